"""
Rolling disc
============

A coin that rolls on its rim across a table neither slips nor leaves the table: two constraints on
its velocity that cannot be integrated to constraints on its place.  Rolling straight ahead,
upright, it is stable when it is fast enough.  A thin disc of radius r that spins with ω leans with
the eigenvalues ±√(4g/5r − 12ω²/5), which are imaginary above ω² = g/3r.

The linear model that `System` gives exactly is compared with that formula, and a disc that wobbles
along a little above the critical speed must keep its energy.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.linearize import constrained_eigenvalues
from pydy.system import System

RADIUS, GRAVITY = 0.3, 9.81
CRITICAL = np.sqrt(GRAVITY / (3 * RADIUS))  # rad/s

# %%
# Equations
# ---------
# The disc turns in three steps: yaw ψ about the vertical z, lean φ about the heading x, roll θ
# about the axle y.  Speeds are the lean rate, the spin and the turning rate along the disc's own
# axes, and the velocity of the point of contact on the table, which depends on the others.


def derive():
    """Return the KanesMethod, values of its constants, and the energy."""
    m, r, g = sm.symbols("m r g")
    psi, phi, theta, x, y = me.dynamicsymbols("psi phi theta x y")
    lean, spin, turn, v_x, v_y = me.dynamicsymbols("u_lean u_spin u_turn v_x v_y")
    t = me.dynamicsymbols._t

    N, A, B = (me.ReferenceFrame(name) for name in "NAB")
    A.orient_axis(N, N.z, psi)
    B.orient_axis(A, A.x, phi)
    # B leans and turns with the disc but does not roll with it.
    B.set_ang_vel(N, lean * B.x + turn * sm.tan(phi) * B.y + turn * B.z)
    disc_spin = lean * B.x + spin * B.y + turn * B.z

    origin, contact, centre = me.Point("O"), me.Point("P"), me.Point("C")
    origin.set_vel(N, 0)
    contact.set_pos(origin, x * N.x + y * N.y)
    contact.set_vel(N, v_x * N.x + v_y * N.y)
    centre.set_pos(contact, r * B.z)
    centre.set_vel(N, contact.vel(N) + B.ang_vel_in(N).cross(r * B.z))
    # The disc is symmetric, so its inertia may be written in the frame that does not roll.
    D = me.ReferenceFrame("D")
    D.orient_axis(B, B.y, theta)
    D.set_ang_vel(N, disc_spin)
    inertia = me.inertia(B, m * r**2 / 4, m * r**2 / 2, m * r**2 / 4)
    disc = me.RigidBody("disc", centre, D, m, (inertia, centre))

    # What touches the table stands still: the centre moves as the spin says.
    no_slip = centre.vel(N) - disc_spin.cross(r * B.z)
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
        velocity_constraints=[no_slip.dot(N.x), no_slip.dot(N.y)],
    )
    kane.kanes_equations([disc], [(centre, -m * g * N.z)])
    energy = me.kinetic_energy(N, disc) + m * g * r * sm.cos(phi)
    return kane, {m: 1.0, r: RADIUS, g: GRAVITY}, energy


# %%
# Stability and simulation
# ------------------------


def main(small=False):
    """Compare eigenvalues with the formula, simulate a wobble, draw."""
    kane, constants, energy = derive()
    phi, (lean, spin) = kane.q[1], kane.u[:2]
    system = System(
        kane,
        constants=constants,
        times=np.linspace(0.0, 1.0 if small else 8.0, num=101 if small else 1601),
        outputs={sm.Symbol("energy"): energy},
    )

    def eigenvalues(rate):
        """Eigenvalues of rolling straight ahead with this spin."""
        system.initial_conditions = {spin: rate}
        system.set_dependent_initial_conditions()
        return constrained_eigenvalues(
            system.evaluate_jacobian(), system.evaluate_jacobian(of="velocity")
        )

    rates = np.linspace(0.0, 2.0, num=9 if small else 81) * CRITICAL
    found = np.array([eigenvalues(rate) for rate in rates])
    largest = found[np.arange(len(rates)), np.abs(found).argmax(axis=1)]
    squares = 4 * GRAVITY / (5 * RADIUS) - 12 * rates**2 / 5
    error = np.abs(largest**2 - squares).max() / squares[0]
    print(f"eigenvalues against the formula, relative error: {error:.0e}")
    assert error < 1e-6  # at the critical speed two eigenvalues meet, which makes both uncertain

    system.initial_conditions = {spin: 1.15 * CRITICAL, phi: 0.1, lean: 0.5}
    system.set_dependent_initial_conditions()
    states = system.integrate(rtol=1e-11, atol=1e-11)
    e = system.evaluate_outputs(x=states)[:, 0]
    drift = np.abs(e / e[0] - 1).max()
    print(f"energy: {e[0]:.4f} J, relative change: {drift:.0e}")
    assert drift < 1e-8
    slip = np.abs(system.evaluate_velocity_constraints(x=states)).max()
    print(f"slip: {slip:.0e} m/s at most")
    assert slip < 1e-8
    draw(rates, found, squares, states)


def draw(rates, found, squares, states):
    """Eigenvalues over the spin, and the track of the wobbling disc."""
    _, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8), layout="constrained")
    for part, colour, name in ((np.real, "tab:red", "real"), (np.imag, "tab:blue", "imaginary")):
        left.plot(rates / CRITICAL, part(found), ".", color=colour, markersize=3)
        for sign in (1, -1):
            values = part(sign * np.sqrt(squares.astype(complex)))
            label = f"{name} part" if sign == 1 else None
            left.plot(rates / CRITICAL, values, color=colour, alpha=0.4, label=label)
    left.axvline(1, color="0.6", linestyle=":")
    left.set(xlabel="spin over critical spin", ylabel="eigenvalue [1/s]", xlim=(0, 2))
    left.legend(loc="upper center")

    psi, phi, _, x, y = states[:, :5].T
    right.plot(x, y, color="tab:orange", label="contact on the table")
    for k in range(0, len(x), len(x) // 40):
        # The disc from above: an ellipse, thin when it stands upright.
        turn = np.linspace(0.0, 2 * np.pi)
        ahead, aside = RADIUS * np.cos(turn), RADIUS * np.sin(phi[k]) * (1 + np.sin(turn))
        px = x[k] + ahead * np.cos(psi[k]) + aside * np.sin(psi[k])
        py = y[k] + ahead * np.sin(psi[k]) - aside * np.cos(psi[k])
        right.plot(px, py, color="0.6", linewidth=0.7, zorder=0)
    right.set(aspect="equal", xlabel="x [m]", ylabel="y [m]")
    right.legend(loc="best")
    for axes in (left, right):
        axes.grid(alpha=0.3)


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
