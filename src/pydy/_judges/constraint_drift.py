"""Check that motions start on the constraints, satisfy them, and conserve energy.

The error bounds are in `pydy.solvers.constraint_drift`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Literal

import numpy as np

from pydy import _forks
from pydy._assembly import (
    Assembly,
    CompiledModel,
    Definition,
    Layout,
    constraints_with_redundant,
    lower_nodes,
)
from pydy._errors import IntegrationError, warn_user
from pydy._graph import (
    Graph,
    directional,
    inputs_of,
    jacobian,
    per_unit,
    rounding_bounds,
    substitute,
)
from pydy._interpolation import evenly
from pydy._mechanics import Equations, find_symbols
from pydy._motion import ConstraintNames, Motion, SolveIvp, constraint_names, is_odeint
from pydy._problem import TOGETHER, EnergyModel, Problem, StateSamples
from pydy._program import Program
from pydy._rank import DIGITS, OF_FEW, ROUNDED, or_one, rank
from pydy.codegen import SpecifiedsPlan
from pydy.solvers import (
    ConstraintResiduals,
    DriftCheck,
    DriftReport,
    Options,
)
from pydy.trajectory import EventRecord

if TYPE_CHECKING:
    import sympy as sm

NO_INPUTS: Mapping[int, int | None] = {}

# -- At the start of a motion, and after resets ----------------------------------------------------


def check_start(at: StateSamples, whose: str = "", corrected: bool = False) -> bool:
    """Warn if the initial state violates the constraints; return whether it does.

    There is no warning if the motion is `corrected`, that is, projected onto the constraints.
    """
    satisfied = satisfied_to_rounding(at)[0]
    if not satisfied:
        _check_constant(at)
    # A corrected motion is not reported, so its violated rows need no names.
    find: Callable[..., object] = violates_constraints if corrected else violations
    violation = not satisfied and find(at, redundant=False)
    equations = at.definition.equations
    unimplied = () if violation else equations.constraints.unenforced_holonomic
    if unimplied and (report := DriftReport.contradiction(at.interpret(rates))):
        why = contradiction(equations, float(at.t[0]), **report.details)
        raise ValueError(f"No motion satisfies all constraints. {why}")
    if satisfied and not any(equations.constraints.redundant):
        return False
    if not violation:
        check_redundant(at)
        violation = find(at)
    if violation and not corrected:
        remedy = "Call `system.set_dependent_initial_conditions()` first."
        if whose:
            remedy = (
                "Dependent initial conditions are those of the System unless they are passed, also "
                "where constants or other initial conditions vary: pass those of each sample in "
                "`initial_conditions`."
            )
        warn_user(
            f"The initial conditions{whose} do not satisfy the constraints, and nothing will bring "
            f"the motion back onto them. {violation} {remedy}"
        )
    return bool(violation)


def _check_constant(at: StateSamples) -> None:
    """Raise if a constraint depends only on constants and is not zero: it cannot be satisfied."""
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
    """Warn of the first reset of each event that moves the state off the constraints."""
    warned: set[str] = set()
    for record in records:
        if record.name in warned or (record.after == record.before).all():
            continue
        time = np.array([record.time])
        if off := violations(at(time, record.after[None]), before=at(time, record.before[None])):
            warned.add(record.name)
            ConstraintResiduals.warn_of_reset(record.name, off)


def satisfied_to_rounding(at: StateSamples) -> np.ndarray:
    """Return a mask of the m states whose residuals are within rounding of their last sums."""
    residuals, sizes = evaluated_rows(at, "sizes")
    satisfied: np.ndarray = (np.abs(residuals) <= DIGITS * sizes).all(axis=1)  # NaN is not
    return satisfied


def first_violation(
    at: StateSamples, blocks: tuple[bool, bool] = (True, True)
) -> tuple[int, str] | None:
    """Return the index and the description of the first tested state with `violations`, or None."""
    tried = evenly(len(at.x), DriftCheck.MOST_STATES)
    for k in tried[~satisfied_to_rounding(at.subset(tried))]:
        if violation := violations(at.subset([k]), blocks=blocks):
            return int(k), violation
    return None


def violations(
    at: StateSamples,
    redundant: bool = True,
    before: StateSamples | None = None,
    blocks: tuple[bool, bool] = (True, True),
) -> str:
    """Describe the residuals that exceed the rounding error of six-digit arithmetic, or return ''.

    With `redundant`, the constraints that were left out as redundant are checked too. Residuals
    that were present `before` a reset count as drift that the reset has not caused. The two flags
    in `blocks` select the holonomic constraints and the velocity constraints.
    """
    if satisfied_to_rounding(at)[0]:
        return ""
    judged = _judged(at, redundant, before, blocks)
    return judged.describe(float(at.t[0]), ConstraintNames(at.definition.equations))


def violates_constraints(at: StateSamples, redundant: bool = True) -> bool:
    """Return whether a state has `violations`, without the cost of printing their names."""
    residuals, allowed = _judged(at, redundant)
    return not (np.abs(residuals) <= allowed).all()


def _judged(
    at: StateSamples,
    redundant: bool,
    before: StateSamples | None = None,
    blocks: tuple[bool, bool] = (True, True),
) -> ConstraintResiduals:
    """Return the residuals of a state and their limits; rows that do not count are zero."""
    residuals, bounds = (part[0] for part in evaluated_rows(at, "bounds"))
    inherited = None if before is None else evaluated_rows(before, "bounds")[0][0]
    equations, (q, v) = at.definition.equations, blocks
    counted = _rows_of(equations, q, q and redundant, v, v and redundant)
    judged = ConstraintResiduals(np.where(counted, residuals, 0.0), DIGITS * bounds)
    return judged.after_reset(inherited)


def _rows_of(equations: Equations, *selected: bool) -> np.ndarray:
    """Return a mask of the rows whose group is selected.

    The groups are: holonomic, redundant holonomic, velocity, redundant velocity.
    """
    constraints = equations.constraints
    closed, redundant = constraints.redundant
    parts = constraints.holonomic, closed, constraints.velocity, redundant
    return np.repeat(selected, [len(part) for part in parts])


@dataclass(frozen=True, eq=False)
class _StateInBatch(StateSamples):
    """One state of a batch. Its values are evaluated for the full batch and `cached`."""

    batch: StateSamples
    index: int
    cached: dict[Callable[[Assembly], dict[str, list[int]]], dict[str, np.ndarray]]

    def interpret(self, nodes: Callable[[Assembly], dict[str, list[int]]]) -> dict[str, np.ndarray]:
        """Return the values of nodes at this state, shape (1, o) for each name."""
        if nodes not in self.cached:
            self.cached[nodes] = self.batch.interpret(nodes)
        return {name: values[[self.index]] for name, values in self.cached[nodes].items()}


def _states_of(batch: StateSamples) -> list[_StateInBatch]:
    cached: dict[Callable[[Assembly], dict[str, list[int]]], dict[str, np.ndarray]] = {}
    single = (vars(batch.subset([k])) for k in range(len(batch.x)))
    return [
        _StateInBatch(**fields, batch=batch, index=k, cached=cached)
        for k, fields in enumerate(single)
    ]


def check_samples(
    at: Callable[[np.ndarray, np.ndarray], StateSamples],
    t: float,
    columns: tuple[Sequence[np.ndarray], Sequence[np.ndarray], Sequence[np.ndarray]],
    shape: tuple[int, ...],
    corrected: bool,
) -> bool:
    """Warn of the sample of an ensemble that violates the constraints most, and return whether any.

    Redundant constraints and contradicting rates are checked for 64 samples.
    """
    total = int(np.prod(shape))
    varied = np.array([np.size(a) > 1 for a in columns[1]], dtype=bool)

    def select(numbers: np.ndarray) -> StateSamples:
        m, parts = len(numbers), []
        for part in columns:
            values = [np.broadcast_to(a, shape).flat[numbers] for a in part]
            parts.append(np.ascontiguousarray(np.array(values).T.reshape(m, -1)))
        x, r, p = parts
        common = at(np.full(m, t), x)
        return replace(common, r=np.where(varied, r, common.r), p=p)

    def warned_of(numbers: np.ndarray) -> bool:
        if not len(numbers):
            return False
        numbers = numbers[evenly(len(numbers), DriftCheck.MOST_STATES)]
        for number, state in zip(numbers, _states_of(select(numbers)), strict=True):
            indices = np.unravel_index(number, shape)
            whose = f" of sample {', '.join(map(str, indices))}" if shape else ""
            if check_start(state, whose, corrected):
                return True
        return False

    for start in range(0, total, TOGETHER):
        numbers = np.arange(start, min(start + TOGETHER, total))
        states = select(numbers)
        residuals, sizes = evaluated_rows(states, "sizes")
        with np.errstate(invalid="ignore"):  # an overflow counts as a violation
            shares = np.nan_to_num((np.abs(residuals) / or_one(sizes)).max(axis=1), nan=np.inf)
        off = np.flatnonzero(shares > DIGITS)
        worst = np.argsort(-shares[off], kind="stable")[: DriftCheck.MOST_STATES]
        if warned_of(numbers[off[worst]]):
            return True
    equations = states.definition.equations
    if equations.constraints.unenforced_holonomic or any(equations.constraints.redundant):
        return warned_of(np.arange(total))
    return False


# -- Velocity constraints that do not imply the holonomic ones -------------------------------------


def contradiction(equations: Equations, t: float, unimplied: int, rate: float) -> str:
    """Describe a holonomic constraint, number `unimplied`, whose `rate` is not zero.

    The state satisfies the velocity constraints.
    """
    name = constraint_names(equations)[equations.constraints.unenforced_holonomic[unimplied]]
    return (
        f"At t = {t!r} the velocity constraints hold, but with these speeds the rate of the "
        f"{name}, is {rate:.3g}. Correct it, or the velocity constraints "
        "(`velocity_constraints`): all motions that they allow must keep the holonomic ones."
    )


def rates_along(
    assembly: Assembly, rows: Sequence[int], inputs: Mapping[int, int | None] = NO_INPUTS
) -> list[int]:
    """Return the time derivatives of rows of coordinates, time and inputs.

    `inputs` maps an input to the input that is its rate, or to None where the rate is zero.
    """
    graph = assembly.graph
    first = graph.args[assembly.speeds[0]][1]
    rates = assembly.blocks.rates[:first]
    derivatives = {graph.input("x", k): {0: rate} for k, rate in enumerate(rates)}
    derivatives[graph.input("t", 0)] = {0: graph.one}
    for k, rate in inputs.items():
        derivatives[graph.input("r", k)] = {} if rate is None else {0: graph.input("r", rate)}
    return directional(graph, known_rows(graph, rows, inputs), derivatives).flat()


def known_rows(graph: Graph, rows: Sequence[int], inputs: Mapping[int, int | None]) -> list[int]:
    """Replace rows by zero if they contain an input whose rate is not known."""
    contained = inputs_of(graph, rows).items()
    unknown = {n for n, (group, k) in contained if group == "r" and k not in inputs}
    return [n if unknown.isdisjoint(graph.reachable([n])) else graph.zero for n in rows]


def slopes_of(definition: Definition, plan: SpecifiedsPlan) -> Slopes:
    """Return the slopes for the inputs of a plan.

    Sampled inputs are excluded: an input and its rate are interpolated separately, so that one is
    not the derivative of the other.
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
    rows = rates_along(assembly, [assembly.blocks.holonomic[k] for k in unenforced])
    return {
        "rates": rows,
        "sizes": rounding_bounds(graph, rows, True),
        "slopes": jacobian(graph, rows, assembly.speeds).flat(),
        "left": assembly.blocks.velocity,
        "rows": jacobian(graph, assembly.blocks.velocity, assembly.speeds).flat(),
    }


