"""Equations of a system, or expressions in another form, and outputs into an `Assembly`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from pydy._assembly.assembly import Assembly, EquationBlocks
from pydy._checks import describe
from pydy._collector import collector_paused
from pydy._graph import Graph, LinearSystem, SymPyReader, jacobian, substitute
from pydy._mechanics import Equations, find_symbols

if TYPE_CHECKING:
    import sympy as sm

    from pydy._sympy_types import AnySymbol


@dataclass(frozen=True, eq=False)
class Form:
    """Equations in one of the forms [1] x' = F, [2] M x' = F, [3] M u' = F with q' = G."""

    right_hand_side: Sequence[sm.Expr] | sm.Matrix
    coordinates: Sequence[AnySymbol]
    speeds: Sequence[AnySymbol]
    constants: Sequence[AnySymbol]
    specifieds: Sequence[AnySymbol]
    time: sm.Symbol
    mass_matrix: sm.Matrix | None = None
    coordinate_derivatives: Sequence[sm.Expr] | sm.Matrix | None = None
    outputs: Sequence[sm.Expr] = ()


@collector_paused()
def assemble_form(
    form: Form, *, external: bool = False, off: frozenset[str] = frozenset()
) -> Assembly:
    """Assemble equations in one of the forms."""
    graph, time = Graph(off), form.time
    states = [*form.coordinates, *form.speeds]
    what = "the right-hand side"
    read = SymPyReader.of_inputs(
        graph, what, p=form.constants, t=[time], r=form.specifieds, x=states
    )
    first: list[int] = []
    if form.coordinate_derivatives is not None:
        read.what = "`coordinate_derivatives`"
        first = read.all(form.coordinate_derivatives)
        for symbol, node in zip(form.coordinates, first, strict=True):
            read.define(symbol.diff(time), node)
        read.what = what
    forcing = read.all(form.right_hand_side)
    matrix: list[int] = []
    sizes = (len(states), len(form.specifieds), len(form.constants))
    n = len(forcing)
    if form.mass_matrix is None:
        rates = opened = forcing
    else:
        read.what = "`mass_matrix`"
        matrix = read.all(form.mass_matrix)
        rows = [matrix[i * n : (i + 1) * n] for i in range(n)]
        rates = [*first, *LinearSystem(graph, rows).solve(forcing, judged=True)]
        opened = [*first, *(graph.input("a", k) for k in range(n))]
    read.what = "`outputs`"

    def depending(derivatives: list[int]) -> dict[str, Any]:
        own = SymPyReader(graph, dict(read.atoms), read.what)
        for symbol, node in zip(states, derivatives, strict=True):
            own.define(symbol.diff(time), node)
        values = own.all(form.outputs)
        return {"rates": derivatives, "ordinary": values, "outputs": values}

    return Assembly(
        graph,
        sizes,
        EquationBlocks(**depending(rates), mass_matrix=matrix, forcing=forcing),
        open=depending(opened) if external else {},
    )


@dataclass(frozen=True)
class Group:
    """Outputs that are given together."""

    names: tuple[AnySymbol, ...]
    # Values, or equations that are zero, when they contain the names themselves.
    expressions: tuple[sm.Expr, ...]


def auxiliary_groups(equations: Equations, groups: Sequence[Group]) -> list[bool]:
    """Return which groups are implicit: those that contain their own names and speeds' rates."""
    rates = set(equations.kinematics.speed_rates)
    flags = []
    for group in groups:
        found = find_symbols(group.expressions)
        flags.append(any(n in found for n in group.names) and any(s in rates for s in found))
    return flags


