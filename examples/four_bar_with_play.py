"""
Four-bar linkage with play in a joint
=====================================

The pin between the coupler and the rocker of a linkage has a bush that is wider by a tenth of a
millimetre.  The pin flies through the play, hits the bush, rebounds, slides along it with friction
and sticks.  `Clearance` is this contact: the joint holds no constraint, and `Contacts` finds when
the pin touches, slides and leaves.

The crank is spun up and released.  Energy falls by what friction and impacts take, and until the
pin has hit the bush the first times the motion is that of a stiff Hunt–Crossley contact.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import Clearance, Contacts, hunt_crossley
from pydy.mechanics import Definition
from pydy.viz import Line, Sphere, Visual

LENGTHS = {"a": 0.1, "b": 0.25, "c": 0.2, "base": 0.28}  # m: crank, coupler, rocker, base
MASSES = {"m1": 0.4, "m2": 0.3, "m3": 0.25}  # kg
PLAY, PIN, RATE = 1e-4, 5e-3, 12.0  # m, m, rad/s

# %%
# Three rods
# ----------
# The crank and the coupler are a chain of two, the rocker is another one.  Nothing connects them
# but the pin B in the bush C.

a, b, c, base, m1, m2, m3, mu, e, play = sm.symbols("a b c base m1 m2 m3 mu e play")
q1, q2, q3, u1, u2, u3 = me.dynamicsymbols("q1:4 u1:4")
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
bodies, speeds = [crank, coupler, rocker], [u1, u2, u3]

# %%
# The joint
# ---------

joint = Clearance(
    B, C, radius=PIN, play=play, axis=N.z, frames=(coupler.frame, rocker.frame),
    mu=mu, restitution=e, name="pin",
)  # fmt: skip

# %%
# The start
# ---------
# The pin begins in the middle of the bush, with its velocity.  These positions and rates follow
# from the triangles of the linkage.

start = np.array([0.5, 0.7, 1.8])
lengths = np.array([LENGTHS["a"], LENGTHS["b"], -LENGTHS["c"]])
for _ in range(20):  # Newton's method for the two angles
    gap = [lengths @ np.cos(start) - LENGTHS["base"], lengths @ np.sin(start)]
    slopes = np.array([-lengths * np.sin(start), lengths * np.cos(start)])
    start[1:] -= np.linalg.solve(slopes[:, 1:], gap)
rates = np.array([RATE, *np.linalg.solve(slopes[:, 1:], -slopes[:, 0] * RATE)])
initial = dict(zip([q1, q2, q3, *speeds], [*start, *rates], strict=True))

# %%
# Simulation
# ----------

end = 0.5
system = System(
    Definition(N, [q1, q2, q3], speeds, bodies=bodies, loads=[]),
    constants={**LENGTHS, **MASSES},
    ode_solver="dop853",
    initial_conditions=initial,
    times=np.linspace(0.0, end, num=1001),
)
contacts = Contacts(system, [joint], {mu: 0.1, e: 0.5, play: PLAY})
motion = contacts.simulate(rtol=1e-11, atol=1e-13)
names = [event.name for event in motion.events]
print({name: names.count(name) for name in dict.fromkeys(names)})
scene = system.scene(
    Visual(Line([O, A], radius=0.005, color="steelblue"), name="crank"),
    Visual(Line([A, B], radius=0.003, color="grey"), name="coupler"),
    Visual(Line([Q, C], radius=0.005, color="seagreen"), name="rocker"),
    Visual(Sphere(0.006, color="orangered"), B, name="pin", trail=True),
    origin=O,
    up="y",
    ground=False,
    series=speeds,
)
scene.animate(motion)

# %%
# The balance of energy
# ---------------------
# What the mechanism loses is the work of impacts and of friction, and the pin stays in the bush.

energy = motion.energy[:, 2]
missing = np.abs(energy - energy[0] - motion.contact_work).max() / energy[0]
print(f"energy: {energy[0]:.4f} J, then {energy[-1]:.4f} J; balance: {missing:.0e}")
assert missing < 1e-9
assert np.diff(energy).max() < 1e-9 * energy[0]
assert motion["pin_gap"].min() > -1e-6 * PLAY

# %%
# Beside a stiff contact
# ----------------------
# The same linkage with an elastic bush.  A pin that does not rebound and has no friction is that of
# a large damping; the difference falls with the depth to which the pin is pressed in.

gap, speed = joint.on.gap, sm.Symbol("rate")
offset = B.pos_from(C)
normal = offset / PLAY
rate = (B.vel(N) - C.vel(N)).dot(-normal)


def stiff(stiffness):
    """Return the motion with a Hunt–Crossley contact, at the same times."""
    force = hunt_crossley(gap.subs(play, PLAY), rate, stiffness, 1e3, 1)
    pressed = Definition(
        N, [q1, q2, q3], speeds, bodies=bodies, loads=[(B, -force * normal), (C, force * normal)]
    )
    alike = System(
        pressed, constants={**LENGTHS, **MASSES}, ode_solver="radau", initial_conditions=initial,
        times=system.times,
    )  # fmt: skip
    return alike.simulate(rtol=1e-9, atol=1e-12)


system.constants[mu], system.constants[e] = 0.0, 0.0
system.times = system.times[system.times <= 0.06]
exact = contacts.simulate(rtol=1e-11, atol=1e-13)
for stiffness in (1e6, 1e8):
    elastic = stiff(stiffness)
    rows = len(elastic.times)
    error = np.abs(elastic[q1] - exact[q1][:rows]).max()
    depth = -min(0.0, (PLAY - np.hypot(*(
        lengths @ np.cos(elastic[[q1, q2, q3]].T) - LENGTHS["base"],
        lengths @ np.sin(elastic[[q1, q2, q3]].T),
    ))).min())  # fmt: skip
    print(f"{stiffness:.0e} N/m: {depth:.0e} m deep, crank differs by {error:.0e} rad")
assert error < 3e-5

# %%
# Where the pin is in its bush, and what presses it:

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
angles = motion[[q1, q2, q3]].T
ex, ey = lengths @ np.cos(angles) - LENGTHS["base"], lengths @ np.sin(angles)
turn = np.linspace(0.0, 2.0 * np.pi, 200)
left.plot(1e3 * PLAY * np.cos(turn), 1e3 * PLAY * np.sin(turn), color="0.7")
left.plot(1e3 * ex, 1e3 * ey, color="tab:orange", linewidth=0.8)
left.set(aspect="equal", xlabel="x [mm]", ylabel="y [mm]", title="pin in the bush")
right.plot(motion.times, motion["pin_normal"], color="tab:blue")
right.set(xlabel="time [s]", ylabel="normal force [N]")
for axes in (left, right):
    axes.grid(alpha=0.3)

plt.show()
