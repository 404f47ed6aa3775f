"""
Forty thousand double pendulums
===============================

A double pendulum is released at rest from every pair of angles.  How many turns has its lower link
made in the end, and when does one of its links first go over the top?  Smooth regions, where
neighbours end alike, border on chaotic ones, where they have nothing in common.

Where 2 cos θ₁ + cos θ₂ > 1 the energy is too small to bring either link upright: none of these can
flip.  Mirror-image initial conditions must give mirror-image motions.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.solvers import Event

n, coarse = 200, 40

# %%
# Equations
# ---------
# Two equal masses on two massless links of equal length.

m, l, g = sm.symbols("m l g")
q, u = me.dynamicsymbols("q1:3"), me.dynamicsymbols("u1:3")
t = me.dynamicsymbols._t
N, above = me.ReferenceFrame("N"), me.Point("O")
above.set_vel(N, 0)
particles, loads = [], []
for k in range(2):
    link = N.orientnew(f"L{k + 1}", "Axis", (q[k], N.z))
    link.set_ang_vel(N, u[k] * N.z)
    end = above.locatenew(f"P{k + 1}", -l * link.y)
    end.v2pt_theory(above, N, link)
    particles.append(me.Particle(f"mass{k + 1}", end, m))
    loads.append((end, -m * g * N.y))
    above = end
kane = me.KanesMethod(N, q, u, [a.diff(t) - b for a, b in zip(q, u, strict=True)])
kane.kanes_equations(particles, loads)
system = System(
    kane, constants={m: 1.0, l: 1.0, g: 1.0}, times=np.linspace(0.0, 20.0, num=601)
)  # the unit of time is √(l/g)

# %%
# A dozen of them
# ---------------
# An ensemble that keeps whole trajectories can be animated beside one of its own: the others are
# faint.  All start within a tenth of a radian of each other.

q1, q2 = system.coordinates
system.initial_conditions = {q1: 1.8, q2: 2.0}
motion = system.simulate(rtol=1e-8, atol=1e-8)
near = system.integrate_ensemble(
    initial_conditions={q2: np.linspace(1.95, 2.05, num=12)}, rtol=1e-8, atol=1e-8
)
system.scene(up="y").animate(motion, compare=near)

# %%
# All of them
# -----------
# The samples are a grid: with ``product=True`` each angle has a dimension of its own.  Of each
# trajectory only the end and the extremes of the angles are kept.

system.times = np.linspace(0.0, 20.0, num=41)


def between(n):
    """Return n angles from −π to π: symmetric, none upright."""
    return np.linspace(-np.pi, np.pi, num=n + 1)[:-1] + np.pi / n


angles = between(n)
results = system.integrate_ensemble(
    initial_conditions={q1: angles, q2: angles},
    product=True,
    reduce=["final", ("max", q1), ("min", q1), ("max", q2), ("min", q2)],
    rtol=1e-8,
    atol=1e-8,
)
assert (results.status == 0).all()
steps = int((results.steps + results.rejected).sum())
print(f"{n * n} trajectories, {steps / 1e6:.2f} million steps")

# %%
# The turns of the lower link over both initial angles.  Inside the black line the energy is too
# small for a flip.

turns = np.round(results.q2 / (2.0 * np.pi)).values


def too_little(results):
    """Return where the energy does not bring a link upright."""
    return 2.0 * np.cos(results.initial_q1) + np.cos(results.initial_q2) > 1.0


forbidden = too_little(results)
figure, axes = plt.subplots(figsize=(6.4, 5.4), layout="constrained")
image = axes.pcolormesh(angles, angles, turns.T, cmap="RdBu", vmin=-4, vmax=4)
axes.contour(angles, angles, forbidden.values.T, levels=[0.5], colors="k", linewidths=0.8)
figure.colorbar(image, ax=axes, label="turns of the lower link after 20 √(l/g)")
ticks = [-3.0, 0.0, 3.0]
axes.set(xlabel="θ₁ at the start", ylabel="θ₂ at the start", xticks=ticks, yticks=ticks)

# %%
# When they flip
# --------------
# Terminal events end a trajectory where a link passes the top.  Trajectories with events are
# integrated one by one; fewer of them, but for longer.

over = [
    Event(q + side * np.pi, terminal=True, name=f"{q} at {-side}π")
    for q in (q1, q2)
    for side in (1, -1)
]
flips = system.integrate_ensemble(
    initial_conditions={q1: between(coarse), q2: between(coarse)},
    times=[0.0, 50.0],
    product=True,
    reduce="final",
    events=over,
    rtol=1e-7,
    atol=1e-7,
)
first = flips.end_time.where(flips.end_time < 50.0)

# %%
# Grey: no flip.

figure, axes = plt.subplots(figsize=(6.4, 5.4), layout="constrained")
cmap = plt.get_cmap("magma_r").with_extremes(bad="0.93")
image = axes.pcolormesh(
    between(coarse), between(coarse), np.log10(first).T, cmap=cmap, vmin=0, vmax=np.log10(50.0)
)
axes.contour(angles, angles, forbidden.values.T, levels=[0.5], colors="tab:blue")
bar = figure.colorbar(image, ax=axes, label=r"first flip [$\sqrt{l/g}$]")
bar.set_ticks(np.log10([1, 2, 5, 10, 20, 50]), labels=["1", "2", "5", "10", "20", "50"])
axes.set(xlabel="θ₁ at the start", ylabel="θ₂ at the start", xticks=ticks, yticks=ticks)

# %%
# Checks
# ------
# No pendulum inside the line flips.  The mirror images are integrated too: without chaos they end
# as mirror images.

farthest = np.maximum.reduce([abs(results[k]) for k in ("q1_max", "q1_min", "q2_max", "q2_min")])
wrong = int(((farthest > np.pi) & forbidden).sum())
print(f"{int(forbidden.sum())} have too little energy; of these {wrong} flip")
assert wrong == 0
few = too_little(flips)
assert not first.where(few).count()
print(f"of the others {float(first.notnull().where(~few).mean()):.0%} flip within 50 √(l/g)")

calm = forbidden.values
mirrored = -results.q2.values[::-1, ::-1]
error = np.abs(results.q2.values - mirrored)[calm].max()
print(f"mirror images with too little energy differ by {error:.0e} rad at most")
assert error < 1e-3

plt.show()
