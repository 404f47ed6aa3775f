"""Periodic motions by shooting, and their stability by Floquet multipliers.

A motion is periodic if its state after a period is its initial state. Newton's method solves for
the state, and for the period if the equations do not depend on time, with the monodromy matrix
∂x(T)/∂x(0) from the sensitivities. The eigenvalues of that matrix, the Floquet multipliers,
describe how small deviations grow from one period to the next.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._checks import flag, listed, positive, shown
from pydy._errors import PeriodicOrbitError, finished_before
from pydy._graph import inputs_of
from pydy._integration import SensitivityRequest, integrate, simulate
from pydy._judges import warn_of_jumps, warn_of_outputs
from pydy._motion import Motion
from pydy._names import numbers_of, some, unique_names
from pydy._optional import progress_of
from pydy._problem import AssumptionChecks, Problem
from pydy._rank import HALF, ROUNDED, or_one
from pydy._states import consistent, energetic_motions
from pydy.analysis.trial_steps import limited_steps
from pydy.analysis.tuning import (
    LARGEST_GAP,
    LEAST_SIZE,
    MULTIPLIER_MARGIN,
    ORBIT_TOLERANCE,
    SKIPPED_START,
    SMALLEST_DAMPING,
)
from pydy.solvers import Event

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from pydy._sympy_types import AnySymbol, SymbolOrName
    from pydy.trajectory import Trajectory

# Longest time until the event, in units of the guessed period.
_LONGEST_WAIT = 5.0

_SAMPLES = 201
# Samples per period for the sizes of the states; largest number of searches with new sizes.
_SIZE_SAMPLES, _MOST_RESIZINGS = 65, 5
_LARGEST_DAMPING = 1e8
# Smallest period, and smallest rates of the states at its end, relative to the first ones.
_SMALLEST_SHARE = 0.1


@dataclass(frozen=True, eq=False)
class PeriodicOrbit:
    """A periodic motion.

    Attributes
    ----------
    period : float
        In s.
    initial_conditions : dict
        All states at its start; they can be assigned to the System's attribute.
    states : tuple of str
        The independent states, except for those that advance steadily.
    monodromy : ndarray, shape (k, k)
        The derivatives of these states after a period with respect to those at its start; if an
        event ends the period, those of the state after the event.
    residual : float
        The largest change of a state over a period.
    autonomous : bool
        Whether the equations do not determine the start of the period: one multiplier is then 1.
    equilibrium : bool
        Whether nothing moves: the search converged to a fixed point, which is periodic with any
        period. The multipliers are those of small motions around it.
    trajectory : Trajectory
        Over one period.
    """

    period: float
    initial_conditions: dict[AnySymbol, float]
    states: tuple[str, ...]
    monodromy: np.ndarray
    residual: float
    autonomous: bool
    equilibrium: bool
    trajectory: Trajectory

    @property
    def multipliers(self) -> np.ndarray:
        """Floquet multipliers, the largest first, shape (k,)."""
        values = np.linalg.eigvals(self.monodromy).astype(complex)
        order = np.lexsort((-values.imag, -values.real, -np.abs(values).round(12)))
        return values[order]

    @property
    def stable(self) -> bool:
        """Whether no multiplier exceeds 1, except the trivial one of an autonomous system."""
        values = self.multipliers
        if self.autonomous and values.size:
            values = np.delete(values, np.abs(values - 1.0).argmin())
        return bool((np.abs(values) <= 1.0 + MULTIPLIER_MARGIN).all())

    def __str__(self) -> str:
        largest = np.abs(self.multipliers).max(initial=0.0)
        title = "Equilibrium over" if self.equilibrium else "Periodic orbit of"
        return (
            f"{title} {self.period:.10g} s, {'' if self.stable else 'un'}stable: "
            f"largest multiplier {largest:.6g}; residual {self.residual:.2g}"
        )

    __repr__ = __str__


def find_periodic_orbit(
    problem: Problem,
    period: float,
    *,
    moving: Iterable[SymbolOrName] = (),
    until: Event | None = None,
    solver: Callable[..., Any],
    progress: bool = False,
    **options: object,
) -> PeriodicOrbit:
    """Find a periodic motion of a Problem; see `System.find_periodic_orbit`.

    Its `dependent` states follow from the others by the constraints.
    """
    search = _OrbitSearch(problem, period, moving, until, solver, options)
    with progress_of(flag(progress, "`progress`"), " flights") as search.progress:
        try:
            return search.orbit()
        except (KeyboardInterrupt, MemoryError) as stop:
            raise finished_before(
                stop,
                "The period and the initial conditions that came nearest to an orbit are",
                "The search for a periodic orbit was interrupted. The period and the initial "
                "conditions that came nearest to one are in the attribute `results` of this "
                "error.",
                search.nearest,
            ) from None


class _OrbitSearch:
    """A Problem that is integrated for a period, from start to start."""

    def __init__(
        self,
        problem: Problem,
        period: float,
        moving: Iterable[SymbolOrName],
        until: Event | None,
        solver: Callable[..., Any],
        options: dict[str, Any],
    ) -> None:
        self.t0, self.guess = problem.t, positive(period, "`period`", finite=True)
        if not problem.t + self.guess / _SAMPLES > problem.t:
            raise ValueError(
                f"`period` must be long enough for {_SAMPLES} times from {problem.t:g} on that "
                f"differ as floats, got {shown(self.guess)}."
            )
        self.until, self.solver, self.original = until, solver, problem
        self._choose_states(problem, moving)
        self.nearest: dict[str, object] = {
            "period": self.guess,
            "initial_conditions": _initial_conditions(problem),
        }
        self.autonomous = until is None and not _depends_on_time(problem)
        # Trial values need not satisfy the symbols' assumptions.
        self.problem = problem.replace(contradicted=None)
        self.options = {"rtol": ORBIT_TOLERANCE, **options}
        self.scales_atol = "atol" not in options
        if problem.dependent:
            self.options.setdefault("constraints", "project")
        self.smallest_gap = np.inf  # the smallest gap so far
        self.steps, self.best_steps = 0, 0  # of the latest period; of that with the smallest gap
        self.progress: Any = None  # reports the progress

    def _choose_states(self, problem: Problem, moving: Iterable[SymbolOrName]) -> None:
        """Divide the states into unknowns of the search, advancing states, and dependent ones."""
        definition, dependent = problem.definition, problem.dependent
        equations, states = definition.equations, definition.places["states"]
        self.steady = sorted(states.columns(listed("moving", moving), "moving").tolist())
        if not dependent and (equations.constraints.holonomic or equations.constraints.velocity):
            raise ValueError(
                "A periodic orbit can be searched for only where it is known which states follow "
                "from the others by the constraints; none is named as dependent. Call "
                "`set_dependent_initial_conditions(dep_vars=…)` first, with as many as constraints."
            )
        coordinates = len(equations.coordinates)
        count = coordinates + len(equations.speeds)
        if any(k >= coordinates for k in self.steady):
            names = [str(states.symbols[k]) for k in self.steady if k >= coordinates]
            raise ValueError(f"`moving` must hold coordinates, got {some(names)}.")
        self.free = [k for k in range(count) if k not in {*dependent, *self.steady}]
        if not self.free:
            raise ValueError(
                "There is no state to search for: `moving` and the constraints determine all of "
                "them. The motion is the one that `simulate` returns."
            )
        self.independent = [k for k in range(count) if k not in dependent]
        self.parameters = [definition.states[k] for k in self.independent]
        self.free_columns = [self.independent.index(k) for k in self.free]
        self.advancing = [self.independent.index(k) for k in self.steady if k not in dependent]
        # Change of the end due to the advance of the steady coordinates.
        self.advance_effect = np.zeros(len(self.free))
        self.names = unique_names(definition.states)

    def start(self, z: np.ndarray) -> Problem:
        """Return the Problem with the free states `z`; the dependent ones follow."""
        x = self.problem.x.copy()
        x[self.free] = z
        problem = self.problem.replace(x=x)
        return consistent(problem) if problem.dependent else problem

    def integrated(self, problem: Problem, times: ArrayLike, **extra_options: Any) -> Motion:
        """Integrate with sensitivities."""
        # Sensitivities control the steps, too: a state at rest would allow steps that are too long.
        request = SensitivityRequest(self.parameters, controlled=True)
        options = limited_steps({**self.options, **extra_options}, self.best_steps)
        motion = integrate(
            problem, np.array(times), solver=self.solver, sensitivities=request, **options
        )
        self.steps += motion.statistics["steps"]
        return motion

    def sizes_along(
        self,
        times: np.ndarray,
        states: np.ndarray,
        end: np.ndarray,
        rates: np.ndarray,
        length: float,
    ) -> np.ndarray:
        """Return the sizes of all states during a motion of one period."""
        natural, moved = energetic_motions(self.problem, times, states)
        most = np.abs(np.concatenate([states, end[None]])).max(axis=0)
        speeds = np.arange(len(end)) >= len(self.problem.definition.equations.coordinates)
        return StateSizes(self.free, speeds, natural, moved).sizes(most, rates, length)

    def map_period(self, z: np.ndarray, length: float) -> PeriodMap:
        """Integrate for a period from states `z`; store the start with the smallest gap."""
        problem, self.steps = self.start(z), 0
        if self.until is None:
            period_map = self._fixed_period(problem, length)
        else:
            period_map = self._period_to_event(problem, self.until, z)
        gap = float((np.abs(period_map.end - z) / self.start_sizes[self.free]).max(initial=0.0))
        if gap < self.smallest_gap or not self.best_steps:
            self.best_steps = self.steps
        if gap < self.smallest_gap:
            self.smallest_gap = gap
            self.nearest.update(
                period=period_map.period, initial_conditions=_initial_conditions(problem)
            )
        self.progress(1, gap=f"{gap:.3g}")
        return period_map

    def _fixed_period(self, problem: Problem, length: float) -> PeriodMap:
        instant = self.t0 + length
        motion = self.integrated(problem, np.linspace(self.t0, instant, num=_SIZE_SAMPLES))
        start, end, slopes = motion.states[0], motion.states[-1], motion.last_sensitivities
        advance = np.abs(end - start)[[self.independent[k] for k in self.advancing]]
        self.advance_effect[:] = np.abs(slopes[np.ix_(self.free, self.advancing)]) @ advance
        rates = motion.segments[-1].rates(instant, end)
        return self._period_map(motion, start, end, rates, slopes, instant)

    def _period_to_event(self, problem: Problem, until: Event, z: np.ndarray) -> PeriodMap:
        t0, guess = self.t0, self.guess
        first = self.integrated(problem, [t0, t0 + SKIPPED_START * guess])
        ending = replace(until, terminal=True)
        times = np.linspace(
            t0 + SKIPPED_START * guess, t0 + _LONGEST_WAIT * guess, num=_SIZE_SAMPLES
        )
        events = [*self.options.get("events", ()), ending]
        motion = self.integrated(first.last, times, events=events)
        event = next((e for e in reversed(motion.events) if e.name == ending.name), None)
        if event is None:
            raise PeriodicOrbitError(
                f"The event `{until.name}` does not happen within {_LONGEST_WAIT:g} times the "
                f"`period` of {guess:g} s. Give a period nearer to it, or other initial "
                "conditions.",
                z,
                np.full(len(z), np.nan),
            )
        rates = motion.segments[-1].rates(event.time, event.after)
        assert event.sensitivity_after is not None
        assert event.time_sensitivity is not None
        after = event.sensitivity_after + np.outer(rates, event.time_sensitivity)
        slopes = after @ first.last_sensitivities[self.independent]
        return self._period_map(motion, first.states[0], event.after, rates, slopes, event.time)

    def _period_map(
        self,
        motion: Motion,
        start: np.ndarray,
        end: np.ndarray,
        rates: np.ndarray,
        slopes: np.ndarray,
        instant: float,
    ) -> PeriodMap:
        period, free = instant - self.t0, self.free
        return PeriodMap(
            end[free],
            slopes[np.ix_(free, self.free_columns)],
            rates[free],
            period,
            self.sizes_along(motion.times, motion.states, end, rates, period),
            None if self.problem.hybrid is None else start[free],
        )

    def _slope_at_start(self) -> np.ndarray | None:
        """Set the sizes at the start; return the motion's direction there for autonomous problems.

        If the equations depend on time, or an event ends the period, the phase is fixed: None.
        """
        t0, guess, free = self.t0, self.guess, self.free
        problem = self.start(self.problem.x[free])
        if problem.hybrid is None:
            rates = problem.at(np.array([problem.t]), problem.x[None]).rates()[0]
        else:
            motion = self.integrated(problem, [t0, t0 + SKIPPED_START * guess])
            rates = motion.segments[0].rates(t0, motion.states[0])
            self.problem = self.problem.replace(modes=motion.segments[0].modes)
        at_start = np.array([t0]), problem.x[None], problem.x
        slope: np.ndarray | None = None
        if self.autonomous:
            slope = rates[free]
            sizes = self.sizes_along(*at_start, np.zeros_like(rates), guess)[free]
            is_moving = self.problem.x[free].any()
            if (np.abs(slope) * guess <= LARGEST_GAP * sizes * is_moving).all():
                raise ValueError(
                    "The initial conditions are an equilibrium, which is no orbit. Start "
                    "elsewhere, or use `find_equilibrium`."
                )
            slope = slope / np.linalg.norm(slope)
        self.start_sizes = self.sizes_along(*at_start, rates, guess)
        if self.scales_atol:
            self.options["atol"] = ORBIT_TOLERANCE * self.start_sizes
        return slope

    def orbit(self) -> PeriodicOrbit:
        """Search for a closed orbit, with states in units of their sizes during the motion."""
        slope, free = self._slope_at_start(), self.free
        z = self.problem.x[free]
        period_map = self.map_period(z, self.guess)
        self.start_sizes = period_map.sizes
        names = [self.names[k] for k in free]
        for _ in range(_MOST_RESIZINGS):
            # States that vanish would have no tolerance in the end.
            sizes = np.maximum(period_map.sizes, ORBIT_TOLERANCE * self.start_sizes)
            if self.scales_atol:
                coarse = (self.options["atol"] > 2.0 * ORBIT_TOLERANCE * sizes).any()
                self.options["atol"] = ORBIT_TOLERANCE * sizes
                if coarse:
                    self.best_steps = 0  # finer tolerances need more
                    period_map = self.map_period(z, period_map.period)
            tolerance = float(np.max(self.options["rtol"]))
            search = OrbitShooting(
                self.map_period, period_map, sizes[free], slope, names, tolerance
            )
            z, period_map, residual = search.solve(z)
            # If sizes shrank, the first ones were not those of the orbit: search again. States that
            # vanish would shrink without end.
            new_sizes = period_map.sizes
            vanish = new_sizes <= ORBIT_TOLERANCE * self.start_sizes
            if ((new_sizes >= 0.5 * sizes) | vanish).all():
                break
        if (self.advance_effect > LARGEST_GAP * period_map.sizes[free]).any():
            on = names[int((self.advance_effect / period_map.sizes[free]).argmax())]
            raise ValueError(
                f"`moving` must not have coordinates that the motion depends on, got "
                f"{some(self.names[k] for k in self.steady)}, on which {on} depends: a motion "
                "in which they advance does not repeat. Leave them out, or end the period "
                "with an event `until` that sets them back."
            )
        motion = self._motion(z, period_map.period)
        start_problem = motion.problem if self.problem.hybrid is None else motion.first
        moved = np.ptp(motion.states[:, free], axis=0)
        return PeriodicOrbit(
            period=period_map.period,
            initial_conditions=_initial_conditions(start_problem),
            states=tuple(names),
            monodromy=period_map.by_start,
            residual=residual,
            autonomous=self.autonomous,
            equilibrium=bool((moved <= ORBIT_TOLERANCE * self.start_sizes[free]).all()),
            trajectory=motion.trajectory,
        )

    def _motion(self, z: np.ndarray, period: float) -> Motion:
        """Integrate the orbit and check it."""
        times = np.linspace(self.t0, self.t0 + period, num=_SAMPLES)
        motion = simulate(self.start(z), times, solver=self.solver, **self.options)
        if motion.problem.hybrid is not None:
            return motion
        if not np.isfinite(motion.trajectory.outputs).all():
            warn_of_outputs(motion.trajectory, motion.problem)
        if self.original.definition.assumes_motions:
            AssumptionChecks(self.original).motion(motion.times, motion.states)
        warn_of_jumps(motion.problem, lambda: motion.trajectory)
        if self.until is None and not self.autonomous:
            _check_period(motion, period)
        return motion


def _check_period(motion: Motion, period: float) -> None:
    """Raise an error if the equations do not have the period: the motion would not repeat."""
    if motion.problem.inputs.sampled:  # samples end with the period
        return
    times, states = motion.times[:: _SAMPLES // 16], motion.states[:: _SAMPLES // 16]
    rates, later_rates = (motion.problem.at(times + late, states).rates() for late in (0.0, period))
    difference = np.abs(later_rates - rates) / or_one(
        np.maximum(np.abs(rates), np.abs(later_rates)).max(axis=0)
    )
    k, j = np.unravel_index(int(np.nan_to_num(difference).argmax()), difference.shape)
    if difference[k, j] > HALF:
        symbol = motion.problem.definition.states[j]
        raise PeriodicOrbitError(
            f"The equations do not have the `period` {period:.6g} s, after which the motion is as "
            f"at its start: at t = {times[k]:.6g} the derivative of {symbol} is "
            f"{rates[k, j]:.6g}, that time later {later_rates[k, j]:.6g} in the same state. Give a "
            "period of all that depends on time.",
            states[0],
            (later_rates - rates)[k],
        )


# -- in numbers alone ------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class PeriodMap:
    """A motion over one period, in k unknown states."""

    end: np.ndarray  # the states after it
    by_start: np.ndarray  # their derivatives (k, k)
    rates: np.ndarray  # their time derivatives at the end
    period: float
    sizes: np.ndarray  # their sizes during the motion; see `StateSizes`
    projected: np.ndarray | None = None  # the states at its start, if not the requested ones

    def scaled(self, sizes: np.ndarray, period: float) -> PeriodMap:
        """Return the map in units of the states' sizes and of a period."""
        return replace(
            self,
            end=self.end / sizes,
            by_start=self.by_start * sizes / sizes[:, None],
            rates=self.rates * period / sizes,
            period=self.period / period,
            projected=None if self.projected is None else self.projected / sizes,
        )

    def start_states(self, requested: np.ndarray) -> np.ndarray:
        """Return the states at the start."""
        return requested if self.projected is None else self.projected


