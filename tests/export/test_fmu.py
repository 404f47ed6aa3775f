"""FMUs by the rules of FMPy: valid, and moving as the System does."""

import ctypes
import itertools
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import threading
import time
import zipfile
from contextlib import contextmanager, redirect_stderr
from io import StringIO
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from optional import optional
from oracles import crossings, departures
from pydy import System
from pydy.errors import GeneratorError
from pydy.export.fmu import compiler
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.solvers import Event
from zoo import inertial_frame
from zoo.ball import bouncing_ball
from zoo.exported_models import (
    TIMES,
    ball,
    hostile,
    kicked,
    kicked_at_an_input,
    kicked_to,
    pendulum,
    rope,
    spring_of,
)

fmpy = optional("fmpy")
validation = optional("fmpy.validation")

VERSIONS = ("3.0", "2.0")
KINDS = ("CoSimulation", "ModelExchange")


@pytest.fixture(scope="module")
def units(tmp_path_factory):
    """The units of all tests, compiled once: by name and version."""
    folder = tmp_path_factory.mktemp("units")
    found = {}
    said = StringIO()
    ball_system, bounce = ball()
    for fmi in VERSIONS:
        for name, system, options in (
            ("pendulum", pendulum(), {}),
            ("ball", ball_system, {"events": bounce}),
            ("mass", hostile(), {"name": '*/ "</x> mass & ]]>'}),
        ):
            path = folder / f"{name}{fmi[0]}.fmu"
            with redirect_stderr(said):
                system.export(path, fmi=fmi, progress=True, **{"name": name, **options})
            found[name, fmi] = str(path)
    assert "part=C compiler" in said.getvalue()  # which takes longest
    return found


@pytest.fixture
def hasty(tmp_path_factory, monkeypatch):
    """Compile without optimisation, in a third of the time, what is tried for its names or once."""
    script = tmp_path_factory.mktemp("hasty") / "cc"
    script.write_text(f'#!/bin/sh\nexec {shlex.join(compiler())} "$@" -O0\n')
    script.chmod(0o755)
    if os.name == "posix":
        monkeypatch.setenv("CC", str(script))


def simulated(unit, kind, names, **options):
    """Return the columns of some variables at `TIMES`."""
    step = TIMES[1] - TIMES[0]
    options = {"relative_tolerance": 1e-13 if kind == "ModelExchange" else 1e-11, **options}
    result = fmpy.simulate_fmu(
        unit, fmi_type=kind, start_time=0.0, stop_time=TIMES[-1], output_interval=step,
        output=names, record_events=False, **options,
    )  # fmt: skip
    assert result["time"] == pytest.approx(TIMES)
    return np.stack([result[name] for name in names], axis=1)


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize("name", ["pendulum", "ball", "mass"])
def test_the_unit_is_valid(units, name, fmi):
    assert validation.validate_fmu(units[name, fmi]) == []
    description = fmpy.read_model_description(units[name, fmi])
    assert description.modelExchange is not None
    assert description.coSimulation is not None


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize("kind", KINDS)
def test_the_trajectory_is_that_of_the_system(units, fmi, kind):
    system = pendulum()
    expected = system.simulate(rtol=1e-12, atol=1e-12)
    names = ["q0", "q1", "q2", "u0", "u1", "u2"]
    found = simulated(units["pendulum", fmi], kind, [*names, "T", "a"])
    assert found[:, :6] == pytest.approx(expected.states, abs=1e-8)
    assert found[:, 6:] == pytest.approx(expected.outputs, abs=1e-7)


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize("kind", KINDS)
def test_constants_states_and_inputs_can_be_set(units, fmi, kind):
    system = pendulum()
    system.constants = {**system.constants, "l0": 1.1}
    system.initial_conditions = {**system.initial_conditions, "q1": -0.3}
    system.specifieds = {"F": -2.0}
    expected = system.integrate(rtol=1e-12, atol=1e-12)
    found = simulated(
        units["pendulum", fmi], kind, ["q0", "q1"], start_values={"l0": 1.1, "q1": -0.3, "F": -2.0}
    )
    assert found == pytest.approx(expected[:, :2], abs=1e-8)


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize("kind", KINDS)
def test_without_a_tolerance_inputs_that_vary_and_jump_are_integrated(units, fmi, kind):
    """FMPy passes the tolerance of the unit to CVODE, which gave up at such inputs with 1e-10."""
    assert fmpy.read_model_description(units["pendulum", fmi]).defaultExperiment.tolerance == "1e-6"
    # Held between the communication points, as FMPy does it: steps of a sine, in steps of 0.05 s.
    held = 3.0 * np.sin(4.0 * TIMES)
    rows = np.rec.fromarrays([TIMES, held], names=["time", "F"])
    system = pendulum()
    system.specifieds = {"F": SampledInput(TIMES, held, "previous")}
    exact = system.integrate(rtol=1e-12, atol=1e-12)
    found = simulated(
        units["pendulum", fmi], kind, ["q0", "q1"], input=rows, relative_tolerance=None
    )
    # CVODE goes over the jumps with its history of smooth steps: that costs two digits in a second.
    least = 1e-4 if kind == "CoSimulation" else 2e-2
    assert found[:20] == pytest.approx(exact[:20, :2], abs=least)


