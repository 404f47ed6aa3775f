"""Motions that left their constraints, or changed their energy without a cause, are errors."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import ODEintWarning

from pydy import System
from pydy._judges.constraint_drift import check_drift
from pydy._motion.motion import Integrator, Motion
from pydy.ensemble.model import Batch
from pydy.errors import IntegrationError
from pydy.inputs import SampledInput
from pydy.mechanics import Definition
from pydy.solvers import Event
from pydy.solvers.constraint_drift import DriftCheck
from pydy.solvers.outcome import Outcome
from registry import ADAPTIVE_NAMES
from zoo import inertial_frame, loops
from zoo.singular import bricard, n_four_bar, slider_crank

ADAPTIVE = ADAPTIVE_NAMES


def loop(name, end=3.0, solver="dop853", **shape):
    return loops.system_of(name, np.linspace(0.0, end, 61), solver, **shape)


def refused(system, code, **options):
    with pytest.raises(IntegrationError) as caught:
        system.integrate(**options)
    error = caught.value
    assert error.info["code"] == code
    assert error.states.shape == (len(system.times), len(system.states))
    assert np.isfinite(error.states).all()
    assert error.time in system.times
    return error


def motion_of(system, states, options, info, projected):
    """A Motion as if the System's solver had returned these states."""
    return Motion(
        problem=system._now(), integrator=Integrator(system.ode_solver, projected),
        options=options, times=system.times, states=states, segments=(), statistics=info,
    )  # fmt: skip


def checked(system):
    """The states of a sound motion by projection, and what checks them when they have changed."""
    options = {"rtol": 1e-8, "atol": 1e-8}
    x, info = system.integrate(constraints="project", full_output=True, **options)
    assert info["nearness"] < 0.05
    motion = motion_of(system, x, options, info, projected=True)

    def check(message=None, code=None):
        if message is None:
            return check_drift(motion)
        with pytest.raises(IntegrationError, match=message) as caught:
            check_drift(motion)
        assert caught.value.info["code"] == code
        assert caught.value.time == system.times[40]

    return x, check


@pytest.mark.parametrize(
    ("name", "solver", "tolerance"),
    [
        ("three_cranks", "dop853", 1e-10),
        ("spatial_four_bar", "dop853", 1e-8),
        ("peaucellier", "vern9", 1e-8),
        ("kite", "dop853", 1e-9),
    ],
)
def test_a_mechanism_that_leaves_its_constraints_is_refused(name, solver, tolerance):
    system = loop(name, solver=solver)
    error = refused(system, Outcome.LEFT_CONSTRAINTS, rtol=tolerance, atol=tolerance)
    assert f"`{solver}` left the constraints, with a residual of " in str(error)
    assert "constraints='project'" in str(error)
    system.integrate(constraints="project", rtol=tolerance, atol=tolerance)


@pytest.mark.parametrize("many", [False, True])
def test_constraints_on_inputs_are_looked_at(many):
    x, y, r = me.dynamicsymbols("x y r")
    frame, place = me.ReferenceFrame("N"), me.Point("P")
    origin = me.Point("O")
    origin.set_vel(frame, 0)
    place.set_pos(origin, x * frame.x + y * frame.y)
    definition = Definition(
        frame, [x, y], bodies=[me.Particle("bob", place, 1)], loads=[(place, -9 * frame.y)],
        holonomic_constraints=[x**2 + y**2 - r**2],
    )  # fmt: skip
    system = System(definition, times=np.linspace(0.0, 3.0, 31), ode_solver="dop853")
    system.initial_conditions = {x: 1.0}
    rates = [
        lambda x, t: 1.0 + 0.1 * (1.0 - np.cos(t)),
        lambda x, t: 0.1 * np.sin(t),
        lambda x, t: 0.1 * np.cos(t),
    ]
    symbols = [r, r.diff(), r.diff().diff()]

    def run(specifieds):
        system.specifieds = specifieds
        if many:
            return system.integrate_ensemble(initial_conditions={y: np.zeros(3)}).status.values
        return system.integrate()

    run({r: 1.0})
    run(dict(zip(symbols, rates, strict=True)))
    times = np.linspace(0.0, 3.0, 31)  # each is interpolated for itself: the rows hold to that
    samples = [SampledInput(times, rate(None, times)) for rate in rates]
    run(dict(zip(symbols, samples, strict=True)))
    wrong = {**dict(zip(symbols, rates, strict=True)), symbols[2]: rates[1]}
    if many:
        assert (run(wrong) == Outcome.LEFT_CONSTRAINTS).all()
    else:
        with pytest.raises(IntegrationError, match="left the constraints"):
            run(wrong)


