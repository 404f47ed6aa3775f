"""Whether a motion kept the constraints and its energy: judged by the errors allowed in a step.

The equations keep the accelerations of all rows zero and, where no load or input changes it, the
energy constant. An error of a step moves a residual or the energy once and for all, and an error of
a residual's rate moves them in proportion to the time since. Steps with errors as large as the
tolerances, all in one direction, explain changes up to

    3 steps · (|∂c/∂x| + duration · |∂c'/∂x|) · (atol + rtol |x|).

Tolerances may be below rounding errors: what a constraint holds against a large force keeps some
2⁻⁵² of that. A residual J u of velocities is of no account, too, if the least motion that has it,
of the energy (J u)² / (2 J M⁻¹ Jᵀ), has less than a rounding of the kinetic energy.

Sound motions stay below that, most by a factor of a hundred, whatever the method, the tolerances
and the units; a mechanism that left its constraints, or a branch of its motion, is beyond it.
"""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np

from pydy._assembly.assembly import Assembly
from pydy._errors import IntegrationError
from pydy._graph.derivative import dense, dense_jacobian, directional
from pydy._graph.node import Graph
from pydy._graph.rewrite import substitute
from pydy._rank import DIGITS
from pydy._system.snapshot import Snapshot
from pydy._system.solving import constraint_names
from pydy._system.start import evaluated_rows
from pydy._system.tuning import EXCESS, LEFT, LOST, NEAR_SINGULAR, TRIED
from pydy.solvers.options import Options
from pydy.solvers.outcome import ENERGY_CHANGED, LEFT_CONSTRAINTS, OUTCOMES
from pydy.trajectory import EventRecord

__all__ = ["Motion", "check_kept"]


