"""The Python of a model runs where there is no pydy."""

import json
import math
import subprocess
import sys

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from _mechanics.test_nearly_singular import truss
from pydy import System
from zoo.exported_models import ball, hostile, pendulum, pulled_by_error_functions, spring_of

ALONE = """
import json, sys
sys.modules["pydy"] = sys.modules["sympy"] = None
sys.path.insert(0, {folder!r})
import numpy as np
import {name} as model
x = np.array({x!r})
rows = np.stack([x, 1.1 * x])
print(json.dumps({{
    "rates": model.rates(0.3, x, {r!r}, {p!r}).tolist(),
    "rows": model.rates(np.array([0.3, 0.4]), rows, {r!r}, {p!r}).tolist(),
    "outputs": model.outputs(0.3, x, {r!r}, {p!r}).tolist(),
    "jacobian": model.jacobian(0.3, x, {r!r}, {p!r}).tolist(),
}}))
"""


def alone(system, folder, x, r=None, p=None):
    system.export(folder / "model.py")
    script = ALONE.format(folder=str(folder), name="model", x=x.tolist(), r=r, p=p)
    # -I: the module stands beside nothing of the caller's.
    command = [sys.executable, "-I", "-W", "error", "-c", script]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_numpys_functions_run_without_pydy(tmp_path):
    system = pendulum()
    x = np.linspace(0.2, 1.1, 6)
    found = alone(system, tmp_path, x, {"F": 0.7}, {"l0": 1.3})
    changed = {"r": {"F": 0.7}, "p": {"l0": 1.3}}
    expected = system.evaluate_ode(x, t=0.3, **changed)
    assert found["rates"] == pytest.approx(expected, rel=1e-12)
    assert found["rows"][0] == pytest.approx(expected, rel=1e-12)
    later = system.evaluate_ode(1.1 * x, t=0.4, **changed)
    assert found["rows"][1] == pytest.approx(later, rel=1e-12)
    assert found["outputs"] == pytest.approx(system.evaluate_outputs(x, t=0.3, **changed))
    by_states = system.evaluate_jacobian(x, t=0.3, **changed)
    assert np.array(found["jacobian"])[:6, :6] == pytest.approx(by_states, rel=1e-10, abs=1e-10)


@pytest.mark.parametrize("target", ["numpy", "jax", "casadi"])
def test_error_functions_need_no_scipy(tmp_path, target):
    if target != "numpy":
        pytest.importorskip(target)
    names = {}
    path = pulled_by_error_functions().export(tmp_path / "model.py", target=target).path
    text = path.read_text(encoding="utf-8")
    assert "scipy" not in text.replace("jax.scipy", "")
    exec(text, names)
    accuracy = 1e-5 if target == "jax" else 1e-14  # JAX has single precision by itself
    for x in (0.3, -4.0, 0.999, 1.001, 2.0, 6.0):
        found = np.ravel(np.array(names["rates"](0.0, [x, x, 0.0, 0.0], [], [])))
        assert found[2:] == pytest.approx([math.erf(x), math.erfc(x)], rel=accuracy, abs=0.0)


def test_names_are_strings_that_nothing_ends(tmp_path):
    system = hostile()
    x = np.array([0.5, 0.1])
    assert alone(system, tmp_path, x)["rates"] == pytest.approx(system.evaluate_ode(x, t=0.0))


@pytest.fixture
def module(tmp_path):
    names = {}
    pendulum().export(tmp_path / "model.py")
    exec((tmp_path / "model.py").read_text(), names)
    return names


def test_an_unknown_constant_is_named(module):
    with pytest.raises(KeyError, match="p: no 'l9'; there are"):
        module["rates"](0.0, np.zeros(6), p={"l9": 1.0})


def test_a_wrong_length_is_named(module):
    with pytest.raises(ValueError, match=r"x must have 6 columns, \['q0', .*; got \(5,\)"):
        module["rates"](0.0, np.zeros(5))
    with pytest.raises(ValueError, match=r"p must have \d+ columns, .*; got \(1,\)"):
        module["rates"](0.0, np.zeros(6), p=[1.0])
    with pytest.raises(ValueError, match=r"r must have 1 columns, \['F'\]; got \(\)"):
        module["rates"](0.0, np.zeros(6), 2.0)


def test_the_numbers_of_a_dictionary_may_be_one_for_each_row(tmp_path):
    """Each row is a spring of its own: v' = -(k + 2 c) x."""
    names = {}
    exec(spring_of("k", "c").export(tmp_path / "m.py").path.read_text(), names)
    x, k, c = np.array([[1.0, 0.5], [2.0, 0.25]]), np.array([1.0, 2.0]), np.array([3.0, 5.0])
    rates = names["rates"]
    expected = np.stack([x[:, 1], -(k + 2 * c) * x[:, 0]], -1)
    np.testing.assert_allclose(rates(0.0, x, p={"k": k, "c": c}), expected, rtol=1e-15)
    expected[:, 1] = -(k + 6.0) * x[:, 0]
    np.testing.assert_allclose(rates(0.0, x, p={"k": k, "c": 3.0}), expected, rtol=1e-15)
    at_one_state = rates(0.0, x[0], p={"k": k, "c": c})
    np.testing.assert_allclose(at_one_state[:, 1], -(k + 2 * c) * x[0, 0], rtol=1e-15)


