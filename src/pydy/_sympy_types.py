"""Short names for unions of SymPy's classes, for annotations; SymPy is not loaded."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

if TYPE_CHECKING:
    import sympy as sm
    from sympy.core.function import AppliedUndef
    from sympy.physics.mechanics import Particle, Point, ReferenceFrame, RigidBody, Vector

# A function of time or a derivative of one: a coordinate, a speed, an input.
TimeFunction: TypeAlias = "AppliedUndef | sm.Derivative"
# What expressions depend on: constants, time, functions of time and their derivatives.
AnySymbol: TypeAlias = "sm.Symbol | AppliedUndef | sm.Derivative"
Expression: TypeAlias = "sm.Expr"
Matrix: TypeAlias = "sm.MatrixBase"
SymbolOrName: TypeAlias = "AnySymbol | str"
ExpressionOrName: TypeAlias = "sm.Expr | str"
Value = TypeVar("Value")
# By symbols or names. The keys are Any, as a mapping of the union would refuse a `dict[str, …]`.
BySymbol: TypeAlias = Mapping[Any, Value]

Body: TypeAlias = "RigidBody | Particle"
# Where a load acts: a force at a point, a torque on a frame.
Location: TypeAlias = "Point | ReferenceFrame"
Load: TypeAlias = "tuple[Location, Vector]"
