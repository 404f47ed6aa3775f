"""Settings for all tests: compiled code goes to a folder of their own, and no windows open."""

from __future__ import annotations

import gc
import os
import sys
import tempfile
from pathlib import Path

import pytest
from _pytest.doctest import DoctestModule

import parts
import timing

if "PYTEST_XDIST_WORKER" not in os.environ:  # workers share that of the process that starts them
    _FOLDER = tempfile.TemporaryDirectory(prefix="pydy-tests-", ignore_cleanup_errors=True)
    os.environ["PYDY_CACHE_DIR"] = _FOLDER.name
os.environ.setdefault("MPLBACKEND", "Agg")  # pictures are drawn, not shown
# On a busy machine the threads of OpenBLAS wait for each other: the singular values of 230 rows
# took seconds, and one thread 10 ms.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


def _raise_on_old_names():
    """Have attributes that SymPy 1.15 deprecates raise, unless an older SymPy itself reads them."""
    from sympy.physics.mechanics import KanesMethod, LagrangesMethod

    def refusing(own):
        def read(self):
            if sys._getframe(1).f_globals["__name__"].startswith("sympy."):
                return own.fget(self)
            raise DeprecationWarning(f"`{own.fget.__name__}` is deprecated since SymPy 1.15")

        return property(read)

    for method in (KanesMethod, LagrangesMethod):
        for name in ("forcelist", "bodylist"):
            if name in vars(method):
                setattr(method, name, refusing(vars(method)[name]))


_raise_on_old_names()

# SymPy's expressions, of which tests keep many, hold no cycles: looking for them at the usual
# thresholds took 15 % of the tests' time. All are looked through whenever two million were made.
gc.set_threshold(100_000, 10, 2)

ROOT = Path(__file__).parents[1]


def pytest_configure(config):
    """Measure the processor time of every test."""
    config.pluginmanager.register(timing.Times())


@pytest.hookimpl(wrapper=True)
def pytest_collection(session):
    """Look for no garbage while tests are collected."""
    gc.disable()
    yield
    gc.enable()


@pytest.hookimpl(wrapper=True)
def pytest_collect_file(file_path):
    """Look for doctests in `src` only: the 250 files of `tests` have none."""
    collectors = yield
    if ROOT / "tests" not in file_path.parents:
        return collectors
    return [c for c in collectors if not isinstance(c, DoctestModule)]


def _examples_of_hypothesis_by_its_seed_alone():
    """Have Hypothesis take no constants from the modules that happen to be loaded.

    Which those are depends on the tests that a worker was given: examples of a seed would differ.
    """
    if "hypothesis" in sys.modules:
        from hypothesis.internal.conjecture import providers

        providers._get_local_constants = lambda: providers._local_constants


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config, items):
    """Keep the cases that a run of all tests tries; where files or tests are named, all of theirs.

    What was collected is stored first: `test_parts.py` compares the table of slow tests with it.
    """
    _examples_of_hypothesis_by_its_seed_alone()
    config.stash[parts.COLLECTED] = [item.nodeid for item in items]
    everything = any(Path(argument).resolve() == ROOT / "tests" for argument in config.args)
    if not everything and parts.WHOLE_FILES is None:
        return
    tried = parts.tried(item.nodeid for item in items)
    config.hook.pytest_deselected(items=[item for item in items if item.nodeid not in tried])
    # The longest first, so that no worker waits for the other at the end.
    items[:] = sorted(
        (item for item in items if item.nodeid in tried),
        key=lambda item: parts.function_of(item.nodeid) not in parts.DRAWING,
    )


@pytest.fixture(scope="session", autouse=True)
def _nothing_is_left_behind():
    """Have files that tests write lie in temporary folders, not in the project's own."""
    before = set(os.listdir(ROOT))
    yield
    new = {name for name in set(os.listdir(ROOT)) - before if not name.startswith((".", "build"))}
    assert not new, f"tests have written {sorted(new)} in {ROOT}"


@pytest.fixture
def uncollected():
    """Collect no garbage: what is raised in a callback of the collector (JAX has one) is lost."""
    gc.disable()
    yield
    gc.enable()
