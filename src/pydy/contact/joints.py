"""Contacts defined by a geometry: bodies that roll, and joints with play."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sm
from sympy.physics.mechanics import Point, ReferenceFrame, RigidBody, Vector

from pydy._checks import instance, shown
from pydy.contact.conditions import Stick, Unilateral
from pydy.contact.laws import _check_units, _expressions


class Roll(Stick):
    """A ball, disc or wheel on a plane: it rolls while friction holds, and slides otherwise.

    A `Stick` on a `Unilateral`, for the point of the body that touches the plane: it is another
    one at each instant, at −`radius` n from the centre of a ball with the normal n, or at the
    lowest point of the rim of a disc.

    Parameters
    ----------
    body : RigidBody
        Its mass centre is the centre of the ball or disc.
    radius : expression
    on : Point
        A point of the plane.
    normal : Vector
        Unit vector, out of the plane. The plane moves with the frame that it is written in.
    along : Vector or two Vectors
        Unit vector along which it may slide, or two of the plane, orthogonal to each other.
    mu, mu_static, name
        As in `Stick`.
    axis : Vector, optional
        Unit vector: the axis of a thin disc; without it a ball, or a disc in plane motion.
    restitution : expression, optional
        As in `Unilateral`.

    Examples
    --------
    >>> import sympy as sm
    >>> import sympy.physics.mechanics as me
    >>> from pydy.contact import Roll
    >>> x, y, phi = me.dynamicsymbols('x, y, phi')
    >>> r = sm.Symbol('r')
    >>> N, O, B = me.ReferenceFrame('N'), me.Point('O'), me.ReferenceFrame('B')
    >>> B.orient_axis(N, N.z, phi)
    >>> C = O.locatenew('C', x*N.x + y*N.y)
    >>> ball = me.RigidBody('ball', C, B, 1, (me.inertia(B, 0, 0, 1), C))
    >>> rolls = Roll(ball, r, on=O, normal=N.y, along=N.x, mu=0.2, name='table')
    >>> rolls.on
    <Unilateral table: -r + y(t)>
    """

    def __init__(
        self,
        body: RigidBody,
        radius: sm.Expr | float,
        *,
        on: Point,
        normal: Vector,
        along: Vector | Sequence[Vector],
        mu: sm.Expr | float,
        mu_static: sm.Expr | float | None = None,
        axis: Vector | None = None,
        restitution: sm.Expr | float = 0,
        name: str = "roll",
    ) -> None:
        instance(body, RigidBody, "`body`")
        (self.radius,) = _expressions(radius=radius)
        _positive("radius", self.radius)
        instance(on, Point, "`on`", "a Point of the plane")
        _unit("normal", normal)
        if len(normal.args) != 1:
            raise ValueError(
                f"`normal` must be written in one frame, that of the plane, got {normal}."
            )
        if axis is not None:
            _unit("axis", axis)
        if along is None:
            raise TypeError("`along` must be one Vector or two, got None.")
        self.body, self.plane_point, self.normal_vector = body, on, normal
        across = sm.S.One if axis is None else sm.sqrt(1 - normal.dot(axis) ** 2)
        lowest = normal if axis is None else (normal - normal.dot(axis) * axis) / across
        self.arm = -self.radius * lowest
        height = body.masscenter.pos_from(on).dot(normal)
        gap = Unilateral(height - self.radius * across, restitution=restitution, name=name)
        super().__init__(
            body.masscenter, on=gap, mu=mu, mu_static=mu_static, along=along, name=name
        )

    def speeds(self, frame: ReferenceFrame) -> tuple[sm.Expr, ...]:
        """Return the sliding speed or speeds, from velocities in the inertial frame."""
        centre, plane = self.body.masscenter, self.normal_vector.args[0][1]
        touched = centre.pos_from(self.plane_point) + self.arm
        velocity = centre.vel(frame) + self.body.frame.ang_vel_in(frame).cross(self.arm)
        velocity -= self.plane_point.vel(frame) + plane.ang_vel_in(frame).cross(touched)
        return tuple(velocity.dot(axis) for axis in self.along)


class Clearance(Stick):
    """A revolute joint with play: a pin in a bush that is wider, with restitution and friction.

    A `Stick` on a `Unilateral`. With the vector e from the centre of the bush to that of the pin,
    and the play c, the gap is (c² − e²)/(2 c): c less the length of e where they
    touch, with the same rate, and smooth where the pin is in the middle.

    Parameters
    ----------
    pin, bush : Point
        Their centres, each a point of its own body. They may be apart along `axis`.
    radius : expression
        Of the pin.
    play : expression
        Radius of the bush less that of the pin.
    axis : Vector
        Unit vector along the joint, fixed in the body of the bush.
    frames : pair of ReferenceFrames
        Those of the bodies of the pin and of the bush.
    mu : expression
        Coefficient of friction, zero for a joint without friction.
    mu_static, name
        As in `Stick`.
    restitution : expression, optional
        As in `Unilateral`.

    Examples
    --------
    >>> import sympy as sm
    >>> import sympy.physics.mechanics as me
    >>> from pydy.contact import Clearance
    >>> x, y = me.dynamicsymbols('x, y')
    >>> r, c = sm.symbols('r, c')
    >>> N, O, B = me.ReferenceFrame('N'), me.Point('O'), me.ReferenceFrame('B')
    >>> P = O.locatenew('P', x*N.x + y*N.y)
    >>> Clearance(P, O, radius=r, play=c, axis=N.z, frames=(B, N), mu=0.1, name='pin').on
    <Unilateral pin: (c**2 - x(t)**2 - y(t)**2)/(2*c)>
    """

    def __init__(
        self,
        pin: Point,
        bush: Point,
        *,
        radius: sm.Expr | float,
        play: sm.Expr | float,
        axis: Vector,
        frames: tuple[ReferenceFrame, ReferenceFrame],
        mu: sm.Expr | float,
        mu_static: sm.Expr | float | None = None,
        restitution: sm.Expr | float = 0,
        name: str = "clearance",
    ) -> None:
        instance(pin, Point, "`pin`")
        instance(bush, Point, "`bush`")
        self.radius, self.play = _expressions(radius=radius, play=play)
        _positive("radius", self.radius)
        _positive("play", self.play)
        _unit("axis", axis)
        pair = isinstance(frames, (tuple, list)) and len(frames) == 2
        if not pair or not all(isinstance(frame, ReferenceFrame) for frame in frames):
            raise TypeError(f"`frames` must be a pair of ReferenceFrames, got {shown(frames)}.")
        self.bush, self.frames, self.axis = bush, tuple(frames), axis
        separation = pin.pos_from(bush)
        self.axial_offset = separation.dot(axis) * axis
        self.offset = separation - self.axial_offset
        gap = (self.play**2 - self.offset.dot(self.offset)) / (2 * self.play)
        pressed = Unilateral(gap, restitution=restitution, name=name)
        super().__init__(pin, on=pressed, mu=mu, mu_static=mu_static, along=axis, name=name)

    def speeds(self, frame: ReferenceFrame) -> tuple[sm.Expr, ...]:
        """Return the sliding speed, from velocities in the inertial frame.

        It is that of the pin on the bush where they touch, r and r + c away from their axes. The
        centre of the bush may lie elsewhere along its axis than that of the pin.
        """
        rates = [frame_of_body.ang_vel_in(frame) for frame_of_body in self.frames]
        pin, bush = (rate.dot(self.axis) for rate in rates)
        opposite = self.bush.vel(frame) + rates[1].cross(self.axial_offset)
        tangential_speed = (self.point.vel(frame) - opposite).dot(self.axis.cross(self.offset))
        return (
            tangential_speed / self.play + self.radius * pin - (self.radius + self.play) * bush,
        )


def _unit(argument: str, value: Vector) -> None:
    instance(value, Vector, f"`{argument}`", "a unit Vector")
    _check_units(argument, (value,))


def _positive(argument: str, value: sm.Expr) -> None:
    if value.is_number and not (value.is_real and value > 0):
        raise ValueError(f"`{argument}` must be positive, got {value}.")
