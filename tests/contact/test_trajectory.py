"""The results of a System with contacts: their names, copies, and what files keep of them."""

import copy
import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.contact import Contacts, Stick, Unilateral
from pydy.errors import ContactError
from pydy.mechanics import Definition
from pydy.trajectory import Trajectory
from pydy.viz import Arrow, Scene, Visual
from zoo.cases import close
from zoo.touching import N, O, ball, billiard_ball, block, m, mu, vx, vy, y

TIMES = np.linspace(0.0, 0.9, 40)


def bounces(**options):
    system, floor = ball(restitution=0.5)
    system.initial_conditions, system.times = {y: 1.0}, np.linspace(0.0, 0.9, 10)
    return Contacts(system, [floor]).simulate(**options)


def test_a_pickled_motion_is_known_between_its_times():
    motion = bounces(rtol=1e-10, atol=1e-10)
    again = pickle.loads(pickle.dumps(motion))
    # Cubics are exact for a fall; the impact is between two of the times.
    assert again.at(TIMES).states == pytest.approx(motion.at(TIMES).states, abs=1e-9)
    assert pickle.loads(pickle.dumps(motion.at(TIMES))).at(TIMES).states.shape == (40, 2)


def test_a_motion_of_more_steps_than_are_kept_is_known_between_its_times(monkeypatch):
    motion = bounces(rtol=1e-10, atol=1e-10)
    monkeypatch.setattr("pydy.solvers.run.workspace.STEPS_MEMORY", 0)
    many = bounces(rtol=1e-10, atol=1e-10, max_step=1e-5)
    assert many.at(TIMES).states == pytest.approx(motion.at(TIMES).states, abs=1e-9)


def test_the_work_of_contacts_is_pickled():
    motion = billiard_ball().simulate()
    again = pickle.loads(pickle.dumps(motion))
    assert motion.contact_work[-1] < -0.1
    np.testing.assert_array_equal(again.contact_work, motion.contact_work)


def test_the_work_of_contacts_is_known_after_more_steps_than_are_kept(monkeypatch):
    motion = billiard_ball().simulate()
    monkeypatch.setattr("pydy.solvers.run.workspace.STEPS_MEMORY", 0)
    again = pickle.loads(pickle.dumps(billiard_ball().simulate(max_step=1e-4)))
    assert again.contact_work == pytest.approx(motion.contact_work, abs=1e-9)


def test_the_work_of_contacts_is_that_in_the_relative_motion():
    """A block that is laid on a belt: the belt does twice the work that the block gains."""
    system, _ = block()
    floor, speed = Unilateral(y, name="belt"), 1.5
    system.times, system.initial_conditions = np.linspace(0.0, 1.0, 11), {y: 0.0}
    contacts = Contacts(system, [floor, Stick(vx - speed, on=floor, mu=mu)], {mu: 0.2})
    motion = contacts.simulate(rtol=1e-12, atol=1e-12)
    sliding = speed - np.minimum(0.2 * 9.81 * motion.times, speed)
    close(motion["v_x"], speed - sliding, 1e-10)
    close(motion.contact_work, (sliding**2 - speed**2) / 2.0, 1e-10)
    assert motion.energy[-1, 2] - motion.energy[0, 2] == pytest.approx(speed**2 / 2.0)


def test_a_motion_at_other_times_has_the_work_of_contacts():
    motion = billiard_ball().simulate(rtol=1e-10, atol=1e-10)
    every = motion.at(motion.times[3:])
    assert isinstance(every, type(motion))
    close(every.contact_work, motion.contact_work[3:], 1e-12)
    back = motion.at(motion.times[::-1]).at(motion.times[5:2:-1])
    close(back.contact_work, motion.contact_work[5:2:-1], 1e-12)
    again = pickle.loads(pickle.dumps(back))
    np.testing.assert_array_equal(again.contact_work, back.contact_work)


def test_the_work_of_an_impact_before_other_times_is_counted():
    motion = bounces(rtol=1e-10, atol=1e-10)
    later = motion.at([0.6, 0.8])  # the ball keeps a quarter of its energy of 9.81 m at 0.45 s
    mass = float(motion.constants[m])
    close(later.contact_work, [-0.75 * 9.81 * mass] * 2, 1e-8)


def test_a_copied_motion_has_the_same_extension():
    motion = bounces()
    np.testing.assert_array_equal(copy.deepcopy(motion).at(TIMES).states, motion.at(TIMES).states)


def test_a_file_is_loaded_as_a_trajectory(tmp_path):
    motion = bounces()
    motion.save(tmp_path / "motion.nc")
    loaded = type(motion).load(tmp_path / "motion.nc")
    assert type(loaded) is Trajectory
    np.testing.assert_array_equal(loaded["floor_gap"], motion["floor_gap"])
    # Parabolas, and rest: cubic pieces from one side of each transition to the other.
    np.testing.assert_allclose(loaded.at(TIMES).states, motion.at(TIMES).states, atol=1e-9)


