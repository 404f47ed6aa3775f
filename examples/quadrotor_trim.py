"""
Trim and feedback of a quadrotor
================================

A quadrotor that flies straight ahead against the air leans forward.  How far, and how hard its
rotors must push, is a trim: states and inputs at which only the position changes.  The linear model
at the trim goes to python-control.  Its linear-quadratic regulator brings the vehicle back after a
gust.
"""

import control
import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.viz import Arrow, Box, Cylinder, Visual

SPEED, MASS, DRAG, ARM, GRAVITY = 8.0, 1.2, 0.25, 0.22, 9.81

# %%
# Equations
# ---------
# In the vertical plane: a body with a rotor on either side of its centre, and drag against the
# velocity, in proportion to it.

x, z, pitch, u, w, rate = me.dynamicsymbols("x z theta u w q")
front, rear = me.dynamicsymbols("T_f T_r")
m, inertia, d, g, c = sm.symbols("m I d g c")
t = me.dynamicsymbols._t
ground, origin = me.ReferenceFrame("N"), me.Point("O")
body = ground.orientnew("B", "Axis", (pitch, ground.y))
body.set_ang_vel(ground, rate * ground.y)
origin.set_vel(ground, 0)
centre = origin.locatenew("C", x * ground.x + z * ground.z)
centre.set_vel(ground, u * ground.x + w * ground.z)
vehicle = me.RigidBody("vehicle", centre, body, m, (me.inertia(body, 0, inertia, 0), centre))
loads = [
    (centre, -m * g * ground.z + (front + rear) * body.z),
    (centre, -c * (u * ground.x + w * ground.z)),
    (body, d * (rear - front) * ground.y),
]
kane = me.KanesMethod(
    ground,
    [x, z, pitch],
    [u, w, rate],
    [x.diff(t) - u, z.diff(t) - w, pitch.diff(t) - rate],
    bodies=[vehicle],
    forcelist=loads,
)
system = System(
    kane,
    constants={m: MASS, inertia: 0.03, d: ARM, g: GRAVITY, c: DRAG},
    ode_solver="dop853",
)

# %%
# Trim
# ----
# The pitch and the two thrusts are unknown, the speed is given, and the position keeps changing.
# Statics has the same answer: lean and thrust balance weight and drag.

trim = system.find_equilibrium(
    [pitch, front, rear], given={u: SPEED, front: 5.0, rear: 5.0}, moving=[x]
)
lean, push = trim.values[pitch], trim.values[front] + trim.values[rear]
print(f"at {SPEED:g} m/s it leans by {np.degrees(lean):.3f}° and pushes with {push:.4f} N")
assert np.isclose(lean, np.arctan2(DRAG * SPEED, MASS * GRAVITY))
assert np.isclose(push, np.hypot(DRAG * SPEED, MASS * GRAVITY))

# %%
# Linear model and regulator
# --------------------------
# The linear model has the thrusts as inputs.

system.initial_conditions = trim.initial_conditions
system.specifieds = trim.specifieds
model = system.linearize().to_control()
weights = np.diag([1.0, 4.0, 1.0, 1.0, 1.0, 0.1])
gain, _, poles = control.lqr(model, weights, 0.1 * np.eye(2))
print("closed loop:", np.sort_complex(poles).round(3))

# %%
# The feedback is an expression of the states and of time, so that it is compiled with the
# equations. Linearised with it, the system has exactly the poles that the regulator was designed
# for.

target = [SPEED * t, *(trim.initial_conditions[s] for s in system.states[1:])]
error = sm.Matrix([s - r for s, r in zip(system.states, target, strict=True)])
feedback = -sm.Matrix(gain) * error
system.specifieds = {T: trim.values[T] + f for T, f in zip((front, rear), feedback, strict=True)}
closed = system.linearize(trim.initial_conditions).eigenvalues
assert np.allclose(np.sort_complex(closed), np.sort_complex(poles), atol=1e-8)

# %%
# After a gust
# ------------
# The gust leaves the vehicle slow, sinking and tilted.

system.initial_conditions = {**trim.initial_conditions, u: SPEED - 2.0, w: -1.0, pitch: lean + 0.3}
system.times = np.linspace(0.0, 8.0, num=801)
flight = system.simulate(rtol=1e-9, atol=1e-9)

arms = [(front, d, "front"), (rear, -d, "rear")]
visuals = [Visual(Box(2 * ARM, 0.05, 0.03, color="grey"), vehicle, name="body")]
for thrust, arm, name in arms:
    hub = centre.locatenew(f"{name} hub", arm * body.x + 0.04 * body.z)
    visuals.append(
        Visual(Cylinder(0.01, 0.12, axis="z", color="steelblue"), body, hub, name="rotors")
    )
    visuals.append(Visual(Arrow(thrust * body.z, scale=0.06), hub, name="thrust"))
scene = system.scene(
    *visuals, origin=origin, up="z", follow=True, view=(0, -1, 0.15), series=[z, pitch]
)
scene.animate(flight)

# %%

figure, (upper, lower) = plt.subplots(2, sharex=True, layout="constrained")
upper.plot(flight.times, flight[x] - SPEED * flight.times, label="ahead")
upper.plot(flight.times, flight[z], label="up")
upper.set_ylabel("deviation [m]")
upper.legend()
lower.plot(flight.times, np.degrees(flight[pitch]))
lower.axhline(np.degrees(lean), color="0.7")
lower.set(xlabel="time [s]", ylabel="pitch [deg]")

# %%
# After eight seconds little is left of the gust.

left = flight.states[-1] - [float(sm.sympify(r).subs(t, 8.0)) for r in target]
print(f"largest deviation after 8 s: {np.abs(left).max():.1e}")
assert np.abs(left).max() < 5e-2

plt.show()
