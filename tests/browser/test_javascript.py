"""The exported module, run by Chromium: values and trajectories are those of the System."""

import json
import math

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from oracles import crossings, departures
from pydy._evaluation.exporting import exported_model
from pydy.examples import whipple_bicycle
from pydy.export.javascript import javascript_module
from pydy.mechanics import Definition, Implicit
from pydy.solvers import Event
from pydy.system import System
from zoo import inertial_frame
from zoo.exported_models import TIMES, ball, pendulum, pulled_by_error_functions, spring_of

LOAD = """async (text) => {
    const place = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
    window.model = (await import(place)).default;
}"""


@pytest.fixture
def loaded(browser):
    page = browser.new_page()

    def loaded(path):
        page.evaluate(LOAD, path.read_text(encoding="utf-8"))
        return page

    yield loaded
    page.close()


def rates(page, x, r=()):
    call = """([x, r]) => {
        const out = new Float64Array(x.length), failed = model.rates(0.3, x, r, out);
        return [failed, Array.from(out)];
    }"""
    failed, out = page.evaluate(call, [list(map(float, x)), list(r)])
    return failed, np.array([np.nan if v is None else v for v in out])


@pytest.mark.parametrize("longest", [4000, 60])
def test_rates_are_as_accurate_as_numpys(tmp_path, loaded, monkeypatch, longest):
    monkeypatch.setattr("pydy.export.javascript.LONGEST", longest)
    bicycle = whipple_bicycle.derive()
    system = System(bicycle.definition, constants=whipple_bicycle.benchmark_parameters(bicycle))
    x = np.random.default_rng(1).uniform(-0.3, 0.3, system.num_states)
    page = loaded(system.export(tmp_path / "bicycle.js").path)
    failed, found = rates(page, x, [0.0] * system.num_specifieds)
    assert not failed
    expected = system.evaluate_ode(x, t=0.3)
    assert found == pytest.approx(expected, rel=1e-11, abs=1e-12 * abs(expected).max())


def test_error_functions_are_those_of_the_c_library(tmp_path, loaded):
    page = loaded(pulled_by_error_functions().export(tmp_path / "model.js").path)
    for x in (-6.5, -2.5, -1e-9, 0.0, 0.84, 2.0, 2.001, 2.999, 3.0, 5.5, 26.0):
        failed, found = rates(page, [x, x, 0.0, 0.0])
        assert not failed
        assert found[2:] == pytest.approx([math.erf(x), math.erfc(x)], rel=1e-13, abs=0.0)


def test_weak_pivots_are_solved_by_pivoting_and_singular_matrices_told(tmp_path, loaded):
    system = pendulum()
    system.constants = {**system.constants, "m0": 1e-14, "m2": 1e-13}
    x = np.array([0.1, np.pi / 2, 0.3, 0.2, 0.1, 0.4])
    page = loaded(system.export(tmp_path / "weak.js").path)
    failed, found = rates(page, x, [0.0])
    assert not failed
    assert found == pytest.approx(system.evaluate_ode(x, t=0.3, r={"F": 0.0}), rel=1e-6)
    page.evaluate("model.bind({ m0: 0, m1: 0, m2: 0 })")
    failed, found = rates(page, x, [0.0])
    assert failed
    assert np.isnan(found[3:]).all()


def test_simulate_takes_names_and_returns_rows(tmp_path, loaded):
    system, bounce = ball()
    page = loaded(system.export(tmp_path / "ball.js", events=bounce).path)
    run = page.evaluate(
        """(times) => {
            const run = model.simulate({ times, initial: { y: 1.5 }, rtol: 1e-9, atol: 1e-9 });
            return { ...run, states: run.states.map((row) => Array.from(row)) };
        }""",
        TIMES.tolist(),
    )
    system.initial_conditions = {"y": 1.5}
    expected, info = system.integrate(rtol=1e-9, atol=1e-9, events=bounce, full_output=True)
    assert np.array(run["states"]) == pytest.approx(expected, abs=1e-10)
    assert run["steps"] == info["steps"]
    assert [e["time"] for e in run["events"]] == pytest.approx([e.time for e in info["events"]])
    assert {e["name"] for e in run["events"]} == {"bounce"}


