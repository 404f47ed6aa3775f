"""Hinges at angles, in axes that are chosen for them."""

import sys
from pathlib import Path

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from graphs import form

sys.path.append(str(Path(__file__).parents[2] / "benchmarks"))

from trees import definition, tree

from pydy._assembly.programs import block_program
from pydy._graph.linear_system import LinearSystem
from pydy._graph.lowering import lower
from pydy._mechanics.formulations import moving
from pydy._program.interpret import run
from pydy.mechanics import Definition
from pydy.system import System
from zoo import inertial_frame


def accelerations_at(formed, x, values):
    """u' in one form, with constants by name."""
    graph, dynamics = formed.graph, formed.dynamics
    solved = dynamics.accelerations
    if solved is None:
        solved = LinearSystem(graph, dynamics.matrix, "ldl").solve(dynamics.forcing)
    sizes = (len(x), 0, len(formed.constants))
    program = lower(graph, sizes, [("accelerations", (len(solved),), solved)])
    p = np.array([values[s.name] for s in formed.constants])
    found, failed = run(program, np.zeros(1), x[None], np.zeros((1, 0)), p)
    assert not failed.any()
    return found[0]


def accelerations(body, **way):
    """u' in one form, at two states with constants of their own."""
    formed = form(body, **way)
    of_unit_norm = [k for k, q in enumerate(body.coordinates) if q.name.startswith("e")]
    both = []
    for seed in (1, 2):
        rng = np.random.default_rng(seed)
        values = {s.name: rng.uniform(0.5, 1.5) for s in sorted(formed.constants, key=str)}
        x = rng.normal(size=len(body.coordinates) + len(body.speeds))
        x[of_unit_norm] /= np.linalg.norm(x[of_unit_norm]) if of_unit_norm else 1.0
        both.append(accelerations_at(formed, x, values))
    return both


def check(source):
    """Compare with vectors in the inertial frame; return the kinematics in body axes."""
    body = System(source)._equations.multibody
    expected = accelerations(body, in_bodies=False, articulated=False)
    for articulated in (True, False):
        both = accelerations(body, in_bodies=True, articulated=articulated)
        for found, right in zip(both, expected, strict=True):
            np.testing.assert_allclose(found, right, rtol=0, atol=1e-12 * abs(right).max())
    return moving(body, in_bodies=True, gravity_as_acceleration=True)


def chain(joints, *, set_velocities=False, last=None, plain=False):
    """Bodies on hinges.

    Each joint is given by the rotations, (axis, angle) each, of a frame fixed in the body before,
    and by the hinge's axis there. In a plain one bodies are described in their own axes alone, so
    that they may be referred to other points of their hinges.
    """
    ground, origin = inertial_frame()
    n = len(joints)
    q, u = list(me.dynamicsymbols(f"q:{n}")), list(me.dynamicsymbols(f"u:{n}"))
    above, joint, bodies, loads = ground, origin, [], []
    for k, (rotations, axis) in enumerate(joints):
        base = fixed = above
        for j, (about, angle) in enumerate(rotations):
            other = me.ReferenceFrame(f"F{k}{j}")
            other.orient_axis(fixed, getattr(fixed, about), angle)
            fixed = other
        own = me.ReferenceFrame(f"B{k}")
        if last is not None and k == n - 1:
            last(fixed, own, q[k], u[k])
        else:
            direction = sum((c * e for c, e in zip(axis, fixed, strict=True)), me.Vector(0))
            own.orient_axis(fixed, direction, q[k])
            own.set_ang_vel(fixed, u[k] * direction.normalize())
        end = joint.locatenew(f"P{k}", 0.3 * above.x + sm.Symbol("l") * above.y - 0.2 * above.z)
        aside = own if plain else fixed
        centre = end.locatenew(f"C{k}", 0.1 * own.x + 0.2 * aside.y - sm.Symbol("c") * own.z)
        if set_velocities:
            end.v2pt_theory(joint, ground, base)
            end_to = end.locatenew(f"D{k}", 0.1 * own.x - sm.Symbol("c") * own.z)
            end_to.v2pt_theory(end, ground, own)
            centre = end_to
        size = me.inertia(own, 2.0, 2.5, 3.0, 0.1, 0.2, sm.Symbol("I"))
        bodies.append(me.RigidBody(f"b{k}", centre, own, 1.0 + k, (size, centre)))
        loads += [(centre, -(1.0 + k) * 9.81 * ground.z), (own, 0.3 * fixed.x)]
        above, joint = own, end
    loads = loads[::2] if plain else loads
    rates = [a.diff() - b for a, b in zip(q, u, strict=True)]
    return Definition(ground, q, u, bodies=bodies, loads=loads, kinematic_equations=rates)


SKEW = [([("z", 0.4), ("x", -1.1)], (0, 0, 1)), ([("x", 0.7)], (0, 1, 0)), ([], (1, 2, 3))]


