"""Fits of a System to measured motions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from copy import copy
from typing import Any

from pydy._simulation.problem import Problem
from pydy._system.setup import Setup
from pydy.analysis.fits.fit import fit
from pydy.analysis.fits.problem import FittedSystem
from pydy.analysis.fits.result import FitResult
from pydy.analysis.fits.trial import Trial


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
        IntegrationError
            The motion that the search begins with cannot be computed; or the velocity constraints
            do not keep a holonomic one, whose derivative is missing.
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
        twin = copy(self)
        twin._contradicted = None  # its numbers are only tried
        self._checked_contacts(contacts)

        def settings(events: Any, constants: Mapping[Any, Any]) -> Problem:
            return self._now(events, constants, contacts)

        def tried(events: Any, outputs: Any, constants: Any, specifieds: Any) -> Problem:
            if outputs:
                twin.outputs = {**self.outputs, **outputs}
            twin.constants, twin.specifieds = constants, specifieds
            return twin._now(events, contacts=contacts)

        return fit(
            FittedSystem(settings, tried, self.ode_solver, contacts),
            parameters,
            trials,
            bounds=bounds,
            priors=priors,
            segments=segments,
            method=method,
            mesh=mesh,
            process_noise=process_noise,
            solver=solver,
            most=most,
            progress=progress,
            options=solver_kwargs,
        )
