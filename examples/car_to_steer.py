"""
Car to steer: a live page
=========================

The page below drives a car with four wheels in your browser.  Its sliders are the steering angle
and the torques of drive and brakes, the speed at the start and the friction of the road.  Brake
hard on a slippery road, and the wheels lock: then the steering has no effect.  Drive hard in a
turn, and the rear turns around.

Closed forms check the model before: the turn of a linear car, full braking with locked wheels, and
the lateral acceleration that friction can give.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm

from pydy.solvers import Event
from pydy.vehicles import CARS, BrushTire, double_track
from pydy.vehicles.scenes import car_scene
from pydy.viz import Live, Slider

G = 9.81  # m/s²

# %%
# The car
# -------
# A brush tire has a stiffness and a friction, which is a symbol here: a constant of the model, for
# a slider of its own.  The length of the contact patch gives the tire its aligning moment.

mu, R = sm.symbols("mu R")
car = CARS["bmw_320i"]
per_load = car.front_stiffness / (car.mass * G * car.rear / car.wheelbase)  # by axle load, 1/rad
tire = BrushTire(3000, stiffness=3000 * per_load, friction=mu, half_length=0.05)
system = double_track(car, tire, speed=15.0)
system.constants["mu"] = 0.9
print(f"{len(system.states)} states, inputs {', '.join(map(str, system.specifieds))}")


def drive(duration, **inputs):
    """Return the motion with inputs that stay as they are, up to standstill."""
    system.specifieds = {"delta": 0.0, "T_drive": 0.0, "T_brake": 0.0, **inputs}
    system.times = np.linspace(0.0, duration, num=401)
    return system.simulate(rtol=1e-8, atol=1e-8, events=stands)


u = system.speeds[0]
stands = Event(u - 1.0, direction=-1, terminal=True, name="walking pace")

# %%
# A gentle turn
# -------------
# At small angles the car turns like the linear one, r/δ = u/(L + K u²).  The side force of a brush
# tire acts a third of the half length behind the axle, which is in K.

gentle = drive(3.0, delta=0.002)
ratio, last = gentle["r"][-1] / 0.002, gentle["u"][-1]
a, b, L, m = car.front, car.rear, car.wheelbase, car.mass
t_f, t_r = (0.05 * np.sqrt(m * G * arm / L / 2 / 3000) / 3 for arm in (b, a))
C_f, C_r = (m * G * arm / L * per_load for arm in (b, a))
K = m / (L - t_f + t_r) * ((b + t_r) / C_f - (a - t_f) / C_r)
expected = last / (L + K * last**2)
print(f"yaw rate by steering angle: {ratio:.4f} 1/s, of the closed form {expected:.4f} 1/s")
assert abs(ratio - expected) < 1e-4 * expected

# %%
# Brakes that lock the wheels
# ---------------------------
# Wheels that slide decelerate the car by μ g, whatever the torque.

braked = drive(3.0, T_brake=9000.0)
sliding = braked.times > 0.5
rate = np.polyfit(braked.times[sliding], braked["u"][sliding], 1)[0]
print(f"deceleration {-rate:.3f} m/s², of the friction {0.9 * G:.3f} m/s²")
assert abs(rate + 0.9 * G) < 1e-3 * G
assert np.abs(braked["omega_fl"][sliding]).max() < 1.0

# %%
# A turn that is too tight
# ------------------------
# The lateral acceleration is the friction's, not the steering's.

tight = drive(4.0, delta=0.2)
assert np.abs(tight["a_y"]).max() < 0.9 * G
assert np.abs(tight["a_y"]).max() > 0.8 * G

# %%
# The page
# --------
# Inputs that are numbers get sliders by their names.  The speed at the start is that of the body
# and of four wheels that roll, so that it is a slider of our own.  The motion is computed anew,
# from the start, when a slider moves.

tour = drive(8.0, delta=0.06, T_drive=300.0)
scene = car_scene(
    system,
    car,
    width=1.61,
    series={"speed": "u", "lateral acceleration": "a_y", "sideslip angle": "beta"},
    title="A car to steer",
)
scene.animate(tour)
v = sm.Symbol("v")
spins = dict.fromkeys(("omega_fl", "omega_fr", "omega_rl", "omega_rr"), v / R)
sliders = {
    "delta": Slider(-0.3, 0.3, unit="rad", label="steering"),
    "T_drive": Slider(0.0, 3000.0, unit="N m", label="drive"),
    "T_brake": Slider(0.0, 6000.0, unit="N m", label="brakes"),
    "mu": Slider(0.1, 1.2, label="friction"),
    v: Slider(3.0, 40.0, 15.0, "m/s", "start speed", sets={"u": v, **spins}),
}

# %%
# The file needs no network and no Python.

with tempfile.TemporaryDirectory() as folder:
    page = scene.to_html(Path(folder) / "car.html", live=Live(sliders, events=stands))
    print(f"the live page takes {page.stat().st_size / 1e6:.1f} MB, three.js included")

# %%
# The motions that were checked
# -----------------------------

figure, axes = plt.subplots(2, 1, figsize=(7, 5), layout="constrained")
for label, motion in {"gentle": gentle, "brakes": braked, "tight": tight}.items():
    axes[0].plot(motion["x"], motion["y"], label=label)
    axes[1].plot(motion.times, motion["u"])
axes[0].set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
axes[0].legend()
axes[1].set(xlabel="time [s]", ylabel="forward speed [m/s]")

plt.show()
