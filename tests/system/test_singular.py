"""A singular mass matrix is reported with its time and state."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.system import System
from zoo import inertial_frame
from zoo.cases import system_of

GENERATORS = ["llvm", "lambdify"]


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("name", ["chain", "added_mass"])
def test_a_singular_mass_matrix_is_reported_with_time_and_state(name, generator):
    model = zoo.MODELS[name]()
    system = system_of(model)
    zeros = [s for s in model.constants if s.name in {"m2", "a2"}]
    if name == "added_mass":
        zeros = [s for s in model.constants if s.name[0] in "ma"]
    system.constants.update(dict.fromkeys(zeros, 0.0))
    system.generate_ode_function(generator=generator)
    x = np.full(len(model.states), 0.0)
    x[0] = 0.125
    with pytest.raises(np.linalg.LinAlgError, match=r"(?s)3\.25.*0\.125|0\.125.*3\.25") as info:
        system.evaluate_ode(x, 3.25)
    assert info.value.time == 3.25
    np.testing.assert_array_equal(info.value.state, x)


@pytest.mark.parametrize("generator", GENERATORS)
def test_a_singular_mass_matrix_in_a_sweep_is_reported_at_its_row(generator):
    model = zoo.added_mass()
    system = system_of(model)
    # With a1 = -m1 and a2 = -m2, the determinant is m1 cos(x2) v2: singular where v2 = 0.
    for i in "12":
        system.constants[sm.Symbol(f"a{i}")] = -model.constants[sm.Symbol(f"m{i}")]
    system.generate_ode_function(generator=generator)
    xs, ts = model.sample(0, 9)
    assert np.all(np.isfinite(system.evaluate_ode(xs, ts)))
    xs[6, 3] = 0.0
    with pytest.raises(np.linalg.LinAlgError) as info:
        system.evaluate_ode(xs, ts)
    assert info.value.time == ts[6]
    np.testing.assert_array_equal(info.value.state, xs[6])


def test_a_singular_mass_matrix_comes_out_of_integrate():
    system = system_of(zoo.chain(), times=[0.5, 1.0])
    system.constants[sm.Symbol("m2")] = 0.0
    with pytest.raises(np.linalg.LinAlgError, match=r"0\.5"):
        system.integrate()


@pytest.mark.parametrize("generator", GENERATORS)
def test_a_body_without_mass_is_singular_whether_or_not_anything_pulls_it(generator):
    (q, u), mass = me.dynamicsymbols("q u"), sm.Symbol("m")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", q * frame.x)
    place.set_vel(frame, u * frame.x)
    bodies = [me.Particle("p", place, mass)]
    system = System(me.KanesMethod(frame, [q], [u], [q.diff() - u], bodies=bodies))
    system.constants = {mass: 0.0}
    system.generate_ode_function(generator=generator)
    with pytest.raises(np.linalg.LinAlgError, match="singular"):
        system.evaluate_ode([0.5, 1.0])
    system.constants = {mass: 2.0}
    np.testing.assert_array_equal(system.evaluate_ode([0.5, 1.0]), [1.0, 0.0])


def without_turning():
    """A rigid body whose frame was never told to turn: its inertia cancels, and w has no row."""
    q, x, u, w = me.dynamicsymbols("q x u w")
    mass, length, inertia, g = sm.symbols("m l I g")
    frame, body, centre = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("P")
    body.set_ang_vel(frame, 0)
    centre.set_vel(frame, length * u * (sm.cos(q) * frame.x + sm.sin(q) * frame.y))
    t = me.dynamicsymbols._t
    kane = me.KanesMethod(frame, [q, x], [u, w], kd_eqs=[q.diff(t) - u, x.diff(t) - w])
    rigid = me.RigidBody("R", centre, body, mass, (me.inertia(body, 0, 0, inertia), centre))
    kane.kanes_equations([rigid], [(centre, -mass * g * frame.y)])
    return kane, inertia


def test_a_constant_that_cancelled_is_called_that():
    kane, inertia = without_turning()
    with pytest.raises(ValueError, match=r"has the key `I`.*hold `I`, but it cancels"):
        System(kane, constants={inertia: 2.0})
    with pytest.raises(ValueError, match="or name it in `constants_symbols`, if a reaction"):
        System(kane, constants={inertia: 2.0})
    assert System(kane, constants={inertia: 2.0}, constants_symbols=[inertia]).constants
    with pytest.raises(
        ValueError, match=r"has the key `nothing`.*: g, l, m\. .*If it occurs in events"
    ):
        System(kane, constants={sm.Symbol("nothing"): 2.0})


@pytest.mark.parametrize("solver", ["odeint", "dop853"])
def test_rows_that_are_identically_zero_are_named(solver):
    system = System(without_turning()[0], times=[0.0, 1.0], ode_solver=solver)
    named = r"rows that are identically zero, of w\(t\): no mass or inertia takes part"
    with pytest.raises((np.linalg.LinAlgError, RuntimeError), match=named):
        system.integrate()
    with pytest.raises(np.linalg.LinAlgError, match=named) as caught:
        system.evaluate_ode(np.zeros((3, 4)), np.zeros(3))
    assert "redundant" not in str(caught.value)
