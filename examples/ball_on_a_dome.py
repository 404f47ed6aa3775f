"""
Ball rolling off a dome
=======================

A ball rests on top of a dome and is nudged.  Where does it leave the surface?

While the ball rolls, the dome pushes with N = m g (17 cos θ − 10)/7.  A ball that starts from rest
therefore leaves where cos θ = 10/17, at 54°.  The friction that makes it roll is
F = (2/7) m g sin θ.

Neither force does work, so neither appears in the equations of motion.  We introduce two auxiliary
speeds of the contact, one along the normal and one along the surface.  They expose the two forces,
and `System` computes them together with the accelerations.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.viz import Arrow, Sphere, Visual

MASS, BALL, DOME, GRAVITY = 0.2, 0.05, 1.0, 9.81  # kg, m, m, m/s²

# %%
# The geometry
# ------------
# The line from the dome's centre to the ball's centre rotates with u = θ'.  W is the world, `arm`
# the frame whose y axis points from dome to ball.

m, r, R, g = sm.symbols("m r R g")
theta, u, u_normal, u_along = me.dynamicsymbols("theta u u_normal u_along")
normal, friction = me.dynamicsymbols("N F")
t = me.dynamicsymbols._t

W = me.ReferenceFrame("W")
arm = W.orientnew("A", "Axis", (-theta, W.z))
arm.set_ang_vel(W, -u * W.z)
top, contact, centre = me.Point("O"), me.Point("P"), me.Point("C")
top.set_vel(W, 0)
contact.set_pos(top, R * arm.y - R * W.y)
centre.set_pos(contact, r * arm.y)

# %%
# Rolling gives the spin of the ball: the material point at the contact is at rest.  The auxiliary
# speeds are added to the velocities of the contact and of the centre.

slip = u_normal * arm.y + u_along * arm.x
contact.set_vel(W, slip)
centre.set_vel(W, (R + r) * u * arm.x + slip)
ball_frame = W.orientnew("B", "Axis", (-(R + r) / r * theta, W.z))
ball_frame.set_ang_vel(W, -(R + r) / r * u * W.z)
inertia = me.inertia(arm, *[sm.Rational(2, 5) * m * r**2] * 3)
ball = me.RigidBody("ball", centre, ball_frame, m, (inertia, centre))

kane = me.KanesMethod(W, [theta], [u], [theta.diff(t) - u], u_auxiliary=[u_normal, u_along])
kane.kanes_equations([ball], [(centre, -m * g * W.y), (contact, normal * arm.y + friction * arm.x)])

# %%
# Simulation
# ----------
# The two forces depend on the accelerations, so both are solved for together.  Their time
# integrals, the impulses on the ball, are further states.

system = System(
    kane,
    constants={m: MASS, r: BALL, R: DOME, g: GRAVITY},
    noncontributing_forces=[normal, friction],
    initial_conditions={theta: 1e-3},
    times=np.linspace(0.0, 3.1, num=1551),
)
print("states:", system.states)
motion = system.simulate(rtol=1e-11, atol=1e-13)

# %%
# The arrow is the normal force on the ball.  It vanishes where a real ball would take off; in the
# model it keeps rolling.

scene = system.scene(
    Visual(Sphere(R, color="lightgrey"), top.locatenew("dome", -R * W.y), name="dome"),
    Visual(Sphere(r, color="orangered"), ball, name="ball", trail=True),
    Visual(Arrow(normal * arm.y, scale=0.15), contact, name="normal force"),
    reference_frame=W,
    origin=top,
    up="y",
    ground=False,
    series=["N", "F"],
)
angle = motion[theta]
on = angle < 1.2  # a little beyond the point of take-off
scene.animate(motion.at(motion.times[on]))

# %%
# Forces against the textbook
# ---------------------------

weight = MASS * GRAVITY
push, drag = motion[normal] / weight, motion[friction] / weight
leaves = np.degrees(np.arccos(10 / 17))

figure, (left, right) = plt.subplots(
    1, 2, figsize=(9, 3.8), layout="constrained", width_ratios=[1, 1.4]
)
turn = np.linspace(0.0, np.pi / 2)
left.fill([*np.sin(turn), 0], [*np.cos(turn), 0], color="0.85", edgecolor="0.5")
for degrees in (0, 15, 30, 45, leaves):
    a, reach = np.radians(degrees), DOME + BALL
    place = (reach * np.sin(a), reach * np.cos(a))
    left.add_patch(plt.Circle(place, BALL, color="tab:orange", alpha=0.9))
left.annotate("leaves", place, (place[0] + 0.12, place[1] + 0.12))
left.set(aspect="equal", xlim=(-0.06, 1.3), ylim=(0, 1.2))
left.axis("off")
right.plot(np.degrees(angle[on]), push[on], label="normal force")
right.plot(np.degrees(angle[on]), -drag[on], label="friction, backwards")
right.axvline(leaves, color="0.5", linestyle=":", label=f"cos θ = 10/17: {leaves:.1f}°")
right.axhline(0, color="0.5", linewidth=0.8)
right.set(xlabel="angle on the dome [deg]", ylabel="force over weight")
right.grid(alpha=0.3)
right.legend()

# %%
# Both forces equal the textbook's to eight digits, and the normal force vanishes at the right
# angle.

expected = (17 * np.cos(angle) - 10 * np.cos(angle[0])) / 7
error = np.abs(push - expected)[on].max()
print(f"normal force against the textbook: {error:.0e} of the weight")
assert error < 1e-8
error = np.abs(drag + 2 / 7 * np.sin(angle))[on].max()
print(f"friction against the textbook: {error:.0e} of the weight")
assert error < 1e-8
found = np.degrees(np.interp(0.0, -push[on], angle[on]))
print(f"the ball leaves at {found:.3f}°, textbook {leaves:.3f}°")
assert abs(found - leaves) < 0.01

plt.show()
