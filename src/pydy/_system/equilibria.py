"""Equilibria of a System; the search is in `pydy.analysis.equilibrium_residual`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from pydy._system.setup import Setup
from pydy.analysis.equilibria import Equilibrium
from pydy.analysis.equilibrium_residual import find_equilibrium


class Equilibria(Setup):
    """States in which the system remains."""

    @np.errstate(under="ignore")  # shares of sizes may be zero
    def find_equilibrium(
        self,
        unknowns: Iterable[Any] | None = None,
        given: dict[Any, float] | None = None,
        *,
        moving: Iterable[Any] = (),
        bounds: dict[Any, Any] | None = None,
    ) -> Equilibrium:
        """Find a state in which the system remains at rest or moves steadily.

        All other values are those of the System; the search starts from its initial conditions,
        and where none is near, from where the system settles if its swings die out.

        Parameters
        ----------
        unknowns : iterable of symbols or names, optional
            States, constants and specifieds to solve for; by default all coordinates and speeds
            that are neither given nor moving.
        given : dict, optional
            Values of other states, constants and specifieds for this search; of an unknown, the
            value to start from.
        moving : iterable of coordinates, optional
            Coordinates that may change at a constant rate, such as the position of a vehicle along
            its path. The motion must not depend on them.
        bounds : dict, optional
            Maps unknowns to pairs of the lowest and the highest value; None is no limit.

        Returns
        -------
        Equilibrium
            `initial_conditions`, `constants` and `specifieds` can be assigned to the System's
            attributes of the same names.

        Raises
        ------
        EquilibriumError
            No equilibrium was found; the message says how close the search came and which rows are
            not satisfied.
        ValueError
            A name is not one of the system's.

        Warns
        -----
        PyDyUserWarning
            The state is an equilibrium at the first of the times alone: specifieds, or loads, that
            change with time put it off it at others.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper(apply_gravity=True)
        >>> system.constants = {'m0': 2.0, 'k0': 5.0, 'g': 9.81}
        >>> found = system.find_equilibrium()
        >>> round(found.values[system.coordinates[0]], 6)
        3.924
        >>> system.initial_conditions = found.initial_conditions
        """
        return find_equilibrium(self._now(), unknowns, given, bounds, moving)
