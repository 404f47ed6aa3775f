"""
The brachistochrone
===================

A bead slides without friction along a wire from one point to another that is lower, but not below.
Which shape of the wire brings it there in the least time?  Johann Bernoulli asked this in 1696.
The answer is a cycloid, the path of a point on a rolling wheel.  Here it is found as an optimal
control problem: the slope of the wire is the control, and the duration is what is minimised.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from scipy.optimize import brentq

from pydy import System
from pydy.control import OptimalControl
from pydy.mechanics import Definition
from pydy.viz import Line, Sphere, Visual

G = 9.81

# %%
# A bead on a wire of free slope
# ------------------------------
# The wire's angle is measured from the vertical.  The speed of the model is that of the bead along
# the wire; x and the depth follow from it.

x, depth, speed, slope = me.dynamicsymbols("x depth speed slope")
t = me.dynamicsymbols._t
ground, origin, bead = me.ReferenceFrame("N"), me.Point("O"), me.Point("bead")
origin.set_vel(ground, 0)
wire = ground.orientnew("W", "Axis", (slope, ground.z))  # its −y axis is along the wire
bead.set_vel(ground, -speed * wire.y)
model = Definition(
    ground,
    [x, depth],
    [speed],
    bodies=[me.Particle("bead", bead, 1)],
    loads=[(bead, -G * ground.y)],
    kinematic_equations=[x.diff(t) - speed * sm.sin(slope), depth.diff(t) - speed * sm.cos(slope)],
)
system = System(model)
print(system)

# %%
# The search
# ----------
# The bead starts at rest at the origin.  It is to be 10 m aside and 6 m lower as soon as possible.

duration = sm.Symbol("duration")
problem = OptimalControl(
    system,
    duration,
    duration,
    end={x: 10.0, depth: 6.0},
    bounds={duration: (0.1, 5.0)},
    order=4,
)
found = problem.solve({speed: [0.0, 10.0], slope: [0.0, 1.5]})
print(f"{found.duration:.9f} s in {len(found.history)} iterations")

# %%
# The cycloid
# -----------
# It is r (a − sin a), r (1 − cos a); the time to the angle a is a √(r/g).


def cycloid(aside, below):
    """Return the radius of the wheel, and by which angle it turns."""
    ratio = aside / below
    turn = brentq(lambda a: (a - np.sin(a)) - ratio * (1 - np.cos(a)), 0.1, 6.2)
    return below / (1 - np.cos(turn)), turn


radius, turn = cycloid(10.0, 6.0)
exact = turn * np.sqrt(radius / G)
print(f"{exact:.9f} s by the cycloid")
assert abs(found.duration / exact - 1.0) < 1e-7

a = np.linspace(0.0, turn, num=200)
figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
axes.plot(radius * (a - np.sin(a)), -radius * (1 - np.cos(a)), color="0.7", linewidth=5)
axes.plot(found[x], -found[depth], label="found")
axes.plot([0.0, 10.0], [0.0, -6.0], "--", label="straight line")
axes.set(aspect="equal", xlabel="x [m]", ylabel="height [m]")
axes.legend()

# %%
# How much faster than straight down the slope?
# ---------------------------------------------
# On a straight wire of length s the time is √(2 s² / (g · depth)).  For a set of ends we solve
# again; each search begins at the motion before.

below = np.linspace(6.0, 1.0, num=11)
gains, last = [], found
for lower in below:
    last = system.optimize_trajectory(
        duration,
        duration,
        end={x: 10.0, depth: lower},
        bounds={duration: (0.1, 10.0)},
        order=4,
        guess=last,
    )
    straight = np.sqrt(2 * (10.0**2 + lower**2) / (G * lower))
    radius, turn = cycloid(10.0, lower)
    assert abs(last.duration / (turn * np.sqrt(radius / G)) - 1.0) < 1e-6
    gains.append(straight / last.duration)
figure, axes = plt.subplots(figsize=(6, 3.5), layout="constrained")
axes.plot(below, gains, "o-")
axes.set(xlabel="depth of the end [m]", ylabel="time on a straight wire / least time")

# %%
# The bead on its way to 10 m aside and 6 m below:

seen = origin.locatenew("seen", x * ground.x - depth * ground.y)
ball = Visual(Sphere(0.3, color="orangered"), seen, name="bead")
bends = [
    origin.locatenew(f"W{k}", float(aside) * ground.x - float(down) * ground.y)
    for k, (aside, down) in enumerate(zip(found[x][::5], found[depth][::5], strict=True))
]
best = Visual(Line(bends, 0.05, color="steelblue"), name="wire")
system.scene(ball, best, origin=origin, up="y").animate(found)

# %%
# Energy
# ------
# Without friction the speed is √(2 g · depth), whatever the wire is like.

assert np.allclose(found[speed], np.sqrt(2 * G * np.abs(found[depth])), atol=1e-4)

plt.show()