# -- Constraints that were left out as redundant ---------------------------------------------------
# Redundancy was decided at random states. A linkage may be assembled in a configuration that was
# not among them, and a constraint may contradict others with the actual lengths.


def check_redundant(at: StateSamples) -> None:
    """Raise if redundant constraints are violated at a state, or are independent there."""
    equations, t = at.definition.equations, float(at.t[0])
    left_out = equations.constraints.redundant
    if not any(left_out):
        return
    n = len(equations.coordinates)
    rows = _rows_of(equations, False, True, False, False)
    closed, bounds = (part[0, rows] for part in evaluated_rows(at, "bounds"))
    if (violated := ~(np.abs(closed) <= DIGITS * bounds)).any():
        k = int(np.argmax(violated))
        raise ValueError(
            f"The holonomic constraint `{left_out[0][k]}` was left out as redundant, but with "
            f"these numbers it contradicts the others: at t = {t!r} it is {closed[k]:.3g} where "
            "the others hold. Correct it, or the constants and initial conditions."
        )
    slopes = at.interpret(_velocity_slopes)["slopes"].reshape(-1, at.x.shape[1])[:, n:]
    # The state is accurate to six digits; a singular matrix leaves half of them.
    needed = rank(slopes, least=DIGITS**0.5)
    if needed > len(equations.constraints.velocity):
        raise ValueError(
            f"At t = {t!r} the rank of the velocity constraints is {needed}, but at the generic "
            "states at which independent ones were selected it was "
            f"{len(equations.constraints.velocity)}. "
            "The linkage can be assembled in more than one way, and the rank differs between them. "
            "Give the configuration that is meant: "
            "`pydy.mechanics.Definition(..., configuration=system.initial_conditions)`."
        )


