"""OptimalTrajectory: the solution of an optimal control problem."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from pydy._axes import axes_of, rows_of_axes, typeset, units_by_name, with_unit
from pydy._checks import text
from pydy._forks import cached_property
from pydy._names import table_of, unique_names
from pydy._problem import Problem, TrajectoryModel, with_settings
from pydy.codegen import OfTime, one_format
from pydy.control.accuracy import objective_errors
from pydy.control.costates import costates_of
from pydy.control.ipopt import INFEASIBLE, Iteration, NlpSolution
from pydy.control.nlp import Nlp
from pydy.control.transcription import Transcription
from pydy.control.tuning import INPUT_SAMPLES, JUMP, PLOTTED
from pydy.inputs import SampledInput
from pydy.trajectory import Columns, Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from pydy._axes import Units
    from pydy._sympy_types import AnySymbol

_STUCK = (INFEASIBLE, 3, -1, -2, -3)  # statuses of a search that could make no more progress

# Times and values of a curve, and times and values of each of its limits.
_Curve: TypeAlias = tuple[np.ndarray, np.ndarray, list[tuple[np.ndarray, np.ndarray]]]


class OptimalTrajectory(Trajectory):
    """The solution of an optimal control problem: a motion, with its multipliers and errors.

    `OptimalControl.solve` and `System.optimize_trajectory` return it. It is a Trajectory at the
    nodes and collocation points of the mesh; between them, states and controls are the method's
    polynomials, of controls held within their bounds.

    Attributes
    ----------
    objective : float
    duration : float
        In s; the motion begins at t = 0.
    constants : dict
        All constants of the system, with the values that were found for free ones.
    controls : tuple of symbols
    mesh : ndarray, shape (M + 1,)
        Times of the nodes.
    error : ndarray, shape (M,)
        The error of each interval: how far a solver that starts at the interval's first state, with
        these controls, ends from its last one, relative to how large each state becomes.
    multipliers : dict of str to ndarray
        The multipliers of each equation, path condition and boundary condition, by the labels that
        messages use: at `collocation_times` or, of boundary conditions, shape (1,). They are the
        derivatives of the objective by the right-hand side of ``a − b = 0`` or ``a − b <= 0``.
        Those of constraints of 'midpoint' are at the nodes after the first, those of
        'hermite-simpson' at `collocation_times` after the start.
    collocation_times : ndarray
    status : int
        As IPOPT returns it; 0 is solved.
    message : str
    solution : Solution
        Unknowns and multipliers as IPOPT returns them.
    history : tuple of Iteration
        The iterations of IPOPT, with `number`, `objective`, `violation`, `dual_violation` and
        `barrier`.
    """

    _sizes: np.ndarray  # (n,), the size of each state in the guess

    def __init__(
        self,
        problem: Problem,
        transcription: Transcription,
        controls: Sequence[AnySymbol],
        free: Sequence[AnySymbol],
        nlp: Nlp,
        solution: NlpSolution,
        error: np.ndarray,
    ) -> None:
        z = solution.z
        duration = transcription.split(z)[3]
        slot_times, slopes = transcription.state_slots
        times = np.unique(slot_times[~slopes]) * duration
        self.duration = duration
        self.objective = solution.objective
        self.controls, self._free = tuple(controls), tuple(free)
        self._states = tuple(problem.definition.states)
        self.mesh = transcription.mesh * duration
        self.error = error
        self.status = solution.status
        self.message = why_in_vain(solution, ())
        self.history: tuple[Iteration, ...] = solution.history
        self.solution = solution
        self._nlp, self._transcription = nlp, transcription
        self.multipliers, self.collocation_times = _multipliers(nlp, solution, duration)
        solved = moving(problem, transcription, z, controls, free)
        model = TrajectoryModel(solved)
        states = transcription.states_at(z, times)
        super().__init__(
            times,
            states,
            Columns(solved.definition.symbols_by_kind),
            outputs=model.outputs(times, states),
            specifieds=model.specifieds(times, states),
            constants=solved.constants,
            statistics={"iterations": solution.iterations},
            model=model,
            dense=partial(transcription.states_at, z),
        )

    def __repr__(self) -> str:
        error = float(np.abs(self.objective_error).sum())
        near = f" ± {error:.1g}" if np.isfinite(error) else ""
        return f"Optimal{super().__repr__()}, objective {self.objective:.9g}{near}: {self.message}"

    @property
    def fractions(self) -> np.ndarray:
        """The nodes as fractions of the duration."""
        return self._transcription.mesh

    def is_on(self, transcription: Transcription) -> bool:
        """Return whether a transcription has the same unknowns and equations."""
        current = self._transcription
        same = current.scheme == transcription.scheme and np.array_equal(
            current.mesh, transcription.mesh
        )
        labels = [
            [group.labels for group in candidate.groups] for candidate in (current, transcription)
        ]
        return same and current.sizes == transcription.sizes and labels[0] == labels[1]

    def active(self, label: str) -> np.ndarray:
        """Return whether a path condition is active, at each of the times.

        By strict complementarity, it is active if its scaled multiplier is larger than its scaled
        distance from its bound.
        """
        nlp, z = self._nlp, self.solution.z
        rows = nlp.native("rows", z / nlp.sizes)[0] * nlp.row_sizes
        low, high = nlp.row_bounds
        away = np.minimum(np.abs(rows - low), np.abs(high - rows)) / nlp.row_sizes
        deciding = np.abs(self.solution.multipliers) * nlp.row_sizes / nlp.cost_size > away
        active = np.zeros(len(self.times), dtype=bool)
        for group, values in nlp.by_group(deciding):
            if group.collocated:
                at = np.searchsorted(self.times, group.fractions * self.duration)
                at = np.clip(at, 0, len(active) - 1)
                for row in [
                    v for v, name in zip(values, group.labels, strict=True) if name == label
                ]:
                    active[at] |= row
        return active

    @cached_property
    def objective_error(self) -> np.ndarray:
        """Each interval's share of the minimum minus this objective, shape (M,).

        An estimate, of second order, of the change that a finer mesh would bring. It has two
        contributions, both weighted by the multipliers: the violation of the equations between the
        collocation points, and the gain by better controls within their bounds there. Only the
        larger one is used, as they may not cancel: where controls jump or states reach bounds
        inside intervals, it is a bound rather than an estimate. Intervals that do not resolve the
        motion, such as boundary layers, are solved again on a finer mesh, four at most. NaN for
        systems with constraints under 'midpoint' and 'hermite-simpson'.
        """
        return objective_errors(self._transcription, self._nlp, self.solution)

    @property
    def costates(self) -> dict[AnySymbol, np.ndarray]:
        """Derivatives of the objective that remains at a node by each state there, shape (M + 1,).

        These are the adjoint variables of Pontryagin's principle for ``H = L + costates · rates``
        with the integrand L that is minimised, and the gradient of the value function. They are
        exact for the discretised problem: at the start they equal the objective's derivatives by
        the values of `start`, to rounding.

        Raises
        ------
        NotImplementedError
            The system has constraints and the method is 'hermite-simpson', whose constraints at
            nodes belong to two intervals.
        """
        transcription = self._transcription
        if (
            transcription.scheme.name == "hermite-simpson"
            and transcription.problem.equations.constraints
        ):
            raise NotImplementedError(
                "The method 'hermite-simpson' has no costates of systems with constraints: "
                "these belong, at nodes, to the intervals on both sides. Use 'radau'."
            )
        first, last = costates_of(transcription, self._nlp, self.solution)
        return dict(zip(self._states, np.append(first, last[:, -1:], axis=1), strict=True))

    def summary(self) -> str:
        """Return the result as a table of text.

        Returns
        -------
        str
            How the search ended; objective with its estimated error, and duration; free constants;
            each state and control at the start, at the end, and between; and the errors of the
            mesh.
        """
        off = float(np.abs(self.objective_error).sum())
        z, transcription = self.solution.z, self._transcription
        values = np.column_stack([self.states, transcription.controls_at(z, self.times)])
        values[0, self.states.shape[1] :] = transcription.controls_in(
            z, np.zeros(1, int), np.zeros(1)
        )
        names = unique_names([*self._states, *self.controls])
        rows = [
            (name, *(f"{v:.6g}" for v in (column[0], column[-1], column.min(), column.max())))
            for name, column in zip(names, values.T, strict=True)
        ]
        constants = [(str(s), f"{self.constants[s]:.8g}") for s in self._free]
        return "\n".join([
            f"Optimal trajectory: {self.message} after {self.solution.iterations} iterations, "
            f"{transcription.scheme.name} on {transcription.intervals} intervals",
            "",
            f"objective  {self.objective:.9g}" + (f" ± {off:.1g}" if np.isfinite(off) else ""),
            f"duration   {self.duration:.9g} s",
            *(["", *table_of(("constant", "value"), constants)] if constants else []),
            "",
            *table_of(("quantity", "start", "end", "least", "largest"), rows),
            "",
            f"errors of intervals, relative to the states: {self.error.max():.2g} at most, "
            f"{self.error.sum():.2g} in all",
        ])  # fmt: skip

    def plot_controls(
        self,
        axes: Axes | Sequence[Axes] | None = None,
        *,
        units: Units = None,
        time_unit: str = "",
    ) -> Axes | Sequence[Axes]:
        """Plot the controls over time, dashed their bounds, and the nodes; return the Axes.

        Parameters
        ----------
        axes : Axes or sequence of Axes, optional
            One for each control.
        units, time_unit
            As for `pydy.plot.plot_coordinates`.
        """
        if not self.controls:
            raise ValueError("The motion has no controls to plot.")
        curves, inputs = [], self.inputs()
        for symbol, sides in zip(
            self.controls, self._transcription.problem.control_bounds, strict=True
        ):
            times = inputs[symbol].breaks
            limits = [(times, side(times / self.duration)) for side in sides]
            curves.append((times, inputs[symbol].rows(times)[:, 0], limits))
        return self._plotted(axes, self.controls, curves, units, time_unit)

    def plot_states(
        self,
        axes: Axes | Sequence[Axes] | None = None,
        *,
        units: Units = None,
        time_unit: str = "",
    ) -> Axes | Sequence[Axes]:
        """Plot the states over time, dashed their bounds, and the nodes; return the Axes.

        Parameters
        ----------
        axes : Axes or sequence of Axes, optional
            One for each state.
        units, time_unit
            As for `pydy.plot.plot_coordinates`.
        """
        transcription = self._transcription
        slot_times, slopes = transcription.state_slots
        inner = ~slopes & (slot_times > 0.0) & (slot_times < 1.0)  # `start` and `end` are no bounds
        slots = np.flatnonzero(inner)[np.argsort(slot_times[inner], kind="stable")]
        sides = [
            transcription.split(side)[0][:, slots] for side in (self._nlp.lower, self._nlp.upper)
        ]
        times = np.linspace(0.0, self.duration, num=PLOTTED * transcription.intervals + 1)
        at = slot_times[slots] * self.duration
        values = transcription.states_at(self.solution.z, times).T
        rows = zip(values, *sides, strict=True)
        curves = [(times, row, [(at, low), (at, high)]) for row, low, high in rows]
        return self._plotted(axes, self._states, curves, units, time_unit)

    def _plotted(
        self,
        axes: Axes | Sequence[Axes] | None,
        symbols: Sequence[AnySymbol],
        curves: Sequence[_Curve],
        units: Units,
        time_unit: str,
    ) -> Axes | Sequence[Axes]:
        """Plot times and values with their limits, each in its Axes."""
        names = unique_names(symbols)
        by_name = units_by_name(units, unique_names(self._states))
        time_label = with_unit("time", text(time_unit, "`time_unit`"))
        axes, rows = rows_of_axes(axes, len(names), f"of {', '.join(names)}")
        for ax, name, (times, values, limits) in zip(rows, names, curves, strict=True):
            unit, factor = by_name.get(name, ("", 1.0))
            ax.plot(times, factor * values)
            for at, limit in limits:
                if len(limit) and np.isfinite(limit).all():
                    ax.plot(at, factor * limit, "--", color="0.5", linewidth=0.8)
            ax.plot(self.mesh, np.zeros_like(self.mesh), "|", color="0.6",
                    transform=ax.get_xaxis_transform())  # fmt: skip
            ax.set_xlabel(time_label)
            ax.set_ylabel(with_unit(typeset(name, ""), unit))
        return axes

    def plot_error(self, ax: Axes | None = None) -> Axes:
        """Plot the error of each interval over time; return the Axes."""
        ax = axes_of(ax, "a plot")
        ax.stairs(self.error, self.mesh, baseline=None)
        if (self.error > 0.0).any():
            ax.set_yscale("log")
        ax.set_xlabel("time")
        ax.set_ylabel("error of the interval")
        return ax

    def plot_sparsity(self, ax: Axes | None = None) -> Axes:
        """Plot where the Jacobian of the equations by the unknowns is not zero; return the Axes."""
        ax = axes_of(ax, "a plot")
        rows, columns = self._nlp.jacobian_at
        ax.plot(columns, rows, "s", markersize=1)
        ax.set_xlim(-1, self._nlp.size)
        ax.set_ylim(self._nlp.rows, -1)
        ax.set_xlabel("unknowns")
        ax.set_ylabel("equations")
        return ax

    def inputs(self) -> dict[AnySymbol, SampledInput]:
        """Return the controls as `pydy.inputs.SampledInput`, for `System.specifieds`.

        Simulate with them to see how far the motion is from one of the real equations. The
        control's polynomial on each interval is sampled; where it jumps at a node, the samples lie
        on both sides.

        Returns
        -------
        dict
            From each control's symbol to its samples.
        """
        # The slope of pchip at a jump belongs to neither side: add a sample close to it.
        s = np.linspace(0.0, 1.0 - JUMP, num=INPUT_SAMPLES)
        s = np.insert(s, [1, -1], [JUMP, 1.0 - 2 * JUMP])
        lengths = np.diff(self.mesh)
        times = np.append((self.mesh[:-1, None] + lengths[:, None] * s).ravel(), self.mesh[-1])
        k = np.append(np.repeat(np.arange(len(lengths)), len(s)), len(lengths) - 1)
        at = np.append(np.tile(s, len(lengths)), 1.0)
        values = self._transcription.controls_in(self.solution.z, k, at)
        return {
            symbol: SampledInput(times, values[:, k], "pchip")
            for k, symbol in enumerate(self.controls)
        }


@dataclass(frozen=True, eq=False)
class _Controls(OfTime):
    """The controls as a function of time."""

    transcription: Transcription
    z: np.ndarray

    def values_at(self, times: np.ndarray) -> np.ndarray:
        """Return the controls at m times, constant before and after the motion."""
        duration = self.transcription.split(self.z)[3]
        return self.transcription.controls_at(self.z, np.clip(times, 0.0, duration))


def moving(
    problem: Problem,
    transcription: Transcription,
    z: np.ndarray,
    controls: Sequence[AnySymbol],
    free: Sequence[AnySymbol],
) -> Problem:
    """Return a System's snapshot with the controls and constants of a solution."""
    constants = transcription.split(z)[2][: len(free)]
    specifieds, _ = one_format(problem.settings.specifieds, "specifieds")
    if controls:
        specifieds = {**specifieds, tuple(controls): _Controls(transcription, z)}
    values = problem.constants | dict(zip(free, constants.tolist(), strict=True))
    return with_settings(problem, specifieds=specifieds, constants=values)


