"""
Double pendulum from a video
============================

A double pendulum is released three times.  A camera records where its two bobs are, to a few
millimetres, at 50 frames a second.  From these records we estimate the lengths of the rods, the
ratio of the masses, and the angles at each release.  The truth is known here and must lie within
the confidence intervals.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.analysis import Trial

TRUTH = {"l1": 0.31, "l2": 0.24, "m2": 0.35}
RELEASES = ((1.1, 0.4), (-0.8, 0.9), (0.3, 1.4))  # rad from hanging down
NOISE = 0.003  # m, standard deviation

# %%
# Equations
# ---------
# Both angles are measured from the vertical.

a, b, u, v = me.dynamicsymbols("a b u v")
l1, l2, m1, m2, g = sm.symbols("l1 l2 m1 m2 g")
t = me.dynamicsymbols._t
ground, pivot = me.ReferenceFrame("N"), me.Point("O")
upper, lower = (ground.orientnew(name, "Axis", (q, ground.z)) for name, q in (("A", a), ("B", b)))
upper.set_ang_vel(ground, u * ground.z)
lower.set_ang_vel(ground, v * ground.z)
pivot.set_vel(ground, 0)
first = pivot.locatenew("P", -l1 * upper.y)
second = first.locatenew("Q", -l2 * lower.y)
first.v2pt_theory(pivot, ground, upper)
second.v2pt_theory(first, ground, lower)
bobs = [me.Particle("first", first, m1), me.Particle("second", second, m2)]
loads = [(bob.point, -bob.mass * g * ground.y) for bob in bobs]
kane = me.KanesMethod(
    ground, [a, b], [u, v], [a.diff(t) - u, b.diff(t) - v], bodies=bobs, forcelist=loads
)

# %%
# What the camera sees
# --------------------
# The coordinates of the bobs are expressions of the angles and of the unknown lengths.

seen = [p.pos_from(pivot).dot(axis) for p in (first, second) for axis in (ground.x, ground.y)]
for expression in seen:
    print(expression)

# %%
# The records are made here: simulate, evaluate the four coordinates, add noise.  In each record a
# hand hides the second bob for a moment; missing samples are NaN.

times = np.linspace(0.0, 2.0, num=101)
truth = {m1: 0.5, g: 9.81, **{sm.Symbol(name): value for name, value in TRUTH.items()}}
system = System(kane, constants=truth, times=times, ode_solver="dop853")
random = np.random.default_rng(3)
coordinates = sm.lambdify((a, b, l1, l2), seen)
trials, rides = [], []
for release in RELEASES:
    system.initial_conditions = dict(zip((a, b), release, strict=True))
    ride = system.simulate(rtol=1e-10, atol=1e-10)
    places = coordinates(ride[a], ride[b], TRUTH["l1"], TRUTH["l2"])
    recorded = [column + random.normal(0.0, NOISE, len(times)) for column in places]
    recorded[3][10:14] = np.nan
    measured = dict(zip(seen, recorded, strict=True))
    guess = {a: release[0] + 0.05, b: release[1] - 0.05}
    trials.append(Trial(times, measured, guess, unknown=[a, b], noise=NOISE))
    rides.append(ride)

figure, panels = plt.subplots(1, 3, figsize=(9, 3.2), layout="constrained", sharey=True)
for axes, trial in zip(panels, trials, strict=True):
    x1, y1, x2, y2 = (np.asarray(column) for column in trial.measured.values())
    axes.plot(x1, y1, ".", markersize=3, label="first bob")
    axes.plot(x2, y2, ".", markersize=3, label="second bob")
    axes.set(aspect="equal", xlabel="x [m]")
panels[0].set_ylabel("y [m]")
panels[0].legend(fontsize=8)

# %%
# The fit
# -------
# Motion depends on the ratio of the masses only, so one of them must be given.  The fit starts from
# parameters that are 10 % off and from angles that are 0.05 rad off.  `System.fit` uses exact
# sensitivities of the trajectories.

system.constants = {**truth, **{sm.Symbol(name): 1.1 * value for name, value in TRUTH.items()}}
system.initial_conditions = trials[0].initial_conditions
wrong = system.simulate(rtol=1e-10, atol=1e-10)
result = system.fit(list(TRUTH), trials)
for name, estimate, (low, high) in zip(
    result.names, result.estimates, result.confidence_intervals(0.997), strict=True
):
    print(f"{name:15}{estimate:9.5f}   from {low:.5f} to {high:.5f}")

# %%
# The true motion of the first release, and, faint, the one that the fit started from:

system.constants = truth
system.scene(up="y").animate(rides[0], compare={"first guess": wrong})

# %%
# Checks
# ------
# The truth lies within the intervals of 99.7 % confidence, and the estimated noise is the camera's.

expected = [*TRUTH.values(), *(angle for release in RELEASES for angle in release)]
low, high = result.confidence_intervals(0.997).T
assert ((low < expected) & (expected < high)).all()
assert 0.9 < result.noise < 1.1
print(f"correlation of l1 and l2: {result.correlation[0, 1]:.2f}")

# %%
# What remains looks like noise:

figure, panels = plt.subplots(3, sharex=True, figsize=(7, 7), layout="constrained")
result.plot_residuals(panels)
for axes in panels:
    axes.get_legend().remove()
    axes.set_ylabel("residual [m]")

plt.show()
