"""What an explicit Runge–Kutta method consists of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

__all__ = ["Row", "Tableau", "from_monomials"]

Row = dict[int, float]


@dataclass(frozen=True)
class Tableau:
    """An explicit embedded Runge–Kutta method.

    Stages are numbered from 0; the number after the last one of the step is the derivative at its
    end, which the next step starts with; further numbers are those of the interpolant alone.
    Rows map the number of a stage to its coefficient.

    Attributes
    ----------
    name : str
    order : int
    error_order : int or None
        Of the embedded solution; None for a method of fixed step size.
    nodes : tuple of float
        The time of each stage, end and interpolant's stages included, as a fraction of the step.
    stages : tuple of rows
    weights : row
        The step is the sum of these times the stages, times h.
    errors : tuple of rows
        One estimate of the error; or two, whose combination of Hairer, Nørsett and Wanner (II.10)
        is taken.
    dense_stages : tuple of rows
    damping : float
        Exponent of the last error in the choice of the step size; 0 for the plain rule.
    interpolant : tuple of rows
        F3, F4 … of ``x + θ (F0 + (1 − θ)(F1 + θ (F2 + (1 − θ)(F3 + …))))``: the form in which
        nothing cancels at the ends of the step. States and derivatives there give F0 to F2.
    """

    name: str
    order: int
    error_order: int | None
    nodes: tuple[float, ...]
    stages: tuple[Row, ...]
    weights: Row
    errors: tuple[Row, ...]
    dense_stages: tuple[Row, ...]
    interpolant: tuple[Row, ...]
    damping: float = 0.0


def from_monomials(stages: Mapping[int, str]) -> tuple[Row, ...]:
    """Return F3, F4 … for polynomials in θ given by the coefficients of θ, θ² … of each stage.

    The conversion is exact; `stages` holds the coefficients as text.
    """
    rows: list[Row] = []
    for stage, text in stages.items():
        rest: Sequence[Fraction] = [Fraction(number) for number in text.split()]  # p(θ) / θ
        rest = _divide_at_one(rest)
        level = 0
        while rest:
            if len(rows) == level:
                rows.append({})
            at_zero = level % 2 == 0
            rows[level][stage] = float(rest[0] if at_zero else sum(rest))
            rest = rest[1:] if at_zero else _divide_at_one(rest)
            level += 1
    return tuple(rows[2:])


def _divide_at_one(polynomial: Sequence[Fraction]) -> list[Fraction]:
    """Return (p(θ) − p(1)) / (1 − θ), lowest power first."""
    quotient: list[Fraction] = []
    total = Fraction(0)
    for coefficient in reversed(polynomial[1:]):
        total += coefficient
        quotient.append(-total)
    return quotient[::-1]
