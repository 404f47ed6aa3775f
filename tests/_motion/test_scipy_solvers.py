"""SciPy's solvers behind System, by function, class or name."""

import copy
import pickle

import numpy as np
import pytest
from scipy.integrate import RK45, Radau, odeint, solve_ivp
from scipy.sparse import csr_array

from pydy._errors import IntegrationError
from pydy._motion import is_implicit
from pydy.models import multi_mass_spring_damper
from pydy.solvers import Event, dop853
from zoo.cases import close

TIMES = [0.0, 0.0, 0.5, 1.0, 1.0, 2.0]
TIGHT = {"rtol": 1e-10, "atol": 1e-10}


@pytest.fixture
def system():
    system = multi_mass_spring_damper(apply_external_forces=True)
    system.initial_conditions = {"x0": 1.0}
    system.specifieds = {"f0": 0.5}
    system.times = TIMES
    return system


SOLVERS = [solve_ivp, RK45, Radau, "solve_ivp", "RK45", "RK23", "DOP853", "Radau", "BDF", "LSODA"]


def test_radau_and_bdf_are_implicit(system):
    implicit = []
    for solver in [*SOLVERS, odeint, dop853]:
        system.ode_solver = solver
        if is_implicit(system.ode_solver):
            implicit.append(solver)
    assert implicit == [Radau, "Radau", "BDF"]


@pytest.mark.parametrize("solver", SOLVERS, ids=lambda s: getattr(s, "__name__", f"named {s}"))
def test_solve_ivp_gives_odeints_trajectory_in_its_shape(system, solver):
    expected = system.integrate(**TIGHT)
    system.ode_solver = solver
    x = system.integrate(**TIGHT)
    assert x.shape == (6, 2)
    close(x, expected, 1e-6)


@pytest.mark.parametrize("name", ["odeint", "lsoda"])
def test_odeint_goes_by_its_methods_name_too(system, name):
    system.ode_solver = dop853
    system.ode_solver = name
    assert system.ode_solver is odeint


def test_an_option_names_another_method(system):
    system.ode_solver = solve_ivp
    x, info = system.integrate(method="Radau", full_output=True, **TIGHT)
    assert info["method"] == "Radau"
    assert info["nlu"] > 0
    close(x, system.integrate(method="DOP853", **TIGHT), 1e-6)


def test_a_simulation_takes_the_dense_output_and_the_counts(system):
    system.ode_solver = "DOP853"
    trajectory = system.simulate(dense_output=True, **TIGHT)
    assert trajectory.statistics["nfev"] > 0
    between = trajectory.at([0.25])
    system.times = [0.0, 0.25]
    close(between.states, system.integrate(**TIGHT)[1:], 1e-6)


def test_an_interval_of_no_length_is_the_initial_state(system):
    system.ode_solver, system.times = "RK45", [1.0, 1.0]
    np.testing.assert_array_equal(system.integrate(), [[1.0, 0.0], [1.0, 0.0]])


def test_where_it_fails_the_error_holds_what_was_computed(system):
    system.ode_solver = "RK45"
    system.specifieds = {"f0": lambda x, t: 1.0 / (1.0 - t) ** 2 if t < 1.0 else np.nan}
    with pytest.raises(IntegrationError, match=r"`solve_ivp` could not go on after t = 0.5") as e:
        system.integrate()
    np.testing.assert_array_equal(e.value.times, [0.0, 0.5])
    assert e.value.states.shape == (2, 2)


@pytest.mark.parametrize("solver", ["RK45", "RK23", "DOP853", "Radau", "BDF", "LSODA"])
@pytest.mark.parametrize("until", [-1.0, 0.0])
@pytest.mark.filterwarnings("ignore::RuntimeWarning:scipy")
def test_derivatives_that_are_no_numbers_from_the_start_on_are_told(system, solver, until):
    system.ode_solver = solver
    system.specifieds = {"f0": lambda x, t: np.nan if t > until else 0.0}
    with pytest.raises(IntegrationError, match=r"`solve_ivp` (met derivatives|could not)") as e:
        system.integrate()
    assert len(e.value.states) == 1
    if until < 0.0:
        assert "not finite at t = 0.0. The specified `f0(t)` is nan there" in str(e.value)


