"""Optimal motions of constrained systems against those in coordinates that need no constraints."""

from dataclasses import replace

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from oracles.optima import T
from pydy import System
from pydy._mechanics import extract
from pydy.analysis import Trial
from pydy.control import OptimalControl
from pydy.control.transcription import Transcription
from pydy.mechanics import Definition
from zoo import inertial_frame, joints

END = 1.2


def pendulum():
    """A bob of 1 kg at 1 m, pushed sideways, by its angle."""
    q, u, F = me.dynamicsymbols("q u F")
    frame, origin = inertial_frame()
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
    frame, origin = inertial_frame()
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
    solution = system.optimize_trajectory(effort(system), 1.5, end=end, order=4)
    assert solution.objective == pytest.approx(by_angle.objective, rel=1e-6)
    assert np.abs(solution["x"] ** 2 + solution["y"] ** 2 - 1.0).max() < 1e-9
    assert np.abs(solution["x"] * solution["v"] + solution["y"] * solution["w"]).max() < 1e-9
    nodes = by_angle.at(solution.mesh)
    np.testing.assert_allclose(solution.at(solution.mesh)["x"], np.sin(nodes["q"]), atol=1e-6)
    labels = [f"constraint {k} of {kind}" for kind in ("positions", "velocities") for k in (0,)]
    assert set(labels) <= solution.multipliers.keys()


def test_slack_velocities_vanish_with_the_errors():
    system, sizes = pendulum_in_a_plane(), []
    for mesh in (10, 20):
        solution = system.optimize_trajectory(
            effort(system), 1.5, end={"x": PLACE["x"], "v": 0.0}, mesh=mesh
        )
        slack = solution._transcription.split(solution.solution.z)[1][1]
        sizes.append(np.abs(slack).max())
    assert sizes[0] < 0.1
    assert sizes[1] < sizes[0] / 4


def vehicle(minimal):
    """A skate that is pushed along and turned: Chaplygin's sleigh with its mass over the blade."""
    x, y, angle, v, w, turn, push, torque = me.dynamicsymbols("x y angle v w turn push torque")
    frame, origin = inertial_frame()
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


@pytest.mark.parametrize(
    ("method", "mesh", "rel"),
    [("radau", 20, 1e-6), ("midpoint", 40, 1e-3), ("hermite-simpson", 40, 5e-6)],
)
def test_a_nonholonomic_vehicle(method, mesh, rel):
    end = {"x": 1.0, "y": 1.0, "angle": 0.0, "v": 0.0, "turn": 0.0}
    system, objective = vehicle(minimal=True)
    free = system.optimize_trajectory(objective, 2.0, end=end, order=4)
    system, objective = vehicle(minimal=False)
    times = np.linspace(0.0, 2.0, 41)
    guess = {name: free.at(times)[name] for name in ("x", "y", "angle")}
    bound = system.optimize_trajectory(
        objective, 2.0, end=end, order=4, guess=guess, method=method, mesh=mesh
    )
    assert bound.objective == pytest.approx(free.objective, rel=rel)
    sideways = bound["w"] * np.cos(bound["angle"]) - bound["v"] * np.sin(bound["angle"])
    assert np.abs(sideways[1:]).max() < 1e-9


def test_dependent_states_of_the_start_follow():
    system = pendulum_in_a_plane()
    solution = system.optimize_trajectory(
        effort(system), 1.0, start={"y": -0.8, "w": 0.3}, end={"x": 0.0, "v": 0.0},
        guess={"x": [0.5, 0.0]},
    )  # fmt: skip
    assert solution["x"][0] == pytest.approx(0.6, abs=1e-9)
    assert solution["v"][0] == pytest.approx(0.4, abs=1e-9)


def test_a_start_that_violates_constraints_is_refused():
    system = pendulum_in_a_plane()
    system.initial_conditions = {"x": 0.3, "y": -1.0}
    with pytest.raises(ValueError, match=r"`constraint 0 of positions` is 0\.09"):
        system.optimize_trajectory(effort(system), 1.0)


def test_a_start_that_the_constraints_do_not_determine_is_refused():
    system = pendulum_in_a_plane()
    with pytest.raises(ValueError, match=r"`start` leaves out .*v\(t\), which the constraints do"):
        system.optimize_trajectory(effort(system), 1.0, start={"y": -1.0, "w": 0.0})


