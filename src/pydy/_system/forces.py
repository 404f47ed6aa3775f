"""Constraint forces of a System, and reactions of its joints."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from pydy._mechanics.reactions import Multipliers, Reaction, multipliers, reaction
from pydy._simulation.missing_derivatives import warn_of_missing_derivatives
from pydy._system.setup import Setup


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
        return multipliers(self._equations, self._forces)

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
        found = reaction(self._equations, self._forces, bodies, point, frame, loads)
        if self._equations.forgotten:
            warn_of_missing_derivatives(self._now())
        return found
