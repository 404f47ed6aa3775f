"""Contacts as rows of accelerations, J u' + b = 0, and their forces, on the graph of a mechanism.

Rows are numbered contact by contact, the normal one first. With W = M⁻¹ Jᵀ and u' = a without
contact forces, the accelerations of the rows are J a + b + J W λ.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from copy import copy
from dataclasses import replace
from typing import Any

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef

from pydy._backends import compile_program
from pydy._checks import describe
from pydy._forks import cached_property
from pydy._graph import (
    Graph,
    SymPyReader,
    jacobian,
    lower,
    rounding_bounds,
    sizes_of_terms,
    solve_accelerations,
    substitute,
)
from pydy._kernel import Kernel
from pydy._mechanics import EquationGraph, Equations, dot, find_symbols
from pydy._rank import DIGITS, ROUNDING, or_one, rank_of
from pydy.contact.conditions import Contact, InfeasibleError
from pydy.contact.smooth import Switched, switched
from pydy.contact.tuning import WITHIN


class StartError(InfeasibleError):
    """A gap is negative at the first time."""


Parts = dict[str, tuple[tuple[int, ...], Sequence[int]]]  # shapes and nodes, by name


_LATE = ("free", "terms", "square", "moves")  # what takes M⁻¹, which open contacts do without


class Numbers:
    """The rows at one state: what takes M⁻¹, and the others, are evaluated when they are wanted."""

    gap: np.ndarray  # (contacts,); zero without one
    near: np.ndarray  # (contacts,), bounds on the rounding errors of the gaps, in units of 2⁻⁵²
    speed: np.ndarray  # (rows,), J u + …
    slow: np.ndarray  # (rows,), bounds on the rounding errors of the speeds
    kinematics: np.ndarray  # (coordinates, speeds), ∂q'/∂u
    gradient: np.ndarray  # (contacts, coordinates), of the gaps
    normal: np.ndarray  # (contacts,), known normal forces
    restitution: np.ndarray
    mu: np.ndarray
    mu_static: np.ndarray
    free: np.ndarray  # (rows,), J a + b
    terms: np.ndarray  # (rows,), how large that would be if none of its terms cancelled
    square: np.ndarray  # (rows, rows), J W
    moves: np.ndarray  # (speeds, rows), W

    def __init__(self, rows: ContactRows, *at: np.ndarray) -> None:
        self._rows, self._at = rows, at

    def __getattr__(self, name: str) -> Any:  # of what has not been evaluated
        if name not in Numbers.__annotations__:
            raise AttributeError(name)
        kernel = self._rows.late if name in _LATE else self._rows.early
        out, failed = kernel.evaluate(*self._at)
        out[failed] = np.nan
        vars(self).update(kernel.program.by_block(out[0]))
        return vars(self)[name]

    def is_closed(self, i: int) -> bool:
        """Return whether a gap is zero within its rounding errors."""
        return bool(self.gap[i] <= WITHIN * ROUNDING * self.near[i])

    def moving(self) -> np.ndarray:
        """Return the speeds, with those within their rounding errors set to zero."""
        return np.where(np.abs(self.speed) <= WITHIN * ROUNDING * self.slow, 0.0, self.speed)

    def after(self, impulses: np.ndarray) -> Numbers:
        """Return the numbers after impulses, which enlarge the terms that speeds are sums of."""
        found, slow = copy(self), self.slow + np.abs(self.square) @ np.abs(impulses)
        found.slow = slow
        return found

    def is_still(self, rows: Sequence[int], speeds: np.ndarray) -> bool:
        """Return whether sliding speeds are zero within the rounding of terms or earlier speeds."""
        sizes = np.maximum(self.slow[list(rows)], np.abs(self.speed[list(rows)]))
        return bool(np.linalg.norm(speeds) <= WITHIN * ROUNDING * np.linalg.norm(sizes))


class ContactRows:
    """The rows of all contacts of a mechanism, as nodes of the constants and specifieds."""

    def __init__(
        self,
        equations: Equations,
        contacts: Sequence[Contact],
        constants: Sequence[Any],
        specifieds: Sequence[Any],
    ) -> None:
        self.equations, self.contacts = equations, tuple(contacts)
        formed = _checked(equations)
        # For sliding in a plane: a direction in which each contact slides, and two speeds.
        self.references = {
            i: sm.symbols([f"{c.name}_reference_{k}" for k in ("1", "2", "least", "clear")])
            for i, c in enumerate(contacts)
            if c.stick is not None and c.stick.plane
        }
        # Of each row: what forces that are not determined differ from least.
        self.biases = [
            sm.Symbol(f"{c.name}_bias_{k}")
            for c in contacts
            for k in range(
                (c.unilateral is not None) + (0 if c.stick is None else 2 if c.stick.plane else 1)
            )
        ]
        # Of each contact: what rounding leaves of its speed where that begins; or zero. While
        # a gap is on the way up, its speed is watched, not the gap.
        self.rising = [sm.Symbol(f"{c.name}_rising") for c in contacts]
        self.hidden = [
            *(s for own in self.references.values() for s in own), *self.biases, *self.rising
        ]  # fmt: skip
        constants = [*constants, *self.hidden]
        self.checked: bytes | None = None  # the constants that coefficients were checked with
        more = [s for s in constants if s not in formed.constants]
        others = [s for s in specifieds if s not in formed.specifieds]
        self.formed = replace(
            formed,
            graph=formed.graph.copy(),
            constants=[*formed.constants, *more],
            specifieds=[*formed.specifieds, *others],
            simplified=None,
        )
        self.graph = self.formed.graph
        self._orders = (
            _places(specifieds, self.formed.specifieds),
            _places(constants[: -len(self.hidden)], self.formed.constants),
        )
        self._read()

    def _read(self) -> None:
        g, e = self.graph, self.equations
        states = (*e.coordinates, *e.speeds)
        self.symbols = self.formed.input_symbols(e.time, states)
        atoms = {symbol: node for node, symbol in self.symbols.items()}
        atoms.update((z, g.zero) for z in e.kinematics.zeros)
        atoms.update(zip(e.kinematics.coordinate_rates, self.formed.rates, strict=True))
        u = [g.input("x", len(e.coordinates) + k) for k in range(len(e.speeds))]
        du = [g.input("a", k) for k in range(len(u))]
        atoms.update(zip(e.speeds, u, strict=True))
        atoms.update(zip(e.kinematics.speed_rates, du, strict=True))
        read = SymPyReader(g, atoms, "the contacts")
        self.normal: list[int | None] = []
        self.tangent: list[list[int]] = []
        self.switched: list[Switched] = []  # gaps and sliding speeds that are written in pieces
        speeds: list[Any] = []
        gaps: list[int] = []
        for c in self.contacts:
            self.normal.append(None if c.unilateral is None else len(speeds))
            if c.unilateral is not None:
                read.what = f"the gap of {c.name!r}"
                gap = self._smooth(f"The gap of {c.name!r}", c.unilateral.gap, slopes=True)
                speeds.append(_rate(e, gap, c.name))
                gaps.append(read(gap))
            else:
                gaps.append(g.zero)
            self.tangent.append([])
            frame = getattr(e.mechanism, "frame", None)
            for part in () if c.stick is None else c.stick.speeds(frame):
                speed = e.kinematics.in_states(sm.sympify(part))
                speed = self._smooth(f"The sliding speed of {c.name!r}", speed, slopes=False)
                _check_linear(e, speed, c.name)
                self.tangent[-1].append(len(speeds))
                speeds.append(speed)
        read.what = "the contacts"
        self.speed_expressions = speeds
        self.speeds, self.gaps = read.all(speeds), gaps
        rates = read.all([s.diff(e.time) for s in speeds])
        self.drift = substitute(g, rates, dict.fromkeys(du, g.zero))
        self.jacobian = jacobian(g, self.speeds, u).dense()
        for row, c in zip(self.jacobian, self._owners(), strict=True):
            if all(n == g.zero for n in row):
                raise ValueError(f"The contact {c.name!r} moves with no speed of the system.")
        self.free = self._free()
        self.moves = self._moves()
        rows = zip(*(map(read, c.coefficients.values()) for c in self.contacts), strict=True)
        self.restitution, self.mu, self.static, self.pressed = map(list, rows)

    @property
    def identity(self) -> Any:
        """The key of the rows: their nodes, numbered when they were read."""
        g, groups = self.graph, (self.jacobian, self.moves, self.formed.matrix)
        parts = (self.gaps, self.speeds, self.drift, self.free, *(r for own in groups for r in own))
        parts += (self.mu, self.static, self.restitution, self.pressed)
        nodes = [(n, g.ops[n], g.args[n]) for n in g.reachable([n for part in parts for n in part])]
        inputs = [[*map(str, own)] for own in (self.formed.constants, self.formed.specifieds)]
        names = [(c.name, c.kind, c.stick is not None and c.stick.plane) for c in self.contacts]
        return names, inputs, nodes, [list(part) for part in parts]

    def _smooth(self, what: str, expression: Any, slopes: bool) -> Any:
        """Return an expression in a differentiable form, or refuse a jump in it by name."""
        moving = (self.equations.time, *self.equations.coordinates, *self.equations.speeds)
        found = switched(what, expression, moving, slopes)
        if found is None:
            return expression
        self.switched.append(found)
        return found.expression

    def _owners(self) -> list[Contact]:
        found = []
        for c, normal, tangent in zip(self.contacts, self.normal, self.tangent, strict=True):
            found += [c] * (len(tangent) + (normal is not None))
        return found

    def _free(self) -> list[int]:
        """Return u' without contact forces."""
        formed, g = self.formed, self.graph
        if formed.accelerations is not None:
            return list(formed.accelerations)
        kind = "ldl" if self.equations.matrices.positive_definite else "lu"
        beyond = solve_accelerations(g, formed.matrix, formed.residual_forcing, kind)
        return [g.add(*parts) for parts in zip(formed.start, beyond, strict=True)]

    def _moves(self) -> list[list[int]]:
        """Return for each row the change of u' by a unit of its force.

        With dependent speeds u_d = A u_i + …, by their rows of the matrix, the force of a row is
        Jᵢ + Aᵀ J_d.
        """
        g, e, matrix = self.graph, self.equations, self.formed.matrix
        dependent, independent = e.dependents.speed_columns, e.dependents.independent_columns
        columns = [list(row) for row in self.jacobian]
        if dependent:
            below = [matrix[k] for k in dependent]
            held = [[row[j] for j in dependent] for row in below]
            moved = [[g.neg(row[i]) for row in below] for i in independent]
            shares = dict(zip(independent, g.solve(held, moved, "lu"), strict=True))
            columns = [
                [
                    dot(g, shares[i], [row[j] for j in dependent], (row[i], 1.0))
                    if i in shares
                    else g.zero
                    for i in range(len(row))
                ]
                for row in columns
            ]
        kind = "ldl" if e.matrices.positive_definite and not dependent else "lu"
        return g.solve([list(row) for row in matrix], columns, kind)

    def _terms(self) -> list[int]:
        """Return the sizes of the terms of the rows' accelerations without contact forces.

        A body that is about to leave a curved surface has a weight and a centripetal acceleration,
        and the two cancel. With M u' = F these are J M⁻¹ F + b.
        """
        g, matrix = self.graph, self.formed.matrix
        shares = self.moves
        if self.equations.constraints.velocity:  # M is not symmetric
            turned = [list(column) for column in zip(*matrix, strict=True)]
            shares = g.solve(turned, [list(row) for row in self.jacobian], "lu")
        forces = sizes_of_terms(g, self.formed.forcing)
        return [
            g.add(dot(g, [g.call("abs", n) for n in share], forces), drift)
            for share, drift in zip(shares, sizes_of_terms(g, self.drift), strict=True)
        ]

    @cached_property
    def parts(self) -> Parts:
        """The blocks of `Numbers`, by name."""
        g, e = self.graph, self.equations
        q, u, k, c = (len(s) for s in (e.coordinates, e.speeds, self.speeds, self.contacts))
        by_q, by_u = ([g.input("x", j) for j in own] for own in (range(q), range(q, q + u)))
        square = [dot(g, row, moved) for row in self.jacobian for moved in self.moves]
        return {
            "gap": ((c,), self.gaps),
            "near": ((c,), rounding_bounds(g, self.gaps)),
            "speed": ((k,), self.speeds),
            "slow": ((k,), rounding_bounds(g, self.speeds)),
            "free": ((k,), [self.acceleration(g, row, self.free) for row in range(k)]),
            "terms": ((k,), self._terms()),
            "square": ((k, k), square),
            "moves": ((u, k), [moved[j] for j in range(u) for moved in self.moves]),
            "kinematics": ((q, u), jacobian(g, self.formed.rates, by_u).flat()),
            "gradient": ((c, q), jacobian(g, self.gaps, by_q).flat()),
            "normal": ((c,), self.pressed),
            "restitution": ((c,), self.restitution),
            "mu": ((c,), self.mu),
            "mu_static": ((c,), self.static),
        }

    @cached_property
    def early(self) -> Kernel:
        """The Kernel of the parts without M⁻¹."""
        return self._compiled(name for name in self.parts if name not in _LATE)

    @cached_property
    def late(self) -> Kernel:
        """The Kernel of the others."""
        return self._compiled(_LATE)

    def _compiled(self, names: Iterable[str]) -> Kernel:
        # From the first state on: interpreted, it would have other last bits in later motions.
        f = self.formed
        n = len(self.equations.coordinates) + len(self.equations.speeds)
        blocks = [(name, *self.parts[name]) for name in names]
        sizes = n, len(f.specifieds), len(f.constants)
        return compile_program(lower(self.graph, sizes, blocks), "llvm", {})

    @cached_property
    def _ways(self) -> dict[int, Any]:
        """For each friction at a point on a gap: the functions of both Jacobians, and the axes.

        The velocity has three rows, in the inertial frame.
        """
        g, e, found = self.graph, self.equations, {}
        u = [g.input("x", len(e.coordinates) + k) for k in range(len(e.speeds))]
        atoms = {symbol: node for node, symbol in self.symbols.items()}
        read = SymPyReader(g, atoms, "the contacts")
        for i, (c, normal) in enumerate(zip(self.contacts, self.normal, strict=True)):
            if normal is not None and c.stick is not None and c.stick.along:
                assert e.mechanism is not None
                frame = e.mechanism.frame
                vectors = [c.stick.velocity(frame), *c.stick.along]
                in_states = e.kinematics.in_states
                nodes = read.all([in_states(x) for v in vectors for x in v.to_matrix(frame)])
                rows = [*self.jacobian[normal], *jacobian(g, nodes[:3], u).flat(), *nodes[3:]]
                found[i] = g.evaluator(rows)
        return found

    @cached_property
    def cuts(self) -> dict[int, list[tuple[Any, Any]]]:
        """For each gap: its functions atan2(y, x), which jump by 2π where y = 0 and x < 0.

        With the function of y, x, the gap, and the gap with 2π more and less in place of that jump.
        """
        found: dict[int, list[tuple[Any, Any]]] = {}
        atoms = {symbol: node for node, symbol in self.symbols.items()}
        read = SymPyReader(self.graph.copy(), atoms, "the contacts")
        for i, c in enumerate(self.contacts):
            gap = sm.S.Zero if c.unilateral is None else c.unilateral.gap
            for f in sorted(gap.atoms(sm.atan2), key=sm.default_sort_key):
                turned = (gap.xreplace({f: f + n * sm.pi}) for n in (0, 2, -2))
                in_states = self.equations.kinematics.in_states
                nodes = read.all([in_states(part) for part in (*f.args, *turned)])
                found.setdefault(i, []).append((f, read.graph.evaluator(nodes)))
        return found

    def check_directions(self, closed: Iterable[int], values: dict[Any, float]) -> None:
        """Refuse friction at a point of a closed gap that is no length, or is not along it.

        The gap's rate is that of the point along a unit normal, whose part in directions in which
        the point can move follows. Where it is another point's, nothing is told.
        """
        inputs = {node: values.get(symbol, 0.0) for node, symbol in self.symbols.items()}
        for i in sorted(self._ways.keys() & set(closed)):
            found, n = self._ways[i](inputs, 1)[0], len(self.equations.speeds)
            if np.isfinite(found).all():
                moves, axes = found[n : 4 * n].reshape(3, n), found[4 * n :].reshape(-1, 3)
                _check_direction(self.contacts[i].name, found[:n], moves, axes)

    def numbers(self, t: float, x: np.ndarray, r: np.ndarray, p: np.ndarray) -> Numbers:
        """Return the rows at a state, with values of the definition's specifieds and constants."""
        r_order, p_order = self._orders  # inputs that it does not have are zero, or hidden
        r, p = np.append(r, 0.0)[r_order], np.append(p, 0.0)[p_order]
        return Numbers(self, np.array([t]), x[None].copy(), r[None], p)

    @cached_property
    def _checks_constants(self) -> bool:
        """Whether what a start checks, but for gaps, depends on the constants alone."""
        g, coefficients = self.graph, [*self.mu, *self.static, *self.restitution]
        held = g.inputs_of(coefficients) | (g.inputs_of(self.gaps) - {"t", "x"})
        return None not in self.normal and not held - {"p"}

    def are_open(self, gaps: Numbers, p: np.ndarray) -> bool:
        """Whether all gaps are open, where no more is to be checked: constants are as `checked`."""
        if self.checked != p.tobytes() or not self._checks_constants:
            return False
        return bool((gaps.gap > WITHIN * ROUNDING * gaps.near).all())

    def owners_of(self, held: Sequence[int]) -> dict[int, int]:
        """Return the contacts of the normal rows among the active rows, in their order."""
        owners = {n: i for i, n in enumerate(self.normal) if n is not None}
        return {n: owners[n] for n in held if n in owners}

    def rates(self, g: Graph, forces: Sequence[int]) -> list[int]:
        """Return u' with some forces of the rows."""
        moves = zip(*self.moves, strict=True)
        return [dot(g, own, forces, (a, 1.0)) for a, own in zip(self.free, moves, strict=True)]

    def acceleration(self, g: Graph, row: int, rates: Sequence[int]) -> int:
        """Return J u' + b of a row."""
        return g.add(dot(g, self.jacobian[row], rates), self.drift[row])