def missed_by(system, found):
    """Return how far a simulation with the controls is from the nodes, at most."""
    system.specifieds, system.times, system.ode_solver = found.inputs(), found.mesh, "dop853"
    states = system.simulate(rtol=1e-10, atol=1e-10).states
    system.specifieds = {}
    return np.abs(states - found.at(found.mesh).states).max()


ORDERS = {"backward-euler": 1, "midpoint": 2, "hermite-simpson": 4}


@pytest.mark.parametrize("method", ORDERS)
@pytest.mark.parametrize("constraints", [1, 2])
def test_every_method_keeps_its_order(by_angle, method, constraints):
    system, wrong, missed = pendulum_in_a_plane(constraints), [], []
    for mesh in (20, 40):
        solution = system.optimize_trajectory(
            effort(system), 1.5, end={"x": PLACE["x"], "v": 0.0}, mesh=mesh, method=method
        )
        nodes = solution.at(solution.mesh)
        assert np.abs(nodes["x"] ** 2 + nodes["y"] ** 2 - 1.0).max() < 1e-9
        assert np.abs(nodes["x"] * nodes["v"] + nodes["y"] * nodes["w"]).max() < 1e-9
        wrong.append(abs(solution.objective - by_angle.objective))
        missed.append(missed_by(system, solution))
    for first, second in (wrong, missed):
        assert second < 1.1 * first / 2 ** ORDERS[method]
    assert missed[1] < {1: 0.6, 2: 7e-3, 4: 1e-5}[ORDERS[method]]


def test_the_first_multipliers_of_hermite_simpson_are_determined():
    """They would be free: the constraints hold at the start already."""
    system = pendulum_in_a_plane()
    solution = system.optimize_trajectory(
        effort(system), 1.5, end={"x": PLACE["x"], "v": 0.0}, method="hermite-simpson"
    )
    _, algebraic, _, _ = solution._transcription.split(solution.solution.z)
    force, slack, tension = algebraic[:, 0]
    assert slack == pytest.approx(0.0, abs=1e-9)
    assert abs(force) > 1.0  # across the rod that hangs, where it is no part of the tension
    assert tension == pytest.approx(-9.81 / 2, rel=1e-9)  # of the weight by 2 y
    assert solution.multipliers["motion of v"].shape == solution.collocation_times.shape == (41,)
    assert solution.multipliers["constraint 0 of velocities"].shape == (40,)
    with pytest.raises(NotImplementedError, match="has no costates of systems with constraints"):
        solution.costates


def test_costates_of_the_midpoint_rule_are_slopes_of_the_objective():
    system = pendulum_in_a_plane()

    def found(angle):
        system.initial_conditions = {"x": np.sin(angle), "y": -np.cos(angle)}
        return system.optimize_trajectory(
            effort(system), 1.5, end={"x": PLACE["x"], "v": 0.0}, method="midpoint"
        )

    slope = (found(1e-4).objective - found(-1e-4).objective) / 2e-4
    x = next(s for s in system.states if s.name == "x")
    assert found(0.0).costates[x][0] == pytest.approx(slope, rel=1e-7)
    assert np.isnan(found(0.0).objective_error).all()  # constraints hold at other points
    assert "±" not in repr(found(0.0))


def test_a_four_bar_by_every_method():
    """A torque turns the crank from rest to rest; the loop of three links and a base is closed."""
    model = joints.four_bar()
    torque, link = me.dynamicsymbols("T"), model.bodies[1].frame
    model.add_loads((link, torque * link.z))
    numbers = {"l1": 1.9, "l2": 0.8, "l3": 1.4, "l4": 1.3, "rho": 2.0, "g": 9.7}
    system = System(model)
    system.constants = {s: numbers[s.name] for s in system.constants_symbols}
    system.initial_conditions = {"q1": 1.2, "q2": -0.9, "q3": -1.4}
    system.set_dependent_initial_conditions()
    asked, objective = {"end": {"q1": 2.6, "u1": 0.0}}, effort(system)
    best = system.optimize_trajectory(objective, 0.8, order=6, mesh=12, **asked)
    for method, ratio in (("midpoint", 3.8), ("hermite-simpson", 13.0)):
        off, missed = [], []
        for mesh in (20, 40):
            solution = system.optimize_trajectory(objective, 0.8, mesh=mesh, method=method, **asked)
            assert len(solution.history) <= 8  # the links of its guess are closed
            off.append(abs(solution.objective / best.objective - 1.0))
            missed.append(missed_by(system, solution))
        assert off[1] < off[0] / ratio
        assert missed[1] < missed[0] / ratio


