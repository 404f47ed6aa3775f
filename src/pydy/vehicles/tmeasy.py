"""TMeasy: a tire from a few parameters that can be read off measured curves."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from math import inf
from typing import Self

from pydy.vehicles.algebra import Algebra, Operand, is_symbolic
from pydy.vehicles.forces import (
    TireEquations,
    TireInputs,
    checked_parameters,
    fields_of,
    unknown_parameter,
)
from pydy.vehicles.tuning import SMALLEST_LOAD, SMALLEST_SLIP

_FORCES = ("rise_x", "peak_x", "sliding_x", "rise_y", "peak_y", "sliding_y")
_SLIPS = ("peak_slip_x", "sliding_slip_x", "peak_slip_y", "sliding_slip_y")
_TRAIL = ("trail", "zero_slip", "end_slip")
_ORDER = (
    ("peak_slip_x", "sliding_slip_x"),
    ("peak_slip_y", "sliding_slip_y"),
    ("zero_slip", "end_slip"),
)


@dataclass(frozen=True)
class TMeasy(TireEquations):
    """TMeasy of Rill: forces by their initial rise, their peak, and where all slides.

    Each parameter is a pair of values, at the nominal load and at twice that load. Forces and
    rises are parabolas of the load through zero, slips and the trail are linear in it. Combined
    slip is the size of the slip vector, each component normalised by its own characteristic.
    Axes and signs are those of `MagicFormula`; slips are κ and tan α. Camber, speed and pressure
    have no effect.

    A parabola that falls behind its vertex would become negative, and the tire drive the car that
    it should brake. So forces remain those of a largest load: where the first parabola has its
    vertex, or at half the load at which a slip that shrinks would vanish, or a peak reach full
    sliding; at least twice the nominal load. Pairs with expressions set no such load.

    Parameters
    ----------
    nominal_load : number or expression
        Load (N) of the first value of each pair.
    rise_x, rise_y : pair of numbers or expressions
        Slope of the force by slip where the slip is zero, dF⁰ (N).
    peak_x, peak_y : pair of numbers or expressions
        Largest force F^M (N).
    peak_slip_x, peak_slip_y : pair of numbers or expressions
        Slip s^M at the largest force.
    sliding_x, sliding_y : pair of numbers or expressions
        Force F^S where the whole contact patch slides (N).
    sliding_slip_x, sliding_slip_y : pair of numbers or expressions
        Slip s^S from which on it slides.
    trail : pair of numbers or expressions, optional
        Pneumatic trail n₀ where the slip is zero (m). By default there is no aligning moment.
    zero_slip, end_slip : pair of numbers or expressions, optional
        Lateral slips where the trail first is zero, and from which on it remains zero.

    References
    ----------
    G. Rill, Road Vehicle Dynamics: Fundamentals and Modeling, CRC Press, 2012, chapter 3.

    G. Rill, TMeasy: the handling tire model for all driving situations, Proc. XV Int. Symp. on
    Dynamic Problems of Mechanics (DINAME), 2013.

    Examples
    --------
    >>> from pydy.vehicles import TMeasy
    >>> tire = TMeasy(
    ...     4000, rise_x=(120e3, 200e3), peak_x=(4400, 8300), peak_slip_x=(0.11, 0.12),
    ...     sliding_x=(4250, 7900), sliding_slip_x=(0.5, 0.6),
    ...     rise_y=(90e3, 160e3), peak_y=(4300, 8100), peak_slip_y=(0.16, 0.18),
    ...     sliding_y=(4200, 7600), sliding_slip_y=(0.6, 0.8))
    >>> round(tire.forces(4000, 0.11, 0.0).Fx), round(tire.forces(8000, 0.0, -1.0).Fy)
    (4400, 7600)
    """

    nominal_load: Operand
    rise_x: Operand
    peak_x: Operand
    peak_slip_x: Operand
    sliding_x: Operand
    sliding_slip_x: Operand
    rise_y: Operand
    peak_y: Operand
    peak_slip_y: Operand
    sliding_y: Operand
    sliding_slip_y: Operand
    trail: Operand = (0.0, 0.0)
    zero_slip: Operand = (0.25, 0.25)
    end_slip: Operand = (0.5, 0.5)

    def __post_init__(self) -> None:
        names = (*_FORCES, *_SLIPS, *_TRAIL)
        pairs: dict[str, Operand] = {}
        for name in names:
            value = getattr(self, name)
            if not isinstance(value, (tuple, list)) or len(value) != 2:
                raise TypeError(
                    f"`{name}` must be a pair of values, at the nominal load and at twice that "
                    f"load, got {value!r}."
                )
            pairs |= {f"{name}[{k}]": v for k, v in enumerate(value)}
        positive = tuple(p for p in pairs if not p.startswith("trail"))
        checked = checked_parameters(
            {"nominal_load": self.nominal_load, **pairs}, positive=("nominal_load", *positive)
        )
        object.__setattr__(self, "nominal_load", checked["nominal_load"])
        for name in names:
            object.__setattr__(self, name, (checked[f"{name}[0]"], checked[f"{name}[1]"]))
        for less, more in _ORDER:
            for k in range(2):
                low, high = checked[f"{less}[{k}]"], checked[f"{more}[{k}]"]
                if not (is_symbolic(low) or is_symbolic(high)) and not low < high:
                    raise ValueError(
                        f"`{more}` must be larger than `{less}`, got {high!r} and {low!r}."
                    )
        self._check_small_loads()

    def _check_small_loads(self) -> None:
        """Refuse pairs with a parabola or a line that is not positive at small loads."""
        for name, at_one, at_two in self._lines():
            if 2 * at_one - at_two > 0.0:
                continue
            if " − " in name:
                more, less = name.split(" − ")
                raise ValueError(
                    f"`{more}` must be larger than `{less}` at small loads, too, got "
                    f"{getattr(self, more)!r} and {getattr(self, less)!r}: the lines through these "
                    "meet below the nominal load. Let them differ less between both loads."
                )
            curve, factor = ("parabola", 4) if name in _FORCES else ("line", 2)
            one, two = getattr(self, name)
            raise ValueError(
                f"`{name}[1]` must be less than {factor} times `{name}[0]`, got {two!r} and "
                f"{one!r}: the {curve} through these is negative at small loads, where forces "
                "would have the wrong sign."
            )

    def _lines(self) -> Iterator[tuple[str, float, float]]:
        """Yield what must be positive and is linear in the load, at one and two nominal loads.

        Of forces, which are parabolas, it is the ratio to the load.
        """
        for name in (*_FORCES, *_SLIPS, "zero_slip", "end_slip"):
            one, two = getattr(self, name)
            if not (is_symbolic(one) or is_symbolic(two)):
                yield name, one, two / 2 if name in _FORCES else two
        for less, more in _ORDER:
            low, high = getattr(self, less), getattr(self, more)
            if not any(map(is_symbolic, (*low, *high))):
                yield f"{more} − {less}", high[0] - low[0], high[1] - low[1]

    def _largest_load(self) -> float:
        """Return the load beyond which forces stay the same, relative to the nominal one.

        A line that vanishes at some load belongs to a parabola with its vertex at half of it. Each
        line is positive at twice the nominal load, so that it still is at the load returned.
        """
        vertices = [(2 * one - two) / (one - two) / 2 for _, one, two in self._lines() if two < one]
        return max(2.0, min(vertices, default=inf))

    @property
    def parameters(self) -> Mapping[str, Operand]:
        """The parameters by name; those of pairs are ``'peak_x[0]'`` and ``'peak_x[1]'``."""
        found: dict[str, Operand] = {}
        for name, value in fields_of(self).items():
            if isinstance(value, tuple):
                found |= {f"{name}[{k}]": v for k, v in enumerate(value)}
            else:
                found[name] = value
        return found

    def replace(self, **parameters: Operand) -> Self:
        """Return the tire with some other parameters.

        Parameters
        ----------
        **parameters
            By name, as for the class, or one value of a pair: ``**{'peak_x[1]': 8000.0}``.
        """
        whole = fields_of(self)
        for name, value in parameters.items():
            if name in whole:
                whole[name] = value
            elif name in self.parameters:
                pair = list(whole[name[:-3]])
                pair[int(name[-2])] = value
                whole[name[:-3]] = tuple(pair)
            else:
                raise unknown_parameter(name, {**whole, **self.parameters})
        return replace(self, **whole)

    def _equations(self, m: Algebra, state: TireInputs) -> tuple[Operand, ...]:
        nominal, largest = m.constant(self.nominal_load), self._largest_load()
        Fz = m.maximum(state.Fz, 0)
        if largest < inf:
            Fz = m.minimum(Fz, largest * nominal)
        load = m.maximum(Fz / nominal, SMALLEST_LOAD)
        value = {}
        for name in (*_FORCES, *_SLIPS, *_TRAIL):
            one, two = map(m.constant, getattr(self, name))
            if name in _FORCES:  # divided by the load
                value[name] = 2 * one - two / 2 - (one - two / 2) * load
            else:
                value[name] = one + (two - one) * (load - 1)
        tangent = m.tan(state.alpha)
        rise, weight_x, weight_y = _combined(m, value, state.kappa, tangent)
        per_load = Fz / nominal
        Fx = per_load * rise * state.kappa / weight_x
        Fy = -per_load * rise * tangent / weight_y
        trail = value["trail"] * _relative_trail(m, m.abs(tangent), value)
        none = m.constant(0.0)
        return Fx, Fy, none, none, -trail * Fy


def _combined(
    m: Algebra, value: dict[str, Operand], kappa: Operand, tangent: Operand
) -> tuple[Operand, Operand, Operand]:
    """Return the force divided by the combined slip, and what normalises both slips.

    The direction of no slip is the mean of both.
    """
    ratio_x, ratio_y = (value[f"peak_{k}"] / value[f"rise_{k}"] for k in "xy")
    slip_x, slip_y = value["peak_slip_x"], value["peak_slip_y"]
    weight_x = slip_x / (slip_x + slip_y) + ratio_x / (ratio_x + ratio_y)
    weight_y = slip_y / (slip_x + slip_y) + ratio_y / (ratio_x + ratio_y)
    x2, y2, tiny = (kappa / weight_x) ** 2, (tangent / weight_y) ** 2, SMALLEST_SLIP**2
    square = x2 + y2 + tiny
    s = m.sqrt(square)
    cos2, sin2 = (x2 + tiny / 2) / square, (y2 + tiny / 2) / square

    def along(a: Operand, b: Operand) -> Operand:
        return m.sqrt(a**2 * cos2 + b**2 * sin2)

    rise = along(value["rise_x"] * weight_x, value["rise_y"] * weight_y)
    peak = along(value["peak_x"], value["peak_y"])
    sliding = along(value["sliding_x"], value["sliding_y"])
    peak_slip = along(slip_x / weight_x, slip_y / weight_y)
    sliding_slip = along(value["sliding_slip_x"] / weight_x, value["sliding_slip_y"] / weight_y)
    # A rational function up to the peak, a cubic polynomial to full sliding.
    up = m.minimum(s / peak_slip, 1)
    first = rise / (1 + up * (up + rise * peak_slip / peak - 2))
    down = m.maximum(m.minimum((s - peak_slip) / (sliding_slip - peak_slip), 1), 0)
    second = (peak - (peak - sliding) * down**2 * (3 - 2 * down)) / s
    return m.where_negative(s - peak_slip, first, second), weight_x, weight_y


def _relative_trail(m: Algebra, slip: Operand, value: dict[str, Operand]) -> Operand:
    """Return the trail relative to that without slip: two cubic polynomials, then zero."""
    zero, end = value["zero_slip"], value["end_slip"]
    w = zero / end
    inner = m.minimum(slip / zero, 1)
    outer = m.maximum(m.minimum((slip - zero) / (end - zero), 1), 0)
    before = (1 - w) * (1 - inner) + w * (1 - (3 - 2 * inner) * inner**2)
    behind = -(1 - w) * outer * (1 - outer) ** 2 * (end - zero) / zero
    return before + behind
