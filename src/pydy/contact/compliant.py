"""A point that touches a plane: laws of contact and friction as loads and events."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

import sympy as sm
from sympy.physics.mechanics import Point, ReferenceFrame, Vector, dynamicsymbols

from pydy._checks import flag, instance, shown
from pydy._rank import ROUNDED
from pydy.contact.laws import _axes, _check_units, _expressions
from pydy.solvers import Event

# A law of a force: a function of two expressions.
Law: TypeAlias = Callable[[sm.Expr, sm.Expr], sm.Expr | float]


class CompliantContact:
    """A point of a body that touches a plane, by a law of the normal force and one of friction.

    Parameters
    ----------
    point : Point
        Point of the body, with a velocity in `frame`.
    plane : Point
        Point of the plane, with a velocity in `frame`. If it belongs to a body, it must be where
        the body is touched, or friction and normal force act at the wrong place.
    normal : Vector
        Unit normal of the plane, towards the body's side.
    frame : ReferenceFrame
        The inertial frame.
    force : callable
        ``force(gap, rate)`` returns the normal force.
    friction : callable, optional
        ``friction(speed, normal)`` returns the friction along a sliding speed.
    along : Vector, or two Vectors, optional
        Unit vectors in the plane, orthogonal to each other, along which the point slides; needed
        with `friction`.
    smoothing : expression, optional
        A small sliding speed (m/s), needed with two vectors: the size of the sliding velocity is
        √(v₁² + v₂² + smoothing²), so that its direction is smooth at rest.
    reaction : bool, optional
        Whether the opposite force acts at `plane`; needed if that is a point of a moving body.
    name : str, optional
        Name of the event.

    Attributes
    ----------
    gap, rate : expression
        Distance and its time derivative.
    speeds : tuple of expressions
        Sliding speeds along the vectors.
    normal_force : expression
    friction_forces : tuple of expressions
        Along the vectors.
    loads : list of (Point, Vector)
        For ``KanesMethod.kanes_equations``, ``System.add_loads`` or ``Definition``.
    events : list of Event
        Where the gap closes and opens: with these, a solver steps over no touch that is longer than
        a quarter of its step.

    Examples
    --------
    >>> import numpy as np
    >>> import sympy as sm
    >>> import sympy.physics.mechanics as me
    >>> from pydy import System
    >>> from pydy.contact import CompliantContact, hunt_crossley
    >>> from pydy.mechanics import Definition
    >>> y, v = me.dynamicsymbols('y v')
    >>> m, g = sm.symbols('m g')
    >>> N, O = me.ReferenceFrame('N'), me.Point('O')
    >>> O.set_vel(N, 0)
    >>> P = O.locatenew('P', y*N.y)
    >>> floor = CompliantContact(P, O, N.y, N, lambda gap, rate: hunt_crossley(gap, rate, 1e6, 0.3))
    >>> system = System(Definition(N, [y], [v], bodies=[me.Particle('ball', P, m)],
    ...                            loads=[(P, -m*g*N.y), *floor.loads]),
    ...                 {g: 9.81}, ode_solver='dop853', initial_conditions={y: 1.0},
    ...                 times=np.linspace(0.0, 1.0, 101))
    >>> touches = system.simulate(events=floor.events, rtol=1e-10, atol=1e-10).events
    >>> [round(event.time, 4) for event in touches]
    [0.4515, 0.4622, 0.9252, 0.9368]
    """

    def __init__(
        self,
        point: Point,
        plane: Point,
        normal: Vector,
        frame: ReferenceFrame,
        force: Law,
        friction: Law | None = None,
        *,
        along: Vector | Sequence[Vector] | None = None,
        smoothing: sm.Expr | float | None = None,
        reaction: bool = False,
        name: str = "touch",
    ) -> None:
        instance(point, Point, "`point`")
        instance(plane, Point, "`plane`")
        instance(normal, Vector, "`normal`")
        instance(frame, ReferenceFrame, "`frame`")
        for argument, function in (("force", force), ("friction", friction)):
            if not callable(function) and (function is not None or argument == "force"):
                raise TypeError(f"`{argument}` must be a function, got {shown(function)}.")
        opposite = flag(reaction, "`reaction`")
        directions = _axes(along)
        _check_units("normal", [normal])
        _check_in_plane(directions, normal)
        if (friction is None) != (not directions):
            raise ValueError("`friction` and `along` belong together: give both or none.")
        if (len(directions) == 2) != (smoothing is not None):
            raise ValueError("`smoothing` must be given with two vectors in `along`, and only so.")
        sliding = point.vel(frame) - plane.vel(frame)
        self.gap = point.pos_from(plane).dot(normal)
        self.rate = sm.sympify(self.gap).diff(dynamicsymbols._t)
        self.speeds = tuple(sliding.dot(v) for v in directions)
        self.normal_force = _of_law("force(gap, rate)", force, self.gap, self.rate)
        self.friction_forces = self._friction(friction, smoothing)
        total = self.normal_force * normal
        for size, direction in zip(self.friction_forces, directions, strict=True):
            total += size * direction
        self.loads = [(point, total), *([(plane, -total)] if opposite else [])]
        self.events = [Event(self.gap, name=name)]

    def _friction(self, law: Law | None, smoothing: sm.Expr | float | None) -> tuple[sm.Expr, ...]:
        if law is None:
            return ()
        signature = "friction(speed, normal)"
        if len(self.speeds) == 1:
            return (_of_law(signature, law, self.speeds[0], self.normal_force),)
        (small,) = _expressions(smoothing=smoothing)
        size = sm.sqrt(sum(v**2 for v in self.speeds) + small**2)
        share = _of_law(signature, law, size, self.normal_force) / size
        return tuple(share * v for v in self.speeds)


def _check_in_plane(directions: Sequence[Vector], normal: Vector) -> None:
    """Refuse directions of sliding with a component along the normal."""
    for direction in directions:
        product = sm.simplify(direction.dot(normal))
        if product.is_number and not abs(product) <= ROUNDED:
            raise ValueError(
                f"`along` must lie in the plane, orthogonal to the normal {normal}, got "
                f"{direction}: friction along it would push the bodies apart or together. Subtract "
                "its component along the normal."
            )


def _of_law(signature: str, law: Law, *arguments: sm.Expr) -> sm.Expr:
    """Return the force that a user's law gives: an expression or a number."""
    try:
        force = law(*arguments)
    except Exception as error:
        error.add_note(f"This was raised by `{signature}`, called with expressions.")
        raise
    return _expressions(**{signature: force})[0]
