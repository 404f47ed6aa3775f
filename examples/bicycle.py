"""
Bicycle that balances itself
============================

The Carvallo–Whipple bicycle with the parameters of the 2007 benchmark, ridden by nobody.  Its
linear model has been published to 15 digits ([1]_): between 4.292 and 6.024 m/s it is stable.  Here
the full nonlinear equations are derived (`pydy.examples.whipple_bicycle`), linearised exactly at
many speeds, and compared with the published eigenvalues and speeds; then the bicycle gets a push.

.. [1] J. P. Meijaard, J. M. Papadopoulos, A. Ruina and A. L. Schwab, "Linearized dynamics equations
   for the balance and steer of a bicycle: a benchmark and review", Proc. R. Soc. A 463 (2007)
   1955-1982.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np

from pydy.examples import bicycle_scene, whipple_bicycle
from pydy.linearize import constrained_eigenvalues
from pydy.system import System

WEAVE_SPEED, CAPSIZE_SPEED = 4.292382536341115, 6.024262015388372  # m/s, published

# %%
# Riding straight ahead, upright, is a steady motion at every speed.  The Jacobians of the equations
# and of the constraints give the linear model of the motions that keep the wheels on the ground and
# rolling.  Of its eigenvalues eleven are zero or nearly so: place, heading, wheel angles and speed
# do not matter.  The four of lean and steer are left.


def lean_and_steer(system, bicycle, speed):
    """Return the four eigenvalues of lean and steer at a forward speed."""
    system.initial_conditions = whipple_bicycle.equilibrium(bicycle, speed)
    A = system.evaluate_jacobian()
    C = np.vstack([system.evaluate_jacobian(of=kind) for kind in ("holonomic", "velocity")])
    values = constrained_eigenvalues(A, C)
    return values[np.argsort(-np.abs(values))[:4]]


def push(x, t):
    """Return a sideways push in N for a fifth of a second."""
    return 300.0 * np.sin(np.pi * (t - 1.0) / 0.2) ** 2 if 1.0 < t < 1.2 else 0.0


def main(small=False):
    """Compare the eigenvalues with the published ones, push the bicycle, draw."""
    bicycle = whipple_bicycle.derive()
    system = System(bicycle.kane, constants=whipple_bicycle.benchmark_parameters(bicycle))

    found = lean_and_steer(system, bicycle, 5.0)
    published = np.array(whipple_bicycle.PUBLISHED_EIGENVALUES[5.0])
    error = max(np.abs(found - value).min() for value in published)
    print(f"eigenvalues at 5 m/s against the published ones: {error:.0e} 1/s")
    assert error < 1e-10

    for name, speed in (("weave", WEAVE_SPEED), ("capsize", CAPSIZE_SPEED)):
        crossing = np.abs(lean_and_steer(system, bicycle, speed).real).min()
        print(f"{name} becomes stable or unstable at {speed:.3f} m/s: real part {crossing:.0e} 1/s")
        # Where it capsizes, zero is a multiple eigenvalue: known to the root of a rounding error.
        assert crossing < 1e-6

    speeds = np.linspace(0.5, 10.0, num=8 if small else 191)
    eigenvalues = np.array([lean_and_steer(system, bicycle, speed) for speed in speeds])

    start = whipple_bicycle.equilibrium(bicycle, 5.0)
    system.initial_conditions = start
    system.specifieds = {bicycle.push: push}
    system.times = np.linspace(0.0, 1.5 if small else 6.0, num=151 if small else 601)
    # The longest step keeps the solver from stepping across the push.
    x = system.integrate(rtol=1e-9, atol=1e-9, hmax=0.02)
    off_ground = np.abs(system.evaluate_holonomic_constraints(x=x)).max()
    print(f"front wheel off the ground by {off_ground:.0e} m at most")
    assert off_ground < 1e-7
    bicycle_scene.scene(system, bicycle, "Pushed at 5 m/s").animate(system.times, x)
    columns = [system.states.index(bicycle[name]) for name in ("phi", "delta")]
    draw(speeds, eigenvalues, system.times, np.degrees(x[:, columns]))


def draw(speeds, eigenvalues, times, angles):
    """Eigenvalues over speed, and lean and steer after the push."""
    _, (left, right) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
    left.axvspan(WEAVE_SPEED, CAPSIZE_SPEED, color="tab:green", alpha=0.12, label="stable")
    left.plot(speeds, eigenvalues.real, ".", color="tab:blue", markersize=2.5)
    left.plot(speeds, np.abs(eigenvalues.imag), ".", color="0.75", markersize=1.5, zorder=0)
    for value in whipple_bicycle.PUBLISHED_EIGENVALUES[5.0]:
        left.plot(5.0, value.real, "r+", markersize=9)
    left.plot([], [], "r+", label="published")
    left.plot([], [], ".", color="tab:blue", label="real part")
    left.plot([], [], ".", color="0.75", label="imaginary part")
    left.axhline(0, color="0.5", linewidth=0.8)
    left.set(xlabel="forward speed [m/s]", ylabel="eigenvalue [1/s]", ylim=(-10, 10), xlim=(0, 10))
    left.legend(loc="lower left", fontsize=9)

    for column, name in enumerate(("lean", "steer")):
        right.plot(times, angles[:, column], label=name)
    right.axvspan(1.0, 1.2, color="0.85", label="push")
    right.set(xlabel="time [s]", ylabel="angle [deg]", xlim=(0, times[-1]))
    right.legend(loc="lower right", fontsize=9)
    for axes in (left, right):
        axes.grid(alpha=0.3)


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
