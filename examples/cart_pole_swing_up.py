"""
Cart and pole: the cheapest and the fastest swing-up
====================================================

A pendulum hangs from a cart that a force of at most 20 N pushes along a rail.  Within two seconds
the cart has to be a metre farther, at rest, with the pendulum upright.  Which force does that with
the least effort?  And how fast can it be done at all?

The first question is that of M. Kelly, An introduction to trajectory optimization, SIAM Review 59
(2017), whose answer is known to ten digits.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.control import OptimalControl
from pydy.mechanics import Definition
from pydy.solvers import dop853

# %%
# Cart and pendulum
# -----------------
# The pendulum's angle is zero where it hangs.  The force has no value: it is the control.

place, angle, speed, rate, force = me.dynamicsymbols("place angle speed rate force")
t = me.dynamicsymbols._t
m1, m2, l, g = sm.symbols("m1 m2 l g")
ground, rod, origin = me.ReferenceFrame("N"), me.ReferenceFrame("A"), me.Point("O")
origin.set_vel(ground, 0)
rod.orient_axis(ground, angle, ground.z)
cart = origin.locatenew("C", place * ground.x)
bob = cart.locatenew("B", -l * rod.y)
bodies = [me.Particle("cart", cart, m1), me.Particle("bob", bob, m2)]
loads = [(cart, force * ground.x), (bob, -m2 * g * ground.y)]
model = Definition(ground, [place, angle], [speed, rate], bodies=bodies, loads=loads)
system = System(model, constants={m1: 1.0, m2: 0.3, l: 0.5, g: 9.81})

# %%
# The least effort
# ----------------
# The search starts from a straight line between start and end, and from no force.

upright = {place: 1.0, angle: np.pi, speed: 0.0, rate: 0.0}
limits = {force: (-20.0, 20.0), place: (-2.0, 2.0)}
effort = sm.Integral(force**2, t)
cheap = system.optimize_trajectory(effort, 2.0, end=upright, bounds=limits, mesh_tol=1e-7)
print(f"least effort in 2 s: {cheap.objective:.6f} N² s on {len(cheap.mesh) - 1} intervals")
assert abs(cheap.objective / 58.80766746 - 1.0) < 1e-5

# %%
# The least time
# --------------
# The duration is a symbol now.  The cheap motion is a good place to begin; the force jumps between
# its limits.  Where the time hardly depends on the force, a trace of effort decides, or the force
# would go back and forth from point to point, with a warning.

duration = sm.Symbol("duration")
fast = system.optimize_trajectory(
    duration + 1e-5 * effort,
    duration,
    end=upright,
    bounds={**limits, duration: (0.5, 4.0)},
    guess=cheap,
    mesh=60,
)
print(f"least time: {fast.duration:.4f} s")
assert fast.duration < 2.0
assert np.abs(fast[force]).max() <= 20.0

figure, axes = plt.subplots(2, 1, sharex=True, figsize=(7, 5), layout="constrained")
for motion, label in ((cheap, "least effort"), (fast, "least time")):
    axes[0].plot(motion.times, np.degrees(motion[angle]), label=label)
    axes[1].plot(motion.times, motion[force])
axes[0].set_ylabel("angle [°]")
axes[1].set(xlabel="t [s]", ylabel="force [N]")
axes[0].legend()

# %%
# Where effort pays
# -----------------
# The costates say how much dearer a motion is that starts elsewhere: the first entry is the
# derivative of the effort by the start.  A start that is a little farther along the rail checks it.

farther = 1e-3
moved = system.optimize_trajectory(
    effort, 2.0, start={place: farther}, end=upright, bounds=limits, guess=cheap, mesh=cheap.mesh
)
slope = (moved.objective - cheap.objective) / farther
print(f"a metre farther: {cheap.costates[place][0]:.2f} N² s, by difference {slope:.2f}")
assert abs(cheap.costates[place][0] / slope - 1.0) < 0.01

# %%
# A heavier bob
# -------------
# `sweep` goes through values of constants; each search begins at the motion before.

problem = OptimalControl(system, effort, 2.0, end=upright, bounds=limits, mesh=40)
masses = np.linspace(0.3, 0.4, num=11)
costs = [motion.objective for motion in problem.sweep({m2: masses}, cheap)]
assert (np.diff(costs) > 0.0).all()
figure, axes = plt.subplots(figsize=(6, 3.5), layout="constrained")
axes.plot(masses, costs, "o-")
axes.set(xlabel="mass of the bob [kg]", ylabel="effort [N² s]")

# %%
# The motions, the cheap one and, faint, the fast one:

system.scene(up="y").animate(cheap, compare={"least time": fast})

# %%
# Is it true?
# -----------
# A simulation with the force that was found must end upright, without any control of what it
# does on the way.

system.specifieds, system.times, system.ode_solver = cheap.inputs(), cheap.mesh, dop853
checked = system.simulate(rtol=1e-10, atol=1e-10)
miss = np.abs(checked.states[-1] - cheap.states[-1]).max()
print(f"the simulation misses the end by {miss:.1e}")
assert miss < 1e-3

plt.show()
