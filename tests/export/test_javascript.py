"""The text of exported JavaScript; `tests/browser` runs it."""

import json
import re
import shutil
import subprocess

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from sympy.physics.mechanics import dynamicsymbols

from oracles import crossings, departures, projections
from pydy._assembly.programs import block_program
from pydy._evaluation.exporting import exported_model
from pydy._program.operations import SHIPPED
from pydy.errors import PyDyUserWarning
from pydy.export.javascript import (
    LONGEST,
    PRELUDE,
    _projection,
    javascript_module,
    javascript_of,
    literal,
)
from pydy.mechanics import Definition
from pydy.solvers import Event
from pydy.system import System
from zoo.ball import bouncing_ball
from zoo.exported_models import (
    ball,
    hostile,
    kicked,
    kicked_at_an_input,
    kicked_to,
    pendulum,
    rope,
)


def test_every_function_of_an_operation_is_defined():
    called = {m[1] for row in SHIPPED.values() if (m := re.match(r"(\w+)\(", row.c))}
    assert called
    for name in called:
        assert re.search(rf"\b{name}\b", PRELUDE), name


def test_nothing_of_c_is_left_in_the_linear_algebra_that_is_made_of_it():
    words = "double|int|int32_t|int64_t|static|inline|INLINE|APART|SERIAL|LESS|AT|sizeof"
    for text, name in ((PRELUDE, "lu_factor"), (_projection(), "set_identity")):
        code = re.sub(r"//.*|/\*[\s\S]*?\*/", "", text)
        assert f"function {name}(" in code
        assert not re.search(rf"\b(?:{words})\b|->|\(\*|&\w|\{{\{{", code)
        bare = re.sub(r"\"[^\"]*\"|`[^`]*`", "", code)
        first = set(re.findall(r"\b(\w+) (?!of\b)(?=[A-Za-z_])", bare))
        assert first <= {
            "const",
            "else",
            "function",
            "let",
            "new",
            "of",
            "return",
        }  # no other types


def test_no_name_of_a_user_stands_in_the_code_as_it_is(tmp_path):
    text = hostile().export(tmp_path / "mass.js").path.read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if not line.startswith("//")]
    code = "\n".join(lines)
    assert "</script>" not in code
    assert "/*CODE*/" not in code.split("const info =")[0]
    assert "\u2028" not in text


def test_no_text_is_made_into_code_where_it_runs(tmp_path):
    system, bounce = ball()
    text = system.export(tmp_path / "ball.js", events=bounce).path.read_text(encoding="utf-8")
    assert not re.search(r"\beval\b|\bnew Function\b|\bimport\b", text)


def test_literals_cannot_end_a_script():
    assert literal({"a": "</script>&<!--"}) == (
        '{"a":"\\u003c/script\\u003e\\u0026\\u003c!--"}'
    )  # fmt: skip


def test_very_long_programs_are_divided(monkeypatch):
    system = pendulum()
    system.generate_ode_function()
    program = block_program(system.model.assembly, "rates")
    whole = javascript_of(program, "rates")
    monkeypatch.setattr("pydy.export.javascript.LONGEST", 50)
    parts = javascript_of(program, "rates")
    assert "function rates_1(" in parts
    assert "function rates_1(" not in whole
    assert LONGEST > 50


SIMULATE = """
import(process.argv[1]).then(({ default: model }) => {
  const runs = JSON.parse(process.argv[2]).map((given) => {
    const run = model.simulate({ ...given, rtol: 1e-11, atol: 1e-13 });
    return { ...run, states: run.states.map((row) => Array.from(row)) };
  });
  console.log(JSON.stringify(runs));
});
"""


def simulated(folder, system, events, wanted):
    """Run an exported module by Node.js, once for each of `wanted`."""
    path = system.export(folder / "table.js", events=events).path.rename(folder / "table.mjs")
    return run_by_node(path, wanted)


