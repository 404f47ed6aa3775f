"""Quaternions of rotations, without `scipy.spatial`, whose import takes longer than a page."""

from __future__ import annotations

import numpy as np


def to_quaternions(rotations: np.ndarray) -> np.ndarray:
    """Return the unit quaternions (…, 4) of rotations (…, 3, 3), the scalar part last.

    They are divided by their largest components, whose squares are no differences of the others:
    S. W. Shepperd, Quaternion from rotation matrix, Journal of Guidance and Control 1 (1978)
    223-224.
    """
    trace = np.trace(rotations, axis1=-2, axis2=-1)[..., None, None]
    products = np.empty((*rotations.shape[:-2], 4, 4))  # 4 q qᵀ
    products[..., :3, :3] = rotations + np.swapaxes(rotations, -2, -1) + (1.0 - trace) * np.eye(3)
    products[..., 3:, 3:] = 1.0 + trace
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        products[..., k, 3] = products[..., 3, k] = rotations[..., j, i] - rotations[..., i, j]
    largest = np.argmax(np.diagonal(products, axis1=-2, axis2=-1), axis=-1)
    rows: np.ndarray = np.take_along_axis(products, largest[..., None, None], axis=-2)[..., 0, :]
    rows /= np.linalg.norm(rows, axis=-1, keepdims=True)
    return rows