def test_a_motion_that_starts_on_a_surface_follows_the_table(tmp_path, loaded):
    system = departures.started(departures.CASES[0])
    page = loaded(system.export(tmp_path / "table.js", events=departures.events()).path)
    for case in departures.CASES:
        constants = {str(symbol): value for symbol, value in departures.numbers(case).items()}
        run = page.evaluate(
            """([times, v, constants]) => {
                const tolerances = { rtol: 1e-10, atol: 1e-12 };
                const run = model.simulate({ times, initial: { v }, constants, ...tolerances });
                return { ...run, states: run.states.map((row) => Array.from(row)) };
            }""",
            [departures.TIMES, case.v0, constants],
        )
        moments, heights = [e["time"] for e in run["events"]], [row[0] for row in run["states"]]
        assert heights[0] == 0.0
        departures.check(case, moments, heights, run["status"] == "stopped")


def test_crossings_follow_the_table(tmp_path, loaded):
    system = crossings.started(crossings.CASES[0])
    page = loaded(system.export(tmp_path / "table.js", events=crossings.events()).path)
    simulate = """(wanted) => {
        const run = model.simulate({ ...wanted, rtol: 1e-11, atol: 1e-13 });
        return { ...run, states: run.states.map((row) => Array.from(row)) };
    }"""
    for case in crossings.CASES:
        crossings.check_javascript(case, page.evaluate(simulate, crossings.for_javascript(case)))


def test_an_event_that_becomes_nan_ends_the_motion(tmp_path, loaded):
    system, _ = ball()
    root = Event(sm.sqrt(system.states[0]), terminal=True, name="root")
    page = loaded(system.export(tmp_path / "root.js", events=root).path)
    run = page.evaluate("model.simulate({ times: [0, 1] })")
    assert run["status"] == "the event root is NaN"


def test_constants_may_be_given_in_a_map(tmp_path, loaded):
    page = loaded(spring_of("length").export(tmp_path / "spring.js").path)
    call = "(given) => Array.from(model.bind(new Map(given)))"
    assert page.evaluate(call, [["length", 2.5]]) == [2.5]


def test_an_unknown_name_is_answered_with_those_there_are(tmp_path, loaded):
    page = loaded(pendulum().export(tmp_path / "pendulum.js").path)
    with pytest.raises(Exception, match="constants: no l9; there are g, l0"):
        page.evaluate("model.bind({ l9: 1 })")


NAMES = (
    "length",
    "name",
    "constructor",
    "__proto__",
    "toString",
    "then",
    "valueOf",
    "0",
    "θ",
    "theta",
)


def test_constants_may_be_called_like_anything_that_objects_have(tmp_path, loaded):
    page = loaded(spring_of(*NAMES).export(tmp_path / "spring.js").path)
    values = {name: 0.5 + k for k, name in enumerate(NAMES)}
    call = """(values) => {
        const constants = JSON.parse(values); // which makes __proto__ a name like any other
        const { states, status } = model.simulate({ times: [0, 0.25], constants });
        return [status, ...states[1]];
    }"""
    status, x, _ = page.evaluate(call, json.dumps(values))
    assert status == "finished"
    stiffness = sum((k + 1) * value for k, value in enumerate(values.values()))
    assert x == pytest.approx(np.cos(np.sqrt(stiffness) * 0.25), abs=1e-7)
    again = "([k]) => model.simulate({ times: [0, 0.25], constants: k }).states[1][0]"
    every = page.evaluate("() => model.constants.map((one) => one.name)")
    assert page.evaluate(again, [[values[name] for name in every]]) == x


def test_a_constant_that_is_no_number_is_named(tmp_path, loaded):
    page = loaded(spring_of("length").export(tmp_path / "spring.js").path)
    said = "(k) => { try { model.bind(k); } catch (error) { return error.message; } }"
    assert (
        page.evaluate(said, {"length": "2"}) == "constants: length must be a finite number, got 2"
    )
    assert "constants: no lenght; there are length" in page.evaluate(said, {"lenght": 2})


ZERO = "atol must be above 0 where a state begins at 0 or rtol is 0, got rtol {} and atol 0"


