"""Check that motions start on the constraints, satisfy them, and conserve energy.

The error bounds are in `pydy.solvers.constraint_drift`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, Literal

import numpy as np

from pydy import _forks
from pydy._assembly import Assembly, CompiledModel, Definition, Layout
from pydy._errors import IntegrationError, warn_user
from pydy._graph import Graph, directional, jacobian, per_unit, rounding_bounds, substitute
from pydy._interpolation import evenly
from pydy._mechanics import Equations, find_symbols
from pydy._motion import ConstraintNames, Motion, constraint_names
from pydy._problem import TOGETHER, EnergyModel, Problem, StateSamples
from pydy._program import Program
from pydy._rank import DIGITS, OF_FEW, or_one, rank
from pydy.codegen import SpecifiedsPlan
from pydy.solvers import (
    ConstraintResiduals,
    DriftCheck,
    DriftReport,
    Options,
)
from pydy.trajectory import EventRecord

NO_INPUTS: Mapping[int, int | None] = {}

# -- where a motion begins, and after resets -------------------------------------------------------


def check_start(at: StateSamples, whose: str = "", mended: bool = False) -> bool:
    """Warn where a motion starts off the constraints; return whether it does."""
    held = satisfied_to_rounding(at)[0]
    if not held:
        _check_constant(at)
    # What is brought back onto the constraints is not reported: its rows need no names.
    look: Callable[..., Any] = violates_constraints if mended else violations
    told = not held and look(at, redundant=False)
    equations = at.definition.equations
    unimplied = () if told else equations.constraints.unenforced_holonomic
    if unimplied and (report := DriftReport.contradiction(at.interpret(rates))):
        why = contradiction(equations, float(at.t[0]), **report.details)
        raise ValueError(f"No motion satisfies all constraints. {why}")
    if held and not any(equations.constraints.redundant):
        return False
    if not told:
        check_redundant(at)
        told = look(at)
    if told and not mended:
        remedy = "Call `system.set_dependent_initial_conditions()` first."
        if whose:
            remedy = (
                "Dependent initial conditions are those of the System unless they are passed, also "
                "where constants or other initial conditions vary: pass those of each sample in "
                "`initial_conditions`."
            )
        warn_user(
            f"The initial conditions{whose} do not satisfy the constraints, and nothing will bring "
            f"the motion back onto them. {told} {remedy}"
        )
    return bool(told)


def _check_constant(at: StateSamples) -> None:
    """Refuse a constraint of constants alone that is not zero: no motion can satisfy it."""
    equations = at.definition.equations
    constraints = equations.constraints
    closed, redundant = constraints.redundant
    rows = [*constraints.holonomic, *closed, *constraints.velocity, *redundant]
    residuals, bounds = (part[0] for part in evaluated_rows(at, "bounds"))
    constants = set(at.definition.constants)
    for k in np.flatnonzero(np.abs(residuals) > DIGITS * bounds):
        if find_symbols([rows[k]]).keys() <= constants:
            name = constraint_names(equations, redundant=True)[k]
            raise ValueError(
                f"No motion satisfies the {name}, which depends on constants alone: it is "
                f"{residuals[k]:.3g}. Leave it out, or correct it."
            )


def check_resets(
    records: Iterable[EventRecord], at: Callable[[np.ndarray, np.ndarray], StateSamples]
) -> None:
    """Warn of the first reset of each event that leaves the constraints."""
    told: set[str] = set()
    for record in records:
        if record.name in told or (record.after == record.before).all():
            continue
        time = np.array([record.time])
        if off := violations(at(time, record.after[None]), before=at(time, record.before[None])):
            told.add(record.name)
            ConstraintResiduals.warn_of_reset(record.name, off)


def satisfied_to_rounding(at: StateSamples) -> np.ndarray:
    """Return which of m states have no `violations`, as far as the last operations tell."""
    residuals, sizes = evaluated_rows(at, "sizes")
    held: np.ndarray = (np.abs(residuals) <= DIGITS * sizes).all(axis=1)  # NaN is not
    return held


def first_violation(
    at: StateSamples, blocks: tuple[bool, bool] = (True, True)
) -> tuple[int, str] | None:
    """Return the first tried state that has `violations`, and these."""
    tried = evenly(len(at.x), DriftCheck.MOST_STATES)
    for k in tried[~satisfied_to_rounding(at.subset(tried))]:
        if told := violations(at.subset([k]), blocks=blocks):
            return int(k), told
    return None


def violations(
    at: StateSamples,
    redundant: bool = True,
    before: StateSamples | None = None,
    blocks: tuple[bool, bool] = (True, True),
) -> str:
    """Name the residuals of a state that is farther from the constraints than six digits are.

    A residual is compared with the bound on its rounding errors, if six digits were computed with.
    Constraints that were left out as `redundant` are judged too. What there was `before` a reset
    counts as drift that it has not made. The `blocks` say whether holonomic constraints are looked
    at, and velocity constraints. What is returned is a sentence, or nothing.
    """
    if satisfied_to_rounding(at)[0]:
        return ""
    judged = _judged(at, redundant, before, blocks)
    return judged.describe(float(at.t[0]), ConstraintNames(at.definition.equations))


def violates_constraints(at: StateSamples, redundant: bool = True) -> bool:
    """Return whether a state has `violations`, without naming them: printing takes long."""
    residuals, allowed = _judged(at, redundant)
    return not (np.abs(residuals) <= allowed).all()


def _judged(
    at: StateSamples,
    redundant: bool,
    before: StateSamples | None = None,
    blocks: tuple[bool, bool] = (True, True),
) -> ConstraintResiduals:
    """Return the residuals of a state, zero where rows do not count, and the allowed ones."""
    residuals, bounds = (part[0] for part in evaluated_rows(at, "bounds"))
    inherited = None if before is None else evaluated_rows(before, "bounds")[0][0]
    equations, (q, v) = at.definition.equations, blocks
    counted = _rows_of(equations, q, q and redundant, v, v and redundant)
    judged = ConstraintResiduals(np.where(counted, residuals, 0.0), DIGITS * bounds)
    return judged.after_reset(inherited)


def _rows_of(equations: Equations, *wanted: bool) -> np.ndarray:
    """Tell which rows are wanted: holonomic, of these left out, velocity, of these left out."""
    constraints = equations.constraints
    closed, redundant = constraints.redundant
    parts = constraints.holonomic, closed, constraints.velocity, redundant
    return np.repeat(wanted, [len(part) for part in parts])


@dataclass(frozen=True, eq=False)
class _Among(StateSamples):
    """One of some states: what is `known` of them is found for all together."""

    whole: StateSamples
    place: int
    known: dict[Callable[[Assembly], Any], dict[str, np.ndarray]]

    def values(self, parts: Callable[[Assembly], dict[str, list[int]]]) -> dict[str, np.ndarray]:
        """Return the values of nodes here, shape (1, o) for each name."""
        if parts not in self.known:
            self.known[parts] = self.whole.interpret(parts)
        return {name: values[[self.place]] for name, values in self.known[parts].items()}


def _each(whole: StateSamples) -> list[_Among]:
    known: dict[Any, dict[str, np.ndarray]] = {}
    some = (vars(whole.subset([k])) for k in range(len(whole.x)))
    return [_Among(**own, whole=whole, place=k, known=known) for k, own in enumerate(some)]


def check_samples(
    at: Callable[[np.ndarray, np.ndarray], StateSamples],
    t: float,
    columns: tuple[Sequence[np.ndarray], Sequence[np.ndarray], Sequence[np.ndarray]],
    shape: tuple[int, ...],
    mended: bool,
) -> None:
    """Warn of a sample of an ensemble that is off the constraints, of the worst.

    Constraints that were left out, and rates that contradict others, are looked at for 64.
    """
    total = int(np.prod(shape))
    varied = np.array([np.size(a) > 1 for a in columns[1]], dtype=bool)

    def some(numbers: np.ndarray) -> StateSamples:
        m, parts = len(numbers), []
        for part in columns:
            values = [np.broadcast_to(a, shape).flat[numbers] for a in part]
            parts.append(np.ascontiguousarray(np.array(values).T.reshape(m, -1)))
        x, r, p = parts
        common = at(np.full(m, t), x)
        return replace(common, r=np.where(varied, r, common.r), p=p)

    def told(numbers: np.ndarray) -> bool:
        if not len(numbers):
            return False
        numbers = numbers[evenly(len(numbers), DriftCheck.MOST_STATES)]
        for number, own in zip(numbers, _each(some(numbers)), strict=True):
            places = np.unravel_index(number, shape)
            whose = f" of sample {', '.join(map(str, places))}" if shape else ""
            if check_start(own, whose, mended):
                return True
        return False

    for start in range(0, total, TOGETHER):
        numbers = np.arange(start, min(start + TOGETHER, total))
        looked_at = some(numbers)
        residuals, sizes = evaluated_rows(looked_at, "sizes")
        with np.errstate(invalid="ignore"):  # what overflows is off
            shares = np.nan_to_num((np.abs(residuals) / or_one(sizes)).max(axis=1), nan=np.inf)
        off = np.flatnonzero(shares > DIGITS)
        worst = np.argsort(-shares[off], kind="stable")[: DriftCheck.MOST_STATES]
        if told(numbers[off[worst]]):
            return
    equations = looked_at.definition.equations
    if equations.constraints.unenforced_holonomic or any(equations.constraints.redundant):
        told(np.arange(total))


# -- Velocity constraints that do not keep the holonomic ones --------------------------------------


def contradiction(equations: Equations, t: float, unimplied: int, rate: float) -> str:
    """Say that velocity constraints hold, but do not keep one of the `unimplied` holonomic ones."""
    name = constraint_names(equations)[equations.constraints.unenforced_holonomic[unimplied]]
    return (
        f"At t = {t!r} the velocity constraints hold, but with these speeds the rate of the "
        f"{name}, is {rate:.3g}. Correct it, or the velocity constraints "
        "(`velocity_constraints`): all motions that they allow must keep the holonomic ones."
    )


def rates_along(
    assembly: Assembly, rows: Sequence[int], inputs: Mapping[int, int | None] = NO_INPUTS
) -> list[int]:
    """Return rates of rows of coordinates, time, and inputs whose rates are inputs, or zero."""
    graph = assembly.graph
    first = graph.args[assembly.speeds[0]][1]
    along = {graph.input("x", k): {0: rate} for k, rate in enumerate(assembly.rates[:first])}
    along[graph.input("t", 0)] = {0: graph.one}
    for k, rate in inputs.items():
        along[graph.input("r", k)] = {} if rate is None else {0: graph.input("r", rate)}
    return directional(graph, known_rows(graph, rows, inputs), along).flat()


def known_rows(graph: Graph, rows: Sequence[int], inputs: Mapping[int, int | None]) -> list[int]:
    """Replace rows that contain other inputs, whose rates are not known, by zeros."""
    held = {n: graph.args[n] for n in graph.inputs(rows)}
    others = {n for n, (group, k) in held.items() if group == "r" and k not in inputs}
    return [n if others.isdisjoint(graph.reachable([n])) else graph.zero for n in rows]


def slopes_of(definition: Definition, plan: SpecifiedsPlan) -> Slopes:
    """Return the slopes where inputs are as planned.

    Samples are interpolated each for itself: their rates are not those of their derivatives.
    """
    sampled, functions = (
        {k for part in parts for k in part[0].tolist()}
        for parts in (plan.inputs.sampled, plan.inputs.functions)
    )
    return Slopes(
        tuple(
            (k, rate)
            for k, rate in enumerate(definition.rates_of_specifieds)
            if not {k, rate} & sampled and (rate is not None or k not in functions)
        )
    )


def rates(assembly: Assembly) -> dict[str, list[int]]:
    """Return 'contradictions' of `DriftQuantities`."""
    graph, equations = assembly.graph, assembly.equations
    assert equations is not None
    unenforced = equations.constraints.unenforced_holonomic
    rows = rates_along(assembly, [assembly.holonomic[k] for k in unenforced])
    return {
        "rates": rows,
        "sizes": rounding_bounds(graph, rows, True),
        "slopes": jacobian(graph, rows, assembly.speeds).flat(),
        "left": assembly.velocity,
        "rows": jacobian(graph, assembly.velocity, assembly.speeds).flat(),
    }


# -- Constraints that were left out as redundant ---------------------------------------------------
# They were chosen at random states. A linkage may be assembled in other ways than in those, and a
# constraint may contradict others in a length that was random there.


def check_redundant(at: StateSamples) -> None:
    """Refuse a state where constraints left out do not hold, or not follow from others."""
    equations, t = at.definition.equations, float(at.t[0])
    left_out = equations.constraints.redundant
    if not any(left_out):
        return
    n = len(equations.coordinates)
    places = _rows_of(equations, False, True, False, False)
    closed, bounds = (part[0, places] for part in evaluated_rows(at, "bounds"))
    if (far := ~(np.abs(closed) <= DIGITS * bounds)).any():
        k = int(np.argmax(far))
        raise ValueError(
            f"The holonomic constraint `{left_out[0][k]}` was left out as redundant, but with "
            f"these numbers it contradicts the others: at t = {t!r} it is {closed[k]:.3g} where "
            "the others hold. Correct it, or the constants and initial conditions."
        )
    slopes = at.interpret(_velocity_slopes)["slopes"].reshape(-1, at.x.shape[1])[:, n:]
    # The state is known to six digits: what is singular there leaves half of them.
    needed = rank(slopes, least=DIGITS**0.5)
    if needed > len(equations.constraints.velocity):
        raise ValueError(
            f"At t = {t!r} there are {needed} independent velocity constraints, but only "
            f"{len(equations.constraints.velocity)} were kept: at the states that were tried, the "
            "others followed from them. "
            "The linkage can be assembled in another way, in which they do. Say which is meant: "
            "`pydy.mechanics.Definition(..., configuration=system.initial_conditions)`."
        )


def warn_of_left_out(at: StateSamples, blocks: tuple[bool, bool]) -> None:
    """Warn of states that violate only constraints that were left out as redundant."""
    equations = at.definition.equations
    kept = _rows_of(equations, True, False, True, False)
    left = _rows_of(equations, False, blocks[0], False, blocks[1])
    if not left.any() or satisfied_to_rounding(at).all():
        return
    residuals, sizes = evaluated_rows(at, "bounds")
    off = np.abs(residuals) > DIGITS * sizes
    states = np.flatnonzero(off[:, left].any(axis=1) & ~off[:, kept].any(axis=1))
    if states.size:
        k, names = states[0], constraint_names(equations, redundant=True)
        row = int(np.argmax(off[k] & left))
        warn_user(
            f"A constraint that was left out as redundant does not hold at t = {float(at.t[k])!r} "
            f"although the others do: the residual is {residuals[k, row]:.3g} in the {names[row]}. "
            "The others lost rank on the way there, and the mechanism has come apart."
        )


def evaluated_rows(
    at: StateSamples, what: Literal["sizes", "bounds"]
) -> tuple[np.ndarray, np.ndarray]:
    """Return the residuals of all constraints, (m, rows), and the scales of their rounding errors.

    These are 'sizes', the terms of the last sum, which are quickly computed, or 'bounds' on
    rounding errors with the residuals that a projection leaves; see `ConstraintResiduals.rounding`.
    Rows are the holonomic constraints, followed by those left out, then the velocity constraints.
    """
    found = at.interpret(sized if what == "sizes" else bounded)
    sizes = found["sizes"]
    if what == "bounds":
        sizes = sizes + ConstraintResiduals.rounding(found, sizes, at.x) / DIGITS
    return found["rows"], sizes


def measured(assembly: Assembly, rows: Sequence[int], count: int) -> dict[str, list[int]]:
    """Return ``slopes``, ``solved`` and ``per_unit`` of `DriftQuantities`.

    The first `count` rows are solved for all states, the others for the speeds.
    """
    graph, n = assembly.graph, assembly.sizes[0]
    states = [graph.input("x", k) for k in range(n)]
    moving, cells = {*assembly.speeds}, jacobian(graph, rows, states).flat()
    solved = [
        cell if k < count * n or states[k % n] in moving else graph.zero
        for k, cell in enumerate(cells)
    ]
    return {"slopes": cells, "solved": solved, "per_unit": per_unit(graph, rows, states)}


def _velocity_slopes(assembly: Assembly) -> dict[str, list[int]]:
    """Return the derivatives of all velocity constraints by the states."""
    states = [assembly.graph.input("x", k) for k in range(assembly.sizes[0])]
    return {"slopes": jacobian(assembly.graph, assembly.with_left_out()[1], states).flat()}


def sized(assembly: Assembly, inherited: bool = False) -> dict[str, list[int]]:
    """Return 'rows' of `DriftQuantities`: all constraints, and the terms of their last sums."""
    holonomic, velocity = assembly.with_left_out()
    parts = (holonomic, len(assembly.holonomic)), (velocity, len(assembly.velocity))
    sizes = [n for rows, kept in parts for n in _sizes(assembly.graph, rows, kept, inherited)]
    return {"rows": [*holonomic, *velocity], "sizes": sizes}


def bounded(assembly: Assembly) -> dict[str, list[int]]:
    """Return 'bounds' of `DriftQuantities`: the same with bounds on rounding errors."""
    found = sized(assembly, inherited=True)
    return {**found, **measured(assembly, found["rows"], len(assembly.with_left_out()[0]))}


def _sizes(graph: Graph, rows: list[int], kept: int, inherited: bool) -> list[int]:
    """Return the scales of the rows' rounding errors.

    SymPy adds up numbers beforehand. A row that is a number is what it left of those of the
    other rows, or of cosines between directions; so is one that was left out whose terms are
    no larger than roundings of the rows that were kept.
    """
    g = graph
    of_constants = [n for n in rows if g.constant[n]]
    sizes = dict(zip(rows, rounding_bounds(g, rows, inherited), strict=True))
    more = rounding_bounds(g, of_constants, inherited, constants=True)
    sizes.update(zip(of_constants, more, strict=True))
    numbers = [n for n in of_constants if g.ops[n] == "const" and n != g.zero]
    others = [(size, OF_FEW / DIGITS) for n, size in sizes.items() if n not in numbers]
    sizes.update(dict.fromkeys(numbers, g.sum(others, OF_FEW / DIGITS)))
    if kept:
        least = sizes[rows[0]]
        for n in rows[1:kept]:
            least = g.call("min", least, sizes[n])
        roundings = g.sum([(least, OF_FEW)])
        for n in {*rows[kept:]} - {*numbers}:
            tiny = g.call("le", sizes[n], roundings)
            sizes[n] = g.call("select", tiny, g.sum([(least, OF_FEW / DIGITS)]), sizes[n])
    return [sizes[n] for n in rows]


# -- along a motion --------------------------------------------------------------------------------


def part_of(
    problem: Problem, slopes: Slopes, name: str
) -> Callable[[Assembly], dict[str, list[int]]] | None:
    """Return the function that makes a part of `DriftQuantities` of an Assembly, or None."""
    constraints = problem.definition.equations.constraints
    if name == "contradictions" and not constraints.unenforced_holonomic:
        return None
    if name in PARTS:
        return PARTS[name]
    if name == "slopes":
        return slopes
    made = problem.model.energies, problem.code.layout
    return EnergyPart(*made) if name == "energy" else Moving(*made)


# -- one motion ------------------------------------------------------------------------------------


def _part(motion: Motion, name: str, t: np.ndarray, x: np.ndarray) -> dict[str, np.ndarray]:
    """Return values along a motion; see `DriftQuantities`."""
    problem = motion.problem
    made = part_of(problem, slopes_of(problem.definition, problem.plan), name)
    return {} if made is None else problem.at(t, x).interpret(made)


def _drift_check(motion: Motion, projected: bool) -> DriftCheck:
    """Return a few states of a motion, with the solver's errors and steps."""
    few = DriftCheck.selected(motion.states, projected)
    steps, statistics = None, motion.statistics
    if "step" not in motion.options and motion.errors_known:
        known = statistics.get("nst", statistics.get("steps"))
        steps = None if known is None else float(np.max(known))
    given = [motion.options.get(name) for name in ("rtol", "atol")]
    defaults = Options.rtol, Options.atol
    rtol, atol = (d if g is None else g for g, d in zip(given, defaults, strict=True))
    return DriftCheck(
        motion.times[few],
        np.ascontiguousarray(motion.states[few]),
        steps,
        rtol,
        atol,
        statistics["nearness"] if projected else None,
        motion.projected,
        [(e.time, e.after) for e in motion.events if (e.after != e.before).any()],
        any(motion.problem.definition.equations.constraints.redundant),
    )