def test_no_gradient_is_given_of_a_mechanism_that_left_them():
    system = loop("kite")
    with pytest.raises(IntegrationError, match="`dop853` left the constraints"):
        system.adjoint_gradient("constants", final=system.states[0], rtol=1e-9, atol=1e-9)


def test_a_stabilised_mechanism_that_leaves_them_is_refused_too():
    options = {"constraints": "baumgarte", "gain": 10.0, "rtol": 1e-10, "atol": 1e-10}
    refused(loop("three_cranks"), Outcome.LEFT_CONSTRAINTS, **options)


@pytest.mark.parametrize("full_output", [False, True])
@pytest.mark.parametrize("solver", ["odeint", "RK45", "DOP853", "Radau", "BDF", "LSODA"])
def test_scipys_solvers_are_looked_at(solver, full_output):
    system = loop("three_cranks", solver=solver)
    error = refused(system, Outcome.LEFT_CONSTRAINTS, rtol=1e-6, atol=1e-6, full_output=full_output)
    assert f"`{solver}` left the constraints" in str(error)


def test_what_odeint_returns_where_it_gives_up_is_not_looked_at():
    system = loop("three_cranks", solver="odeint")
    with pytest.warns(ODEintWarning):
        _, info = system.integrate(full_output=True, mxstep=2, rtol=1e-6, atol=1e-6)
    assert "Excess work" in info["message"]


def test_a_users_solver_is_looked_at():
    def midpoint(f, x0, t, args):
        states, x = [x0], np.array(x0)
        for k, step in enumerate(np.diff(t)):
            for _ in range(100):
                x = x + step / 100 * f(x + step / 200 * f(x, t[k], *args), t[k], *args)
            states.append(x)
        return np.array(states)

    error = refused(loop("three_cranks", solver=midpoint), Outcome.LEFT_CONSTRAINTS)
    assert "`midpoint` left the constraints" in str(error)
    loop("sarrus", end=0.2, solver=midpoint).integrate()


@pytest.mark.parametrize("returned", ["states", 5, (1, 2), [[1.0]], np.zeros((61, 1))])
def test_whatever_else_a_users_solver_returns_is_returned(returned):
    system = loop("kite", solver=lambda f, x0, t, args: returned)
    assert system.integrate() is returned


@pytest.mark.parametrize(
    ("name", "solver", "tolerance"),
    [("even_slider_crank", "dop853", 1e-6), ("kite", "vern9", 1e-6), ("kite", "tsit5", 1e-6)],
)
def test_one_passage_of_a_singular_position_explains_no_work_all_the_time(name, solver, tolerance):
    # There alone the forces are large that do work beside the constraints.
    system = loop(name, solver=solver)
    refused(system, Outcome.ENERGY_CHANGED, rtol=tolerance, atol=tolerance)


def test_energies_are_looked_at_where_constraints_nearly_lost_rank():
    system = bricard((0, 1, 3, 4)).system
    system.ode_solver, system.times = "tsit5", np.linspace(0.0, 5.0, 61)
    error = refused(system, Outcome.ENERGY_CHANGED, rtol=1e-10, atol=1e-10)
    assert np.abs(system.evaluate_constraints(error.states, system.times)).max() < 1e-5


@pytest.mark.parametrize("size", [1e-9, 1.0, 1e9])
def test_how_near_rows_are_to_losing_rank_has_no_unit(size):
    angles = np.linspace(1.0, 2.0, 7)
    rows = np.array([[[size, 0.0], [np.cos(a), np.sin(a)]] for a in angles])

    def near(rows):
        return DriftCheck.nearly_loses_rank((rows @ rows.swapaxes(1, 2)).reshape(len(rows), -1))

    assert not near(rows)
    rows[3, 1] = np.cos(0.03), np.sin(0.03)
    assert near(rows)
    rows[3] = 0.0
    assert near(rows)
    assert not near(np.zeros((7, 0, 2)))


