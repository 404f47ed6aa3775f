"""Optimal motions of constrained systems against those in coordinates that need no constraints."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from optima import T
from pydy import System
from pydy.control import OptimalControl
from pydy.mechanics import Definition

END = 1.2


def ground():
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    return frame, origin


def pendulum():
    """A bob of 1 kg at 1 m, pushed sideways, by its angle."""
    q, u, F = me.dynamicsymbols("q u F")
    frame, origin = ground()
    rod = me.ReferenceFrame("A")
    rod.orient_axis(frame, q, frame.z)
    rod.set_ang_vel(frame, u * frame.z)
    bob = origin.locatenew("P", -rod.y)
    bob.set_vel(frame, u * rod.x)
    loads = [(bob, F * frame.x - 9.81 * frame.y)]
    return System(Definition(frame, [q], [u], bodies=[me.Particle("b", bob, 1)], loads=loads))


def pendulum_in_a_plane(constraints=1):
    """The same in x and y, with its length as a constraint."""
    x, y, v, w, F = me.dynamicsymbols("x y v w F")
    frame, origin = ground()
    bob = origin.locatenew("P", x * frame.x + y * frame.y)
    bob.set_vel(frame, v * frame.x + w * frame.y)
    rows = [x**2 + y**2 - 1, 3 * (x**2 + y**2) - 3]
    definition = Definition(
        frame,
        [x, y],
        [v, w],
        bodies=[me.Particle("b", bob, 1)],
        loads=[(bob, F * frame.x - 9.81 * frame.y)],
        holonomic_constraints=rows[:constraints],
    )
    return System(definition, initial_conditions={y: -1.0})


def effort(system):
    (F,) = system.specifieds_symbols
    return sm.Integral(F**2, T)


@pytest.fixture(scope="module")
def by_angle():
    system = pendulum()
    return system.optimize_trajectory(effort(system), 1.5, end={"q": END, "u": 0.0}, mesh_tol=1e-8)


PLACE = {"x": np.sin(END), "y": -np.cos(END)}


@pytest.mark.parametrize("end", [{"x": PLACE["x"], "v": 0.0}, {**PLACE, "v": 0.0, "w": 0.0}])
@pytest.mark.parametrize("constraints", [1, 2])
def test_a_pendulum_in_cartesian_coordinates(by_angle, end, constraints):
    # It hangs where x cannot be solved for, and may have redundant constraints.
    system = pendulum_in_a_plane(constraints)
    found = system.optimize_trajectory(effort(system), 1.5, end=end, order=4)
    assert found.objective == pytest.approx(by_angle.objective, rel=1e-6)
    assert np.abs(found["x"] ** 2 + found["y"] ** 2 - 1.0).max() < 1e-9
    assert np.abs(found["x"] * found["v"] + found["y"] * found["w"]).max() < 1e-9
    nodes = by_angle.at(found.mesh)
    np.testing.assert_allclose(found.at(found.mesh)["x"], np.sin(nodes["q"]), atol=1e-6)
    labels = [f"constraint {k} of {kind}" for kind in ("positions", "velocities") for k in (0,)]
    assert set(labels) <= found.multipliers.keys()


def test_slack_velocities_vanish_with_the_errors():
    system, sizes = pendulum_in_a_plane(), []
    for mesh in (10, 20):
        found = system.optimize_trajectory(
            effort(system), 1.5, end={"x": PLACE["x"], "v": 0.0}, mesh=mesh
        )
        slack = found._transcription.split(found.solution.z)[1][1]
        sizes.append(np.abs(slack).max())
    assert sizes[0] < 0.1
    assert sizes[1] < sizes[0] / 4


def vehicle(minimal):
    """A skate that is pushed along and turned: Chaplygin's sleigh with its mass over the blade."""
    x, y, angle, v, w, turn, push, torque = me.dynamicsymbols("x y angle v w turn push torque")
    frame, origin = ground()
    body = me.ReferenceFrame("B")
    body.orient_axis(frame, angle, frame.z)
    body.set_ang_vel(frame, turn * frame.z)
    centre = origin.locatenew("C", x * frame.x + y * frame.y)
    c, s = sm.cos(angle), sm.sin(angle)
    loads = [(centre, push * body.x), (body, torque * frame.z)]
    centre.set_vel(frame, v * body.x if minimal else v * frame.x + w * frame.y)
    rigid = me.RigidBody("sleigh", centre, body, 1, (me.inertia(body, 0, 0, 0.1), centre))
    if minimal:
        kinematics = [x.diff() - v * c, y.diff() - v * s, angle.diff() - turn]
        definition = Definition(
            frame, [x, y, angle], [v, turn], bodies=[rigid], loads=loads,
            kinematic_equations=kinematics,
        )  # fmt: skip
    else:
        definition = Definition(
            frame, [x, y, angle], [v, w, turn], bodies=[rigid], loads=loads,
            nonholonomic_constraints=[w * c - v * s],
        )  # fmt: skip
    return System(definition), sm.Integral(push**2 + torque**2, T)


