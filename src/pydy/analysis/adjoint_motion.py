"""Motions with recorded steps, and the adjoint that is integrated back through these steps."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np

from pydy._assembly import Assembly, CompiledModel, stored_program
from pydy._errors import (
    IntegrationError,
    IntegrationInterrupted,
    SingularMatrixError,
    warn_user,
)
from pydy._forks import cached_property
from pydy._graph import SensitivityDirection, derivative_program, simplify
from pydy._integration import (
    AugmentedSystem,
    Parameter,
    by_samples,
    columns_of,
    compiled_event,
    compiled_sensitivities,
    explain_failure,
    least_sizes,
    marker,
    motion_so_far,
    with_step_limit,
)
from pydy._judges import judge_motion, node_of
from pydy._kernel import Inputs, Kernel, KernelCall
from pydy._motion import Integrator, Motion, PreparedIntegration, Segment, with_all
from pydy._optional import progress_of
from pydy._problem import Problem, TrajectoryModel
from pydy._program import Program
from pydy._rank import DEPENDENT, HALF, is_zero, or_one
from pydy.inputs import SampledInput
from pydy.solvers import (
    CompiledConstraints,
    CompiledSensitivities,
    Outcome,
    ParameterSize,
    Solver,
    read_options,
)
from pydy.trajectory import EventRecord

if TYPE_CHECKING:
    from pydy._sympy_types import Expression
    from pydy.trajectory import Trajectory


def with_integral_and_marker(
    term: int | Expression | None, marked: bool, assembly: Assembly
) -> Assembly:
    """Return the equations with the integral and the sample marker appended to the states."""
    n, s, c = assembly.sizes
    extra_rates = [] if term is None else [node_of(assembly, term, "`integral`")]
    if marked:
        extra_rates.append(assembly.graph.input("r", s))
    return replace(
        assembly, sizes=(n + len(extra_rates), s + marked, c), rates=[*assembly.rates, *extra_rates]
    )


class Projections:
    """The constraint projections at the ends of some steps, and their adjoints.

    A projection changes sensitivities S by −K (c_x S + c_θ), where c are the residuals and K is the
    minimum-norm correction, first for positions and then for velocities. Before the projection, an
    adjoint λ is therefore λ − c_xᵀ Kᵀ λ, and the derivatives with respect to θ gain −(Kᵀ λ) · c_θ.

    `wrt` lists the inputs to differentiate with respect to. `call` takes a Kernel and the number of
    inputs that follow r, and returns the Kernel's call. The m `states` are those after projection.
    """

    def __init__(
        self,
        model: CompiledModel,
        constraints: CompiledConstraints,
        wrt: tuple[tuple[str, int], ...],
        call: Callable[[Kernel, int], KernelCall],
        times: np.ndarray,
        states: np.ndarray,
    ) -> None:
        self.times, self._x, self._wrt, self._model = times, states, wrt, model
        self._constraints = constraints
        constraint_call = call(constraints.kernel, 0)
        self._r = constraint_call.inputs.rows(states, times)
        self._p = constraint_call.p
        out = model.evaluate(constraints.kernel, times, states, self._r, self._p)
        self._parts = constraints.kernel.program.signature.by_block(out)
        (h, v, q, _), n = constraints.sizes, states.shape[1]
        self._gradient = self._parts["gradient"].reshape(len(times), h, q)
        if any(model.assembly.following):  # their corrections are not along the gradient
            by_state = model.compiled_jacobian("holonomic", "x")
            jacobian = model.evaluate(by_state, times, states, self._r, self._p)
            self._gradient = jacobian.reshape(len(times), h, n)
        self._slopes = np.zeros((len(times), v, n))
        if v:
            by_state = model.compiled_jacobian("velocity", "x")
            jacobian = model.evaluate(by_state, times, states, self._r, self._p)
            self._slopes = jacobian.reshape(len(times), v, n)
        self._multipliers = np.zeros((len(times), h + v))

    def back(self, k: int, adjoint: np.ndarray) -> np.ndarray:
        """Return the adjoint of the state before projection k, from that after it."""
        constraints = self._constraints
        h, v, q, u = constraints.sizes
        part = {name: values[k] for name, values in self._parts.items()}
        inverse = np.eye(u)
        if constraints.weighted:
            inverse = _inverse_factor(part["kinetic_hessian"].reshape(u, u))
        adjoint = adjoint.copy()
        multipliers = self._multipliers[k]
        if v:
            rows = part["velocity_gradient"].reshape(v, u) @ inverse
            multipliers[h:] = (inverse @ _pseudoinverse(rows)).T @ adjoint[q : q + u]
            adjoint -= multipliers[h:] @ self._slopes[k]
        if h:
            gradient = part["gradient"].reshape(h, q)
            reach = part["kinematics"].reshape(q, u) @ inverse
            terms = np.linalg.norm(np.abs(gradient) @ np.abs(reach), axis=1)
            moving = gradient @ reach
            moving[is_zero(np.linalg.norm(moving, axis=1), terms)] = 0.0
            correction = reach @ _pseudoinverse(moving)
            # Constraints that no speed can correct.
            correction = correction + _pseudoinverse(gradient) @ (np.eye(h) - gradient @ correction)
            multipliers[:h] = correction.T @ adjoint[:q]
            slopes = self._gradient[k]
            adjoint[: slopes.shape[1]] -= multipliers[:h] @ slopes
        return adjoint

    def totals(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the derivatives by the parameters: their sum (w,) and those per time (m, w)."""
        model, wrt = self._model, self._wrt
        if not wrt:
            return np.zeros(0), np.zeros((len(self.times), 0))
        assembly = model.assembly

        def make() -> Program:
            fork = assembly.fork()
            nodes = simplify(fork.graph, [*fork.holonomic, *fork.velocity])
            return derivative_program(fork.graph, nodes, wrt, "vector-jacobian", fork.sizes)

        kernel = model.compiled_by(("adjoint of the constraints", wrt), make)
        rows = np.broadcast_to(self._r, (len(self.times), self._r.shape[1]))
        r = np.concatenate([rows, -self._multipliers], axis=1)
        per_time = model.evaluate(kernel, self.times, self._x, r, self._p)
        total: np.ndarray = per_time.sum(axis=0)
        return total, per_time