@pytest.mark.parametrize("fmi", VERSIONS)
def test_a_pulse_between_two_steps_is_not_passed_over(tmp_path, hasty, fmi):
    unit = str(kicked().export(tmp_path / "kicked.fmu", fmi=fmi).path)
    for kind in KINDS:
        for t0, w in ((5.0, 0.01), (11.3, 1e-4), (0.0, 0.1), (10.0, 1e-6)):
            for step in (5.0, 0.1):
                result = fmpy.simulate_fmu(
                    unit, fmi_type=kind, stop_time=20.0, output_interval=step, output=["x", "v"],
                    relative_tolerance=1e-9, start_values={"t0": t0, "w": w},
                )  # fmt: skip
                expected = kicked_to(20.0, t0, w)
                assert [*result[-1]][1:] == pytest.approx(expected, rel=1e-6, abs=1e-7)


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize("kind", KINDS)
def test_a_pulse_that_an_input_begins_is_not_passed_over(tmp_path, hasty, fmi, kind):
    unit = str(kicked_at_an_input().export(tmp_path / "kicked.fmu", fmi=fmi).path)
    # The input is 18, and from 5 s on 11.3.
    rows = np.rec.fromarrays([[0.0, 5.0, 5.0, 20.0], [18.0, 18.0, 11.3, 11.3]], names=["time", "D"])
    for t0, given in ((11.3, {"start_values": {"D": 11.3}}), (11.3, {"input": rows})):
        result = fmpy.simulate_fmu(
            unit, fmi_type=kind, stop_time=20.0, output_interval=5.0, output=["x", "v"],
            relative_tolerance=1e-9, **given,
        )  # fmt: skip
        assert [*result[-1]][1:] == pytest.approx(kicked_to(20.0, t0, 0.01), rel=1e-6, abs=1e-7)


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize("kind", KINDS)
def test_events_reset_states(units, fmi, kind):
    system, bounce = ball()
    expected = system.integrate(rtol=1e-12, atol=1e-12, events=bounce)
    assert (np.diff(expected[:, 1]) > 0.5).sum() >= 3  # so many bounces
    found = simulated(units["ball", fmi], kind, ["y", "v"])
    # FMPy stops for events of Model Exchange at a step of its own solver, some 1e-6 s late.
    assert found == pytest.approx(expected, abs=1e-8 if kind == "CoSimulation" else 1e-2)


@pytest.mark.parametrize("kind", KINDS)
def test_a_motion_that_starts_on_a_surface_follows_the_table(tmp_path, hasty, kind):
    path = tmp_path / "departures.fmu"
    departures.started(departures.CASES[0]).export(path, events=departures.events())
    folder = fmpy.extract(path)
    for case in departures.CASES:
        values = {str(symbol): value for symbol, value in departures.numbers(case).items()}
        options = {"fmi_type": kind, "stop_time": 0.1, "output_interval": 0.05}
        options["start_values"] = {**values, "v": case.v0}
        if kind == "ModelExchange" and not case.goes_on:  # the importer cannot even begin
            with pytest.raises(Exception, match="requested termination"):
                fmpy.simulate_fmu(folder, **options)
            continue
        result = fmpy.simulate_fmu(folder, **options, output=["h", "n"], record_events=False)
        # A unit does not tell which events it has met.
        moments, ended = [0.0] * case.recorded, bool(result["time"][-1] < 0.0999)
        departures.check(case, moments, result["h"].tolist(), ended)
        if case.action == "count":
            assert result["n"][-1] == case.acts


@pytest.mark.parametrize("fmi", VERSIONS)
def test_crossings_follow_the_table(tmp_path, hasty, fmi):
    path = tmp_path / "crossings.fmu"
    crossings.started(crossings.CASES[0]).export(path, events=crossings.events(), fmi=fmi)
    folder = fmpy.extract(path)

    def last(case, kind):
        values = {str(symbol): value for symbol, value in crossings.numbers(case).items()}
        result = fmpy.simulate_fmu(
            folder, fmi_type=kind, stop_time=case.end, output_interval=case.end / 8,
            start_values={**values, "h": case.h0, "v": case.v0}, output=["h", "v"],
            relative_tolerance=1e-11, record_events=kind == "ModelExchange",
        )  # fmt: skip
        return [result["h"][-1], result["v"][-1]]

    for case in crossings.CASES:
        crossings.check_end(case, last(case, "CoSimulation"))
        # An importer does not see a crossing and return within one of its steps, and stops late.
        if case.acts and case.within == 1e-9:
            np.testing.assert_allclose(last(case, "ModelExchange"), case.final, rtol=0, atol=1e-7)


def test_a_terminal_event_ends_the_simulation(tmp_path, hasty):
    system, bounce = ball()
    stop = type(bounce)(bounce.expression, direction=-1, terminal=True)
    path = system.export(tmp_path / "fall.fmu", events=stop).path
    result = fmpy.simulate_fmu(str(path), fmi_type="CoSimulation", stop_time=2.0, output=["y"],
                          output_interval=0.05)  # fmt: skip
    assert result["time"][-1] == pytest.approx(np.sqrt(2 / 9.81), abs=0.06)


def test_an_event_that_depends_on_constants_is_found_or_told_to_be_nan(tmp_path, hasty):
    system, bounce = bouncing_ball()
    system.initial_conditions = {"q": 1.0, "u": 0.0}
    above = bounce.expression  # q − d
    options = {"fmi_type": "CoSimulation", "stop_time": 1.0, "output_interval": 0.01}
    path = system.export(tmp_path / "low.fmu", events=Event(above, terminal=True)).path
    result = fmpy.simulate_fmu(str(path), **options, output=["q"])
    assert result["time"][-1] == pytest.approx(np.sqrt(2 * 0.9 / 9.81), abs=0.011)
    path = system.export(tmp_path / "root.fmu", events=Event(sm.sqrt(above))).path
    told = []
    with pytest.raises(fmpy.fmi1.FMICallException, match="fmi3DoStep failed"):
        fmpy.simulate_fmu(str(path), **options, logger=lambda *words: told.append(words[-1]))
    assert b"is NaN at t = 0.42835293" in told[0]  # √(2 · 0.9 / 9.81)


@pytest.mark.parametrize("fmi", VERSIONS)
def test_a_step_that_leads_nowhere_is_an_error(units, fmi):
    path = units["pendulum", fmi]
    told, description = [], fmpy.read_model_description(path)
    unit = fmpy.instantiate_fmu(fmpy.extract(path), description, "CoSimulation",
                           logger=lambda *words: told.append(words[-1]))  # fmt: skip
    if fmi == "2.0":
        unit.setupExperiment(startTime=0.0)
    unit.enterInitializationMode()
    unit.exitInitializationMode()
    unit.doStep(0.0, 0.1)
    unit.doStep(0.1 + 2**-54, 0.1)
    unit.doStep(0.2, 0.0)
    for point, step in (
        (0.2, -0.1),
        (0.2, np.nan),
        (0.2, np.inf),
        (0.05, 0.05),
        (0.1, 0.1),
        (0.25, 0.1),
        (5.0, 0.0),
        (0.4, 0.1),
        (np.nan, 0.1),
    ):
        with pytest.raises(fmpy.fmi1.FMICallException, match="DoStep failed") as caught:
            unit.doStep(point, step)
        assert caught.value.status == 3
        assert b"the step must be finite" in told[-1]
    unit.terminate()
    unit.freeInstance()


