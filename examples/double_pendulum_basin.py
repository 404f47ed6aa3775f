"""
Which double pendulums flip?
============================

A double pendulum is let go at rest from every pair of angles.  How long does it take until one of
its links goes over the top?  The answer is a picture: smooth shores, and chaos behind them.

One shore is known exactly.  Where 2 cos θ₁ + cos θ₂ > 1 the pendulum has not enough energy to bring
either link upright, so none of those may ever flip; and the picture must be symmetric, because a
mirror image moves like a mirror image.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.system import System

# %%
# Equations
# ---------
# Two equal masses on two equal, massless links.


def derive():
    """Return the KanesMethod and values of its constants."""
    m, l, g = sm.symbols("m l g")
    q = me.dynamicsymbols("q1:3")
    u = me.dynamicsymbols("u1:3")
    t = me.dynamicsymbols._t
    N = me.ReferenceFrame("N")
    above = me.Point("O")
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
    return kane, {m: 1.0, l: 1.0, g: 1.0}


# %%
# Simulation
# ----------
# The unit of time is √(l/g).  Those that have not flipped by the end count as never.


def main(small=False):
    """Compute the time of the first flip for a grid of angles, check, draw."""
    n = 11 if small else 61
    kane, constants = derive()
    system = System(kane, constants=constants, times=np.linspace(0.0, 50.0, num=501))
    angles = np.linspace(-np.pi, np.pi, num=n)

    def first_flip(q1, q2):
        system.initial_conditions = dict(zip(kane.q, (q1, q2), strict=True))
        q = system.integrate(rtol=1e-7, atol=1e-7, mxstep=5000)[:, :2]
        over = (np.abs(q) > np.pi + 1e-3).any(axis=1)
        return system.times[over.argmax()] if over.any() else np.inf

    # Half of the angles are enough: the other half is the mirror image.
    half = [[first_flip(q1, q2) for q2 in angles] for q1 in angles[: n // 2 + 1]]
    flips = np.array(half + [row[::-1] for row in half[-2::-1]])

    c1, c2 = np.meshgrid(np.cos(angles), np.cos(angles), indexing="ij")
    forbidden = 2 * c1 + c2 > 1
    early = np.isfinite(flips[forbidden]).sum()
    print(f"{forbidden.sum()} of {n * n} have not enough energy; of these {early} flip")
    assert early == 0
    print(f"of the others {np.isfinite(flips[~forbidden]).mean():.0%} flip within 50 √(l/g)")

    # The middle row, q1 = 0, is its own mirror image, though every pendulum of it was simulated.
    middle = flips[n // 2]
    symmetric = np.isclose(middle, middle[::-1], atol=0.2) | (middle == middle[::-1])
    print(f"q1 = 0: {symmetric.sum()} of {n} flip when their mirror images do")
    assert symmetric.mean() > 0.9  # the last bit may decide, after chaos
    draw(angles, flips)


def draw(angles, flips):
    """The time of the first flip over both angles, and the shore of energy."""
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
    axes.set_title("grey: no flip; blue line: not enough energy inside", fontsize=10)


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
