"""Many motions with contacts: one by one, with modes that all samples share."""

import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import Contacts, Unilateral
from pydy.errors import IntegrationInterrupted, PyDyUserWarning
from pydy.mechanics import Definition
from pydy.solvers import Event
from zoo.touching import TIGHT, J, N, O, a, ball, e, falling_body, g, k, m, mu, vx, vy, x, y


def test_samples_move_as_they_do_alone():
    system, floor = ball(restitution=e)
    system.initial_conditions, system.times = {y: 1.0}, np.linspace(0.0, 1.5, 4)
    contacts = Contacts(system, [floor], {e: 0.8})
    result = system.integrate_ensemble(
        contacts=contacts, constants={e: [0.2, 0.5, 0.8]}, initial_conditions={y: [1.0, 2.0, 3.0]},
        workers=2, **TIGHT,
    )  # fmt: skip
    assert set(result.status.values) == {0}
    assert contacts.compiled_modes == [{"floor": "open"}, {"floor": "closed"}]
    for row, (ratio, height) in enumerate([(0.2, 1.0), (0.5, 2.0), (0.8, 3.0)]):
        system.constants[e], system.initial_conditions = ratio, {y: height}
        alone = contacts.simulate(**TIGHT)
        for name in ("y", "v_y", "floor_gap", "floor_normal"):
            assert result[name].values[row] == pytest.approx(alone[name], abs=1e-14)
        assert result.steps.values[row] == alone.statistics["steps"]


def test_transitions_and_users_events_are_told_of_each_sample():
    system, floor = ball(restitution=0.5)
    system.times = np.linspace(0.0, 1.0, 3)
    apex = Event(system.states[1], direction=-1, name="apex")
    result = system.integrate_ensemble(
        contacts=Contacts(system, [floor]), initial_conditions={y: [1.0, 0.5]}, events=apex,
        reduce=["final", ("events", 2), ("max", "floor_normal")], **TIGHT,
    )  # fmt: skip
    first = np.sqrt(2 * np.array([1.0, 0.5]) / 9.81)
    assert result["floor closes_times"].values[:, 0] == pytest.approx(first, abs=1e-11)
    assert result["apex_times"].values[:, 1] == pytest.approx(1.5 * first, abs=1e-11)
    assert result["floor_normal_max"].values == pytest.approx([0.0, 9.81])  # the second rests
    assert result["y"].shape == (2,)


def test_the_final_state_is_the_one_after_a_terminal_event():
    system, floor = ball(restitution=0.5)
    system.times, system.outputs = np.linspace(0.0, 1.0, 3), {"twice": 2 * y}
    apex = Event(system.states[1], direction=-1, terminal=True, name="apex")
    heights = np.array([1.0, 0.5, 7.0])
    ends = system.integrate_ensemble(
        contacts=Contacts(system, [floor]), initial_conditions={y: heights, system.states[1]: -1.0},
        events=apex, reduce="final", **TIGHT,
    )  # fmt: skip
    assert ends.status.values.tolist() == [5, 5, 0]
    # A quarter of the energy is left after the impact; the third has not fallen yet.
    highest = np.array([*(heights[:2] + 0.5 / 9.81) / 4, 7.0 - 1.0 - 9.81 / 2])
    assert ends["y"].values == pytest.approx(highest, abs=1e-10)
    assert ends["twice"].values == pytest.approx(2 * highest, abs=1e-10)
    assert ends["floor_gap"].values == pytest.approx(highest, abs=1e-10)


def test_samples_have_the_sensitivities_that_they_have_alone():
    system, feet = falling_body([(-1, -0.2), (1, -0.2)], restitution=e, mu=mu)
    system.constants.update({J: 0.4, e: 0.3, mu: 0.3})
    system.initial_conditions = {y: 1.0, a: 0.4, vx: 1.0}
    system.times = np.linspace(0.0, 0.6, 4)
    contacts, wrt = Contacts(system, feet), [mu, e, a]
    given = {"contacts": contacts, "constants": {mu: [0.3, 2.0]}, "sensitivities": iter(wrt)}
    whole = system.integrate_ensemble(**given, workers=2, **TIGHT)
    reduced = ["final", ("events", 1), ("max", "v_x")]
    given["sensitivities"] = wrt
    few = system.integrate_ensemble(**given, reduce=reduced, **TIGHT)
    for row, friction in enumerate([0.3, 2.0]):
        system.constants[mu] = friction
        alone = contacts.simulate(sensitivities=wrt, **TIGHT)
        first = next(one for one in alone.events if one.name == "foot0 closes")
        for name in ("x", "w", "foot0_normal", "foot1_gap"):
            slopes = whole.sensitivity.sel(quantity=name).values[row]
            wanted = np.stack([alone.sensitivity[name, one] for one in wrt], axis=1)
            assert slopes == pytest.approx(wanted, abs=1e-12)
            assert few.sensitivity.sel(quantity=name).values[row] == pytest.approx(wanted[-1])
        times = few["foot0 closes_times_sensitivity"].values[row, 0]
        assert times == pytest.approx(first.time_sensitivity)


def test_a_sample_without_a_motion_is_lost_alone():
    # Painlevé's paradox: J + cos a (cos a − μ sin a) < 0 for the largest friction.
    system, feet = falling_body([(-1.0, 0.0)], mu=mu)
    lean = 0.9
    system.constants[J], system.times = 1 / 3, [0.0, 0.1, 0.2]
    system.initial_conditions = {a: lean, x: np.cos(lean), y: np.sin(lean), vx: -1.0}
    contacts = Contacts(system, feet, {mu: 0.5})
    result = system.integrate_ensemble(contacts=contacts, constants={mu: [0.3, 3.0, 0.6]})
    assert list(result.status.values) == [0, 22, 0]
    slopes = system.integrate_ensemble(
        contacts=contacts, constants={mu: [0.3, 3.0, 0.6]}, sensitivities=[mu]
    ).sensitivity
    assert np.isfinite(slopes.values[[0, 2]]).all()
    assert np.isnan(slopes.values[1]).all()
    assert "contacts_impossible" in result.status.attrs["flag_meanings"].split()
    assert np.isnan(result["x"].values[1]).all()
    assert np.isfinite(result["foot0_normal"].values[[0, 2]]).all()


