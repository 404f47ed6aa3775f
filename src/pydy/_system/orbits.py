"""Periodic orbits of a System: its simulations with sensitivities as a map of states."""

from __future__ import annotations

from collections.abc import Iterable
from copy import copy
from dataclasses import replace
from typing import Any

import numpy as np

from pydy._checks import flag, instance, listed, positive, shown
from pydy._errors import PeriodicOrbitError, finished_before
from pydy._names import some, unique_names
from pydy._optional import progress_of
from pydy._rank import HALF, or_one
from pydy._simulation.dependent_states import latest_dependents
from pydy._simulation.discontinuities import warn_of_jumps
from pydy._simulation.events_and_constraints import native_solver
from pydy._simulation.problem import Problem
from pydy._simulation.states import energetic_motions
from pydy._simulation.tuning import BEGINNING, ORBIT
from pydy._system.simulation import Simulation
from pydy._system.values import Evaluation
from pydy.analysis.orbits import Flight, Measure, PeriodicOrbit, Shooting
from pydy.analysis.tuning import ORBIT_CLOSED
from pydy.solvers.events import Event

# How long an event is waited for, in periods as guessed.
_PATIENCE = 5.0

_SAMPLES = 201
# Samples that tell how large states become on the way, and how often that is looked at again.
_ON_THE_WAY, _RESIZED = 65, 5


def _depends_on_time(now: Problem) -> bool:
    plan = now.plan
    if plan.functions or plan.sampled:
        return True
    assembly = now.driven.assembly
    return "t" in assembly.graph.inputs_of(assembly.rates)


