"""Warn of discontinuous rates and prescribed motions, which derivatives of a motion ignore."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._assembly import Assembly, Definition, Plan, differentiated, kinetic_hessian
from pydy._errors import warn_user
from pydy._graph import Branches, inputs_of, jacobian, rounding_bounds, substitute
from pydy._interpolation import in_order
from pydy._judges.passages import MotionPath, Values, WatchedQuantities, jump_message, passages
from pydy._kernel import KernelCall
from pydy._motion import EvaluationRecorder, Motion
from pydy._problem import Problem, StateSamples, evaluate_specifieds
from pydy._rank import HALF, is_zero
from pydy.inputs import jumps_of, merged_jumps
from pydy.solvers import Options

if TYPE_CHECKING:
    import sympy as sm

    from pydy._sympy_types import AnySymbol
    from pydy.trajectory import Trajectory

_MISSED = 100.0  # in tolerances of a step: the error of a full motion may be this many


def has_any(at: StateSamples, parts: Any, block: str = "switches") -> bool:
    """Return whether a block has any numbers. The answer is cached in the model."""
    cache = at.model.latest
    if parts not in cache:
        cache[parts] = bool(at.interpret(parts)[block].size)
    return bool(cache[parts])


def switched_blocks(
    assembly: Assembly,
    nodes: Sequence[int],
    searched: Sequence[int],
    inputs: str,
    other_inputs: str = "",
    bends: bool = False,
) -> tuple[list[int], dict[str, list[int]]]:
    """Return the switches in `searched` that depend on `inputs`, also as named blocks.

    They may depend on `other_inputs` in addition. With `bends`, those count too at which the nodes
    only have kinks.
    """
    graph = assembly.graph
    switches: list[int] = []
    steps: list[int] = []
    for switch in Branches(graph, searched).switches(whole=True):
        above, below = Branches(graph, nodes).sides(switch, bends)
        inputs_of_switch = inputs_of(graph, [switch]).groups
        relevant = inputs_of_switch & {*inputs} and inputs_of_switch <= {*inputs, *other_inputs}
        if above != below and relevant:
            switches.append(switch)
            steps += map(graph.sub, above, below)
    return switches, {"nodes": [*nodes] if switches else [], "switches": switches, "steps": steps}


def loads_and_rates(assembly: Assembly, coordinates: int) -> tuple[list[int], list[int]]:
    """Return the rates, with loads for u' where these suffice, and the nodes to search."""
    graph, blocks = assembly.graph, assembly.blocks
    nodes = [*blocks.rates]
    if len(blocks.forcing) != len(assembly.speeds):
        return nodes, nodes
    # The pivots by which constraints reduce the mass matrix contain switches; exclude them.
    matrix = (blocks.velocity and kinetic_hessian(assembly)) or blocks.mass_matrix
    if Branches(graph, matrix).switches(whole=True):
        return nodes, nodes
    speed_rows = slice(coordinates, coordinates + len(assembly.speeds))
    # Other rates may contain u', such as those of implicit speeds: search them with u' replaced by
    # the loads.
    pairs = zip(nodes[speed_rows], blocks.forcing, strict=True)
    loads = {u: load for u, load in pairs if graph.operands(u)}
    nodes[speed_rows] = blocks.forcing
    return nodes, substitute(graph, nodes, loads)


def inputs_of_groups(assembly: Assembly, groups: str) -> list[int]:
    sizes = dict(zip("xrp", assembly.sizes, strict=True))
    return [assembly.graph.input(group, k) for group in groups for k in range(sizes[group])]


@dataclass(frozen=True)
class Discontinuities:
    """The switches of rates and of the `integral`, their derivatives, and the steps there."""

    coordinates: int
    integral: int | sm.Expr | None = None

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        nodes, searched = loads_and_rates(assembly, self.coordinates)
        if self.integral is not None:
            integrand = node_of(assembly, self.integral, "`integral`")
            nodes, searched = [*nodes, integrand], [*searched, integrand]
        switches, blocks = switched_blocks(assembly, nodes, searched, "xrp", "t")
        return {
            **blocks,
            "slopes": jacobian(assembly.graph, switches, inputs_of_groups(assembly, "xrp")).flat(),
        }