def warn_of_redundant(at: StateSamples, blocks: tuple[bool, bool]) -> None:
    """Warn of states that violate only constraints that were left out as redundant."""
    equations = at.definition.equations
    enforced = _rows_of(equations, True, False, True, False)
    left_out = _rows_of(equations, False, blocks[0], False, blocks[1])
    if not left_out.any() or satisfied_to_rounding(at).all():
        return
    residuals, sizes = evaluated_rows(at, "bounds")
    off = np.abs(residuals) > DIGITS * sizes
    states = np.flatnonzero(off[:, left_out].any(axis=1) & ~off[:, enforced].any(axis=1))
    if states.size:
        k, names = states[0], constraint_names(equations, redundant=True)
        row = int(np.argmax(off[k] & left_out))
        warn_user(
            f"A constraint that was left out as redundant does not hold at t = {float(at.t[k])!r} "
            f"although the others do: the residual is {residuals[k, row]:.3g} in the {names[row]}. "
            "The others lost rank on the way there, and the mechanism has come apart."
        )


def evaluated_rows(
    at: StateSamples, scale: Literal["sizes", "bounds"]
) -> tuple[np.ndarray, np.ndarray]:
    """Return the residuals of all constraints, (m, rows), and the scales of their rounding errors.

    The `scale` is 'sizes', the terms of the last sum, which are cheap to compute, or 'bounds' on
    rounding errors plus the residuals that a projection leaves (`ConstraintResiduals.rounding`).
    The rows are the holonomic constraints, the redundant ones last, then the velocity constraints.
    """
    values = at.interpret(sized if scale == "sizes" else bounded)
    sizes = values["sizes"]
    if scale == "bounds":
        sizes = sizes + ConstraintResiduals.rounding(values, sizes, at.x) / DIGITS
    return values["rows"], sizes


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
    _, velocity = constraints_with_redundant(assembly)
    return {"slopes": jacobian(assembly.graph, velocity, states).flat()}


