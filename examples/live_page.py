"""
Live page
=========

A pendulum hangs from a carriage on a spring: a tuned vibration absorber, or a toy that never comes
to rest, depending on the masses.  The page below runs the simulation.  Drag a slider, and
JavaScript generated from the same equations computes the new motion in your browser.

The check does not use pydy:  `System.export` writes the equations as functions that need NumPy
alone.  SciPy integrates these, and must end where pydy's own solver ends.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import solve_ivp

from pydy import System
from pydy.viz import Box, Cylinder, Live, Sphere, Visual

# %%
# Equations
# ---------
# The carriage moves along x, and its spring is unstretched at x = 0; q is the pendulum's angle from
# hanging down.

x, q, v, u = me.dynamicsymbols("x q v u")
M, m, l, k, g = sm.symbols("M m l k g", positive=True)
N, O, C, P = me.ReferenceFrame("N"), me.Point("O"), me.Point("C"), me.Point("P")
B = N.orientnew("B", "Axis", (q, N.z))
B.set_ang_vel(N, u * N.z)
O.set_vel(N, 0)
C.set_pos(O, x * N.x)
C.set_vel(N, v * N.x)
P.set_pos(C, -l * B.y)
P.set_vel(N, v * N.x + l * u * B.x)
bodies = [me.Particle("carriage", C, M), me.Particle("bob", P, m)]
loads = [(C, -k * x * N.x - M * g * N.y), (P, -m * g * N.y)]
kane = me.KanesMethod(N, [x, q], [v, u], [x.diff() - v, q.diff() - u])
kane.kanes_equations(bodies, loads)

# %%
# Simulation
# ----------

system = System(
    kane,
    constants={M: 2.0, m: 0.5, l: 1.0, k: 20.0, g: 9.81},
    ode_solver="dop853",
    initial_conditions={x: 0.3, q: 0.0},
    times=np.linspace(0.0, 20.0, num=601),
)
motion = system.simulate(rtol=1e-10, atol=1e-10)

figure, panels = plt.subplots(2, 1, sharex=True, layout="constrained")
for axes, quantity, label in zip(panels, (x, q), ("carriage [m]", "pendulum [rad]"), strict=True):
    axes.plot(motion.times, motion[quantity])
    axes.set_ylabel(label)
panels[1].set_xlabel("time [s]")
figure.suptitle("Energy moves back and forth between carriage and pendulum")

# %%
# The page
# --------
# The rod's length is an expression of the constant l, so that it follows the slider.  A slider is
# given by its minimum, maximum, initial value and unit.

rod = C.locatenew("rod", -l / 2 * B.y)
scene = system.scene(
    Visual(Box(0.3, 0.15, 0.2), C, name="carriage"),
    Visual(Cylinder(length=l, radius=0.015), B, rod, name="rod"),
    Visual(Sphere(0.07), P, name="bob", trail=True),
    reference_frame=N,
    origin=O,
    up="y",
    series=[x, q],
)
scene.animate(motion)
sliders = {
    "M": (0.5, 5.0, 2.0, "kg"),
    "m": (0.05, 3.0, 0.5, "kg"),
    "l": (0.3, 2.0, 1.0, "m"),
    "k": (2.0, 80.0, 20.0, "N/m"),
    "x": (-0.5, 0.5, 0.3, "m"),
    "q": (-3.0, 3.0, 0.0, "rad"),
}
with tempfile.TemporaryDirectory() as folder:
    page = scene.to_html(Path(folder) / "carriage.html", live=Live(sliders))
    print(f"the live page takes {page.stat().st_size / 1e6:.1f} MB, three.js included")

# %%
# The same equations without pydy
# -------------------------------
# The exported file is plain NumPy.  Its first lines:

with tempfile.TemporaryDirectory() as folder:
    exported = system.export(Path(folder) / "carriage.py")
    source = exported.path.read_text(encoding="utf-8")
print("\n".join(source.splitlines()[:12]))

# %%

functions = {}
exec(source, functions)
there = solve_ivp(
    functions["rates"],
    motion.times[[0, -1]],
    motion.states[0],
    method="DOP853",
    rtol=1e-11,
    atol=1e-11,
)
error = np.abs(there.y[:, -1] - motion.states[-1]).max()
print(f"the exported functions end {error:.0e} away")
assert error < 1e-6

plt.show()
