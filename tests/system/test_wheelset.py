"""The wheelset of the Test Set for IVP Solvers: contact points, and forces that need each other."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from sympy import cos, sin, sqrt

from pydy import System
from pydy.mechanics import Definition, Implicit
from zoo import inertial_frame

# Cones on rails of circular profile, at 30 m/s on a straight track. The creep forces depend on the
# normal forces, and these on them. B. Simeon, C. Führer, P. Rentrop, "Introduction to differential-
# algebraic equations in vehicle system dynamics", Surv. Math. Ind. 1 (1991) 1-37; the numbers and
# the solution at t = 10 are those of the test set.
T = me.dynamicsymbols._t
SPEED, RADIUS, HALF, RAIL, CONE = 30.0, 0.1, 0.1506, 0.06, 0.0262
MASS, SPIN, YAW, SPRING, LEVER, GRAVITY = 16.08, 0.0605, 0.366, 6400.0, 0.19, 9.81
PLACES = X, Y, Z, THETA, PHI = me.dynamicsymbols("x, y, z, theta, phi", real=True)
SPEEDS = me.dynamicsymbols("v_x, v_y, v_z, v_theta, v_phi", real=True)
CHI, BETA = me.dynamicsymbols("chi, beta", real=True)
OMEGA = SPEED / RADIUS + BETA
UP = sm.Matrix([0, 1, 0])
START = {X: 0.14941e-02, Y: 0.40089e-06, Z: 0.11241e-05, THETA: -0.28573e-03, PHI: 0.26459e-03}
END = {
    "x": 0.86355386965811e-02, "y": 0.13038281022727e-04, "z": -0.93635784016818e-04,
    "theta": -0.13642299804033e-01, "phi": 0.15292895005422e-02,
    "v_x": -0.76985374142666e-01, "v_y": -0.25151106429207e-03, "v_z": 0.20541188079539e-02,
    "v_theta": -0.23904837703692, "v_phi": -0.13633468454173e-01, "beta": -0.24421377661131,
    "psi_r": -0.33666751972196e-03, "xi_r": -0.15949425684022,
    "psi_l": 0.37839614386969e-03, "xi_l": 0.14173214964613,
    "e_l": -0.10124044903201e-01, "e_r": -0.56285630573753e-02,
}  # fmt: skip


class Limited(sm.Function):
    """The first of two creep forces, which are limited one by one and then together.

    As a function of its own: SymPy would look for the real parts of tanh for minutes.
    """

    def doit(self, **hints):
        own, other = (sm.tanh(a, evaluate=False) for a in self.args)
        whole = sqrt(own**2 + other**2, evaluate=False)
        return own / sm.Max(whole, 1, evaluate=False)


def turned(angle):
    """The axes of the axle, yawed and rolled, and the horizontal one across, as columns."""
    flat, forward = sm.Matrix([cos(angle), 0, -sin(angle)]), sm.Matrix([sin(angle), 0, cos(angle)])
    return (cos(PHI) * flat + sin(PHI) * UP, cos(PHI) * UP - sin(PHI) * flat, forward), flat


class Wheel:
    """A wheel on its rail; `side` is 1 on the left, or −1."""

    def __init__(self, axle, side, name):
        self.unknowns = psi, xi = me.dynamicsymbols(f"psi_{name}, xi_{name}", real=True)
        self.rates = me.dynamicsymbols(f"psi_{name}_rate, xi_{name}_rate", real=True)
        self.e = me.dynamicsymbols(f"e_{name}", real=True)  # the multiplier, in 10⁴ N
        self.side = side
        slope = -side * np.tan(CONE)
        self.wheel = RADIUS + slope * (xi - side * HALF)
        self.arm = self.from_centre(axle)
        across = X + self.arm[0]
        beside = side * across - HALF - np.sin(CONE) * RAIL
        depth = sqrt(RAIL**2 - beside**2)
        tilt = -side * beside / depth
        normal = slope * axle[0] + cos(psi) * axle[1] + sin(psi) * axle[2]  # out of the wheel, down
        # Normals are parallel, that of the rail is (−tilt, 1, 0).
        self.geometry = [tilt * normal[1] + normal[0], normal[2]]
        self.incline = -side * sm.atan(normal[0] / normal[1])
        self.gap = depth - RADIUS - np.cos(CONE) * RAIL - Y - self.arm[1]
        self.row = sm.Matrix([[self.gap.diff(q) for q in PLACES]])

    def from_centre(self, axle):
        psi, xi = self.unknowns
        return xi * axle[0] - self.wheel * (cos(psi) * axle[1] + sin(psi) * axle[2])

    def creep(self, normal_force):
        """Kalker's coefficients with a smooth limit; the yaw is that in the plane of contact."""
        g, e = 0.7115218, 1.3537956
        stiff, friction, mu = 7.92e10, 0.12, 0.28
        c11, c22, c23 = 4.72772197, 4.27526987, 1.97203505
        axle, flat = turned(THETA / cos(self.incline))
        tilted = cos(self.incline) * flat + self.side * sin(self.incline) * UP
        centre = sm.Matrix([*SPEEDS[:2], SPEEDS[2] + SPEED])
        spin = OMEGA * axle[0] + SPEEDS[3] * UP + SPEEDS[4] * axle[2]
        sliding = centre + spin.cross(self.from_centre(axle))
        rolling = sqrt(sum(c**2 for c in sliding - 2 * centre)) / 2
        curves = 0.5 / (self.wheel * sqrt(1 + np.tan(CONE) ** 2)) + 0.5 / RAIL
        size = 3 * normal_force * (1 - mu) * e / (2 * 3.1415926 * curves * stiff * np.sqrt(g))
        size = size ** sm.Rational(1, 3)
        most = friction * normal_force
        turning = -self.side * sin(self.incline) * OMEGA + cos(self.incline) * SPEEDS[3]
        along = stiff * size**2 * c11 * sliding.dot(axle[2]) / rolling
        beside = stiff * size**2 * (c22 * sliding.dot(tilted) + size * c23 * turning) / rolling
        along, beside = along / most, beside / most
        return -most * (Limited(along, beside) * axle[2] + Limited(beside, along) * tilted)