def test_what_projection_takes_away_is_refused():
    system = loop("three_cranks")
    states, check = checked(system)
    check()
    states[40:, 4:] *= 0.999  # the constraints hold
    check("changed the total energy by .* without a cause", Outcome.ENERGY_CHANGED)


# -- sound motions --------------------------------------------------------------------------------


@pytest.mark.parametrize("solver", ADAPTIVE)
@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-11])
def test_a_crank_that_turns_is_sound_without_projection(solver, tolerance):
    system = slider_crank(2.0).system
    system.ode_solver, system.times = solver, np.linspace(0.0, 10.0, 101)
    system.integrate(rtol=tolerance, atol=tolerance)


@pytest.mark.parametrize("length", [1e-6, 1.0])
@pytest.mark.parametrize(("solver", "tolerance"), [("dop853", 1e-6), ("tsit5", 1e-4)])
def test_a_slow_drift_is_sound(solver, tolerance, length):
    # Beside its circle the rod's force does work, as long as the motion lasts.
    x, y, u, v = me.dynamicsymbols("x y u v")
    frame, origin, bob = me.ReferenceFrame("N"), me.Point("O"), me.Point("P")
    origin.set_vel(frame, 0)
    bob.set_pos(origin, x * frame.x + y * frame.y)
    definition = Definition(
        frame, [x, y], [u, v], bodies=[me.Particle("bob", bob, 1)],
        loads=[(bob, -9.81 * frame.y)], holonomic_constraints=[x**2 + y**2 - length**2],
    )  # fmt: skip
    rate = length**0.5
    start = {x: 0.6 * length, y: -0.8 * length, u: 8.0 * rate, v: 6.0 * rate}
    times = np.linspace(0.0, 20.0 * rate, 51)
    system = System(definition, initial_conditions=start, times=times, ode_solver=solver)
    system.integrate(rtol=tolerance, atol=tolerance * length)


@pytest.mark.parametrize("solver", ADAPTIVE)
@pytest.mark.parametrize("tolerance", [1e-4, 1e-10])
def test_passing_singular_positions_by_projection_is_sound(solver, tolerance):
    system = n_four_bar(2).system
    system.ode_solver, system.times = solver, np.linspace(0.0, 3.0, 31)
    system.integrate(constraints="project", rtol=tolerance, atol=tolerance)


@pytest.mark.parametrize("metre", [1e-6, 1.0, 1e6])
def test_units_make_no_difference(metre):
    lengths = (1.0 * metre, 1.5 * metre)
    system = loop("spatial_four_bar", solver="tsit5", lengths=lengths)
    system.constants = {loops.GRAVITY: 9.81 * metre}
    refused(system, Outcome.LEFT_CONSTRAINTS, rtol=1e-6, atol=1e-6)
    system.integrate(constraints="project", rtol=1e-6, atol=1e-6)


UNITS = [(1e-8, 1e7), (1.0, 1.0), (1e-6, 1e-9), (1e6, 1e-7)]
UNITS += [(second, metre) for second in (1e-9, 1e9) for metre in (1e-9, 1e9)]


@pytest.mark.parametrize(("second", "metre"), UNITS)
def test_what_is_left_of_a_force_that_a_constraint_holds_is_sound(second, metre):
    """Tolerances below rounding errors explain none of it; beside the motion it is nothing."""
    x, y, u, v = me.dynamicsymbols("x y u v")
    frame, origin = inertial_frame()
    bodies = []
    for name, place, speed in (("held", x, u), ("free", y, v)):
        point = origin.locatenew(name, place * frame.x)
        point.set_vel(frame, speed * frame.x)
        bodies.append(me.Particle(name, point, 2))
    system = System(
        Definition(
            frame, [x, y], [u, v], bodies=bodies, kinematic_equations=[x.diff() - u, y.diff() - v],
            loads=[(body.masscenter, 3e8 * metre / second**2 * frame.x) for body in bodies],
            holonomic_constraints=[sm.sin(x / metre) - 0.6],
        ),
        times=np.array([0.0, 0.02 * second]),
    )  # fmt: skip
    place, rate = np.arcsin(0.6) * metre, metre / second
    states = np.array([[place, 0.0, 0.0, rate], [place, 0.0, 0.0, rate]])
    states = states[:, [[x, y, u, v].index(s) for s in system.states]]
    held = system.states.index(u)
    options = {"rtol": 1e-12, "atol": 1e-13 * min(metre, rate)}
    for share, sound in ((1e-9, True), (1e-6, False)):
        states[1, held] = share * rate
        info = {"steps": 1, "method": "dop853"}
        motion = motion_of(system, states, options, info, projected=False)
        if sound:
            check_drift(motion)
            continue
        with pytest.raises(IntegrationError, match="left the constraints"):
            check_drift(motion)


