"""Rotations of robot files, beside SciPy's."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from pydy.robots.tree import of_quaternion, of_roll_pitch_yaw

RANDOM = np.random.default_rng(0)
ANGLES = [*RANDOM.uniform(-10.0, 10.0, (40, 3)), *np.pi / 2 * RANDOM.integers(-4, 5, (40, 3))]


@pytest.mark.parametrize("angles", ANGLES, ids=str)
def test_angles_and_quaternions_are_scipys(angles):
    expected = Rotation.from_euler("xyz", angles)
    rotation = of_roll_pitch_yaw(angles)
    np.testing.assert_allclose(rotation, expected.as_matrix(), rtol=0, atol=1e-15)
    quaternion = np.roll(expected.as_quat(), 1)
    for size in (1e-100, 1.0, 1e100):  # it is normalised
        np.testing.assert_allclose(
            of_quaternion(size * quaternion), expected.as_matrix(), rtol=0, atol=2e-15
        )


def test_right_angles_have_exact_cosines():
    turned = of_roll_pitch_yaw(np.array([np.pi / 2, 0.0, np.pi]))
    np.testing.assert_array_equal(turned, [[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
    half = np.sqrt(0.5)
    turned = of_quaternion(np.array([half, 0.0, 0.0, half]))
    np.testing.assert_array_equal(turned, [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
