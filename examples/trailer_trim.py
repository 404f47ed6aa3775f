"""
A trailer in a turn, forwards and backwards
===========================================

A car with a steered front axle and a trailer behind it drives round a circle.  In the steady turn
the hitch angle is determined by geometry alone, while the motor works against the drag.  Driving
forwards, the trailer returns to that angle after a disturbance.  Driving backwards, it jackknifes.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.viz import Box, Line, Visual

BASE, TONGUE, STEER, DRAG = 2.7, 4.0, np.radians(15.0), 60.0  # m, m, rad, N s/m

# %%
# Equations
# ---------
# Three axles do not slip sideways: the car's rear axle, where the trailer is hitched, its front
# axle, and the trailer's.  One independent speed is left, that of the car along itself.

x, y, heading, hitch = me.dynamicsymbols("x y psi beta")
ahead, aside, yaw, fold = me.dynamicsymbols("v w r s")
drive = me.dynamicsymbols("F")
b, d, delta, c, m1, m2, i1, i2 = sm.symbols("b d delta c m1 m2 I1 I2")
t = me.dynamicsymbols._t
ground, origin = me.ReferenceFrame("N"), me.Point("O")
origin.set_vel(ground, 0)
car = ground.orientnew("C", "Axis", (heading, ground.z))
car.set_ang_vel(ground, yaw * ground.z)
trailer = car.orientnew("T", "Axis", (hitch, ground.z))
trailer.set_ang_vel(ground, (yaw + fold) * ground.z)
wheel = car.orientnew("W", "Axis", (delta, ground.z))
rear = origin.locatenew("R", x * ground.x + y * ground.y)
rear.set_vel(ground, ahead * car.x + aside * car.y)
front = rear.locatenew("A1", b * car.x)
front.v2pt_theory(rear, ground, car)
centre = rear.locatenew("M", b / 2 * car.x)
centre.v2pt_theory(rear, ground, car)
axle = rear.locatenew("A2", -d * trailer.x)
axle.v2pt_theory(rear, ground, trailer)
vehicle = me.RigidBody("car", centre, car, m1, (me.inertia(car, 0, 0, i1), centre))
load = me.RigidBody("trailer", axle, trailer, m2, (me.inertia(trailer, 0, 0, i2), axle))
kane = me.KanesMethod(
    ground,
    q_ind=[x, y, heading, hitch],
    u_ind=[ahead],
    u_dependent=[aside, yaw, fold],
    kd_eqs=[
        x.diff(t) - (ahead * sm.cos(heading) - aside * sm.sin(heading)),
        y.diff(t) - (ahead * sm.sin(heading) + aside * sm.cos(heading)),
        heading.diff(t) - yaw,
        hitch.diff(t) - fold,
    ],
    velocity_constraints=[
        aside,
        front.vel(ground).dot(wheel.y),
        axle.vel(ground).dot(trailer.y),
    ],
    bodies=[vehicle, load],
    forcelist=[(rear, drive * car.x), (axle, -c * axle.vel(ground))],
)
masses = {m1: 1400.0, m2: 600.0, i1: 2100.0, i2: 900.0}
system = System(
    kane,
    constants={b: BASE, d: TONGUE, delta: STEER, c: DRAG, **masses},
    ode_solver="dop853",
)

# %%
# Trim
# ----
# The unknowns are the hitch angle, the rate of turn and the force of the motor.  The speed is
# given, and position and heading keep changing.  No axle slips, so all of them turn about one
# point, and the motor's power equals the power of the drag at the trailer's axle.

radius = BASE / np.tan(STEER)
angle = -np.arcsin(TONGUE / radius)
trims = {}
for speed in (3.0, -3.0):
    trim = system.find_equilibrium(
        [hitch, yaw, drive],
        given={ahead: speed, hitch: -0.5, yaw: speed / radius},
        moving=[x, y, heading],
    )
    push = trim.values[drive]
    print(f"at {speed:g} m/s: hitch at {np.degrees(trim.values[hitch]):.4f}°, {push:.3f} N")
    assert np.isclose(trim.values[hitch], angle)
    assert np.isclose(trim.values[yaw], speed / radius)
    assert np.isclose(push * speed, DRAG * (speed * np.cos(angle)) ** 2)
    trims[speed] = trim

# %%
# Stability
# ---------
# Without slip the hitch obeys β' = −(v/d) sin β − r.  Its eigenvalue −(v/d) cos β is stable
# forwards and unstable backwards.  Three eigenvalues are zero, those of position and heading.

for speed, trim in trims.items():
    system.specifieds = trim.specifieds
    poles = system.linearize(trim.initial_conditions).eigenvalues
    print(f"eigenvalues at {speed:g} m/s:", poles.real.round(6))
    assert np.isclose(poles, -speed / TONGUE * np.cos(angle)).any()
    assert (poles.real < 1e-6).all() == (speed > 0.0)

# %%
# After a nudge
# -------------
# The hitch starts 0.05 rad away from its trim; the dependent speeds follow.

rides = {}
for speed, trim in trims.items():
    system.specifieds = trim.specifieds
    system.initial_conditions = {**trim.initial_conditions, hitch: angle + 0.05}
    system.set_dependent_initial_conditions([aside, yaw, fold])
    system.times = np.linspace(0.0, 6.0, num=301)
    rides[speed] = system.simulate(rtol=1e-9, atol=1e-9)
    gone = abs(rides[speed][hitch][-1] - angle)
    print(f"at {speed:g} m/s the hitch is {gone:.4f} rad away after 6 s")
    assert (gone < 0.005) == (speed > 0.0)

visuals = [
    Visual(Box(4.2, 1.7, 0.8, color="steelblue"), vehicle, name="car"),
    Visual(Box(3.0, 1.8, 0.8, color="orange"), load, name="trailer"),
    Visual(Line([rear, axle], radius=0.06, color="grey"), name="tongue"),
]
scene = system.scene(*visuals, origin=origin, up="z", view=(0.2, -0.6, 1))
scene.animate(rides[-3.0])

# %%

figure, panes = plt.subplots(1, 2, layout="constrained")
for ax, (speed, ride) in zip(panes, rides.items(), strict=True):
    turned = ride[heading] + ride[hitch]
    behind = (ride[x] - TONGUE * np.cos(turned), ride[y] - TONGUE * np.sin(turned))
    ax.plot(ride[x], ride[y], label="car's rear axle")
    ax.plot(*behind, label="trailer's axle")
    ax.set(title="forwards" if speed > 0.0 else "backwards", xlabel="x [m]", aspect="equal")
panes[0].set_ylabel("y [m]")
panes[0].legend()

plt.show()