def _multipliers(
    nlp: Nlp, solution: NlpSolution, duration: float
) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """Return the multipliers by label, in the order of time, and the times."""
    parts: dict[str, list[np.ndarray]] = {}
    when: dict[str, list[np.ndarray]] = {}
    fractions: list[np.ndarray] = []
    for group, values in nlp.by_group(-solution.multipliers):
        # A condition with kinks has several consecutive rows; its multiplier is their sum.
        first = [k for k, s in enumerate(group.labels) if not k or s != group.labels[k - 1]]
        values = np.add.reduceat(values, first) if first else values
        names = unique_names([group.labels[k] for k in first])
        for name, row in zip(names, values, strict=True):
            parts.setdefault(name, []).append(row)
            when.setdefault(name, []).append(group.fractions)
        if group.collocated:
            fractions.append(group.fractions)
    multipliers = {}
    for name, rows in parts.items():
        order = np.argsort(np.concatenate(when[name]), kind="stable")
        multipliers[name] = np.concatenate(rows)[order]
    return multipliers, np.sort(np.concatenate(fractions)) * duration


def why_in_vain(
    solution: NlpSolution,
    parts: Sequence[tuple[Transcription, Nlp, np.ndarray, Sequence[AnySymbol]]],
) -> str:
    """Explain why a search failed: IPOPT's message, and controls without effect at the guess.

    A control may have no effect to first order at the guess, as u = 0 where u² is a force. The
    search then has no direction for it, although the problem is feasible.
    """
    names = [f"`{symbol}`" for part in parts for symbol in _stationary(*part)]
    if not names or solution.status not in _STUCK:
        return solution.message
    reason = (
        f"at the guess all derivatives of the equations by {', '.join(names)} are zero, so that "
        "the search has no direction in which to change a control. Give a `guess` where they are "
        "not"
    )
    return reason if solution.status == INFEASIBLE else f"{solution.message}; {reason}"


