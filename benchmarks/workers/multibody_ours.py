"""The problems of `multibody.py` here: angles as coordinates, an explicit method, projection."""

from __future__ import annotations

import sys
import time
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from harness.serve import in_child, serve, time_of

from pydy.mechanics import Definition
from pydy.system import System

sys.path.insert(0, str(Path(__file__).parents[2] / "tests"))

from singular import defined_windows


@cache
def system_of(name: str) -> System:
    """Return the System of a problem; the marked point is at the end of the first rod."""
    if name == "pendulum":
        angle, rate = me.dynamicsymbols("a0 ua0")
        frame, origin = me.ReferenceFrame("N"), me.Point("O")
        origin.set_vel(frame, 0)
        x, y = sm.cos(angle), sm.sin(angle)
        place = origin.locatenew("P", x * frame.x + y * frame.y)
        place.set_vel(frame, rate * (x * frame.y - y * frame.x))
        bodies, loads = [me.Particle("P", place, 1)], [(place, -9.81 * frame.y)]
        made = Definition(frame, [angle], [rate], bodies=bodies, loads=loads)
        return System(made, initial_conditions={angle: np.pi}, ode_solver="dop853")
    n = int(name)
    made = defined_windows(n)
    system = System(made, ode_solver="dop853")
    system.constants = dict(zip(sm.symbols("m l g", positive=True), (1.0, 1.0, 9.81), strict=True))
    for q, u in zip(made.coordinates, made.speeds, strict=True):
        post = str(q).startswith("a")
        system.initial_conditions[q] = np.pi / 2 if post else 0.0
        system.initial_conditions[u] = -1.0 if post else 0.0
    return system


def first(name: str, end: float) -> dict[str, Any]:
    """Return the seconds from the bodies to the first motion, with an empty cache."""
    return {"seconds": time_of(lambda: run(name, 1e-8, end))}


def run(name: str, accuracy: float, end: float) -> dict[str, Any]:
    """Integrate with a tolerance; the place of the marked point."""
    system = system_of(name)
    system.times = np.array([0.0, end])
    start = time.process_time()
    held = "project" if name != "pendulum" else None
    motion = system.simulate(rtol=accuracy, atol=accuracy, constraints=held)
    seconds = time.process_time() - start
    angle = float(motion["a0"][-1])
    return {"seconds": seconds, "place": [float(np.cos(angle)), float(np.sin(angle))]}


if __name__ == "__main__":
    serve({"first": lambda **asked: in_child(partial(first, **asked)), "run": run})
