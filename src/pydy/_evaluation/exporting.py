"""Build the `pydy.export.Model` of a Problem, for exported code and live pages."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING

import numpy as np
import sympy as sm

from pydy._assembly import (
    Assembly,
    Definition,
    expression_program,
    followed,
    stored_program,
)
from pydy._checks import choice, describe
from pydy._errors import warn_user
from pydy._graph import TimeSwitches, derivative_program, lower
from pydy._judges import check_orientations, start_program, warn_of_missing_derivatives
from pydy._mechanics import find_symbols
from pydy._motion import (
    ConstraintNames,
    check_events,
    event_bounds_program,
    event_input_rates_program,
    event_rates_program,
    event_redirects,
    projection_program,
    with_all,
)
from pydy._names import name_of, unique_names
from pydy._problem import Problem
from pydy._program import Program
from pydy.codegen import SpecifiedsPlan

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, SymbolOrName
    from pydy.export import Model
    from pydy.solvers import Event
    from pydy.viz import LiveSystem


def _dependents(problem: Problem) -> tuple[list[int], list[int]]:
    """Return the positions in x of the states that constraints determine, or all if unknown."""
    equations, count = problem.definition.equations, len(problem.definition.equations.coordinates)
    columns, solved = problem.dependent, problem.settings.solved_for
    q, u = [k for k in columns if k < count], [k for k in columns if k >= count]
    if solved is None and len(q) < len(equations.constraints.holonomic):
        q = list(range(count))
    if solved is None and len(u) < len(equations.constraints.velocity):
        u = list(range(count, count + len(equations.speeds)))
    return q, u


def _input_columns(
    definition: Definition, plan: SpecifiedsPlan, inputs: Sequence[SymbolOrName] | None
) -> tuple[int, ...]:
    """Return the columns in r of the exported model's inputs, ascending.

    These are all specifieds that no expression gives. The argument `inputs` only permits those that
    functions or samples give; it neither orders nor selects, and must not name those that
    expressions give, because these are parts of the equations. A live page has no such argument,
    which is None: its inputs are numbers.
    """
    requested = {definition.places["specifieds"].find(key, "inputs") for key in inputs or ()}
    prescribed = followed(definition, plan)
    named = [definition.specifieds[k] for k in sorted(requested)]
    if formulas := [symbol for symbol in named if symbol in prescribed]:
        raise ValueError(
            f"`inputs` has {describe(formulas)}, given by a SymPy expression in `specifieds`, "
            "which becomes part of the equations. Give a number in its place, the value at the "
            "start, and it becomes an input."
        )
    for columns, source in (
        *((part[0], "a Python function") for part in plan.inputs.functions),
        *((part[0], "samples") for part in plan.inputs.sampled),
    ):
        for k in columns.tolist():
            if k not in requested:
                symbol = plan.symbols[k]
                given_by = f"`specifieds` gives `{symbol}` by {source}, which cannot"
                expression = "as a SymPy expression, which becomes part of the equations, or as a"
                if inputs is None:
                    raise ValueError(
                        f"{given_by} run in a live page. Give it {expression} number, which can "
                        "have a slider."
                    )
                raise ValueError(
                    f"{given_by} be exported. Give it {expression} number; or pass "
                    f"inputs=['{name_of(symbol)}'], so that it becomes an input."
                )
    return tuple(k for k, symbol in enumerate(definition.specifieds) if symbol not in prescribed)


def _check_resets(definition: Definition, events: Sequence[Event]) -> None:
    """Refuse resets of symbols in the residuals, which exported code does not solve."""
    implicit = definition.equations.constraints.residuals.implicit
    if implicit is None:
        return
    in_states = definition.equations.kinematics.in_states
    symbols = {*find_symbols(map(in_states, implicit.residuals.values()))}
    for event in events:
        if moved := [s for s in event.reset if s in symbols]:
            raise ValueError(
                f"`events`: `{event.name}` resets {describe(moved)}, which the residuals of "
                "`implicit` hold. They give other values then, but exported code does not solve "
                "them. Leave the event out, or make it terminal without a reset and begin again "
                "with values that fit."
            )


def _names(symbols: Sequence[AnySymbol]) -> list[str]:
    """Return unique names of symbols; derivatives are named as in FMI: ``der(F)``."""
    spelled = []
    for name, symbol in zip(unique_names(symbols), symbols, strict=True):
        if isinstance(symbol, sm.Derivative):
            order = int(symbol.derivative_count)
            name = f"der({name_of(symbol.expr)}{f',{order}' if order > 1 else ''})"
        spelled.append(re.sub(r"\s+", " ", name))
    return spelled


def _projection_sizes(problem: Problem) -> dict[str, int | tuple[int, ...]]:
    """Return the sizes of the arrays in the projection."""
    equations, assembly = problem.definition.equations, problem.code.assembly
    if not (assembly.blocks.holonomic or assembly.blocks.velocity):
        raise ValueError("`constraints='project'` holds constraints, but the system has none.")
    every = with_all(problem.code, problem.definition).assembly
    return {
        "holonomic": len(every.blocks.holonomic),
        "velocity": len(every.blocks.velocity),
        "positions": len(assembly.blocks.holonomic),
        "motions": len(assembly.blocks.velocity),
        "coordinates": len(equations.coordinates),
        "speeds": len(equations.speeds),
        "weighted": int(equations.mechanism is not None and bool(equations.mechanism.bodies)),
        "following": equations.constraints.residuals.columns,
    }


def _builders(
    problem: Problem, columns: tuple[int, ...], events: Sequence[Event], projected: bool
) -> dict[str, Callable[[], Program]]:
    """Return the functions that build a model's Programs; the inputs are columns of r."""
    from pydy.export import PARTS, with_inputs

    assembly, programs = problem.code.assembly, problem.code.programs
    n, builders = len(problem.definition.states), dict[str, Callable[[], Program]]()

    def store(
        part: str, key: str, make: Callable[[Assembly], Program], assembly: Assembly = assembly
    ) -> None:
        program = partial(stored_program, assembly, key, lambda: make(assembly))
        builders[part] = lambda: with_inputs(program(), columns)

    def store_block(part: str) -> None:
        builders[part] = lambda: with_inputs(programs.of(part), columns)

    def jacobian(assembly: Assembly) -> Program:
        variables = [*(("x", k) for k in range(n)), *(("r", k) for k in columns)]
        rates = [*assembly.blocks.rates, *assembly.blocks.outputs]
        with_outputs = replace(assembly, blocks=replace(assembly.blocks, rates=rates))
        graph, nodes = with_outputs.simplified("rates")
        return derivative_program(graph, nodes, variables, "jacobian", assembly.sizes)

    for part in ("rates", "outputs"):
        store_block(part)
    store("jacobian", f"exported jacobian {columns}", jacobian)
    for part in (part for part in PARTS if getattr(assembly.blocks, part)):
        store_block(part)
    if projected:
        residuals = problem.definition.equations.constraints.residuals
        key = f"projection {residuals.rows, residuals.columns}" if residuals.rows else "projection"
        every = with_all(problem.code, problem.definition).assembly
        store("projection", key, projection_program, every)
    if events:
        expressions = tuple(event.expression for event in events)
        resets = [e.reset.get(s, s) for e in events for s in problem.definition.states]
        count, formulas = len(events), partial(expression_program, assembly)
        for part, make in {
            "events": partial(formulas, "the events", (count,), expressions),
            "resets": partial(formulas, "the resets of the events", (count, n), resets),
            "event_rates": partial(event_rates_program, assembly, expressions),
            "event_bounds": partial(event_bounds_program, assembly, expressions),
        }.items():
            builders[part] = partial(lambda make: with_inputs(make(), columns), make)
        if columns:
            # The rates of the inputs follow these.
            both = (*columns, *(assembly.sizes[1] + k for k in columns))
            builders["event_input_rates"] = lambda: with_inputs(
                event_input_rates_program(assembly, expressions), both
            )
    return builders


