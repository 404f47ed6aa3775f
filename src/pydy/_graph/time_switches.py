"""The times at which a Program switches by time alone, whatever the states are.

A load such as ``Piecewise((50, sin(7*t) > 0.99), (0, True))`` is zero at all stages of a step that
passes over the pulse, so that error control does not see it. Its switch g(t) = sin(7 t) − 0.99 is a
function of time, constants and inputs that are numbers. Its zeros are found by bisection with
interval arithmetic (`intervals`): an interval of time on which bounds on g exclude zero has none,
and one on which bounds on g' exclude zero has at most one, at a change of the sign of g.

A switch within others is continuous between the times of those, which are found first.

Conditions by which a solution is found in one of two ways are no switches, nor are those of the way
that is taken elsewhere: a guard's solutions are equal, so that whatever switches them is in both.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from pydy._graph.derivative import jacobian
from pydy._graph.inputs import inputs_of
from pydy._graph.intervals import bounded, bounds
from pydy._graph.node import Graph
from pydy._graph.rewrite import substitute
from pydy._graph.tuning import (
    BEYOND_ENDS,
    DIVISIONS,
    FEW_CHANGES,
    INTERVALS_AT_ONCE,
    LEAST_WINDOW,
    MOST_INTERVALS,
    SHORTEST_INTERVAL,
    SIGN_SAMPLES,
    STORED_SEARCHES,
    WIDENINGS,
)
from pydy._program import OPERATIONS, Program, SwitchTimes
from pydy.inputs import merged_jumps

if TYPE_CHECKING:
    from pydy._graph.intervals import Interval

_COMPARED = frozenset(("lt", "le", "min", "max"))
_SIGNED = frozenset(("abs", "sign", "atan2"))
_ROUNDINGS = frozenset(("floor", "ceil"))
_SWITCHING = _COMPARED | _SIGNED | _ROUNDINGS
_ARITHMETIC = frozenset(("add", "sub", "mul", "div", "neg"))  # which graphs have methods for
_SYSTEMS = frozenset(("factor", "solve", "guard", "item"))
_NEVER = ("bool", (False,))


@dataclass(frozen=True, eq=False)
class TimeSwitches:
    """The switches of a Program that depend on time alone, as nodes of a graph."""

    graph: Graph
    nodes: tuple[int, ...]  # each is zero where one switches; inner ones first
    slopes: tuple[int, ...]  # their derivatives by time
    inputs: tuple[int, ...]  # what they depend on besides time
    _stored: dict[tuple[object, ...], SwitchTimes] = field(default_factory=dict)

    @classmethod
    def of(
        cls, program: Program, varying: frozenset[int], outputs: Sequence[int] | None = None
    ) -> TimeSwitches | None:
        """Return the switches of a Program whose inputs r vary at some places, if it has any.

        They are those of some of its `outputs`; None: of all.
        """
        if ("t", 0) not in program.args or _SWITCHING.isdisjoint(program.ops):
            return None
        operations = _of_time(program, varying, program.outputs if outputs is None else outputs)
        if not operations:
            return None
        graph, nodes = _switches(program, operations)
        if not nodes:
            return None
        time = graph.input("t", 0)
        slopes = [row.get(0, graph.zero) for row in jacobian(graph, nodes, [time])]
        inputs = [n for n in inputs_of(graph, [*nodes, *slopes]) if n != time]
        return cls(graph, tuple(nodes), tuple(slopes), tuple(inputs))

    def split_by_linearity(self) -> tuple[list[int], TimeSwitches | None]:
        """Return the times of switches that are linear in time, as nodes, and the other switches.

        A time is not finite where constants let the switch not depend on time.
        """
        graph = self.graph
        time = graph.input("t", 0)
        pairs = [*zip(self.nodes, self.slopes, strict=True)]
        linear = [
            (node, slope)
            for node, slope in pairs
            if time not in inputs_of(graph, [slope])
            and not any(
                graph.ops[n] in _SWITCHING and time in inputs_of(graph, [n])
                for n in graph.reachable([node])
            )
        ]
        rest = [pair for pair in pairs if pair not in linear]
        at_zero = substitute(graph, [n for n, _ in linear], {time: graph.zero})
        times = [graph.neg(graph.div(n, s)) for n, (_, s) in zip(at_zero, linear, strict=True)]
        if not rest:
            return times, None
        nodes, slopes = zip(*rest, strict=True)
        inputs = [n for n in inputs_of(graph, [*nodes, *slopes]) if n != time]
        return times, TimeSwitches(graph, nodes, slopes, tuple(inputs))

    def numbers(self, p: np.ndarray, r: np.ndarray) -> np.ndarray:
        """Return the numbers that the times depend on, of one set of constants and inputs or m."""
        groups = {"p": p, "r": r}
        columns = [groups[g][..., k] for g, k in (self.graph.args[n] for n in self.inputs)]
        return np.stack(columns, axis=-1) if columns else np.zeros((*p.shape[:-1], 0))

    def times(self, p: np.ndarray, r: np.ndarray, start: float, end: float) -> SwitchTimes:
        """Return the times from `start` to `end`, both included."""
        numbers = self.numbers(p, r)
        key = numbers.tobytes(), start, end
        times = self._stored.get(key)
        if times is None:
            while len(self._stored) >= STORED_SEARCHES:
                self._stored.pop(next(iter(self._stored)), None)
            values = dict(zip(self.inputs, numbers.tolist(), strict=True))
            self._stored[key] = times = _SwitchSearch(self, values, start, end).switch_times()
        return times


def _determining(program: Program, outputs: Sequence[int]) -> bytearray:
    """Return which operations the values of outputs depend on.

    Of a guard these are the ones of its fast solution, without the condition and the system that
    give the same values, unless the system is always solved.
    """
    needed = bytearray(len(program.ops))
    for node in outputs:
        needed[node] = 1
    for node in reversed(range(len(program.ops))):
        if needed[node]:
            op, args = program.ops[node], program.args[node]
            needs = OPERATIONS.operands(op, args)
            if op == "guard" and (program.ops[args[3]], program.args[args[3]]) != _NEVER:
                needs = args[4]
            for operand in needs:
                needed[operand] = 1
    return needed


def _of_time(program: Program, varying: frozenset[int], outputs: Sequence[int]) -> list[int]:
    """Return the operations that switch by an operand that depends on time alone."""
    operations: list[int] = []
    determining = _determining(program, outputs)
    # Whether each depends on time, and whether also on states or inputs that vary.
    timed, moving = bytearray(len(program.ops)), bytearray(len(program.ops))
    for k, (op, args) in enumerate(zip(program.ops, program.args, strict=True)):
        if op == "input":
            timed[k] = args[0] == "t"
            moving[k] = args[0] == "x" or (args[0] == "r" and args[1] in varying)
        elif op not in ("const", "bool"):
            needs = OPERATIONS.operands(op, args)
            timed[k] = any(map(timed.__getitem__, needs))
            moving[k] = op in _SYSTEMS or any(map(moving.__getitem__, needs))
            if timed[k] and not moving[k] and op in _SWITCHING and determining[k]:
                operations.append(k)
    return operations


def _switches(program: Program, switching_operations: Sequence[int]) -> tuple[Graph, list[int]]:
    """Return a graph, and in it what is zero where operations of a Program switch."""
    graph, built, switching = Graph(), dict[int, int](), {*switching_operations}
    needed = bytearray(len(program.ops))
    for k in reversed(range(max(switching_operations) + 1)):
        if needed[k] or k in switching:
            needed[k] = 1
            for n in OPERATIONS.operands(program.ops[k], program.args[k]):
                needed[n] = 1
    zeros: dict[int, None] = {}
    for k in np.flatnonzero(needed).tolist():
        op, args = program.ops[k], program.args[k]
        if op in ("const", "input", "bool"):
            built[k] = graph.node(op, args)
            continue
        nodes = [built[n] for n in args]
        arithmetic = op in _ARITHMETIC
        built[k] = getattr(graph, op)(*nodes) if arithmetic else graph.call(op, *nodes)
        if k in switching and not graph.constant[switch := _switch(graph, op, nodes)]:
            core = graph.scaled(switch)[1]
            if "t" in inputs_of(graph, [core]).groups:
                zeros[min(core, graph.neg(core))] = None
    return graph, [*zeros]


def _switch(graph: Graph, op: str, nodes: Sequence[int]) -> int:
    if op in _COMPARED:
        return graph.sub(*nodes)
    if op in _ROUNDINGS:  # zero where the operand is a whole number
        return graph.call("sin", graph.mul(graph.const(math.pi), nodes[0]))
    return nodes[0]


class _SwitchSearch:
    """The search for the times at which switches are zero, with numbers for their inputs."""

    def __init__(
        self, switches: TimeSwitches, values: dict[int, float], start: float, end: float
    ) -> None:
        self.switches, self.values = switches, values
        self.span, self.ends = end - start, (start, end)
        # Rounding may move a switch at an end beyond it; no interval may end in a jump.
        margin = BEYOND_ENDS * max(abs(start), abs(end), self.span)
        self.start, self.end = start - margin, end + margin
        self.intervals_remaining = MOST_INTERVALS

    def switch_times(self) -> SwitchTimes:
        """Return the times of all switches."""
        graph, nodes = self.switches.graph, self.switches.nodes
        windows: dict[int, np.ndarray] = {}
        unresolved = 0
        for node, slope in zip(nodes, self.switches.slopes, strict=True):
            needs = graph.reachable([node])
            nested = not _SWITCHING.isdisjoint(graph.ops[n] for n in needs)
            low, high = self._intervals_between([*windows.values()] if nested else [])
            are_bounded = all(bounded(graph.ops[n]) for n in graph.reachable([node, slope]))
            times, changes = (
                self._zeros(node, slope, low, high) if are_bounded else self._sampled(node)
            )
            unresolved = max(unresolved, changes)
            windows[node] = self._windows(node, times)
        return SwitchTimes(merged_jumps([*windows.values()]), unresolved)

    def _intervals_between(self, windows: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
        """Return the intervals between some windows, as lower and upper ends."""
        rows = merged_jumps(windows)
        low, high = np.append(self.start, rows[:, 2]), np.append(rows[:, 1], self.end)
        is_interval = low < high
        return low[is_interval], high[is_interval]

    # -- bounds -----------------------------------------------------------------------------------

    def _bounds(self, nodes: Sequence[int], low: np.ndarray, high: np.ndarray) -> list[np.ndarray]:
        """Return lower and upper bounds on nodes, one after the other, in intervals of time."""

        def leaf(node: int) -> Interval:
            value = self.values.get(node)
            return (low, high) if value is None else (value, value)

        pairs = bounds(self.switches.graph, nodes, leaf)
        return [np.broadcast_to(end, low.shape) for ends in pairs for end in ends]

    def _bounds_in_parts(
        self, nodes: Sequence[int], low: np.ndarray, high: np.ndarray
    ) -> list[np.ndarray]:
        if len(low) <= INTERVALS_AT_ONCE:
            return self._bounds(nodes, low, high)
        parts = [slice(k, k + INTERVALS_AT_ONCE) for k in range(0, len(low), INTERVALS_AT_ONCE)]
        bounds_of_parts = [self._bounds(nodes, low[part], high[part]) for part in parts]
        return [np.concatenate(ends) for ends in zip(*bounds_of_parts, strict=True)]

    def _values(self, node: int, times: np.ndarray) -> np.ndarray:
        graph = self.switches.graph
        inputs: dict[int, float | np.ndarray] = {graph.input("t", 0): times, **self.values}
        values: np.ndarray = graph.evaluator([node])(inputs, len(times))[:, 0]
        return values

    # -- zeros ------------------------------------------------------------------------------------

    def _zeros(
        self, node: int, slope: int, low: np.ndarray, high: np.ndarray
    ) -> tuple[np.ndarray, int]:
        """Return the zeros of a node in intervals of time in which it is smooth.

        The second value is 0, or if there are too many zeros, which are then not returned, the
        number of changes of sign.
        """
        brackets: list[tuple[np.ndarray, np.ndarray]] = []
        touched: list[tuple[np.ndarray, np.ndarray]] = []
        while len(low):
            self.intervals_remaining -= len(low)
            if self.intervals_remaining < 0:  # bounds are too wide, or zeros too many
                if (changes := self._changes(node, low, high)) > FEW_CHANGES:
                    return np.zeros(0), changes
                brackets.append((low, high))
                break
            least, most, lowest, highest = self._bounds_in_parts([node, slope], low, high)
            open_ = ~((least > 0.0) | (most < 0.0) | ((least == 0.0) & (most == 0.0)))
            # Next to a pole no bounds are finite.
            steady = open_ & np.isfinite(least) & np.isfinite(most)
            steady &= (lowest > 0.0) | (highest < 0.0)
            short = open_ & ~steady & (high - low <= SHORTEST_INTERVAL * self.span)
            brackets.append((low[steady], high[steady]))
            touched.append((low[short], high[short]))
            undecided = open_ & ~steady & ~short
            ends = np.linspace(low[undecided], high[undecided], DIVISIONS + 1)
            low, high = ends[:-1].T.ravel(), ends[1:].T.ravel()
        if touched:
            brackets.append(_merged(*(np.concatenate(part) for part in zip(*touched, strict=True))))
        if not brackets:
            return np.zeros(0), 0
        first, last = (np.concatenate(part) for part in zip(*brackets, strict=True))
        return self._in_brackets(node, first, last), 0

    def _changes(self, node: int, low: np.ndarray, high: np.ndarray) -> int:
        """Return the number of intervals in which the sign changes."""
        return int((self._values(node, low) * self._values(node, high) < 0.0).sum())

    def _in_brackets(self, node: int, low: np.ndarray, high: np.ndarray) -> np.ndarray:
        """Return the zeros in intervals at whose ends the signs differ, and at these ends."""
        value_at_low, value_at_high = self._values(node, low), self._values(node, high)
        at_ends = [low[value_at_low == 0.0], high[value_at_high == 0.0]]
        low, high, value_at_low = (
            a[value_at_low * value_at_high < 0.0] for a in (low, high, value_at_low)
        )
        for _ in range(80):
            middle = 0.5 * (low + high)
            if not ((low < middle) & (middle < high)).any():
                break
            value = self._values(node, middle)
            before = value * value_at_low > 0.0
            low = np.where(before | (value == 0.0), middle, low)
            high = np.where(before, high, middle)
        nearer = np.abs(self._values(node, low)) <= np.abs(self._values(node, high))
        return np.unique(np.concatenate([*at_ends, np.where(nearer, low, high)]))

    def _sampled(self, node: int) -> tuple[np.ndarray, int]:
        """Return the zeros between samples of different signs, as `_zeros` does."""
        times = np.linspace(self.start, self.end, SIGN_SAMPLES + 1)
        low, high = times[:-1], times[1:]
        if 8 * (changes := self._changes(node, low, high)) > SIGN_SAMPLES:
            return np.zeros(0), changes
        return self._in_brackets(node, low, high), 0

    def _windows(self, node: int, times: np.ndarray) -> np.ndarray:
        """Return rows of `SwitchTimes` for the zeros at which the sign changes."""
        smallest = np.maximum(2.0 * np.spacing(np.abs(times)), LEAST_WINDOW * self.span)
        half_width, before, after = smallest, *(np.full(len(times), np.nan) for _ in range(2))
        if all(bounded(self.switches.graph.ops[n]) for n in self.switches.graph.reachable([node])):
            for _ in range(WIDENINGS):
                before, after = (self._sides(node, times + s * half_width) for s in (-1.0, 1.0))
                unknown = np.isnan(before) | np.isnan(after)
                if not unknown.any():
                    break
                half_width = np.where(unknown, 4.0 * half_width, half_width)
        half_width = np.where(np.isnan(before) | np.isnan(after), smallest, half_width)
        rows = np.stack([times, times - half_width, times + half_width], axis=1)[before != after]
        for end in self.ends:  # else the first or last step may be as short as rounding
            rows[(rows[:, 1] < end) & (end < rows[:, 2]), 0] = end
        table: np.ndarray = rows
        return table

    def _sides(self, node: int, times: np.ndarray) -> np.ndarray:
        """Return the signs of a node at some times, NaN where rounding may change them."""
        least, most = self._bounds_in_parts([node], times, times)
        signs = np.sign(least)
        result: np.ndarray = np.where(signs == np.sign(most), signs, np.nan)
        return result


def _merged(low: np.ndarray, high: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Merge intervals that meet."""
    order = np.argsort(low)
    low, high = low[order], high[order]
    first = np.append(True, low[1:] > high[:-1])[: len(low)]
    last = np.append(low[1:] > high[:-1], True)[: len(low)]
    return low[first], high[last]
