"""
Four-bar linkage
================

A crank, a coupler and a rocker on a fixed base: the linkage in wipers, pumps and oil wells.  The
crank is spun up and released.  Gravity is off, so that only the changing inertia of the linkage
slows it down and speeds it up again.

Two equations close the loop.  The rocker's angle also follows from the intersection of two circles,
with which we compare it.  The energy must be constant.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.viz import Line, Sphere, Visual

LENGTHS = {"a": 0.1, "b": 0.25, "c": 0.2, "base": 0.28}  # m: crank, coupler, rocker, base
MASSES = {"m1": 0.4, "m2": 0.3, "m3": 0.25}  # kg

# %%
# Three rods
# ----------
# All angles are measured from the base.  A rod is a frame, its end, its mass centre and its body.

a, b, c, base, m1, m2, m3 = sm.symbols("a b c base m1 m2 m3")
q1, q2, q3, u1, u2, u3 = me.dynamicsymbols("q1:4 u1:4")
t = me.dynamicsymbols._t

N, O = me.ReferenceFrame("N"), me.Point("O")
O.set_vel(N, 0)
Q = O.locatenew("Q", base * N.x)
Q.set_vel(N, 0)


def rod(name, start, end, length, mass, q, u):
    """Return the body and the end of a uniform rod that begins at a point."""
    frame = N.orientnew(name, "Axis", (q, N.z))
    frame.set_ang_vel(N, u * N.z)
    centre = start.locatenew(f"{name}_centre", length / 2 * frame.x)
    end = start.locatenew(end, length * frame.x)
    centre.v2pt_theory(start, N, frame)
    end.v2pt_theory(start, N, frame)
    inertia = (me.inertia(frame, 0, 0, mass * length**2 / 12), centre)
    return me.RigidBody(name, centre, frame, mass, inertia), end


crank, A = rod("crank", O, "A", a, m1, q1, u1)
coupler, B = rod("coupler", A, "B", b, m2, q2, u2)
rocker, C = rod("rocker", Q, "C", c, m3, q3, u3)
tracer = A.locatenew("T", b / 2 * coupler.frame.x + b / 3 * coupler.frame.y)

# %%
# Closing the loop
# ----------------
# The crank's angle is independent.  The end of the coupler must be the end of the rocker: two
# equations for their angles, and two for their rates.

gap, slip = B.pos_from(C), B.vel(N) - C.vel(N)
kane = me.KanesMethod(
    N,
    q_ind=[q1],
    q_dependent=[q2, q3],
    u_ind=[u1],
    u_dependent=[u2, u3],
    kd_eqs=[q1.diff(t) - u1, q2.diff(t) - u2, q3.diff(t) - u3],
    configuration_constraints=[gap.dot(N.x), gap.dot(N.y)],
    velocity_constraints=[slip.dot(N.x), slip.dot(N.y)],
    bodies=[crank, coupler, rocker],
    forcelist=[],
)

# %%
# The initial position
# --------------------
# Only the crank's angle and rate are given.  `set_dependent_initial_conditions` finds the rest from
# a rough guess, which selects one of the two ways to assemble the linkage.  The coordinates of the
# tracer, a point beside the coupler, are outputs.

energy = me.kinetic_energy(N, crank, coupler, rocker)
path = tracer.pos_from(O)
system = System(
    kane,
    constants={**LENGTHS, **MASSES},
    initial_conditions={q1: 0.5, q2: 0.7, q3: 1.8, u1: 12.0},
    times=np.linspace(0.0, 2.0, num=1001),
    outputs={"energy": energy, "T_x": path.dot(N.x), "T_y": path.dot(N.y)},
)
print("residuals of the guess:", system.evaluate_holonomic_constraints().round(3))
system.set_dependent_initial_conditions(use_jac=True)
print("residuals of the start:", system.evaluate_holonomic_constraints().round(15))

# %%
# Simulation
# ----------
# The trace of the tracer is the coupler curve: linkages are designed for its shape.

motion = system.simulate(rtol=1e-11, atol=1e-11)
scene = system.scene(
    Visual(Line([O, A], radius=0.005, color="steelblue"), name="crank"),
    Visual(Line([A, B, tracer, A], radius=0.003, color="grey"), name="coupler"),
    Visual(Line([Q, C], radius=0.005, color="seagreen"), name="rocker"),
    Visual(Sphere(0.006, color="orangered"), tracer, name="tracer", trail=True),
    origin=O,
    up="y",
    ground=False,
    series=[u1, u2, u3],
)
scene.animate(motion)

# %%

figure, axes = plt.subplots(figsize=(7, 3.2), layout="constrained")
for speed, name in ((u1, "crank"), (u2, "coupler"), (u3, "rocker")):
    axes.plot(motion.times, motion[speed], label=name)
axes.set(xlabel="time [s]", ylabel="angular velocity [rad/s]", xlim=(0, motion.times[-1]))
axes.legend(loc="upper right")
axes.grid(alpha=0.3)

# %%
# Two circles
# -----------
# The joint of coupler and rocker lies on a circle about A with radius b and on one about Q with
# radius c.  The triangle of A, Q and the joint gives the rocker's angle for every crank angle.

lengths = LENGTHS
dx = lengths["base"] - lengths["a"] * np.cos(motion[q1])
dy = -lengths["a"] * np.sin(motion[q1])
distance = np.hypot(dx, dy)
at_rocker = np.arccos(
    (distance**2 + lengths["c"] ** 2 - lengths["b"] ** 2) / (2 * distance * lengths["c"])
)
expected = np.arctan2(-dy, -dx) - at_rocker
error = np.abs(np.sin(motion[q3] - expected)).max()
print(f"rocker against two circles: {error:.0e} rad")
assert error < 1e-7

drift = np.abs(motion["energy"] / motion["energy"][0] - 1).max()
print(f"energy: {motion['energy'][0]:.4f} J, relative change: {drift:.0e}")
assert drift < 1e-7

# %%
# The rocker's angle over the crank's, and the coupler curve:

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8), layout="constrained")
order = np.argsort(motion[q1] % (2 * np.pi))
turn = np.degrees(motion[q1] % (2 * np.pi))[order]
left.plot(turn, np.degrees(motion[q3])[order], label="simulated")
left.plot(turn[::20], np.degrees(expected)[order][::20], "k+", label="two circles")
left.set(xlabel="crank [deg]", ylabel="rocker [deg]")
left.legend()
right.plot(motion["T_x"], motion["T_y"], color="tab:orange")
right.set(aspect="equal", xlabel="x [m]", ylabel="y [m]", title="coupler curve")
for axes in (left, right):
    axes.grid(alpha=0.3)

plt.show()