def _inverse_factor(matrix: np.ndarray) -> np.ndarray:
    """Return L⁻ᵀ of the Cholesky factor L, or the identity if there is none, as projections do."""
    try:
        factor = np.linalg.cholesky(matrix)
    except np.linalg.LinAlgError:
        return np.eye(len(matrix))
    rounding = 4.0 * len(matrix) * np.finfo(float).eps
    if not (np.diag(factor) ** 2 > rounding * np.diag(matrix)).all():
        return np.eye(len(matrix))
    return np.linalg.inv(factor).T


def _pseudoinverse(rows: np.ndarray) -> np.ndarray:
    """Return the pseudoinverse of some rows, which ignores their linearly dependent directions."""
    lengths = or_one(np.linalg.norm(rows, axis=1))
    solution: np.ndarray = np.linalg.pinv(rows / lengths[:, None], rcond=DEPENDENT) / lengths
    return solution


InputSlot = tuple[str, int]


@dataclass(frozen=True, eq=False)
class Task:
    """The equations, objective and parameters of one gradient."""

    sensitive: AugmentedSystem  # its model has the system's states only
    final: int | Expression | None  # the position of an output, an expression, or None
    integral: int | Expression | None

    @cached_property
    def full_model(self) -> CompiledModel:
        """The equations with the integral and the sample marker appended to the states."""
        marked = self.marker is not None
        model = self.sensitive.model
        if self.integral is None and not marked:
            return model
        return model.variant(
            ("integral", self.integral, marked),
            partial(with_integral_and_marker, self.integral, marked),
        )

    @cached_property
    def marker(self) -> SampledInput | None:
        """See `samples.marker`."""
        return marker(self.sensitive.parameters)

    @property
    def _unsampled(self) -> list[Parameter]:
        return [p for p in self.sensitive.parameters if p.kind != "states" and p.samples is None]

    @cached_property
    def sampled(self) -> list[Parameter]:
        """The parameters that are samples."""
        return [p for p in self.sensitive.parameters if p.samples is not None]

    @cached_property
    def wrt(self) -> tuple[InputSlot, ...]:
        """The inputs to differentiate with respect to; sampled specifieds come last."""
        groups = {"constants": "p", "specifieds": "r"}
        return tuple((groups[p.kind], p.index) for p in (*self._unsampled, *self.sampled))

    def call_full(self, kernel: Kernel, further: int = 0) -> KernelCall:
        """Return the call of a Kernel of `full_model`, with `further` inputs after r."""
        if self.marker is None:
            return self.call(kernel, further)
        call = self.call(kernel, further + 1)
        marker_index = np.array([len(self.sensitive.inputs.values)])
        sampled = (*call.inputs.sampled, (marker_index, self.marker))
        return replace(call, inputs=replace(call.inputs, sampled=sampled))

    def call(self, kernel: Kernel, further: int = 0) -> KernelCall:
        """Return the call of a Kernel, with `further` inputs after r."""
        inputs, states = self.sensitive.inputs, self.sensitive.definition.states
        r = np.concatenate([inputs.values, np.zeros(further)])

        def names() -> tuple[str, ...]:
            return (*map(str, states), "the integral")

        return KernelCall(kernel, self.sensitive.p, Inputs(r, inputs.sampled), names)

    # -- compiled ---------------------------------------------------------------------------------

    def with_sensitivities(
        self, full_state: np.ndarray, columns: np.ndarray, options: dict[str, object]
    ) -> tuple[KernelCall, np.ndarray, CompiledSensitivities]:
        """Return the equations with columns of sensitivities, and the solver's options for them.

        The `columns` (n, n + w) are derivatives by states, then by the inputs `wrt`. Where they
        vary faster than the states, their errors determine the step size.
        """
        sensitive = self.sensitive
        states = [Parameter(s, "states", k) for k, s in enumerate(sensitive.definition.states)]
        inputs = [replace(p, samples=None) for p in (*self._unsampled, *self.sampled)]
        moving = [k for k, p in enumerate([*states, *inputs]) if p in inputs or columns[:, k].any()]
        parameters = tuple([*states, *inputs][k] for k in moving)
        augmented = replace(
            sensitive,
            model=self.full_model,
            parameters=parameters,
            columns=columns_of(parameters, sensitive.definition, states=len(full_state)),
        )
        compiled = compiled_sensitivities(augmented, full_state, options, controlled=True)
        values = np.zeros((len(full_state), len(moving)))
        values[: len(states)] = columns[:, moving]
        call = self.call_full(augmented.kernel())
        return call, augmented.columns.together(full_state, values), compiled

    def with_generic_direction(
        self, full_state: np.ndarray, options: dict[str, object]
    ) -> tuple[KernelCall, np.ndarray, CompiledSensitivities]:
        """Return the equations with one column of sensitivities, and the solver's options for it.

        The column is the derivative along a generic direction in the space of all initial
        conditions and the inputs `wrt`, each scaled by its size. Its error limits the step size:
        it contains modes that the motion itself does not excite but that the gradient depends on.
        """
        model, width = self.full_model, len(full_state)
        direction = SensitivityDirection(width, self.wrt)
        call = self.call_full(direction_kernel(model, direction))
        sized = [
            ParameterSize("x", k, least=s)
            for k, s in enumerate(least_sizes(options, width).tolist())
        ]
        sized += [
            parameter.sized._replace(columns=1) for parameter in (*self._unsampled, *self.sampled)
        ]
        sensitive, r = self.sensitive, self.sensitive.inputs.values
        sizes = ParameterSize.scales(sized, full_state, r, sensitive.p, len(sized))
        parts = sizes * generic_direction(len(sized))
        column, weights = parts[:width], parts[width:]
        column[sensitive.columns.states :] = 0.0  # integrals start at zero
        with_constraints = with_all(model, sensitive.definition)
        compiled = CompiledSensitivities(
            width, _OF_NO_INPUT, np.ones(1), full_state, False, _of_no_event,
            lambda: direction_kernel(with_constraints, direction, "holonomic", "velocity"),
        )  # fmt: skip
        r = np.concatenate([call.inputs.values, weights])
        call = replace(call, inputs=replace(call.inputs, values=r))
        return call, np.append(full_state, column), compiled

    def rates_vjp(self) -> KernelCall:
        """Return the vector-Jacobian product Σ weight · rate; see `DiscreteAdjoint`."""
        model = self.full_model
        assembly = model.assembly
        n = assembly.sizes[0]
        inputs = [*(("x", k) for k in range(n)), *self.wrt]

        def make() -> Program:
            graph, rates = assembly.simplified("rates")
            return derivative_program(graph, rates, inputs, "vector-jacobian", assembly.sizes)

        key = ("adjoint of the rates", self.wrt)
        return self.call_full(model.compiled_by(key, make), n)

    def objective(self) -> KernelCall:
        """Return `final` and its gradient by states, time, specifieds and parameters."""
        model = self.sensitive.model
        assembly = model.assembly
        n, s, _ = assembly.sizes
        nonstate_inputs = [("t", 0), *(("r", k) for k in range(s)), *self.wrt]
        inputs = [*(("x", k) for k in range(n)), *nonstate_inputs]

        def make() -> Program:
            fork = assembly.fork()
            nodes = simplify(fork.graph, [node_of(fork, self.final, "`final`")])
            return derivative_program(fork.graph, nodes, inputs, "gradient", fork.sizes)

        key = ("gradient at the end", self.final, self.wrt)
        return self.call(model.compiled_by(key, make))


