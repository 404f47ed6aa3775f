"""Regressors and base parameters: forces are linear in masses, moments and inertias."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy import System
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from zoo import inertial_frame
from zoo.cases import system_of


def spatial_arm(lift=0.0):
    """Two bodies on hinges that are not parallel, with products of inertia, and a spring.

    With a `lift`, this share of the hand's weight is compensated, and the frame is returned too.
    """
    q, u = me.dynamicsymbols("q1:3"), me.dynamicsymbols("u1:3")
    frame, origin = inertial_frame()
    one = frame.orientnew("A", "Axis", (q[0], frame.z))
    two = one.orientnew("B", "Axis", (q[1], one.x))
    first = origin.locatenew("C1", 0.3 * one.x + 0.1 * one.y)
    elbow = origin.locatenew("E", 0.7 * one.x + 0.2 * one.z)
    second = elbow.locatenew("C2", 0.4 * two.y + 0.1 * two.z)
    bodies = [
        me.RigidBody(
            "arm", first, one, 2.0, (me.inertia(one, 0.3, 0.4, 0.5, 0.01, 0.02, 0.03), first)
        ),
        me.RigidBody(
            "hand", second, two, 1.5, (me.inertia(two, 0.2, 0.1, 0.3, 0.02, 0.01, 0), second)
        ),
    ]
    loads = [
        (b.masscenter, -9.81 * (1 - share) * b.mass * frame.y)
        for b, share in zip(bodies, (0.0, lift), strict=True)
    ]
    loads.append((two, -3.0 * q[1] * two.x))
    system = System(Definition(frame, q, u, bodies=bodies, loads=loads))
    return (system, frame) if lift else system


def test_forces_are_the_regressor_times_the_parameters():
    system = spatial_arm()
    q, v, a = np.random.default_rng(1).normal(size=(3, 6, 2))
    matrix = system.regressor(q, v, a)
    parameters = system.inertial_parameters()
    assert matrix.shape == (6, 2, 20)
    assert parameters["Ixy of arm"] == 0.01
    spring = np.stack([np.zeros(6), 3.0 * q[:, 1]], axis=1)
    forces = system.inverse_dynamics(q, v, a) - spring
    assert matrix @ [*parameters.values()] == pytest.approx(forces, rel=1e-12, abs=1e-13)


def test_columns_of_a_body_are_those_of_a_body_with_another_mass_centre():
    """A point mass at r from the mass centre is m, m r and its inertia there."""
    q, v, a = np.random.default_rng(2).normal(size=(3, 2))
    system = spatial_arm()
    hand = system.eom_method.bodies[1]
    r, mass = np.array([0.2, -0.3, 0.5]), 0.8
    place = hand.masscenter.locatenew(
        "L", sum((float(c) * e for c, e in zip(r, hand.frame, strict=True)), me.Vector(0))
    )
    definition = system.eom_method
    load = me.Particle("load", place, mass)
    heavier = System(
        Definition(
            definition.frame, definition.coordinates, definition.speeds,
            bodies=[*definition.bodies, load],
            loads=[*definition.loads, (place, -9.81 * mass * definition.frame.y)],
        )
    )  # fmt: skip
    inertia = mass * (r @ r * np.eye(3) - np.outer(r, r))
    entries = [inertia[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))]
    more = np.array([mass, *(mass * r), *entries])
    found = system.regressor(q, v, a)[:, 10:] @ more
    expected = heavier.inverse_dynamics(q, v, a) - system.inverse_dynamics(q, v, a)
    assert found == pytest.approx(expected, rel=1e-12)


def test_base_parameters_give_the_same_forces():
    system = spatial_arm()
    q, v, a = np.random.default_rng(3).normal(size=(3, 40, 2))
    base = system.base_parameters(q, v, a)
    parameters = np.array([*system.inertial_parameters().values()])
    matrix = system.regressor(q, v, a)
    assert len(base.places) == np.linalg.matrix_rank(matrix.reshape(-1, 20), tol=1e-9)
    reduced = base.matrix @ parameters
    assert matrix[..., base.places] @ reduced == pytest.approx(
        matrix @ parameters, rel=1e-10, abs=1e-10
    )


def test_a_pendulum_tells_three_parameters():
    """Two first moments and one inertia, which the mass adds to: seven of ten are not told."""
    q = me.dynamicsymbols("q")
    frame, origin = inertial_frame()
    own = frame.orientnew("A", "Axis", (q, frame.z))
    rod = me.RigidBody("rod", origin.locatenew("C", own.x), own, 2.0)
    rod.inertia = me.inertia(own, 0, 1, 1), rod.masscenter
    system = System(Definition(frame, [q], bodies=[rod], loads=[(rod.masscenter, -20 * frame.y)]))
    motions = np.random.default_rng(0).normal(size=(3, 20, 1))
    assert len(system.base_parameters(*motions).places) == 3
    assert len(system.base_parameters(motions[0], 0 * motions[1], 0 * motions[2]).places) == 2


@pytest.mark.parametrize("second", [1.0, 1e6])
def test_base_parameters_are_the_same_in_any_unit_of_length(second):
    """A hand on a slider: forces in its direction, and torques."""
    l, g, ma, mb, i = sm.symbols("l g m_a m_b i")
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    frame, origin = inertial_frame()
    slider = origin.locatenew("S", q[2] * frame.x)
    one = frame.orientnew("A", "Axis", (q[0], frame.z))
    two = one.orientnew("B", "Axis", (q[1], one.x))
    first = slider.locatenew("C1", l * one.x)
    second_center = slider.locatenew("E", 2 * l * one.x).locatenew("C2", -l * two.z)
    arm = me.RigidBody("arm", first, one, ma, (me.inertia(one, i, i, i), first))
    hand = me.RigidBody("hand", second_center, two, mb)
    hand.inertia = me.inertia(two, i, 2 * i, i), second_center
    loads = [(b.masscenter, -b.mass * g * frame.z) for b in (arm, hand)]
    definition = Definition(frame, q, u, bodies=[arm, hand], loads=loads)
    motions = np.random.default_rng(0).normal(size=(3, 40, 3))

    def found(metre):
        system = System(
            definition,
            constants={l: 0.35 * metre, g: 9.81 * metre / second**2, ma: 1.0, mb: 2.0,
                       i: 0.1 * metre**2},
        )  # fmt: skip
        by = np.array([1.0, 1.0, metre])
        rates = [m * by / second**k for k, m in enumerate(motions)]
        base = system.base_parameters(*rates)
        tau = system.regressor(*rates) @ (pi := np.array([*system.inertial_parameters().values()]))
        return base, tau, system.regressor(*rates)[..., base.places] @ (base.matrix @ pi)

    expected = found(1.0)[0].places
    for exponent in (-12, -9, -6, -3, 0, 3, 6, 9, 12):
        base, tau, forces = found(10.0**exponent)
        assert base.places == expected
        sizes = np.abs(tau).max(axis=0)
        np.testing.assert_allclose(forces / sizes, tau / sizes, atol=1e-11)


@pytest.mark.parametrize("name", ["free_body", "disc", "gyro", "fourbar", "free_pendulum"])
def test_models_of_all_kinds_have_a_regressor(name):
    system = system_of(zoo.MODELS[name]())
    rng = np.random.default_rng(4)
    q, v, a = (
        rng.uniform(0.2, 0.8, len(s)) for s in (system.coordinates, system.speeds, system.speeds)
    )
    parameters = [*system.inertial_parameters().values()]
    forces = system.regressor(q, v, a) @ parameters
    others = system.bias(q, 0 * v) - system.gravity(q)
    assert forces == pytest.approx(system.inverse_dynamics(q, v, a) - others, rel=1e-11, abs=1e-11)


def test_gravity_is_given_where_a_weight_is_compensated():
    """The regressor is that of the arm whose loads tell gravity; the lift is another load."""
    q, v, a = np.random.default_rng(1).normal(size=(3, 6, 2))
    expected = spatial_arm().regressor(q, v, a)
    lifted, frame = spatial_arm(lift=0.5)
    with pytest.raises(ValueError, match=r"Give it: `acceleration=-g\*N.z`"):
        lifted.regressor(q, v, a)
    columns = lifted.regressor(q, v, a, acceleration=-9.81 * frame.y)
    np.testing.assert_allclose(columns, expected, rtol=1e-13, atol=1e-13)
    weightless = lifted.regressor(q, v, a, acceleration=0 * frame.y)
    assert abs(weightless - expected).max() > 1.0
    base = lifted.base_parameters(q, v, a, acceleration=-9.81 * frame.y)
    assert base.places == spatial_arm().base_parameters(q, v, a).places


def test_what_is_not_linear_or_not_whole_is_told():
    with pytest.raises(ValueError, match="do not tell which way gravity pulls"):
        towed().regressor()
    with pytest.raises(ValueError, match=r"`a` must have the shape \(1,\)"):
        multi_mass_spring_damper().regressor(a=[1.0, 2.0])
    assert n_link_pendulum_on_cart(1).inertial_parameters(p={"m0": 4.0})["m of Pa0"] == 4.0


@pytest.mark.parametrize("what", ["regressor", "inertial_parameters"])
def test_masses_that_change_are_refused(what):
    """The rope of a chain that is paid out: m' v was missing, without a word."""
    x, t = me.dynamicsymbols("x"), me.dynamicsymbols._t
    frame, origin = inertial_frame()
    place = origin.locatenew("P", x * frame.x)
    for mass in (2.0 * x, 3.0 - t, me.dynamicsymbols("mu")):
        system = System(Definition(frame, [x], bodies=[me.Particle("end", place, mass)]))
        with pytest.raises(ValueError, match=r"mass of end, .*, may change with time"):
            getattr(system, what)()


