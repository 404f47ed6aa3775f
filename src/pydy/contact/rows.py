"""Contacts as rows of accelerations, J u' + b = 0, and their forces, on the graph of a mechanism.

Rows are numbered contact by contact, the normal one first. With W = M⁻¹ Jᵀ and u' = a without
contact forces, the accelerations of the rows are J a + b + J W λ.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from copy import copy
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef

from pydy._backends import compile_program
from pydy._checks import describe
from pydy._forks import cached_property
from pydy._graph import (
    Graph,
    LinearSystem,
    SymPyReader,
    inputs_of,
    jacobian,
    lower,
    rounding_bounds,
    sizes_of_terms,
    substitute,
)
from pydy._kernel import Kernel
from pydy._mechanics import EquationGraph, Equations, dot, find_symbols
from pydy._rank import DIGITS, ROUNDING, or_one, rank_of
from pydy.contact.conditions import Contact, InfeasibleError
from pydy.contact.smooth import Switched, switched
from pydy.contact.tuning import ROUNDING_MARGIN

if TYPE_CHECKING:
    from pydy._program import Evaluator
    from pydy._sympy_types import AnySymbol


class StartError(InfeasibleError):
    """A gap is negative at the first time."""


_ZERO = np.zeros(1)
Parts = dict[str, tuple[tuple[int, ...], Sequence[int]]]  # shapes and nodes, by name


_LATE = ("free", "terms", "delassus", "response")  # they need M⁻¹; open contacts do without


class RowValues:
    """The rows at one state, evaluated lazily: those that need M⁻¹, and the others."""

    gap: np.ndarray  # (contacts,); zero without one
    gap_rounding: np.ndarray  # (contacts,), bounds on rounding errors, in units of 2⁻⁵²
    speed: np.ndarray  # (rows,), J u + …
    speed_rounding: np.ndarray  # (rows,), bounds on the rounding errors of the speeds
    kinematics: np.ndarray  # (coordinates, speeds), ∂q'/∂u
    gradient: np.ndarray  # (contacts, coordinates), of the gaps
    normal: np.ndarray  # (contacts,), known normal forces
    restitution: np.ndarray
    mu: np.ndarray
    mu_static: np.ndarray
    free: np.ndarray  # (rows,), J a + b
    terms: np.ndarray  # (rows,), the sums of the absolute terms of `free`
    delassus: np.ndarray  # (rows, rows), the Delassus matrix J W = J M⁻¹ Jᵀ
    response: np.ndarray  # (speeds, rows), W

    def __init__(
        self, rows: ContactRows, x: np.ndarray, t: float, r: np.ndarray, p: np.ndarray
    ) -> None:
        self._rows, self._point = rows, (x, t, r, p)

    def __getattr__(self, name: str) -> Any:  # an attribute that has not been evaluated
        if name not in RowValues.__annotations__:
            raise AttributeError(name)
        late = name in _LATE
        kernel = self._rows.late if late else self._rows.early
        signature = kernel.program.signature
        out: np.ndarray | None = vars(self).get(late_or_early := "_late" if late else "_early")
        if out is None:
            vars(self)[late_or_early] = out = np.empty(signature.num_outputs)
            if kernel.at(*self._point, out):
                out[:] = np.nan
        block = signature.block(name)
        values: np.ndarray = out[block.start : block.stop].reshape(block.shape)
        vars(self)[name] = values
        return values

    def is_closed(self, i: int) -> bool:
        """Return whether a gap is zero within its rounding errors."""
        return bool(self.gap[i] <= ROUNDING_MARGIN * ROUNDING * self.gap_rounding[i])

    def moving(self) -> np.ndarray:
        """Return the speeds, with those within their rounding errors set to zero."""
        return np.where(
            np.abs(self.speed) <= ROUNDING_MARGIN * ROUNDING * self.speed_rounding, 0.0, self.speed
        )

    def after(self, impulses: np.ndarray) -> RowValues:
        """Return the values after impulses, which enlarge the rounding bounds of the speeds."""
        values, slow = copy(self), self.speed_rounding + np.abs(self.delassus) @ np.abs(impulses)
        values.speed_rounding = slow
        return values

    def is_still(self, rows: Sequence[int], speeds: np.ndarray) -> bool:
        """Return whether sliding speeds are zero within rounding of their terms or of `speed`."""
        sizes = np.maximum(self.speed_rounding[list(rows)], np.abs(self.speed[list(rows)]))
        return bool(np.linalg.norm(speeds) <= ROUNDING_MARGIN * ROUNDING * np.linalg.norm(sizes))


class ContactRows:
    """The rows of all contacts of a mechanism, as nodes of the constants and specifieds."""

    def __init__(
        self,
        equations: Equations,
        contacts: Sequence[Contact],
        constants: Sequence[AnySymbol],
        specifieds: Sequence[AnySymbol],
    ) -> None:
        self.equations, self.contacts = equations, tuple(contacts)
        formed = _checked(equations)
        # For sliding in a plane: the reference direction of each contact, and three speeds.
        self.references = {
            i: sm.symbols([f"{c.name}_reference_{k}" for k in ("1", "2", "least", "clear", "rest")])
            for i, c in enumerate(contacts)
            if c.stick is not None and c.stick.plane
        }
        # Of each row: redundant forces are those with the least distance from these.
        self.biases = [
            sm.Symbol(f"{c.name}_bias_{k}")
            for c in contacts
            for k in range(
                (c.unilateral is not None) + (0 if c.stick is None else 2 if c.stick.plane else 1)
            )
        ]
        # Of each contact: a bound on the rounding of its speed where a motion begins, or zero.
        # While a gap separates from zero, the event monitors its speed instead of the gap.
        self.speed_bounds = [sm.Symbol(f"{c.name}_rising") for c in contacts]
        references = (s for symbols in self.references.values() for s in symbols)
        self.hidden = [*references, *self.biases, *self.speed_bounds]
        constants = [*constants, *self.hidden]
        self.checked: bytes | None = None  # the constants that coefficients were checked with
        added_constants = [s for s in constants if s not in formed.constants]
        added_specifieds = [s for s in specifieds if s not in formed.specifieds]
        self.formed = replace(
            formed,
            graph=formed.graph.copy(),
            constants=[*formed.constants, *added_constants],
            specifieds=[*formed.specifieds, *added_specifieds],
            simplified=None,
        )
        self.graph = self.formed.graph
        self._orders = (
            _indices(specifieds, self.formed.specifieds),
            _indices(constants[: -len(self.hidden)], self.formed.constants),
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
        self.switched: list[Switched] = []  # piecewise gaps and sliding speeds
        speeds: list[sm.Expr] = []
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
        kind = "ldl" if e.matrices.positive_definite else "lu"
        self.free = self.formed.dynamics.solution(g, kind)  # u' without contact forces
        self.response = self._speed_responses()
        rows = zip(*(map(read, c.coefficients.values()) for c in self.contacts), strict=True)
        self.restitution, self.mu, self.static, self.pressed = map(list, rows)

    @property
    def identity(self) -> tuple[object, ...]:
        """A cache key of the rows: their nodes in the order of reading."""
        g, groups = self.graph, (self.jacobian, self.response, self.formed.dynamics.matrix)
        parts = (
            self.gaps,
            self.speeds,
            self.drift,
            self.free,
            *(r for group in groups for r in group),
        )
        parts += (self.mu, self.static, self.restitution, self.pressed)
        nodes = [(n, g.ops[n], g.args[n]) for n in g.reachable([n for part in parts for n in part])]
        inputs = [[*map(str, group)] for group in (self.formed.constants, self.formed.specifieds)]
        names = [(c.name, c.kind, c.stick is not None and c.stick.plane) for c in self.contacts]
        return names, inputs, nodes, [list(part) for part in parts]

    def _smooth(self, subject: str, expression: sm.Expr, slopes: bool) -> sm.Expr:
        """Return an expression in a differentiable form; refuse jumps."""
        moving = (self.equations.time, *self.equations.coordinates, *self.equations.speeds)
        switches = switched(subject, expression, moving, slopes)
        if switches is None:
            return expression
        self.switched.append(switches)
        return switches.expression

    def _owners(self) -> list[Contact]:
        owners = []
        for c, normal, tangent in zip(self.contacts, self.normal, self.tangent, strict=True):
            owners += [c] * (len(tangent) + (normal is not None))
        return owners

    def _speed_responses(self) -> list[list[int]]:
        """Return for each row the change of u' per unit of its force: the columns of W.

        With dependent speeds u_d = A u_i + …, where A follows from their rows of the matrix, the
        generalized force of a row is Jᵢ + Aᵀ J_d.
        """
        g, e, matrix = self.graph, self.equations, self.formed.dynamics.matrix
        dependent, independent = e.dependents.speed_columns, e.dependents.independent_columns
        columns = [list(row) for row in self.jacobian]
        if dependent:
            below = [matrix[k] for k in dependent]
            block = [[row[j] for j in dependent] for row in below]
            right = [[g.neg(row[i]) for row in below] for i in independent]
            shares = dict(zip(independent, map(LinearSystem(g, block).solve, right), strict=True))
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
        return [*map(LinearSystem(g, matrix, kind).solve, columns)]

    def _terms(self) -> list[int]:
        """Return the sums of the absolute terms of the rows' accelerations without contact forces.

        The terms may cancel: weight and centripetal acceleration do when a body leaves a curved
        surface. With M u' = F they are those of J M⁻¹ F + b.
        """
        g, matrix = self.graph, self.formed.dynamics.matrix
        shares = self.response
        if self.equations.constraints.velocity:  # M is not symmetric
            transposed = [list(column) for column in zip(*matrix, strict=True)]
            shares = [*map(LinearSystem(g, transposed).solve, self.jacobian)]
        forces = sizes_of_terms(g, self.formed.dynamics.forcing)
        return [
            g.add(dot(g, [g.call("abs", n) for n in share], forces), drift)
            for share, drift in zip(shares, sizes_of_terms(g, self.drift), strict=True)
        ]

    @cached_property
    def parts(self) -> Parts:
        """The shape and the nodes of each attribute of `RowValues`, by name."""
        g, e = self.graph, self.equations
        q, u, k, c = (len(s) for s in (e.coordinates, e.speeds, self.speeds, self.contacts))
        by_q, by_u = ([g.input("x", j) for j in indices] for indices in (range(q), range(q, q + u)))
        square = [dot(g, row, response) for row in self.jacobian for response in self.response]
        return {
            "gap": ((c,), self.gaps),
            "gap_rounding": ((c,), rounding_bounds(g, self.gaps)),
            "speed": ((k,), self.speeds),
            "speed_rounding": ((k,), rounding_bounds(g, self.speeds)),
            "free": ((k,), [self.acceleration(g, row, self.free) for row in range(k)]),
            "terms": ((k,), self._terms()),
            "delassus": ((k, k), square),
            "response": ((u, k), [response[j] for j in range(u) for response in self.response]),
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
        # Compiled from the first state on: an interpreter would change the last bits.
        f = self.formed
        n = len(self.equations.coordinates) + len(self.equations.speeds)
        blocks = [(name, *self.parts[name]) for name in names]
        sizes = n, len(f.specifieds), len(f.constants)
        return compile_program(lower(self.graph, sizes, blocks), "llvm", {})

    @cached_property
    def _friction_jacobians(self) -> dict[int, Evaluator]:
        """For each friction at a point of a gap: evaluators of both Jacobians and the axes.

        The point's velocity has three rows, in the inertial frame.
        """
        g, e, evaluators = self.graph, self.equations, {}
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
                evaluators[i] = g.evaluator(rows)
        return evaluators

    @cached_property
    def cuts(self) -> dict[int, list[tuple[sm.Expr, Evaluator]]]:
        """For each gap: its functions atan2(y, x), which jump by 2π where y = 0 and x < 0.

        Each comes with an evaluator of y, x, the gap, and the gap with 2π added and subtracted.
        """
        evaluators: dict[int, list[tuple[sm.Expr, Evaluator]]] = {}
        atoms = {symbol: node for node, symbol in self.symbols.items()}
        read = SymPyReader(self.graph.copy(), atoms, "the contacts")
        for i, c in enumerate(self.contacts):
            gap = sm.S.Zero if c.unilateral is None else c.unilateral.gap
            for f in sorted(gap.atoms(sm.atan2), key=sm.default_sort_key):
                branches = (gap.xreplace({f: f + n * sm.pi}) for n in (0, 2, -2))
                in_states = self.equations.kinematics.in_states
                nodes = read.all([in_states(part) for part in (*f.args, *branches)])
                evaluators.setdefault(i, []).append((f, read.graph.evaluator(nodes)))
        return evaluators

    def check_directions(
        self, closed: Iterable[int], values_by_symbol: Mapping[AnySymbol, float]
    ) -> None:
        """Refuse friction at a point if the closed gap is no length, or `along` is not tangential.

        If the gap belongs to the point, its rate is the point's velocity along a unit normal; this
        determines the normal within the directions in which the point can move. The check is
        skipped if the gap belongs to another point.
        """
        inputs = {node: values_by_symbol.get(symbol, 0.0) for node, symbol in self.symbols.items()}
        for i in sorted(self._friction_jacobians.keys() & set(closed)):
            values, n = self._friction_jacobians[i](inputs, 1)[0], len(self.equations.speeds)
            if np.isfinite(values).all():
                velocity_jacobian, axes = (
                    values[n : 4 * n].reshape(3, n),
                    values[4 * n :].reshape(-1, 3),
                )
                _check_direction(self.contacts[i].name, values[:n], velocity_jacobian, axes)

    def numbers(self, t: float, x: np.ndarray, r: np.ndarray, p: np.ndarray) -> RowValues:
        """Return the rows at a state, with values of the definition's specifieds and constants."""
        r_order, p_order = self._orders  # missing inputs are zero, or hidden
        r, p = np.concatenate((r, _ZERO))[r_order], np.concatenate((p, _ZERO))[p_order]
        return RowValues(self, x.copy(), t, r, p)

    @cached_property
    def _checks_constants(self) -> bool:
        """Whether the checks at the start, except for gaps, depend on the constants alone."""
        g, coefficients = self.graph, [*self.mu, *self.static, *self.restitution]
        input_groups = inputs_of(g, coefficients).groups | (
            inputs_of(g, self.gaps).groups - {"t", "x"}
        )
        return None not in self.normal and not input_groups - {"p"}

    def are_open(self, gaps: RowValues, p: np.ndarray) -> bool:
        """Whether all gaps are open, and the constants have been `checked` before."""
        if self.checked != p.tobytes() or not self._checks_constants:
            return False
        pairs = zip(gaps.gap.tolist(), gaps.gap_rounding.tolist(), strict=True)
        return all(gap > ROUNDING_MARGIN * ROUNDING * rounding for gap, rounding in pairs)

    def owners_of(self, active: Sequence[int]) -> dict[int, int]:
        """Return the contact of each normal row among the active rows, in their order."""
        owners = {n: i for i, n in enumerate(self.normal) if n is not None}
        return {n: owners[n] for n in active if n in owners}

    def rates(self, g: Graph, forces: Sequence[int]) -> list[int]:
        """Return u' under forces of the rows."""
        responses = zip(*self.response, strict=True)
        return [
            dot(g, response, forces, (a, 1.0))
            for a, response in zip(self.free, responses, strict=True)
        ]

    def acceleration(self, g: Graph, row: int, rates: Sequence[int]) -> int:
        """Return J u' + b of a row."""
        return g.add(dot(g, self.jacobian[row], rates), self.drift[row])


