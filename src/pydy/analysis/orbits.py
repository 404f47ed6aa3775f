"""Periodic motions by shooting, and their stability by Floquet multipliers.

A motion is periodic if its state after a period is its initial state. Newton's method solves for
the state, and for the period if the equations do not depend on time, with the monodromy matrix
∂x(T)/∂x(0) from the sensitivities. The eigenvalues of that matrix, the Floquet multipliers,
describe how small deviations grow from one period to the next.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pydy._checks import flag, listed, positive, shown
from pydy._errors import PeriodicOrbitError, finished_before
from pydy._integration import SensitivityRequest, integrate, simulate
from pydy._judges import warn_of_jumps, warn_of_outputs
from pydy._motion import Motion
from pydy._names import numbers_of, some, unique_names
from pydy._optional import progress_of
from pydy._problem import AssumptionChecks, Problem
from pydy._rank import HALF, ROUNDED, or_one
from pydy._states import consistent, energetic_motions
from pydy.analysis.tuning import (
    BEGINNING,
    DAMPED,
    LEAST_SIZE,
    MARGIN,
    ORBIT,
    ORBIT_CLOSED,
)
from pydy.solvers import Event

# How long an event is waited for, in periods as guessed.
_PATIENCE = 5.0

_SAMPLES = 201
# Samples that tell how large states become on the way, and how often that is looked at again.
_ON_THE_WAY, _RESIZED = 65, 5
_STUCK = 1e8
# The least period, and the least rates of the states at its end, as shares of those at first.
_SHORTEST = 0.1


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
    initial_conditions: dict[Any, float]
    states: tuple[str, ...]
    monodromy: np.ndarray
    residual: float
    autonomous: bool
    equilibrium: bool
    trajectory: Any

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
        return bool((np.abs(values) <= 1.0 + MARGIN).all())

    def __str__(self) -> str:
        largest = np.abs(self.multipliers).max(initial=0.0)
        what = "Equilibrium over" if self.equilibrium else "Periodic orbit of"
        return (
            f"{what} {self.period:.10g} s, {'' if self.stable else 'un'}stable: "
            f"largest multiplier {largest:.6g}; residual {self.residual:.2g}"
        )

    __repr__ = __str__


def find_periodic_orbit(
    problem: Problem,
    period: float,
    *,
    moving: Iterable[Any] = (),
    until: Event | None = None,
    solver: Any,
    progress: bool = False,
    **options: Any,
) -> PeriodicOrbit:
    """Find a periodic motion of a Problem; see `System.find_periodic_orbit`.

    Its `dependent` states follow from the others by the constraints.
    """
    search = _Search(problem, period, moving, until, solver, options)
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


class _Search:
    """A Problem that is integrated for a period, from start to start."""

    def __init__(
        self,
        problem: Problem,
        period: float,
        moving: Iterable[Any],
        until: Event | None,
        solver: Any,
        options: dict[str, Any],
    ) -> None:
        self.t0, self.guess = problem.t, positive(period, "`period`", finite=True)
        if not problem.t + self.guess / _SAMPLES > problem.t:
            raise ValueError(
                f"`period` must be long enough for {_SAMPLES} times from {problem.t:g} on that "
                f"differ as floats, got {shown(self.guess)}."
            )
        self.until, self.solver, self.judged = until, solver, problem
        self._choose_states(problem, moving)
        self.nearest: dict[str, Any] = {
            "period": self.guess,
            "initial_conditions": _initial_conditions(problem),
        }
        self.autonomous = until is None and not _depends_on_time(problem)
        # Numbers that are only tried need not agree with assumptions of symbols.
        self.problem = problem.replace(contradicted=None)
        self.options = {"rtol": ORBIT, **options}
        self.scales_atol = "atol" not in options
        if problem.dependent:
            self.options.setdefault("constraints", "project")
        self.least = np.inf  # the gap of the nearest start
        self.progress: Any = None  # what shows the progress

    def _choose_states(self, problem: Problem, moving: Iterable[Any]) -> None:
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
        count = len(equations.coordinates) + len(equations.speeds)
        self.free = [k for k in range(count) if k not in {*dependent, *self.steady}]
        if not self.free:
            raise ValueError(
                "There is no state to search for: `moving` and the constraints determine all of "
                "them. The motion is the one that `simulate` returns."
            )
        self.rows = [k for k in range(count) if k not in dependent]
        self.parameters = [definition.states[k] for k in self.rows]
        self.columns = [self.rows.index(k) for k in self.free]
        self.advancing = [self.rows.index(k) for k in self.steady if k not in dependent]
        # By how much the end changes as those advance that move.
        self.pushed = np.zeros(len(self.free))
        self.names = unique_names(definition.states)

    def start(self, z: np.ndarray) -> Problem:
        """Return the Problem with the free states `z`; the dependent ones follow."""
        x = self.problem.x.copy()
        x[self.free] = z
        problem = self.problem.replace(x=x)
        return consistent(problem) if problem.dependent else problem

    def integrated(self, problem: Problem, times: Any, **more: Any) -> Motion:
        """Integrate with sensitivities."""
        # A state that stays would be followed in steps that are too long for its neighbours.
        wanted = SensitivityRequest(self.parameters, controlled=True)
        options = {**more, **self.options}
        return integrate(
            problem, np.array(times), solver=self.solver, sensitivities=wanted, **options
        )

    def sizes_along(
        self,
        times: np.ndarray,
        states: np.ndarray,
        end: np.ndarray,
        rates: np.ndarray,
        length: float,
    ) -> np.ndarray:
        """Return the sizes of all states on a flight."""
        natural, moved = energetic_motions(self.problem, times, states)
        most = np.abs(np.concatenate([states, end[None]])).max(axis=0)
        speeds = np.arange(len(end)) >= len(self.problem.definition.equations.coordinates)
        return Measure(self.free, speeds, natural, moved).sizes(most, rates, length)

    def fly(self, z: np.ndarray, length: float) -> Flight:
        """Fly for a period from states `z`; the start that comes nearest to its end is stored."""
        problem = self.start(z)
        if self.until is None:
            flight = self._for_a_time(problem, length)
        else:
            flight = self._until(problem, self.until, z)
        gap = float((np.abs(flight.end - z) / self.begun[self.free]).max(initial=0.0))
        if gap < self.least:
            self.least = gap
            self.nearest.update(
                period=flight.period, initial_conditions=_initial_conditions(problem)
            )
        self.progress(1, gap=f"{gap:.3g}")
        return flight

    def _for_a_time(self, problem: Problem, length: float) -> Flight:
        instant = self.t0 + length
        motion = self.integrated(problem, np.linspace(self.t0, instant, num=_ON_THE_WAY))
        start, end, slopes = motion.states[0], motion.states[-1], motion.end_sensitivities
        advance = np.abs(end - start)[[self.rows[k] for k in self.advancing]]
        self.pushed[:] = np.abs(slopes[np.ix_(self.free, self.advancing)]) @ advance
        return self._flight(motion, start, end, motion.rates(instant, end), slopes, instant)

    def _until(self, problem: Problem, until: Event, z: np.ndarray) -> Flight:
        t0, guess = self.t0, self.guess
        first = self.integrated(problem, [t0, t0 + BEGINNING * guess])
        ending = replace(until, terminal=True)
        times = np.linspace(t0 + BEGINNING * guess, t0 + _PATIENCE * guess, num=_ON_THE_WAY)
        motion = self.integrated(first.last, times, events=ending)
        event = motion.event(ending.name)
        if event is None:
            raise PeriodicOrbitError(
                f"The event `{until.name}` does not happen within {_PATIENCE:g} times the "
                f"`period` of {guess:g} s. Give a period nearer to it, or other initial "
                "conditions.",
                z,
                np.full(len(z), np.nan),
            )
        rates = motion.rates(event.time, event.after)
        assert event.sensitivity_after is not None
        assert event.time_sensitivity is not None
        after = event.sensitivity_after + np.outer(rates, event.time_sensitivity)
        slopes = after @ first.end_sensitivities[self.rows]
        return self._flight(motion, first.states[0], event.after, rates, slopes, event.time)

    def _flight(
        self,
        motion: Motion,
        start: np.ndarray,
        end: np.ndarray,
        rates: np.ndarray,
        slopes: np.ndarray,
        instant: float,
    ) -> Flight:
        period, free = instant - self.t0, self.free
        return Flight(
            end[free],
            slopes[np.ix_(free, self.columns)],
            rates[free],
            period,
            self.sizes_along(motion.times, motion.states, end, rates, period),
            None if self.problem.hybrid is None else start[free],
        )

    def _slope_at_start(self) -> np.ndarray | None:
        """Measure the start; return the direction in which the motion leaves, if it may be late.

        Where the equations depend on time, or the period has an end of its own, it may not.
        """
        t0, guess, free = self.t0, self.guess, self.free
        problem = self.start(self.problem.x[free])
        if problem.hybrid is None:
            rates = problem.at(np.array([problem.t]), problem.x[None]).rates()[0]
        else:
            motion = self.integrated(problem, [t0, t0 + BEGINNING * guess])
            rates = motion.rates(t0, motion.states[0], segment=0)
            self.problem = self.problem.replace(modes=motion.segments[0].modes)
        at_start = np.array([t0]), problem.x[None], problem.x
        slope: np.ndarray | None = None
        if self.autonomous:
            slope = rates[free]
            own = self.sizes_along(*at_start, np.zeros_like(rates), guess)[free]
            moves = self.problem.x[free].any()
            if (np.abs(slope) * guess <= ORBIT_CLOSED * own * moves).all():
                raise ValueError(
                    "The initial conditions are an equilibrium, which is no orbit. Start "
                    "elsewhere, or use `find_equilibrium`."
                )
            slope = slope / np.linalg.norm(slope)
        self.begun = self.sizes_along(*at_start, rates, guess)
        if self.scales_atol:
            self.options["atol"] = ORBIT * self.begun
        return slope

    def orbit(self) -> PeriodicOrbit:
        """Search until states come back, in units of the sizes that they have on the way."""
        slope, free = self._slope_at_start(), self.free
        z = self.problem.x[free]
        flight = self.fly(z, self.guess)
        self.begun = flight.sizes
        names = [self.names[k] for k in free]
        for _ in range(_RESIZED):
            sizes = flight.sizes
            if self.scales_atol:
                coarse = (self.options["atol"] > 2.0 * ORBIT * sizes).any()
                self.options["atol"] = ORBIT * sizes
                if coarse:
                    flight = self.fly(z, flight.period)
            tolerance = float(np.max(self.options["rtol"]))
            search = Shooting(self.fly, flight, sizes[free], slope, names, tolerance)
            z, flight, residual = search.found(z)
            # A first flight that led far away told nothing of the orbit.
            again = flight.sizes
            if (again >= 0.5 * sizes).all() or (again <= ORBIT * self.begun).all():
                break
        if (self.pushed > ORBIT_CLOSED * flight.sizes[free]).any():
            on = names[int((self.pushed / flight.sizes[free]).argmax())]
            raise ValueError(
                f"`moving` must not have coordinates that the motion depends on, got "
                f"{some(self.names[k] for k in self.steady)}, on which {on} depends: a motion "
                "in which they advance does not repeat. Leave them out, or end the period "
                "with an event `until` that sets them back."
            )
        motion = self._motion(z, flight.period)
        begun = motion.problem if self.problem.hybrid is None else motion.first
        moved = np.ptp(motion.states[:, free], axis=0)
        return PeriodicOrbit(
            period=flight.period,
            initial_conditions=_initial_conditions(begun),
            states=tuple(names),
            monodromy=flight.by_start,
            residual=residual,
            autonomous=self.autonomous,
            equilibrium=bool((moved <= ORBIT * self.begun[free]).all()),
            trajectory=motion.trajectory,
        )

    def _motion(self, z: np.ndarray, period: float) -> Motion:
        """Integrate the orbit, and judge it."""
        times = np.linspace(self.t0, self.t0 + period, num=_SAMPLES)
        motion = simulate(self.start(z), times, solver=self.solver, **self.options)
        if motion.problem.hybrid is not None:
            return motion
        if not np.isfinite(motion.trajectory.outputs).all():
            warn_of_outputs(motion.trajectory, motion.problem)
        if self.judged.definition.assumes_motions:
            AssumptionChecks(self.judged).motion(motion.times, motion.states)
        warn_of_jumps(motion.problem, lambda: motion.trajectory)
        if self.until is None and not self.autonomous:
            _check_period(motion, period)
        return motion


def _check_period(motion: Motion, period: float) -> None:
    """Refuse a motion that ends as it began where the equations do not: it would not repeat."""
    if motion.problem.inputs.sampled:  # whose times end
        return
    times, states = motion.times[:: _SAMPLES // 16], motion.states[:: _SAMPLES // 16]
    now, later = (motion.problem.at(times + late, states).rates() for late in (0.0, period))
    off = np.abs(later - now) / or_one(np.maximum(np.abs(now), np.abs(later)).max(axis=0))
    k, j = np.unravel_index(int(np.nan_to_num(off).argmax()), off.shape)
    if off[k, j] > HALF:
        symbol = motion.problem.definition.states[j]
        raise PeriodicOrbitError(
            f"The equations do not have the `period` {period:.6g} s, after which the motion is as "
            f"at its start: at t = {times[k]:.6g} the derivative of {symbol} is "
            f"{now[k, j]:.6g}, that time later {later[k, j]:.6g} in the same state. Give a period "
            "of all that depends on time.",
            states[0],
            (later - now)[k],
        )


# -- in numbers alone ------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Flight:
    """A motion over one period, in k unknown states."""

    end: np.ndarray  # the states after it
    by_start: np.ndarray  # their derivatives (k, k)
    rates: np.ndarray  # their time derivatives at the end
    period: float
    sizes: np.ndarray  # how large they are on the way; see `Measure`
    projected: np.ndarray | None = None  # the states at its start, if they are not as wanted

    def scaled(self, sizes: np.ndarray, period: float) -> Flight:
        """Return the same in units of the states' sizes and of a period."""
        return replace(
            self,
            end=self.end / sizes,
            by_start=self.by_start * sizes / sizes[:, None],
            rates=self.rates * period / sizes,
            period=self.period / period,
            projected=None if self.projected is None else self.projected / sizes,
        )

    def begun(self, wanted: np.ndarray) -> np.ndarray:
        """Return the states at its start."""
        return wanted if self.projected is None else self.projected