# -- causes ---------------------------------------------------------------------------------------


def kite(*loads, **more):
    """The kite, with torques on its first bar."""
    definition, start = loops.kite()
    bar = definition.bodies[0].frame
    system = System(
        Definition(
            definition.frame,
            definition.coordinates,
            definition.speeds,
            bodies=definition.bodies,
            loads=[*definition.loads, *((bar, load * definition.frame.z) for load in loads)],
            holonomic_constraints=definition.holonomic_constraints,
        ),
        {loops.GRAVITY: 9.81},
        initial_conditions=start,
        times=np.linspace(0.0, 3.0, 31),
        ode_solver="dop853",
        **more,
    )
    system.set_dependent_initial_conditions()
    return system


def projected(system, **options):
    return system.integrate(
        constraints="project", rtol=1e-8, atol=1e-8, full_output=True, **options
    )


def test_friction_is_a_cause():
    system = kite(-0.5 * me.dynamicsymbols("u1"))
    x, info = projected(system)
    assert info["nearness"] < 0.05
    assert np.ptp(system.evaluate_energy(x).total) > 1.0


def test_a_load_in_time_is_a_cause():
    t = me.dynamicsymbols._t
    system = kite(sm.Piecewise((5.0, (t > 1.02) & (t < 1.08)), (0.0, True)))
    x, info = projected(system, max_step=0.01)
    assert info["nearness"] < 0.05
    assert np.ptp(system.evaluate_energy(x).total) > 0.1


def test_an_input_is_a_cause():
    torque = me.dynamicsymbols("torque")
    system = kite(torque, specifieds={torque: lambda x, t: -x[4]})
    x, info = projected(system)
    assert info["nearness"] < 0.05
    assert np.ptp(system.evaluate_energy(x).total) > 1.0


def test_a_reset_is_a_cause():
    system = kite()
    reset = {u: u / 2 for u in system.speeds}
    brake = Event(me.dynamicsymbols._t - 1, reset=reset, name="brake")
    x, info = projected(system, events=[brake])
    assert info["events"]
    assert info["nearness"] < 0.05
    assert np.ptp(system.evaluate_energy(x).total) > 1.0


@pytest.mark.parametrize("drive", [3.0, 3.0 + sm.sin(me.dynamicsymbols._t)])
def test_a_drive_is_a_cause(drive):
    definition, _ = loops.kite()
    system = System(
        Definition(
            definition.frame,
            definition.coordinates,
            definition.speeds,
            bodies=definition.bodies,
            loads=definition.loads,
            holonomic_constraints=definition.holonomic_constraints,
            nonholonomic_constraints=[definition.speeds[0] - drive],
        ),
        {loops.GRAVITY: 9.81},
        initial_conditions=dict(loops.kite()[1]),
        times=np.linspace(0.0, 0.5, 11),
        ode_solver="dop853",
    )
    system.set_dependent_initial_conditions()
    x = system.integrate(rtol=1e-3, atol=1e-3)  # beside the constraints by more than six digits
    assert np.ptp(system.evaluate_energy(x).total) > 1.0


def test_a_step_that_is_too_long_is_a_cause():
    system = kite()
    system.ode_solver = "rk4"
    x = system.integrate(constraints="project", step=0.03)
    assert np.ptp(system.evaluate_energy(x).total) > 0.01


# -- ensembles ------------------------------------------------------------------------------------


