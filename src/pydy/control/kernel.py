"""Equations of motion in implicit form on a graph, and machine code for functions of points.

In this package, only this file and `jumps` use the expression graph; `nlp` uses the LLVM back end,
too.

The equations are ``q' − G = 0`` and ``M(q) u' − F = 0``: no linear system is solved, and every
derivative is a sum of products. Constraints hold themselves, not their derivatives: of velocities,
``J u + b = 0`` with multipliers in ``M u' − F − Jᵀ λ = 0``, which hold in every configuration; of
positions, ``φ(q, z) = 0`` with slack velocities in ``q' − G − D (φ_qᵀ γ + g_qᵀ η) = 0``, which
vanish with the errors of the discretisation (C. W. Gear, B. Leimkuhler and G. K. Gupta, Automatic
integration of Euler–Lagrange equations with constraints, J. Comput. Appl. Math. 12 (1985) 77–90).
D are the squares of the coordinates' sizes, so that angles and lengths of any unit are corrected in
the same proportions. Residuals ``g(q, z) = 0`` determine their unknowns z in place of z'. The rows
``φ_zᵀ γ + g_zᵀ η = 0`` of z give η = −g_z⁻ᵀ φ_zᵀ γ, by which φ corrects q through z.

The functions are evaluated at *points*, which are collocation points or the ends of the motion. A
point has variables X, data R and the constants P. Many points are evaluated in one call, side by
side in vector registers, in arrays of shape (items, points).
"""

from __future__ import annotations

import hashlib
import marshal
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, cast

import numpy as np

from pydy._assembly import stored
from pydy._backends import LLVMBackend, sweep_by_columns
from pydy._forks import cached_property
from pydy._graph import (
    Graph,
    SymPyReader,
    adjoints,
    factor_sums,
    jacobian,
    lower,
    rounding_bounds,
    simplify,
    substitute,
)
from pydy._kernel import Kernel
from pydy._program import OPERATIONS, Program, program_from_bytes, program_to_bytes
from pydy._rank import DIGITS
from pydy.control.tuning import STORED_FUNCTIONS

if TYPE_CHECKING:
    import sympy as sm

    from pydy._assembly import Assembly
    from pydy._problem import Problem, StateSamples
    from pydy._sympy_types import AnySymbol

_LANES = 8  # points evaluated by one call of the machine code
# Read at import: the package's files may be replaced while this process runs.
_SOURCE = hashlib.sha256(Path(__file__).read_bytes()).digest()


