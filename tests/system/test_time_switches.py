"""Loads that time alone switches: steps end where they do, and no pulse is passed over."""

import warnings

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.errors import PyDyUserWarning
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.solvers import dop853
from pydy.solvers.events import Event
from registry import ADAPTIVE, SOLVER_NAMES, step_options
from zoo.cases import close

t = me.dynamicsymbols._t
x, v, y, z, F = me.dynamicsymbols("x v y z F")
m, w = sm.symbols("m w", positive=True)
C, N = 0.99, 50.0
END = 10.0


def free_mass(load, solver="dop853", times=(0.0, END), **values):
    """A mass m on a line, under a load of time alone."""
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    place = origin.locatenew("P", x * frame.x)
    place.set_vel(frame, v * frame.x)
    kane = me.KanesMethod(frame, [x], [v], [x.diff(t) - v])
    kane.kanes_equations([me.Particle("P", place, m)], [(place, load * frame.x)])
    system = System(kane, times=np.array(times), **values)
    system.ode_solver = solver
    return system


PULSES = sm.Piecewise((N, sm.sin(w * t) > C), (0, True))


def pulses(frequency=7.0, end=END):
    """Return when the pulses begin and end, those up to a time."""
    turns = 2 * np.pi * np.arange(int(frequency * end / 6.0) + 2)
    begin, finish = (turns + a for a in (np.arcsin(C), np.pi - np.arcsin(C)))
    begin, finish = np.minimum(begin / frequency, end), np.minimum(finish / frequency, end)
    return begin, finish


def pushed(frequency=7.0, end=END, mass=1.0):
    """Return the position and speed after the pulses, from rest."""
    begin, finish = pulses(frequency, end)
    speed = N / mass * (finish - begin).sum()
    return np.array([N / mass / 2 * ((end - begin) ** 2 - (end - finish) ** 2).sum(), speed])


@pytest.mark.parametrize("solver", SOLVER_NAMES)
def test_no_pulse_is_passed_over(solver):
    system = free_mass(PULSES, solver, constants={m: 1.0, w: 7.0})
    states, info = system.integrate(full_output=True, **step_options(solver, 1e-9, 0.1))
    close(states[-1], pushed(), 1e-12)
    assert info["rejected"] == 0
    for frequency in (11.0, 3.0):  # other numbers, and another number of pulses
        system.constants[w] = frequency
        close(system.integrate(**step_options(solver, 1e-9, 0.1))[-1], pushed(frequency), 1e-12)


@pytest.mark.parametrize("solver", SOLVER_NAMES)
def test_a_step_that_begins_or_ends_at_a_switch_is_on_its_own_side(solver):
    system = free_mass(sm.Heaviside(t - 2), solver)
    for times in [(0, 5), (0, 2, 5), (2, 5), (0, 2), (5, 0), (5, 2, 0), (2, 0)]:
        system.times = np.array(times, dtype=float)
        found, info = system.integrate(full_output=True, **step_options(solver, 1e-9, 0.1))
        ramp = np.maximum(np.array(times) - 2.0, 0.0)
        close(found[:, 1], ramp - ramp[0], 1e-14)
        assert info["rejected"] == 0


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_a_square_wave_is_integrated_half_wave_by_half_wave(solver):
    system = free_mass(sm.sign(sm.sin(7 * t)), solver, [0.0, 20.0])
    found, info = system.integrate(full_output=True)
    half, rest = divmod(20.0, np.pi / 7)
    close(found[-1, 1], rest if half % 2 == 0 else np.pi / 7 - rest, 1e-12)
    assert info["rejected"] == 0


def test_the_larger_of_two_loads_is_seen_where_it_takes_over():
    """Between two waves the larger one is a number, which error control takes for all there is."""
    load = N * (sm.Max(sm.sin(7 * t), sm.Rational(99, 100)) - sm.Rational(99, 100))
    begin, finish = pulses()
    expected = N * ((np.cos(7 * begin) - np.cos(7 * finish)) / 7 - C * (finish - begin)).sum()
    found = free_mass(load).integrate(rtol=1e-10, atol=1e-12)
    assert found[-1, 1] == pytest.approx(expected, rel=1e-9)


