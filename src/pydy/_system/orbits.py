"""Periodic orbits of a System: its simulations with sensitivities as a map of states."""

from __future__ import annotations

from collections.abc import Iterable
from copy import copy
from dataclasses import replace
from typing import Any

import numpy as np

from pydy._checks import flag, listed, positive, shown
from pydy._errors import PeriodicOrbitError, finished_before
from pydy._names import some, unique_names
from pydy._optional import progress_of
from pydy._rank import HALF, or_one
from pydy._system.balance import energetic_motions
from pydy._system.dependents import latest_dependents
from pydy._system.jumps import warn_of_jumps
from pydy._system.simulation import Simulation
from pydy._system.snapshot import Snapshot
from pydy._system.solving import native_solver
from pydy._system.tuning import BEGINNING, ORBIT
from pydy._system.values import Evaluation
from pydy.analysis.orbits import Flight, Measure, PeriodicOrbit, shoot
from pydy.analysis.tuning import ORBIT_CLOSED
from pydy.solvers.events import Event

# How long an event is waited for, in periods as guessed.
_PATIENCE = 5.0
_SAMPLES = 201
# Samples that tell how large states become on the way, and how often that is looked at again.
_ON_THE_WAY, _RESIZED = 65, 5


def _depends_on_time(now: Snapshot) -> bool:
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
            A load, or another rate, jumps on the way: the multipliers know nothing of it.

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
        now = self._now()
        guess = positive(period, "`period`", finite=True)
        if not now.t + guess / _SAMPLES > now.t:
            raise ValueError(
                f"`period` must be long enough for {_SAMPLES} times from {now.t:g} on that differ "
                f"as floats, got {guess!r}."
            )
        if until is not None and not isinstance(until, Event):
            raise TypeError(f"`until` must be a pydy.solvers.Event, got {type(until).__name__}.")
        definition = now.definition
        equations, states = definition.equations, definition.places["states"]
        steady = sorted(states.columns(listed("moving", moving), "moving").tolist())
        dependent = latest_dependents(definition, self._dependent)
        if not dependent and (equations.holonomic or equations.velocity):
            raise ValueError(
                "A periodic orbit can be searched for only where it is known which states follow "
                "from the others by the constraints; none is named as dependent. Call "
                "`set_dependent_initial_conditions(dep_vars=…)` first, with as many as constraints."
            )
        tied = {definition.states.index(s) for s in dependent}
        count = len(equations.coordinates) + len(equations.speeds)
        free = [k for k in range(count) if k not in tied.union(steady)]
        if not free:
            raise ValueError(
                "There is no state to search for: `moving` and the constraints determine all of "
                "them. The motion is the one that `simulate` returns."
            )
        kept = [definition.states[k] for k in range(count) if k not in tied]
        names = unique_names(definition.states)
        columns = [kept.index(definition.states[k]) for k in free]
        rows = [definition.states.index(s) for s in kept]
        advancing = [kept.index(definition.states[k]) for k in steady if k not in tied]
        pushed = np.zeros(len(free))  # by how much the end changes as those advance that move
        runner = copy(self)
        runner._searching = True
        runner.ode_solver = native_solver(self.ode_solver)
        held = None  # the modes of contacts at the start
        if contacts is not None:
            if getattr(contacts, "system", None) is not self:
                raise TypeError(
                    f"`contacts` must be Contacts of this System, got {shown(contacts)}."
                )
            contacts = copy(contacts)
            contacts.system = runner
        options = {"rtol": ORBIT, **solver_kwargs}
        chosen = "atol" not in solver_kwargs
        if tied:
            options.setdefault("constraints", "project")
        t0 = now.t
        autonomous = until is None and not _depends_on_time(now)
        if contacts is not None:
            autonomous &= not contacts.depends_on_time

        def begin(z: np.ndarray) -> None:
            """Set the states at the start; the dependent ones follow."""
            x = now.x.copy()
            x[free] = z
            runner.initial_conditions = dict(zip(definition.states, x.tolist(), strict=True))
            if tied:
                runner.set_dependent_initial_conditions(dependent)

        def rates_of(ride: Any, x: np.ndarray, t: float, last: int = -1) -> np.ndarray:
            """Return the derivatives of the states, where a motion ends or begins."""
            if contacts is None:
                return np.array(runner.evaluate_ode(x, t))
            found: np.ndarray = ride.end(last)[1](np.array([t]), x[None])[0]
            return found

        def run(times: Any, modes: Any = None, **more: Any) -> Any:
            runner.times = times
            # A state that stays would be followed in steps that are too long for its neighbours.
            more = {"sensitivities": kept, "control_sensitivities": True, **more, **options}
            return runner.simulate(**more) if contacts is None else contacts.resumed(modes, **more)

        nearest: dict[str, Any] = {
            "period": guess,
            "initial_conditions": dict(self.initial_conditions),
        }
        least = np.inf
        speeds = np.arange(len(now.x)) >= len(equations.coordinates)

        def fly(z: np.ndarray, length: float) -> Flight:
            nonlocal least
            begin(z)
            started = dict(runner.initial_conditions)
            flight = flown(z, length)
            gap = float((np.abs(flight.end - z) / begun[free]).max(initial=0.0))
            if gap < least:
                least = gap
                nearest.update(period=flight.period, initial_conditions=started)
            told(1, gap=f"{gap:.3g}")
            return flight

        def flown(z: np.ndarray, length: float) -> Flight:
            if until is None:
                ride = run(np.linspace(t0, t0 + length, num=_ON_THE_WAY), held)
                end, slopes, instant = ride.states[-1], ride.sensitivity.values[-1], t0 + length
                start = ride.states[0]
                rates = rates_of(ride, end, instant)
                advance = np.abs(end - start)[[rows[k] for k in advancing]]
                pushed[:] = np.abs(slopes[np.ix_(free, advancing)]) @ advance
            else:
                first = run([t0, t0 + BEGINNING * guess], held)
                start, modes = first.states[0], None if contacts is None else first.end()[0]
                runner.initial_conditions = dict(
                    zip(definition.states, first.states[-1].tolist(), strict=True)
                )
                ending = replace(until, terminal=True)
                times = np.linspace(t0 + BEGINNING * guess, t0 + _PATIENCE * guess, num=_ON_THE_WAY)
                ride = run(times, modes, events=ending)
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
                end, instant = event.after, event.time
                rates = rates_of(ride, end, instant)
                after = event.sensitivity_after + np.outer(rates, event.time_sensitivity)
                slopes = after @ first.sensitivity.values[-1][rows]
            return Flight(
                end[free],
                slopes[np.ix_(free, columns)],
                rates[free],
                instant - t0,
                sizes_along(ride.times, ride.states, end, rates, instant - t0),
                None if contacts is None else start[free],
            )

        def sizes_along(
            times: np.ndarray,
            states: np.ndarray,
            end: np.ndarray,
            rates: np.ndarray,
            length: float,
        ) -> np.ndarray:
            """Return the sizes of all states on a flight."""
            natural, moved = energetic_motions(now, times, states)
            most = np.abs(np.concatenate([states, end[None]])).max(axis=0)
            return Measure(free, speeds, natural, moved).sizes(most, rates, length)

        start = now.x[free]
        slope = None
        begin(start)
        beginning = np.array([runner.initial_conditions[s] for s in definition.states])
        if contacts is None:
            rates = runner.evaluate_ode()
        else:
            ride = run([t0, t0 + BEGINNING * guess])
            held, rates = ride.end(0)[0], rates_of(ride, ride.states[0], t0, 0)
        at_start = np.array([t0]), beginning[None], beginning
        if autonomous:
            slope = rates[free]
            own = sizes_along(*at_start, np.zeros_like(rates), guess)[free]
            if (np.abs(slope) * guess <= ORBIT_CLOSED * own * start.any()).all():
                raise ValueError(
                    "The initial conditions are an equilibrium, which is no orbit. Start "
                    "elsewhere, or use `find_equilibrium`."
                )
            slope = slope / np.linalg.norm(slope)
        begun = sizes_along(*at_start, rates, guess)
        if chosen:
            options["atol"] = ORBIT * begun
        with progress_of(flag(progress, "`progress`"), " flights") as told:
            try:
                z, flight = start, fly(start, guess)
                begun = flight.sizes
                for _ in range(_RESIZED):
                    sizes = flight.sizes
                    if chosen:
                        coarse = (options["atol"] > 2.0 * ORBIT * sizes).any()
                        options["atol"] = ORBIT * sizes
                        if coarse:
                            flight = fly(z, flight.period)
                    z, flight, residual = shoot(
                        fly, flight, sizes[free], z, flight.period, slope,
                        [names[k] for k in free], float(np.max(options["rtol"])),
                    )  # fmt: skip
                    # A first flight that led far away told nothing of the orbit.
                    again = flight.sizes
                    if (again >= 0.5 * sizes).all() or (again <= ORBIT * begun).all():
                        break
                if (pushed > ORBIT_CLOSED * flight.sizes[free]).any():
                    on = names[free[int((pushed / flight.sizes[free]).argmax())]]
                    raise ValueError(
                        f"`moving` must not have coordinates that the motion depends on, got "
                        f"{some(names[k] for k in steady)}, on which {on} depends: a motion "
                        "in which they advance does not repeat. Leave them out, or end the period "
                        "with an event `until` that sets them back."
                    )
                begin(z)
                initial = dict(runner.initial_conditions)
                runner.times = np.linspace(t0, t0 + flight.period, num=_SAMPLES)
                runner._searching = False
                if contacts is None:
                    trajectory = runner.simulate(**options)
                    warn_of_jumps(now, lambda: trajectory)
                    if until is None and not autonomous:
                        _check_period(runner, trajectory, flight.period)
                else:  # what contacts hold is projected at the start
                    trajectory = contacts.resumed(held, **options)
                    initial = dict(zip(initial, trajectory.states[0].tolist(), strict=True))
            except (KeyboardInterrupt, MemoryError) as stop:
                raise finished_before(
                    stop,
                    "The period and the initial conditions that came nearest to an orbit are",
                    "The search for a periodic orbit was interrupted. The period and the initial "
                    "conditions that came nearest to one are in the attribute `results` of this "
                    "error.",
                    nearest,
                ) from None
        moved = np.ptp(trajectory.states[:, free], axis=0)
        return PeriodicOrbit(
            period=flight.period,
            initial_conditions=initial,
            states=tuple(names[k] for k in free),
            monodromy=flight.by_start,
            residual=residual,
            autonomous=autonomous,
            equilibrium=bool((moved <= ORBIT * begun[free]).all()),
            trajectory=trajectory,
        )


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