def run_by_node(path, wanted):
    """Return what `simulate` of a module returns for each of `wanted`."""
    command = ["node", "-e", SIMULATE, path.as_uri(), json.dumps(wanted)]
    return json.loads(subprocess.run(command, capture_output=True, check=True, text=True).stdout)


by_node = pytest.mark.skipif(shutil.which("node") is None, reason="needs Node.js")


@by_node
def test_a_motion_that_starts_on_a_surface_follows_the_table(tmp_path):
    wanted = [
        {
            "times": departures.TIMES,
            "initial": {"v": case.v0},
            "constants": {str(k): value for k, value in departures.numbers(case).items()},
        }
        for case in departures.CASES
    ]
    system = departures.started(departures.CASES[0])
    runs = simulated(tmp_path, system, departures.events(), wanted)
    for case, run in zip(departures.CASES, runs, strict=True):
        moments, heights = [e["time"] for e in run["events"]], [row[0] for row in run["states"]]
        assert heights[0] == 0.0
        departures.check(case, moments, heights, run["status"] == "stopped")


@by_node
def test_a_pulse_between_two_steps_is_not_passed_over(tmp_path):
    pulses = [(5.0, 0.01), (11.3, 1e-4), (0.0, 0.1), (20.0 - 1e-6, 1e-6)]
    wanted = [{"times": [0.0, 20.0], "constants": {"t0": t0, "w": w}} for t0, w in pulses]
    for (t0, w), run in zip(pulses, simulated(tmp_path, kicked(), None, wanted), strict=True):
        assert run["states"][1] == pytest.approx(kicked_to(20.0, t0, w), rel=1e-8, abs=1e-9)
        assert run["steps"] < 100


@by_node
def test_a_pulse_that_an_input_begins_is_not_passed_over(tmp_path):
    pulses = [(5.0, 0.01), (11.3, 1e-4), (0.0, 0.1)]
    wanted = [
        {"times": [0.0, 20.0], "constants": {"w": w}, "inputs": {"D": t0}} for t0, w in pulses
    ]
    runs = simulated(tmp_path, kicked_at_an_input(), None, wanted)
    for (t0, w), run in zip(pulses, runs, strict=True):
        assert run["states"][1] == pytest.approx(kicked_to(20.0, t0, w), rel=1e-8, abs=1e-9)


def test_pulses_that_exported_code_does_not_know_are_warned_of(tmp_path):
    system = kicked()
    system.constants = {}
    system.specifieds = {"F": sm.Piecewise((500, sm.sin(dynamicsymbols._t) > 0.999), (0, True))}
    with pytest.warns(PyDyUserWarning, match=r"6 times, the closest 0\.08945 apart, .*`maxStep"):
        system.export(tmp_path / "kicked.js")
    system.export(tmp_path / "kicked.c")  # which has no solver


def test_pulses_by_an_input_that_exported_code_does_not_know_are_warned_of(tmp_path):
    x, v, level = dynamicsymbols("x v level")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    P = O.locatenew("P", x * N.x)
    force = sm.Piecewise((500, sm.sin(dynamicsymbols._t) > level), (0, True))
    system = System(
        Definition(N, [x], [v], bodies=[me.Particle("mass", P, 2)], loads=[(P, force * N.x)]),
        times=[0.0, 20.0], specifieds={level: 0.999},
    )  # fmt: skip
    # 2 acos(0.999) = 0.08945, and two of three and a half periods
    with pytest.warns(PyDyUserWarning, match=r"6 times, the closest 0\.08945 apart"):
        system.export(tmp_path / "kicked.js")


@by_node
def test_crossings_follow_the_table(tmp_path):
    wanted = [crossings.for_javascript(case) for case in crossings.CASES]
    system = crossings.started(crossings.CASES[0])
    runs = simulated(tmp_path, system, crossings.events(), wanted)
    for case, run in zip(crossings.CASES, runs, strict=True):
        crossings.check_javascript(case, run)


