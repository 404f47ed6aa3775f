"""Constraint forces as a user asks for them: by name, for bodies, at a point."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import sympy as sm
from sympy.physics.mechanics import Particle, Point, ReferenceFrame, RigidBody
from sympy.physics.mechanics.joint import Joint

from pydy._checks import describe, instance, listed, shown, text
from pydy._mechanics.equations import Equations
from pydy._mechanics.forces import ConstraintForces
from pydy._mechanics.reader import read_loads
from pydy._names import name_of
from pydy._simulation.missing_derivatives import warn_of_missing_derivatives
from pydy._system.dynamics import named
from pydy._system.setup import Setup


class Multipliers(dict[Any, Any]):
    """Multipliers of the constraints by symbol; a name is taken too."""

    def __missing__(self, key: Any) -> Any:
        for symbol, expression in self.items():
            if symbol.name == key:
                return expression
        names = describe(list(self)) if self else "none"
        raise KeyError(f"`constraint_forces` has no multiplier {key!r}; it has {names}.")


@dataclass(frozen=True, eq=False)
class Reaction:
    """The force and torque by which a joint holds some bodies.

    Attributes
    ----------
    force : Vector
    torque : Vector
        About the point of the cut.
    frame : ReferenceFrame
        The axes in which both were formed.
    """

    force: Any
    torque: Any
    frame: Any

    def outputs(self, name: str) -> dict[Any, Any]:
        """Return the components as a dictionary for `System.outputs`.

        Parameters
        ----------
        name : str
            The outputs are called ``name_Fx``, ``name_Fy``, ``name_Fz``, ``name_Tx``, ``name_Ty``
            and ``name_Tz``.
        """
        text(name, "`name`", empty=False)
        found = {}
        for part, vector in (("F", self.force), ("T", self.torque)):
            for axis, value in zip("xyz", vector.to_matrix(self.frame), strict=True):
                found[sm.Symbol(f"{name}_{part}{axis}")] = value
        return found


def _forces(equations: Equations, *, bodies: bool) -> ConstraintForces:
    forces = equations.constraint_forces
    if bodies and forces is not None and forces.body.lagrangian is not None:
        raise ValueError(
            "Reactions follow from the bodies and the loads on each of them, but a Lagrangian does "
            "not tell which bodies its potential energy acts on. Give a `pydy.mechanics.Definition`"
            " or a KanesMethod with `bodies` and all loads, gravity included. The multipliers of a "
            "LagrangesMethod's constraints are in `constraint_forces`."
        )
    if forces is None or (bodies and not forces.body.bodies):
        raise ValueError(
            "Constraint forces follow from bodies and loads, but `eom_method` holds no bodies: "
            "construct a KanesMethod with `bodies=` and `forcelist=`, or call its "
            "`kanes_equations(bodies, loads)`."
        )
    return forces


def _joints(equations: Equations) -> tuple[Any, ...]:
    return equations.mechanism.joints if equations.mechanism is not None else ()


def _beyond(equations: Equations, forces: ConstraintForces, joint: Any) -> list[Any]:
    """Return the bodies beyond a joint: its child, and those that further joints attach to it."""
    joints = _joints(equations)
    if not any(joint is other for other in joints):
        raise ValueError(
            f"The joint {joint.name} is not one of the joints of `eom_method`: "
            f"{describe([other.name for other in joints])}. Give all bodies beyond it instead."
        )
    points = [joint.child.masscenter]
    for point in points:
        for other in joints:
            ends = [other.parent.masscenter, other.child.masscenter]
            if other is not joint and point in ends:
                points += [end for end in ends if end not in points]
    return [body for body in forces.body.bodies if body.masscenter in points]


def _several(bodies: Any) -> list[Any]:
    if isinstance(bodies, (str, RigidBody, Particle)):
        return [bodies]
    if not isinstance(bodies, Iterable):
        raise TypeError(
            "`bodies` must be a RigidBody or Particle, its name, or a list of them, got "
            f"{shown(bodies)}."
        )
    return listed("bodies", bodies)


def _member(forces: ConstraintForces, item: Any) -> Any:
    bodies = forces.body.bodies
    found = named(bodies, item)
    if isinstance(item, (Point, ReferenceFrame)) or any(found is body for body in bodies):
        return found
    raise ValueError(
        f"`bodies` has {shown(item)}, which is not one of the system's bodies: "
        f"{describe(list(bodies))}. Give the RigidBody or Particle, or its name; or a joint alone."
    )


def _check_way(item: Any, point: Any) -> None:
    try:
        item.pos_from(point)
    except ValueError:
        raise ValueError(
            f"`point` is {point}, but the position of {item} from there is not known. Use "
            f"`{point}.set_pos(...)`, from a point that is located from the bodies."
        ) from None


class Forces(Setup):
    """Constraint forces, and reactions of joints, bearings and contacts."""

    @property
    def constraint_forces(self) -> Multipliers:
        """Multipliers of the constraints: a dictionary that maps symbols to expressions.

        ``lambda0`` belongs to the first row of `constraints`, and so on; redundant constraints that
        were left out follow behind all others. The multiplier lambda of a row c adds lambda ∂c'/∂u
        to the equation of each speed u: a force in the direction in which c increases. Its unit
        times that of c is the unit of work (holonomic) or of power (nonholonomic). A row whose rate
        is not implied by any velocity constraint, such as the norm of a quaternion, has no
        multiplier.

        The expressions depend on states, derivatives of the speeds, constants and specifieds. They
        can be used in outputs, events and scenes; ``system.outputs = system.constraint_forces``
        makes each an output with its own name. Names can be used as keys. Forces that
        `noncontributing_forces` names by then are zero in them: the expressions include them.

        Raises
        ------
        ValueError
            The method knows no bodies.

        Examples
        --------
        The tension of a string is minus the multiplier of its length:

        >>> import sympy as sm
        >>> import sympy.physics.mechanics as me
        >>> from pydy.system import System
        >>> x, y, u, v = me.dynamicsymbols('x, y, u, v')
        >>> N, O = me.ReferenceFrame('N'), me.Point('O')
        >>> O.set_vel(N, 0)
        >>> P = O.locatenew('P', x*N.x + y*N.y)
        >>> kane = me.KanesMethod(
        ...     N, [x], [u], kd_eqs=[x.diff() - u, y.diff() - v], q_dependent=[y],
        ...     u_dependent=[v], configuration_constraints=[sm.sqrt(x**2 + y**2) - 2],
        ...     velocity_constraints=[x*u + y*v], bodies=[me.Particle('bob', P, 3)],
        ...     forcelist=[(P, -30*N.y)],
        ... )
        >>> system = System(kane)
        >>> system.outputs = {'tension': -system.constraint_forces['lambda0']}
        >>> system.evaluate_outputs([0.0, -2.0, 1.0, 0.0])[0].round(12)  # 3*10 + 3*1**2/2
        np.float64(31.5)
        """
        if self._equations.forgotten:
            warn_of_missing_derivatives(self._now())
        if not self._equations.velocity:
            return Multipliers()
        return Multipliers(_forces(self._equations, bodies=False).multipliers(self._forces))

    def reaction(
        self, bodies: Any, point: Any = None, *, frame: Any = None, loads: Iterable[Any] = ()
    ) -> Reaction:
        """Return the force and torque of a joint, bearing or contact on a group of bodies.

        They follow from the Newton–Euler equations: the resultant, about a point, of everything
        that acts on these bodies from outside, except the loads.

        Parameters
        ----------
        bodies : RigidBody, Particle, str, or list of them, or Joint
            All bodies on one side of the cut; for the reaction of a joint on the bodies beyond it,
            those bodies. A joint of a `sympy.physics.mechanics.System`, or its name, stands for its
            child and all bodies beyond. A load is included if the point or frame it acts on moves
            with one of the bodies and with no body outside, nor with the ground; of bodies
            welded together, it belongs to the one it was located or oriented from. The list may
            also contain hinges, and massless points and frames whose loads are to be included.
        point : Point
            Point of action of the force, and reference point of the torque; by default the joint's
            own point.
        frame : ReferenceFrame, optional
            Frame of the components; by default the inertial frame.
        loads : iterable of loads, optional
            Other loads that act on these bodies from outside, not at `point`: the reaction of
            another joint or contact, from multipliers or from another call. Pairs of a Point and a
            force, or of a ReferenceFrame and a torque.

        Returns
        -------
        Reaction
            ``force`` and ``torque``, SymPy vectors, which can be projected, added, or drawn as
            arrows. The method ``outputs(name)`` returns the six components for `outputs`.

        Raises
        ------
        TypeError, ValueError
            An argument is not valid, a position is not known, the method has no bodies, or it is a
            LagrangesMethod: a Lagrangian does not contain which load acts on which body.

        Notes
        -----
        The result may contain masses and inertias that do not affect the motion, such as the
        products of inertia that a RigidBody names itself. They become constants of the System when
        the reaction is used, and are 1.0 by default like all others: set them.

        Examples
        --------
        >>> import sympy.physics.mechanics as me
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1)
        >>> cart, bob = system.eom_method.bodies
        >>> pin = system.reaction(bob, cart.masscenter)  # of the cart on the rod
        >>> system.outputs = pin.outputs('pin')
        >>> system.constants = {'m1': 3.0, 'g': 10.0}
        >>> system.evaluate_outputs([0.0, 0.0, 0.0, 0.0]).round(12)[:2] + 0.0
        array([ 0., 30.])
        """
        equations = self._equations
        forces = _forces(equations, bodies=True)
        if isinstance(bodies, str) and bodies not in map(name_of, forces.body.bodies):
            bodies = named(_joints(equations), bodies)
        if isinstance(bodies, Joint):
            point = bodies.child_point if point is None else point
            bodies = _beyond(equations, forces, bodies)
        members = [_member(forces, item) for item in _several(bodies)]
        own = forces.body.bodies
        if not any(item in own for item in members):
            raise ValueError(
                f"`bodies` must hold one body of the system or more: {describe(list(own))}."
            )
        instance(point, Point, "`point`")
        if frame is None:
            frame = forces.body.frame
        instance(frame, ReferenceFrame, "`frame`")
        more = read_loads(listed("loads", loads, "loads"))
        for where, _ in more:
            if isinstance(where, Point):
                _check_way(where, point)
        for item in members:
            if not isinstance(item, ReferenceFrame):
                _check_way(item if isinstance(item, Point) else item.masscenter, point)
        name = f"reaction_{point}"
        found = forces.reaction(members, point, frame, more, name, self._forces)
        if equations.forgotten:
            warn_of_missing_derivatives(self._now())
        return Reaction(*found, frame)