def check_drift(motion: Motion) -> None:
    """Refuse a motion that left the constraints, or changed its energy without a cause."""
    equations, projected = motion.problem.definition.equations, "constraints" in motion.options
    statistics = motion.statistics
    sound = statistics["nearness"] >= DriftCheck.NEAR_SINGULAR if projected else False
    if sound and not equations.constraints.has_unprojected_rows:
        return
    check = _drift_check(motion, projected)
    report = check.report(partial(_part, motion))
    if report is None:
        return
    details, t = report.details, float(check.times[report.state_index])
    if "unimplied" in details:
        status = text = f"cannot keep all constraints. {contradiction(equations, t, **details)}"
    else:
        if "row" in details:
            names = constraint_names(equations, redundant=True)
            details = {**details, "row": names[details["row"]]}
        status = report.outcome.text.format(**details)
        text = f"{status} at t = {t!r}. {report.outcome.remedy}"
    error = IntegrationError(
        f"`{motion.method}` {text}",
        motion.times,
        motion.states,
        t,
        check.states[report.state_index],
        {**statistics, "method": motion.method, "code": int(report.outcome), "status": status},
    )
    error.motion = motion
    raise error


# -- the motions of an ensemble --------------------------------------------------------------------


def drift_programs(problem: Problem, model: CompiledModel, plan: SpecifiedsPlan) -> DriftPrograms:
    """Return the parts as Programs, kept from the latest ensemble of a model."""
    slopes = slopes_of(problem.definition, plan)
    energies, by, found = model.latest.get("kept", (None, None, None))
    if energies is not problem.model.energies or by != slopes:
        found = DriftPrograms(problem, model, slopes)
        model.latest["kept"] = problem.model.energies, slopes, found
    made: DriftPrograms = found
    return made


