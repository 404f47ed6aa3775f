"""Where rates and prescribed motions jump: derivatives of a motion, and the motion, miss that."""

from __future__ import annotations

from collections.abc import Callable, Sequence
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
from pydy._rank import HALF
from pydy._system.snapshot import At, Snapshot
from pydy.analysis.jumps import Passed, Values, Watched, passages, told_of_jump

_IN_TIME = 4096  # times that functions of time alone are looked at


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


def _switches(at: At, parts: Any) -> bool:
    """Return whether anything switches at all; the model keeps that, which is asked at each run."""
    known = at.model.latest
    if parts not in known:
        known[parts] = bool(at.values(parts)["switches"].size)
    return bool(known[parts])


def watched(at: At, sensitive: Any = None, integral: Any = None) -> Watched | None:
    """Return what tells of jumps of the rates, or None where nothing switches."""
    equations, states = at.definition.equations, at.definition.states
    parts = Jumps(len(equations.coordinates), integral)
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
    now: Snapshot, motion_of: Callable[[], Any], sensitive: Any = None, integral: Any = None
) -> None:
    """Warn where a motion passes a jump of the rates, of which derivatives know nothing."""
    found = watched(now.at(np.array([now.t]), now.x[None]), sensitive, integral)
    if found is None:
        return
    motion, parts = motion_of(), found.nodes

    def columns(times: np.ndarray) -> np.ndarray | None:
        known = (motion if times is motion.times else motion.at(times))._sensitivity
        return None if known is None else known.values[:, : found.states]

    def evaluate(times: np.ndarray) -> Values:
        return now.at(times, motion.at(times).states).values(parts)

    if told := told_of_jump(
        Passed.of(motion.times, motion._dense, motion.events, columns), found, evaluate
    ):
        warn_user(told)


def warn_of_impulses(now: Snapshot, times: np.ndarray) -> None:
    """Warn where a prescribed motion, or a constraint, jumps of which derivatives are taken."""
    parts = Impulses(now.definition, now.plan)
    if not _switches(now.at(times[:1], now.x[None]), parts):
        return
    names = [*parts.nodes(now.driven.assembly.fork()).values()]

    def evaluate(times: np.ndarray) -> Values:
        return now.at(times, np.tile(now.x, (len(times), 1))).values(parts)

    every = np.unique(np.append(times, np.linspace(times[0], times[-1], num=_IN_TIME)))
    for k, beside, found, sizes in passages(evaluate, every):
        step = found["steps"][:, k].min(axis=0)
        for what, one, size in zip(names, step, sizes, strict=True):
            if one > HALF * size:
                warn_user(
                    f"At t = {beside[0]:.6g} {what} jumps by {one:.3g}. The equations hold its "
                    "derivative, in which that is an impulse, which the motion misses. Give a "
                    "smooth expression."
                )
                return
