"""Where an ensemble is computed changes nothing: threads, Dask's schedulers, stores that resume."""

import importlib
import os
import pickle
import pickletools
import signal
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

from optional import optional
from pydy.ensemble import store as stores
from zoo.ensemble_cases import constant, identical, pendulum, random_values, same_bits

xr = optional("xarray")

dask = optional("dask")
optional("zarr")


@pytest.mark.parametrize("chunks", [1, 7, 64, 1000, "auto", {"sample": 30}])
def test_the_size_of_chunks_changes_no_bit(reference, chunks):
    system, values, whole = reference
    lazy = system.integrate_ensemble(**values, chunks=chunks)
    assert dask.is_dask_collection(lazy.q1)
    identical(lazy.compute(scheduler="threads"), whole)


def test_arrays_that_change_before_it_is_computed_change_nothing(reference):
    system, values, whole = reference
    own = {key: {s: np.array(v) for s, v in part.items()} for key, part in values.items()}
    lazy = system.integrate_ensemble(**own, chunks=20)
    for array in (v for part in own.values() for v in part.values()):
        array[...] = 0.5
    identical(lazy.compute(scheduler="threads"), whole)


def test_a_product_is_computed_in_blocks_of_its_dimensions(reference):
    system, _, _ = reference
    grid = {
        "initial_conditions": {system.states[1]: np.linspace(-1.0, 1.0, num=5)},
        "constants": {constant(system, "g"): [1, 2, 3]},
        "product": True,
    }
    whole = system.integrate_ensemble(**grid)
    lazy = system.integrate_ensemble(**grid, chunks={"initial_q1": 2, "g": 2})
    assert lazy.q1.chunks[:2] == ((2, 2, 1), (2, 1))
    identical(lazy.compute(), whole)


def test_processes_need_neither_sympy_nor_the_system(reference):
    system, values, whole = reference
    code = (
        "import pickle, sys; from pathlib import Path\n"
        "work, samples = pickle.loads(Path(sys.argv[1]).read_bytes())\n"
        "found = work(samples)\n"
        "assert 'sympy' not in sys.modules\n"
        "Path(sys.argv[2]).write_bytes(found['q1'].values.tobytes())\n"
    )
    ensemble = _ensemble(system, values)
    folder = Path(os.environ["PYDY_CACHE_DIR"])
    folder.mkdir(exist_ok=True)
    given, found = folder / "work.pickle", folder / "found"
    given.write_bytes(pickle.dumps((ensemble.work, ensemble.samples)))
    done = subprocess.run(
        [sys.executable, "-c", code, given, found], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    assert found.read_bytes() == whole.q1.values.tobytes()


def _ensemble(system, values, **options):
    """What the System would run."""
    taken = {}

    def take(self):
        taken["ensemble"] = self
        return self

    from pydy.ensemble.engine import Ensemble

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Ensemble, "run", take)
        return system.integrate_ensemble(**values, **options)


# -- stores ---------------------------------------------------------------------------------------


def test_a_store_holds_the_results(reference, tmp_path):
    system, values, whole = reference
    made = system.integrate_ensemble(**values, store=tmp_path / "s.zarr", chunks=25)
    identical(made.load(), whole)
    again = xr.open_zarr(tmp_path / "s.zarr", consolidated=False)
    identical(again.load(), whole)
    assert again.q1.attrs == whole.q1.attrs


def test_only_what_is_missing_in_a_store_is_computed(reference, tmp_path):
    system, values, whole = reference
    path = tmp_path / "s.zarr"
    system.integrate_ensemble(**values, store=path, chunks=25)
    (path / "status" / "c" / "1").unlink()  # never finished
    (path / "q1" / "c" / "1" / "0").write_bytes(b"half")  # and half written
    (path / "status" / "c" / "3").write_bytes(b"")  # the last thing a killed process did
    from pydy.ensemble.work import Work

    done = []
    with pytest.MonkeyPatch.context() as patch:
        call = Work.__call__
        patch.setattr(
            Work, "__call__", lambda self, s, *a: done.append(s.size) or call(self, s, *a)
        )
        made = system.integrate_ensemble(**values, store=path, chunks=25, resume=True)
    assert done == [25, 25]
    identical(made.load(), whole)


