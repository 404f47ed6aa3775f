"""Stores on Windows and macOS: folders of arrays have names that every system takes."""

import re

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from optional import optional
from pydy.ensemble.store import file_names
from pydy.system import System
from zoo.ensemble_cases import identical

xr = optional("xarray")

NAMES = [
    "q",
    "Q",
    "\\theta",
    "/theta",
    "a/b",
    "a:b*",
    "x?",
    "aux",
    "CON.txt",
    "..",
    ".",
    "a.",
    "__a",
]
NAMES += ["∫ y dt", "zarr.json", "é", "É", "Q_2", "q_2", "", " ", "\n", "c", "x y", "pydy_chunks"]


def folders_serve(names):
    """Whether folders of these names can lie side by side on every system."""
    folded = [name.casefold() for name in names]
    device = re.compile(r"(aux|con|nul|prn|com\d|lpt\d)(\..*)?", re.IGNORECASE)
    return len(set(folded)) == len(folded) and not any(
        re.search(r'[\x00-\x1f<>:"/\\|?* ]|^\.|\.$|^$', name) or device.fullmatch(name)
        for name in names
    )


def test_folders_of_all_names_can_lie_side_by_side():
    found = file_names(NAMES)
    assert list(found) == NAMES
    assert not folders_serve(NAMES)
    assert folders_serve(found.values())


def test_names_that_serve_are_kept():
    names = ["q1", "Q2", "θ", "end_time", "x.1", "l (varied)".replace(" ", "_"), "c"]
    assert file_names(names) == dict(zip(names, names, strict=True))
    assert file_names(["a/b", "a_b"]) == {"a/b": "a_b_2", "a_b": "a_b"}


def pendulum(q, u, output):
    """A pendulum whose coordinate, speed and output have these names."""
    q, u = (sm.Function(name)(me.dynamicsymbols._t) for name in (q, u))
    m, g, l = sm.symbols("m g l")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    arm = frame.orientnew("A", "Axis", (q, frame.z))
    arm.set_ang_vel(frame, u * frame.z)
    origin.set_vel(frame, 0)
    bob = origin.locatenew("P", l * arm.x)
    bob.v2pt_theory(origin, frame, arm)
    kane = me.KanesMethod(frame, [q], [u], kd_eqs=[q.diff() - u])
    kane.kanes_equations([me.Particle("bob", bob, m)], [(bob, m * g * frame.x)])
    return System(
        kane,
        initial_conditions={q: 0.1},
        times=np.linspace(0.0, 1.0, 3),
        outputs={sm.Symbol(output): q**2},
    )


@pytest.mark.parametrize(
    "names", [("q", "Q", "M"), (r"\theta", r"\omega", "a/b"), ("aux", "con", "∫ y dt")]
)
def test_results_come_back_under_their_own_names(names, tmp_path):
    system, path = pendulum(*names), tmp_path / "s.zarr"
    values = {"constants": {"l": xr.DataArray(np.linspace(1.0, 2.0, 6), dims=r"\ell")}}
    whole = system.integrate_ensemble(**values)
    made = system.integrate_ensemble(**values, store=path, chunks=2)
    identical(made.load(), whole)
    assert folders_serve([folder.name for folder in path.iterdir() if folder.is_dir()])
    status = xr.open_zarr(path, consolidated=False).status
    assert status.dims == ("_ell",)
    (path / "status" / "c" / "1").unlink()
    again = system.integrate_ensemble(**values, store=path, chunks=2, resume=True)
    identical(again.load(), whole)


def test_a_coordinate_whose_name_has_blanks_stays_one(tmp_path):
    system = pendulum("q of x", "u", "y")
    (angle, _) = system.states
    values = {"initial_conditions": {angle: [0.1, 0.2]}}
    made = system.integrate_ensemble(**values, store=tmp_path / "s.zarr")
    assert set(made.coords) == set(system.integrate_ensemble(**values).coords)
