"""
Bicycle changes the lane: countersteering as an optimum
=======================================================

A bicycle without a rider runs at 5 m/s.  Which torque on its handlebar moves it a metre to the
right within three seconds, upright and straight again in the end, with the least effort?

These are the full nonlinear equations of the Carvallo–Whipple bicycle
(`pydy.examples.whipple_bicycle`), with their closed loop: both wheels stay on the ground and roll
without slip.  Collocation holds these constraints at all of its points.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.control import OptimalControl
from pydy.examples import bicycle_scene, whipple_bicycle
from pydy.solvers import dop853

SPEED, ASIDE = 5.0, 1.0  # m/s, m

# %%
# The model
# ---------
# The torque on the steer has no value: it is the control.  The others are zero.

bicycle = whipple_bicycle.derive()
system = System(bicycle.definition, constants=whipple_bicycle.benchmark_parameters(bicycle))
system.initial_conditions = whipple_bicycle.equilibrium(bicycle, SPEED)
torque, t = bicycle.steer_torque, me.dynamicsymbols._t
system.specifieds = {torque: 0.0, bicycle.roll_torque: 0.0, bicycle.push: 0.0}
system.times = np.linspace(0.0, 3.0, num=61)
straight = system.simulate(rtol=1e-8, atol=1e-8)
system.specifieds = {bicycle.roll_torque: 0.0, bicycle.push: 0.0}

# %%
# The least effort
# ----------------
# The search starts from the ride straight ahead.  In the end the bicycle is a metre aside; its
# heading, lean and steer, and the rates of the last two, are zero.  How far it has come is free,
# and all else follows from the constraints.

end = {bicycle["y"]: ASIDE}
end |= {bicycle[name]: 0.0 for name in ("psi", "phi", "delta", "u_phi", "u_delta")}
effort = sm.Integral(torque**2, t)
found = system.optimize_trajectory(effort, 3.0, end=end, guess=straight, mesh_tol=1e-6)
print(f"effort {found.objective:.5f} N² m² s in {len(found.mesh) - 1} intervals: {found.message}")
steer, lean = np.degrees(found[bicycle["delta"]]), np.degrees(found[bicycle["phi"]])
print(f"steer from {steer.min():.1f} to {steer.max():.1f}°, lean to {lean.max():.1f}°")

# %%
# To the left first
# -----------------
# To go to the right, the bicycle steers to the left: only so does it lean to the right, which the
# turn needs.

first = np.flatnonzero(np.abs(steer) > 0.5)[0]
assert steer[first] < 0.0
assert lean[found.times < 1.0].max() > 3.0

figure, axes = plt.subplots(3, 1, sharex=True, figsize=(7, 6), layout="constrained")
axes[0].plot(found.times, found[bicycle["y"]])
axes[1].plot(found.times, steer, label="steer")
axes[1].plot(found.times, lean, label="lean")
axes[2].plot(found.times, found[torque])
axes[0].set_ylabel("to the right [m]")
axes[1].set_ylabel("angle [°]")
axes[1].legend()
axes[2].set(xlabel="t [s]", ylabel="torque [N m]")

# %%
# The wheels are on the ground at all collocation points:

off = np.abs(system.evaluate_holonomic_constraints(x=found.states, t=found.times)).max()
print(f"front wheel off the ground by {off:.0e} m at most")
assert off < 1e-8

# %%
# Less time
# ---------
# A shorter manoeuvre is dearer.

durations = np.linspace(3.0, 2.0, num=6)
costs, last = [], found
for duration in durations:
    problem = OptimalControl(system, effort, duration, end=end, mesh=30)
    last = problem.solve(last)
    costs.append(last.objective)
assert (np.diff(costs) > 0.0).all()
figure, axes = plt.subplots(figsize=(6, 3.5), layout="constrained")
axes.semilogy(durations, costs, "o-")
axes.set(xlabel="duration [s]", ylabel="effort [N² m² s]")

# %%
# The ride:

bicycle_scene.scene(system, bicycle, "A change of the lane").animate(found)

# %%
# Is it true?
# -----------
# A simulation with this torque, without any control, must end on the other lane.

system.specifieds = {**found.inputs(), bicycle.roll_torque: 0.0, bicycle.push: 0.0}
system.times, system.ode_solver = found.mesh, dop853
checked = system.simulate(rtol=1e-10, atol=1e-10)
miss = abs(checked[bicycle["y"]][-1] - ASIDE)
print(f"the simulation ends {miss:.1e} m beside")
assert miss < 1e-4

plt.show()
