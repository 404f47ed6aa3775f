"""Motions that left their constraints, or changed their energy without a cause, are errors."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np

from pydy import _forks
from pydy._assembly.assembly import Assembly
from pydy._assembly.definition import Layout
from pydy._assembly.model import CompiledModel
from pydy._errors import IntegrationError
from pydy._graph.derivative import dense_jacobian, jacobian
from pydy._graph.program import Program
from pydy._graph.rewrite import substitute
from pydy._system.energy import EnergyModel
from pydy._system.snapshot import Snapshot
from pydy._system.solving import constraint_names
from pydy._system.start import bounded, contradiction, measured, rates, rates_along, sized
from pydy.solvers.kept import Ran, judge, looked_at
from pydy.solvers.options import Options
from pydy.solvers.outcome import OUTCOMES
from pydy.solvers.tuning import NEAR_SINGULAR
from pydy.trajectory import EventRecord


def part_of(now: Snapshot, name: str) -> Callable[[Assembly], dict[str, list[int]]] | None:
    """Return what makes a part of `kept.Part` of an Assembly, or None where there is none."""
    if name == "contradictions" and not now.definition.equations.unimplied:
        return None
    if name in PARTS:
        return PARTS[name]
    made = now.energies, now.driven.layout
    return EnergyPart(*made) if name == "energy" else Moving(*made)


# -- one motion ------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Motion:
    """What a solver returned."""

    now: Snapshot
    times: np.ndarray
    states: np.ndarray
    # for the solver, with its own tolerances if these are not those of `Options`
    options: dict[str, Any]
    # its statistics; where they do not tell the number of steps, its errors are not known
    info: Mapping[str, Any]
    mended: bool  # whether the motion is brought back onto the constraints

    def part(self, name: str, t: np.ndarray, x: np.ndarray) -> dict[str, np.ndarray]:
        """Return values along the motion; see `kept.Part`."""
        made = part_of(self.now, name)
        return {} if made is None else self.now.at(t, x).values(made)

    @property
    def ran(self) -> Ran:
        """A few of its states, with what is known of the solver."""
        projected = "constraints" in self.options
        few = looked_at(self.states, projected)
        steps = None
        if "step" not in self.options:
            known = self.info.get("nst", self.info.get("steps"))
            steps = None if known is None else float(np.max(known))
        given = [self.options.get(name) for name in ("rtol", "atol")]
        defaults = Options.rtol, Options.atol
        rtol, atol = (d if g is None else g for g, d in zip(given, defaults, strict=True))
        records: Iterable[EventRecord] = self.info.get("events", ())
        return Ran(
            self.times[few],
            np.ascontiguousarray(self.states[few]),
            steps,
            rtol,
            atol,
            self.info["nearness"] if projected else None,
            self.mended,
            [(e.time, e.after) for e in records if (e.after != e.before).any()],
            any(self.now.definition.equations.left_out),
        )


def check_kept(motion: Motion) -> None:
    """Refuse a motion that left the constraints, or changed its energy without a cause."""
    equations, projected = motion.now.definition.equations, "constraints" in motion.options
    held = motion.info["nearness"] >= NEAR_SINGULAR if projected else False
    if held and not equations.beyond_projection:
        return
    ran = motion.ran
    verdict = judge(ran, motion.part)
    if verdict is None:
        return
    if "unimplied" in verdict.details:
        t = float(ran.times[verdict.place])
        why = contradiction(equations, t, **verdict.details)
        text = f"cannot keep all constraints. {why}"
        raise _refused(motion, verdict.code, verdict.place, text)
    details, outcome = verdict.details, OUTCOMES[verdict.code]
    if "row" in details:
        names = constraint_names(equations, redundant=True)
        details = {**details, "row": names[details["row"]]}
    status, t = outcome.text.format(**details), float(ran.times[verdict.place])
    text = f"{status} at t = {t!r}. {outcome.remedy}"
    raise _refused(motion, verdict.code, verdict.place, text, status)


def _refused(
    motion: Motion, code: int, place: int, text: str, status: str | None = None
) -> IntegrationError:
    ran = motion.ran
    return IntegrationError(
        f"`{motion.info.get('method', 'odeint')}` {text}",
        motion.times,
        motion.states,
        float(ran.times[place]),
        ran.states[place],
        {**motion.info, "code": code, "status": text if status is None else status},
    )


# -- the motions of an ensemble --------------------------------------------------------------------


def kept_programs(now: Snapshot, model: CompiledModel) -> KeptPrograms:
    """Return the parts as Programs, those that the latest ensemble of a model made."""
    energies, found = model.latest.get("kept", (None, None))
    if energies is not now.energies:
        found = KeptPrograms(now, model)
        model.latest["kept"] = now.energies, found
    made: KeptPrograms = found
    return made


class KeptPrograms:
    """The parts of `kept.Part` as Programs; those that travel to other processes take all along."""

    def __init__(self, now: Snapshot, model: CompiledModel) -> None:
        self._now, self._model = now, model
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
        made = part_of(self._now, name)
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


def slopes(assembly: Assembly) -> dict[str, list[int]]:
    """Return 'slopes' of `kept.Part`; specifieds of which values alone are known have no rate."""
    graph = assembly.graph
    places, motion = assembly.with_left_out()
    rows = [graph.zero if "r" in graph.inputs_of([n]) else n for n in (*places, *motion)]
    rates = rates_along(assembly, rows[: len(places)]) + [graph.zero] * len(motion)
    states = [graph.input("x", k) for k in range(assembly.sizes[0])]
    turns = dense_jacobian(graph, rates, states)
    return {"rows": rows, "rates": rates, "turns": turns, **measured(assembly, rows, len(places))}


PARTS: dict[str, Callable[[Assembly], dict[str, list[int]]]] = {
    "rows": sized, "bounds": bounded, "products": products, "contradictions": rates,
    "slopes": slopes,
}  # fmt: skip


@dataclass(frozen=True)
class _OfEnergies:
    """A part that follows from the energies; there is nothing in it where these are not known."""

    energies: EnergyModel
    layout: Layout


class EnergyPart(_OfEnergies):
    """The energies and forces, and the total energy's derivatives; nothing where it may change."""

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        known: tuple[Any, ...] = ()
        with suppress(ValueError, NotImplementedError):
            known = self.energies.expressions(self.layout) if self.energies.static else ()
        if not known:
            return {}
        graph, speeds = assembly.graph, assembly.speeds
        kinetic, potential = assembly.read(known, "the energy")
        places, motion = assembly.with_left_out()
        first, n = graph.args[speeds[0]][1], len(speeds)
        moves = [*motion, *assembly.rates[:first]]
        driven = graph.inputs_of([kinetic, potential, *places, *moves]) & {"t", "r"}
        momenta = dense_jacobian(graph, [kinetic], speeds)
        rest = substitute(graph, [kinetic, *momenta, *moves], dict.fromkeys(speeds, graph.zero))
        if driven or any(node != graph.zero for node in rest):
            return {}
        total = graph.add(kinetic, potential)
        states = [graph.input("x", k) for k in range(assembly.sizes[0])]
        hessian, u_dot = dense_jacobian(graph, momenta, speeds), assembly.rates[first : first + n]
        forces = [graph.zero] * len(states)
        for k in range(n):
            parts = zip(hessian[k * n : (k + 1) * n], u_dot, strict=True)
            forces[first + k] = graph.sum([(graph.mul(a, b), 1.0) for a, b in parts])
        slopes = dense_jacobian(graph, [total], states)
        return {"kinetic": [kinetic], "total": [total], "slopes": slopes, "forces": forces}


class Moving(_OfEnergies):
    """The kinetic energy, and its second derivatives by the states as far as these are speeds."""

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        graph, speeds = assembly.graph, assembly.speeds
        try:
            nodes = assembly.read((self.energies.moving(self.layout),), "the energy")
        except (ValueError, NotImplementedError):
            return {}
        rows = dense_jacobian(graph, dense_jacobian(graph, nodes, speeds), speeds)
        first, n, states = graph.args[speeds[0]][1], len(speeds), assembly.sizes[0]
        hessian = [graph.zero] * states**2
        for k in range(n):
            start = (first + k) * states + first
            hessian[start : start + n] = rows[k * n : (k + 1) * n]
        return {"kinetic": nodes, "hessian": hessian}
