"""Linear models of constrained systems: small motions that satisfy the constraints.

The functions take arrays, so that they work with any state matrix. A System provides both arguments
exactly, ``system.evaluate_jacobian()`` and ``system.evaluate_jacobian(of=...)``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pydy._checks import real_array
from pydy._rank import or_one, rank

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["constrained_eigenvalues", "reduce_state_matrix"]
__dir__ = __all__.copy

# How far A may lead out of the tangent space, relative to A.  A Jacobian from differences is good
# to 1e-6 or so; a state that is no equilibrium misses by something like 1e-2 or more.
_INVARIANCE = 1e-5


def reduce_state_matrix(state_matrix: ArrayLike, constraint_jacobian: ArrayLike) -> np.ndarray:
    """Return the state matrix of the motions that satisfy the constraints.

    Parameters
    ----------
    state_matrix : array_like, shape (n, n)
        A: the derivatives of the rates x' with respect to the states x, at an equilibrium (or at a
        steady motion in which only ignorable coordinates change).
    constraint_jacobian : array_like, shape (k, n)
        C: the derivatives of the residuals of the constraints with respect to the states, at the
        same x: holonomic and velocity constraints, one below the other. Rows may be linearly
        dependent and have any scale, and there may be none (k = 0).

    Returns
    -------
    ndarray, shape (m, m)
        ``T.T @ A @ T``, where the columns of T are an orthonormal basis of the null space of C and
        m = n - rank(C).  T is not unique, the eigenvalues are.

    Raises
    ------
    ValueError
        The shapes do not match, a number is not finite, or A maps vectors out of the null space of
        C, which happens if x is not an equilibrium or C does not belong to A.

    Notes
    -----
    The states that satisfy the constraints c(x) = 0 form a manifold, and the null space of C =
    dc/dx is its tangent space. A motion that starts on the manifold stays there, so the flow maps a
    curve on it through the equilibrium to another such curve. Differentiated along the curve, this
    means that the linearised flow exp(A t) maps tangent vectors to tangent vectors: C exp(A t) v =
    0 for every v with C v = 0. The derivative of this at t = 0 is C A v = 0. Hence A maps the
    tangent space into itself, T (T.T A T) = A T, and the eigenvalues of the small matrix are
    exactly those of A whose motions satisfy the constraints. The remaining eigenvalues of A
    describe how violations of the constraints would evolve; they are an artefact of how the
    equations were written and can even seem unstable.

    Unlike in the usual elimination [1]_, no choice of independent coordinates is needed, so none
    can be unsuitable.

    References
    ----------
    .. [1] D. L. Peterson, G. Gede and M. Hubbard, "Symbolic linearization of equations of motion
       of constrained multibody systems", Multibody System Dynamics 33 (2015) 143-161.

    Examples
    --------
    A pendulum of length 1 under gravity 9, in Cartesian coordinates (x, y, x', y'), hangs at (0,
    -1) with the rod's force eliminated.  The constraint x² + y² = 1 and its rate leave two of the
    four states, an oscillation with the frequency sqrt(9 / 1) = 3:

    >>> import numpy as np
    >>> from pydy.linearize import reduce_state_matrix
    >>> A = np.array([[0, 0, 1, 0], [0, 0, 0, 1], [-9, 0, 0, 0], [0, 0, 0, 0]])
    >>> C = np.array([[0, -2, 0, 0], [0, 0, 0, -2]])
    >>> swing = reduce_state_matrix(A, C)
    >>> swing.shape
    (2, 2)
    >>> np.allclose(np.poly(swing), [1, 0, 9])
    True
    """
    A = _matrix("state_matrix", state_matrix)
    C = _matrix("constraint_jacobian", constraint_jacobian)
    if A.shape[0] != A.shape[1]:
        raise ValueError(f"`state_matrix` must be square, shape (n, n), got {A.shape}.")
    if C.shape[1] != A.shape[0]:
        raise ValueError(
            f"`constraint_jacobian` must have the shape (k, {A.shape[0]}), one column for each "
            f"state of `state_matrix`, got {C.shape}."
        )
    if not len(C):
        return A
    # A constraint in millimetres is the same constraint: neither its scale nor that of a state must
    # decide on the rank.
    T = np.linalg.svd(C / or_one(np.linalg.norm(C, axis=1, keepdims=True)))[2][rank(C) :].T
    AT = A @ T
    reduced: np.ndarray = T.T @ AT
    outside = float(np.linalg.norm(AT - T @ reduced))
    if outside > _INVARIANCE * float(np.linalg.norm(A)):
        raise ValueError(
            "`state_matrix` must map the null space of `constraint_jacobian` into itself, but "
            f"leads out of it by {outside / float(np.linalg.norm(A)):.2g} of its size. Evaluate "
            "both at one equilibrium that satisfies the constraints, and give the holonomic and "
            "the velocity constraints."
        )
    return reduced


def constrained_eigenvalues(state_matrix: ArrayLike, constraint_jacobian: ArrayLike) -> np.ndarray:
    """Return the eigenvalues of the motions that satisfy the constraints.

    Parameters
    ----------
    state_matrix : array_like, shape (n, n)
        See `reduce_state_matrix`.
    constraint_jacobian : array_like, shape (k, n)
        See `reduce_state_matrix`.

    Returns
    -------
    ndarray of complex, shape (m,)
        In 1/s, the largest real part first, so that the first one determines stability; of a
        conjugate pair, the one with the positive imaginary part comes first.

    Raises
    ------
    ValueError
        As in `reduce_state_matrix`.

    Examples
    --------
    Two unit masses on springs of stiffness 3 and 5 to the wall, welded together by x0 = x1 and its
    rate v0 = v1, so that each one is accelerated by the mean of both springs' forces:

    >>> import numpy as np
    >>> from pydy.linearize import constrained_eigenvalues
    >>> A = np.array([[0, 0, 1, 0], [0, 0, 0, 1], [-1.5, -2.5, 0, 0], [-1.5, -2.5, 0, 0]])
    >>> C = np.array([[1, -1, 0, 0], [0, 0, 1, -1]])
    >>> constrained_eigenvalues(A, C).imag.round(12)
    array([ 2., -2.])
    """
    values = np.linalg.eigvals(reduce_state_matrix(state_matrix, constraint_jacobian))
    values = values.astype(complex)
    return values[np.lexsort((-values.imag, -values.real))]


def _matrix(name: str, value: ArrayLike) -> np.ndarray:
    """Return a value as a finite real matrix."""
    matrix = real_array(value, f"`{name}`")
    if matrix.ndim != 2:
        raise ValueError(f"`{name}` must have two dimensions, got the shape {matrix.shape}.")
    if not np.isfinite(matrix).all():
        row, column = np.argwhere(~np.isfinite(matrix))[0]
        raise ValueError(
            f"`{name}` must be finite, got {matrix[row, column]} in row {row}, column {column}."
        )
    return matrix
