"""
How does a person stand? Gains from a shaken platform
=====================================================

Somebody stands on a platform that is shaken, and does not fall: ankles and hips answer with torques
to what legs and trunk do.  From a record of the motion we find the eight gains of that feedback, as
S. Park, F. B. Horak and A. D. Kuo did (Postural feedback responses scale with biomechanical
constraints in human standing, Exp. Brain Res. 154, 2004).

Without feedback a person falls, and so does every simulation with wrong gains: it never gets near
the record.  Collocation needs no simulation.  It starts with gains of zero.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.analysis import Trial
from pydy.mechanics import Definition

GAINS = np.array([[950.0, 175.0, 185.0, 50.0], [45.0, 290.0, 60.0, 26.0]])  # N m/rad, N m s/rad
NOISE = np.radians(0.25)  # of the markers, standard deviation

# %%
# Legs and trunk
# --------------
# Both angles are zero in an upright person of 70 kg and 1.75 m; the segments are those of D. A.
# Winter, Biomechanics and Motor Control of Human Movement, table 4.1.  In the frame of the platform
# each mass feels a force against the platform's acceleration.

ankle, hip, leg_rate, hip_rate = states = me.dynamicsymbols("ankle hip leg_rate hip_rate")
T_ankle, T_hip, shaken = me.dynamicsymbols("T_ankle T_hip acceleration")
ground, leg, trunk = (me.ReferenceFrame(name) for name in "NLT")
leg.orient_axis(ground, ankle, ground.z)
trunk.orient_axis(leg, hip, leg.z)
foot = me.Point("foot")
foot.set_vel(ground, 0)
joint = foot.locatenew("hip", 0.86 * leg.y)
bodies, loads = [], [(leg, (T_ankle - T_hip) * ground.z), (trunk, T_hip * ground.z)]
for name, start, frame, mass, distance, gyration in (
    ("leg", foot, leg, 22.5, 0.475, 0.28),
    ("trunk", joint, trunk, 47.5, 0.315, 0.25),
):
    centre = start.locatenew(name, distance * frame.y)
    spin = me.inertia(frame, 0, 0, mass * gyration**2)
    bodies.append(me.RigidBody(name, centre, frame, mass, (spin, centre)))
    loads.append((centre, -mass * shaken * ground.x - 9.81 * mass * ground.y))
model = Definition(ground, states[:2], states[2:], bodies=bodies, loads=loads)

# %%
# The feedback
# ------------
# Each torque is a sum of the four states times gains.  The platform moves by twelve sines.

t = me.dynamicsymbols._t
gains = sm.symbols("k:2:4")
feedback = -(sm.Matrix(2, 4, gains) * sm.Matrix(states))
rates = [2 * np.pi * n / 240 for n in (7, 11, 16, 25, 38, 61, 103, 131, 151, 181, 313, 523)]
system = System(model)
system.specifieds = {
    shaken: sum(-0.02 * w**2 * sm.sin(w * t) for w in rates),
    T_ankle: feedback[0],
    T_hip: feedback[1],
}

# %%
# The record
# ----------
# It is made here, so that the truth is known: a simulation with noise.

times = np.arange(0.0, 20.0, 0.01)
system.constants = dict(zip(gains, GAINS.ravel(), strict=True))
system.times, system.ode_solver = times, "dop853"
ride = system.simulate(rtol=1e-9, atol=1e-9)
random = np.random.default_rng(4)
measured = {s: ride[s] + random.normal(0.0, NOISE, len(times)) for s in states}
figure, axes = plt.subplots(figsize=(7, 3.2), layout="constrained")
for s in (ankle, hip):
    axes.plot(times, np.degrees(measured[s]), ".", markersize=2, label=s.func.__name__)
axes.set(xlabel="t [s]", ylabel="angle [°]")
axes.legend()

# %%
# The fit
# -------
# With gains of zero the person falls; that is where the search begins.

system.constants = dict.fromkeys(gains, 0.0)
result = system.fit(gains, Trial(times, measured, noise=NOISE), method="collocation")
for name, estimate, error, truth in zip(
    result.names, result.estimates, result.standard_errors, GAINS.ravel(), strict=True
):
    print(f"{name}: {estimate:8.2f} ± {error:.2f}, true {truth:6.1f}")

# %%
# Checks
# ------
# The truth is within three standard errors and a half of all eight, and what remains is the noise.

distance = (result.estimates - GAINS.ravel()) / result.standard_errors
assert np.abs(distance).max() < 3.5
assert abs(result.noise - 1.0) < 0.08

# %%
# The person on the platform, and what the fit leaves of the record:

system.constants = dict(zip(gains, GAINS.ravel(), strict=True))
system.scene(up="y").animate(ride)

figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
result.plot_residuals(axes)

plt.show()
