"""
A gyroscope from joints
=======================

A fast wheel on one end of a rod, whose other end rests in a ball-and-socket joint.  Let go level,
it does not fall: it nods, and turns about the vertical.

Nothing is derived here.  The bodies and joints of `sympy.physics.mechanics` go into a `System` of
SymPy, and that into ours, which forms the equations of motion.  Gravity does no work on a turn
about the vertical, and pulls through that axis: energy and the vertical part of the angular
momentum must not change.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.system import System

# %%
# Bodies and joints
# -----------------
# The socket has three angles, about z, then y, then x: the heading, the dip and the roll of the
# rod.  That needs an inertia about its own axis, or nothing would tell its roll from the spin.


def build():
    """Return the System, and the angular momentum about the vertical through the socket."""
    m, n, r, l, g = sm.symbols("m n r l g")
    ground, rod, wheel = (
        me.RigidBody("ground"),
        me.RigidBody("rod", mass=n),
        me.RigidBody("wheel", mass=m),
    )
    rod.central_inertia = me.inertia(rod.frame, n * r**2 / 50, n * l**2 / 12, n * l**2 / 12)
    wheel.central_inertia = me.inertia(wheel.frame, m * r**2 / 2, m * r**2 / 4, m * r**2 / 4)
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
    momentum = me.angular_momentum(ground.masscenter, ground.frame, rod, wheel).dot(ground.z)
    constants = {m: 1.0, n: 0.1, r: 0.1, l: 0.2, g: 9.81}
    start = {speeds[3]: 300.0}  # rad/s; level, and at rest but for the wheel
    return System(top, constants, initial_conditions=start), momentum


def main(small=False):
    """Let the gyroscope go, check what must not change, draw where its end goes."""
    system, momentum = build()
    system.times = np.linspace(0.0, 0.2 if small else 2.0, num=201 if small else 2001)
    system.ode_solver = "dop853"
    system.outputs = {"momentum": momentum}
    motion = system.simulate(rtol=1e-11, atol=1e-11)

    energy = system.evaluate_energy(motion.states, motion.times).total
    for name, values in (("energy", energy), ("vertical angular momentum", motion["momentum"])):
        change = np.ptp(values) / max(np.abs(values).max(), 1.0)
        print(f"{name}: largest change {change:.1e}")
        assert change < 1e-9

    heading, dip = np.degrees(motion["heading"]), np.degrees(motion["dip"])
    print(f"it dips by {dip.max():.1f} degrees, and turns by {heading[-1] - heading[0]:.0f}")
    assert dip.max() < 15.0

    _, axes = plt.subplots(figsize=(7, 3.5))
    axes.plot(heading, -dip)
    axes.set(xlabel="heading (°)", ylabel="height of the end (°)", title="Nodding and turning")
    axes.grid(alpha=0.3)
    plt.show()


if __name__ == "__main__":
    main(small="--small" in sys.argv)
