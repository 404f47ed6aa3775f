"""A holonomic constraint whose derivative was not given is told wherever it is missed."""

import functools
import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.analysis import Trial
from pydy.control import OptimalControl
from pydy.errors import IntegrationError, PyDyUserWarning
from pydy.mechanics import Definition
from pydy.system import System

X, Y, V, W = me.dynamicsymbols("x y v w")
M, G, L, K = sm.symbols("m g l k")
T = me.dynamicsymbols._t
MISSING = r"No velocity constraint keeps the holonomic constraint 0, .*`velocity_constraints`"


def on_a_circle(called=True, velocity=()):
    N, P = me.ReferenceFrame("N"), me.Point("P")
    P.set_pos(me.Point("O"), X * N.x + Y * N.y)
    P.set_vel(N, V * N.x + W * N.y)
    bodies, loads = [me.Particle("bob", P, M)], [(P, -M * G * N.y)]
    more = {"velocity_constraints": list(velocity), "u_dependent": [W]} if velocity else {}
    kane = me.KanesMethod(
        N, [X], [V] if velocity else [V, W], [X.diff(T) - V, Y.diff(T) - W], q_dependent=[Y],
        configuration_constraints=[X**2 + Y**2 - L**2], bodies=bodies, forcelist=loads, **more,
    )  # fmt: skip
    if called:
        kane.kanes_equations(bodies, loads)
    numbers = {M: 1.0, G: 9.81, L: 1.0}
    return System(kane, numbers, initial_conditions={X: 0.0, Y: -1.0}, times=np.linspace(0, 1, 5))


@functools.cache
def forgotten():
    return on_a_circle()


CALLS = {
    "evaluate_ode": lambda s: s.evaluate_ode(),
    "evaluate_jacobian": lambda s: s.evaluate_jacobian(),
    "linearize": lambda s: s.linearize(),
    "mass_matrix": lambda s: s.mass_matrix(),
    "generate_ode_function": lambda s: s.generate_ode_function(),
    "equations_of_motion": lambda s: s.equations_of_motion(),
    "constraint_forces": lambda s: s.constraint_forces,
    "reaction": lambda s: s.reaction("bob", s.eom_method.bodies[0].masscenter),
    "OptimalControl": lambda s: OptimalControl(s, sm.Integral(V**2, T), 1.0, mesh=2),
}


@pytest.mark.parametrize("call", CALLS)
def test_what_evaluates_linearizes_or_compiles_gives_one_warning_with_the_remedy(call):
    with pytest.warns(PyDyUserWarning, match=MISSING) as told:
        CALLS[call](forgotten())
    assert len(told) == 1
    assert told[0].filename == __file__


def test_an_optimal_trajectory_gives_the_warning_once():
    with pytest.warns(PyDyUserWarning, match=MISSING) as told:
        forgotten().optimize_trajectory(sm.Integral(V**2, T), 0.1, mesh=2)
    assert len(told) == 1
    assert told[0].filename == __file__


def test_constraint_forces_of_complete_equations_are_formed_in_silence():
    system = on_a_circle(velocity=[X * V + Y * W])
    assert len(system.constraint_forces) == 1
    assert system.reaction("bob", system.eom_method.bodies[0].masscenter).force != 0


def test_exports_give_the_warning(tmp_path):
    with pytest.warns(PyDyUserWarning, match=MISSING) as told:
        forgotten().export(tmp_path / "model.c")
    assert len(told) == 1


def test_equations_that_are_formed_from_bodies_give_the_warning_too():
    with pytest.warns(PyDyUserWarning, match=MISSING):
        on_a_circle(called=False).evaluate_ode()


@pytest.mark.parametrize("solver", ["dop853", "radau"])
def test_integrate_raises_without_a_warning(solver):
    system = on_a_circle()
    system.initial_conditions = {X: np.sin(0.5), Y: -np.cos(0.5)}
    system.ode_solver = solver
    with pytest.raises(IntegrationError, match="constraint"):
        system.integrate()


FITS = pytest.mark.parametrize(
    "options", [{}, {"method": "collocation"}, {"method": "collocation", "mesh": 10}]
)


@FITS
@pytest.mark.parametrize("unknown", [[], [X]])
def test_fits_raise_without_a_warning_as_simulations_do(options, unknown):
    system, times = on_a_circle(), np.linspace(0.0, 1.0, 11)
    system.initial_conditions = {X: np.sin(0.3), Y: -np.cos(0.3)}
    system.ode_solver = "dop853"
    trial = Trial(times, {X: np.sin(0.3 * np.cos(np.sqrt(9.81) * times))}, unknown=unknown)
    message = "cannot keep all constraints.* rate of the holonomic constraint 0: .* is "
    with pytest.raises(IntegrationError, match=message):
        system.fit([G], trial, **options)


