"""resume=True: the same ensemble goes on, another one is refused, what is damaged is mended."""

import json
import os
import shutil
import subprocess
import sys
import textwrap
import warnings

import numpy as np
import pytest

from optional import optional
from pydy.ensemble import store as stores
from pydy.ensemble.work import Work
from pydy.inputs import SampledInput
from pydy.models import multi_mass_spring_damper
from pydy.solvers import Event
from zoo.ensemble_cases import identical, pendulum, random_values

xr = optional("xarray")
zarr = optional("zarr")


@pytest.fixture
def system():
    return multi_mass_spring_damper(apply_external_forces=True)


def run(system, path, **options):
    x, _ = system.states
    usual = {"chunks": 5, "times": [0.0, 0.5, 1.0], "initial_conditions": {x: np.arange(10.0)}}
    return system.integrate_ensemble(store=path, **{**usual, **options})


@pytest.fixture
def computed(monkeypatch):
    """How many samples each computation had, in order."""
    sizes, call = [], Work.__call__

    def counted(work, samples, *rest):
        sizes.append(samples.size)
        return call(work, samples, *rest)

    monkeypatch.setattr(Work, "__call__", counted)
    return sizes


REFUSED = "was written by another ensemble"


def test_resets_of_other_events_are_refused(system, tmp_path):
    x, v = system.states

    def events(first, second):
        return [Event(x - 1, reset=first, name="a"), Event(x - 2, reset=second, name="b")]

    path = tmp_path / "s.zarr"
    run(system, path, events=events({v: -v}, {}))
    with pytest.raises(ValueError, match=REFUSED):
        run(system, path, events=events({}, {v: -v}), resume=True)


def test_other_samples_of_an_input_are_refused(system, tmp_path):
    (force,) = system.specifieds_symbols
    path = tmp_path / "s.zarr"
    run(system, path, specifieds={force: SampledInput([0.0, 1.0], [1.0, 2.0])})
    run(system, path, specifieds={force: SampledInput([0.0, 1.0], [1.0, 2.0])}, resume=True)
    with pytest.raises(ValueError, match=REFUSED):
        run(system, path, specifieds={force: SampledInput([0.0, 1.0], [1.0, 3.0])}, resume=True)


def test_other_labels_of_the_same_numbers_are_refused(system, tmp_path):
    x, _ = system.states
    path = tmp_path / "s.zarr"

    def labelled(first):
        values = xr.DataArray([1.0, 2.0], dims="run", coords={"run": [first, first + 1]})
        return {"initial_conditions": {x: values}}

    run(system, path, **labelled(0))
    run(system, path, **labelled(0), resume=True)
    with pytest.raises(ValueError, match=REFUSED):
        run(system, path, **labelled(7), resume=True)


SCRIPT = """
    import sys
    import numpy as np
    from pydy.models import multi_mass_spring_damper

    def force(x, t):
        return np.sin(t)

    def largest(dataset):
        return dataset[["x0"]].max("time")

    system = multi_mass_spring_damper(apply_external_forces=True)
    (symbol,) = system.specifieds_symbols
    x, _ = system.states
    for name in sys.argv[2:]:
        system.integrate_ensemble(
            initial_conditions={x: [0.0, 1.0]},
            specifieds={symbol: force},
            times=[0.0, 0.5],
            reduce=largest,
            store=sys.argv[1],
            resume=name,
        )
        print(name)
"""