@by_node
def test_bounces_on_a_moving_floor_accumulate_and_none_leads_through_it(tmp_path):
    """The last rebounds are as low as roundings of the height, in which the signs say nothing."""
    system, _ = bouncing_ball()
    (q, u), e, c = system.states, sm.Symbol("e"), sm.Symbol("c")
    system.constants[c] = 0.0
    gap = q - c * dynamicsymbols._t
    bounce = Event(gap, direction=-1, reset={u: c - e * (u - c)}, name="bounce")
    cases = [(speed, e) for speed in (-10.0, -3.0, -0.3, 1.0, 3.0) for e in (0.3, 0.5, 0.8)]
    wanted = [
        {"times": [0.0, 9.0], "initial": {"q": 1.0, "u": 0.5 + c}, "constants": {"c": c, "e": e}}
        for c, e in cases
    ]
    for (_, e), run in zip(cases, simulated(tmp_path, system, bounce, wanted), strict=True):
        landing = np.sqrt(0.5**2 + 2 * 9.81)
        end = (0.5 + landing) / 9.81 + 2 * landing / 9.81 * e / (1 - e)
        assert run["status"] == "stopped"
        assert run["events"][-1]["time"] == pytest.approx(end, abs=1e-5)


@by_node
@pytest.mark.parametrize("case", projections.CASES, ids=lambda case: case.name)
def test_projections_follow_the_table(tmp_path, case):
    model = exported_model(projections.started(case)._now(), constraints="project")
    path = tmp_path / "table.mjs"
    path.write_text(javascript_module(model, [case.name]), encoding="utf-8")
    (run,) = run_by_node(path, [{"times": [0.0, 1e-9], "initial": case.start}])
    assert run["status"] == "finished"
    projections.check(case, run["states"][0])


@by_node
def test_an_event_that_a_reset_makes_nan_ends_the_motion(tmp_path):
    system, bounce = bouncing_ball()
    up = Event(sm.sqrt(-system.states[1] + 0.6) + 1, name="up")  # NaN where the ball rises fast
    [run] = simulated(tmp_path, system, [bounce, up], [{"times": [0.0, 0.2, 2.0]}])
    assert run["status"] == "the event up is NaN"
    assert [event["time"] for event in run["events"]] == pytest.approx(
        [(0.5 + np.sqrt(0.5**2 + 2 * 9.81 * 0.9)) / 9.81]
    )


@pytest.mark.skipif(shutil.which("node") is None, reason="needs Node.js")
def test_a_start_off_the_constraints_is_told(tmp_path):
    """The rope is 1 + 0.2 sin(3 t) long; the initial conditions of the module fit it at t = 0."""
    rope().export(tmp_path / "rope.js")
    (tmp_path / "package.json").write_text('{"type": "module"}')
    (tmp_path / "run.js").write_text(
        'import { simulate } from "./rope.js";\n'
        "const told = [];\n"
        "console.warn = (text) => told.push(text);\n"
        "const length = 1 + 0.2 * Math.sin(1.5), vy = -0.6 * Math.cos(1.5);\n"
        "const initial = { y: -length, vy }, late = [0.5, 1];\n"
        "for (const options of [{ times: [0, 1] }, { times: late, initial }, { times: late },\n"
        "  { times: [0, 0.5], constants: { b: 0.3 } }]) {\n"
        "  simulate(options);\n"
        "  told.push(told.length);\n"
        "}\n"
        "console.log(JSON.stringify(told));\n"
    )
    run = subprocess.run(["node", "run.js"], cwd=tmp_path, capture_output=True, text=True)
    good, consistent, early, _, changed, _ = json.loads(run.stdout)
    assert (good, consistent) == (0, 1)  # nothing but the counts
    assert "at t = 0.5 is 1.10 in the velocity constraint 0" in early
    assert "at t = 0 is -0.600 in the velocity constraint 0" in changed