def _stationary(
    transcription: Transcription, nlp: Nlp, start: np.ndarray, controls: Sequence[AnySymbol]
) -> list[AnySymbol]:
    J, columns = nlp.native("jacobian", start / nlp.sizes)[0], nlp.jacobian_at[1]
    first, count, stationary = transcription.sizes[0], len(transcription.control_times), []
    for k, symbol in enumerate(controls):
        entries = (columns >= first + k * count) & (columns < first + (k + 1) * count)
        if entries.any() and not J[entries].any():
            stationary.append(symbol)
    return stationary


def worst_rows(nlp: Nlp, solution: NlpSolution, duration: float) -> str:
    """Name the equations that are violated most, in units of their sizes."""
    y = solution.z / nlp.sizes
    values = nlp.native("rows", y)[0]
    if not all(np.isfinite(nlp.native(name, y)[0]).all() for name in ("cost", "gradient")):
        return (
            "The objective or its derivatives are not finite there: begin elsewhere, with another "
            "`guess`, or keep away from such values with `bounds`."
        )
    low, high = (side / nlp.row_sizes for side in nlp.row_bounds)
    violated = np.nan_to_num(np.maximum(np.maximum(low - values, values - high), 0.0), nan=np.inf)
    violations = []
    for group, parts in nlp.by_group(violated):
        for label, part in zip(group.labels, parts, strict=True):
            at = int(part.argmax())
            when = group.fractions[at] * duration
            time_text = "" if np.isnan(when) else f" at t = {when:.6g}"
            violations.append((float(part[at]), f"{label}{time_text}, by {part[at]:.2g}"))
    violations.sort(key=lambda pair: -pair[0])
    return (
        "Violated most, in units of each equation's size: "
        + "; ".join(text for _, text in violations[:3])
        + ". Another `guess`, wider `bounds` or a finer `mesh` may help."
    )
