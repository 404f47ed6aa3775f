"""Functions of CasADi against the System that they were written from."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from _mechanics.test_nearly_singular import truss
from optional import optional
from pydy import System
from pydy.mechanics import Definition
from zoo import inertial_frame
from zoo.exported_models import ball, hostile, pendulum

casadi = optional("casadi")


def module(system, folder, **options):
    names = {}
    path = system.export(folder / "model.py", target="casadi", **options).path
    exec(compile(path.read_text(), str(path), "exec"), names)
    return names


def values(names, x, *, t=0.3, r=None, p=None):
    given = (
        [*{**names["INPUTS"], **(r or {})}.values()],
        [*{**names["CONSTANTS"], **(p or {})}.values()],
    )
    return lambda name: np.array(names[name](t, x, *given))


def test_functions_have_the_values_of_the_system(tmp_path):
    system = pendulum()
    names = module(system, tmp_path)
    assert isinstance(names["rates"], casadi.Function)
    x = np.linspace(0.2, 1.1, 6)
    changed = {"r": {"F": 0.7}, "p": {"l0": 1.3}}
    of = values(names, x, **changed)
    rates = system.evaluate_ode(x, t=0.3, **changed)
    np.testing.assert_allclose(of("rates")[:, 0], rates, rtol=1e-12)
    expected = system.evaluate_outputs(x, t=0.3, **changed)
    np.testing.assert_allclose(of("outputs")[:, 0], expected, rtol=1e-12)
    assert of("mass_matrix").shape == (3, 3)
    np.testing.assert_allclose(of("mass_matrix") @ rates[3:], of("forcing")[:, 0], rtol=1e-12)


def test_a_number_for_a_vector_is_refused(tmp_path):
    names = module(pendulum(), tmp_path)
    rates, x = names["rates"], np.linspace(0.2, 1.1, 6)
    r, p = ([*names[key].values()] for key in ("INPUTS", "CONSTANTS"))
    expected = np.array(rates(0.3, x, r, p))
    for place in (x[:, None], x[None], x.tolist(), casadi.DM(x)):
        np.testing.assert_array_equal(rates(0.3, place, r, p), expected)
    np.testing.assert_array_equal(rates(t=0.3, x=x, r=r, p=p)["rates"], expected)
    np.testing.assert_array_equal(rates(0.3, np.stack([x, x], 1), r, p), np.hstack([expected] * 2))
    for given, named, message in (
        ((0.3, x, r, 2.0), {}, r"rates: p must have \d+ entries, got the shape \(\)"),
        ((0.3, x, r, p[1:]), {}, "rates: p must have"),
        ((0.3, 0.0, r, p), {}, "rates: x must have 6 entries"),
        ((0.3, x, [], p), {}, r"rates: r must have 1 entries, got the shape \(0,\)"),
        ((), {"x": x, "t": 0.3, "r": r}, r"rates: p must have \d+ entries, got nothing"),
    ):
        with pytest.raises(ValueError, match=message):
            rates(*given, **named)


def test_casadi_differentiates_them(tmp_path):
    system = pendulum()
    names = module(system, tmp_path)
    t, x, r, p = (names["rates"].mx_in(k) for k in range(4))
    slopes = casadi.jacobian(names["rates"](t, x, r, p), x)
    function = casadi.Function("J", [t, x, r, p], [slopes])
    at = np.linspace(0.2, 1.1, 6)
    found = function(0.3, at, [*names["INPUTS"].values()], [*names["CONSTANTS"].values()])
    np.testing.assert_allclose(found, system.evaluate_jacobian(at, t=0.3), rtol=1e-10, atol=1e-10)


def test_constraints_are_functions_too(tmp_path):
    system, _ = truss(0.5, "definition")
    x = np.array([system.initial_conditions.get(s, 0.0) for s in system.states]) + 0.01
    names = module(system, tmp_path)
    of = values(names, x)
    np.testing.assert_allclose(of("rates")[:, 0], system.evaluate_ode(x), rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(of("holonomic")[:, 0], system.evaluate_constraints(x), rtol=1e-12)
    t, place, r, p = (names["holonomic"].mx_in(k) for k in range(4))
    row = casadi.jtimes(names["holonomic"](t, place, r, p), place, names["rates"](t, place, r, p))
    names["derivative"] = casadi.Function("derivative", [t, place, r, p], [row])
    np.testing.assert_allclose(of("velocity"), of("derivative"), rtol=1e-10)


def test_names_and_events(tmp_path):
    x = np.array([0.5, 0.1])
    system = hostile()
    of = values(module(system, tmp_path), x)
    np.testing.assert_allclose(of("rates")[:, 0], system.evaluate_ode(x, t=0.0), rtol=1e-12)
    system, bounce = ball()
    of = values(module(system, tmp_path, events=bounce), np.array([0.3, -2.0]))
    assert of("events").tolist() == [[0.3]]
    np.testing.assert_allclose(of("resets"), [[0.3, 1.6]])


def test_expressions_of_users_with_conditions(tmp_path):
    q, u = me.dynamicsymbols("q u")
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, u * frame.x)
    force = sm.Piecewise((-sm.Abs(q), u > 0), (sm.Max(q, 0.2) + sm.atan2(u, q), True))
    kane = me.KanesMethod(frame, [q], [u], kd_eqs=[u - q.diff()])
    kane.kanes_equations([me.Particle("P", point, sm.Symbol("m"))], [(point, force * frame.x)])
    system = System(kane)
    names = module(system, tmp_path)
    for x in ([0.5, 0.3], [0.1, -0.3], [-0.5, -0.3]):
        found = values(names, x)("rates")[:, 0]
        np.testing.assert_allclose(found, system.evaluate_ode(np.array(x)), rtol=1e-12)


def test_redundant_constraints_are_refused(tmp_path):
    x, y, q, vx, vy, u = me.dynamicsymbols("x y q vx vy u")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    rows = [x - sm.sin(q), y + sm.cos(q), x**2 + y**2 - 1]
    made = [
        Definition(
            frame, [x, y, q], [vx, vy, u], bodies=[me.Particle("p", place, 1)],
            loads=[(place, -10 * frame.y)], holonomic_constraints=own,
            configuration={q: 0.5, x: 0.48, y: -0.88},
        )
        for own in (rows[:2], rows)
    ]  # fmt: skip
    system = System(made[0])
    place = {x: np.sin(0.5), y: -np.cos(0.5), q: 0.5}
    state = [place.get(s, 0.0) for s in system.states]
    rates = values(module(system, tmp_path), state)("rates")
    assert rates[system.states.index(u)] == pytest.approx(-10 * np.sin(0.5))
    with pytest.raises(ValueError, match="`target='casadi'` needs constraints that are indep"):
        System(made[1]).export(tmp_path / "other.py", target="casadi")
