"""Warn of discontinuous rates and prescribed motions, which derivatives of a motion ignore."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from pydy._assembly import Assembly, Definition, Plan, differentiated
from pydy._errors import warn_user
from pydy._graph import Branches, jacobian, rounding_bounds, substitute
from pydy._interpolation import in_order
from pydy._judges.passages import Passed, Values, Watched, jump_message, passages
from pydy._kernel import KernelCall
from pydy._motion import Motion
from pydy._problem import Problem, StateSamples, evaluate_specifieds
from pydy._rank import HALF, ROUNDING, is_zero
from pydy.inputs import jumps_of, merged_jumps
from pydy.solvers import Options

_MISSED = 100.0  # tolerances: the errors of a whole motion are as many of those of a step


def _switched(
    assembly: Assembly,
    nodes: Sequence[int],
    searched: Sequence[int],
    inputs: str,
    others: str = "",
    bends: bool = False,
) -> tuple[list[int], dict[str, list[int]]]:
    """Return the switches in `searched` that depend on `inputs` (and `others`), as blocks too."""
    graph = assembly.graph
    found: list[int] = []
    steps: list[int] = []
    for switch in Branches(graph, searched).switches(whole=True):
        above, below = Branches(graph, nodes).sides(switch, bends)
        held = graph.inputs_of([switch])
        if above != below and held & {*inputs} and held <= {*inputs, *others}:
            found.append(switch)
            steps += map(graph.sub, above, below)
    return found, {"nodes": [*nodes] if found else [], "switches": found, "steps": steps}


def _loads_and_rates(assembly: Assembly, coordinates: int) -> tuple[list[int], list[int]]:
    """Return the rates, with loads for u' where these suffice, and the nodes to search."""
    graph, nodes = assembly.graph, [*assembly.rates]
    if len(assembly.forcing) != len(assembly.speeds):
        return nodes, nodes
    # Without the pivots by which constraints reduce the mass matrix, which switch, too.
    matrix = (assembly.velocity and assembly.kinetic_hessian) or assembly.mass_matrix
    if Branches(graph, matrix).switches(whole=True):
        return nodes, nodes
    own = slice(coordinates, coordinates + len(assembly.speeds))
    # What else holds u', as the rates of what residuals give for speeds, is searched with loads in
    # its place.
    pairs = zip(nodes[own], assembly.forcing, strict=True)
    loads = {u: load for u, load in pairs if graph.operands(u)}
    nodes[own] = assembly.forcing
    return nodes, substitute(graph, nodes, loads)


def _inputs(assembly: Assembly, groups: str) -> list[int]:
    sizes = dict(zip("xrp", assembly.sizes, strict=True))
    return [assembly.graph.input(group, k) for group in groups for k in range(sizes[group])]


@dataclass(frozen=True)
class Discontinuities:
    """The switches of rates and of the `integral`, their derivatives, and the steps there."""

    coordinates: int
    integral: Any = None

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        nodes, searched = _loads_and_rates(assembly, self.coordinates)
        if self.integral is not None:
            more = node_of(assembly, self.integral, "`integral`")
            nodes, searched = [*nodes, more], [*searched, more]
        found, blocks = _switched(assembly, nodes, searched, "xrp", "t")
        return {
            **blocks,
            "slopes": jacobian(assembly.graph, found, _inputs(assembly, "xrp")).flat(),
        }


@dataclass(frozen=True)
class DerivativeDiscontinuities:
    """The switches of rates with rounding bounds, and the rates' derivatives on both sides."""

    coordinates: int

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        graph, by = assembly.graph, _inputs(assembly, "xr")
        nodes, searched = _loads_and_rates(assembly, self.coordinates)
        found, blocks = _switched(assembly, nodes, searched, "xr", "tp", bends=True)
        both = [
            n
            for switch in found
            for side in Branches(graph, nodes).sides(switch, True)
            for n in side
        ]
        moves, slopes = (jacobian(graph, nodes, by).flat() for nodes in (found, both))
        bounds = rounding_bounds(graph, found)
        return {**blocks, "moves": moves, "slopes": slopes, "bounds": bounds}


def node_of(assembly: Assembly, term: Any, argument: str) -> int:
    """Return an output's node or an expression's, in a graph that may grow."""
    return assembly.outputs[term] if isinstance(term, int) else assembly.read([term], argument)[0]


@dataclass(frozen=True)
class ImpulsiveInputs:
    """The switches and steps of functions of time whose derivatives the equations contain."""

    definition: Definition = field(compare=False)
    plan: Plan = field(compare=False)

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        nodes = [*self.nodes(assembly)]
        return _switched(assembly, nodes, nodes, "t", "p")[1]

    def nodes(self, assembly: Assembly) -> dict[int, str]:
        """Return the nodes that are differentiated by time, with their names."""
        found: dict[int, str] = {}
        sources: set[Any] = set()
        for node, (source, _) in differentiated(assembly, self.definition, self.plan).items():
            of = "a derivative of " if source in sources else ""
            found[node] = f"{of}`specifieds[{source}]`"
            sources.add(source)
        for kind, rows in (("holonomic", assembly.holonomic), ("velocity", assembly.velocity)):
            for k, node in enumerate(rows):
                found.setdefault(node, f"the {kind} constraint {k}")
        return found


