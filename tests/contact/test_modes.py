"""Systems of one combination of modes, and what contacts cost that do not act."""

import math
from copy import copy

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy._integration import integration
from pydy.contact import Contacts, Stick, Unilateral
from pydy.errors import ContactError
from pydy.mechanics import Definition
from zoo import inertial_frame
from zoo.touching import J, N, a, ball, block, falling_body, m, mu, slope, vx, y


def test_a_linear_model_of_one_mode():
    # A body that stands on one foot, which sticks: an inverted pendulum of the length 1.
    system, feet = falling_body([(0.0, -1.0)], mu=mu)
    system.constants[J], system.initial_conditions = 0.3, {y: 1.0}
    contacts = Contacts(system, feet, {mu: 0.5})
    stands = contacts.in_modes({"foot0": "sticks"})
    values = np.sort(stands.linearize().eigenvalues.real)
    rate = math.sqrt(9.81 / 1.3)
    assert values[[0, -1]] == pytest.approx([-rate, rate], abs=1e-9)
    # It is free to move where nothing holds it, and slides with friction that does not hold.
    assert contacts.in_modes({}).evaluate_ode()[3:] == pytest.approx([0.0, -9.81, 0.0])
    slides = contacts.in_modes({"foot0": "slides +"}).evaluate_ode()[3:]
    assert slides[0] == pytest.approx(-0.5 * (9.81 + slides[1]))
    assert abs(stands.evaluate_ode()).max() == 0.0


def test_outputs_keep_the_names_that_the_user_gave():
    system, feet = falling_body([(0.0, -1.0)], mu=mu)
    system.constants[J], system.initial_conditions = 0.3, {y: 1.0, vx: 0.25}
    height = sm.Symbol("height")
    # One has the name of a state: it is `v_x_output` where names are labels.
    system.outputs = {height: y - 1, ("twice", "thrice"): (2 * vx, 3 * vx), "v_x": 4 * vx}
    contacts = Contacts(system, feet, {mu: 0.5})
    free = contacts.in_modes({})
    assert [*free.outputs][:3] == [*system.outputs][:3]
    assert free.outputs[height] == y - 1
    assert free.outputs_symbols[:4] == system.outputs_symbols[:4]
    np.testing.assert_array_equal(free.evaluate_outputs()[:4], [0.0, 0.5, 0.75, 1.0])
    system.times = np.linspace(0.0, 0.1, 3)
    trajectory = contacts.simulate()
    assert [*trajectory["v_x_output"]] == pytest.approx([*(4 * trajectory["v_x"])])


def test_constants_that_are_replaced_leave_those_of_the_contacts_at_zero():
    system, feet = falling_body([(-1.0, -1.0), (1.0, -1.0)], mu=mu)
    system.constants[J], system.initial_conditions = 0.3, {y: 1.0}
    stands = Contacts(system, feet, {mu: 0.5}).in_modes({"foot0": "sticks", "foot1": "sticks"})
    names = {str(symbol) for symbol in stands.constants}
    assert not any("bias" in name or "rising" in name for name in names)
    definite = stands.evaluate_outputs()
    bias = next(s for s in stands.constants_symbols if str(s) == "foot0_bias_1")
    assert abs(stands.evaluate_outputs(p={bias: 1.0}) - definite).max() > 0.1  # frictions squeeze
    stands.constants = dict(stands.constants)
    np.testing.assert_array_equal(stands.evaluate_outputs(), definite)


def test_modes_that_a_contact_does_not_have_are_named():
    system, P = block(slope)
    ground = Unilateral(y, name="ground")
    contacts = Contacts(system, [Stick(P, on=ground, mu=mu, along=N.x)])
    with pytest.raises(ValueError, match="`modes` has the key 'floor'; the contacts are ground"):
        contacts.in_modes({"floor": "open"})
    with pytest.raises(ValueError, match=r"must be one of 'open', 'sticks', .*got 'closed'"):
        contacts.in_modes({"ground": "closed"})
    brake = Contacts(system, [Stick(vx, mu=mu, normal=1.0, name="brake")])
    with pytest.raises(ValueError, match=r"`modes\['brake'\]` must be one of 'sticks'.* got None"):
        brake.in_modes({})
    with pytest.raises(AttributeError, match=r"Contacts have no `export`.*`in_modes`"):
        contacts.export("model.c")
    with pytest.raises(AttributeError, match="Contacts have no attribute 'hop'"):
        contacts.hop()
    with pytest.raises(AttributeError, match="constants"):
        contacts.constants = {mu: 0.3}  # those of the System are meant