@dataclass(frozen=True, eq=False)
class StateSizes:
    """Sizes of n states during a motion: the units for the search and for the integration.

    A state that does not move is a rounding error and has no size. It gets a share of three others:
    the largest state of the same unit, the motion with the same energy, and a radian. The smallest
    is taken, since a size that is too large would hide a gap.
    """

    # the unknown states; others, such as a vehicle's position, do not determine sizes
    free: Sequence[int]
    # True for speeds; their sizes are those of the oscillation's amplitudes times its frequency
    speeds: np.ndarray
    # natural sizes of coordinates and of the integrals of speeds: 1 for angles, 0 if there is none
    natural: np.ndarray
    # the speeds and the rates of the coordinates in motions of one energy; 0 if unknown
    moved: np.ndarray

    def sizes(self, most: np.ndarray, rates: np.ndarray, period: float) -> np.ndarray:
        """Return the sizes of all states, from their largest magnitudes `most`; 1 if all are zero.

        A state that is zero at the ends of an oscillation gets its size from its rate there.
        """
        time = period / (2.0 * np.pi)
        unit = np.where(self.speeds, 1.0 / time, 1.0)
        sizes = np.maximum(np.abs(most), np.abs(rates) * time) / unit
        largest = float(sizes[self.free].max(initial=0.0))
        if not (np.isfinite(largest) and largest > 0.0):
            return np.ones(len(most))
        unit_motion = self.moved * time
        searched = np.isin(np.arange(len(most)), self.free)
        energetic = float(
            (sizes / or_one(unit_motion))[searched & (unit_motion > 0.0)].max(initial=0.0)
        )
        by_energy = LEAST_SIZE * energetic * unit_motion
        unscaled = self.natural == 0.0
        # States that do not move by themselves do not determine the sizes of others.
        alike = LEAST_SIZE * float(
            sizes[searched & unscaled & (sizes > by_energy)].max(initial=0.0)
        )
        least = np.where(unscaled, alike if alike > 0.0 else np.inf, self.natural)
        least = np.minimum(least, np.where(by_energy > 0.0, by_energy, np.inf))
        least[np.isinf(least)] = LEAST_SIZE * largest
        result: np.ndarray = np.maximum(sizes, least) * unit
        return result


