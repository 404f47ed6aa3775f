"""Truncated power series in time, in 80 bits: arrays whose first axis is the degree, 0 to 2.

The second axis are motions side by side: the real one, and one for each speed of size one.
"""

import numpy as np

LONG = np.longdouble


def multiply(a, b, product=np.multiply):
    """The product of two series, for matrices with ``product=np.matmul``."""
    return np.stack(
        [
            product(a[0], b[0]),
            product(a[0], b[1]) + product(a[1], b[0]),
            product(a[0], b[2]) + product(a[1], b[1]) + product(a[2], b[0]),
        ]
    )


def rotate(matrix, vector):
    """A series of matrices times one of vectors, or times a vector that is fixed."""
    if vector.ndim == 1:
        return matrix @ vector
    return multiply(matrix, vector[..., None], np.matmul)[..., 0]


def dot(a, b):
    return multiply(a, b).sum(-1)


def square_root(a):
    first = np.sqrt(a[0])
    second = a[1] / first / 2
    return np.stack([first, second, (a[2] - second**2) / first / 2])


def cos_sin(a):
    c, s = np.cos(a[0]), np.sin(a[0])
    half = a[1] ** 2 / 2
    return (
        np.stack([c, -s * a[1], -s * a[2] - c * half]),
        np.stack([s, c * a[1], c * a[2] - s * half]),
    )


def constant(value, motions):
    """A series that does not move."""
    value = np.asarray(value, LONG)
    found = np.zeros((3, motions, *value.shape), LONG)
    found[0] = value
    return found


def rate(a):
    """The derivative; its last coefficient is not known and zero."""
    return np.stack([a[1], 2 * a[2], 0 * a[2]])


def turned(axis, angle):
    """The matrices of a rotation about a fixed axis by a series of angles."""
    x, y, z = np.asarray(axis, LONG) / np.sqrt((np.asarray(axis, LONG) ** 2).sum())
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]], LONG)
    c, s = cos_sin(angle)
    c, s = c[..., None, None], s[..., None, None]
    return constant(np.eye(3) + cross @ cross, angle.shape[1]) + s * cross - c * (cross @ cross)


def solved(matrix, right):
    """The solution of a linear system in 80 bits: rows of equal size, the largest pivots."""
    a, b = np.array(matrix, LONG), np.array(right, LONG)
    b = b[:, None] if b.ndim == 1 else b
    size = abs(a).max(axis=1)
    size[size == 0] = 1
    a, b = a / size[:, None], b / size[:, None]
    n = len(a)
    for k in range(n):
        p = k + int(np.argmax(abs(a[k:, k])))
        a[[k, p]], b[[k, p]] = a[[p, k]], b[[p, k]]
        factor = a[k + 1 :, k] / a[k, k]
        a[k + 1 :] -= factor[:, None] * a[k]
        b[k + 1 :] -= factor[:, None] * b[k]
    for k in reversed(range(n)):
        b[k] = (b[k] - a[k, k + 1 :] @ b[k + 1 :]) / a[k, k]
    return b[:, 0] if np.ndim(right) == 1 else b


def pivots(matrix, sizes, threshold=1e-13):
    """Rows and columns of the largest pivots: the rank is how many there are.

    Rows and columns are scaled by the sizes of what was added up in them, so that neither units
    nor rounding decide.
    """
    a, size = np.array(matrix, LONG), np.array(sizes, LONG)
    for _ in range(3):
        for axis in (1, 0):
            scale = size.max(axis=axis, keepdims=True, initial=0)
            scale[scale == 0] = 1
            a, size = a / scale, size / scale
    rows, columns = [], []
    for _ in range(min(a.shape)):
        i, j = np.unravel_index(np.argmax(abs(a)), a.shape)
        if abs(a[i, j]) < threshold:
            break
        rows.append(int(i))
        columns.append(int(j))
        a = a - np.outer(a[:, j], a[i]) / a[i, j]
        a[i], a[:, j] = 0, 0
    return rows, columns
