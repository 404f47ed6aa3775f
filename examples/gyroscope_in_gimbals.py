"""
Gyroscope in gimbals
====================

A rotor spins in an inner ring, the inner ring turns in an outer ring, and the outer ring turns
about the vertical.  The inner ring is heavier on one side.  Instead of tipping over, the rotor
precesses about the vertical.

Three pin joints of SymPy make the mechanism.  With a level axis the rate of steady precession is
m g d/(C ω) exactly, for the moment m g d of the imbalance and the spin momentum C ω.  Released from
rest, the rotor also nutates, with a frequency near C ω/√(A B).
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.viz import Cylinder, Sphere, Torus, Visual

SPIN = 250.0  # rad/s

# %%
# Rings and rotor
# ---------------
# The moments of inertia are numbers that suit a desk toy.  The mass centre of the inner ring lies d
# from the centre, along the rotor's axis.

m, d, g, C, D = sm.symbols("m d g C D")
A_o, B_i, C_i = sm.symbols("A_o B_i C_i")
ground = me.RigidBody("ground")
outer = me.RigidBody("outer", mass=sm.Symbol("m_o"))
inner = me.RigidBody("inner", mass=m)
rotor = me.RigidBody("rotor", mass=sm.Symbol("m_r"))
outer.central_inertia = me.inertia(outer.frame, A_o, A_o, A_o)
inner.central_inertia = me.inertia(inner.frame, C_i, B_i, B_i)
rotor.central_inertia = me.inertia(rotor.frame, C, D, D)

# %%
# Joints
# ------
# The outer ring turns about the vertical, the inner ring about the outer ring's y axis, and the
# rotor about the inner ring's x axis.  All three axes meet in one point.

psi, theta, phi = me.dynamicsymbols("psi theta phi")
u = u_psi, u_theta, u_phi = me.dynamicsymbols("u_psi u_theta u_phi")
yaw = me.PinJoint("yaw", ground, outer, psi, u_psi, joint_axis=ground.z)
pitch = me.PinJoint(
    "pitch", outer, inner, theta, u_theta, child_point=-d * inner.x, joint_axis=outer.y
)
spin = me.PinJoint("spin", inner, rotor, phi, u_phi, parent_point=-d * inner.x, joint_axis=inner.x)
gyroscope = me.System.from_newtonian(ground)
gyroscope.add_joints(yaw, pitch, spin)
gyroscope.apply_uniform_gravity(-g * ground.z)

VALUES = {m: 0.1, d: 0.05, g: 9.81, C: 1.2e-4, D: 7e-5, A_o: 1.5e-4, B_i: 8e-5, C_i: 9e-5}
system = System(gyroscope, constants=VALUES, ode_solver="dop853")
print(system.states)

# %%
# Steady precession
# -----------------
# The moment of the weight is equal to the change of the spin momentum, which turns with the outer
# ring.  Started at this rate, the axis stays level.

rate = VALUES[m] * VALUES[g] * VALUES[d] / (VALUES[C] * SPIN)
print(f"precession: {rate:.4f} rad/s, one turn in {2 * np.pi / rate:.2f} s")
system.initial_conditions = {u_phi: SPIN, u_psi: rate}
system.times = np.linspace(0.0, 4.0, num=1001)
steady = system.simulate(rtol=1e-11, atol=1e-12)
dip = np.abs(steady[theta]).max()
print(f"the axis leaves the horizontal by {dip:.0e} rad at most")
assert dip < 1e-9

# %%
# Released from rest
# ------------------
# The weight side drops a little, the precession overshoots, and so on: nutation.  The animation is
# twenty times slower than the toy.

system.initial_conditions = {u_phi: SPIN}
system.times = np.linspace(0.0, 0.5, num=2001)
motion = system.simulate(rtol=1e-11, atol=1e-12)

centre = outer.masscenter
arm = inner.masscenter.locatenew("weight", 0.04 * inner.x)
scene = system.scene(
    Visual(Torus(0.14, 0.006, axis="x", color="steelblue"), outer.frame, centre, name="outer ring"),
    Visual(Torus(0.11, 0.005, axis="z", color="seagreen"), inner.frame, centre, name="inner ring"),
    Visual(Cylinder(0.18, 0.004, axis="x", color="grey"), inner.frame, centre, name="axle"),
    Visual(Cylinder(0.02, 0.07, axis="x", color="darkorange"), rotor.frame, centre, name="rotor"),
    Visual(Sphere(0.018, color="crimson"), arm, name="weight", trail=True),
    origin=ground.masscenter,
    up="z",
    ground=False,
    series=[psi, theta],
)
scene.animate(motion, speed=0.05)

# %%
# The path of the axis is a cycloid: it is at rest at each of its upper points.

figure, axes = plt.subplots(figsize=(8, 3), layout="constrained")
axes.plot(np.degrees(motion[psi]), -np.degrees(motion[theta]), label="released from rest")
axes.plot(np.degrees(rate * motion.times), 0 * motion.times, "--", label="steady precession")
axes.set(xlabel="heading [deg]", ylabel="elevation [deg]")
axes.grid(alpha=0.3)
axes.legend()

# %%
# Frequency of the nutation
# -------------------------
# A and B are the moments of inertia about the vertical and about the pitch axis of all that turns
# with them.  The eigenvalues of the linear model give the exact frequency of small nutations.

A = VALUES[A_o] + VALUES[B_i] + VALUES[m] * VALUES[d] ** 2 + VALUES[D]
B = VALUES[B_i] + VALUES[m] * VALUES[d] ** 2 + VALUES[D]
expected = VALUES[C] * SPIN / np.sqrt(A * B)
x = [0.0, 0.0, 0.0, rate, 0.0, SPIN]
exact = np.abs(np.linalg.eigvals(system.evaluate_jacobian(x)).imag).max()
print(f"nutation: C ω/√(A B) = {expected:.3f} rad/s, exactly {exact:.3f} rad/s")
assert abs(expected / exact - 1) < 2e-3

# %%
# The simulated elevation has the same frequency, and its average moves with the steady rate.
# Nothing brakes the toy, so its energy is constant.

crossings = np.flatnonzero(np.diff(np.sign(motion[u_theta])))
found = np.pi / np.diff(motion.times[crossings]).mean()
drift = (motion[psi] @ np.ones(len(motion.times)) * 2 / len(motion.times)) / motion.times[-1]
print(f"in the simulation: {found:.2f} rad/s; mean precession {drift:.3f} rad/s")
assert abs(found / exact - 1) < 0.02
assert abs(drift / rate - 1) < 0.05
total = motion.energy[:, 2]
change = np.ptp(total) / total[0]
print(f"energy, relative change: {change:.0e}")
assert change < 1e-9

plt.show()
