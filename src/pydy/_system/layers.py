"""A System's functions for libraries that differentiate: JAX and PyTorch."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from copy import copy
from itertools import accumulate
from typing import Any

import numpy as np

from pydy._checks import Places, describe
from pydy._errors import IntegrationError, SingularMatrixError
from pydy._forks import Lock
from pydy._graph.products import derivative_program
from pydy._graph.program import Program
from pydy._kernel import Kernel
from pydy._names import unique_names
from pydy._simulation.definition import refuse_descending
from pydy._simulation.events_and_constraints import native_solver
from pydy._simulation.missing_derivatives import warn_of_missing_derivatives
from pydy._simulation.problem import Problem
from pydy._system.setup import Setup
from pydy.analysis.adjoint import explicit_solver, there_and_back
from pydy.codegen.arguments import SpecifiedsPlan
from pydy.inputs import SampledInput
from pydy.layers.layer import Function, Given, Layer, Part
from pydy.solvers.outcome import EVENTS_ACCUMULATE, TERMINATED

_KINDS = {"x": "states", "r": "specifieds", "p": "constants"}


def _plan(problem: Problem, part: Part | None) -> SpecifiedsPlan:
    """Return the plan of the specifieds, with numbers for those in the layer's arguments."""
    if part is None:
        return problem.plan
    places = problem.definition.places["specifieds"]
    zeros = dict.fromkeys((places.symbols[k] for k in part.places), 0.0)
    return problem.plan.updated(SpecifiedsPlan(zeros, places, argument="r"))


def _rows(base: np.ndarray, part: Part | None, given: Any, m: int) -> np.ndarray:
    """Return m rows of `base`, or of (m, n), with some entries replaced."""
    rows: np.ndarray = np.array(np.broadcast_to(base, (m, base.shape[-1])), order="C")
    if part is not None:
        rows[:, list(part.places)] = given
    return rows


def _runs(rows: np.ndarray) -> Iterator[slice]:
    """Return stretches of equal rows."""
    ends = np.flatnonzero((rows[1:] != rows[:-1]).any(axis=1)) + 1
    for start, stop in zip([0, *ends], [*ends, len(rows)], strict=True):
        yield slice(start, stop)


