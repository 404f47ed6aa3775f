"""
Brakes of a bicycle
===================

How hard may one brake?  Too weakly, and the way is long; on a wet road locked wheels skid; on a dry
one the rear wheel lifts off, and the rider goes over the handlebars.

Four contacts: each wheel on the ground with friction, and a brake in each wheel, whose pads press
with a known force.  All of them stick and slide as they have to: the brake slides and the wheel
rolls, or the brake holds the wheel and the tyre skids.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import Contacts, Stick, Unilateral
from pydy.mechanics import Definition
from pydy.solvers import Event
from pydy.viz import Arrow, Line, Sphere, Torus, Visual

# %%
# Equations
# ---------
# Seen from the side: a frame with its rider, which moves and pitches, and two wheels.

x, y, pitch, rear_angle, front_angle = me.dynamicsymbols("x y pitch theta_r theta_f")
vx, vy, omega, rear_rate, front_rate = me.dynamicsymbols("v_x v_y omega omega_r omega_f")
m, I, m_wheel, I_wheel, r, base, b, h, g = sm.symbols("m I m_w I_w r L b h g")
N, origin, A = me.ReferenceFrame("N"), me.Point("O"), me.ReferenceFrame("A")
origin.set_vel(N, 0)
A.orient_axis(N, N.z, pitch)
A.set_ang_vel(N, omega * N.z)
centre = origin.locatenew("C", x * N.x + y * N.y)
centre.set_vel(N, vx * N.x + vy * N.y)
rider = me.RigidBody("rider", centre, A, m, (me.inertia(A, 0, 0, I), centre))


def wheel(name, ahead, angle, rate):
    frame = me.ReferenceFrame(name)
    frame.orient_axis(N, N.z, angle)
    frame.set_ang_vel(N, rate * N.z)
    axle = centre.locatenew(f"{name} axle", ahead * A.x - (h - r) * A.y)
    axle.v2pt_theory(centre, N, A)
    return me.RigidBody(name, axle, frame, m_wheel, (me.inertia(frame, 0, 0, I_wheel), axle))


rear = wheel("rear", -b, rear_angle, rear_rate)
front = wheel("front", base - b, front_angle, front_rate)
bodies = [rider, rear, front]
definition = Definition(
    N,
    [x, y, pitch, rear_angle, front_angle],
    [vx, vy, omega, rear_rate, front_rate],
    bodies=bodies,
    loads=[(body.masscenter, -body.mass * g * N.y) for body in bodies],
)

# %%
# Contacts
# --------
# The pads of the front brake press with `squeeze` newtons on both sides of the rim, those of the
# rear brake with half of it.  A tyre that rolls holds a fifth better than one that skids.

mu_road, mu_pad, squeeze = sm.symbols("mu_road mu_pad squeeze")


def touches(body):
    height = body.masscenter.pos_from(origin).dot(N.y)
    road = Unilateral(height - r, restitution=0, name=f"{body.name} tyre")
    slip = body.masscenter.vel(N).dot(N.x) + r * body.frame.ang_vel_in(N).dot(N.z)
    return [road, Stick(slip, on=road, mu=mu_road, mu_static=1.2 * mu_road)]


def brake(body, force):
    rate = body.frame.ang_vel_in(N).dot(N.z) - omega
    return Stick(rate, mu=mu_pad, normal=2 * r * force, name=f"{body.name} brake")


SPEED, MASS, WHEEL, INERTIA, RADIUS, BASE, AHEAD, HEIGHT = (
    8.0,
    80.0,
    2.0,
    0.2,
    0.34,
    1.05,
    0.45,
    1.0,
)
system = System(
    definition,
    constants={
        m: MASS, I: 12.0, m_wheel: WHEEL, I_wheel: INERTIA, r: RADIUS, base: BASE, b: AHEAD,
        h: HEIGHT, g: 9.81,
    },
    initial_conditions={
        y: HEIGHT, vx: SPEED, rear_rate: -SPEED / RADIUS, front_rate: -SPEED / RADIUS
    },
    ode_solver="dop853",
    times=np.linspace(0.0, 4.0, num=401),
)  # fmt: skip
contacts = Contacts(
    system,
    [*touches(rear), *touches(front), brake(rear, squeeze / 2), brake(front, squeeze)],
    {mu_road: 0.9, mu_pad: 0.4, squeeze: 160.0},
)

# %%
# Three stops
# -----------
# On a dry road, gently: the tyres roll and the brakes slide until all stand still.  On a wet one
# the same brake would do; a stronger one locks the front wheel.  On a dry road, that one lifts the
# rear wheel.

gentle = contacts.simulate(rtol=1e-10, atol=1e-10)
system.constants.update({mu_road: 0.25, squeeze: 450.0})
skids = contacts.simulate(rtol=1e-10, atol=1e-10)
system.constants.update({mu_road: 0.9, squeeze: 700.0})
over = contacts.simulate(
    events=[Event(pitch + 0.7, terminal=True, name="over the handlebars")], rtol=1e-10, atol=1e-10
)
for title, motion in {"gently": gentle, "wet road": skids, "dry road, hard": over}.items():
    print(f"{title}: {motion[x][-1]:.3f} m")
    for event in motion.events:
        print(f"    {event.time:.4f} s  {event.name}")

# %%
# The hard stop, with the forces of the road by the names of their outputs.

shown = []
for body in (rear, front):
    foot = body.masscenter.locatenew(f"{body.name} foot", -r * N.y)
    normal, friction = (sm.Symbol(f"{body.name} tyre_{part}") for part in ("normal", "friction"))
    shown += [
        Visual(Torus(r - 0.02, 0.02, colour="dimgray"), body, name="wheels"),
        Visual(Line([body.masscenter, centre], 0.02, colour="crimson"), name="frame"),
        Visual(Arrow(normal * N.y + friction * N.x, scale=0.001, name="force of the road"), foot),
    ]
head = centre.locatenew("head", 0.45 * A.y + 0.1 * A.x)
shown += [
    Visual(Line([centre, head], 0.09, colour="steelblue"), name="rider"),
    Visual(Sphere(0.12, colour="steelblue"), head, name="rider"),
]
scene = system.scene(*shown, up="y", ground=0.0, series=[vx, pitch])
scene.animate(over)

# %%
# The way to stop
# ---------------
# Squeezes below the one that lifts the rear wheel, in one ensemble for each road.

system.times = np.linspace(0.0, 12.0, num=25)
squeezes = np.linspace(60.0, 480.0, num=43)
ways = {
    road: system.integrate_ensemble(
        contacts=contacts, constants={squeeze: squeezes, mu_road: grip}, rtol=1e-9, atol=1e-9
    )["x"][:, -1].values
    for road, grip in {"dry": 0.9, "wet": 0.25}.items()
}
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.5), layout="constrained")
for title, motion in {"gentle": gentle, "locked on a wet road": skids, "over": over}.items():
    left.plot(motion.times, motion[vx], label=title)
left.set(xlabel="time [s]", ylabel="speed [m/s]")
left.legend()
for road, way in ways.items():
    right.plot(squeezes, way, label=f"{road} road")
right.set(xlabel="force of the pads [N]", ylabel="way to stop [m]")
right.legend()

# %%
# Checks
# ------
# Closed forms.  While wheels roll, their inertia adds to the mass; a locked wheel slides with the
# load that braking shifts to it.

mass = MASS + 2 * WHEEL
rolling = INERTIA / RADIUS**2  # what a rolling wheel adds to the mass
press = 2 * 0.4  # of both pads, by the force on each
way = SPEED**2 * (mass + 2 * rolling) / (2 * press * 1.5 * 160.0)
assert abs(gentle[x][-1] - way) < 1e-8 * way

# Moments about the foot of the rear wheel, all locked: the front is pressed by mass g b/L and by
# what the height of the masses adds.
height = MASS * HEIGHT + 2 * WHEEL * RADIUS
ahead = MASS * AHEAD + WHEEL * BASE
pressed = 9.81 * (ahead + 0.25 * height) / BASE
locked = (skids.times > 1.0) & (skids.times < 3.0)
print(f"the locked front wheel is pressed by {pressed:.3f} N")
assert np.abs(skids["front tyre_normal"][locked] - pressed).max() < 1e-8 * pressed

for motion in (gentle, skids, over):
    energy = motion.energy[:, 2]
    assert np.abs(energy - energy[0] - motion.contact_work).max() < 1e-7 * energy[0]

# On the wet road the best squeeze is just below the one that locks the wheels.
best = int(ways["wet"].argmin())
least, last = ways["wet"][[best, -1]]
print(f"wet road: {least:.2f} m with {squeezes[best]:.0f} N, {last:.2f} m with locked wheels")
assert least < 0.9 * last

plt.show()
