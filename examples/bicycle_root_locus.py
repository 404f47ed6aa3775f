"""
Root locus of a bicycle over its speed
======================================

A bicycle that nobody steers falls over at low speed, rights itself between two speeds, and falls
over slowly at higher ones.  The eigenvalues of its linear model tell which speeds these are.  The
model is the Carvallo–Whipple bicycle with the parameters of Meijaard, Papadopoulos, Ruina and
Schwab (Proc. R. Soc. A 463, 2007).
"""

import matplotlib.pyplot as plt
import numpy as np

from pydy import System
from pydy.examples import bicycle_scene, whipple_bicycle

PUBLISHED = (4.292382536341, 6.024262015388)  # weave and capsize speed, m/s

# %%
# Linear models over the speed
# ----------------------------
# At each speed the bicycle rides straight ahead.  Its position and the angles of its wheels change
# steadily: they are listed as `moving`.  `System.eigenvalues` solves for the steady motion, takes
# the linear model of the independent states and follows each eigenvalue from speed to speed.

bicycle = whipple_bicycle.derive()
system = System(bicycle.definition, constants=whipple_bicycle.benchmark_parameters(bicycle))
speeds = np.linspace(0.0, 10.0, num=1001)
sweep = system.eigenvalues({"u_x": speeds}, moving=["x", "theta_R", "theta_F"])

figure, axes = plt.subplots(figsize=(7, 4.2), layout="constrained")
sweep.plot(axes, "m/s")
axes.set_ylim(-10, 10)

# %%
# Where stability changes
# -----------------------
# `crossings` finds the speeds at which a real part is zero, to all digits.

weave, capsize = sweep.crossings()
print(f"weave speed {weave.value:.12f} m/s, at {weave.eigenvalue.imag:.6f} rad/s")
print(f"capsize speed {capsize.value:.12f} m/s")
assert np.allclose((weave.value, capsize.value), PUBLISHED, rtol=0, atol=5e-12)

# %%
# The eigenvalues themselves are published at eleven speeds.

worst = 0.0
for speed, published in whipple_bicycle.PUBLISHED_EIGENVALUES.items():
    row = sweep.eigenvalues[np.abs(speeds - speed).argmin()]
    worst = max(worst, *(np.abs(row - value).min() for value in published))
print(f"largest difference from the published eigenvalues: {worst:.1e} 1/s")
assert worst < 1e-9

# %%
# The root locus
# --------------
# The same eigenvalues in the complex plane: the pair of the weave mode crosses the imaginary axis
# from right to left, and the capsize eigenvalue passes zero from left to right.

figure, axes = plt.subplots(figsize=(7, 4.2), layout="constrained")
sweep.plot_root_locus(axes, "m/s")
axes.set_xlim(-15, 7)

# %%
# Below the weave speed
# ---------------------
# At 4 m/s the weave mode grows slowly.  The bicycle starts with a small rate of lean; its
# oscillation grows by the factor that the eigenvalue predicts.

start = whipple_bicycle.equilibrium(bicycle, 4.0)
lean, lean_rate = bicycle["phi"], bicycle["u_phi"]
system.initial_conditions = {**start, lean_rate: 0.02}
system.set_dependent_initial_conditions()
system.ode_solver = "dop853"
system.times = np.linspace(0.0, 8.0, num=481)
motion = system.simulate(rtol=1e-9, atol=1e-9)
bicycle_scene.scene(system, bicycle, "Weave at 4 m/s").animate(motion)

# %%

row = sweep.eigenvalues[np.abs(speeds - 4.0).argmin()]
mode = max((value for value in row if value.imag > 0.5), key=lambda value: value.real)
print(f"weave mode at 4 m/s: {mode:.4f} 1/s")
angle = np.degrees(motion[lean])
figure, axes = plt.subplots(figsize=(7, 3), layout="constrained")
axes.plot(motion.times, angle, label="lean")
late = motion.times > 0.5 * motion.times[-1]
peak = np.abs(angle[late]).argmax() + np.flatnonzero(late)[0]
envelope = np.abs(angle[peak]) * np.exp(mode.real * (motion.times - motion.times[peak]))
axes.plot(motion.times, envelope, "--", color="0.5", label="growth of the weave mode")
axes.plot(motion.times, -envelope, "--", color="0.5")
axes.set(xlabel="time [s]", ylabel="lean [deg]", xlim=(0, motion.times[-1]))
axes.legend(loc="upper left")
axes.grid(alpha=0.3)

plt.show()