def sized(assembly: Assembly, inherited: bool = False) -> dict[str, list[int]]:
    """Return 'rows' of `DriftQuantities`: all constraints, and the terms of their last sums."""
    holonomic, velocity = constraints_with_redundant(assembly)
    parts = (holonomic, len(assembly.blocks.holonomic)), (velocity, len(assembly.blocks.velocity))
    sizes = [
        n for rows, enforced in parts for n in _sizes(assembly.graph, rows, enforced, inherited)
    ]
    return {"rows": [*holonomic, *velocity], "sizes": sizes}


def bounded(assembly: Assembly) -> dict[str, list[int]]:
    """Return 'bounds' of `DriftQuantities`: the same with bounds on rounding errors."""
    blocks = sized(assembly, inherited=True)
    holonomic, _ = constraints_with_redundant(assembly)
    return {**blocks, **measured(assembly, blocks["rows"], len(holonomic))}


def start_program(assembly: Assembly) -> Program:
    """Return the Program with which exported code checks the state that a motion begins with.

    The residuals of all constraints, then the largest that numbers typed to six digits explain,
    then the largest that rounding of the states leaves: that is not finite where slopes are not.
    """
    own = assembly.fork()
    graph, n = own.graph, own.sizes[0]
    blocks = bounded(own)
    scales = []
    for k, slope in enumerate(blocks["per_unit"]):
        scale = graph.call("abs", graph.input("x", k))
        if slope != graph.zero:
            scale = graph.call("max", scale, graph.div(graph.one, slope))
        scales.append(scale)
    terms = [graph.mul(graph.call("abs", a), scales[k % n]) for k, a in enumerate(blocks["slopes"])]
    parts = {
        "rows": blocks["rows"],
        "typed": [graph.sum([(size, DIGITS)]) for size in blocks["sizes"]],
        "rounded": [
            graph.sum([(term, ROUNDED) for term in terms[k : k + n]])
            for k in range(0, len(terms), n)
        ],
    }
    return lower_nodes(own, parts)


