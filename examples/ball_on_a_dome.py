"""
Ball rolling off a dome
=======================

A ball rests on top of a dome and is nudged.  How long does it stay on?  A textbook answer: while it
rolls, the dome pushes with N = m g (17 cos θ − 10)/7, so that a ball that starts from rest leaves
where cos θ = 10/17, at 54°; the friction that makes it roll is F = (2/7) m g sin θ.

Neither force does work, so neither is in the equations of motion.  Two fictitious speeds of the
contact, one along the normal and one along the surface, bring them into evidence, and `System`
computes them with the accelerations.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.system import System

MASS, BALL, DOME, GRAVITY = 0.2, 0.05, 1.0, 9.81

# %%
# Equations
# ---------
# The line from the dome's centre to the ball's turns with u = θ'.  The ball's spin follows from
# rolling: where it touches the dome it stands still, but for the fictitious speeds.


def derive():
    """Return the KanesMethod, values of its constants, and the names of the two forces."""
    m, r, R, g = sm.symbols("m r R g")
    theta, u, u_normal, u_along = me.dynamicsymbols("theta u u_normal u_along")
    normal, friction = me.dynamicsymbols("N F")
    t = me.dynamicsymbols._t

    W = me.ReferenceFrame("W")
    arm = W.orientnew("A", "Axis", (-theta, W.z))  # arm.y points from dome to ball
    arm.set_ang_vel(W, -u * W.z)
    top, contact, centre = me.Point("O"), me.Point("P"), me.Point("C")
    top.set_vel(W, 0)
    contact.set_pos(top, R * arm.y - R * W.y)
    slip = u_normal * arm.y + u_along * arm.x
    contact.set_vel(W, slip)
    centre.set_pos(contact, r * arm.y)
    centre.set_vel(W, (R + r) * u * arm.x + slip)
    ball = W.orientnew("B", "Axis", (-(R + r) / r * theta, W.z))
    ball.set_ang_vel(W, -(R + r) / r * u * W.z)
    inertia = me.inertia(arm, *[sm.Rational(2, 5) * m * r**2] * 3)
    body = me.RigidBody("ball", centre, ball, m, (inertia, centre))

    kane = me.KanesMethod(W, [theta], [u], [theta.diff(t) - u], u_auxiliary=[u_normal, u_along])
    loads = [(centre, -m * g * W.y), (contact, normal * arm.y + friction * arm.x)]
    kane.kanes_equations([body], loads)
    return kane, {m: MASS, r: BALL, R: DOME, g: GRAVITY}, [normal, friction]


# %%
# Simulation
# ----------
# The forces depend on accelerations.  They are therefore solved for together with them, and their
# time integrals, the impulses that the dome has given the ball, are further states.


def main(small=False):
    """Let the ball roll, compare the forces with the textbook, draw."""
    kane, constants, forces = derive()
    system = System(
        kane,
        constants=constants,
        noncontributing_forces=forces,
        initial_conditions={kane.q[0]: 1e-3},
        times=np.linspace(0.0, 3.1, num=156 if small else 1551),
    )
    print("states:", system.states)
    x = system.integrate(rtol=1e-11, atol=1e-13)
    normal, friction = system.evaluate_outputs(x=x).T
    angle = x[:, 0]
    on = angle < 1.2  # a little beyond the point where a real ball would fly off

    weight = MASS * GRAVITY
    expected = weight * (17 * np.cos(angle) - 10 * np.cos(angle[0])) / 7
    error = np.abs(normal - expected)[on].max() / weight
    print(f"normal force against the textbook: {error:.0e} of the weight")
    assert error < 1e-8
    error = np.abs(friction + 2 / 7 * weight * np.sin(angle))[on].max() / weight
    print(f"friction against the textbook: {error:.0e} of the weight")
    assert error < 1e-8

    leaves = np.degrees(np.interp(0.0, -normal[on], angle[on]))
    textbook = np.degrees(np.arccos(10 / 17))
    print(f"the ball leaves at {leaves:.3f}°, textbook {textbook:.3f}°")
    assert abs(leaves - textbook) < (0.5 if small else 0.01)
    draw(angle[on], normal[on] / weight, friction[on] / weight, textbook)


def draw(angle, normal, friction, leaves):
    """The forces over the angle, and the ball on the dome."""
    _, (left, right) = plt.subplots(
        1, 2, figsize=(9, 3.8), layout="constrained", width_ratios=[1, 1.4]
    )
    turn = np.linspace(0.0, np.pi / 2)
    left.fill([*np.sin(turn), 0], [*np.cos(turn), 0], color="0.85", edgecolor="0.5")
    for degrees in (0, 15, 30, 45, leaves):
        a, reach = np.radians(degrees), DOME + BALL
        centre = (reach * np.sin(a), reach * np.cos(a))
        left.add_patch(plt.Circle(centre, BALL, color="tab:orange", alpha=0.9))
    left.annotate("leaves", centre, (centre[0] + 0.12, centre[1] + 0.12))
    left.set(aspect="equal", xlim=(-0.06, 1.3), ylim=(0, 1.2))
    left.axis("off")

    right.plot(np.degrees(angle), normal, label="normal force")
    right.plot(np.degrees(angle), -friction, label="friction, backwards")
    right.axvline(leaves, color="0.5", linestyle=":", label=f"cos θ = 10/17: {leaves:.1f}°")
    right.axhline(0, color="0.5", linewidth=0.8)
    right.set(xlabel="angle on the dome [deg]", ylabel="force over weight")
    right.grid(alpha=0.3)
    right.legend()


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
