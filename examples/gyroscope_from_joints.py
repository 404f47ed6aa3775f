"""
A gyroscope from joints
=======================

A fast wheel sits on one end of a rod, whose other end rests in a ball-and-socket joint.  Released
level, it does not fall: it nods, and rotates about the vertical.

We derive nothing by hand.  The bodies and joints of `sympy.physics.mechanics` go into a `System` of
SymPy, and that into `pydy.System`, which forms the equations of motion.  Gravity has no moment
about the vertical through the socket: the energy and the vertical component of the angular momentum
must be constant.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.viz import Cylinder, Line, Sphere, Visual

# %%
# Bodies
# ------
# The rod needs a moment of inertia about its own axis: otherwise its roll and the wheel's spin
# could not be told apart.

m, n, r, l, g = sm.symbols("m n r l g")
ground = me.RigidBody("ground")
rod = me.RigidBody("rod", mass=n)
wheel = me.RigidBody("wheel", mass=m)
rod.central_inertia = me.inertia(rod.frame, n * r**2 / 50, n * l**2 / 12, n * l**2 / 12)
wheel.central_inertia = me.inertia(wheel.frame, m * r**2 / 2, m * r**2 / 4, m * r**2 / 4)

# %%
# Joints
# ------
# The socket has three angles, about z, then y, then x: the heading, the dip and the roll of the
# rod. The axle lets the wheel turn about the rod.

heading, dip, roll, spin = me.dynamicsymbols("heading dip roll spin")
speeds = me.dynamicsymbols("u1:5")
socket = me.SphericalJoint(
    "socket",
    ground,
    rod,
    [heading, dip, roll],
    speeds[:3],
    child_point=-l / 2 * rod.x,
    rot_order="zyx",
)
axle = me.PinJoint(
    "axle", rod, wheel, spin, speeds[3], parent_point=l / 2 * rod.x, joint_axis=rod.x
)
top = me.System.from_newtonian(ground)
top.add_joints(socket, axle)
top.apply_uniform_gravity(-g * ground.z)

# %%
# Simulation
# ----------
# The rod starts level and at rest; only the wheel spins.

momentum = me.angular_momentum(ground.masscenter, ground.frame, rod, wheel).dot(ground.z)
system = System(
    top,
    constants={m: 1.0, n: 0.1, r: 0.1, l: 0.2, g: 9.81},
    initial_conditions={speeds[3]: 300.0},  # rad/s
    times=np.linspace(0.0, 2.0, num=2001),
    ode_solver="dop853",
    outputs={"momentum": momentum},
)
motion = system.simulate(rtol=1e-11, atol=1e-11)

# %%
# The trace of the rod's end shows nutation, the nodding, on top of precession.

base = ground.masscenter
scene = system.scene(
    Visual(Line([base, wheel.masscenter], radius=r / 15, color="grey"), name="rod"),
    Visual(Cylinder(r / 5, r, axis="x", color="steelblue", opacity=0.8), wheel, name="wheel"),
    Visual(Sphere(r / 10, color="orangered"), wheel.masscenter, name="end", trail=True),
    origin=base,
    up="z",
    series=[heading, dip],
)
scene.animate(motion)

# %%

angles = np.degrees(motion[[heading, dip]])
figure, axes = plt.subplots(figsize=(7, 3.5), layout="constrained")
axes.plot(angles[:, 0], -angles[:, 1])
axes.set(xlabel="heading [deg]", ylabel="height of the end [deg]")
axes.grid(alpha=0.3)

# %%
# Checks
# ------
# The two constants of the motion:

for name, values in (
    ("energy", motion.energy[:, 2]),
    ("vertical angular momentum", motion["momentum"]),
):
    change = np.ptp(values) / max(np.abs(values).max(), 1.0)
    print(f"{name}: largest change {change:.1e}")
    assert change < 1e-9

print(f"it dips by {angles[:, 1].max():.1f}°, and turns by {np.ptp(angles[:, 0]):.0f}°")
assert angles[:, 1].max() < 15.0

plt.show()
