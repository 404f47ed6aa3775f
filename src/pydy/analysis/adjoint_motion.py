"""Motions whose steps are recorded, and the adjoint of these from the last to the first."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, NoReturn

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
    compiled_event,
    explain_failure,
    least_sizes,
    marker,
    motion_so_far,
)
from pydy._judges import judge_motion, node_of
from pydy._kernel import Inputs, Kernel, KernelCall
from pydy._motion import Motion, PreparedIntegration, Segment, with_all
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


def extended(term: Any, marked: bool, assembly: Assembly) -> Assembly:
    """Return the equations with the integral and the marker of samples as their last states."""
    n, s, c = assembly.sizes
    more = [] if term is None else [node_of(assembly, term, "`integral`")]
    if marked:
        more.append(assembly.graph.input("r", s))
    return replace(assembly, sizes=(n + len(more), s + marked, c), rates=[*assembly.rates, *more])


class Projections:
    """The projections at the ends of some steps.

    A projection moves sensitivities S by −K (c_x S + c_θ), with the residuals c and the least
    correction K in the norm of the projection, of positions and then of velocities. So an adjoint λ
    becomes λ − c_xᵀ Kᵀ λ before it, and the derivatives by θ gain −(Kᵀ λ) · c_θ.

    The inputs `wanted` are differentiated by; `call` returns the call of a Kernel with so many
    inputs after r. The m states at the times are as they were projected.
    """

    def __init__(
        self,
        model: CompiledModel,
        constraints: CompiledConstraints,
        wanted: tuple[tuple[str, int], ...],
        call: Callable[[Kernel, int], KernelCall],
        times: np.ndarray,
        states: np.ndarray,
    ) -> None:
        self.times, self._x, self._wanted, self._model = times, states, wanted, model
        self._constraints = constraints
        plain = call(constraints.kernel, 0)
        self._r = Inputs(plain.r, plain.sampled).rows(states, times)
        self._p = plain.p
        out = model.evaluate(constraints.kernel, times, states, self._r, self._p)
        self._parts = constraints.kernel.program.by_block(out)
        h, v, n = constraints.holonomic, constraints.velocity, states.shape[1]
        self._gradient = self._parts["gradient"].reshape(len(times), h, constraints.coordinates)
        if any(model.assembly.following):  # whose corrections are not along the gradient
            by_state = model.compiled_jacobian("holonomic", "x")
            found = model.evaluate(by_state, times, states, self._r, self._p)
            self._gradient = found.reshape(len(times), h, n)
        self._slopes = np.zeros((len(times), v, n))
        if v:
            by_state = model.compiled_jacobian("velocity", "x")
            found = model.evaluate(by_state, times, states, self._r, self._p)
            self._slopes = found.reshape(len(times), v, n)
        self._multipliers = np.zeros((len(times), h + v))

    def back(self, k: int, adjoint: np.ndarray) -> np.ndarray:
        """Return the adjoint of the state before projection k, from that after it."""
        wanted = self._constraints
        h, v, q, u = wanted.holonomic, wanted.velocity, wanted.coordinates, wanted.speeds
        part = {name: values[k] for name, values in self._parts.items()}
        inverse = np.eye(u)
        if wanted.weighted:
            inverse = _inverse_factor(part["kinetic_hessian"].reshape(u, u))
        adjoint = adjoint.copy()
        multipliers = self._multipliers[k]
        if v:
            rows = part["velocity_gradient"].reshape(v, u) @ inverse
            multipliers[h:] = (inverse @ _least(rows)).T @ adjoint[q : q + u]
            adjoint -= multipliers[h:] @ self._slopes[k]
        if h:
            gradient = part["gradient"].reshape(h, q)
            reach = part["kinematics"].reshape(q, u) @ inverse
            terms = np.linalg.norm(np.abs(gradient) @ np.abs(reach), axis=1)
            moved = gradient @ reach
            moved[is_zero(np.linalg.norm(moved, axis=1), terms)] = 0.0
            correction = reach @ _least(moved)
            # Rows that no speed reaches.
            correction = correction + _least(gradient) @ (np.eye(h) - gradient @ correction)
            multipliers[:h] = correction.T @ adjoint[:q]
            slopes = self._gradient[k]
            adjoint[: slopes.shape[1]] -= multipliers[:h] @ slopes
        return adjoint

    def totals(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the derivatives by the parameters: the sum (w,), and those at each time (m, w)."""
        model, wanted = self._model, self._wanted
        if not wanted:
            return np.zeros(0), np.zeros((len(self.times), 0))
        assembly = model.assembly

        def make() -> Program:
            own = assembly.fork()
            nodes = simplify(own.graph, [*own.holonomic, *own.velocity])
            return derivative_program(own.graph, nodes, wanted, "vector-jacobian", own.sizes)

        kernel = model.compiled_by(("adjoint of the constraints", wanted), make)
        rows = np.broadcast_to(self._r, (len(self.times), self._r.shape[1]))
        r = np.concatenate([rows, -self._multipliers], axis=1)
        found = model.evaluate(kernel, self.times, self._x, r, self._p)
        total: Any = found.sum(axis=0)
        return total, found


