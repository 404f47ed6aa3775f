"""
Pendulum of many links
======================

Ten equal point masses on ten massless links hang in a row.  We release the whole row from the
horizontal.  The motion is chaotic, but the energy is constant.

Small oscillations are not chaotic.  Their frequencies follow from the zeros z of the Laguerre
polynomial of degree n, ω² = z g/l, which is a closed form to compare the exact linear model with.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from numpy.polynomial.laguerre import lagroots

from pydy import System
from pydy.viz import Line, Sphere, Visual

n = 10

# %%
# Equations
# ---------
# Every angle is measured from the vertical: each mass moves relative to the one above it with the
# speed l u, normal to its own link.

m, l, g = sm.symbols("m l g")
q = me.dynamicsymbols(f"q1:{n + 1}")
u = me.dynamicsymbols(f"u1:{n + 1}")
t = me.dynamicsymbols._t

N, pivot = me.ReferenceFrame("N"), me.Point("P0")
pivot.set_vel(N, 0)
points, particles, loads = [pivot], [], []
for k in range(n):
    link = N.orientnew(f"L{k + 1}", "Axis", (q[k], N.z))
    link.set_ang_vel(N, u[k] * N.z)
    end = points[-1].locatenew(f"P{k + 1}", -l * link.y)
    end.v2pt_theory(points[-1], N, link)
    points.append(end)
    particles.append(me.Particle(f"mass{k + 1}", end, m))
    loads.append((end, -m * g * N.y))

# %%
# `KanesMethod` gets the bodies and loads, but we do not call its `kanes_equations`.  `System` forms
# the equations of motion itself, in a fraction of the time.

kane = me.KanesMethod(
    N,
    q,
    u,
    [a.diff(t) - b for a, b in zip(q, u, strict=True)],
    bodies=particles,
    forcelist=loads,
)
system = System(
    kane,
    constants={m: 0.1, l: 0.1, g: 9.81},
    times=np.linspace(0.0, 5.0, num=1001),
)

# %%
# Small oscillations
# ------------------
# Initial conditions are zero by default: the pendulum hangs at rest.  The imaginary parts of the
# Jacobian's eigenvalues are the frequencies.

eigenvalues = np.linalg.eigvals(system.evaluate_jacobian())
frequencies = np.sort(eigenvalues.imag[eigenvalues.imag > 0])
closed_form = np.sqrt(lagroots([0] * n + [1]) * 9.81 / 0.1)
error = np.abs(frequencies / closed_form - 1).max()
print(f"{n} frequencies from Laguerre's polynomial, relative error: {error:.0e}")
assert error < 1e-10

# %%
# The fall
# --------

system.initial_conditions = dict.fromkeys(q, np.pi / 2)
motion = system.simulate(rtol=1e-11, atol=1e-11, mxstep=5000)
scene = system.scene(
    Visual(Line(points, radius=l / 30, color="steelblue"), name="links"),
    *(Visual(Sphere(l / 8, color="grey"), point, name="masses") for point in points[1:-1]),
    Visual(Sphere(l / 8, color="orangered"), points[-1], name="end", trail=True),
    origin=pivot,
    up="y",
    ground=False,
)
scene.animate(motion)

# %%
# The links in the first half second, and the path of the end:

zeros = np.zeros((len(motion.times), 1))
angles = motion[list(q)]
px = np.hstack([zeros, np.cumsum(0.1 * np.sin(angles), axis=1)])
py = np.hstack([zeros, np.cumsum(-0.1 * np.cos(angles), axis=1)])

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4.6), layout="constrained")
shown = np.searchsorted(motion.times, np.linspace(0.0, min(0.5, motion.times[-1]), num=18))
colours = plt.get_cmap("viridis")(np.linspace(0.0, 0.95, num=len(shown)))
for k, colour in zip(shown, colours, strict=True):
    left.plot(px[k], py[k], "o-", color=colour, linewidth=1, markersize=2.5)
left.set(title=f"the first {motion.times[shown[-1]]:.1f} s", aspect="equal", xlabel="x [m]")
left.set_ylabel("y [m]")
reach = 0.1 * n
right.plot(px[:, -1], py[:, -1], color="tab:blue", linewidth=0.8)
right.plot(0, 0, "^", color="black")
right.set(title=f"the end over {motion.times[-1]:.1f} s", aspect="equal", xlabel="x [m]")
right.set(xlim=(-1.1 * reach, 1.1 * reach), ylim=(-1.1 * reach, 1.1 * reach))
for axes in (left, right):
    axes.locator_params(nbins=5)
    axes.grid(alpha=0.3)

# %%
# Check of the energy
# -------------------
# `Trajectory.energy` has the kinetic, the potential and the total energy, from the bodies and
# loads.

kinetic, potential, total = motion.energy.T
drift = np.ptp(total) / np.ptp(kinetic)
print(f"change of the total energy over the range of the kinetic energy: {drift:.0e}")
assert drift < 1e-7

plt.show()