def test_a_store_of_another_ensemble_is_left_alone(reference, tmp_path):
    system, values, _ = reference
    path = tmp_path / "s.zarr"
    system.integrate_ensemble(**values, store=path, chunks=50)
    with pytest.raises(ValueError, match="Pass resume=True"):
        system.integrate_ensemble(**values, store=path, chunks=50)
    with pytest.raises(ValueError, match="was written by another ensemble"):
        system.integrate_ensemble(**values, store=path, chunks=50, resume=True, rtol=1e-3)


def test_a_function_that_raises_names_its_samples_and_leaves_the_finished(reference, tmp_path):
    system, values, whole = reference
    path = tmp_path / "s.zarr"
    wrong = [True]

    def picky(dataset):
        if (
            wrong[0]
            and dataset.sizes["sample"] > 1
            and dataset.initial_q1[0] == whole.initial_q1[60]
        ):
            raise ZeroDivisionError("no")
        return dataset[["q1"]]

    options = {"store": path, "chunks": 20, "reduce": picky, "workers": 1, "resume": "picky"}
    with pytest.raises(ZeroDivisionError, match="no") as caught:
        system.integrate_ensemble(**values, **options)
    assert any("samples sample 60 to 79" in note for note in caught.value.__notes__)
    wrong[0] = False
    made = system.integrate_ensemble(**values, **options)
    assert same_bits(made.q1, whole.q1)


def test_an_interrupt_ends_the_work_within_a_moment_and_keeps_finished_blocks(
    tmp_path, monkeypatch
):
    system = pendulum(2)
    values = random_values(system, 4000)
    store = tmp_path / "s.zarr"
    options = {"store": store, "chunks": 100, "times": np.linspace(0.0, 20.0, num=5)}

    write = stores.write

    def interrupt_after_a_block(*arguments):
        write(*arguments)
        monkeypatch.setattr(stores, "write", write)
        signal.pthread_kill(threading.main_thread().ident, signal.SIGINT)

    system.integrate_ensemble(
        initial_conditions={s: v[:2] for s, v in values["initial_conditions"].items()}
    )  # whatever has to be compiled
    # Where the tests run in the background, a shell has SIGINT ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    monkeypatch.setattr(stores, "write", interrupt_after_a_block)
    try:
        with pytest.raises(KeyboardInterrupt):
            system.integrate_ensemble(**values, **options, rtol=1e-11, atol=1e-11)
    finally:
        signal.signal(signal.SIGINT, before)
    status = xr.open_zarr(store, consolidated=False).status.values
    blocks = status.reshape(-1, 100)
    assert (blocks == 0).any()
    assert ((blocks == 0).all(axis=1) | (blocks == -1).all(axis=1)).all()
    assert (blocks == -1).any()


# -- without Dask ---------------------------------------------------------------------------------


def test_threads_of_the_standard_library_serve_without_dask(reference, monkeypatch):
    system, values, whole = reference
    monkeypatch.setitem(sys.modules, "dask", None)
    identical(system.integrate_ensemble(**values), whole)
    with pytest.raises(ImportError, match=r"pip install 'pydy\[ensemble\]'"):
        system.integrate_ensemble(**values, chunks=10)


def test_a_bar_counts_samples(reference, capsys):
    pytest.importorskip("tqdm")
    system, values, _ = reference
    system.integrate_ensemble(**values, progress=True)
    assert "100/100" in capsys.readouterr().err


