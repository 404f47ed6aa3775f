"""
The simplest walker
===================

Two straight legs, all the mass at the hip, walk down a slope of 0.009 rad without a motor (Garcia,
Chatterjee, Ruina and Coleman, J. Biomech. Eng. 120, 1998).  A step ends when the swinging foot
strikes the ground; then the legs change their roles, and the impact takes some of the speed.

The gait is a periodic orbit that ends at an event.  Its multipliers are inside the unit circle:
after a small stumble the walker comes back to its gait.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.solvers import Event
from pydy.system import System

PUBLISHED = (0.200310900544287, -0.199832473004977)  # stance angle and its rate after a strike

# %%
# Equations
# ---------
# The feet weigh nothing beside the hip, so the swing leg does not act on the stance leg.  Time
# counts in √(l/g).  The two angles stand as places of unit masses on a line, under the forces that
# make the published equations.


def derive():
    """Return the KanesMethod, values of its constants, and the heel strike."""
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
    kane.kanes_equations()
    c = sm.cos(2 * theta)
    strike = Event(
        phi - 2 * theta,
        direction=1,
        name="heel strike",
        reset={theta: -theta, phi: -2 * theta, omega: c * omega, nu: c * (1 - c) * omega},
    )
    return kane, {gamma: 0.009, m: 1.0}, strike


# %%
# The gait
# --------


def main(small=False):
    """Find the gait, compare with the published one, draw the swing of both legs."""
    kane, constants, strike = derive()
    theta, phi, omega, nu = (*kane.q, *kane.u)
    system = System(
        kane,
        constants=constants,
        initial_conditions={theta: 0.2, phi: 0.4, omega: -0.2, nu: -0.02},
    )
    gait = system.find_periodic_orbit(3.8, until=strike)
    found = (gait.initial_conditions[theta], gait.initial_conditions[omega])
    print(f"a step takes {gait.period:.6f} √(l/g), the legs' angle is {2 * found[0]:.6f} rad")
    print("multipliers:", gait.multipliers.round(6))
    assert np.allclose(found, PUBLISHED, atol=1e-8)
    assert gait.stable

    # A walker that stumbles returns to the gait.
    system.initial_conditions = {**gait.initial_conditions, omega: found[1] * 1.002}
    system.ode_solver = "dop853"
    system.times = np.linspace(0.0, (5 if small else 12) * gait.period, num=1201)
    walk = system.simulate(events=strike, rtol=1e-10, atol=1e-10)
    angles = [event.after[0] for event in walk.events if event.time > 0.1]
    print("angles after the strikes:", np.round(angles, 5))
    assert abs(angles[-1] - PUBLISHED[0]) < 2e-3

    _, ax = plt.subplots(layout="constrained")
    ax.plot(walk.times, walk[theta], label="stance leg")
    ax.plot(walk.times, walk[theta] - walk[phi], label="swing leg")
    ax.set_xlabel("time (√(l/g))")
    ax.set_ylabel("angle to the slope's normal (rad)")
    ax.legend()


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
