"""Exports of a System: from its equations and numbers to a `pydy.export.Model`."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import partial
from itertools import islice
from operator import methodcaller
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sm

from pydy._assembly.assembly import Assembly
from pydy._assembly.definition import Definition
from pydy._assembly.model import stored_program
from pydy._assembly.specifieds import followed
from pydy._checks import choice, describe, file_of, flag, listed, text
from pydy._graph.program import Program
from pydy._mechanics.symbols import find_symbols
from pydy._names import name_of, unique_names
from pydy._optional import progress_of
from pydy._simulation.events_and_constraints import (
    check_events,
    event_bounds_program,
    event_rates_program,
    event_redirects,
    projection_program,
    with_all,
)
from pydy._simulation.missing_derivatives import warn_of_missing_derivatives
from pydy._simulation.problem import Problem
from pydy._system.setup import Setup
from pydy.codegen.arguments import SpecifiedsPlan

if TYPE_CHECKING:
    from pydy.export import Exported, Model
    from pydy.solvers.events import Event
    from pydy.viz.live import LiveSystem


def _dependents(problem: Problem) -> tuple[list[int], list[int]]:
    """Return the positions in x of the states that constraints determine, or all if unknown."""
    equations, count = problem.definition.equations, problem.coordinate_count
    places, solved = problem.dependent, problem.solved_for
    q, u = [k for k in places if k < count], [k for k in places if k >= count]
    if solved is None and len(q) < len(equations.holonomic):
        q = list(range(count))
    if solved is None and len(u) < len(equations.velocity):
        u = list(range(count, count + len(equations.speeds)))
    return q, u


def _input_places(
    definition: Definition, plan: SpecifiedsPlan, inputs: Sequence[Any] | None
) -> tuple[int, ...]:
    """Return which specifieds are inputs of the exported model.

    A live page has no argument `inputs`, which is None: its inputs are numbers.
    """
    wanted = {definition.places["specifieds"].find(key, "inputs") for key in inputs or ()}
    given = followed(definition, plan)
    for columns, what in (
        *((part[0], "a Python function") for part in plan.functions),
        *((part[0], "samples") for part in plan.sampled),
    ):
        for k in columns.tolist():
            if k not in wanted:
                symbol = plan.symbols[k]
                given_by = f"`specifieds` gives `{symbol}` by {what}, which cannot"
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
    return tuple(k for k, symbol in enumerate(definition.specifieds) if symbol not in given)


def _check_resets(definition: Definition, events: Sequence[Event]) -> None:
    """Refuse resets after which residuals give other unknowns: exported code does not solve."""
    implicit = definition.equations.implicit
    if implicit is None:
        return
    held = {*find_symbols(map(definition.equations.in_states, implicit.residuals.values()))}
    for event in events:
        if moved := [s for s in event.reset if s in held]:
            raise ValueError(
                f"`events`: `{event.name}` resets {describe(moved)}, which the residuals of "
                "`implicit` hold. They give other values then, but exported code does not solve "
                "them. Leave the event out, or make it terminal without a reset and begin again "
                "with values that fit."
            )


def _names(symbols: Sequence[Any]) -> list[str]:
    """Return a name for each symbol, none twice; derivatives are called as in FMI: ``der(F)``."""
    spelled = []
    for name, symbol in zip(unique_names(symbols), symbols, strict=True):
        if isinstance(symbol, sm.Derivative):
            order = int(symbol.derivative_count)
            name = f"der({name_of(symbol.expr)}{f',{order}' if order > 1 else ''})"
        spelled.append(re.sub(r"\s+", " ", name))
    return spelled


def _held(problem: Problem) -> dict[str, Any]:
    """Return the sizes that projection works with."""
    equations, assembly = problem.definition.equations, problem.code.assembly
    if not (assembly.holonomic or assembly.velocity):
        raise ValueError("`constraints='project'` holds constraints, but the system has none.")
    every = with_all(problem.code, problem.definition).assembly
    return {
        "holonomic": len(every.holonomic),
        "velocity": len(every.velocity),
        "positions": len(assembly.holonomic),
        "motions": len(assembly.velocity),
        "coordinates": len(equations.coordinates),
        "speeds": len(equations.speeds),
        "weighted": int(equations.mechanism is not None and bool(equations.mechanism.bodies)),
        "following": equations.following[1],
    }


def _builders(
    problem: Problem, places: tuple[int, ...], events: Sequence[Event], projected: bool
) -> dict[str, Callable[[], Program]]:
    """Return what makes the Programs of a model with specifieds at some places as inputs."""
    from pydy.export.model import PARTS, with_inputs

    assembly = problem.code.assembly
    n, found = len(problem.definition.states), dict[str, Callable[[], Program]]()

    def store(part: str, what: str, make: Any, assembly: Assembly = assembly) -> None:
        program = partial(stored_program, assembly, what, lambda: make(assembly))
        found[part] = lambda: with_inputs(program(), places)

    def jacobian(assembly: Assembly) -> Program:
        by = [*(("x", k) for k in range(n)), *(("r", k) for k in places)]
        both = replace(assembly, rates=[*assembly.rates, *assembly.outputs])
        return both.jacobian_program("rates", by)

    for part in ("rates", "outputs"):
        store(part, part, methodcaller("program", part))
    store("jacobian", f"exported jacobian {places}", jacobian)
    for part in (part for part in PARTS if getattr(assembly, part)):
        store(part, f"exported {part}", methodcaller("program", part))
    if projected:
        what = f"projection {assembly.following}" if any(assembly.following) else "projection"
        every = with_all(problem.code, problem.definition).assembly
        store("projection", what, projection_program, every)
    if events:
        expressions = tuple(event.expression for event in events)
        resets = [e.reset.get(s, s) for e in events for s in problem.definition.states]
        count, formulas = len(events), assembly.expression_program
        for part, make in {
            "events": partial(formulas, "the events", (count,), expressions),
            "resets": partial(formulas, "the resets of the events", (count, n), resets),
            "event_rates": partial(event_rates_program, assembly, expressions),
            "event_bounds": partial(event_bounds_program, assembly, expressions),
        }.items():
            found[part] = partial(lambda make: with_inputs(make(), places), make)
    return found


class Exporting(Setup):
    """The system as code for other programs and for a page."""

    def export(
        self,
        path: Any,
        *,
        name: str | None = None,
        events: Any = None,
        inputs: Iterable[Any] = (),
        progress: bool = False,
        **options: Any,
    ) -> Exported:
        """Write the system as code for another program: C, an FMU, JavaScript or Python.

        Parameters
        ----------
        path : path
            The suffix selects the format: ``.c`` (C99, with a header next to it), ``.fmu`` (a
            functional mock-up unit for Model Exchange and Co-Simulation), ``.js`` (an ECMAScript
            module) or ``.py`` (functions that need only NumPy, JAX or CasADi).
        name : str, optional
            Name of the model; by default the stem of the file.
        events : Event or sequence of Event, optional
            Events to export with their resets; event indicators in an FMU.
        inputs : iterable of specifieds, optional
            Specifieds given by a function or by samples that become inputs.
        progress : bool, optional
            Whether to show which part is made, the C compiler's included; requires tqdm.
        **options
            ``fmi`` ('3.0' or '2.0') and ``binary`` (False omits the compiled library) for
            ``.fmu``; ``target`` ('numpy', 'jax' or 'casadi') for ``.py``.

        Returns
        -------
        Exported
            ``path``, ``files``, and ``names``, the identifiers of names that are not valid ones.

        Raises
        ------
        ValueError
            Unknown suffix, or a specified given by a function or by samples.
        GeneratorError
            No C compiler was found for the binary of an FMU, or it failed.

        Examples
        --------
        >>> import os, tempfile
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1)
        >>> folder = tempfile.mkdtemp()
        >>> exported = system.export(os.path.join(folder, 'pendulum.c'))
        >>> [file.name for file in exported.files]
        ['pendulum.c', 'pendulum.h']
        """
        from pydy.export.writing import check_options, write

        target = file_of(path, "`path`")
        check_options(target, options)
        title = target.stem if name is None else text(name, "`name`")
        inputs = listed("inputs", inputs, "specifieds of the system", hashable=True)
        with progress_of(flag(progress, "`progress`"), " parts") as told:
            told(0, part="equations")
            model = self._exportable(name=title, events=events, inputs=inputs)
            told(1)
            return write(replace(model, told=told), target, **options)

    def _exportable(
        self,
        *,
        name: str = "model",
        events: Any = None,
        constraints: Any = None,
        inputs: Sequence[Any] | None = (),
    ) -> Model:
        """Return the Programs, names and numbers of the exported model."""
        from pydy.export.model import EventData, Model, Variable, identifiers

        problem = self._now(events)
        warn_of_missing_derivatives(problem)
        definition, times = problem.definition, problem.times
        start = float(times[0]) if len(times) else 0.0
        places = _input_places(definition, problem.plan, inputs)
        held = choice(constraints, (None, "project"), "`constraints`") and _held(problem)
        checked = check_events(events, definition.places["states"])
        _check_resets(definition, checked)
        r = problem.plan(problem.x, start) if places else np.zeros(0)
        parts = [
            (definition.states, problem.x),
            ([definition.specifieds[k] for k in places], r[[*places]]),
            (definition.constants, problem.p),
            (definition.outputs_symbols, np.zeros(len(definition.outputs_symbols))),
        ]
        names = _names([symbol for symbols, _ in parts for symbol in symbols])
        values = np.concatenate([numbers for _, numbers in parts]).tolist()
        variables = iter(map(Variable, names, identifiers(names), values))
        states, own, numbers, outputs = (tuple(islice(variables, len(s))) for s, _ in parts)
        return Model(
            name=identifiers([name])[0],
            title=name,
            states=states,
            inputs=own,
            constants=numbers,
            outputs=outputs,
            builders=_builders(problem, places, checked, bool(held)),
            events=EventData(
                tuple(event.name for event in checked),
                tuple(int(event.direction) for event in checked),
                tuple(bool(event.terminal) for event in checked),
                tuple(bool(event.terminal or event.reset) for event in checked),
                event_redirects(problem.code.assembly, checked, definition.states),
            ),
            start=start,
            stop=float(times[-1]) if len(times) > 1 else start + 1.0,
            constraints=held or {},
            unknowns=definition.equations.following[1],
        )

    def _live_system(self, *, constraints: Any = "auto", **options: Any) -> LiveSystem:
        """Return the model of a live page; `options` are those of `_exportable`."""
        from pydy.viz.live import LiveSystem

        problem = self._now()
        definition, plan = problem.definition, problem.plan
        equations = definition.equations
        constrained = bool(equations.holonomic or equations.velocity)
        if constraints == "auto":
            constraints = "project" if constrained else None
        exported = self._exportable(constraints=constraints, inputs=None, **options)
        formulas = dict(plan.expressions)
        for symbol in followed(definition, plan) - formulas.keys():
            # A derivative of a motion that is an expression.
            whole = plan.expressions.get(symbol.expr)
            if whole is not None:
                formulas[symbol] = whole.diff(equations.time, symbol.derivative_count)
        dependents: tuple[list[int], list[int]] = ([], [])
        if constraints is not None:
            dependents = _dependents(problem)
        return LiveSystem(
            model=exported,
            states=definition.states,
            inputs=tuple(definition.specifieds[k] for k in _input_places(definition, plan, None)),
            constants=definition.constants,
            outputs=definition.outputs_symbols,
            definitions=formulas,
            dependents=dependents,
            coordinates=len(equations.coordinates),
            speeds=len(equations.speeds),
        )
