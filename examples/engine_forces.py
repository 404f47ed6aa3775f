"""
Forces in an engine
===================

A crank, a connecting rod and a piston: what turns in every car shakes its frame.  The piston is
held in its cylinder by a constraint, whose multiplier is the side thrust on the wall; what the main
bearing carries is the reaction of a joint.  Neither needs a speed of its own.

The sum of all forces on the engine must be the change of its momentum, which we take from the
trajectory by differences; and along the cylinder the wall must push across only.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.system import System

# %%
# Equations
# ---------
# Crank and rod are measured from the cylinder's axis N.x.  That the wrist pin stays on the axis
# closes the loop: one equation, whose gradient is a unit vector, so that its multiplier is a force
# in newtons, on the piston along N.y.

CONSTANTS = {"a": 0.04, "b": 0.14, "m1": 2.0, "m2": 0.6, "m3": 0.5}  # m, kg


def derive():
    """Return the KanesMethod, the engine's frame, its joints, and its momentum."""
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
    bodies = [
        me.RigidBody(
            "crank", crank_centre, A, m1, (me.inertia(A, 0, 0, m1 * a**2 / 2), crank_centre)
        ),
        me.RigidBody("rod", rod_centre, B, m2, (me.inertia(B, 0, 0, m2 * b**2 / 12), rod_centre)),
        me.Particle("piston", wrist_pin, m3),
    ]
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
    momentum = sum((body.mass * body.masscenter.pos_from(O).dt(N) for body in bodies), me.Vector(0))
    return kane, N, (O, crank_pin, wrist_pin), momentum


# %%
# Forces
# ------
# The main bearing holds crank, rod and piston; so does the wall, which therefore is among the loads
# of that cut.  The crank pin holds rod and piston, the wrist pin the piston alone.


def forces(system, N, joints):
    """Return the outputs: forces on the moving parts, and the torque about the main bearing."""
    crank, rod, piston = system.eom_method.bodies
    bearing, crank_pin, wrist_pin = joints
    thrust = system.constraint_forces["lambda0"]
    wall = [(wrist_pin, thrust * N.y)]
    main = system.reaction([crank, rod, piston], bearing, loads=wall)
    pin = system.reaction([rod, piston], crank_pin, loads=wall)
    wrist = system.reaction(piston, wrist_pin, loads=wall)
    return {
        "thrust": thrust,
        "main_x": main.force.dot(N.x),
        "main_y": main.force.dot(N.y),
        "main_torque": main.torque.dot(N.z),
        "pin": pin.force.magnitude(),
        "wrist_x": wrist.force.dot(N.x),
        "wrist_y": wrist.force.dot(N.y),
    }


# %%
# Simulation
# ----------
# The gas pushes as long as the piston moves outwards.  The rod is a two-force member but for its
# own mass: at the wrist pin the force is the piston's inertia and the gas along the axis, and the
# wall's thrust across it.


def main(small=False):
    """Simulate a few turns, compare the forces with the change of momentum, draw."""
    kane, N, joints, momentum = derive()
    (q1, q2), (u1, _) = kane.q, kane.u
    gas = me.dynamicsymbols("gas")
    system = System(
        kane,
        constants=CONSTANTS,
        specifieds={gas: 300.0 * (1.0 + sm.cos(q1))},
        initial_conditions={q1: 0.3, q2: 0.0, u1: 200.0},
        times=np.linspace(0.0, 0.01 if small else 0.1, num=1001 if small else 10001),
        ode_solver="dop853",
    )
    system.set_dependent_initial_conditions(use_jac=True)
    system.outputs = {
        **forces(system, N, joints),
        "p_x": momentum.dot(N.x),
        "p_y": momentum.dot(N.y),
    }
    run = system.simulate(constraints="project", rtol=1e-11, atol=1e-11)

    step = run.times[1]

    def rate(p):  # of fourth order, at the inner times
        return (8 * (p[3:-1] - p[1:-3]) - (p[4:] - p[:-4])) / (12 * step)

    inner = slice(2, -2)
    push = 300.0 * (1.0 + np.cos(run["q1"][inner]))
    along = run["main_x"][inner] - push - rate(run["p_x"])
    across = run["main_y"][inner] + run["thrust"][inner] - rate(run["p_y"])
    size = np.abs(run["main_x"]).max()
    error = max(np.abs(along).max(), np.abs(across).max()) / size
    print(f"forces against the change of momentum: {error:.0e} of {size:.0f} N")
    assert error < 1e-6
    idle = np.abs(run["main_torque"]).max() / (size * CONSTANTS["a"])
    wall = np.abs(run["wrist_y"] + run["thrust"]).max() / size
    print(f"torque in the bearing: {idle:.0e}; wall against wrist pin: {wall:.0e}")
    assert idle < 1e-9
    assert wall < 1e-9
    draw(run)


def draw(run):
    """The path of the main bearing's force, and forces over time."""
    _, (left, right) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
    left.plot(-run["main_x"] / 1e3, -run["main_y"] / 1e3, color="tab:blue", linewidth=0.8)
    left.set(aspect="equal", xlabel="along the cylinder [kN]", ylabel="across [kN]")
    left.set_title("force on the main bearing")
    for name, label in (("pin", "crank pin"), ("thrust", "wall on piston")):
        right.plot(1e3 * run.times, run[name] / 1e3, label=label)
    right.set(xlabel="time [ms]", ylabel="force [kN]", xlim=(0, 1e3 * run.times[-1]))
    right.legend(loc="upper right")
    for axes in (left, right):
        axes.grid(alpha=0.3)


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
