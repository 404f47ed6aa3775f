"""
Dzhanibekov effect
==================

A wing nut that spins in weightlessness turns steadily, flips over, turns steadily, and flips back:
rotation about the axis of the intermediate moment of inertia is unstable.

Without torque the angular velocity follows Euler's equations, whose solution by Jacobi's elliptic
functions is known.  We compare with it, and check that the spatial angular momentum is constant.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from scipy.special import ellipj, ellipk, ellipkinc

from pydy import System
from pydy.viz import Arrow, Cylinder, Visual

INERTIA = (0.3, 0.2, 0.1)  # kg m², about the body's axes x, y, z
SPIN = (0.02, 8.0, 0.0)  # rad/s: about y, the intermediate axis, and slightly about x

# %%
# Equations
# ---------
# The speeds are the body-fixed components of the angular velocity, which keeps the dynamics short.
# The attitude is given by three angles whose singularity is far from a rotation about y.

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
# The default solver, LU, would divide by sin(q3), which is zero at the start.
kane = me.KanesMethod(N, q, w, kinematics, kd_eqs_solver="CRAMER")
kane.kanes_equations([body])

# %%
# Simulation
# ----------
# The angular momentum is an output, in spatial components.

momentum = sum((i * u * e for i, u, e in zip(inertias, w, B, strict=True)), me.Vector(0))
system = System(
    kane,
    constants=dict(zip(inertias, INERTIA, strict=True)),
    initial_conditions=dict(zip(w, SPIN, strict=True)),
    times=np.linspace(0.0, 10.0, num=2001),
    outputs={tuple(sm.symbols("h_x h_y h_z")): list(momentum.to_matrix(N))},
)
motion = system.simulate(rtol=1e-12, atol=1e-12, mxstep=5000)

# %%
# A wing nut is a cylinder along y with a bar across.  The arrow is the angular velocity; the
# angular momentum stays vertical.

scene = system.scene(
    Visual(Cylinder(0.5, 0.12, color="steelblue"), B, centre, name="nut"),
    Visual(
        Cylinder(0.9, 0.06, axis="z", color="orangered"),
        B,
        centre.locatenew("wings", 0.25 * B.y),
        name="wings",
    ),
    Visual(Arrow(B.ang_vel_in(N), scale=0.06), centre, name="angular velocity"),
    origin=centre,
    up="y",
    ground=False,
    series=w,
)
scene.animate(motion)

# %%
# Jacobi's solution
# -----------------
# For A > B > C and an angular momentum larger than that of a rotation about the intermediate axis
# with the same energy, ω = (α dn(s), β sn(s), −γ cn(s)) with s = p t + s₀ ([1]_, section 37).  From
# one flip to the next takes 2 K/p, with the complete elliptic integral K.
#
# .. [1] L. D. Landau and E. M. Lifshitz, "Mechanics", Pergamon 1976.

A_, B_, C_ = INERTIA
w1, w2, w3 = SPIN
energy = A_ * w1**2 + B_ * w2**2 + C_ * w3**2
square = A_**2 * w1**2 + B_**2 * w2**2 + C_**2 * w3**2
alpha = np.sqrt((square - energy * C_) / (A_ * (A_ - C_)))
beta = np.sqrt((energy * A_ - square) / (B_ * (A_ - B_)))
gamma = np.sqrt((energy * A_ - square) / (C_ * (A_ - C_)))
p = np.sqrt((A_ - B_) * (square - energy * C_) / (A_ * B_ * C_))
modulus = (B_ - C_) * (energy * A_ - square) / ((A_ - B_) * (square - energy * C_))
start = ellipkinc(np.arcsin(min(1.0, w2 / beta)), modulus)
sn, cn, dn, _ = ellipj(p * motion.times + start, modulus)
expected = np.column_stack([alpha * dn, beta * sn, -gamma * cn])
flip = 2 * ellipk(modulus) / p

found = motion[w]
figure, axes = plt.subplots(figsize=(9, 3.2), layout="constrained")
for k, axis in enumerate("xyz"):
    axes.plot(motion.times, found[:, k], label=f"$\\omega_{axis}$")
for k in range(1, int(motion.times[-1] / flip) + 1):
    axes.axvline(k * flip, color="0.8", zorder=0)
axes.set(xlabel="time [s]", ylabel="angular velocity [rad/s]", xlim=(0, motion.times[-1]))
axes.legend(loc="upper right")
axes.grid(alpha=0.3)

# %%
# The numbers agree to the accuracy of the integration, which grows with every flip.

error = np.abs(found - expected).max() / SPIN[1]
print(f"it flips every {flip:.4f} s")
print(f"angular velocity against elliptic functions, relative error: {error:.0e}")
assert error < 1e-6
h = np.column_stack([motion[name] for name in ("h_x", "h_y", "h_z")])
drift = np.abs(h - h[0]).max() / np.linalg.norm(h[0])
print(f"spatial angular momentum, relative change: {drift:.0e}")
assert drift < 1e-8

# %%
# The path of the angular velocity
# --------------------------------
# Its tip moves on the ellipsoid of constant energy, near the line that separates the rotations
# about the axis x from those about z.

figure = plt.figure(figsize=(5.5, 4.5), layout="constrained")
axes = figure.add_subplot(projection="3d")
size = np.sqrt(np.dot(INERTIA, found[0] ** 2) / np.array(INERTIA))
polar, around = np.mgrid[0 : np.pi : 31j, 0 : 2 * np.pi : 61j]
sphere = (np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar))
shell = [r * s for r, s in zip(size, sphere, strict=True)]
axes.plot_surface(*shell, color="0.8", alpha=0.25, linewidth=0)
axes.plot(*found.T, color="tab:red", linewidth=1.2)
axes.set(xlabel=r"$\omega_x$", ylabel=r"$\omega_y$", zlabel=r"$\omega_z$")
axes.set_box_aspect(size)
axes.locator_params(nbins=4)

plt.show()