@pytest.mark.parametrize("fmi", VERSIONS)
def test_an_event_indicator_that_is_nan_is_told_to_the_importer(tmp_path, hasty, fmi):
    system, bounce = bouncing_ball()
    system.initial_conditions = {"q": 1.0, "u": 0.0}
    root = Event(sm.sqrt(bounce.expression), name="50 % of it")  # NaN once the ball is below
    path = system.export(tmp_path / "root.fmu", events=root, fmi=fmi).path
    told, description = [], fmpy.read_model_description(path)
    instance = fmpy.instantiate_fmu(fmpy.extract(path), description, "ModelExchange",
                               logger=lambda *words: told.append(words))  # fmt: skip
    [q] = [v.valueReference for v in description.modelVariables if v.name == "q"]
    if fmi == "2.0":
        instance.setupExperiment(startTime=0.0)
    instance.enterInitializationMode()
    instance.exitInitializationMode()
    values = (ctypes.c_double * 1)()
    instance.getEventIndicators(values, 1)
    assert values[0] == pytest.approx(np.sqrt(0.9))
    (instance.setReal if fmi == "2.0" else instance.setFloat64)([q], [0.0])
    with pytest.raises(fmpy.fmi1.FMICallException, match="GetEventIndicators failed") as caught:
        instance.getEventIndicators(values, 1)
    assert caught.value.status == 2  # discard: the importer may try a smaller step
    assert told[0][-2:] == (b"logStatusDiscard", b"the event 50 % of it is NaN")
    instance.terminate()
    instance.freeInstance()


def sensitivities(unit, call):
    """Return d(unknowns)/d(knowns) of a unit in its initial state, column by column."""
    description = fmpy.read_model_description(unit)
    folder = fmpy.extract(unit)
    instance = fmpy.instantiate_fmu(folder, description, "ModelExchange")
    variables = {v.name: v.valueReference for v in description.modelVariables}
    unknowns = [variables[f"der({name})"] for name in ("q0", "u0", "u1", "u2")]
    knowns = [variables[name] for name in ("q1", "u2", "F")]
    if description.fmiVersion == "2.0":
        instance.setupExperiment(startTime=0.0)
    instance.enterInitializationMode()
    instance.exitInitializationMode()
    found = call(instance, unknowns, knowns)
    instance.terminate()
    instance.freeInstance()
    return found


@pytest.mark.parametrize("fmi", VERSIONS)
def test_directional_derivatives_are_exact(units, fmi):
    def columns(instance, unknowns, knowns):
        return [instance.getDirectionalDerivative(unknowns, [known], [1.0]) for known in knowns]

    found = np.array(sensitivities(units["pendulum", fmi], columns)).T
    system = pendulum()
    expected = np.hstack([system.evaluate_jacobian(), system.evaluate_jacobian(wrt=["F"])])
    assert found == pytest.approx(expected[np.ix_([0, 3, 4, 5], [1, 5, 6])], rel=1e-12)


def test_adjoint_derivatives_are_the_same_transposed(units):
    def rows(instance, unknowns, knowns):
        return [instance.getAdjointDerivative([u], knowns, [1.0], 3) for u in unknowns]

    def columns(instance, unknowns, knowns):
        return [instance.getDirectionalDerivative(unknowns, [known], [1.0]) for known in knowns]

    unit = units["pendulum", "3.0"]
    assert np.array(sensitivities(unit, rows)) == pytest.approx(
        np.array(sensitivities(unit, columns)).T
    )