def test_a_new_process_goes_on_under_the_same_name_and_refuses_another(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(textwrap.dedent(SCRIPT), "utf-8")
    outcomes = []
    for seed, names in ((1, ["first"]), (2, ["first", "second"])):
        done = subprocess.run(
            [sys.executable, str(script), str(tmp_path / "s.zarr"), *names],
            env={**os.environ, "PYTHONHASHSEED": str(seed)},
            capture_output=True,
            text=True,
            timeout=300,
        )
        outcomes.append(done)
    assert [o.returncode for o in outcomes] == [0, 1], [o.stderr for o in outcomes]
    assert [o.stdout for o in outcomes] == ["first\n", "first\n"]
    assert REFUSED in outcomes[1].stderr


def test_a_store_says_what_it_differs_in(system, tmp_path):
    x, _ = system.states
    path = tmp_path / "s.zarr"
    run(system, path)
    for what, other in {
        "numbers": {"constants": {"k0": 2.0}},
        "options": {"rtol": 1e-3},
        "`times`": {"times": [0.0, 0.5, 1.5]},
        "`chunks`": {"chunks": 2},
        "`reduce`": {"reduce": "final"},
        "equations": {"events": [Event(x - 100.0, terminal=True)]},
        "options, numbers": {"constants": {"k0": 2.0}, "ode_solver": "tsit5"},
    }.items():
        with pytest.raises(ValueError, match=rf"What differs: {what}\. Pass another path"):
            run(system, path, **other, resume=True)


def test_another_version_refuses_a_store_by_that(system, tmp_path, monkeypatch):
    path = tmp_path / "s.zarr"
    run(system, path)
    monkeypatch.setattr(stores, "__version__", "0.0")
    with pytest.raises(ValueError, match=r"What differs: the version of pydy\."):
        run(system, path, resume=True)


def test_what_is_no_store_of_an_ensemble_is_refused_as_that(system, tmp_path):
    zarr.open_group(tmp_path / "s.zarr", mode="w")
    with pytest.raises(ValueError, match="is not the store of an ensemble"):
        run(system, tmp_path / "s.zarr", resume=True)


# -- labels ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("labels", "others"),
    [
        pytest.param(
            np.array(["a", "b"]),
            np.array(["a", "c"]),
            marks=pytest.mark.filterwarnings("ignore:The data type:FutureWarning"),
        ),
        (np.array(["2020-01-01", "2020-01-02"], "M8[s]"), np.array(["2020-01-01"] * 2, "M8[s]")),
    ],
    ids=["text", "dates"],
)
def test_labels_of_text_and_dates_are_compared_too(system, tmp_path, labels, others):
    x, _ = system.states
    path = tmp_path / "s.zarr"

    def labelled(names):
        return {x: xr.DataArray([1.0, 2.0], dims="run", coords={"run": names})}

    run(system, path, initial_conditions=labelled(labels))
    made = run(system, path, initial_conditions=labelled(labels), resume=True)
    assert made.run.values.tolist() == labels.tolist()
    with pytest.raises(ValueError, match="What differs: numbers"):
        run(system, path, initial_conditions=labelled(others), resume=True)


def test_labels_that_zarr_has_no_type_for_are_refused_with_the_remedy(system, tmp_path):
    x, _ = system.states
    names = np.array(["a", "b"], dtype=object)
    values = xr.DataArray([1.0, 2.0], dims="run", coords={"run": names})
    with pytest.raises(ValueError, match=r"those of `run` are objects.*labels\.astype\(str\)"):
        run(system, tmp_path / "s.zarr", initial_conditions={x: values})


# -- Python functions -----------------------------------------------------------------------------


def scaled(k):
    return lambda dataset: dataset[["x0"]] * k


def push(size):
    return lambda x, t: size * np.sin(t)


class Push:
    """No function by its type, but called like one."""

    def __call__(self, x, t):
        return np.sin(t)


@pytest.mark.parametrize(
    ("functions", "named"),
    [
        ({"reduce": scaled(1.0)}, "`reduce`"),
        ({"specifieds": {"f0": push(1.0)}}, "`specifieds`"),
        ({"specifieds": {"f0": Push()}}, "`specifieds`"),
        ({"reduce": scaled(1.0), "specifieds": {"f0": push(1.0)}}, "`reduce` and `specifieds`"),
    ],
    ids=["reduce", "specifieds", "an object", "both"],
)
def test_functions_need_a_name(system, tmp_path, computed, functions, named):
    path = tmp_path / "s.zarr"
    remedy = rf"Python functions in {named}, and .*resume='name', from the first call on"
    with pytest.raises(ValueError, match=rf"`resume=True` needs more: .*{remedy}"):
        run(system, path, **functions, resume=True)
    assert not computed
    assert not path.exists()
    made = run(system, path, **functions, resume="first version").load()
    computed.clear()
    identical(run(system, path, **functions, resume="first version").load(), made)
    assert not computed
    with pytest.raises(ValueError, match=rf"{REFUSED}.*differs: the name of its functions"):
        run(system, path, **functions, resume="second version")


def test_a_function_that_the_system_has_needs_a_name_too(system, tmp_path):
    system.specifieds = {"f0": push(1.0)}
    with pytest.raises(ValueError, match="Python functions in `specifieds`"):
        run(system, tmp_path / "s.zarr", resume=True)


def test_an_expression_is_no_function_and_is_compared(system, tmp_path):
    x, _ = system.states
    path = tmp_path / "s.zarr"
    run(system, path, specifieds={"f0": -x})
    run(system, path, specifieds={"f0": -x}, resume=True)
    with pytest.raises(ValueError, match="What differs: equations"):
        run(system, path, specifieds={"f0": -2 * x}, resume=True)


