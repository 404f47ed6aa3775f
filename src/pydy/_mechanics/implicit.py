"""Unknowns that are defined implicitly by residuals, which are solved numerically.

Such an unknown z becomes a coordinate without a speed. By the implicit function theorem, z' follows
from g(z, q, t) = 0, as from a kinematic equation, and g = 0 is a holonomic constraint that all
motions satisfy, like the norm of a quaternion. Otherwise z is treated as a coordinate. If g
contains speeds, z' contains u', and z may occur in loads and outputs only.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

from pydy._checks import SymbolIndex, check_mapping, describe, number, shown
from pydy._graph import (
    Graph,
    LinearSystem,
    NodeExpression,
    inputs_of,
    jacobian,
    signatures,
    substitute,
)
from pydy._mechanics.components import flat
from pydy._mechanics.kinematics import Kinematics
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.symbols import find_symbols, rate_of, replace_symbols
from pydy._modular import inverse

if TYPE_CHECKING:
    from pydy._sympy_types import TimeFunction


class Implicit:
    """Functions of time that residuals give, such as the point of a surface that is nearest.

    They may stand in loads, positions, constraints and outputs; where residuals hold speeds, in
    loads and outputs. They are states that follow from the others: g(z, q, u, t) = 0 is solved by
    Newton's method, and z' by the implicit function theorem, −g_z⁻¹ (g_q q' + g_u u' + g_t).

    Parameters
    ----------
    residuals : mapping of functions of time to expressions
        As many expressions as functions; all are zero together. They hold these functions,
        coordinates, speeds, constants, specifieds and time, but no accelerations.
    start : mapping of these functions to numbers, optional
        Where the search for their first values begins, 0.0 by default: it decides which one of
        several solutions is meant. An initial condition of the System takes its place.

    Raises
    ------
    TypeError, ValueError
        An argument is not what it should be; the message names it.

    Examples
    --------
    The eccentric anomaly E of an orbit satisfies Kepler's equation:

    >>> import sympy as sm
    >>> import sympy.physics.mechanics as me
    >>> from pydy import System
    >>> from pydy.mechanics import Definition, Implicit
    >>> x, v, E = me.dynamicsymbols('x, v, E')
    >>> m, n, e = sm.symbols('m, n, e')
    >>> N, O = me.ReferenceFrame('N'), me.Point('O')
    >>> O.set_vel(N, 0)
    >>> P = O.locatenew('P', x*N.x)
    >>> pulled = Definition(N, [x], [v], bodies=[me.Particle('P', P, m)],
    ...                     loads=[(P, (sm.cos(E) - x)*N.x)])
    >>> kepler = Implicit({E: E - e*sm.sin(E) - n*me.dynamicsymbols._t}, start={E: 0.0})
    >>> system = System(pulled, {e: 0.5}, times=[0.0, 1.0], ode_solver='dop853', implicit=kepler)
    >>> system.simulate(rtol=1e-10, atol=1e-10)['E'].round(6)
    array([0.      , 1.498701])
    """

    def __init__(
        self,
        residuals: Mapping[TimeFunction, sm.Expr],
        start: Mapping[TimeFunction, float] | None = None,
    ) -> None:
        time = dynamicsymbols._t
        self.residuals = check_mapping("residuals", residuals)
        if not self.residuals:
            raise ValueError("`residuals` must map at least one function of time to an expression.")
        for symbol, residual in self.residuals.items():
            if not (isinstance(symbol, AppliedUndef) and symbol.args == (time,)):
                raise ValueError(
                    "`residuals` must have functions of time as keys, such as dynamicsymbols('z'), "
                    f"got {shown(symbol)}."
                )
            if not isinstance(residual, sm.Expr):
                raise TypeError(
                    f"`residuals[{symbol}]` must be an expression that is zero, got "
                    f"{shown(residual)}."
                )
            if self.residuals.keys().isdisjoint(find_symbols([residual])):
                raise ValueError(
                    f"`residuals[{symbol}]`, `{residual}`, holds none of {describe([*residuals])}: "
                    "nothing follows from it. Give an expression that does."
                )
        start_values = check_mapping("start", start)
        unknowns = SymbolIndex([*self.residuals], "keys of `residuals`")
        self.start = dict.fromkeys(self.residuals, 0.0) | {
            key: number(value, f"`start[{key}]`", finite=True)
            for key, value in unknowns.by_symbol(start_values, "start").items()
        }

    def __repr__(self) -> str:
        return f"<Implicit {describe([*self.residuals])}>"

    def added_to(self, body: Multibody) -> Multibody:
        """Return the body with these coordinates, and their residuals as holonomic constraints."""
        time, unknowns = body.time, tuple(self.residuals)
        existing = (*body.coordinates, *body.speeds, *body.auxiliary)
        if duplicates := [z for z in unknowns if z in existing]:
            raise ValueError(
                f"`implicit` gives {describe(duplicates)}, which the system has as a coordinate or "
                "speed already. Leave it out of the one or the other."
            )
        kinematics, constraints = body.kinematics, body.constraints
        known = zip(kinematics.coordinate_rates, kinematics.coordinate_derivatives, strict=True)
        mapping = dict(known)
        residuals = [
            e if mapping.keys().isdisjoint(find_symbols([e])) else replace_symbols(e, mapping)
            for e in self.residuals.values()
        ]
        rates = tuple(rate_of(z, time) for z in unknowns)
        moving = {*kinematics.speed_rates, *body.auxiliary, *rates}
        for z, residual in zip(unknowns, residuals, strict=True):
            if refused := [s for s in find_symbols([residual]) if s in moving]:
                raise ValueError(
                    f"The residual of `{z}`, `{residual}`, holds {describe(refused)}: it may hold "
                    "coordinates and speeds, but no derivatives of speeds or unknowns. Write what "
                    "depends on accelerations as an output."
                )
        derivatives = *kinematics.coordinate_derivatives, *_rates(body, unknowns, residuals)
        return replace(
            body,
            coordinates=(*body.coordinates, *unknowns),
            kinematics=replace(
                kinematics,
                coordinate_rates=(*kinematics.coordinate_rates, *rates),
                coordinate_derivatives=derivatives,
            ),
            dependents=replace(
                body.dependents, coordinates=(*body.dependents.coordinates, *unknowns)
            ),
            constraints=replace(
                constraints,
                holonomic=(*constraints.holonomic, *residuals),
                implicit=Implicit(dict(zip(unknowns, residuals, strict=True)), self.start),
            ),
        )


def check_forces(body: Multibody, graph: Graph, kinetic: int) -> None:
    """Refuse positions and constraints that contain unknowns of residuals with speeds."""
    rates = zip(body.coordinates, body.kinematics.coordinate_derivatives, strict=True)
    moved = {*body.kinematics.speed_rates}
    unknowns = [z for z, rate in rates if not moved.isdisjoint(find_symbols([rate]))]
    if not unknowns:
        return
    contained = find_symbols([*body.constraints.of_positions, *body.constraints.velocity])
    if "a" in inputs_of(graph, [kinetic]).groups or not contained.keys().isdisjoint(unknowns):
        raise ValueError(
            f"A position, velocity or constraint holds {describe(unknowns)}, whose residuals hold "
            "speeds. What depends on speeds may stand in loads and outputs only."
        )


def _rates(
    body: Multibody, unknowns: Sequence[TimeFunction], residuals: Sequence[sm.Expr]
) -> list[sm.Expr]:
    """Return z' by the implicit function theorem, block by block, as expressions.

    They are computed on a graph: SymPy takes minutes for a wheel that creeps on a rail.
    """
    kinematics = Kinematics(body, in_bodies=False, driven=True)
    g, read = kinematics.graph, kinematics.read
    nodes, unknown_nodes = read.all(residuals), read.all(unknowns)
    slopes = jacobian(g, nodes, unknown_nodes)
    rates = dict.fromkeys(read.all(rate_of(z, body.time) for z in unknowns), g.zero)
    right_sides = substitute(g, kinematics.dt(nodes), rates)
    solved: dict[int, int] = {}
    for rows, columns in blocks_of(residuals, unknowns):
        matrix = [[slopes[i].get(j, g.zero) for j in columns] for i in rows]
        values = signatures(g, flat(matrix))
        if inverse([values[k : k + len(rows)] for k in range(0, len(values), len(rows))]) is None:
            names = describe([unknowns[k] for k in columns])
            raise ValueError(
                f"`implicit` cannot be solved for {names}: their residuals depend on "
                "each other. Give as many independent ones as unknowns."
            )
        known_terms = [
            [(g.mul(d, solved[j]), -1.0) for j, d in slopes[i].items() if j in solved] for i in rows
        ]
        right = [
            g.sum([(right_sides[i], -1.0), *terms])
            for i, terms in zip(rows, known_terms, strict=True)
        ]
        if len(rows) == 1:
            solved[columns[0]] = g.div(right[0], matrix[0][0])
        else:
            solved |= zip(columns, LinearSystem(g, matrix).solve(right), strict=True)
    symbols = kinematics.symbols()
    return [
        NodeExpression.of(g, solved[k], symbols, f"rate of {z}") for k, z in enumerate(unknowns)
    ]


def blocks_of(
    residuals: Sequence[sm.Expr], unknowns: Sequence[TimeFunction]
) -> list[tuple[list[int], list[int]]]:
    """Return the positions of residuals and unknowns, in blocks that are solved in turn."""
    if len(residuals) <= 1:
        return [([k], [k]) for k, _ in enumerate(residuals)]
    from scipy.sparse import csr_array  # other models do not need SciPy
    from scipy.sparse.csgraph import maximum_bipartite_matching

    n, order = len(unknowns), {z: k for k, z in enumerate(unknowns)}
    incidence = np.zeros((n, n), dtype=bool)
    for k, residual in enumerate(residuals):
        incidence[k, [order[s] for s in find_symbols([residual]) if s in order]] = True
    gives = maximum_bipartite_matching(csr_array(incidence), perm_type="column")
    if (gives < 0).any():
        return [([*range(n)], [*range(n)])]  # which is refused later
    # Equations that need each other, at last, are a block; what needs more comes later.
    needs = np.linalg.matrix_power(incidence[:, gives] | np.eye(n, dtype=bool), n)
    blocks: dict[bytes, list[int]] = {}
    for k in np.argsort(needs.sum(axis=1), kind="stable"):
        blocks.setdefault(needs[k].tobytes(), []).append(int(k))
    return [(block, sorted(int(gives[k]) for k in block)) for block in blocks.values()]