def test_a_bar_is_shown_before_the_first_samples_with_feedback(capsys):
    pytest.importorskip("tqdm")
    system, shown = pendulum(), []
    force = next(iter(system.specifieds_symbols))

    def feedback(x, t):
        if not shown:
            shown.append(capsys.readouterr().err)
        return -x[0]

    system.specifieds = {force: feedback}
    values = random_values(system, 40)
    system.integrate_ensemble(**values, workers=1, progress=True)
    assert "0/40" in shown[0]
    assert "40/40" in capsys.readouterr().err


def test_a_task_carries_the_values_of_its_samples_once_and_dask_takes_none_apart(monkeypatch):
    delayed = importlib.import_module("dask.delayed")
    system = pendulum()
    values, opened = random_values(system, 4000), []
    take_apart = delayed.unpack_collections

    def counted(expression, **options):
        opened.append(type(expression))
        return take_apart(expression, **options)

    monkeypatch.setattr(delayed, "unpack_collections", counted)
    lazy = system.integrate_ensemble(**values, chunks=1000, reduce="final")
    graph = dict(lazy.__dask_graph__())
    blocks = [key for key in graph if key[0].startswith("block-")]
    assert len(blocks) == 4
    varied = sum(map(len, values.values()))
    for key in blocks:  # values of eight bytes, and the names of arrays
        assert 8000 * varied < len(pickle.dumps(graph[key])) < 8000 * varied + 4000
    # Besides, the work that all blocks share, and for each variable of a block its name.
    variables = [key for key in graph if "-of-block-" in key[0]]
    assert len(variables) == 4 * len(lazy.data_vars)
    assert max(len(pickle.dumps(graph[key])) for key in variables) < 300
    assert len(graph) == 1 + len(blocks) + len(variables)
    assert not opened


def test_a_block_is_one_task_and_a_reduction_of_a_variable_another():
    system = pendulum()
    values, called = random_values(system, 40), []
    lazy = system.integrate_ensemble(**values, chunks=10, reduce="final")

    def watch(key, *_):
        called.append(key[0] if isinstance(key, tuple) else key)

    from dask.callbacks import Callback

    with Callback(pretask=watch):
        dask.compute(lazy.q1.mean(), lazy.u1.max(), scheduler="synchronous")
    integrated = [
        key for key in called if key.startswith("block-") and len(key) == len("block-") + 32
    ]
    assert len(integrated) == 4
    # Each of two reductions: one task for a block and its new name, and those that combine four.
    assert len(called) - len(integrated) <= 2 * (2 * 4 + 3)


def test_events_reach_workers_without_their_expressions():
    from pydy.solvers import Event

    system = pendulum(ode_solver="dop853")
    event = Event(system.speeds[1], name="turning")
    ensemble = _ensemble(system, random_values(system, 4), events=[event], reduce="events")
    opcodes = pickletools.genops(pickle.dumps(ensemble.work))
    names = {argument for _, argument, _ in opcodes if isinstance(argument, str)}
    assert "pydy.solvers.compiled_events" in names
    assert not [name for name in names if name.startswith("sympy")]


@pytest.mark.parametrize("logged", [1, 3])
def test_reduced_events_of_lanes_need_no_object_for_each_event(monkeypatch, logged):
    from pydy.ensemble import model
    from pydy.solvers import Event

    system = pendulum(ode_solver="dop853")
    event = Event(system.speeds[1], name="turning")
    values = random_values(system, 40)
    values["constants"][constant(system, "g")] *= 20.0
    built = []
    record = model.EventRecord
    monkeypatch.setattr(model, "EventRecord", lambda *a: built.append(a) or record(*a))
    results = system.integrate_ensemble(**values, events=[event], reduce=("events", logged))
    assert not built
    assert results.turning_count.sum() > 20
    for k in (0, 17, 39):
        for kind, columns in values.items():
            setattr(system, kind, {symbol: column[k] for symbol, column in columns.items()})
        alone = system.simulate(events=[event])
        times = [e.time for e in alone.events]
        assert results.turning_count[k] == len(times)
        expected = np.full(logged, np.nan)
        expected[: len(times)] = times[:logged]
        assert same_bits(results.turning_times[k], expected)
