"""The first result of a process, part by part, as a user's script would reach it."""

# ruff: noqa: E402 (imports are measured one by one)

from __future__ import annotations

import json
import sys
import tempfile
import time
from itertools import pairwise
from pathlib import Path

_clock = time.process_time
_marks = [("start", _clock())]
_wall = time.perf_counter()


def _mark(name: str) -> None:
    _marks.append((name, _clock()))


import sympy as sm
import sympy.physics.mechanics as me

_mark("sympy")
import numpy as np

_mark("numpy")
from pydy.system import System

_mark("pydy")


def _pendulum() -> System:
    q, u = me.dynamicsymbols("q u")
    m, g, length = sm.symbols("m g l")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    turned = frame.orientnew("A", "Axis", (q, frame.z))
    turned.set_ang_vel(frame, u * frame.z)
    origin.set_vel(frame, 0)
    end = origin.locatenew("P", -length * turned.y)
    end.v2pt_theory(origin, frame, turned)
    kane = me.KanesMethod(frame, [q], [u], kd_eqs=[q.diff() - u])
    kane.kanes_equations([me.Particle("P", end, m)], [(end, -m * g * frame.y)])
    return System(kane, {m: 1.0, g: 9.81, length: 1.0}, initial_conditions={q: 0.5})


def _bicycle() -> System:
    from pydy.examples import whipple_bicycle

    model = whipple_bicycle.derive()
    initial = whipple_bicycle.equilibrium(model, 5.0)
    constants = whipple_bicycle.benchmark_parameters(model)
    return System(model.definition, constants, initial_conditions=initial)


def _from_file(text: str, suffix: str) -> System:
    from pydy.robots import read

    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / f"robot{suffix}"
        file.write_text(text, encoding="utf-8")
        return read(file).system()


def _chain() -> System:
    from pydy.models import n_link_pendulum_on_cart

    return n_link_pendulum_on_cart(20)


def _arm() -> System:
    links, axes = ["<link name='world'/>"], ("0 0 1", "0 1 0", "0 1 0", "1 0 0", "0 1 0", "1 0 0")
    for k, axis in enumerate(axes):
        links.append(
            f"<link name='l{k}'><inertial><origin xyz='0.01 0.02 0.1'/>"
            f"<mass value='{2.0 - 0.3 * k}'/>"
            "<inertia ixx='0.02' iyy='0.03' izz='0.01' ixy='0' ixz='0' iyz='0'/></inertial></link>"
            f"<joint name='j{k}' type='continuous'><parent link='{f'l{k - 1}' if k else 'world'}'/>"
            f"<child link='l{k}'/><origin xyz='0 0.05 0.2'/><axis xyz='{axis}'/></joint>"
        )
    return _from_file(f"<robot name='arm'>{''.join(links)}</robot>", ".urdf")


def _four_bar() -> System:
    def bar(name: str, place: str, end: str, inner: str = "") -> str:
        return (
            f"<body name='{name}' pos='{place}'><joint name='{name}' axis='0 1 0'/>"
            f"<geom type='capsule' fromto='0 0 0 {end}' size='0.02'/>{inner}</body>"
        )

    crank = bar("crank", "0 0 0", "0 0 0.3", bar("coupler", "0 0 0.3", "0.8 0 0"))
    return _from_file(
        f"<mujoco><worldbody>{crank}{bar('rocker', '0.8 0 0', '0 0 0.3')}</worldbody><equality>"
        "<connect body1='coupler' body2='rocker' anchor='0.8 0 0'/></equality></mujoco>",
        ".xml",
    )


MODELS = {
    "pendulum": _pendulum,
    "bicycle": _bicycle,
    "20 links": _chain,
    "arm from URDF": _arm,
    "closed loop": _four_bar,
}


def main() -> None:
    """Print the seconds of each part as JSON."""
    model, solver = sys.argv[1:]
    system = MODELS[model]()
    system.times = np.linspace(0.0, 0.5, num=51)
    system.ode_solver = solver
    _mark("model")
    system.integrate()
    _mark("integrate")
    wall = time.perf_counter() - _wall
    parts = {name: after - before for (_, before), (name, after) in pairwise(_marks)}
    print(json.dumps({**parts, "all": _marks[-1][1], "wall": wall}))


if __name__ == "__main__":
    main()
