"""Bodies, loads and kinematics: what equations of motion are formed from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from pydy._forks import cached_property
from pydy._mechanics.frame_tree import FrameTree
from pydy._mechanics.reader import is_rigid
from pydy._mechanics.symbols import rate_of

if TYPE_CHECKING:
    import sympy as sm
    from sympy.physics.mechanics import ReferenceFrame

    from pydy._sympy_types import Body, Load, TimeFunction


@dataclass(frozen=True, eq=False)
class Multibody:
    """Bodies, loads and kinematics, from which equations of motion are formed."""

    frame: ReferenceFrame  # the inertial frame
    bodies: tuple[Body, ...]
    loads: tuple[Load, ...]
    time: sm.Symbol
    coordinates: tuple[TimeFunction, ...]  # in the order of the states, like the speeds
    speeds: tuple[TimeFunction, ...]
    coordinate_rates: tuple[sm.Derivative, ...]
    coordinate_derivatives: tuple[sm.Expr, ...]  # q' in q, u and t
    holonomic: tuple[sm.Expr, ...] = ()  # configuration constraints, zero when satisfied
    velocity: tuple[sm.Expr, ...] = ()  # velocity constraints, one for each dependent speed
    # Their derivatives, in u' and the states; empty where they are just that.
    acceleration: tuple[sm.Expr, ...] = ()
    auxiliary: tuple[TimeFunction, ...] = ()  # auxiliary speeds
    # Of the coordinates and speeds; the speeds in the order of the velocity constraints.
    dependent_coordinates: tuple[TimeFunction, ...] = ()
    dependent_speeds: tuple[TimeFunction, ...] = ()
    chosen: tuple[TimeFunction, ...] = ()  # the dependent ones that the user did not choose
    # In place of bodies; the speeds are then the derivatives of the coordinates.
    lagrangian: sm.Expr | None = None
    # More velocity constraints, which follow from the others at generic states.
    redundant: tuple[sm.Expr, ...] = ()
    # More holonomic constraints, which follow from the others wherever their speeds do.
    closed: tuple[sm.Expr, ...] = ()
    # Whether the choice of dependent speeds may become invalid: the rank of the constraints, or
    # the speeds for which they can be solved, may change as the system moves.
    changing: bool = False
    implicit: Any = None  # the `Implicit` that gave some coordinates and holonomic constraints
    activations: tuple[TimeFunction, ...] = ()  # states of musculotendons that are specifieds here
    # The properties of the bodies when they were read: SymPy lets users change them.
    snapshots: tuple[tuple[Body, tuple[Any, ...]], ...] = ()

    def __post_init__(self) -> None:
        if not self.snapshots:
            snapshots = tuple((body, _snapshot(body)) for body in self.bodies)
            object.__setattr__(self, "snapshots", snapshots)

    @property
    def position_constraints(self) -> list[sm.Expr]:
        """The holonomic constraints, except the residuals of an `Implicit`."""
        residuals = set() if self.implicit is None else {*self.implicit.residuals.values()}
        return [e for e in (*self.holonomic, *self.closed) if e not in residuals]

    def check_unchanged(self) -> None:
        """Refuse bodies that changed since they were read: their equations would be outdated."""
        for body, before in self.snapshots:
            names = ("mass", "inertia", "mass center", "frame", "position", "orientation")
            for name, old, new in zip(names, before, _snapshot(body), strict=True):
                if isinstance(old, dict):  # SymPy adds neighbours as it goes
                    new = {key: new.get(key) for key in old}
                if old is not new and old != new:
                    change = "" if isinstance(old, dict) else f" from {old} to {new}"
                    raise ValueError(
                        f"The {name} of the body `{body.name}` has been changed{change} since the "
                        "System was made. Its equations of motion are those from before: make a "
                        "new System, or undo the change. For values that vary, use constants."
                    )

    @cached_property
    def speed_rates(self) -> tuple[sm.Derivative, ...]:
        """The derivatives of the speeds."""
        return tuple(rate_of(u, self.time) for u in self.speeds)

    @cached_property
    def dependent_columns(self) -> tuple[int, ...]:
        """The positions of the dependent speeds among the speeds, in their own order."""
        return tuple(self.speeds.index(u) for u in self.dependent_speeds)

    @property
    def independent_first(self) -> Multibody:
        """A copy with the dependent coordinates and speeds last, as equations are formed."""
        coordinates = _last(self.coordinates, self.dependent_coordinates)
        speeds = _last(self.speeds, self.dependent_speeds)
        if (coordinates, speeds) == (self.coordinates, self.speeds):
            return self
        order = [self.coordinates.index(q) for q in coordinates]
        return replace(
            self,
            coordinates=coordinates,
            speeds=speeds,
            coordinate_rates=tuple(self.coordinate_rates[k] for k in order),
            coordinate_derivatives=tuple(self.coordinate_derivatives[k] for k in order),
        )


def _last(
    symbols: Sequence[TimeFunction], dependent: Sequence[TimeFunction]
) -> tuple[TimeFunction, ...]:
    """Return the symbols with the dependent ones last."""
    return (*(s for s in symbols if s not in dependent), *dependent)


def _snapshot(body: Body) -> tuple[Any, ...]:
    """Return a record of a body's properties for `Multibody.check_unchanged`."""
    point = body.masscenter
    positions = {**FrameTree.positions(point)}
    if not is_rigid(body):
        return body.mass, None, point, None, positions, {}
    orientations = {**FrameTree.orientations(body.frame)}
    return body.mass, body.inertia, point, body.frame, positions, orientations
