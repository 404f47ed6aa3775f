"""
Stick and slip
==============

A block lies on a belt and is held by a spring.  The belt carries it along until the spring is
stronger than static friction; then it slides back, until its speed is that of the belt again.  So
a violin string is bowed, and so brakes squeal.

Friction that sticks is no law of the speed: while the block sticks, friction is whatever holds it.
`Contacts` has equations of motion for each mode, and finds the times of the transitions.  The
motion is periodic from the first slip on, with a period that is known: the time in which the belt
goes from one end of the slide to the other, and that of an arc of an ellipse in the phase plane.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import Contacts, Stick
from pydy.mechanics import Definition
from pydy.viz import Cube, Line, Visual

BELT, STATIC, KINETIC, WEIGHT, STIFFNESS = 0.1, 0.6, 0.3, 9.81, 20.0  # m/s, -, -, N, N/m

# %%
# Equations
# ---------
# A particle on a line, with a spring.

m, k, belt, mu, static = sm.symbols("m k belt mu static")
x, v = me.dynamicsymbols("x v")
N, origin = me.ReferenceFrame("N"), me.Point("O")
origin.set_vel(N, 0)
place = origin.locatenew("B", x * N.x)
place.set_vel(N, v * N.x)
block = me.Particle("block", place, m)
definition = Definition(N, [x], [v], bodies=[block], loads=[(place, -k * x * N.x)])

# %%
# Friction
# --------
# What slides is the block on the belt: friction acts along the difference of their speeds.  The
# normal force is known, so that no gap is needed.

rub = Stick(v - belt, mu=mu, mu_static=static, normal=WEIGHT, name="belt")

# %%
# Simulation
# ----------
# The block starts with the belt.

system = System(
    definition,
    constants={m: 1.0, k: STIFFNESS},
    ode_solver="dop853",
    initial_conditions={v: BELT},
    times=np.linspace(0.0, 20.0, num=2001),
)
contacts = Contacts(system, [rub], {belt: BELT, mu: KINETIC, static: STATIC})
motion = contacts.simulate(rtol=1e-12, atol=1e-12)
for start, end, modes in motion.modes[:4]:
    print(f"from {start:.3f} s to {end:.3f} s it {modes['belt'].split()[0]}")

# %%
# Transitions are marked on the time axis of the animation.

wall = origin.locatenew("W", -0.6 * N.x)
ends = [origin.locatenew(f"E{k}", k * N.x - 0.06 * N.y) for k in (-0.4, 0.6)]
scene = system.scene(
    Visual(Cube(0.1, color="orangered"), block, name="block"),
    Visual(Line([wall, place], 0.01, color="dimgray"), name="spring"),
    Visual(Line(ends, 0.015, color="darkgray"), name="belt"),
    up="y", series=[x, v],
)  # fmt: skip
scene.animate(motion)

# %%
# Friction follows the spring while the block sticks.  In the phase plane, the motion is a straight
# line and an arc.

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.5), layout="constrained")
left.plot(motion.times, motion["belt_friction"], color="tab:blue")
for start, end, modes in motion.modes:
    if modes["belt"] == "sticks":
        left.axvspan(start, end, color="0.9")
left.set(xlabel="time [s]", ylabel="friction [N]", title="shaded: it sticks")
right.plot(motion[x], motion[v], color="tab:orange")
right.axhline(BELT, color="0.7", linestyle="--", label="belt")
right.set(xlabel="x [m]", ylabel="v [m/s]")
right.legend()

# %%
# Checks
# ------
# The period, and the balance of energy: the belt does work through friction.

slips = np.array([event.time for event in motion.events if event.name == "belt slips"])
rate = np.sqrt(STIFFNESS)
high, middle = STATIC * WEIGHT / STIFFNESS, KINETIC * WEIGHT / STIFFNESS
low = 2 * middle - high
angle = np.arctan2(BELT / rate, high - middle)
period = (high - low) / BELT + (np.pi + 2 * angle) / rate
error = np.abs(np.diff(slips) - period).max()
print(f"period against the closed form: {error:.0e} s")
assert error < 1e-10

sticks = motion["belt_sliding"][[modes == "sticks" for modes in (
    next(w["belt"] for s, e, w in reversed(motion.modes) if s <= t) for t in motion.times
)]]  # fmt: skip
print(f"speed on the belt while it sticks: {np.abs(sticks).max():.0e} m/s")
assert np.abs(sticks).max() < 1e-15

plt.show()
