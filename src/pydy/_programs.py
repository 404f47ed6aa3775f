"""Equations and outputs into Programs: the one place where the form of the equations is decided.

An `Assembly` holds the whole system as nodes of one graph; a Program is lowered from any selection
of its blocks, so that a solver pays for the state derivatives alone and an evaluation of outputs
for nothing else.
"""

from __future__ import annotations

import hashlib
import marshal
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import astuple, dataclass, field, replace
from typing import Any

from pydy._graph.accelerations import solve_accelerations
from pydy._graph.collector import collector_paused
from pydy._graph.derivative import jacobian
from pydy._graph.factor import factor_sums
from pydy._graph.from_sympy import SymPyReader
from pydy._graph.lower import lower
from pydy._graph.node import Graph
from pydy._graph.passes import Passes
from pydy._graph.program import Program
from pydy._graph.rewrite import substitute
from pydy._graph.rounding import rounding_bounds
from pydy._graph.simplify import simplify
from pydy._mechanics.equations import Equations
from pydy._mechanics.mechanism import Mechanism
from pydy._mechanics.symbols import find_symbols

__all__ = [
    "Assembly",
    "Group",
    "assemble_form",
    "assemble_system",
    "auxiliary_groups",
    "check_accelerations",
]


@dataclass(frozen=True)
class Group:
    """Outputs that are given together.

    Attributes
    ----------
    names : tuple of symbols or functions of time
    expressions : tuple of expressions
        Values, or equations that are zero, when they contain the names themselves.
    """

    names: tuple[Any, ...]
    expressions: tuple[Any, ...]


_BLOCKS = (
    "rates", "ordinary", "outputs", "holonomic", "velocity", "nonholonomic", "mass_matrix",
    "forcing",
)  # fmt: skip