@pytest.mark.parametrize("error", [ValueError, IndexError, FloatingPointError])
def test_what_a_function_raises_after_it_was_undefined_arrives(system, error):
    calls = []

    def push(x, t):
        calls.append(t)
        if len(calls) > 10:
            raise error("mine")
        return np.nan if len(calls) > 5 else 0.0

    system.ode_solver, system.specifieds = "RK45", {"f0": push}
    with pytest.raises(error, match="mine"):
        system.integrate()


def test_where_it_fails_at_once_the_error_holds_the_start(system):
    system.ode_solver, system.times = "RK45", [1e16, 1e16 + 2, 1e16 + 4]  # neighbours
    with pytest.raises(
        IntegrationError, match=r"`solve_ivp` could not go on after t = 1e\+16"
    ) as e:
        system.integrate(**TIGHT)
    np.testing.assert_array_equal(e.value.states, [[1.0, 0.0]])


@pytest.mark.parametrize(
    ("solver", "option", "meant"),
    [
        ("odeint", "rtoll", "rtol"),
        ("odeint", "maxstep", "mxstep"),
        ("RK45", "max_stepp", "max_step"),
        ("Radau", "jacob", "jac"),
        ("dop853", "firststep", "first_step"),
    ],
)
def test_an_unknown_option_names_the_nearest(system, solver, option, meant):
    system.ode_solver = solver
    with pytest.raises(TypeError, match=f"has no option `{option}`.* Did you mean `({meant})`"):
        system.integrate(**{option: 1e-3})


@pytest.mark.parametrize("solver", ["odeint", "dop853"])
@pytest.mark.parametrize("option", ["method", "solver"])
def test_a_solver_is_no_option(system, solver, option):
    system.ode_solver = solver
    with pytest.raises(TypeError, match=f"no option `{option}`.* `system.ode_solver = 'RK45'`"):
        system.integrate(**{option: "RK45"})
    with pytest.raises(TypeError, match=f"no option `{option}`.* `system.ode_solver = 'RK45'`"):
        system.simulate(**{option: "RK45"})


@pytest.mark.parametrize(
    ("solver", "option", "meant"),
    [
        ("odeint", "max_steps", "mxstep"),
        ("odeint", "jac", "Dfun"),
        ("RK45", "hmax", "max_step"),
        ("dop853", "mxstep", "max_steps"),
    ],
)
def test_the_option_of_another_solver_is_translated(system, solver, option, meant):
    system.ode_solver = solver
    with pytest.raises(TypeError, match=rf"has no option `{option}`.* It is called `{meant}` ther"):
        system.integrate(**{option: 1e-3})


@pytest.mark.parametrize(
    ("solver", "option", "value", "told"),
    [
        ("odeint", "hmax", -1.0, r"`hmax` must be zero or positive, got -1\.0"),
        ("odeint", "hmax", np.nan, r"`hmax` must be zero or positive, got nan"),
        ("odeint", "h0", -1.0, r"`h0` must be zero or positive, got -1\.0"),
        ("odeint", "hmin", np.inf, r"`hmin` must be finite, got inf"),
        ("odeint", "rtol", np.nan, r"`rtol` must be finite and not negative, got nan"),
        ("odeint", "Dfun", "x", r"`Dfun` must be a function Dfun\(x, t\), or None .*, got 'x'"),
        ("odeint", "ixpr", "x", r"`ixpr` must be True or False, got 'x'"),
        ("BDF", "jac", "x", r"`jac` must be a function jac\(t, x\), a matrix .*, got 'x'"),
        ("Radau", "jac", 3, r"`jac` must be a function .*, a matrix of shape \(n, n\).*, got 3"),
        ("BDF", "max_step", np.nan, r"`max_step` must be positive, got nan"),
        ("LSODA", "first_step", np.nan, r"`first_step` must be positive, got nan"),
        ("LSODA", "min_step", -1.0, r"`min_step` must be zero or positive, got -1\.0"),
    ],
)
def test_a_value_that_a_solver_cannot_take_is_named_with_what_it_can(
    system, solver, option, value, told
):
    system.ode_solver = solver
    with pytest.raises((ValueError, TypeError), match=told):
        system.integrate(**{option: value})


def test_values_that_stand_for_the_solvers_own_choice_stay(system):
    expected = system.integrate(**TIGHT)
    assert np.array_equal(system.integrate(**TIGHT, hmax=0.0, h0=0, hmin=0.0, Dfun=None), expected)
    system.ode_solver = "BDF"
    jacobian = system.evaluate_jacobian([1.0, 0.0], t=0.0)
    for jac in (None, lambda t, x: jacobian, jacobian, csr_array(jacobian)):
        close(system.integrate(**TIGHT, jac=jac, max_step=np.inf, first_step=None), expected, 1e-6)


