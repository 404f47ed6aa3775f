"""
An arm with weak motors: the fastest way up
===========================================

Two links hang from a shoulder.  The motors are too weak to hold it stretched out to the side,
yet it is to swing up and stand still, as soon as possible.  The torques that do so jump between
their limits.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.control import OptimalControl
from pydy.mechanics import Definition
from pydy.solvers import dop853

G, LENGTH, MASS = 9.81, 0.5, 2.0  # m/s², m, kg, of each link

# %%
# The arm
# -------
# Both angles are zero where the arm hangs.  The torques have no values: they are the controls.

shoulder, elbow, shoulder_rate, elbow_rate = me.dynamicsymbols("shoulder elbow w1 w2")
T1, T2 = torques = me.dynamicsymbols("T1 T2")
t = me.dynamicsymbols._t
ground, upper, lower = (me.ReferenceFrame(name) for name in ("N", "upper", "lower"))
upper.orient_axis(ground, shoulder, ground.z)
lower.orient_axis(upper, elbow, ground.z)
start = me.Point("shoulder")
start.set_vel(ground, 0)
bodies, loads = [], [(upper, (T1 - T2) * ground.z), (lower, T2 * ground.z)]
for frame in (upper, lower):
    centre = start.locatenew(f"centre of {frame.name}", -LENGTH / 2 * frame.y)
    spin = me.inertia(frame, 0, 0, MASS * LENGTH**2 / 12)
    bodies.append(me.RigidBody(f"{frame.name} link", centre, frame, MASS, (spin, centre)))
    loads.append((centre, -MASS * G * ground.y))
    start = start.locatenew(f"end of {frame.name}", -LENGTH * frame.y)
model = Definition(
    ground, [shoulder, elbow], [shoulder_rate, elbow_rate], bodies=bodies, loads=loads
)
system = System(model)

# %%
# Held out to the side the arm needs more at the shoulder than the motor has:

needed = 2 * MASS * G * LENGTH
limits = {T1: (-12.0, 12.0), T2: (-6.0, 6.0)}
print(f"{needed:.1f} N m to hold it, {limits[T1][1]} N m to be had")
assert needed > limits[T1][1]

# %%
# Little effort first
# -------------------
# A search for the least time begins best at a motion that is possible.  The least integral of the
# torques squared, in two seconds, gives one.  The elbow bends to both sides, but not through.

up = {shoulder: np.pi, elbow: 0.0, shoulder_rate: 0.0, elbow_rate: 0.0}
limits[elbow] = (-2.6, 2.6)
effort = sm.Integral(T1**2 + T2**2, t)
cheap = system.optimize_trajectory(effort, 2.0, end=up, bounds=limits, mesh_tol=1e-8)
print(f"effort {cheap.objective:.1f} N² m² s: {cheap.message}")

# %%
# The least time
# --------------

duration = sm.Symbol("duration")
fastest = {**limits, duration: (0.3, 4.0)}
problem = OptimalControl(system, duration, duration, end=up, bounds=fastest, mesh=60)
fast = problem.solve(cheap)
print(f"least time {fast.duration:.4f} s, for 2 s: {fast.message}")
assert fast.duration < 2.0
for torque in torques:
    assert np.abs(fast[torque]).max() <= limits[torque][1] + 1e-6
axes = fast.plot_controls()

# %%
# Stronger motors
# ---------------
# Each search begins at the motion before.

strengths = np.linspace(1.0, 2.0, num=6)
times, last = [], fast
for strength in strengths:
    stronger = {
        **fastest,
        T1: (-12.0 * strength, 12.0 * strength),
        T2: (-6.0 * strength, 6.0 * strength),
    }
    last = system.optimize_trajectory(
        duration, duration, end=up, bounds=stronger, guess=last, mesh=60
    )
    times.append(last.duration)
assert (np.diff(times) < 0.0).all()
figure, axes = plt.subplots(figsize=(6, 3.5), layout="constrained")
axes.plot(strengths, times, "o-")
axes.set(xlabel="strength of the motors", ylabel="least time [s]")

# %%
# The fast motion, and faint the cheap one:

system.scene(up="y").animate(fast, compare={"least effort": cheap})

# %%
# Is it true?
# -----------
# Simulated with the torques that were found, without any control, the arm must arrive.

system.specifieds, system.times, system.ode_solver = cheap.inputs(), cheap.mesh, dop853
checked = system.simulate(rtol=1e-10, atol=1e-10)
miss = np.abs(checked.states[-1] - cheap.states[-1]).max()
print(f"the simulation misses the end by {miss:.1e}")
assert miss < 0.05

plt.show()
