"""The native solvers behind System: with every kind of specifieds, generator and linear solver."""

import copy
import pickle
from functools import cache

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import odeint

import zoo
from pydy import solvers
from pydy._errors import IntegrationError, SingularMatrixError
from pydy.inputs import SampledInput
from pydy.models import multi_mass_spring_damper
from pydy.system import System
from registry import SOLVER_NAMES, has_fixed_step, step_options
from zoo.cases import close, system_of

ALL = SOLVER_NAMES
F, T1, T2 = me.dynamicsymbols("F T1 T2")
START = [0.1, 0.5, -0.3, 0.2, 0.1, -0.4]
TIMES = np.array([0.0, 0.3, 0.6, 1.0, 1.4])
SAMPLES = SampledInput([0.0, 0.6, 1.0, 2.0], [0.3, 1.2, -0.4, 0.8])

SPECIFIEDS = {
    "numbers": {F: 0.4, T1: -0.2, T2: 0.1},
    "a function": {F: lambda x, t: np.cos(5 * t) - x[0], (T1, T2): [0.3, -0.1]},
    "an expression": {F: sm.cos(5 * zoo.T) - me.dynamicsymbols("q0"), T1: 0.3, T2: F / 4},
    "samples": {F: SAMPLES, (T1, T2): [0.3, -0.1]},
    "all at once": {F: SAMPLES, T1: lambda x, t: np.sin(t), T2: sm.sin(3 * zoo.T) + T1},
    "format 2": {
        "symbols": (T2, F, T1),
        "values": lambda x, t: np.array([np.sin(t), x[1], 0.2]),
    },
}


def pendulum(specifieds, solver=odeint, **options):
    model = zoo.pendulum()
    start = dict(zip(model.states, START, strict=True))
    return system_of(
        model,
        initial_conditions=start,
        times=TIMES,
        specifieds=specifieds,
        ode_solver=solver,
        **options,
    )


def options_of(solver):
    return step_options(solver, 1e-9, 2e-3)


@cache
def reference(kind):
    return pendulum(SPECIFIEDS[kind]).integrate(rtol=1e-11, atol=1e-11, tcrit=[0.6, 1.0])


@pytest.mark.parametrize("kind", SPECIFIEDS)
@pytest.mark.parametrize("solver", ALL)
def test_every_kind_of_specifieds_gives_odeints_trajectory(solver, kind):
    x = pendulum(SPECIFIEDS[kind], solver).integrate(**options_of(solver))
    close(x, reference(kind), 1e-6)


@pytest.mark.parametrize("kind", SPECIFIEDS)
@pytest.mark.parametrize("linear", ["numpy", "sympy"])
def test_an_external_linear_solver_gives_the_same_trajectory(linear, kind):
    system = pendulum(SPECIFIEDS[kind], "dop853")
    system.generate_ode_function(linear_sys_solver=linear)
    close(system.integrate(rtol=1e-9, atol=1e-9), reference(kind), 1e-6)


def test_radau_works_with_an_external_linear_solver():
    system = pendulum(SPECIFIEDS["samples"], "radau")
    system.generate_ode_function(linear_sys_solver=np.linalg.solve)
    close(system.integrate(rtol=1e-7, atol=1e-7), reference("samples"), 1e-6)


@pytest.mark.parametrize("generator", ["lambdify", "cython"])
def test_every_generator_gives_the_same_trajectory(generator):
    system = pendulum(SPECIFIEDS["all at once"], "dop853")
    system.generate_ode_function(generator=generator)
    close(system.integrate(rtol=1e-9, atol=1e-9), reference("all at once"), 1e-6)
    system.ode_solver = "radau"
    close(system.integrate(rtol=1e-6, atol=1e-6), reference("all at once"), 1e-5)


def test_only_functions_are_called_from_python():
    for kind, functions in (("samples", False), ("an expression", False), ("a function", True)):
        system = pendulum(SPECIFIEDS[kind], "dop853")
        calls = []
        system.ode_solver = lambda f, x0, t, args, calls=calls: calls.append(f.native(args))
        system.integrate()
        assert bool(calls[0].inputs.functions) is functions
        assert calls[0].kernel.addresses is not None


@pytest.mark.parametrize("native", [False, True])
def test_other_arguments_in_a_solver_of_the_user_are_used_or_refused(native):
    system = pendulum(SPECIFIEDS["numbers"], "dop853")
    x0 = np.zeros(len(system.states))

    def derivative(change):
        found = []

        def solver(f, x0, t, args):
            args = change(*args)
            if native:
                found.append(solvers.rk4(f, x0, [0.0, 1e-6], args, step=1.0)[1] / 1e-6)
            else:
                found.append(f(x0, 0.0, *args))

        system.initial_conditions = dict.fromkeys(system.states, 0.0)
        system.ode_solver = solver
        system.integrate()
        return found[0]

    assert len(x0) == len(derivative(lambda r, p: (r, p)))
    close(derivative(lambda r, p: (0 * r, p)), x0, 1e-12)
    assert abs(derivative(lambda r, p: (r + 1, p))).max() > 0.1
    with pytest.raises(ValueError, match=r"`p`, the constants, must have the shape"):
        derivative(lambda r, p: (r, p[:1]))
    with pytest.raises(ValueError, match=r"`r`, the specifieds, must have the shape"):
        derivative(lambda r, p: (np.ones(9), p))


@pytest.mark.parametrize("solver", ALL)
def test_a_solver_may_be_given_by_name_or_as_itself(solver):
    system = multi_mass_spring_damper()
    system.ode_solver = solver
    assert system.ode_solver is getattr(solvers, solver)
    system.ode_solver = getattr(solvers, solver)
    assert system.ode_solver.name == solver