def test_an_unknown_solver_names_the_nearest(system):
    with pytest.raises(ValueError, match=r"one of 'odeint'.* got 'RK54'. Did you mean `RK45`"):
        system.ode_solver = "RK54"
    with pytest.raises(ValueError, match=r"got 'RK4'. Did you mean `rk4`"):
        system.ode_solver = "RK4"
    with pytest.raises(ValueError, match=r"or a function, got 'ode45'. Use 'tsit5'.$"):
        system.ode_solver = "ode45"
    with pytest.raises(ValueError, match=r"or a function, got 'ODE15S'. Use 'BDF'.$"):
        system.ode_solver = "ODE15S"
    with pytest.raises(ValueError, match=r"or a function, got 'scipy'.$"):
        system.ode_solver = "scipy"
    with pytest.raises(ValueError, match=r"`ode_solver` must be a function .*, got 5"):
        system.ode_solver = 5


def test_a_system_with_it_is_copied_pickled_and_printed(system):
    system.ode_solver = solve_ivp
    expected = system.integrate(**TIGHT)
    for other in (copy.deepcopy(system), pickle.loads(pickle.dumps(system))):
        np.testing.assert_array_equal(other.integrate(**TIGHT), expected)
    assert "solve_ivp, method RK45" in repr(system)
    assert repr(system.ode_solver) == "scipy.integrate.solve_ivp with method='RK45'"


@pytest.mark.parametrize("outer", ["odeint", "LSODA"])
@pytest.mark.parametrize("inner", ["odeint", "LSODA"])
def test_lsoda_is_not_started_by_what_it_calls(system, inner, outer):
    # SciPy keeps its state in one place: the run outside went on with that of the run inside.
    preview = copy.deepcopy(system)
    preview.ode_solver = inner
    system.ode_solver = outer
    system.specifieds = {"f0": lambda x, t: 0.5 - 0.0 * preview.integrate()[-1, 0]}
    with pytest.raises(RuntimeError, match=f"`{inner}` cannot be started by a function that"):
        system.integrate()
    preview.ode_solver = "dop853"
    close(system.integrate(**TIGHT), preview.integrate(**TIGHT), 1e-6)


# -- events of the solver's own --------------------------------------------------------------------


def free_fall(t_end=1.0):
    """x'' = −9.81 from 2 m at rest: at the ground after √(4 / 9.81) s."""
    system = multi_mass_spring_damper(apply_external_forces=True)
    system.constants = {"k0": 0.0, "c0": 0.0}
    system.specifieds, system.initial_conditions = {"f0": -9.81}, {"x0": 2.0}
    system.times, system.ode_solver = np.linspace(0.0, t_end, num=11), solve_ivp
    return system


LANDED = np.sqrt(4.0 / 9.81)


def ground(t, x):
    return x[0]


ground.terminal, ground.direction = True, -1


def ground_of_args(t, x, r, p):
    assert (r[0], len(p)) == (-9.81, 3)
    return x[0]


ground_of_args.terminal = True


def ground_of_any(t, x, *args):
    assert len(args) == 2
    return x[0]


ground_of_any.terminal = True


@pytest.mark.parametrize("event", [ground, [ground], ground_of_args, ground_of_any])
def test_a_terminal_event_of_solve_ivp_leaves_the_rows_before(event):
    system = free_fall()
    x = system.integrate(events=event, **TIGHT)
    np.testing.assert_allclose(x[:, 0], 2.0 - 9.81 / 2 * system.times[:7] ** 2, atol=1e-9)
    x, info = system.integrate(events=event, full_output=True, dense_output=True, **TIGHT)
    assert (len(x), len(info["times"])) == (7, 7)
    assert abs(info["t_events"][0][0] - LANDED) < 1e-9
    run = system.simulate(events=event, **TIGHT)
    assert run.times[-1] == system.times[6]
    assert [e.name for e in run.events] == [getattr(event, "__name__", "ground")]
    assert abs(run.events[0].time - LANDED) < 1e-9


