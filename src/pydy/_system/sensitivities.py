"""Sensitivities of a simulation: which parameters, their columns at the start, and the equations.

The columns ∂x/∂θ are integrated beside the state (`pydy._graph.columns`). An initial condition is a
parameter of its own state; where the constraints tie others to it, they follow by the implicit
function theorem: from c(x, θ) = 0 follows c_d x_d' = −(c_i x_i' + c_θ) for the dependent states d.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np
import sympy as sm

from pydy._assembly.definition import Definition
from pydy._assembly.model import CompiledModel
from pydy._assembly.stored import stored_program
from pydy._backends.llvm.backend import LLVMBackend
from pydy._backends.llvm.columns import compile_columns, lanes_for
from pydy._checks import Places, describe, one_or_more
from pydy._graph.columns import Columns
from pydy._graph.program import Program
from pydy._graph.split import SplitProgram
from pydy._kernel import Inputs, Kernel, KernelCall
from pydy._system.samples import by_samples, mean_spacing
from pydy._system.tuning import UNSOLVED_COLUMNS
from pydy.analysis.tuning import FREE
from pydy.codegen.arguments import SpecifiedsPlan
from pydy.inputs import SampledInput
from pydy.solvers.events import Event
from pydy.solvers.sensitivities import CompiledSensitivities
from pydy.solvers.solver import Solver

__all__ = ["Parameter", "Sensitive", "Wanted", "read_parameters"]


@dataclass(frozen=True)
class Parameter:
    """Something that a motion depends on.

    Attributes
    ----------
    symbol : symbol
        A constant, a state for its initial condition, or a specified.
    kind : {'constants', 'states', 'specifieds'}
    place : int
        In p, x or r.
    samples : SampledInput or None
        The samples of a specified, of which each is a parameter; those of this one alone.
    """

    symbol: Any
    kind: str
    place: int
    samples: SampledInput | None = None

    @property
    def count(self) -> int:
        """The number of columns."""
        return 1 if self.samples is None else len(self.samples.times)


def read_parameters(
    definition: Definition, plan: SpecifiedsPlan, wanted: Any, argument: str = "sensitivities"
) -> tuple[Parameter, ...]:
    """Return the parameters that a user named, in the argument of a name.

    Raises
    ------
    ValueError
        One that the system does not have, or has twice; or a specified of which no derivative is
        taken.
    """
    symbols = one_or_more(argument, wanted)
    if not symbols:
        raise ValueError(
            f"`{argument}` must name at least one constant, initial condition or specified."
        )
    for _, _, label in plan.functions:
        raise ValueError(
            f"`{argument}` needs the derivatives of the specifieds, but {label} is a Python "
            "function, which has none. Give it as a SymPy expression of states, time and "
            "constants, or as samples, pydy.inputs.SampledInput(times, values)."
        )
    found: dict[tuple[str, int], Parameter] = {}
    for symbol in symbols:
        parameter = _parameter(definition, plan, symbol, argument)
        place = (parameter.kind, parameter.place)
        if place in found:
            raise ValueError(
                f"`{argument}` has `{parameter.symbol}` more than once. Keep one of them."
            )
        found[place] = parameter
    return tuple(found.values())


def _parameter(definition: Definition, plan: SpecifiedsPlan, key: Any, argument: str) -> Parameter:
    kinds = ("constants", "states", "specifieds")
    for kind in kinds:
        place = definition.places[kind].get(key, argument)
        if place is not None:
            break
    else:
        everything = [s for kind in kinds for s in definition.places[kind].symbols]
        what = "constants, states (for their initial conditions) and specifieds of the system"
        Places(everything, what).find(key, argument)  # raises, with names that are alike
        raise AssertionError(key)
    symbol = definition.places[kind].symbols[place]
    if kind != "specifieds":
        return Parameter(symbol, kind, place)
    if symbol in plan.expressions:
        raise ValueError(
            f"`{argument}` has the specified `{symbol}`, which is given as the expression "
            f"`{plan.expressions[symbol]}`. Name the constants in it instead."
        )
    for columns, samples in plan.sampled:
        if place in columns:
            return Parameter(symbol, kind, place, samples.of([columns.tolist().index(place)]))
    if isinstance(symbol, sm.Derivative) and symbol not in plan.given:
        raise ValueError(
            f"`{argument}` has `{symbol}`, which follows from `{symbol.expr}`. Name that "
            "instead, or the constants in its expression."
        )
    return Parameter(symbol, kind, place)


@dataclass(frozen=True, eq=False)
class Sensitive:
    """A System's equations with columns of sensitivities beside the state.

    Attributes
    ----------
    definition : Definition
    model : CompiledModel
        With its linear solve and all expressions compiled in, as it is integrated.
    plan : SpecifiedsPlan
    parameters : tuple of Parameter
    p : ndarray
    argument : str
        That named the parameters.
    """

    definition: Definition
    model: CompiledModel
    plan: SpecifiedsPlan
    parameters: tuple[Parameter, ...]
    p: np.ndarray
    argument: str = "sensitivities"
    columns: Columns = field(init=False)

    def __post_init__(self) -> None:
        s = len(self.definition.specifieds)
        directions: list[Any] = []
        weights = 0
        for parameter in self.parameters:
            if parameter.kind == "states":
                directions.append(None)
            elif parameter.kind == "constants":
                directions.append(("p", parameter.place))
            elif parameter.samples is None:
                directions.append(("r", parameter.place))
            else:
                for _ in range(parameter.count):
                    directions.append(("r", parameter.place, s + weights))
                    weights += 1
        n = len(self.definition.states)
        if self._side_by_side:  # whole blocks; what is left over stays zero
            directions += [None] * (-len(directions) % lanes_for(len(directions)))
        object.__setattr__(self, "columns", Columns(n, tuple(directions), weights))

    @property
    def count(self) -> int:
        """The number of columns that are wanted; there may be more."""
        return sum(parameter.count for parameter in self.parameters)

    @property
    def _side_by_side(self) -> bool:
        """Whether the back end takes several columns at a time."""
        return isinstance(self.model.backend, LLVMBackend)

    # -- compiled ---------------------------------------------------------------------------------

    def kernel(self, *blocks: str) -> Kernel:
        """Return the Kernel of the derivatives of blocks by the parameters.

        By default it is that of the derivatives of the states and of their sensitivities by time.
        """
        columns, assembly = self.columns, self.model.assembly

        def make() -> Program:
            if not blocks:
                graph, rates = assembly.simplified("rates")
                return columns.rates_program(graph, rates, assembly.sizes, assembly.passes)
            graph = assembly.graph.copy()
            nodes = [(name, getattr(assembly, name)) for name in blocks]
            return columns.program(graph, nodes, assembly.sizes, assembly.passes)

        def stored() -> Program:
            what = f"sensitivities of {', '.join(blocks)} {columns}"
            return stored_program(assembly, what, make)

        if not blocks and self._side_by_side:
            return self.model.kernel_by(("sensitivities", columns), self._compiled_apart)
        return self.model.compiled_by(("sensitivities", blocks, columns), stored)

    def _compiled_apart(self) -> Kernel:
        columns, assembly = self.columns, self.model.assembly

        @cache
        def made() -> tuple[Program, Program]:
            graph, rates = assembly.simplified("rates")
            return columns.split_programs(graph, rates, assembly.sizes, assembly.passes)

        what = f"of sensitivities {columns}"
        shared = stored_program(assembly, f"shared part {what}", lambda: made()[0])
        column = stored_program(assembly, f"one column {what}", lambda: made()[1])
        return compile_columns(SplitProgram(shared, column, columns.table()))

    def call(self) -> KernelCall:
        """Return the equations with sensitivities and their numbers, for native solvers."""
        model = self.model
        return KernelCall(
            self.kernel(),
            self.p,
            np.concatenate([self.plan.values, np.zeros(self.columns.weights)]),
            (*self.plan.sampled, *self._weights()),
            None,
            lambda: tuple(map(str, model.layout.states)),
            lambda: model.compiled_jacobian("rates", "x"),
        )

    def _weights(self) -> list[tuple[np.ndarray, SampledInput]]:
        """Return the derivatives of sampled inputs by their samples, with their places in r."""
        result, start = [], len(self.definition.specifieds)
        for parameter in self.parameters:
            if parameter.samples is not None:
                places = np.arange(start, start + parameter.count)
                result.append((places, by_samples(parameter)))
                start += parameter.count
        return result

    def function(self) -> Callable[..., np.ndarray]:
        """Return ``f(x, t, …)`` for solvers, of states with their sensitivities."""
        call, n = self.call(), self.columns.states
        kernel, model, p = call.kernel, self.model, call.p

        def f(x: Any, t: Any, *args: Any) -> np.ndarray:
            out = np.empty(self.columns.size)
            state = np.ascontiguousarray(x, dtype=float)
            r = call.inputs_at(state, float(t))
            status = kernel.call(state, float(t), r, p, out)
            if status > 0:
                raise model.singular(float(t), state[:n])
            if status < 0:
                out[:] = model.evaluate(kernel, np.array([float(t)]), state[None], r[None], p)[0]
            return out

        f.native = lambda args: call  # type: ignore[attr-defined]
        return f

    def compiled(self, scales: np.ndarray | None, events: Sequence[Event]) -> CompiledSensitivities:
        """Return what native solvers need to know beside the equations."""
        n, k = self.columns.states, self.columns.count
        return CompiledSensitivities(
            n,
            k,
            self.count,
            scales,
            lambda event: self._jump(events[event]),
            lambda: self.kernel("holonomic", "velocity"),
        )

    def _jump(self, event: Event) -> Kernel:
        """Return the Kernel of what an event does to sensitivities."""
        states = self.definition.states
        after = [event.reset.get(s, s) for s in states] if event.reset else []

        def make() -> Program:
            own = self.model.assembly.fork()
            crossing, *moved = own.read([event.expression, *after], f"the event `{event.name}`")
            return self.columns.jump_program(
                own.graph, crossing, moved, own.rates, own.sizes, own.passes
            )

        return self.model.compiled_by(("jump", event.expression, *after, self.columns), make)

    def rows(self, times: np.ndarray) -> np.ndarray:
        """Return r with its further inputs at some times, shape (m, s + w) or (1, s + w)."""
        call = self.call()
        return Inputs(call.r, call.sampled).rows(np.empty((len(times), 0)), times)

    def rates(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the derivatives of the sensitivities by time, shape (m, n, k)."""
        out = self._sweep(self.kernel(), times, states, values)
        return self.columns.apart(out)[1][..., : self.count]

    def outputs(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the sensitivities of the outputs, shape (m, o, k)."""
        out = self._sweep(self.kernel("outputs"), times, states, values)
        return out.reshape(len(times), -1, self.columns.count)[..., : self.count]

    def _sweep(
        self, kernel: Kernel, times: np.ndarray, states: np.ndarray, values: np.ndarray
    ) -> np.ndarray:
        whole = self.columns.together(states, values)
        return self.model.evaluate(kernel, times, whole, self.rows(times), self.p)

    # -- the start --------------------------------------------------------------------------------

    def start(self, x0: np.ndarray, t: float, dependent: Sequence[int]) -> np.ndarray:
        """Return the sensitivities of the initial state, shape (n, k).

        Parameters
        ----------
        x0 : ndarray, shape (n,)
        t : float
        dependent : sequence of int
            The places of the states that follow from the others by the constraints.

        Raises
        ------
        ValueError
            A parameter is a dependent initial condition, or the constraints cannot be solved for
            the dependent ones.
        """
        n, k = self.columns.states, self.columns.count
        values = np.zeros((n, k))
        column = 0
        for parameter in self.parameters:
            if parameter.kind == "states":
                if parameter.place in dependent:
                    names = describe([self.definition.states[d] for d in dependent])
                    raise ValueError(
                        f"`{self.argument}` has the initial condition of `{parameter.symbol}`, "
                        f"which follows from the others by the constraints, as do {names}. Name "
                        "independent ones, or make it independent: call "
                        "set_dependent_initial_conditions(dep_vars=…) with other variables."
                    )
                values[parameter.place, column] = 1.0
            column += parameter.count
        equations = self.definition.equations
        blocks = [b for b in ("holonomic", "velocity") if getattr(equations, b)]
        if blocks:
            self._complete(values, x0, t, list(dependent), blocks)
        return values

    def _complete(
        self, values: np.ndarray, x0: np.ndarray, t: float, dependent: list[int], blocks: list[str]
    ) -> None:
        """Let the dependent initial conditions follow the others."""
        n = self.columns.states
        instant = np.array([t])
        args = (instant, x0[None], self.plan.rows(x0[None], instant), self.p)
        rows = [
            self.model.evaluate(self.model.compiled_jacobian(block, "x"), *args) for block in blocks
        ]
        gradient = np.concatenate([row.reshape(-1, n) for row in rows])
        moved = np.concatenate(
            [
                self._sweep(self.kernel(b), instant, x0[None], values[None]).reshape(
                    -1, self.columns.count
                )
                for b in blocks
            ]
        )
        solved, *_ = np.linalg.lstsq(gradient[:, dependent], -moved, rcond=FREE)
        values[dependent] += solved
        size = (np.abs(gradient) @ np.abs(values) + np.abs(moved)).max(axis=0)
        if (np.abs(gradient[:, dependent] @ solved + moved) > UNSOLVED_COLUMNS * size).any():
            names = describe([self.definition.states[d] for d in dependent]) if dependent else ""
            which = f"for {names}" if names else "for any: none is named as dependent"
            raise ValueError(
                f"`{self.argument}` needs to know how the dependent initial conditions follow from "
                f"the others, but the constraints cannot be solved {which}. Call "
                "set_dependent_initial_conditions(dep_vars=…) with variables for which they can."
            )


class Wanted:
    """Sensitivities that a simulation is to find, and what it is integrated with for them.

    Parameters
    ----------
    parameters : symbol, name, or iterable of these
    controlled : bool
        Whether the step control of a native solver looks at the sensitivities too.

    Attributes
    ----------
    sensitive : Sensitive
        From the call of `problem` on.
    """

    sensitive: Sensitive

    def __init__(self, parameters: Any, controlled: bool) -> None:
        self._parameters = parameters
        self._controlled = controlled

    def problem(
        self,
        definition: Definition,
        integrated: CompiledModel,
        plan: SpecifiedsPlan,
        start: tuple[np.ndarray, float],
        p: np.ndarray,
        dependent: Sequence[int],
        solver: Any,
        options: dict[str, Any],
    ) -> tuple[Callable[..., np.ndarray], np.ndarray, dict[str, Any]]:
        """Return the right-hand side, the initial values and the options of the solver.

        Parameters
        ----------
        definition : Definition
        integrated : CompiledModel
            Of the states alone.
        plan : SpecifiedsPlan
        start : (ndarray, float)
            The initial state and its time.
        p : ndarray
        dependent : sequence of int
            The places of the dependent initial conditions.
        solver : callable
        options : dict
            For the solver.
        """
        parameters = read_parameters(definition, plan, self._parameters)
        self.sensitive = sensitive = Sensitive(definition, integrated, plan, parameters, p)
        values = sensitive.start(*start, dependent)
        columns = sensitive.columns
        if isinstance(solver, Solver):
            # Samples in a line leave no mark in the motion: the states' error shows no kink there.
            spacing = mean_spacing(parameters)
            if spacing is not None and solver.adaptive:
                options = {"max_step": spacing, **options}
            controlled = self._controlled or spacing is not None
            scales = self._scales(parameters, start[0], p) if controlled else None
            events = options.get("events")
            compiled = sensitive.compiled(scales, () if events is None else events.sources)
            options = {**options, "sensitivities": compiled}
        else:
            for name in options.keys() & {"rtol", "atol"}:
                if np.size(options[name]) == columns.states > 1:  # others as of their states
                    every = np.repeat(np.asarray(options[name]), columns.count)
                    options = {**options, name: np.concatenate([options[name], every])}
        return sensitive.function(), columns.together(start[0], values), options

    def results(self, whole: np.ndarray) -> tuple[np.ndarray, dict[str, Any]]:
        """Return the states of a solver's result, and what a Trajectory takes beside them."""
        sensitive = self.sensitive
        states, values = sensitive.columns.apart(whole)
        states = np.ascontiguousarray(states)
        values = np.ascontiguousarray(values[..., : sensitive.count])
        counts = {parameter.symbol: parameter.count for parameter in sensitive.parameters}
        return states, {"sensitivities": (counts, values), "sensitivity_model": sensitive}

    def cut(self, error: Any) -> None:
        """Leave the sensitivities out of what an error holds."""
        n = self.sensitive.columns.states
        if getattr(error, "states", None) is not None:
            error.states = error.states[:, :n]
        error.state = error.state[:n]

    def _scales(self, parameters: Sequence[Parameter], x0: np.ndarray, p: np.ndarray) -> np.ndarray:
        """Return the parameters' sizes.

        An initial condition passes through zero, so that what it is at the start says little: its
        size is at least 1. Else a derivative by a speed of 1e-17 would have no error to speak of.
        """
        sizes = []
        for parameter in parameters:
            if parameter.samples is not None:
                own = np.abs(parameter.samples.values).max()
            elif parameter.kind == "specifieds":
                own = abs(self.sensitive.plan.values[parameter.place])
            elif parameter.kind == "constants":
                own = abs(p[parameter.place])
            else:
                own = max(abs(x0[parameter.place]), 1.0)
            sizes += [own if own > 0.0 else 1.0] * parameter.count
        return np.array(sizes + [1.0] * (self.sensitive.columns.count - len(sizes)))
