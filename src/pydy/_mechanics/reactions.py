"""Multipliers by name, and reactions on bodies at a point, as `System` returns them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

import sympy as sm
from sympy.physics.mechanics import Particle, Point, ReferenceFrame, RigidBody
from sympy.physics.mechanics.joint import Joint

from pydy._checks import describe, instance, listed, shown, text
from pydy._errors import warn_user
from pydy._graph import NodeExpression
from pydy._mechanics.equations import Equations
from pydy._mechanics.forces import ConstraintForces
from pydy._mechanics.reader import read_loads
from pydy._names import item_of_name, name_of

if TYPE_CHECKING:
    from sympy.physics.mechanics import Vector

    from pydy._sympy_types import AnySymbol, Body, Load, Location


_REACTION = "reaction_"  # what the expressions of reactions are called, before the point

# Bodies on one side of a cut: some of them, or all beyond a joint.
_OneSide: TypeAlias = "Body | str | Joint | Iterable[Body | Location | str]"


class Multipliers(dict[sm.Symbol, sm.Expr]):
    """Multipliers of the constraints by symbol; a name is taken too."""

    def __missing__(self, key: object) -> sm.Expr:
        for symbol, expression in self.items():
            if symbol.name == key:
                return expression
        names = describe(list(self)) if self else "none"
        raise KeyError(f"`constraint_forces` has no multiplier {key!r}; it has {names}.")


@dataclass(frozen=True, eq=False)
class Reaction:
    """The force and torque that a joint exerts on a group of bodies.

    Attributes
    ----------
    force : Vector
    torque : Vector
        About the point of the cut.
    frame : ReferenceFrame
        The axes in which both were formed.
    """

    force: Vector
    torque: Vector
    frame: ReferenceFrame

    def outputs(self, name: str) -> dict[sm.Symbol, sm.Expr]:
        """Return the components as a dictionary for `System.outputs`.

        Parameters
        ----------
        name : str
            The outputs are called ``name_Fx``, ``name_Fy``, ``name_Fz``, ``name_Tx``, ``name_Ty``
            and ``name_Tz``.
        """
        text(name, "`name`", empty=False)
        outputs = {}
        for part, vector in (("F", self.force), ("T", self.torque)):
            for axis, value in zip("xyz", vector.to_matrix(self.frame), strict=True):
                outputs[sm.Symbol(f"{name}_{part}{axis}")] = value
        return outputs


class Reactions:
    """The multipliers and reactions of equations of motion, with noncontributing forces.

    `auxiliary_forces` are the symbols of the noncontributing forces.
    """

    def __init__(self, equations: Equations, auxiliary_forces: Sequence[AnySymbol]) -> None:
        self.equations, self.auxiliary_forces = equations, auxiliary_forces

    def multipliers(self) -> Multipliers:
        """Return the multipliers of the constraints."""
        if not self.equations.constraints.velocity:
            return Multipliers()
        return Multipliers(self._forces(bodies=False).multipliers(self.auxiliary_forces))

    def reaction(
        self,
        bodies: _OneSide,
        point: Point | None,
        frame: ReferenceFrame | None,
        further_loads: Iterable[Load] | None,
    ) -> Reaction:
        """Return the force and torque on a group of bodies; see `System.reaction`."""
        forces = self._forces(bodies=True)
        all_bodies = forces.body.bodies
        if isinstance(bodies, str) and bodies not in map(name_of, all_bodies):
            bodies = item_of_name(self._joints, bodies)
        if isinstance(bodies, Joint):
            point = bodies.child_point if point is None else point
            bodies = self._bodies_beyond(bodies, all_bodies)
        members = [_member(all_bodies, item) for item in _as_list(bodies)]
        if not any(item in all_bodies for item in members):
            raise ValueError(
                f"`bodies` must hold one body of the system or more: {describe(list(all_bodies))}."
            )
        instance(point, Point, "`point`")
        if frame is None:
            frame = forces.body.frame
        instance(frame, ReferenceFrame, "`frame`")
        loads = read_loads(listed("loads", () if further_loads is None else further_loads, "loads"))
        for location, _ in loads:
            if isinstance(location, Point):
                _check_located(location, point)
        for item in members:
            if not isinstance(item, ReferenceFrame):
                _check_located(item if isinstance(item, Point) else item.masscenter, point)
        reactions = [location for location, vector in loads if _holds_reaction(vector)]
        known = [location for location in reactions if isinstance(location, Point)]
        # A torque alone does not say at which joint it acts.
        if (further_loads is None or loads) and (known or not reactions):
            _warn_of_joints(*forces.further_joints(members, point, known), point, loads)
        if links := forces.uncounted(members, point, [location for location, _ in loads]):
            _warn_of_links(links)
        name = f"{_REACTION}{point}"
        force, torque = forces.reaction(members, point, frame, loads, name, self.auxiliary_forces)
        return Reaction(force, torque, frame)

    def _forces(self, *, bodies: bool) -> ConstraintForces:
        forces = self.equations.constraint_forces
        if bodies and forces is not None and forces.body.lagrangian is not None:
            raise ValueError(
                "Reactions follow from the bodies and the loads on each of them, but a Lagrangian "
                "does not tell which bodies its potential energy acts on. Give a "
                "`pydy.mechanics.Definition` or a KanesMethod with `bodies` and all loads, gravity "
                "included. The multipliers of a LagrangesMethod's constraints are in "
                "`constraint_forces`."
            )
        if forces is None or (bodies and not forces.body.bodies):
            raise ValueError(
                "Constraint forces follow from bodies and loads, but `eom_method` holds no bodies: "
                "construct a KanesMethod with `bodies=` and `forcelist=`, or call its "
                "`kanes_equations(bodies, loads)`."
            )
        return forces

    @property
    def _joints(self) -> tuple[Joint, ...]:
        mechanism = self.equations.mechanism
        return () if mechanism is None else mechanism.joints

    def _bodies_beyond(self, joint: Joint, bodies: Sequence[Body]) -> list[Body]:
        """Return the child of a joint, and the bodies that further joints attach to it."""
        joints = self._joints
        if not any(joint is candidate for candidate in joints):
            raise ValueError(
                f"The joint {joint.name} is not one of the joints of `eom_method`: "
                f"{describe([candidate.name for candidate in joints])}. Give all bodies beyond it "
                "instead."
            )
        points = [joint.child.masscenter]
        for point in points:
            for candidate in joints:
                ends = [candidate.parent.masscenter, candidate.child.masscenter]
                if candidate is not joint and point in ends:
                    points += [end for end in ends if end not in points]
        return [body for body in bodies if body.masscenter in points]


def _as_list(bodies: _OneSide) -> list[Body | Location | str]:
    if isinstance(bodies, (str, RigidBody, Particle)):
        return [bodies]
    if not isinstance(bodies, Iterable):
        raise TypeError(
            "`bodies` must be a RigidBody or Particle, its name, or a list of them, got "
            f"{shown(bodies)}."
        )
    return listed("bodies", bodies)


def _member(bodies: Sequence[Body], item: Body | Location | str) -> Body | Location:
    """Return a body by its name, or a body, point or frame as it is."""
    member = item_of_name(bodies, item)
    if isinstance(item, (Point, ReferenceFrame)) or any(member is body for body in bodies):
        return member
    raise ValueError(
        f"`bodies` has {shown(item)}, which is not one of the system's bodies: "
        f"{describe(list(bodies))}. Give the RigidBody or Particle, or its name; or a joint alone."
    )


def _names_in(vector: Vector) -> set[str]:
    """Return the names of multipliers and reactions in a vector."""
    parts = [part for components, _ in vector.args for part in components]
    return {str(item) for part in parts for item in part.atoms(NodeExpression)}


def _holds_reaction(vector: Vector) -> bool:
    return any(name.startswith(_REACTION) for name in _names_in(vector))


def _warn_of_joints(
    joined: bool, across: Sequence[str], point: Point, loads: Sequence[Load]
) -> None:
    """Warn if something else joins the bodies to others, unless `loads` says what acts there.

    Constraints `across` the cut are not those of joints whose reactions are among the loads.
    """
    names = set().union(*(_names_in(vector) for _, vector in loads))
    resultant = (
        f", not at {point} alone: the reaction is the resultant of all that holds them, not the "
        f"force of one joint."
    )
    if missing := [name for name in across if name not in names]:
        more = f" and of {len(missing) - 1} more" if len(missing) > 1 else ""
        warn_user(
            f"The bodies are also held by the constraint of {missing[0]}{more}{resultant} Pass the "
            "constraints' forces as `loads`, in terms of `constraint_forces`, or `loads=[]` for "
            "the resultant."
        )
    elif joined and not loads:
        warn_user(
            f"The bodies are also joined to others{resultant} Give all bodies on one side of the "
            "joint in `bodies`, or what acts elsewhere as `loads`, or `loads=[]` for the resultant."
        )


def _warn_of_links(frames: Sequence[ReferenceFrame]) -> None:
    """Warn of torques on massless links between particles, which belong to no body."""
    first = frames[0]
    more = f" and {len(frames) - 1} more" if len(frames) > 1 else ""
    warn_user(
        f"The reaction's torque does not count the torque on the frame {first}{more}, which turns "
        f"with no rigid body, but with the line to a particle among `bodies`. Add {first} to "
        "`bodies` if the torque acts beyond the cut, or give it in `loads`."
    )


def _check_located(item: Point, point: Point) -> None:
    try:
        item.pos_from(point)
    except ValueError:
        raise ValueError(
            f"`point` is {point}, but the position of {item} from there is not known. Use "
            f"`{point}.set_pos(...)`, from a point that is located from the bodies."
        ) from None
