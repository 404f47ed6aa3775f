"""The problems of `multibody.py` here: joints' coordinates, projection onto closed loops."""

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

from zoo.loops import bricard
from zoo.singular import defined_windows


@cache
def problem(name: str) -> tuple[System, str | None, list[sm.Expr]]:
    """Return the System of a problem, how its loops are held, and the place of the marked point."""
    if name in ("bricard", "governor"):
        return _bricard() if name == "bricard" else _governor()
    angle = me.dynamicsymbols("a0")
    place = [sm.cos(angle), sm.sin(angle)]
    if name == "pendulum":
        rate = me.dynamicsymbols("ua0")
        frame, origin = _ground()
        x, y = place
        point = origin.locatenew("P", x * frame.x + y * frame.y)
        point.set_vel(frame, rate * (x * frame.y - y * frame.x))
        bodies, loads = [me.Particle("P", point, 1)], [(point, -9.81 * frame.y)]
        made = Definition(frame, [angle], [rate], bodies=bodies, loads=loads)
        start = {angle: np.pi}
        return System(made, initial_conditions=start, ode_solver="dop853"), None, place
    made = defined_windows(int(name))
    system = System(made, ode_solver="dop853")
    system.constants = dict(zip(sm.symbols("m l g", positive=True), (1.0, 1.0, 9.81), strict=True))
    for q, u in zip(made.coordinates, made.speeds, strict=True):
        post = str(q).startswith("a")
        system.initial_conditions[q] = np.pi / 2 if post else 0.0
        system.initial_conditions[u] = -1.0 if post else 0.0
    return system, "project", place


def _ground() -> tuple[me.ReferenceFrame, me.Point]:
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    return frame, origin


def _bricard() -> tuple[System, str, list[sm.Expr]]:
    """Five rods along edges of a cube; the place of the third one's end."""
    made, start = bricard((1, -1, 1))
    rods = made.bodies[:3]
    edges = [getattr(rod.frame, axis) for rod, axis in zip(rods, "xyz", strict=True)]
    end = edges[0] - edges[1] + edges[2]
    system = System(made, constants={"g": 9.81}, initial_conditions=start, ode_solver="dop853")
    return system, "project", [end.dot(e) for e in made.frame]


def _governor() -> tuple[System, None, list[sm.Expr]]:
    """A shaft that turns, a base that slides on it, and two rods with balls at their ends."""
    q, u = me.dynamicsymbols("turn slide down1 down2"), me.dynamicsymbols("u1:5")
    frame, origin = _ground()
    shaft = frame.orientnew("shaft", "Axis", (q[0], frame.z))
    shaft.set_ang_vel(frame, u[0] * frame.z)
    middle = origin.locatenew("middle", shaft.z / 2)
    slider = origin.locatenew("slider", q[1] * shaft.z)
    bodies = [
        _box("shaft", shaft, middle, (0.01, 0.01, 1.0)),
        _box("base", shaft, slider, (0.1, 0.1, 0.1)),
    ]
    loads = []
    for k, side in enumerate((1, -1)):
        rod = shaft.orientnew(f"rod{k}", "Axis", (side * q[2 + k], shaft.y))
        rod.set_ang_vel(shaft, side * u[2 + k] * shaft.y)
        pin = origin.locatenew(f"pin{k}", side * 0.05 * shaft.x + shaft.z)
        centre = pin.locatenew(f"centre{k}", side * rod.x / 2)
        ball = pin.locatenew(f"ball{k}", side * rod.x)
        foot = slider.locatenew(f"foot{k}", side * 0.05 * shaft.x)
        bodies += [
            _box(f"rod{k}", rod, centre, (1.0, 0.01, 0.01)),
            me.Particle(f"ball{k}", ball, 5),
        ]
        path = me.LinearPathway(foot, centre)
        loads += path.to_loads(-8e5 * (path.length - 0.5) - 4e4 * path.extension_velocity)
    loads += [(b.masscenter, -9.81 * b.mass * frame.z) for b in bodies]
    made = Definition(frame, q, u, bodies=bodies, loads=loads)
    start = {q[1]: 0.5, q[2]: np.pi / 6, q[3]: np.pi / 6, u[0]: 2 * np.pi}
    place = bodies[3].masscenter.pos_from(origin)
    system = System(made, initial_conditions=start, ode_solver="radau")
    return system, None, [place.dot(e) for e in frame]


def _box(
    name: str, frame: me.ReferenceFrame, centre: me.Point, sides: tuple[float, float, float]
) -> me.RigidBody:
    x, y, z = sides
    mass = 3000 * x * y * z
    moments = (mass / 12 * s for s in (y * y + z * z, x * x + z * z, x * x + y * y))
    return me.RigidBody(name, centre, frame, mass, (me.inertia(frame, *moments), centre))


def first(name: str, end: float) -> dict[str, Any]:
    """Return the seconds from the bodies to the first motion, with an empty cache."""
    return {"seconds": time_of(lambda: run(name, 1e-8, end))}


def run(name: str, accuracy: float, end: float) -> dict[str, Any]:
    """Integrate with a tolerance; the place of the marked point."""
    system, held, place = problem(name)
    system.times = np.array([0.0, end])
    start = time.process_time()
    motion = system.simulate(rtol=accuracy, atol=accuracy, constraints=held)
    seconds = time.process_time() - start
    last = dict(zip(system.states, motion.states[-1], strict=True))
    return {"seconds": seconds, "place": [float(x.xreplace(last)) for x in place]}


if __name__ == "__main__":
    serve({"first": lambda **asked: in_child(partial(first, **asked)), "run": run})
