"""Multipliers and reactions in all places where expressions are taken."""

import copy
import pickle

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy import viz
from pydy.solvers import Event
from pydy.system import System
from zoo import T, inertial_frame
from zoo.by_hand import MECHANISMS
from zoo.cases import close, system_of

GENERATORS = ["llvm", "lambdify"]
LAMBDA = sm.Symbol("lambda0")


def string_pendulum(**options):
    """A bob on a string of length 2 that holds no push, and its tension as an output."""
    x, y, u, v = me.dynamicsymbols("x y u v")
    m, g = sm.symbols("m g")
    frame, origin = inertial_frame()
    point = origin.locatenew("P", x * frame.x + y * frame.y)
    kane = me.KanesMethod(
        frame,
        [x],
        [u],
        kd_eqs=[x.diff(T) - u, y.diff(T) - v],
        q_dependent=[y],
        u_dependent=[v],
        configuration_constraints=[sm.sqrt(x**2 + y**2) - 2],
        velocity_constraints=[x * u + y * v],
        bodies=[me.Particle("bob", point, m)],
        forcelist=[(point, -m * g * frame.y)],
    )
    system = System(kane, {m: 1.5, g: 10.0}, **options)
    system.outputs = {"tension": -system.constraint_forces["lambda0"]}
    # Below u² = 5 g l the string slackens on the way up.
    system.initial_conditions = {x: 0.0, y: -2.0, u: np.sqrt(3.5 * 10.0 * 2.0)}
    system.times = np.linspace(0.0, 1.0, 201)
    return system


@pytest.mark.parametrize("generator", GENERATORS)
def test_a_tension_is_an_output_of_every_generator(generator):
    system = string_pendulum()
    system.generate_ode_function(generator=generator)
    xdot, outputs = system.evaluate_ode_function(system_state(system), 0.0, np.array([10.0, 1.5]))
    close(outputs[0], 1.5 * (10.0 + 70.0 / 2.0))
    assert len(xdot) == 4


def system_state(system):
    return np.array([system.initial_conditions.get(s, 0.0) for s in system.states])


def test_a_tension_is_computed_from_the_accelerations_of_a_solver_of_the_users():
    system = string_pendulum()
    system.generate_ode_function(linear_sys_solver="numpy")
    close(system.evaluate_outputs()[0], 1.5 * (10.0 + 70.0 / 2.0))


def test_all_multipliers_are_outputs_in_one_line():
    system = system_of(zoo.fourbar())
    system.outputs = system.constraint_forces
    assert [str(s) for s in system.outputs_symbols[:2]] == ["lambda0", "lambda1"]


def test_an_event_finds_where_a_string_slackens():
    system = string_pendulum(ode_solver="dop853")
    slack = Event(-system.constraint_forces["lambda0"], direction=-1, terminal=True, name="slack")
    trajectory = system.simulate(events=[slack], constraints="project", rtol=1e-11, atol=1e-11)
    (event,) = trajectory.events
    # There gravity alone turns the velocity: v² = g y, with v² = 70 - 2 g (y + l).
    close(event.before[1], (70.0 - 40.0) / 30.0, 1e-8)


def test_tensions_are_in_trajectories_datasets_and_ensembles():
    system = string_pendulum(ode_solver="dop853")
    trajectory = system.simulate(constraints="project")
    expected = 1.5 * ((trajectory.states[:, 2:] ** 2).sum(axis=1) - 10 * trajectory["y"]) / 2.0
    close(trajectory["tension"], expected, 1e-8)
    close(trajectory.to_xarray()["tension"], expected, 1e-8)
    many = system.integrate_ensemble(constants={"m": [1.5, 3.0]}, times=[0.0, 0.1])
    close(many["tension"].values[1], 2.0 * many["tension"].values[0], 1e-6)


def test_a_reaction_is_an_arrow_and_a_series_of_a_scene(tmp_path):
    system = string_pendulum()
    (bob,) = system.eom_method.bodies
    pull = system.reaction(bob, bob.masscenter)
    scene = system.scene(
        viz.Visual(viz.Arrow(pull.force, scale=0.01), bob),
        series={"tension": pull.force.magnitude()},
    )
    scene.animate([0.0], [system_state(system)])
    page = tmp_path / "string.html"
    scene.to_html(page)
    assert "tension" in page.read_text(encoding="utf-8")


def test_derivatives_go_through_forces():
    system = string_pendulum()
    gradient = system.evaluate_jacobian(of="outputs", wrt="constants")
    close(gradient[0], [1.5, 10.0 + 70.0 / 2.0], 1e-9)  # by g and by m


