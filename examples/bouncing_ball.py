"""
Bouncing ball
=============

A ball is thrown and bounces.  Each bounce reverses its vertical velocity and keeps a fraction e of
it, so that bounces follow each other faster and faster and accumulate at a finite time: Zeno
behaviour.

A bounce is an event.  The solver finds the time at which the height crosses zero, resets the
velocity, and continues from there.  Between bounces the ball flies a parabola, so the times of all
bounces are known: t₁ (1 + 2 e + 2 e² + …) with the time t₁ of the first one.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.solvers import Event
from pydy.viz import Sphere, Visual

HEIGHT, FORWARD, GRAVITY, RESTITUTION = 1.0, 0.5, 9.81, 0.8  # m, m/s, m/s²

# %%
# Equations
# ---------
# A particle in a plane, with gravity as its only load.

m, g = sm.symbols("m g")
x, y, v_x, v_y = me.dynamicsymbols("x y v_x v_y")
t = me.dynamicsymbols._t
N, origin = me.ReferenceFrame("N"), me.Point("O")
origin.set_vel(N, 0)
place = origin.locatenew("B", x * N.x + y * N.y)
place.set_vel(N, v_x * N.x + v_y * N.y)
ball = me.Particle("ball", place, m)
kane = me.KanesMethod(N, [x, y], [v_x, v_y], [x.diff(t) - v_x, y.diff(t) - v_y])
kane.kanes_equations([ball], [(place, -m * g * N.y)])

# %%
# The event
# ---------
# It occurs when y crosses zero on the way down.  Its reset is an expression of the states before
# the bounce.

bounce = Event(y, direction=-1, reset={v_y: -RESTITUTION * v_y}, name="bounce")

# %%
# Simulation
# ----------
# The run ends a little before the bounces accumulate.

first = np.sqrt(2 * HEIGHT / GRAVITY)
end = first * (1 + RESTITUTION) / (1 - RESTITUTION)
system = System(
    kane,
    constants={m: 0.05, g: GRAVITY},
    ode_solver="dop853",
    initial_conditions={y: HEIGHT, v_x: FORWARD},
    times=np.linspace(0.0, 0.97 * end, num=1001),
)
motion = system.simulate(rtol=1e-10, atol=1e-10, events=[bounce])
print(motion.events[0])
print(f"{len(motion.events)} bounces in {motion.times[-1]:.2f} s")

# %%
# Bounces are marked on the time axis of the animation; click a mark to go there.

scene = system.scene(
    Visual(Sphere(0.05, color="orangered"), ball, name="ball", trail=True), up="y", series=[y, v_y]
)
scene.animate(motion)

# %%

figure, axes = plt.subplots(figsize=(9, 3), layout="constrained")
axes.plot(motion[x], motion[y], color="tab:orange")
places = [event.before[0] for event in motion.events]
axes.plot(places, np.zeros(len(places)), "k.", markersize=4, label="bounce")
axes.set(xlabel="x [m]", ylabel="y [m]", aspect="equal", ylim=(-0.05, 1.05 * HEIGHT))
axes.grid(alpha=0.3)
axes.legend()

# %%
# Checks
# ------
# Every bounce occurs when the closed form says, and none is missing.

found = np.array([event.time for event in motion.events])
exact = first * (1 + 2 * np.cumsum(RESTITUTION ** np.arange(len(found))) - 2)
error = np.abs(found - exact).max()
print(f"times of the bounces against the closed form: {error:.0e} s")
assert len(found) == np.sum(exact < motion.times[-1])
assert error < 1e-9

speeds = np.array([[event.before[3], event.after[3]] for event in motion.events])
error = np.abs(speeds[:, 1] + RESTITUTION * speeds[:, 0]).max()
print(f"speeds after the bounces: {error:.0e} m/s off")
assert error < 1e-12

plt.show()
