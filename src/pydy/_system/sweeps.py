"""Sweeps of a System along a parameter; the work is in `pydy.analysis.families`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from pydy._system.setup import Setup
from pydy.analysis.continuation import EquilibriumBranch
from pydy.analysis.families import eigenvalues, follow_equilibria
from pydy.analysis.sweeps import EigenvalueSweep


class Sweeps(Setup):
    """Eigenvalues and equilibria along a parameter."""

    @np.errstate(under="ignore")  # shares of sizes may be zero
    def eigenvalues(
        self,
        over: dict[Any, Any],
        at: Any = None,
        *,
        unknowns: Iterable[Any] | None = None,
        given: dict[Any, float] | None = None,
        moving: Iterable[Any] = (),
        progress: bool = False,
    ) -> EigenvalueSweep:
        """Return the eigenvalues of the linear models along a parameter, sorted into branches.

        At each value of the parameter, the equilibrium is found from the previous one, and the
        motions near it that satisfy the constraints are linearised.

        Parameters
        ----------
        over : dict
            One state, constant or specified, by symbol or name, and its values, ascending or
            descending.
        at : array_like, shape (n,) or (m, n), or dict, optional
            States at which to linearise, without a search for equilibria: one, or one for each
            value.
        unknowns, given, moving
            As in `find_equilibrium`.
        progress : bool, optional
            Whether to show a progress bar; requires tqdm.

        Returns
        -------
        EigenvalueSweep

        Raises
        ------
        AnalysisInterrupted
            The user interrupted it; the error holds the sweep over the first values. So does a
            MemoryError.
        EquilibriumError
            There is no equilibrium at a value of the parameter.
        ValueError
            The system has no such name, or the values are neither ascending nor descending.

        Examples
        --------
        >>> import numpy as np
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> sweep = system.eigenvalues({'c0': np.linspace(-1.0, 3.0, num=9)})
        >>> [(round(c.value, 9), c.eigenvalue, c.oscillatory) for c in sweep.crossings()]
        [(0.0, 1j, True)]
        """
        return eigenvalues(
            self._now(),
            over,
            at=at,
            unknowns=unknowns,
            given=given,
            moving=moving,
            progress=progress,
        )

    @np.errstate(under="ignore")  # shares of sizes may be zero
    def follow_equilibria(
        self,
        over: dict[Any, Any],
        unknowns: Iterable[Any] | None = None,
        given: dict[Any, float] | None = None,
        *,
        moving: Iterable[Any] = (),
        step: float = 0.02,
        most: int = 500,
        progress: bool = False,
    ) -> EquilibriumBranch:
        """Follow equilibria along a parameter, around folds, and detect bifurcations.

        Parameters
        ----------
        over : dict
            One state, constant or specified, mapped to a list of its first and last value. The
            search starts from an equilibrium at the first value.
        unknowns, given, moving
            As in `find_equilibrium`.
        step : float, optional
            The largest step along the branch, as a fraction of the parameter's range.
        most : int, optional
            The maximum number of points.
        progress : bool, optional
            Whether to show a progress bar; requires tqdm.

        Returns
        -------
        EquilibriumBranch
            It ends where the parameter leaves its range, or where the branch returns to its start.

        Raises
        ------
        AnalysisInterrupted
            The user interrupted it; the error holds the branch so far. So does a MemoryError.
        EquilibriumError
            There is no equilibrium at the first value.
        ValueError
            A name is not one of the system's.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> (point,) = system.follow_equilibria({'c0': [1.0, -1.0]}).special
        >>> point.kind, abs(round(point.value, 9)), round(point.frequency, 9)
        ('Hopf', 0.0, 1.0)
        """
        return follow_equilibria(
            self._now(),
            over,
            unknowns=unknowns,
            given=given,
            moving=moving,
            step=step,
            most=most,
            progress=progress,
        )