@pytest.mark.parametrize("method", ["midpoint", "hermite-simpson"])
def test_dependent_states_follow_and_phases_join_by_every_method(method):
    system = pendulum_in_a_plane()
    found = system.optimize_trajectory(
        effort(system), 1.0, start={"y": -0.8, "w": 0.3}, end={"x": 0.0, "v": 0.0},
        guess={"x": [0.5, 0.0]}, method=method,
    )  # fmt: skip
    assert found["x"][0] == pytest.approx(0.6, abs=1e-9)
    assert found["v"][0] == pytest.approx(0.4, abs=1e-9)
    ends = [{"x": 0.5}, {"x": PLACE["x"], "v": 0.0}]
    phases = [
        [OptimalControl(system, effort(system), 0.7, end=end, **how) for end in ends]
        for how in ({"order": 5}, {"method": method, "mesh": 40})
    ]
    best, found = (OptimalControl.phases(each).solve() for each in phases)
    assert found.objective == pytest.approx(best.objective, rel=1e-3)
    for phase in found:
        assert np.abs(phase["x"] ** 2 + phase["y"] ** 2 - 1.0)[[0, -1]].max() < 1e-9


def test_a_constraint_that_a_control_moves_is_refused():
    x, y, v, w, F = me.dynamicsymbols("x y v w F")
    frame, origin = inertial_frame()
    bob = origin.locatenew("P", x * frame.x + y * frame.y)
    bob.set_vel(frame, v * frame.x + w * frame.y)
    bodies = [me.Particle("b", bob, 1)]
    made = Definition(frame, [x, y], [v, w], bodies=bodies, nonholonomic_constraints=[w - F * v])
    system = System(made)
    system.specifieds = {F.diff(): 0.0}
    with pytest.raises(NotImplementedError, match="The constraints hold a control"):
        OptimalControl(system, sm.Integral(F**2, T), 1.0)


def guessed(system, problem, given=None):
    """Return the coordinates x and y of a guess at its nodes and points, and their times."""
    transcription = Transcription(problem._problem, problem._scheme, problem._mesh)
    states = transcription.split(problem._combined_program([problem._mesh], [given])[1])[0]
    rows = {s.name: row for s, row in zip(system.states, states, strict=True)}
    there = ~transcription.state_slots[1]
    return rows["x"][there], rows["y"][there], transcription.state_slots[0][there]


@pytest.mark.parametrize("method", ["radau", "midpoint", "hermite-simpson"])
def test_a_guess_follows_from_the_constraints(method):
    system = pendulum_in_a_plane()
    problem = OptimalControl(system, effort(system), 1.0, end={"x": 0.8}, method=method, mesh=12)
    x, y, times = guessed(system, problem)
    assert np.abs(x**2 + y**2 - 1.0).max() < 1e-4
    assert (y < 0.0).all()  # on the side on which it begins
    np.testing.assert_allclose(x, 0.8 * times, atol=1e-12)
    # What is given stays as it is.
    x, y, _ = guessed(system, problem, {"y": -0.5})
    assert set(y) == {-0.5, -1.0}


def test_dependent_coordinates_of_a_guess_follow_and_free_ones_keep_their_lines():
    x, y, z, F = me.dynamicsymbols("x y z F")
    frame, origin = inertial_frame()
    bodies, u = [], me.dynamicsymbols("u1:4")
    for name, q, axis in (("a", x, frame.x), ("b", y, frame.y), ("c", z, frame.z)):
        point = origin.locatenew(name, q * axis)
        bodies.append(me.Particle(name, point, 1))
    made = Definition(
        frame,
        [x, y, z],
        u,
        bodies=bodies,
        loads=[(bodies[0].point, F * frame.x)],
        holonomic_constraints=[sm.sin(x) - y - z],
        dependent_coordinates=[y],
    )
    system = System(made)
    problem = OptimalControl(system, effort(system), 1.0, end={"x": 1.0}, mesh=6)
    transcription = Transcription(problem._problem, problem._scheme, problem._mesh)
    states = transcription.split(problem._combined_program([problem._mesh], [None])[1])[0]
    rows = {
        s.name: row[~transcription.state_slots[1]]
        for s, row in zip(system.states, states, strict=True)
    }
    assert (rows["z"] == 0.0).all()
    np.testing.assert_allclose(rows["y"], np.sin(rows["x"]), atol=1e-5)


