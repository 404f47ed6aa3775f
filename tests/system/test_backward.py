"""Descending and negative times: motions backward, against closed forms and motions forward."""

import pickle
from functools import cache

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.contact import Contacts, Unilateral
from pydy.errors import IntegrationError, PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.models import n_link_pendulum_on_cart
from pydy.solvers import Event
from pydy.system import System
from pydy.trajectory import Trajectory
from registry import SOLVER_NAMES
from zoo.cases import system_of

T = me.dynamicsymbols._t
SOLVERS = ["odeint", "solve_ivp", "DOP853", *SOLVER_NAMES]
NATIVE = ["dop853", "radau"]
TIMES = np.linspace(-1.0, 1.5, num=6)


@cache
def mass():
    """A damped mass on a spring with a force that depends on time, and another that is given."""
    x, v, force = me.dynamicsymbols("x v F")
    k, c = sm.symbols("k c")
    ground, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(ground, 0)
    point = origin.locatenew("P", x * ground.x)
    load = (point, (force - k * x - c * v + sm.sin(2 * T)) * ground.x)
    return Definition(ground, [x], [v], bodies=[me.Particle("p", point, 1)], loads=[load])


def system(solver="dop853", force=0.5, times=TIMES):
    made = System(mass(), constants={"k": 4.0, "c": 0.3}, specifieds={"F": force})
    made.initial_conditions = {"x": 1.0, "v": -0.2}
    made.ode_solver, made.times = solver, times
    return made


def options(solver):
    if solver == "rk4":
        return {"step": 1e-3}
    step = {"odeint": {"hmax": 0.05}, "dop853": {}, "radau": {}}
    return {"rtol": 1e-10, "atol": 1e-10, **step.get(solver, {"max_step": 0.05})}


def there_and_back(solver="dop853", force=0.5, times=TIMES, **more):
    """A motion forward, and one backward that begins where it ended."""
    made = system(solver, force, times)
    forward = made.simulate(**options(solver), **more)
    made.initial_conditions = dict(zip(made.states, forward.states[-1], strict=True))
    made.times = times[::-1]
    return forward, made.simulate(**options(solver), **more)


# -- negative times --------------------------------------------------------------------------------


@pytest.mark.parametrize("solver", SOLVERS)
def test_a_motion_from_negative_times_follows_its_closed_form(solver):
    made = system(solver, force=0.0)
    made.constants = {"k": 0.0, "c": 0.0}  # x'' = sin 2t
    made.initial_conditions = {"x": 0.0, "v": 0.0}
    x = made.integrate(**options(solver))[:, 0]
    expected = (np.sin(-2.0) - np.sin(2 * TIMES)) / 4 + np.cos(-2.0) / 2 * (TIMES + 1.0)
    np.testing.assert_allclose(x, expected, atol=1e-8)


# -- descending times ------------------------------------------------------------------------------


@pytest.mark.parametrize("solver", SOLVERS)
def test_growth_backward_follows_its_closed_form(solver):
    made = system(solver, force=0.0)
    made.constants = {"k": 0.0, "c": 0.0}
    made.initial_conditions, made.times = {"x": 0.0, "v": 0.0}, TIMES[::-1]
    x = made.integrate(**options(solver))[:, 0]
    expected = (np.sin(3.0) - np.sin(2 * TIMES[::-1])) / 4
    expected = expected + np.cos(3.0) / 2 * (TIMES[::-1] - 1.5)
    np.testing.assert_allclose(x, expected, atol=1e-8)


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("kind", ["linear", "previous", "pchip", "function"])
def test_a_motion_with_inputs_runs_back_to_where_it_began(solver, kind):
    def push(x, t):
        return np.cos(3 * t)

    samples = [-1.5, -0.5, 0.3, 1.0, 1.5], [0.0, 2.0, -1.0, 3.0, 0.5]
    force = push if kind == "function" else SampledInput(*samples, kind)
    forward, backward = there_and_back(solver, force)
    np.testing.assert_allclose(backward.states, forward.states[::-1], atol=3e-7)
    at = np.array([-0.9, -0.5, 0.31, 1.4])
    np.testing.assert_allclose(backward.at(at).states, forward.at(at).states, atol=3e-7)
    np.testing.assert_array_equal(backward.at(at[::-1]).states, backward.at(at).states[::-1])


