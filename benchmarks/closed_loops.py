"""Closed loops over ten seconds: what is left of constraints and energy here and in MuJoCo.

A four-bar linkage, a leg with two loops as Cassie's, and a Stewart platform, all without friction,
as MJCF files that both read. The residual is the largest distance of the ends that an equality
joins, at 101 times; the energy is relative to the range of the kinetic energy.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from harness.report import save, table

from pydy.robots import read

TIMES = np.linspace(0.0, 10.0, num=101)
GOAL = 1e-10
KEYS = ("model", "solver", "residual", "energy")
WAYS = (("EULER", 2e-3, False), ("RK4", 2e-4, False), ("RK4", 2e-4, True))


def bar(name: str, place: str, end: str, inner: str = "") -> str:
    """Return a rod on a hinge, from its origin to an end."""
    return (
        f'<body name="{name}" pos="{place}"><joint name="{name}" axis="0 1 0"/>'
        f'<geom type="capsule" fromto="0 0 0 {end}" size="0.02"/>{inner}</body>'
    )


def four_bar() -> str:
    """Return a crank, a coupler, and a rocker on the ground."""
    coupler = bar("coupler", "0 0 0.3", "0.8 0 0")
    return _file(
        bar("crank", "0 0 0", "0 0 0.3", coupler) + bar("rocker", "0.8 0 0", "0 0 0.3"),
        '<connect body1="coupler" body2="rocker" anchor="0.8 0 0"/>',
    )


def leg() -> str:
    """Return a leg whose knee and ankle are moved by a crank and a rod each, as Cassie's are."""
    pull = bar("pull", "0.02 0 -0.1", "0.02 0 -0.28")
    shin = bar("shin", "0 0 -0.4", "0 0 -0.4", bar("foot", "0 0 -0.4", "0.15 0 -0.05")
               + bar("lever", "0.08 0 -0.05", "0.02 0 -0.1", pull))  # fmt: skip
    crank = bar("crank", "0.1 0 -0.05", "0 0 -0.1", bar("rod", "0 0 -0.1", "0 0 -0.3"))
    return _file(
        bar("thigh", "0 0 1", "0 0 -0.4", shin + crank),
        '<connect body1="rod" body2="shin" anchor="0 0 -0.3"/>'
        '<connect body1="pull" body2="foot" anchor="0.02 0 -0.28"/>',
    )


def stewart() -> str:
    """Return a platform on six legs with springs."""
    legs, ends = [], []
    for k in range(6):
        low, high = (np.deg2rad(60 * (k // 2) * 2 + s * (-1) ** k) for s in (15, 45))
        foot = np.array([np.cos(low), np.sin(low), 0.0])
        top = np.array([0.6 * np.cos(high), 0.6 * np.sin(high), 1.0])
        way = top - foot
        place, end, axis = (" ".join(map(repr, v.tolist())) for v in (foot, way / 2, way))
        legs.append(
            f'<body name="low{k}" pos="{place}"><joint axis="1 0 0"/><joint axis="0 1 0"/>'
            f'<geom type="capsule" fromto="0 0 0 {end}" size="0.03"/>'
            f'<body name="high{k}" pos="{end}"><joint type="slide" axis="{axis}" stiffness="2000"/>'
            f'<geom type="capsule" fromto="0 0 0 {end}" size="0.02"/></body></body>'
        )
        ends.append(f'<connect body1="high{k}" body2="plate" anchor="{end}"/>')
    plate = (
        '<body name="plate" pos="0 0 1"><freejoint/><geom type="cylinder" size="0.6 0.02"/></body>'
    )
    return _file("".join(legs) + plate, "".join(ends))


def _file(bodies: str, ties: str) -> str:
    return (
        '<mujoco><compiler angle="radian"/><option><flag energy="enable" contact="disable"/>'
        f"</option><worldbody>{bodies}</worldbody><equality>{ties}</equality></mujoco>"
    )


PUSHED = {"four-bar": 2.0, "leg": 1.0, "Stewart platform": 0.5}
MODELS = {"four-bar": four_bar, "leg": leg, "Stewart platform": stewart}


def ours(path: Path, push: float) -> tuple[float, float, dict[str, list[float]], int]:
    """Return residual, loss of energy, the speeds at the start by joint, and the steps."""
    robot = read(path)
    system = robot.system(ode_solver="dop853", times=TIMES)
    first = str(system.speeds[0].func)
    system.initial_conditions = {**robot.start, first: push}
    system.set_dependent_initial_conditions()
    start = {str(s): float(v) for s, v in system.initial_conditions.items()}
    motion = system.simulate(rtol=1e-11, atol=1e-11, constraints="project")
    residual = np.abs(system.evaluate_holonomic_constraints(motion.states, TIMES)).max()
    kinetic, _, whole = motion.energy.T
    steps = int(motion.statistics["steps"])
    joints = {
        name: [start.get(str(s), 0.0) for s in joint.speeds] for name, joint in robot.joints.items()
    }
    return float(residual), float(np.ptp(whole) / np.ptp(kinetic)), joints, steps


def theirs(
    path: Path, start: dict[str, list[float]], how: str, step: float, stiff: bool
) -> tuple[float, float]:
    """Return MuJoCo's residual and loss of energy; `stiff` equalities are as stiff as it goes."""
    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.integrator = getattr(mujoco.mjtIntegrator, f"mjINT_{how}")
    model.opt.timestep = step
    if stiff:  # a time constant of two steps, the least that it takes, and no softness
        model.eq_solref[:, 0] = 2 * step
        model.eq_solimp[:, :2] = 0.9999
    data = mujoco.MjData(model)
    speeds = [v for values in start.values() for v in values]
    data.qvel[:] = speeds
    each = round((TIMES[1] - TIMES[0]) / step)
    residuals, kinetic, whole = [], [], []
    for k in range(len(TIMES)):
        if k:
            mujoco.mj_step(model, data, each)
        mujoco.mj_forward(model, data)
        equal = data.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY
        residuals.append(np.abs(data.efc_pos[equal]).max())
        kinetic.append(data.energy[1])
        whole.append(data.energy.sum())
    return float(max(residuals)), float(np.ptp(whole) / np.ptp(kinetic))


def main() -> int:
    """Print the table; return how many residuals are above the goal."""
    rows: list[list[Any]] = []
    for name, make in MODELS.items():
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "loop.xml"
            path.write_bytes(make().encode())
            residual, energy, start, steps = ours(path, PUSHED[name])
            rows.append([name, f"pydy, dop853, {steps} steps", residual, energy])
            for how, step, stiff in WAYS:
                label = f"MuJoCo, {how.lower()}, {1000 * step:g} ms{', stiff' * stiff}"
                rows.append([name, label, *theirs(path, start, how, step, stiff)])
    shown = [[name, how, f"{left:.0e}", f"{lost:.0e}"] for name, how, left, lost in rows]
    table("closed loops for 10 s", ["", "solver", "residual [m]", "energy"], shown)
    save("loops", [dict(zip(KEYS, row, strict=True)) for row in rows])
    return sum(not row[2] <= GOAL for row in rows if row[1].startswith("pydy"))


if __name__ == "__main__":
    sys.exit(main())
