"""The numbers of a System at one moment, with the model that they belong to."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from operator import attrgetter
from typing import Any, Protocol, Self

import numpy as np
import scipy

from pydy._assembly import Assembly, Assumptions, CompiledModel, Definition, errors_of
from pydy._checks import Places, describe, real_array, vector
from pydy._errors import warn_user
from pydy._forks import cached_property
from pydy._graph import jacobian, rounding_bounds
from pydy._kernel import Inputs, Kernel
from pydy._names import name_of
from pydy._problem.definition import check_times
from pydy._problem.model import Model
from pydy._rank import ROUNDED
from pydy.codegen import SpecifiedsPlan
from pydy.inputs import jumps_of
from pydy.solvers import CompiledConstraints
from pydy.trajectory import Columns, Trajectory

_DEFAULTS = {"constants": ("constants", 1.0), "initial_conditions": ("states", 0.0)}


def read_numbers(
    definition: Definition, argument: str, values: dict[Any, Any], told: set[str] | None
) -> np.ndarray:
    """Return 'constants' in order, 1.0 without a value, or 'initial_conditions', then 0.0.

    Values that contradict an assumption are reported once, unless what was `told` is None.
    """
    what, default = _DEFAULTS[argument]
    places = definition.places[what]
    try:
        numbers = places.read(argument, values, default)
    except ValueError as error:
        mechanism, time = definition.equations.mechanism, definition.equations.time
        unknown = [key for key in values if places.get(key, argument) is None]
        if time in unknown:
            raise ValueError(
                f"{error} `{time}` is the time, `dynamicsymbols._t`, wherever it occurs. Give the "
                "quantity another symbol."
            ) from None
        gone = [str(key) for key in unknown if mechanism and key in mechanism.symbols]
        if gone:
            raise ValueError(
                f"{error} The bodies or loads hold `{gone[0]}`, but it cancels: the motion does "
                "not depend on it. Leave it out; or name it in `constants_symbols`, if a reaction "
                "or energy needs it; or check the velocities and angular velocities given."
            ) from None
        name = name_of(unknown[0]) if unknown else ""
        if what == "constants" and name.isidentifier() and not places.meant(unknown[0]):
            raise ValueError(
                f"{error} Remove it if it belonged to an expression that you replaced. If it "
                f"occurs in events only, assign it in place, `system.constants[{name!r}] = ...`, "
                "right before the first call with them."
            ) from None
        raise
    if definition.assumptions and told is not None and what in definition.assumptions:
        assumed = definition.assumptions[what]
        check_given(assumed, places, argument, numbers[None], values, told)
    return numbers


def check_given(
    assumed: Assumptions,
    places: Places,
    argument: str,
    rows: np.ndarray,
    given: Iterable[Any],
    told: set[str],
) -> None:
    """Warn once of numbers (m, k) that the user gave and that contradict an assumption."""
    if (new := [c for c in assumed.contradictions(rows) if c.name not in told]) and (
        known := {places.get(key, argument) for key in given}
    ):
        new = [c for c in new if c.column in known]
        told.update(c.name for c in new)
        for first in new[:1]:
            first.warn(f"`{argument}` for ", "", new[1:])


@dataclass(frozen=True, eq=False)
class At:
    """A model at m states, with all that its equations take there."""

    definition: Definition
    model: CompiledModel  # with the expressions for specifieds compiled in
    t: np.ndarray  # (m,)
    x: np.ndarray  # (m, n)
    r: np.ndarray  # (m, s), or (1, s) for all states alike
    p: np.ndarray  # (k,), or (m, k)

    def some(self, places: Any) -> Self:
        """Return the same at some of the states, by their places."""
        r = self.r[places] if len(self.r) > 1 else self.r
        p = self.p[places] if self.p.ndim > 1 else self.p
        return replace(self, t=self.t[places], x=self.x[places], r=r, p=p)

    def with_unknowns(self, given: Any, rows: Callable[..., np.ndarray]) -> Self:
        """Return it with an Implicit's unknowns solved for, unless a whole state is `given`."""
        if self.definition.equations.constraints.residuals.implicit is None:
            return self
        if not (given is None or isinstance(given, Mapping)):
            return self
        x = np.array([solved_residuals(self.some([k])) for k in range(len(self.x))])
        return replace(self, x=x, r=rows(x, self.t))

    def evaluate(self, kernel: Kernel, x: np.ndarray | None = None) -> np.ndarray:
        """Return the flat outputs of a Kernel, shape (m, o); x may have more than the states."""
        return self.model.evaluate(kernel, self.t, self.x if x is None else x, self.r, self.p)

    def values(self, parts: Callable[[Assembly], dict[str, list[int]]]) -> dict[str, np.ndarray]:
        """Return the values of nodes, shape (m, o) for each name; few are worth compiling."""
        return self.model.interpreted(parts, (self.t, self.x, self.r, self.p))