@pytest.mark.parametrize("solver", ["dop853", "rk4"])
def test_jumps_of_samples_are_taken_from_the_other_side(solver):
    # x'' = F: at the jump, t = 0.5, the force of the samples before it acts
    made = system(solver, SampledInput([-1.0, 0.5, 1.5], [2.0, -6.0, 0.0], "previous"))
    made.constants = {"k": 0.0, "c": 0.0}
    made.times, made.initial_conditions = [0.5, -1.0], {"x": 0.0, "v": 0.0}
    x = made.integrate(**options(solver))[-1, 0]
    sine = (np.sin(1.0) - np.sin(-2.0)) / 4 + np.cos(1.0) / 2 * -1.5
    assert abs(x - (2.0 * 1.5**2 / 2 + sine)) < 1e-9


@pytest.mark.parametrize("solver", NATIVE)
def test_steps_and_evaluations_are_those_of_the_reflected_motion(solver):
    """A pendulum knows no direction of time: backward from rest it does what it does forward."""
    made = n_link_pendulum_on_cart(1, cart_force=False)
    made.ode_solver, made.initial_conditions = solver, {"q1": 1.0}
    found = []
    for times in ([0.0, 1.0, 2.0], [0.0, -1.0, -2.0]):
        made.times = times
        found.append(made.integrate(full_output=True))
    (one, told), (other, of_other) = found
    half = len(made.coordinates)
    np.testing.assert_array_equal(one[:, :half], other[:, :half])
    np.testing.assert_array_equal(one[:, half:], 0.0 - other[:, half:])
    for name in ("steps", "rejected", "evaluations", "jacobians", "last_step"):
        assert told[name] == of_other[name]
    assert (told["time"], of_other["time"]) == (2.0, -2.0)


@pytest.mark.parametrize("solver", ["dop853", "odeint"])
def test_times_that_turn_back_are_refused(solver):
    made = system(solver)
    for times, where in (([0, 2, 1], "1.0 after 2.0"), ([2, 0, 1], "1.0 after 0.0")):
        with pytest.raises(
            ValueError, match=f"`times` must be ascending or descending, got {where}"
        ):
            made.times = times


def test_equal_neighbours_give_equal_rows():
    made = system(times=[1.0, 0.5, 0.5, 0.0])
    for solver in ("dop853", "odeint", "solve_ivp"):
        made.ode_solver = solver
        x = made.integrate()
        np.testing.assert_array_equal(x[1], x[2])
        assert abs(x[2] - x[3]).min() > 0.0


@pytest.mark.parametrize("solver", NATIVE)
def test_generators_and_generated_functions_agree_backward(solver):
    made = system(solver)
    expected = made.integrate(**options(solver))
    made.times = TIMES[::-1]
    expected = made.integrate(**options(solver))
    made.generate_ode_function(generator="lambdify")
    np.testing.assert_allclose(made.integrate(**options(solver)), expected, atol=1e-9)
    made.generate_ode_function()
    f, native = made.evaluate_ode_function, made.ode_solver
    given = (np.array([0.5]), np.array([made.constants[s] for s in made.constants_symbols]))
    x0 = np.array([1.0, -0.2])
    np.testing.assert_array_equal(native(f, x0, TIMES[::-1], given, **options(solver)), expected)
    # the same function again, forward: nothing of the run before is left
    forward = native(f, x0, TIMES, given, **options(solver))
    made.times = TIMES
    np.testing.assert_array_equal(forward, made.integrate(**options(solver)))


@pytest.mark.parametrize("solver", NATIVE)
def test_projection_holds_a_linkage_backward(solver):
    made = system_of(zoo.fourbar(), times=np.linspace(0.0, 2.0, num=9), ode_solver=solver)
    given = {"rtol": 1e-9, "atol": 1e-9, "constraints": "project"}
    forward = made.simulate(**given)
    made.initial_conditions = dict(zip(made.states, forward.states[-1], strict=True))
    made.times = made.times[::-1]
    backward = made.simulate(**given)
    np.testing.assert_allclose(backward.states, forward.states[::-1], atol=1e-6)
    held = made.evaluate_constraints(backward.states, backward.times)
    assert np.abs(held).max() < 1e-12


