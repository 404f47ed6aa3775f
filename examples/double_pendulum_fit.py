"""
Double pendulum from a video
============================

A double pendulum is let go three times, and a camera sees where its two bobs are, to a few
millimetres, in 50 pictures a second.  What are the lengths of its rods, the ratio of its masses,
and the angles it was let go at?  The truth is known here, and lies within the confidence intervals.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.analysis import Trial
from pydy.system import System

TRUTH = {"l1": 0.31, "l2": 0.24, "m2": 0.35}
RELEASES = ((1.1, 0.4), (-0.8, 0.9), (0.3, 1.4))  # rad from hanging down
BLUR = 0.003  # m, standard deviation

# %%
# Equations
# ---------


def derive():
    """Return the KanesMethod, values of its constants, and the coordinates of both bobs."""
    a, b, u, v = me.dynamicsymbols("a b u v")
    l1, l2, m1, m2, g = sm.symbols("l1 l2 m1 m2 g")
    t = me.dynamicsymbols._t
    ground = me.ReferenceFrame("N")
    upper, lower = (
        ground.orientnew(name, "Axis", (q, ground.z)) for name, q in (("A", a), ("B", b))
    )
    upper.set_ang_vel(ground, u * ground.z)
    lower.set_ang_vel(ground, v * ground.z)
    pivot = me.Point("O")
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
    kane.kanes_equations()
    seen = [p.pos_from(pivot).dot(axis) for p in (first, second) for axis in (ground.x, ground.y)]
    return kane, {m1: 0.5, g: 9.81, **{sm.Symbol(k): v for k, v in TRUTH.items()}}, seen


# %%
# Pictures, and the fit
# ---------------------
# The masses are known from each other only: one of them is given.  The bobs' places are expressions
# of the angles and of the lengths that are sought.


def main(small=False):
    """Make noisy pictures, fit, compare with the truth, draw the residuals."""
    kane, constants, seen = derive()
    a, b = kane.q
    times = np.linspace(0.0, 1.0 if small else 2.0, num=51 if small else 101)
    system = System(kane, constants=constants, times=times, ode_solver="dop853")
    rng = np.random.default_rng(3)
    where = sm.lambdify((a, b, *map(sm.Symbol, ("l1", "l2"))), seen)
    trials = []
    for first, second in RELEASES:
        system.initial_conditions = {a: first, b: second}
        ride = system.simulate(rtol=1e-10, atol=1e-10)
        places = where(ride[a], ride[b], TRUTH["l1"], TRUTH["l2"])
        blurred = [column + rng.normal(0.0, BLUR, len(times)) for column in places]
        blurred[3][10:14] = np.nan  # a hand was in the way
        guess = {a: first + 0.05, b: second - 0.05}
        measured = dict(zip(seen, blurred, strict=True))
        trials.append(Trial(times, measured, guess, unknown=[a, b], noise=BLUR))

    system.constants = {**constants, **{sm.Symbol(k): 1.1 * v for k, v in TRUTH.items()}}
    result = system.fit(list(TRUTH), trials)
    print(result)
    expected = [*TRUTH.values(), *(angle for release in RELEASES for angle in release)]
    low, high = result.confidence_intervals(0.997).T
    assert ((low < expected) & (expected < high)).all()
    assert 0.9 < result.noise < 1.1
    print(f"correlation of l1 and l2: {result.correlation[0, 1]:.2f}")

    _, axes = plt.subplots(3, sharex=True, figsize=(7, 7), layout="constrained")
    result.plot_residuals(axes)
    for ax in axes:
        ax.get_legend().remove()
        ax.set_ylabel("residual (m)")


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
