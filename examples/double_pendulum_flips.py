"""
Forty thousand double pendulums
===============================

A double pendulum is let go at rest from every pair of angles.  How often has its lower link gone
over the top in the end?  Side by side lie starts that end alike, and starts that share nothing.

Where 2 cos θ₁ + cos θ₂ > 1 there is not enough energy to bring either link upright: none of those
may ever flip.  And a mirror image must move like a mirror image.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.system import System


def derive():
    """Return the System of two equal masses on two massless links of equal length."""
    m, l, g = sm.symbols("m l g")
    q, u = me.dynamicsymbols("q1:3"), me.dynamicsymbols("u1:3")
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
    rates = [a.diff(me.dynamicsymbols._t) - b for a, b in zip(q, u, strict=True)]
    kane = me.KanesMethod(N, q, u, rates)
    kane.kanes_equations(particles, loads)
    return System(kane, constants={m: 1.0, l: 1.0, g: 1.0}, times=np.linspace(0.0, 20.0, num=41))


# %%
# The samples are a grid: with ``product=True`` each angle has a dimension of its own.  Only the
# ends and the extremes of the angles are kept.


def main(small=False):
    """Integrate a grid of starts, check, draw."""
    n = 21 if small else 200
    system = derive()
    q1, q2 = system.coordinates
    angles = np.linspace(-np.pi, np.pi, num=n + 1)[:-1] + np.pi / n  # symmetric, none upright
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

    farthest = np.maximum.reduce(
        [abs(results[k]) for k in ("q1_max", "q1_min", "q2_max", "q2_min")]
    )
    forbidden = 2.0 * np.cos(results.initial_q1) + np.cos(results.initial_q2) > 1.0
    flipped = farthest > np.pi
    wrong = int((flipped & forbidden).sum())
    print(f"{int(forbidden.sum())} have not enough energy; of these {wrong} flip")
    assert wrong == 0

    # Their mirror images are integrated too, bit by bit the same until chaos makes rounding large.
    turns = np.round(results.q2 / (2.0 * np.pi)).values
    calm = forbidden.values
    mirrored = -results.q2.values[::-1, ::-1]
    error = np.abs(results.q2.values - mirrored)[calm].max()
    print(f"mirror images without enough energy differ by {error:.0e} rad at most")
    assert error < 1e-3
    draw(angles, turns, calm)


def draw(angles, turns, calm):
    """The turns of the lower link over both angles, and the shore of energy."""
    figure, axes = plt.subplots(figsize=(6.4, 5.4), layout="constrained")
    image = axes.pcolormesh(angles, angles, turns.T, cmap="RdBu", vmin=-4, vmax=4)
    axes.contour(angles, angles, calm.T, levels=[0.5], colors="k", linewidths=0.8)
    figure.colorbar(image, ax=axes, label="turns of the lower link after 20 √(l/g)")
    ticks = [-3.0, 0.0, 3.0]
    axes.set(xlabel="θ₁ at the start", ylabel="θ₂ at the start", xticks=ticks, yticks=ticks)


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
