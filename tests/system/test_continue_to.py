"""Motions that are continued where they ended: as simulated at once."""

import pickle
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
import sympy as sm
from sympy.physics.mechanics import Particle

from pydy import System
from pydy.contact import Contacts, Stick, Unilateral
from pydy.errors import PyDyUserWarning
from pydy.mechanics import Definition
from pydy.solvers import Event
from zoo.cases import close
from zoo.touching import N, O, ball, m, vx, vy, x, y

TIGHT = {"rtol": 1e-10, "atol": 1e-10}
BOUNCE = [
    Event(y, direction=-1, reset={vy: -0.8 * vy}, name="bounce"),
    Event(y - 0.5, name="half"),
]


def falling(end, solver="dop853"):
    """A ball that is let go at 1 m."""
    system, _ = ball()
    system.initial_conditions, system.times = {y: 1.0}, [0.0, end]
    system.ode_solver = solver
    return system


@cache
def whole():
    """The motion at once, with five events, and times on, before and after each."""
    motion = falling(1.5).simulate(events=BOUNCE, **TIGHT)
    moments = [event.time for event in motion.events]
    return motion, [t for e in moments for t in (e, np.nextafter(e, 0), np.nextafter(e, 9))]


@pytest.mark.parametrize("place", range(15))
def test_no_crossing_at_the_boundary_of_two_legs_is_counted_twice(place):
    motion, ends = whole()
    first = falling(ends[place]).simulate(events=BOUNCE, **TIGHT)
    second = first.continue_to(1.5)
    found = [event.name for event in (*first.events, *second.events)]
    assert found == [event.name for event in motion.events]
    close(second.states[-1], motion.states[-1], 1e-8)


@pytest.mark.parametrize("solver", ["radau", "tsit5"])
def test_each_solver_goes_on_with_its_own_options(solver):
    motion = falling(0.3, solver).simulate(**TIGHT).continue_to([0.4, 0.45])
    np.testing.assert_array_equal(motion.times, [0.3, 0.4, 0.45])
    close(motion["y"], 1 - 9.81 / 2 * motion.times**2, 1e-8)


def test_a_terminal_event_is_passed():
    level = Event(y - 0.5, terminal=True, name="level")
    first = falling(1.0).simulate(events=[level], **TIGHT)
    second = first.continue_to(0.4)
    assert second.times[0] == first.events[-1].time == pytest.approx(np.sqrt(1 / 9.81))
    assert second.events == ()
    close(second["y"][-1], 1 - 9.81 / 2 * 0.16, 1e-9)


def test_later_changes_of_the_system_do_not_matter():
    system = falling(0.2)
    first = system.simulate()
    system.constants[m], system.initial_conditions, system.times = 7.0, {}, [5.0, 6.0]
    assert first.continue_to(0.3).times[-1] == 0.3
    assert first.continue_to(0.3).constants[m] == first.constants[m]


def test_what_cannot_go_on_says_why():
    first = falling(0.2).simulate()
    for t in (0.1, [0.1, 0.3], [0.2], [], np.nan):
        with pytest.raises(ValueError, match=r"after the end of the motion, 0\.2|must be finite"):
            first.continue_to(t)
    with pytest.raises(ValueError, match="does not know how to go on"):
        pickle.loads(pickle.dumps(first)).continue_to(1.0)
    with pytest.raises(ValueError, match="does not know how to go on"):
        first.at([0.1]).continue_to(1.0)
    with pytest.raises(NotImplementedError, match="`sensitivities` of a motion"):
        falling(0.2).simulate(sensitivities=[y]).continue_to(1.0)
    bounce = Event(y, direction=-1, reset={vy: -0.5 * vy})
    with pytest.warns(PyDyUserWarning, match="accumulate"):
        rest = falling(2.0).simulate(events=[bounce])
    with pytest.raises(ValueError, match="where events accumulate"):
        rest.continue_to(3.0)


@cache
def sliding():
    """A block with friction above the ground, and its contacts."""
    P = O.locatenew("P", x * N.x + y * N.y)
    P.set_vel(N, vx * N.x + vy * N.y)

    g, mu = sm.symbols("g, mu")
    block = Definition(
        N, [x, y], [vx, vy], bodies=[Particle("block", P, m)], loads=[(P, -m * g * N.y)]
    )
    ground = Unilateral(y, name="ground", restitution=0.6)
    return block, [ground, Stick(P, on=ground, mu=mu, along=N.x)], {g: 9.81, m: 1.0}, {mu: 0.2}


def thrown(end):
    block, contacts, constants, given = sliding()
    system = System(
        block, constants, ode_solver="dop853", initial_conditions={y: 1.0, vx: 1.0},
        times=[0.0, end],
    )  # fmt: skip
    return Contacts(system, contacts, given)


LEVEL = Event(y - 0.2, name="level")


@cache
def landed():
    return thrown(4.0).simulate(events=[LEVEL], **TIGHT)


@pytest.mark.parametrize("event", range(4))
@pytest.mark.parametrize("way", [-9.0, None, 9.0])
def test_contacts_go_on_from_any_transition(event, way):
    motion = landed()
    end = motion.events[event].time
    first = thrown(end if way is None else np.nextafter(end, way)).simulate(events=[LEVEL], **TIGHT)
    second = first.continue_to(4.0)
    found = [one.name for one in (*first.events, *second.events)]
    assert found == [one.name for one in motion.events]
    close(second.states[-1], motion.states[-1], 1e-8)


def test_contacts_go_on_in_their_modes():
    second = thrown(3.0).simulate(**TIGHT).continue_to([3.5, 4.0])
    assert [modes for *_, modes in second.modes] == [{"ground": "sticks"}]
    assert second.events == ()
    np.testing.assert_array_equal(second["x"], second["x"][0])


def test_neighbouring_parts_in_the_same_modes_are_one_interval():
    modes = landed().modes
    assert modes[0][0] == 0.0
    assert all(a[2] != b[2] for a, b in pairwise(modes))
    assert all(a[1] == b[0] for a, b in pairwise(modes))
    assert len(landed().impacts) > 5  # between which all are open


def test_pictures_do_not_leave_out_contacts():
    contacts = thrown(1.0)
    system = contacts.system
    for method in ("animate", "plot"):
        with pytest.raises(ValueError, match=rf"system.{method}\(contacts=contacts\)"):
            getattr(system, method)()
        with pytest.raises(AttributeError, match=rf"Call system.{method}\(contacts=…\)"):
            getattr(contacts, method)
    heights = system.animate(contacts=contacts).poses[:, 0, 1, 3]
    assert heights.min() > -1e-9
    line = system.plot(["y"], contacts=contacts).lines[0].get_ydata()
    assert min(line) > -1e-6
    with pytest.raises(TypeError, match="must be Contacts of this System"):
        system.animate(contacts=thrown(1.0))


def test_a_motion_backward_in_time_goes_on_backward():
    back = falling(1.0)
    back.times = [0.3, 0.2, 0.1]
    back.initial_conditions = {y: 1 - 9.81 / 2 * 0.09, vy: -9.81 * 0.3}
    motion = back.simulate(**TIGHT).continue_to([0.05, 0.0])
    np.testing.assert_array_equal(motion.times, [0.1, 0.05, 0.0])
    close(motion["y"], 1 - 9.81 / 2 * motion.times**2, 1e-8)
    with pytest.raises(ValueError, match=r"after the end of the motion, 0\.1"):
        back.simulate(**TIGHT).continue_to(0.2)
