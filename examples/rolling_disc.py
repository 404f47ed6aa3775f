"""
Rolling disc
============

A coin that rolls on a table without slipping has two nonholonomic constraints: they restrict its
velocity and cannot be integrated to constraints on its position.  Rolling straight ahead, upright,
the coin is stable when it is fast enough.  A thin disc of radius r that spins with ω leans with the
eigenvalues ±√(4g/5r − 12ω²/5), which are imaginary above ω² = g/3r.

We compare the exact linear model with that formula.  Then a disc wobbles a little above the
critical speed, and its energy must be constant.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.linearize import constrained_eigenvalues
from pydy.viz import Box, Cylinder, Visual

RADIUS, GRAVITY = 0.3, 9.81  # m, m/s²
CRITICAL = np.sqrt(GRAVITY / (3 * RADIUS))  # rad/s

# %%
# Orientation
# -----------
# The disc rotates in three steps: yaw ψ about the vertical z, lean φ about the heading x, roll θ
# about the axle y.  The speeds are the lean rate, the spin and the turning rate along the disc's
# own axes, and the velocity of the point of contact on the table.

m, r, g = sm.symbols("m r g")
psi, phi, theta, x, y = me.dynamicsymbols("psi phi theta x y")
lean, spin, turn, v_x, v_y = me.dynamicsymbols("u_lean u_spin u_turn v_x v_y")
t = me.dynamicsymbols._t

N, A, B, D = (me.ReferenceFrame(name) for name in "NABD")
A.orient_axis(N, N.z, psi)
B.orient_axis(A, A.x, phi)
D.orient_axis(B, B.y, theta)
# B leans and turns with the disc but does not roll with it.
B.set_ang_vel(N, lean * B.x + turn * sm.tan(phi) * B.y + turn * B.z)
disc_spin = lean * B.x + spin * B.y + turn * B.z
D.set_ang_vel(N, disc_spin)

# %%
# Rolling
# -------
# The material point at the contact is at rest, which determines the velocity of the centre from the
# spin.  The disc is axisymmetric, so its inertia is constant in the frame that does not roll.

origin, contact, centre = me.Point("O"), me.Point("P"), me.Point("C")
origin.set_vel(N, 0)
contact.set_pos(origin, x * N.x + y * N.y)
contact.set_vel(N, v_x * N.x + v_y * N.y)
centre.set_pos(contact, r * B.z)
centre.set_vel(N, contact.vel(N) + B.ang_vel_in(N).cross(r * B.z))
inertia = me.inertia(B, m * r**2 / 4, m * r**2 / 2, m * r**2 / 4)
disc = me.RigidBody("disc", centre, D, m, (inertia, centre))

slip = centre.vel(N) - disc_spin.cross(r * B.z)
kane = me.KanesMethod(
    N,
    q_ind=[psi, phi, theta, x, y],
    u_ind=[lean, spin, turn],
    u_dependent=[v_x, v_y],
    kd_eqs=[
        psi.diff(t) - turn / sm.cos(phi),
        phi.diff(t) - lean,
        theta.diff(t) - spin + turn * sm.tan(phi),
        x.diff(t) - v_x,
        y.diff(t) - v_y,
    ],
    velocity_constraints=[slip.dot(N.x), slip.dot(N.y)],
)
kane.kanes_equations([disc], [(centre, -m * g * N.z)])
system = System(
    kane,
    constants={m: 1.0, r: RADIUS, g: GRAVITY},
    times=np.linspace(0.0, 8.0, num=1601),
    outputs={"energy": me.kinetic_energy(N, disc) + m * g * r * sm.cos(phi)},
)

# %%
# Stability
# ---------
# Rolling straight ahead is a steady motion at every spin.  The Jacobians of the equations and of
# the constraints give the eigenvalues of the motions that the constraints allow.


def eigenvalues(rate):
    """Return the eigenvalues of rolling straight ahead."""
    system.initial_conditions = {spin: rate}
    system.set_dependent_initial_conditions()
    return constrained_eigenvalues(
        system.evaluate_jacobian(), system.evaluate_jacobian(of="velocity")
    )


rates = np.linspace(0.0, 2.0, num=81) * CRITICAL
found = np.array([eigenvalues(rate) for rate in rates])
squares = 4 * GRAVITY / (5 * RADIUS) - 12 * rates**2 / 5

figure, axes = plt.subplots(figsize=(7, 3.8), layout="constrained")
for part, colour, name in ((np.real, "tab:red", "real"), (np.imag, "tab:blue", "imaginary")):
    axes.plot(rates / CRITICAL, part(found), ".", color=colour, markersize=3)
    for sign in (1, -1):
        values = part(sign * np.sqrt(squares.astype(complex)))
        label = f"{name} part" if sign == 1 else None
        axes.plot(rates / CRITICAL, values, color=colour, alpha=0.4, label=label)
axes.axvline(1, color="0.6", linestyle=":")
axes.set(xlabel="spin over critical spin", ylabel="eigenvalue [1/s]", xlim=(0, 2))
axes.legend(loc="upper center")
axes.grid(alpha=0.3)

# %%
# At the critical spin two eigenvalues meet, which makes both uncertain to the root of a rounding
# error.

largest = found[np.arange(len(rates)), np.abs(found).argmax(axis=1)]
error = np.abs(largest**2 - squares).max() / squares[0]
print(f"squares of the eigenvalues against the formula, relative error: {error:.0e}")
assert error < 1e-6

# %%
# A wobbling disc
# ---------------
# 15 % above the critical spin, with an initial lean.  `set_dependent_initial_conditions` finds the
# velocity of the contact.

system.initial_conditions = {spin: 1.15 * CRITICAL, phi: 0.1, lean: 0.5}
system.set_dependent_initial_conditions()
motion = system.simulate(rtol=1e-11, atol=1e-11)
scene = system.scene(
    Visual(Cylinder(r / 20, r, color="steelblue", opacity=0.8), disc, name="disc"),
    Visual(Box(2 * r, r / 15, r / 10, color="orangered"), disc, name="spoke"),
    origin=origin,
    up="z",
    series=[phi, spin],
)
scene.animate(motion)

# %%
# The track on the table, and the disc from above, drawn as an ellipse:

figure, axes = plt.subplots(figsize=(7, 3.8), layout="constrained")
px, py, heading, tilt = (motion[s] for s in (x, y, psi, phi))
axes.plot(px, py, color="tab:orange", label="contact on the table")
around = np.linspace(0.0, 2 * np.pi)
for k in range(0, len(px), len(px) // 40):
    ahead, aside = RADIUS * np.cos(around), RADIUS * np.sin(tilt[k]) * (1 + np.sin(around))
    ex = px[k] + ahead * np.cos(heading[k]) + aside * np.sin(heading[k])
    ey = py[k] + ahead * np.sin(heading[k]) - aside * np.cos(heading[k])
    axes.plot(ex, ey, color="0.6", linewidth=0.7, zorder=0)
axes.set(aspect="equal", xlabel="x [m]", ylabel="y [m]")
axes.legend(loc="best")
axes.grid(alpha=0.3)

# %%
# Constraint forces do no work, so the energy is constant; and the disc does not slip.

energy = motion["energy"]
drift = np.abs(energy / energy[0] - 1).max()
print(f"energy: {energy[0]:.4f} J, relative change: {drift:.0e}")
assert drift < 1e-8
slipped = np.abs(system.evaluate_velocity_constraints(x=motion.states)).max()
print(f"slip: {slipped:.0e} m/s at most")
assert slipped < 1e-8

plt.show()
