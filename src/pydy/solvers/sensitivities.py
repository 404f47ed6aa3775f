"""Sensitivities that a solver integrates together with the state.

At an event with g(x, t, θ) = 0 and the state R(x, t, θ) after it the columns S = ∂x/∂θ jump: the
event's time moves by dt/dθ = −(g_x S + g_θ) / ġ, and after it

    S⁺ = R_x S + R_θ + (Ṙ − f⁺) dt/dθ,

where ġ = g_x f + g_t and Ṙ = R_x f + R_t with the derivatives f of the states before it, f⁺ those
after it (P. I. Barton and C. K. Lee, "Modeling, simulation, sensitivity analysis, and optimization
of hybrid systems", ACM Transactions on Modeling and Computer Simulation 12 (2002) 256–289).

The errors of columns bound the step even if the step-size control uses those of the states only: a
fast direction that the motion does not excite is visible in the columns alone.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from pydy._kernel import Kernel, KernelCall
from pydy.solvers.tuning import BOUND, BOUND_CAP, ROUNDING
from pydy.trajectory import EventRecord


class Jump(NamedTuple):
    """The derivatives of an event's time and reset."""

    time: np.ndarray  # (k,): derivatives of the event's time
    after: np.ndarray  # (n, k): derivatives of the states after it, at a fixed time
    depth: float  # how far the motion goes beyond zero, at most: ġ² / 2|g̈|
    error: float  # of the expression at the event, due to the tolerances
    lower: str  # the start of a remedy, which tolerances to lower: see `event_resolution`