class DriftPrograms:
    """The parts of `DriftQuantities` as Programs, which can be sent to other processes."""

    def __init__(self, problem: Problem, model: CompiledModel, slopes: Slopes) -> None:
        self._now, self._model, self._slopes = problem, model, slopes
        self._made: dict[str, Program | None] = {}
        self._lock = _forks.Lock()

    def __getitem__(self, name: str) -> Program | None:
        """Return a part as a Program to interpret; 'screen' is rows and products, to compile."""
        with self._lock:
            if name not in self._made:
                self._made[name] = self._program(name)
            return self._made[name]

    def _program(self, name: str) -> Program | None:
        own = self._model.assembly.fork()
        if name == "screen":
            return own.lowered({**sized(own), **products(own)})
        made = part_of(self._now, self._slopes, name)
        parts = made(own) if made else {}
        return own.lowered(parts, as_is=True) if parts else None

    def __reduce__(self) -> tuple[Any, ...]:
        names = "screen rows bounds products contradictions slopes moving energy"
        return dict, ({name: self[name] for name in names.split()},)


# -- the parts, as nodes of an Assembly ------------------------------------------------------------


def products(assembly: Assembly) -> dict[str, list[int]]:
    """Return the velocity constraints' derivatives by the speeds, each row times each."""
    graph = assembly.graph
    rows = jacobian(graph, assembly.velocity, assembly.speeds)

    def product(a: dict[int, int], b: dict[int, int]) -> int:
        return graph.sum([(graph.mul(a[k], b[k]), 1.0) for k in a.keys() & b.keys()])

    pairs = ((rows[max(i, j)], rows[min(i, j)]) for i in range(len(rows)) for j in range(len(rows)))
    return {"products": [product(*pair) for pair in pairs]}