def wheelset(**options):
    frame, origin = inertial_frame()
    axle, _ = turned(THETA)
    body = frame.orientnew("yawed", "Axis", (THETA, frame.y))
    body = body.orientnew("axle", "Axis", (PHI, body.z))
    body = body.orientnew("B", "Axis", (CHI + SPEED / RADIUS * T, body.x))
    centre = origin.locatenew("C", X * frame.x + Y * frame.y + (Z + SPEED * T) * frame.z)
    wheels = left, right = Wheel(axle, 1, "l"), Wheel(axle, -1, "r")
    pulls = [1e4 * wheel.e * wheel.row for wheel in wheels]
    pull = pulls[0] + pulls[1]
    # The normal forces have the multipliers' resultant in the plane across the track.
    a, b = left.incline, right.incline
    size = -sin(a + b)
    normal = (
        (cos(b) * pull[0] - sin(b) * pull[1]) / size,
        (-cos(a) * pull[0] - sin(a) * pull[1]) / size,
    )
    forces = [wheel.creep(n) for wheel, n in zip(wheels, normal, strict=True)]
    force = forces[0] + forces[1]
    force += sm.Matrix([-2 * SPRING * X, -MASS * GRAVITY, -2 * SPRING * Z])
    torque = -2 * LEVER**2 * SPRING * THETA * UP
    for wheel, own in zip(wheels, forces, strict=True):
        torque += wheel.arm.cross(own)
    # The test set takes for the constraints' moment about the axle's y what is about the track's.
    beyond = (1 - 1 / cos(PHI)) * pull[3] * axle[1]
    # Accelerations, and the gaps' second derivatives, which are zero.
    w = SPEEDS[3] * sin(PHI), SPEEDS[3] * cos(PHI), SPEEDS[4]
    accelerations = sm.Matrix([
        *((f + p) / MASS for f, p in zip(force, pull, strict=False)),
        (YAW * w[2] * w[0] - SPIN * OMEGA * w[2] - (SPIN - YAW) * w[0] * w[2]
         + torque.dot(axle[1]) + pull[3]) / (YAW * cos(PHI)),
        (SPIN * OMEGA * w[1] + (SPIN - YAW) * w[0] * w[1] + torque.dot(axle[2]) + pull[4]) / YAW,
    ])  # fmt: skip
    rates = dict(zip((q.diff() for q in PLACES), SPEEDS, strict=True))
    for wheel in wheels:
        rates |= dict(zip((s.diff() for s in wheel.unknowns), wheel.rates, strict=True))
    residuals = {}
    for wheel in wheels:
        residuals |= dict(zip(wheel.unknowns, wheel.geometry, strict=True))
        moved = [g.diff(T).subs(rates) for g in wheel.geometry]
        residuals |= dict(zip(wheel.rates, moved, strict=True))
        turning = wheel.row.diff(T).subs(rates)
        residuals[wheel.e] = (wheel.row * accelerations)[0] + turning.dot(SPEEDS)

    def along(columns):
        return sum((c * e for c, e in zip(columns, frame, strict=True)), 0 * frame.x)

    inertia = me.inertia(body, SPIN, YAW, YAW)
    coordinates, speeds = [*PLACES, CHI], [*SPEEDS, BETA]
    near = {X: 1e-3, THETA: 1e-3}
    definition = Definition(
        frame, coordinates, speeds,
        bodies=[me.RigidBody("W", centre, body, MASS, (inertia, centre))],
        loads=[(centre, along(force)), (body, along(torque + beyond))],
        holonomic_constraints=[wheel.gap for wheel in wheels],
        dependent_coordinates=[Y, PHI], dependent_speeds=[SPEEDS[1], SPEEDS[4]],
        configuration=near,
    )  # fmt: skip
    start = {left.unknowns[1]: 0.15, right.unknowns[1]: -0.15, left.e: -0.0079, right.e: -0.0079}
    return System(
        definition, implicit=Implicit(residuals, start), initial_conditions=START, **options
    )


def test_the_motion_ends_where_the_test_set_says():
    """All 17 published values, which were computed with rtol = atol = 1e-9."""
    system = wheelset(times=np.array([0.0, 10.0]), ode_solver="dop853")
    trajectory = system.simulate(rtol=1e-9, atol=1e-10, constraints="project")
    for name, value in END.items():
        assert trajectory[name][-1] == pytest.approx(value, rel=1e-5), name
