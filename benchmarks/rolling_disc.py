"""A thin disc that rolls without slip: `WheelContact` without a tire against EXUDYN's joint.

The disc begins leaning, spinning and turning. The position and velocity of its centre after a
second here, with the wheel's holonomic and nonholonomic constraints, at a tolerance of 1e-13; in
EXUDYN, by its trapezoidal rule with 250 to 4,000 steps, extrapolated to steps of no length: its
error has even powers of the step (Richardson). Both are compared with the equations of textbooks,
too, which SciPy integrates. Fails where two of the three differ by more than 1e-9.
"""

from __future__ import annotations

import argparse
import sys
from itertools import pairwise
from pathlib import Path

import numpy as np
import sympy.physics.mechanics as me
from harness.driver import Worker
from harness.options import add_measuring, add_pythons
from harness.report import save, table

from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles import WheelContact

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from oracles.rolling_disc import disc_motion
from zoo.wheels import free_wheel

DISC = {"mass": 10.0, "radius": 0.3, "gravity": 9.81}  # kg, m, m/s²
END, TOLERANCE = 1.0, 1e-9  # s, m and m/s
STEPS = (250, 500, 1000, 2000, 4000)
# The lean (rad) and the rates about the heading, the axle and the upward axis of the disc (rad/s).
STARTS = {
    "wobbles": (0.3, [1.0, 8.0, 0.5]),
    "runs fast": (-0.6, [0.0, -12.0, 3.0]),
    "spins on its edge": (0.9, [0.4, 2.0, 9.0]),
}


def ours() -> System:
    """Return the disc of `DISC` here."""
    m, r = DISC["mass"], DISC["radius"]
    wheel = free_wheel(m, m * r**2 / 2, m * r**2 / 4)
    contact = WheelContact(wheel.body, wheel.B.y, r, wheel.O, wheel.N.z, wheel.N)
    definition = Definition(
        wheel.N,
        wheel.names,
        wheel.rates,
        bodies=[wheel.body],
        loads=[(wheel.G, -m * DISC["gravity"] * wheel.N.z)],
        kinematic_equations=wheel.kinematics,
        holonomic_constraints=contact.holonomic_constraints,
        nonholonomic_constraints=contact.nonholonomic_constraints,
    )
    return System(definition, ode_solver="dop853", times=[0.0, END])


def our_end(system: System, lean: float, rates: list[float]) -> np.ndarray:
    """Return the position and the velocity of the centre at the end."""
    r, cos, sin = DISC["radius"], np.cos(lean), np.sin(lean)
    start = dict(zip(("w1", "w2", "w3"), rates, strict=True))
    start |= {"lean": lean, "y": -r * sin, "z": r * cos}
    start |= {"vx": r * rates[1], "vy": -r * rates[0] * cos, "vz": -r * rates[0] * sin}
    system.initial_conditions = {me.dynamicsymbols(name): v for name, v in start.items()}
    motion = system.simulate(rtol=1e-13, atol=1e-13, constraints="project")
    return np.array([motion[name][-1] for name in ("x", "y", "z", "vx", "vy", "vz")])


def textbook_end(lean: float, rates: list[float]) -> np.ndarray:
    """Return the same of the equations of textbooks."""
    (x, y, z, yaw, lean, w1, w2, _) = disc_motion(np.array([0.0, END]), lean, rates, **DISC)[-1]
    heading = np.array([np.cos(yaw), np.sin(yaw), 0.0])
    axle = np.array([-np.sin(yaw) * np.cos(lean), np.cos(yaw) * np.cos(lean), np.sin(lean)])
    return np.concatenate([[x, y, z], DISC["radius"] * (w2 * heading - w1 * axle)])


def extrapolated(ends: list[np.ndarray]) -> np.ndarray:
    """Return the limit of results with steps that are halved, whose errors have even powers."""
    power = 2
    while len(ends) > 1:
        ends = [fine + (fine - coarse) / (2.0**power - 1.0) for coarse, fine in pairwise(ends)]
        power += 2
    return ends[0]


def main() -> None:
    """Compare, and print a table of the differences."""
    parser = argparse.ArgumentParser(description=__doc__)
    add_pythons(parser, "--peer-python")
    add_measuring(parser, budget=5.0, timeout=120.0)
    options = parser.parse_args()
    system, rows, worst = ours(), [], 0.0
    with Worker(
        "exudyn", options.peer_python, "rolling_disc_exudyn.py", timeout=options.timeout
    ) as worker:
        for name, (lean, rates) in STARTS.items():
            asked = {"lean": lean, "rates": rates, "end": END, **DISC}
            theirs = [np.array(worker.ask("motion", steps=n, **asked)) for n in STEPS]
            limit, here, book = (
                extrapolated(theirs),
                our_end(system, lean, rates),
                textbook_end(lean, rates),
            )
            pairs = ((here, limit), (here, book), (limit, book), (theirs[-1], limit))
            differences = [float(np.abs(one - other).max()) for one, other in pairs]
            worst = max(worst, *differences[:3])
            rows.append([name, *(f"{value:.0e}" for value in differences)])
    header = ["", "pydy, EXUDYN", "pydy, textbook", "EXUDYN, textbook", "EXUDYN, 4,000 steps"]
    table("Largest differences after a second, m and m/s", header, rows)
    save("rolling_disc", {"differences": rows})
    if not worst < TOLERANCE:
        sys.exit(f"differs by {worst:.1e}")


if __name__ == "__main__":
    main()