class _Values:
    """A block of the equations as a function of x, t, r and p."""

    def __init__(self, problem: Problem, block: str, parts: tuple[Part, ...]) -> None:
        self.now, self.block, self.parts = problem, block, parts
        self._of = {part.group: part for part in parts}
        self._plan = _plan(problem, self._of.get("r"))
        self._model = problem.model.with_compiled_inputs(self._plan)
        self._check_unknowns()
        self._kernel = self._model.compiled(block)
        self.shape: tuple[int, ...] = (len(self._kernel.program.outputs),)
        self._products: dict[Any, tuple[Kernel, list[Part]]] = {}

    def _check_unknowns(self) -> None:
        """Refuse to take the unknowns of an `Implicit` from before, where others follow."""
        blocks = self.now.definition.equations.residual_blocks
        if not blocks or ("x" in self._of and self._of["x"].whole):
            return
        assembly = self._model.assembly
        g, rows = assembly.graph, [assembly.holonomic[k] for own, _ in blocks for k in own]
        held = {g.args[n] for n in g.inputs(rows)}
        if any((part.group, k) in held for part in self.parts for k in part.places):
            unknowns = [self.now.definition.states[k] for _, places in blocks for k in places]
            raise ValueError(
                f"`x` must be an array of whole states where the values of a call change what the "
                f"residuals of `implicit` give, {describe(unknowns)}: layers solve for that in "
                "`simulate` and `final` alone. `evaluate_ode` and `evaluate_outputs` solve for it."
            )

    def _evaluate(self, kernel: Kernel, given: Given, more: np.ndarray | None = None) -> np.ndarray:
        """Return the outputs of a Kernel, (…, o); `more` are inputs after r."""
        lead = given[0].shape[:-1]
        if not lead:
            return self._at(kernel, given, more)
        if 0 in lead:
            return np.empty((*lead, len(kernel.program.outputs)))
        flat = [one.reshape(-1, one.shape[-1]) for one in given]
        own = {part.group: one for part, one in zip(self.parts, flat, strict=True)}
        m, problem, of = len(flat[0]), self.now, self._of
        x = _rows(problem.x, of.get("x"), own.get("x"), m)
        t = np.ascontiguousarray(own["t"][:, 0]) if "t" in own else np.full(m, problem.t)
        self._plan.check_times(t, "t")
        r = _rows(self._plan.rows(x, t), of.get("r"), own.get("r"), m)
        if more is not None:
            r = np.hstack([r, more.reshape(m, -1)])
        p = _rows(problem.p, of.get("p"), own.get("p"), m)
        found = [self._model.evaluate(kernel, t[k], x[k], r[k], p[k.start]) for k in _runs(p)]
        whole = found[0] if len(found) == 1 else np.concatenate(found)
        return whole.reshape(*lead, -1)

    def _at(self, kernel: Kernel, given: Given, more: np.ndarray | None) -> np.ndarray:
        """Do the same at one state, where the time of a call counts."""
        problem, plan = self.now, self._plan
        own = {"x": problem.x, "p": problem.p}
        t = problem.t
        for part, one in zip(self.parts, given, strict=True):
            group = part.group
            if group == "t":
                t = float(one[0])
            elif part.whole:
                own[group] = one
            elif group != "r":
                own[group] = own[group].copy()
                own[group][list(part.places)] = one
        x, p = own["x"], own["p"]
        r = own.get("r")
        if r is None:
            if plan.sampled:
                plan.check_times(np.array([t]), "t")
            r = plan(x, t)
            if "r" in self._of:
                r[list(self._of["r"].places)] = given[self.parts.index(self._of["r"])]
        if more is not None:
            r = np.concatenate([r, more])
        out = np.empty(len(kernel.program.outputs))
        if kernel.at(x, t, r, p, out):
            raise self._model.singular(t, x)
        return out

    def value(self, *given: np.ndarray) -> np.ndarray:
        return self._evaluate(self._kernel, given)

    def _product(self, kind: str, wanted: tuple[int, ...]) -> tuple[Kernel, list[Part]]:
        """Return the Kernel of a product with the Jacobian, and the variables it is taken by."""
        known = self._products.get((kind, wanted))
        if known is not None:
            return known
        for _, _, label in self._plan.functions:
            raise ValueError(
                f"Derivatives need those of the specifieds, but {label} is a Python function, "
                "which has none. Give it as a SymPy expression of states, time and constants, as "
                "samples, pydy.inputs.SampledInput(times, values), or in `r`."
            )
        parts = [self.parts[k] for k in wanted]
        s = len(self.now.definition.specifieds)
        if self._plan.sampled and any(part.group == "t" for part in parts):
            parts.append(Part("r", (*range(s),), (1,) * s, True))  # samples change with time
        by = tuple((part.group, k) for part in parts for k in part.places)
        model, block = self._model, self.block
        assembly = model.assembly

        def program() -> Program:
            graph, nodes = assembly.simplified(block)
            return derivative_program(graph, nodes, by, kind, assembly.sizes)

        kernel = model.compiled_by(("product", kind, block, (), by, 1), program)
        self._products[kind, wanted] = kernel, parts
        return kernel, parts

    def _slopes(self, wanted: tuple[int, ...], given: Given) -> np.ndarray:
        """Return the derivatives of sampled specifieds by time, (…, s)."""
        t = np.full(given[0].shape[:-1], self.now.t)
        for part, one in zip(self.parts, given, strict=True):
            t = one[..., 0] if part.group == "t" else t
        slopes = np.zeros((*t.shape, len(self.now.definition.specifieds)))
        own = self._of.get("r")
        for columns, samples in self._plan.sampled:
            found = [samples.slopes_at(float(instant)) for instant in t.ravel()]
            slopes[..., columns] = np.reshape(found, (*t.shape, len(columns)))
        if own is not None:
            slopes[..., list(own.places)] = 0.0
        return slopes

    def forward(self, wanted: tuple[int, ...], given: Given, along: Given) -> np.ndarray:
        kernel, parts = self._product("jacobian-vector", wanted)
        directions = [*along]
        if len(parts) > len(wanted):
            k = next(k for k, part in enumerate(parts) if part.group == "t")
            directions.append(along[k] * self._slopes(wanted, given))
        return self._evaluate(kernel, given, np.concatenate(directions, axis=-1))

    def backward(self, wanted: tuple[int, ...], given: Given, weights: np.ndarray) -> Given:
        kernel, parts = self._product("vector-jacobian", wanted)
        found = self._evaluate(kernel, given, weights)
        stops = [*accumulate(part.size for part in parts)]
        columns = [found[..., a:b] for a, b in zip([0, *stops], stops, strict=False)]
        if len(parts) > len(wanted):
            k = next(k for k, part in enumerate(parts) if part.group == "t")
            extra = (columns.pop() * self._slopes(wanted, given)).sum(axis=-1, keepdims=True)
            columns[k] = columns[k] + extra
        return tuple(columns)


