"""A rigid car on a level road, in the plane: its kinematics, and wheels that spin."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import sympy as sm
import sympy.physics.mechanics as me

if TYPE_CHECKING:
    from pydy._sympy_types import Load

LOWEST_SPEED = 0.1  # m/s, that slips are relative to at least, as in the source of `CARS`


class Chassis:
    """A body with the coordinates x, y, ψ of its mass centre G and the speeds u, v, r.

    u points forward, v to the left; u may be a constant. The frame B is fixed in the body.
    """

    def __init__(self, mass: sm.Symbol, yaw_inertia: sm.Symbol, u: sm.Expr) -> None:
        x, y, psi, v, r = me.dynamicsymbols("x y psi v r")
        self.N, self.B = me.ReferenceFrame("N"), me.ReferenceFrame("B")
        self.origin = me.Point("O")
        self.u, self.v, self.r = u, v, r
        self.B.orient_axis(self.N, self.N.z, psi)
        self.B.set_ang_vel(self.N, r * self.N.z)
        self.origin.set_vel(self.N, 0)
        self.G = self.origin.locatenew("G", x * self.N.x + y * self.N.y)
        self.G.set_vel(self.N, u * self.B.x + v * self.B.y)
        inertia = (me.inertia(self.B, 0, 0, yaw_inertia), self.G)
        self.body = me.RigidBody("car", self.G, self.B, mass, inertia)
        self.coordinates = [x, y, psi]
        self.kinematic_equations = [
            x.diff() - u * sm.cos(psi) + v * sm.sin(psi),
            y.diff() - u * sm.sin(psi) - v * sm.cos(psi),
            psi.diff() - r,
        ]

    def point(self, name: str, forward: Any, left: Any = 0) -> me.Point:
        """Return a point of the body."""
        return self.G.locatenew(name, forward * self.B.x + left * self.B.y)

    def wheel(
        self,
        name: str,
        forward: Any,
        left: Any,
        steering: Any,
        radius: Any,
        inertia: Any,
        sideways: Any = 0,
    ) -> Wheel:
        """Return a wheel of this body that spins with a speed of its own, ω_name.

        Its side slip has the speed `sideways`, by the roll of an axle, in addition.
        """
        point = self.point(name, forward, left)
        spin = me.dynamicsymbols(f"omega_{name}")
        # In the plane, only the inertia about the axle matters, whichever way that is steered.
        frame = me.ReferenceFrame(f"W_{name}")
        frame.orient_axis(self.B, self.B.y, 0)
        frame.set_ang_vel(self.B, spin * self.B.y)
        body = me.RigidBody(name, point, frame, 0, (me.inertia(self.B, 0, inertia, 0), point))
        ahead, aside = self.u - self.r * left, self.v + self.r * forward
        cos, sin = sm.cos(steering), sm.sin(steering)
        speed = ahead * cos + aside * sin
        aside += sideways
        rolling = ahead * cos + aside * sin
        return Wheel(
            body,
            point,
            spin,
            radius,
            cos * self.B.x + sin * self.B.y,
            cos * self.B.y - sin * self.B.x,
            self.B.y,
            speed,
            (radius * spin - speed) / _size(speed),
            sm.atan((aside * cos - ahead * sin) / _size(rolling)),
        )


@dataclass(frozen=True, eq=False)
class Wheel:
    """A wheel, where it is, and its slips κ and α."""

    body: me.RigidBody
    point: me.Point
    spin: sm.Expr
    radius: sm.Expr
    forward: me.Vector
    left: me.Vector
    axle: me.Vector
    speed: sm.Expr
    kappa: sm.Expr
    alpha: sm.Expr

    def brake(self, torque: sm.Expr) -> sm.Expr:
        """Return the torque of a brake, against the spin; it fades where the wheel stands still."""
        turning = self.radius * self.spin / LOWEST_SPEED
        return -torque * sm.Max(-1, sm.Min(turning, 1, evaluate=False), evaluate=False)

    def loads(self, Fx: sm.Expr, Fy: sm.Expr, torque: sm.Expr) -> list[Load]:
        """Return the loads of the road's forces and of the torque of a drive or a brake."""
        force = Fx * self.forward + Fy * self.left
        return [
            (self.point, force),
            (self.body.frame, (torque - self.radius * Fx) * self.axle),
        ]


def _size(speed: sm.Expr) -> sm.Expr:
    """Return the speed that slips are relative to."""
    return sm.Max(sm.Abs(speed, evaluate=False), LOWEST_SPEED, evaluate=False)