def test_a_store_whose_functions_have_no_name_cannot_be_resumed(system, tmp_path):
    path = tmp_path / "s.zarr"
    run(system, path, reduce=scaled(1.0))
    with pytest.raises(ValueError, match=REFUSED):
        run(system, path, reduce=scaled(1.0), resume="a name too late")


def test_a_name_stands_for_functions_and_nothing_else(system, tmp_path):
    path = tmp_path / "s.zarr"
    run(system, path, reduce=scaled(1.0), resume="scaled")
    run(system, path, reduce=scaled(2.0), resume="scaled")
    with pytest.raises(ValueError, match=REFUSED):
        run(system, path, reduce=scaled(1.0), resume="scaled", rtol=1e-3)
    with pytest.raises(ValueError, match="What differs: which specifieds are functions"):
        run(system, path, reduce=scaled(1.0), resume="scaled", specifieds={"f0": push(0.0)})


# -- a start that fails -------------------------------------------------------------------------


def test_a_store_is_there_as_a_whole_or_not_at_all(system, tmp_path, monkeypatch):
    def full(*arguments):
        raise OSError("no space left")

    path = tmp_path / "new" / "s.zarr"
    with monkeypatch.context() as patch:
        patch.setattr(stores, "write_coordinates", full)
        with pytest.raises(OSError, match="no space left"):
            run(system, path)
    assert list(path.parent.iterdir()) == []
    run(system, path)
    assert list(path.parent.iterdir()) == [path]


def test_a_store_that_another_process_made_meanwhile_stays(system, tmp_path, monkeypatch):
    path, written = tmp_path / "s.zarr", stores.write_coordinates

    def raced(*arguments):
        written(*arguments)
        path.mkdir()
        (path / "results").write_text("of another process")

    monkeypatch.setattr(stores, "write_coordinates", raced)
    with pytest.raises(
        ValueError, match=r"another process has made '.*s\.zarr' meanwhile\. Call again"
    ):
        run(system, path)
    assert (path / "results").read_text() == "of another process"


# -- damage ---------------------------------------------------------------------------------------


@pytest.fixture
def store(tmp_path):
    """A store of four blocks with 25 samples each, and what is in it."""
    system = pendulum()
    values, path = random_values(system, 100), tmp_path / "s.zarr"

    def go_on():
        return system.integrate_ensemble(**values, store=path, chunks=25, resume=True).load()

    return path, go_on, go_on()


@pytest.mark.parametrize("name", ["q1/c/1/0", "rejected/c/1", "end_time/c/1", "status/c/1"])
@pytest.mark.parametrize("content", [b"", b"half", None])
def test_a_chunk_that_is_lost_or_does_not_decode_is_computed_again(store, computed, name, content):
    path, go_on, whole = store
    computed.clear()
    if content is None:
        (path / name).unlink()
    else:
        (path / name).write_bytes(content)
    identical(go_on(), whole)
    assert computed == [25]


