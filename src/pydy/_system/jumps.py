"""Where rates and prescribed motions jump: derivatives of a motion, and the motion, miss that."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pydy._assembly.assembly import Assembly
from pydy._assembly.definition import Definition
from pydy._assembly.specifieds import Plan, differentiated
from pydy._errors import warn_user
from pydy._graph.branches import sides, switches
from pydy._graph.derivative import dense_jacobian
from pydy._graph.rewrite import substitute
from pydy._rank import HALF, or_one
from pydy._system.snapshot import Snapshot

# Times between two that a jump is between, and how often they are taken: to 2⁻⁴⁸ of the way.
_FINER, _REFINED = 65, 8
_IN_STEP = 4  # places in a solver's step that are looked at, beside outputs
_PASSAGES = 16  # of a switch that are looked at closer, those with the largest steps
_IN_TIME = 4096  # times that functions of time alone are looked at

_BY_SWITCH = {"steps", "slopes"}  # blocks that have a row for each switch
_Values = dict[str, np.ndarray]


def _switched(
    assembly: Assembly, nodes: Sequence[int], searched: Sequence[int], inputs: str, others: str = ""
) -> tuple[list[int], dict[str, list[int]]]:
    """Return what the `searched` switch at by `inputs`, and `others`, and blocks of nodes."""
    graph = assembly.graph
    found: list[int] = []
    steps: list[int] = []
    for switch in switches(graph, searched, whole=True):
        above, below = sides(graph, nodes, switch)
        held = graph.inputs_of([switch])
        if above != below and held & {*inputs} and held <= {*inputs, *others}:
            found.append(switch)
            steps += map(graph.sub, above, below)
    return found, {"nodes": [*nodes] if found else [], "switches": found, "steps": steps}


@dataclass(frozen=True)
class Jumps:
    """What rates, and last the `integral`, switch at, its derivatives, and their steps."""

    coordinates: int
    integral: Any = None

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        graph, nodes = assembly.graph, [*assembly.rates]
        if self.integral is not None:
            nodes.append(node_of(assembly, self.integral, "`integral`"))
        searched = nodes
        if len(assembly.forcing) == len(assembly.speeds):
            # Without the pivots by which constraints reduce it, which switch, too.
            matrix = (assembly.velocity and assembly.kinetic_hessian) or assembly.mass_matrix
            if not switches(graph, matrix, whole=True):
                own = slice(self.coordinates, self.coordinates + len(assembly.speeds))
                # What else holds u', as the rates of what residuals give for speeds, is searched
                # with loads in its place.
                pairs = zip(nodes[own], assembly.forcing, strict=True)
                loads = {u: load for u, load in pairs if graph.operands(u)}
                nodes[own] = assembly.forcing
                searched = substitute(graph, nodes, loads)
        found, blocks = _switched(assembly, nodes, searched, "xrp", "t")
        groups = zip("xrp", assembly.sizes, strict=True)
        by = [graph.input(group, k) for group, size in groups for k in range(size)]
        return {**blocks, "slopes": dense_jacobian(graph, found, by)}


def node_of(assembly: Assembly, term: Any, argument: str) -> int:
    """Return an output's node or an expression's, in a graph that may grow."""
    return assembly.outputs[term] if isinstance(term, int) else assembly.read([term], argument)[0]


@dataclass(frozen=True)
class Impulses:
    """At which times what equations hold derivatives of switches, and its steps."""

    definition: Definition = field(compare=False)
    plan: Plan = field(compare=False)

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        nodes = [*self.nodes(assembly)]
        return _switched(assembly, nodes, nodes, "t", "p")[1]

    def nodes(self, assembly: Assembly) -> dict[int, str]:
        """Return what is differentiated, and what to call it."""
        found: dict[int, str] = {}
        sources: set[Any] = set()
        for node, source in differentiated(assembly, self.definition, self.plan).items():
            of = "a derivative of " if source in sources else ""
            found[node] = f"{of}`specifieds[{source}]`"
            sources.add(source)
        for kind, rows in (("holonomic", assembly.holonomic), ("velocity", assembly.velocity)):
            for k, node in enumerate(rows):
                found.setdefault(node, f"the {kind} constraint {k}")
        return found


def _passages(
    evaluate: Callable[[np.ndarray], _Values], times: np.ndarray, resets: Sequence[float] = ()
) -> Iterator[tuple[int, np.ndarray, _Values, np.ndarray]]:
    """Yield switches that a motion passes, two times beside, values there, and sizes."""
    along = evaluate(times)
    sizes = np.abs(along["nodes"]).max(axis=0, initial=0.0)
    before = np.searchsorted(resets, times, side="right")
    for k, value in enumerate(along["switches"].T):
        size = np.abs(value).max()
        places = np.flatnonzero(value)
        turns = np.flatnonzero(np.diff(np.sign(value[places])))
        pairs = np.stack([places[turns], places[turns + 1]], axis=1)
        pairs = pairs[before[pairs[:, 0]] == before[pairs[:, 1]]]
        largest = along["steps"][:, k][pairs].min(axis=1).max(axis=1, initial=0.0)
        for beside in times[pairs[np.argsort(-largest, kind="stable")[:_PASSAGES]]]:
            for _ in range(_REFINED):
                finer = np.linspace(beside[0], beside[1], num=_FINER)
                if not (np.diff(finer) > 0.0).all():
                    break
                value = evaluate(finer)["switches"][:, k]
                turn = int(np.argmax(np.sign(value) != np.sign(value[0])))
                beside = finer[turn - 1 : turn + 1]
            found = evaluate(beside)
            # What jumps through zero passes a switch of its own there.
            if (np.abs(found["switches"][:, k]) < HALF * size).any():
                yield k, beside, found, sizes


def _shaped(found: _Values) -> _Values:
    m, k = found["switches"].shape
    found["steps"] = np.abs(found["steps"])
    return found | {name: found[name].reshape(m, k, -1) for name in found.keys() & _BY_SWITCH}


def _looked_at(motion: Any) -> np.ndarray:
    """Return times of a motion, and places in the solver's steps."""
    times = motion.times
    ends = np.append(getattr(motion._dense, "starts", ()), times[-1])
    within = ends[:-1] + np.arange(_IN_STEP)[:, None] / _IN_STEP * np.diff(ends)
    every = np.unique(np.concatenate([times, within.ravel()]))
    found: np.ndarray = every[(every >= times[0]) & (every <= times[-1])]
    return found