@dataclass
class OrbitShooting:
    """Shooting for k states that return after a period, in units of their sizes.

    The states stay in the plane normal to `slope`, and the period is unknown. If `slope` is None,
    the period is fixed.
    """

    map_period: Callable[[np.ndarray, float], PeriodMap]  # integrates from states, for a period
    first: PeriodMap
    sizes: np.ndarray
    slope: np.ndarray | None  # the states' rates at the start of the first period
    names: Sequence[str]
    tolerance: float  # of the integration

    def solve(self, start: np.ndarray) -> tuple[np.ndarray, PeriodMap, float]:
        """Return the states, the map from there, and the largest gap."""
        self.unscaled, self.period = self.first, self.first.period
        if self.slope is not None:
            slope = self.slope / self.sizes
            self.normal = slope / np.linalg.norm(slope)
        self.scaled_map = self._scaled(self.first)
        self.z = self.start = self.scaled_map.start_states(start / self.sizes)
        self._approach()
        self._last_newton_steps()
        z, gap = self.z * self.sizes, self._gap() * self.sizes
        return z, self.unscaled, float(np.abs(gap).max(initial=0.0))

    def _scaled(self, period_map: PeriodMap) -> PeriodMap:
        return period_map.scaled(self.sizes, self.first.period)

    def _gap(self) -> np.ndarray:
        gap: np.ndarray = self.scaled_map.end - self.z
        return gap

    def _after_step(self, step: np.ndarray) -> tuple[np.ndarray, float]:
        """Return the states and the period after a step."""
        late = 0.0 if self.slope is None else float(step[-1]) * self.first.period
        return self.z + step[: len(self.z)], self.period + late

    def _approach(self) -> None:
        """Take Levenberg–Marquardt steps as long as the gap becomes smaller.

        The damping vanishes with the gap. It selects the nearest orbit of the families that
        conservative systems have.
        """
        weight = 1.0
        for _ in range(40):
            size = float(np.abs(self._gap()).max(initial=0.0))
            matrix, right = self._equations()
            n = matrix.shape[1]
            while weight < _LARGEST_DAMPING:
                damping = np.sqrt(weight * min(size, 1.0)) * np.eye(n)
                right_side = np.append(right, np.zeros(n))
                step = np.linalg.lstsq(np.vstack([matrix, damping]), right_side, rcond=ROUNDED)[0]
                if self._try_step(*self._after_step(step), size):
                    weight *= 0.1
                    break
                if size <= LARGEST_GAP * _scale(self.z):
                    return
                weight = max(10.0 * weight, SMALLEST_DAMPING)
            else:
                return

    def _try_step(self, z: np.ndarray, period: float, size: float) -> bool:
        """Accept a state and a period if the gap is smaller than `size`."""
        # A period of zero closes every motion, and an equilibrium closes with every period.
        if period <= _SMALLEST_SHARE * self.first.period:
            return False
        try:
            unscaled = self.map_period(z * self.sizes, period)
        except (RuntimeError, ValueError):
            # No event, a failure of the integration, or a start from which the constraints cannot
            # be solved; wrong arguments have stopped the first motion.
            return False
        scaled_map = self._scaled(unscaled)
        speed = np.linalg.norm(self._scaled(self.first).rates)
        if self.slope is not None and np.linalg.norm(scaled_map.rates) < _SMALLEST_SHARE * speed:
            return False
        z = scaled_map.start_states(z)
        if not float(np.abs(scaled_map.end - z).max()) < size:
            return False
        self.z, self.unscaled, self.scaled_map, self.period = z, unscaled, scaled_map, period
        return True

    def _last_newton_steps(self) -> None:
        """Take the last Newton steps, until the gap is a rounding error."""
        for remaining in range(3, -1, -1):
            gap = self._gap()
            if np.abs(gap).max(initial=0.0) <= LARGEST_GAP * _scale(self.z):
                return
            # Unstable motion amplifies the errors of rounding and integration to a larger gap. Then
            # the size of the next step measures the accuracy of the start.
            matrix, right = self._equations()
            step = np.linalg.lstsq(matrix, right, rcond=self.tolerance)[0]
            open_by = np.abs([*step, *(right - matrix @ step)]).max()
            grown = self.tolerance * float(np.linalg.norm(self.scaled_map.by_start, 2))
            at_rounding = float(np.abs(gap).max(initial=0.0)) <= grown
            if at_rounding and open_by <= LARGEST_GAP * _scale(self.z):
                return
            if not (at_rounding and remaining):
                raise _no_orbit_error(
                    self.names, self.z * self.sizes, gap * self.sizes, self.period
                )
            z, self.period = self._after_step(step)
            self.unscaled = self.map_period(z * self.sizes, self.period)
            self.scaled_map = self._scaled(self.unscaled)
            self.z = self.scaled_map.start_states(z)

    def _equations(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the linear equations of the Newton step, including that of the plane."""
        gap = self._gap()
        matrix = self.scaled_map.by_start - np.eye(len(gap))
        if self.slope is None:
            return matrix, -gap
        border = np.append(self.normal, 0.0)
        matrix = np.vstack([np.column_stack([matrix, self.scaled_map.rates]), border])
        return matrix, np.append(-gap, -self.normal @ (self.z - self.start))


def _scale(z: np.ndarray) -> float:
    return max(1.0, float(np.abs(z).max(initial=0.0)))


def _no_orbit_error(
    names: Sequence[str], z: np.ndarray, gap: np.ndarray, period: float
) -> PeriodicOrbitError:
    order = np.argsort(-np.abs(gap))[:3]
    gaps = ", ".join(f"{names[k]} by {gap[k]:.3g}" for k in order)
    return PeriodicOrbitError(
        f"No periodic orbit was found. Nearest, at {numbers_of(names, z)} with the "
        f"period {period:.6g} s, these change over it: {gaps}. Start closer to an "
        "orbit, or list coordinates that advance steadily in `moving`.",
        z,
        gap,
    )


def _depends_on_time(problem: Problem) -> bool:
    """Return whether the equations, inputs or modes depend on time explicitly."""
    if problem.inputs.functions or problem.inputs.sampled:
        return True
    if problem.hybrid is not None and problem.hybrid.depends_on_time:
        return True
    assembly = problem.code.assembly
    return "t" in inputs_of(assembly.graph, assembly.blocks.rates).groups


def _initial_conditions(problem: Problem) -> dict[AnySymbol, float]:
    """Return the states' values by symbol."""
    return dict(zip(problem.definition.states, problem.x.tolist(), strict=True))