def _sizes(graph: Graph, rows: list[int], enforced: int, inherited: bool) -> list[int]:
    """Return the scales of the rows' rounding errors.

    SymPy adds numbers up before this graph is built. A row that is a number is therefore a
    rounding error of sums that the other rows contain, or of direction cosines. So is a redundant
    row whose terms are no larger than the rounding errors of the enforced rows.
    """
    g = graph
    of_constants = [n for n in rows if g.constant[n]]
    sizes = dict(zip(rows, rounding_bounds(g, rows, inherited), strict=True))
    constant_bounds = rounding_bounds(g, of_constants, inherited, constants=True)
    sizes.update(zip(of_constants, constant_bounds, strict=True))
    numbers = [n for n in of_constants if g.ops[n] == "const" and n != g.zero]
    nonconstant = [(size, OF_FEW / DIGITS) for n, size in sizes.items() if n not in numbers]
    sizes.update(dict.fromkeys(numbers, g.sum(nonconstant, OF_FEW / DIGITS)))
    if enforced:
        least = sizes[rows[0]]
        for n in rows[1:enforced]:
            least = g.call("min", least, sizes[n])
        roundings = g.sum([(least, OF_FEW)])
        for n in {*rows[enforced:]} - {*numbers}:
            tiny = g.call("le", sizes[n], roundings)
            sizes[n] = g.call("select", tiny, g.sum([(least, OF_FEW / DIGITS)]), sizes[n])
    return [sizes[n] for n in rows]


# -- Along a motion --------------------------------------------------------------------------------


