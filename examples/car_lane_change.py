"""
Car changes the lane: from a tire file to an animation
======================================================

A tire property file has the coefficients of a measured tire.  With them a car drives through the
cones of the double lane change of ISO 3888-1: to the left lane and back within 125 m, between cones
that leave a few decimetres beside the car.

We check the clearance at each cone, and the car by a closed form: in a steady turn the lateral
acceleration for each angle of the steering is u²/(L + K u²), where the understeer gradient K
follows from the slopes of the tire's forces.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from pydy.vehicles import CARS, MagicFormula, lane_change, read_tir, single_track, step_steer
from pydy.vehicles.scenes import car_scene

WIDTH, SPEED = 1.61, 16.0  # m, m/s

# %%
# A tire property file
# --------------------
# Files come from a tire test, hundreds of lines long.  This short one has the side force and the
# aligning moment of a 205/60R15 tire, from H. B. Pacejka, Tyre and Vehicle Dynamics, 2nd ed., 2006,
# Table A3.1, all that a car needs that neither drives nor brakes.

TIRE = """
[MODEL]
FITTYP = 61          $ Magic Formula 6.1
USE_MODE = 2         $ side force and moments
TYRESIDE = 'LEFT'
[DIMENSION]
UNLOADED_RADIUS = 0.313
[VERTICAL]
FNOMIN = 4000
[LATERAL_COEFFICIENTS]
PCY1 = 1.193
PDY1 = -0.99
PDY2 = 0.145
PEY1 = -1.003
PEY2 = -0.537
PKY1 = -14.95
PKY2 = 2.13
[ALIGNING_COEFFICIENTS]
QBZ1 = 8.964
QCZ1 = 1.18
QDZ1 = 0.1
QEZ1 = -1.609
"""
with tempfile.TemporaryDirectory() as folder:
    path = Path(folder, "205_60R15.tir")
    path.write_text(TIRE, encoding="utf-8")
    tire = MagicFormula(read_tir(path))
print(tire)

# %%
# The lane change
# ---------------
# A driver looks half a second ahead and steers towards the middle of the track there.  The cones
# show how narrow the lanes are.  The wheels in front turn with the steering angle.

car = CARS["bmw_320i"]
system = single_track(car, tire, speed=SPEED)
change = lane_change(system, WIDTH)
print(change)
scene = car_scene(system, car, change=change, width=WIDTH, series=["a_y", "beta"])
scene.animate(change.trajectory)

# %%
# Path, steering and lateral acceleration
# ---------------------------------------
# The path is that of the mass centre, the grey line what the driver aims at.

figure, (above, below) = plt.subplots(2, 1, figsize=(8, 5), layout="constrained")
change.plot(above)
below.plot(change.trajectory.times, np.degrees(change.angles), label="steering [°]")
below.plot(change.trajectory.times, change.trajectory["a_y"], label="lateral acceleration [m/s²]")
below.set_xlabel("time [s]")
below.grid(alpha=0.3)
below.legend()

assert change.passed
assert change.clearances.min() > 0.0
assert np.abs(change.trajectory["a_y"]).max() < 0.99 * 9.81  # the tire's friction

# %%
# A steady turn, by a closed form
# -------------------------------
# An axle has two tires that each bear half of its load.  Around straight driving their side force
# has the slope C, and acts a trail t behind the axle.  Of the balance of forces and moments in a
# turn of the radius R follows δ = L/R + K u²/R, with ::
#
#     K = m/(L − t_f + t_r) ((b + t_r)/C_f − (a − t_f)/C_r)


def slopes(load):
    """Return the cornering stiffness of an axle and the trail of its tires."""
    step = 1e-5
    one, other = (tire.forces(load / 2, 0.0, slip) for slip in (step, -step))
    return -2 * (one.Fy - other.Fy) / (2 * step), -(one.Mz - other.Mz) / (one.Fy - other.Fy)


a, b, L, m = car.front, car.rear, car.wheelbase, car.mass
(C_f, t_f), (C_r, t_r) = (slopes(m * 9.81 * arm / L) for arm in (b, a))
K = m / (L - t_f + t_r) * ((b + t_r) / C_f - (a - t_f) / C_r)
gain = SPEED**2 / (L + K * SPEED**2)
measured = step_steer(system, 1e-3, quantity="a_y").steady / 1e-3
print(f"understeer gradient {np.degrees(K):.3f}° s²/m")
print(f"lateral acceleration by angle {measured:.3f}, by the closed form {gain:.3f} m/s²/rad")
assert abs(measured - gain) < 1e-4 * gain

# %%
# How fast?
# ---------
# The faster the car, the nearer the cones, until it touches them.

speeds = np.linspace(12.0, 24.0, num=4)
nearest = []
for speed in speeds:
    system.constants["u"] = speed
    nearest.append(np.nanmin(lane_change(system, WIDTH).clearances))
figure, axes = plt.subplots(figsize=(7, 3), layout="constrained")
axes.axhline(0.0, color="0.7")
axes.plot(speeds, nearest, "o-")
axes.set(xlabel="speed [m/s]", ylabel="nearest cone [m]")
axes.grid(alpha=0.3)
assert nearest[0] > nearest[1] > 0.0 > nearest[-1]

plt.show()