def test_specifieds_that_are_expressions_reach_the_forces():
    model = zoo.shaken()
    system = system_of(model, specifieds={})
    (bob,) = model.kane.bodies
    system.outputs = system.reaction(bob, bob.masscenter).outputs("rod")
    x, t = model.sample()
    lift = next(s for s in system.specifieds_symbols if not isinstance(s, sm.Derivative))
    numbers = system.evaluate_outputs(x, t, r={lift: 0.2, lift.diff(T): 0.6, lift.diff(T, 2): 1.2})
    system.specifieds = {lift: T**3 * 0.2}
    system.evaluate_outputs(x, 1.0)
    close(system.evaluate_outputs(x, 1.0), numbers, 1e-12)


@pytest.mark.parametrize("how", [copy.deepcopy, lambda s: pickle.loads(pickle.dumps(s))])
def test_a_copy_has_the_same_forces(how):
    system = string_pendulum()
    other = how(system)
    close(other.evaluate_outputs(), system.evaluate_outputs())
    other.outputs = other.constraint_forces
    close(-other.evaluate_outputs()[0], system.evaluate_outputs()[0])


def test_a_multiplier_is_found_by_its_name():
    forces = string_pendulum().constraint_forces
    assert forces["lambda0"] is forces[LAMBDA]
    assert str(-forces["lambda0"]) == "-lambda0"
    with pytest.raises(KeyError, match=r"no multiplier 'lambda7'; it has lambda0"):
        forces["lambda7"]


def test_a_symbol_that_prints_like_a_multiplier_is_not_a_constant():
    system = string_pendulum(ode_solver="dop853")
    slack = Event(-LAMBDA)
    with pytest.raises(ValueError, match=r"write `system.constraint_forces\['lambda0'\]`"):
        system.simulate(events=[slack])
    system.outputs = system.constraint_forces | {"double": 2 * LAMBDA}  # of the output's name
    np.testing.assert_allclose(system.evaluate_outputs()[1], -2 * 1.5 * (10.0 + 70.0 / 2.0))
    with pytest.raises(ValueError, match="not the multiplier of that name"):
        system.outputs = {"tension": -LAMBDA}


def test_a_constant_of_the_equations_may_have_a_multipliers_name():
    system = string_pendulum()
    speed = system.speeds[0]
    named = System(system.eom_method, {LAMBDA: 3.0}, constants_symbols=["m", "g", LAMBDA])
    named.outputs = {"momentum": LAMBDA * speed}
    close(named.evaluate_outputs([0.0, -2.0, 2.0, 0.0])[0], 6.0)


def test_a_system_without_constraints_has_no_multipliers():
    system = system_of(zoo.pendulum())
    assert system.constraint_forces == {}
    with pytest.raises(KeyError, match="it has none"):
        system.constraint_forces["lambda0"]


def test_the_outputs_of_a_reaction_are_named_after_it():
    system = string_pendulum()
    (bob,) = system.eom_method.bodies
    names = [str(s) for s in system.reaction(bob, bob.masscenter).outputs("string")]
    assert names == [f"string_{part}{axis}" for part in "FT" for axis in "xyz"]
    with pytest.raises(TypeError, match="`name` must be a string that is not empty, got ''"):
        system.reaction(bob, bob.masscenter).outputs("")


def test_a_frame_turns_the_components():
    model = zoo.free_pendulum()
    system = system_of(model)
    bob = model.kane.bodies[-1]
    turned = me.ReferenceFrame("A")
    turned.orient_axis(model.kane._inertial, model.kane._inertial.z, sm.pi / 2)
    joint = model.kane.bodies[-2].masscenter
    system.outputs = {
        **system.reaction(bob, joint).outputs("a"),
        **system.reaction(bob, joint, frame=turned).outputs("b"),
    }
    x, t = model.sample()
    a, b = system.evaluate_outputs(x, t).reshape(2, 6)
    close(b[:3], [a[1], -a[0], 0.0], 1e-12)


def test_a_load_at_a_hinge_counts_when_the_hinge_is_listed():
    model = MECHANISMS["tilted_plates"].__wrapped__()
    first, second = model.kane.bodies
    push = sm.Symbol("push")
    frame = model.kane._inertial
    hinge = next(p for p in second.masscenter._pos_dict if p.name == "H")
    load = (hinge, push * frame.y)
    kane = me.KanesMethod(
        frame,
        list(model.kane.q),
        list(model.kane.u),
        kd_eqs=[a.diff(T) - b for a, b in zip(model.kane.q, model.kane.u, strict=True)],
        bodies=[first, second],
        forcelist=[*model.kane.loads, load],
    )
    system = System(kane)
    outside, inside = (system.reaction(b, hinge) for b in (second, [second, hinge]))
    system.outputs = {**outside.outputs("a"), **inside.outputs("b")}
    x, t = model.sample()
    a, b = system.evaluate_outputs(x, t, p={"push": 5.0}).reshape(2, 6)
    close(a - b, [0.0, 5.0, 0.0, 0.0, 0.0, 0.0], 1e-12)


