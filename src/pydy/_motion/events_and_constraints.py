"""Compile the events and constraints that native solvers need in addition to the equations."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Literal

from pydy._assembly import (
    Assembly,
    CompiledModel,
    Definition,
    constraints_with_redundant,
    kinetic_hessian,
    lower_nodes,
)
from pydy._checks import SymbolIndex, describe, typed
from pydy._graph import (
    Graph,
    LinearSystem,
    NodeExpression,
    directional,
    inputs_of,
    jacobian,
    reach,
    rounding_bounds,
)
from pydy._mechanics import Equations
from pydy._program import OPERATIONS, Program
from pydy.solvers import (
    SOLVERS,
    CompiledConstraints,
    CompiledEvents,
    ConstraintSizes,
    Event,
    EventTraits,
    Solver,
    StepOptions,
    Turn,
)

if TYPE_CHECKING:
    import sympy as sm

    from pydy._sympy_types import AnySymbol


class EnsembleOptions(StepOptions, total=False):
    """Options of `System.integrate_ensemble` that decide each integration, for type checkers."""

    constraints: Literal["project", "baumgarte"] | None
    gain: float | None
    events: Event | Iterable[Event] | None


def native_solver(ode_solver: object) -> Solver:
    """Return a System's `ode_solver` if it is native, else the default native one."""
    return ode_solver if isinstance(ode_solver, Solver) else SOLVERS["dop853"]


def check_events(events: object, states: SymbolIndex) -> tuple[Event, ...]:
    """Return the events of an argument, with states in place of names in their resets."""
    if events is None or isinstance(events, Event):
        events = () if events is None else (events,)
    if not isinstance(events, Iterable) or isinstance(events, (str, bytes)):
        remedy = f" Use `Event({events})`." if hasattr(events, "free_symbols") else ""
        raise TypeError(f"`events` must be a list of Event, got {type(events).__name__}.{remedy}")
    checked = []
    for event in events:
        if not isinstance(event, Event):
            raise TypeError(
                f"`events` must hold objects of pydy.solvers.Event, got {typed(event)}."
                + (f" Use `Event({event})`." if hasattr(event, "free_symbols") else "")
            )
        reset = {}
        for key, after in event.reset.items():
            index = states.get(key, "reset")
            if index is None:
                raise ValueError(
                    f"`reset` of the event `{event.name}` has a value for `{key}`, which is no "
                    f"state of the system: {describe(states.symbols)}.{states.suggestion(key)}"
                )
            if states.symbols[index] in reset:
                raise ValueError(
                    f"`reset` of the event `{event.name}` gives `{states.symbols[index]}` more "
                    "than once, by the symbol or by its name. Keep one of them."
                )
            reset[states.symbols[index]] = after
        checked.append(replace(event, reset=reset))
    names = [event.name for event in checked]
    double = [name for name in names if names.count(name) > 1]
    if double:
        raise ValueError(
            f"`events` must have different names, got `{double[0]}` twice. An event without a name "
            "is called after its expression: use `Event(..., name=...)`."
        )
    return tuple(checked)


def with_residuals_projected(
    definition: Definition, solver: object, options: Mapping[str, object]
) -> dict[str, object]:
    """Return options that project residuals of an `Implicit`, unless constraints are chosen."""
    implicit = definition.equations.constraints.residuals.implicit
    native_implicit = implicit is not None and isinstance(solver, Solver)
    must_project = native_implicit and options.get("constraints") is None
    return {**options, "constraints": "project"} if must_project else {**options}