def test_what_simulate_cannot_use_is_named(tmp_path, loaded):
    system, bounce = ball()
    page = loaded(system.export(tmp_path / "ball.js", events=bounce).path)
    said = """text => {
        try { return model.simulate(eval(`({ ${text} })`)).status; } catch (e) { return e.message; }
    }"""
    for given, message in {
        "": "times must be an array of at least one number, got undefined",
        "times: 3": "times must be an array of at least one number, got 3",
        "times: []": "times must be an array of at least one number, got []",
        "times: [0, Infinity]": "times must be finite numbers, got Infinity at 1",
        "times: [0, '1']": "times must be finite numbers, got 1 at 1",
        "times: [1, 0]": "times must ascend, got 0 after 1 at 1",
        "times: [0, 1], rtol: -1": "rtol must be finite and not negative, got -1",
        "times: [0, 1], atol: [1]": "atol must be finite and not negative, got [1]",
        "times: [0, 1], atol: 0, rtol: 0": ZERO.format("0"),
        "times: [0, 1], atol: 0, initial: [0, 1]": ZERO.format("1.49012e-8"),
        "times: [0, 1], maxStep: null": "maxStep must be a positive number, got null",
        "times: [0, 1], maxSteps: NaN": "maxSteps must be at least 1, got NaN",
        "times: [0, 1], rtoll: 1": (
            "there is no option rtoll; there are rtol, atol, maxStep, maxSteps"
        ),
        "times: [0, 1], initial: [NaN, 1]": "initial: y must be a finite number, got NaN",
        "times: [0, 1], initial: 'y'": "initial must be an array, an object or a Map, got y",
        "times: [0, 1], constants: new Set(['g'])": (
            "constants must be an array, an object or a Map, got [object Set]"
        ),
        "times: [0, 1], constants: new Map([['G', 9.8]])": "constants: no G; there are g, m",
        "times: [0, 0, 1], atol: undefined, maxStep: Infinity": "finished",
        "times: new Float64Array([2]), atol: 0, initial: [1, 1]": "finished",
    }.items():
        assert page.evaluate(said, given) == message


SAID = """text => {
    const given = eval(`({ times: [0, 0.1], ${text} })`);
    try { return model.simulate(given).status; } catch (e) { return e.message; }
}"""


def test_what_residuals_give_is_not_kept_where_other_values_are_given(tmp_path, loaded):
    """In Python it is solved for again."""
    x, z = me.dynamicsymbols("x z")
    k = sm.Symbol("k")
    frame, place = me.ReferenceFrame("N"), me.Point("P")
    place.set_vel(frame, x.diff() * frame.x)
    bodies, loads = [me.Particle("b", place, 1)], [(place, -z * frame.x)]
    definition = Definition(frame, [x], bodies=bodies, loads=loads)
    system = System(definition, {k: 1.0}, implicit=Implicit({z: z**3 + z - k * x}))
    system.initial_conditions = {x: 1.0}
    page = loaded(system.export(tmp_path / "implicit.js").path)
    needed = (
        "initial must give z too, with which the residuals of `implicit` are zero: what is given "
        "may change it"
    )
    for given, said in {
        "": "finished",
        "initial: {x: 2}": needed,
        "constants: {k: 2}": needed,
        "initial: {x: 2, z: 1}": "finished",
        "constants: {k: 2}, initial: {z: 1}": "finished",
    }.items():
        assert page.evaluate(SAID, given) == said


def test_a_start_far_from_the_constraints_is_refused_as_in_python(tmp_path, loaded):
    x, y = me.dynamicsymbols("x y")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    definition = Definition(
        frame, [x, y], bodies=[me.Particle("b", place, 1)], loads=[(place, -9 * frame.y)],
        holonomic_constraints=[x**2 + y**2 - 1],
    )  # fmt: skip
    system = System(definition, initial_conditions={x: 1.0})
    module = javascript_module(exported_model(system._now(), constraints="project"), ["a pendulum"])
    (tmp_path / "pendulum.js").write_text(module, encoding="utf-8")
    page = loaded(tmp_path / "pendulum.js")
    for given, said in {
        "initial: [1, 0, 0, 0]": "finished",
        "initial: [1.0005, 0, 0, 0]": "finished",
        "initial: [1.2, 0, 0, 0]": "the initial conditions do not satisfy the constraints",
        "initial: [1, 0, 1, 0]": "the initial conditions do not satisfy the constraints",
    }.items():
        assert page.evaluate(SAID, given) == said
