"""Ten bodies, two closed loops and eight musculotendons: someone begins to pedal.

Trunk and arms, two legs of thigh, shank and foot, and a crank whose pedals the feet stay on. The
argument is the folder for machine code.
"""

from __future__ import annotations

import os
import sys
import time
from typing import Any

os.environ["PYDY_CACHE_DIR"] = sys.argv[1]

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from harness.serve import serve
from sympy.physics.biomechanics import FirstOrderActivationDeGroote2016, MusculotendonDeGroote2016

from pydy import System
from pydy.control import OptimalControl
from pydy.control.ipopt import library
from pydy.mechanics import Definition

library()  # IPOPT is loaded once
T = me.dynamicsymbols._t
# Lengths in m and masses in kg.
TRUNK, ARM, THIGH, SHANK, FOOT, CRANK = 0.5, 0.6, 0.43, 0.43, 0.16, 0.17
CENTRE = (0.25, -0.62)  # of the crank, from the hips
# Origin and insertion, along and across the segments, force, and lengths of fibre and tendon.
MUSCLES = {
    "gluteus": (("trunk", 0.10, -0.10), ("thigh", 0.20, -0.04), 1500, 0.20, 0.12),
    "psoas": (("trunk", 0.10, 0.08), ("thigh", 0.12, 0.04), 1000, 0.12, 0.12),
    "vastus": (("thigh", 0.15, 0.04), ("shank", 0.06, 0.05), 4000, 0.12, 0.24),
    "biceps": (("thigh", 0.15, -0.04), ("shank", 0.08, -0.04), 1000, 0.20, 0.14),
}