BAD = [
    ({"bodies": "nobody"}, ValueError, "`bodies` has 'nobody', which is not one of the system's"),
    ({"bodies": 3}, TypeError, "`bodies` must be a RigidBody or Particle, its name, or a list"),
    ({"bodies": []}, ValueError, "`bodies` must hold one body of the system or more: bob"),
    ({"point": "P"}, TypeError, "`point` must be a Point, got the str 'P'"),
    ({"point": me.Point("far")}, ValueError, r"`point` is far, but the position of P from there"),
    ({"frame": 1}, TypeError, "`frame` must be a ReferenceFrame, got the int 1"),
    ({"loads": 1}, TypeError, "`loads` must be a sequence of loads, got 1"),
    ({"loads": [(me.Point("far"), me.ReferenceFrame("N").x)]}, ValueError, "position of far"),
    ({"loads": [(me.Point("Q"), 3)]}, TypeError, r"The load at Q must be a Vector"),
]


@pytest.mark.parametrize(("change", "kind", "message"), BAD)
def test_arguments_that_do_not_fit_are_named(change, kind, message):
    system = string_pendulum()
    (bob,) = system.eom_method.bodies
    given = {"bodies": bob, "point": bob.masscenter, **change}
    with pytest.raises(kind, match=message):
        system.reaction(given.pop("bodies"), given.pop("point"), **given)


def test_without_bodies_the_remedy_is_said():
    theta = me.dynamicsymbols("theta")
    system = System(me.LagrangesMethod(theta.diff(T) ** 2 / 2, [theta]))
    remedy = r"Give a `pydy.mechanics.Definition` or a KanesMethod with `bodies` and all loads"
    with pytest.raises(ValueError, match=f"a Lagrangian does not tell .* {remedy}"):
        system.reaction("bob", me.Point("P"))


def arm():
    """Two plates on pin joints that are not parallel, with a motor in the second joint."""
    q, u = me.dynamicsymbols("q1:3"), me.dynamicsymbols("u1:3")
    ground = me.RigidBody("ground")
    bodies = [me.RigidBody(name) for name in ("upper", "lower")]
    system = me.System.from_newtonian(ground)
    pins = [
        me.PinJoint(
            name, parent, child, q[k], u[k], joint_axis=axis(parent),
            parent_point=(1 if k else 0) * parent.x, child_point=-child.x,
        )
        for k, (name, parent, child, axis) in enumerate(
            [
                ("shoulder", ground, bodies[0], lambda b: b.y),
                ("elbow", bodies[0], bodies[1], lambda b: b.z),
            ]
        )
    ]  # fmt: skip
    system.add_joints(*pins)
    motor = me.TorqueActuator(
        sm.Symbol("tau"), pins[1].joint_axis, bodies[1].frame, bodies[0].frame
    )
    system.add_actuators(motor)
    system.apply_uniform_gravity(-sm.Symbol("g") * ground.z)
    return system, pins


def test_a_joint_stands_for_all_beyond_it():
    multibody, (shoulder, elbow) = arm()
    system = System(multibody)
    upper, lower = multibody.bodies[1:] if len(multibody.bodies) == 3 else multibody.bodies
    system.outputs = {
        **system.reaction("shoulder").outputs("a"),
        **system.reaction([upper, lower], shoulder.child_point).outputs("b"),
        **system.reaction(elbow, frame=lower.frame).outputs("c"),
        **system.reaction(lower, elbow.child_point, frame=lower.frame).outputs("d"),
    }
    a, b, c, d = system.evaluate_outputs([0.3, 0.5, 0.7, -0.4]).reshape(4, 6)
    close(a, b, 1e-12)
    close(c, d, 1e-12)
    close([a[4], c[5]], [0.0, 0.0], 1e-12)  # a pin holds no torque about its axis


def test_a_joint_of_another_system_is_refused():
    (system, _), (_, (other, _)) = arm(), arm()
    with pytest.raises(ValueError, match=r"joint shoulder is not one of the joints of .*elbow"):
        System(system).reaction(other)


def test_bodies_need_a_point():
    system = string_pendulum()
    with pytest.raises(TypeError, match="`point` must be a Point, got the NoneType None"):
        system.reaction("bob")