@dataclass(frozen=True, eq=False)
class Motion:
    """What a solver returned.

    Attributes
    ----------
    now : Snapshot
    times, states : ndarray, shapes (m,) and (m, n)
    options : dict
        For the solver.
    info : dict
        Its statistics.
    mended : bool
        Whether the motion is brought back onto the constraints.
    """

    now: Snapshot
    times: np.ndarray
    states: np.ndarray
    options: dict[str, Any]
    info: dict[str, Any]
    mended: bool

    def at(
        self, t: np.ndarray, x: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Return t, x, r and p; r has one row where it is the same for all."""
        return t, x, self.now.plan.rows(x, t), self.now.p

    @property
    def some(self) -> tuple[np.ndarray, np.ndarray]:
        """A few times and states, spread over all, with the last that was reached.

        By projection a motion begins beside the state that was given.
        """
        found = np.flatnonzero(np.isfinite(self.states).all(axis=1))
        found = found[int(self.projected and len(found) > 1) :]
        if len(found) > TRIED:
            found = found[np.unique(np.linspace(0, len(found) - 1, TRIED).astype(int))]
        return self.times[found], np.ascontiguousarray(self.states[found])

    @property
    def resets(self) -> list[EventRecord]:
        """The events that changed the state."""
        records: Iterable[EventRecord] = self.info.get("events", ())
        return [record for record in records if (record.after != record.before).any()]

    @property
    def projected(self) -> bool:
        """Whether projection holds the constraints."""
        return "constraints" in self.options

    @property
    def controlled(self) -> bool:
        """Whether the solver controls its errors."""
        return "step" not in self.options

    def errors(self, x: np.ndarray) -> np.ndarray:
        """Return how large the errors of all steps are together, if each is what is allowed."""
        sizes: np.ndarray = np.abs(x)
        if not self.controlled:
            return LEFT * sizes
        rtol, atol = (self.options.get(name, getattr(Options, name)) for name in ("rtol", "atol"))
        steps = self.info["nst"].max() if "nst" in self.info else self.info["steps"]
        sizes = (atol + rtol * sizes) * EXCESS * float(steps)
        return sizes


def check_kept(motion: Motion) -> None:
    """Refuse a motion that left the constraints, redundant ones too, or changed its energy.

    Energies are looked at where residuals exceed six digits, or the constraints nearly lost rank.
    What begins beside the constraints was told of, or comes back to them: it has other energies.

    Raises
    ------
    IntegrationError
    """
    now, left_out = motion.now, motion.now.definition.equations.left_out
    near = motion.info.get("nearness", 1.0) < NEAR_SINGULAR
    if motion.projected and not near and not any(left_out):
        return
    at = motion.at(*motion.some)
    residuals, sizes = evaluated_rows(now.definition, now.driven, "sizes", at)
    limits = DIGITS * sizes.max(axis=0)
    if not (np.abs(residuals) > limits).any():
        if near and motion.controlled:
            _check_energy(motion, at)
        return
    t, x = at[:2]
    rows = _Rows(*left_out)
    found, errors = now.driven.interpreted(rows, at), motion.errors(x)
    begins = [(t[0], x[0]), *((event.time, event.after) for event in motion.resets)]
    times, states = (np.array(part) for part in zip(*begins, strict=True))
    start = now.driven.interpreted(rows, motion.at(times, states))
    beside, allowed = np.abs(start["rows"]), _moved(found["slopes"], errors)
    sound = bool((beside <= allowed).all())
    if (beside > limits).any() or (motion.mended and not sound):
        return
    duration = (t - t[0])[:, None]
    allowed = allowed + beside.sum(axis=0)
    allowed = allowed + duration * (
        _moved(found["turns"], errors) + np.abs(start["rates"]).sum(axis=0)
    )
    if (np.abs(found["rows"]) > np.fmax(allowed, limits)).any():
        allowed = allowed + _unseen(motion, at, found["slopes"])
    _check_residuals(motion, at, found["rows"], allowed, limits)
    if sound and motion.controlled:
        _check_energy(motion, at)


def _check_residuals(
    motion: Motion, at: Any, residuals: np.ndarray, allowed: np.ndarray, limits: np.ndarray
) -> None:
    now, (t, x, _, _) = motion.now, at
    off = np.abs(residuals) / np.fmax(allowed, np.where(limits > 0.0, limits, 1.0))
    if (off > 1.0).any():
        k = int((off > 1.0).any(axis=1).argmax())
        row = int(np.argmax(off[k]))
        names = constraint_names(now.definition.equations, redundant=True)
        _stop(
            motion, LEFT_CONSTRAINTS, float(t[k]), x[k], row=names[row],
            residual=residuals[k, row], explained=allowed[k, row],
        )  # fmt: skip


def _check_energy(motion: Motion, at: Any) -> None:
    now, (t, x, _, _) = motion.now, at
    if motion.resets or not now.energies.static:
        return
    parts = _energy(now)
    if parts is None:
        return
    found = now.driven.interpreted(parts, at)
    if not found["total"].size:
        return
    kinetic = found["kinetic"].max()
    changes = np.abs(found["total"] - found["total"][0])[:, 0]
    errors = motion.errors(x)
    allowed = _moved(found["slopes"], errors)[0] + LOST * kinetic
    if not motion.projected:  # beside the constraints their forces, of which M u' is made, do work
        q, n = len(now.definition.equations.coordinates), len(now.definition.equations.speeds)
        u_dot = now.derivatives(t, x)[:, q : q + n]
        forces = np.einsum("kij,kj->ki", found["hessian"].reshape(-1, n, n), u_dot)
        allowed = allowed + (t - t[0]) * _moved(forces, errors[:, q : q + n])[0]
    allowed = np.broadcast_to(allowed, t.shape)
    if (changes > allowed).any():
        k = int((changes > allowed).argmax())
        _stop(
            motion, ENERGY_CHANGED, float(t[k]), x[k],
            change=changes[k], explained=allowed[k], kinetic=kinetic,
        )  # fmt: skip


def _energy(now: Snapshot) -> _Energy | None:
    """Return the energies of a model, found once; None where they are not known."""
    latest = now.driven.latest
    parts: _Energy | None
    energies, parts = latest.get("energy", (None, None))
    if energies is not now.energies:
        parts, left_out = None, now.definition.equations.left_out
        with suppress(ValueError, NotImplementedError):
            parts = _Energy(*now.energies.expressions(now.driven.layout), *left_out)
        latest["energy"] = now.energies, parts
    return parts


def _unseen(motion: Motion, at: Any, slopes: np.ndarray) -> np.ndarray:
    """Return residuals of velocities whose energy is a rounding of the kinetic one, row by row."""
    now, states = motion.now, at[1].shape[1]
    slopes = slopes.reshape(len(slopes), -1, states)
    try:
        kinetic = now.energies.moving(now.driven.layout)
        found = now.driven.interpreted(_Moving(kinetic), at)
    except (ValueError, NotImplementedError):  # not known
        return np.zeros(slopes.shape[1])
    equations = now.definition.equations
    first, n = len(equations.coordinates), len(equations.speeds)
    slopes = slopes[:, :, first : first + n]
    mobility = np.linalg.pinv(found["hessian"].reshape(-1, n, n), hermitian=True)
    moved = np.einsum("kri,kij,krj->kr", slopes, mobility, slopes)
    share = 2.0 * np.finfo(float).eps * found["kinetic"].max()
    largest: np.ndarray = np.sqrt(share * moved).max(axis=0)
    return largest


def _moved(slopes: np.ndarray, errors: np.ndarray) -> np.ndarray:
    """Return what errors of the states may make of some values, at the state where it is most."""
    sizes = np.abs(slopes.reshape(len(errors), -1, errors.shape[1])) * errors[:, None]
    largest: np.ndarray = sizes.sum(axis=2).max(axis=0)
    return largest


def _stop(motion: Motion, code: int, t: float, x: np.ndarray, **details: Any) -> None:
    status = OUTCOMES[code].text.format(**details)
    raise IntegrationError(
        f"`{motion.info.get('method', 'odeint')}` {status} at t = {t!r}. {OUTCOMES[code].remedy}",
        motion.times,
        motion.states,
        t,
        x,
        {**motion.info, "code": code, "status": status},
    )


@dataclass(frozen=True)
class _Rows:
    """All constraints, rates of the holonomic ones, and the derivatives of both by the states.

    Rows with specifieds of which nothing but values is known have no rate, and are left out.
    """

    closed: tuple[Any, ...]
    redundant: tuple[Any, ...]

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        graph = assembly.graph
        places, motion = self.read(assembly)
        rows = [graph.zero if _inputs(graph, [n]) & {"r"} else n for n in (*places, *motion)]
        first = graph.args[assembly.speeds[0]][1]
        along = {graph.input("x", k): {0: rate} for k, rate in enumerate(assembly.rates[:first])}
        along[graph.input("t", 0)] = {0: graph.one}
        rates = dense(graph, directional(graph, rows[: len(places)], along), 1)
        rates += [graph.zero] * len(motion)
        states = [graph.input("x", k) for k in range(assembly.sizes[0])]
        return {
            "rows": rows,
            "rates": rates,
            "slopes": dense_jacobian(graph, rows, states),
            "turns": dense_jacobian(graph, rates, states),
        }

    def read(self, assembly: Assembly) -> tuple[list[int], list[int]]:
        """Return the holonomic and the velocity constraints."""
        closed = assembly.read(self.closed, "the holonomic constraints")
        redundant = assembly.read(self.redundant, "the velocity constraints")
        return [*assembly.holonomic, *closed], [*assembly.velocity, *redundant]


@dataclass(frozen=True)
class _Energy:
    """The energies, and the total one's derivatives by the states; nothing where it may change.

    It is constant where loads have a potential and constraints do no work: neither depends on time
    or specifieds, all that moves moves with the speeds.
    """

    kinetic: Any
    potential: Any
    closed: tuple[Any, ...]
    redundant: tuple[Any, ...]

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        graph, speeds = assembly.graph, assembly.speeds
        kinetic, potential = assembly.read((self.kinetic, self.potential), "the energy")
        places, motion = _Rows(self.closed, self.redundant).read(assembly)
        moves = [*motion, *assembly.rates[: graph.args[speeds[0]][1]]]
        driven = _inputs(graph, [kinetic, potential, *places, *moves]) & {"t", "r"}
        momenta = dense_jacobian(graph, [kinetic], speeds)
        rest = substitute(graph, [kinetic, *momenta, *moves], dict.fromkeys(speeds, graph.zero))
        if driven or any(node != graph.zero for node in rest):
            return {"kinetic": [], "total": [], "slopes": [], "hessian": []}
        total = graph.add(kinetic, potential)
        states = [graph.input("x", k) for k in range(assembly.sizes[0])]
        slopes = dense_jacobian(graph, [total], states)
        hessian = dense_jacobian(graph, momenta, speeds)
        return {"kinetic": [kinetic], "total": [total], "slopes": slopes, "hessian": hessian}


@dataclass(frozen=True)
class _Moving:
    """The kinetic energy, and its second derivatives by the speeds."""

    kinetic: Any

    def __call__(self, assembly: Assembly) -> dict[str, list[int]]:
        graph, speeds = assembly.graph, assembly.speeds
        nodes = assembly.read((self.kinetic,), "the energy")
        momenta = dense_jacobian(graph, nodes, speeds)
        return {"kinetic": nodes, "hessian": dense_jacobian(graph, momenta, speeds)}


def _inputs(graph: Graph, nodes: list[int]) -> set[str]:
    """Return the kinds of inputs that nodes depend on: of 't', 'x', 'r' and 'p'."""
    found = graph.reachable(nodes)
    return {str(graph.args[n][0]) for n in found if graph.ops[n] == "input"}
