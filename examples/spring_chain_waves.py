"""
Waves on a chain of springs
===========================

Fifty equal masses are joined by equal springs, and the first one to a wall.  A bump in the middle
is released.  It splits into two waves that run in opposite directions.  The wall reflects its wave
inverted, the free end upright, and both disperse, because on a chain short waves are slower than
long ones.

A chain of n masses with one end fixed has the modes sin((2j−1)π i/(2n+1)) with the frequencies ω =
2 √(k/m) sin((2j−1)π/(4n+2)).  Their sum is the exact motion, with which we compare.
"""

from itertools import pairwise

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.mechanics import Definition
from pydy.viz import Box, Sphere, Visual

n = 50

# %%
# Equations
# ---------
# The coordinates are the displacements from rest.  For many bodies we use
# `pydy.mechanics.Definition`: `KanesMethod` takes long to construct.

m, k = sm.symbols("m k")
x = me.dynamicsymbols(f"x1:{n + 1}")
N, origin = me.ReferenceFrame("N"), me.Point("O")
origin.set_vel(N, 0)
stretch = [x[0], *(after - before for before, after in pairwise(x)), 0]
masses, loads = [], []
for i in range(n):
    point = origin.locatenew(f"P{i + 1}", (i + 1 + x[i]) * N.x)
    masses.append(me.Particle(f"mass{i + 1}", point, m))
    loads.append((point, k * (stretch[i + 1] - stretch[i]) * N.x))
chain = Definition(N, x, me.dynamicsymbols(f"v1:{n + 1}"), bodies=masses, loads=loads)

# %%
# Simulation
# ----------
# All constants are 1 by default.

place = np.arange(1, n + 1)
bump = np.exp(-(((place - n / 2) / 3.0) ** 2))
system = System(
    chain,
    initial_conditions=dict(zip(x, bump, strict=True)),
    times=np.linspace(0.0, 2.2 * n, num=8 * n + 1),
)
motion = system.simulate(rtol=1e-10, atol=1e-10, mxstep=5000)
displacement = motion[list(x)]

# %%
# The waves are longitudinal: masses crowd where the displacement falls, and thin out where it
# rises.

scene = system.scene(
    Visual(Box(0.3, 4, 4, color="grey"), N, origin, name="wall"),
    *(Visual(Sphere(0.32, color="steelblue"), mass.point, name="masses") for mass in masses),
    origin=origin,
    up="y",
    ground=False,
    view=(0, 0.2, 1),
)
scene.animate(motion, speed=5.0)

# %%
# Displacement over mass and time:

figure, axes = plt.subplots(figsize=(6, 4.2), layout="constrained")
image = axes.imshow(
    displacement,
    aspect="auto",
    origin="lower",
    extent=(0.5, n + 0.5, 0, motion.times[-1]),
    cmap="RdBu_r",
    vmin=-1,
    vmax=1,
)
axes.set(xlabel="mass, from the wall", ylabel=r"time [$\sqrt{m/k}$]")
figure.colorbar(image, ax=axes, label="displacement")

# %%
# The sum of modes
# ----------------
# The bump is written as a sum of modes, of which each oscillates with its own frequency.

odd = 2 * np.arange(1, n + 1) - 1
modes = np.sin(np.outer(place, odd) * np.pi / (2 * n + 1))
frequencies = 2 * np.sin(odd * np.pi / (4 * n + 2))
weights = np.linalg.solve(modes, bump)
exact = (weights * np.cos(np.outer(motion.times, frequencies))) @ modes.T
error = np.abs(displacement - exact).max()
print(f"displacements against the sum of {n} modes: {error:.0e} of the bump's height")
assert error < 1e-6

# %%

figure, axes = plt.subplots(figsize=(6, 4.2), layout="constrained")
for row, share in enumerate((0.0, 0.1, 0.3, 0.6, 0.9)):
    instant = int(share * (len(motion.times) - 1))
    axes.plot(place, displacement[instant] - 1.3 * row, color="tab:blue")
    axes.plot(place, exact[instant] - 1.3 * row, ".", color="k", markersize=2)
    axes.text(n / 2, 0.35 - 1.3 * row, f"t = {motion.times[instant]:.0f}", ha="center")
axes.set(xlabel="mass, from the wall", yticks=[])
axes.set_title("simulated (lines) and exact (dots)", fontsize=10)
axes.grid(alpha=0.3)

plt.show()
