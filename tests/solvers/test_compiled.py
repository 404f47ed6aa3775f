"""When numba is loaded, what is compiled, and where it is kept."""

import os
import subprocess
import sys

import pytest

from pydy.solvers import compiled

RUN = """
import logging, sys
logging.basicConfig(level=logging.WARNING, format="%(name)s:%(message)s", stream=sys.stdout)
from pydy.solvers import dop853
print(dop853(lambda x, t: -x, [1.0], [0.0, 1.0], rtol=1e-10, atol=1e-10)[1, 0])
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


@pytest.fixture
def warm(tmp_path):
    """A cache folder with a compiled solver, as `run` left it."""
    first = run(RUN, PYDY_CACHE_DIR=str(tmp_path))
    assert first.count(ANNOUNCED) == 1
    assert abs(float(first[-1]) - 0.36787944117144233) < 1e-9
    return tmp_path


def test_compiling_is_announced_once_and_kept_and_a_spoiled_entry_is_a_miss(warm):
    # One test, since each miss takes half a minute.
    files = sorted((warm / "solvers").rglob("*.nb?"))
    assert {f.suffix for f in files} == {".nbi", ".nbc"}
    again = run(RUN, PYDY_CACHE_DIR=str(warm))
    assert ANNOUNCED not in again
    assert len(again) == 1
    for file in files:
        file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])
    spoiled = run(RUN, PYDY_CACHE_DIR=str(warm))
    assert spoiled.count(ANNOUNCED) == 1
    assert spoiled[-1] == again[-1]
    assert run(RUN, PYDY_CACHE_DIR=str(warm)) == again


def test_without_a_cache_a_solver_is_compiled_without_a_trace(tmp_path):
    out = run(RUN, PYDY_CACHE_DIR="off", XDG_CACHE_HOME=str(tmp_path))
    assert abs(float(out[-1]) - 0.36787944117144233) < 1e-9
    assert not list(tmp_path.rglob("*.nb?"))