def compile_events(
    model: CompiledModel, definition: Definition, events: tuple[Event, ...]
) -> CompiledEvents:
    """Compile events, their rates, bounds on their change in a step, and their resets."""
    expressions = tuple(event.expression for event in events)
    states = definition.states
    assembly = model.assembly.fork()
    graph = assembly.graph
    nodes = assembly.read(expressions, "the events")

    groups = [inputs_of(graph, [node]).groups for node in nodes]
    slopes = _slopes(assembly, nodes)

    def resets() -> Program:
        fork, after = model.assembly.fork(), []
        for event in events:
            state_after = [event.reset.get(s, s) for s in states]
            after += fork.read(state_after, f"`reset` of the event `{event.name}`")
        return lower_nodes(fork, {"resets": after}, {"resets": (len(events), len(states))})

    redirects = _redirects(assembly, slopes, events, states)
    traits = tuple(
        EventTraits(
            name=event.name,
            direction=event.direction,
            terminal=bool(event.terminal),
            resets=bool(event.reset),
            turns=isinstance(event, Turn),
            constant=inputs <= {"p"},
            linear="r" not in inputs and inputs_of(graph, row.values()).groups <= {"p"},
            redirects=changes_rate,
            may_rest=_may_rest(graph, event, node, inputs),
        )
        for event, node, inputs, row, changes_rate in zip(
            events, nodes, groups, slopes, redirects, strict=True
        )
    )
    sources = [k - event.turns for k, event in enumerate(traits)]
    far = event_reach(assembly, [nodes[k] for k in sources])
    key = ("resets of the events", *(tuple(event.reset.items()) for event in events))
    return CompiledEvents(
        traits,
        values=model.compiled_expressions("the events", (len(nodes),), expressions),
        rates=model.compiled_by(
            ("rates and bounds of the events", *expressions),
            lambda: event_rates_program(model.assembly, expressions, bounds=True),
        ),
        reach=None
        if far is None
        else model.compiled_by(("reach", *(expressions[k] for k in sources)), far),
        resets=model.compiled_by(key, resets) if any(event.resets for event in traits) else None,
        sources=events,
        input_rates=model.compiled_by(
            ("rates of the events by specifieds", *expressions),
            lambda: event_input_rates_program(model.assembly, expressions),
        )
        if any("r" in inputs for inputs in groups)
        else None,
    )


def _may_rest(graph: Graph, event: Event, node: int, inputs: Collection[str]) -> bool:
    """Return whether an event's expression may be zero all along a stretch."""
    if isinstance(event.expression, NodeExpression):  # contacts check their own events
        return False
    reachable = graph.reachable([node])
    return "r" in inputs or any(graph.ops[n] in OPERATIONS.partly_constant for n in reachable)


def event_redirects(
    assembly: Assembly, events: Sequence[Event], states: Sequence[AnySymbol]
) -> tuple[bool, ...]:
    """Return whether each event's reset changes a state that the event's own rate depends on."""
    fork = assembly.fork()
    nodes = fork.read(tuple(event.expression for event in events), "the events")
    return _redirects(fork, _slopes(fork, nodes), events, states)


def _slopes(assembly: Assembly, nodes: Sequence[int]) -> Sequence[Mapping[int, int]]:
    """Return the derivatives of expressions by the states and, last, by time."""
    graph = assembly.graph
    moving = [*(graph.input("x", k) for k in range(assembly.sizes[0])), graph.input("t", 0)]
    return jacobian(graph, nodes, moving)


def _redirects(
    assembly: Assembly,
    slopes: Sequence[Mapping[int, int]],
    events: Sequence[Event],
    states: Sequence[AnySymbol],
) -> tuple[bool, ...]:
    graph, redirects = assembly.graph, []
    for event, row in zip(events, slopes, strict=True):
        rates = [assembly.blocks.rates[i] for i in row if i < len(states)] if event.reset else []
        inputs = {*inputs_of(graph, [*row.values(), *rates]).values()}
        changed = [k for k, state in enumerate(states) if state in event.reset]
        redirects.append(any(("x", k) in inputs for k in changed))
    return tuple(redirects)