class _Motion:
    """The states of a simulation, or the last of them, as a function of x, r and p."""

    def __init__(
        self, system: Any, problem: Problem, final: bool, parts: tuple[Part, ...], contacts: Any,
        options: Any,
    ) -> None:  # fmt: skip
        self.parts, self._final, self._options = parts, final, options
        self._times = problem.checked_times(problem.times)
        definition = problem.definition
        n = len(definition.states)
        self.shape: tuple[int, ...] = (n,) if final else (len(self._times), n)
        self._twin = system = copy(system)  # what is set on it does not reach the user's
        self._contacts = contacts and contacts.of(system)
        system._searching = True
        system.ode_solver = native_solver(system.ode_solver)
        system.initial_conditions = dict(zip(definition.states, problem.x.tolist(), strict=True))
        system.constants = problem.constants
        system.times = self._times
        plan = problem.plan
        given = [s for s in plan.symbols if s in plan.given and s not in plan.expressions]
        numbers = dict(zip(plan.symbols, plan.values.tolist(), strict=True))
        self._samples: dict[Any, SampledInput] = {}
        kept: dict[Any, Any] = {s: numbers[s] for s in given} | plan.expressions
        for columns, samples in plan.sampled:
            for j, k in enumerate(columns):
                kept[plan.symbols[k]] = self._samples[plan.symbols[k]] = samples.of([j])
        own = next((part for part in parts if part.group == "r"), None)
        for columns, function, _ in _plan(problem, own).functions:  # of what `r` does not give
            names = tuple(plan.symbols[k] for k in columns)
            kept = {s: v for s, v in kept.items() if s not in names} | {names: function}
        system.specifieds = kept
        self._dependent = [] if system._dependent is None else [*system._dependent]
        following = [definition.states[k] for k in problem.dependent]
        self._entries: list[list[Any]] = []  # the symbols of each part
        self._by: list[list[Any]] = []  # those to differentiate by
        for part in parts:
            symbols = definition.places[_KINDS[part.group]].symbols
            entries = [symbols[k] for k in part.places]
            self._entries.append(entries)
            skipped = following if part.whole and part.group == "x" else ()
            self._by.append([s for s in entries if s not in skipped])
            if part.group == "x" and part.whole:
                self._dependent = []  # as they are given
        self._keys = {"x": "initial_conditions", "r": "specifieds", "p": "constants"}
        self._base = {k: getattr(system, k) for k in self._keys.values()}
        self._names = unique_names(definition.states)
        self._lock = Lock()

    def _set(self, row: list[np.ndarray]) -> None:
        """Set the values of one sample."""
        for part, entries, values in zip(self.parts, self._entries, row, strict=True):
            key = self._keys[part.group]
            pieces = np.split(values, np.cumsum(part.counts)[:-1])
            new: dict[Any, Any] = {}
            for symbol, piece in zip(entries, pieces, strict=True):
                known = self._samples.get(symbol) if part.group == "r" and not part.whole else None
                if known is None:
                    new[symbol] = float(piece[0])
                else:
                    new[symbol] = SampledInput(known.times, piece, known.interpolation)
            whole = part.group == "r" and part.whole
            setattr(self._twin, key, new if whole else {**self._base[key], **new})
        if self._dependent:
            self._twin.set_dependent_initial_conditions(self._dependent)

    def _flat(self, given: Given) -> list[np.ndarray]:
        return [one.reshape(-1, one.shape[-1]) for one in given]

    def _together(self, m: int) -> bool:
        """Tell whether samples are integrated side by side."""
        sampled = any(count > 1 for part in self.parts for count in part.counts)
        whole = any(part.group == "r" and part.whole for part in self.parts)
        return m > 1 and not (sampled or whole or self._dependent)

    def _ensemble(self, flat: list[np.ndarray], **more: Any) -> Any:
        """Integrate all samples; the values are by keyword of `integrate_ensemble`."""
        varied: dict[str, dict[Any, Any]] = {}
        for part, entries, values in zip(self.parts, self._entries, flat, strict=True):
            columns = np.ascontiguousarray(values.T)
            varied[self._keys[part.group]] = dict(zip(entries, columns, strict=True))
        more = {**more, **self._options, "contacts": self._contacts}
        return self._twin.integrate_ensemble(**varied, **more)

    def _one(self, row: list[np.ndarray], by: list[Any] | None = None) -> Any:
        self._set(row)
        if self._contacts is not None:
            return self._contacts.simulate(sensitivities=by, **self._options)
        options = {"dense_output": False, **self._options}
        return self._twin.simulate(sensitivities=by, **options)

    def value(self, *given: np.ndarray) -> np.ndarray:
        flat, lead = self._flat(given), given[0].shape[:-1]
        m = len(flat[0])
        with self._lock:
            if self._together(m):
                found = self._ensemble(flat)
                states = np.stack([found[name].values for name in self._names], axis=-1)
                values = states[:, -1].copy() if self._final else states
                rest = np.flatnonzero(self._late(found)[:, -1] & self._final).tolist()
            else:
                values, rest = np.empty((m, *self.shape)), [*range(m)]
            for k in rest:
                values[k] = self._or_nan(lead, self._state, [one[k] for one in flat])
        return values.reshape(*lead, *self.shape)

    def _or_nan(self, lead: tuple[int, ...], of: Callable[..., Any], *given: Any) -> Any:
        """Return a function of one sample; NaN where that fails and is one of several."""
        try:
            return of(*given)
        except (IntegrationError, SingularMatrixError):
            if not lead:
                raise
            return np.nan

    def _late(self, found: Any) -> np.ndarray:
        """Return which times of an ensemble's samples are behind their last event, (m, times)."""
        ended = np.isin(found["status"].values, (TERMINATED, EVENTS_ACCUMULATE))
        late: np.ndarray = ended[:, None] & (self._times > found["end_time"].values[:, None])
        return late

    def _state(self, row: list[np.ndarray]) -> np.ndarray:
        trajectory = self._one(row)
        states, missing = trajectory.states, len(self._times) - len(trajectory.times)
        if self._final:
            last: np.ndarray = trajectory.events[-1].after if missing else states[-1]
            return last
        return np.pad(states, ((0, missing), (0, 0)), constant_values=np.nan)

    def _columns(self, wanted: tuple[int, ...]) -> tuple[list[Any], list[np.ndarray]]:
        """Return the parameters to differentiate by, and their columns in each argument."""
        by: list[Any] = []
        places = []
        for k in wanted:
            entries, counts = self._entries[k], self.parts[k].counts
            starts = np.cumsum([0, *counts])
            by += self._by[k]
            mine = [
                np.arange(starts[j], starts[j + 1])
                for j, symbol in enumerate(entries)
                if symbol in self._by[k]
            ]
            places.append(np.concatenate(mine) if mine else np.zeros(0, dtype=int))
        return by, places

    def _check_reached(self, missed: Any) -> None:
        if missed and self._final:
            remedy = "Use reverse derivatives: jax.grad or jax.vjp, backward() of PyTorch."
            if self._contacts is not None:
                remedy = "With `contacts`, events that are not terminal have derivatives."
            raise ValueError(
                "`final` goes forward to times that are given, but a terminal event ended the "
                f"motion. {remedy}"
            )

    def _jacobian(
        self, by: list[Any], flat: list[np.ndarray], lead: tuple[int, ...], columns: int
    ) -> np.ndarray:
        """Return the sensitivities of the states, (m, times, n, k)."""
        m, n = len(flat[0]), len(self._names)
        if not by:
            return np.zeros((m, len(self._times), n, 0))
        if self._together(m):
            whole = self._ensemble(flat, sensitivities=by)
            states = whole["sensitivity"].sel(quantity=list(self._names))
            states = states.transpose("sample", "time", "quantity", "parameter").values
            late = self._late(whole)
            self._check_reached(late[:, -1].any())
            return np.where(late[:, :, None, None], 0.0, states)

        def slopes(row: list[np.ndarray]) -> np.ndarray:
            values = self._one(row, by).sensitivity.values[:, :n]
            missing = len(self._times) - len(values)
            self._check_reached(missing > 0)
            return np.pad(values, ((0, missing), (0, 0), (0, 0)))

        result = np.empty((m, len(self._times), n, columns))
        for k in range(m):
            result[k] = self._or_nan(lead, slopes, [one[k] for one in flat])
        return result

    def forward(self, wanted: tuple[int, ...], given: Given, along: Given) -> np.ndarray:
        by, places = self._columns(wanted)
        lead = given[0].shape[:-1]
        distinct, back = _distinct(self._flat(given))
        with self._lock:
            slopes = self._jacobian(by, distinct, lead, sum(map(len, places)))
        slopes = slopes[:, -1] if self._final else slopes
        directions = [d.reshape(-1, d.shape[-1])[:, k] for d, k in zip(along, places, strict=True)]
        product = np.einsum("m...k,mk->m...", slopes[back], np.concatenate(directions, axis=-1))
        found: np.ndarray = product
        return found.reshape(*lead, *self.shape)

    def backward(self, wanted: tuple[int, ...], given: Given, weights: np.ndarray) -> Given:
        by, places = self._columns(wanted)
        flat, lead = self._flat(given), given[0].shape[:-1]
        weights = weights.reshape(len(flat[0]), *self.shape)
        with self._lock:
            if self._final and self._contacts is None:
                found = np.empty((len(weights), sum(map(len, places))))
                for k, w in enumerate(weights):
                    found[k] = self._or_nan(lead, self._back, by, [one[k] for one in flat], w)
            else:
                distinct, back = _distinct(flat)
                slopes = self._jacobian(by, distinct, lead, sum(map(len, places)))[back]
                if self._final:
                    slopes, weights = slopes[:, -1:], weights[:, None]
                found = np.einsum("mtnk,mtn->mk", slopes, weights)
        ends = np.cumsum([len(k) for k in places])[:-1]
        result = []
        for k, mine, columns in zip(wanted, places, np.split(found, ends, axis=1), strict=True):
            whole = np.zeros((len(flat[0]), self.parts[k].size))
            whole[:, mine] = columns
            result.append(whole.reshape(given[k].shape))
        return tuple(result)

    def _back(self, by: list[Any], row: list[np.ndarray], weights: np.ndarray) -> np.ndarray:
        """Return the derivatives of the weighted sum of the last state."""
        if not by:
            return np.zeros(0)
        self._set(row)
        system = self._twin
        _, _, values, _ = there_and_back(
            system._now(self._options.get("events")),
            system.times,
            by,
            final=None,
            integral=None,
            solver=explicit_solver(system.ode_solver),
            options=dict(self._options),
            weights=weights,
        )
        found: np.ndarray = values
        return found


