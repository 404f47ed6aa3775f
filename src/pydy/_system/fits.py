"""Fits of a System to trials: residuals and their Jacobian from simulations with sensitivities."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from copy import copy
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from pydy._checks import (
    Places,
    check_mapping,
    choice,
    describe,
    flag,
    limits,
    listed,
    merged,
    one_or_more,
    positive,
    real_array,
    refuse_twice,
    whole,
)
from pydy._errors import (
    FitInterrupted,
    IntegrationError,
    SingularMatrixError,
    note_finished,
    warn_user,
)
from pydy._names import unique_names
from pydy._optional import progress_of
from pydy._simulation.events_and_constraints import native_solver
from pydy._simulation.scipy_solvers import SolveIvp, call_odeint, is_odeint
from pydy._simulation.states import located
from pydy._simulation.tuning import FIT
from pydy._system.setup import Setup
from pydy._system.trials import Data, checked_trial, in_units_of_noise, warn_of_estimates
from pydy.analysis.fit import FitResult, covariance_of, estimate, held_by
from pydy.analysis.residuals import told_of_correlation
from pydy.analysis.trial import Trial
from pydy.analysis.tuning import LEAST_SIZE, ON_GIVEN_MESH
from pydy.solvers.solver import SOLVERS

# Weights of the gaps between segments, in shares of a state's spread, from search to search.
_STAGES = (1e1, 1e3, 1e5)


@dataclass(frozen=True)
class _Part:
    """A piece of a trial that is simulated at once: samples ``first <= k < last``."""

    first: int
    last: int
    begin: float  # its time
    end: float
    column: int | None  # of the unknown states at its beginning; None for those of the trial


class _Fit:
    def __init__(
        self, system: Any, parameters: Any, trials: list[Trial], segments: int, contacts: Any,
        options: Any,
    ) -> None:  # fmt: skip
        self.system = system
        self.runner = copy(system)
        self.runner._searching = True
        self.runner.ode_solver = native_solver(system.ode_solver)
        self.options = {"rtol": FIT, "atol": FIT, **options}
        self.exact = "atol" in options
        self.tolerance = float(np.max(self.options["rtol"]))
        keys = one_or_more("parameters", parameters, hashable=True)
        given: dict[Any, Any] = dict.fromkeys(keys)
        for trial in trials:
            given |= check_mapping("constants", getattr(trial, "constants", None))
        self.now = system._now(self.options.get("events"), given, contacts)
        self.moving = self.runner if contacts is None else contacts.of(self.runner)
        definition = self.now.definition
        self.expressions: dict[Any, Any] = {}
        self.data = [
            checked_trial(k, trial, definition, self.expressions) for k, trial in enumerate(trials)
        ]
        if len({d.trial.noise is None for d in self.data}) > 1:
            raise ValueError("Give the `noise` of all trials, or of none.")
        self.own_noise = self.data[0].trial.noise is None
        self.samples = sum(int(np.isfinite(d.values).sum()) for d in self.data)
        if self.expressions:
            added = {name: expression for expression, name in self.expressions.items()}
            self.runner.outputs = {**system.outputs, **added}
        equations = definition.equations
        self.tied = tied = tuple(definition.states[k] for k in self.now.dependent)
        if tied:
            self.options.setdefault("constraints", "project")
        self.order = definition.states
        self.free = [s for s in (*equations.coordinates, *equations.speeds) if s not in tied]
        found = [located(definition, key, "parameters") for key in keys]
        self.shared = [(kind, definition.places[kind].symbols[place]) for kind, place in found]
        start = [self.now.value(kind, place) for kind, place in found]
        refuse_twice([symbol for _, symbol in self.shared], "parameters")
        self.names = list(unique_names([s for _, s in self.shared]))
        self.columns: list[int] = []
        self.initial = [self._initial(d) for d in self.data]
        self.constants = [self._others("constants", d) for d in self.data]
        self.specifieds = [self._others("specifieds", d) for d in self.data]
        for d, initial in zip(self.data, self.initial, strict=True):
            self.columns.append(len(self.names))
            self.names += [f"{unique_names([symbol])[0]} of {d.label}" for symbol in d.unknown]
            start += [initial[symbol] for symbol in d.unknown]
        self.count = len(self.names)  # of parameters proper
        if not self.count:
            raise ValueError("`parameters` must name at least one constant or state.")
        self.parts = [self._split(d, segments) for d in self.data]
        self.start = np.array(start)
        self.spread = np.ones(len(self.free))
        self.largest, self.sizes = np.zeros(len(self.order)), np.ones(len(self.order))
        self.limits = np.empty(0), np.empty(0)
        self.priors: list[tuple[int, float, float]] = []
        self.gaps = 0.0
        self.is_gap = np.empty(0, dtype=bool)

    def _others(self, argument: str, d: Data) -> dict[Any, Any]:
        """Return the values of a trial that are no parameters, by their symbols."""
        places, label = self.now.definition.places[argument], f"{argument} of {d.label}"
        parameters = {symbol for _, symbol in self.shared}
        for symbol in parameters.intersection(d.unknown):
            raise ValueError(
                f"`{symbol}` is unknown in {d.label}, and a parameter of all trials too."
            )
        values: dict[Any, Any] = {}
        for what, owner in ((argument, self.system), (label, d.trial)):
            given = merged(check_mapping(what, getattr(owner, argument)))
            own = places.by_symbol(given, what, others=True)
            if owner is d.trial:
                numbers = {s: v for s, v in own.items() if isinstance(v, (int, float))}
                self.now.check_values(argument, numbers, f"`{what}` for ")
            if len(self.data) > 1 and owner is d.trial and (both := parameters & own.keys()):
                raise ValueError(
                    f"`{what}` gives {describe([*both])} a value of its own, but `parameters` "
                    "names it, for all trials. Leave one of them out."
                )
            values |= own
        return {key: value for key, value in values.items() if key not in parameters}

    def _initial(self, d: Data) -> dict[Any, float]:
        now, argument = self.now, f"initial_conditions of {d.label}"
        states = now.definition.places["states"]
        given = merged(check_mapping(argument, d.trial.initial_conditions))
        x = now.x_with(given, argument)
        own = {s: x[k] for k, s in enumerate(states.symbols) if s in states.chosen(given, argument)}
        now.check_values("states", own, f"`{argument}` for ")
        start = now.at(np.array([d.start]), x[None]).with_unknowns({}, now.plan.rows)
        return dict(zip(states.symbols, start.x[0].tolist(), strict=True))

    def choose_solver(self) -> None:
        """Take 'radau' for SciPy's implicit methods, and where odeint goes over to its own.

        Equations are stiff there: an explicit method takes as many steps as keep it stable,
        whatever its tolerance.
        """
        own, part, times = self.system.ode_solver, self.parts[0][0], self.data[0].times
        times = np.unique(np.append(part.begin, times[part.first : part.last]))
        stiff = isinstance(own, SolveIvp) and own.method.__name__ in ("Radau", "BDF")
        if is_odeint(own) and "events" not in self.options and len(times) > 1:
            self._set(self.start, 0, part, times)
            now = self.runner._now()

            def rates(x: np.ndarray, t: float) -> np.ndarray:
                found: np.ndarray = now.derivatives(np.array([t]), x[None])[0]
                return found

            with suppress(RuntimeError, SingularMatrixError):  # which the fit itself tells
                _, info = call_odeint(rates, now.x, times, (), self.order, {})
                stiff = bool(np.mean(info["mused"] == 2) > 0.5)  # odeint's method for stiff ones
        if stiff:
            self.runner.ode_solver = SOLVERS["radau"]

    def _split(self, d: Data, segments: int) -> list[_Part]:
        m = len(d.times)
        edges = np.unique(np.linspace(0, m - 1, segments + 1).round().astype(int))
        parts = []
        for j, (a, b) in enumerate(pairwise(edges)):
            column = None
            if j:
                column = len(self.names)
                self.names += [f"{s} of {d.label} at {d.times[a]:g}" for s in self.free]
            first = int(a) + 1 if j else 0
            begin = float(d.times[a]) if j else d.start
            parts.append(_Part(first, int(b) + 1, begin, float(d.times[b]), column))
        if not parts:
            parts = [_Part(0, m, d.start, float(d.times[-1]), None)]
        return parts

    # -- simulations ------------------------------------------------------------------------------

    def motion(self, z: np.ndarray, k: int) -> tuple[Any, np.ndarray, np.ndarray]:
        """Return the System of a trial, and times and states where a search may begin.

        States that are measured are their samples, and speeds that are rates of such coordinates
        the slopes; the others are simulated if they can be, or stay where they are.
        """
        d = self.data[k]
        times = np.unique(np.append(d.start, d.times))
        if len(times) < 2:
            raise ValueError(
                f"`times` of {d.label} must hold a time after the start, got {float(times[0])!r} "
                "alone: collocation needs a motion."
            )
        self._set(z, k, self.parts[k][0], times)
        now = self.runner._now()
        states = np.tile(now.x, (len(times), 1))
        known = {}
        for key, column in zip(d.keys, d.values.T, strict=True):
            there = np.isfinite(column)
            if key in self.order and there.any():
                known[key] = np.interp(times, d.times[there], column[there])
        equations = now.definition.equations
        rates = dict(zip(equations.coordinate_derivatives, equations.coordinates, strict=True))
        for speed, coordinate in rates.items():
            if coordinate in known and speed in self.order and speed not in known:
                known[speed] = np.gradient(known[coordinate], times)
        if len(known) < len(self.order):
            try:
                ride = self.moving.simulate(**self.options)
                if np.isfinite(ride.states).all():
                    states = ride.states.copy()
            except (IntegrationError, SingularMatrixError):
                pass  # the search may begin with states that stand still
        for symbol, column in known.items():
            states[:, self.order.index(symbol)] = column
        return now, times, states

    def _set(
        self, z: np.ndarray, k: int, part: _Part, times: np.ndarray
    ) -> tuple[list[Any], list[int]]:
        """Set the runner's numbers; return the parameters to differentiate by and their columns."""
        d, runner = self.data[k], self.runner
        constants, specifieds = dict(self.constants[k]), dict(self.specifieds[k])
        initial = dict(self.initial[k])
        symbols: list[Any] = []
        columns: list[int] = []
        for j, (kind, symbol) in enumerate(self.shared):
            if kind == "constants":
                constants[symbol] = float(z[j])
            elif kind == "specifieds":
                specifieds[symbol] = float(z[j])
            elif part.column is None:
                initial[symbol] = float(z[j])
            else:
                continue
            symbols.append(symbol)
            columns.append(j)
        own = d.unknown if part.column is None else self.free
        at = self.columns[k] if part.column is None else part.column
        for j, symbol in enumerate(own):
            initial[symbol] = float(z[at + j])
            symbols.append(symbol)
            columns.append(at + j)
        runner.constants, runner.specifieds = constants, specifieds
        runner.initial_conditions, runner.times = initial, times
        if self.tied:
            runner.set_dependent_initial_conditions(self.tied)
        return symbols, columns

    def ride(self, z: np.ndarray, k: int, part: _Part) -> tuple[Any, list[int], int]:
        """Simulate a part; return the trajectory, the columns, and the first sample's place."""
        d = self.data[k]
        times = d.times[part.first : part.last]
        skip = int(not len(times) or times[0] > part.begin)
        times = np.append(part.begin, times) if skip else times
        if len(times) < 2:
            times = np.append(times, times)  # a single sample, where the part begins
        symbols, columns = self._set(z, k, part, times)
        ride = self.moving.simulate(sensitivities=symbols, **self.options)
        self.largest = np.maximum(self.largest, np.abs(ride.states).max(axis=0))
        if len(ride.times) < len(times):
            raise ValueError(
                f"An event ended {d.label} at t = {float(ride.times[-1])!r}, before the last of "
                "its samples. Pass events that are not terminal, or leave out later samples."
            )
        return ride, columns, skip

    def evaluate(self, z: np.ndarray, *, first: bool = False) -> tuple[np.ndarray, np.ndarray]:
        """Return residuals of all trials, then gaps, and their derivatives.

        At the `first` place of a search all must be finite.
        """
        values, slopes, gaps = [], [], []
        for k, d in enumerate(self.data):
            for j, part in enumerate(self.parts[k]):
                ride, columns, skip = self.ride(z, k, part)
                run = slice(skip, skip + part.last - part.first)
                noise = d.noise[part.first : part.last]
                model = np.stack([ride[key][run] for key in d.keys], axis=1)
                there = np.isfinite(d.values[part.first : part.last])
                J = np.zeros((*model.shape, len(z)))
                with np.errstate(all="ignore"):  # what is not finite is no step of the search
                    missed = (model - d.values[part.first : part.last]) / noise
                    for q, key in enumerate(d.keys):
                        J[:, q, columns] = ride.sensitivity[key][run] / noise[:, q, None]
                sound = np.isfinite(missed) & np.isfinite(J).all(axis=2)
                if first and (there & ~sound).any():
                    at, q = np.argwhere(there & ~sound)[0].tolist()
                    raise ValueError(
                        f"`measured[{d.names[q]}]` of {d.label} has no finite value or "
                        "derivatives in the motion that the search begins with: at t = "
                        f"{d.times[part.first + at]:g} it is {model[at, q]:g}. Begin with other "
                        "constants or initial conditions, or measure another expression."
                    )
                values.append(missed[there])
                slopes.append(J[there])
                gaps.append(np.zeros(len(values[-1]), dtype=bool))
                if j + 1 < len(self.parts[k]):
                    following = self.parts[k][j + 1].column
                    assert following is not None
                    places = [self.order.index(s) for s in self.free]
                    scale = self.gaps / self.spread
                    ahead = slice(following, following + len(places))
                    G = np.zeros((len(places), len(z)))
                    with np.errstate(all="ignore"):
                        values.append((ride.states[-1][places] - z[ahead]) * scale)
                        G[:, columns] = ride.sensitivity.values[-1][places] * scale[:, None]
                    G[:, ahead] -= np.diag(scale)
                    slopes.append(G)
                    gaps.append(np.ones(len(G), dtype=bool))
        self.is_gap = np.concatenate(gaps)
        return np.concatenate(values), np.concatenate(slopes)

    def measure(self) -> bool:
        """Set the sizes of the states, and the tolerance; tell whether it became much tighter.

        A state that is small beside the other coordinates, or the other speeds, may be nothing but
        their rounding.
        """
        first = len(self.system.coordinates)
        for part in (slice(first), slice(first, None)):
            largest = self.largest[part]
            size = largest.max(initial=0.0)
            least = min(1.0, LEAST_SIZE * size)
            self.sizes[part] = np.maximum(largest, least) if size > 0.0 else 1.0
        if not self.exact:
            self.options["atol"] = FIT * np.minimum(self.sizes, 1.0)
        return not self.exact and bool(self.sizes.min() < 0.1)  # those of the first runs are 1

    def scales(self) -> np.ndarray:
        """Return sizes of parameters: first values; the largest states for initial conditions."""
        result: np.ndarray = np.abs(self.start)
        states = [s if kind == "states" else None for kind, s in self.shared]
        for k, symbol in enumerate([*states, *(s for d in self.data for s in d.unknown)]):
            if symbol is not None:
                result[k] = self.sizes[self.order.index(symbol)]
        return result

    def guess(self) -> np.ndarray:
        """Return the first guess: at segments the measured states, else the motion so far."""
        z = np.append(self.start, np.zeros(len(self.names) - self.count))
        found = []
        for k, d in enumerate(self.data):
            for j, part in enumerate(self.parts[k][:-1]):
                try:
                    end = self.ride(z, k, part)[0].states[-1].copy()
                except (IntegrationError, SingularMatrixError):
                    end = np.zeros(len(self.order))
                for q, key in enumerate(d.keys):
                    sample = d.values[part.last - 1, q]
                    if key in self.order and np.isfinite(sample):
                        end[self.order.index(key)] = sample
                following = self.parts[k][j + 1].column
                assert following is not None
                ahead = [end[self.order.index(s)] for s in self.free]
                z[following : following + len(ahead)] = ahead
                found.append(ahead)
        if found:
            self.measure()
            places = [self.order.index(s) for s in self.free]
            least = 1e-2 * self.sizes[places]  # the scales at which parts join, at least
            self.spread = np.maximum(np.std(found, axis=0), least)
        return z

    def with_priors(
        self, values: np.ndarray, J: np.ndarray, z: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Append the priors' residuals and derivatives to those of the measurements."""
        pulls = [(z[k] - mean) / s for k, mean, s in self.priors]
        rows = np.zeros((len(pulls), len(z)))
        rows[np.arange(len(pulls)), [k for k, _, _ in self.priors]] = [
            1.0 / s for _, _, s in self.priors
        ]
        return np.append(values, pulls), np.vstack([J, rows])


def _shot(
    work: _Fit, values: np.ndarray, J: np.ndarray
) -> tuple[np.ndarray, np.ndarray, list[dict[str, np.ndarray]]]:
    """Return residuals without gaps, their derivatives by the parameters, and tables of them."""
    k = work.count
    gap = np.append(work.is_gap, np.zeros(len(values) - len(work.is_gap), dtype=bool))
    by_parameters = J[~gap, :k]
    if gap.any():
        # The states between segments follow from the parameters: their gaps stay closed.
        follow = np.linalg.solve(J[gap, k:], -J[gap, :k])
        by_parameters = by_parameters + J[~gap, k:] @ follow
    residuals, start = [], 0
    for d, parts in zip(work.data, work.parts, strict=True):
        table = np.full(d.values.shape, np.nan)
        for j, part in enumerate(parts):
            run = slice(part.first, part.last)
            there = np.isfinite(d.values[run])
            block = np.full(there.shape, np.nan)
            count = int(there.sum())
            block[there] = -values[start : start + count]
            table[run] = block * d.noise[run]
            start += count + (len(work.free) if j + 1 < len(parts) else 0)
        residuals.append(dict(zip(d.names, table.T, strict=True)))
    return values[~gap], by_parameters, residuals


def _collocated(
    work: _Fit,
    z: np.ndarray,
    asked: tuple[Any, dict[int, float], tuple[str, dict[str, Any]], bool],
) -> FitResult:
    """Fit by collocation."""
    from pydy.control.identification import Experiment, Identification
    from pydy.control.solvers import fitting_solver_of

    mesh, noise, solver, progress = asked
    search = fitting_solver_of(*solver)
    order, definition = work.order, work.now.definition
    experiments = []
    for k, d in enumerate(work.data):
        now, at, states = work.motion(z, k)
        if now.plan.functions:
            raise ValueError(
                f"`specifieds` gives a Python function for {now.plan.functions[0][2]}, which has "
                "no derivatives. Give an expression of time and states, or samples."
            )
        weights = np.where(np.isfinite(d.values), 1.0 / d.noise, 0.0)
        unknown, tied = ([order.index(s) for s in part] for part in (d.unknown, work.tied))
        experiments.append(
            Experiment(
                now, d.start, d.times, tuple(d.keys), d.values, weights, tuple(unknown),
                tuple(tied), states, at,
            )
        )  # fmt: skip
    shared = [(kind, definition.places[kind].symbols.index(s)) for kind, s in work.shared]
    fit = Identification(experiments, shared, noise, work.limits, work.priors)

    def watch(iteration: Any) -> None:
        told(1, objective=f"{iteration.objective:.4g}", gap=f"{iteration.violation:.2g}")

    with progress_of(progress, " iterations") as told:
        found = fit.solve(z, mesh, search, watch)
    ended = found.solution
    if ended.interrupted:
        values = dict(zip(work.names, found.z.tolist(), strict=True))
        if isinstance(stop := ended.interrupted, MemoryError):
            note_finished(stop, "The latest estimates are", values=values)
            raise stop
        raise FitInterrupted(
            "The fit was interrupted. Its latest estimates are in `values`.", values
        )
    if not ended.solved:
        warn_user(
            f"The fit did not converge in {ended.iterations} iterations: {ended.message}. "
            "The estimates are the last ones. Start closer to the solution, set `bounds` or raise "
            "`most`."
        )
    work.sizes = found.largest
    tables = []
    for d, missed in zip(work.data, found.residuals, strict=True):
        table = np.where(np.isfinite(d.values), -missed * d.noise, np.nan)
        tables.append(dict(zip(d.names, table.T, strict=True)))
    missed, J = work.with_priors(found.values, found.jacobian, found.z)
    end = ended.solved, ended.message, ended.iterations
    work.tolerance = ON_GIVEN_MESH if mesh is not None else FIT
    return _result(work, found.z, missed, J, tables, len(found.followed), end, not noise)


def _disturbances(work: _Fit, given: Any) -> dict[int, float]:
    """Return the intensities of white noise by places in r."""
    places = work.now.definition.places["specifieds"]
    found: dict[int, float] = {}
    given = check_mapping("process_noise", given)
    columns = places.columns(given, "process_noise").tolist()
    for place, (key, value) in zip(columns, given.items(), strict=True):
        found[place] = positive(value, f"`process_noise[{key}]`", finite=True)
    if found and work.own_noise:
        raise ValueError(
            "`process_noise` needs the `noise` of each Trial: what is noise of the samples and "
            "what of the motion follows from their sizes."
        )
    return found


def _result(
    work: _Fit,
    z: np.ndarray,
    values: np.ndarray,
    J: np.ndarray,
    residuals: list[dict[str, np.ndarray]],
    equations: int,
    ended: tuple[bool, str, int],
    white: bool = True,
) -> FitResult:
    """Return the result of a fit; J holds the derivatives of the values by the parameters.

    So many `equations` were solved for a motion; it `ended` so after some evaluations. Residuals
    are `white` noise unless the motion is disturbed.
    """
    names, k = tuple(work.names[: work.count]), work.count
    degrees = work.samples + len(work.priors) - k
    success, message, evaluations = ended
    noise = float(np.sqrt(values @ values / degrees)) if degrees > 0 else np.nan
    sizes = np.maximum(np.abs(z[:k]), work.scales())
    # Motions are not more accurate than their tolerance, to which each equation is solved.
    samples = [np.nan_to_num(d.values / d.noise).ravel() for d in work.data]
    least = FIT * equations**0.5 * float(np.linalg.norm(np.concatenate(samples)))
    covariance, undetermined = covariance_of(J, z[:k], sizes, names, least)
    if work.own_noise:
        covariance = covariance * noise**2
    held = held_by(z[:k], (work.limits[0][:k], work.limits[1][:k]), names)
    messages = [] if success else [f"The fit did not converge: {message}"]
    messages += warn_of_estimates(undetermined, held)
    if white and success and not held and degrees > 0:
        scaled, least = in_units_of_noise(work.data, residuals, max(work.tolerance, FIT))
        if told := told_of_correlation(scaled, least, not work.own_noise):
            messages.append(told)
            warn_user(told)
    shared = list(zip(work.shared, z.tolist(), strict=False))
    for what in ("constants", "states", "specifieds"):
        estimates = {s: v for (kind, s), v in shared if kind == what}
        work.now.check_values(what, estimates, "The estimate of ")
    return FitResult(
        names=names,
        estimates=z[:k].copy(),
        covariance=covariance,
        constants={s: v for (kind, s), v in shared if kind == "constants"},
        initial_conditions={s: v for (kind, s), v in shared if kind == "states"},
        undetermined=undetermined,
        at_bounds=held,
        residuals=residuals,
        times=[d.times for d in work.data],
        noise=noise,
        degrees=degrees,
        evaluations=evaluations,
        success=success,
        message=message,
        measured=[dict(zip(d.names, d.values.T.copy(), strict=True)) for d in work.data],
        labels=tuple(d.label for d in work.data),
        warnings=tuple(messages),
        noise_given=not work.own_noise,
    )


def _meant(work: _Fit, key: Any, argument: str) -> list[int]:
    """Return the parameters that a key means; a state means that of each trial."""
    shared = Places([s for _, s in work.shared], "parameters of the fit")
    place = shared.get(key, argument)
    if place is not None:
        return [place]
    found = []
    for d, column in zip(work.data, work.columns, strict=True):
        own = Places(d.unknown, "unknown initial conditions")
        place = own.get(key, argument)
        if place is not None:
            found.append(column + place)
    if not found:
        Places(
            [*shared.symbols, *{s: 0 for d in work.data for s in d.unknown}],
            "parameters of the fit",
        ).find(key, argument)
    return found


def _pairs(
    work: _Fit, given: Any, argument: str, read: Callable[[Any, str], tuple[float, float]]
) -> list[tuple[list[int], tuple[float, float]]]:
    """Return pairs of numbers, and the parameters that each is for, none of them twice."""
    given = check_mapping(argument, given)
    found = []
    meant = [_meant(work, key, argument) for key in given]
    refuse_twice([work.names[place] for places in meant for place in places], argument)
    for places, (key, pair) in zip(meant, given.items(), strict=True):
        found.append((places, read(pair, f"`{argument}[{key}]`")))
    return found


def _bounds(work: _Fit, bounds: Any, size: int) -> tuple[np.ndarray, np.ndarray]:
    low, high = np.full(size, -np.inf), np.full(size, np.inf)
    for places, pair in _pairs(work, bounds, "bounds", limits):
        low[places], high[places] = pair
    return low, high


def _prior(value: Any, what: str) -> tuple[float, float]:
    numbers = real_array(value, what)
    if numbers.shape != (2,) or not np.isfinite(numbers).all() or not numbers[1] > 0.0:
        raise ValueError(
            f"{what} must be a pair of the mean and the positive standard deviation, got {value}."
        )
    return float(numbers[0]), float(numbers[1])


def _check_method(
    collocated: bool, segments: int, own: Mapping[str, Any], options: Mapping[str, Any]
) -> None:
    """Refuse arguments of the other method."""
    if collocated and segments > 1:
        raise ValueError(
            "`segments` belongs to method='shooting'. With collocation, `mesh` is the number of "
            "intervals."
        )
    if collocated and "events" in options:
        raise ValueError(
            "`events` need method='shooting': collocation takes the equations of motion alone."
        )
    if not collocated:
        for name, value in own.items():
            if value is not None:
                raise ValueError(f"`{name}` needs method='collocation'.")


class Fitting(Setup):
    """Fits to measured motions."""

    def fit(
        self,
        parameters: Iterable[Any],
        trials: Trial | Iterable[Trial],
        *,
        bounds: dict[Any, Any] | None = None,
        priors: dict[Any, Any] | None = None,
        segments: int = 1,
        method: str = "shooting",
        mesh: Any = None,
        process_noise: Mapping[Any, Any] | None = None,
        solver: str | None = None,
        most: int = 100,
        progress: bool = False,
        contacts: Any = None,
        **solver_kwargs: Any,
    ) -> FitResult:
        """Estimate parameters from measured motions by least squares with exact derivatives.

        The search starts from the System's values; quantities that are not parameters keep these
        values.

        Parameters
        ----------
        parameters : symbol, name, or iterable of these
            Constants, including those in expressions for specifieds; specifieds that are numbers;
            and states, for their initial conditions. All trials share these parameters. Unknown
            initial conditions of single trials are listed in `Trial.unknown`.
        trials : Trial or iterable of Trial
            The measurements.
        bounds : dict, optional
            Maps parameters to pairs of the lowest and the highest value; None is no limit.
        priors : dict, optional
            Maps parameters to pairs of the mean and the standard deviation of prior knowledge,
            relative to the samples, whose weight is given by `Trial.noise`, which is then needed.
        segments : int, optional
            Number of segments into which each trial is divided. Each has its own initial state, and
            all must meet in the end: multiple shooting, for long or unstable motions.
        method : {'shooting', 'collocation'}, optional
            Simulations from the initial conditions, or collocation, where all states are unknown
            and the equations hold in the end: for unstable motions, feedback with unknown gains and
            disturbances. It needs IPOPT, ``pip install 'pydy[optimal]'``.
        mesh : int or array_like, optional
            Of collocation: the number of equal intervals of each trial, or ascending nodes, which
            are scaled to its duration. By default the mesh is refined until its error is small
            beside the noise.
        process_noise : dict, optional
            Of collocation: maps specifieds to the intensities of white noise that is added to
            them, their standard deviation times the square root of the time, in s, over which each
            value lasts. These disturbances are found too, at a cost ½ ∫ (disturbance/intensity)² dt
            in addition to that of the residuals, ½ Σ (residual/noise)².
        solver : {'ipopt', 'cyipopt', 'pounce'}, optional
            Of collocation: IPOPT from CasADi's wheel, which is the default, an installed cyipopt,
            or pounce-solver.
        most : int, optional
            The maximum number of evaluations, or of iterations of that solver.
        progress : bool, optional
            Show a progress bar; requires tqdm.
        contacts : pydy.contact.Contacts, optional
            Contacts of this System, which the motions are simulated with, in one segment. Constants
            of contacts, such as a restitution, may be parameters.
        **solver_kwargs
            Options of the native solver; `rtol` and `atol` are 1e-9 by default. If `ode_solver` is
            not native it is ``'radau'`` for SciPy's implicit methods, and where odeint takes its
            own for stiff equations, else ``'dop853'``. With collocation, those of `solver`.

        Returns
        -------
        FitResult

        Raises
        ------
        ValueError, TypeError
            The system has no such parameter, a specified has no derivatives, or the data are not
            valid.
        MissingDependencyError
            The `solver` is not installed: ``pip install 'pydy[optimal]'``.
        FitInterrupted
            The user pressed Ctrl-C; the exception contains the best estimates so far.

        Warns
        -----
        PyDyUserWarning
            The data do not determine some combinations of parameters, a parameter is at a bound,
            the search did not converge, or neighbouring residuals are correlated, so that standard
            errors are too small; white noise causes this warning in one of 10 000 fits.

        Examples
        --------
        >>> import numpy as np
        >>> from pydy.analysis import Trial
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> times = np.linspace(0.0, 10.0, num=101)
        >>> swing = np.exp(-0.1 * times) * np.cos(np.sqrt(3.99) * times)  # k = 4, c = 0.2
        >>> trial = Trial(times, {'x0': swing}, {'x0': 1.0, 'v0': -0.1})
        >>> result = system.fit(['k0', 'c0'], trial)
        >>> result.estimates.round(6)
        array([4. , 0.2])
        """
        alone = isinstance(trials, Trial | np.ndarray)
        given: list[Any] = [trials] if alone else listed("trials", trials, "pydy.analysis.Trial")
        if not given:
            raise ValueError("`trials` must hold at least one pydy.analysis.Trial.")
        segments, most = whole(segments, "`segments`"), whole(most, "`most`")
        collocated = choice(method, ("shooting", "collocation"), "`method`") == "collocation"
        own = {"mesh": mesh, "process_noise": process_noise, "solver": solver}
        _check_method(collocated, segments, own, solver_kwargs)
        if self._checked_contacts(contacts) is not None and (collocated or segments > 1):
            raise ValueError(
                "`contacts` need method='shooting' with segments=1: collocation takes the "
                "equations of motion alone, and segments would begin in any modes."
            )
        options = {} if collocated else solver_kwargs
        work = _Fit(self, parameters, given, segments, contacts, options)
        if not collocated:
            work.choose_solver()
        z = work.guess()
        work.limits = _bounds(work, bounds, len(z))
        z = np.clip(z, *work.limits)
        pairs = _pairs(work, priors, "priors", _prior)
        work.priors = [(place, *pair) for places, pair in pairs for place in places]
        if work.priors and work.own_noise:
            # Without it a residual would count as one in its unit, metre or millimetre, does.
            raise ValueError(
                "`priors` need the `noise` of each Trial: how much the samples count beside the "
                "priors follows from it. If it is not known, fit without `priors` first: "
                "`result.noise` of that fit estimates it."
            )
        progress = flag(progress, "`progress`")
        if collocated:
            disturbed = _disturbances(work, process_noise)
            searching = (
                "ipopt" if solver is None else solver,
                {"max_iter": min(most, 2**31 - 1), **solver_kwargs},
            )
            return _collocated(work, z, (mesh, disturbed, searching, progress))
        count = 0
        # A search may try a gap that is negative at first, or a restitution above one.
        refused = () if contacts is None else (contacts.infeasible,)

        def evaluate(z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
            nonlocal count
            count += 1
            try:
                values, slopes = work.evaluate(z, first=count == 1)
                if count == 1 and work.measure():
                    values, slopes = work.evaluate(z)
            except (IntegrationError, SingularMatrixError, *refused):
                if count == 1:
                    raise
                values, slopes = np.full(size, np.nan), np.zeros((size, len(z)))
            with np.errstate(all="ignore"):
                told(1, residual=f"{np.sqrt(np.mean(values**2)):.4g}")
                return work.with_priors(values, slopes, z)

        size = work.samples + (len(z) - work.count)
        stages = _STAGES if len(z) > work.count else (0.0,)
        with progress_of(progress, " evaluations") as told:
            for stage in stages:
                work.gaps = stage
                last = stage == stages[-1]
                z, values, J, found = estimate(
                    evaluate, z, work.limits, work.names, most, told=last
                )
        values, J, tables = _shot(work, values, J)
        ended = bool(found.success), str(found.message), count
        return _result(work, z, values, J, tables, 1, ended)
