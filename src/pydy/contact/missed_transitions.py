"""Checks of a motion with contacts after the integration: missed transitions, flat gaps."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import TYPE_CHECKING, NamedTuple, Protocol

import numpy as np

from pydy._checks import shown
from pydy._interpolation import evenly
from pydy._judges import diagnosis_of
from pydy._motion import Motion
from pydy._rank import ROUNDING
from pydy.contact.complementarity import OPEN, SLIDES, STICKS
from pydy.contact.modes import margin_symbol
from pydy.contact.tuning import CHECKED, SLACK

if TYPE_CHECKING:
    import sympy as sm

    from pydy._errors import ContactError
    from pydy._problem import Problem
    from pydy._sympy_types import AnySymbol
    from pydy.contact.conditions import Contact
    from pydy.contact.modes import CompiledModes, Mode
    from pydy.contact.rows import ContactRows, RowValues


class ContactSimulation(Protocol):
    """A simulation with contacts, such as a `ContactRun`."""

    compiled: CompiledModes
    problem: Problem
    contacts: tuple[Contact, ...]
    rows: ContactRows
    modes: tuple[str, ...]
    sizes: np.ndarray  # of forces where a segment begins
    times: np.ndarray  # (m,), at which states are given
    states: np.ndarray  # (m, n), NaN where they are not known yet
    n: int  # number of states
    first: int  # the column of the first speed

    def numbers(self, t: float, x: np.ndarray) -> RowValues:
        """Return the rows of the contacts at a state."""

    def values(self, t: float, x: np.ndarray) -> Mapping[AnySymbol, float]:
        """Return the values of states, constants, specifieds and time, by symbol."""

    def resolution(self, t: float) -> float:
        """Return the time difference below which two events count as simultaneous."""

    def unresolved(self, i: int) -> float:
        """Return the largest sliding speed that solver tolerances do not distinguish from zero."""

    def unresolved_gap(self, i: int, p: RowValues, x: np.ndarray) -> float:
        """Return the largest gap that solver tolerances do not distinguish from zero."""

    def fail(self, t: float, x: np.ndarray, why: str) -> ContactError:
        """Return an error with the state, the modes and the results so far."""


def missed_transitions(
    run: ContactSimulation,
    motion: Motion,
    mode: Mode,
    at_rest: Collection[int],
    end: float,
    last: np.ndarray | None,
    reported: Collection[tuple[str, int]],
) -> tuple[list[tuple[str, int]], np.ndarray | None]:
    """Refuse a motion in one mode if its integration missed a transition.

    An event at the time `end` ended the motion in the state `last`, before its reset; without an
    event, `last` is None. Transitions that events `reported` there, where a load may jump, are not
    missed.

    Return two things. First, the kinds and contacts of inequalities that the motion violates from
    its start on: where forces are at their limits, or contacts are `at_rest`, several modes are
    possible at the start, and the motion shows which are wrong. Second, the outputs at all times of
    the simulation if the motion is the whole of it, else None.
    """
    symbols, output_index = run.compiled.symbols, mode.output_index
    # Rows: the times of the motion, the end, and times at which the solver's steps begin.
    count, sample_times, states = len(motion.times) - 1, motion.times, motion.states
    # A projection may move the first state, which the simulation gives as it was.
    whole = last is None and len(motion.times) == len(run.times)
    whole = whole and not motion.integrator.constraints_enforced
    if last is not None:  # before the event's reset
        count = int(motion.times.searchsorted(end))
        sample_times = np.append(motion.times[:count], end)
        states = np.concatenate([motion.states[:count], last[None, : run.n]])
    dense = motion.segments[0].dense
    if dense is not None and not _stays_open(motion, mode):  # only as many steps as are stored
        starts = dense.starts
        if len(starts) > CHECKED:  # select evenly spaced steps
            further = starts[evenly(len(starts), CHECKED)]
        else:
            further = np.linspace(motion.times[0], end, CHECKED)
        further = further[: further.searchsorted(end)]
        sample_times = np.concatenate([sample_times, further])
        states = np.concatenate([states, dense(further)[:, : run.n]])
    table = motion.problem.at(sample_times, states).outputs()
    broken = []
    for i, c in enumerate(run.contacts):
        if run.modes[i] == OPEN and i in run.rows.cuts:
            _check_cuts(run, i, sample_times, states)
        if run.modes[i] == OPEN and table[:, output_index[symbols[i, "gap"]]].min() >= 0.0:
            continue
        for limit in _limits(run, i, i in at_rest):
            column = output_index[limit.symbol]
            values = table[:, column] * limit.sign
            allowed = SLACK * np.abs(values).max(initial=0.0) + limit.slack
            below = values < -allowed
            below[count] &= (limit.kind, i) not in reported
            if below.any() and limit.symbol is symbols.get((i, "gap")):
                # Compare with the start: a gap that was closed before may have drifted.
                below &= values < values[0] - allowed
                # For large coordinates the relative tolerance resolves less of the gap.
                worst = int(values.argmin())
                p = run.numbers(float(sample_times[worst]), states[worst])
                late = run.resolution(float(sample_times[worst])) * abs(p.speed[run.rows.normal[i]])
                below &= values < -run.unresolved_gap(i, p, states[worst]) - late
            if not below.any():
                continue
            earlier = sample_times < sample_times[below].min()
            if limit.kind and values[earlier].max(initial=-np.inf) <= allowed:
                broken.append((limit.kind, i))
                continue
            worst = int(values.argmin())
            place = float(sample_times[worst]), states[worst]
            name, value = limit.name, float(table[worst, column])
            if limit.symbol is symbols.get((i, "power")) and run.numbers(*place).mu[i] < 0.0:
                name, value = "`mu`", float(run.numbers(*place).mu[i])  # it drives the body
            remedy = (
                "between two transitions: the solver stepped over one. Limit the step with "
                "`max_step`."
            )
            if name in ("`mu`", "`normal`"):  # which have no transitions
                opens = ", or a Unilateral as `on`, which opens" if name == "`normal`" else ""
                remedy = (
                    "during the motion, but must not be negative. Give an expression that is "
                    f"never negative, such as Max(0, ...){opens}."
                )
            raise run.fail(*place, f"The {name} of {c.name!r} became {value:.3g} {remedy}")
    return broken, table[: count + 1] if whole else None


def _stays_open(motion: Motion, mode: Mode) -> bool:
    """Return whether all contacts are open, and no step came near the closing of a gap.

    The solver's bounds on the gaps, which have been positive, then hold between the times too.
    """
    kinds, sides = mode.events[1], motion.statistics.get("sides", ())
    return (
        motion.statistics.get("clear", False)
        and all(m == OPEN for m in mode.modes)
        and all(kind != "closes" or side > 0 for (kind, _), side in zip(kinds, sides, strict=False))
    )


def _check_cuts(run: ContactSimulation, i: int, times: np.ndarray, states: np.ndarray) -> None:
    """Refuse a gap that jumps during the motion, where atan2 goes from π to −π."""
    order = np.argsort(times, kind="stable")
    times, states = times[order], states[order]
    values = dict(run.values(float(times[0]), states[0]))
    values |= zip(run.problem.definition.states, states.T, strict=True)
    values[run.problem.definition.equations.time] = times
    inputs = {node: values.get(symbol, 0.0) for node, symbol in run.rows.symbols.items()}
    for f, evaluate in run.rows.cuts[i]:
        y, x, gap, gap_above, gap_below = evaluate(inputs, len(times)).T
        crosses = (np.signbit(y[1:]) != np.signbit(y[:-1])) & (np.maximum(x[1:], x[:-1]) < 0.0)
        continued = np.where(np.signbit(y[:-1]), gap_below[1:], gap_above[1:])  # without the jump
        size = np.maximum(np.abs(gap[1:]), np.abs(continued))
        for k in np.flatnonzero(crosses & (np.abs(continued - gap[1:]) > SLACK * size)):
            raise run.fail(
                float(times[k + 1]), states[k + 1],
                f"The gap of {run.contacts[i].name!r} jumped to {gap[k + 1]:.6g}, and would have "
                f"gone on to {continued[k]:.6g}: `{shown(f)}` jumps by 2π where the angle is π. "
                "Turn the angle so that the motion does not come there, as atan2(-y, -x) + pi is "
                "of atan2(y, x), or use a coordinate that counts turns.",
            )  # fmt: skip


def diagnose_flat_gap(
    run: ContactSimulation, t: float, x: np.ndarray, contacts: Collection[int]
) -> str:
    """Return a message if a closed gap has no slope, as q² has none at q = 0, or no mass; or ''.

    A slope counts as zero if it changes by its own size within the rounding errors of the gap and
    of the closing time.
    """
    p = run.numbers(t, x)
    for i in contacts:
        normal = run.rows.normal[i]
        inverse_mass = p.delassus[normal, normal]
        if not np.isfinite(inverse_mass):
            cause = diagnosis_of(run.problem.at(np.array([t]), x[None]))
            return (
                f"The force that closes the gap of {run.contacts[i].name!r} cannot be computed. "
                f"{cause or 'Check that no mass or inertia of the bodies there is zero.'}"
            )
        step = np.zeros(run.first)
        if inverse_mass > 0.0:
            least = ROUNDING * p.gap_rounding[i] + abs(p.speed[normal]) * run.resolution(t)
            step = p.kinematics @ p.response[:, normal] * (least / inverse_mass)
        for shift in (step, -step):
            shifted = x.copy()
            shifted[: run.first] += shift
            neighbour = run.numbers(t, shifted).delassus[normal, normal]
            if not inverse_mass / 4.0 < neighbour < 4.0 * inverse_mass:
                return (
                    f"The gap of {run.contacts[i].name!r} has no slope where it closes: no speed "
                    "changes it there, so that it has no normal force and no impact. Write a gap "
                    "that changes as a distance does, such as q in place of q**2 or q**3, and a "
                    "stop at a dead centre as a limit of the crank's angle."
                )
    return ""


class _ModeLimit(NamedTuple):
    """A quantity of a contact's mode that is not negative, or not positive if the sign is −1."""

    symbol: sm.Symbol  # of the output
    slack: float  # how far beyond zero it may be, beside a share of its size
    kind: str  # of the event that ends the mode there; '' if no mode may begin beyond it
    name: str  # in messages
    sign: float = 1.0


def _limits(run: ContactSimulation, i: int, at_rest: bool) -> Iterator[_ModeLimit]:
    """Yield the limits of a contact in its mode."""
    c, mode, symbols, size = run.contacts[i], run.modes[i], run.compiled.symbols, run.sizes[i]
    if c.unilateral is None:
        yield _ModeLimit(symbols[i, "normal"], SLACK * size, "", "`normal`")
    if mode in SLIDES:
        kind, slack = "turns" if at_rest else "", run.unresolved(i) * size
        yield _ModeLimit(symbols[i, "power"], slack, kind, "power of friction", sign=-1.0)
    if mode == STICKS:
        slack = 2.0 * SLACK * size**2
        yield _ModeLimit(margin_symbol(c), slack, "slips", "margin of friction, squared,")
    if c.unilateral is not None and mode == OPEN:
        # Its tolerance follows from those of the states that it depends on, see `unresolved_gap`.
        yield _ModeLimit(symbols[i, "gap"], 0.0, "", "gap")
    elif c.unilateral is not None:
        yield _ModeLimit(symbols[i, "normal"], SLACK * size, "opens", "normal force")