def by_name(parts: Parts, found: np.ndarray) -> dict[str, np.ndarray]:
    """Return the numbers (nodes, …) of all parts, each in its shape."""
    ends = np.cumsum([len(nodes) for _, nodes in parts.values()])
    pieces = zip(parts.items(), np.split(found, ends[:-1]), strict=True)
    return {name: own.reshape(*shape, *found.shape[1:]) for (name, (shape, _)), own in pieces}


def _places(given: Sequence[Any], symbols: Sequence[Any]) -> list[int]:
    """Return where each symbol is among those given; -1 if it is not."""
    found = {symbol: k for k, symbol in enumerate(given)}
    return [found.get(symbol, -1) for symbol in symbols]


def _check_direction(name: str, gap: np.ndarray, moves: np.ndarray, axes: np.ndarray) -> None:
    """Refuse a gap (n,) that changes in other units than a point moves (3, n), and slanted axes."""
    units = or_one(np.abs(moves).max(axis=0))
    gap, moves = gap / units, moves / units
    left, sizes, right = np.linalg.svd(moves)
    r = rank_of(sizes)
    normal = left[:, :r] @ ((right[:r] @ gap) / sizes[:r])
    size = float(np.linalg.norm(normal))
    if not np.linalg.norm(gap - normal @ moves) <= DIGITS * np.linalg.norm(gap):
        return
    if size > 1.0 + DIGITS or (r == 3 and size < 1.0 - DIGITS):
        raise ValueError(
            f"The gap of {name!r} must be a length, so that friction at a point is `mu` times its "
            f"force: where it is closed it changes {size:.6g} times as fast as the point moves. "
            "Divide it by that, or give the Stick a sliding speed in the gap's unit as `point`."
        )
    for axis in axes:
        seen = np.linalg.norm(left[:, r:].T @ axis) <= DIGITS  # all of it is a way that it can move
        if seen and abs(cosine := float(axis @ normal) / size) > DIGITS:
            angle = np.degrees(np.arccos(min(abs(cosine), 1.0)))
            raise ValueError(
                f"`along` of {name!r} must be tangential to what is touched, got a vector at "
                f"{angle:.4g}° to the gap's normal. Give the direction in which the point slides "
                "while the gap stays closed."
            )