def _switches(now: Snapshot, parts: Any) -> bool:
    """Return whether anything switches at all; the model keeps that, which is asked at each run."""
    known = now.driven.latest
    if parts not in known:
        found = now.at(np.array([now.t]), now.x[None]).values(parts)
        known[parts] = bool(found["switches"].size)
    return bool(known[parts])


def warn_of_jumps(
    now: Snapshot, motion_of: Callable[[], Any], sensitive: Any = None, integral: Any = None
) -> None:
    """Warn where a motion passes a jump of the rates, of which derivatives know nothing."""
    equations, states = now.definition.equations, now.definition.states
    n, r = len(states), len(now.definition.specifieds)
    parts = Jumps(len(equations.coordinates), integral)
    if not _switches(now, parts):
        return
    motion = motion_of()

    def evaluate(times: np.ndarray) -> _Values:
        return _shaped(now.at(times, motion.at(times).states).values(parts))

    resets = [e.time for e in motion.events if not np.array_equal(e.after, e.before)]
    for k, beside, found, sizes in _passages(evaluate, _looked_at(motion), resets):
        step, slopes = found["steps"][:, k].min(axis=0), found["slopes"][0, k]
        moved, explicit = slopes[:n], np.zeros(1)
        if sensitive is not None:
            first = {"specifieds": n, "constants": n + r}
            given = [first[p.kind] + p.place for p in sensitive.parameters if p.kind in first]
            explicit = slopes[given]
            if (known := motion.at(beside)._sensitivity) is not None:  # an adjoint has none
                large = np.abs(slopes[:n]) @ np.abs(motion._sensitivity.values).max(axis=0)
                moved = moved @ known.values[0]
                moved[np.abs(moved) <= HALF * large] = 0.0  # it passes there at any parameters
        if (step > HALF * sizes).any() and (moved.any() or explicit.any()):
            row = int(np.argmax(step / or_one(sizes)))
            what = "what is integrated"
            if row < n:
                speed = states[row] in equations.speeds
                what = f"the {'load on' if speed else 'rate of'} {states[row]}"
            warn_user(
                f"At t = {beside[0]:.6g} {what} jumps by {step[row]:.3g}, and the derivatives of "
                "the motion miss what this changes. Give a smooth one, such as with tanh(u/v) for "
                "sign(u), or an event with a reset there."
            )
            return


def warn_of_impulses(now: Snapshot, times: np.ndarray) -> None:
    """Warn where a prescribed motion, or a constraint, jumps of which derivatives are taken."""
    parts = Impulses(now.definition, now.plan)
    if not _switches(now, parts):
        return
    names = [*parts.nodes(now.driven.assembly.fork()).values()]

    def evaluate(times: np.ndarray) -> _Values:
        return _shaped(now.at(times, np.tile(now.x, (len(times), 1))).values(parts))

    every = np.unique(np.append(times, np.linspace(times[0], times[-1], num=_IN_TIME)))
    for k, beside, found, sizes in _passages(evaluate, every):
        step = found["steps"][:, k].min(axis=0)
        for what, one, size in zip(names, step, sizes, strict=True):
            if one > HALF * size:
                warn_user(
                    f"At t = {beside[0]:.6g} {what} jumps by {one:.3g}. The equations hold its "
                    "derivative, in which that is an impulse, which the motion misses. Give a "
                    "smooth expression."
                )
                return