def _distinct(flat: list[np.ndarray]) -> tuple[list[np.ndarray], np.ndarray]:
    """Return the samples without repetitions, and which of them each sample is."""
    whole = np.concatenate(flat, axis=1)
    _, first, back = np.unique(whole, axis=0, return_index=True, return_inverse=True)
    return [one[first] for one in flat], back.reshape(-1)


class _Frozen:
    """The functions of a System as it was."""

    def __init__(self, system: Any, contacts: Any, options: dict[str, Any]) -> None:
        self._now = system._now(options.get("events"), contacts=contacts)
        warn_of_missing_derivatives(self._now)
        self._system, self._contacts, self._options = copy(system), contacts, options
        self._made: dict[Any, Function] = {}

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_made": {}}  # which hold locks, and are made again

    def places(self, group: str) -> Places:
        places: Places = self._now.definition.places[_KINDS[group]]
        return places

    def counts(self, kind: str, group: str, places: tuple[int, ...]) -> tuple[int, ...]:
        numbers = dict.fromkeys(places, 1)
        if group == "r" and kind in ("simulate", "final"):
            for columns, samples in self._now.plan.sampled:
                numbers |= {k: len(samples.times) for k in columns.tolist() if k in numbers}
        return tuple(numbers[k] for k in places)

    def start(self) -> np.ndarray:
        x: np.ndarray = self._now.x
        return x

    def function(self, kind: str, parts: tuple[Part, ...]) -> Function:
        made = self._made.get((kind, parts))
        if made is None:
            made = self._made[kind, parts] = self._make(kind, parts)
        return made

    def _make(self, kind: str, parts: tuple[Part, ...]) -> Function:
        problem = self._now
        if kind == "outputs" and not problem.definition.outputs_symbols:
            raise ValueError("The system has no outputs to evaluate. Set `system.outputs`.")
        if kind in ("ode", "outputs"):
            return _Values(problem, {"ode": "rates", "outputs": "outputs"}[kind], parts)
        if len(problem.times) < 2:
            raise ValueError(
                f"`times` must have at least two values before `{kind}` can be called, got "
                f"{len(problem.times)}. Set `system.times`, and make the layer after that."
            )
        refuse_descending(problem.times, f"`{kind}` integrates forward only")
        final = kind == "final"
        return _Motion(self._system, problem, final, parts, self._contacts, self._options)


