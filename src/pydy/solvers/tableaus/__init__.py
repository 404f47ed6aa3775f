"""Runge–Kutta methods as data, each with its source, and as the arrays that compiled code reads."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from importlib import import_module

import numpy as np

from pydy.solvers.layout import DEPTH, Method
from pydy.solvers.tuning import GROW, SAFETY, SHRINK

Row = dict[int, float]

_CONSISTENT = 1e-12  # coefficients come in 16 digits


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
        Of the embedded solution; None for a method of fixed step size, which has no `errors`.
    nodes : tuple of float
        The time of each stage, end and interpolant's stages included, as a fraction of the step.
    stages : tuple of rows
    weights : row
        The step is the sum of these times the stages, times h.
    errors : tuple of rows
        One estimate of the error, the difference of two solutions' weights; or two, whose
        combination of Hairer, Nørsett and Wanner (II.10) is taken.
    dense_stages : tuple of rows
    damping : float
        Exponent of the last error in the choice of the step size; 0 for the plain rule.
    interpolant : tuple of rows
        F3, F4 … of ``x + θ (F0 + (1 − θ)(F1 + θ (F2 + (1 − θ)(F3 + …))))``: the form in which
        nothing cancels at the ends of the step. States and derivatives there give F0 to F2; with
        no rows it is the cubic Hermite polynomial.
    """

    name: str
    order: int
    error_order: int | None
    nodes: tuple[float, ...]
    stages: tuple[Row, ...]
    weights: Row
    errors: tuple[Row, ...] = ()
    dense_stages: tuple[Row, ...] = ()
    interpolant: tuple[Row, ...] = ()
    damping: float = 0.0

    def check(self) -> None:
        """Check the consistency of the coefficients."""
        count, dense = len(self.stages), len(self.dense_stages)
        if len(self.nodes) != count + 1 + dense:
            raise ValueError(
                f"`nodes` must have {count + 1 + dense} entries, one for each stage, one for the "
                f"end of the step and one for each of `dense_stages`, got {len(self.nodes)}."
            )
        if (self.error_order is None) != (not self.errors):
            raise ValueError(
                "`errors` and `error_order` belong together: give both, or neither for a method "
                f"of fixed step size; got error_order = {self.error_order} and {len(self.errors)} "
                "rows of errors."
            )
        if not 0 <= len(self.errors) <= 2:
            raise ValueError(f"`errors` must have one row or two, got {len(self.errors)}.")
        for k, (node, row) in enumerate(zip(self.nodes, self.stages, strict=False)):
            if any(not 0 <= j < k for j in row):
                raise ValueError(f"`stages` must refer to earlier stages, but row {k} is {row}.")
            if abs(sum(row.values()) - node) > _CONSISTENT:
                raise ValueError(
                    f"`stages` must sum to `nodes`, but row {k} sums to {sum(row.values())} and "
                    f"the node is {node}."
                )
        if abs(sum(self.weights.values()) - 1.0) > _CONSISTENT:
            raise ValueError(f"`weights` must sum to 1, got {sum(self.weights.values())}.")
        for row in self.errors:
            if abs(sum(row.values())) > _CONSISTENT:
                raise ValueError(
                    "`errors` are differences of two solutions and must sum to 0, but a row sums "
                    f"to {sum(row.values())}."
                )


def from_monomials(stages: Mapping[int, str]) -> tuple[Row, ...]:
    """Return F3, F4 … for polynomials in θ given by the coefficients of θ, θ² … of each stage.

    The conversion is exact; `stages` holds the coefficients as text.
    """
    rows: list[Row] = []
    for stage, text in stages.items():
        polynomial: Sequence[Fraction] = [Fraction(number) for number in text.split()]  # p(θ) / θ
        polynomial = _divide_at_one(polynomial)
        level = 0
        while polynomial:
            if len(rows) == level:
                rows.append({})
            at_zero = level % 2 == 0
            rows[level][stage] = float(polynomial[0] if at_zero else sum(polynomial))
            polynomial = polynomial[1:] if at_zero else _divide_at_one(polynomial)
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


# -- by name ---------------------------------------------------------------------------------------

_ADDED: dict[str, Tableau] = {}


@cache
def tableau_of(name: str) -> Tableau:
    """Return the tableau of a method: one that was added, or that of the module of its name."""
    if name in _ADDED:
        return _ADDED[name]
    tableau: Tableau = getattr(import_module(f"pydy.solvers.tableaus.{name}"), name.upper())
    return tableau


def add_tableau(tableau: Tableau) -> None:
    """Register a consistent tableau under its name, which must be new."""
    tableau.check()
    if _ADDED.setdefault(tableau.name, tableau) != tableau:
        raise ValueError(
            f"`tableau` has the name {tableau.name!r}, which another one has already; give it "
            "another name."
        )


# -- as arrays -------------------------------------------------------------------------------------

IMPLICIT = "radau"


@cache
def method_arrays(name: str, length: int) -> Method:
    """Return a method's arrays for vectors of some padded length."""
    if name == IMPLICIT:
        nothing, none = np.zeros(0), np.zeros(0, dtype=np.int64)
        shape = np.zeros(5, dtype=np.int64)
        shape[DEPTH] = 3  # its collocation polynomial is a cubic
        return _frozen(Method(shape, none, none, nothing, nothing, nothing))
    tableau = tableau_of(name)
    stages = len(tableau.stages)
    rows, offsets, weights = [0], [], []
    for row in (
        *tableau.stages,
        tableau.weights,
        *tableau.errors,
        *tableau.dense_stages,
        *tableau.interpolant,
    ):
        row = row or {0: 0.0}  # compiled code takes the last term of each by itself
        offsets += [stage * length for stage in row]
        weights += list(row.values())
        rows.append(len(offsets))
    counts = (
        stages,
        len(tableau.errors),
        len(tableau.dense_stages),
        len(tableau.interpolant) + 3,
        any(stages in row for row in tableau.errors),
    )
    exponent = 1.0 / ((tableau.error_order or 0) + 1)
    # K. Gustafsson's PI controller with the weights of DOPRI5 (Hairer, Nørsett, Wanner, IV.2).
    alpha = exponent - 0.75 * tableau.damping
    control = (exponent, alpha, tableau.damping, SAFETY, SHRINK, GROW)
    return _frozen(
        Method(
            shape=np.array(counts, dtype=np.int64),
            rows=np.array(rows),
            offsets=np.array(offsets),
            weights=np.array(weights),
            nodes=np.array(tableau.nodes),
            control=np.array(control),
        )
    )


def _frozen(method: Method) -> Method:
    for array in method:
        array.setflags(write=False)
    return method
