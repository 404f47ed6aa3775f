"""Pictures straight from a System."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from optional import optional
from pydy.errors import PyDyUserWarning
from pydy.mechanics import Definition
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart
from pydy.system import System
from zoo import inertial_frame

plt = optional("matplotlib.pyplot")


def test_a_system_simulates_and_plots():
    system = multi_mass_spring_damper()
    system.initial_conditions = {"x0": 1.0}
    system.times = np.linspace(0.0, 1.0, 11)
    ax = system.plot(["x0"])
    np.testing.assert_array_equal(ax.get_lines()[0].get_ydata(), system.integrate()[:, 0])
    assert len(system.plot()) == 2
    plt.close("all")


def test_a_system_simulates_and_animates():
    system = n_link_pendulum_on_cart(1)
    system.initial_conditions = {"q1": 0.5}
    system.times = np.linspace(0.0, 1.0, 11)
    scene = system.animate(title="Cart")
    np.testing.assert_array_equal(scene.poses, system.scene().animate(system.simulate()).poses)


def lever_with_marks():
    """A lever with a mass at its end, and two points that the equations do not need."""
    q = me.dynamicsymbols("q")
    length, reach, height = sm.symbols("length reach height")
    frame, origin = inertial_frame()
    bearing = origin.locatenew("B", height * frame.y)
    lever = frame.orientnew("A", "Axis", (q, frame.z))
    end = bearing.locatenew("P", length * lever.x)
    end.locatenew("mark", reach * lever.y)
    arm = me.RigidBody("arm", end, lever, 1, (me.inertia(lever, 0, 0, 1), end))
    system = System(Definition(frame, [q], bodies=[arm], loads=[(end, -9.81 * frame.y)]))
    system.times = np.linspace(0.0, 1.0, 11)
    return system


def test_values_of_symbols_that_only_a_picture_needs_are_given_to_it():
    system = lever_with_marks()
    with pytest.raises(ValueError, match=r"`height`, .* Give its value in `constants`"):
        system.simulate().animate(constants={"reach": 0.5})
    given = {"height": 2.0, "reach": 0.5}
    for source in (system, system.simulate()):
        places = source.animate(constants=given).poses[0, :, :3, 3]
        assert [1.0, 2.0, 0.0] in places.tolist()  # the arm, in its first position


def test_marks_without_a_value_are_left_out_of_a_default_picture_with_a_warning():
    system = lever_with_marks()
    with pytest.warns(PyDyUserWarning, match=r"^Lines to mark are not drawn: .* for reach\."):
        part = system.animate(constants={"height": 2.0})
    whole = system.animate(constants={"height": 2.0, "reach": 0.5})
    assert len(part.visuals) < len(whole.visuals)


def test_the_origin_of_a_picture_does_not_depend_on_velocities_that_sympy_derived():
    """Then a point that is fixed to the ground would be the nearest one at rest."""
    q = me.dynamicsymbols("q")
    frame, origin = inertial_frame()
    bearing = origin.locatenew("B", 2 * frame.y)
    lever = frame.orientnew("A", "Axis", (q, frame.z))
    end = bearing.locatenew("P", lever.x)
    system = System(Definition(frame, [q], bodies=[me.Particle("bob", end, 1)]))
    system.times = [0.0, 1.0]
    before = system.animate().poses
    bearing.vel(frame)
    np.testing.assert_array_equal(system.animate().poses, before)
    assert [1.0, 2.0, 0.0] in before[0, :, :3, 3].tolist()