def two_cranks(**more):
    """Three cranks without gravity in two samples: the first passes its singular position."""
    system = loop("three_cranks")
    system.constants = {loops.GRAVITY: 0.0}
    speeds = {speed: [6.0, 0.1] for speed in system.speeds[:3]}
    return system, {"initial_conditions": speeds, "rtol": 1e-10, "atol": 1e-10, **more}


@pytest.mark.parametrize(
    "options",
    [
        {},
        {"constraints": "baumgarte", "gain": 10.0},
        {"ode_solver": "radau"},
        {"reduce": "final"},
        {"reduce": [("max", "q1"), "final"]},
        {"events": [Event(me.dynamicsymbols._t - 2.88, terminal=True)]},
    ],
)
def test_a_sample_that_leaves_its_constraints_is_lost_alone(options):
    system, options = two_cranks(**options)
    results = system.integrate_ensemble(**options)
    terminal = "events" in options
    np.testing.assert_array_equal(results.status, [Outcome.LEFT_CONSTRAINTS, 5 if terminal else 0])
    assert results.end_time[0] < results.end_time[1]
    if "reduce" in options:
        assert np.isfinite(results.q1).values.tolist() == [False, True]
        return
    lost = np.isnan(results.q1.values)
    np.testing.assert_array_equal(lost[0], system.times > results.end_time.values[0])
    assert lost[1].sum() == (3 if terminal else 0)


def test_a_sample_that_is_lost_ends_like_a_single_motion():
    system, options = two_cranks()
    results = system.integrate_ensemble(**options)
    for speed in system.speeds[:3]:
        system.initial_conditions[speed] = 6.0
    error = refused(system, Outcome.LEFT_CONSTRAINTS, rtol=1e-10, atol=1e-10)
    assert results.end_time[0] == system.times[system.times < error.time][-1]
    reached = ~np.isnan(results.q1.values[0])
    np.testing.assert_allclose(results.q1.values[0][reached], error.states[reached, 0], atol=1e-3)


def test_a_sample_that_changes_its_energy_is_lost_alone():
    system = bricard((0, 1, 3, 4)).system
    (rate,) = [s for s in system.speeds if str(s) == "u1(t)"]
    results = system.integrate_ensemble(
        constants={"g": [9.81, 0.0]}, times=np.linspace(0.0, 5.0, 61), ode_solver="tsit5",
        rtol=1e-10, atol=1e-10,
    )  # fmt: skip
    np.testing.assert_array_equal(results.status, [Outcome.ENERGY_CHANGED, 0])
    assert np.isfinite(results[str(rate)[:2]].values[1]).all()


def test_a_projected_ensemble_passes_and_is_judged_near_singular_places(monkeypatch):
    system, options = two_cranks(constraints="project")
    assert (system.integrate_ensemble(**options).status == 0).all()
    judged = []
    monkeypatch.setattr(DriftCheck, "report", lambda check, _: judged.append(check.nearness))
    system.integrate_ensemble(**options)
    # The other sample kept the rows that were left out, far from singular places.
    (nearness,) = judged
    assert nearness < DriftCheck.NEAR_SINGULAR


def test_an_ensemble_in_other_processes_is_looked_at():
    dask = pytest.importorskip("dask")
    system, options = two_cranks(chunks=1)
    with dask.config.set(scheduler="processes", num_workers=1):
        status = system.integrate_ensemble(**options).status.values
    np.testing.assert_array_equal(status, [Outcome.LEFT_CONSTRAINTS, 0])


def test_a_sound_ensemble_is_looked_at_once():
    system = slider_crank(2.0).system
    judged = []
    real = DriftCheck.report
    times = np.linspace(0.0, 3.0, 201)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(DriftCheck, "report", lambda *a: judged.append(a) or real(*a))
        evaluate, counted = Batch.evaluate, []

        def count(batch, program, times, states):
            if program is not batch.model.outputs:
                counted.append(states[0].size)
            return evaluate(batch, program, times, states)

        patch.setattr(Batch, "evaluate", count)
        found = system.integrate_ensemble(
            constants={"g": np.linspace(9.0, 10.0, 50)}, times=times, workers=1
        )
    assert (found.status == 0).all()
    assert judged == []
    # Of each evaluation of the equations a hundredth: 64 states against thousands of stages.
    assert sum(counted) * 10 < found.evaluations.values.sum()
