"""Collocation methods as data: the unknowns of an interval, and the formulas of its points.

Times within an interval are fractions of its length h. Its *slots* are the times at which a state
vector, or its derivative, is unknown; neighbours share the slots of their common node. The state
and derivative at a collocation point are Σ coefficient · slot · h^power.

=================  =========================================================================
backward Euler     Radau with one point
midpoint           Gauss with one point: x = (x₀ + x₁)/2, x' = (x₁ − x₀)/h
Hermite–Simpson    cubic with slopes as unknowns, x_c = (x₀ + x₁)/2 + h (v₀ − v₁)/8; the points
                   are those of Lobatto IIIA with three stages
Radau              polynomial of degree K through the start and K Radau IIA points
=================  =========================================================================

Every method enforces constraints at the nodes, with their multipliers at the collocation points.
The points of Radau include the ends of intervals. Those of the midpoint rule do not: the constraint
force at the midpoint makes the next node satisfy the constraints, which is a symmetric step and so
of order 2 (Jay 1998). The points of Hermite–Simpson include the start, where the constraints hold
already; their rates determine the multipliers there. Otherwise the multipliers could change by any
multiple of (1, −1/2, 1) along each interval and affect the motion by its errors only.

References
----------
E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., IV.5.
J. T. Betts, Practical Methods for Optimal Control and Estimation Using Nonlinear Programming,
2nd ed., 4.5 (Hermite–Simpson, separated form).
D. Garg et al., Direct trajectory optimization and costate estimation of finite-horizon and
infinite-horizon optimal control problems using a Radau pseudospectral method, Comput. Optim. Appl.
49 (2011) 335–358.
L. O. Jay, Structure preservation for constrained dynamics with super partitioned additive
Runge–Kutta methods, SIAM J. Sci. Comput. 20 (1998) 416–446, and Convergence of a class of
Runge–Kutta methods for differential-algebraic systems of index 2, BIT 33 (1993) 137–150 (Lobatto
IIIA).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from numpy.polynomial import legendre

# A slot of the interval, its coefficient (None: different at each point, see `Points.coefficients`)
# and the power of h.
Term = tuple[int, float | None, int]


@dataclass(frozen=True, eq=False)
class Points:
    """Collocation points of one kind on all intervals; they share machine code."""

    # The terms of x and x', which refer to the rows of `slots`.
    state: tuple[Term, ...]
    rate: tuple[Term, ...]
    slots: np.ndarray  # (y, points)
    controls: np.ndarray  # (points,), the slots of the controls
    # (c, points), for the terms whose coefficient is None, those of `state` first.
    coefficients: np.ndarray
    # (points,), their times, the lengths h of their intervals and the quadrature weights, as
    # fractions of the duration.
    fractions: np.ndarray
    lengths: np.ndarray
    weights: np.ndarray
    # The equations that hold at the points: 'all', 'motion' (without constraints), 'constraints'
    # (alone), or 'start' (those of motion with the rates of the constraints).
    rows: str = "all"

    def part(self, points: slice, rows: str = "all") -> Points:
        """Return some of the points."""
        return replace(
            self,
            slots=self.slots[:, points],
            controls=self.controls[points],
            coefficients=self.coefficients[:, points],
            fractions=self.fractions[points],
            lengths=self.lengths[points],
            weights=self.weights[points],
            rows=rows,
        )


@dataclass(frozen=True)
class Slots:
    """Values at the nodes of a mesh, if any, then at each of some fractions of its intervals.

    A second block of nodes has the slopes there.
    """

    blocks: int
    inner: tuple[float, ...] = ()

    def times_on(self, mesh: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the times of the slots and whether they are slopes.

        `mesh` holds the nodes as fractions of the duration, M + 1 of them.
        """
        h, starts = np.diff(mesh), mesh[:-1]
        times = np.concatenate([*[mesh] * self.blocks, *(starts + c * h for c in self.inner)])
        slopes = np.zeros(len(times), dtype=bool)
        slopes[len(mesh) : self.blocks * len(mesh)] = True
        return times, slopes

    def of_intervals(self, intervals: int) -> np.ndarray:
        """Return the slots of each interval, shape (y, M), in the order of `basis`."""
        k, first = np.arange(intervals), self.blocks * (intervals + 1)
        if self.blocks == 2:
            return np.array([k, k + 1, intervals + 1 + k, intervals + 2 + k])
        inner = [first + j * intervals + k for j in range(len(self.inner))]
        return np.array([k, *inner, k + 1] if self.blocks else inner)

    def basis(self, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the interpolant at fractions s of an interval.

        The values (y, len(s)) are of each slot of an interval; the powers (y,) of h go with them.
        """
        if self.blocks == 2:
            values = [(1 + 2 * s) * (1 - s) ** 2, s**2 * (3 - 2 * s), s * (1 - s) ** 2]
            return np.array([*values, -(s**2) * (1 - s)]), np.array([0, 0, 1, 1])
        nodes = np.array([0.0, *self.inner, 1.0] if self.blocks else self.inner)
        return lagrange(nodes, s), np.zeros(len(nodes), dtype=int)


@dataclass(frozen=True)
class Scheme:
    """A collocation method."""

    name: str  # 'radau', 'midpoint' or 'hermite-simpson'
    order: int = 1  # number of points of Radau; 1 for the others

    @property
    def convergence(self) -> int:
        """The order of the states' error at the nodes in the length of the intervals."""
        return {"radau": 2 * self.order - 1, "midpoint": 2, "hermite-simpson": 4}[self.name]

    @property
    def states(self) -> Slots:
        """The slots of the states."""
        if self.name == "hermite-simpson":
            return Slots(2)
        return Slots(1, tuple(radau_points(self.order)[:-1].tolist()))

    @property
    def controls(self) -> Slots:
        """The slots of the controls."""
        if self.name == "radau":
            return Slots(0, tuple(radau_points(self.order).tolist()))
        return Slots(int(self.name == "hermite-simpson"), (0.5,))

    # -- collocation points ----------------------------------------------------------------------

    def points(self, mesh: np.ndarray, *, constrained: bool = False) -> tuple[Points, ...]:
        """Return the collocation points on a mesh of nodes, as fractions of the duration.

        The first entry of 'radau' and 'midpoint' has a point in each interval in order, K times for
        K points. If motions are `constrained`, a second entry of 'midpoint' has the constraints.
        """
        h, M, starts = np.diff(mesh), len(mesh) - 1, mesh[:-1]
        k = np.arange(M)
        slots = self.states.of_intervals(M)
        if self.name == "radau":
            K = self.order
            c = radau_points(K)
            D, w = derivatives(np.append(0.0, c)), quadrature(c)
            order = [[j, *(i for i in range(K + 1) if i != j)] for j in range(1, K + 1)]
            return (
                Points(
                    state=((0, 1.0, 0),),
                    rate=tuple((y, None, -1) for y in range(K + 1)),
                    slots=np.concatenate([slots[row] for row in order], axis=1),
                    controls=np.arange(K * M),
                    coefficients=np.repeat(
                        np.array([D[row[0], row] for row in order]).T, M, axis=1
                    ),
                    fractions=np.concatenate([starts + cj * h for cj in c]),
                    lengths=np.tile(h, K),
                    weights=np.concatenate([wj * h for wj in w]),
                ),
            )
        none = np.empty((0, M))
        if self.name == "midpoint":
            state, rate = ((0, 0.5, 0), (1, 0.5, 0)), ((0, -1.0, -1), (1, 1.0, -1))
            middles = Points(state, rate, slots, k, none, starts + 0.5 * h, h, h)
            if not constrained:
                return (middles,)
            ends = Points(
                ((0, 1.0, 0),), (), slots[1:], k, none, mesh[1:], h, 0.0 * h, "constraints"
            )
            return replace(middles, rows="motion"), ends
        nodes = np.arange(M + 1)
        simpson = np.zeros(M + 1)
        simpson[:-1] += h / 6
        simpson[1:] += h / 6
        x = ((0, 0.5, 0), (1, 0.5, 0), (2, 0.125, 1), (3, -0.125, 1))
        v = ((0, -1.5, -1), (1, 1.5, -1), (2, -0.25, 0), (3, -0.25, 0))
        ends = Points(
            ((0, 1.0, 0),), ((1, 1.0, 0),), np.array([nodes, M + 1 + nodes]), nodes,
            np.empty((0, M + 1)), mesh, np.append(h, h[-1]), simpson,
        )  # fmt: skip
        middles = Points(x, v, slots, M + 1 + k, none, starts + 0.5 * h, h, h * (2 / 3))
        if not constrained:
            return ends, middles
        return ends.part(slice(0, 1), "start"), ends.part(slice(1, None)), middles


METHODS = ("radau", "hermite-simpson", "midpoint", "backward-euler")


def scheme_of(method: str, order: int) -> Scheme:
    """Return the scheme of a method's name."""
    if method == "radau":
        return Scheme("radau", order)
    return Scheme("radau", 1) if method == "backward-euler" else Scheme(method)


@cache
def radau_points(K: int) -> np.ndarray:
    """Return the K Radau points in (0, 1], the last of which is 1.

    1 − 2 c are the roots of P_{K−1} + P_K, −1 among them.
    """
    flipped = legendre.legroots(legendre.legadd([0.0] * (K - 1) + [1.0], [0.0] * K + [1.0]))
    c: np.ndarray = np.sort((1.0 - np.real(flipped)) / 2)
    c[-1] = 1.0
    return c


def lagrange(nodes: np.ndarray, s: np.ndarray) -> np.ndarray:
    """Return the Lagrange polynomials of some nodes at s, shape (nodes, len(s))."""
    rows = []
    for i, node in enumerate(nodes):
        remaining = np.delete(nodes, i)
        rows.append(np.prod((s[:, None] - remaining) / (node - remaining), axis=1))
    return np.array(rows)


def derivatives(nodes: np.ndarray) -> np.ndarray:
    """Return the derivatives of the Lagrange polynomials, D[j, i] that of i at node j.

    By barycentric weights; the rows sum to zero, as the derivative of a constant (J.-P. Berrut and
    L. N. Trefethen, Barycentric Lagrange interpolation, SIAM Rev. 46 (2004) 501–517, §9).
    """
    gaps = nodes[:, None] - nodes
    np.fill_diagonal(gaps, 1.0)
    weights = 1.0 / gaps.prod(axis=1)
    D: np.ndarray = weights / weights[:, None] / gaps
    np.fill_diagonal(D, 0.0)
    np.fill_diagonal(D, -D.sum(axis=1))
    return D


def quadrature(nodes: Sequence[float] | np.ndarray) -> np.ndarray:
    """Return the weights that integrate polynomials through some nodes over [0, 1] exactly."""
    x, w = legendre.leggauss(len(nodes))
    return lagrange(np.asarray(nodes), (1.0 + x) / 2) @ (w / 2)
