"""Sensitivities of a simulation: which parameters, their columns at the start, and the equations.

The columns ∂x/∂θ are integrated with the state (`pydy._graph.columns`). An initial condition is a
parameter of its own state. States that the constraints make dependent follow by the implicit
function theorem: from c(x, θ) = 0 follows c_d x_d' = −(c_i x_i' + c_θ) for the dependent states d.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import factorial
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._assembly import CompiledModel, Definition, singular_mass_matrix, stored_program
from pydy._checks import describe
from pydy._graph import (
    DerivativeRows,
    SensitivityColumns,
    factor_sums,
    jacobian,
    lower,
    simplify,
)
from pydy._integration.parameters import Parameter, by_samples, mean_spacing, read_parameters
from pydy._judges import explain_columns
from pydy._kernel import Inputs, Kernel, KernelCall
from pydy._motion import SolveIvp, of_states, with_all
from pydy._problem import Problem
from pydy._program import Program, Tangent
from pydy._states import follow
from pydy.codegen import SpecifiedsPlan
from pydy.inputs import SampledInput
from pydy.solvers import (
    CompiledSensitivities,
    Event,
    Options,
    ParameterSize,
    Solver,
    read_options,
    tableau_of,
)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from pydy._sympy_types import AnySymbol, SymbolOrName

# Motions smaller than this many tolerances are invisible to the step control: their errors are at
# most a thousandth of them, if errors are as large as the tolerances.
_VISIBLE = 1e3


@dataclass(frozen=True, eq=False)
class AugmentedSystem:
    """A System's equations with columns of sensitivities after the state."""

    definition: Definition
    model: CompiledModel  # with all expressions compiled in, as it is integrated
    plan: SpecifiedsPlan
    parameters: tuple[Parameter, ...]
    p: np.ndarray
    argument: str = "sensitivities"  # the user's argument, for messages
    dependent: tuple[int, ...] = ()  # columns of the dependent states
    width: int = 0  # of the states with further integrated quantities, or 0
    columns: SensitivityColumns = field(init=False)

    @staticmethod
    def for_parameters(
        problem: Problem,
        model: CompiledModel,
        plan: SpecifiedsPlan,
        requested: SymbolOrName | Iterable[SymbolOrName],
        argument: str = "sensitivities",
    ) -> AugmentedSystem:
        """Return the sensitivities with respect to a user's parameters."""
        definition, dependent = problem.definition, problem.dependent
        following = tuple(definition.states[k] for k in dependent)
        parameters = read_parameters(definition, plan, requested, argument, following)
        return AugmentedSystem(definition, model, plan, parameters, problem.p, argument, dependent)

    def __post_init__(self) -> None:
        s = len(self.definition.specifieds)
        directions: list[tuple[str, int] | tuple[str, int, int] | None] = []
        weights = 0
        for parameter in self.parameters:
            if parameter.kind == "states":
                directions.append(None)
            elif parameter.kind == "constants":
                directions.append(("p", parameter.index))
            elif parameter.samples is None:
                directions.append(("r", parameter.index))
            else:
                for _ in range(parameter.count):
                    directions.append(("r", parameter.index, s + weights))
                    weights += 1
        n = self.width or len(self.definition.states)
        object.__setattr__(self, "columns", SensitivityColumns(n, tuple(directions), weights))

    def stepped(
        self,
        solver: Solver,
        options: dict[str, object],
        x0: np.ndarray,
        times: np.ndarray,
        controlled: bool,
    ) -> dict[str, Any]:
        """Return options with a maximum step where the error of the states is no indicator.

        Collinear samples leave no kink in the states. A motion that begins at rest or in a steady
        state shows no error either: growth and oscillations near it appear only in the
        sensitivities, unless these are `controlled` too.
        """
        if not solver.adaptive:
            return options
        spacing = mean_spacing(self.parameters)
        longest = np.inf if spacing is None else spacing
        if not controlled:
            longest = min(longest, self._step_limit_at_rest(solver, options, x0, times))
        return options if longest == np.inf else {"max_step": longest, **options}

    def _step_limit_at_rest(
        self, solver: Solver, options: Mapping[str, object], x0: np.ndarray, times: np.ndarray
    ) -> float:
        """Return the maximum step for a motion that begins steadily and shows no error, or inf."""
        model, n, at = self.model, len(x0), times[:1]
        tolerances = {k: options[k] for k in ("rtol", "atol") if k in options}
        read = read_options(solver.name, solver.adaptive, tolerances)
        if any(np.shape(tolerance) not in ((), (n,)) for tolerance in (read.rtol, read.atol)):
            return float(np.inf)  # an invalid shape, which is reported elsewhere
        args = at, x0[None], self.plan.inputs.rows(x0[None], at), self.p
        equations = self.definition.equations
        first = len(equations.coordinates)
        speeds = slice(first, first + len(equations.speeds))
        changes = np.abs(model.compiled("rates").evaluate(*args)[0][0, speeds])
        visible = (_VISIBLE * (read.atol + read.rtol * np.abs(x0)))[speeds]
        if not (changes * (times[-1] - times[0]) <= _VISIBLE * visible).all():
            return float(np.inf)  # the derivatives are not needed
        slopes = model.compiled_jacobian("rates", "x").evaluate(*args)[0].reshape(n, n)
        if not np.isfinite(slopes).all():
            return float(np.inf)
        eigenvalues = np.linalg.eigvals(slopes)
        implicit = solver.name == "radau"  # decaying modes need no short steps
        fastest = (
            np.maximum(eigenvalues.real, np.abs(eigenvalues.imag))
            if implicit
            else np.abs(eigenvalues)
        ).max()
        if not (fastest > 0.0 and (changes <= fastest * visible).all()):
            return float(np.inf)
        order = 5 if implicit else tableau_of(solver.name).order
        # The relative error of a step h for exp(λ t) is (h λ)ᵖ⁺¹ / (p + 1)!.
        allowed = float(np.max(read.rtol)) or Options.rtol
        share = (allowed * factorial(order + 1)) ** (1.0 / (order + 1))
        return float(min(share, 1.0) / fastest)

    def controlled(self, requested: bool) -> bool:
        """Return whether the step control includes the sensitivities: those by samples, always."""
        return requested or mean_spacing(self.parameters) is not None

    def sized(self, options: Mapping[str, object]) -> tuple[ParameterSize, ...]:
        """Return the parameters' sizes.

        States with individual absolute tolerances have sizes of at least atol / rtol; all others
        have sizes of at least 1.
        """
        sizes = tuple(parameter.sized for parameter in self.parameters)
        least = least_sizes(options, self.columns.states).tolist()
        return tuple(s._replace(least=least[s.position]) if s.group == "x" else s for s in sizes)

    @property
    def with_all_constraints(self) -> AugmentedSystem:
        """A copy with all constraints, as in the projection."""
        model = with_all(self.model, self.definition)
        return self if model is self.model else replace(self, model=model)

    # -- Compiled code ----------------------------------------------------------------------------

    def kernel(self, *blocks: str) -> Kernel:
        """Return the Kernel of the derivatives of blocks by the parameters.

        By default it is that of the derivatives of the states and of their sensitivities by time.
        """
        return self.model.compiled_by(
            ("sensitivities", blocks, self.columns), lambda: self.tangent(*blocks)
        )

    def tangent(self, *blocks: str) -> Tangent:
        """Return the Tangent of `kernel`."""
        columns, assembly = self.columns, self.model.assembly

        def make() -> Tangent:
            if blocks:
                graph = assembly.graph.copy()
                nodes = [node for name in blocks for node in getattr(assembly, name)]
                return columns.tangent(graph, simplify(graph, nodes), sizes)
            graph, rates = assembly.simplified("rates")
            return columns.tangent(graph, rates, sizes, "rates")

        sizes = assembly.sizes
        return stored_program(
            assembly, f"sensitivities of {', '.join(blocks) or 'rates'} {columns}", make
        )

    def written_out(self, *blocks: str) -> Program:
        """Return the Program of `kernel`: an infinite derivative affects no other column."""
        name = f"sensitivities of {', '.join(blocks)} {self.columns}, written out"
        return stored_program(
            self.model.assembly, name, lambda: self.tangent(*blocks).written_out()
        )

    def call(self) -> KernelCall:
        """Return the equations with sensitivities and their numbers, for native solvers."""
        model = self.model
        return KernelCall(
            self.kernel(),
            self.p,
            Inputs(
                np.concatenate([self.plan.inputs.values, np.zeros(self.columns.weights)]),
                (*self.plan.inputs.sampled, *self.weights()),
            ),
            lambda: tuple(map(str, model.layout.states)),
            lambda: model.compiled_jacobian("rates", "x"),
        )

    def weights(self) -> list[tuple[np.ndarray, SampledInput]]:
        """Return the derivatives of sampled inputs by their samples, with their columns in r."""
        result, start = [], len(self.definition.specifieds)
        for parameter in self.parameters:
            if parameter.samples is not None:
                columns = np.arange(start, start + parameter.count)
                result.append((columns, by_samples(parameter)))
                start += parameter.count
        return result

    def function(self) -> Callable[..., np.ndarray]:
        """Return ``f(x, t, …)`` for solvers, of states with their sensitivities."""
        call, n = self.call(), self.columns.states
        kernel, model, p = call.kernel, self.model, call.p

        def f(x: ArrayLike, t: float, *args: object) -> np.ndarray:
            out = np.empty(self.columns.size)
            state = np.ascontiguousarray(x, dtype=float)
            r = call.inputs(state, float(t))
            if kernel.at(state, float(t), r, p, out):
                raise singular_mass_matrix(model.layout, float(t), state[:n])
            return out

        f.native = lambda args: call  # type: ignore[attr-defined]
        return f

    def compiled(
        self,
        x: np.ndarray,
        options: Mapping[str, object],
        controlled: bool = False,
        events: Sequence[Event] = (),
    ) -> CompiledSensitivities:
        """Return the sensitivities of a motion that begins at x, for native solvers.

        If `controlled`, the step control includes them.
        """
        columns, model = self.columns, self.model
        sizes = ParameterSize.scales(
            self.sized(options), x, self.plan.inputs.values, self.p, columns.count
        )
        return CompiledSensitivities(
            columns.states,
            columns.sources,
            sizes,
            x,
            self.controlled(controlled),
            lambda event: compiled_event(model, events[event], columns.wanted),
            lambda: self.with_all_constraints.kernel("holonomic", "velocity"),
        )

    def rows(self, times: np.ndarray) -> np.ndarray:
        """Return r with its further inputs at some times, shape (m, s + w) or (1, s + w)."""
        return self.call().inputs.rows(np.empty((len(times), 0)), times)

    def rates(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the derivatives of the sensitivities by time, shape (m, n, k)."""
        out = self._sweep((), times, states, values)
        return self.columns.split(out)[1]

    def outputs(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the sensitivities of the outputs, shape (m, o, k)."""
        out = self._sweep(("outputs",), times, states, values)
        return out.reshape(len(times), -1, self.columns.count)

    def _sweep(
        self, blocks: tuple[str, ...], times: np.ndarray, states: np.ndarray, values: np.ndarray
    ) -> np.ndarray:
        augmented = self.columns.together(states, values)
        return self.model.evaluate(self.kernel(*blocks), times, augmented, self.rows(times), self.p)

    # -- The initial values -----------------------------------------------------------------------

    def start(self, x0: np.ndarray, t: float) -> np.ndarray:
        """Return the sensitivities of the initial state, shape (n, k); see `follow`."""
        values = self.independent()
        if self.tied:
            n, instant, model = self.columns.states, np.array([t]), self.model
            args = (instant, x0[None], self.plan.inputs.rows(x0[None], instant), self.p)
            rows = [model.evaluate(model.compiled_jacobian(b, "x"), *args) for b in self.tied]
            moved = [self._sweep((b,), instant, x0[None], values[None])[0] for b in self.tied]
            gradients = [row.reshape(-1, n) for row in rows]
            every = np.concatenate(moved)
            if not follow(values, gradients, every, self.unknowns, self.dependent):
                raise ValueError(self.unsolved())
        return values

    @property
    def tied(self) -> list[str]:
        """The blocks of constraints that initial conditions satisfy."""
        constraints = self.definition.equations.constraints
        return [block for block in ("holonomic", "velocity") if getattr(constraints, block)]

    @property
    def unknowns(self) -> list[range]:
        """The columns of the states for which each of these blocks is solved."""
        first = len(self.definition.equations.coordinates)
        every = {"holonomic": range(first), "velocity": range(first, self.columns.states)}
        return [every[block] for block in self.tied]

    def independent(self) -> np.ndarray:
        """Return the sensitivities of the initial state, zero for the dependent ones."""
        values = np.zeros((self.columns.states, self.columns.count))
        column = 0
        for parameter in self.parameters:
            if parameter.kind == "states":
                if parameter.index in self.dependent:
                    raise ValueError(
                        f"`{self.argument}` has the initial condition of `{parameter.symbol}`, "
                        "which follows from the others by the constraints, as do "
                        f"{self._following}. Name independent ones, or make it independent: "
                        "call set_dependent_initial_conditions(dep_vars=…) with other variables."
                    )
                values[parameter.index, column] = 1.0
            column += parameter.count
        return values

    @property
    def _following(self) -> str:
        return describe([self.definition.states[k] for k in self.dependent])

    def unsolved(self) -> str:
        """Return the message for constraints that do not determine the dependent conditions."""
        target = "for any: none is named as dependent"
        if self.dependent:
            target = f"for {self._following}"
        return (
            f"`{self.argument}` needs to know how the dependent initial conditions follow from "
            f"the others, but the constraints cannot be solved {target}. Call "
            "set_dependent_initial_conditions(dep_vars=…) with variables for which they can."
        )


def least_sizes(options: Mapping[str, Any], n: int) -> np.ndarray:
    """Return the least sizes of n initial conditions; see `AugmentedSystem.sized`."""
    if np.shape(options.get("atol", 0.0)) == (n,):
        rtol, atol = (np.asarray(options.get(name, 0.0), dtype=float) for name in ("rtol", "atol"))
        if (rtol > 0.0).all() and (atol > 0.0).all():
            sizes: np.ndarray = atol / rtol
            return np.broadcast_to(sizes, n)
    return np.ones(n)


def changed_by(event: Event, states: Sequence[AnySymbol]) -> tuple[int, ...]:
    """Return the columns of the states that an event changes."""
    return tuple(k for k, state in enumerate(states) if state in event.reset)


def program_of_event(
    model: CompiledModel, event: Event, inputs: Sequence[tuple[str, int]]
) -> Program:
    """Return the Program of an event with g = 0 and the state R after it.

    The inputs r are followed by their time derivatives. There are w `inputs` (group, index) to
    differentiate by, and c states that the event changes. The blocks are

    ===========  ============  ==================================================================
    rate         (1,)          ġ, along the motion
    curvature    (1,)          g̈
    crossing     (n + w,)      the derivatives of g by the states, then by the `inputs`
    after_rates  (n,)          Ṙ, along the motion before the event
    after        (c, n + w)    the derivatives of those states in R that are changed
    ===========  ============  ==================================================================
    """
    fork, symbols = model.assembly.fork(), model.layout.states
    graph, (n, s, c) = fork.graph, fork.sizes
    after = [event.reset.get(state, state) for state in symbols]
    read = fork.read([event.expression, *after], f"the event `{event.name}`")
    crossing, *nodes = simplify(graph, [*read, *fork.rates])
    after, rates = nodes[:n], nodes[n:]
    states = [graph.input("x", i) for i in range(n)]
    tangents = {graph.input("t", 0): {0: graph.one}}
    tangents.update((x, {0: rate}) for x, rate in zip(states, rates, strict=True))
    tangents.update((graph.input("r", i), {0: graph.input("r", s + i)}) for i in range(s))
    motion = DerivativeRows(graph, tangents)
    variables = [*states, *(graph.input(*input_key) for input_key in inputs)]
    first = motion(crossing).get(0, graph.zero)
    changed = [after[k] for k in changed_by(event, symbols)]
    parts = {
        "rate": [first],
        "curvature": [motion(first).get(0, graph.zero)],
        "crossing": jacobian(graph, [crossing], variables).flat(),
        "after_rates": [motion(node).get(0, graph.zero) for node in after],
        "after": jacobian(graph, changed, variables).flat(),
    }
    shapes = {"after": (len(changed), len(variables))}
    cells = iter(factor_sums(graph, [node for part in parts.values() for node in part]))
    blocks = [
        (name, shapes.get(name, (len(part),)), [next(cells) for _ in part])
        for name, part in parts.items()
    ]
    return lower(graph, (n, 2 * s, c), blocks, sizes_of_matrices=fork.sizes)


def compiled_event(
    model: CompiledModel, event: Event, inputs: tuple[tuple[str, int], ...]
) -> tuple[Kernel, tuple[int, ...]]:
    """Return the Kernel of an event's effect on derivatives, and the states it changes."""
    key = ("the event", event.expression, *event.reset.items(), inputs)
    kernel = model.compiled_by(key, lambda: program_of_event(model, event, inputs))
    return kernel, changed_by(event, model.layout.states)


@dataclass
class SensitivityRequest:
    """The requested sensitivities of a simulation: an argument of `integrate` and `simulate`.

    `parameters` are symbols, names or groups such as ``'states'``, as in `System.simulate`. If
    derivatives are the main result, as in orbits, they are `controlled`.
    """

    parameters: SymbolOrName | Iterable[SymbolOrName]
    # whether the step control of a native solver includes the sensitivities
    controlled: bool = False
    initial: np.ndarray | None = None  # initial values, shape (n, k); by default they are computed
    untimed: frozenset[int] = frozenset()  # see `CompiledSensitivities`
    sensitive: AugmentedSystem = field(init=False)  # from the call of `augment` on

    def augment(
        self,
        problem: Problem,
        model: CompiledModel,
        times: np.ndarray,
        solver: object,
        options: dict[str, Any],
    ) -> tuple[Callable[..., np.ndarray], np.ndarray, dict[str, Any]]:
        """Return the right-hand side, the initial values and the options of the solver.

        The `model` is that of the states alone.
        """
        self.sensitive = sensitive = AugmentedSystem.for_parameters(
            problem, model, problem.plan, self.parameters
        )
        values = (
            sensitive.start(problem.x, float(times[0])) if self.initial is None else self.initial
        )
        columns = sensitive.columns
        if isinstance(solver, Solver):
            controlled = sensitive.controlled(self.controlled)
            options = sensitive.stepped(solver, options, problem.x, times, controlled)
            sources = () if (events := options.get("events")) is None else events.sources
            compiled = sensitive.compiled(problem.x, options, self.controlled, sources)
            compiled = replace(compiled, untimed=self.untimed)
            options = {**options, "sensitivities": compiled}
        else:
            if isinstance(solver, SolveIvp) and "events" in options:
                options = {**options, "events": of_states(options["events"], columns.states)}
            for name in options.keys() & {"rtol", "atol"}:
                if np.size(options[name]) == columns.states > 1:  # others as of their states
                    every = np.repeat(np.asarray(options[name]), columns.count)
                    options = {**options, name: np.concatenate([options[name], every])}
        return sensitive.function(), columns.together(problem.x, values), options

    def cut(self, error: Any) -> None:
        """Remove the sensitivities from the states in an error."""
        n = self.sensitive.columns.states
        if getattr(error, "states", None) is not None:
            error.states = error.states[:, :n]
        explain_columns(error, error.state[n:])
        error.state = error.state[:n]