def by_name(parts: Parts, values: np.ndarray) -> dict[str, np.ndarray]:
    """Split the values (nodes, …) into the parts, each in its shape."""
    ends = np.cumsum([len(nodes) for _, nodes in parts.values()])
    arrays = zip(parts.items(), np.split(values, ends[:-1]), strict=True)
    return {name: array.reshape(*shape, *values.shape[1:]) for (name, (shape, _)), array in arrays}


def _indices(inputs: Sequence[AnySymbol], symbols: Sequence[AnySymbol]) -> np.ndarray:
    """Return the index of each symbol among the inputs; -1 if it is missing."""
    index = {symbol: k for k, symbol in enumerate(inputs)}
    return np.array([index.get(symbol, -1) for symbol in symbols], dtype=int)


def _check_direction(
    name: str, gap: np.ndarray, velocity_jacobian: np.ndarray, axes: np.ndarray
) -> None:
    """Refuse a gap (n,) in other units than the velocity (3, n), and non-tangential axes."""
    units = or_one(np.abs(velocity_jacobian).max(axis=0))
    gap, velocity_jacobian = gap / units, velocity_jacobian / units
    left_vectors, sizes, right_vectors = np.linalg.svd(velocity_jacobian)
    r = rank_of(sizes)
    normal = left_vectors[:, :r] @ ((right_vectors[:r] @ gap) / sizes[:r])
    size = float(np.linalg.norm(normal))
    if not np.linalg.norm(gap - normal @ velocity_jacobian) <= DIGITS * np.linalg.norm(gap):
        return
    if size > 1.0 + DIGITS or (r == 3 and size < 1.0 - DIGITS):
        raise ValueError(
            f"The gap of {name!r} must be a length, so that friction at a point is `mu` times its "
            f"force: where it is closed it changes {size:.6g} times as fast as the point moves. "
            "Divide it by that, or give the Stick a sliding speed in the gap's unit as `point`."
        )
    for axis in axes:
        reachable = (
            np.linalg.norm(left_vectors[:, r:].T @ axis) <= DIGITS
        )  # the point can move along it
        if reachable and abs(cosine := float(axis @ normal) / size) > DIGITS:
            angle = np.degrees(np.arccos(min(abs(cosine), 1.0)))
            raise ValueError(
                f"`along` of {name!r} must be tangential to what is touched, got a vector at "
                f"{angle:.4g}° to the gap's normal. Give the direction in which the point slides "
                "while the gap stays closed."
            )