@pytest.mark.parametrize("solver", ["dop853", "radau", "odeint", "solve_ivp"])
def test_sensitivities_backward_are_differences(solver):
    made = system(solver, SampledInput(TIMES, np.cos(TIMES)), TIMES[::-1])
    found = made.simulate(sensitivities=["k", "x", "F"], **options(solver)).sensitivity
    step = 3e-3
    by_k = []
    for k in (4.0 - step, 4.0 + step):
        made.constants = {"k": k, "c": 0.3}
        by_k.append(made.integrate(**options(solver)))
    differences = np.diff(by_k, axis=0)[0] / (2 * step)
    np.testing.assert_allclose(found.values[:, :, 0], differences, atol=2e-5)
    made.constants = {"k": 4.0, "c": 0.3}
    samples = np.cos(TIMES)
    samples[2] += 1.0  # linear in the samples
    plain = made.integrate(**options(solver))
    made.specifieds = {"F": SampledInput(TIMES, samples)}
    more = made.integrate(**options(solver)) - plain
    np.testing.assert_allclose(found["x", "F"][:, 2], more[:, 0], atol=2e-6)


# -- events ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("solver", NATIVE)
def test_crossings_are_found_in_the_direction_of_the_integration(solver):
    x, v = me.dynamicsymbols("x v")
    made = system(solver, force=0.0, times=[0.0, -4.0])
    made.constants = {"k": 0.0, "c": 0.0}
    # x'' = sin 2t from v = −1/2 at 0: v = −cos(2t)/2, x = −sin(2t)/4
    made.initial_conditions = {"x": 0.0, "v": -0.5}
    rising = [Event(v, direction=1, name="up"), Event(v, direction=-1, name="down")]
    events = made.simulate(events=rising, **options(solver)).events
    times = {name: [e.time for e in events if e.name == name] for name in ("up", "down")}
    np.testing.assert_allclose(times["up"], [-np.pi / 4, -5 * np.pi / 4], atol=1e-9)
    np.testing.assert_allclose(times["down"], [-3 * np.pi / 4], atol=1e-9)
    ended = made.simulate(
        events=Event(x + sm.Rational(1, 8), terminal=True), sensitivities=["v"], **options(solver)
    )
    assert len(ended.times) == 1
    (event,) = ended.events
    # −sin(2t)/4 = −1/8 going back
    assert abs(event.time - (-7 * np.pi / 12)) < 1e-9
    # x moves by t for each unit of v at the start, so the event by −t/v
    speed = -np.cos(2 * event.time) / 2
    assert abs(event.time_sensitivity[0] + event.time / speed) < 1e-7


def test_resets_cannot_be_undone():
    x, v = me.dynamicsymbols("x v")
    made = system(times=[1.0, 0.0])
    with pytest.raises(ValueError, match="`times` descend, but the event `bounce` has a reset"):
        made.integrate(events=Event(x, reset={v: -v / 2}, name="bounce"))


def test_an_error_backward_is_told_in_the_users_time():
    made = System(mass(), constants={"k": 4.0}, ode_solver="dop853")
    made.specifieds = {"F": lambda x, t: np.nan if t < -0.5 else 0.0}
    made.initial_conditions, made.times = {"x": 1.0}, [0.0, -0.25, -1.0]
    with pytest.raises(IntegrationError, match=r"at t = -0\.\d") as told:
        made.integrate()
    np.testing.assert_array_equal(told.value.times, [0.0, -0.25])
    assert -0.5 - 1e-6 < told.value.time <= -0.25


# -- what runs forward only ------------------------------------------------------------------------


