"""Periodic orbits of a System; the search is in `pydy.analysis.orbits`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from pydy._checks import instance, listed
from pydy._simulation.events_and_constraints import native_solver
from pydy._system.setup import Setup
from pydy.analysis.orbits import PeriodicOrbit, find_periodic_orbit
from pydy.solvers.events import Event


class Orbits(Setup):
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
        if until is not None:
            instance(until, Event, "`until`", "a pydy.solvers.Event")
        further = solver_kwargs.get("events", ())
        events = [*([] if until is None else [until]), *listed("events", further, "events")]
        problem = self._now(events or None, contacts=self._checked_contacts(contacts))
        return find_periodic_orbit(
            problem,
            period,
            moving=moving,
            until=until,
            solver=native_solver(self.ode_solver),
            progress=progress,
            **solver_kwargs,
        )