def node_of(assembly: Assembly, term: int | sm.Expr, argument: str) -> int:
    """Return the node of an output or an expression; new nodes may be added to the graph."""
    if isinstance(term, int):
        return assembly.blocks.outputs[term]
    return assembly.read([term], argument)[0]


@dataclass(frozen=True)
class ImpulsiveInputs:
    """The switches and steps of functions of time whose derivatives the equations contain."""

    definition: Definition = field(compare=False)
    plan: Plan = field(compare=False)

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        nodes = [*self.nodes(assembly)]
        return switched_blocks(assembly, nodes, nodes, "t", "p")[1]

    def nodes(self, assembly: Assembly) -> dict[int, str]:
        """Return the nodes that are differentiated by time, with their names."""
        names: dict[int, str] = {}
        sources: set[AnySymbol] = set()
        for node, (source, _) in differentiated(assembly, self.definition, self.plan).items():
            prefix = "a derivative of " if source in sources else ""
            names[node] = f"{prefix}`specifieds[{source}]`"
            sources.add(source)
        blocks = assembly.blocks
        for kind, rows in (("holonomic", blocks.holonomic), ("velocity", blocks.velocity)):
            for k, node in enumerate(rows):
                names.setdefault(node, f"the {kind} constraint {k}")
        return names


def watched(
    at: StateSamples, augmented: Any = None, integral: int | sm.Expr | None = None
) -> WatchedQuantities | None:
    """Return the quantities whose jumps must be detected, or None if nothing switches."""
    equations, states = at.definition.equations, at.definition.states
    parts = Discontinuities(len(equations.coordinates), integral)
    if not has_any(at, parts):
        return None
    names = [f"the {'load on' if s in equations.speeds else 'rate of'} {s}" for s in states]
    n, parameter_columns = len(states), ()
    if augmented is not None:
        first = {"specifieds": n, "constants": n + len(at.definition.specifieds)}
        parameters = [p for p in augmented.parameters if p.kind in first]
        parameter_columns = tuple(first[p.kind] + p.index for p in parameters)
    return WatchedQuantities(parts, (*names, "what is integrated"), n, parameter_columns)


def warn_of_jumps(
    problem: Problem,
    motion_of: Callable[[], Trajectory],
    augmented: Any = None,
    integral: int | sm.Expr | None = None,
) -> None:
    """Warn if a motion passes a jump of the rates, which its derivatives ignore."""
    quantities = watched(problem.at(np.array([problem.t]), problem.x[None]), augmented, integral)
    if quantities is None:
        return
    motion, parts = in_order(motion_of()), quantities.nodes

    def columns(times: np.ndarray) -> np.ndarray | None:
        sensitivity = (motion if times is motion.times else motion.at(times))._sensitivity
        return None if sensitivity is None else sensitivity.values[:, : quantities.states]

    def evaluate(times: np.ndarray) -> Values:
        return problem.at(times, motion.at(times).states).interpret(parts)

    if message := jump_message(
        MotionPath.from_solution(motion.times, motion._dense, motion.events, columns),
        quantities,
        evaluate,
    ):
        warn_user(message)


def warn_of_impulses(problem: Problem, times: np.ndarray) -> None:
    """Warn if a prescribed motion or a constraint jumps although the equations differentiate it."""
    parts = ImpulsiveInputs(problem.definition, problem.plan)
    if not has_any(problem.at(times[:1], problem.x[None]), parts):
        return
    assembly = problem.code.assembly.fork()
    names = parts.nodes(assembly)
    differentiated_nodes = differentiated(assembly, problem.definition, problem.plan)

    def evaluate(times: np.ndarray) -> Values:
        return problem.at(times, np.tile(problem.x, (len(times), 1))).interpret(parts)

    # Functions of time alone are sampled at this many times.
    every = np.unique(np.append(times, np.linspace(times[0], times[-1], num=4096)))
    for k, bracket, values, sizes in passages(evaluate, every):
        step = values["steps"][:, k].min(axis=0)
        for (node, name), jump, size in zip(names.items(), step, sizes, strict=True):
            if jump > HALF * size and (
                node not in differentiated_nodes
                or _acts(problem, differentiated_nodes[node][1], bracket[0])
            ):
                warn_user(
                    f"At t = {bracket[0]:.6g} {name} jumps by {jump:.3g}. The equations hold its "
                    "derivative, in which that is an impulse, which the motion misses. Give a "
                    "smooth expression."
                )
                return