def evaluate_groups(
    graph: Graph, read: SymPyReader, groups: Sequence[Group], known: dict[int, int]
) -> list[list[int]]:
    """Return the values of each group; solve groups given as linear equations."""
    own: list[list[int]] = []
    count = 0
    for group in groups:
        own.append([graph.input("y", count + k) for k in range(len(group.names))])
        count += len(group.names)
        for name, node in zip(group.names, own[-1], strict=True):
            read.define(name, node)
    formulas = [read.all(group.expressions) for group in groups]
    values: list[list[int] | None] = [None] * len(groups)
    owner = {node: k for k, nodes in enumerate(own) for node in nodes}
    known = dict(known)
    waiting = list(range(len(groups)))
    while waiting:
        ready = []
        for k in waiting:
            needs = {owner[n] for n in graph.reachable(formulas[k]) if n in owner} - {k}
            if all(values[j] is not None for j in needs):
                ready.append(k)
        if not ready:
            names = describe([n for k in waiting for n in groups[k].names])
            raise ValueError(
                f"Circular definition in `outputs`: {names} refer to each other. Give them as one "
                "group, a tuple of names mapped to as many equations."
            )
        for k in ready:
            nodes = substitute(graph, formulas[k], known)
            solved = _solve_group(graph, groups[k], nodes, own[k])
            values[k] = solved
            known.update(zip(own[k], solved, strict=True))
            waiting.remove(k)
    return [v for v in values if v is not None]


def _solve_group(graph: Graph, group: Group, nodes: list[int], own: list[int]) -> list[int]:
    if not set(own) & set(graph.reachable(nodes)):
        return nodes
    n = len(own)
    rows = jacobian(graph, nodes, own)
    names = describe(group.names)
    if set(own) & set(graph.reachable([d for row in rows for d in row.values()])):
        raise ValueError(
            f"`outputs` for {names} are nonlinear in {names}. Equations that contain their own "
            "names must be linear in them; solve them for the names first."
        )
    for k in range(n):
        if not rows[k] or not any(k in row for row in rows):
            raise ValueError(
                f"`outputs` for {names} cannot be solved for {names}: there must be as many "
                "independent equations as names."
            )
    rest = substitute(graph, nodes, dict.fromkeys(own, graph.zero))
    right = [graph.neg(node) for node in rest]
    # One unknown an equation, with a number before it, needs no solve.
    if all(len(row) == 1 and graph.value(next(iter(row.values()))) for row in rows):
        places = {next(iter(row)): i for i, row in enumerate(rows)}
        if len(places) == n:
            return [graph.div(right[places[k]], rows[places[k]][k]) for k in range(n)]
    return LinearSystem(graph, rows.dense()).solve(right, judged=True)


@collector_paused()
def assemble_system(
    equations: Equations,
    groups: Sequence[Group],
    auxiliaries: Sequence[AnySymbol],
    specifieds: Sequence[AnySymbol],
    constants: Sequence[AnySymbol],
    *,
    external: bool = False,
    off: frozenset[str] = frozenset(),
) -> Assembly:
    """Assemble a mechanical system with its outputs."""
    formed = equations.formed and equations.formed.renumbered(constants, specifieds)
    graph = Graph() if formed is None else formed.graph
    graph.off = off
    q, u, t = equations.coordinates, equations.speeds, equations.time
    states, what = [*q, *u, *auxiliaries], "the equations of motion"
    read = SymPyReader.of_inputs(graph, what, p=constants, t=[t], r=specifieds, x=states)
    speeds = [read.atoms[s] for s in u]
    accelerations = [graph.input("a", k) for k in range(len(u))]
    read.atoms.update((z, graph.zero) for z in equations.kinematics.zeros)
    if formed is None:
        kinematics = read.all(equations.kinematics.coordinate_derivatives)
    else:
        kinematics = formed.rates
    for rate, node in zip(equations.kinematics.coordinate_rates, kinematics, strict=True):
        read.define(rate, node)
    known = dict(read.atoms)
    for rate, node in zip(equations.kinematics.speed_rates, accelerations, strict=True):
        read.define(rate, node)
    if formed is None:
        matrix = read.all(equations.matrices.mass_matrix)
        forcing = read.all(equations.matrices.forcing)
    else:
        matrix = [node for row in formed.dynamics.matrix for node in row]
        forcing = formed.dynamics.forcing
    matrix, forcing, moved = _collect_accelerations(
        graph, equations, matrix, forcing, accelerations
    )
    read.what = "the constraints"
    holonomic = read.all(equations.constraints.holonomic)
    velocity = read.all(equations.constraints.velocity)
    nonholonomic = read.all(equations.constraints.nonholonomic)
    n = len(u)
    sizes = (len(q) + n + len(auxiliaries), len(specifieds), len(constants))
    kind = "ldl" if equations.matrices.positive_definite and not moved else "lu"
    if formed is None or (moved and formed.dynamics.accelerations is None):
        rows = [matrix[i * n : (i + 1) * n] for i in range(n)]
        solved = LinearSystem(graph, rows, kind).solve_by_differences(forcing)
    else:
        solved = formed.dynamics.solution(graph, kind)
    read.what = "the outputs"
    integrated = auxiliary_groups(equations, groups)

    def depending(u_dot: Sequence[int]) -> dict[str, Any]:
        """Return the blocks that depend on the accelerations, which are given."""
        known = dict(zip(accelerations, u_dot, strict=True))
        values = evaluate_groups(graph, read, groups, known)
        parts = [*zip(values, integrated, strict=True)]
        moving = substitute(graph, kinematics, known)
        return {
            "rates": [*moving, *u_dot, *(n for part, own in parts if own for n in part)],
            "ordinary": [n for part, own in parts if not own for n in part],
            "outputs": [n for part in values for n in part],
        }

    blocks = depending(solved)
    # What events and the like may hold. A user's solver finds u' from M and F, which what is read
    # later cannot wait for.
    if not external:
        known.update(zip(equations.kinematics.speed_rates, solved, strict=True))
        outputs = iter(blocks["outputs"])
        for group in groups:
            found = {name: next(outputs) for name in group.names}
            if group.expressions == equations.auxiliary.residuals:
                known.update(found)  # the noncontributing forces
    ready = None
    if formed is not None and formed.simplified is not None and not off:
        # What residuals with speeds give moves with u' too, and is not simplified yet.
        first = moved or any(integrated) or blocks["rates"][: len(q)] != kinematics
        ready = None if first else (blocks["rates"], *formed.simplified)
    return Assembly(
        graph,
        sizes,
        EquationBlocks(
            **blocks,
            holonomic=holonomic,
            velocity=velocity,
            nonholonomic=nonholonomic,
            mass_matrix=matrix,
            forcing=forcing,
        ),
        atoms=known,
        speeds=speeds,
        equations=equations,
        open=depending(accelerations) if external else {},
        ready=ready,
    )


