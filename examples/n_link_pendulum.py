"""
Pendulum of many links
======================

Ten equal point masses on ten massless links hang in a row from the ceiling; we let go of the whole
row held out level, as straight as a rod.  What follows looks like chaos, and is; but the energy
stays what it was.

Small motions are not chaotic at all.  Their frequencies follow from the zeros z of the Laguerre
polynomial of degree n, ω² = z g/l, a closed form to compare the exact linear model with.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from numpy.polynomial.laguerre import lagroots

from pydy.system import System

# %%
# Equations
# ---------
# Every angle is measured from the vertical, so that each mass moves relative to the one above it
# with the speed l u, across its own link.


def derive(n):
    """Return the KanesMethod of n links, its constants' values and the energy."""
    m, l, g = sm.symbols("m l g")
    q = me.dynamicsymbols(f"q1:{n + 1}")
    u = me.dynamicsymbols(f"u1:{n + 1}")
    t = me.dynamicsymbols._t

    N = me.ReferenceFrame("N")
    pivot = me.Point("P0")
    pivot.set_vel(N, 0)
    particles, loads, height = [], [], 0
    for k in range(n):
        link = N.orientnew(f"L{k + 1}", "Axis", (q[k], N.z))
        link.set_ang_vel(N, u[k] * N.z)
        end = pivot.locatenew(f"P{k + 1}", -l * link.y)
        end.v2pt_theory(pivot, N, link)
        particles.append(me.Particle(f"mass{k + 1}", end, m))
        loads.append((end, -m * g * N.y))
        height = height + (n - k) * (1 - sm.cos(q[k]))
        pivot = end

    kane = me.KanesMethod(
        N,
        q,
        u,
        [a.diff(t) - b for a, b in zip(q, u, strict=True)],
        bodies=particles,
        forcelist=loads,
    )
    energy = me.kinetic_energy(N, *particles) + m * g * l * height
    return kane, {m: 0.1, l: 0.1, g: 9.81}, energy


# %%
# Simulation
# ----------


def main(small=False):
    """Check the frequencies, drop the pendulum, check the energy, draw."""
    n = 3 if small else 10
    kane, constants, energy = derive(n)
    system = System(
        kane,
        constants=constants,
        times=np.linspace(0.0, 0.5 if small else 5.0, num=61 if small else 1001),
        outputs={sm.Symbol("energy"): energy},
    )

    # At rest, hanging: all initial conditions are zero by default.
    eigenvalues = np.linalg.eigvals(system.evaluate_jacobian())
    frequencies = np.sort(eigenvalues.imag[eigenvalues.imag > 0])
    closed_form = np.sqrt(lagroots([0] * n + [1]) * 9.81 / 0.1)
    error = np.abs(frequencies / closed_form - 1).max()
    print(f"{n} frequencies from Laguerre's polynomial, relative error: {error:.0e}")
    assert error < 1e-10

    system.initial_conditions = dict.fromkeys(kane.q, np.pi / 2)
    x = system.integrate(rtol=1e-11, atol=1e-11, mxstep=5000)
    e = system.evaluate_outputs(x=x)[:, 0]
    drift = np.abs(e - e[0]).max() / e[0]
    print(f"energy: {e[0]:.3f} J, relative change: {drift:.0e}")
    assert drift < 1e-7
    draw(system.times, x[:, :n])


def draw(times, q):
    """The links at 18 instants of the fall, and the path of the end."""
    length = 0.1
    zeros = np.zeros((len(q), 1))
    px = np.hstack([zeros, np.cumsum(length * np.sin(q), axis=1)])
    py = np.hstack([zeros, np.cumsum(-length * np.cos(q), axis=1)])

    _, (left, right) = plt.subplots(1, 2, figsize=(9, 4.6), layout="constrained")
    shown = np.searchsorted(times, np.linspace(0.0, min(0.5, times[-1]), num=18))
    colours = plt.get_cmap("viridis")(np.linspace(0.0, 0.95, num=len(shown)))
    for k, colour in zip(shown, colours, strict=True):
        left.plot(px[k], py[k], "o-", color=colour, linewidth=1, markersize=2.5)
    left.set(title=f"the first {times[shown[-1]]:.1f} s", aspect="equal", xlabel="x [m]")
    left.set_ylabel("y [m]")

    reach = length * q.shape[1]
    right.plot(px[:, -1], py[:, -1], color="tab:blue", linewidth=0.8)
    right.plot(0, 0, "^", color="black")
    right.set(title=f"the end over {times[-1]:.1f} s", aspect="equal", xlabel="x [m]")
    right.set(xlim=(-1.1 * reach, 1.1 * reach), ylim=(-1.1 * reach, 1.1 * reach))
    for axes in (left, right):
        axes.locator_params(nbins=5)
        axes.grid(alpha=0.3)


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
