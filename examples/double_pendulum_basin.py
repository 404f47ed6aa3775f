"""
Which double pendulums flip?
============================

A double pendulum is released at rest from every pair of angles.  How long does it take until one of
its links goes over the top?  The result is a picture with smooth borders and chaos behind them.

One border is known exactly.  Where 2 cos θ₁ + cos θ₂ > 1 the energy is too small to bring either
link upright, so none of these can flip.  And the picture must be symmetric, because the model is.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System

small = "--small" in sys.argv  # fewer pendulums, for the tests
n = 11 if small else 61

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
    kane, constants={m: 1.0, l: 1.0, g: 1.0}, times=np.linspace(0.0, 50.0, num=501)
)  # the unit of time is √(l/g)

# %%
# One pendulum
# ------------
# Two releases that differ by a hundredth of a radian: the semi-transparent one soon diverges.


def release(q1, q2):
    """Simulate from rest at two angles."""
    system.initial_conditions = dict(zip(q, (q1, q2), strict=True))
    return system.simulate(rtol=1e-7, atol=1e-7, mxstep=5000)


scene = system.scene(up="y", series=q)
scene.animate(release(2.0, 2.5), compare={"0.01 rad beside": release(2.01, 2.5)})

# %%
# All of them
# -----------
# A pendulum that has not flipped by the end counts as never.  Half of the angles are enough: the
# other half is the mirror image.


def first_flip(q1, q2):
    """Return the time at which a link first passes the top."""
    motion = release(q1, q2)
    over = (np.abs(motion[list(q)]) > np.pi + 1e-3).any(axis=1)
    return motion.times[over.argmax()] if over.any() else np.inf


angles = np.linspace(-np.pi, np.pi, num=n)
half = [[first_flip(q1, q2) for q2 in angles] for q1 in angles[: n // 2 + 1]]
flips = np.array(half + [row[::-1] for row in half[-2::-1]])

# %%
# Grey: no flip.  Blue line: the border of energy.

figure, axes = plt.subplots(figsize=(6.4, 5.4), layout="constrained")
shown = np.ma.masked_invalid(np.log10(flips, where=flips > 0, out=np.zeros_like(flips)))
cmap = plt.get_cmap("magma_r").with_extremes(bad="0.93")
edge = angles[-1] + (angles[1] - angles[0]) / 2
image = axes.imshow(
    shown.T, origin="lower", extent=(-edge, edge, -edge, edge), cmap=cmap, vmin=0, vmax=1.7
)
fine = np.linspace(-np.pi, np.pi, num=201)
energy = 2 * np.cos(fine)[None, :] + np.cos(fine)[:, None]
axes.contour(fine, fine, energy, levels=[1.0], colors="tab:blue")
bar = figure.colorbar(image, ax=axes, label=r"first flip [$\sqrt{l/g}$]")
bar.set_ticks(np.log10([1, 2, 5, 10, 20, 50]), labels=["1", "2", "5", "10", "20", "50"])
ticks = [-np.pi, 0, np.pi]
axes.set_xticks(ticks, labels=["−π", "0", "π"])
axes.set_yticks(ticks, labels=["−π", "0", "π"])
axes.set(xlabel="θ₁ at the start", ylabel="θ₂ at the start")

# %%
# Checks
# ------
# No pendulum inside the border flips.  The middle row, q1 = 0, is its own mirror image, though
# every pendulum of it was simulated; only where chaos amplifies the last bit may the two halves
# differ.

c1, c2 = np.meshgrid(np.cos(angles), np.cos(angles), indexing="ij")
forbidden = 2 * c1 + c2 > 1
early = np.isfinite(flips[forbidden]).sum()
print(f"{forbidden.sum()} of {n * n} have too little energy; of these {early} flip")
assert early == 0
print(f"of the others {np.isfinite(flips[~forbidden]).mean():.0%} flip within 50 √(l/g)")

middle = flips[n // 2]
symmetric = np.isclose(middle, middle[::-1], atol=0.2) | (middle == middle[::-1])
print(f"q1 = 0: {symmetric.sum()} of {n} flip when their mirror images do")
assert symmetric.mean() > 0.9

plt.show()