@dataclass(frozen=True, eq=False)
class Measure:
    """How large n states are on the way: the units to search and to integrate in.

    A state that stays where it is has no size of its own but that of rounding. It gets a share of
    what others reach: of those with a like unit, of the motion with as much energy, and of a
    radian. The least of them is taken, since one too large would hide a gap.
    """

    # the states that are searched for; others, such as the way of a vehicle, measure nothing
    free: Sequence[int]
    # which of the states are speeds; they count as the amplitudes of an oscillation
    speeds: np.ndarray
    # how large coordinates are by themselves, and the integrals of speeds: of angles 1; 0 where
    # nothing tells
    natural: np.ndarray
    # the speeds, and the rates of the coordinates, in motions of one energy; 0 where these are not
    # known
    moved: np.ndarray

    def sizes(self, most: np.ndarray, rates: np.ndarray, period: float) -> np.ndarray:
        """Return the sizes of all states, 1 where nothing moves, if they become as large as `most`.

        Where a state is zero at the ends of an oscillation through zero, its rate there tells its
        size.
        """
        time = period / (2.0 * np.pi)
        unit = np.where(self.speeds, 1.0 / time, 1.0)
        sizes = np.maximum(np.abs(most), np.abs(rates) * time) / unit
        largest = float(sizes[self.free].max(initial=0.0))
        if not (np.isfinite(largest) and largest > 0.0):
            return np.ones(len(most))
        one = self.moved * time
        searched = np.isin(np.arange(len(most)), self.free)
        energetic = float((sizes / or_one(one))[searched & (one > 0.0)].max(initial=0.0))
        by_energy = LEAST_SIZE * energetic * one
        plain = self.natural == 0.0
        # What does not move by itself is no measure of others.
        alike = LEAST_SIZE * float(sizes[searched & plain & (sizes > by_energy)].max(initial=0.0))
        least = np.where(plain, alike if alike > 0.0 else np.inf, self.natural)
        least = np.minimum(least, np.where(by_energy > 0.0, by_energy, np.inf))
        least[np.isinf(least)] = LEAST_SIZE * largest
        found: np.ndarray = np.maximum(sizes, least) * unit
        return found