def test_a_nonholonomic_vehicle():
    end = {"x": 1.0, "y": 1.0, "angle": 0.0, "v": 0.0, "turn": 0.0}
    system, objective = vehicle(minimal=True)
    free = system.optimize_trajectory(objective, 2.0, end=end, order=4)
    system, objective = vehicle(minimal=False)
    times = np.linspace(0.0, 2.0, 41)
    guess = {name: free.at(times)[name] for name in ("x", "y", "angle")}
    bound = system.optimize_trajectory(objective, 2.0, end=end, order=4, guess=guess)
    assert bound.objective == pytest.approx(free.objective, rel=1e-6)
    sideways = bound["w"] * np.cos(bound["angle"]) - bound["v"] * np.sin(bound["angle"])
    assert np.abs(sideways[1:]).max() < 1e-9


def test_dependent_states_of_the_start_follow():
    system = pendulum_in_a_plane()
    found = system.optimize_trajectory(
        effort(system), 1.0, start={"y": -0.8, "w": 0.3}, end={"x": 0.0, "v": 0.0},
        guess={"x": [0.5, 0.0]},
    )  # fmt: skip
    assert found["x"][0] == pytest.approx(0.6, abs=1e-9)
    assert found["v"][0] == pytest.approx(0.4, abs=1e-9)


def test_a_start_that_violates_constraints_is_refused():
    system = pendulum_in_a_plane()
    system.initial_conditions = {"x": 0.3, "y": -1.0}
    with pytest.raises(ValueError, match=r"`constraint 0 of positions` is 0\.09"):
        system.optimize_trajectory(effort(system), 1.0)


def test_a_start_that_the_constraints_do_not_determine_is_refused():
    system = pendulum_in_a_plane()
    with pytest.raises(ValueError, match=r"`start` leaves out .*v\(t\), which the constraints do"):
        system.optimize_trajectory(effort(system), 1.0, start={"y": -1.0, "w": 0.0})


def test_methods_and_equations_that_do_not_take_constraints_are_told():
    system = pendulum_in_a_plane()
    with pytest.raises(NotImplementedError, match="`method` is 'midpoint', which does not treat"):
        OptimalControl(system, effort(system), 1.0, method="midpoint")


def test_a_constraint_that_a_control_moves_is_refused():
    x, y, v, w, F = me.dynamicsymbols("x y v w F")
    frame, origin = ground()
    bob = origin.locatenew("P", x * frame.x + y * frame.y)
    bob.set_vel(frame, v * frame.x + w * frame.y)
    bodies = [me.Particle("b", bob, 1)]
    made = Definition(frame, [x, y], [v, w], bodies=bodies, nonholonomic_constraints=[w - F * v])
    system = System(made)
    system.specifieds = {F.diff(): 0.0}
    with pytest.raises(NotImplementedError, match="The constraints hold a control"):
        OptimalControl(system, sm.Integral(F**2, T), 1.0)