_OF_NO_INPUT = np.array([[-1, -1]])


def _of_no_event(event: int) -> NoReturn:
    raise AssertionError("The derivatives that limit step sizes have no jumps at events.")


def generic_direction(count: int) -> np.ndarray:
    """Return the components of a fixed generic direction, of magnitude 1/2 to 1 and both signs.

    Modes of symmetric systems are sums and differences of states. Multiples of the golden ratio
    modulo 1 are evenly distributed, so few components are nearly equal.
    """
    parts = np.arange(1.0, count + 1.0) * 0.5 * (5.0**0.5 - 1.0) % 1.0
    components: np.ndarray = np.where(parts < 0.5, 0.5 + parts, -parts)
    return components


def direction_kernel(model: CompiledModel, direction: SensitivityDirection, *blocks: str) -> Kernel:
    """Return the Kernel of the directional derivatives of some blocks.

    Without blocks, it computes the rates of the states and of their directional derivatives.
    """
    assembly = model.assembly

    def make() -> Program:
        if blocks:
            graph = assembly.graph.copy()
            nodes = [node for name in blocks for node in getattr(assembly, name)]
            return direction.program(graph, simplify(graph, nodes), assembly.sizes)
        graph, rates = assembly.simplified("rates")
        return direction.program(graph, rates, assembly.sizes, "rates")

    def stored() -> Program:
        description = f"along one direction of {', '.join(blocks) or 'rates'} {direction}"
        return stored_program(assembly, description, make)

    return model.compiled_by(("along one direction", blocks, direction), stored)