def test_modes_and_impacts_are_those_of_the_motion_in_files_copies_and_at_other_times(tmp_path):
    motion = bounces()
    fall = np.sqrt(2.0 / 9.81)
    assert motion.modes[0][2] == {"floor": "open"}
    assert motion.impacts[0][0] == pytest.approx(fall, rel=1e-6)
    motion.at(TIMES).save(tmp_path / "motion.nc")
    loaded = Trajectory.load(tmp_path / "motion.nc")
    loaded.save(tmp_path / "again.nc")
    again = Trajectory.load(tmp_path / "again.nc")
    several = [motion.at(TIMES).at(TIMES[::-1]), loaded, loaded.at(TIMES), again]
    for other in [*several, *(pickle.loads(pickle.dumps(one)) for one in (motion, loaded))]:
        assert other.modes == motion.modes
        assert other.impacts == motion.impacts


@pytest.mark.parametrize("name", ["floor_gap", "floor_normal", "floor_margin"])
def test_outputs_of_the_user_and_of_contacts_have_different_names(name):
    system, floor = ball()
    system.outputs = {sm.Symbol(name): vy}
    contacts = [Stick(vy, on=floor, mu=0.1)] if name == "floor_margin" else [floor]
    with pytest.raises(ValueError, match=rf"the name `{name}`, which `contacts` need"):
        Contacts(system, contacts)


@pytest.mark.parametrize("name", ["floor_rising", "floor_bias_0"])
def test_constants_do_not_become_quantities_of_contacts(name):
    system, floor = ball()
    system.constants = {}
    own = sm.Symbol(name)
    P = next(iter(system.eom_method.bodies)).masscenter
    moved = type(system)(
        type(system.eom_method)(
            N, [y], [vy], bodies=system.eom_method.bodies, loads=[(P, -m * own * N.y)]
        ),
        {own: 9.81},
    )
    with pytest.raises(ValueError, match=rf"the name `{name}`, which `contacts` need"):
        Contacts(moved, [floor])


@pytest.mark.parametrize("kind", [KeyboardInterrupt, RuntimeError, MemoryError])
def test_what_stops_a_motion_hands_over_what_was_computed(kind):
    """In the second flight of a ball that bounces, where a specified raises."""
    height, speed, push = me.dynamicsymbols("height speed push")
    P = O.locatenew("P", height * N.y)
    P.set_vel(N, speed * N.y)

    def raising(state, t):
        if t > 0.7:
            raise kind("stop")
        return 0.0

    system = System(
        Definition(
            N, [height], [speed], bodies=[me.Particle("P", P, 1)], loads=[(P, (push - 10) * N.y)]
        ),
        ode_solver="dop853", initial_conditions={height: 1.0}, specifieds={push: raising},
        times=np.linspace(0.0, 2.0, num=41),
    )  # fmt: skip
    with pytest.raises(kind) as caught:
        Contacts(system, [Unilateral(height, restitution=0.8)]).simulate(max_step=0.05)
    if kind is RuntimeError:  # it arrives as it was raised
        assert str(caught.value) == "stop"
        return
    times, states = caught.value.times, caught.value.states
    assert 9 <= len(times) <= 14
    assert times[0] == 0.0
    assert times[-1] <= 0.7
    fall, rest = np.sqrt(0.2), times > np.sqrt(0.2)
    flight = times[rest] - fall
    close(states[~rest, 0], 1 - 5 * times[~rest] ** 2, 1e-6)
    close(states[rest, 0], 8 * np.sqrt(0.2) * flight - 5 * flight**2, 1e-6)


def test_arrows_show_contact_forces_where_the_motion_has_them():
    motion = billiard_ball().simulate(rtol=1e-10, atol=1e-10)
    name = next(str(s)[: -len("_normal")] for s in motion.outputs_symbols if "_normal" in str(s))
    normal, friction = sm.symbols(f"{name}_normal {name}_friction")
    arrow = Visual(Arrow(normal * N.y + friction * N.x), O)
    scene = Scene(N, O, arrow).animate(motion)
    drawn = scene._animation.items[0].vectors
    shown = motion.at(scene.times)
    close(drawn[:, :2], np.stack([shown[friction], shown[normal]], axis=1), 1e-12)
    assert drawn[0, 0] != 0.0 == drawn[-1, 0]  # it slides, then it rolls


@pytest.mark.parametrize("full", [True, False])
def test_a_motion_has_its_statistics_whatever_full_output_is(full):
    motion = bounces(full_output=full)
    assert motion.statistics["steps"] > 0
    np.testing.assert_array_equal(motion.states, bounces().states)


@pytest.mark.parametrize("height", [0.0, 1.0])
def test_a_body_without_mass_in_contact_is_named_by_its_mass(height):
    system, floor = ball(restitution=0.5)
    system.constants[m], system.initial_conditions = 0.0, {y: height}
    system.times = [0.0, 1.0]
    with pytest.raises(ContactError, match="The cause is the constant `m`, which is zero"):
        Contacts(system, [floor]).simulate()