@dataclass(frozen=True, eq=False)
class CompiledSensitivities:
    """The equations of a state followed by columns of sensitivities, for a solver."""

    states: int  # number of states, n; they come first
    # (k, 2): for each column of S, which follows the state row by row, the index of the input that
    # it is a derivative by, among those of `events`, and of its weight in r; or -1.
    sources: np.ndarray
    scales: np.ndarray  # (k,): the sizes of the parameters
    start: np.ndarray  # (n,): the states at the beginning
    # Whether the step-size control includes the sensitivities: the error allowed in ∂x/∂θ is then
    # that of x over the size of θ. Else they only bound the steps: see `bounding_tolerances`.
    controlled: bool
    # The Kernel of an event's effect on derivatives, and the states that it changes.
    events: Callable[[int], tuple[Kernel, Sequence[int]]]
    # The Kernel of the derivatives of the holonomic, then of the velocity residuals, shapes (h, k)
    # and (v, k).
    constraints: Callable[[], Kernel]
    # Events whose times may be unknown, NaN: what follows does not depend on them.
    untimed: frozenset[int] = frozenset()

    @property
    def columns(self) -> int:
        """Number of columns, k."""
        return len(self.sources)

    def tolerances(self, rtol: np.ndarray, atol: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the tolerances (n (1 + k),) of states and sensitivities from those of states."""
        if self.controlled:
            columns = np.repeat(rtol, self.columns), (atol[:, None] / self.scales).ravel()
        else:
            columns = self.bounding_tolerances(rtol, atol, self.start, self.scales)
        return np.append(rtol, columns[0]), np.append(atol, columns[1])

    def table(self, augmented: np.ndarray) -> np.ndarray:
        """Return S, shape (n, k), of states and sensitivities (n (1 + k),)."""
        return augmented[self.states :].reshape(self.states, self.columns)

    def jump(
        self,
        call: KernelCall,
        event: int,
        t: float,
        augmented: np.ndarray,
        after: np.ndarray,
        tolerances: tuple[np.ndarray, np.ndarray],
        forced: bool = False,
    ) -> Jump:
        """Return the change of sensitivities by an event.

        States and sensitivities before it are `augmented`, the states after it `after`. The
        tolerances are those of states. An event is `forced` if the jump of a sampled input caused
        it: its time is then that of the sample.
        """
        n, (kernel, changed), table = self.states, self.events(event), self.table(augmented)
        r, program = call.inputs(augmented, t), kernel.program
        s = program.signature.num_specifieds // 2
        inputs = np.concatenate([r[:s], call.inputs.slopes(t)[:s]])
        out = kernel.evaluate(np.array([t]), augmented[None, :n], inputs[None], call.p)[0][0]
        blocks = program.signature.by_block(out)
        rate, curvature = float(blocks["rate"][0]), float(blocks["curvature"][0])
        with np.errstate(all="ignore"):
            time = -self._by_parameters(blocks["crossing"][None], table, r)[0] / rate
            depth = rate * rate / (2.0 * abs(curvature)) if curvature else abs(rate) * np.inf
        if forced:
            time, depth = np.zeros(self.columns), np.inf
        rtol, atol = tolerances
        error, lower = self.event_resolution(
            depth, blocks["crossing"][:n], augmented[:n], rtol, atol
        )
        if not changed:
            return Jump(time, table, depth, error, lower)
        changed_columns = table.copy()
        changed_columns[[*changed]] = self._by_parameters(blocks["after"], table, r)
        rates = call.evaluate(call.kernel, np.concatenate([after, changed_columns.ravel()]), t)[:n]
        jump = changed_columns + np.outer(blocks["after_rates"] - rates, time)
        return Jump(time, jump, depth, error, lower)

    def _by_parameters(self, rows: np.ndarray, table: np.ndarray, r: np.ndarray) -> np.ndarray:
        """Apply the chain rule: derivatives by parameters from those by states and other inputs."""
        n, (column, weight) = self.states, self.sources.T
        # Only the column's own input is multiplied: the slope of another one may be infinite.
        by_input = np.pad(rows[:, n:], [(0, 0), (0, 1)])[:, column]
        with np.errstate(all="ignore"):
            derivatives: np.ndarray = rows[:, :n] @ table + by_input * np.append(r, 1.0)[weight]
        return derivatives

    @staticmethod
    def event_resolution(
        depth: float, slopes: np.ndarray, x: np.ndarray, rtol: np.ndarray, atol: np.ndarray
    ) -> tuple[float, str]:
        """Return the error of an event's expression due to tolerances, and the start of a remedy.

        The expression has these `slopes` by the states x, and the motion goes by `depth` beyond
        zero. The remedy names the tolerances to lower, unless none would resolve that depth.
        """
        by_atol = float(np.abs(slopes) @ atol)
        by_rtol = float(np.abs(slopes) @ (rtol * np.abs(x)))
        error = by_atol + by_rtol
        if not 0.0 < depth <= error:
            return error, "Omit"
        # Lowering one is enough if the contribution of the other is small.
        contributions = {"atol": (atol, by_atol, by_rtol), "rtol": (rtol, by_rtol, by_atol)}
        factors = {
            name: (tolerance, (depth - remaining) / part)
            for name, (tolerance, part, remaining) in contributions.items()
            if remaining < depth / 2.0
        } or {name: (tolerance, depth / error) for name, (tolerance, *_) in contributions.items()}
        if "rtol" in factors and np.max(rtol) * factors["rtol"][1] < ROUNDING:
            return error, "Omit"
        changes = [
            f"`{name}` from {np.max(tolerance):.2g} to less than {np.max(tolerance) * factor:.2g}"
            for name, (tolerance, factor) in factors.items()
        ]
        return error, f"If it is to cross there, lower {' and '.join(changes)}. Otherwise omit"

    @staticmethod
    def grazing_remedy(lower: str, records: Sequence[EventRecord], end: float) -> str:
        """Return the start of a remedy for the last of these events, which grazes; usually `lower`.

        If the same event happened before at ever shorter intervals, as the bounces of a ball that
        comes to rest, and these add up to less than the time that is left until `end`, a lower
        tolerance only resolves a few more of infinitely many.
        """
        times = [record.time for record in records if record.index == records[-1].index]
        intervals = np.abs(np.diff(times[-4:]))
        if len(intervals) < 3 or not (np.diff(intervals) < 0.0).all():
            return lower
        # At most, by the larger ratio: those of a periodic event differ by errors only, and add up
        # to very much.
        ratio = (intervals[1:] / intervals[:-1]).max()
        if not intervals[-1] * ratio / (1.0 - ratio) <= abs(end - times[-1]):
            return lower
        return (
            f"It is the number {len(times)} of these events, which follow each other at ever "
            "shorter intervals: where they accumulate (Zeno behaviour), no tolerance resolves all "
            "of them. Let `times` end before, make the event terminal, let its reset stop the "
            "motion as it stops in reality, or model a rebound by `pydy.contact.Contacts`, which "
            "continue with the derivatives of the limit. Or omit"
        )

    @staticmethod
    def bounding_tolerances(
        rtol: np.ndarray, atol: np.ndarray, start: np.ndarray, scales: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return tolerances of sensitivities that only bound the step, (n k,) and (..., n k).

        They follow from those of the states (n,), the states at the start (..., n) and the sizes of
        the parameters (..., k). A state that begins at zero with an absolute tolerance of zero has
        no known size: its sensitivities, which may be rounding errors, bound nothing.
        """
        k = scales.shape[-1]
        relative = np.minimum(BOUND * np.maximum(rtol, ROUNDING), np.maximum(rtol, BOUND_CAP))
        absolute = np.maximum(BOUND * atol, rtol * np.abs(start))
        absolute = np.where(absolute > 0.0, absolute, np.inf)[..., None] / scales[..., None, :]
        return np.repeat(relative, k), absolute.reshape(*start.shape[:-1], k * len(atol))


class ParameterSize(NamedTuple):
    """Where the size of a parameter comes from: the unit of the derivatives by it."""

    group: str  # 'x', 'r' or 'p': an initial condition, a specified or a constant
    position: int  # in that array
    columns: int = 1  # one, or the number of samples
    largest: float | None = None  # of the samples
    least: float = 1.0  # the least size of an initial condition

    @staticmethod
    def scales(
        parameters: Sequence[ParameterSize],
        x: np.ndarray,
        r: np.ndarray,
        p: np.ndarray,
        columns: int,
    ) -> np.ndarray:
        """Return the sizes of parameters, shape (..., columns), from arrays of shape (..., n).

        An initial condition has a least size, as it may be near zero at the start by chance: the
        error of a derivative by a speed of 1e-17 would not be controlled at all. Columns without a
        parameter have the size 1.
        """
        arrays = {"x": x, "r": r, "p": p}
        scales, column = np.ones((*x.shape[:-1], columns)), 0
        for parameter in parameters:
            sizes = np.abs(arrays[parameter.group][..., parameter.position])
            if parameter.largest is not None:
                sizes = np.full_like(sizes, parameter.largest)
            elif parameter.group == "x":
                sizes = np.maximum(sizes, parameter.least)
            sizes = np.where(sizes > 0.0, sizes, 1.0)
            scales[..., column : column + parameter.columns] = sizes[..., None]
            column += parameter.columns
        return scales
