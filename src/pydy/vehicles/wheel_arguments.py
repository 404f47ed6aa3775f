"""What users say of a wheel: laws as functions, and unit vectors."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import Vector, dynamicsymbols

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

    A law that may be negative, as SymPy knows, may also act before the wheel touches.
    """
    name = "force(gap, rate)"
    force = _called(name, law, gap, rate)
    if _called(name, law, *sm.symbols("gap rate", real=True, cls=sm.Dummy)).is_nonnegative:
        return force
    pressed = sm.Max(force, 0, evaluate=False)
    return sm.Piecewise((pressed, sm.Lt(gap, 0, evaluate=False)), (0, True), evaluate=False)


def check_unit(label: str, vector: object) -> None:
    """Refuse a vector whose length is the same at two states, and not 1."""
    instance(vector, Vector, f"`{label}`")
    square = sm.sympify(vector.dot(vector))  # type: ignore[attr-defined]
    functions = square.atoms(AppliedUndef)
    symbols = sorted(functions | square.free_symbols - {dynamicsymbols._t}, key=str)
    lengths = []
    for start in (0.3, 0.4):  # SymPy takes long to simplify what a surface's normal is made of
        state = {s: start + 0.1 * k for k, s in enumerate(symbols)}
        value = square.subs(state).evalf()
        lengths.append(float(value) if value.is_number and value.is_real else np.nan)
    size = lengths[0]
    if abs(lengths[1] - size) <= ROUNDED * size and not abs(size - 1) <= ROUNDED:
        raise ValueError(
            f"`{label}` must be of unit length, got {vector}. Divide it by its length."
        )
