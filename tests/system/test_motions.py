"""Prescribed motions whose derivatives are in the equations, and the order of specifieds."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.errors import PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.system import System
from zoo import inertial_frame
from zoo.cases import close

T = me.dynamicsymbols._t
Z = me.dynamicsymbols("z")
RATE, ACCELERATION = Z.diff(T), Z.diff(T, 2)
X, INSTANT = np.array([0.6, -1.2]), 0.4


def shaken():
    """A damped pendulum whose pivot moves along z(t), of which only derivatives matter."""
    q, u = me.dynamicsymbols("q u")
    m, length, c = sm.symbols("m l c")
    frame = me.ReferenceFrame("N")
    turned = frame.orientnew("A", "Axis", (q, frame.z))
    turned.set_ang_vel(frame, u * frame.z)
    origin, pivot, bob = me.Point("O"), me.Point("P"), me.Point("B")
    origin.set_vel(frame, 0)
    pivot.set_pos(origin, Z * frame.x)
    pivot.set_vel(frame, RATE * frame.x)
    bob.set_pos(pivot, -length * turned.y)
    bob.v2pt_theory(pivot, frame, turned)
    kane = me.KanesMethod(frame, [q], [u], kd_eqs=[q.diff(T) - u])
    kane.kanes_equations([me.Particle("B", bob, m)], [(bob, -c * bob.vel(frame) - m * frame.y)])
    return kane


@pytest.fixture(scope="module")
def kane():
    return shaken()


def expected(kane, rate, acceleration):
    system = System(kane, specifieds={RATE: rate, ACCELERATION: acceleration})
    return system.evaluate_ode(X, INSTANT)


def test_the_equations_hold_derivatives_only(kane):
    assert System(kane).specifieds_symbols == {RATE, ACCELERATION}


def test_an_expression_of_a_motion_that_drops_out_is_differentiated(kane):
    system = System(kane, specifieds={Z: sm.sin(3 * T)})
    s, c = np.sin(3 * INSTANT), np.cos(3 * INSTANT)
    close(system.evaluate_ode(X, INSTANT), expected(kane, 3 * c, -9 * s))
    assert system.specifieds_symbols == {Z, RATE, ACCELERATION}


def test_the_motion_that_drops_out_is_in_the_trajectory(kane):
    system = System(kane, specifieds={Z: sm.sin(3 * T)}, times=[0.0, 0.5, 1.0])
    close(system.simulate()[Z], np.sin([0.0, 1.5, 3.0]))


def test_a_motion_that_is_no_longer_given_is_no_specified_any_more(kane):
    system = System(kane, specifieds={Z: sm.sin(3 * T)})
    system.specifieds = {}
    assert system.specifieds_symbols == {RATE, ACCELERATION}


def test_a_number_for_a_motion_that_drops_out_is_taken(kane):
    close(
        System(kane, specifieds={Z: 2.0}).evaluate_ode(X, INSTANT),
        System(kane).evaluate_ode(X, INSTANT),
    )


ALL = (Z, RATE, ACCELERATION)


@pytest.mark.parametrize(
    "specifieds",
    [
        {ALL: lambda x, t: [np.sin(t), np.cos(t), -np.sin(t)]},
        {s: (lambda x, t, k=k: np.sin(t + k * np.pi / 2)) for k, s in enumerate(ALL)},
        {ALL: np.array([np.sin(INSTANT), np.cos(INSTANT), -np.sin(INSTANT)])},
        {"symbols": ALL, "values": lambda x, t: [np.sin(t), np.cos(t), -np.sin(t)]},
    ],
    ids=["a function", "functions", "numbers", "format 2"],
)
def test_a_motion_that_drops_out_may_be_given_with_its_derivatives(kane, specifieds):
    system = System(kane, specifieds=specifieds)
    close(system.evaluate_ode(X, INSTANT), expected(kane, np.cos(INSTANT), -np.sin(INSTANT)))


@pytest.mark.parametrize("wrong", [me.dynamicsymbols("w"), Z.diff(T, 3)])
def test_what_is_no_part_of_the_motion_is_still_refused(kane, wrong):
    with pytest.raises(ValueError, match="not one of the specifieds of the system"):
        System(kane, specifieds={wrong: 1.0})


@pytest.mark.parametrize("given", ["together", "apart", "format 2"])
def test_a_second_derivative_that_cancels_may_be_given_with_the_motion(given):
    """A bob at the end of a rope of length l(t): its angle's derivative holds l and l' alone."""
    q, u, l = me.dynamicsymbols("q u l")
    frame, origin = inertial_frame()
    turned = frame.orientnew("A", "Axis", (q, frame.z))
    bob = origin.locatenew("B", -l * turned.y)
    method = Definition(
        frame, [q], [u], bodies=[me.Particle("bob", bob, 1)], loads=[(bob, -9.81 * frame.y)]
    )
    symbols = (l, l.diff(T), l.diff(T, 2))
    assert System(method).specifieds_symbols == {*symbols[:2]}
    numbers = [2.0, 0.3, 5.0]
    specifieds = {
        "together": {symbols: lambda x, t: np.array(numbers)},
        "apart": dict(zip(symbols, numbers, strict=True)),
        "format 2": {"symbols": symbols, "values": lambda x, t: np.array(numbers)},
    }[given]
    found = System(method, specifieds=specifieds).evaluate_ode([0.1, 0.7])
    close(found, [0.7, -9.81 * np.sin(0.1) / 2.0 - 2.0 * 0.3 * 0.7 / 2.0])


def test_an_output_may_not_have_the_name_of_the_motion(kane):
    with pytest.raises(ValueError, match=r"z\(t\)"):
        System(kane, specifieds={Z: sm.sin(T)}, outputs={Z: sm.Integer(1)})


# what does not follow from a function


def moving(x, t):
    return np.sin(t)


@pytest.mark.parametrize("value", [moving, SampledInput([0.0, 1.0, 2.0], [0.0, 1.0, 0.0])])
def test_a_motion_without_its_derivatives_warns_with_the_remedy(kane, value):
    with pytest.warns(PyDyUserWarning, match=r"stays zero.* as a SymPy expression of time") as got:
        System(kane, specifieds={Z: value})
    assert [str(w.message).split("`")[5] for w in got] == [str(RATE), str(ACCELERATION)]
    assert got[0].filename == __file__


def test_the_warning_comes_once(kane):
    with pytest.warns(PyDyUserWarning, match="stays zero"):
        system = System(kane, specifieds={Z: moving}, times=[0.0, 1.0])
    system.evaluate_ode()
    system.integrate()


def test_a_motion_put_in_place_warns_at_the_next_evaluation(kane):
    system = System(kane)
    system.specifieds[Z] = moving
    with pytest.warns(PyDyUserWarning, match="stays zero"):
        system.evaluate_ode()


def test_a_motion_for_one_call_warns_too():
    system = System(zoo.shaken().kane)
    with pytest.warns(PyDyUserWarning, match="stays zero"):
        system.evaluate_ode(r={me.dynamicsymbols("y"): moving})


@pytest.mark.parametrize(
    "specifieds",
    [
        {Z: 1.0},
        {Z: sm.sin(T)},
        {Z: moving, RATE: sm.cos(T)},
        {Z: moving, RATE: 1.0},
        {Z: moving, RATE: moving, ACCELERATION: 0.0},
    ],
    ids=["number", "expression", "rate as expression", "rate as number", "all"],
)
def test_what_follows_does_not_warn(kane, specifieds):
    System(kane, specifieds=specifieds).evaluate_ode()


# several specifieds at once

F1, F2, F3 = FORCES = me.dynamicsymbols("f1:4")


def pushed():
    """Three masses, each with a force of its own."""
    x, v = me.dynamicsymbols("x1:4"), me.dynamicsymbols("v1:4")
    frame, origin = inertial_frame()
    bodies, loads = [], []
    for k in range(3):
        point = origin.locatenew(f"P{k}", x[k] * frame.x)
        point.set_vel(frame, v[k] * frame.x)
        bodies.append(me.Particle(f"B{k}", point, sm.Symbol("m")))
        loads.append((point, FORCES[k] * frame.x))
    kane = me.KanesMethod(frame, x, v, [a.diff(T) - b for a, b in zip(x, v, strict=True)])
    kane.kanes_equations(bodies, loads)
    return kane


@pytest.fixture
def forces():
    return System(pushed())


@pytest.mark.parametrize("value", [2.0, 2, sm.Integer(2), np.array(2.0)])
def test_one_number_for_several_specifieds_holds_for_each(forces, value):
    forces.specifieds = {(F1, F3): value}
    close(forces.evaluate_ode()[3:], [2.0, 0.0, 2.0])


@pytest.mark.parametrize("generator", ["llvm", "lambdify"])
def test_the_order_of_the_second_format_is_the_order_of_r(forces, generator):
    forces.specifieds = {"symbols": (F2, F3, F1), "values": [20.0, 30.0, 10.0]}
    rhs = forces.generate_ode_function(generator=generator)
    listed = [rhs.__doc__.index(f"- {f}") for f in (F2, F3, F1)]
    assert listed == sorted(listed)
    close(rhs(np.zeros(6), 0.0, [2.0, 3.0, 1.0], [1.0])[3:], [1.0, 2.0, 3.0])
    close(forces.evaluate_ode()[3:], [10.0, 20.0, 30.0])
    close(forces.evaluate_ode(r=[2.0, 3.0, 1.0])[3:], [1.0, 2.0, 3.0])
    assert list(forces.specifieds_symbols) == list(FORCES)


def test_another_order_of_the_second_format_makes_another_function(forces):
    forces.specifieds = {"symbols": (F2, F3, F1), "values": [20.0, 30.0, 10.0]}
    first = forces.generate_ode_function()
    forces.specifieds["symbols"] = (F1, F2, F3)
    forces.specifieds["values"] = [10.0, 20.0, 30.0]
    close(forces.evaluate_ode()[3:], [10.0, 20.0, 30.0])
    close(forces.evaluate_ode_function(np.zeros(6), 0.0, [1.0, 2.0, 3.0], [1.0])[3:], [1, 2, 3])
    close(first(np.zeros(6), 0.0, [2.0, 3.0, 1.0], [1.0])[3:], [1.0, 2.0, 3.0])


def test_the_first_format_after_the_second_is_sorted_again(forces):
    forces.specifieds = {"symbols": (F2, F3, F1), "values": [20.0, 30.0, 10.0]}
    forces.specifieds = {F2: 20.0}
    close(forces.evaluate_ode(r=[1.0, 2.0, 3.0])[3:], [1.0, 2.0, 3.0])


def test_a_solver_of_the_users_gets_r_in_the_order_of_the_second_format(forces):
    seen = []

    def solver(f, x0, t, args=()):
        seen.append(args[0])
        return np.array([f(x0, instant, *args) for instant in t])

    forces.specifieds = {"symbols": (F2, F3, F1), "values": [20.0, 30.0, 10.0]}
    forces.ode_solver, forces.times = solver, [0.0, 1.0]
    close(forces.integrate()[0, 3:], [10.0, 20.0, 30.0])
    close(seen[0], [20.0, 30.0, 10.0])


def test_the_generated_function_takes_the_second_format(forces):
    rhs = forces.generate_ode_function()
    r = {"symbols": (F2, F3, F1), "values": [2.0, 3.0, 1.0]}
    close(rhs(np.zeros(6), 0.0, r, [1.0])[3:], [1.0, 2.0, 3.0])


@pytest.mark.parametrize("symbols", [None, 5, "f1"])
def test_the_second_format_needs_a_list_of_symbols(forces, symbols):
    with pytest.raises(TypeError, match=r"`specifieds\['symbols'\]` must be a sequence"):
        forces.specifieds = {"symbols": symbols, "values": [1.0]}