def _switch_times(
    problem: Problem, r: np.ndarray, span: tuple[float, float], max_step: float | None
) -> Program | None:
    """Return the Program of the times at which the rates switch whatever the states are, if any.

    These are zeros of switches that are linear in time, which depend on constants and inputs: the
    exported code computes them anew where these change. Warns if others are closer to one another
    than the longest step of the exported code, None if it has no solver.
    """
    rates = problem.code.programs.of("rates")
    switches = TimeSwitches.of(rates, frozenset())
    if switches is None:
        return None
    times, others = switches.split_by_linearity()
    if max_step is not None and others is not None:
        _warn_of_pulses(others, problem, r, span, max_step)
    if not times:
        return None
    sizes = rates.signature.sizes
    return lower(switches.graph, sizes, [("switches", (len(times),), times)])


def _warn_of_pulses(
    switches: TimeSwitches,
    problem: Problem,
    r: np.ndarray,
    span: tuple[float, float],
    max_step: float,
) -> None:
    """Warn of switches that are closer than the longest step, with the present inputs r."""
    zeros = switches.times(problem.p, r, *span)
    closest = float(np.diff(zeros.rows[:, 0]).min(initial=np.inf))
    if zeros.unresolved * max_step > span[1] - span[0] or closest < max_step:
        several = f"{zeros.unresolved or len(zeros.rows)} times"
        several += f", the closest {closest:.4g} apart," if np.isfinite(closest) else ""
        warn_user(
            f"A load or rate switches by time alone {several} from t = {span[0]:.6g} to "
            f"{span[1]:.6g}, by conditions that are not linear in time: exported code does not "
            "know when, so that its steps may pass over a pulse. Keep them shorter than the "
            "shortest pulse: by `maxStep` in JavaScript, by `max_step` of a live page, and by the "
            "communication step or the importer's longest step of an FMU."
        )