@dataclass(frozen=True)
class _Residuals:
    """The equations of an `Implicit`: rows of the holonomic constraints, and their unknowns."""

    rows: tuple[int, ...]
    places: tuple[int, ...]

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        graph = assembly.graph
        rows = [assembly.holonomic[k] for k in self.rows]
        unknowns = [graph.input("x", k) for k in self.places]
        return {
            "residuals": rows,
            "slopes": jacobian(graph, rows, unknowns).flat(),
            "bounds": rounding_bounds(graph, rows),
        }


def solved_residuals(at: At) -> np.ndarray:
    """Solve an `Implicit` from a state and return the state with its unknowns."""
    x: np.ndarray = at.x[0].copy()
    for rows, places in at.definition.equations.constraints.residuals.blocks:
        x[[*places]] = _solved_block(replace(at, x=x[None]), _Residuals(rows, places))
    return x


def _solved_block(at: At, parts: _Residuals) -> np.ndarray:
    x: np.ndarray = at.x[0].copy()
    places, n = [*parts.places], len(parts.places)

    def values(z: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        x[places] = z
        found = replace(at, x=x[None]).values(parts)
        return found["residuals"][0], found["slopes"][0].reshape(n, n), found["bounds"][0]

    z: np.ndarray = x[places]
    left, slopes, bounds = values(z)
    if not CompiledConstraints.satisfied(left, bounds):
        z = scipy.optimize.root(lambda z: values(z)[0], z, jac=lambda z: values(z)[1]).x
        for _ in range(5):  # two do
            left, slopes, bounds = values(z)
            if CompiledConstraints.satisfied(left, bounds) or not np.isfinite(slopes).all():
                break
            z = z - np.linalg.lstsq(slopes, left)[0]
    if not CompiledConstraints.satisfied(left, bounds):
        k = int(np.argmax(np.where(np.isfinite(left), np.abs(left), np.inf)))
        equations = at.definition.equations
        residual = equations.constraints.holonomic[parts.rows[k]]
        unknowns = [equations.coordinates[k] for k in places]
        raise ValueError(
            f"`implicit` finds no {describe(unknowns)} at t = "
            f"{float(at.t[0])!r} with which the residuals are zero: `{residual}` "
            f"is left at {left[k]:.3g}. Give a `start`, or initial conditions, nearer to a "
            "solution, or check that there is one."
        )
    return z


class Hybrid(Protocol):
    """What makes a motion one of several modes, such as contacts."""

    @property
    def depends_on_time(self) -> bool:
        """Whether the modes depend on time explicitly."""

    def integrate(self, problem: Problem, times: np.ndarray, **options: Any) -> Any:
        """Return the Motion from a Problem's state on, in its modes if it has any."""

    def motions(
        self,
        problem: Problem,
        solver: Any,
        specifieds: Mapping[Any, Any],
        columns: Sequence[int],
        options: Mapping[str, Any],
    ) -> Any:
        """Return the motions of the samples of an ensemble; see `pydy.ensemble.model.Motions`.

        The `specifieds` are those of all samples, `columns` the places of those that vary.
        """


_REPLACED = frozenset(("t", "x", "p", "times", "contradicted", "modes"))


@dataclass(frozen=True, eq=False)
class Problem:
    """A model with its numbers at one state, which later changes of the System do not affect.

    It never changes itself: `replace` returns another one. What is expensive is read, checked or
    compiled when it is first needed.
    """

    definition: Definition  # the model's
    model: Model
    # 'constants', 'specifieds' and 'initial_conditions' as the user gave them, each checked when
    # it is first needed
    user: dict[str, dict[Any, Any]]
    times: np.ndarray  # the System's, which are the default of evaluations
    # Names of symbols whose values contradict their assumptions, as the user knows; None where
    # numbers are only tried.
    contradicted: set[str] | None = None
    # The states that initial conditions were solved for last; None for the method's own.
    solved_for: tuple[Any, ...] | None = None
    hybrid: Hybrid | None = None  # what makes a motion one of several modes
    modes: tuple[str, ...] | None = None  # of `hybrid`; None where they follow from the state

    def replace(self, **numbers: Any) -> Problem:
        """Return the same with another `t`, `x`, `p`, `times`, `contradicted` or `modes`.

        Nothing is compiled or checked again. States that follow from others stay as they are: see
        `consistent`.
        """
        if unknown := numbers.keys() - _REPLACED:
            raise TypeError(f"a Problem has no {', '.join(sorted(unknown))} to replace")
        other = object.__new__(Problem)
        other.__dict__.update(self.__dict__)
        other.__dict__.update(numbers)
        return other

    @cached_property
    def x(self) -> np.ndarray:
        """The initial conditions in order; where residuals give some of them, these are solved."""
        given = self.user["initial_conditions"]
        x = read_numbers(self.definition, "initial_conditions", given, self.contradicted)
        implicit = self.definition.equations.constraints.residuals.implicit
        places = self.definition.places["states"]
        if implicit is None:
            return x
        known = {places.find(key, "initial_conditions") for key in given}
        for symbol, value in implicit.start.items():
            if (k := places.symbols.index(symbol)) not in known:
                x[k] = value
        return solved_residuals(self.at(np.array([self.t]), x[None]))

    @cached_property
    def p(self) -> np.ndarray:
        """The constants in order."""
        given = self.user["constants"]
        return read_numbers(self.definition, "constants", given, self.contradicted)

    @property
    def constants(self) -> dict[Any, float]:
        """The constants' values by symbol."""
        return dict(zip(self.definition.constants, self.p.tolist(), strict=True))

    @cached_property
    def t(self) -> float:
        """The time of the state: at first that of the first of the System's times, or zero."""
        return float(self.times[0]) if len(self.times) else 0.0

    @cached_property
    def dependent(self) -> tuple[int, ...]:
        """The places of the states that follow from the others by the constraints."""
        equations, states = self.definition.equations, self.definition.states
        method = (*equations.dependents.coordinates, *equations.dependents.speeds)
        chosen = method if self.solved_for is None else self.solved_for
        return tuple(states.index(symbol) for symbol in chosen)

    @property
    def initial_conditions(self) -> dict[Any, float]:
        """The states' values by symbol."""
        return dict(zip(self.definition.states, self.x.tolist(), strict=True))

    @property
    def coordinate_count(self) -> int:
        """How many of the states are coordinates: the first ones."""
        return len(self.definition.equations.coordinates)

    @property
    def judges_assumptions(self) -> bool:
        """Whether motions are compared with assumptions of symbols, such as `positive=True`."""
        return self.definition.assumes_motions and self.contradicted is not None

    @property
    def depends_on_time(self) -> bool:
        """Whether the equations, inputs or modes depend on time explicitly."""
        if self.plan.inputs.functions or self.inputs.sampled:
            return True
        if self.hybrid is not None and self.hybrid.depends_on_time:
            return True
        assembly = self.code.assembly
        return "t" in assembly.graph.inputs_of(assembly.rates)

    @cached_property
    def plan(self) -> SpecifiedsPlan:
        """How r is computed: by the latest plan, where at most numbers differ from its own."""
        given, latest = self.user["specifieds"], self.model.code.latest
        already_warned = self.model.already_warned
        warned, known = latest.get("plan", (None, None))
        plan: SpecifiedsPlan | None = None
        if warned is already_warned:
            plan = known.again(given)
        if plan is None:
            plan = checked_plan(self.definition, given, already_warned, self.contradicted)
            _warn_of_activations(self.definition, plan, already_warned)
        elif plan is not known and self.definition.assumes_motions:
            check_specifieds(self.definition, plan, self.contradicted)
        latest["plan"] = already_warned, plan
        return plan

    @property
    def inputs(self) -> Inputs:
        """The specifieds that are numbers, samples and functions; expressions are in the `code`."""
        return self.plan.inputs

    @cached_property
    def code(self) -> CompiledModel:
        """The model's code with the expressions for specifieds compiled in."""
        plan, model = self.plan, self.model
        return model.with_compiled_inputs(plan) if plan.expressions else model.code

    def at(self, t: np.ndarray, x: np.ndarray) -> At:
        """Return the model with these numbers at m times and states."""
        x = np.ascontiguousarray(x)
        return At(self.definition, self.code, t, x, self.plan.inputs.rows(x, t), self.p)

    def value(self, kind: str, place: int) -> float:
        """Return the number of a state, constant or specified at the initial time."""
        if kind == "specifieds":
            return float(self.plan.inputs.rows(self.x[None], np.array([self.t]))[0][place])
        return float((self.x if kind == "states" else self.p)[place])

    def checked_times(self, times: np.ndarray) -> np.ndarray:
        """Return a copy of times, whose array may have been edited in place."""
        known = self.model.code.latest.get("times")
        if known is None or known.shape != times.shape or known.tobytes() != times.tobytes():
            self.model.code.latest["times"] = known = check_times(times)
        return known.copy()

    # -- values for one call ----------------------------------------------------------------------

    def x_with(self, x: Any, argument: str = "x") -> Any:
        """Return states; a dictionary gives some of the initial conditions instead."""
        if type(x) is np.ndarray:
            return x
        if isinstance(x, Mapping):
            return self.definition.places["states"].read(argument, x, self.x)
        self.definition.places["states"].check_order(x, argument)
        return x

    def p_with(self, p: Any) -> np.ndarray:
        """Return the constants, with a user's values for one call."""
        if p is None:
            return self.p
        places = self.definition.places["constants"]
        if isinstance(p, Mapping):
            numbers = places.read("p", p, self.p)
        else:
            places.check_order(p, "p")
            numbers = vector(p, len(places), "`p`")
        self.check_columns("constants", numbers[None], "`p` for ")
        return numbers

    def plan_with(self, r: Any) -> SpecifiedsPlan:
        """Return how r is computed, with a user's values for one call."""
        if r is None:
            return self.plan
        places = self.definition.places["specifieds"]
        if callable(r):
            return SpecifiedsPlan({places.symbols: r}, places, argument="r")
        own, already_warned = SpecifiedsPlan(r, places, argument="r"), self.model.already_warned
        check_specifieds(self.definition, own, self.contradicted, "r")
        body, plan = self.definition.equations.multibody, None
        if body and body.activations:  # what has no value may have one in this call
            given = self.user["specifieds"]
            plan = checked_plan(self.definition, given, already_warned, self.contradicted)
        plan = (plan or self.plan).updated(own)
        _warn_of_activations(self.definition, plan, already_warned)
        return _warned_of(self.definition, plan, already_warned)

    # -- assumptions on values --------------------------------------------------------------------

    def check_columns(self, what: str, values: np.ndarray, source: str, **options: Any) -> None:
        """Warn once of values (m, k) of all states, specifieds or constants, by assumptions."""
        if self.contradicted is not None and what in self.definition.assumptions:
            assumed = self.definition.assumptions[what]
            assumed.tell(values, self.contradicted, source, **options)

    def check_values(self, what: str, values: Mapping[Any, Any], source: str) -> None:
        """Warn once of numbers for some states, specifieds or constants, by assumptions."""
        if values and what in self.definition.assumptions:
            row = np.full((1, len(self.definition.places[what])), np.nan)
            for symbol, value in values.items():
                row[0, self.definition.places[what].find(symbol, what)] = value
            self.check_columns(what, row, source)

    def check_states(self, at: At, given: bool, r: Any) -> None:
        """Warn once of states that the user gave, and of specifieds that are computed there."""
        assumptions = self.definition.assumptions
        if given and "states" in assumptions:
            # Several may be those of a computed motion.
            allowed = errors_of(at.x, ROUNDED) if len(at.x) > 1 else 0.0
            self.check_columns("states", at.x, "`x` for ", allowed=allowed)
        if "specifieds" not in assumptions or self.contradicted is None:
            return
        columns = assumptions["specifieds"].columns
        if r is None or callable(r) or isinstance(r, Mapping):
            plan = self.plan_with(r)
            columns &= plan.changing
            columns -= {k for k, s in enumerate(plan.symbols) if s in plan.expressions}
        self.check_columns("specifieds", at.r, "The specified ", columns=columns)
        if r is None and self.plan.expressions:
            rows = self.specifieds(at.t, at.x)
            places = {k for k, s in enumerate(self.plan.symbols) if s in self.plan.expressions}
            self.check_columns("specifieds", rows, "The specified ", columns=places)

    def check_motion(
        self, times: np.ndarray, states: np.ndarray, rtol: Any = 1.0, atol: Any = 0.0
    ) -> None:
        """Warn once of states and specifieds along a motion that contradict their assumptions.

        A solver's tolerances say which contradictions may be errors; without error control only
        those that are large beside the other values are reported.
        """
        told, assumptions = self.contradicted, self.definition.assumptions
        if told is None or not len(times):
            return

        def where(row: int) -> str:
            return f" at t = {times[row]:g} of a motion"

        if (assumed := assumptions.get("states")) is not None:
            allowed = errors_of(states, rtol, atol)
            assumed.tell(states, told, "", where=where, allowed=allowed, in_time=True)
        if (assumed := assumptions.get("specifieds")) is None:
            return
        plan = self.plan  # whose numbers and samples were judged when they were given
        if columns := assumed.columns & plan.changing:
            finite = np.isfinite(states).all(axis=1)
            rows = np.full((len(times), len(plan.symbols)), np.nan)
            rows[finite] = self.specifieds(times[finite], states[finite])
            allowed = errors_of(rows, rtol)
            assumed.tell(
                rows, told, "", where=where, allowed=allowed, in_time=True, columns=columns
            )

    # -- along a trajectory -----------------------------------------------------------------------

    def specifieds(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the specifieds, shape (m, s)."""
        symbols = self.definition.specifieds
        if not self.plan.expressions:
            rows = self.plan.inputs.rows(np.ascontiguousarray(states), times)
            return np.array(np.broadcast_to(rows, (len(times), len(symbols))))
        kernel = self.code.compiled_expressions("the specifieds", (len(symbols),), symbols)
        return self.at(times, states).evaluate(kernel)

    def derivatives(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the derivatives of the states, shape (m, n)."""
        return self.at(times, states).evaluate(self.code.compiled("rates"))

    def rates(self) -> np.ndarray:
        """Return the derivatives of the states at its own state, shape (n,)."""
        found: np.ndarray = self.derivatives(np.array([self.t]), self.x[None])[0]
        return found

    def outputs(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the outputs, shape (m, o)."""
        if not self.definition.outputs_symbols:
            return np.empty((len(times), 0))
        return self.at(times, states).evaluate(self.code.compiled("outputs"))

    def energy(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return kinetic, potential and total energy, shape (m, 3)."""
        return self.at(times, states).evaluate(self.model.energies.kernel(self.code))

    def jumps(self) -> np.ndarray:
        """Return the times at which sampled inputs jump."""
        return jumps_of(self.plan.inputs.sampled)[:, 0]

    def trajectory(self, times: np.ndarray, states: np.ndarray, **more: Any) -> Trajectory:
        """Return states at some times with their names, outputs and specifieds."""
        if self.definition.assumes_motions:
            self.check_motion(times, states)
        columns = self.model.code.latest.get("columns")
        if columns is None:
            columns = self.model.code.latest["columns"] = Columns(self.definition.symbols_by_kind)
        return Trajectory(
            times,
            states,
            columns,
            outputs=self.outputs(times, states),
            specifieds=self.specifieds(times, states),
            constants=self.constants,
            model=self,
            **more,
        )

    def scene(self, *visuals: Any, **options: Any) -> Any:
        """Return a scene that shows the bodies, or some visuals; see `System.scene`."""
        from pydy._problem.scene import make_scene

        assembly = partial(attrgetter("model.code.assembly"), self)
        return make_scene(self.definition, self.constants, assembly, visuals, options)


def checked_plan(
    definition: Definition,
    specifieds: dict[Any, Any],
    told: set[Any],
    contradicted: set[str] | None,
) -> SpecifiedsPlan:
    """Return how a System's dictionary of specifieds, in either format, gives r."""
    places = definition.places["specifieds"]
    plan = SpecifiedsPlan(specifieds, places, argument="specifieds")
    check_specifieds(definition, plan, contradicted)
    return _warned_of(definition, plan, told)


def check_specifieds(
    definition: Definition,
    plan: SpecifiedsPlan,
    told: set[str] | None,
    argument: str = "specifieds",
) -> None:
    """Warn once of numbers and samples for specifieds that contradict an assumption.

    Samples are interpolated monotonically: nothing between them is beyond them.
    """
    assumed = definition.assumptions.get("specifieds")
    if assumed is None or told is None:
        return
    places, what = definition.places["specifieds"], f"`{argument}` for "
    numbers = plan.given - {plan.symbols[k] for k in plan.changing}
    check_given(assumed, places, argument, plan.inputs.values[None], numbers, told)
    for columns, samples in plan.inputs.sampled:
        rows = np.full((len(samples.times), len(plan.symbols)), np.nan)
        rows[:, columns] = samples.values.reshape(len(rows), -1)
        times = samples.times

        def where(row: int, times: np.ndarray = times) -> str:
            return f" at t = {times[row]:g}"

        assumed.tell(rows, told, what, where=where)


def _warned_of(definition: Definition, plan: SpecifiedsPlan, told: set[Any]) -> SpecifiedsPlan:
    """Warn once of derivatives that are zero for want of a value although their function moves.

    Numbers and expressions have derivatives that follow; samples and functions have not.
    """
    if plan.inputs.constant or not definition.lower_derivatives:
        return plan
    moving = {plan.symbols[k] for k in plan.inputs.changing}
    for rate, lower in definition.lower_derivatives.items():
        function = next((s for s in reversed(lower) if s in plan.given), None)
        if rate not in plan.given and function in moving and rate not in told:
            told.add(rate)
            warn_user(
                f"`specifieds` gives `{function}` as a function or as samples, but the "
                f"equations also hold `{rate}`, which stays zero: the motion contradicts "
                f"itself. Give `{function}` as a SymPy expression of time, from which its "
                f"derivatives follow, or give `{rate}` a function too."
            )
    return plan


def samples(
    x: Any,
    t: Any,
    default: Callable[[], np.ndarray],
    times: np.ndarray,
    n: int,
    argument: str = "x",
) -> tuple[np.ndarray, np.ndarray, bool]:
    """Return states (m, n), times (m,), and whether there is only one sample."""
    if x is None:
        states = default()
    else:
        states = real_array(x, f"`{argument}`")
        if states.ndim not in (1, 2) or states.shape[-1] != n:
            raise ValueError(
                f"`{argument}` must have the shape ({n},) or (m, {n}), one column for each state, "
                f"got {states.shape}."
            )
    single = states.ndim == 1
    if t is None:
        if single:
            instants = times[:1] if len(times) else np.zeros(1)
        else:
            instants = times if len(times) else np.zeros(len(states))
        source = "the System's `times`"
    else:
        instants = real_array(t, "`t`")
        source = "`t`"
        if single:
            if instants.ndim != 0:
                raise ValueError(
                    f"`t` must be a scalar for `{argument}` of the shape {states.shape}, got the "
                    f"shape {np.shape(t)}."
                )
            instants = instants.reshape(1)
        elif instants.ndim != 1:
            raise ValueError(
                f"`t` must have the shape ({len(states)},) for `{argument}` of the shape "
                f"{states.shape}, got the shape {np.shape(t)}."
            )
    if not single and len(instants) != len(states):
        raise ValueError(
            f"`{argument}` and `t` must have as many rows as times: `{argument}` has the shape "
            f"{states.shape}, {source} the shape {instants.shape}."
        )
    return (states[None] if single else states), np.ascontiguousarray(instants), single


def _warn_of_activations(definition: Definition, plan: SpecifiedsPlan, told: set[Any]) -> None:
    """Warn once of states of muscles that are specifieds without a value: activations."""
    body = definition.equations.multibody
    for state in () if body is None else body.activations:
        if state in definition.specifieds and state not in plan.given and state not in told:
            told.add(state)
            warn_user(
                f"`{state}` is a state of a musculotendon, but the equations do not hold its "
                "derivative, `rhs()`: it is a specified without a value, and stays zero. Add it to "
                "the coordinates and its derivative to the kinematic equations of a "
                f"pydy.mechanics.Definition, or give `{state}` in `specifieds`."
            )