def event_rates_program(
    assembly: Assembly, expressions: Sequence[sm.Expr | NodeExpression], bounds: bool = False
) -> Program:
    """Return the Program of the events' rates, and of bounds on their roundings."""
    fork = assembly.fork()
    graph = fork.graph
    nodes = fork.read(expressions, "the events")
    tangents = {graph.input("x", k): {0: rate} for k, rate in enumerate(fork.blocks.rates)}
    rows = directional(graph, nodes, {**tangents, graph.input("t", 0): {0: graph.one}})
    totals = [row.get(0, graph.zero) for row in rows]
    if not bounds:
        return lower_nodes(fork, {"rates": totals})
    return lower_nodes(fork, {"rates": totals, "bounds": rounding_bounds(graph, nodes)}, as_is=True)


def event_input_rates_program(
    assembly: Assembly, expressions: Sequence[sm.Expr | NodeExpression]
) -> Program:
    """Return the Program of ∂g/∂r · ṙ, with ṙ behind r among its inputs."""
    fork = assembly.fork()
    graph, (n, s, c) = fork.graph, fork.sizes
    nodes = fork.read(expressions, "the events")
    tangents = {graph.input("r", i): {0: graph.input("r", s + i)} for i in range(s)}
    rows = directional(graph, nodes, tangents)
    totals = [row.get(0, graph.zero) for row in rows]
    return lower_nodes(fork, {"rates": totals}, sizes=(n, 2 * s, c))


def event_reach(assembly: Assembly, nodes: Sequence[int]) -> Callable[[], Program] | None:
    """Return a function that builds the Program of events and bounds on their change in a step.

    The largest changes of the states and of time follow the specifieds in r. The result is None if
    an event cannot be bounded.
    """
    graph, (n, s, k) = assembly.graph, assembly.sizes
    inputs = [*(graph.input("x", i) for i in range(n)), graph.input("t", 0)]
    bounds = reach(graph, nodes, {x: graph.input("r", s + i) for i, x in enumerate(inputs)})
    finite_bounds = [bound for bound in bounds if bound is not None]
    if len(finite_bounds) < len(bounds):
        return None
    parts, sizes = {"values": nodes, "reach": finite_bounds}, (n, s + n + 1, k)
    return lambda: lower_nodes(assembly, parts, sizes=sizes, as_is=True)


def event_bounds_program(
    assembly: Assembly, expressions: Sequence[sm.Expr | NodeExpression]
) -> Program:
    """Return the Program of bounds on the roundings of the events' expressions."""
    fork = assembly.fork()
    nodes = fork.read(expressions, "the events")
    return lower_nodes(fork, {"bounds": rounding_bounds(fork.graph, nodes)})


def compile_constraints(model: CompiledModel, definition: Definition) -> CompiledConstraints:
    """Compile the constraints for the projection."""
    equations = definition.equations
    mechanism = equations.mechanism
    weighted = mechanism is not None and bool(mechanism.bodies)
    model, (closed, redundant) = with_all(model, definition), equations.constraints.redundant
    kernel = model.compiled_by(("projection",), lambda: projection_program(model.assembly))
    blocks = model.assembly.blocks
    moved = inputs_of(model.assembly.graph, [*blocks.holonomic, *blocks.velocity]).groups
    return CompiledConstraints(
        kernel=kernel,
        sizes=ConstraintSizes(
            holonomic=len(blocks.holonomic),
            velocity=len(blocks.velocity),
            coordinates=len(equations.coordinates),
            speeds=len(equations.speeds),
        ),
        dependent_speeds=equations.dependents.speed_columns,
        weighted=weighted,
        judged="r" not in moved and ("t" in moved or bool(equations.constraints.residuals.columns)),
        following=equations.constraints.residuals.columns,
        names=ConstraintNames(equations),
        left_out=(len(closed), len(redundant)),
    )


def constraint_names(equations: Equations, redundant: bool = False) -> tuple[str, ...]:
    """Return names of the holonomic, then the velocity constraints, including `redundant` ones."""
    constraints = equations.constraints
    left_out = constraints.redundant if redundant else ((), ())
    enforced = ("holonomic", constraints.holonomic), ("velocity", constraints.velocity)
    names = []
    for (kind, rows), redundant_rows in zip(enforced, left_out, strict=True):
        for k, row in enumerate((*rows, *redundant_rows)):
            text = str(row)
            name = f"{kind} constraint {k}" if k < len(rows) else f"redundant {kind} constraint"
            names.append(f"{name}: {text if len(text) <= 60 else text[:57] + '...'}")
    return tuple(names)


