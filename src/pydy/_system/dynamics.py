"""Inverse dynamics, terms of the equations of motion, and frames of a System."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from pydy._simulation.dynamics import (
    Quantity,
    evaluate,
    frame_jacobian,
    frame_position,
    frame_rotation,
    gravity,
    inverse_dynamics,
    mass_matrix,
    required_forces,
)
from pydy._system.setup import Setup


class Dynamics(Setup):
    """Inverse dynamics, terms of the equations of motion, and how frames move."""

    def _evaluated(self, made: Quantity, q: Any, t: Any, r: Any, p: Any, wrt: Any) -> np.ndarray:
        """Evaluate what depends on no speeds."""
        at = q, None, np.zeros(0), t
        return evaluate(self._now(constants=p), made, at, r, p, wrt, self._values)

    @property
    def _values(self) -> Mapping[Any, float]:
        """The method's values of constants that the motion does not depend on."""
        values: Mapping[Any, float] = getattr(self._eom_method, "values", {})
        return values

    def inverse_dynamics(
        self,
        q: Any = None,
        v: Any = None,
        a: Any = None,
        t: Any = None,
        *,
        at: Any = None,
        r: Any = None,
        p: Any = None,
        wrt: Any = None,
    ) -> np.ndarray:
        """Return the generalised forces that a motion needs in addition to the loads.

        τ = M(q) a + b(q, v), with `mass_matrix` and `bias`. They are what has to be added to the
        system's loads, specifieds included, so that the speeds change at the rates a. The force at
        a speed times that speed is a power: N for m/s, N m for rad/s. The recursive Newton–Euler
        algorithm gives them, in about half of the operations of `evaluate_ode`.

        Without `at` these are forces at all speeds, with which the motion needs no constraint
        forces: in a mechanism with loops, those of the tree that is left when the loops are cut.
        With `at` they act at some speeds alone, such as those of the motors, and constraints do the
        rest.

        Parameters
        ----------
        q, v : array_like, shape (n,) or (m, n), or dict, optional
            Coordinates, and speeds, in the orders of `coordinates` and `speeds`; by default the
            initial conditions. A dictionary gives some of these instead, by symbol or name; a
            warning reports a state that then violates the constraints.
        a : array_like, shape (n,) or (m, n), or dict, optional
            Derivatives of the speeds. Those of as many speeds as the constraints leave free bring
            the others along, as the constraints say: of the independent ones, by shape, or of those
            that a dictionary names. Where it names independent speeds alone, those of other
            independent speeds are zero, as all are by default.
        t : float or array_like, shape (m,), optional
            Time; by default the first of `times`, or zero.
        at : {'independent'} or list of speeds or names, optional
            Where the forces act, in this order: as many speeds as the constraints leave free.
        r, p
            As in `evaluate_ode`.
        wrt : {'coordinates', 'speeds', 'accelerations', 'specifieds', 'constants'}, list, optional
            Return the exact derivatives by these instead, or by symbols or names.

        Returns
        -------
        ndarray, shape (k,) or (m, k)
            One force for each speed, or for each in `at`. With `wrt` one more axis, for the
            variables.

        Raises
        ------
        ValueError
            A shape or a name is not valid, or constraints are known but no bodies.
        SingularMatrixError
            Forces at these speeds cannot give this motion: the mechanism is singular there.

        References
        ----------
        Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, section 5.3.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.inverse_dynamics([1.0], [0.0], [0.0])  # holds the spring
        array([1.])
        >>> system.inverse_dynamics([1.0], [0.0], system.evaluate_ode([1.0, 0.0])[1:])
        array([0.])
        """
        problem = self._now(constants=p)
        return inverse_dynamics(problem, (q, v, a, t), at, r, p, wrt, self._values)

    def mass_matrix(
        self, q: Any = None, t: Any = None, *, r: Any = None, p: Any = None, wrt: Any = None
    ) -> np.ndarray:
        """Return the mass matrix of all speeds, before any constraint reduces it.

        Parameters
        ----------
        q, t, r, p, wrt
            As in `inverse_dynamics`.

        Returns
        -------
        ndarray, shape (n, n) or (m, n, n)
            Entries times a product of two speeds are energies. It is symmetric, unless loads hold
            accelerations.

        Examples
        --------
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1, cart_force=False)
        >>> system.mass_matrix([0.0, 0.0])
        array([[ 2., -1.],
               [-1.,  1.]])
        """
        return self._evaluated(mass_matrix(self._equations), q, t, r, p, wrt)

    def bias(
        self,
        q: Any = None,
        v: Any = None,
        t: Any = None,
        *,
        r: Any = None,
        p: Any = None,
        wrt: Any = None,
    ) -> np.ndarray:
        """Return the generalised forces at zero accelerations, one for each speed.

        They balance gravity and all other loads, and what the speeds bring: Coriolis and
        centrifugal forces.

        Parameters
        ----------
        q, v, t, r, p, wrt
            As in `inverse_dynamics`.

        Returns
        -------
        ndarray, shape (n,) or (m, n)

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> multi_mass_spring_damper().bias([1.0], [2.0])  # k0*x0 + c0*v0
        array([3.])
        """
        made, at = required_forces(self._equations, (), None, zero=True), (q, v, np.zeros(0), t)
        return evaluate(self._now(constants=p), made, at, r, p, wrt, self._values)

    def gravity(
        self,
        q: Any = None,
        t: Any = None,
        *,
        acceleration: Any = None,
        r: Any = None,
        p: Any = None,
        wrt: Any = None,
    ) -> np.ndarray:
        """Return the generalised forces that hold all masses against gravity.

        Gravity is what the loads at all mass centres have in common: forces for each body with a
        mass, this mass times one constant acceleration. In one vector with others it is not known.

        Parameters
        ----------
        q, t, r, p, wrt
            As in `inverse_dynamics`.
        acceleration : Vector, optional
            Of free fall, such as ``-g*N.z``, if it cannot be found from the loads.

        Returns
        -------
        ndarray, shape (n,) or (m, n)

        Raises
        ------
        ValueError
            The loads at mass centres have no acceleration in common, one of them may contain
            other forces than a weight, or gravity is in a Lagrangian; give `acceleration`.

        Examples
        --------
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1)
        >>> system.constants = {'g': 10.0}
        >>> system.gravity({'q1': 0.5}).round(6)
        array([0.      , 4.794255])
        """
        return self._evaluated(gravity(self._equations, acceleration), q, t, r, p, wrt)

    def frame_position(
        self,
        where: Any,
        q: Any = None,
        t: Any = None,
        *,
        r: Any = None,
        p: Any = None,
        wrt: Any = None,
    ) -> np.ndarray:
        """Return where a point is, in the axes of the inertial frame.

        It is measured from the point at rest that is next to the bodies.

        Parameters
        ----------
        where : str, RigidBody, Particle, Point, or pair of a ReferenceFrame and a Point
            A name is one of the `frames` of a `pydy.mechanics.Definition`, such as the links of a
            robot from a file, or that of a body, whose mass centre is meant.
        q, t, r, p, wrt
            As in `inverse_dynamics`.

        Returns
        -------
        ndarray, shape (3,) or (m, 3)

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> body = system.eom_method.bodies[0]
        >>> system.frame_position(body, [2.0])
        array([2., 0., 0.])
        """
        made = frame_position(self._equations, self._eom_method, where)
        return self._evaluated(made, q, t, r, p, wrt)

    def frame_rotation(
        self,
        where: Any,
        q: Any = None,
        t: Any = None,
        *,
        r: Any = None,
        p: Any = None,
        wrt: Any = None,
    ) -> np.ndarray:
        """Return the rotation matrix of a frame: its axes as columns, in the inertial frame.

        Parameters
        ----------
        where : str, RigidBody, ReferenceFrame, or pair of a ReferenceFrame and a Point
            As in `frame_position`.
        q, t, r, p, wrt
            As in `inverse_dynamics`.

        Returns
        -------
        ndarray, shape (3, 3) or (m, 3, 3)
        """
        made = frame_rotation(self._equations, self._eom_method, where)
        return self._evaluated(made, q, t, r, p, wrt)

    def frame_jacobian(
        self,
        where: Any,
        q: Any = None,
        t: Any = None,
        *,
        r: Any = None,
        p: Any = None,
        wrt: Any = None,
    ) -> np.ndarray:
        """Return how fast a frame moves with each speed, all speeds free.

        Parameters
        ----------
        where : str, RigidBody, Particle, Point, ReferenceFrame, or pair of the last two
            As in `frame_position`.
        q, t, r, p, wrt
            As in `inverse_dynamics`.

        Returns
        -------
        ndarray, shape (6, n) or (m, 6, n)
            Three rows for the velocity of the point, then three for the angular velocity, in the
            axes of the inertial frame: the derivatives of both by the speeds. For a point or a
            frame alone, its three rows. The transpose gives the generalised forces of a force and
            a torque there.

        Examples
        --------
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1)
        >>> cart, bob = system.eom_method.bodies
        >>> system.frame_jacobian(bob, [0.0, 0.0])
        array([[1., 1.],
               [0., 0.],
               [0., 0.]])
        """
        made = frame_jacobian(self._equations, self._eom_method, where)
        return self._evaluated(made, q, t, r, p, wrt)