def test_jax_has_one_entry_for_each_row_too(tmp_path):
    pytest.importorskip("jax", reason="needs pydy[jax]").config.update("jax_enable_x64", True)
    system = spring_of("k", "c")
    k, c = (sm.Symbol(name) for name in "kc")
    system.outputs = {"pull": -(k + 2 * c) * system.coordinates[0]}
    names = {}
    exec(system.export(tmp_path / "m.py", target="jax").path.read_text(), names)
    x = np.array([[1.0, 0.5], [2.0, 0.25]])
    p = {"k": np.array([1.0, 2.0]), "c": np.array([3.0, 5.0])}
    found = names["outputs"](0.0, x, p=p)
    np.testing.assert_allclose(found, [[-7.0], [-24.0]], rtol=1e-15)
    with pytest.raises(ValueError, match=r"must be of one state, .* use jax\.vmap for many"):
        names["rates"](0.0, x, p=p)


def test_a_folder_that_is_not_there_is_named_with_the_remedy(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"`path` is '.*', but there is no folder .*mkdir"):
        pendulum().export(tmp_path / "nowhere" / "model.py")


def test_a_singular_mass_matrix_gives_nan_without_a_warning(module):
    massless = dict.fromkeys(module["CONSTANTS"], 0.0)
    assert np.isnan(module["rates"](0.0, np.zeros(6), p=massless)[3:]).all()


def test_weak_pivots_are_solved_by_pivoting(module):
    system = pendulum()
    p = {"m0": 1e-14, "m1": 1.0, "m2": 1e-13}
    x = np.array([0.1, np.pi / 2, 0.3, 0.2, 0.1, 0.4])
    assert module["rates"](0.0, x, p=p) == pytest.approx(system.evaluate_ode(x, t=0.0, p=p), 1e-6)


def test_events_and_resets_are_functions_too(tmp_path):
    system, bounce = ball()
    names = {}
    system.export(tmp_path / "ball.py", events=bounce)
    exec((tmp_path / "ball.py").read_text(), names)
    assert names["events"](0.0, [0.3, -2.0]).tolist() == [0.3]
    assert names["resets"](0.0, [0.3, -2.0]) == pytest.approx(np.array([[0.3, 1.6]]))


SWITCHED = {
    "k (-q)^1.5": lambda q: sm.Piecewise((3 * (-q) ** sm.Rational(3, 2), q < 0), (0, True)),
    "(-q)^1.3": lambda q: sm.Piecewise(((-q) ** sm.Rational(13, 10), q < 0), (0, True)),
    "sin(q)/q": lambda q: sm.Piecewise((sm.sin(q) / q, sm.Ne(q, 0)), (1, True)),
    "sinc": sm.sinc,
    "two roots": lambda q: sm.Piecewise((sm.sqrt(q), q > 0), (q / sm.sqrt(-q), q < 0), (2, True)),
    "nested": lambda q: sm.Piecewise(
        (sm.Piecewise((sm.log(q), q > sm.Rational(1, 4)), (sm.acos(q), True)), q > 0), (1, True)
    ),
    "large": lambda q: sm.Piecewise((sm.exp(-2e3 * q), q > 0), (1 - 2e3 * q, True)),
}


@pytest.mark.parametrize("expression", SWITCHED)
def test_branches_that_are_not_taken_have_no_part_in_derivatives_by_jax(tmp_path, expression):
    jax = pytest.importorskip("jax", reason="needs pydy[jax]")
    jax.config.update("jax_enable_x64", True)
    q, u = me.dynamicsymbols("q u")
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, u * frame.x)
    kane = me.KanesMethod(frame, [q], [u], kd_eqs=[q.diff() - u])
    force = SWITCHED[expression](q) - u
    kane.kanes_equations([me.Particle("b", point, 1)], [(point, force * frame.x)])
    system = System(kane)
    names = {}
    exec(system.export(tmp_path / "m.py", target="jax").path.read_text(), names)
    for x in ([0.5, 0.1], [0.1, 0.1], [-0.5, 0.1], [0.0, 0.1]):
        expected = system.evaluate_jacobian(np.array(x), 0.0)
        assert np.isfinite(expected).all()
        for way in (jax.jacrev, jax.jacfwd):
            found = way(lambda x: names["rates"](0.0, x))(np.array(x))
            np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-12)


def test_jax_source_is_python(tmp_path):
    system = pendulum()
    compile(system.export(tmp_path / "m.py", target="jax").path.read_text(), "m.py", "exec")
    text = (tmp_path / "m.py").read_text()
    assert "import jax" in text
    assert "numpy as np" not in text.replace("jax.numpy as jnp", "")


@pytest.mark.parametrize("sag", [0.5, 1e-2, 1e-6, 0.0])
def test_constraints_close_to_a_singular_position_hold(tmp_path, sag):
    system, _ = truss(sag, "definition")
    x = [system.initial_conditions.get(s, 0.0) for s in system.states]
    names = {}
    system.export(tmp_path / "model.py")
    exec((tmp_path / "model.py").read_text(), names)
    expected = system.evaluate_ode(np.array(x))
    np.testing.assert_allclose(names["rates"](0.0, x), expected, rtol=0, atol=1e-14)
    several = names["rates"](0.0, np.array([x, x]))
    np.testing.assert_allclose(several, [expected, expected], rtol=0, atol=1e-14)