def test_contacts_ensembles_adjoints_and_layers_say_that_they_run_forward():
    x = me.dynamicsymbols("x")
    made = system(times=[1.0, 0.0])
    for call in (
        lambda: Contacts(made, [Unilateral(x + 2, name="floor")]).simulate(),
        lambda: made.integrate_ensemble(constants={"k": [1.0, 2.0]}),
        lambda: made.integrate_ensemble(constants={"k": [1.0, 2.0]}, times=[3.0, 0.0]),
        lambda: made.adjoint_gradient(["k"], final=x),
    ):
        with pytest.raises(ValueError, match=r"`times` descend, from [13]\.0 to 0\.0, but "):
            call()


# -- results ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("solver", ["dop853", "odeint"])
def test_trajectories_with_descending_times_are_saved_pickled_and_interpolated(solver, tmp_path):
    force = SampledInput([-1.0, 0.2, 1.5], [1.0, -2.0, 0.0], "previous")
    forward, backward = there_and_back(solver, force, np.linspace(-1.0, 1.5, num=101))
    at = np.array([1.45, 0.21, 0.19, -0.95])
    expected = forward.at(at)
    for one in (backward, pickle.loads(pickle.dumps(backward))):
        np.testing.assert_allclose(one.at(at).states, expected.states, atol=1e-6)
        np.testing.assert_allclose(one.at(at)["F"], [-2.0, -2.0, 1.0, 1.0])
    backward.save(tmp_path / "run.nc")
    loaded = Trajectory.load(tmp_path / "run.nc")
    np.testing.assert_array_equal(loaded.times, backward.times)
    np.testing.assert_allclose(loaded.at(at).states, expected.states, atol=1e-6)
    np.testing.assert_array_equal(loaded.at(at).times, at)
    np.testing.assert_allclose(backward.energy, forward.energy[::-1], atol=1e-6)


def test_values_along_descending_times_are_those_of_each_row():
    _, backward = there_and_back()
    made = system(times=TIMES[::-1])
    rates = made.evaluate_ode(backward.states)
    each = [made.evaluate_ode(x, t) for x, t in zip(backward.states, TIMES[::-1], strict=True)]
    np.testing.assert_array_equal(rates, each)
    np.testing.assert_array_equal(backward.derivatives, rates)


def test_a_film_of_a_motion_backward_runs_forward():
    pytest.importorskip("matplotlib")
    forward, backward = there_and_back("odeint")
    scene, other = forward.animate(), backward.animate()
    np.testing.assert_array_equal(other.times, scene.times)
    ours, theirs = (np.asarray(s._motion.states) for s in (other, scene))
    np.testing.assert_allclose(ours, theirs, atol=1e-6)
    plain = system().scene().animate(TIMES[::-1], backward.states, series={"s": TIMES[::-1]})
    np.testing.assert_allclose(plain._motion.states, theirs, atol=1e-6)
    np.testing.assert_array_equal(plain._animation.series["s"], [plain.times, plain.times])
    assert len(backward.plot(["x"]).lines[0].get_xdata()) == len(TIMES)


def test_motions_are_judged_alike_in_both_directions():
    """A linkage without losses knows no direction of time, nor do bounds on its errors."""
    told = []
    for way in (1.0, -1.0):
        made = system_of(zoo.fourbar(), times=way * np.linspace(0.0, 30.0, 61), ode_solver="dop853")
        speeds = set(made.speeds)
        made.initial_conditions = {
            s: way * value if s in speeds else value for s, value in made.initial_conditions.items()
        }
        with pytest.raises(IntegrationError, match="`dop853`") as error:
            made.integrate(rtol=1e-2, atol=1e-2)
        told.append((error.value.info["code"], way * error.value.time))
    assert told[0] == told[1]


def test_a_jump_on_the_way_back_is_told():
    x, v = me.dynamicsymbols("x v")
    ground, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(ground, 0)
    point = origin.locatenew("P", x * ground.x)
    load = (point, -sm.sign(x + sm.Rational(1, 10)) * ground.x)
    slide = Definition(ground, [x], [v], bodies=[me.Particle("p", point, 1)], loads=[load])
    made = System(slide, ode_solver="dop853", times=[0.0, -1.0], initial_conditions={v: 0.3})
    with pytest.warns(PyDyUserWarning, match="jumps by"):
        made.simulate(sensitivities=["v"])