@pytest.mark.parametrize("name", ["q1/c/1/0", "status/c/1"])
def test_a_flipped_bit_is_seen_anywhere_in_a_chunk(store, computed, name):
    path, go_on, whole = store
    sound = (path / name).read_bytes()
    for place in (0, len(sound) // 2, len(sound) - 5, len(sound) - 1):
        computed.clear()
        flipped = bytearray(sound)
        flipped[place] ^= 1
        (path / name).write_bytes(flipped)
        with pytest.raises(ValueError, match="checksum"):
            xr.open_zarr(path, consolidated=False).load()
        identical(go_on(), whole)
        assert computed == [25]


def test_chunks_of_other_places_are_computed_again(store, computed):
    path, go_on, whole = store

    def swap(a, b):
        for old, new in ((a, "aside"), (b, a), ("aside", b)):
            (path / old).rename(path / new)

    computed.clear()
    swap("q1/c/0", "q1/c/1")
    identical(go_on(), whole)
    assert computed == [25, 25]
    swap("q1/c", "u1/c")
    identical(go_on(), whole)
    assert computed == [25] * 6
    for name in whole.data_vars:  # whole blocks, each with its own checksums
        swap(f"{name}/c/2", f"{name}/c/3")
    swap("pydy_chunks/checksums/c/2", "pydy_chunks/checksums/c/3")
    identical(go_on(), whole)
    assert computed == [25] * 8


def test_chunks_of_another_ensemble_are_computed_again(store, computed, tmp_path):
    path, go_on, whole = store
    other = tmp_path / "other.zarr"
    pendulum().integrate_ensemble(**random_values(pendulum(), 100, seed=1), store=other, chunks=25)
    computed.clear()
    for name in whole.data_vars:
        chunk = next(p for p in (f"{name}/c/1/0", f"{name}/c/1") if (path / p).is_file())
        shutil.copy(other / chunk, path / chunk)
    identical(go_on(), whole)
    assert computed == [25]


@pytest.mark.parametrize("name", ["q1", "status", "time", "initial_q1", ""])
def test_a_flipped_bit_is_seen_anywhere_in_what_describes_the_arrays(store, computed, name):
    path, go_on, whole = store
    sound = (path / name / "zarr.json").read_bytes()
    computed.clear()
    for place in range(0, len(sound), max(1, len(sound) // 7)):
        flipped = bytearray(sound)
        flipped[place] ^= 1
        (path / name / "zarr.json").write_bytes(flipped)
        with pytest.raises(ValueError, match=r"zarr\.json"):
            go_on()
    (path / name / "zarr.json").write_bytes(sound)
    identical(go_on(), whole)
    assert computed == []


def test_a_store_whose_metadata_were_consolidated_goes_on(store, computed):
    path, go_on, whole = store
    computed.clear()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of Zarr's, that this is no part of its standard
        zarr.consolidate_metadata(path)
    identical(go_on(), whole)
    assert computed == []


@pytest.mark.parametrize("lost", [None, "q1", "pydy_chunks/checksums"])
def test_a_store_whose_consolidated_metadata_lack_arrays_is_named_with_the_remedy(
    store, computed, lost
):
    path, go_on, whole = store
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of Zarr's, that this is no part of its standard
        zarr.consolidate_metadata(path)
        about = json.loads((path / "zarr.json").read_text())
        known = about["consolidated_metadata"]["metadata"]
        about["consolidated_metadata"]["metadata"] = {
            name: entry for name, entry in known.items() if lost is not None and name != lost
        }
        (path / "zarr.json").write_text(json.dumps(about))
        with pytest.raises(ValueError, match="has consolidated metadata without") as refused:
            go_on()
        message = str(refused.value)
        assert (lost or "q1") in message or "more" in message
        assert str(path) in message
        computed.clear()
        assert f"zarr.consolidate_metadata({str(path)!r})" in message
        zarr.consolidate_metadata(path)
    identical(go_on(), whole)
    assert computed == []


def test_stores_are_written_and_resumed_without_asserts(tmp_path):
    script = """
        import sys
        from pydy.models import multi_mass_spring_damper

        system = multi_mass_spring_damper()
        values = {"chunks": 2, "times": [0.0, 1.0], "initial_conditions": {"x0": [0.1, 0.2, 0.3]}}
        for resume in (False, True):
            system.integrate_ensemble(store=sys.argv[1], resume=resume, **values)
        found = system.integrate_ensemble(store=sys.argv[1], resume=True, **values)
        print(__debug__, found.x0.shape, int(found.status.sum()))
    """
    command = [sys.executable, "-O", "-c", textwrap.dedent(script), str(tmp_path / "s.zarr")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.stdout.strip() == "False (3, 2) 0", done.stderr


def test_a_store_that_is_whole_computes_nothing(store, computed):
    _, go_on, whole = store
    computed.clear()
    identical(go_on(), whole)
    assert computed == []


@pytest.mark.parametrize("name", ["initial_q1/c/0", "time/c/0"])
def test_coordinates_that_do_not_decode_are_written_again(store, name):
    path, go_on, whole = store
    (path / name).write_bytes(b"half")
    identical(go_on(), whole)


@pytest.mark.parametrize("name", ["q1", "status", "time", "initial_q1"])
def test_an_array_that_is_lost_is_named(store, name):
    path, go_on, _ = store
    shutil.rmtree(path / name)
    with pytest.raises(ValueError, match=f"has lost its array `{name}`"):
        go_on()


# -- what keeps a store from being written --------------------------------------------------------


def test_a_full_disk_names_the_store(system, tmp_path, monkeypatch):
    def full(*_):
        raise OSError(28, "No space left on device")

    path = tmp_path / "s.zarr"
    run(system, path)
    (path / "status/c/1").unlink()
    monkeypatch.setattr(zarr.Array, "__setitem__", full)
    with pytest.raises(OSError, match=r"No space left on device: '.*s.zarr'"):
        run(system, path, resume=True)


def test_letters_that_the_locale_lacks_are_told(system, tmp_path, monkeypatch):
    encode = os.fsencode
    monkeypatch.setattr("os.fsencode", lambda name: str(encode(name), "utf-8").encode("ascii"))
    system.outputs = {"θ": system.coordinates[0]}
    with pytest.raises(ValueError, match=r"a file of the name '\\u03b8', .* PYTHONUTF8=1"):
        run(system, tmp_path / "s.zarr")