def test_options_go_to_the_solver():
    system = pendulum(SPECIFIEDS["numbers"], "dop853")
    _, info = system.integrate(rtol=1e-3, atol=1e-3, max_step=0.01, full_output=True)
    assert info["steps"] in (139, 140, 141)
    with pytest.raises(
        TypeError, match=r"no option `t_eval`; .* results by `system.times = ...`.$"
    ):
        system.integrate(t_eval=[0.0, 1.0])
    with pytest.raises(
        TypeError, match=r"no option `ode_solver`; .* `system.ode_solver = 'RK45'`.$"
    ):
        system.integrate(ode_solver="RK45")
    with pytest.raises(TypeError, match="`dop853` has no option `mxstep`; its options are atol"):
        system.integrate(mxstep=3)


@pytest.mark.parametrize("way", [copy.copy, copy.deepcopy, lambda s: pickle.loads(pickle.dumps(s))])
def test_a_system_with_a_native_solver_can_be_copied(way):
    system = pendulum(SPECIFIEDS["samples"], "dop853")
    np.testing.assert_array_equal(way(system).integrate(), system.integrate())


def test_editing_in_place_between_integrations_counts():
    system = pendulum(SPECIFIEDS["numbers"], "dop853")
    system.specifieds = dict(SPECIFIEDS["numbers"])
    first = system.integrate()
    system.constants[sm.Symbol("g")] = 3.3
    system.specifieds[F] = SAMPLES
    other = pendulum({**SPECIFIEDS["numbers"], F: SAMPLES}, "dop853")
    other.constants[sm.Symbol("g")] = 3.3
    second = system.integrate()
    np.testing.assert_array_equal(second, other.integrate())
    assert np.abs(first - second).max() > 1e-3


@pytest.mark.parametrize("solver", ALL)
@pytest.mark.parametrize("name", ["free_pendulum", "free_body", "bare", "gyro"])
def test_what_is_conserved_is_conserved(name, solver):
    model = zoo.MODELS[name]()
    system = system_of(model, times=np.linspace(0.0, 2.0, num=9), ode_solver=solver)
    x = system.integrate(
        **{**options_of(solver), **({"step": 5e-4} if has_fixed_step(solver) else {})}
    )
    for quantity in (model.energy, *model.momenta):
        f = sm.lambdify(model.states, quantity.xreplace(model.constants))
        values = np.broadcast_to(f(*x.T), 9)
        close(values, np.full(9, values[0]), 1e-6)


def test_a_trajectory_knows_the_work_of_the_solver():
    trajectory = pendulum(SPECIFIEDS["samples"], "dop853").simulate(rtol=1e-9, atol=1e-9)
    close(trajectory.states, reference("samples"), 1e-6)
    assert trajectory.statistics["method"] == "dop853"
    assert trajectory.statistics["steps"] > 4
    assert trajectory.events == ()


# -- a stiff contact ------------------------------------------------------------------------------


def contact(solver, stiffness=1e6, end=1.0):
    """A ball of 1 kg falls on a stiff, damped ground."""
    z, v = me.dynamicsymbols("z v")
    m, g, k, c = sm.symbols("m g k c")
    frame, point = me.ReferenceFrame("N"), me.Point("P")
    point.set_vel(frame, v * frame.z)
    kane = me.KanesMethod(frame, [z], [v], kd_eqs=[z.diff(zoo.T) - v])
    push = sm.Piecewise((-k * z - c * v, z < 0), (0, True))
    kane.kanes_equations([me.Particle("P", point, m)], [(point, (push - m * g) * frame.z)])
    return System(
        kane,
        constants={m: 1.0, g: 9.81, k: stiffness, c: 0.02 * stiffness},
        initial_conditions={z: 0.01},
        times=[0.0, end],
        ode_solver=solver,
    )


def test_explicit_methods_crawl_through_a_stiff_contact_and_radau_does_not():
    def work(solver):
        x, info = contact(solver).integrate(rtol=1e-6, atol=1e-9, full_output=True)
        close(x[-1], [-9.81 / 1e6, 0.0], 1e-6)
        return info["evaluations"]

    implicit, explicit = work("radau"), work("tsit5")
    assert implicit < 2000
    assert explicit > 5 * implicit


# -- what goes wrong ------------------------------------------------------------------------------


@pytest.mark.parametrize("solver", ALL)
def test_failures_name_the_states(solver):
    system = contact(solver, end=10.0)
    options = {} if solver != "rk4" else {"step": 1e-5}
    with pytest.raises(IntegrationError, match=r"z\(t\) = .*, v\(t\) = ") as caught:
        system.integrate(max_steps=10, **options)
    assert "took 10 steps" in str(caught.value)
    np.testing.assert_array_equal(caught.value.times, [0.0])


def test_a_singular_mass_matrix_is_an_integration_error():
    system = pendulum({}, "dop853")
    system.constants = dict.fromkeys(system.constants, 0.0)
    with pytest.raises(IntegrationError, match=r"met a singular mass matrix at t = 0\.0 in the st"):
        system.integrate()
    system.ode_solver = odeint
    with pytest.raises(SingularMatrixError):
        system.integrate()


def test_progress_shows_what_is_prepared_before_the_motion(capsys):
    pytest.importorskip("tqdm")
    system = multi_mass_spring_damper(1)
    system.times, system.ode_solver = [0.0, 1.0], "dop853"
    quiet = system.integrate()
    assert capsys.readouterr() == ("", "")
    np.testing.assert_array_equal(system.integrate(progress=True), quiet)
    out, shown = capsys.readouterr()
    assert not out
    places = [shown.index(f"part={part}") for part in ("equations", "machine code")]
    assert places == sorted(places)
    assert places[-1] < shown.index("dop853: ")