@pytest.mark.parametrize("known", ["__GNUC__", "__FP_FAST_FMA", "nothing"])
@pytest.mark.parametrize("fmi", VERSIONS)
def test_its_sources_compile_without_a_warning(units, tmp_path, fmi, known):
    with zipfile.ZipFile(units["ball", fmi]) as archive:
        archive.extractall(tmp_path)
    strict = ["-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-pedantic", "-fPIC", "-shared"]
    folder = tmp_path / "sources"
    numbers = (folder / "real.h").read_text(encoding="utf-8")
    for name in {"__GNUC__", "__FP_FAST_FMA"} - {known}:  # of other compilers, and processors
        numbers = numbers.replace(name, "UNKNOWN")
    numbers = numbers.replace("__FP_FAST_FMA", "__GNUC__")
    (folder / "real.h").write_text(numbers, encoding="utf-8")
    command = [*compiler(), *strict, "-o", "unit.so", "all.c", "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_the_same_model_gives_the_same_file(tmp_path):
    paths = [pendulum().export(tmp_path / name / "p.fmu", binary=False).path
             for name in ("a", "b") if not (tmp_path / name).mkdir()]  # fmt: skip
    assert paths[0].read_bytes() == paths[1].read_bytes()


def test_without_a_binary_only_the_sources_are_there(tmp_path):
    path = pendulum().export(tmp_path / "p.fmu", binary=False).path
    with zipfile.ZipFile(path) as archive:
        assert not [name for name in archive.namelist() if name.startswith("binaries")]
        assert "sources/all.c" in archive.namelist()


def test_a_compiler_that_fails_shows_its_words(tmp_path, monkeypatch):
    monkeypatch.setenv("CC", " ".join([*compiler(), "-no-such-option"]))
    with pytest.raises(GeneratorError, match="no-such-option"):
        pendulum().export(tmp_path / "p.fmu")


def test_without_a_compiler_the_error_tells_the_remedy(tmp_path, monkeypatch):
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(GeneratorError, match=re.escape("pass binary=False for an FMU of")):
        pendulum().export(tmp_path / "p.fmu")


@pytest.mark.parametrize(
    ("platform", "named", "words"),
    [
        ("linux", "ccache gcc", ["ccache", "gcc"]),
        (
            "win32",
            r'"C:\Program Files\LLVM\clang.exe" -v',
            [r"C:\Program Files\LLVM\clang.exe", "-v"],
        ),
        ("win32", r"D:\tools\cl.exe", [r"D:\tools\cl.exe"]),
    ],
)
def test_a_compiler_is_named_as_the_system_names_programs(platform, named, words, monkeypatch):
    monkeypatch.setattr(sys, "platform", platform)
    monkeypatch.setenv("CC", named)
    assert compiler() == words


def test_a_quotation_without_an_end_is_told(monkeypatch):
    monkeypatch.setenv("CC", 'gcc "-O2')
    with pytest.raises(GeneratorError, match="CC is 'gcc \"-O2', in which a quotation has no end"):
        compiler()


def test_a_compiler_may_lie_in_a_folder_whose_name_has_blanks(tmp_path, monkeypatch):
    folder = tmp_path / "Zoë's tools"
    folder.mkdir()
    (folder / "cc").symlink_to(shutil.which(compiler()[0]))
    monkeypatch.setenv("CC", str(folder / "cc"))
    assert compiler() == [str(folder / "cc")]
    pendulum().export(tmp_path / "p.fmu")


@pytest.mark.parametrize("fmi", ["2.0", "3.0"])
@pytest.mark.parametrize(
    ("platform", "name", "suffix", "fits"),
    [
        ("win32", "cl", ".dll", lambda words: "/LD" in words and "-shared" not in words),
        ("win32", "clang", ".dll", lambda words: "-shared" in words and "-lm" not in words),
        ("darwin", "clang", ".dylib", lambda words: "-fPIC" in words and "-lm" in words),
    ],
)
def test_every_system_has_its_library_and_options(
    platform, name, suffix, fits, fmi, tmp_path, monkeypatch
):
    asked = []

    @contextmanager
    def run(command, cwd):
        asked.append(command)
        (Path(cwd) / f"model{suffix}").write_bytes(b"code")
        yield SimpleNamespace(communicate=lambda timeout: ("", None), returncode=0)

    monkeypatch.setattr(sys, "platform", platform)
    monkeypatch.setenv("CC", name)
    monkeypatch.setattr("pydy.export.fmu.started", run)
    path = pendulum().export(tmp_path / "p.fmu", fmi=fmi).path
    [command] = asked
    assert fits(command)
    with zipfile.ZipFile(path) as archive:
        [library] = [name for name in archive.namelist() if name.startswith("binaries")]
        assert archive.read(library) == b"code"
    assert library.endswith(suffix)


@pytest.mark.parametrize(
    ("name", "fmi"),
    [
        *(("all", "2.0"), ("config", "3.0"), ("fmu_core", "2.0"), ("fmi", "2.0"), ("fmi", "3.0")),
        *(("update", "3.0"), ("event", "2.0"), ("linux", "3.0"), ("a\x00b\x01", "2.0")),
        *(("\ud800 surrogate", "3.0"), ("x" * 300, "2.0")),
    ],
)
def test_a_model_may_have_any_name(tmp_path, hasty, name, fmi):
    system = spring_of("NX", "SELF", "linux", "NULL", "length", "\x07", "\ud800", "k" * 300)
    path = system.export(tmp_path / "unit.fmu", name=name, fmi=fmi).path
    description = fmpy.read_model_description(path)
    assert len(description.coSimulation.modelIdentifier) <= 100
    fmpy.extract(path, tmp_path / "unpacked")
    result = fmpy.simulate_fmu(str(path), fmi_type="CoSimulation", stop_time=1.0, output=["x"])
    # All stiffnesses are 1: 1 + 2 + ... + 8 = 36.
    assert result["x"][-1] == pytest.approx(np.cos(6.0), abs=1e-5)


@pytest.mark.parametrize("name", ["all", "config", "fmu_core", "fmi", "fmi2"])
def test_the_file_may_be_called_like_one_of_the_sources(tmp_path, hasty, name):
    path = spring_of("k").export(tmp_path / f"{name}.fmu").path
    result = fmpy.simulate_fmu(str(path), fmi_type="CoSimulation", stop_time=1.0, output=["x"])
    assert result["x"][-1] == pytest.approx(np.cos(1.0), abs=1e-5)


@pytest.mark.skipif(os.name != "posix", reason="the signal is for a process of POSIX")
def test_a_ctrl_c_ends_the_compiler_and_what_it_started_at_once(tmp_path, monkeypatch, uncollected):
    running, script = tmp_path / "running", tmp_path / "cc"
    script.write_text(f"#!/bin/sh\nsleep 600 &\necho $! > {running}.new\n"
                      f"mv {running}.new {running}\nwait\n")  # fmt: skip
    script.chmod(0o755)
    monkeypatch.setenv("CC", str(script))
    system, sent = spring_of("k"), []
    patience = 300.0  # seconds on a busy machine, where 0.1 are meant and the compiler takes 600

    def interrupt():
        while not running.exists():
            time.sleep(0.01)
        sent.append(time.monotonic())
        # Here, so that no system call of the main thread ends early: so it is with a signal that
        # comes right before one.
        signal.pthread_kill(threading.get_ident(), signal.SIGINT)

    thread = threading.Thread(target=interrupt, daemon=True)
    # Where the tests run in the background, a shell has SIGINT ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    thread.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            system.export(tmp_path / "spring.fmu")
    finally:
        signal.signal(signal.SIGINT, before)
    assert time.monotonic() - sent[0] < patience
    thread.join()
    number = int(running.read_text())
    status = Path(f"/proc/{number}/stat")  # a zombie until whoever adopts it looks after it
    while status.exists() and " Z " not in status.read_text():
        assert time.monotonic() - sent[0] < patience
        time.sleep(0.01)
    assert not (tmp_path / "spring.fmu").exists()


def test_the_model_and_its_solver_may_need_functions_of_the_same_name(tmp_path, hasty):
    """A contact in a loop that is closed without dependent speeds: what C has no function for."""
    x, y = me.dynamicsymbols("x y")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    contact = (sm.Max(-x, 0) ** sm.Rational(3, 2) - sm.Min(x, 0) - 0.1 * sm.sign(x)) * frame.x
    system = System(
        Definition(
            frame, [x, y], bodies=[me.Particle("P", place, 1)],
            loads=[(place, contact - frame.y)], holonomic_constraints=[x**2 + y**2 - 1],
        ),
        initial_conditions={x: 0.6, y: -0.8}, times=TIMES, ode_solver="dop853",
    )  # fmt: skip
    path = tmp_path / "contact.fmu"
    system.export(path)
    expected = system.simulate(rtol=1e-11, atol=1e-11)["x"]
    assert simulated(str(path), "CoSimulation", ["x"])[:, 0] == pytest.approx(expected, abs=1e-7)


LOGGERS = []


@pytest.fixture(scope="module", autouse=True)
def _loggers_stay_alive():
    """FMPy has one logger for all units of FMI 2.0, the latest, and calls it when it is freed."""
    from fmpy import logging

    add = logging.addLoggerProxy
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(logging, "addLoggerProxy", lambda new: (LOGGERS.append(new), add(new))[1])
        yield


@pytest.fixture(scope="module")
def bouncing(tmp_path_factory):
    """A ball whose restitution `e` and floor `d` are parameters: by version."""
    system, bounce = bouncing_ball()
    folder = tmp_path_factory.mktemp("bouncing")
    return {
        fmi: fmpy.extract(
            str(system.export(folder / f"ball{fmi[0]}.fmu", fmi=fmi, events=bounce).path)
        )
        for fmi in VERSIONS
    }


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    ("floor", "restitution"), [(0.0, 0.5), (0.1, 0.3), (0.1, 0.5), (-3.3, 0.6), (1e3, 0.4)]
)
def test_bounces_that_accumulate_end_the_motion(bouncing, fmi, kind, floor, restitution):
    """As in Python, where the ball would fall through the floor otherwise.

    A floor at zero hides much: the height above it then has all its digits, however small it is.
    """
    e, told = restitution, []
    landing = np.sqrt(0.5**2 + 2 * 9.81)  # m/s: thrown upwards with 0.5 m/s, 1 m above the floor
    end = (0.5 + landing) / 9.81 + 2 * landing / 9.81 * e / (1 - e)  # the sum of all flights
    result = fmpy.simulate_fmu(
        bouncing[fmi], fmi_type=kind, stop_time=end + 1.0, output_interval=0.01,
        output=["q", "u"], relative_tolerance=1e-9,
        start_values={"e": e, "d": floor, "q": 1.0 + floor},
        logger=lambda *words: told.append(words),
    )  # fmt: skip
    # The importer's error of the height, 1e-9 of it, ends flights that are no higher.
    unseen = np.sqrt(2 * 1e-9 * (abs(floor) + 1.0) / 9.81) * 2 / (1 - e)
    assert end - unseen - 0.01 <= result["time"][-1] <= end + 0.01
    assert result["q"].min() >= floor - 1e-9 * (abs(floor) + 1.0)
    assert told[-1][-2] == b"logStatusWarning"
    assert b"the events bounce accumulate" in told[-1][-1]


