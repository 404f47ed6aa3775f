"""
Backing up a trailer
====================

Driving forwards, a trailer follows.  Driving backwards, it jackknifes, unless the driver steers
against it.  Wheels that do not slip sideways are nonholonomic constraints: one at the rear axle,
one at the front axle, one at the trailer.

With straight steering the hitch angle β grows by a closed form: tan(β/2) = tan(β₀/2) exp(s/L) after
s metres backwards, for a trailer of length L.  We compare with it.  Then a feedback law steers the
trailer onto a line.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.mechanics import Definition
from pydy.solvers import Event
from pydy.viz import Box, Cylinder, Line, Visual

WHEELBASE, TRAILER = 2.6, 3.5  # m

# %%
# Car, front wheels and trailer
# -----------------------------
# ψ is the car's heading, θ the trailer's, δ the steering angle.  The speeds v and s are the forward
# and the sideways velocity of the rear axle, where the trailer is hitched.

x, y, psi, theta, delta = me.dynamicsymbols("x y psi theta delta")
v, s, w, z, rate = me.dynamicsymbols("v s w z u_delta")
force, torque = me.dynamicsymbols("F T")
L, T, m, M, m_w, I, I_t, I_w = sm.symbols("L L_t m M m_w I I_t I_w")
t = me.dynamicsymbols._t

N, O = me.ReferenceFrame("N"), me.Point("O")
O.set_vel(N, 0)
C, D, W = (me.ReferenceFrame(name) for name in ("C", "D", "W"))
for frame, angle, turning in ((C, psi, w), (D, theta, z), (W, psi + delta, w + rate)):
    frame.orient_axis(N, N.z, angle)
    frame.set_ang_vel(N, turning * N.z)
rear = O.locatenew("rear axle", x * N.x + y * N.y)
rear.set_vel(N, v * C.x + s * C.y)
front, axle = rear.locatenew("front axle", L * C.x), rear.locatenew("trailer axle", -T * D.x)
car_centre = rear.locatenew("car centre", L / 2 * C.x)
trailer_centre = rear.locatenew("trailer centre", -sm.Rational(4, 5) * T * D.x)
for point, frame in ((front, C), (car_centre, C), (axle, D), (trailer_centre, D)):
    point.v2pt_theory(rear, N, frame)
bodies = [
    me.RigidBody("car", car_centre, C, m, (me.inertia(C, 0, 0, I), car_centre)),
    me.RigidBody("trailer", trailer_centre, D, M, (me.inertia(D, 0, 0, I_t), trailer_centre)),
    me.RigidBody("front wheels", front, W, m_w, (me.inertia(W, 0, 0, I_w), front)),
]

# %%
# Wheels roll, and do not slip sideways
# -------------------------------------
# Each constraint is the velocity of an axle along its own direction.

model = Definition(
    N,
    [x, y, psi, theta, delta],
    [v, s, w, z, rate],
    bodies=bodies,
    loads=[(rear, force * C.x), (W, torque * N.z), (C, -torque * N.z)],
    kinematic_equations=[
        x.diff(t) - rear.vel(N).dot(N.x),
        y.diff(t) - rear.vel(N).dot(N.y),
        psi.diff(t) - w,
        theta.diff(t) - z,
        delta.diff(t) - rate,
    ],
    nonholonomic_constraints=[
        rear.vel(N).dot(C.y),
        front.vel(N).dot(W.y),
        axle.vel(N).dot(D.y),
    ],
    dependent_speeds=[s, w, z],
)
system = System(
    model,
    constants={L: WHEELBASE, T: TRAILER, m: 1200, M: 700, m_w: 40, I: 1500, I_t: 900, I_w: 1.0},
    ode_solver="dop853",
)
print(
    f"{system.num_nonholonomic_constraints} nonholonomic constraints on {len(system.speeds)} speeds"
)

# %%
# Jackknife
# ---------
# The car drives backwards at 1 m/s with straight steering.  The hitch angle is only one degree at
# the start.  The run ends at 70°.


def hands(wanted):
    """Return the torque that turns the front wheels to a steering angle."""
    return -400 * (delta - wanted) - 40 * rate


engine = -2000 * (v + 1.0)
hitch = psi - theta
system.specifieds = {force: engine, torque: hands(0)}
start = np.radians(1.0)
system.initial_conditions = {v: -1.0, theta: -start}
system.set_dependent_initial_conditions()
system.times = np.linspace(0.0, 25.0, num=1501)
folded = Event(hitch - np.radians(70.0), direction=1, terminal=True, name="jackknifed")
jackknife = system.simulate(events=folded, rtol=1e-10, atol=1e-10)


def scene_of(title):
    """Return a scene of car and trailer."""
    wheel = Cylinder(0.25, 0.32, color="dimgrey")
    visuals = [
        Visual(
            Box(4.0, 1.7, 0.9, color="steelblue"), C, car_centre.locatenew("car box", 0.7 * N.z)
        ),
        Visual(
            Box(3.2, 1.9, 1.0, color="darkorange"),
            D,
            rear.locatenew("trailer box", -0.75 * T * D.x + 0.8 * N.z),
        ),
        Visual(
            Line(
                [rear.locatenew("coupling", 0.4 * N.z), axle.locatenew("shaft", 0.4 * N.z)],
                radius=0.06,
            )
        ),
    ]
    for point, frame in ((front, W), (rear, C), (axle, D)):
        for side in (-0.85, 0.85):
            body = D if point is axle else C
            hub = point.locatenew(f"{point.name} {side}", side * body.y + 0.32 * N.z)
            visuals.append(Visual(wheel, frame, hub, name="wheels"))
    return system.scene(
        *visuals,
        reference_frame=N,
        origin=O,
        up="z",
        ground=0.0,
        view=(0.3, -1, 0.8),
        series={"hitch angle": hitch, "steering angle": delta},
        title=title,
    )


scene_of("Jackknife").animate(jackknife)

# %%
# The closed form holds at every metre.

back = -jackknife[x]
beta = jackknife[psi] - jackknife[theta]
expected = 2 * np.arctan(np.tan(start / 2) * np.exp(back / TRAILER))
figure, axes = plt.subplots(figsize=(7, 3.2), layout="constrained")
axes.plot(back, np.degrees(beta), label="simulated")
axes.plot(back[::60], np.degrees(expected)[::60], "k+", label="closed form")
axes.set(xlabel="distance backwards [m]", ylabel="hitch angle [deg]")
axes.grid(alpha=0.3)
axes.legend()
error = np.abs(beta - expected).max()
print(f"hitch angle against the closed form: {error:.0e} rad")
assert error < 1e-7

# %%
# Steering onto a line
# --------------------
# The controller is a cascade.  The offset and heading of the trailer determine a desired hitch
# angle, limited to 30°.  The error of the hitch angle determines the steering angle, such that the
# hitch follows as a first-order lag over the distance driven.

offset = axle.pos_from(O).dot(N.y)
limit = np.radians(30.0)
wanted_hitch = limit * sm.tanh(TRAILER * (0.6 * theta - 0.09 * offset) / limit)
wanted_steering = sm.atan(WHEELBASE * (sm.sin(hitch) / TRAILER + 0.9 * (hitch - wanted_hitch)))
system.specifieds = {force: engine, torque: hands(wanted_steering)}
system.outputs = {"offset": offset}
system.initial_conditions = {v: -1.0, y: 4.0}
system.set_dependent_initial_conditions()
system.times = np.linspace(0.0, 50.0, num=1501)
parking = system.simulate(rtol=1e-9, atol=1e-9)
scene_of("Backing up onto a line").animate(parking, speed=3.0)

# %%
# The track of the trailer, and where it stands at some instants:

figure, axes = plt.subplots(figsize=(8, 3.2), layout="constrained")
ax_x = parking[x] - TRAILER * np.cos(parking[theta])
axes.axhline(0.0, color="0.7")
axes.plot(ax_x, parking["offset"], color="tab:orange", label="trailer axle")
axes.plot(parking[x], parking[y], color="tab:blue", linewidth=0.8, label="rear axle of the car")
for k in range(0, len(parking.times), 150):
    axes.plot([ax_x[k], parking[x][k]], [parking["offset"][k], parking[y][k]], "0.4", linewidth=2)
axes.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
axes.grid(alpha=0.3)
axes.legend()

# %%
# Checks
# ------
# The trailer ends on the line, and no wheel has slipped.

print(f"offset of the trailer at the end: {parking['offset'][-1]:.4f} m")
assert abs(parking["offset"][-1]) < 0.01
slipped = np.abs(system.evaluate_velocity_constraints(x=parking.states)).max()
print(f"sideways slip: {slipped:.0e} m/s at most")
assert slipped < 1e-6

plt.show()