def test_events_that_go_on_are_listed_in_their_order():
    def fast(t, x):
        return x[1] + 7.0

    def low(t, x):
        return x[0] - 1.0

    system = free_fall()
    run = system.simulate(events=[fast, low], **TIGHT)
    assert [e.name for e in run.events] == ["low", "fast"]
    np.testing.assert_allclose(
        [e.time for e in run.events], [np.sqrt(2 / 9.81), 7 / 9.81], atol=1e-9
    )
    assert len(run.times) == 11
    found = system.simulate(events=[fast, low, ground], sensitivities=["v0"], **TIGHT)
    assert [e.before.shape for e in found.events] == [(2,)] * 2
    np.testing.assert_allclose(found.sensitivity["x0", "v0"], system.times[:7], atol=1e-8)


def test_other_times_can_be_asked_of_solve_ivp():
    system = free_fall()
    x = system.integrate(t_eval=[0.0, 0.5], **TIGHT)
    np.testing.assert_allclose(x[:, 0], [2.0, 2.0 - 9.81 / 8], atol=1e-9)
    np.testing.assert_array_equal(system.simulate(t_eval=[0.1, 0.5], **TIGHT).times, [0.1, 0.5])
    system.times = [1.0, 0.0]
    assert system.integrate(t_eval=[0.5, 0.2], **TIGHT).shape == (2, 2)
    with pytest.raises(ValueError, match="`t_eval` must hold times within those of the System"):
        system.integrate(t_eval=[0.5, 2.0])


def test_times_against_the_motion_are_those_that_a_terminal_event_leaves():
    system = free_fall()
    system.times = [0.0, 1.0]
    x, info = system.integrate(t_eval=[0.9, 0.2], events=ground, full_output=True, **TIGHT)
    np.testing.assert_array_equal(info["times"], [0.2])
    np.testing.assert_allclose(x[:, 0], [2.0 - 9.81 / 2 * 0.2**2], atol=1e-9)


def test_events_of_a_motion_backwards_come_in_its_order():
    def high(t, x):
        return x[0] + 1.0

    system = free_fall()
    system.times, system.initial_conditions = [0.0, -1.0], {"x0": 2.0}  # it came from below
    run = system.simulate(events=[ground, high], t_eval=[0.0], **TIGHT)
    assert [e.name for e in run.events] == ["ground"]
    ground_goes_on = lambda t, x: x[0]  # noqa: E731
    run = system.simulate(events=[high, ground_goes_on], t_eval=[0.0], **TIGHT)
    assert [round(e.time, 3) for e in run.events] == [-0.639, -0.782]


@pytest.mark.parametrize("name", ["RK45", "Radau", "BDF", "LSODA"])
def test_accepted_steps_are_counted_for_every_method(name, system):
    system.ode_solver = name
    _, info = system.integrate(dense_output=True, full_output=True, **TIGHT)
    assert info["steps"] == len(info["dense_output"].starts) - 1


def test_equal_times_keep_the_times_asked_for():
    system = free_fall()
    system.times = [1.0, 1.0]
    assert system.simulate(t_eval=[1.0, 1.0, 1.0]).times.tolist() == [1.0] * 3


def test_an_event_before_the_first_output_leaves_no_row():
    system = free_fall()
    found, info = system.integrate(t_eval=[0.9, 1.0], events=ground, full_output=True, **TIGHT)
    assert found.shape == (0, 2)
    assert len(info["times"]) == 0


def test_what_is_no_event_of_solve_ivp_is_refused():
    system = free_fall()
    for events, error, match in (
        ([3.0], TypeError, r"`events` of solve_ivp must be functions f\(t, x\)"),
        (3.0, TypeError, r"`events` must be a sequence of functions f\(t, x\)"),
        ([Event(system.states[0])], ValueError, "`events` needs a native solver"),
    ):
        with pytest.raises(error, match=match):
            system.integrate(events=events)
    with pytest.raises(TypeError, match="`args` are the specifieds and constants"):
        system.integrate(args=())


def test_a_solver_of_the_users_gets_all_keywords_and_its_rows_come_back():
    seen = {}

    def own(f, x0, t, args=(), **options):
        seen.update(options)
        found = solve_ivp(
            lambda t, x: f(x, t, *args), (t[0], t[-1]), x0, t_eval=t, events=options["events"]
        )
        return (found.y.T, {"times": found.t}) if options.get("told") else found.y.T

    system = free_fall()
    system.ode_solver = own
    assert system.integrate(events=ground, told=False, kind=[1]).shape == (7, 2)
    assert seen == {"events": ground, "told": False, "kind": [1]}
    assert system.simulate(events=ground, told=True).times[-1] == system.times[6]
    with pytest.raises(ValueError, match=r"got \(7, 2\)\. One that ends early tells the times"):
        system.simulate(events=ground)