class Orbits(Simulation, Evaluation):
    """Periodic motions."""

    @np.errstate(under="ignore")  # shares of sizes may be zero
    def find_periodic_orbit(
        self,
        period: float,
        *,
        moving: Iterable[Any] = (),
        until: Event | None = None,
        progress: bool = False,
        contacts: Any = None,
        **solver_kwargs: Any,
    ) -> PeriodicOrbit:
        """Find a periodic motion by shooting, and its Floquet multipliers.

        The search starts from the initial conditions.

        Parameters
        ----------
        period : float
            In s. If the equations depend on time, the period itself; otherwise the initial guess of
            the period.
        moving : iterable of coordinates, optional
            Coordinates that may advance from period to period, such as the position of a vehicle.
            Without `until`, the motion must not depend on them.
        until : Event, optional
            The period ends when this happens, after its reset: the impact of a walker's foot, say.
        progress : bool, optional
            Whether to show a progress bar, with the remaining gap; requires tqdm.
        contacts : pydy.contact.Contacts, optional
            Contacts of this System: the motion is that of `Contacts.simulate`. Its start stays in
            the modes of the initial conditions; an event `until` must not be a transition.
        **solver_kwargs
            Options of the native solver (``'dop853'`` if `ode_solver` is not native); `rtol` is
            1e-12 by default, and `atol` as much of the sizes of the states along the way.
            Constraints are enforced by projection.

        Returns
        -------
        PeriodicOrbit

        Raises
        ------
        PeriodicOrbitError
            No periodic orbit was found; the message says how close the search came.
        AnalysisInterrupted
            The user interrupted it; the error holds the motion that came nearest to an orbit. So
            does a MemoryError.

        Warns
        -----
        PyDyUserWarning
            A load, or another rate, jumps along the orbit: the multipliers do not include it.

        Examples
        --------
        A damped oscillator driven by a force sin(t):

        >>> import numpy as np
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper(1, False, True, external_force_as_sin_of_t=True)
        >>> orbit = system.find_periodic_orbit(2 * np.pi)
        >>> bool(np.allclose(np.abs(orbit.multipliers), np.exp(-np.pi))), orbit.stable
        (True, True)
        """
        search = _Search(self, period, moving, until, contacts, solver_kwargs)
        with progress_of(flag(progress, "`progress`"), " flights") as search.told:
            try:
                return search.found()
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
    """A System that flies for a period, from start to start."""

    def __init__(
        self,
        system: Orbits,
        period: float,
        moving: Iterable[Any],
        until: Event | None,
        contacts: Any,
        options: dict[str, Any],
    ) -> None:
        self.now = now = system._now()
        self.t0, self.guess = now.t, positive(period, "`period`", finite=True)
        if not now.t + self.guess / _SAMPLES > now.t:
            raise ValueError(
                f"`period` must be long enough for {_SAMPLES} times from {now.t:g} on that differ "
                f"as floats, got {shown(self.guess)}."
            )
        if until is not None:
            instance(until, Event, "`until`", "a pydy.solvers.Event")
        self.until = until
        self._choose_states(system, moving)
        self.runner = copy(system)
        self.runner._searching = True
        self.runner.ode_solver = native_solver(system.ode_solver)
        self.autonomous = until is None and not _depends_on_time(now)
        if system._checked_contacts(contacts) is not None:
            self.autonomous &= not contacts.depends_on_time
        self.contacts = contacts and contacts.of(self.runner)
        self.held: Any = None  # the modes of contacts at the start
        self.options = {"rtol": ORBIT, **options}
        self.chosen = "atol" not in options
        if self.dependent:
            self.options.setdefault("constraints", "project")
        self.nearest: dict[str, Any] = {
            "period": self.guess,
            "initial_conditions": dict(system.initial_conditions),
        }
        self.least = np.inf  # the gap of that
        self.told: Any = None  # what shows the progress

    def _choose_states(self, system: Orbits, moving: Iterable[Any]) -> None:
        """Divide the states into unknowns of the search, advancing states, and dependent ones."""
        definition = self.now.definition
        equations, states = definition.equations, definition.places["states"]
        self.steady = sorted(states.columns(listed("moving", moving), "moving").tolist())
        self.dependent = latest_dependents(definition, system._dependent)
        if not self.dependent and (equations.holonomic or equations.velocity):
            raise ValueError(
                "A periodic orbit can be searched for only where it is known which states follow "
                "from the others by the constraints; none is named as dependent. Call "
                "`set_dependent_initial_conditions(dep_vars=…)` first, with as many as constraints."
            )
        tied = {definition.states.index(s) for s in self.dependent}
        count = len(equations.coordinates) + len(equations.speeds)
        self.free = [k for k in range(count) if k not in tied.union(self.steady)]
        if not self.free:
            raise ValueError(
                "There is no state to search for: `moving` and the constraints determine all of "
                "them. The motion is the one that `simulate` returns."
            )
        self.rows = [k for k in range(count) if k not in tied]
        self.kept = [definition.states[k] for k in self.rows]
        self.columns = [self.rows.index(k) for k in self.free]
        self.advancing = [self.rows.index(k) for k in self.steady if k not in tied]
        # By how much the end changes as those advance that move.
        self.pushed = np.zeros(len(self.free))
        self.names = unique_names(definition.states)

    def begin(self, z: np.ndarray) -> None:
        """Set the states at the start; the dependent ones follow."""
        x = self.now.x.copy()
        x[self.free] = z
        self._set(x)
        if self.dependent:
            self.runner.set_dependent_initial_conditions(self.dependent)

    def _set(self, x: np.ndarray) -> None:
        states = self.now.definition.states
        self.runner.initial_conditions = dict(zip(states, x.tolist(), strict=True))

    def run(self, times: Any, modes: Any = None, **more: Any) -> Any:
        """Simulate with sensitivities, and with contacts in `modes` at the start."""
        self.runner.times = times
        # A state that stays would be followed in steps that are too long for its neighbours.
        own = {"sensitivities": self.kept, "control_sensitivities": True}
        more = {**own, **more, **self.options}
        if self.contacts is None:
            return self.runner.simulate(**more)
        return self.contacts.resumed(modes, **more)

    def rates_of(self, ride: Any, x: np.ndarray, t: float, last: int = -1) -> np.ndarray:
        """Return the derivatives of the states, where a motion ends or begins."""
        if self.contacts is None:
            return np.array(self.runner.evaluate_ode(x, t))
        found: np.ndarray = ride.end(last)[1](np.array([t]), x[None])[0]
        return found

    def sizes_along(
        self,
        times: np.ndarray,
        states: np.ndarray,
        end: np.ndarray,
        rates: np.ndarray,
        length: float,
    ) -> np.ndarray:
        """Return the sizes of all states on a flight."""
        natural, moved = energetic_motions(self.now, times, states)
        most = np.abs(np.concatenate([states, end[None]])).max(axis=0)
        speeds = np.arange(len(end)) >= len(self.now.definition.equations.coordinates)
        return Measure(self.free, speeds, natural, moved).sizes(most, rates, length)

    def fly(self, z: np.ndarray, length: float) -> Flight:
        """Fly for a period from states `z`; the start that comes nearest to its end is kept."""
        self.begin(z)
        started = dict(self.runner.initial_conditions)
        flight = self._for_a_time(length) if self.until is None else self._until(self.until, z)
        gap = float((np.abs(flight.end - z) / self.begun[self.free]).max(initial=0.0))
        if gap < self.least:
            self.least = gap
            self.nearest.update(period=flight.period, initial_conditions=started)
        self.told(1, gap=f"{gap:.3g}")
        return flight

    def _for_a_time(self, length: float) -> Flight:
        instant = self.t0 + length
        ride = self.run(np.linspace(self.t0, instant, num=_ON_THE_WAY), self.held)
        start, end, slopes = ride.states[0], ride.states[-1], ride.sensitivity.values[-1]
        advance = np.abs(end - start)[[self.rows[k] for k in self.advancing]]
        self.pushed[:] = np.abs(slopes[np.ix_(self.free, self.advancing)]) @ advance
        return self._flight(ride, start, end, self.rates_of(ride, end, instant), slopes, instant)

    def _until(self, until: Event, z: np.ndarray) -> Flight:
        t0, guess = self.t0, self.guess
        first = self.run([t0, t0 + BEGINNING * guess], self.held)
        modes = None if self.contacts is None else first.end()[0]
        self._set(first.states[-1])
        ending = replace(until, terminal=True)
        times = np.linspace(t0 + BEGINNING * guess, t0 + _PATIENCE * guess, num=_ON_THE_WAY)
        ride = self.run(times, modes, events=ending)
        happened = [event for event in ride.events if event.name == ending.name]
        if not happened:
            raise PeriodicOrbitError(
                f"The event `{until.name}` does not happen within {_PATIENCE:g} times the "
                f"`period` of {guess:g} s. Give a period nearer to it, or other initial "
                "conditions.",
                z,
                np.full(len(z), np.nan),
            )
        event = happened[-1]
        rates = self.rates_of(ride, event.after, event.time)
        after = event.sensitivity_after + np.outer(rates, event.time_sensitivity)
        slopes = after @ first.sensitivity.values[-1][self.rows]
        return self._flight(ride, first.states[0], event.after, rates, slopes, event.time)

    def _flight(
        self,
        ride: Any,
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
            self.sizes_along(ride.times, ride.states, end, rates, period),
            None if self.contacts is None else start[free],
        )

    def _slope_at_start(self) -> np.ndarray | None:
        """Measure the start; return the direction in which the motion leaves, if it may be late.

        Where the equations depend on time, or the period has an end of its own, it may not.
        """
        t0, guess, free = self.t0, self.guess, self.free
        self.begin(self.now.x[free])
        conditions = self.runner.initial_conditions
        beginning = np.array([conditions[s] for s in self.now.definition.states])
        if self.contacts is None:
            rates = self.runner.evaluate_ode()
        else:
            ride = self.run([t0, t0 + BEGINNING * guess])
            self.held, rates = ride.end(0)[0], self.rates_of(ride, ride.states[0], t0, 0)
        at_start = np.array([t0]), beginning[None], beginning
        slope: np.ndarray | None = None
        if self.autonomous:
            slope = rates[free]
            own = self.sizes_along(*at_start, np.zeros_like(rates), guess)[free]
            moves = self.now.x[free].any()
            if (np.abs(slope) * guess <= ORBIT_CLOSED * own * moves).all():
                raise ValueError(
                    "The initial conditions are an equilibrium, which is no orbit. Start "
                    "elsewhere, or use `find_equilibrium`."
                )
            slope = slope / np.linalg.norm(slope)
        self.begun = self.sizes_along(*at_start, rates, guess)
        if self.chosen:
            self.options["atol"] = ORBIT * self.begun
        return slope

    def found(self) -> PeriodicOrbit:
        """Search until states come back, in units of the sizes that they have on the way."""
        slope, free = self._slope_at_start(), self.free
        z = self.now.x[free]
        flight = self.fly(z, self.guess)
        self.begun = flight.sizes
        names = [self.names[k] for k in free]
        for _ in range(_RESIZED):
            sizes = flight.sizes
            if self.chosen:
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
        initial, trajectory = self._motion(z, flight.period)
        moved = np.ptp(trajectory.states[:, free], axis=0)
        return PeriodicOrbit(
            period=flight.period,
            initial_conditions=initial,
            states=tuple(names),
            monodromy=flight.by_start,
            residual=residual,
            autonomous=self.autonomous,
            equilibrium=bool((moved <= ORBIT * self.begun[free]).all()),
            trajectory=trajectory,
        )

    def _motion(self, z: np.ndarray, period: float) -> tuple[dict[Any, float], Any]:
        """Simulate the orbit: its initial conditions, and the trajectory."""
        self.begin(z)
        initial, runner = dict(self.runner.initial_conditions), self.runner
        runner.times = np.linspace(self.t0, self.t0 + period, num=_SAMPLES)
        runner._searching = False
        runner._contradicted = None  # where the orbit begins was computed, with errors
        if self.contacts is not None:  # what contacts hold is projected at the start
            trajectory = self.contacts.resumed(self.held, **self.options)
            return dict(zip(initial, trajectory.states[0].tolist(), strict=True)), trajectory
        trajectory = runner.simulate(**self.options)
        if self.now.definition.assumes_motions:
            self.now.check_motion(trajectory.times, trajectory.states)
        warn_of_jumps(self.now, lambda: trajectory)
        if self.until is None and not self.autonomous:
            _check_period(runner, trajectory, period)
        return initial, trajectory


def _check_period(system: Any, motion: Any, period: float) -> None:
    """Refuse a motion that ends as it began where the equations do not: it would not repeat."""
    if system._now().plan.sampled:  # whose times end
        return
    times, states = motion.times[:: _SAMPLES // 16], motion.states[:: _SAMPLES // 16]
    now, later = (system.evaluate_ode(states, times + late) for late in (0.0, period))
    off = np.abs(later - now) / or_one(np.maximum(np.abs(now), np.abs(later)).max(axis=0))
    k, j = np.unravel_index(int(np.nan_to_num(off).argmax()), off.shape)
    if off[k, j] > HALF:
        raise PeriodicOrbitError(
            f"The equations do not have the `period` {period:.6g} s, after which the motion is as "
            f"at its start: at t = {times[k]:.6g} the derivative of {motion.state_symbols[j]} is "
            f"{now[k, j]:.6g}, that time later {later[k, j]:.6g} in the same state. Give a period "
            "of all that depends on time.",
            states[0],
            (later - now)[k],
        )
