"""Large models, written down because SymPy would take minutes or hours to derive them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy as sm
from sympy.physics.mechanics import dynamicsymbols

from harness.model import Model


def total(terms: Iterable[Any]) -> Any:
    """Return a sum as it stands, zeros left out."""
    kept = [term for term in terms if term is not sm.S.Zero]
    return sm.Add(*kept, evaluate=False) if len(kept) > 1 else kept[0] if kept else sm.S.Zero


def product(*factors: Any) -> Any:
    """Return a product as it stands, zeros and ones left out."""
    if any(factor is sm.S.Zero for factor in factors):
        return sm.S.Zero
    kept = [factor for factor in factors if factor is not sm.S.One]
    return sm.Mul(*kept, evaluate=False) if len(kept) > 1 else kept[0] if kept else sm.S.One


def pendulum_written_down(n: int) -> Model:
    """Return the same pendulum without deriving it, which takes SymPy minutes at 50 links.

    The terms are those that Kane's method gives, one for each mass below a joint, none collected.
    """
    m, length, g = sm.symbols(f"m0:{n + 1}"), sm.symbols(f"l0:{n}"), sm.Symbol("g")
    q, u = (dynamicsymbols(f"{name}0:{n + 1}") for name in "qu")
    force = dynamicsymbols("F")
    s, c = [sm.sin(angle) for angle in q], [sm.cos(angle) for angle in q]
    links = range(1, n + 1)

    matrix = [[sm.S.Zero] * (n + 1) for _ in range(n + 1)]
    matrix[0][0] = total(m)
    loads: list[list[Any]] = [[] for _ in range(n + 1)]
    loads[0].append(force)
    for i in links:
        a = length[i - 1]
        matrix[0][i] = matrix[i][0] = total(product(-1, a, m[k], c[i]) for k in range(i, n + 1))
        matrix[i][i] = total(product(a**2, m[k]) for k in range(i, n + 1))
        loads[0] += [product(-1, a, m[k], u[i] ** 2, s[i]) for k in range(i, n + 1)]
        loads[i] += [product(g, a, m[k], s[i]) for k in range(i, n + 1)]
        for j in links:
            if j == i:
                continue
            below = range(max(i, j), n + 1)
            b = length[j - 1]
            across = s[i] * s[j] + c[i] * c[j]
            matrix[i][j] = total(product(a, b, m[k], across) for k in below)
            turned = s[i] * c[j] - s[j] * c[i]
            loads[i] += [product(-1, a, b, m[k], turned, u[j] ** 2) for k in below]
    return Model(
        name=f"pendulum-{n}",
        coordinates=list(q),
        speeds=list(u),
        specifieds=[force],
        constants=sorted([g, *length, *m], key=sm.default_sort_key),
        mass_matrix=[entry for row in matrix for entry in row],
        forcing=[total(terms) for terms in loads],
        coordinate_derivatives=list(u),
        positive_definite=True,
        values=[9.81, *[1.0 / n] * (2 * n + 1)],  # g sorts first
        about={"sympy": sm.__version__, "source": "a pendulum on a cart, written down by hand"},
    )


# A vector is a list of its three components along the axes of some body.
Vector = list[Any]


def cross(a: Vector, b: Vector) -> Vector:
    """Return a × b."""
    return [
        total([product(a[i], b[j]), product(-1, a[j], b[i])]) for i, j in ((1, 2), (2, 0), (0, 1))
    ]


def dot(a: Vector, b: Vector) -> Any:
    """Return a · b."""
    return total(product(x, y) for x, y in zip(a, b, strict=True))


def plus(*vectors: Vector) -> Vector:
    """Return a sum of vectors."""
    return [total(parts) for parts in zip(*vectors, strict=True)]


def along(axes: list[Vector], vector: Vector) -> Vector:
    """Return the components along other axes."""
    return [dot(axis, vector) for axis in axes]


def at(
    distance: Any,
    turning: list[Vector],
    moving: list[Vector],
    omega: Vector,
    alpha: Vector,
    pull: Vector,
) -> tuple[list[Vector], Vector]:
    """Return partial velocities and acceleration of a rod's point below its joint."""
    arm = [sm.S.Zero, sm.S.Zero, product(-1, distance)]
    swing = plus(cross(alpha, arm), cross(omega, cross(omega, arm)))
    partial = [plus(v, cross(w, arm)) for v, w in zip(moving, turning, strict=True)]
    return partial, plus(pull, swing)