@pytest.mark.parametrize(
    "joints",
    [
        SKEW,
        [([], (0, 0, 1)), ([], (0, 0, -1)), ([("y", sm.pi / 2)], (0, 0, 1)), ([], (-1, 1, 0))],
        [([("x", sm.pi / 2)], (0, 0, 1)), ([("x", -sm.pi / 2)], (0, 0, 1))] * 2,
        [([], (0, 1, 0)), ([("y", sm.Symbol("tilt"))], (0, 0, 1)), ([("z", 0.2)], (0, 1, 0))],
        [([("x", sm.Symbol("b"))], (1, 0, 0)), ([("x", sm.Symbol("b"))], (0, 0, 1))] * 2,
        [([], (0, 1, 0)), ([("y", sm.Symbol("b")), ("x", 0.3)], (0, 1, 0)), *SKEW],
    ],
    ids=["skew", "opposite", "right angles", "tilted", "symbols", "both"],
)
def test_hinges_at_angles_give_the_accelerations_of_the_inertial_frame(joints):
    assert not check(chain(joints)).honoured


def test_points_of_hinges_at_angles_may_have_velocities():
    joints = [([], (0, 1, 0)), ([("y", sm.Symbol("b")), ("x", 0.3)], (0, 1, 0)), *SKEW]
    assert not check(chain(joints, set_velocities=True)).honoured


@pytest.mark.parametrize("floating", [False, True])
def test_branches_about_any_axes_give_the_accelerations_of_the_inertial_frame(floating):
    rng = np.random.default_rng(5)
    check(definition(tree([-1, 0, 0, 1, 1, 2, 2], rng, floating=floating)))


def test_a_joint_that_is_no_hinge_may_be_behind_turned_axes():
    def gimbal(fixed, own, q, u):
        """Two angles that move together: no axis is left in place."""
        own.orient_body_fixed(fixed, (q, 2 * q, 0), "123")
        own.set_ang_vel(fixed, u * (sm.cos(2 * q) * own.x + 2 * own.y + sm.sin(2 * q) * own.z))

    check(chain([*SKEW, ([("y", 0.3)], None)], last=gimbal))


def test_between_two_hinges_there_is_one_constant_rotation_in_a_plane():
    kinematics = check(chain([*SKEW, *SKEW[1:]]))
    frames, g = kinematics.frames, kinematics.graph
    hinged = [axes for axes in frames.turns if not frames.is_fixed(axes)]
    assert len(hinged) == 5
    for axes in frames.above:
        (row,) = [row for row in frames.steps[axes] if g.one in row]
        assert row.count(g.zero) == 2
    for axes in hinged[1:]:
        fixed = frames.parent(axes)
        assert not frames.is_fixed(fixed) or frames.parent(fixed) in hinged


def test_a_constant_rotation_about_the_hinge_is_added_to_its_angle():
    tilt = sm.Symbol("tilt")
    kinematics = check(chain([([], (0, 1, 0)), ([("y", tilt)], (0, 0, 1))]))
    g = kinematics.graph
    q, angle = g.input("x", 0), kinematics.read(tilt)
    assert not any(kinematics.frames.is_fixed(axes) for axes in kinematics.frames.turns)
    assert ("cos", (g.add(q, angle),)) in zip(g.ops, g.args, strict=True)


def test_hinges_along_axes_leave_the_users_frames_alone():
    kinematics = check(definition(tree([-1, 0, 1], np.random.default_rng(3), aligned=True)))
    assert not kinematics.frames.above
    assert not kinematics.frames.written


def test_an_arm_about_any_axes_costs_no_more_operations_than_it_did():
    source = definition(tree(list(range(-1, 6)), np.random.default_rng(3)))
    program = block_program(System(source).model.assembly, "rates")
    assert sum(program.operation_count["run"].values()) <= 2296


def check_system(source, values):
    """Compare a System's accelerations with those in the inertial frame, for some values each."""
    system = System(source)
    formed = form(system._equations.multibody, in_bodies=False, articulated=False)
    for numbers in values:
        check_numbers(system, formed, numbers)


def check_numbers(system, formed, values):
    system.constants = values
    x = np.random.default_rng(3).normal(size=len(system.states))
    found = system.evaluate_ode(x)[len(system.coordinates) :]
    expected = accelerations_at(formed, x, values)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-11 * abs(expected).max())


# Nearly parallel hinges as files of robots have them, whose right angles have twelve digits.
@pytest.mark.parametrize("bend", [4.9e-12, 2.1e-13, 3e-9, 1e-5])
def test_hinges_that_are_nearly_parallel_keep_their_joints_within_reach(bend):
    # The other point of such an axis, from which two components lead on, lay 1e11 lengths away.
    def about_x(angle):
        return [("x", sm.Float(angle))]

    values = {"l": 0.7, "c": 0.3, "I": 0.2}
    legs = [([], "001"), (about_x(np.pi / 2 + bend), "001"), (about_x(np.pi + 3 * bend), "001")]
    for joints in (legs, [([], "001"), (about_x(bend), "001"), ([("y", sm.Float(bend))], "001")]):
        made = [(turns, tuple(map(int, axis))) for turns, axis in joints]
        check_system(chain(made, plain=True), [values])


def test_constant_angles_may_have_any_value():
    # Where hinges are parallel for some values of constants, nothing is divided by their angle.
    a, b = sm.symbols("a b")
    turns = [[], [("x", a)], [("y", b)], [("x", a), ("z", b)]]
    twists, bends = [0.0, 1e-300, 1e-12, 0.3, np.pi / 2, np.pi], [0.0, 1e-12, 0.4]
    others = {"l": 0.7, "c": 0.3, "I": 0.2}
    values = [{"a": twist, "b": bend, **others} for twist in twists for bend in bends]
    check_system(chain([(turn, (0, 0, 1)) for turn in turns], plain=True), values)