def test_constants_of_contacts_do_not_change_the_dictionary_of_the_user():
    values = {m: 2.0}
    system, _ = block(slope)
    system.constants = {}
    system.constants = values
    Contacts(system, [Stick(vx, mu=mu, normal=1.0)], {"mu": 0.4})
    assert values == {m: 2.0}
    assert system.constants == {m: 2.0, "mu": 0.4}


def test_a_dictionary_that_drops_what_contacts_were_given_is_refused():
    """Friction of 0.4 would be one of 1.0, the default, after an assignment for other reasons."""
    system, _ = block(slope)
    contacts = Contacts(system, [Stick(vx, mu=mu, normal=1.0)], {"mu": 0.4})
    system.times, system.constants = [0.0, 1.0], {}
    system.constants = {m: 2.0}
    message = r"`system.constants` has no value of `mu`, 0\.4 in `Contacts`"
    for run in (contacts.simulate, lambda: system.integrate_ensemble(contacts=contacts)):
        with pytest.raises(ValueError, match=message):
            run()
    ensemble = system.integrate_ensemble(contacts=contacts, constants={mu: [0.4, 0.4]})
    with pytest.raises(ValueError, match=message):  # the copy belongs to the same System
        copy(contacts).simulate()
    system.constants = {m: 2.0, mu: 0.4}  # by another spelling of the key
    assert ensemble["v_x"].values[:, -1] == pytest.approx(contacts.simulate()["v_x"][-1])


@pytest.mark.parametrize("speed", [4.0, 0.0])
def test_a_known_normal_force_that_becomes_negative_is_named(speed):
    """Friction that drives the body, or holds it by the square of that force, is none."""
    system, _ = block(0)
    system.initial_conditions, system.times = {vx: speed}, np.linspace(0.0, 6.0, 13)
    force = 5 * sm.sin(me.dynamicsymbols._t)
    with pytest.raises(ContactError, match=r"`normal` of 'brake' became -.* must not be negative"):
        Contacts(system, [Stick(vx, mu=0.3, normal=force, name="brake")]).simulate()
    positive = Stick(vx, mu=0.3, normal=force + 5, name="brake")  # it touches zero
    assert Contacts(system, [positive]).simulate().times[-1] == 6.0


def test_a_coefficient_of_friction_that_becomes_negative_is_named():
    """Friction that drives the body is none."""
    system, _ = block(0)
    system.initial_conditions, system.times = {vx: 4.0}, np.linspace(0.0, 6.0, 13)
    mu = 0.1 - 0.1 * me.dynamicsymbols._t
    with pytest.raises(ContactError, match=r"`mu` of 'brake' became -.* must not be negative"):
        Contacts(system, [Stick(vx, mu=mu, normal=5, name="brake")]).simulate()


@pytest.mark.parametrize("way", [1e-8, 10.0])
def test_a_transition_that_was_stepped_over_is_named_whatever_tolerance_other_states_have(way):
    """A floor that jumps up for 50 µs by 2 m touches a body at rest at 1 m, which travels far."""
    t, (height, x, v, w) = me.dynamicsymbols._t, me.dynamicsymbols("y x v w")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", height * frame.y + x * frame.x)
    point.set_vel(frame, v * frame.y + w * frame.x)
    body = Definition(frame, [height, x], [v, w], bodies=[me.Particle("body", point, 1)])
    system = System(
        body,
        ode_solver="dop853",
        initial_conditions={height: 1.0, w: 1e9},
        times=np.linspace(0.0, 1.0, 3),
    )
    floor = Unilateral(height - 2 * sm.exp(-((20000 * t - 10000) ** 2)), name="floor")
    stepped_over = r"gap of 'floor' became -1 between two transitions: the solver stepped over one"
    with pytest.raises(ContactError, match=stepped_over):
        Contacts(system, [floor]).simulate(atol=np.array([1e-8, way, 1e-8, 1e-8]))


def test_a_contact_that_does_not_act_costs_no_step_and_no_evaluation():
    system, feet = falling_body([(-1, -0.2), (1, -0.2)], mu=0.3)
    system.constants[J] = 0.4
    system.initial_conditions, system.times = {y: 1e3, a: 0.3, vx: 1.0}, np.linspace(0.0, 5.0, 6)
    contacts = Contacts(system, feet)
    for solver in ("tsit5", "dop853", "radau"):
        system.ode_solver = solver
        apart, alone = contacts.simulate(rtol=1e-9), system.simulate(rtol=1e-9)
        assert len(apart.modes) == 1
        assert apart.statistics["steps"] == alone.statistics["steps"]
        assert np.array_equal(apart.states, alone.states)
        assert apart.statistics["evaluations"] == alone.statistics["evaluations"]


