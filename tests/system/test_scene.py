"""system.scene: the short way from a System to its animation."""

import numpy as np
import pytest
import sympy as sm
from sympy.physics.mechanics import (
    KanesMethod,
    LagrangesMethod,
    Lagrangian,
    Particle,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System
from pydy.viz import Arrow, Sphere, Visual
from zoo import inertial_frame

q, u, F = dynamicsymbols("q, u, F")


def rotor(origin_rests=True, **load):
    N, O, C = ReferenceFrame("N"), Point("O"), Point("C")
    B = N.orientnew("B", "Axis", (q, N.z))
    B.set_ang_vel(N, u * N.z)
    C.set_pos(O, 2 * B.x)
    C.set_vel(N, 2 * u * B.y)
    if origin_rests:
        O.set_vel(N, 0)
    body = RigidBody("rotor", C, B, 12, (inertia(B, 1 + 4, 4 + 9, 1 + 9), C))
    kane = KanesMethod(N, [q], [u], kd_eqs=[q.diff() - u])
    kane.kanes_equations([body], [(C, F * N.x)])
    return System(kane, times=np.linspace(0, 1, 31)), N, O, B, C


def test_bodies_origin_and_gravity_come_from_the_method():
    sys = n_link_pendulum_on_cart(2)
    sys.times = np.linspace(0, 1, 31)
    scene = sys.scene().animate(sys.simulate())
    assert [v.name for v in scene.visuals[:3]] == ["Pa0", "Pa1", "Pa2"]
    assert scene.origin.name == "O"
    assert scene._settings.up_axis.tolist() == [0, 1, 0]


def test_gravity_may_pull_along_any_axis():
    sys = multi_mass_spring_damper(2, apply_gravity=True)
    assert sys.scene()._settings.up_axis.tolist() == [-1, 0, 0]


@pytest.mark.parametrize("mass", [sm.Symbol("m"), 0.5])
def test_gravity_may_be_a_number(mass):
    y, v = dynamicsymbols("y, v")
    N, O = inertial_frame()
    P = O.locatenew("P", y * N.y)
    P.set_vel(N, v * N.y)
    thrust = sm.Symbol("F")
    kane = KanesMethod(N, [y], [v], kd_eqs=[y.diff() - v], bodies=[Particle("ball", P, mass)],
                       forcelist=[(P, -mass * 9.81 * N.y), (P, thrust * N.x)])  # fmt: skip
    assert System(kane).scene()._settings.up_axis.tolist() == [0, 1, 0]


def hanging(axis, weight, energy=None):
    """A pendulum by Lagrange's method that hangs along an axis, whose weight no load tells."""
    N, O = inertial_frame()
    l, m = sm.Symbol("l"), sm.Symbol("m")
    down, aside = -{"x": N.x, "y": N.y, "z": N.z}[axis], {"x": N.y, "y": N.z, "z": N.x}[axis]
    P = O.locatenew("P", l * (sm.cos(q) * down + sm.sin(q) * aside))
    P.set_vel(N, P.pos_from(O).dt(N))
    bob = Particle("bob", P, m if weight.free_symbols else 2)
    bob.potential_energy = -weight * l * sm.cos(q) if energy is None else energy
    return System(LagrangesMethod(Lagrangian(N, bob), [q], bodies=[bob], frame=N))


G, K, M = sm.symbols("g, k, m")


@pytest.mark.parametrize("axis", ["x", "y", "z"])
@pytest.mark.parametrize("weight", [M * G, M * 9.81, sm.Float(19.62), -M * G])
def test_gravity_may_be_in_the_potential_energy_alone(axis, weight):
    scene = hanging(axis, weight).scene()
    up = np.array([axis == "x", axis == "y", axis == "z"], dtype=float)
    np.testing.assert_array_equal(scene._settings.up_axis, -up if weight == -M * G else up)
    assert scene._settings.ground is None


def test_springs_are_told_from_weights():
    l = sm.Symbol("l")
    spring = K * (q - 1) ** 2 / 2
    both = hanging("y", M * G, -M * G * l * sm.cos(q) + spring).scene()
    assert both._settings.up_axis.tolist() == [0, 1, 0]
    both = hanging("y", M, -M * 9.81 * l * sm.cos(q) + spring).scene()
    assert both._settings.up_axis.tolist() == [0, 1, 0]
    alone = hanging("y", M, spring).scene()
    assert alone._settings.up_axis.tolist() == [0, 0, 1]
    assert alone._settings.ground is False


def test_a_rigid_body_is_a_bar_from_its_bearing_to_its_mass_centre():
    sys, *_ = rotor()
    (ball, line, support) = sys.scene().animate(sys.simulate())._animation.items
    assert isinstance(ball.shape, Sphere)
    assert line.points[0] == pytest.approx(np.array([[0, 0, 0], [2, 0, 0]]))
    assert "Support at O" in str(support.visual)


def test_states_at_the_systems_times_will_do():
    sys, *_, C = rotor()
    sys.initial_conditions = {u: 1.0}
    states = sys.integrate()
    first = sys.scene(Visual(Sphere(1), C)).animate(states)
    second = sys.scene(Visual(Sphere(1), C)).animate(sys.times, states)
    assert first.poses == pytest.approx(second.poses)
    assert first.poses[:, 0, 0, 3] == pytest.approx(2 * np.cos(first.times))


def test_states_of_the_wrong_shape_are_refused():
    sys, *_ = rotor()
    with pytest.raises(ValueError, match=r"`states` must have the shape \(31, 2\)"):
        sys.scene().animate(np.zeros((31, 3)))
    sys.times = None
    with pytest.raises(ValueError, match="`times` must be a sequence"):
        sys.scene().animate(np.zeros((31, 2)))


def test_derivatives_and_specifieds_are_known():
    sys, N, _, _, C = rotor()
    sys.initial_conditions = {u: 3.0}
    sys.specifieds = {F: lambda x, t: t}
    scene = sys.scene(Visual(Arrow(q.diff() * N.z), C), Visual(Arrow(F * N.x), C), series=[F])
    for motion in (sys.simulate(), sys.integrate()):
        scene.animate(motion)
        spin, force = scene._animation.items
        assert spin.vectors[0].tolist() == [0, 0, 3]
        assert force.vectors[:, 0] == pytest.approx(scene.times)
        times, values = scene._animation.series["F"]
        np.testing.assert_array_equal(values, times)
        assert {*scene.times} <= {*times}


def test_a_trajectory_of_another_system_is_refused():
    sys, *_ = rotor()
    other = n_link_pendulum_on_cart(1)
    other.times = [0.0, 1.0]
    with pytest.raises(ValueError, match=r"of another system: it has the states q0\(t\), q1"):
        sys.scene().animate(other.simulate())


def test_without_a_point_at_rest_the_origin_must_be_given():
    sys, _, O, _, _ = rotor(origin_rests=False)
    with pytest.raises(ValueError, match=r"`origin` is required.*Pass `origin=O`"):
        sys.scene()
    assert sys.scene(origin=O).origin is O


def test_a_method_without_bodies_needs_visuals():
    N, P = ReferenceFrame("N"), Point("P")
    P.set_vel(N, u * N.x)
    kane = KanesMethod(N, [q], [u], kd_eqs=[q.diff() - u])
    kane.kanes_equations([Particle("p", P, 1)], [])
    sys = System(kane)
    object.__setattr__(sys._equations, "mechanism", None)
    with pytest.raises(ValueError, match="`scene` needs visuals"):
        sys.scene()
    with pytest.raises(ValueError, match="`reference_frame` must be given"):
        sys.scene(Visual(Sphere(1), P))


def test_options_are_those_of_a_scene():
    sys, *_ = rotor()
    scene = sys.scene(up="z", title="Rotor", ground=False)
    assert scene._settings.up_axis.tolist() == [0, 0, 1]
    with pytest.raises(TypeError, match="colour"):
        sys.scene(colour="red")
