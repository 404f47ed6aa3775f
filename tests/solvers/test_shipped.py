"""The compiled loops that the package ships: what they are made from, when they are compiled."""

import os
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest
import solvers_ir

from pydy._backends.llvm import native
from pydy._backends.llvm.emit import solver_names
from pydy.models import multi_mass_spring_damper
from pydy.solvers import layout, tuning
from pydy.solvers.core import declarations
from pydy.solvers.run import shipped
from pydy.solvers.solver import SOLVERS

ENTRIES = sorted(solvers_ir.ENTRIES)


def run(code, **environment):
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, **environment},
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


# -- what is shipped ------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ENTRIES)
def test_the_ir_is_made_from_the_sources_as_they_are(name):
    assert solvers_ir.recorded(name) == solvers_ir.digest(name), "run `make solvers-ir`"


def test_there_is_ir_for_each_entry_and_for_nothing_else():
    folders = solvers_ir.SOLVERS, solvers_ir.GATES
    assert sorted(path.stem for folder in folders for path in folder.glob("*.ll")) == ENTRIES


@pytest.mark.parametrize("name", ENTRIES)
def test_the_ir_is_what_the_compiler_makes_of_the_sources(name):
    pytest.importorskip("ziglang")
    assert solvers_ir.written(name) == solvers_ir.ir(name).read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ENTRIES)
def test_the_ir_is_for_no_processor_and_needs_libm_or_python_alone(name):
    text = solvers_ir.ir(name).read_text(encoding="utf-8")
    assert not re.search(r"^target |target-cpu|target-features", text, flags=re.MULTILINE)
    called = set(re.findall(r"^declare [^@]*@([\w.]+)", text, flags=re.MULTILINE))
    known = solvers_ir.PYTHON if name == "gates" else solvers_ir.LIBRARY
    assert {f for f in called if not f.startswith("llvm.")} <= known
    assert not re.search(r"inttoptr \(i64 \d", text)  # an address of the process that wrote it
    outside = re.findall(r"^define (?!internal)[^@]*@([\w.]+)", text, flags=re.MULTILINE)
    kind, _, lanes = name.partition("_")
    expected = {
        "gates": native._GATES,
        "nlp": native.NLP,
        "solve": solver_names(int(lanes or 0) if kind == "solve" else 0),
    }
    assert sorted(outside) == sorted(expected.get(kind, [name]))


def test_the_digest_depends_on_every_file_that_an_entry_is_made_of(tmp_path, monkeypatch):
    names = declarations.included("advance.c").keys()
    assert {"advance.c", "run.h", "step.h", "sums.h", "real.h"} <= names
    assert not {"newton.h", "lanes.h", "layout.h"} & names

    first = solvers_ir.digest("advance")
    shutil.copytree(declarations.FOLDER, tmp_path / "core")
    monkeypatch.setattr(declarations, "FOLDER", tmp_path / "core")
    assert solvers_ir.digest("advance") == first
    far = tmp_path / "core" / "real.h"
    far.write_text(far.read_text(encoding="utf-8") + "\n", encoding="utf-8")
    assert solvers_ir.digest("advance") != first


def test_the_digest_depends_on_the_tuples_and_numbers_of_python(monkeypatch):
    first = solvers_ir.digest("advance")
    monkeypatch.setattr(tuning, "SLIVER", 0.5 * tuning.SLIVER)
    other = solvers_ir.digest("advance")
    assert other != first
    monkeypatch.setattr(tuning, "FOR_PYTHON_ALONE", 0.5, raising=False)
    assert solvers_ir.digest("advance") == other
    monkeypatch.setattr(layout.Memory, "_fields", layout.Memory._fields[::-1])
    assert solvers_ir.digest("advance") not in (first, other)


# -- at first use ---------------------------------------------------------------------------------


ASK = "from pydy.solvers.run import shipped; print(shipped.address_of('evaluate_lanes') != 0)"
EXPLICIT = (
    "from pydy.solvers import dop853; print(dop853(lambda x, t: -x, [1.0], [0.0, 1.0]).shape)"
)


def test_an_entry_is_compiled_once_and_kept(tmp_path):
    assert run(ASK, PYDY_CACHE_DIR=str(tmp_path)) == ["True"]
    (entry,) = tmp_path.rglob("*.code")
    entry.touch()
    before = entry.stat().st_ino
    assert run(ASK, PYDY_CACHE_DIR=str(tmp_path)) == ["True"]
    assert [path.stat().st_ino for path in tmp_path.rglob("*.code")] == [before]


def test_an_explicit_method_compiles_its_own_loop_alone(tmp_path):
    run(EXPLICIT, PYDY_CACHE_DIR=str(tmp_path))
    # Where that takes long, the gates are compiled beside it.
    loops = [code for p in tmp_path.rglob("*.code") if b"advance" in (code := p.read_bytes())]
    assert len(loops) == 1
    assert b"advance_implicit" not in loops[0]


@pytest.mark.parametrize("share", [0.0, 0.5])
def test_a_damaged_entry_is_compiled_again(tmp_path, share):
    run(ASK, PYDY_CACHE_DIR=str(tmp_path))
    (entry,) = tmp_path.rglob("*.code")
    whole = entry.read_bytes()
    entry.write_bytes(whole[: int(share * len(whole))])
    assert run(ASK, PYDY_CACHE_DIR=str(tmp_path)) == ["True"]
    assert entry.read_bytes() == whole


def test_without_a_cache_nothing_is_left(tmp_path):
    assert run(ASK, PYDY_CACHE_DIR="off", XDG_CACHE_HOME=str(tmp_path)) == ["True"]
    assert not list(tmp_path.rglob("*.code"))


def test_a_run_is_the_same_where_numpys_arrays_are_laid_out_otherwise(monkeypatch):
    system = multi_mass_spring_damper()
    system.times, system.initial_conditions = [0.0, 1.0, 2.0], {system.states[0]: 1.0}
    for name, solver in SOLVERS.items():
        accuracy = {"rtol": 1e-6} if solver.adaptive else {"step": 0.01}
        system.ode_solver = name
        expected = system.integrate(**accuracy)
        with monkeypatch.context() as patch:
            patch.setattr(shipped, "FITS", False)
            np.testing.assert_array_equal(system.integrate(**accuracy), expected)
