"""
Bicycle that balances itself
============================

The Carvallo–Whipple bicycle with the parameters of the 2007 benchmark, without a rider.  Its linear
model has been published to 15 digits ([1]_): it is stable between 4.292 and 6.024 m/s.

Here we take the full nonlinear equations (`pydy.examples.whipple_bicycle`), linearise them exactly
at many speeds, compare with the published eigenvalues and speeds, and then push the bicycle.

.. [1] J. P. Meijaard, J. M. Papadopoulos, A. Ruina and A. L. Schwab, "Linearized dynamics equations
   for the balance and steer of a bicycle: a benchmark and review", Proc. R. Soc. A 463 (2007)
   1955-1982.
"""

import matplotlib.pyplot as plt
import numpy as np

from pydy import System
from pydy.examples import bicycle_scene, whipple_bicycle
from pydy.linearize import constrained_eigenvalues

WEAVE_SPEED, CAPSIZE_SPEED = 4.292382536341115, 6.024262015388372  # m/s, published

# %%
# The model
# ---------
# The equations of motion have eight coordinates and eight speeds.  The front wheel touches the
# ground: one holonomic constraint.  Both wheels roll without slip: four more on the speeds.

bicycle = whipple_bicycle.derive()
system = System(bicycle.definition, constants=whipple_bicycle.benchmark_parameters(bicycle))
print("coordinates:", system.coordinates)
print(f"{system.num_holonomic_constraints} holonomic constraint, "
      f"{system.num_nonholonomic_constraints} nonholonomic ones")  # fmt: skip

# %%
# Stability over the speed
# ------------------------
# Riding straight ahead, upright, is a steady motion at every speed.  The Jacobians of the equations
# and of the constraints give the linear model of the motions that the constraints allow.  Eleven of
# its eigenvalues are zero, since nothing depends on position, heading and wheel angles.  The four
# of lean and steer remain.


def lean_and_steer(speed):
    """Return the four eigenvalues of lean and steer at a forward speed."""
    system.initial_conditions = whipple_bicycle.equilibrium(bicycle, speed)
    A = system.evaluate_jacobian()
    C = np.vstack([system.evaluate_jacobian(of=kind) for kind in ("holonomic", "velocity")])
    values = constrained_eigenvalues(A, C)
    return values[np.argsort(-np.abs(values))[:4]]


speeds = np.linspace(0.5, 10.0, num=191)
eigenvalues = np.array([lean_and_steer(speed) for speed in speeds])

figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
axes.axvspan(WEAVE_SPEED, CAPSIZE_SPEED, color="tab:green", alpha=0.12, label="stable")
axes.plot(speeds, eigenvalues.real, ".", color="tab:blue", markersize=2.5)
axes.plot(speeds, np.abs(eigenvalues.imag), ".", color="0.75", markersize=1.5, zorder=0)
for value in whipple_bicycle.PUBLISHED_EIGENVALUES[5.0]:
    axes.plot(5.0, value.real, "r+", markersize=9)
axes.plot([], [], "r+", label="published")
axes.plot([], [], ".", color="tab:blue", label="real part")
axes.plot([], [], ".", color="0.75", label="imaginary part")
axes.axhline(0, color="0.5", linewidth=0.8)
axes.set(xlabel="forward speed [m/s]", ylabel="eigenvalue [1/s]", ylim=(-10, 10), xlim=(0, 10))
axes.legend(loc="lower left", fontsize=9)
axes.grid(alpha=0.3)

# %%
# The eigenvalues at 5 m/s agree with the published ones.  At the two published speeds a real part
# is zero; at the capsize speed zero is a multiple eigenvalue, known to the root of a rounding error
# only.

found = lean_and_steer(5.0)
published = np.array(whipple_bicycle.PUBLISHED_EIGENVALUES[5.0])
error = max(np.abs(found - value).min() for value in published)
print(f"eigenvalues at 5 m/s against the published ones: {error:.0e} 1/s")
assert error < 1e-10

for name, speed in (("weave", WEAVE_SPEED), ("capsize", CAPSIZE_SPEED)):
    crossing = np.abs(lean_and_steer(speed).real).min()
    print(f"{name} speed {speed:.3f} m/s: smallest real part {crossing:.0e} 1/s")
    assert crossing < 1e-6

# %%
# A push
# ------
# At 5 m/s the bicycle recovers from a sideways push that lasts a fifth of a second.


def push(x, t):
    """Return a sideways force in N."""
    return 300.0 * np.sin(np.pi * (t - 1.0) / 0.2) ** 2 if 1.0 < t < 1.2 else 0.0


system.initial_conditions = whipple_bicycle.equilibrium(bicycle, 5.0)
system.specifieds = {bicycle.push: push}
system.times = np.linspace(0.0, 6.0, num=601)
# The largest step keeps the solver from stepping across the push.
motion = system.simulate(rtol=1e-9, atol=1e-9, hmax=0.02)
bicycle_scene.scene(system, bicycle, "Pushed at 5 m/s").animate(motion)

# %%
# Lean and steer swing together: the bicycle steers into the fall.

figure, axes = plt.subplots(figsize=(7, 3.2), layout="constrained")
for name, label in (("phi", "lean"), ("delta", "steer")):
    axes.plot(motion.times, np.degrees(motion[bicycle[name]]), label=label)
axes.axvspan(1.0, 1.2, color="0.85", label="push")
axes.set(xlabel="time [s]", ylabel="angle [deg]", xlim=(0, motion.times[-1]))
axes.legend(loc="lower right", fontsize=9)
axes.grid(alpha=0.3)

# %%
# The front wheel stays on the ground:

off_ground = np.abs(system.evaluate_holonomic_constraints(x=motion.states)).max()
print(f"front wheel off the ground by {off_ground:.0e} m at most")
assert off_ground < 1e-7

plt.show()