def test_a_guess_stays_on_the_branch_on_which_it_begins():
    """Of sin(b - 5 a) = 0, with branches b = 5 a + k pi, the one through the start is followed.

    b has the guess 0 everywhere: alone, each slot would find the branch that is nearest to that.
    """
    a, b, F = me.dynamicsymbols("a b F")
    frame, origin = inertial_frame()
    points = origin.locatenew("A", a * frame.x), origin.locatenew("B", b * frame.y)
    made = Definition(
        frame,
        [a, b],
        bodies=[me.Particle(point.name, point, 1) for point in points],
        loads=[(points[0], F * frame.x)],
        holonomic_constraints=[sm.sin(b - 5 * a)],
    )
    system = System(made)
    problem = OptimalControl(system, effort(system), 1.0, end={"a": 1.0}, mesh=12)
    transcription = Transcription(problem._problem, problem._scheme, problem._mesh)
    states = transcription.split(problem._combined_program([problem._mesh], [None])[1])[0]
    there = ~transcription.state_slots[1]
    np.testing.assert_allclose(states[0][there], transcription.state_slots[0][there], atol=1e-12)
    np.testing.assert_allclose(states[1][there], 5.0 * states[0][there], atol=1e-3)


def test_a_guess_that_no_configuration_has_stays():
    system = pendulum_in_a_plane()
    problem = OptimalControl(system, effort(system), 1.0, end={"x": 1.2}, mesh=12)
    x, y, times = guessed(system, problem)
    near = x < 0.99
    assert np.abs((x**2 + y**2 - 1.0)[near]).max() < 1e-4
    np.testing.assert_allclose(x, 1.2 * times, atol=1e-12)
    assert (y[x > 1.01] == -1.0).all()


def test_a_swing_up_in_cartesian_coordinates_by_every_method():
    system = pendulum()
    best = system.optimize_trajectory(
        effort(system), 2.0, end={"q": np.pi, "u": 0.0}, mesh=40, order=4
    )
    along = best.at(np.linspace(0.0, 2.0, num=81))
    c, s, u = np.cos(along["q"]), np.sin(along["q"]), along["u"]
    guess = {"x": s, "y": -c, "v": u * c, "w": u * s, "F": along["F"]}
    end = {"x": 0.0, "y": 1.0, "v": 0.0, "w": 0.0}
    system = pendulum_in_a_plane()
    for method, off in (("radau", 2e-5), ("hermite-simpson", 2e-4), ("midpoint", 3e-2)):
        solution = system.optimize_trajectory(
            effort(system), 2.0, end=end, mesh=40, method=method, guess=guess
        )
        assert solution.objective == pytest.approx(best.objective, rel=off)
        np.testing.assert_allclose(
            solution.at(solution.mesh)["x"], np.sin(best.at(solution.mesh)["q"]), atol=10 * off
        )


def rod_of_cosines(**options):
    """A point on a circle by its direction (c, s), whose length the kinematics keep."""
    c, s, w, F = me.dynamicsymbols("c s w F")
    frame, origin = inertial_frame()
    place = origin.locatenew("P", c * frame.x + s * frame.y)
    along = -s * frame.x + c * frame.y
    place.set_vel(frame, w * along)
    definition = Definition(
        frame, [c, s], [w], bodies=[me.Particle("P", place, 1)], loads=[(place, F * along)],
        kinematic_equations=[c.diff() + s * w, s.diff() - c * w],
        holonomic_constraints=[c**2 + s**2 - 1], dependent_coordinates=[s],
    )  # fmt: skip
    effort, end = sm.Integral(F**2, T), {c: 0.6, w: 0}
    return OptimalControl(System(definition), effort, 1.0, end=end, mesh=8, **options)


def test_what_the_motion_keeps_by_itself_holds_at_the_start():
    solution = rod_of_cosines(start={"c": 0.8, "s": 0.6, "w": 0}).solve()
    turned = np.arccos(0.6) - np.arccos(0.8)
    assert solution.objective == pytest.approx(12 * turned**2, rel=1e-6)
    with pytest.raises(
        ValueError, match=r"does not satisfy the constraints: constraint 0 .* -0.11"
    ):
        rod_of_cosines(start={"c": 0.8, "s": 0.5, "w": 0}).check()
    with pytest.raises(ValueError, match=r"`start` leaves out s\(t\), but what would give them"):
        rod_of_cosines(start={"c": 0.8, "w": 0}).check()


