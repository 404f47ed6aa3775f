"""The states of a simulation as a function, with products of its Jacobian and vectors."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._checks import describe
from pydy._errors import IntegrationError, SingularMatrixError
from pydy._forks import Lock
from pydy._integration import simulate
from pydy._motion import Motion
from pydy._names import unique_names
from pydy._problem import Problem, read_times, with_settings
from pydy._states import with_dependents
from pydy.analysis import explicit_solver, motion_and_gradient
from pydy.ensemble import after_end, integrate_ensemble
from pydy.inputs import SampledInput
from pydy.layers.layer import KINDS, ArgumentPart, Arrays, replaced_specifieds
from pydy.solvers import Solver

if TYPE_CHECKING:
    from xarray import Dataset

    from pydy._sympy_types import AnySymbol

_ARGUMENTS = {"x": "initial_conditions", "r": "specifieds", "p": "constants"}


class MotionFunction:
    """All states of a motion, or the last one, as a function of x, r and p: a `LayerFunction`."""

    def __init__(
        self,
        problem: Problem,
        solver: Solver,
        final: bool,
        parts: tuple[ArgumentPart, ...],
        options: dict[str, Any],
    ) -> None:
        self.parts, self._solver, self._final, self._options = parts, solver, final, options
        definition, states = problem.definition, problem.definition.states
        kind = "final" if final else "simulate"
        forward = f"`{kind}` integrates forward only"
        times = read_times(problem, problem.settings.times, forward)
        self.shape: tuple[int, ...] = (len(states),) if final else (len(times), len(states))
        self._problem = with_settings(
            problem,
            initial_conditions=dict(zip(states, problem.x.tolist(), strict=True)),
            specifieds=_one_by_one(problem, parts),
            constants=problem.constants,
            times=times,
            contradicted=None,
        )
        self._solved_for = problem.settings.solved_for or ()
        following = [states[k] for k in problem.dependent]
        self._symbols: list[tuple[AnySymbol, ...]] = []  # of each part
        self._wrt: list[list[AnySymbol]] = []  # symbols of each part to differentiate by
        for part in parts:
            symbol_index = definition.places[KINDS[part.group]]
            symbols = tuple(symbol_index.symbols[k] for k in part.indices)
            self._symbols.append(symbols)
            if part.group == "x" and len(symbols) == len(states):
                self._solved_for = ()  # the caller's states are used without changes
                self._wrt.append([s for s in symbols if s not in following])
            else:
                if part.group == "x":
                    _check_independent(symbols, self._solved_for)
                self._wrt.append([*symbols])
        self._names = unique_names(states)
        self._lock = Lock()  # threads share the model's prepared integration

    # -- samples ----------------------------------------------------------------------------------

    def _problem_of(self, row: list[np.ndarray]) -> Problem:
        """Return the Problem of one sample."""
        changes: dict[str, dict[AnySymbol, object]] = {}
        for part, symbols, values in zip(self.parts, self._symbols, row, strict=True):
            argument = _ARGUMENTS[part.group]
            replaces_all = part.group == "r" and part.is_full
            before = {} if replaces_all else getattr(self._problem.settings, argument)
            entries = np.split(values, np.cumsum(part.counts)[:-1])
            new: dict[AnySymbol, float | SampledInput] = {}
            for symbol, entry in zip(symbols, entries, strict=True):
                samples = before.get(symbol)
                if isinstance(samples, SampledInput):
                    new[symbol] = SampledInput(samples.times, entry, samples.interpolation)
                else:
                    new[symbol] = float(entry[0])
            changes[argument] = {**changes.get(argument, before), **new}
        problem = with_settings(self._problem, **changes)
        return with_dependents(problem, self._solved_for) if self._solved_for else problem

    def _flattened(self, arrays: Arrays) -> list[np.ndarray]:
        return [array.reshape(-1, array.shape[-1]) for array in arrays]

    def _uses_ensemble(self, m: int) -> bool:
        """Return whether the samples are integrated as an ensemble."""
        sampled = any(count > 1 for part in self.parts for count in part.counts)
        full_r = any(part.group == "r" and part.is_full for part in self.parts)
        return m > 1 and not (sampled or full_r or self._solved_for)

    def _ensemble(
        self, flat: list[np.ndarray], sensitivities: list[AnySymbol] | None = None
    ) -> Dataset:
        """Integrate all samples as an ensemble."""
        varied: dict[str, dict[AnySymbol, np.ndarray]] = {}
        for part, symbols, values in zip(self.parts, self._symbols, flat, strict=True):
            columns = np.ascontiguousarray(values.T)
            varied[_ARGUMENTS[part.group]] = dict(zip(symbols, columns, strict=True))
        options = dict(self._options)
        return integrate_ensemble(
            self._problem,
            initial_conditions=varied.get("initial_conditions"),
            specifieds=varied.get("specifieds"),
            constants=varied.get("constants"),
            solver=self._solver,
            sensitivities=sensitivities,
            control_sensitivities=options.pop("control_sensitivities", False),
            progress=options.pop("progress", False),
            options=options,
        )

    def _motion(self, row: list[np.ndarray], parameters: list[AnySymbol] | None = None) -> Motion:
        """Integrate one sample, with sensitivities to the `parameters` unless None."""
        problem, options = self._problem_of(row), dict(self._options)
        if problem.hybrid is None:
            options = {"dense_output": False, **options}
        return simulate(
            problem,
            problem.settings.times,
            solver=self._solver,
            sensitivities=parameters,
            **options,
        )

    def _nan_if_batched(
        self, lead: tuple[int, ...], function: Callable[..., np.ndarray], *sample: object
    ) -> np.ndarray | float:
        """Return a function of one sample; if it fails, NaN for samples with axes, or raise."""
        try:
            return function(*sample)
        except (IntegrationError, SingularMatrixError):
            if not lead:
                raise
            return np.nan

    # -- values -----------------------------------------------------------------------------------

    def value(self, *arrays: np.ndarray) -> np.ndarray:
        """Return the states."""
        flat, lead = self._flattened(arrays), arrays[0].shape[:-1]
        m = len(flat[0])
        with self._lock:
            if self._uses_ensemble(m):
                results = self._ensemble(flat)
                states = np.stack([results[name].values for name in self._names], axis=-1)
                values = states[:, -1].copy() if self._final else states
                late = after_end(results, self._problem.settings.times)
                remaining = np.flatnonzero(late[:, -1] & self._final).tolist()
            else:
                values, remaining = np.empty((m, *self.shape)), [*range(m)]
            for k in remaining:
                values[k] = self._nan_if_batched(lead, self._states, [array[k] for array in flat])
        return values.reshape(*lead, *self.shape)

    def _states(self, row: list[np.ndarray]) -> np.ndarray:
        """Return the states of one sample, or the last of them."""
        motion = self._motion(row)
        states, missing = motion.states, len(self._problem.settings.times) - len(motion.times)
        if self._final:
            last: np.ndarray = motion.events[-1].after if missing else states[-1]
            return last
        return np.pad(states, ((0, missing), (0, 0)), constant_values=np.nan)

    # -- derivatives ------------------------------------------------------------------------------

    def forward(self, wrt: tuple[int, ...], arrays: Arrays, directions: Arrays) -> np.ndarray:
        """Return the Jacobian-vector product, with a direction for each argument of `wrt`."""
        parameters, columns = self._columns(wrt)
        lead = arrays[0].shape[:-1]
        distinct, back = _distinct(self._flattened(arrays))
        with self._lock:
            slopes = self._jacobian(parameters, distinct, lead, sum(map(len, columns)))
        slopes = slopes[:, -1] if self._final else slopes
        direction_columns = [
            d.reshape(-1, d.shape[-1])[:, k] for d, k in zip(directions, columns, strict=True)
        ]
        product = np.einsum(
            "m...k,mk->m...", slopes[back], np.concatenate(direction_columns, axis=-1)
        )
        result: np.ndarray = product
        return result.reshape(*lead, *self.shape)

    def backward(self, wrt: tuple[int, ...], arrays: Arrays, weights: np.ndarray) -> Arrays:
        """Return the vector-Jacobian products of the weights, one for each argument of `wrt`."""
        parameters, columns = self._columns(wrt)
        flat, lead = self._flattened(arrays), arrays[0].shape[:-1]
        weights = weights.reshape(len(flat[0]), *self.shape)
        with self._lock:
            if self._final and self._problem.hybrid is None:
                slopes = np.empty((len(weights), sum(map(len, columns))))
                for k, w in enumerate(weights):
                    slopes[k] = self._nan_if_batched(
                        lead, self._adjoint, parameters, [a[k] for a in flat], w
                    )
            else:
                distinct, back = _distinct(flat)
                states = self._jacobian(parameters, distinct, lead, sum(map(len, columns)))[back]
                if self._final:
                    states, weights = states[:, -1:], weights[:, None]
                slopes = np.einsum("mtnk,mtn->mk", states, weights)
        ends = np.cumsum([len(k) for k in columns])[:-1]
        result = []
        for k, entries, part_slopes in zip(
            wrt, columns, np.split(slopes, ends, axis=1), strict=True
        ):
            table = np.zeros((len(flat[0]), self.parts[k].size))
            table[:, entries] = part_slopes
            result.append(table.reshape(arrays[k].shape))
        return tuple(result)

    def _columns(self, wrt: tuple[int, ...]) -> tuple[list[AnySymbol], list[np.ndarray]]:
        """Return the parameters to differentiate by, and their columns in each argument."""
        parameters: list[AnySymbol] = []
        columns = []
        for k in wrt:
            starts = np.cumsum([0, *self.parts[k].counts])
            parameters += self._wrt[k]
            part_columns = [
                np.arange(starts[j], starts[j + 1])
                for j, symbol in enumerate(self._symbols[k])
                if symbol in self._wrt[k]
            ]
            columns.append(np.concatenate(part_columns) if part_columns else np.zeros(0, dtype=int))
        return parameters, columns

    def _jacobian(
        self,
        parameters: list[AnySymbol],
        flat: list[np.ndarray],
        lead: tuple[int, ...],
        columns: int,
    ) -> np.ndarray:
        """Return the sensitivities of the states, (m, times, n, k)."""
        m, n, steps = len(flat[0]), len(self._names), len(self._problem.settings.times)
        if not parameters:
            return np.zeros((m, steps, n, 0))
        if self._uses_ensemble(m):
            results = self._ensemble(flat, sensitivities=parameters)
            table = results["sensitivity"].sel(quantity=list(self._names))
            slopes = table.transpose("sample", "time", "quantity", "parameter").values
            late = after_end(results, self._problem.settings.times)
            self._check_reached(late[:, -1].any())
            return np.where(late[:, :, None, None], 0.0, slopes)

        def slopes_of(row: list[np.ndarray]) -> np.ndarray:
            slopes = self._motion(row, parameters).sensitivities
            assert slopes is not None
            missing = steps - len(slopes)
            self._check_reached(missing > 0)
            return np.pad(slopes, ((0, missing), (0, 0), (0, 0)))

        result = np.empty((m, steps, n, columns))
        for k in range(m):
            result[k] = self._nan_if_batched(lead, slopes_of, [array[k] for array in flat])
        return result

    def _check_reached(self, missed: bool | np.bool_) -> None:
        if missed and self._final:
            remedy = "Use reverse derivatives: jax.grad or jax.vjp, backward() of PyTorch."
            if self._problem.hybrid is not None:
                remedy = "With `contacts`, events that are not terminal have derivatives."
            raise ValueError(
                "`final` goes forward to times that are given, but a terminal event ended the "
                f"motion. {remedy}"
            )

    def _adjoint(
        self, parameters: list[AnySymbol], row: list[np.ndarray], weights: np.ndarray
    ) -> np.ndarray:
        """Return the gradient of the weighted sum of the last state."""
        if not parameters:
            return np.zeros(0)
        problem = self._problem_of(row)
        _, slopes, _ = motion_and_gradient(
            problem,
            problem.settings.times,
            parameters,
            final=None,
            integral=None,
            solver=explicit_solver(self._solver),
            options=dict(self._options),
            weights=weights,
        )
        result: np.ndarray = slopes
        return result


def _check_independent(symbols: Sequence[AnySymbol], solved_for: Sequence[AnySymbol]) -> None:
    """Refuse initial conditions that the constraints would replace."""
    replaced = [s for s in symbols if s in solved_for]
    if replaced:
        raise ValueError(
            f"`x` has the initial condition of {describe(replaced)}, but the constraints are "
            f"solved for {describe(solved_for)}. Leave it out, give all states, or make it "
            "independent: call set_dependent_initial_conditions(dep_vars=…) with other variables "
            "before you make the layer."
        )


def _one_by_one(
    problem: Problem, parts: tuple[ArgumentPart, ...]
) -> dict[AnySymbol | tuple[AnySymbol, ...], object]:
    """Return the specifieds by single symbols, so that each can be replaced.

    The specifieds of one Python function have a common entry, unless an argument replaces some.
    """
    plan = problem.plan
    numbers = dict(zip(plan.symbols, plan.inputs.values.tolist(), strict=True))
    specifieds: dict[AnySymbol | tuple[AnySymbol, ...], object] = {
        s: numbers[s] for s in plan.symbols if s in plan.given
    }
    specifieds |= plan.expressions
    for columns, samples in plan.inputs.sampled:
        for j, k in enumerate(columns):
            specifieds[plan.symbols[k]] = samples.of([j])
    for columns, function in plan.with_zeros(replaced_specifieds(parts)).inputs.functions:
        symbols = tuple(plan.symbols[k] for k in columns)
        specifieds = {s: v for s, v in specifieds.items() if s not in symbols}
        specifieds[symbols] = function
    return specifieds


def _distinct(flat: list[np.ndarray]) -> tuple[list[np.ndarray], np.ndarray]:
    """Return the distinct samples, and the index of each sample among these."""
    table = np.concatenate(flat, axis=1)
    _, first, back = np.unique(table, axis=0, return_index=True, return_inverse=True)
    return [array[first] for array in flat], back.reshape(-1)
