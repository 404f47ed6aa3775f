"""
A standing jump: phases with equations of their own
===================================================

Who jumps from a stand pushes off, flies, and catches the landing.  Each phase has equations of its
own: on the ground the leg pushes the body away from the foot, in the air it cannot.  Where one
phase ends and how long each takes is for the optimisation to find.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.control import OptimalControl
from pydy.mechanics import Definition
from pydy.solvers import dop853
from pydy.viz import Line, Scene, Sphere, Visual

MASS, G = 70.0, 9.81  # kg, m/s²
LEG, STRETCHED, CROUCHED = 0.95, 1.0, 0.5  # m: how long the leg is in standing, and its limits
STRONGEST, ANKLE = 2500.0, 120.0  # N along the leg, N m about the foot
FRICTION = 0.6

# %%
# Three phases, two models
# ------------------------
# The body is a point.  On the ground its place is the length of the leg and its lean, and the
# muscles are a force along the leg and a small torque at the ankle.

length, lean, stretching, leaning = me.dynamicsymbols("length lean stretching leaning")
push, ankle = me.dynamicsymbols("push ankle")
t = me.dynamicsymbols._t
ground, foot = me.ReferenceFrame("N"), me.Point("foot")
foot.set_vel(ground, 0)
leg = me.ReferenceFrame("leg")
leg.orient_axis(ground, -lean, ground.z)
standing_body = foot.locatenew("standing body", length * leg.y)
weight = -MASS * G * ground.y
standing = System(
    Definition(
        ground,
        [length, lean],
        [stretching, leaning],
        bodies=[me.Particle("body", standing_body, MASS)],
        loads=[(standing_body, weight + push * leg.y + ankle / length * leg.x)],
    )
)

# %%
# In the air it is its place from the foot that pushed off, and there is nothing to choose.

x, y, vx, vy = me.dynamicsymbols("x y vx vy")
flying_body = foot.locatenew("flying body", x * ground.x + y * ground.y)
flying = System(
    Definition(
        ground,
        [x, y],
        [vx, vy],
        bodies=[me.Particle("body", flying_body, MASS)],
        loads=[(flying_body, weight)],
    )
)

# %%
# The least effort
# ----------------
# Each phase begins where the one before ended: links say how its states follow.  The next foot
# stands as far away as the jump is to be long.  It pushes, never pulls, which are bounds, and it
# must not slip.

takes = sm.symbols("pushing flight landing", positive=True)
effort = sm.Integral(push**2 + (10 * ankle) ** 2, t) / (MASS * G) ** 2
along = push * sm.sin(lean) + ankle / length * sm.cos(lean)
across_ground = push * sm.cos(lean) - ankle / length * sm.sin(lean)
grip = [along <= FRICTION * across_ground, -along <= FRICTION * across_ground]
limits = {length: (CROUCHED, STRETCHED), push: (0.0, STRONGEST), ankle: (-ANKLE, ANKLE)}
stand = {length: LEG, lean: 0.0, stretching: 0.0, leaning: 0.0}
across = {x: length * sm.sin(lean), y: length * sm.cos(lean)}
rates = {stretching: length.diff(t), leaning: lean.diff(t)}
to_air = dict(across)
for speed, place in ((vx, x), (vy, y)):
    to_air[speed] = across[place].diff(t).subs({rate: u for u, rate in rates.items()})


def to_ground(distance):
    """Return the length and lean of a leg that stands so far ahead, and their rates."""
    ahead = x - distance
    far = sm.sqrt(ahead**2 + y**2)
    return {
        length: far,
        lean: sm.atan2(ahead, y),
        stretching: (ahead * vx + y * vy) / far,
        leaning: (vx * y - vy * ahead) / far**2,
    }


def jump(distance, guess=None):
    """Return the phases of the jump with the least effort."""
    first, last = (
        OptimalControl(standing, effort, duration, path=grip, mesh=15, **ends,
                       bounds={**limits, duration: (0.2, 1.5)})
        for duration, ends in (
            (takes[0], {"start": stand}),
            (takes[2], {"start": dict.fromkeys(standing.states), "end": stand}),
        )
    )  # fmt: skip
    air = OptimalControl(
        flying,
        sm.Integer(0),
        takes[1],
        start=dict.fromkeys(flying.states),
        bounds={takes[1]: (0.05, 1.0)},
        mesh=2,
    )
    phases = OptimalControl.phases([first, air, last], [to_air, to_ground(distance)])
    return phases.solve(guess)


# %%
# The search begins at a rough idea of each phase: lean and push, fly, catch.

roughly = [
    {push: MASS * G, lean: [0.0, 0.5], takes[0]: 0.6},
    {x: [0.4, 0.7], y: 0.9, vx: 1.5, vy: [1.0, -1.0], takes[1]: 0.2},
    {push: MASS * G, lean: [-0.4, 0.0], takes[2]: 0.6},
]
found = jump(1.6, roughly)
pushing, flight, landing = found
print(found)
for name, phase in zip(("pushing", "flight", "landing"), found, strict=True):
    print(f"{name:8} {phase.duration:.3f} s")

# %%
# In the air there is gravity alone, so that the flight is known: a parabola from the take-off.

take_off = {s: flight[s][0] for s in (x, y, vx, vy)}
T = flight.duration
lands = take_off[x] + take_off[vx] * T, take_off[y] + take_off[vy] * T - G * T**2 / 2
assert np.allclose(lands, (flight[x][-1], flight[y][-1]), rtol=1e-8)

# %%
# Both stands are alike, and so the best jump is its own mirror image, backwards in time.

assert abs(landing.duration - pushing.duration) < 1e-3
assert abs(landing[lean][0] + pushing[lean][-1]) < 1e-3

# %%
# Farther
# -------
# Short distances are a long step; farther away the flight takes over.  Each search begins at the
# motion before.

distances = [1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0]
jumps, last = [], found
for distance in distances:
    last = jump(distance, list(last))
    jumps.append(last)
airborne = [one[1].duration for one in jumps]
assert (np.diff(airborne) >= -1e-9).all()
figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.5), layout="constrained")
left.plot(distances, airborne, "o-")
left.set(xlabel="distance [m]", ylabel="flight [s]")
for colour, k in (("C0", 0), ("C1", -1)):
    first, air, last = jumps[k]
    right.plot(first.times, first[push] / (MASS * G), colour, label=f"{distances[k]} m")
    caught = last.times + first.duration + air.duration
    right.plot(caught, last[push] / (MASS * G), colour)
right.legend()
right.set(xlabel="time [s]", ylabel="force along the leg / weight")

# %%
# Is it true?
# -----------
# Simulated with the pushes that were found, without any control, the body must take off alike.

standing.initial_conditions = {s: pushing[s][0] for s in standing.states}
standing.specifieds, standing.times, standing.ode_solver = pushing.inputs(), pushing.mesh, dop853
checked = standing.simulate(rtol=1e-10, atol=1e-10)
miss = np.abs(checked.states[-1] - pushing.states[-1]).max()
print(f"the simulation misses the take-off by {miss:.1e}")
assert miss < 1e-3

# %%
# The whole jump
# --------------
# Body and foot over the three phases; in the air the foot swings ahead.

times, places = [], []
for phase, begin in ((pushing, 0.0), (flight, 0.0), (landing, 1.6)):
    start = times[-1][-1] if times else 0.0
    fine = np.linspace(0.0, phase.duration, num=40)[1 if times else 0 :]
    now = phase.at(fine)
    if phase is flight:
        foot_at = np.linspace(0.0, 1.6, num=len(fine))
        rows = [now[x], now[y], foot_at, 0.1 * np.sin(np.pi * fine / phase.duration)]
    else:
        foot_at = np.full(len(fine), begin)
        rows = [begin + now[length] * np.sin(now[lean]), now[length] * np.cos(now[lean])]
        rows += [foot_at, 0.0 * fine]
    times.append(start + fine)
    places.append(np.column_stack(rows))
symbols = [b_x, b_y, f_x, f_y] = me.dynamicsymbols("b_x b_y f_x f_y")
body = foot.locatenew("B", b_x * ground.x + b_y * ground.y)
toe = foot.locatenew("F", f_x * ground.x + f_y * ground.y)
scene = Scene(
    ground,
    foot,
    Visual(Sphere(0.12, color="steelblue"), body, name="body"),
    Visual(Line([body, toe], radius=0.02, color="grey"), name="leg"),
    up="y",
    ground=0.0,
    view=(0.3, 0.2, 1),
    title="A standing jump",
)
scene.animate(np.concatenate(times), np.concatenate(places), symbols=symbols)
plt.show()
