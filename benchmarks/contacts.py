"""Contact: a table that is dropped on a floor, here and in MuJoCo; valves and a loop in C.

The table falls level on its four feet while it moves sideways, loses μ times the speed of its fall
in the impact, which has no rebound, slides, and stops. The place of rest has a closed form. MuJoCo
runs at several step sizes, with its usual contacts and with contacts as stiff as it goes.

A thousand pressure relief valves hit their seats: an ensemble with an event and its reset, on one
thread, beside `workers/valve.c`, a loop that is written for this problem alone.
"""

from __future__ import annotations

import argparse
import ctypes
import math
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median
from typing import Any

import mujoco
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from harness.report import save, table

from pydy import System
from pydy.contact import Contacts, Stick, Unilateral
from pydy.mechanics import Definition
from pydy.solvers import Event

HEIGHT, ASIDE, FRICTION, GRAVITY = 0.05, (1.2, 0.9), 0.3, 9.81  # the feet's; m, m/s
LEG, SIDE, MASS, INERTIA, FOOT = 0.5, 0.6, 8.0, (1.0, 1.2, 1.6), 0.01
END = 2.0  # s
GOAL = 1e-9
STEPS = (4e-3, 2e-3, 1e-3, 2e-4, 5e-5)
ENDS = [(x, y) for x in (1, -1) for y in (1, -1)]


def place_of_rest() -> np.ndarray:
    """Return where the table stops, (2,): it falls, is braked by the impact, and slides."""
    speed, falls = math.hypot(*ASIDE), math.sqrt(2 * HEIGHT / GRAVITY)
    left = speed - FRICTION * GRAVITY * falls
    way = speed * falls + left**2 / (2 * FRICTION * GRAVITY)
    return np.array(ASIDE) * way / speed


def ours() -> Contacts:
    """Return the table with its contacts."""
    q, u = me.dynamicsymbols("x y z roll pitch yaw"), me.dynamicsymbols("u1:7")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    board = frame
    for angle, rate, axis in zip(q[3:], u[3:], "xyz", strict=True):
        about = getattr(board, axis)
        before, board = board, board.orientnew(str(angle.func), "Axis", (angle, about))
        board.set_ang_vel(before, rate * about)
    centre = origin.locatenew("C", q[0] * frame.x + q[1] * frame.y + q[2] * frame.z)
    centre.set_vel(frame, u[0] * frame.x + u[1] * frame.y + u[2] * frame.z)
    body = me.RigidBody("table", centre, board, MASS, (me.inertia(board, *INERTIA), centre))
    made = Definition(frame, q, u, bodies=[body], loads=[(centre, -MASS * GRAVITY * frame.z)])
    contacts = []
    for k, (x, y) in enumerate(ENDS):
        foot = centre.locatenew(f"foot{k}", SIDE * (x * board.x + y * board.y) - LEG * board.z)
        foot.v2pt_theory(centre, frame, board)
        gap = Unilateral(foot.pos_from(origin).dot(frame.z), restitution=0, name=f"foot{k}")
        contacts.append(Stick(foot, on=gap, mu=FRICTION, along=(frame.x, frame.y)))
    system = System(made, ode_solver="dop853", times=np.linspace(0.0, END, num=21))
    system.initial_conditions = {q[2]: LEG + HEIGHT, u[0]: ASIDE[0], u[1]: ASIDE[1]}
    return Contacts(system, contacts)


def theirs(step: float, stiff: bool) -> tuple[Any, Any]:
    """Return MuJoCo's model of the same table, with small balls for feet, and its data."""
    feet = "".join(
        f'<geom type="sphere" size="{FOOT}" pos="{x * SIDE} {y * SIDE} {FOOT - LEG}"/>'
        for x, y in ENDS
    )
    inertia = " ".join(map(str, INERTIA))
    # Elliptic cones are Coulomb's; stiff contacts have a time constant of two steps, the least.
    contact = f'solref="{2 * step} 1" solimp="0.9999 0.9999 0.001 0.5 2"' if stiff else ""
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><option timestep="{step}" gravity="0 0 -{GRAVITY}" cone="elliptic" impratio="100"'
        f' tolerance="1e-12" iterations="100"/><default><geom friction="{FRICTION} 0 0" condim="3"'
        f' {contact}/></default><worldbody><geom type="plane" size="10 10 1"/>'
        f'<body pos="0 0 {LEG + HEIGHT}"><freejoint/>'
        f'<inertial pos="0 0 0" mass="{MASS}" diaginertia="{inertia}"/>{feet}</body>'
        "</worldbody></mujoco>"
    )
    return model, mujoco.MjData(model)


