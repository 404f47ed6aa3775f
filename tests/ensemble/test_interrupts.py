"""Ctrl-C, as a shell sends it to a process, while trajectories are integrated one by one."""

import contextlib
import os
import pickle
import signal
import subprocess
import sys
import textwrap
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from optional import optional
from pydy.ensemble import engine, store
from pydy.errors import EnsembleInterrupted
from pydy.models import multi_mass_spring_damper
from zoo.ensemble_cases import constant, pendulum

xr = optional("xarray")

PATIENCE = 120.0  # seconds on a busy machine, where 0.1 are meant

# The first of four samples ends at once, the others would take hours.
SCRIPT = """
    import gc
    import signal
    import sys
    import threading

    import dask
    import sympy as sm

    import zoo
    from zoo.cases import system_of
    from pydy.ensemble import store
    from pydy.models import multi_mass_spring_damper
    from pydy.solvers import Event

    signal.signal(signal.SIGINT, signal.default_int_handler)
    gc.disable()  # see `uncollected`
    write = store.write


    def missed():
        # In this thread: the main one waits on, as if the signal had come right before its wait.
        signal.pthread_kill(threading.get_ident(), signal.SIGINT)


    def asked(kind):
        if kind == "projection":
            return system_of(zoo.fourbar()), sm.Symbol("g"), {"constraints": "project"}
        system = multi_mass_spring_damper(apply_external_forces=True)
        varied = next(s for s in system.constants_symbols if s.name == "k0")
        (force,) = system.specifieds_symbols
        x, v = system.states
        system.initial_conditions = {x: 1.0}
        options = {
            "function": {"specifieds": {force: lambda x, t: 0.0}},
            "events": {"events": [Event(x - 1e9)]},
            "radau": {"ode_solver": "radau"},
            "dask": {"specifieds": {force: lambda x, t: 0.0}},
        }
        return system, varied, options[kind]


    for line in sys.stdin:
        kind, path = line.split(maxsplit=1)
        system, varied, options = asked(kind)
        dask.config.set(scheduler="threads" if kind == "dask" else None, num_workers=4)

        def tell(*arguments):
            write(*arguments)
            print("written", flush=True)
            if kind == "function":
                threading.Timer(0.3, missed).start()

        store.write = tell
        try:
            system.integrate_ensemble(
                constants={varied: [1.0, 1e14, 1e14, 1e14]},
                times=[0.0, 1.0, 2.0],
                max_steps=10**15,
                chunks=1,
                workers=2,
                store=path.strip(),
                resume="x",
                **options,
            )
        except KeyboardInterrupt:
            print("interrupted", flush=True)
"""


@pytest.fixture(scope="module")
def process(tmp_path_factory):
    """A process that makes the ensemble of each line, and ends when no more come."""
    script = tmp_path_factory.mktemp("interrupted") / "script.py"
    script.write_text(textwrap.dedent(SCRIPT), "utf-8")
    tests = Path(__file__).parents[1]
    process = subprocess.Popen(
        [sys.executable, str(script)],
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(tests), *sys.path])},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    with process:
        try:
            yield process
            process.stdin.close()
            assert process.wait(timeout=PATIENCE) == 0  # nothing goes on behind an interrupt
        finally:
            process.kill()


@pytest.mark.parametrize("kind", ["function", "events", "radau", "projection", "dask"])
def test_ctrl_c_ends_an_ensemble_and_keeps_the_finished_blocks(tmp_path, kind, process):
    path = tmp_path / "s.zarr"
    watchdog = threading.Timer(300.0, process.kill)
    watchdog.start()
    try:
        process.stdin.write(f"{kind} {path}\n")
        process.stdin.flush()
        assert process.stdout.readline() == "written\n"
        if kind != "function":  # which sends it itself
            time.sleep(0.3)  # the others are under way
            process.send_signal(signal.SIGINT)
        assert process.stdout.readline() == "interrupted\n"
    finally:
        watchdog.cancel()
    status = xr.open_zarr(path, consolidated=False).status.values
    assert status.tolist() == [0, -1, -1, -1]


def test_ctrl_c_strikes_nowhere_where_this_thread_may_have_the_lock_of_a_future(
    monkeypatch, tmp_path
):
    """Raised there, it left the lock taken, and the thread that had a result waited for ever."""
    returned = []

    def struck(*arguments):
        if not returned:
            signal.raise_signal(signal.SIGINT)
        returned.append(wait(*arguments))
        return returned[-1]

    wait = engine.wait
    monkeypatch.setattr(engine, "wait", struck)
    system = multi_mass_spring_damper()
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            system.integrate_ensemble(
                constants={constant(system, "k0"): np.linspace(1.0, 2.0, num=4)},
                times=[0.0, 1.0], ode_solver="radau", workers=2, chunks=1,
                store=tmp_path / "s.zarr", resume="x",
            )  # fmt: skip
        assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    finally:
        signal.signal(signal.SIGINT, before)
    assert returned