def sinking():
    """A ball on a floor that moves at the constant speed `c`, and a bounce."""
    system, _ = bouncing_ball()
    (q, u), e, c = system.states, sm.Symbol("e"), sm.Symbol("c")
    system.constants[c] = 0.0
    gap = q - c * me.dynamicsymbols._t
    return system, Event(gap, direction=-1, reset={u: c - e * (u - c)}, name="bounce")


@pytest.mark.parametrize("fmi", VERSIONS)
def test_bounces_on_a_moving_floor_accumulate_and_none_leads_through_it(tmp_path, hasty, fmi):
    (system, bounce), told = sinking(), []
    folder = fmpy.extract(str(system.export(tmp_path / "ball.fmu", fmi=fmi, events=bounce).path))
    for kind, speed, e in itertools.product(KINDS, (-10.0, -3.0, 1.0), (0.3, 0.5)):
        landing = np.sqrt(0.5**2 + 2 * 9.81)
        end = (0.5 + landing) / 9.81 + 2 * landing / 9.81 * e / (1 - e)
        result = fmpy.simulate_fmu(
            folder, fmi_type=kind, stop_time=end + 1.0, output_interval=0.01, output=["q"],
            relative_tolerance=1e-9, logger=lambda *words: told.append(words[-1]),
            start_values={"e": e, "c": speed, "q": 1.0, "u": 0.5 + speed},
        )  # fmt: skip
        unseen = np.sqrt(2 * 1e-9 * 30.0 / 9.81) * 2 / (1 - e)
        assert end - unseen - 0.01 <= result["time"][-1] <= end + 0.01
        assert b"the events bounce accumulate" in told.pop()


@pytest.mark.parametrize("fmi", VERSIONS)
def test_inputs_that_leap_act_in_co_simulation_as_samples_in_a_simulation(tmp_path, hasty, fmi):
    """A floor that rises and sinks in steps leaps above a ball, also one that has just bounced."""
    q, u, floor = me.dynamicsymbols("q u floor")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", q * frame.x)
    system = System(
        Definition(
            frame, [q], [u], bodies=[me.Particle("ball", point, 1)],
            loads=[(point, -9.81 * frame.x)], kinematic_equations=[q.diff() - u],
        ),
        initial_conditions={q: 1.0}, ode_solver="dop853",
    )  # fmt: skip
    system.outputs, system.specifieds = {"gap": q - floor}, {floor: 0.0}
    bounce = Event(q - floor, direction=-1, reset={u: 0.2 - u / 2}, name="bounce")
    folder = fmpy.extract(str(system.export(tmp_path / "ball.fmu", fmi=fmi, events=bounce).path))
    description = fmpy.read_model_description(folder)
    names = {v.name: v.valueReference for v in description.modelVariables}
    system.times, leaps = 0.02 * np.arange(101), 0
    for height, rate in ((0.1, 8.0), (-0.2, 6.0), (0.3, 20.0)):
        floors = height * np.sin(rate * system.times)
        system.specifieds = {floor: SampledInput(system.times, floors, interpolation="previous")}
        expected = system.simulate(events=bounce, rtol=1e-10, atol=1e-10)
        leaps += sum(record.time in system.times for record in expected.events)
        unit = fmpy.instantiate_fmu(folder, description, "CoSimulation")
        if fmi == "2.0":
            get, put = unit.getReal, unit.setReal
            unit.setupExperiment(tolerance=1e-10, startTime=0.0)
            unit.enterInitializationMode()
        else:
            get, put = unit.getFloat64, unit.setFloat64
            unit.enterInitializationMode(tolerance=1e-10)
        unit.exitInitializationMode()
        heights = [1.0]
        for start, end, level in zip(system.times[:-1], system.times[1:], floors[:-1], strict=True):
            put([names["floor"]], [level])
            unit.doStep(start, end - start)
            heights += get([names["q"]])
        unit.terminate()
        unit.freeInstance()
        assert heights == pytest.approx(expected["q"], abs=1e-7)
    assert leaps >= 2


@pytest.mark.parametrize("kind", KINDS)
def test_what_no_importer_sees_while_a_ball_bounces_is_not_lost(bouncing, kind):
    """The restitution 0.9, at steps that are longer than the last flights, up to a bounce."""
    result = fmpy.simulate_fmu(
        bouncing["3.0"], fmi_type=kind, stop_time=7.0, output_interval=0.25,
        output=["q"], start_values={"e": 0.9}, relative_tolerance=1e-9, record_events=False,
    )  # fmt: skip
    system, bounce = bouncing_ball(e=0.9)
    system.times = np.arange(0.0, 7.01, 0.25)
    expected = system.simulate(rtol=1e-10, atol=1e-10, events=bounce)["q"]
    assert result["q"] == pytest.approx(expected, abs=1e-4)