class ConstraintNames(Sequence[str]):
    """The names of constraints, which are printed when one is needed: this may take long."""

    def __init__(self, equations: Equations) -> None:
        self._equations: Equations | None = equations
        self._names: tuple[str, ...] = ()

    def _all_names(self) -> tuple[str, ...]:
        if self._equations is not None:
            self._names, self._equations = constraint_names(self._equations, redundant=True), None
        return self._names

    def __len__(self) -> int:
        return len(self._all_names())

    def __getitem__(self, k: Any) -> Any:
        return self._all_names()[k]

    # A worker has no SymPy to print with.
    def __reduce__(self) -> tuple[type[tuple[str, ...]], tuple[tuple[str, ...]]]:
        return tuple, (self._all_names(),)


def with_all(model: CompiledModel, definition: Definition) -> CompiledModel:
    """Return the equations with all constraints, the redundant ones last."""

    def change(original: Assembly) -> Assembly:
        holonomic, velocity = constraints_with_redundant(original)
        blocks = replace(original.blocks, holonomic=holonomic, velocity=velocity)
        return replace(original, blocks=blocks)

    unchanged = not any(definition.equations.constraints.redundant)
    return model if unchanged else model.variant("all constraints", change)


def projection_program(assembly: Assembly) -> Program:
    """Return the Program of `CompiledConstraints`."""
    assembly = assembly.fork()
    assert assembly.equations is not None
    graph, speeds = assembly.graph, assembly.speeds
    first = graph.args[speeds[0]][1]
    coordinates = [graph.input("x", k) for k in range(first)]
    gradient = jacobian(graph, assembly.blocks.holonomic, coordinates).dense()
    rates = assembly.blocks.rates[:first]
    residuals = assembly.equations.constraints.residuals
    for k in _separate(graph, gradient, residuals.rows, residuals.columns):
        rates[k] = graph.zero
    kinematics = jacobian(graph, rates, speeds).dense()
    parts = {
        "holonomic": assembly.blocks.holonomic,
        "velocity": assembly.blocks.velocity,
        "gradient": [cell for row in gradient for cell in row],
        "kinematics": [cell for row in kinematics for cell in row],
        "velocity_gradient": jacobian(graph, assembly.blocks.velocity, speeds).flat(),
        "kinetic_hessian": kinetic_hessian(assembly),
    }
    return lower_nodes(assembly, parts, bounded="holonomic")


def _separate(
    graph: Graph, gradient: list[list[int]], rows: Sequence[int], columns: Sequence[int]
) -> Sequence[int]:
    """Let residuals g correct only the coordinates z that they determine; return their columns.

    The gradient of g becomes ∂g/∂z, without a part for speeds. In the gradients of other
    constraints h, z is eliminated: h_q − h_z g_z⁻¹ g_q. Projection onto g then changes no other
    coordinate.
    """
    if len(rows) != len(columns):
        return ()
    zero = graph.zero
    block = [[gradient[i][k] for k in columns] for i in rows]
    for i, row in enumerate(gradient):
        if i in rows or all(row[k] == zero for k in columns):
            continue
        transposed = [list(column) for column in zip(*block, strict=True)]
        share = LinearSystem(graph, transposed).solve([row[k] for k in columns])
        for k in range(len(row)):
            terms = [(graph.mul(a, gradient[g][k]), -1.0) for a, g in zip(share, rows, strict=True)]
            row[k] = zero if k in columns else graph.sum([(row[k], 1.0), *terms])
    for i in rows:
        gradient[i] = [c if k in columns else zero for k, c in enumerate(gradient[i])]
    return columns