def rods_written_down(n: int) -> Model:
    """Return the chain of rods of `harness.models.rods` by Kane's method, body by body.

    Velocities and accelerations are taken along each rod's own axes, from the rod above: shared
    sub-expressions are shared objects, and nothing is multiplied out.
    """
    m, length, ix, iy, iz = (sm.symbols(f"{name}0:{n}") for name in ("m", "l", "I_x", "I_y", "I_z"))
    g = sm.Symbol("g")
    zero = sm.S.Zero
    coordinates, speeds, rates = [], [], []
    # Of the joint above: partial velocities and the acceleration without u'; it falls upwards.
    turning: list[Vector] = []
    moving: list[Vector] = []
    omega, alpha, pull = [zero] * 3, [zero] * 3, [zero, zero, g]
    matrix = [[[] for _ in range(3 * n)] for _ in range(3 * n)]
    forcing: list[list[Any]] = [[] for _ in range(3 * n)]
    for k in range(n):
        angles = dynamicsymbols(f"a{k} b{k} c{k}")
        own = list(dynamicsymbols(f"u{k} v{k} w{k}"))
        (sa, sb, sc), (ca, cb, cc) = map(sm.sin, angles), map(sm.cos, angles)
        sine = product(own[0], cc) - product(own[1], sc)
        rates += [sine / cb, product(own[0], sc) + product(own[1], cc), own[2] - sine * sb / cb]
        axes = [  # of this rod, along those of the one above
            [product(cb, cc), ca * sc + product(sa, sb, cc), sa * sc - product(ca, sb, cc)],
            [product(-1, cb, sc), ca * cc - product(sa, sb, sc), sa * cc + product(ca, sb, sc)],
            [sb, product(-1, sa, cb), product(ca, cb)],
        ]

        unit = [[sm.S.One if i == j else zero for j in range(3)] for i in range(3)]
        turning = [along(axes, v) for v in turning] + unit
        moving = [along(axes, v) for v in moving] + [[zero] * 3] * 3
        omega = plus(along(axes, omega), own)
        alpha = plus(along(axes, alpha), cross(omega, own))
        pull = along(axes, pull)
        inertia = [ix[k], iy[k], iz[k]]
        momentum = [product(i, w) for i, w in zip(inertia, omega, strict=True)]
        moment = plus(
            [product(i, a) for i, a in zip(inertia, alpha, strict=True)], cross(omega, momentum)
        )

        body = (turning, moving, omega, alpha, pull)
        centre, acceleration = at(length[k] / 2, *body)
        for i, (v, w) in enumerate(zip(centre, turning, strict=True)):
            forcing[i] += [product(-1, m[k], dot(v, acceleration)), product(-1, dot(w, moment))]
            spun = [product(a, b) for a, b in zip(inertia, w, strict=True)]
            for j in range(i + 1):
                matrix[i][j] += [product(m[k], dot(v, centre[j])), dot(spun, turning[j])]
        moving, pull = at(length[k], *body)
        coordinates += angles
        speeds += own
    full = [[total(cell) for cell in row] for row in matrix]
    typical = {"m": 1.0, "l": 0.5, "I_x": 0.021, "I_y": 0.022, "I_z": 0.002, "g": 9.81}
    constants = sorted([g, *m, *length, *ix, *iy, *iz], key=sm.default_sort_key)
    return Model(
        name=f"rods-{n}",
        coordinates=coordinates,
        speeds=speeds,
        specifieds=[],
        constants=constants,
        mass_matrix=[full[max(i, j)][min(i, j)] for i in range(3 * n) for j in range(3 * n)],
        forcing=[total(terms) for terms in forcing],
        coordinate_derivatives=rates,
        positive_definite=True,
        values=[typical[s.name.rstrip("0123456789")] for s in constants],
        about={"sympy": sm.__version__, "source": "rods with ball joints, written down by hand"},
    )