@dataclass
class Assembly:
    """A system as nodes of one graph.

    Attributes
    ----------
    graph : Graph
    sizes : (int, int, int)
        Numbers of states, specifieds and constants.
    rates : list of nodes
        Derivatives of the states.
    ordinary : list of nodes
        The outputs that come back beside the derivatives.
    outputs : list of nodes
        All outputs, in the user's order.
    holonomic, velocity, nonholonomic : list of nodes
        Constraint residuals.
    mass_matrix, forcing : list of nodes
        The linear system for the accelerations; empty where the form has none.
    passes : Passes
        The rewriting that Programs go through.
    atoms : mapping of symbols, functions of time and derivatives to nodes
        What further expressions may hold; see `expression_program`.
    speeds : list of nodes
    mechanism : Mechanism or None
        The bodies behind the equations.
    external : bool
        Whether the accelerations are inputs at the end of r.
    given : mapping of input nodes to nodes
        What `substituted` put in place of inputs.
    """

    graph: Graph
    sizes: tuple[int, int, int]
    rates: list[int]
    ordinary: list[int]
    outputs: list[int]
    holonomic: list[int] = field(default_factory=list)
    velocity: list[int] = field(default_factory=list)
    nonholonomic: list[int] = field(default_factory=list)
    mass_matrix: list[int] = field(default_factory=list)
    forcing: list[int] = field(default_factory=list)
    passes: Passes = field(default_factory=Passes)
    atoms: Mapping[Any, int] = field(default_factory=dict)
    speeds: list[int] = field(default_factory=list)
    mechanism: Mechanism | None = None
    external: bool = False
    given: Mapping[int, int] = field(default_factory=dict)

    @property
    def constraints(self) -> list[int]:
        """Residuals of the holonomic, then the nonholonomic constraints."""
        return [*self.holonomic, *self.nonholonomic]

    @property
    def kinetic_energy(self) -> list[int]:
        """The kinetic energy of the bodies: one node, or none where no bodies are known."""
        return substitute(self.graph, self._kinetic_energy(), self.given)

    @property
    def kinetic_hessian(self) -> list[int]:
        """Second derivatives of the kinetic energy by all speeds, dependent ones included.

        This is the mass matrix before any constraint reduces it, row by row. Specifieds are held,
        those that are given as expressions too.
        """
        energy = self._kinetic_energy()
        if not energy:
            return []
        g, n = self.graph, len(self.speeds)
        momenta = jacobian(g, energy, self.speeds)[0]
        rows = jacobian(g, [momenta.get(k, g.zero) for k in range(n)], self.speeds)
        # One triangle for both, so that the matrix is symmetric to the last bit.
        cells = [rows[max(i, j)].get(min(i, j), g.zero) for i in range(n) for j in range(n)]
        return substitute(g, cells, self.given)

    def _kinetic_energy(self) -> list[int]:
        if self.mechanism is None or not self.mechanism.bodies:
            return []
        return self._reader("the kinetic energy").all([self.mechanism.energy])

    def fork(self) -> Assembly:
        """Return the same with a graph of its own: what is read into it leaves this one alone."""
        return replace(self, graph=self.graph.copy())

    def read(self, expressions: Iterable[Any], what: str) -> list[int]:
        """Return further expressions in the states and symbols as nodes; `what` is for messages."""
        return substitute(self.graph, self._reader(what).all(expressions), self.given)

    def _reader(self, what: str) -> SymPyReader:
        return SymPyReader(self.graph, self.atoms, what)

    def program(self, *names: str) -> Program:
        """Return the Program of the named blocks.

        Parameters
        ----------
        names : {'rates', 'ordinary', 'outputs', 'holonomic', 'velocity', 'constraints', ...}
            Attributes of this class.
        """
        own, blocks = self.fork(), []
        for name in names:
            nodes: list[int] = getattr(own, name)
            n = len(self.speeds)
            square = name == "kinetic_hessian" and nodes
            blocks.append((name, (n, n) if square else (len(nodes),), nodes))
        return own.lowered(blocks, own.graph)

    def expression_program(self, name: str, shape: tuple[int, ...], expressions: Any) -> Program:
        """Return the Program of one block of further expressions in the states and symbols.

        Parameters
        ----------
        name : str
            Of the block, and in messages.
        shape : tuple of int
        expressions : iterable of expressions
            In C order; they may hold q', which the kinematics provide, but not u'.

        Raises
        ------
        ValueError
            A symbol that is not among those of the assembly.
        """
        n, s, c = self.sizes
        sizes = (n, s - len(self.speeds), c) if self.external else self.sizes
        own = self.fork()
        return own.lowered([(name, shape, own.read(expressions, name))], own.graph, sizes)

    def bounded_program(self, name: str) -> Program:
        """Return the Program of a block and of bounds on its rounding errors, as 'rounding'."""
        own = self.fork()
        nodes: list[int] = getattr(own, name)
        return own.lowered([(name, (len(nodes),), nodes)], own.graph, bounded=name)

    def jacobian_program(self, name: str, by: str | Sequence[tuple[str, int]]) -> Program:
        """Return the Program of a block's Jacobian.

        Parameters
        ----------
        name : str
            Of the block.
        by : {'x', 'r', 'p'} or sequence of (group, index)
            All inputs of a group, or some of any.
        """
        if isinstance(by, str):
            by = [(by, k) for k in range(dict(zip("xrp", self.sizes, strict=True))[by])]
        width = len(by)
        with collector_paused():
            graph = self.graph.copy()
            nodes = simplify(graph, getattr(self, name), self.passes)
            rows = jacobian(graph, nodes, [graph.input(*place) for place in by])
            cells = [row.get(k, graph.zero) for row in rows for k in range(width)]
            # Derivatives of what is simplified need no more than common factors taken out.
            cells = factor_sums(graph, cells) if self.passes.factor else cells
            blocks = [("jacobian", (len(nodes), width), cells)]
            return lower(graph, self.sizes, blocks, passes=self.passes)

    def substituted(self, mapping: Mapping[int, int]) -> Assembly:
        """Return the Assembly with other nodes in place of some inputs, in every block."""
        blocks = {name: getattr(self, name) for name in _BLOCKS}
        with collector_paused():
            nodes = iter(
                substitute(self.graph, [n for part in blocks.values() for n in part], mapping)
            )
        new: dict[str, Any] = {name: [next(nodes) for _ in part] for name, part in blocks.items()}
        return replace(self, given=dict(mapping), **new)

    def lowered(
        self,
        blocks: Sequence[tuple[str, tuple[int, ...], Sequence[int]]],
        graph: Graph | None = None,
        sizes: tuple[int, int, int] | None = None,
        bounded: str | None = None,
    ) -> Program:
        """Simplify and lower blocks of nodes, of this graph and of its sizes by default.

        The rounding bounds of the block `bounded` follow as a further block, 'rounding'; they are
        those of the nodes as simplified, which are what is computed.

        Each Program starts from the equations as they are: it does not depend on which others were
        made before.
        """
        with collector_paused():
            graph = self.graph.copy() if graph is None else graph
            nodes = [n for _, _, part in blocks for n in part]
            nodes = simplify(graph, nodes, self.passes)
            new = []
            start = 0
            for name, shape, part in blocks:
                new.append((name, shape, nodes[start : start + len(part)]))
                start += len(part)
                if name == bounded:
                    bounds = rounding_bounds(graph, new[-1][2])
            if bounded is not None:
                new.append(("rounding", (len(bounds),), bounds))
            return lower(graph, sizes or self.sizes, new, passes=self.passes)

    def fingerprint(self) -> bytes:
        """Return a digest of all that Programs are made from."""
        blocks = [getattr(self, name) for name in ("sizes", *_BLOCKS)]
        content = (self.graph.ops, self.graph.args, blocks, astuple(self.passes))
        # Version 2 of the format writes every object in full: equal content gives equal bytes.
        return hashlib.sha256(marshal.dumps(content, 2)).digest()


def _inputs(
    graph: Graph,
    time: Any,
    states: Sequence[Any],
    specifieds: Sequence[Any],
    constants: Sequence[Any],
) -> dict[Any, int]:
    atoms: dict[Any, int] = {s: graph.input("p", k) for k, s in enumerate(constants)}
    atoms[time] = graph.input("t", 0)
    atoms.update((s, graph.input("r", k)) for k, s in enumerate(specifieds))
    atoms.update((s, graph.input("x", k)) for k, s in enumerate(states))
    return atoms