def test_a_number_among_the_specifieds_is_known_and_samples_jump_too():
    load = sm.Piecewise((F, sm.sin(7 * t) > F / 100), (0, True))
    system = free_mass(load, specifieds={F: 99.0})
    begin, finish = pulses()
    close(system.integrate()[-1, 1], 99.0 * (finish - begin).sum(), 1e-12)
    steps = SampledInput([0.0, 2.0, 3.0, END], [1.0, 4.0, 0.0, 0.0], "previous")
    both = free_mass(F * sm.Heaviside(t - 2) + 10 * sm.Heaviside(t - 3), specifieds={F: steps})
    found, info = both.integrate(full_output=True)
    close(found[-1, 1], 4.0 + 70.0, 1e-14)
    assert info["rejected"] == 0


@pytest.mark.parametrize("solver", SOLVER_NAMES)
def test_dense_output_has_the_corners(solver):
    system = free_mass(PULSES, solver, constants={m: 2.0, w: 7.0})
    trajectory = system.simulate(**step_options(solver, 1e-9, 0.1))
    between = np.linspace(0.0, END, num=333)
    expected = np.array([pushed(end=moment, mass=2.0) for moment in between])
    close(trajectory.at(between).states, expected, 1e-11)


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_constraints_are_projected_on_at_the_ends_of_pulses(solver):
    """On the line y = 2 x a load along x moves a mass of 5 m."""
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    place.set_vel(frame, v * frame.x + z * frame.y)
    made = Definition(
        frame,
        [x, y],
        [v, z],
        bodies=[me.Particle("P", place, m)],
        loads=[(place, PULSES * frame.x)],
        holonomic_constraints=[y - 2 * x],
    )
    system = System(made, times=[0.0, END], constants={m: 1.0, w: 7.0})
    system.ode_solver = solver
    found = system.integrate(constraints="project", rtol=1e-10, atol=1e-10)[-1]
    position, speed = pushed(mass=5.0)
    close(found, [position, 2 * position, speed, 2 * speed], 1e-9)


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_events_and_resets_happen_beside_pulses(solver):
    """The mass is stopped whenever 2.3 pulses have pushed it."""
    system = free_mass(PULSES, solver, constants={m: 1.0, w: 7.0})
    begin, finish = pulses()
    gain = N * (finish - begin)[0]
    events = [Event(v - 2.3 * gain, reset={v: 0})]
    found, info = system.integrate(events=events, full_output=True, rtol=1e-10, atol=1e-10)
    count = np.array([2.3, 4.6, 6.9, 9.2])  # of 11 pulses
    whole = count.astype(int)
    moments = begin[whole] + (count - whole) * gain / N
    close([record.time for record in info["events"]], moments, 1e-9)
    close(found[-1, 1], 1.8 * gain, 1e-9)


@pytest.mark.parametrize("solver", ADAPTIVE)
def test_an_event_may_happen_by_a_switch(solver):
    system = free_mass(sm.Heaviside(t - 2), solver, [0.0, 5.0])
    jump = Event(sm.Heaviside(t - 2) - sm.Rational(1, 3))
    _, info = system.integrate(events=[jump], full_output=True)
    close([record.time for record in info["events"]], [2.0], 1e-15)


def test_sensitivities_and_adjoint_gradients_pass_pulses():
    system = free_mass(PULSES, constants={m: 2.0, w: 7.0})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = system.simulate(sensitivities=[m], rtol=1e-11, atol=1e-11)
        by_mass = -pushed(mass=2.0) / 2.0
        close([found.sensitivity[state, m][-1] for state in (x, v)], by_mass, 1e-9)
        found = system.adjoint_gradient([m], final=x, rtol=1e-11, atol=1e-11)
    close(found.value, pushed(mass=2.0)[0], 1e-11)
    close(found.values, by_mass[:1], 1e-9)
    close(found.by_state, [1.0, END], 1e-9)


def test_samples_of_an_ensemble_switch_at_the_same_times_or_at_their_own():
    system = free_mass(PULSES, constants={m: 1.0, w: 7.0})
    masses = np.linspace(0.5, 3.0, num=19)
    found = system.integrate_ensemble(constants={m: masses})
    for k in (0, 7, 18):
        system.constants[m] = masses[k]
        np.testing.assert_array_equal(found["x"][k], system.integrate()[:, 0])
    system.constants[m] = 1.0
    frequencies = np.linspace(2.0, 9.0, num=11)
    own = system.integrate_ensemble(constants={w: frequencies})
    close(own["x"][:, -1], [pushed(frequency)[0] for frequency in frequencies], 1e-12)


