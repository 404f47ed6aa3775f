"""Large models, written down because SymPy would take minutes or hours to derive them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any
from zlib import crc32

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
    arm: Vector,
    turning: list[Vector],
    moving: list[Vector],
    omega: Vector,
    alpha: Vector,
    pull: Vector,
) -> tuple[list[Vector], Vector]:
    """Return partial velocities and acceleration of a body's point, so far from its joint."""
    swing = plus(cross(alpha, arm), cross(omega, cross(omega, arm)))
    partial = [plus(v, cross(w, arm)) for v, w in zip(moving, turning, strict=True)]
    return partial, plus(pull, swing)


def turned(axis: int, angle: Any) -> list[Vector]:
    """Return the axes of a body that has turned about x, y or z, along those before."""
    s, c, j, k = sm.sin(angle), sm.cos(angle), (axis + 1) % 3, (axis + 2) % 3
    axes = [list(row) for row in UNIT]
    axes[j][j], axes[j][k] = c, s
    axes[k][j], axes[k][k] = product(-1, s), c
    return axes


def below(distance: Any) -> Vector:
    """Return the way from a rod's joint to a point below it."""
    return [sm.S.Zero, sm.S.Zero, product(-1, distance)]


UNIT = [[sm.S.One if i == j else sm.S.Zero for j in range(3)] for i in range(3)]


class Chain:
    """Kane's equations of a chain, body by body.

    Velocities and accelerations are taken along each body's own axes, from the body inside: shared
    sub-expressions are shared objects, and nothing is multiplied out.
    """

    def __init__(self, g: Any) -> None:
        zero = sm.S.Zero
        self.coordinates: list[Any] = []
        self.speeds: list[Any] = []
        self.rates: list[Any] = []
        self.matrix: list[list[list[Any]]] = []
        self.forcing: list[list[Any]] = []
        # Of the joint inside: partial velocities and the acceleration without u'; it falls upwards.
        self._turning: list[Vector] = []
        self._moving: list[Vector] = []
        self._omega, self._alpha, self._pull = [zero] * 3, [zero] * 3, [zero, zero, g]

    def add(
        self,
        axes: list[Vector],
        partial: list[Vector],
        own: Vector,
        rate: Vector,
        mass: Any,
        inertia: list[Vector],
        centre: Vector,
        end: Vector,
    ) -> None:
        """Add a body at the end of the last one.

        Its axes are along those of the last one, all else along its own: the partial angular
        velocities and the angular velocity against the last one, with the rate of its components
        without u'; inertia about the mass centre; the ways from its joint to that and to the end.
        """
        count = len(partial)
        self._turning = [along(axes, v) for v in self._turning] + partial
        self._moving = [along(axes, v) for v in self._moving] + [[sm.S.Zero] * 3] * count
        self._omega = omega = plus(along(axes, self._omega), own)
        self._alpha = plus(along(axes, self._alpha), plus(rate, cross(omega, own)))
        self._pull = along(axes, self._pull)
        body = (self._turning, self._moving, omega, self._alpha, self._pull)
        moment = plus(along(inertia, self._alpha), cross(omega, along(inertia, omega)))
        velocities, acceleration = at(centre, *body)
        self.matrix += [[] for _ in range(count)]
        self.forcing += [[] for _ in range(count)]
        for i, (v, w) in enumerate(zip(velocities, self._turning, strict=True)):
            self.forcing[i] += [
                product(-1, mass, dot(v, acceleration)),
                product(-1, dot(w, moment)),
            ]
            spun = along(inertia, w)
            self.matrix[i] += [[] for _ in range(i + 1 - len(self.matrix[i]))]
            for j in range(i + 1):
                self.matrix[i][j] += [
                    product(mass, dot(v, velocities[j])),
                    dot(spun, self._turning[j]),
                ]
        self._moving, self._pull = at(end, *body)

    def model(self, name: str, source: str, specifieds: Any, constants: Any, values: Any) -> Model:
        """Return what there is as a model."""
        full = [[total(cell) for cell in row] for row in self.matrix]
        n = len(full)
        constants = sorted(constants, key=sm.default_sort_key)
        return Model(
            name=name,
            coordinates=self.coordinates,
            speeds=self.speeds,
            specifieds=list(specifieds),
            constants=constants,
            mass_matrix=[full[max(i, j)][min(i, j)] for i in range(n) for j in range(n)],
            forcing=[total(terms) for terms in self.forcing],
            coordinate_derivatives=self.rates,
            positive_definite=True,
            values=[float(values(s.name)) for s in constants],
            about={"sympy": sm.__version__, "source": source},
        )