def test_what_a_sample_did_before_it_failed_is_kept():
    P = O.locatenew("P", y * N.y)
    P.set_vel(N, vy * N.y)
    pull = (-m * g + sm.log(1 - k * me.dynamicsymbols._t)) * N.y
    system = System(
        Definition(N, [y], [vy], bodies=[me.Particle("P", P, m)], loads=[(P, pull)]),
        {g: 9.81}, {}, "dop853", {y: 1.0}, np.linspace(0.0, 2.0, 5),
    )  # fmt: skip
    contacts = Contacts(system, [Unilateral(y, name="floor", restitution=0.5)])
    result = system.integrate_ensemble(contacts=contacts, constants={k: [0.0, 1.0]}, rtol=1e-8)
    assert result.status.values[0] == 0
    assert result.status.values[1] in (2, 4)  # the logarithm ends at t = 1
    assert result.end_time.values[1] == pytest.approx(1.0, abs=1e-3)
    assert np.isfinite(result["floor_gap"].values[1, :2]).all()
    assert np.isnan(result["y"].values[1, 3:]).all()


def test_a_sample_travels_to_another_process():
    system, floor = ball(restitution=0.5)
    system.initial_conditions, system.times = {y: 1.0}, np.linspace(0.0, 1.0, 3)
    contacts = Contacts(system, [floor])
    wanted = contacts.simulate()
    there = pickle.loads(pickle.dumps(contacts))
    assert there.simulate().states == pytest.approx(wanted.states, abs=0)
    lazy = system.integrate_ensemble(contacts=contacts, initial_conditions={y: [1.0]}, chunks=1)
    assert lazy["y"].values[0] == pytest.approx(wanted["y"], abs=0)


def test_what_is_no_contacts_of_the_system_is_named():
    system, floor = ball()
    other, _ = ball()
    system.times = other.times = [0.0, 1.0]
    contacts = Contacts(system, [Unilateral(y, name="floor")])
    with pytest.raises(TypeError, match="`contacts` must be Contacts of this System, got"):
        other.integrate_ensemble(contacts=contacts, initial_conditions={y: [1.0]})
    with pytest.raises(TypeError, match="`contacts` must be Contacts of this System, got"):
        system.integrate_ensemble(contacts=[floor], initial_conditions={y: [1.0]})


def test_a_sample_that_begins_below_the_floor_is_told_and_others_go_on():
    system, floor = ball(restitution=0.5)
    system.times = np.linspace(0.0, 1.0, 3)
    contacts = Contacts(system, [floor])
    with pytest.warns(PyDyUserWarning, match="1 of 2"):
        result = system.integrate_ensemble(contacts=contacts, initial_conditions={y: [1.0, -0.1]})
    assert result.status.values.tolist() == [0, 9]
    assert np.isnan(result["y"].values[1]).all()
    assert np.isfinite(result["y"].values[0]).all()


@pytest.mark.parametrize("what", ["restitution", "gap", "hypothesis", "events", "masses"])
def test_a_store_belongs_to_its_contacts(what, tmp_path):
    def contacts(what=""):
        weight = 2.0 if what == "masses" else 1.0
        rail = Definition(N, [x, y], [vx, vy], bodies=[
            me.Particle("a", O.locatenew("A", x*N.x), 1.0),
            me.Particle("b", O.locatenew("B", y*N.x), weight),
        ])  # fmt: skip
        system = System(rail, initial_conditions={x: 0.0, y: 1.0, vx: 2.0}, ode_solver="dop853",
                        times=np.linspace(0.0, 1.0, 3))  # fmt: skip
        gap = Unilateral(y - x - (0.5 if what == "gap" else 0),
                         restitution=e**2 if what == "restitution" else e)  # fmt: skip
        poisson = "poisson" if what == "hypothesis" else "newton"
        return Contacts(system, [gap], {e: 0.5}, hypothesis=poisson)

    def run(what="", **options):
        made = contacts(what)
        seen = Event(x - 0.2, terminal=what == "events")
        return made.system.integrate_ensemble(
            contacts=made, constants={e: [0.2, 0.8]}, events=seen, chunks=1,
            store=tmp_path / "found.zarr", **options,
        )  # fmt: skip

    first = run().load()
    assert run(resume=True).load().equals(first)
    with pytest.raises(ValueError, match=r"was written by another ensemble.*differs: .*contacts"):
        run(what, resume=True)


def test_a_motion_that_is_stopped_ends_at_its_next_transition():
    system, floor = ball(restitution=0.9)
    system.initial_conditions, system.times = {y: 1.0}, [0.0, 5.0]
    contacts = Contacts(system, [floor])
    options = {"sensitivities": None, "control_sensitivities": False}
    motions = contacts.motions(system._now(), system.ode_solver, {}, [], options)
    asked = []

    def stopped():
        asked.append(True)
        return len(asked) == 3

    with pytest.raises(IntegrationInterrupted) as caught:
        motions(np.array([1.0, 0.0]), np.zeros(0), system._now().p, system.times, stopped)
    apex = (2 / 9.81) ** 0.5 * 1.9  # that after the impact, from which on the gap is watched
    assert caught.value.time == pytest.approx(apex)
