"""
Forces in an engine
===================

A crank, a connecting rod and a piston: a closed loop, and the forces that hold it together.  The
piston is guided by a constraint, whose multiplier is the side thrust on the cylinder wall.  The
load of the main bearing is the reaction of a joint.  Neither needs an auxiliary speed.

The sum of all forces on the moving parts must be the rate of change of their momentum, which we
take from the trajectory by differences.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.viz import Arrow, Box, Line, Sphere, Visual

CONSTANTS = {"a": 0.04, "b": 0.14, "m1": 2.0, "m2": 0.6, "m3": 0.5}  # m, kg

# %%
# Crank, rod and piston
# ---------------------
# The angles of crank and rod are measured from the cylinder's axis N.x.

a, b, m1, m2, m3 = sm.symbols("a b m1 m2 m3")
q1, q2, u1, u2 = me.dynamicsymbols("q1 q2 u1 u2")
gas, t = me.dynamicsymbols("gas"), me.dynamicsymbols._t

N, O = me.ReferenceFrame("N"), me.Point("O")
O.set_vel(N, 0)
A, B = N.orientnew("A", "Axis", (q1, N.z)), N.orientnew("B", "Axis", (q2, N.z))
A.set_ang_vel(N, u1 * N.z)
B.set_ang_vel(N, u2 * N.z)
crank_pin = O.locatenew("crank pin", a * A.x)
wrist_pin = crank_pin.locatenew("wrist pin", b * B.x)
crank_centre = O.locatenew("crank centre", a / 4 * A.x)
rod_centre = crank_pin.locatenew("rod centre", b / 3 * B.x)
crank = me.RigidBody(
    "crank", crank_centre, A, m1, (me.inertia(A, 0, 0, m1 * a**2 / 2), crank_centre)
)
rod = me.RigidBody("rod", rod_centre, B, m2, (me.inertia(B, 0, 0, m2 * b**2 / 12), rod_centre))
piston = me.Particle("piston", wrist_pin, m3)
bodies = [crank, rod, piston]

# %%
# The wrist pin stays on the axis: one equation closes the loop.  Its gradient is a unit vector, so
# that the multiplier is a force in newtons, on the piston along N.y.

off_axis = wrist_pin.pos_from(O).dot(N.y)
kane = me.KanesMethod(
    N,
    q_ind=[q1],
    q_dependent=[q2],
    u_ind=[u1],
    u_dependent=[u2],
    kd_eqs=[q1.diff(t) - u1, q2.diff(t) - u2],
    configuration_constraints=[off_axis],
    velocity_constraints=[off_axis.diff(t).xreplace({q1.diff(t): u1, q2.diff(t): u2})],
    bodies=bodies,
    forcelist=[(wrist_pin, -gas * N.x)],
)

# %%
# The gas pushes while the piston moves outwards.  Only the crank's angle and rate are given;
# `set_dependent_initial_conditions` finds those of the rod.

system = System(
    kane,
    constants=CONSTANTS,
    specifieds={gas: 300.0 * (1.0 + sm.cos(q1))},
    initial_conditions={q1: 0.3, q2: 0.0, u1: 200.0},
    times=np.linspace(0.0, 0.1, num=10001),
    ode_solver="dop853",
)
system.set_dependent_initial_conditions(use_jac=True)

# %%
# Forces as outputs
# -----------------
# `system.reaction` cuts bodies free and returns the resultant that holds them.  The main bearing
# holds crank, rod and piston.  So does the wall, whose thrust is therefore among the loads of this
# cut.  The crank pin holds rod and piston, the wrist pin the piston alone.

thrust = system.constraint_forces["lambda0"]
wall = [(wrist_pin, thrust * N.y)]
main = system.reaction(bodies, O, loads=wall)
pin = system.reaction([rod, piston], crank_pin, loads=wall)
wrist = system.reaction(piston, wrist_pin, loads=wall)
momentum = sum((body.mass * body.masscenter.pos_from(O).dt(N) for body in bodies), me.Vector(0))
system.outputs = {
    "thrust": thrust,
    "main_x": main.force.dot(N.x),
    "main_y": main.force.dot(N.y),
    "main_torque": main.torque.dot(N.z),
    "pin": pin.force.magnitude(),
    "wrist_y": wrist.force.dot(N.y),
    "p_x": momentum.dot(N.x),
    "p_y": momentum.dot(N.y),
}
motion = system.simulate(constraints="project", rtol=1e-11, atol=1e-11)

# %%
# The engine in motion, with the forces of wall and main bearing on the moving parts as arrows.
# Both have one scale.

pace = 8e-6  # m of an arrow for each N
scene = system.scene(
    Visual(Line([O, crank_pin], radius=0.008, color="steelblue"), name="crank"),
    Visual(Line([crank_pin, wrist_pin], radius=0.006, color="grey"), name="rod"),
    Visual(Sphere(0.01, color="steelblue"), crank_pin, name="crank pin"),
    Visual(Box(0.04, 0.06, 0.06, color="darkorange", opacity=0.6), N, wrist_pin, name="piston"),
    Visual(Arrow(main.force, scale=pace), O, name="main bearing"),
    Visual(Arrow(thrust * N.y, scale=4 * pace), wrist_pin, name="wall, 4 times larger"),
    origin=O,
    up="y",
    ground=False,
    series=["main_x", "main_y", "thrust"],
)
scene.animate(motion.at(motion.times[: len(motion.times) // 3]), speed=0.005)

# %%
# The forces over time
# --------------------
# A bearing is designed for the polar diagram of its load, on the left.

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
left.plot(-motion["main_x"] / 1e3, -motion["main_y"] / 1e3, color="tab:blue", linewidth=0.8)
left.set(aspect="equal", xlabel="along the cylinder [kN]", ylabel="across [kN]")
left.set_title("force on the main bearing")
for name, label in (("pin", "crank pin"), ("thrust", "wall on piston")):
    right.plot(1e3 * motion.times, motion[name] / 1e3, label=label)
right.set(xlabel="time [ms]", ylabel="force [kN]", xlim=(0, 1e3 * motion.times[-1]))
right.legend(loc="upper right")
for axes in (left, right):
    axes.grid(alpha=0.3)

# %%
# Checks
# ------
# Newton's second law for all moving parts together, with the rate of the momentum by differences of
# fourth order:

step = motion.times[1]
inner = slice(2, -2)


def rate(p):
    """Return the derivative at the inner times."""
    return (8 * (p[3:-1] - p[1:-3]) - (p[4:] - p[:-4])) / (12 * step)


push = 300.0 * (1.0 + np.cos(motion["q1"][inner]))
along = motion["main_x"][inner] - push - rate(motion["p_x"])
across = motion["main_y"][inner] + motion["thrust"][inner] - rate(motion["p_y"])
size = np.abs(motion["main_x"]).max()
error = max(np.abs(along).max(), np.abs(across).max()) / size
print(f"forces against the change of momentum: {error:.0e} of {size:.0f} N")
assert error < 1e-6

# %%
# The main bearing transmits no torque, and across the axis the wrist pin balances the wall.

idle = np.abs(motion["main_torque"]).max() / (size * CONSTANTS["a"])
balance = np.abs(motion["wrist_y"] + motion["thrust"]).max() / size
print(f"torque in the bearing: {idle:.0e}; wall against wrist pin: {balance:.0e}")
assert idle < 1e-9
assert balance < 1e-9

plt.show()