# -- systems ------------------------------------------------------------------------------------


def auxiliary_groups(equations: Equations, groups: Sequence[Group]) -> list[bool]:
    """Tell which groups are integrated: those with their own names and derivatives of speeds."""
    rates = set(equations.speed_rates)
    flags = []
    for group in groups:
        found = find_symbols(group.expressions)
        flags.append(any(n in found for n in group.names) and any(s in rates for s in found))
    return flags


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
        Whether the accelerations are solved for by a user's solver: they then are inputs, at the
        end of r.
    passes : Passes, optional
        All by default.

    Raises
    ------
    ValueError
        Accelerations occur nonlinearly in the equations of motion, a group is nonlinear in its own
        names, or outputs refer to each other in a circle.
    """
    passes = passes or Passes()
    formed = equations.formed
    graph = Graph() if formed is None else formed.placed(constants, specifieds)
    q, u, t = equations.coordinates, equations.speeds, equations.time
    atoms = _inputs(graph, t, [*q, *u, *auxiliaries], specifieds, constants)
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
    if external:
        solved = [graph.input("r", len(specifieds) + k) for k in range(n)]
    elif formed is not None and formed.accelerations is not None:
        solved = formed.accelerations
    else:
        kind = "ldl" if equations.positive_definite and not moved else "lu"
        rows = [matrix[i * n : (i + 1) * n] for i in range(n)]
        solved = solve_accelerations(graph, rows, forcing, kind, rebase=passes.rebase)
    read.what = "the outputs"
    values = _evaluate_groups(graph, read, groups, dict(zip(accelerations, solved, strict=True)))
    integrated = auxiliary_groups(equations, groups)
    outputs = [node for part in values for node in part]
    aux = [n for part, flag in zip(values, integrated, strict=True) if flag for n in part]
    ordinary = [n for part, flag in zip(values, integrated, strict=True) if not flag for n in part]
    return Assembly(
        graph,
        (sizes[0], sizes[1] + n, sizes[2]) if external else sizes,
        [*kinematics, *solved, *aux],
        ordinary,
        outputs,
        holonomic,
        velocity,
        nonholonomic,
        matrix,
        forcing,
        passes,
        known,
        [atoms[s] for s in u],
        equations.mechanism,
        external,
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


def _evaluate_groups(
    graph: Graph, read: SymPyReader, groups: Sequence[Group], known: dict[int, int]
) -> list[list[int]]:
    """Return the values of each group, solving those that are given as linear equations."""
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
            names = ", ".join(str(n) for k in waiting for n in groups[k].names)
            raise ValueError(
                f"`outputs` {names} refer to each other in a circle. Give them as one group, a "
                "tuple of names mapped to as many equations."
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
    names = ", ".join(map(str, group.names))
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
    matrix = [[row.get(k, graph.zero) for k in range(n)] for row in rows]
    return graph.solve(matrix, [right], "lu")[0]


# -- the forms of generate_ode_function -----------------------------------------------------------


@collector_paused()
def assemble_form(
    right_hand_side: Sequence[Any],
    coordinates: Sequence[Any],
    speeds: Sequence[Any],
    constants: Sequence[Any],
    specifieds: Sequence[Any],
    mass_matrix: Any,
    coordinate_derivatives: Sequence[Any] | None,
    outputs: Sequence[Any],
    time: Any,
    *,
    external: bool = False,
    passes: Passes | None = None,
) -> Assembly:
    """Assemble equations in one of the forms [1] x' = F, [2] M x' = F, [3] M u' = F with q' = G."""
    graph = Graph()
    states = [*coordinates, *speeds]
    atoms = _inputs(graph, time, states, specifieds, constants)
    read = SymPyReader(graph, atoms, "the right-hand side")
    first: list[int] = []
    if coordinate_derivatives is not None:
        read.what = "`coordinate_derivatives`"
        first = read.all(coordinate_derivatives)
        for symbol, node in zip(coordinates, first, strict=True):
            read.define(symbol.diff(time), node)
        read.what = "the right-hand side"
    forcing = read.all(right_hand_side)
    matrix: list[int] = []
    sizes = (len(states), len(specifieds), len(constants))
    n = len(forcing)
    if mass_matrix is None:
        rates = forcing
    else:
        read.what = "`mass_matrix`"
        matrix = read.all(mass_matrix)
        if external:
            solved = [graph.input("r", len(specifieds) + k) for k in range(n)]
            sizes = (sizes[0], sizes[1] + n, sizes[2])
        else:
            rows = [matrix[i * n : (i + 1) * n] for i in range(n)]
            solved = graph.solve(rows, [forcing], "lu")[0]
        rates = [*first, *solved]
    for symbol, node in zip(states, rates, strict=True):
        read.define(symbol.diff(time), node)
    read.what = "`outputs`"
    values = read.all(outputs)
    return Assembly(
        graph, sizes, rates, values, values, mass_matrix=matrix, forcing=forcing,
        passes=passes or Passes(),
    )  # fmt: skip
