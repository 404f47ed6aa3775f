"""
Live page
=========

A pendulum hangs from a carriage on a spring: a tuned vibration absorber, or a toy that never
settles, depending on the masses.  The page below simulates: drag a slider, and the motion is
computed anew where you read this, by JavaScript made from the same equations.

The check takes the equations out of pydy altogether.  `System.export` writes them as functions that
need NumPy alone; SciPy integrates those, and must end where pydy's own solver ends.
"""

import sys
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import solve_ivp

from pydy.system import System
from pydy.viz import Box, Cylinder, Live, Sphere, Visual

# %%
# Equations
# ---------
# The carriage moves along x, its spring is unstretched at x = 0; q is the pendulum's angle from
# where it hangs.


def derive():
    """Return the KanesMethod, the values of its constants, and what the scene shows."""
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
    rod = C.locatenew("rod", -l / 2 * B.y)
    visuals = [
        Visual(Box(0.3, 0.15, 0.2), C, name="carriage"),
        Visual(Cylinder(length=l, radius=0.015), B, rod, name="rod"),
        Visual(Sphere(0.07), P, name="bob", trail=True),
    ]
    return kane, {M: 2.0, m: 0.5, l: 1.0, k: 20.0, g: 9.81}, visuals, (N, O)


# %%
# Simulation, the live page, and the check
# ----------------------------------------


def main(small=False):
    """Simulate, write the live page, compare with the exported functions, draw."""
    kane, constants, visuals, (N, O) = derive()
    x, q = kane.q
    system = System(
        kane,
        constants=constants,
        ode_solver="dop853",
        initial_conditions={x: 0.3, q: 0.0},
        times=np.linspace(0.0, 4.0 if small else 20.0, num=121 if small else 601),
    )
    trajectory = system.simulate(rtol=1e-10, atol=1e-10)
    scene = system.scene(*visuals, reference_frame=N, origin=O, up="y", series=[x, q])
    scene.animate(trajectory)
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
        exported = system.export(Path(folder) / "carriage.py")
        functions = {}
        exec(exported.path.read_text(), functions)
    there = solve_ivp(
        functions["rates"], system.times[[0, -1]], trajectory.states[0], "DOP853",
        rtol=1e-11, atol=1e-11,
    )  # fmt: skip
    error = np.abs(there.y[:, -1] - trajectory.states[-1]).max()
    print(f"the exported functions end {error:.0e} away")
    assert error < 1e-6
    draw(trajectory, x, q)


def draw(trajectory, x, q):
    figure, axes = plt.subplots(2, 1, sharex=True)
    for ax, quantity, label in zip(axes, (x, q), ("carriage [m]", "pendulum [rad]"), strict=True):
        ax.plot(trajectory.times, trajectory[quantity])
        ax.set_ylabel(label)
    axes[1].set_xlabel("time [s]")
    figure.suptitle("Energy goes to and fro between carriage and pendulum")


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
