"""
The simplest walker
===================

Two straight legs with all their mass at the hip walk down a slope of 0.009 rad without a motor
(Garcia, Chatterjee, Ruina and Coleman, J. Biomech. Eng. 120, 1998).  A step ends when the swinging
foot strikes the ground.  Then the legs exchange their roles, and the impact takes some of the
speed.

The gait is a periodic orbit that ends at an event.  Its multipliers are inside the unit circle:
after a small stumble the walker returns to its gait.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from scipy.optimize import brentq

from pydy import System
from pydy.solvers import Event
from pydy.viz import Line, Scene, Sphere, Visual

# Stance angle and its rate after a strike, to ten digits, from M. Garcia's program that made the
# paper's results.
PUBLISHED = (0.20031090049483, -0.19983247291764)
# The paper's Table 1, "long": the time of a step and the stance angle over γ^(1/3), as γ → 0.
PUBLISHED_LIMITS = (3.812092, 0.970956)
SLOPE = 0.009

# %%
# Equations
# ---------
# The unit of time is √(l/g).  θ is the angle of the stance leg to the slope's normal, φ the angle
# between the legs.  The feet have no mass compared with the hip, so the swing leg does not act on
# the stance leg.  In that limit the published equations are θ'' = sin(θ − γ) and φ'' = sin(θ − γ) +
# (θ'² − cos(θ − γ)) sin φ.  We enter them as forces on two unit masses, whose positions on a line
# are the two angles.

theta, phi, omega, nu = me.dynamicsymbols("theta phi omega nu")
gamma, m = sm.symbols("gamma m")
t = me.dynamicsymbols._t
stance = sm.sin(theta - gamma)
swing = stance + (omega**2 - sm.cos(theta - gamma)) * sm.sin(phi)
ground, origin = me.ReferenceFrame("N"), me.Point("O")
origin.set_vel(ground, 0)
masses, loads = [], []
for angle, speed, rate in ((theta, omega, stance), (phi, nu, swing)):
    point = origin.locatenew(f"P_{angle.name}", angle * ground.x)
    point.set_vel(ground, speed * ground.x)
    masses.append(me.Particle(angle.name, point, m))
    loads.append((point, m * rate * ground.x))
kane = me.KanesMethod(
    ground,
    [theta, phi],
    [omega, nu],
    [theta.diff(t) - omega, phi.diff(t) - nu],
    bodies=masses,
    forcelist=loads,
)

# %%
# The strike
# ----------
# The swinging foot is on the ground when φ = 2θ.  The reset exchanges the legs.  The impulse at the
# new stance foot keeps the angular momentum of the hip about it.

c = sm.cos(2 * theta)
strike = Event(
    phi - 2 * theta,
    direction=1,
    name="heel strike",
    reset={theta: -theta, phi: -2 * theta, omega: c * omega, nu: c * (1 - c) * omega},
)

# %%
# The gait
# --------
# A shooting method finds the motion that repeats after each strike.

system = System(
    kane,
    constants={gamma: SLOPE, m: 1.0},
    initial_conditions={theta: 0.2, phi: 0.4, omega: -0.2, nu: -0.02},
)
gait = system.find_periodic_orbit(3.8, until=strike)
found = (gait.initial_conditions[theta], gait.initial_conditions[omega])
print(f"a step takes {gait.period:.6f} √(l/g), the legs' angle is {2 * found[0]:.6f} rad")
print("multipliers:", gait.multipliers.round(6))
assert np.allclose(found, PUBLISHED, atol=1e-8)
assert gait.stable

# %%
# On a gentle slope
# -----------------
# The paper expands the gait in γ^(1/3).  The time of a step tends to the τ of
# tan(τ/2) = −3 tanh(τ/2), which is the published one to the last digit, and the stance angle to a
# multiple of γ^(1/3).

gentle = SLOPE / 512.0
system.constants[gamma] = gentle
system.initial_conditions = {theta: 0.025, phi: 0.05, omega: -0.025, nu: -4e-5}
slow = system.find_periodic_orbit(3.8, until=strike)
half = brentq(lambda h: np.tan(h) + 3.0 * np.tanh(h), 0.51 * np.pi, np.pi)
limits = (slow.period, slow.initial_conditions[theta] / gentle ** (1.0 / 3.0))
print(f"on a slope of {gentle:.1e} rad: {limits[0]:.4f} √(l/g), {limits[1]:.4f} γ^(1/3)")
assert np.isclose(2.0 * half, PUBLISHED_LIMITS[0], rtol=0.0, atol=5e-7)
assert np.allclose(limits, PUBLISHED_LIMITS, rtol=5e-4)

# %%
# After a stumble
# ---------------
# Half a step after a strike the walker is slowed down a little, and returns to its gait.  The first
# half is simulated without the event: right after a strike the legs are on its surface still.

system.constants[gamma] = SLOPE
system.initial_conditions, system.ode_solver = gait.initial_conditions, "dop853"
system.times = [0.0, gait.period / 2.0]
half_a_step = system.integrate(rtol=1e-10, atol=1e-10)[-1]
system.initial_conditions = dict(zip(system.states, half_a_step, strict=True))
system.initial_conditions[omega] *= 1.002
steps = 12
system.times = np.linspace(0.5, steps, num=120 * steps + 1) * gait.period
walk = system.simulate(events=strike, rtol=1e-10, atol=1e-10)
strikes = [event for event in walk.events if event.time > 0.1]
angles = [event.after[0] for event in strikes]
print("angles after the strikes:", np.round(angles, 5))
assert abs(angles[-1] - PUBLISHED[0]) < 2e-3

# %%

figure, axes = plt.subplots(figsize=(8, 3.4), layout="constrained")
axes.plot(walk.times, walk[theta], label="stance leg")
axes.plot(walk.times, walk[theta] - walk[phi], label="swing leg")
axes.set(xlabel=r"time [$\sqrt{l/g}$]", ylabel="angle to the slope's normal [rad]")
axes.legend()
axes.grid(alpha=0.3)

# %%
# The walk as a picture
# ---------------------
# The animation needs positions.  Each strike moves the stance foot on by one step, and the hip
# stands above it.  A `Scene` of its own takes the angles of the two legs and the position of the
# hip.

landed = np.array([event.time for event in strikes])
lengths = np.array([2 * np.sin(event.after[0]) for event in strikes])
number = np.searchsorted(landed, walk.times, side="right")  # of steps done
foot = np.concatenate([[0.0], np.cumsum(lengths)])[number]
first_leg = np.where(number % 2 == 0, walk[theta], walk[theta] - walk[phi])
second_leg = np.where(number % 2 == 0, walk[theta] - walk[phi], walk[theta])
hip = np.column_stack([foot - np.sin(walk[theta]), np.cos(walk[theta])])

left, right, h_x, h_y = me.dynamicsymbols("left right h_x h_y")
H = origin.locatenew("H", h_x * ground.x + h_y * ground.y)
feet = [
    H.locatenew(name, sm.sin(leg) * ground.x - sm.cos(leg) * ground.y)
    for name, leg in (("F1", left), ("F2", right))
]
scene = Scene(
    ground,
    origin,
    Visual(Sphere(0.08, color="grey"), H, name="hip"),
    Visual(Line([H, feet[0]], radius=0.02, color="steelblue"), name="left leg"),
    Visual(Line([H, feet[1]], radius=0.02, color="orangered"), name="right leg"),
    up="y",
    ground=0.0,
    follow=True,
    view=(0.3, 0.2, 1),
    title="The simplest walker",
)
scene.animate(
    walk.times, np.column_stack([first_leg, second_leg, hip]), symbols=[left, right, h_x, h_y]
)

plt.show()
