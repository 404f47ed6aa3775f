"""
A woodpecker
============

The toy: a bird hangs by a spring on a sleeve, which is a little wider than the pole around it.  The
sleeve jams and slips, the bird swings, its beak strikes the pole, and bird and sleeve hop down
without end.

Three contacts with friction and impacts, and three degrees of freedom.  The numbers are those of
Ch. Glocker, Dynamik von Starrkörpersystemen mit Reibung und Stößen, VDI-Verlag 1995.  R. Leine,
Glocker and D. van Campen analyse the toy in Nonlinear Dynamics of the Woodpecker Toy, ASME DETC
2001.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import Contacts, Stick, Unilateral
from pydy.mechanics import Definition
from pydy.viz import Box, Cylinder, Line, Sphere, Visual

# %%
# Equations
# ---------
# The angles are small, as in the publications: the sleeve's middle is at the height y, the spring
# to its right, and the bird further out.

y, phi, psi, v, omega, nu = me.dynamicsymbols("y phi psi v omega nu")
m_sleeve, i_sleeve, m_bird, i_bird, l_spring, l_bird, c, g = sm.symbols(
    "m_sleeve i_sleeve m_bird i_bird l_spring l_bird c g"
)
N, origin = me.ReferenceFrame("N"), me.Point("O")
origin.set_vel(N, 0)
middle = origin.locatenew("M", y * N.y)
middle.set_vel(N, v * N.y)
centre = origin.locatenew(
    "S", (l_spring + l_bird) * N.x + (y + l_spring * phi + l_bird * psi) * N.y
)
centre.set_vel(N, (v + l_spring * omega + l_bird * nu) * N.y)


def body(name, point, angle, rate, mass, inertia):
    frame = me.ReferenceFrame(name)
    frame.orient_axis(N, N.z, angle)
    frame.set_ang_vel(N, rate * N.z)
    return me.RigidBody(name, point, frame, mass, (me.inertia(frame, 0, 0, inertia), point))


sleeve = body("sleeve", middle, phi, omega, m_sleeve, i_sleeve)
bird = body("bird", centre, psi, nu, m_bird, i_bird)
spring = c * (psi - phi) * N.z
definition = Definition(
    N,
    [y, phi, psi],
    [v, omega, nu],
    bodies=[sleeve, bird],
    loads=[
        (middle, -m_sleeve * g * N.y),
        (centre, -m_bird * g * N.y),
        (sleeve.frame, spring),
        (bird.frame, -spring),
    ],
)

# %%
# Contacts
# --------
# The beak, and the lower and upper edges of the sleeve, touch the pole.  The beak keeps half of its
# speed, the edges none.  Friction acts along the pole.

l_beak, h_beak, h_sleeve, r_sleeve, r_pole, mu = sm.symbols(
    "l_beak h_beak h_sleeve r_sleeve r_pole mu"
)
slide = v + r_sleeve * omega
beak = Unilateral(l_spring + l_bird - l_beak - r_pole - h_beak * psi, restitution=0.5, name="beak")
lower = Unilateral(r_sleeve - r_pole + h_sleeve * phi, restitution=0.0, name="lower")
upper = Unilateral(r_sleeve - r_pole - h_sleeve * phi, restitution=0.0, name="upper")
rubs = [
    Stick(v + l_spring * omega + (l_bird - l_beak) * nu, on=beak, mu=mu),
    Stick(slide, on=lower, mu=mu),
    Stick(slide, on=upper, mu=mu),
]

# %%
# Simulation
# ----------
# In kilograms, metres and seconds.  The sleeve's lower edge touches the pole and slides down.

SLEEVE, POLE, HEIGHT = 0.0031, 0.0025, 0.0058  # inner radius; radius; half the sleeve's height
PUBLISHED = {psi: -0.2788, v: -0.3411, nu: -7.4583}  # on the limit cycle
system = System(
    definition,
    constants={
        m_sleeve: 3e-4, i_sleeve: 5e-9, m_bird: 4.5e-3, i_bird: 7e-7,
        l_spring: 0.010, l_bird: 0.015, c: 0.0056, g: 9.81,
    },
    initial_conditions={phi: -(SLEEVE - POLE) / HEIGHT, **PUBLISHED},
    ode_solver="dop853",
    times=np.linspace(0.0, 3.0, num=3001),
)  # fmt: skip
contacts = Contacts(
    system,
    [beak, lower, upper, *rubs],
    {l_beak: 0.0201, h_beak: 0.020, h_sleeve: HEIGHT, r_sleeve: SLEEVE, r_pole: POLE, mu: 0.3},
)
motion = contacts.simulate(rtol=1e-10, atol=1e-12)

# %%
# One cycle: the lower edge slides, sticks while the bird swings down and back, and lets go; the
# upper edge and the beak strike; the sleeve falls on its lower edge again.

stops = [event.time for event in motion.events if event.name == "lower stops"]
first, second = stops[-2:]
for event in motion.events:
    if first <= event.time < second:
        print(f"{event.time - first:.4f} s  {event.name}")
print(f"period {second - first:.5f} s")

# %%
# The first half second.

arm = origin.locatenew("arm", l_spring * N.x + y * N.y)
halfway = origin.locatenew("halfway", -0.03 * N.y)
scene = system.scene(
    Visual(Cylinder(0.12, POLE, color="burlywood"), N, halfway, name="pole"),
    Visual(Cylinder(2 * HEIGHT, 1.5 * SLEEVE, color="saddlebrown"), sleeve),
    Visual(Line([middle, arm, centre], 0.0007, color="gray"), name="spring"),
    Visual(Sphere(0.006, color="crimson"), bird),
    Visual(
        Box(0.013, 0.003, 0.003, color="gold"),
        bird.frame,
        centre.locatenew("beak", -0.012 * bird.frame.x + h_beak * bird.frame.y),
    ),
    Visual(
        Box(0.004, 0.02, 0.004, color="crimson"),
        bird.frame,
        centre.locatenew("neck", -0.002 * bird.frame.x + h_beak / 2 * bird.frame.y),
    ),
    up="y",
    series=[phi, psi],
)
scene.animate(motion.at(np.linspace(0.0, 0.5, num=501)))

# %%
# The limit cycle.  The angle of the sleeve has stops at both ends.

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.5), layout="constrained")
shown_times = motion.times > motion.times[-1] - 0.4
left.plot(motion.times[shown_times], motion[psi][shown_times], label=r"bird $\psi$")
left.plot(motion.times[shown_times], motion[phi][shown_times], label=r"sleeve $\varphi$")
left.set(xlabel="time [s]", ylabel="angle [rad]")
left.legend()
right.plot(motion[psi], motion[nu], color="tab:blue", linewidth=0.7)
right.set(xlabel=r"$\psi$ [rad]", ylabel=r"$\nu$ [rad/s]")

# %%
# Checks
# ------
# The work of friction and impacts closes the balance of energy.  Where the sleeve's lower edge
# slides, the bird's angle tells the rest of the state: the published one is half a percent off.
# The cycle is that of a time-stepping with steps of 5e-6 s, whose period is 0.1460 s.

energy = motion.energy[:, 2]
error = np.abs(energy - energy[0] - motion.contact_work).max() / np.ptp(energy)
print(f"energy and the work of contacts differ by {error:.0e} of what was lost")
assert error < 1e-9

near = np.linspace(second - 0.05, second, 5001)
there = motion.at(near)
place = int(np.abs(there[psi] - PUBLISHED[psi]).argmin())
found = {symbol: float(there[symbol][place]) for symbol in PUBLISHED}
print({str(symbol): round(value, 4) for symbol, value in found.items()})
for symbol, published in PUBLISHED.items():
    assert abs(found[symbol] - published) < 0.01 * abs(published)
assert abs(second - first - 0.1460) < 3e-4

plt.show()
