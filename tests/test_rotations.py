"""Quaternions of rotations, beside SciPy's."""

import numpy as np
from scipy.spatial.transform import Rotation

from pydy._rotations import to_quaternions

RANDOM = np.random.default_rng(0)
ANGLES = [*RANDOM.uniform(-10.0, 10.0, (400, 3)), *np.pi / 2 * RANDOM.integers(-4, 5, (400, 3))]


def test_quaternions_are_scipys():
    rotations = Rotation.from_euler("xyz", np.array(ANGLES)).as_matrix()
    expected = Rotation.from_matrix(rotations).as_quat()  # with the same of both signs
    np.testing.assert_allclose(to_quaternions(rotations), expected, rtol=0, atol=1e-15)


def test_many_rotations_have_the_quaternions_of_each():
    rotations = Rotation.from_euler("xyz", np.array(ANGLES[::10])).as_matrix()
    alone = [to_quaternions(rotation) for rotation in rotations]
    np.testing.assert_array_equal(to_quaternions(rotations), alone)
    np.testing.assert_array_equal(to_quaternions(rotations.reshape(4, 20, 3, 3))[1, 2], alone[22])