class Importer:
    """An importer of a unit for Model Exchange that is at the states of its choice."""

    def __init__(self, folder, fmi, **starts):
        description = fmpy.read_model_description(folder)
        self.unit, self.fmi = fmpy.instantiate_fmu(folder, description, "ModelExchange"), fmi
        self.names = {v.name: v.valueReference for v in description.modelVariables}
        if fmi == "2.0":
            self.unit.setupExperiment(startTime=0.0)
        self.unit.enterInitializationMode()
        self.set(**starts)
        self.unit.exitInitializationMode()
        assert not self.terminates()
        self.unit.enterContinuousTimeMode()

    def set(self, **values):
        setter = self.unit.setReal if self.fmi == "2.0" else self.unit.setFloat64
        setter([self.names[name] for name in values], [*values.values()])

    def get(self, name):
        getter = self.unit.getReal if self.fmi == "2.0" else self.unit.getFloat64
        return getter([self.names[name]])[0]

    def step(self, time, *states):
        """Return whether the unit asks for an event after a step, and whether it terminates."""
        self.unit.setTime(time)
        self.unit.setContinuousStates((ctypes.c_double * len(states))(*states), len(states))
        return tuple(map(bool, self.unit.completedIntegratorStep()))

    def moved(self, time, *states, **inputs):
        """Return the same after a step in which inputs vary."""
        self.unit.setTime(time)
        self.set(**inputs)
        return self.step(time, *states)

    def terminates(self):
        """Let the unit handle its events, and return whether it terminates."""
        update = "newDiscreteStates" if self.fmi == "2.0" else "updateDiscreteStates"
        return bool(getattr(self.unit, update)()[1])

    def happens(self):
        self.unit.enterEventMode()
        assert not self.terminates()
        self.unit.enterContinuousTimeMode()

    def close(self):
        self.unit.terminate()
        self.unit.freeInstance()


def thrown(q, u, t):
    return q + u * t - 9.81 * t**2 / 2, u - 9.81 * t


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize("when", ["event", "step", "before"])
def test_a_floor_that_leaps_above_a_rising_ball_knocks_it(bouncing, fmi, when):
    """As where a sampled input jumps: the event happens at that time, by the jump."""
    moment, end = 0.02, 0.1
    height, speed = thrown(0.2, 0.5, moment)
    importer = Importer(bouncing[fmi], fmi, d=0.0, e=0.5, q=0.2, u=0.5)
    assert importer.step(moment / 2, *thrown(0.2, 0.5, moment / 2)) == (False, False)
    if when == "before":  # at the start of a step
        importer.set(d=0.3)
        assert importer.step(moment, height, speed) == (True, False)
    else:
        assert importer.step(moment, height, speed) == (False, False)
        importer.set(d=0.3)
        if when == "step":  # one without duration
            assert importer.step(moment, height, speed) == (True, False)
    importer.happens()
    assert importer.get("u") == -0.5 * speed
    # It goes on below the floor, and meets that no more.
    assert importer.step(end, *thrown(height, -0.5 * speed, end - moment)) == (False, False)
    importer.happens()
    assert importer.get("u") == pytest.approx(-0.5 * speed - 9.81 * (end - moment))
    importer.close()


@pytest.mark.parametrize("fmi", VERSIONS)
def test_fmpy_lets_a_floor_leap_above_a_rising_ball(bouncing, fmi):
    moment, end = 0.02, 0.1
    height, speed = thrown(0.2, 0.5, moment)
    rows = np.rec.fromarrays([[0.0, moment, end], [0.0, 0.3, 0.3]], names=["time", "d"])
    result = fmpy.simulate_fmu(
        bouncing[fmi], fmi_type="ModelExchange", stop_time=end, output_interval=moment, input=rows,
        start_values={"d": 0.0, "e": 0.5, "q": 0.2}, output=["q", "u"], relative_tolerance=1e-10,
    )  # fmt: skip
    found = [result["q"][-1], result["u"][-1]]
    assert found == pytest.approx(thrown(height, -0.5 * speed, end - moment), abs=1e-7)


@pytest.mark.parametrize("fmi", VERSIONS)
def test_a_floor_that_leaps_below_a_ball_that_bounces_is_no_event(bouncing, fmi):
    importer = Importer(bouncing[fmi], fmi, d=0.0, e=0.5, q=1e-6, u=-1.0)
    assert importer.step(2e-6, *thrown(1e-6, -1.0, 2e-6)) == (False, False)
    importer.happens()
    speed = importer.get("u")
    assert speed == pytest.approx(0.5, abs=1e-4)
    importer.set(d=-0.1)
    importer.happens()
    assert importer.get("u") == speed
    importer.close()


@pytest.mark.parametrize("fmi", VERSIONS)
def test_a_flight_that_is_shorter_than_the_first_step_ends_in_a_bounce(bouncing, fmi):
    """The ball leaves the floor at the start, where no indicator shows it above the floor."""
    importer = Importer(bouncing[fmi], fmi, d=0.1, e=0.5, q=0.1, u=0.5)
    height, speed = thrown(0.1, 0.5, 0.15)
    assert height < 0.1
    assert importer.step(0.15, height, speed) == (True, False)
    importer.happens()
    assert importer.get("u") == -0.5 * speed
    # A later one does not, as the step of the importer has passed over events.
    assert importer.step(1.0, *thrown(height, -0.5 * speed, 0.85)) == (True, True)
    importer.close()


def test_events_that_only_are_recorded_may_happen_as_often_as_they_like(tmp_path, hasty):
    system, _ = bouncing_ball()
    q = system.states[0]
    path = system.export(tmp_path / "passes.fmu", events=Event(q, name="passes")).path
    importer = Importer(fmpy.extract(path), "3.0", q=1.0)
    for height in (-1e-9, 1e-9, -1e-9, 1e-9):  # at one time
        importer.step(0.5, height, 0.0)
        importer.happens()
    importer.close()