def part_of(
    problem: Problem, slopes: Slopes, name: str
) -> Callable[[Assembly], dict[str, list[int]]] | None:
    """Return the function that builds a part of `DriftQuantities` for an Assembly, or None."""
    constraints = problem.definition.equations.constraints
    if name == "contradictions" and not constraints.unenforced_holonomic:
        return None
    if name in PARTS:
        return PARTS[name]
    if name == "slopes":
        return slopes
    arguments = problem.model.energies, problem.code.layout
    return EnergyPart(*arguments) if name == "energy" else Moving(*arguments)


# -- One motion ------------------------------------------------------------------------------------


def _part(motion: Motion, name: str, t: np.ndarray, x: np.ndarray) -> dict[str, np.ndarray]:
    """Return values along a motion; see `DriftQuantities`."""
    problem = motion.problem
    part = part_of(problem, slopes_of(problem.definition, problem.plan), name)
    return {} if part is None else problem.at(t, x).interpret(part)


def _drift_check(motion: Motion, projected: bool) -> DriftCheck:
    """Return the check of a motion at selected states, with the solver's tolerances and steps."""
    selected = DriftCheck.selected(motion.states, projected)
    steps, statistics = None, motion.statistics
    if "step" not in motion.options and motion.integrator.errors_known:
        step_count = statistics.get("nst", statistics.get("steps"))
        steps = None if step_count is None else float(np.max(step_count))
    tolerances = [motion.options.get(name) for name in ("rtol", "atol")]
    defaults = Options.rtol, Options.atol
    rtol, atol = (d if g is None else g for g, d in zip(tolerances, defaults, strict=True))
    return DriftCheck(
        motion.times[selected],
        np.ascontiguousarray(motion.states[selected]),
        steps,
        rtol,
        atol,
        statistics["nearness"] if projected else None,
        motion.integrator.constraints_enforced,
        [(e.time, e.after) for e in motion.events if (e.after != e.before).any()],
        any(motion.problem.definition.equations.constraints.redundant),
    )


def _method(motion: Motion) -> str:
    """Return the name of the solver, for messages."""
    integrator = motion.integrator
    solver = integrator.solver
    if isinstance(solver, SolveIvp) and not integrator.errors_known:
        return solver.name
    default = "odeint" if is_odeint(solver) else "ode_solver"
    return str(motion.statistics.get("method", getattr(solver, "__name__", default)))


def check_drift(motion: Motion) -> None:
    """Raise if a motion left the constraints, or changed its energy without a cause."""
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
    method = _method(motion)
    error = IntegrationError(
        f"`{method}` {text}",
        motion.times,
        motion.states,
        t,
        check.states[report.state_index],
        {**statistics, "method": method, "code": int(report.outcome), "status": status},
    )
    error.motion = motion
    raise error


# -- The motions of an ensemble --------------------------------------------------------------------


def drift_programs(problem: Problem, model: CompiledModel, plan: SpecifiedsPlan) -> DriftPrograms:
    """Return the parts as Programs; those of the model's latest ensemble are reused."""
    slopes = slopes_of(problem.definition, plan)
    energies, stored_slopes, programs = model.latest.get("kept", (None, None, None))
    if energies is not problem.model.energies or stored_slopes != slopes:
        programs = DriftPrograms(problem, model, slopes)
        model.latest["kept"] = problem.model.energies, slopes, programs
    result: DriftPrograms = programs
    return result


class DriftPrograms:
    """The parts of `DriftQuantities` as Programs, which can be sent to other processes."""

    def __init__(self, problem: Problem, model: CompiledModel, slopes: Slopes) -> None:
        self._problem, self._model, self._slopes = problem, model, slopes
        self._programs: dict[str, Program | None] = {}
        self._lock = _forks.Lock()

    def __getitem__(self, name: str) -> Program | None:
        """Return a part as a Program to interpret. 'screen', rows and products, is compiled."""
        with self._lock:
            if name not in self._programs:
                self._programs[name] = self._program(name)
            return self._programs[name]

    def _program(self, name: str) -> Program | None:
        assembly = self._model.assembly.fork()
        if name == "screen":
            return lower_nodes(assembly, {**sized(assembly), **products(assembly)})
        part = part_of(self._problem, self._slopes, name)
        parts = part(assembly) if part else {}
        return lower_nodes(assembly, parts, as_is=True) if parts else None

    def __reduce__(
        self,
    ) -> tuple[type[dict[str, Program | None]], tuple[dict[str, Program | None]]]:
        names = "screen rows bounds products contradictions slopes moving energy"
        return dict, ({name: self[name] for name in names.split()},)