def _inverse_factor(matrix: np.ndarray) -> np.ndarray:
    """Return L⁻ᵀ of a Cholesky factor; the identity where there is none, as the projection does."""
    try:
        factor = np.linalg.cholesky(matrix)
    except np.linalg.LinAlgError:
        return np.eye(len(matrix))
    rounding = 4.0 * len(matrix) * np.finfo(float).eps
    if not (np.diag(factor) ** 2 > rounding * np.diag(matrix)).all():
        return np.eye(len(matrix))
    return np.linalg.inv(factor).T


def _least(rows: np.ndarray) -> np.ndarray:
    """Return the least solution of equations, without their dependent rows."""
    lengths = or_one(np.linalg.norm(rows, axis=1))
    found: np.ndarray = np.linalg.pinv(rows / lengths[:, None], rcond=DEPENDENT) / lengths
    return found


Place = tuple[str, int]


@dataclass(frozen=True, eq=False)
class Task:
    """The equations, objective and parameters of one gradient."""

    sensitive: AugmentedSystem  # its model is of the states alone
    final: Any  # the place of an output, an expression, or None
    integral: Any

    @cached_property
    def whole(self) -> CompiledModel:
        """The equations, with the integral and the marker of samples as their last states."""
        marked = self.marker is not None
        model = self.sensitive.model
        if self.integral is None and not marked:
            return model
        return model.changed(
            ("integral", self.integral, marked), partial(extended, self.integral, marked)
        )

    @cached_property
    def marker(self) -> SampledInput | None:
        """See `samples.marker`."""
        return marker(self.sensitive.parameters)

    @property
    def _plain(self) -> list[Parameter]:
        return [p for p in self.sensitive.parameters if p.kind != "states" and p.samples is None]

    @cached_property
    def sampled(self) -> list[Parameter]:
        """The parameters that are samples."""
        return [p for p in self.sensitive.parameters if p.samples is not None]

    @cached_property
    def wanted(self) -> tuple[Place, ...]:
        """The inputs to differentiate by; sampled specifieds come last."""
        groups = {"constants": "p", "specifieds": "r"}
        return tuple((groups[p.kind], p.place) for p in (*self._plain, *self.sampled))

    def call_whole(self, kernel: Kernel, further: int = 0) -> KernelCall:
        """Return the call of a Kernel of `whole` with so many inputs after r."""
        if self.marker is None:
            return self.call(kernel, further)
        call = self.call(kernel, further + 1)
        place = np.array([len(self.sensitive.plan.inputs.values)])
        return replace(call, sampled=(*call.sampled, (place, self.marker)))

    def call(self, kernel: Kernel, further: int = 0) -> KernelCall:
        """Return the call of a Kernel with so many inputs after r."""
        plan, states = self.sensitive.plan, self.sensitive.definition.states
        r = np.concatenate([plan.inputs.values, np.zeros(further)])

        def names() -> tuple[str, ...]:
            return (*map(str, states), "the integral")

        return KernelCall(kernel, self.sensitive.p, r, plan.inputs.sampled, None, names)

    # -- compiled ---------------------------------------------------------------------------------

    def guided(
        self, whole: np.ndarray, columns: np.ndarray, options: dict[str, Any]
    ) -> tuple[KernelCall, np.ndarray, CompiledSensitivities]:
        """Return the equations with columns of derivatives, and their options for the solver.

        The `columns` (n, n + w) are by some states, then by what is wanted. Where they turn more
        quickly than states, their errors choose the steps.
        """
        own = self.sensitive
        states = [Parameter(s, "states", k) for k, s in enumerate(own.definition.states)]
        others = [replace(p, samples=None) for p in (*self._plain, *self.sampled)]
        moving = [k for k, p in enumerate([*states, *others]) if p in others or columns[:, k].any()]
        parameters = tuple([*states, *others][k] for k in moving)
        beside = replace(own, model=self.whole, parameters=parameters, width=len(whole))
        compiled = beside.compiled(whole, options, wanted=True)
        values = np.zeros((len(whole), len(moving)))
        values[: len(states)] = columns[:, moving]
        call = self.call_whole(beside.kernel())
        return call, beside.columns.together(whole, values), compiled

    def bounded(
        self, whole: np.ndarray, options: dict[str, Any]
    ) -> tuple[KernelCall, np.ndarray, CompiledSensitivities]:
        """Return the equations with one column of derivatives, and its options for the solver.

        It is the derivative along a generic direction of all initial conditions and of what is
        wanted, each in units of its size. Its errors bound the steps: what the motion does not
        excite shows in it, and the gradient is made of the derivatives along such directions.
        """
        model, width = self.whole, len(whole)
        direction = SensitivityDirection(width, self.wanted)
        call = self.call_whole(direction_kernel(model, direction))
        sized = [
            ParameterSize("x", k, least=s)
            for k, s in enumerate(least_sizes(options, width).tolist())
        ]
        sized += [one.sized._replace(columns=1) for one in (*self._plain, *self.sampled)]
        own, r = self.sensitive, self.sensitive.plan.inputs.values
        sizes = ParameterSize.scales(sized, whole, r, own.p, len(sized))
        parts = sizes * generic(len(sized))
        column, weights = parts[:width], parts[width:]
        column[own.columns.states :] = 0.0  # integrals begin at zero
        every = with_all(model, own.definition)
        beside = CompiledSensitivities(
            width, _OF_NO_INPUT, np.ones(1), whole, False, _of_no_event,
            lambda: direction_kernel(every, direction, "holonomic", "velocity"),
        )  # fmt: skip
        call = replace(call, r=np.concatenate([call.r, weights]))
        return call, np.append(whole, column), beside

    def turned(self) -> KernelCall:
        """Return the derivatives of Σ weight · rate; see `DiscreteAdjoint`."""
        model = self.whole
        assembly = model.assembly
        n = assembly.sizes[0]
        by = [*(("x", k) for k in range(n)), *self.wanted]

        def make() -> Program:
            graph, rates = assembly.simplified("rates")
            return derivative_program(graph, rates, by, "vector-jacobian", assembly.sizes)

        key = ("adjoint of the rates", self.wanted)
        return self.call_whole(model.compiled_by(key, make), n)

    def objective(self) -> KernelCall:
        """Return `final` and its derivatives by states, time, specifieds and parameters."""
        model = self.sensitive.model
        assembly = model.assembly
        n, s, _ = assembly.sizes
        places = [("t", 0), *(("r", k) for k in range(s)), *self.wanted]
        by = [*(("x", k) for k in range(n)), *places]

        def make() -> Program:
            own = assembly.fork()
            nodes = simplify(own.graph, [node_of(own, self.final, "`final`")])
            return derivative_program(own.graph, nodes, by, "gradient", own.sizes)

        key = ("gradient at the end", self.final, self.wanted)
        return self.call(model.compiled_by(key, make))