def test_a_right_hand_side_without_a_system_has_its_pulses_too():
    system = free_mass(PULSES)
    rhs = system.generate_ode_function()
    found = dop853(rhs, [0.0, 0.0], [0.0, END], args=(dict(zip((m, w), (1.0, 7.0), strict=True)),))
    close(found[-1], pushed(), 1e-12)


def test_more_switches_than_steps_can_end_at_are_told_of_unless_steps_are_short():
    rhs = free_mass(PULSES).generate_ode_function()
    call = [0.0, 0.0], [0.0, 100.0], (dict(zip((m, w), (1.0, 1e6), strict=True)),)
    with pytest.warns(PyDyUserWarning, match="switches by time alone .* from t = 0 to 100: too"):
        dop853.prepare(rhs, *call)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        dop853.prepare(rhs, *call, max_step=1e-7)


def bead(load, constraints):
    """A bead of 2 kg on a rod that turns at a rate w, under a load along the rod."""
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    place = origin.locatenew("P", x * frame.x + y * frame.y)
    place.set_vel(frame, v * frame.x + z * frame.y)
    along = sm.cos(w * t) * frame.x + sm.sin(w * t) * frame.y
    definition = Definition(
        frame, [x, y], [v, z], bodies=[me.Particle("bead", place, 2)],
        loads=[(place, load * along)], kinematic_equations=[x.diff(t) - v, y.diff(t) - z],
        holonomic_constraints=constraints,
    )  # fmt: skip
    start = {x: 1.0, y: 0.0, v: 0.0, z: 1.5}
    return System(definition, {w: 1.5}, initial_conditions=start, times=np.array([0.0, 2.0]))


ROD = y * sm.cos(w * t) - x * sm.sin(w * t)
HELD = [{}, {"constraints": "project"}, {"constraints": "baumgarte", "gain": 5.0}]


@pytest.mark.parametrize("held", HELD, ids=["free", "projected", "stabilised"])
@pytest.mark.parametrize("rows", [[ROD], [ROD, 2 * ROD]], ids=["one row", "a redundant row"])
@pytest.mark.parametrize("force", [0, 5000])
def test_a_constraint_that_moves_with_time_switches_nothing(held, rows, force):
    """The radius follows r'' = w² r + F/m, in which only the pulses F switch."""
    load = force * sm.Piecewise((1, sm.sin(7 * t) > C), (0, True))
    system = bead(load, rows)
    system.ode_solver = dop853
    moved = system.simulate(rtol=1e-9, atol=1e-9, **held)
    (begin, finish), rate = pulses(end=2.0), 1.5
    pushes = np.cosh(rate * (2.0 - begin)) - np.cosh(rate * (2.0 - finish))
    radius = np.cosh(2.0 * rate) + force / (2 * rate**2) * pushes.sum()
    expected = radius * np.array([np.cos(2.0 * rate), np.sin(2.0 * rate)])
    np.testing.assert_allclose([moved["x"][-1], moved["y"][-1]], expected, rtol=1e-7)


def test_a_model_without_such_a_load_knows_at_once():
    for load in (sm.sin(7 * t), sm.Abs(v), sm.sign(v) * t):
        system = free_mass(-load)
        kernel = system._now().model.code.compiled("rates")
        assert kernel.time_switches(frozenset()) is None


OF_SCIPY = {
    "odeint": (0.001, {"hmax": 4e-4, "mxstep": 10**5}),
    "DOP853": (0.05, {"max_step": 0.02}),
}


@pytest.mark.parametrize("solver", OF_SCIPY)
def test_a_solver_of_scipy_that_passes_over_a_pulse_is_told_of(solver):
    width, limit = OF_SCIPY[solver]
    system = free_mass(sm.Piecewise((N, sm.And(t > 5, t < 5 + width)), (0, True)), solver)
    with pytest.warns(PyDyUserWarning, match="the loads that time alone switches there"):
        system.integrate()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = system.integrate(**limit)
    assert found[-1, 1] == pytest.approx(N * width, rel=1e-2)
