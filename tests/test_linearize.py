"""Linear models in the tangent space of the constraints, against matrices made for the purpose."""

import numpy as np
import pytest

from pydy.linearize import constrained_eigenvalues, reduce_state_matrix

# A pendulum of length 1 under gravity 9 in (x, y, x', y'), hanging at (0, -1).
PENDULUM = np.array([[0, 0, 1, 0], [0, 0, 0, 1], [-9, 0, 0, 0], [0, 0, 0, 0]], dtype=float)
ROD = np.array([[0, -2, 0, 0], [0, 0, 0, -2]], dtype=float)


def made_of(inner, outer, seed=0):
    """A state matrix that has the eigenvalues of `inner` on the null space of C, and that C."""
    rng = np.random.default_rng(seed)
    m, n = len(inner), len(inner) + len(outer)
    coupling = rng.normal(size=(m, n - m))
    block = np.block([[inner, coupling], [np.zeros((n - m, m)), outer]])
    basis = rng.normal(size=(n, n)) + 3 * np.eye(n)
    inverse = np.linalg.inv(basis)
    return basis @ block @ inverse, inverse[m:]


def test_the_pendulum_keeps_its_swing_only():
    values = constrained_eigenvalues(PENDULUM, ROD)
    np.testing.assert_allclose(values, [3j, -3j], atol=1e-13)


def test_only_the_eigenvalues_of_permitted_motions_are_left():
    inner = np.array([[-1.0, 4.0, 0.0], [-4.0, -1.0, 0.0], [0.0, 0.0, 0.5]])
    A, C = made_of(inner, np.diag([7.0, -3.0]))
    np.testing.assert_allclose(constrained_eigenvalues(A, C), [0.5, -1 + 4j, -1 - 4j], rtol=1e-12)


def test_eigenvalues_come_with_the_largest_real_part_first():
    values = constrained_eigenvalues(np.diag([-2.0, 3.0, 0.0, -1.0]), np.zeros((0, 4)))
    np.testing.assert_array_equal(values, [3, 0, -1, -2])


def test_the_scale_of_a_constraint_does_not_matter():
    scaled = ROD * [[1e-14], [1e9]]
    np.testing.assert_allclose(constrained_eigenvalues(PENDULUM, scaled), [3j, -3j], atol=1e-13)


def test_rows_that_repeat_others_change_nothing():
    more = np.vstack([ROD, ROD[0] - 3 * ROD[1], np.zeros(4)])
    assert reduce_state_matrix(PENDULUM, more).shape == (2, 2)


def test_without_constraints_the_matrix_stays_as_it_is():
    np.testing.assert_array_equal(reduce_state_matrix(PENDULUM, np.zeros((0, 4))), PENDULUM)


def test_constraints_that_fix_everything_leave_nothing():
    assert constrained_eigenvalues(PENDULUM, np.eye(4)).shape == (0,)


def test_a_constraint_that_the_motion_does_not_keep_is_refused():
    # The rod's rate is missing: y = -1 is not kept by a pendulum that may move up and down.
    with pytest.raises(ValueError, match=r"into itself, but leads out of it by 0\.1"):
        reduce_state_matrix(PENDULUM, ROD[:1])


@pytest.mark.parametrize("metre", [1e-6, 1.0, 1e9])
def test_the_rank_of_constraints_does_not_depend_on_the_unit_of_length(metre):
    """An angle beside lengths: the third row is the difference of the others, with roundings."""
    rows = np.array([[1.0, -0.3 / metre, 0.7], [0.2, 0.1 / metre, 0.4]])
    rows = np.vstack([rows, (rows[0] / 3.0 - rows[1] / 7.0) * (1.0 + 1e-13 * np.array([1, -1, 1]))])
    A = np.zeros((3, 3))
    assert reduce_state_matrix(A, rows).shape == (1, 1)
    assert reduce_state_matrix(A, 1e-3 * rows[[0, 2]]).shape == (1, 1)