_OF_NO_INPUT = np.array([[-1, -1]])


def _of_no_event(event: int) -> NoReturn:
    raise AssertionError("Derivatives that bound steps go on through events as they are.")


def generic(count: int) -> np.ndarray:
    """Return the components of a fixed direction, of sizes from 1/2 to 1 and of both signs.

    Modes of symmetric systems are sums and differences of states: multiples of the golden section
    are spread evenly, so that few of them are nearly the same.
    """
    parts = np.arange(1.0, count + 1.0) * 0.5 * (5.0**0.5 - 1.0) % 1.0
    found: np.ndarray = np.where(parts < 0.5, 0.5 + parts, -parts)
    return found


def direction_kernel(model: CompiledModel, direction: SensitivityDirection, *blocks: str) -> Kernel:
    """Return the Kernel of the derivatives of blocks along a direction.

    By default it is that of the derivatives of the states and of their column by time.
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
        what = f"along one direction of {', '.join(blocks) or 'rates'} {direction}"
        return stored_program(assembly, what, make)

    return model.compiled_by(("along one direction", blocks, direction), stored)


class MotionSegment:
    """A motion of the states and the integral, to the state `last`; its steps are noted.

    Derivatives may `guide` its steps, see `Task.guided`; else they are `bounded`, or as the errors
    of the states choose them.
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
        self.unbounded: str | None = None  # what came of derivatives that should bound the steps
        self.rates = rates = task.call_whole(task.whole.compiled("rates"))
        more = rates.kernel.program.num_states - n
        for name in options.keys() & {"rtol", "atol"}:
            if np.size(options[name]) == n > 1 and more:  # the integral as the strictest state
                given = np.asarray(options[name], dtype=float)
                options = {**options, name: np.append(given, given.min())}
        options = task.sensitive.stepped(solver, options, x0, times, False)
        whole, call = np.append(x0, np.zeros(more)), rates
        if guide is not None:
            call, whole, beside = task.guided(whole, guide, options)
            options = {**options, "sensitivities": beside}
        elif bounded and solver.adaptive:
            call, whole, beside = task.bounded(whole, options)
            options = {**options, "sensitivities": beside}
        read: Any = replace(read_options(solver.name, solver.adaptive, options), recorded=n)
        integration = Integration(solver.name, call, len(whole), times, (), read)
        self.task, self.times, self.n, self._first = task, times, n, x0
        self.options: Any = read
        width = n + more
        self.states = states = integration.run(whole)[:, :width]
        for told in integration.event_warnings():
            warn_user(told)
        self.info = info = integration.info()
        self.records: list[EventRecord] = info["events"]
        self.end: float = info["time"]
        self.stopped = info["code"] == Outcome.TERMINATED
        ended = integration.memory.x[:width].copy()
        self.last = ended if self.stopped or not len(states) else states[-1]
        rows: Any = integration.recorded_steps()
        starts = rows[rows[:, 1] > 0.0, 0]
        ends = np.append(starts, self.end)[1:]  # of those that events cut short, too
        moves = ends > starts
        self.starts, self.ends = starts[moves], ends[moves]
        self.before = rows[rows[:, 1] > 0.0, 2 : 2 + width][moves]
        further, kept = len(task.wanted), len(task.sampled)
        switched = None if integration.call is None else integration.call.switched
        known = replace(rates, switched=switched)
        self._back = DiscreteAdjoint(solver.name, known, task.turned(), further, kept)
        self._kept = kept
        integrals = 0 if task.integral is None else 1
        self.value = float(self.last[n : n + integrals].sum())
        self._seen: list[tuple[np.ndarray, np.ndarray]] = []  # derivatives by samples, with times
        self._totals = np.zeros(further)
        self._adjoint = np.zeros(len(self.last))
        self._adjoint[n : n + integrals] = 1.0
        self._slope = 0.0  # of the objective along the motion at its end
        self._followed = False  # whether the motion goes on from where this one ends

    def finish(self, weights: np.ndarray | None = None, moves: bool = True) -> None:
        """Take the terms at the end; the last state's sum with some `weights` is one.

        Whether an event that ends the motion `moves` its end.
        """
        n, t, self._followed = self.n, self.end, not moves
        if weights is not None:
            self._adjoint[:n] = weights
        if self.task.final is None:
            return
        call = self.task.objective()
        found = call.evaluate(call.kernel, self.last, t)
        self.value += float(found[0])
        s = len(call.r)
        by_state, by_time = found[1 : 1 + n], float(found[1 + n])
        by_input = found[2 + n : 2 + n + s]
        self._adjoint[:n] = by_state
        self._add(found[2 + n + s :], t)
        self._slope = by_time + float(by_input @ call.slopes_at(t))

    def _add(self, part: np.ndarray, t: float) -> None:
        """Add the derivatives by the parameters due to one instant."""
        self._totals += part
        if self._kept:
            self._seen.append((np.array([t]), part[None, len(part) - self._kept :]))

    def interrupted(self, times: np.ndarray, states: np.ndarray) -> IntegrationInterrupted:
        """Return the error of a way back that was interrupted, with the whole motion."""
        return IntegrationInterrupted(
            "The gradient was interrupted on the way back through the motion, which is whole: it "
            "is in the attributes `times` and `states` of this error.",
            times.copy(), states.copy(), self.end, self.last[: self.n].copy(), self.info,
        )  # fmt: skip

    def motion(self, problem: Problem, solver: Solver, ready: PreparedIntegration) -> Motion:
        """Return what was integrated as a Motion."""
        reached = self.info["reached"]
        return Motion(
            problem=problem,
            solver=solver,
            options=ready.options,
            times=self.times[:reached],
            states=self.states[:reached, : self.n],
            segments=(Segment(float(self.times[0]), self.end, (), problem),),
            events=self.records,
            statistics=self.info,
            dense=self.info.get("dense_output"),
            projected=ready.enforced,
        )

    def passed(self, problem: Problem) -> Any:
        """Return the motion as a Trajectory at the solver's own steps."""
        states = np.vstack([self.before, self.last])[:, : self.n]
        return TrajectoryModel(problem).label(
            np.append(self.starts, self.end), states, events=self.records
        )

    def gradient(self, start: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Go back to the beginning; return the derivatives by parameters and by the first state.

        The derivatives of the first state by the parameters are `start`, shape (n, k).
        """
        by_state = self.back()
        return self.by_parameters(by_state @ start), by_state

    def back(self) -> np.ndarray:
        """Go back to the beginning; return the derivatives by the first state."""
        with progress_of(self.options.progress, " steps back", len(self.starts)) as self._told:
            found = self._all_back()
        if self.unbounded is not None:
            warn_user(
                "The steps of this gradient follow from the errors of the states alone. With "
                f"derivatives beside them {self.unbounded}. If the gradient depends on a direction "
                "that the motion does not excite, compare it with `simulate(sensitivities=...)`."
            )
        return found

    def through(
        self, matrix: np.ndarray, time: np.ndarray, earlier: MotionSegment | None = None
    ) -> np.ndarray:
        """Go back through a transition that leads here; return the derivatives by the state before.

        The `matrix` (n, n + w) has the derivatives of the state after it by that state, then by
        what is wanted, at a fixed time, `time` (n + w,) those of its time, NaN where they are not
        known. An `earlier` stretch that leads to it takes over what has been found.
        """
        n, t = self.n, float(self.times[0])
        turned = self._adjoint[:n] @ matrix
        if earlier is not None:
            jump = (earlier._rates(earlier.last, t) - self._rates(self._first, t))[n:]
            if (moved := float(self._adjoint[n:] @ jump)) and np.isnan(time).any():
                steps = zip(earlier.before, earlier.starts, strict=True)
                sizes = [np.abs(earlier._rates(x, t)[n:]).max() for x, t in steps]
                if not abs(moved) <= HALF * max(sizes, default=0.0):
                    raise NotImplementedError(
                        f"`integral` jumps at t = {t!r}, where a body comes to rest in a plane: "
                        "how that time depends on parameters is not known. Integrate what is "
                        "continuous there."
                    )
                moved = 0.0
            turned = turned + (moved * time if moved else 0.0)
            earlier._adjoint[:n] = turned[:n]
            earlier._totals, earlier._seen, earlier._followed = self._totals, self._seen, True
        self._add(turned[n:], t)
        found: np.ndarray = turned[:n]
        return found

    def _all_back(self) -> np.ndarray:
        events = self.options.events
        if self.stopped and not self._followed:
            self._slope += float(self._adjoint @ self._rates(self.last, self.end))
        acting = []
        if events is not None and not self._followed:
            acts = [a or b for a, b in zip(events.terminal, events.resetting, strict=True)]
            acting = [r for r in self.records if acts[r.index]]
        last, end = len(self.starts), self.last
        for record in reversed(acting):
            first = int(np.searchsorted(self.ends, record.time, side="right"))
            if first == 0 or (first == len(self.ends) and not self.stopped):
                continue  # at the very beginning or end, where it is seen only
            self._steps_back(first, last, end)
            last, end = first, record.before
            terminal = events.terminal[record.index]
            self._jump(record, self._slope if terminal else 0.0)
            self._slope = 0.0 if terminal else self._slope
        self._steps_back(0, last, end)
        return self._adjoint[: self.n].copy()

    def _rates(self, x: np.ndarray, t: float) -> np.ndarray:
        whole = np.append(x[: self.n], np.zeros(len(self.last) - self.n))
        return self.rates.evaluate(self.rates.kernel, whole, t)

    def _steps_back(self, first: int, last: int, end: np.ndarray) -> None:
        """Go back from the end of step `last` − 1, the state `end`, to where `first` begins."""
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
            own = slice(start, stop)
            steps = self.starts[own], self.ends[own], self.before[own]
            sweep = self._back.sweep_back(*steps, self._adjoint, self._told)
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
            self._seen.append((sweep.times, sweep.stagewise))
        if projections is not None:
            self._projected(projections)

    def _projections(self, times: np.ndarray, states: np.ndarray) -> Projections:
        task, held = self.task, self.options.constraints
        return Projections(task.sensitive.whole.model, held, task.wanted, task.call, times, states)

    def _projected(self, projections: Projections) -> None:
        """Add the derivatives by the parameters due to projections."""
        totals, kept = projections.totals()
        self._totals += totals
        self._seen.append((projections.times, kept[:, kept.shape[1] - self._kept :]))

    def _jump(self, record: EventRecord, slope: float) -> None:
        """Go back through an event.

        With the adjoint λ after it, its time t_e moves the objective by λ · (Ṙ − f⁺) at a fixed
        time, and by its own slope where the motion ends there; dt_e/dθ = −(g_x S + g_θ) / ġ.
        """
        n, t = self.n, record.time
        x, adjoint = record.before, self._adjoint[:n].copy()
        part, changed, time = self.moment(record)
        places = [*changed]
        if changed and self.options.constraints is not None:  # the projection after it
            held = self._projections(np.array([t]), record.after[None])
            adjoint = held.back(0, adjoint)
            self._projected(held)
        moved = slope
        if time.any():
            before, after = self._rates(x, t), self._rates(record.after, t)
            moved += float(adjoint @ (part["after_rates"] - after[:n]))
            moved += float(self._adjoint[n:] @ (before - after)[n:])
        turned = adjoint[places] @ part["after"] + moved * time
        adjoint[places] = 0.0
        self._adjoint[:n] = adjoint + turned[:n]
        self._add(turned[n:], t)

    def moment(
        self, record: EventRecord, untimed: bool = False
    ) -> tuple[dict[str, np.ndarray], tuple[int, ...], np.ndarray]:
        """Return an event's effect on derivatives, the states changed, and its time's derivatives.

        These are by the state before it, then by what is wanted: (n + w,). They are refused where
        it only grazes, or NaN where it may be `untimed`.
        """
        n, t, x = self.n, record.time, record.before
        events = self.options.events
        assert events is not None
        source, wanted = events.sources[record.index], self.task.wanted
        kernel, changed = compiled_event(self.task.sensitive.model, source, wanted)
        call = self.task.call(kernel)
        r = np.concatenate([call.inputs_at(x, t), call.slopes_at(t)])
        out = kernel.evaluate(np.array([t]), x[None, :n], r[None], call.p)[0][0]
        part = kernel.program.by_block(out)
        time = np.zeros(len(part["crossing"]))
        # Where an input that jumps makes it happen, its time is given.
        if events.forcing_time(call, record.index, x, t) is None:
            rate, curvature = float(part["rate"][0]), float(part["curvature"][0])
            tolerances = self.options.atol, self.options.rtol
            atol, rtol = (np.broadcast_to(one, len(self.last))[:n] for one in tolerances)
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
            else:  # it only grazes: its time has no derivative
                self._refuse(
                    Outcome.EVENT_GRAZES, record, depth=depth, explained=error, lower=lower
                )
        return part, changed, time

    def _refuse(self, outcome: Outcome, record: EventRecord, **details: Any) -> NoReturn:
        text, remedy = (
            part.format(event=record.name, **details) for part in (outcome.text, outcome.remedy)
        )
        k = int(np.searchsorted(self.times, record.time))
        raise IntegrationError(
            f"The motion {text} at t = {record.time!r}. {remedy}",
            self.times[:k], self.states[:k, : self.n], record.time, record.before, self.info,
        )  # fmt: skip

    def by_parameters(self, start: np.ndarray) -> np.ndarray:
        """Return the derivatives by all parameters, of which the first state gives some."""
        task = self.task
        place = {one: k for k, one in enumerate(task.wanted)}
        sampled = {p.symbol: k for k, p in enumerate(task.sampled)}
        found: list[float] = []
        for parameter in task.sensitive.parameters:
            if parameter.kind == "states":
                found.append(0.0)
            elif parameter.samples is None:
                group = "p" if parameter.kind == "constants" else "r"
                found.append(float(self._totals[place[group, parameter.place]]))
            else:
                weights, total = by_samples(parameter), np.zeros(parameter.count)
                for times, kept in self._seen:
                    total += kept[:, sampled[parameter.symbol]] @ weights.rows(times)
                found += total.tolist()
        both: np.ndarray = start + np.array(found)
        return both


def integrate_forward(
    problem: Problem,
    solver: Solver,
    ready: PreparedIntegration,
    times: np.ndarray,
    task: Task,
    guide: np.ndarray | None = None,
) -> MotionSegment:
    """Return a motion from the initial conditions, or say why it could not go on."""
    n = len(problem.definition.states)
    run = partial(MotionSegment, task, solver, problem.x, times, ready.options, guide)
    failed: Any = None
    try:
        try:
            found = run()
        except (IntegrationError, SingularMatrixError) as error:
            if guide is not None or not solver.adaptive:
                raise
            failed = error
        if failed is not None:  # derivatives may end where the motion does not
            found = run(bounded=False)
            if isinstance(failed, SingularMatrixError):
                found.unbounded = "the mass matrix became singular"
            # One that is not finite stops the way back, too, if the scalar depends on it.
            elif failed.info["code"] != Outcome.NOT_FINITE:
                found.unbounded = (
                    f"`{solver.name}` {failed.info['status']} at t = {failed.time:.6g}"
                )
    except (IntegrationError, IntegrationInterrupted, SingularMatrixError) as error:
        if not isinstance(error, SingularMatrixError):
            error.states, error.state = error.states[:, :n], error.state[:n]
            error.motion = motion_so_far(problem, ready, solver, ready.options, error)
        if not isinstance(error, IntegrationInterrupted):
            explain_failure(error, problem, ready, not ready.enforced)
        raise
    judge_motion(found.motion(problem, solver, ready))
    return found
