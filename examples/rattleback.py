"""
Rattleback
==========

A rattleback is a boat-shaped stone that prefers one direction of spin.  Spun one way it turns
steadily.  Spun the other way it soon begins to rattle, stops, and reverses.  The cause is rolling
without slip, and a mass distribution that is skewed against the curvature of its underside.

This is the model of Kane and Levinson with their numbers ([1]_), without friction.  We check that
the spin reverses, that the energy is constant, and that a stone without skew keeps spinning.  Then
we ask how sensitive the moment of reversal is.

.. [1] T. R. Kane and D. A. Levinson, "Realistic mathematical modeling of the rattleback",
   International Journal of Non-Linear Mechanics 17 (1982) 175-186.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.solvers import Event
from pydy.viz import Mesh, Visual

# %%
# The contact
# -----------
# The underside is an ellipsoid with the semi-axes a, b, c.  Where its outer normal is ν in the
# body's axes, its surface lies at (a²ν₁, b²ν₂, c²ν₃)/√(a²ν₁² + b²ν₂² + c²ν₃²) from its centre; it
# touches the table where ν points straight down.  The mass centre lies h below the ellipsoid's
# centre.

a, b, c, h, m, g = sm.symbols("a b c h m g")
I_1, I_2, I_3, I_12 = sm.symbols("I_1 I_2 I_3 I_12")
alpha, beta, gamma = q = me.dynamicsymbols("alpha beta gamma")
w = me.dynamicsymbols("omega_1:4")

N, R = me.ReferenceFrame("N"), me.ReferenceFrame("R")
# Spin γ about the vertical first, then roll and pitch, both small.
R.orient_body_fixed(N, [gamma, alpha, beta], "ZXY")
turning = R.ang_vel_in(N)
spin = w[0] * R.x + w[1] * R.y + w[2] * R.z
R.set_ang_vel(N, spin)

up = [N.z.dot(axis) for axis in R]
root = sm.sqrt(sum(s**2 * n**2 for s, n in zip((a, b, c), up, strict=True)))
contact = h * R.z  # from the mass centre to the ellipsoid's centre, and on to the table
for size, n, axis in zip((a, b, c), up, R, strict=True):
    contact = contact - size**2 * n / root * axis

# %%
# Equations
# ---------
# Rolling gives the velocity of the mass centre from the angular velocity alone: v = −ω × p, with p
# from the mass centre to the contact.  Three speeds are enough, and no constraint is left.

G = me.Point("G")
G.set_vel(N, -spin.cross(contact))
inertia = me.inertia(R, I_1, I_2, I_3, I_12, 0, 0)
stone = me.RigidBody("stone", G, R, m, (inertia, G))
kinematics = [(turning - spin).dot(axis) for axis in R]
kane = me.KanesMethod(N, q, w, kinematics, kd_eqs_solver="CRAMER")
kane.kanes_equations([stone], [(G, -m * g * N.z)])

constants = {a: 0.2, b: 0.03, c: 0.02, h: 0.01, m: 1.0, g: 9.81}
constants |= {I_1: 2e-4, I_2: 1.6e-3, I_3: 1.7e-3, I_12: -2e-5}
energy = me.kinetic_energy(N, stone) - m * g * contact.dot(N.z)
system = System(
    kane,
    constants=constants,
    times=np.linspace(0.0, 60.0, num=6001),
    outputs={"energy": energy},
)

# %%
# Both directions
# ---------------
# Half a degree of roll is enough to start the rattle.


def run(rate):
    """Simulate from a spin; the energy must be constant."""
    system.initial_conditions = {alpha: np.radians(0.5), w[2]: rate}
    motion = system.simulate(rtol=1e-11, atol=1e-12, mxstep=5000)
    drift = np.abs(motion["energy"] / motion["energy"][0] - 1).max()
    print(f"spun with {rate:g} rad/s: energy changes by {drift:.0e} of itself")
    assert drift < 1e-7
    return motion


clockwise, anticlockwise = run(-5.0), run(5.0)
system.constants = {**constants, I_12: 0.0}
straight = run(-5.0)
system.constants = constants

assert clockwise[w[2]].max() > 0.5
assert anticlockwise[w[2]][anticlockwise.times < 10].min() > 4.5
assert np.abs(straight[w[2]] + 5.0).max() < 0.1

# %%
# The first seconds of the clockwise spin.  The stone is drawn as the lower half of its ellipsoid:

around, down = np.meshgrid(np.linspace(0.0, 2 * np.pi, 25), np.linspace(-np.pi / 2, 0.0, 9))
sphere = [np.cos(down) * np.cos(around), np.cos(down) * np.sin(around), np.sin(down)]
hull = np.stack(sphere, axis=-1).reshape(-1, 3) * [0.2, 0.03, 0.02] + [0.0, 0.0, 0.01]
shape = Visual(Mesh(hull, color="peru"), stone, name="stone")
scene = system.scene(shape, origin=G, up="z", series=[w[2], alpha, beta])
scene.animate(clockwise.at(clockwise.times[clockwise.times <= 12.0]))

# %%
# Without friction even the preferred direction ends after a while, by rolling from side to side
# instead of pitching, and the stone reverses again and again.  A real one has come to rest by then.

figure, (top, bottom) = plt.subplots(
    2, 1, figsize=(9, 5), sharex=True, layout="constrained", height_ratios=[1.4, 1]
)
for motion, name in (
    (clockwise, "clockwise"),
    (anticlockwise, "anticlockwise"),
    (straight, "clockwise, no skew"),
):
    top.plot(motion.times, motion[w[2]], label=name)
top.axhline(0, color="0.5", linewidth=0.8)
top.set(ylabel="spin [rad/s]", ylim=(-6, 8.5))
top.legend(loc="upper right", ncols=3, fontsize=9)
for angle, name, colour in ((alpha, "roll", "tab:cyan"), (beta, "pitch", "tab:purple")):
    bottom.plot(
        clockwise.times, np.degrees(clockwise[angle]), linewidth=0.5, color=colour, label=name
    )
bottom.set(ylabel="clockwise: rattle [deg]", xlabel="time [s]", xlim=(0, clockwise.times[-1]))
bottom.legend(loc="upper right", ncols=2, fontsize=9)
for axes in (top, bottom):
    axes.grid(alpha=0.3)

# %%
# When does it reverse?
# ---------------------
# The moment at which the spin passes zero is an event.  Its derivatives with respect to constants
# and initial conditions come with one simulation: the solver integrates the variational equations
# together with the motion.  Multiplied by tolerances they show which one matters most.

TOLERANCES = {"I_12": 2e-6, "h": 1e-4, "b": 1e-4, "alpha": np.radians(0.05), "omega_3": 0.1}
reversal = Event(w[2], direction=1, terminal=True, name="turns back")
accuracy = {"events": [reversal], "rtol": 1e-11, "atol": 1e-12}
system.ode_solver = "dop853"
system.initial_conditions = {alpha: np.radians(0.5), w[2]: -5.0}
system.times = np.linspace(0.0, 6.0, num=601)
motion = system.simulate(sensitivities=list(TOLERANCES), **accuracy)
event = motion.events[0]
derivatives = dict(zip(TOLERANCES, event.time_sensitivity, strict=True))
print(f"turns back after {event.time:.4f} s")
for name, tolerance in TOLERANCES.items():
    print(f"  {name} ± {tolerance:.1e}: ± {abs(derivatives[name]) * tolerance:.3f} s")

# %%
# The effect of one tolerance on the spin grows over time.

figure, (top, bottom) = plt.subplots(2, 1, figsize=(9, 5), sharex=True, layout="constrained")
top.plot(motion.times, motion["omega_3"], color="tab:blue")
top.axhline(0, color="0.5", linewidth=0.8)
top.set(ylabel="spin [rad/s]")
for name, tolerance in TOLERANCES.items():
    change = tolerance * motion.sensitivity["omega_3", name]
    bottom.plot(motion.times, np.abs(change), label=name)
bottom.set(ylabel="change of the spin\nby one tolerance [rad/s]", xlabel="time [s]")
bottom.set(yscale="log", ylim=(1e-6, None), xlim=(0, motion.times[-1]))
bottom.legend(ncols=5, fontsize=9)
for axes in (top, bottom):
    axes.grid(alpha=0.3)

# %%
# The exact derivatives agree with differences between simulations.


def moment(**changes):
    """Return when the stone turns back, with changed numbers."""
    skew, roll = changes.get("I_12", 0.0), changes.get("alpha", 0.0)
    system.constants = {**constants, I_12: constants[I_12] + skew}
    system.initial_conditions = {alpha: np.radians(0.5) + roll, w[2]: -5.0}
    return system.simulate(**accuracy).events[0].time


for name in ("I_12", "alpha"):
    change = 1e-3 * TOLERANCES[name]
    difference = (moment(**{name: change}) - moment(**{name: -change})) / (2 * change)
    print(f"by differences in {name}: {difference:.6g}, exactly {derivatives[name]:.6g}")
    assert abs(difference / derivatives[name] - 1.0) < 1e-4

plt.show()