@pytest.mark.parametrize("reduce", [None, "final", lambda dataset: dataset[["x0"]].max("time")])
def test_finished_samples_in_memory_are_handed_over(reduce):
    system = multi_mass_spring_damper(apply_external_forces=True)
    (force,) = system.specifieds_symbols
    x, _ = system.states
    stiffness = constant(system, "k0")
    calls = []

    def push(x, t):
        if abs(x[1]) > 1e5:  # one of the samples that take hours
            calls.append(t)
            if len(calls) == 100:
                os.kill(os.getpid(), signal.SIGINT)
        return 0.0

    k = np.array([1.0] * 8 + [1e14] * 8)
    options = {"constants": {stiffness: k}, "times": [0.0, 1.0, 2.0], "max_steps": 10**15}
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(EnsembleInterrupted, match="8 of 16 samples are finished") as caught:
            system.integrate_ensemble(
                initial_conditions={x: 1.0},
                specifieds={force: push},
                reduce=reduce,
                workers=1,
                **options,
            )
    finally:
        signal.signal(signal.SIGINT, before)
    results = caught.value.results
    assert results.status.values.tolist() == [0] * 8 + [-1] * 8
    assert np.isfinite(results.x0[:8]).all()
    assert np.isnan(results.x0[8:]).all()
    assert pickle.loads(pickle.dumps(caught.value)).results.identical(results)


@pytest.mark.parametrize("workers", [1, 2])
def test_finished_samples_are_handed_over_where_memory_ends(workers):
    system = multi_mass_spring_damper(apply_external_forces=True)
    (force,) = system.specifieds_symbols
    system.initial_conditions, system.times = {"x0": 1.0}, [0.0, 1.0, 2.0]
    k0 = np.arange(1.0, 18.0)  # three blocks: one has ended when the last begins
    whole = system.integrate_ensemble(constants={"k0": k0}, specifieds={force: lambda x, t: 0.0})

    def push(x, t):
        if x[0] > 1.5:  # the last sample alone starts from there
            raise MemoryError("no more")
        return 0.0

    x0 = np.array([1.0] * 16 + [2.0])
    with pytest.raises(MemoryError, match="no more") as caught:
        system.integrate_ensemble(
            constants={"k0": k0},
            initial_conditions={"x0": x0},
            specifieds={force: push},
            workers=workers,
        )
    assert any("of 17 samples are finished" in note for note in caught.value.__notes__)
    results = caught.value.results
    done = results.status.values == 0
    assert done.sum() >= 8  # the others may be under way
    assert (results.status.values[~done] == -1).all()
    np.testing.assert_array_equal(results.x0.values[done], whole.x0.values[done])
    assert np.isnan(results.x0.values[~done]).all()


class _AlarmError(Exception):
    pass


@pytest.mark.skipif(not hasattr(signal, "SIGALRM"), reason="no alarms")
def test_what_a_signal_handler_raises_while_a_store_is_made_arrives(tmp_path, monkeypatch):
    """Zarr writes in a thread of its own: what it writes to must not be removed meanwhile."""
    system, make, written, begun = pendulum(), store._array, [], threading.Event()

    def slow(group, name, *rest):
        if not written:
            written.append(threading.Thread(target=fill, args=(Path(group.store.root, name),)))
            written[0].start()
            assert begun.wait(PATIENCE)
            signal.raise_signal(signal.SIGALRM)
        return make(group, name, *rest)

    def fill(folder):
        folder.mkdir()
        parts = [folder / f"part {k}" for k in range(2000)]
        for part in parts:
            part.touch()
        begun.set()
        with contextlib.suppress(OSError):  # the folder has been removed, or is in its place
            while all(part.exists() for part in parts[::200]):
                time.sleep(0.0001)
            for k in range(1000):
                (folder / f"late {k}").touch()

    def alarm(*_):
        signal.signal(signal.SIGALRM, signal.SIG_IGN)
        raise _AlarmError

    before = signal.signal(signal.SIGALRM, alarm)
    monkeypatch.setattr(store, "_array", slow)
    try:
        with pytest.raises(_AlarmError):
            system.integrate_ensemble(
                initial_conditions={"q1": [0.1, 0.2]}, store=tmp_path / "s.zarr"
            )
    finally:
        signal.signal(signal.SIGALRM, before)
        written[0].join()
    assert [path.name for path in tmp_path.iterdir()] in ([], ["s.zarr"])


def test_memory_that_ends_before_anything_is_finished_is_told_as_that(monkeypatch):
    """What had room by then was taken for results, of which `status` was looked for."""
    system = multi_mass_spring_damper(apply_external_forces=True)
    (force,) = system.specifieds_symbols
    system.initial_conditions, system.times = {"x0": 1.0}, [0.0, 1.0]
    numbers = iter(range(100))

    class Full:
        def __getattr__(self, name):
            return getattr(np, name)

        def empty(self, *given):
            if next(numbers) == 2:
                raise MemoryError("no more")
            return np.empty(*given)

    monkeypatch.setattr("pydy.ensemble.engine.np", Full())
    with pytest.raises(MemoryError, match="no more"):
        system.integrate_ensemble(
            constants={"k0": np.arange(1.0, 18.0)}, specifieds={force: lambda x, t: 0.0}, workers=1
        )