def rods_written_down(n: int, *, universal: bool = False) -> Model:
    """Return the chain of rods of `harness.models.rods` by Kane's method, body by body.

    With a `universal` first joint, that has two angles whose rates are its speeds.
    """
    m, length, ix, iy, iz = (sm.symbols(f"{name}0:{n}") for name in ("m", "l", "I_x", "I_y", "I_z"))
    g, zero = sm.Symbol("g"), sm.S.Zero
    chain = Chain(g)
    for k in range(n):
        angles, own = (
            list(dynamicsymbols(f"a{k} b{k} c{k}")),
            list(dynamicsymbols(f"u{k} v{k} w{k}")),
        )
        partial, spin, rate = UNIT, own, [zero] * 3
        if universal and k == 0:
            angles, own = angles[:2], own[:2]
            (sa, sb), (ca, cb), (sc, cc) = (
                map(sm.sin, angles),
                map(sm.cos, angles),
                (zero, sm.S.One),
            )
            partial = [[cb, zero, sb], UNIT[1]]
            spin = [product(own[0], cb), own[1], product(own[0], sb)]
            rate = [product(-1, *own, sb), zero, product(*own, cb)]
            chain.rates += own
        else:
            (sa, sb, sc), (ca, cb, cc) = map(sm.sin, angles), map(sm.cos, angles)
            sine = product(own[0], cc) - product(own[1], sc)
            chain.rates += [
                sine / cb,
                product(own[0], sc) + product(own[1], cc),
                own[2] - sine * sb / cb,
            ]
        axes = [  # of this rod, along those of the one above
            [product(cb, cc), ca * sc + product(sa, sb, cc), sa * sc - product(ca, sb, cc)],
            [product(-1, cb, sc), ca * cc - product(sa, sb, sc), sa * cc + product(ca, sb, sc)],
            [sb, product(-1, sa, cb), product(ca, cb)],
        ]
        chain.coordinates += angles
        chain.speeds += own
        inertia = [[ix[k], zero, zero], [zero, iy[k], zero], [zero, zero, iz[k]]]
        chain.add(axes, partial, spin, rate, m[k], inertia, below(length[k] / 2), below(length[k]))
    typical = {"m": 1.0, "l": 0.5, "I_x": 0.021, "I_y": 0.022, "I_z": 0.002, "g": 9.81}
    return chain.model(
        f"rods{'-universal' * universal}-{n}",
        "rods in space, written down by hand",
        (),
        [g, *m, *length, *ix, *iy, *iz],
        lambda name: typical[name.rstrip("0123456789")],
    )


def arm_written_down(n: int) -> Model:
    """Return an arm of n revolute joints in space, about x, y and z in turn, driven by torques.

    Each link has six moments of inertia and its mass centre anywhere.
    """
    g, zero = sm.Symbol("g"), sm.S.Zero
    torques = dynamicsymbols(f"T0:{n}")
    chain, constants = Chain(g), [g]
    for k in range(n):
        q, u = dynamicsymbols(f"q{k} u{k}")
        m, *inertia, cx, cy, cz, l = sm.symbols(
            f"m{k} I{k}_xx I{k}_yy I{k}_zz I{k}_xy I{k}_yz I{k}_zx c{k}_x c{k}_y c{k}_z l{k}"
        )
        constants += [m, *inertia, cx, cy, cz, l]
        xx, yy, zz, xy, yz, zx = inertia
        own = [zero] * 3
        own[k % 3] = u
        chain.coordinates.append(q)
        chain.speeds.append(u)
        chain.rates.append(u)
        chain.add(
            turned(k % 3, q),
            [UNIT[k % 3]],
            own,
            [zero] * 3,
            m,
            [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]],
            [cx, cy, cz],
            [zero, zero, l],
        )
    for terms, torque in zip(chain.forcing, torques, strict=True):
        terms.append(torque)
    typical = {"g": 9.81, "m": 1.0, "I": 0.02, "c": 0.1, "l": 0.3}

    def value(name: str) -> float:
        near = 0.8 + 0.4 * crc32(name.encode()) / 2**32  # somewhat different for each
        axes = name.partition("_")[2]
        product_of_inertia = name[0] == "I" and axes[0] != axes[1]
        return (
            typical[name[0]] * (0.1 if product_of_inertia else 1.0) * (near if name != "g" else 1.0)
        )

    return chain.model(
        f"arm-{n}", "an arm in space, written down by hand", torques, constants, value
    )