@dataclass(frozen=True, eq=False)
class ImplicitEquations:
    """``f(x', x, r, p, t) = 0`` as nodes of a graph.

    The inputs are of the groups 'd' (x'), 'x', 'r', 'p', 't', 's' (γ, η, λ) and 'w' (D).
    """

    graph: Graph
    # Nodes of coordinates, of speeds and of auxiliary states, then the constraints.
    residuals: list[int]
    constraints: list[int]  # nodes of the constraints of positions, then of velocities
    # Nodes that replace the constraints where these already hold: γ, z' − G, then the rates of the
    # constraints of velocities.
    rates: list[int]
    atoms: Mapping[AnySymbol, int]  # nodes of the symbols that further expressions may contain
    substitutions: Mapping[int, int]  # nodes of the specifieds that are given as expressions
    # The functions compiled last for this model, by a digest of their content.
    compiled: dict[bytes, PointFunctions] = field(default_factory=dict, repr=False)

    def __getstate__(self) -> dict[str, object]:
        return {**self.__dict__, "compiled": {}}

    @classmethod
    def from_snapshot(cls, snapshot: Problem, *, disturbed: bool = False) -> ImplicitEquations:
        """Return the equations of a System's snapshot.

        If `disturbed`, the entries of r of specifieds that are expressions are added to these.
        Raises NotImplementedError for constraints of equations without bodies.
        """
        definition, code = snapshot.definition, snapshot.code
        if disturbed:
            code = snapshot.model.with_compiled_inputs(snapshot.plan, perturbed=True)
        assembly, equations = code.assembly.fork(), definition.equations
        graph, rates = assembly.graph, assembly.blocks.rates
        nq, nu = len(equations.coordinates), len(equations.speeds)
        slopes = [graph.input("d", k) for k in range(len(rates))]
        # Accelerations in an objective are the inputs u'; no linear system is solved for them.
        atoms = {
            **assembly.atoms,
            **dict(zip(definition.outputs.symbols, assembly.blocks.outputs, strict=True)),
            **dict(zip(equations.kinematics.speed_rates, slopes[nq:], strict=False)),
        }
        compiled = code.latest.setdefault("points", {})
        implicit = cls(graph, [], [], [], atoms, assembly.given, compiled)
        x = [graph.input("x", k) for k in range(nq + nu)]
        constraints = equations.constraints
        holonomic = [assembly.blocks.holonomic[k] for k in constraints.enforced_holonomic]
        motion = assembly.blocks.velocity
        if motion:
            if equations.constraint_forces is None:
                raise NotImplementedError(
                    "The system has constraints, and equations without bodies. Collocation on "
                    "constraints needs the bodies and loads: give them to the method, and leave "
                    "out `equations='method'`."
                )
            forces = equations.constraint_forces.unbalanced(definition.outputs.forces)
            unbalanced = implicit.read(graph, forces, "the equations of motion")
        else:
            unbalanced = []
            for i in range(nu):
                row = assembly.blocks.mass_matrix[i * nu : (i + 1) * nu]
                parts = [(graph.mul(m, slopes[nq + j]), -1.0) for j, m in enumerate(row)]
                unbalanced.append(graph.sum([*parts, (assembly.blocks.forcing[i], 1.0)]))
        terms = [[(slopes[k], 1.0), (rates[k], -1.0)] for k in range(nq)]
        terms += [[(node, -1.0)] for node in unbalanced]
        terms += [[(slopes[k], 1.0), (rates[k], -1.0)] for k in range(nq + nu, len(rates))]
        enforced, solved = len(constraints.implied_holonomic), constraints.residuals.columns
        start_rows = [graph.input("s", k) for k in range(enforced)]
        start_rows += [graph.sum(terms[k]) for k in solved]
        terms = [[] if k in solved else parts for k, parts in enumerate(terms)]
        by_places, by_speeds = jacobian(graph, holonomic, x[:nq]), jacobian(graph, motion, x[nq:])
        for j, derivatives in enumerate(by_places):
            for k, node in derivatives.items():
                slack = graph.mul(node, graph.input("s", j))
                if k in solved:
                    terms[k].append((slack, 1.0))
                elif enforced:  # otherwise these slack velocities are zero
                    terms[k].append((graph.mul(slack, graph.input("w", k)), -1.0))
        for j, derivatives in enumerate(by_speeds, start=len(holonomic)):
            for k, node in derivatives.items():
                terms[nq + k].append((graph.mul(node, graph.input("s", j)), -1.0))
        constraint_nodes = [*holonomic, *motion]
        residuals = [*(graph.sum(parts) for parts in terms), *constraint_nodes]
        for i in equations.dependents.speed_columns:  # these rows of M u' = F are the constraints
            row = assembly.blocks.mass_matrix[i * nu : (i + 1) * nu]
            parts = [(graph.mul(m, slopes[nq + j]), 1.0) for j, m in enumerate(row)]
            start_rows.append(graph.sum([*parts, (assembly.blocks.forcing[i], -1.0)]))
        return replace(
            implicit, residuals=residuals, constraints=constraint_nodes, rates=start_rows
        )

    def rows(self, kind: str) -> list[int]:
        """Return the equations of points; see `Points.rows`."""
        motion = self.residuals[: len(self.residuals) - len(self.constraints)]
        return {
            "all": self.residuals,
            "motion": motion,
            "constraints": self.constraints,
            "start": [*motion, *self.rates],
        }[kind]

    def depend_on(
        self, nodes: Iterable[int], columns: Iterable[int], *, time: bool = False
    ) -> bool:
        """Return whether nodes depend on some of the specifieds, or on the `time`."""
        inputs = set(self.graph.reachable(nodes))
        if time and self.graph.input("t", 0) in inputs:
            return True
        return any(self.graph.input("r", k) in inputs for k in columns)

    def read(
        self,
        graph: Graph,
        expressions: Iterable[sm.Expr],
        description: str,
        named: Mapping[AnySymbol, tuple[str, int]] | None = None,
    ) -> list[int]:
        """Read expressions into a copy of the graph; `description` names them in messages.

        `named` maps further symbols in them to inputs.
        """
        further = {s: graph.input(*key) for s, key in (named or {}).items()}
        atoms = {**self.atoms, **further}
        nodes = SymPyReader(graph, atoms, description).all(list(expressions))
        return substitute(graph, nodes, self.substitutions)