@dataclass(frozen=True)
class Slopes:
    """'slopes' of `DriftQuantities`.

    The `inputs` are the places of specifieds whose rates are known, with those of the rates, or
    None where they are zero.
    """

    inputs: tuple[tuple[int, int | None], ...]

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        graph, inputs = assembly.graph, dict(self.inputs)
        places, motion = assembly.with_left_out()
        rows = known_rows(graph, [*places, *motion], inputs)
        rates = rates_along(assembly, rows[: len(places)], inputs) + [graph.zero] * len(motion)
        states = [graph.input("x", k) for k in range(assembly.sizes[0])]
        turns = jacobian(graph, rates, states).flat()
        return {
            "rows": rows, "rates": rates, "turns": turns, **measured(assembly, rows, len(places))
        }  # fmt: skip


PARTS: dict[str, Callable[[Assembly], dict[str, list[int]]]] = {
    "rows": sized, "bounds": bounded, "products": products, "contradictions": rates
}  # fmt: skip


@dataclass(frozen=True)
class _OfEnergies:
    """A part that follows from the energies; there is nothing in it where these are not known."""

    energies: EnergyModel
    layout: Layout


class EnergyPart(_OfEnergies):
    """The energies, and the total energy's derivatives; nothing where it may change."""

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        known: tuple[Any, ...] = ()
        with suppress(ValueError, NotImplementedError):
            known = self.energies.expressions(self.layout) if self.energies.static else ()
        if not known:
            return {}
        graph, speeds = assembly.graph, assembly.speeds
        kinetic, potential = assembly.read(known, "the energy")
        places, motion = assembly.with_left_out()
        moves = [*motion, *assembly.rates[: graph.args[speeds[0]][1]]]
        driven = graph.inputs_of([kinetic, potential, *places, *moves]) & {"t", "r"}
        momenta = jacobian(graph, [kinetic], speeds).flat()
        rest = substitute(graph, [kinetic, *momenta, *moves], dict.fromkeys(speeds, graph.zero))
        if driven or any(node != graph.zero for node in rest):
            return {}
        total = graph.add(kinetic, potential)
        states = [graph.input("x", k) for k in range(assembly.sizes[0])]
        slopes = jacobian(graph, [total], states).flat()
        return {"kinetic": [kinetic], "total": [total], "slopes": slopes}


class Moving(_OfEnergies):
    """The kinetic energy, its second derivatives by speeds, and the states' own derivatives."""

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        graph, speeds = assembly.graph, assembly.speeds
        try:
            nodes = assembly.read((self.energies.moving(self.layout),), "the energy")
        except (ValueError, NotImplementedError):
            return {}
        rows = jacobian(graph, jacobian(graph, nodes, speeds).flat(), speeds).flat()
        first, n, states = graph.args[speeds[0]][1], len(speeds), assembly.sizes[0]
        hessian = [graph.zero] * states**2
        for k in range(n):
            start = (first + k) * states + first
            hessian[start : start + n] = rows[k * n : (k + 1) * n]
        return {"kinetic": nodes, "hessian": hessian, "rates": assembly.rates[:states]}
