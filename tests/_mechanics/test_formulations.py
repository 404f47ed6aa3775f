"""Accelerations formed from bodies and loads, against SymPy's own equations in 30 digits."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from graphs import form
from oracles.oracle import oracle
from pydy._graph.linear_system import LinearSystem
from pydy._graph.lowering import lower
from pydy._mechanics.elimination import composite
from pydy._mechanics.formulations import forms, moving
from pydy._mechanics.inertia import loads_and_inertias
from pydy._mechanics.kane import multibody_of_kane
from pydy._program.interpret import run
from pydy.mechanics import Definition
from zoo import by_hand
from zoo.by_hand import MECHANISMS, derived, state

FORMS = {
    "articulated bodies in body axes": {"in_bodies": True, "articulated": True},
    "articulated bodies in the inertial frame": {"in_bodies": False, "articulated": True},
    "composite bodies in body axes": {"in_bodies": True, "articulated": False},
    "composite bodies in the inertial frame": {"in_bodies": False, "articulated": False},
}
# Loads with accelerations: M and F of the form are then not those of SymPy, whose F holds them.
MODELS = {**zoo.MODELS, **MECHANISMS}
del MODELS["added_mass"], MODELS["towed_sledge"]


def rates(model, way, *states):
    """The states' derivatives, from the interpreter and without any simplification."""
    formed = form(multibody_of_kane(model.kane), **FORMS[way])
    graph, dynamics = formed.graph, formed.dynamics
    accelerations = dynamics.accelerations
    if accelerations is None:
        accelerations = LinearSystem(graph, dynamics.matrix).solve(dynamics.forcing)
    nodes = [*formed.rates, *accelerations]
    sizes = (len(nodes), len(formed.specifieds), len(formed.constants))
    program = lower(graph, sizes, [("rates", (len(nodes),), nodes)])
    values = {**model.constants, **model.specifieds}
    r = [[values.get(s, np.nan) for s in formed.specifieds]]
    p = np.array([values[s] for s in formed.constants], dtype=float)
    found = []
    for x, t in states:
        out, failed = run(program, np.array([t]), x[None], np.array(r, dtype=float), p)
        assert not failed.any()
        found.append(out[0])
    assert len(dynamics.forcing) == len(model.kane.u)
    return found


def spun_rods():
    """Two rods with ball joints, one on what a hinge turns, on a support that turns as given."""
    q, u = me.dynamicsymbols("q:7"), me.dynamicsymbols("u:7")
    t, ground = me.dynamicsymbols._t, me.ReferenceFrame("N")
    above = ground.orientnew("T", "axis", (sm.sin(t), ground.z))
    joint = me.Point("O")
    joint.set_vel(ground, 0)
    bodies, rates = [], []
    for k in (0, 3):
        frame = me.ReferenceFrame(f"B{k}")
        frame.orient_body_fixed(above, q[k : k + 3], "123")
        rates += [frame.ang_vel_in(above).dot(a) - s for a, s in zip(frame, u[k:], strict=False)]
        frame.set_ang_vel(above, sum((s * a for s, a in zip(u[k:], frame, strict=False)), 0))
        centre = joint.locatenew(f"C{k}", frame.x / 3 - frame.z / 2)
        inertia = me.inertia(frame, 2, 3, 4, 0.1, 0.2, 0.3)
        bodies.append(me.RigidBody(f"b{k}", centre, frame, 2, (inertia, centre)))
        joint = joint.locatenew(f"P{k}", -frame.z)
        above = frame.orientnew("H", "axis", (q[6], frame.x)) if k == 0 else frame
        if k == 0:
            above.set_ang_vel(frame, u[6] * frame.x)
            wheel = (me.inertia(above, 1, 2, 3), joint)
            bodies.append(me.RigidBody("wheel", joint, above, 1, wheel))
    return Definition(
        frame=ground,
        coordinates=q,
        speeds=u,
        kinematic_equations=[*rates, q[6].diff() - u[6]],
        bodies=bodies,
        loads=[(body.masscenter, -9 * body.mass * ground.z) for body in bodies],
    )


@pytest.mark.parametrize("in_bodies", [True, False])
def test_accelerations_do_not_depend_on_what_is_known_of_them_beforehand(in_bodies):
    body = spun_rods().multibody
    kinematics = moving(body, in_bodies)
    matrix, forcing = composite(kinematics, *loads_and_inertias(kinematics))
    expected = at_random(
        kinematics.graph, LinearSystem(kinematics.graph, matrix, "ldl").solve(forcing)
    )
    composed, eliminated = forms(body, in_bodies=in_bodies).equations
    graph, whole = composed.graph, composed.dynamics
    assert sum(n != graph.zero for n in whole.start) == 6
    beyond = LinearSystem(graph, whole.matrix, "ldl").solve(whole.residual_forcing)
    for found in (
        [graph.add(*parts) for parts in zip(whole.start, beyond, strict=True)],
        LinearSystem(graph, whole.matrix, "ldl").solve(whole.forcing),
        eliminated.dynamics.accelerations,
    ):
        np.testing.assert_allclose(at_random(graph, found), expected, rtol=1e-10, atol=1e-12)


def at_random(graph, nodes):
    """Values at three states of seven coordinates and speeds."""
    program = lower(graph, (14, 0, 0), [("all", (len(nodes),), nodes)])
    x, t = np.random.default_rng(2).normal(size=(3, 14)), np.array([0.1, 0.4, 2.0])
    found, failed = run(program, t, x, np.zeros((3, 0)), np.zeros(0))
    assert not failed.any()
    return found


