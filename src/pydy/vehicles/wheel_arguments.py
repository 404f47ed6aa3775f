"""What users say of a wheel: laws as functions, unit vectors, and normals that turn."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import Point, ReferenceFrame, Vector, dynamicsymbols

from pydy._checks import instance
from pydy._rank import ROUNDED
from pydy.vehicles.algebra import checked_quantity
from pydy.vehicles.forces import checked_parameters

if TYPE_CHECKING:
    from pydy._sympy_types import Expression

# A law of the normal force: a function of the gap and its rate.
Law: TypeAlias = "Callable[[Expression, Expression], Expression | float]"


def rolling_radius_of(radius: object, load: Expression | None) -> Expression:
    """Return the effective rolling radius, or what a user's function says of the load."""
    if load is None:
        raise ValueError(
            "`rolling_radius` belongs to a tire that is deflected, and this wheel is rigid: give "
            "a `force`, or a `radius` of this size."
        )
    if callable(radius):
        return _called("rolling_radius(normal_force)", radius, load)
    checked = checked_parameters({"rolling_radius": radius}, positive=("rolling_radius",))
    return sm.sympify(checked["rolling_radius"])


def _called(signature: str, function: Callable[..., object], *arguments: Expression) -> Expression:
    try:
        result = function(*arguments)
    except Exception as error:
        error.add_note(f"This was raised by `{signature}`, called with expressions.")
        raise
    return sm.sympify(checked_quantity(result, f"`{signature}`", arrays=False))


def normal_force_of(law: Law, gap: Expression, rate: Expression) -> Expression:
    """Return the normal force that a user's law gives, and none where it is negative.

    A law that is negative somewhere, such as a spring with a damper, or one that grows with the
    distance, such as a square of the gap, would also act before the wheel touches. Another one,
    such as a smooth one, would jump if it were cut there.
    """
    name = "force(gap, rate)"
    force = _called(name, law, gap, rate)
    variables = sm.symbols("gap rate", real=True, cls=sm.Dummy)
    general = _called(name, law, *variables)
    shape = _shape(general, variables)
    if general.is_nonnegative and not shape.grows:
        return force
    pressed = sm.Max(force, 0, evaluate=False)
    if not (shape.negative or shape.grows):
        return pressed
    return sm.Piecewise((pressed, sm.Lt(gap, 0, evaluate=False)), (0, True), evaluate=False)


class _ForceLaw(NamedTuple):
    """Whether a law of a gap and its rate is negative somewhere, and grows with positive gaps."""

    negative: bool
    grows: bool


_UNKNOWN = _ForceLaw(negative=True, grows=False)


def _shape(law: Expression, variables: tuple[Expression, ...]) -> _ForceLaw:
    """Return the shape of a law, from its values at many gaps and rates."""
    others = _variables(law).difference(variables)
    if any(s.has(*variables) for s in others):  # unknown functions of them
        return _UNKNOWN
    gaps = np.append(0.0, 10.0 ** np.arange(-6, 3))
    rates = np.concatenate([-(10.0 ** np.arange(-3, 4)), [0.0], 10.0 ** np.arange(-3, 4)])
    negative = grows = False
    try:
        function = sm.lambdify([*variables, *others], law, "numpy")
        for start in _STARTS:
            state = _state(others, start)
            numbers = [state[s] for s in others]
            with np.errstate(all="ignore"):
                lifted, pressed = (
                    np.zeros((len(rates), len(gaps)))
                    + function(*np.meshgrid(side * gaps, rates), *numbers)
                    for side in (1.0, -1.0)
                )
                if np.isnan(lifted).any():  # such as a root of −gap
                    return _UNKNOWN
                # A difference that vanishes with the gap is rounded like its terms.
                rounding = ROUNDED * np.nan_to_num(np.abs(pressed))
                negative |= bool((pressed < 0.0).any() or (lifted < -rounding).any())
                grows |= bool((lifted > lifted[:, :1] + rounding).any())
    except (NameError, TypeError, ValueError):  # functions without numbers
        return _UNKNOWN
    return _ForceLaw(negative, grows)


class SurfacePoint(Point):  # type: ignore[misc]  # SymPy has no types
    """The point of a surface that a wheel touches, with the surface's normal there."""

    normal: Vector


def turning_of(normal: Vector, plane: Point, frame: ReferenceFrame) -> Vector | None:
    """Return the time derivative of the normal of a surface, or None of one that is constant.

    A plane that turns is refused: the velocity of its material at C is not that of its point.
    """
    rate = normal.dt(frame)
    if rate == 0:
        return None
    if isinstance(plane, SurfacePoint) and plane.normal == normal:
        return rate
    components = sm.Matrix(normal.to_matrix(frame))
    constants = components.free_symbols - {dynamicsymbols._t}
    moving = _variables(components) - constants | {dynamicsymbols._t}
    steady = _state(constants, _STARTS[0])
    first, second = (
        # Functions go before the time that they depend on.
        components.subs(_state(moving - {dynamicsymbols._t}, start))
        .subs({**steady, dynamicsymbols._t: start})
        .evalf()
        for start in _STARTS
    )
    change = (first - second).norm()
    if change.is_number and change.is_real and not change <= ROUNDED:
        raise ValueError(
            f"`normal` must be constant in `frame`, got {normal}, which turns. A wheel touches a "
            "plane that does not turn; where the slope varies give the `point` and the `normal` of "
            "a RoadSurface."
        )
    return None


_STARTS = (0.3, 0.4)  # of two states, at which expressions are compared


def _variables(expression: Expression) -> set[Expression]:
    names: set[Expression] = expression.atoms(AppliedUndef) | expression.free_symbols
    return names - {dynamicsymbols._t}


def _state(variables: Iterable[Expression], start: float) -> dict[Expression, float]:
    """Return different numbers for variables, of the signs that SymPy knows."""
    ordered = enumerate(sorted(variables, key=str))
    return {s: (-1 if s.is_nonpositive else 1) * (start + 0.1 * k) for k, s in ordered}


def check_unit(label: str, vector: object) -> None:
    """Refuse a vector whose length is the same at two states, and not 1."""
    instance(vector, Vector, f"`{label}`")
    square = sm.sympify(vector.dot(vector))  # type: ignore[attr-defined]
    lengths = []
    for start in _STARTS:  # SymPy takes long to simplify what a surface's normal is made of
        value = square.subs(_state(_variables(square), start)).evalf()
        lengths.append(float(value) if value.is_number and value.is_real else np.nan)
    size = lengths[0]
    if abs(lengths[1] - size) <= ROUNDED * size and not abs(size - 1) <= ROUNDED:
        raise ValueError(
            f"`{label}` must be of unit length, got {vector}. Divide it by its length."
        )