def test_a_step_too_short_for_the_time_is_an_error(tmp_path, hasty):
    """The times near 1e9 s are 1e-7 s apart, and the period of the oscillation is 6e-9 s."""
    folder = fmpy.extract(spring_of("k").export(tmp_path / "spring.fmu").path)
    told, description = [], fmpy.read_model_description(folder)
    unit = fmpy.instantiate_fmu(folder, description, "CoSimulation",
                           logger=lambda *words: told.append(words[-1]))  # fmt: skip
    [stiffness] = [v.valueReference for v in description.modelVariables if v.name == "k"]
    unit.enterInitializationMode(startTime=1e9)
    unit.setFloat64([stiffness], [1e18])
    unit.exitInitializationMode()
    with pytest.raises(fmpy.fmi1.FMICallException, match="DoStep failed"):
        unit.doStep(1e9, 1.0)
    assert b"step" in told[-1]
    unit.terminate()
    unit.freeInstance()


RESETS = {
    "no number": (
        lambda u, e: {u: sm.sqrt(e - 2)},
        b"the reset of the event bounce gives a state that is not finite at t = 0.42835293",
    ),
    "NaN elsewhere": (lambda u, e: {u: -e * u}, b"the event up is NaN at t = 0.42835293"),
}


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("case", RESETS)
def test_a_reset_that_gives_no_number_is_an_error(tmp_path, hasty, fmi, kind, case):
    system, bounce = bouncing_ball()
    system.initial_conditions = {"q": 1.0, "u": 0.0}
    (_, u), e = system.states, sm.Symbol("e")
    reset, message = RESETS[case]
    bounce = Event(bounce.expression, direction=-1, reset=reset(u, e), name="bounce")
    up = Event(sm.sqrt(-u + 0.001) + 1, name="up")  # NaN where the ball rises
    path = system.export(tmp_path / "ball.fmu", fmi=fmi, events=[bounce, up]).path
    told = []
    with pytest.raises(fmpy.fmi1.FMICallException):
        fmpy.simulate_fmu(
            str(path), fmi_type=kind, stop_time=2.0, output_interval=0.01,
            relative_tolerance=1e-9, logger=lambda *words: told.append(words[-1]),
        )  # fmt: skip
    assert message[:-2] in told[0]


def test_a_saved_state_goes_on_after_an_end(bouncing):
    description = fmpy.read_model_description(bouncing["3.0"])
    unit = fmpy.instantiate_fmu(bouncing["3.0"], description, "CoSimulation")
    names = {v.name: v.valueReference for v in description.modelVariables}
    unit.enterInitializationMode()
    unit.setFloat64([names["e"]], [0.5])
    unit.exitInitializationMode()
    unit.doStep(0.0, 0.25)
    saved = unit.getFMUState()
    assert unit.doStep(0.25, 5.0)[1]  # terminates
    unit.setFMUState(saved)
    assert not unit.doStep(0.25, 0.1)[1]
    height = unit.getFloat64([names["q"]])[0]
    assert height == pytest.approx(1.0 + 0.5 * 0.35 - 9.81 * 0.35**2 / 2, abs=1e-6)
    unit.freeFMUState(saved)
    unit.terminate()
    unit.freeInstance()


@pytest.fixture(scope="module")
def on_a_floor(tmp_path_factory):
    """Units of a ball on a floor, whose height is an input, by version; `w` is its velocity."""
    q, u, floor = me.dynamicsymbols("q u floor")
    e, w = sm.symbols("e w")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", q * frame.x)
    body, loads = me.Particle("ball", point, 1), [(point, -9.81 * frame.x)]
    system = System(
        Definition(frame, [q], [u], bodies=[body], loads=loads),
        outputs={"gap": q - floor}, constants_symbols=[e, w], times=[0.0, 3.0],
    )  # fmt: skip
    bounce = Event(q - floor, direction=-1, reset={u: w - e * (u - w)}, name="bounce")
    folder = tmp_path_factory.mktemp("floor")
    return {
        fmi: fmpy.extract(system.export(folder / f"{fmi[0]}.fmu", fmi=fmi, events=bounce).path)
        for fmi in VERSIONS
    }


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize(
    ("rate", "e"), [(-3.0, 0.2), (-1.0, 0.2), (0.5, 0.2), (3.0, 0.2), (-1.0, 0.5), (3.0, 0.5)]
)
def test_bounces_on_a_floor_that_an_input_moves_accumulate_and_none_leads_through_it(
    on_a_floor, fmi, rate, e
):
    """A ball that rebounds downwards, more slowly than the floor sinks, has left the floor."""
    importer, step = Importer(on_a_floor[fmi], fmi, q=1.0, e=e, w=rate), 1e-3
    t, q, u, above, gaps = 0.0, 1.0, 0.0, True, []
    while t < 2.0:
        size = step
        crosses = (thrown(q, u, step)[0] > rate * (t + step)) != above
        if crosses:  # importers stop a little late
            roots = np.roots([-9.81 / 2, u - rate, q - rate * t])
            size = min(r for r in roots if 0.0 < r <= step) + 1e-12
        t, (q, u) = t + size, thrown(q, u, size)
        asks, ends = importer.moved(t, q, u, floor=rate * t)
        gaps.append(q - rate * t)
        if not ends and (crosses or asks):
            importer.unit.enterEventMode()
            ends = importer.terminates()
            importer.unit.enterContinuousTimeMode()
        if ends:
            break
        q, u = importer.get("q"), importer.get("u")
        above = q - rate * t > 0.0
    importer.close()
    # In the frame of the floor each flight is e times as long; the last are shorter than a step.
    landing = np.sqrt(rate**2 + 2 * 9.81)
    rest = (landing - rate) / 9.81 + 2 * landing / 9.81 * e / (1 - e)
    assert rest - step / (1 - e) <= t <= rest + 2 * step
    assert min(gaps) > -9.81 * step**2


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize("when", ["event", "step", "before"])
def test_an_input_that_leaps_has_no_rate(on_a_floor, fmi, when):
    """As of a constant that leaps: the ball is knocked by the leap, and goes on below the floor."""
    moment, end = 0.02, 0.1
    height, speed = thrown(0.2, 0.5, moment)
    importer = Importer(on_a_floor[fmi], fmi, q=0.2, u=0.5, e=0.5, w=0.0)
    assert importer.step(moment / 2, *thrown(0.2, 0.5, moment / 2)) == (False, False)
    if when == "before":
        importer.set(floor=0.3)
        assert importer.step(moment, height, speed) == (True, False)
    else:
        assert importer.step(moment, height, speed) == (False, False)
        importer.set(floor=0.3)
        if when == "step":
            assert importer.step(moment, height, speed) == (True, False)
    importer.happens()
    assert importer.get("u") == -0.5 * speed
    assert importer.step(end, *thrown(height, -0.5 * speed, end - moment)) == (False, False)
    importer.happens()
    assert importer.get("u") == pytest.approx(-0.5 * speed - 9.81 * (end - moment))
    importer.close()


