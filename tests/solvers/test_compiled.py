"""When numba is loaded, what is compiled, and where it is kept."""

import os
import subprocess
import sys

import pytest

from pydy.solvers import compiled

# A function as small as can be: a solver takes half a minute to compile.
RUN = """
import logging, sys
logging.basicConfig(level=logging.WARNING, format="%(name)s:%(message)s", stream=sys.stdout)
from pydy.solvers.compiled import compiled, inlined
@inlined
def twice(x):
    return 2.0 * x
@compiled
def next_to(x):
    return twice(x) + 1.0
print(next_to(20.5))
"""
ANNOUNCED = "pydy:Compiling a solver, once on this machine: this takes some seconds."


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


@pytest.mark.parametrize(
    "statement",
    [
        "import pydy.solvers",
        "import pydy.system",
        "from pydy.solvers import dop853, Event",
        "from pydy.models import multi_mass_spring_damper as m; s = m(); s.ode_solver = 'radau'",
        "from pydy.models import multi_mass_spring_damper as m; s = m(); s.times = [0, 1]; "
        "s.integrate()",
    ],
)
def test_numba_is_not_loaded_before_a_solver_runs(statement):
    assert run(f"{statement}; import sys; print('numba' in sys.modules)")[-1] == "False"


def test_only_what_python_calls_is_compiled_on_its_own():
    from pydy.solvers import explicit, implicit

    assert explicit.advance._cache is not None
    assert {type(f._cache).__name__ for f in (explicit.advance, implicit.advance_implicit)} == {
        "_Cache"
    }
    assert type(explicit.take_step._cache).__name__ == "NullCache"


def test_the_cache_depends_on_the_text_of_every_module_of_solvers(tmp_path, monkeypatch):
    package = tmp_path / "solvers"
    (package / "tableaus").mkdir(parents=True)
    here, far = package / "compiled.py", package / "tableaus" / "far.py"
    here.write_text("one")
    far.write_text("two")
    monkeypatch.setattr(compiled, "__file__", str(here))
    digest = compiled._digest.__wrapped__
    first = digest()
    far.write_text("three")
    assert digest() != first


def entries(place):
    return sorted((place / "solvers").rglob("*.code"))


def test_compiling_is_announced_and_kept(tmp_path):
    assert run(RUN, PYDY_CACHE_DIR=str(tmp_path)) == [ANNOUNCED, "42.0"]
    assert len(entries(tmp_path)) == 1
    assert run(RUN, PYDY_CACHE_DIR=str(tmp_path)) == ["42.0"]


@pytest.mark.parametrize("part", [0.0, 0.5])
def test_a_spoiled_entry_is_compiled_again(tmp_path, part):
    run(RUN, PYDY_CACHE_DIR=str(tmp_path))
    for file in entries(tmp_path):
        file.write_bytes(file.read_bytes()[: int(part * file.stat().st_size)])
    assert run(RUN, PYDY_CACHE_DIR=str(tmp_path)) == [ANNOUNCED, "42.0"]
    assert run(RUN, PYDY_CACHE_DIR=str(tmp_path)) == ["42.0"]


def test_a_folder_that_cannot_be_written_is_done_without(tmp_path):
    (tmp_path / "file").write_text("in the way")
    out = run(RUN, PYDY_CACHE_DIR=str(tmp_path / "file"))
    assert out[-1] == "42.0"


def test_without_a_cache_nothing_is_left(tmp_path):
    assert run(RUN, PYDY_CACHE_DIR="off", XDG_CACHE_HOME=str(tmp_path))[-1] == "42.0"
    assert not list(tmp_path.rglob("*.code"))