def test_another_run_prepares_nothing_again(monkeypatch):
    system, feet = falling_body([(-1, -0.2), (1, -0.2)], mu=0.3)
    system.constants[J] = 0.4
    system.initial_conditions, system.times = {y: 1.0, a: 0.4, vx: 1.0}, np.linspace(0.0, 1.0, 9)
    contacts = Contacts(system, feet)
    first = contacts.simulate(rtol=1e-8)
    made = []
    monkeypatch.setattr(integration, "PreparedIntegration", lambda *given: made.append(given))
    again = contacts.simulate(rtol=1e-8)
    assert len(again.modes) == len(first.modes) > 2
    assert not made
    np.testing.assert_array_equal(again.states, first.states)


def test_a_gap_that_is_lowest_far_away_many_times_is_seen_to_close_later():
    # Where it turns is not looked at while it is far from zero.
    q, u = me.dynamicsymbols("q u")
    frame, origin = inertial_frame()
    tip = origin.locatenew("P", sm.sin(q) * frame.x - sm.cos(q) * frame.y)
    tip.set_vel(frame, u * (sm.cos(q) * frame.x + sm.sin(q) * frame.y))
    body = me.Particle("P", tip, 1)
    swing = Definition(frame, [q], [u], bodies=[body], loads=[(tip, -9.81 * frame.y)])
    system = System(swing, initial_conditions={q: 1.0}, times=np.linspace(0.0, 60.0, 61))
    floor = 0.1 * me.dynamicsymbols._t - 6.0
    contacts = Contacts(system, [Unilateral(-sm.cos(q) - floor, name="floor")])
    for solver in ("dop853", "tsit5", "radau"):
        system.ode_solver = solver
        found, fine = (
            contacts.simulate(rtol=1e-9, atol=1e-9, **o) for o in ({}, {"max_step": 0.02})
        )
        assert [e.name for e in found.events[:1]] == [e.name for e in fine.events[:1]] != []
        assert found.events[0].time == pytest.approx(fine.events[0].time, abs=1e-6)
        assert 50.0 < found.events[0].time < 55.0


def sliding(gap, along, mu=0.3):
    """A mass that falls on what a gap is measured from, with friction along some axis."""
    x, y, z, *u = me.dynamicsymbols("x y z u v w")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x + y * frame.y + z * frame.z)
    place.set_vel(frame, u[0] * frame.x + u[1] * frame.y + u[2] * frame.z)
    body = me.Particle("P", place, 1)
    block = Definition(frame, [x, y, z], u, bodies=[body], loads=[(place, -9 * frame.z)])
    system = System(block, ode_solver="dop853", initial_conditions={z: 1.0, u[0]: 1.0})
    system.times = np.linspace(0.0, 1.0, 5)
    gap = Unilateral(gap(x, z), name="floor")
    return Contacts(system, [gap, Stick(place, on=gap, mu=mu, along=along(frame))])


@pytest.mark.parametrize(
    ("gap", "along", "told"),
    [
        (lambda x, z: 1000 * z, lambda f: f.x, r"gap of 'floor' must be a length, .* 1000 times"),
        (
            lambda x, z: z / 3,
            lambda f: f.x,
            r"gap of 'floor' must be a length, .* 0\.333333 times",
        ),
        (lambda x, z: z, lambda f: f.z, r"`along` of 'floor' must be tangential .* at 0°"),
        (lambda x, z: z, lambda f: (f.x + f.z) / sm.sqrt(2), r"`along` of .* at 45° to the gap's"),
    ],
)
def test_friction_needs_a_length_and_a_tangent(gap, along, told):
    with pytest.raises(ValueError, match=told):
        sliding(gap, along).simulate()


def test_a_gap_is_a_length_where_it_is_closed():
    """A level of which that is so at the surface alone, and a slope."""
    sliding(lambda x, z: z**2 - 1 / 4, lambda f: f.x).simulate()
    tilt = 0.1
    sliding(
        lambda x, z: z * sm.cos(tilt) - x * sm.sin(tilt),
        lambda f: sm.cos(tilt) * f.x + sm.sin(tilt) * f.z,
    ).simulate()


def test_rows_are_compiled_and_every_motion_has_the_same_bits(monkeypatch):
    system, floor = ball(restitution=0.5)
    system.initial_conditions, system.times = {y: 1.0}, np.linspace(0.0, 1.5, 31)
    # None is interpreted node by node, as would take a hundred times as long.
    monkeypatch.setattr("pydy._program.nodes.Nodes.evaluator", None)
    contacts = Contacts(system, [floor])
    first, second = contacts.simulate(), contacts.simulate()
    assert len(second.impacts) > 3
    assert (first.states == second.states).all()
    assert [r.time for r in first.events] == [r.time for r in second.events]