def towed():
    """A bob on which a constant force acts that its mass is not in, beside one without."""
    x, y = me.dynamicsymbols("x y")
    frame, origin = inertial_frame()
    bobs = [
        me.Particle(f"bob{k}", origin.locatenew(f"P{k}", s * frame.x), 2.0)
        for k, s in enumerate((x, y))
    ]
    return System(
        Definition(frame, [x, y], bodies=bobs, loads=[(bobs[0].masscenter, 3.0 * frame.x)])
    )


@pytest.mark.filterwarnings("ignore")  # of the regressor's rows
@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_samples_that_are_no_numbers_are_named_not_left_to_empty_the_answer(value):
    system = n_link_pendulum_on_cart(2)
    q, v, a = np.random.default_rng(0).normal(size=(3, 50, 3))
    q[7, 1] = value
    with pytest.raises(ValueError, match="for 3 of its rows, the first of them of sample 7"):
        system.base_parameters(q, v, a)


def test_an_inertia_that_no_motion_depends_on_is_named_with_its_remedy():
    """A body in a plane turns about one axis: the inertia about the others cancels."""
    q, u = me.dynamicsymbols("q u")
    about, across = sm.symbols("I J")
    frame, centre = me.ReferenceFrame("N"), me.Point("C")
    turned = frame.orientnew("A", "Axis", (q, frame.z))
    turned.set_ang_vel(frame, u * frame.z)
    centre.set_vel(frame, 0)
    inertia = me.inertia(turned, across, across, about)
    body = me.RigidBody("disc", centre, turned, 1, (inertia, centre))
    kane = me.KanesMethod(frame, [q], [u], kd_eqs=[u - q.diff()])
    kane.kanes_equations([body], [])
    with pytest.raises(ValueError, match=r"`J` occurs in .* in its `constants_symbols`"):
        System(kane).inertial_parameters()
    system = System(kane, {across: 2.0}, constants_symbols=[about, across])
    assert system.inertial_parameters()["Ixx of disc"] == 2.0
