"""Slips that follow with a lag: the deflections of a tire's contact patch as states."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

from pydy._checks import shown
from pydy.vehicles.algebra import Operand, is_symbolic
from pydy.vehicles.forces import checked_parameters
from pydy.vehicles.tuning import SHORTEST_RELAXATION, SMALLEST_SLIDING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from pydy._sympy_types import Expression


@dataclass(frozen=True)
class SlidingSpeeds:
    """Velocity of the wheel's material at the contact point, V_x of its centre, and its radius."""

    radius: Operand
    speed: Expression
    forward: Expression
    left: Expression


@dataclass(frozen=True)
class TransientSlips:
    """Slips of a tire with relaxation, and the equations of the deflections, which are zero."""

    kappa: Expression
    alpha: Expression
    equations: list[Expression]


def transient_slips(
    sliding: SlidingSpeeds, lengths: object, deflections: object, values: dict[str, Operand]
) -> TransientSlips:
    """Return the slips of deflections u and v, Pacejka 2006, sections 7.2 and 8.6.

    The book's deflection reaches σ with a locked wheel, and has no bound with a wheel that slides
    sideways; where such a wheel stops, its tire would push it back over that distance. Beyond the
    slip s the deflections are bounded as in the LuGre model, and the slips are scaled to what they
    would be without this bound.

    The deflection u is forward and shrinks as the material slides forward, v is to the right and
    grows as it slides to the left. Near rest, slips also grow with the rates of u and v: a damper.
    """
    lag_x, lag_y = _lengths(lengths, SHORTEST_RELAXATION * sliding.radius)
    u, v = _deflections(deflections)
    checked = checked_parameters(
        values, positive=("low_speed", "sliding_slip"), not_negative=("damping",)
    )
    size = sm.Abs(sliding.speed, evaluate=False)
    # 1 at rest, 0 from low_speed on, with a continuous derivative.
    ratio = sm.Min(size / checked["low_speed"], 1, evaluate=False)
    slow = (1 + sm.cos(sm.pi * ratio)) / 2
    unresolved = SMALLEST_SLIDING * checked["low_speed"]
    total = sm.sqrt(sliding.forward**2 + sliding.left**2 + unresolved**2)
    bound = total / checked["sliding_slip"]
    decay = sm.Max(size, bound, evaluate=False)
    growth = decay / sm.Max(size, slow * bound, evaluate=False)
    t = dynamicsymbols._t
    damping = slow * checked["damping"]
    return TransientSlips(
        (growth * u - damping * sliding.forward) / lag_x,
        sm.atan((growth * v + damping * sliding.left) / lag_y, evaluate=False),
        [
            u.diff(t) + sliding.forward + decay / lag_x * u,
            v.diff(t) - sliding.left + decay / lag_y * v,
        ],
    )


def camber_equation(
    sliding: SlidingSpeeds,
    lengths: object,
    camber: object,
    deflections: Sequence[object],
    gamma: Expression,
) -> Expression:
    """Return the equation, which is zero, of camber that a tire's forces follow over σ_α.

    With a linear tire the entire side force then lags (Sharp 1971).
    """
    _, lag = _lengths(lengths, SHORTEST_RELAXATION * sliding.radius)
    t = dynamicsymbols._t
    if not _is_function_of_time(camber) or camber in deflections:
        raise TypeError(
            "`camber` must be a further function of time, such as dynamicsymbols('gamma_lag'), "
            f"got {shown(camber)}."
        )
    state: Operand = camber
    return state.diff(t) + sm.Abs(sliding.speed, evaluate=False) / lag * (state - gamma)


def _is_function_of_time(value: object) -> bool:
    return isinstance(value, AppliedUndef) and value.args == (dynamicsymbols._t,)


def _lengths(lengths: object, shortest: Operand) -> list[Operand]:
    if not isinstance(lengths, (tuple, list)) or len(lengths) != 2:
        raise TypeError(
            "`lengths` must be a pair of relaxation lengths, longitudinal and lateral, got "
            f"{shown(lengths)}."
        )
    names = ("lengths[0]", "lengths[1]")
    checked = checked_parameters(dict(zip(names, lengths, strict=True)), positive=names)
    # Lengths that depend on the load vanish with it, and the decay would have no bound.
    return [sm.Max(x, shortest, evaluate=False) if is_symbolic(x) else x for x in checked.values()]


def _deflections(deflections: object) -> tuple[Operand, Operand]:
    if (
        not isinstance(deflections, (tuple, list))
        or len(deflections) != 2
        or not all(map(_is_function_of_time, deflections))
        or deflections[0] == deflections[1]
    ):
        raise TypeError(
            "`deflections` must be two functions of time, such as dynamicsymbols('u v'), got "
            f"{shown(deflections)}."
        )
    return deflections[0], deflections[1]