def check_accelerations(
    equations: Equations, constants: Sequence[AnySymbol], specifieds: Sequence[AnySymbol]
) -> None:
    """Refuse equations of motion that are nonlinear in the derivatives of the speeds."""
    if any(rate in equations.symbols for rate in equations.kinematics.speed_rates):
        assemble_system(equations, (), (), specifieds, constants)


def _collect_accelerations(
    graph: Graph,
    equations: Equations,
    matrix: list[int],
    forcing: list[int],
    accelerations: list[int],
) -> tuple[list[int], list[int], bool]:
    """Move u' that is linear in the forcing into the mass matrix."""
    present = set(accelerations) & set(graph.reachable([*matrix, *forcing]))
    if not present:
        return matrix, forcing, False
    n = len(forcing)
    rows = jacobian(graph, forcing, accelerations)
    cells = [d for row in rows for d in row.values()]
    if present & set(graph.reachable([*cells, *matrix])):
        names = describe(equations.kinematics.speed_rates)
        raise ValueError(
            f"The equations of motion are nonlinear in the derivatives of the speeds ({names}) in "
            f"the term `{_nonlinear_term(equations)}`. Loads may depend on accelerations linearly "
            "only."
        )
    forcing = substitute(graph, forcing, dict.fromkeys(accelerations, graph.zero))
    matrix = list(matrix)
    for i, row in enumerate(rows):
        for j, d in row.items():
            matrix[i * n + j] = graph.sub(matrix[i * n + j], d)
    return matrix, forcing, True


def _nonlinear_term(equations: Equations) -> sm.Expr | tuple[sm.Expr, ...]:
    """Return the first additive term that is not linear in the derivatives of the speeds."""
    rates = equations.kinematics.speed_rates
    loads = equations.mechanism.loads if equations.formed and equations.mechanism else ()
    parts = [e for _, vector in loads for column, _ in vector.args for e in column]
    for expression in (*equations.matrices.forcing, *equations.matrices.mass_matrix, *parts):
        for term in expression.expand().as_ordered_terms():
            if any(term.diff(a).has(*rates) for a in rates):
                return term
    return equations.matrices.forcing