def _switches(at: StateSamples, parts: Any) -> bool:
    """Return whether anything switches at all; the model keeps that, which is asked at each run."""
    known = at.model.latest
    if parts not in known:
        known[parts] = bool(at.interpret(parts)["switches"].size)
    return bool(known[parts])


def watched(at: StateSamples, sensitive: Any = None, integral: Any = None) -> Watched | None:
    """Return the jumps of the rates to watch for, or None where nothing switches."""
    equations, states = at.definition.equations, at.definition.states
    parts = Discontinuities(len(equations.coordinates), integral)
    if not _switches(at, parts):
        return None
    names = [f"the {'load on' if s in equations.speeds else 'rate of'} {s}" for s in states]
    n, given = len(states), ()
    if sensitive is not None:
        first = {"specifieds": n, "constants": n + len(at.definition.specifieds)}
        known = [p for p in sensitive.parameters if p.kind in first]
        given = tuple(first[p.kind] + p.place for p in known)
    return Watched(parts, (*names, "what is integrated"), n, given)


def warn_of_jumps(
    problem: Problem, motion_of: Callable[[], Any], sensitive: Any = None, integral: Any = None
) -> None:
    """Warn where a motion passes a jump of the rates, which its derivatives do not contain."""
    found = watched(problem.at(np.array([problem.t]), problem.x[None]), sensitive, integral)
    if found is None:
        return
    motion, parts = in_order(motion_of()), found.nodes

    def columns(times: np.ndarray) -> np.ndarray | None:
        known = (motion if times is motion.times else motion.at(times))._sensitivity
        return None if known is None else known.values[:, : found.states]

    def evaluate(times: np.ndarray) -> Values:
        return problem.at(times, motion.at(times).states).interpret(parts)

    if told := jump_message(
        Passed.of(motion.times, motion._dense, motion.events, columns), found, evaluate
    ):
        warn_user(told)


def warn_of_kinks(
    at: StateSamples, T: np.ndarray, free: np.ndarray, columns: Sequence[int]
) -> None:
    """Warn of the first state at which the rates to be linearised have a kink or jump.

    That is along the tangents T, (m, n, k) of the `free` states, and the specifieds in `columns`.
    """
    definition, (m, n, _) = at.definition, T.shape
    equations, states = definition.equations, definition.states
    parts = DerivativeDiscontinuities(len(equations.coordinates))
    if not _switches(at, parts):
        return
    found, w = at.interpret(parts), len(definition.specifieds)
    near = np.abs(found["switches"]) <= ROUNDING * found["bounds"]
    count, width = near.shape[1], found["nodes"].shape[1]
    steps = np.abs(found["steps"].reshape(m, count, width))
    steps[steps <= HALF * np.abs(found["nodes"])[:, None]] = 0.0
    moves = found["moves"].reshape(m, count, 1, n + w)
    sides = found["slopes"].reshape(m, count, 2 * width, n + w)
    own, rows = np.concatenate([moves, sides], axis=2), np.broadcast_to(at.r, (m, w))
    for k, switch in np.argwhere(near):
        with np.errstate(all="ignore"):  # what is not finite is told of where it is used
            along = own[k, switch, :, :n] @ T[k]
            along = np.concatenate([along, own[k, switch, :, n:][:, [*columns]]], axis=1)
        above, below = along[1 : 1 + width], along[1 + width :]
        largest = np.maximum(np.abs(above), np.abs(below))
        turns = (np.abs(above - below) > HALF * largest) | (steps[k, switch] > 0.0)[:, None]
        for row, place in np.argwhere(turns & (along[0] != 0.0))[:1]:
            symbols = [*(states[j] for j in free), *(definition.specifieds[j] for j in columns)]
            value = [*at.x[k, free], *rows[k, [*columns]]][place]
            speed = row < len(states) and states[row] in equations.speeds
            what = f"jumps by {steps[k, switch, row]:.3g}"
            if not steps[k, switch, row]:
                what = f"has the slope {above[row, place]:.3g} on one side by it"
                what += f" and {below[row, place]:.3g} on the other"
            warn_user(
                f"There is no linear model for both sides of t = {at.t[k]:.6g}, "
                f"{symbols[place]} = {value:.6g}: the {'load on' if speed else 'rate of'} "
                f"{states[row]} {what}. What is returned takes one side. Linearize beside it, or "
                "give a smooth expression."
            )
            return