class Layers(Setup):
    """Differentiable functions for other libraries."""

    def as_jax(self, *, contacts: Any = None, **solver_kwargs: Any) -> Layer:
        """Return the equations and simulations as functions of JAX.

        They are compiled as for `evaluate_ode` and `simulate`. They work under `jax.jit`,
        `jax.vmap` (one call for all samples; simulations as an ensemble), `jax.grad`, `jax.vjp` and
        `jax.jvp`. Second derivatives are refused.

        Parameters
        ----------
        contacts : pydy.contact.Contacts, optional
            Contacts of this System, which simulations are done with; their constants are arguments
            too.
        **solver_kwargs
            Options of the `ode_solver` for simulations, as in `simulate`; ``'dop853'`` is used if
            it is not native.

        Returns
        -------
        Layer
            ``ode``, ``outputs``, ``simulate`` and ``final``, of the system as it is now.

        Raises
        ------
        ImportError
            A package is missing: ``pip install 'pydy[jax]'``.
        TypeError
            JAX computes with float32: ``jax.config.update('jax_enable_x64', True)``.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> import jax  # doctest: +SKIP
        >>> jax.config.update('jax_enable_x64', True)  # doctest: +SKIP
        >>> layer = system.as_jax()  # doctest: +SKIP
        >>> jax.jit(layer.ode)([1.0, 0.0])  # doctest: +SKIP
        Array([ 0., -1.], dtype=float64)
        """
        from pydy.layers.of_jax import JaxArrays

        return Layer(_Frozen(self, contacts, solver_kwargs), JaxArrays(), "JAX")

    def as_torch(self, *, contacts: Any = None, **solver_kwargs: Any) -> Layer:
        """Return the equations and simulations as functions of PyTorch.

        They take and return tensors of float64, and work with autograd, and with `torch.func`:
        `grad`, `vjp`, `jvp` and `vmap`. Second derivatives are refused.

        Parameters
        ----------
        contacts, **solver_kwargs
            As in `as_jax`.

        Returns
        -------
        Layer
            As of `as_jax`.

        Raises
        ------
        ImportError
            A package is missing: ``pip install 'pydy[torch]'``.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> layer = multi_mass_spring_damper().as_torch()  # doctest: +SKIP
        >>> layer.ode([1.0, 0.0])  # doctest: +SKIP
        tensor([ 0., -1.], dtype=torch.float64)
        """
        from pydy.layers.of_torch import TorchArrays

        return Layer(_Frozen(self, contacts, solver_kwargs), TorchArrays(), "PyTorch")