@pytest.mark.parametrize("method", ["radau", "hermite-simpson", "midpoint"])
def test_units_of_lengths_beside_angles_do_not_change_the_search(method):
    """A slider-crank: what slack velocities move is shared by angles and the slider's place."""
    found = []
    for unit, mass, second in ((1, 1, 1), (1e-9, 1e9, 1), (1e9, 1e-9, 1), (1e9, 1, 1e6)):
        a, b, c, u, w, z, torque = me.dynamicsymbols("a b c u w z torque")
        frame, origin = inertial_frame()
        crank, rod = me.ReferenceFrame("A"), me.ReferenceFrame("B")
        for body, angle, speed in ((crank, a, u), (rod, b, w)):
            body.orient_axis(frame, angle, frame.z)
            body.set_ang_vel(frame, speed * frame.z)
        pin = origin.locatenew("P", unit * crank.x)
        pin.set_vel(frame, u * unit * crank.y)
        slider = origin.locatenew("S", c * frame.x)
        slider.set_vel(frame, z * frame.x)
        bodies = [me.Particle("p", pin, mass), me.Particle("s", slider, 2 * mass)]
        loop = pin.pos_from(origin) + 3 * unit * rod.x - c * frame.x
        definition = Definition(
            frame, [a, b, c], [u, w, z], bodies=bodies, loads=[(crank, torque * frame.z)],
            holonomic_constraints=[loop.dot(frame.x), loop.dot(frame.y)],
        )  # fmt: skip
        system = System(definition, initial_conditions={a: 0.0, b: 0.0, c: 4 * unit})
        ends = {"end": {a: np.pi, u: 0.0}, "method": method}
        found.append(system.optimize_trajectory(effort(system), 2.0 * second, **ends))
        again = system.optimize_trajectory(
            effort(system), 2.0 * second, guess=found[-1], mesh=found[-1].mesh, **ends
        )
        assert len(again.history) <= 3  # the guess's equations are taken over
        assert again.objective == pytest.approx(found[-1].objective, rel=1e-8)
        size = mass**2 * unit**4 / second**3
        assert found[-1].objective / size == pytest.approx(found[0].objective, rel=1e-8)
        assert found[-1].error == pytest.approx(found[0].error, rel=1e-3)
    assert len({len(one.history) for one in found}) == 1


class WithoutBodies:
    """A method of mechanics that knows its equations alone, as a reader of a user's may."""

    def __init__(self, method):
        self.method = method


@extract.register
def _(method: WithoutBodies, source=None, implicit=None):
    equations = extract(method.method, "method", None)
    return replace(equations, multibody=None, mechanism=None)


def test_constraints_of_equations_without_bodies_are_refused_by_both_users_of_collocation():
    x, y, u, v = me.dynamicsymbols("x y u v")
    g = sm.Symbol("g")
    frame, origin = inertial_frame()
    bob = origin.locatenew("P", x * frame.x + y * frame.y)
    bob.set_vel(frame, u * frame.x + v * frame.y)
    method = me.KanesMethod(
        frame, [x], [u], [x.diff() - u, y.diff() - v], q_dependent=[y],
        configuration_constraints=[x**2 + y**2 - 1], u_dependent=[v],
        velocity_constraints=[2 * x * u + 2 * y * v],
    )  # fmt: skip
    method.kanes_equations([me.Particle("bob", bob, 1)], [(bob, -g * frame.y)])
    system = System(WithoutBodies(method), constants={g: 9.81}, ode_solver="dop853")
    system.initial_conditions, system.times = {x: 0.6, y: -0.8}, np.linspace(0.0, 1.0, num=21)
    motion = system.simulate()
    remedy = "needs the bodies and loads: give them to the method"
    with pytest.raises(NotImplementedError, match=remedy):
        system.fit([g], Trial(motion.times, {x: motion[x]}), method="collocation")
    with pytest.raises(NotImplementedError, match=remedy):
        system.optimize_trajectory(sm.Integral(u**2, me.dynamicsymbols._t), 1.0)
