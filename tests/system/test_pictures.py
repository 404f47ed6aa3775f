"""Pictures straight from a System."""

import numpy as np

from optional import optional
from pydy.models import multi_mass_spring_damper, n_link_pendulum_on_cart

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