@dataclass(frozen=True)
class _InputSlopes:
    """The derivatives of the rates by specifieds."""

    columns: tuple[int, ...]

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        inputs = [assembly.graph.input("r", k) for k in self.columns]
        slopes = jacobian(assembly.graph, assembly.blocks.rates, inputs).flat()
        return {"slopes": slopes, "bounds": rounding_bounds(assembly.graph, slopes)}


def _acts(problem: Problem, columns: Sequence[int], t: float) -> bool:
    """Return whether specifieds affect the rates, at this state or at three others.

    Example: the second derivative of a steering angle is multiplied by an inertia that may be zero.
    """
    x = np.array(
        [problem.x, *problem.x + np.random.default_rng(0).uniform(0.3, 1.3, (3, len(problem.x)))]
    )
    times = np.full(len(x), t)
    at = replace(
        problem.at(times, x), model=problem.model.code, r=evaluate_specifieds(problem, times, x)
    )
    values = at.interpret(_InputSlopes(tuple(columns)))
    return not is_zero(values["slopes"], values["bounds"]).all()


def jumps_by_time(f: Any, args: tuple[object, ...], times: np.ndarray) -> np.ndarray | None:
    """Return the times at which a right-hand side is discontinuous, or None if it never is.

    These are the jumps of its inputs and its switches that depend on time alone. For the rows see
    `pydy._program.switch_times.SwitchTimes`.
    """
    call: KernelCall | None = f.native(args)
    if call is None:
        return None
    start, end = sorted((float(times[0]), float(times[-1])))
    switched = call.switch_times(start, end)
    if switched is None and not call.inputs.sampled:
        return None
    sampled = jumps_of(call.inputs.sampled)
    return sampled if switched is None else merged_jumps([sampled, switched.rows])


def warn_of_pulses(motion: Motion, recorded: EvaluationRecorder) -> None:
    """Warn if a solver stepped from one jump in time over the next and missed a change of rates.

    Solvers without a list of jumps detect them by error control, only where they evaluate.
    """
    problem, evaluation_times = motion.problem, recorded.times
    times, states = motion.times, motion.states
    if times[-1] < times[0]:
        times, states = times[::-1], states[::-1]
    jumps, (start, end) = recorded.jumps, times[[0, -1]]
    jumps = jumps[(jumps[:, 0] > start) & (jumps[:, 0] < end)]
    moments, before, after = jumps.T
    until, evaluated = np.append(moments[1:], np.inf), np.append(np.sort(evaluation_times), np.inf)
    missed = np.flatnonzero(evaluated[np.searchsorted(evaluated, moments)] >= until)
    missed = missed[np.isfinite(until[missed])]
    if not missed.size or not np.isfinite(states).all():
        return
    first, last = moments[missed], until[missed]
    x = states[np.searchsorted(times, first)]
    step = problem.at(after[missed], x).rates() - problem.at(before[missed], x).rates()
    moved = np.abs(step) * (last - first)[:, None]
    options, n = motion.options, x.shape[1]
    tolerances = options.get("rtol", Options.rtol), options.get("atol", Options.atol)
    rtol, atol = (np.atleast_1d(tolerance)[:n] for tolerance in tolerances)
    excess = moved / (_MISSED * (atol + rtol * np.abs(x)) + np.finfo(float).tiny)
    k, state = np.unravel_index(excess.argmax(), excess.shape)
    if excess[k, state] > 1.0:
        by_samples = first[k] in jumps_of(problem.inputs.sampled)[:, 0]
        cause = "the 'previous' samples" if by_samples else "the loads that time alone switches"
        warn_user(
            f"The solver evaluated nothing from t = {first[k]:.6g} to {last[k]:.6g}, so that it "
            f"does not know {cause} there: they change "
            f"{problem.definition.states[state]} by {moved[k, state]:.3g}. Set "
            "`system.ode_solver = 'dop853'`, which ends a step at each jump, or limit the step: "
            "`hmax=` of odeint, `max_step=` of solve_ivp."
        )
