"""Loads as arrows, and other runs beside the one that is shown."""

from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._names import name_of
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.viz import Arrow, Visual
from pydy.viz.page import page_data

TIMES = np.linspace(0.0, 1.0, num=31)


@pytest.fixture
def system():
    system = n_link_pendulum_on_cart(1)
    system.constants = {"g": 9.81, "m1": 2.0}
    system.initial_conditions = {"q1": 0.5}
    system.times = TIMES
    return system


def test_loads_are_arrows_of_one_scale(system):
    system.specifieds = {"F": 5.0}
    items = system.animate(loads=True)._animation.items
    forces = [item for item in items if item.visual.name == "forces"]
    cart, bob = (item.vectors[0] for item in forces)
    assert cart[:2] / -bob[1] == pytest.approx([5.0 / 19.62, -0.5])
    assert bob[0] == 0.0
    plain = system.animate()._animation.items
    assert len(plain) == len(items) - 2


def test_the_arrows_of_two_runs_have_one_scale(system):
    cart, bob = system.eom_method.bodies
    force = system.reaction([bob], cart.masscenter).force
    first = system.simulate()
    system.initial_conditions = {"q1": 2.5}
    second = system.simulate()
    scene = system.scene(Visual(Arrow(force, scale=None), cart.masscenter))
    alone = scene.animate(second)._animation.items[0]
    own, other = scene.animate(first, compare={"other": second})._animation.items
    assert own.shape.scale == other.shape.scale != alone.shape.scale
    in_newtons = alone.vectors / alone.shape.scale
    np.testing.assert_allclose(other.vectors / other.shape.scale, in_newtons, rtol=1e-9)


def test_a_short_peak_leaves_the_rest_of_an_arrow_to_be_seen():
    from pydy.viz.animation import _arrow_scale

    steady = np.linspace(9.0, 10.0, num=101)
    peaked = np.where(np.arange(101) == 50, 300.0, 10.0)
    assert _arrow_scale(steady) * steady.max() == pytest.approx(1 / 3, rel=0.02)
    assert _arrow_scale(peaked) * 300.0 == pytest.approx(1.0)
    assert _arrow_scale(np.zeros(3)) == 1.0


def test_torques_are_arrows_at_their_bodies():
    system = n_link_pendulum_on_cart(1, cart_force=False, joint_torques=True)
    names = [visual.name for visual in system.scene(loads=True).visuals]
    assert "torques" not in names  # a particle has no frame of its own
    N, B, O = me.ReferenceFrame("N"), me.ReferenceFrame("B"), me.Point("O")
    q, u = me.dynamicsymbols("q, u")
    B.orient_axis(N, q, N.z)
    B.set_ang_vel(N, u * N.z)
    O.set_vel(N, 0)
    wheel = me.RigidBody("wheel", O, B, 1, (me.inertia(B, 1, 1, 2), O))
    kane = me.KanesMethod(N, [q], [u], [q.diff() - u])
    kane.kanes_equations([wheel], [(B, 3 * N.z)])
    from pydy.system import System

    (_, torque) = System(kane).scene(loads=True).visuals
    assert torque.name == "torques"
    assert torque.shape.vector == 3 * N.z


def test_gravity_on_the_ground_itself_needs_no_mass_and_no_arrow():
    from pydy.system import System

    g = sm.Symbol("g")
    wall, arm = me.RigidBody("wall"), me.RigidBody("arm")
    mechanism = me.System.from_newtonian(wall)
    mechanism.add_joints(me.PinJoint("pin", wall, arm, child_point=arm.y, joint_axis=wall.z))
    mechanism.apply_uniform_gravity(-g * wall.y)
    assert len(mechanism.loads) == 2
    system = System(mechanism, {g: 9.81}, times=TIMES)
    items = system.animate(loads=True)._animation.items
    (force,) = [item for item in items if item.visual.name == "forces"]
    assert force.vectors[0][1] < 0.0  # of some length that can be seen


def test_outputs_may_stand_in_arrows(system):
    spring = multi_mass_spring_damper()
    x0, v0 = spring.states
    power = sm.Symbol("power")
    spring.initial_conditions, spring.times = {"x0": 1.0}, TIMES
    spring.outputs = {power: x0 * v0}
    trajectory = spring.simulate()
    frame, body = spring.eom_method._inertial, spring.eom_method.bodies[0]
    scene = spring.scene(Visual(Arrow(power * frame.x, scale=2.0), body.point))
    (item,) = scene.animate(trajectory)._animation.items
    np.testing.assert_allclose(item.vectors[:, 0], 2 * trajectory["power"])


def test_other_runs_are_ghosts_under_their_labels(system):
    shown = system.simulate()
    system.initial_conditions = {"q1": 0.6}
    other = system.simulate()
    scene = system.scene().animate(shown, compare={"from 0.6": other})
    own, ghosts = scene._animation.items[:3], scene._animation.items[3:]
    assert [item.visual.name for item in ghosts] == ["from 0.6"] * 3
    assert [g.shape.colour for g in ghosts] == [i.shape.colour for i in own]
    assert all(g.shape.opacity == 0.3 for g in ghosts)
    alone = system.scene().animate(other)._animation.items
    for ghost, item in zip(ghosts, alone, strict=True):
        np.testing.assert_allclose(ghost.positions, item.positions, atol=1e-12)
    # Turning frames of both runs are told apart on the page.
    tracks = {
        entry.get("track") for entry in page_data(scene._animation, scene._settings)["visuals"]
    }
    assert len(tracks) > 3


def test_a_run_from_a_file_has_its_own_constants(system):
    shown = system.simulate()
    names = {str(s): v for s, v in shown.constants.items()}
    other = SimpleNamespace(
        times=shown.times, states=shown.states, at=lambda t: other,
        state_symbols=tuple(map(name_of, system.states)),
        constants={**names, "l0": 2.0 * names["l0"]},
    )  # fmt: skip
    expected = system.scene().animate(shown, constants={"l0": other.constants["l0"]})
    ghosts = system.scene().animate(shown, compare=other)._animation.items[3:]
    for ghost, item in zip(ghosts, expected._animation.items, strict=True):
        np.testing.assert_allclose(ghost.positions, item.positions, atol=1e-12)


def test_a_shorter_run_rests_at_its_end(system):
    shown = system.simulate()
    system.times = TIMES[:11]
    short = system.simulate()
    ghosts = system.scene().animate(shown, compare=[short])._animation.items[3:]
    assert ghosts[0].visual.name == "run 2"
    np.testing.assert_allclose(ghosts[1].positions[-1], ghosts[1].positions[10], atol=1e-12)


def test_members_of_an_ensemble_are_ghosts(system):
    pytest.importorskip("xarray")
    results = system.integrate_ensemble(
        initial_conditions={"q1": np.linspace(0.1, 0.9, 30)}, times=TIMES
    )
    scene = system.scene().animate(system.simulate(), compare=results)
    names = [item.visual.name for item in scene._animation.items]
    assert names.count("compared") == 12 * 3


def test_what_cannot_be_compared_is_refused(system):
    shown = system.simulate()
    with pytest.raises(TypeError, match="`compare` must be a Trajectory"):
        system.scene().animate(shown, compare=5.0)
    with pytest.raises(TypeError, match="a label in `compare` must be a string, got 3"):
        system.scene().animate(shown, compare={3: shown})
    with pytest.raises(ValueError, match="one of another system"):
        system.scene().animate(shown, compare=_other())


def _other():
    spring = multi_mass_spring_damper()
    spring.times = TIMES
    return spring.simulate()
