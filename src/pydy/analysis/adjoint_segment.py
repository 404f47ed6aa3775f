"""The adjoint of an objective, integrated back through the recorded steps of a motion."""

from __future__ import annotations

import numpy as np

from pydy._errors import warn_user
from pydy._integration import GradientEquations, RecordedMotion, by_samples
from pydy._optional import progress_of
from pydy._rank import HALF
from pydy.trajectory import EventRecord


class AdjointSegment:
    """The adjoint of a segment of a motion: of one mode, between two transitions.

    The adjoint λ is the derivative of the objective by the states of the `recorded` steps. It
    starts at the end of the motion (`finish`) and is integrated back (`back`); a transition passes
    it on to the earlier segment (`back_through_transition`).
    """

    def __init__(self, recorded: RecordedMotion) -> None:
        steps, equations = recorded.steps, recorded.equations
        n = recorded.motion.states.shape[1]
        integrals = 0 if equations.integral is None else 1
        self.recorded, self._n = recorded, n
        self.value = float(steps.end_state[n : n + integrals].sum())  # of the objective
        self._by_inputs = ParameterDerivatives(equations)
        self._adjoint = np.zeros(len(steps.end_state))
        self._adjoint[n : n + integrals] = 1.0
        self._slope = 0.0  # of the objective along the motion at its end
        self._followed = False  # True if another segment continues the motion

    def finish(self, weights: np.ndarray | None = None, end_varies: bool = True) -> None:
        """Start the adjoint from the terms at the end: `final`, or Σ weight · last state.

        `end_varies` is True if the time of an event that ends the motion depends on the parameters.
        """
        equations, steps, n = self.recorded.equations, self.recorded.steps, self._n
        self._followed = not end_varies
        if weights is not None:
            self._adjoint[:n] = weights
        if equations.final is None:
            return
        call = equations.objective()
        value_and_gradient = call.evaluate(call.kernel, steps.end_state, steps.end)
        self.value += float(value_and_gradient[0])
        s = len(call.inputs.values)
        by_state, by_time = value_and_gradient[1 : 1 + n], float(value_and_gradient[1 + n])
        by_input = value_and_gradient[2 + n : 2 + n + s]
        self._adjoint[:n] = by_state
        self._add(value_and_gradient[2 + n + s :], steps.end)
        self._slope = by_time + float(by_input @ call.inputs.slopes(steps.end))

    def _add(self, derivatives: np.ndarray, t: float) -> None:
        """Add the derivatives by the inputs `wrt` due to one instant."""
        self._by_inputs.add(derivatives, np.array([t]), derivatives[None])

    def gradient(self, initial: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Integrate the adjoint back; return the derivatives by parameters and by the first state.

        `initial` (n, k) contains the derivatives of the first state by the parameters.
        """
        by_state = self.back()
        return self.by_parameters(by_state @ initial), by_state

    def back(self) -> np.ndarray:
        """Integrate the adjoint back to the start; return the derivatives by the first state."""
        recorded = self.recorded
        count = len(recorded.steps.starts)
        with progress_of(recorded.options.progress, " steps back", count) as self._progress:
            by_state = self._all_back()
        if recorded.unlimited:
            warn_user(
                "The steps of this gradient follow from the errors of the states alone. With "
                f"derivatives beside them {recorded.unlimited}. If the gradient depends on a "
                "direction that the motion does not excite, compare it with "
                "`simulate(sensitivities=...)`."
            )
        return by_state

    def back_through_transition(
        self, matrix: np.ndarray, time: np.ndarray, earlier: AdjointSegment | None = None
    ) -> np.ndarray:
        """Apply the adjoint of the transition before this segment; return the state derivatives.

        `matrix` (n, n + w) contains the derivatives of the state after the transition by the state
        before it, then by the inputs `wrt`, at a fixed time. `time` (n + w,) contains those of the
        transition's time, NaN if unknown. The sums so far are passed on to the `earlier` segment.
        """
        recorded, n = self.recorded, self._n
        t = float(recorded.motion.times[0])
        derivatives = self._adjoint[:n] @ matrix
        if earlier is not None:
            steps, first = earlier.recorded.steps, recorded.motion.problem.x
            before = earlier.recorded.rates(steps.end_state, t)
            jump = (before - recorded.rates(first, t))[n:]
            if (slope := float(self._adjoint[n:] @ jump)) and np.isnan(time).any():
                starts = zip(steps.states, steps.starts, strict=True)
                sizes = [np.abs(earlier.recorded.rates(x, t)[n:]).max() for x, t in starts]
                if not abs(slope) <= HALF * max(sizes, default=0.0):
                    raise NotImplementedError(
                        f"`integral` jumps at t = {t!r}, where a body comes to rest in a plane: "
                        "how that time depends on parameters is not known. Integrate what is "
                        "continuous there."
                    )
                slope = 0.0
            derivatives = derivatives + (slope * time if slope else 0.0)
            earlier._adjoint[:n] = derivatives[:n]
            earlier._by_inputs, earlier._followed = self._by_inputs, True
        self._add(derivatives[n:], t)
        by_state: np.ndarray = derivatives[:n]
        return by_state

    def _all_back(self) -> np.ndarray:
        recorded, steps, events = self.recorded, self.recorded.steps, self.recorded.options.events
        if steps.stopped and not self._followed:
            self._slope += float(self._adjoint @ recorded.rates(steps.end_state, steps.end))
        acting: list[tuple[EventRecord, bool]] = []  # with whether it ends the motion
        if events is not None and not self._followed:
            traits = [(r, events.traits[r.index]) for r in steps.events]
            acting = [(record, event.terminal) for record, event in traits if event.acts]
        last, end = len(steps.starts), steps.end_state
        for record, terminal in reversed(acting):
            first = int(np.searchsorted(steps.ends, record.time, side="right"))
            if first == 0 or (first == len(steps.ends) and not steps.stopped):
                continue  # at the very start or end, where an event is recorded only
            self._steps_back(first, last, end)
            last, end = first, record.before
            self._jump(record, self._slope if terminal else 0.0)
            self._slope = 0.0 if terminal else self._slope
        self._steps_back(0, last, end)
        return self._adjoint[: self._n].copy()

    def _steps_back(self, first: int, last: int, end: np.ndarray) -> None:
        """Integrate the adjoint from the end of step `last` − 1 to the start of step `first`.

        `end` is the state at the end of step `last` − 1.
        """
        if first == last:
            return
        recorded, steps, n, sweeps = self.recorded, self.recorded.steps, self._n, [(first, last)]
        projections = None
        if recorded.options.constraints is not None:
            sweeps = [(k, k + 1) for k in range(first, last)]
            ends = np.vstack([steps.states[first + 1 : last, :n], end[:n]])
            projections = recorded.projections(steps.ends[first:last], ends)
        for k, (start, stop) in reversed(list(enumerate(sweeps))):
            if projections is not None:
                self._adjoint[:n] = projections.back(k, self._adjoint[:n])
            sweep = recorded.discrete_adjoint.sweep_back(
                steps, slice(start, stop), self._adjoint, self._progress
            )
            if not np.isfinite(sweep.adjoint).all():
                begin, past = float(steps.starts[start]), float(steps.ends[stop - 1])
                raise ValueError(
                    "The derivatives of the equations are not finite between t = "
                    f"{begin!r} and t = {past!r}, though the motion is: look there for the square "
                    "root of zero, or another function without a derivative. "
                    "`system.evaluate_jacobian` tells which."
                )
            self._adjoint = sweep.adjoint
            self._by_inputs.add(sweep.totals, sweep.times, sweep.stagewise)
        if projections is not None:
            self._by_inputs.add(*projections.totals())

    def _jump(self, record: EventRecord, slope: float) -> None:
        """Apply the adjoint of an event.

        With the adjoint λ after it, the event time t_e changes the objective by λ · (Ṙ − f⁺) and,
        if the motion ends there, by the objective's `slope`; dt_e/dθ = −(g_x S + g_θ) / ġ.
        """
        recorded, n, t = self.recorded, self._n, record.time
        x, adjoint = record.before, self._adjoint[:n].copy()
        blocks, changed, time = recorded.event_derivatives(record)
        changed_states = [*changed]
        if changed and recorded.options.constraints is not None:  # the projection after it
            projections = recorded.projections(np.array([t]), record.after[None])
            adjoint = projections.back(0, adjoint)
            self._by_inputs.add(*projections.totals())
        time_slope = slope
        if time.any():
            before, after = recorded.rates(x, t), recorded.rates(record.after, t)
            time_slope += float(adjoint @ (blocks["after_rates"] - after[:n]))
            time_slope += float(self._adjoint[n:] @ (before - after)[n:])
        derivatives = adjoint[changed_states] @ blocks["after"] + time_slope * time
        adjoint[changed_states] = 0.0
        self._adjoint[:n] = adjoint + derivatives[:n]
        self._add(derivatives[n:], t)

    def by_parameters(self, initial: np.ndarray) -> np.ndarray:
        """Return the derivatives by all parameters.

        `initial` contains the contributions of the initial state.
        """
        return self._by_inputs.values(initial)


class ParameterDerivatives:
    """The derivatives of an objective by all parameters, added up while its adjoint goes back."""

    def __init__(self, equations: GradientEquations) -> None:
        self._equations = equations
        self._totals = np.zeros(len(equations.wrt))
        # Times (m,) and derivatives (m, j) by the sampled inputs at these times.
        self._by_time: list[tuple[np.ndarray, np.ndarray]] = []

    def add(self, totals: np.ndarray, times: np.ndarray, by_time: np.ndarray) -> None:
        """Add derivatives by the inputs `wrt`: their totals, and those at each time.

        The last columns of `by_time`, shape (m, …), are those of the sampled inputs.
        """
        self._totals += totals
        if sampled := len(self._equations.sampled):
            self._by_time.append((times, by_time[:, by_time.shape[1] - sampled :]))

    def values(self, initial: np.ndarray) -> np.ndarray:
        """Return the sums, shape (k,), with the contributions of the initial state added."""
        equations = self._equations
        index_of = {slot: k for k, slot in enumerate(equations.wrt)}
        sampled = {p.symbol: k for k, p in enumerate(equations.sampled)}
        derivatives: list[float] = []
        for parameter in equations.augmented.parameters:
            if parameter.kind == "states":
                derivatives.append(0.0)
            elif parameter.samples is None:
                group = "p" if parameter.kind == "constants" else "r"
                derivatives.append(float(self._totals[index_of[group, parameter.index]]))
            else:
                weights, total = by_samples(parameter), np.zeros(parameter.count)
                for times, slopes in self._by_time:
                    total += slopes[:, sampled[parameter.symbol]] @ weights.rows(times)
                derivatives += total.tolist()
        values: np.ndarray = initial + np.array(derivatives)
        return values