def violated(at: StateSamples) -> dict[int, float]:
    """Return the nonzero residuals of invariants, such as norms of quaternions, by their indices.

    `at` is the start of a motion. Invariants are holonomic constraints that are not enforced.
    """
    indices = at.definition.equations.constraints.unenforced_holonomic
    values = at.interpret(_holonomic) if indices else {}
    rows = {k: [float(values[name][0, k]) for name in ("rows", "bounds")] for k in indices}
    return {k: value for k, (value, bound) in rows.items() if abs(value) > DIGITS * bound}


def _holonomic(assembly: Assembly) -> dict[str, list[int]]:
    rows = assembly.blocks.holonomic
    return {"rows": rows, "bounds": rounding_bounds(assembly.graph, rows)}


class PointBuilder:
    """Builds functions of points: provides nodes of variables, data and constants.

    `constants` is the number of constants P.
    """

    def __init__(self, equations: ImplicitEquations, constants: int) -> None:
        self.equations = equations
        self.graph = equations.graph.copy()
        self.constants = constants
        self._variables: list[int] = []
        self._data: list[int] = []

    def variables(self, count: int) -> list[int]:
        """Return the nodes of further variables, in the order of X."""
        return self._extend(self._variables, "V", count)

    def data(self, count: int) -> list[int]:
        """Return the nodes of further data, in the order of R."""
        return self._extend(self._data, "R", count)

    def _extend(self, nodes: list[int], group: str, count: int) -> list[int]:
        new = [self.graph.input(group, len(nodes) + k) for k in range(count)]
        nodes += new
        return new

    def constant(self, k: int) -> int:
        """Return the node of one of the numbers P."""
        return self.graph.input("P", k)

    def combined(self, terms: Iterable[tuple[int, float | Sequence[int], int]], h: int) -> int:
        """Return Σ coefficient · node · h^power; a coefficient is a number or a node in a list."""
        g = self.graph
        parts = []
        for node, coefficient, power in terms:
            number = coefficient if isinstance(coefficient, float) else 1.0
            factors = [(node, 1), (h, power)]
            if not isinstance(coefficient, float):
                factors.append((coefficient[0], 1))
            parts.append((g.product(factors), number))
        return g.sum(parts)

    def residuals(self, at: Mapping[tuple[str, int], int], kind: str = "all") -> list[int]:
        """Return the equations with nodes in place of their inputs; see `Points.rows`."""
        return self._placed(self.equations.rows(kind), at)

    def read(
        self,
        expressions: Sequence[sm.Expr],
        description: str,
        at: Mapping[tuple[str, int], int],
        named: Mapping[AnySymbol, tuple[str, int]] | None = None,
    ) -> list[int]:
        """Return expressions of the system's quantities as nodes; `at` as in `residuals`."""
        return self._placed(self.equations.read(self.graph, expressions, description, named), at)

    def read_with(
        self, expressions: Sequence[sm.Expr], description: str, atoms: Mapping[AnySymbol, int]
    ) -> list[int]:
        """Return expressions of some symbols alone as nodes."""
        return SymPyReader(self.graph, dict(atoms), description).all(list(expressions))

    def _placed(self, nodes: Sequence[int], at: Mapping[tuple[str, int], int]) -> list[int]:
        return substitute(self.graph, nodes, {self.graph.input(*k): n for k, n in at.items()})

    def functions(
        self,
        rows: Sequence[int],
        cost: int | None,
        *,
        hessian: str | None,
        squares: Sequence[tuple[int, int]] = (),
    ) -> PointFunctions:
        """Compile the rows, a part of the objective, and their derivatives by the variables.

        The `hessian` is 'exact', that of rows and cost; 'gauss-newton', an approximation of the
        cost's by first derivatives; or None. The cost is the sum of factor · residual² over
        `squares`, pairs of these.
        """
        costs = [] if cost is None else [cost]
        roots = [*rows, *costs, *(node for pair in squares for node in pair)]
        outputs = len(rows), len(costs)
        key, cache = self._content(roots, outputs, hessian), self.equations.compiled
        compiled = cache.pop(key, None)
        if compiled is None:
            compiled = stored(
                (_SOURCE, key),
                lambda: self._derived(roots, outputs, hessian),
                PointFunctions.to_bytes,
                PointFunctions.from_bytes,
            )
        cache[key] = compiled
        while len(cache) > STORED_FUNCTIONS:
            del cache[next(iter(cache))]
        return compiled

    def _content(self, roots: list[int], outputs: tuple[int, int], hessian: str | None) -> bytes:
        """Return a digest of everything that determines the derivatives."""
        g = self.graph
        order = g.reachable(roots)
        new = {old: k for k, old in enumerate(order)}
        nodes = [(g.ops[n], OPERATIONS.with_operands(g.ops[n], g.args[n], new)) for n in order]
        sizes = (len(self._variables), len(self._data), self.constants, *outputs)
        # Version 2 of the format writes every object in full: equal content gives equal bytes.
        content = (nodes, [new[n] for n in roots], sizes, hessian)
        return hashlib.sha256(marshal.dumps(content, 2)).digest()

    def _derived(
        self, roots: list[int], outputs: tuple[int, int], hessian: str | None
    ) -> PointFunctions:
        g = self.graph
        inputs = {n: g.input("x", k) for k, n in enumerate(self._variables)}
        inputs |= {n: g.input("r", k) for k, n in enumerate(self._data)}
        inputs |= {g.input("P", k): g.input("p", k) for k in range(self.constants)}
        variables, data, m = [*inputs.values()][: len(self._variables)], len(self._data), outputs[0]
        roots = simplify(g, substitute(g, roots, inputs))
        pairs, roots = roots[sum(outputs) :], roots[: sum(outputs)]
        rows, costs = roots[:m], roots[m:]
        weights = [g.input("r", data + k) for k in range(len(roots))]
        slopes = jacobian(g, rows, variables)
        gradient = adjoints(g, costs, [g.one], variables) if costs else []
        gradient_at = [k for k, n in enumerate(gradient) if n != g.zero]
        jacobian_at = [(i, j) for i, row in enumerate(slopes) for j in row]
        cells = {
            "cost": costs,
            "gradient": [gradient[k] for k in gradient_at],
            "rows": rows,
            "jacobian": [slopes[i][j] for i, j in jacobian_at],
        }
        hessian_at: list[tuple[int, int]] = []
        if hessian == "gauss-newton" and pairs:
            hessian_at, cells["hessian"] = _normal(
                g, pairs[::2], pairs[1::2], variables, weights[m]
            )
        elif hessian == "exact":
            lagrangian = factor_sums(g, adjoints(g, roots, weights, variables))
            second = jacobian(g, lagrangian, variables)
            hessian_at = [(i, j) for i, row in enumerate(second) for j in row if j <= i]
            cells["hessian"] = [second[i][j] for i, j in hessian_at]
        sizes = (len(variables), data, self.constants)
        weighted = (len(variables), data + len(weights), self.constants)
        programs = {}
        for name, nodes in cells.items():
            if nodes:
                shared = nodes if name in ("cost", "rows") else factor_sums(g, nodes)
                input_sizes = weighted if name == "hessian" else sizes
                programs[name] = lower(g, input_sizes, [(name, (len(nodes),), shared)])
        return PointFunctions.from_programs(
            programs, sizes, outputs, gradient_at, jacobian_at, hessian_at
        )