@dataclass
class Shooting:
    """A search for k states that come back, in units of their sizes.

    The search keeps to the plane normal to the `slope`, and the period is an unknown unless that is
    None.
    """

    fly: Callable[[np.ndarray, float], Flight]  # from states, for a period
    first: Flight
    sizes: np.ndarray
    slope: np.ndarray | None  # the states' rates where the first flight begins
    names: Sequence[str]
    tolerance: float  # of the integration

    def found(self, start: np.ndarray) -> tuple[np.ndarray, Flight, float]:
        """Return the states, the flight from there, and the largest gap."""
        self.flown, self.period = self.first, self.first.period
        if self.slope is not None:
            slope = self.slope / self.sizes
            self.normal = slope / np.linalg.norm(slope)
        self.flight = self._scaled(self.first)
        self.z = self.begun = self.flight.begun(start / self.sizes)
        self._approach()
        self._settle()
        z, gap = self.z * self.sizes, self._gap() * self.sizes
        return z, self.flown, float(np.abs(gap).max(initial=0.0))

    def _scaled(self, flight: Flight) -> Flight:
        return flight.scaled(self.sizes, self.first.period)

    def _gap(self) -> np.ndarray:
        gap: np.ndarray = self.flight.end - self.z
        return gap

    def _moved(self, step: np.ndarray) -> tuple[np.ndarray, float]:
        """Return the states and the period after a step."""
        late = 0.0 if self.slope is None else float(step[-1]) * self.first.period
        return self.z + step[: len(self.z)], self.period + late

    def _approach(self) -> None:
        """Take steps after Levenberg and Marquardt, as long as the gap becomes smaller.

        Their weight vanishes with the gap: orbits of conservative systems come in families, of
        which the nearest is wanted.
        """
        weight = 1.0
        for _ in range(40):
            size = float(np.abs(self._gap()).max(initial=0.0))
            whole, right = self._equations()
            n = whole.shape[1]
            while weight < _STUCK:
                held = np.sqrt(weight * min(size, 1.0)) * np.eye(n)
                both = np.append(right, np.zeros(n))
                step = np.linalg.lstsq(np.vstack([whole, held]), both, rcond=ROUNDED)[0]
                if self._nearer(*self._moved(step), size):
                    weight *= 0.1
                    break
                if size <= ORBIT_CLOSED * _scale(self.z):
                    return
                weight = max(10.0 * weight, DAMPED)
            else:
                return

    def _nearer(self, z: np.ndarray, period: float, size: float) -> bool:
        """Go to a state if the flight from there leaves less than a gap of some size."""
        # Every motion comes back after no time at all, and an equilibrium after any.
        if period <= _SHORTEST * self.first.period:
            return False
        try:
            flown = self.fly(z * self.sizes, period)
        except RuntimeError:  # no event, or a failure of the integration
            return False
        flight = self._scaled(flown)
        speed = np.linalg.norm(self._scaled(self.first).rates)
        if self.slope is not None and np.linalg.norm(flight.rates) < _SHORTEST * speed:
            return False
        z = flight.begun(z)
        if not float(np.abs(flight.end - z).max()) < size:
            return False
        self.z, self.flown, self.flight, self.period = z, flown, flight, period
        return True

    def _settle(self) -> None:
        """Take the last steps, from where rounding is all that is left of the gap."""
        for left in range(3, -1, -1):
            gap = self._gap()
            if np.abs(gap).max(initial=0.0) <= ORBIT_CLOSED * _scale(self.z):
                return
            # Unstable motion makes a larger gap of what rounding and the integration leave: then
            # the start is as good as steps to a better one are small.
            whole, right = self._equations()
            step = np.linalg.lstsq(whole, right, rcond=self.tolerance)[0]
            open_by = np.abs([*step, *(right - whole @ step)]).max()
            grown = self.tolerance * float(np.linalg.norm(self.flight.by_start, 2))
            known = float(np.abs(gap).max(initial=0.0)) <= grown
            if known and open_by <= ORBIT_CLOSED * _scale(self.z):
                return
            if not (known and left):
                raise _lost(self.names, self.z * self.sizes, gap * self.sizes, self.period)
            z, self.period = self._moved(step)
            self.flown = self.fly(z * self.sizes, self.period)
            self.flight = self._scaled(self.flown)
            self.z = self.flight.begun(z)

    def _equations(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the linear equations of a step that closes the gap, in the plane of the search."""
        gap = self._gap()
        whole = self.flight.by_start - np.eye(len(gap))
        if self.slope is None:
            return whole, -gap
        border = np.append(self.normal, 0.0)
        whole = np.vstack([np.column_stack([whole, self.flight.rates]), border])
        return whole, np.append(-gap, -self.normal @ (self.z - self.begun))


def _scale(z: np.ndarray) -> float:
    return max(1.0, float(np.abs(z).max(initial=0.0)))


def _lost(
    names: Sequence[str], z: np.ndarray, gap: np.ndarray, period: float
) -> PeriodicOrbitError:
    order = np.argsort(-np.abs(gap))[:3]
    left = ", ".join(f"{names[k]} by {gap[k]:.3g}" for k in order)
    return PeriodicOrbitError(
        f"No periodic orbit was found. Nearest, at {numbers_of(names, z)} with the "
        f"period {period:.6g} s, these change over it: {left}. Start closer to an "
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
    return "t" in assembly.graph.inputs_of(assembly.rates)


def _initial_conditions(problem: Problem) -> dict[Any, float]:
    """Return the states' values by symbol."""
    return dict(zip(problem.definition.states, problem.x.tolist(), strict=True))