# -- The parts, as nodes of an Assembly ------------------------------------------------------------


def products(assembly: Assembly) -> dict[str, list[int]]:
    """Return the Gram matrix J Jᵀ of the velocity constraints' derivatives J by the speeds."""
    graph = assembly.graph
    rows = jacobian(graph, assembly.blocks.velocity, assembly.speeds)

    def product(a: dict[int, int], b: dict[int, int]) -> int:
        return graph.sum([(graph.mul(a[k], b[k]), 1.0) for k in a.keys() & b.keys()])

    pairs = ((rows[max(i, j)], rows[min(i, j)]) for i in range(len(rows)) for j in range(len(rows)))
    return {"products": [product(*pair) for pair in pairs]}


@dataclass(frozen=True)
class Slopes:
    """'slopes' of `DriftQuantities`.

    The `inputs` are the indices of specifieds with known rates, each with the index of its rate, or
    None if the rate is zero.
    """

    inputs: tuple[tuple[int, int | None], ...]

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        graph, inputs = assembly.graph, dict(self.inputs)
        holonomic, velocity = constraints_with_redundant(assembly)
        rows = known_rows(graph, [*holonomic, *velocity], inputs)
        rates = rates_along(assembly, rows[: len(holonomic)], inputs) + [graph.zero] * len(velocity)
        states = [graph.input("x", k) for k in range(assembly.sizes[0])]
        turns = jacobian(graph, rates, states).flat()
        return {
            "rows": rows, "rates": rates, "turns": turns, **measured(assembly, rows, len(holonomic))
        }  # fmt: skip


PARTS: dict[str, Callable[[Assembly], dict[str, list[int]]]] = {
    "rows": sized, "bounds": bounded, "products": products, "contradictions": rates
}  # fmt: skip


@dataclass(frozen=True)
class _OfEnergies:
    """A part that is computed from the energies; empty if these are not known."""

    energies: EnergyModel
    layout: Layout


class EnergyPart(_OfEnergies):
    """The energies, and the total energy's derivatives; empty if the total energy may change."""

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        energies: tuple[sm.Expr, ...] = ()
        with suppress(ValueError, NotImplementedError):
            energies = self.energies.expressions(self.layout) if self.energies.static else ()
        if not energies:
            return {}
        graph, speeds = assembly.graph, assembly.speeds
        kinetic, potential = assembly.read(energies, "the energy")
        holonomic, velocity = constraints_with_redundant(assembly)
        rate_rows = [*velocity, *assembly.blocks.rates[: graph.args[speeds[0]][1]]]
        driven = inputs_of(graph, [kinetic, potential, *holonomic, *rate_rows]).groups & {"t", "r"}
        momenta = jacobian(graph, [kinetic], speeds).flat()
        residual_nodes = substitute(
            graph, [kinetic, *momenta, *rate_rows], dict.fromkeys(speeds, graph.zero)
        )
        if driven or any(node != graph.zero for node in residual_nodes):
            return {}
        total = graph.add(kinetic, potential)
        states = [graph.input("x", k) for k in range(assembly.sizes[0])]
        slopes = jacobian(graph, [total], states).flat()
        return {"kinetic": [kinetic], "total": [total], "slopes": slopes}


class Moving(_OfEnergies):
    """The kinetic energy, its second derivatives by speeds, and the time derivatives of states."""

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
        return {"kinetic": nodes, "hessian": hessian, "rates": assembly.blocks.rates[:states]}