# -- Where a motion begins -------------------------------------------------------------------------


@pytest.fixture(scope="module")
def hanging(tmp_path_factory):
    """Units of a rope whose length follows the time, by version."""
    folder = tmp_path_factory.mktemp("rope")
    return {fmi: str(rope().export(folder / f"rope{fmi[0]}.fmu", fmi=fmi).path) for fmi in VERSIONS}


def lowered(unit, kind, start=0.0, **values):
    """Return the times and heights of the ball, and what the unit logs."""
    told = []
    result = fmpy.simulate_fmu(
        unit, fmi_type=kind, start_time=start, stop_time=start + 0.5, output_interval=0.1,
        output=["y"], relative_tolerance=1e-10, start_values=values, record_events=False,
        logger=lambda *parts: told.append((parts[-3], parts[-1].decode())),
    )  # fmt: skip
    return result["time"], result["y"], told


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(("start", "b"), [(0.5, 0.2), (0.0, 0.5), (0.5, 0.3)])
def test_start_values_off_the_constraints_are_told(hanging, fmi, kind, start, b):
    """The start values of the unit fit the rope's length at t = 0, with b = 0.2."""
    length, rate = 1.0 + b * np.sin(3.0 * start), 3.0 * b * np.cos(3.0 * start)
    residuals = [1.0 - length**2, 2.0 * 0.2 * 3.0 - 2.0 * length * rate]
    _, y, told = lowered(hanging[fmi], kind, start, b=b)
    ((status, text),) = told
    assert status == 1  # a warning: the importer may go on
    assert text.startswith("the start values do not satisfy the constraints")
    found = re.search(
        rf"at t = {start:.9g} is (\S+) in the (holonomic|velocity) constraint 0", text
    )
    assert float(found[1]) == pytest.approx(residuals[found[2] == "velocity"], rel=1e-2)
    assert "Set start values of the states" in text
    # Without the warning, a length that is off would be told by nothing.
    assert abs(y[-1] + 1.0 + b * np.sin(3.0 * (start + 0.5))) > 0.01


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(("start", "b"), [(0.0, 0.2), (0.5, 0.2), (0.5, 0.3)])
def test_start_values_on_the_constraints_are_not(hanging, fmi, kind, start, b):
    length, rate = 1.0 + b * np.sin(3.0 * start), 3.0 * b * np.cos(3.0 * start)
    typed = {"b": b, "y": float(f"{-length:.6g}"), "vy": float(f"{-rate:.6g}")}  # to six digits
    times, y, told = lowered(hanging[fmi], kind, start, **(typed if start else {}))
    assert told == []
    assert y == pytest.approx(-1.0 - b * np.sin(3.0 * times), abs=1e-5)


@pytest.mark.parametrize("fmi", VERSIONS)
def test_what_is_not_varied_adds_nothing_to_a_directional_derivative(tmp_path, hasty, fmi):
    """The derivative of sqrt(x) at 0 is infinite; times a seed of zero it was NaN."""
    x, y, vx, vy = me.dynamicsymbols("x y vx vy")
    N, O = inertial_frame()
    P = O.locatenew("P", x * N.x + y * N.y)
    P.set_vel(N, vx * N.x + vy * N.y)
    force = (P, -sm.sqrt(x) * N.x - 3 * y * N.x)
    system = System(
        Definition(N, [x, y], [vx, vy], bodies=[me.Particle("ball", P, 2)], loads=[force])
    )
    unit = str(system.export(tmp_path / "root.fmu", fmi=fmi).path)
    description = fmpy.read_model_description(unit)
    instance = fmpy.instantiate_fmu(fmpy.extract(unit), description, "ModelExchange")
    of = {v.name: v.valueReference for v in description.modelVariables}
    if fmi == "2.0":
        instance.setupExperiment(startTime=0.0)
    instance.enterInitializationMode()
    instance.exitInitializationMode()
    rates, states = [of["der(vx)"], of["der(vy)"]], [of["x"], of["y"]]
    assert instance.getDirectionalDerivative(rates, states, [0.0, 2.0]) == [-3.0, 0.0]
    assert instance.getDirectionalDerivative(rates, states, [1.0, 2.0]) == [-np.inf, 0.0]
    if fmi == "3.0":
        assert instance.getAdjointDerivative(rates, states, [0.0, 1.0], 2) == [0.0, 0.0]
    instance.terminate()
    instance.freeInstance()


@pytest.mark.parametrize("fmi", VERSIONS)
def test_a_run_goes_on_from_a_saved_state_as_if_nothing_had_happened(units, fmi):
    """Before, between and after bounces, in the same instance and by bytes in another one."""
    description = fmpy.read_model_description(units["ball", fmi])
    folder, step = fmpy.extract(units["ball", fmi]), 0.037
    states = [v.valueReference for v in description.modelVariables if v.name in ("y", "v")]

    def begun():
        instance = fmpy.instantiate_fmu(folder, description, "CoSimulation")
        if fmi == "2.0":
            instance.setupExperiment(startTime=0.0)
        instance.enterInitializationMode()
        instance.exitInitializationMode()
        return instance

    def rows(instance, first, last):
        result = []
        for k in range(first, last):
            instance.doStep(k * step, step)
            result.append((instance.getReal if fmi == "2.0" else instance.getFloat64)(states))
        return result

    whole = rows(begun(), 0, 54)
    assert sum(a[1] < 0 < b[1] for a, b in itertools.pairwise(whole)) >= 2  # bounces
    for middle in (0, 12, 13, 40):
        instance, other = begun(), begun()
        before = rows(instance, 0, middle)
        saved = instance.getFMUState()
        parts = [rows(instance, middle, 54)]
        instance.setFMUState(saved)
        parts.append(rows(instance, middle, 54))
        rows(other, 0, 5)
        copied = other.deserializeFMUState(instance.serializeFMUState(saved))
        other.setFMUState(copied)
        parts.append(rows(other, middle, 54))
        assert [before + part for part in parts] == [whole] * 3
        instance.freeFMUState(saved)
        other.freeFMUState(copied)