def test_a_collocated_fit_that_does_not_converge_is_told_first():
    system, times = on_a_circle(), np.linspace(0.0, 1.0, 11)
    system.initial_conditions = {X: np.sin(0.3), Y: -np.cos(0.3)}
    trial = Trial(times, {X: np.sin(0.3 * np.cos(np.sqrt(9.81) * times))})
    with pytest.warns(PyDyUserWarning) as told:
        assert not system.fit([G], trial, method="collocation", most=1).success
    assert str(told[0].message).startswith("The fit did not converge in 1 iteration:")


def test_the_constraint_itself_is_evaluated_in_silence():
    np.testing.assert_allclose(forgotten().evaluate_holonomic_constraints(), [0.0], atol=1e-15)


def test_a_complete_pendulum_has_its_own_eigenvalues_in_silence():
    system = on_a_circle(velocity=[X * V + Y * W])
    found = np.sort_complex(system.linearize().eigenvalues)
    np.testing.assert_allclose(found, [-1j * np.sqrt(9.81), 1j * np.sqrt(9.81)], atol=1e-9)


def test_a_constraint_that_the_kinematics_keep_is_not_missed():
    """Quaternion rates keep the norm, whatever the angular velocity is."""
    e, u = me.dynamicsymbols("e:4"), me.dynamicsymbols("u:3")
    N, B = me.ReferenceFrame("N"), me.ReferenceFrame("B")
    B.orient_quaternion(N, e)
    rates = B.ang_vel_in(N)
    B.set_ang_vel(N, sum(s * axis for s, axis in zip(u, B, strict=True)))
    O = me.Point("O")
    O.set_vel(N, 0)
    matrix = sm.Matrix([[-e[1], -e[2], -e[3]], [e[0], -e[3], e[2]], [e[3], e[0], -e[1]],
                        [-e[2], e[1], e[0]]]) / 2  # fmt: skip
    assert rates != 0
    body = me.RigidBody("body", O, B, M, (me.inertia(B, 1, 2, 3), O))
    kane = me.KanesMethod(
        N, e[1:], u, list(sm.Matrix(e).diff(T) - matrix * sm.Matrix(u)), q_dependent=e[:1],
        configuration_constraints=[sum(i**2 for i in e) - 1], bodies=[body], kd_eqs_solver="CRAMER",
    )  # fmt: skip
    system = System(kane, initial_conditions={e[0]: 1.0, u[0]: 0.3})
    assert np.isfinite(system.evaluate_ode()).all()


def on_a_line():
    """y = k x is kept by w = v where k is 1, and is not with another k."""
    N, P = me.ReferenceFrame("N"), me.Point("P")
    P.set_pos(me.Point("O"), X * N.x + Y * N.y)
    P.set_vel(N, V * N.x + W * N.y)
    method = Definition(
        N, [X, Y], [V, W], bodies=[me.Particle("p", P, M)], holonomic_constraints=[Y - K * X],
        velocity_constraints=[W - V], loads=[(P, -L * X * N.x)],
    )  # fmt: skip
    return System(method, {K: 1.0, M: 1.0, L: 3.0}, initial_conditions={X: 0.2, Y: 0.2})


@FITS
def test_a_fit_of_what_only_these_constants_imply(options):
    """A spring on one of two equal masses, 2 m x'' = −l x."""
    times = np.linspace(0.0, 1.0, 11)
    trial = Trial(times, {X: 0.2 * np.cos(np.sqrt(2.0) * times)})
    system = on_a_line()
    system.ode_solver = "dop853"
    assert system.fit([L], trial, **options)[L] == pytest.approx(4.0, rel=1e-7)
    system.constants[K] = 2.0
    system.initial_conditions = {X: 0.2, Y: 0.4}
    with pytest.raises(IntegrationError, match=r"cannot keep all .*: -k\*x\(t\) \+ y\(t\), is"):
        system.fit([L], trial, **options)


def test_what_only_these_constants_imply_is_not_missed():
    system = on_a_line()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        system.evaluate_ode()
    system.constants[K] = 2.0
    with pytest.warns(PyDyUserWarning, match=MISSING):
        system.evaluate_ode()
