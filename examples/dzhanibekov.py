"""
Dzhanibekov effect
==================

A wing nut spun in weightlessness turns steadily, flips over, turns steadily, flips back: rotation
about the axis of the middle moment of inertia is unstable.  Without torque the angular velocity
follows Euler's equations, whose solution by Jacobi's elliptic functions is compared with here; the
spatial angular momentum must stay where it is, in length and direction.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from scipy.special import ellipj, ellipk, ellipkinc

from pydy.system import System

INERTIA = (0.3, 0.2, 0.1)  # kg m², about the body's axes x, y, z
SPIN = (0.02, 8.0, 0.0)  # rad/s: about y, the middle one, and a trifle about x

# %%
# Equations
# ---------
# Body-fixed angular velocities as speeds keep the dynamics short; the attitude is given by three
# angles, chosen so that they stay away from their singularity as the body turns about y.


def derive():
    """Return the KanesMethod, values of its constants, and the spatial angular momentum."""
    inertias = sm.symbols("I_x I_y I_z")
    q = me.dynamicsymbols("q1:4")
    w = me.dynamicsymbols("omega_x omega_y omega_z")
    N, B = me.ReferenceFrame("N"), me.ReferenceFrame("B")
    B.orient_body_fixed(N, q, "YXZ")
    turning = B.ang_vel_in(N)
    B.set_ang_vel(N, w[0] * B.x + w[1] * B.y + w[2] * B.z)
    centre = me.Point("C")
    centre.set_vel(N, 0)
    body = me.RigidBody("nut", centre, B, sm.Symbol("m"), (me.inertia(B, *inertias), centre))
    kinematics = [turning.dot(axis) - rate for axis, rate in zip(B, w, strict=True)]
    # The default, LU, would divide by sin(q3), which is zero at the start.
    kane = me.KanesMethod(N, q, w, kinematics, kd_eqs_solver="CRAMER")
    kane.kanes_equations([body])
    momentum = sum((i * u * e for i, u, e in zip(inertias, w, B, strict=True)), me.Vector(0))
    return kane, dict(zip(inertias, INERTIA, strict=True)), momentum.to_matrix(N)


# %%
# Jacobi's solution
# -----------------
# For A > B > C and more momentum than spinning about the middle axis would need with the same
# energy, ω = (α dn(s), β sn(s), γ cn(s)) with s = p t + s₀ up to signs ([1]_, section 37).
#
# .. [1] L. D. Landau and E. M. Lifshitz, "Mechanics", Pergamon 1976.


def closed_form(t):
    """Angular velocities over time, and the time from one flip to the next."""
    A, B, C = INERTIA
    w1, w2, w3 = SPIN
    energy = A * w1**2 + B * w2**2 + C * w3**2
    square = A**2 * w1**2 + B**2 * w2**2 + C**2 * w3**2
    alpha = np.sqrt((square - energy * C) / (A * (A - C)))
    beta = np.sqrt((energy * A - square) / (B * (A - B)))
    gamma = np.sqrt((energy * A - square) / (C * (A - C)))
    p = np.sqrt((A - B) * (square - energy * C) / (A * B * C))
    modulus = (B - C) * (energy * A - square) / ((A - B) * (square - energy * C))
    start = ellipkinc(np.arcsin(min(1.0, w2 / beta)), modulus)
    sn, cn, dn, _ = ellipj(p * t + start, modulus)
    return np.column_stack([alpha * dn, beta * sn, -gamma * cn]), 2 * ellipk(modulus) / p


# %%
# Simulation
# ----------


def main(small=False):
    """Simulate ten seconds, compare with the closed form, draw."""
    kane, constants, momentum = derive()
    system = System(
        kane,
        constants=constants,
        initial_conditions=dict(zip(kane.u, SPIN, strict=True)),
        times=np.linspace(0.0, 1.0 if small else 10.0, num=101 if small else 2001),
        outputs={tuple(sm.symbols("h_x h_y h_z")): list(momentum)},
    )
    x = system.integrate(rtol=1e-12, atol=1e-12, mxstep=5000)
    expected, flip = closed_form(system.times)
    error = np.abs(x[:, 3:] - expected).max() / SPIN[1]
    print(f"it flips every {flip:.4f} s")
    print(f"angular velocity against elliptic functions, relative error: {error:.0e}")
    assert error < 1e-6
    h = system.evaluate_outputs(x=x)
    wander = np.abs(h - h[0]).max() / np.linalg.norm(h[0])
    print(f"spatial angular momentum, relative change: {wander:.0e}")
    assert wander < 1e-8
    draw(system.times, x[:, 3:], flip)


def draw(times, w, flip):
    """Angular velocities over time, and their path on the ellipsoid of energy."""
    figure = plt.figure(figsize=(9, 4), layout="constrained")
    left = figure.add_subplot(1, 2, 1)
    for k, axis in enumerate("xyz"):
        left.plot(times, w[:, k], label=f"$\\omega_{axis}$")
    for k in range(1, int(times[-1] / flip) + 1):
        left.axvline(k * flip, color="0.8", zorder=0)
    left.set(xlabel="time [s]", ylabel="angular velocity [rad/s]", xlim=(0, times[-1]))
    left.legend(loc="upper right")
    left.grid(alpha=0.3)

    right = figure.add_subplot(1, 2, 2, projection="3d")
    size = np.sqrt(np.dot(INERTIA, w[0] ** 2) / np.array(INERTIA))
    polar, around = np.mgrid[0 : np.pi : 31j, 0 : 2 * np.pi : 61j]
    sphere = (np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar))
    shell = [r * s for r, s in zip(size, sphere, strict=True)]
    right.plot_surface(*shell, color="0.8", alpha=0.25, linewidth=0)
    right.plot(*w.T, color="tab:red", linewidth=1.2)
    right.set(xlabel=r"$\omega_x$", ylabel=r"$\omega_y$", zlabel=r"$\omega_z$")
    right.set_box_aspect(size)
    right.locator_params(nbins=4)
    right.set_title("path on the ellipsoid of energy", fontsize=10)


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