def _checked(equations: Equations) -> EquationGraph:
    """Return the equations on the graph; refuse those that contacts cannot use."""
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


def _rate(equations: Equations, gap: sm.Expr, name: str) -> sm.Expr:
    symbols = find_symbols([gap])
    rates = (*equations.speeds, *equations.kinematics.coordinate_rates)
    wrong = [s for s in symbols if s in rates]
    if wrong:
        raise ValueError(f"The gap of {name!r} must depend on coordinates, got {describe(wrong)}.")
    _check_symbols(equations, symbols, name)
    return equations.kinematics.in_states(sm.sympify(gap).diff(equations.time))


def _check_symbols(equations: Equations, symbols: Iterable[AnySymbol], name: str) -> None:
    supported = {*equations.coordinates, *equations.speeds, *equations.kinematics.coordinate_rates}
    unsupported = [
        s for s in symbols if isinstance(s, (AppliedUndef, sm.Derivative)) and s not in supported
    ]
    if unsupported:
        raise NotImplementedError(
            f"Of functions of time, the contact {name!r} may depend on states alone, got "
            f"{describe(unsupported)}. Write a prescribed motion as an expression of time."
        )


def _check_linear(equations: Equations, speed: sm.Expr, name: str) -> None:
    _check_symbols(equations, find_symbols([speed]), name)
    for u in equations.speeds:
        slope = speed.diff(u)
        if any(slope.has(w) for w in equations.speeds):
            raise ValueError(
                f"The sliding speed of {name!r} must be linear in the speeds of the system, got "
                f"{speed}."
            )
