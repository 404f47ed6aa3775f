"""Scalar and vector products of SymPy's vectors that leave out products with zero."""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sm
from sympy.physics.mechanics import ReferenceFrame, Vector

if TYPE_CHECKING:
    from pydy._sympy_types import Expression


def dot(a: Vector, b: Vector) -> Expression:
    """Return the scalar product, the same expression as ``a.dot(b)``.

    SymPy multiplies matrices, and asks whether each factor of a zero is finite. For velocities of
    points at the end of a chain this takes seconds.
    """
    total = sm.S.Zero
    for components, frame in a.args:
        for others, other in b.args:
            total += _dot(_rotated(others, other, frame), components)
    return total


def cross(a: Vector, b: Vector) -> Vector:
    """Return the vector product, the same vector as ``a.cross(b)``, in the frames of `b`."""
    parts = []
    for others, frame in b.args:
        x = [sm.S.Zero] * 3
        for components, own in a.args:
            x = [p + q for p, q in zip(x, _rotated(components, own, frame), strict=True)]
        product = [
            _product(x[i], others[k]) - _product(x[k], others[i])
            for i, k in ((1, 2), (2, 0), (0, 1))
        ]
        parts.append((sm.Matrix(product), frame))
    return Vector(parts)


def _rotated(components: sm.Matrix, frame: ReferenceFrame, target: ReferenceFrame) -> Expression:
    if frame is target:
        return list(components)
    rotation = frame.dcm(target)  # its rows are the axes of `frame`
    return [_dot(components, rotation[:, k]) for k in range(3)]


def _dot(x: Expression, y: Expression) -> Expression:
    return sm.Add(*(_product(p, q) for p, q in zip(x, y, strict=True)))


def _product(x: Expression, y: Expression) -> Expression:
    return sm.S.Zero if sm.S.Zero in (x, y) else x * y