def made() -> tuple[Any, list[Any], list[Any]]:
    """Return the System, the excitations and the activations."""
    ground, hips = me.ReferenceFrame("N"), me.Point("hips")
    hips.set_vel(ground, 0)
    names = ["crank", "trunk", "arm_l", "arm_r"]
    names += [f"{part}_{side}" for side in "lr" for part in ("thigh", "shank", "foot")]
    q = dict(zip(names, me.dynamicsymbols(" ".join(f"q_{n}" for n in names)), strict=True))
    u = dict(zip(names, me.dynamicsymbols(" ".join(f"u_{n}" for n in names)), strict=True))
    frames, bodies, loads = {}, [], []
    ends: dict[str, Any] = {}

    def segment(name: str, start: Any, length: float, mass: float, up: int = -1) -> Any:
        """Add a rod that hangs from a point, or stands on it; its angle is that from there."""
        frame = frames[name] = me.ReferenceFrame(name)
        frame.orient_axis(ground, q[name], ground.z)
        frame.set_ang_vel(ground, u[name] * ground.z)
        centre = start.locatenew(f"{name}_c", up * length / 2 * frame.y)
        spin = me.inertia(frame, 0, 0, mass * length**2 / 12)
        bodies.append(me.RigidBody(name, centre, frame, mass, (spin, centre)))
        loads.append((centre, -9.81 * mass * ground.y))
        ends[name] = start.locatenew(f"{name}_e", up * length * frame.y)
        return ends[name]

    axle = hips.locatenew("axle", CENTRE[0] * ground.x + CENTRE[1] * ground.y)
    axle.set_vel(ground, 0)
    frame = frames["crank"] = me.ReferenceFrame("crank")
    frame.orient_axis(ground, q["crank"], ground.z)
    frame.set_ang_vel(ground, u["crank"] * ground.z)
    spin = me.inertia(frame, 0, 0, 0.3)
    bodies.append(me.RigidBody("crank", axle, frame, 3, (spin, axle)))
    loads.append((frame, -20 * u["crank"] * ground.z))
    neck = segment("trunk", hips, TRUNK, 35, up=1)
    loads.append((frames["trunk"], (-400 * (q["trunk"] + 0.3) - 40 * u["trunk"]) * ground.z))
    for side in "lr":
        segment(f"arm_{side}", neck, ARM, 3)
        loads.append((frames[f"arm_{side}"], -2 * u[f"arm_{side}"] * ground.z))
    rows, kinematics, excitations, activations = [], [], [], []
    for side, sign in (("l", 1), ("r", -1)):
        knee = segment(f"thigh_{side}", hips, THIGH, 8)
        ankle = segment(f"shank_{side}", knee, SHANK, 3.5)
        toe = segment(f"foot_{side}", ankle, FOOT, 1)
        gap = toe.pos_from(axle) - sign * CRANK * frame.y
        rows += [gap.dot(ground.x), gap.dot(ground.y)]
        bend = q[f"foot_{side}"] - q[f"shank_{side}"] - 0.9
        rate = u[f"foot_{side}"] - u[f"shank_{side}"]
        twist = (-60 * bend - 3 * rate) * ground.z
        loads += [(frames[f"foot_{side}"], twist), (frames[f"shank_{side}"], -twist)]
        for muscle, (origin, insertion, force, fibre, tendon) in MUSCLES.items():
            own = []
            for part, along, across in (origin, insertion):
                name = part if part == "trunk" else f"{part}_{side}"
                start = {"trunk": hips, "thigh": hips, "shank": knee}[part]
                up = 1 if part == "trunk" else -1
                body = frames[name]
                own.append(
                    start.locatenew(
                        f"{muscle}_{side}_{part}", up * along * body.y + across * body.x
                    )
                )
            unit = MusculotendonDeGroote2016.with_defaults(
                f"{muscle}_{side}",
                me.LinearPathway(*own),
                FirstOrderActivationDeGroote2016.with_defaults(f"{muscle}_{side}"),
                tendon_slack_length=sm.Float(tendon),
                peak_isometric_force=sm.Integer(force),
                optimal_fiber_length=sm.Float(fibre),
                maximal_fiber_velocity=sm.Integer(10),
                optimal_pennation_angle=sm.Float(0.1),
                fiber_damping_coefficient=sm.Float(0.1),
            )
            loads += unit.to_loads()
            excitations.append(unit.e)
            activations.append(unit.a)
            kinematics.append(unit.a.diff(T) - unit.rhs()[0])
    kinematics = [*(q[n].diff(T) - u[n] for n in names), *kinematics]
    definition = Definition(
        ground,
        [*(q[n] for n in names), *activations],
        [u[n] for n in names],
        bodies=bodies,
        loads=loads,
        kinematic_equations=kinematics,
        holonomic_constraints=rows,
        dependent_coordinates=[q[f"{p}_{s}"] for s in "lr" for p in ("thigh", "shank")],
        dependent_speeds=[u[f"{p}_{s}"] for s in "lr" for p in ("thigh", "shank")],
    )
    start = {q["crank"]: -0.6, q["trunk"]: -0.3, **dict.fromkeys(activations, 0.05)}
    start |= {q[f"{p}_{s}"]: a for s in "lr" for p, a in (("thigh", 0.9), ("shank", -0.5))}
    start |= {q[f"foot_{s}"]: 0.4 for s in "lr"}
    system = System(definition, initial_conditions=start)
    system.set_dependent_initial_conditions()
    return system, excitations, activations


class Pedals:
    def load(self, intervals: int, order: int) -> Any:
        """Build; return the seconds from the bodies to the compiled functions."""
        start = time.perf_counter(), time.process_time()
        system, excitations, activations = made()
        crank = system.states[0]
        bounds = dict.fromkeys([*excitations, *activations], (0.0, 1.0))
        free = dict.fromkeys(activations, (0.01, 1.0))
        self.guess = dict.fromkeys(excitations, 0.1)
        self.problem = OptimalControl(
            system,
            sm.Integral(sum(e**2 for e in excitations), T),
            0.5,
            start=dict(zip(system.states, system._now().x, strict=True)) | free,
            end={crank: -1.4},
            bounds=bounds,
            mesh=intervals,
            order=order,
        )
        self.problem.check(self.guess)
        return {"seconds": time.perf_counter() - start[0],
                "processor": time.process_time() - start[1],
                "states": len(system.states), "bodies": 10}  # fmt: skip

    def solve(self) -> Any:
        """Solve from a motion that stands still."""
        start = time.perf_counter(), time.process_time()
        found = self.problem.solve(self.guess)
        return {"seconds": time.perf_counter() - start[0],
                "processor": time.process_time() - start[1],
                "objective": found.objective, "iterations": len(found.history) - 1,
                "error": float(np.max(found.error))}  # fmt: skip


if __name__ == "__main__":
    pedals = Pedals()
    serve({n: getattr(pedals, n) for n in ("load", "solve")})
