"""
Waves on a chain of springs
===========================

Fifty equal masses are joined by equal springs, and the first one to a wall; a bump is let go in the
middle.  It parts into two waves that run off both ways, come back upside down from the wall and
upright from the free end, and fray out, because short waves are slower than long ones on a chain of
grains.

A chain of n masses with one end fixed has the modes sin((2j−1)π i/(2n+1)) with the frequencies
ω = 2 √(k/m) sin((2j−1)π/(4n+2)).  Their sum is the exact motion, and what we compare with.
"""

import sys
from itertools import pairwise

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.system import System

# %%
# Equations
# ---------
# The coordinates are the displacements from rest.  `pydy.models.multi_mass_spring_damper` is the
# same chain with dampers, and with the stretches of the springs as coordinates.


def derive(n):
    """Return the KanesMethod of n masses."""
    m, k = sm.symbols("m k")
    x = me.dynamicsymbols(f"x1:{n + 1}")
    v = me.dynamicsymbols(f"v1:{n + 1}")
    t = me.dynamicsymbols._t
    N = me.ReferenceFrame("N")
    origin = me.Point("O")
    origin.set_vel(N, 0)
    stretch = [x[0], *(b - a for a, b in pairwise(x)), 0]
    masses, loads = [], []
    for i in range(n):
        point = origin.locatenew(f"P{i + 1}", (i + 1 + x[i]) * N.x)
        point.set_vel(N, v[i] * N.x)
        masses.append(me.Particle(f"mass{i + 1}", point, m))
        loads.append((point, k * (stretch[i + 1] - stretch[i]) * N.x))
    kane = me.KanesMethod(
        N, x, v, [a.diff(t) - b for a, b in zip(x, v, strict=True)], bodies=masses, forcelist=loads
    )
    return kane


# %%
# The sum of modes, and the simulation
# ------------------------------------


def modes(n):
    """Return the matrix of the modes, one a column, and their frequencies for k = m = 1."""
    odd = 2 * np.arange(1, n + 1) - 1
    shapes = np.sin(np.outer(np.arange(1, n + 1), odd) * np.pi / (2 * n + 1))
    return shapes, 2 * np.sin(odd * np.pi / (4 * n + 2))


def main(small=False):
    """Let the bump go, compare with the sum of modes, draw."""
    n = 12 if small else 50
    place = np.arange(1, n + 1)
    bump = np.exp(-(((place - n / 2) / 3.0) ** 2))
    kane = derive(n)
    system = System(  # all constants are 1 by default
        kane,
        initial_conditions=dict(zip(kane.q, bump, strict=True)),
        times=np.linspace(0.0, 2.2 * n, num=8 * n + 1),
    )
    displacement = system.integrate(rtol=1e-10, atol=1e-10, mxstep=5000)[:, :n]

    shapes, frequencies = modes(n)
    weights = np.linalg.solve(shapes, bump)
    exact = (weights * np.cos(np.outer(system.times, frequencies))) @ shapes.T
    error = np.abs(displacement - exact).max()
    print(f"displacements against the sum of {n} modes: {error:.0e} of the bump's height")
    assert error < 1e-6
    draw(system.times, displacement)


def draw(times, displacement):
    """Displacements over place and time, and at a few instants."""
    n = displacement.shape[1]
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4.2), layout="constrained")
    image = left.imshow(
        displacement,
        aspect="auto",
        origin="lower",
        extent=(0.5, n + 0.5, 0, times[-1]),
        cmap="RdBu_r",
        vmin=-1,
        vmax=1,
    )
    left.set(xlabel="mass, from the wall", ylabel=r"time [$\sqrt{m/k}$]")
    figure.colorbar(image, ax=left, label="displacement")
    for k, share in enumerate((0.0, 0.1, 0.3, 0.6, 0.9)):
        row = int(share * (len(times) - 1))
        right.plot(np.arange(1, n + 1), displacement[row] - 1.3 * k, color="tab:blue")
        right.text(n / 2, 0.35 - 1.3 * k, f"t = {times[row]:.0f}", ha="center")
    right.set(xlabel="mass, from the wall", yticks=[])
    right.grid(alpha=0.3)


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