def exported_model(
    problem: Problem,
    *,
    name: str = "model",
    events: Event | Iterable[Event] | None = None,
    constraints: str | None = None,
    inputs: Sequence[SymbolOrName] | None = (),
    max_step: float | None = None,
) -> Model:
    """Return the Programs, names and numbers of a Problem for exported code.

    Its solver takes steps up to `max_step`; None if it has no solver.
    """
    from pydy.export import EventData, Model, Variable, identifiers, with_inputs

    warn_of_missing_derivatives(problem)
    definition, times = problem.definition, problem.settings.times
    start = float(times[0]) if len(times) else 0.0
    columns = _input_columns(definition, problem.plan, inputs)
    mode = choice(constraints, (None, "project"), "`constraints`")
    projection = mode and _projection_sizes(problem)
    checked = check_events(events, definition.places["states"])
    _check_resets(definition, checked)
    stop = float(times[-1]) if len(times) > 1 else start + 1.0
    r = problem.inputs(problem.x, start) if columns else np.zeros(len(definition.specifieds))
    switches = _switch_times(problem, r, (start, stop), max_step)
    builders = _builders(problem, columns, checked, bool(projection))
    check_orientations(problem.at(np.array([start]), problem.x[None]))
    names_of_constraints: tuple[str, ...] = ()
    if max_step is not None and not projection:
        names_of_constraints = tuple(ConstraintNames(definition.equations))
    if names_of_constraints:
        start_residuals = partial(
            stored_program, problem.code.assembly, "start residuals",
            lambda: start_program(problem.code.assembly),
        )  # fmt: skip
        builders["start_residuals"] = lambda: with_inputs(start_residuals(), columns)
    if switches is not None:
        builders["switches"] = lambda: with_inputs(switches, columns)
    parts = [
        (definition.states, problem.x),
        ([definition.specifieds[k] for k in columns], r[[*columns]]),
        (definition.constants, problem.p),
        (definition.outputs.symbols, np.zeros(len(definition.outputs.symbols))),
    ]
    names = _names([symbol for symbols, _ in parts for symbol in symbols])
    values = np.concatenate([numbers for _, numbers in parts]).tolist()
    variables = iter(map(Variable, names, identifiers(names), values))
    states, model_inputs, numbers, outputs = (tuple(islice(variables, len(s))) for s, _ in parts)
    return Model(
        name=identifiers([name])[0],
        title=name,
        states=states,
        inputs=model_inputs,
        constants=numbers,
        outputs=outputs,
        builders=builders,
        events=EventData(
            tuple(event.name for event in checked),
            tuple(int(event.direction) for event in checked),
            tuple(bool(event.terminal) for event in checked),
            tuple(bool(event.terminal or event.reset) for event in checked),
            event_redirects(problem.code.assembly, checked, definition.states),
        ),
        start=start,
        stop=stop,
        switches=0 if switches is None else switches.signature.num_outputs,
        constraints=projection or {},
        unknowns=definition.equations.constraints.residuals.columns,
        constraint_names=names_of_constraints,
    )


def live_system(
    problem: Problem,
    *,
    name: str = "model",
    constraints: str | None = "auto",
    events: Event | Iterable[Event] | None = None,
    max_step: float | None = None,
) -> LiveSystem:
    """Return a Problem in the format of a live page, which simulates in the browser."""
    from pydy.viz import LiveSystem

    definition, plan = problem.definition, problem.plan
    equations = definition.equations
    constrained = bool(equations.constraints.holonomic or equations.constraints.velocity)
    if constraints == "auto":
        constraints = "project" if constrained else None
    exported = exported_model(
        problem,
        name=name,
        events=events,
        constraints=constraints,
        inputs=None,
        max_step=np.inf if max_step is None else max_step,
    )
    formulas = dict(plan.expressions)
    for symbol in followed(definition, plan) - formulas.keys():
        # A derivative of a motion that is an expression.
        motion = plan.expressions.get(symbol.expr)
        if motion is not None:
            formulas[symbol] = motion.diff(equations.time, symbol.derivative_count)
    dependents: tuple[list[int], list[int]] = ([], [])
    if constraints is not None:
        dependents = _dependents(problem)
    return LiveSystem(
        model=exported,
        states=definition.states,
        inputs=tuple(definition.specifieds[k] for k in _input_columns(definition, plan, None)),
        constants=definition.constants,
        outputs=definition.outputs.symbols,
        definitions=formulas,
        dependents=dependents,
        coordinates=len(equations.coordinates),
        speeds=len(equations.speeds),
    )
