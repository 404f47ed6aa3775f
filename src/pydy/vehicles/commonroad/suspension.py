"""Axles of the multi-body model of CommonRoad: springs, joints to the sprung mass, and wheels.

Equations (A...) are those of Allen et al. 1992. Axes point forward, to the right, and down.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sm
import sympy.physics.mechanics as me

from pydy.vehicles.chassis import Chassis, Wheel
from pydy.vehicles.commonroad.tires import tire_forces


class SprungMass:
    """The body above the springs: roll φ, pitch θ and height z, and their rates p, q and w.

    It moves forward with the speed u of the car, and to the side with v.
    """

    def __init__(self, chassis: Chassis) -> None:
        self.chassis = chassis
        self.phi, self.theta, self.z = me.dynamicsymbols("phi theta z")
        self.p, self.q, self.w = me.dynamicsymbols("p q w")
        self.sin, self.cos = sm.sin(self.phi), sm.cos(self.phi)
        self.height, self.radius = sm.symbols("h R")


@dataclass(frozen=True, eq=False)
class Corner:
    """A wheel with the force of its spring, on a side: −1 at the left, 1 at the right."""

    side: int
    wheel: Wheel
    spring: sm.Expr
    gamma: sm.Expr
    Fx: sm.Expr
    Fy: sm.Expr
    Fz: sm.Expr
    along: sm.Expr
    across: sm.Expr

    def outputs(self) -> dict[str, sm.Expr]:
        """Return slips, camber and forces by their names."""
        wheel = self.wheel
        values = wheel.kappa, wheel.alpha, self.gamma, self.Fx, self.Fy, self.Fz
        names = ("kappa", "alpha", "gamma", "Fx", "Fy", "Fz")
        return {f"{n}_{wheel.body.name}": value for n, value in zip(names, values, strict=True)}


class Axle:
    """An unsprung mass: its roll φ_i and height z_i, and the speeds p_i, v_i and w_i.

    The joint to the sprung mass, at the roll axis, is displaced by y_i to the side.

    Parameters
    ----------
    body : SprungMass
    end : {'f', 'r'}
    forward : expression
        Position in front of the mass centre.
    steering : expression
        Steering angle of its wheels.
    load : expression
        Force of each spring at rest.

    Attributes
    ----------
    rates : dict
        Rates of the coordinates.
    joint, spring : expression
        Forces of the joint across the sprung mass, and of both springs.
    joint_moment, spring_moment : expression
        Their roll moments on the sprung mass; that of the springs on the axle is opposite.
    along, across, yaw_moment : expression
        Force of the road in its plane, and its moment about the car's mass centre.
    """

    def __init__(
        self, body: SprungMass, end: str, forward: sm.Expr, steering: sm.Expr, load: sm.Expr
    ) -> None:
        self.body, self.end, self.forward, self.load = body, end, forward, load
        self.phi, self.z, y = me.dynamicsymbols(f"phi_{end} z_{end} y_{end}")
        self.p, self.v, self.w = me.dynamicsymbols(f"p_{end} v_{end} w_{end}")
        self.track, roll_axis = sm.symbols(f"T_{end} h_ra{end}")
        self.mass, self.inertia = sm.symbols(f"m_u{end} I_u{end}")
        self.lever = roll_axis - body.radius
        # Of the sprung mass above the axle.
        self.distance = body.height - body.radius + self.z - body.z

        y_rate = body.chassis.v + forward * body.chassis.r - self.v
        self.rates = {self.phi: self.p, self.z: self.w, y: y_rate}
        self.joint = self._joint(y, y_rate)
        arm = self.distance - self.lever * sm.cos(self.phi)
        self.joint_moment = -self.joint / body.cos * arm

        self.corners = [self._corner(side, steering) for side in (-1, 1)]
        left, right = self.corners
        half = self.track / 2
        self.spring = left.spring + right.spring
        self.spring_moment = half * (left.spring - right.spring)
        self.along, self.across = left.along + right.along, left.across + right.across
        self.yaw_moment = forward * self.across + half * (left.along - right.along)

    def _joint(self, y: sm.Expr, y_rate: sm.Expr) -> sm.Expr:
        """Return the force of the joint, (A61) to (A68)."""
        stiffness, damping = sm.symbols("K_ras K_rad")
        body, distance, turned = self.body, self.distance, self.body.phi - self.phi
        stretch = distance * body.sin - y * body.cos - self.lever * sm.sin(turned)
        rate = (
            (distance * body.cos + y * body.sin) * body.p
            + (self.w - body.w) * body.sin
            - y_rate * body.cos
            - self.lever * sm.cos(turned) * (body.p - self.p)
        )
        return stiffness * stretch + damping * rate

    def _corner(self, side: int, steering: sm.Expr) -> Corner:
        body, end, R = self.body, self.end, self.body.radius
        K, damping, torsion = sm.symbols(f"K_s{end} K_sd{end} K_ts{end}")
        D, E, tire, J = sm.symbols(f"D_{end} E_{end} K_zt J")
        half, turned = side * self.track / 2, body.phi - self.phi
        # The travel of the spring, (A23) to (A26); camber, (A27) to (A30); load, (A48) to (A51).
        travel = self.distance / body.cos - (body.height - R)
        travel += self.forward * body.theta - half * turned
        rate = self.w - body.w + self.forward * body.q - half * (body.p - self.p)
        spring = self.load - K * travel - damping * rate - side * torsion / self.track * turned
        gamma = body.phi - side * (D * travel + E * travel**2)
        Fz = tire * (self.z + R * (sm.cos(self.phi) - 1) + half * sm.sin(self.phi))
        rolling = -self.p * (R - self.z)
        name = f"{end}{'l' if side < 0 else 'r'}"
        wheel = body.chassis.wheel(name, self.forward, half, steering, R, J, rolling)
        Fx, Fy = tire_forces(Fz, wheel.kappa, wheel.alpha, gamma)
        sin, cos = sm.sin(steering), sm.cos(steering)
        along, across = Fx * cos - Fy * sin, Fx * sin + Fy * cos
        return Corner(side, wheel, spring, gamma, Fx, Fy, Fz, along, across)