def _checked(equations: Equations) -> EquationGraph:
    """Return the equations on the graph, or say why contacts cannot use them."""
    formed = equations.formed
    if formed is None:
        raise ValueError(
            "Contacts need equations that are formed from the bodies and loads: `eom_method` must "
            "be a Definition, or a method with bodies and loads without `equations='method'`."
        )
    if any(group == "a" for group, _ in formed.inputs()):
        raise NotImplementedError("Contacts are not supported with loads that depend on u'.")
    if equations.auxiliary.speeds:
        raise NotImplementedError(
            "Contacts are not supported with auxiliary speeds: their noncontributing forces would "
            "lack the contact forces."
        )
    return formed


def _rate(equations: Equations, gap: Any, name: str) -> Any:
    found = find_symbols([gap])
    rates = (*equations.speeds, *equations.kinematics.coordinate_rates)
    wrong = [s for s in found if s in rates]
    if wrong:
        raise ValueError(f"The gap of {name!r} must depend on coordinates, got {describe(wrong)}.")
    _check_known(equations, found, name)
    return equations.kinematics.in_states(sm.sympify(gap).diff(equations.time))


def _check_known(equations: Equations, found: Any, name: str) -> None:
    known = {*equations.coordinates, *equations.speeds, *equations.kinematics.coordinate_rates}
    others = [s for s in found if isinstance(s, (AppliedUndef, sm.Derivative)) and s not in known]
    if others:
        raise NotImplementedError(
            f"The contact {name!r} depends on {describe(others)}, which is no state. Write a "
            "prescribed motion as an expression of time."
        )


def _check_linear(equations: Equations, speed: Any, name: str) -> None:
    _check_known(equations, find_symbols([speed]), name)
    for u in equations.speeds:
        slope = speed.diff(u)
        if any(slope.has(w) for w in equations.speeds):
            raise ValueError(
                f"The sliding speed of {name!r} must be linear in the speeds of the system, got "
                f"{speed}."
            )
