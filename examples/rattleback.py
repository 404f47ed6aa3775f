"""
Rattleback
==========

A boat-shaped stone that has a mind of its own: spun one way it turns steadily; spun the other way
it soon begins to rattle, stops, and turns back.  Nothing but rolling without slip on a table is
needed for that, and a mass that is a little askew with respect to the curvature.

This is the model of Kane and Levinson with their numbers ([1]_), without friction.  The spin must
reverse, the energy must not change, and a stone whose mass is not askew must keep spinning.
Without friction even the steady direction gives in after a while, by rolling from side to side
instead of pitching, and the stone reverses again and again; a real one has come to rest by then.

.. [1] T. R. Kane and D. A. Levinson, "Realistic mathematical modeling of the rattleback",
   International Journal of Non-Linear Mechanics 17 (1982) 175-186.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.system import System

# %%
# Equations
# ---------
# The underside is an ellipsoid with the semi-axes a, b, c.  Where its outer normal is ν, seen in
# the body, its surface lies at (a²ν₁, b²ν₂, c²ν₃) / √(a²ν₁² + b²ν₂² + c²ν₃²) from its centre; it
# touches the table where ν points straight down.  The mass centre lies h below the ellipsoid's
# centre.
#
# Rolling gives the velocity of the mass centre from the angular velocity alone, v = −ω × p with p
# from the mass centre to the contact.  So there are three speeds and no constraint to care about.


def derive():
    """Return the KanesMethod, values of its constants, and the energy."""
    a, b, c, h, m, g = sm.symbols("a b c h m g")
    I_1, I_2, I_3, I_12 = sm.symbols("I_1 I_2 I_3 I_12")
    alpha, beta, gamma = q = me.dynamicsymbols("alpha beta gamma")
    w = me.dynamicsymbols("omega_1:4")

    N, R = me.ReferenceFrame("N"), me.ReferenceFrame("R")
    # Spin γ about the vertical first, then pitch and roll, both small.
    R.orient_body_fixed(N, [gamma, alpha, beta], "ZXY")
    turning = R.ang_vel_in(N)
    spin = w[0] * R.x + w[1] * R.y + w[2] * R.z
    R.set_ang_vel(N, spin)

    up = [N.z.dot(axis) for axis in R]
    root = sm.sqrt(sum(s**2 * n**2 for s, n in zip((a, b, c), up, strict=True)))
    contact = h * R.z  # from the mass centre to the ellipsoid's centre, and on to the table
    for size, n, axis in zip((a, b, c), up, R, strict=True):
        contact = contact - size**2 * n / root * axis

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
    return kane, constants, energy


# %%
# Simulation
# ----------
# Half a degree of roll is enough to start the rattle.


def main(small=False):
    """Spin the stone both ways and once with its mass straight, check, draw."""
    kane, constants, energy = derive()
    alpha, w_3, askew = kane.q[0], kane.u[2], sm.Symbol("I_12")
    system = System(
        kane,
        constants=constants,
        times=np.linspace(0.0, 5.0 if small else 60.0, num=501 if small else 6001),
        outputs={sm.Symbol("energy"): energy},
    )

    def spin(rate):
        system.initial_conditions = {alpha: np.radians(0.5), w_3: rate}
        x = system.integrate(rtol=1e-11, atol=1e-12, mxstep=5000)
        e = system.evaluate_outputs(x=x)[:, 0]
        return x, np.abs(e / e[0] - 1).max()

    runs = {}
    for name, rate in (("spun clockwise", -5.0), ("spun anticlockwise", 5.0)):
        runs[name], drift = spin(rate)
        w = runs[name][:, 5]
        after = system.times[np.argmax(w * w[0] < 0)]
        reversal = f"turns back after {after:.1f} s" if after else "keeps turning"
        print(f"{name}: {reversal}; energy changes by {drift:.0e} of itself")
        assert drift < 1e-7
    assert runs["spun clockwise"][:, 5].max() > 0.5
    assert runs["spun anticlockwise"][:, 5][system.times < 10].min() > 4.5

    system.constants = constants | {askew: 0.0}
    straight, drift = spin(-5.0)
    print(f"mass not askew: spin {straight[-1, 5]:.2f} rad/s after {system.times[-1]:g} s")
    assert drift < 1e-7
    assert np.abs(straight[:, 5] + 5.0).max() < 0.1
    centre = kane.bodies[0].masscenter
    system.scene(origin=centre).animate(system.times, runs["spun clockwise"])
    draw(system.times, {**runs, "clockwise, mass not askew": straight})


def draw(times, runs):
    """Spin and pitch over time."""
    _, (top, bottom) = plt.subplots(
        2, 1, figsize=(9, 5), sharex=True, layout="constrained", height_ratios=[1.4, 1]
    )
    for name, x in runs.items():
        top.plot(times, x[:, 5], label=name)
    # Angles in the order of q: alpha is the roll, beta the pitch.
    x = runs["spun clockwise"]
    bottom.plot(times, np.degrees(x[:, 0]), linewidth=0.5, color="tab:cyan", label="roll")
    bottom.plot(times, np.degrees(x[:, 1]), linewidth=0.5, color="tab:purple", label="pitch")
    bottom.legend(loc="upper right", ncols=2, fontsize=9)
    top.axhline(0, color="0.5", linewidth=0.8)
    top.set(ylabel="spin [rad/s]")
    top.set(ylim=(-6, 8.5))
    top.legend(loc="upper right", ncols=3, fontsize=9)
    bottom.set(ylabel="clockwise: rattle [deg]", xlabel="time [s]", xlim=(0, times[-1]))
    for axes in (top, bottom):
        axes.grid(alpha=0.3)


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