@pytest.mark.parametrize("way", FORMS)
@pytest.mark.parametrize("name", MODELS)
def test_the_accelerations_are_those_of_sympys_equations(name, way):
    model = MODELS[name]()
    samples = [state(model, seed) for seed in (1, 2)]
    found = rates(model, way, *samples)
    for own, (x, t) in zip(found, samples, strict=True):
        expected = oracle(derived(model)).xdot(x, t)
        np.testing.assert_allclose(own, expected, rtol=0, atol=1e-12 * abs(expected).max())


@pytest.mark.parametrize("way", FORMS)
def test_an_inertia_in_axes_that_turn_beside_the_body_changes_with_them(way):
    """A rotor without symmetry whose inertia is written in the axes of its housing: I' is not 0."""
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    frame, origin, g = me.ReferenceFrame("N"), me.Point("O"), sm.Symbol("g")
    origin.set_vel(frame, 0)
    yoke, housing, rotor = (me.ReferenceFrame(name) for name in ("Y", "H", "R"))
    for own, above, angle, rate, axis in (
        (yoke, frame, q[0], u[0], frame.z),
        (housing, yoke, q[1], u[1], yoke.x),
        (rotor, housing, q[2], u[2], housing.y),
    ):
        own.orient_axis(above, axis, angle)
        own.set_ang_vel(above, rate * axis)
    centre = origin.locatenew("C", -2 * housing.z)
    centre.v2pt_theory(origin, frame, housing)
    inertia = me.inertia(housing, 2, 3, 4, 0.3, 0.2, 0.5)
    body = me.RigidBody("rotor", centre, rotor, 2, (inertia, centre))
    kinematic = [a.diff(zoo.T) - b for a, b in zip(q, u, strict=True)]
    loads = [(centre, -2 * g * frame.z), (rotor, u[2] * rotor.x)]
    kane = me.KanesMethod(frame, q, u, kinematic, bodies=[body], forcelist=loads)
    model = zoo.Model(kane, {g: 9.8})
    x = np.array([0.3, -0.7, 1.1, 0.9, -1.3, 2.1])
    (found,) = rates(model, way, (x, 0.0))
    expected = oracle(derived(model)).xdot(x, 0.0)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * abs(expected).max())


def test_a_velocity_that_is_not_the_rate_of_its_place_is_the_users():
    model = by_hand.wheel()
    formulations = forms(multibody_of_kane(model.kane), in_bodies=True)
    assert [p.name for p in formulations.honoured] == ["C"]


@pytest.mark.parametrize("in_bodies", [True, False])
def test_points_reached_from_one_whose_velocity_is_given_move_with_it(in_bodies):
    q, v = me.dynamicsymbols("q:2"), me.dynamicsymbols("v:2")
    ground, arm = me.ReferenceFrame("N"), me.ReferenceFrame("A")
    arm.orient_axis(ground, q[0], ground.z)
    arm.set_ang_vel(ground, v[0] * ground.z)
    origin = me.Point("O")
    origin.set_vel(ground, 0)
    slipping = origin.locatenew("slipping", q[1] * arm.x)
    carried = slipping.locatenew("carried", 2 * arm.y)
    between = carried.locatenew("between", arm.x)
    held = between.locatenew("held", arm.x - arm.y)
    rate = v[1] * arm.x + q[1] * v[0] * arm.y
    slipping.set_vel(ground, rate + 3 * v[0] * arm.x)
    carried.set_vel(ground, rate + v[0] * arm.x)  # that of the slipping point, and 2 v0 less
    held.set_vel(ground, rate + v[0] * (arm.x + 2 * arm.y))  # that of its place, 3 v0 less
    bodies = [me.Particle(p.name, p, 1) for p in (slipping, carried, held)]
    model = Definition(
        frame=ground,
        coordinates=q,
        speeds=v,
        kinematic_equations=[a.diff() - b for a, b in zip(q, v, strict=True)],
        bodies=bodies,
    )
    formulations = forms(model.multibody, in_bodies=in_bodies)
    assert [p.name for p in formulations.honoured] == ["held", "slipping"]


def test_a_velocity_that_is_the_rate_of_its_place_is_replaced_by_it():
    model = by_hand.tilted_plates()
    assert forms(multibody_of_kane(model.kane), in_bodies=True).honoured == ()


def test_a_wheels_spin_angle_does_not_occur_in_its_equations():
    model = by_hand.wheel()
    formed = form(multibody_of_kane(model.kane), in_bodies=True, articulated=True)
    angle = formed.graph.input("x", 2)
    assert angle not in formed.graph.reachable(formed.dynamics.accelerations)


def test_a_frame_whose_angular_velocity_is_known_in_its_own_axes_needs_no_orientation():
    q, u = me.dynamicsymbols("q u")
    size, torque = sm.symbols("I tau")
    frame, own, point = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("P")
    own.set_ang_vel(frame, u * own.z)
    point.set_vel(frame, 0)
    body = me.RigidBody("b", point, own, 1, (me.inertia(own, 0, 0, size), point))
    kane = me.KanesMethod(
        frame,
        [q],
        [u],
        kd_eqs=[q.diff(zoo.T) - u],
        bodies=[body],
        forcelist=[(own, torque * own.z)],
    )
    model = zoo.Model(kane, {size: 2.0, torque: 3.0})
    (found,) = rates(model, "articulated bodies in body axes", (np.array([0.1, 0.2]), 0.0))
    np.testing.assert_allclose(found, [0.2, 1.5])