def _normal(
    g: Graph,
    factors: Sequence[int],
    residuals: Sequence[int],
    variables: Sequence[int],
    weight: int,
) -> tuple[list[tuple[int, int]], list[int]]:
    """Return the lower triangle of ``2 weight Σ factor · slope slopeᵀ``: indices and nodes."""
    terms: dict[tuple[int, int], list[tuple[int, float]]] = {}
    for factor, row in zip(factors, jacobian(g, residuals, variables), strict=True):
        for i, a in row.items():
            for j, b in row.items():
                if j <= i:
                    terms.setdefault((i, j), []).append((g.mul(weight, factor, a, b), 2.0))
    return [*terms], [g.sum(parts) for parts in terms.values()]


@dataclass(frozen=True, eq=False)
class PointFunctions:
    """Machine code for rows and a cost at points, and for their derivatives by the variables."""

    # 'cost', 'gradient', 'rows', 'jacobian' and 'hessian', without those that are empty.
    programs: dict[str, Program]
    sizes: tuple[int, int, int]  # numbers of variables, data and constants
    outputs: tuple[int, int]  # numbers of rows and of costs, which is one or none
    gradient_at: np.ndarray  # (k,), the variables that the cost depends on
    # (k, 2), rows and variables, or pairs of variables, of the entries; of the Hessian, the lower
    # triangle.
    jacobian_at: np.ndarray
    hessian_at: np.ndarray
    _sweeps: dict[str, tuple[np.ndarray, int, object]] = field(default_factory=dict, repr=False)

    @classmethod
    def from_programs(
        cls,
        programs: dict[str, Program],
        sizes: tuple[int, int, int],
        outputs: tuple[int, int],
        gradient_at: Sequence[int],
        *pairs: Sequence[tuple[int, int]],
    ) -> PointFunctions:
        """Return the functions of Programs; positions of entries are given as lists."""
        first, second = (np.array(pair, dtype=int).reshape(-1, 2) for pair in pairs)
        return cls(programs, sizes, outputs, np.array(gradient_at, dtype=int), first, second)

    def to_bytes(self) -> bytes:
        """Return the bytes that `from_bytes` reads."""
        programs = {name: program_to_bytes(program) for name, program in self.programs.items()}
        positions = [at.tolist() for at in (self.gradient_at, self.jacobian_at, self.hessian_at)]
        return marshal.dumps((programs, self.sizes, self.outputs, *positions))

    @classmethod
    def from_bytes(cls, data: bytes) -> PointFunctions:
        """Read the bytes of `to_bytes`."""
        programs, sizes, outputs, *positions = marshal.loads(data)
        decoded = {name: program_from_bytes(data) for name, data in programs.items()}
        return cls.from_programs(cast("dict[str, Program]", decoded), sizes, outputs, *positions)

    @cached_property
    def _kernels(self) -> dict[str, Kernel]:
        backend = LLVMBackend(lanes=_LANES)
        return {name: backend.compile(program) for name, program in self.programs.items()}

    def sweep(self, name: str) -> tuple[np.ndarray, int, object]:
        """Return the arguments of native code for one of the functions; see `sweep_by_columns`."""
        if name not in self._sweeps:
            self._sweeps[name] = sweep_by_columns(self.programs[name], _LANES)
        words, scratch, code = self._sweeps[name]
        return words.copy(), scratch, code

    def __getstate__(self) -> dict[str, object]:
        return {k: v for k, v in self.__dict__.items() if k != "_kernels"} | {"_sweeps": {}}

    def __call__(self, name: str, X: np.ndarray, R: np.ndarray, P: np.ndarray) -> np.ndarray:
        """Return the values of one of the functions, (entries, points).

        X is (variables, points), R (data, points) and P (constants,). For the Hessian, R ends with
        the multipliers of the rows and the weight of the cost.
        """
        count = X.shape[1]
        if name not in self.programs:
            return np.empty((0, count))
        times, X, R = np.zeros(count), np.ascontiguousarray(X), np.ascontiguousarray(R)
        if count > 1 and len(X) > 1:  # as they lie: the values are written in place
            out = np.empty((self.programs[name].signature.num_outputs, count))
            self._kernels[name].evaluate(times, X.T, R.T, P, out.T)
            return out
        return np.ascontiguousarray(self._kernels[name].evaluate(times, X.T, R.T, P)[0].T)
