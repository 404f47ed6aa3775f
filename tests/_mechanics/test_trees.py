"""Random trees of bodies against Newton's and Euler's equations, written down with NumPy."""

import numpy as np
import pytest

from pydy._mechanics.form import forms
from pydy._mechanics.kane import multibody_of_kane
from random_trees import accelerations, as_kane, imbalance, random_tree


@pytest.mark.parametrize(
    ("seed", "n", "set_velocities"),
    [(0, 4, True), (1, 7, True), (2, 7, False), (3, 12, False), (4, 29, False)],
)
def test_random_trees_obey_newtons_and_eulers_equations(seed, n, set_velocities):
    links = random_tree(seed, n)
    body = multibody_of_kane(as_kane(links, set_velocities=set_velocities))
    rng = np.random.default_rng(seed)
    x = rng.uniform(-1.0, 1.0, 2 * n)
    for in_bodies in (True, False):
        for formed in forms(body, in_bodies=in_bodies):
            assert formed.honoured == ()
            missing, size = imbalance(links, x[:n], x[n:], accelerations(formed, x))
            np.testing.assert_array_less(abs(missing), 1e-10 * size.max())
