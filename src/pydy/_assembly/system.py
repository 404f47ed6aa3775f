"""Equations of a mechanical system and its outputs into an `Assembly`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pydy._assembly.assembly import Assembly, Depending
from pydy._assembly.outputs import Group, auxiliary_groups, evaluate_groups
from pydy._graph.collector import collector_paused
from pydy._graph.derivative import jacobian
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.node import Graph
from pydy._graph.rewrite import substitute
from pydy._graph.solve.choose import solve_accelerations
from pydy._graph.switches import Passes
from pydy._graph.symbols import input_nodes
from pydy._mechanics.equations import Equations

__all__ = ["assemble_system", "check_accelerations"]


@collector_paused()
def assemble_system(
    equations: Equations,
    groups: Sequence[Group],
    auxiliaries: Sequence[Any],
    specifieds: Sequence[Any],
    constants: Sequence[Any],
    *,
    external: bool = False,
    passes: Passes | None = None,
) -> Assembly:
    """Assemble a mechanical system with its outputs.

    Parameters
    ----------
    equations : Equations
    groups : sequence of Group
        Outputs, in the user's order.
    auxiliaries : sequence of symbols
        The auxiliary states, one for each name of an integrated group.
    specifieds, constants : sequence of symbols
        In the order of the arrays r and p.
    external : bool
        Whether a user's solver may solve for the accelerations: blocks that depend on them are
        then there in two ways, see `Assembly.open`.
    passes : Passes, optional
        All by default.

    Raises
    ------
    ValueError
        Accelerations occur nonlinearly in the equations of motion, a group is nonlinear in its own
        names, or outputs refer to each other in a circle.
    """
    passes = passes or Passes()
    formed = equations.formed and equations.formed.placed(constants, specifieds)
    graph = Graph() if formed is None else formed.graph
    q, u, t = equations.coordinates, equations.speeds, equations.time
    atoms = input_nodes(graph, p=constants, t=[t], r=specifieds, x=[*q, *u, *auxiliaries])
    accelerations = [graph.input("a", k) for k in range(len(u))]
    atoms.update((z, graph.zero) for z in equations.zeros)
    read = SymPyReader(graph, atoms, "the equations of motion")
    if formed is None:
        kinematics = read.all(equations.coordinate_derivatives)
    else:
        kinematics = formed.rates
    for rate, node in zip(equations.coordinate_rates, kinematics, strict=True):
        read.define(rate, node)
    known = dict(read.atoms)
    for rate, node in zip(equations.speed_rates, accelerations, strict=True):
        read.define(rate, node)
    if formed is None:
        matrix = read.all(equations.mass_matrix)
        forcing = read.all(equations.forcing)
    else:
        matrix = [node for row in formed.matrix for node in row]
        forcing = formed.forcing
    matrix, forcing, moved = _collect_accelerations(
        graph, equations, matrix, forcing, accelerations
    )
    read.what = "the constraints"
    holonomic = read.all(equations.holonomic)
    velocity = read.all(equations.velocity)
    nonholonomic = read.all(equations.nonholonomic)
    n = len(u)
    sizes = (len(q) + n + len(auxiliaries), len(specifieds), len(constants))
    if formed is not None and formed.accelerations is not None:
        solved = formed.accelerations
    else:
        kind = "ldl" if equations.positive_definite and not moved else "lu"
        rows = [matrix[i * n : (i + 1) * n] for i in range(n)]
        if formed is None or moved:
            solved = solve_accelerations(graph, rows, forcing, kind, passes)
        else:
            beyond = solve_accelerations(graph, rows, formed.rest, kind, passes)
            solved = [graph.add(*parts) for parts in zip(formed.start, beyond, strict=True)]
    read.what = "the outputs"
    integrated = auxiliary_groups(equations, groups)

    def depending(u_dot: Sequence[int]) -> Depending:
        """Return the blocks that depend on the accelerations, which are given."""
        known = dict(zip(accelerations, u_dot, strict=True))
        values = evaluate_groups(graph, read, groups, known)
        parts = [*zip(values, integrated, strict=True)]
        return Depending(
            rates=[*kinematics, *u_dot, *(n for part, own in parts if own for n in part)],
            ordinary=[n for part, own in parts if not own for n in part],
            outputs=[n for part in values for n in part],
        )

    blocks = depending(solved)
    ready = None
    if formed is not None and formed.simplified is not None and passes == Passes():
        ready = None if moved or any(integrated) else (blocks.rates, *formed.simplified)
    return Assembly(
        graph,
        sizes,
        *blocks,
        ready=ready,
        holonomic=holonomic,
        velocity=velocity,
        nonholonomic=nonholonomic,
        mass_matrix=matrix,
        forcing=forcing,
        passes=passes,
        # A user's solver finds u' from M and F, which what is read later cannot wait for.
        atoms=known if external else known | dict(zip(equations.speed_rates, solved, strict=True)),
        speeds=[atoms[s] for s in u],
        mechanism=equations.mechanism,
        open=depending(accelerations)._asdict() if external else {},
    )


def check_accelerations(equations: Equations) -> None:
    """Refuse equations of motion that are nonlinear in the derivatives of the speeds."""
    if any(rate in equations.symbols for rate in equations.speed_rates):
        constants, specifieds = _other_symbols(equations)
        assemble_system(equations, (), (), specifieds, constants)


def _other_symbols(equations: Equations) -> tuple[list[Any], list[Any]]:
    t = equations.time
    states = {*equations.coordinates, *equations.speeds}
    rates = (*equations.coordinate_rates, *equations.speed_rates)
    known = {*states, *rates, *equations.zeros, t}
    rest = [s for s in equations.symbols if s not in known]
    return [s for s in rest if s.is_Symbol], [s for s in rest if not s.is_Symbol]


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
        names = ", ".join(map(str, equations.speed_rates))
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


def _nonlinear_term(equations: Equations) -> Any:
    """Return the first additive term that is not linear in the derivatives of the speeds."""
    rates = equations.speed_rates
    loads = equations.mechanism.loads if equations.formed and equations.mechanism else ()
    parts = [e for _, vector in loads for column, _ in vector.args for e in column]
    for expression in (*equations.forcing, *equations.mass_matrix, *parts):
        for term in expression.expand().as_ordered_terms():
            if any(term.diff(a).has(*rates) for a in rates):
                return term
    return equations.forcing