def warn_of_impulses(problem: Problem, times: np.ndarray) -> None:
    """Warn where a prescribed motion, or a constraint, jumps of which derivatives are taken."""
    parts = ImpulsiveInputs(problem.definition, problem.plan)
    if not _switches(problem.at(times[:1], problem.x[None]), parts):
        return
    assembly = problem.code.assembly.fork()
    names = parts.nodes(assembly)
    beyond = differentiated(assembly, problem.definition, problem.plan)

    def evaluate(times: np.ndarray) -> Values:
        return problem.at(times, np.tile(problem.x, (len(times), 1))).interpret(parts)

    # Functions of time alone are looked at so often.
    every = np.unique(np.append(times, np.linspace(times[0], times[-1], num=4096)))
    for k, beside, found, sizes in passages(evaluate, every):
        step = found["steps"][:, k].min(axis=0)
        for (node, what), one, size in zip(names.items(), step, sizes, strict=True):
            if one > HALF * size and (
                node not in beyond or _acts(problem, beyond[node][1], beside[0])
            ):
                warn_user(
                    f"At t = {beside[0]:.6g} {what} jumps by {one:.3g}. The equations hold its "
                    "derivative, in which that is an impulse, which the motion misses. Give a "
                    "smooth expression."
                )
                return


@dataclass(frozen=True)
class _Slopes:
    """The derivatives of the rates by specifieds."""

    places: tuple[int, ...]

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        by = [assembly.graph.input("r", k) for k in self.places]
        slopes = jacobian(assembly.graph, assembly.rates, by).flat()
        return {"slopes": slopes, "bounds": rounding_bounds(assembly.graph, slopes)}


def _acts(problem: Problem, places: Sequence[int], t: float) -> bool:
    """Return whether specifieds move the states, with these constants, at this or other states.

    The second derivative of a steering angle is in the equations with an inertia that may be zero.
    """
    x = np.array(
        [problem.x, *problem.x + np.random.default_rng(0).uniform(0.3, 1.3, (3, len(problem.x)))]
    )
    times = np.full(len(x), t)
    at = replace(
        problem.at(times, x), model=problem.model.code, r=evaluate_specifieds(problem, times, x)
    )
    found = at.interpret(_Slopes(tuple(places)))
    return not is_zero(found["slopes"], found["bounds"]).all()


def jumps_by_time(f: Any, args: Any, times: np.ndarray) -> np.ndarray | None:
    """Return rows of when inputs of a right-hand side jump, or it switches by time alone.

    None if it never does, whatever the times and numbers. The rows are as those of
    `pydy._program.switch_times.SwitchTimes`.
    """
    call: KernelCall | None = f.native(args)
    if call is None:
        return None
    start, end = sorted((float(times[0]), float(times[-1])))
    switched = call.switch_times(start, end)
    if switched is None and not call.sampled:
        return None
    sampled = jumps_of(call.sampled)
    return sampled if switched is None else merged_jumps([sampled, switched.rows])


def warn_of_pulses(motion: Motion) -> None:
    """Warn where a solver stepped from one jump by time to the next, and missed what moves states.

    Solvers that are not told of jumps find them by error control, which sees what they evaluate.
    """
    assert motion.evaluated is not None
    problem, asked = motion.problem, motion.evaluated.times
    times, states = motion.times, motion.states
    if times[-1] < times[0]:
        times, states = times[::-1], states[::-1]
    jumps, (start, end) = motion.evaluated.jumps, times[[0, -1]]
    jumps = jumps[(jumps[:, 0] > start) & (jumps[:, 0] < end)]
    moments, before, after = jumps.T
    until, evaluated = np.append(moments[1:], np.inf), np.append(np.sort(asked), np.inf)
    missed = np.flatnonzero(evaluated[np.searchsorted(evaluated, moments)] >= until)
    missed = missed[np.isfinite(until[missed])]
    if not missed.size or not np.isfinite(states).all():
        return
    first, last = moments[missed], until[missed]
    x = states[np.searchsorted(times, first)]
    step = problem.at(after[missed], x).rates() - problem.at(before[missed], x).rates()
    moved = np.abs(step) * (last - first)[:, None]
    options, n = motion.options, x.shape[1]
    given = options.get("rtol", Options.rtol), options.get("atol", Options.atol)
    rtol, atol = (np.atleast_1d(one)[:n] for one in given)
    excess = moved / (_MISSED * (atol + rtol * np.abs(x)) + np.finfo(float).tiny)
    k, state = np.unravel_index(excess.argmax(), excess.shape)
    if excess[k, state] > 1.0:
        by_samples = first[k] in jumps_of(problem.inputs.sampled)[:, 0]
        what = "the 'previous' samples" if by_samples else "the loads that time alone switches"
        warn_user(
            f"The solver evaluated nothing from t = {first[k]:.6g} to {last[k]:.6g}, so that it "
            f"does not know {what} there: they change "
            f"{problem.definition.states[state]} by {moved[k, state]:.3g}. Set "
            "`system.ode_solver = 'dop853'`, which ends a step at each jump, or limit the step: "
            "`hmax=` of odeint, `max_step=` of solve_ivp."
        )