def run_theirs(model: Any, data: Any) -> np.ndarray:
    """Return where MuJoCo's table is at the end, (2,)."""
    mujoco.mj_resetData(model, data)
    data.qvel[:2] = ASIDE
    mujoco.mj_step(model, data, round(END / model.opt.timestep))
    return np.array(data.qpos[:2])


def valves(number: int = 1000, end: float = 300.0, tolerance: float = 1e-8) -> list[list[Any]]:
    """Return what valves take here and in C, processor time in s, with their impacts."""
    (y, p), v = me.dynamicsymbols("y p"), me.dynamicsymbols("v")
    flow, frame, origin = sm.Symbol("q"), me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    place = origin.locatenew("P", y * frame.x)
    place.set_vel(frame, v * frame.x)
    rates = [y.diff() - v, p.diff() - 20 * (flow - y * sm.sqrt(p))]
    poppet = me.Particle("poppet", place, 1)
    force = (p - y - 10 - sm.Rational(5, 4) * v) * frame.x
    made = Definition(
        frame, [y, p], [v], bodies=[poppet], loads=[(place, force)], kinematic_equations=rates
    )
    system = System(made, ode_solver="tsit5", initial_conditions={y: 0.2})
    flows = np.linspace(0.6, 10.0, number)
    options: dict[str, Any] = {
        "constants": {flow: flows}, "times": [0.0, end], "rtol": tolerance, "atol": tolerance,
        "events": [Event(y, direction=-1, reset={v: -0.8 * v}, name="impact")], "workers": 1,
    }  # fmt: skip
    counted = int(system.integrate_ensemble(reduce="events", **options).impact_count.sum())

    def here() -> int:
        system.integrate_ensemble(reduce="final", **options)
        return counted

    with tempfile.TemporaryDirectory() as folder:
        library, source = Path(folder) / "valve.so", Path(__file__).parent / "workers" / "valve.c"
        flags = ["-O3", "-march=native", "-shared", "-fPIC"]
        subprocess.run(["cc", *flags, "-o", str(library), str(source), "-lm"], check=True)
        function = ctypes.CDLL(str(library)).valves
        function.restype = ctypes.c_long
        pointer, states = ctypes.POINTER(ctypes.c_double), np.zeros((number, 3))

        def there() -> int:
            first, last = (a.ctypes.data_as(pointer) for a in (flows, states))
            ends = ctypes.c_double(end), ctypes.c_double(tolerance)
            return int(function(number, first, *ends, last))

        runs = ("pydy, tsit5", here), ("a loop in C", there)
        rows: list[list[Any]] = [[name, run(), math.inf] for name, run in runs]
        for _ in range(3):
            for row, (_, run) in zip(rows, runs, strict=True):
                before = time.process_time()
                run()
                row[2] = min(row[2], time.process_time() - before)
    return rows


def main() -> int:
    """Print the tables; return whether our place of rest is beside the closed form."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=15, help="runs of each (default: 15)")
    options = parser.parse_args()
    contacts, expected = ours(), place_of_rest()
    peers = [(h, stiff, *theirs(h, stiff)) for stiff in (False, True) for h in STEPS]

    def run_ours() -> np.ndarray:
        return contacts.simulate(rtol=1e-8, atol=1e-8).states[-1, :2]

    runs = [("pydy, dop853, 1e-8", run_ours)] + [
        (f"MuJoCo, {1e3 * h:g} ms{', stiff' * stiff}", lambda m=m, d=d: run_theirs(m, d))
        for h, stiff, m, d in peers
    ]
    errors = [float(np.linalg.norm(run() - expected)) for _, run in runs]
    times: list[list[float]] = [[] for _ in runs]
    for _ in range(options.rounds):  # in turn: the machine's speed may change
        for (_, run), known in zip(runs, times, strict=True):
            before = time.perf_counter()
            run()
            known.append((time.perf_counter() - before) / END)
    rows = [
        [name, error, 1e3 * median(known)]
        for (name, _), error, known in zip(runs, errors, times, strict=True)
    ]
    shown = [[name, f"{error:.1e}", f"{cost:.2f}"] for name, error, cost in rows]
    table("a table on four feet", ["", "error of the place of rest [m]", "ms per second"], shown)
    found = valves()
    shown = [[name, str(hits), f"{cost:.2f}"] for name, hits, cost in found]
    table("a thousand valves for 300", ["", "impacts", "s"], shown)
    save(
        "contacts",
        {
            "table": [dict(zip(("solver", "error", "cost"), row, strict=True)) for row in rows],
            "valves": [dict(zip(("solver", "hits", "cost"), row, strict=True)) for row in found],
        },
    )
    return int(errors[0] > GOAL)


if __name__ == "__main__":
    sys.exit(main())