class MotionSegment:
    """A motion of the states and the integral up to the state `last`, with recorded steps.

    The step size is controlled by the sensitivities `guide` (see `Task.with_sensitivities`), or
    limited by one direction if `bounded` (see `Task.with_generic_direction`), or controlled by the
    states alone.
    """

    def __init__(
        self,
        task: Task,
        solver: Solver,
        x0: np.ndarray,
        times: np.ndarray,
        options: dict[str, Any],
        guide: np.ndarray | None = None,
        bounded: bool = True,
    ) -> None:
        from pydy.solvers import DiscreteAdjoint, Integration

        n = len(x0)
        self.unbounded: str | None = None  # why no derivatives limit the step size
        self.rates = rates = task.call_full(task.full_model.compiled("rates"))
        num_extra = rates.kernel.program.signature.num_states - n
        for name in options.keys() & {"rtol", "atol"}:
            if np.size(options[name]) == n > 1 and num_extra:  # the integral: the strictest of them
                tolerances = np.asarray(options[name], dtype=float)
                options = {**options, name: np.append(tolerances, tolerances.min())}
        options = with_step_limit(task.sensitive, solver, options, x0, times, False)
        full_state, call = np.append(x0, np.zeros(num_extra)), rates
        if guide is not None:
            call, full_state, sensitivities = task.with_sensitivities(full_state, guide, options)
            options = {**options, "sensitivities": sensitivities}
        elif bounded and solver.adaptive:
            call, full_state, sensitivities = task.with_generic_direction(full_state, options)
            options = {**options, "sensitivities": sensitivities}
        read = replace(read_options(solver.name, solver.adaptive, options), recorded=n)
        integration = Integration(solver.name, call, len(full_state), times, (), read)
        self.task, self.times, self.n, self._first = task, times, n, x0
        self.options: Any = read
        width = n + num_extra
        self.states = states = integration.run(full_state)[:, :width]
        for message in integration.event_warnings():
            warn_user(message)
        self.info = info = integration.info()
        self.records: list[EventRecord] = info["events"]
        self.end: float = info["time"]
        self.stopped = info["code"] == Outcome.TERMINATED
        ended = integration.memory.x[:width].copy()
        self.last = ended if self.stopped or not len(states) else states[-1]
        rows: Any = integration.recorded_steps()
        starts = rows[rows[:, 1] > 0.0, 0]
        ends = np.append(starts, self.end)[1:]  # includes steps that an event cut short
        nonempty = ends > starts
        self.starts, self.ends = starts[nonempty], ends[nonempty]
        self.before = rows[rows[:, 1] > 0.0, 2 : 2 + width][nonempty]
        num_wrt, num_sampled = len(task.wrt), len(task.sampled)
        switched = None if integration.call is None else integration.call.switched
        call_with_switches = replace(rates, switched=switched)
        self._back = DiscreteAdjoint(
            solver.name, call_with_switches, task.rates_vjp(), num_wrt, num_sampled
        )
        self._num_sampled = num_sampled
        integrals = 0 if task.integral is None else 1
        self.value = float(self.last[n : n + integrals].sum())
        self._sample_derivatives: list[tuple[np.ndarray, np.ndarray]] = []  # (times, derivatives)
        self._totals = np.zeros(num_wrt)
        self._adjoint = np.zeros(len(self.last))
        self._adjoint[n : n + integrals] = 1.0
        self._slope = 0.0  # of the objective along the motion at its end
        self._followed = False  # True if another segment continues the motion

    def finish(self, weights: np.ndarray | None = None, end_varies: bool = True) -> None:
        """Start the adjoint from the terms at the end: `final`, or Σ weight · last state.

        `end_varies` is True if the time of an event that ends the motion depends on the parameters.
        """
        n, t, self._followed = self.n, self.end, not end_varies
        if weights is not None:
            self._adjoint[:n] = weights
        if self.task.final is None:
            return
        call = self.task.objective()
        value_and_gradient = call.evaluate(call.kernel, self.last, t)
        self.value += float(value_and_gradient[0])
        s = len(call.inputs.values)
        by_state, by_time = value_and_gradient[1 : 1 + n], float(value_and_gradient[1 + n])
        by_input = value_and_gradient[2 + n : 2 + n + s]
        self._adjoint[:n] = by_state
        self._add(value_and_gradient[2 + n + s :], t)
        self._slope = by_time + float(by_input @ call.inputs.slopes(t))

    def _add(self, part: np.ndarray, t: float) -> None:
        """Add the derivatives by the parameters due to one instant."""
        self._totals += part
        if self._num_sampled:
            self._sample_derivatives.append(
                (np.array([t]), part[None, len(part) - self._num_sampled :])
            )

    def interrupted(self, times: np.ndarray, states: np.ndarray) -> IntegrationInterrupted:
        """Return the error for an interrupted backward pass; it contains the complete motion."""
        return IntegrationInterrupted(
            "The gradient was interrupted on the way back through the motion, which is whole: it "
            "is in the attributes `times` and `states` of this error.",
            times.copy(), states.copy(), self.end, self.last[: self.n].copy(), self.info,
        )  # fmt: skip

    def motion(self, problem: Problem, solver: Solver, ready: PreparedIntegration) -> Motion:
        """Return the integrated states as a Motion."""
        reached, dense = self.info["reached"], self.info.get("dense_output")
        return Motion(
            problem=problem,
            integrator=Integrator(solver, ready.enforced),
            options=ready.options,
            times=self.times[:reached],
            states=self.states[:reached, : self.n],
            segments=(Segment(float(self.times[0]), self.end, (), problem, dense=dense),),
            events=self.records,
            statistics=self.info,
        )

    def passed(self, problem: Problem) -> Trajectory:
        """Return the motion as a Trajectory at the solver's steps."""
        states = np.vstack([self.before, self.last])[:, : self.n]
        return TrajectoryModel(problem).label(
            np.append(self.starts, self.end), states, events=self.records
        )

    def gradient(self, start: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Integrate the adjoint back; return the derivatives by parameters and by the first state.

        `start` (n, k) contains the derivatives of the first state by the parameters.
        """
        by_state = self.back()
        return self.by_parameters(by_state @ start), by_state

    def back(self) -> np.ndarray:
        """Integrate the adjoint back to the start; return the derivatives by the first state."""
        with progress_of(self.options.progress, " steps back", len(self.starts)) as self._progress:
            by_state = self._all_back()
        if self.unbounded is not None:
            warn_user(
                "The steps of this gradient follow from the errors of the states alone. With "
                f"derivatives beside them {self.unbounded}. If the gradient depends on a direction "
                "that the motion does not excite, compare it with `simulate(sensitivities=...)`."
            )
        return by_state

    def back_through_transition(
        self, matrix: np.ndarray, time: np.ndarray, earlier: MotionSegment | None = None
    ) -> np.ndarray:
        """Apply the adjoint of the transition before this segment; return the state derivatives.

        `matrix` (n, n + w) contains the derivatives of the state after the transition by the state
        before it, then by the inputs `wrt`, at a fixed time. `time` (n + w,) contains those of the
        transition's time, NaN if unknown. The sums so far are passed on to the `earlier` segment.
        """
        n, t = self.n, float(self.times[0])
        derivatives = self._adjoint[:n] @ matrix
        if earlier is not None:
            jump = (earlier._rates(earlier.last, t) - self._rates(self._first, t))[n:]
            if (slope := float(self._adjoint[n:] @ jump)) and np.isnan(time).any():
                steps = zip(earlier.before, earlier.starts, strict=True)
                sizes = [np.abs(earlier._rates(x, t)[n:]).max() for x, t in steps]
                if not abs(slope) <= HALF * max(sizes, default=0.0):
                    raise NotImplementedError(
                        f"`integral` jumps at t = {t!r}, where a body comes to rest in a plane: "
                        "how that time depends on parameters is not known. Integrate what is "
                        "continuous there."
                    )
                slope = 0.0
            derivatives = derivatives + (slope * time if slope else 0.0)
            earlier._adjoint[:n] = derivatives[:n]
            earlier._totals, earlier._sample_derivatives, earlier._followed = (
                self._totals,
                self._sample_derivatives,
                True,
            )
        self._add(derivatives[n:], t)
        by_state: np.ndarray = derivatives[:n]
        return by_state

    def _all_back(self) -> np.ndarray:
        events = self.options.events
        if self.stopped and not self._followed:
            self._slope += float(self._adjoint @ self._rates(self.last, self.end))
        acting = []
        if events is not None and not self._followed:
            acting = [r for r in self.records if events.traits[r.index].acts]
        last, end = len(self.starts), self.last
        for record in reversed(acting):
            first = int(np.searchsorted(self.ends, record.time, side="right"))
            if first == 0 or (first == len(self.ends) and not self.stopped):
                continue  # at the very start or end, where an event is recorded only
            self._steps_back(first, last, end)
            last, end = first, record.before
            terminal = events.traits[record.index].terminal
            self._jump(record, self._slope if terminal else 0.0)
            self._slope = 0.0 if terminal else self._slope
        self._steps_back(0, last, end)
        return self._adjoint[: self.n].copy()

    def _rates(self, x: np.ndarray, t: float) -> np.ndarray:
        full_state = np.append(x[: self.n], np.zeros(len(self.last) - self.n))
        return self.rates.evaluate(self.rates.kernel, full_state, t)

    def _steps_back(self, first: int, last: int, end: np.ndarray) -> None:
        """Integrate the adjoint from the end of step `last` − 1 to the start of step `first`.

        `end` is the state at the end of step `last` − 1.
        """
        if first == last:
            return
        n, sweeps = self.n, [(first, last)]
        projections = None
        if self.options.constraints is not None:
            sweeps = [(k, k + 1) for k in range(first, last)]
            ends = np.vstack([self.before[first + 1 : last, :n], end[:n]])
            projections = self._projections(self.ends[first:last], ends)
        for k, (start, stop) in reversed(list(enumerate(sweeps))):
            if projections is not None:
                self._adjoint[:n] = projections.back(k, self._adjoint[:n])
            span = slice(start, stop)
            steps = self.starts[span], self.ends[span], self.before[span]
            sweep = self._back.sweep_back(*steps, self._adjoint, self._progress)
            if not np.isfinite(sweep.adjoint).all():
                begin, past = float(self.starts[start]), float(self.ends[stop - 1])
                raise ValueError(
                    "The derivatives of the equations are not finite between t = "
                    f"{begin!r} and t = {past!r}, though the motion is: look there for the square "
                    "root of zero, or another function without a derivative. "
                    "`system.evaluate_jacobian` tells which."
                )
            self._adjoint = sweep.adjoint
            self._totals += sweep.totals
            self._sample_derivatives.append((sweep.times, sweep.stagewise))
        if projections is not None:
            self._projected(projections)

    def _projections(self, times: np.ndarray, states: np.ndarray) -> Projections:
        task, constraints = self.task, self.options.constraints
        return Projections(
            with_all(task.sensitive.model, task.sensitive.definition),
            constraints,
            task.wrt,
            task.call,
            times,
            states,
        )

    def _projected(self, projections: Projections) -> None:
        """Add the derivatives by the parameters due to projections."""
        totals, per_time = projections.totals()
        self._totals += totals
        self._sample_derivatives.append(
            (projections.times, per_time[:, per_time.shape[1] - self._num_sampled :])
        )

    def _jump(self, record: EventRecord, slope: float) -> None:
        """Apply the adjoint of an event.

        With the adjoint λ after it, the event time t_e changes the objective by λ · (Ṙ − f⁺) and,
        if the motion ends there, by the objective's `slope`; dt_e/dθ = −(g_x S + g_θ) / ġ.
        """
        n, t = self.n, record.time
        x, adjoint = record.before, self._adjoint[:n].copy()
        part, changed, time = self.moment(record)
        changed_states = [*changed]
        if changed and self.options.constraints is not None:  # the projection after it
            projections = self._projections(np.array([t]), record.after[None])
            adjoint = projections.back(0, adjoint)
            self._projected(projections)
        time_slope = slope
        if time.any():
            before, after = self._rates(x, t), self._rates(record.after, t)
            time_slope += float(adjoint @ (part["after_rates"] - after[:n]))
            time_slope += float(self._adjoint[n:] @ (before - after)[n:])
        derivatives = adjoint[changed_states] @ part["after"] + time_slope * time
        adjoint[changed_states] = 0.0
        self._adjoint[:n] = adjoint + derivatives[:n]
        self._add(derivatives[n:], t)

    def moment(
        self, record: EventRecord, untimed: bool = False
    ) -> tuple[dict[str, np.ndarray], tuple[int, ...], np.ndarray]:
        """Return an event's derivative blocks, the changed states, and its time's derivatives.

        The time's derivatives (n + w,) are by the state before the event, then by the inputs `wrt`.
        At a grazing event they do not exist: this is an error, or they are NaN if `untimed`.
        """
        n, t, x = self.n, record.time, record.before
        events = self.options.events
        assert events is not None
        source, wrt = events.sources[record.index], self.task.wrt
        kernel, changed = compiled_event(self.task.sensitive.model, source, wrt)
        call = self.task.call(kernel)
        r = np.concatenate([call.inputs(x, t), call.inputs.slopes(t)])
        out = kernel.evaluate(np.array([t]), x[None, :n], r[None], call.p)[0][0]
        part = kernel.program.signature.by_block(out)
        time = np.zeros(len(part["crossing"]))
        # An event that a jump of an input causes has the jump's time, which is fixed.
        if events.forcing_time(call, record.index, x, t) is None:
            rate, curvature = float(part["rate"][0]), float(part["curvature"][0])
            tolerances = self.options.atol, self.options.rtol
            atol, rtol = (
                np.broadcast_to(tolerance, len(self.last))[:n] for tolerance in tolerances
            )
            depth = rate * rate / (2.0 * abs(curvature)) if curvature else abs(rate) * np.inf
            error, lower = CompiledSensitivities.event_resolution(
                depth, part["crossing"][:n], x, rtol, atol
            )
            value = events.value_after_jump(call, record.index, x, t, error)
            if value is None and depth > error:
                time = -part["crossing"] / rate
            elif untimed:
                time[:] = np.nan
            elif value is not None:
                self._refuse(Outcome.EVENT_JUMPS, record, value=value)
            else:  # a grazing event: its time has no derivative
                self._refuse(
                    Outcome.EVENT_GRAZES, record, depth=depth, explained=error, lower=lower
                )
        return part, changed, time

    def _refuse(self, outcome: Outcome, record: EventRecord, **details: object) -> NoReturn:
        text, remedy = (
            part.format(event=record.name, **details) for part in (outcome.text, outcome.remedy)
        )
        k = int(np.searchsorted(self.times, record.time))
        raise IntegrationError(
            f"The motion {text} at t = {record.time!r}. {remedy}",
            self.times[:k], self.states[:k, : self.n], record.time, record.before, self.info,
        )  # fmt: skip

    def by_parameters(self, start: np.ndarray) -> np.ndarray:
        """Return the derivatives by all parameters.

        `start` contains the contributions of the initial state.
        """
        task = self.task
        index_of = {slot: k for k, slot in enumerate(task.wrt)}
        sampled = {p.symbol: k for k, p in enumerate(task.sampled)}
        derivatives: list[float] = []
        for parameter in task.sensitive.parameters:
            if parameter.kind == "states":
                derivatives.append(0.0)
            elif parameter.samples is None:
                group = "p" if parameter.kind == "constants" else "r"
                derivatives.append(float(self._totals[index_of[group, parameter.index]]))
            else:
                weights, total = by_samples(parameter), np.zeros(parameter.count)
                for times, slopes in self._sample_derivatives:
                    total += slopes[:, sampled[parameter.symbol]] @ weights.rows(times)
                derivatives += total.tolist()
        total_derivatives: np.ndarray = start + np.array(derivatives)
        return total_derivatives


def integrate_forward(
    problem: Problem,
    solver: Solver,
    ready: PreparedIntegration,
    times: np.ndarray,
    task: Task,
    guide: np.ndarray | None = None,
) -> MotionSegment:
    """Integrate from the initial conditions; raise an error with a diagnosis on failure."""
    n = len(problem.definition.states)
    run = partial(MotionSegment, task, solver, problem.x, times, ready.options, guide)
    failed: IntegrationError | SingularMatrixError | None = None
    try:
        try:
            segment = run()
        except (IntegrationError, SingularMatrixError) as error:
            if guide is not None or not solver.adaptive:
                raise
            failed = error
        if failed is not None:  # the sensitivities may be singular where the motion is not
            segment = run(bounded=False)
            if isinstance(failed, SingularMatrixError):
                segment.unbounded = "the mass matrix became singular"
            # A derivative that is not finite fails the backward pass if the scalar depends on it.
            elif failed.info["code"] != Outcome.NOT_FINITE:
                segment.unbounded = (
                    f"`{solver.name}` {failed.info['status']} at t = {failed.time:.6g}"
                )
    except (IntegrationError, IntegrationInterrupted, SingularMatrixError) as error:
        if not isinstance(error, SingularMatrixError):
            error.states, error.state = error.states[:, :n], error.state[:n]
            error.motion = motion_so_far(problem, ready, solver, ready.options, error)
        if not isinstance(error, IntegrationInterrupted):
            explain_failure(error, problem, ready, not ready.enforced)
        raise
    judge_motion(segment.motion(problem, solver, ready))
    return segment
