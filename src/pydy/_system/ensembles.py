"""Ensembles of a System; they are integrated by `pydy.ensemble.integration`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from pydy._simulation.events_and_constraints import native_solver
from pydy._system.setup import Setup
from pydy.ensemble.integration import integrate_ensemble

if TYPE_CHECKING:
    from typing import Unpack

    from numpy.typing import ArrayLike

    from pydy._simulation.events_and_constraints import EnsembleOptions


class Ensembles(Setup):
    """Many trajectories at a time."""

    def integrate_ensemble(
        self,
        *,
        initial_conditions: Mapping[Any, Any] | None = None,
        constants: Mapping[Any, Any] | None = None,
        specifieds: Mapping[Any, Any] | None = None,
        times: ArrayLike | None = None,
        ode_solver: Any = None,
        product: bool = False,
        sensitivities: Any = None,
        control_sensitivities: Any = False,
        reduce: Any = None,
        chunks: Any = None,
        store: Any = None,
        resume: bool | str = False,
        workers: int | None = None,
        progress: bool = False,
        units: Mapping[Any, str] | None = None,
        contacts: Any = None,
        **solver_kwargs: Unpack[EnsembleOptions],
    ) -> Any:
        """Integrate many trajectories of the system, each with different values.

        Values that are not passed are those of the System. Eight trajectories at a time share the
        processor's vector registers, and blocks of trajectories are distributed over its cores. The
        results are bitwise identical for any `chunks`, `workers` and scheduler.

        Parameters
        ----------
        initial_conditions, constants, specifieds : dict, optional
            Like the attributes of the same names, but a value may also be a one-dimensional array
            with one entry for each sample, or an `xarray.DataArray` along any dimensions, which are
            matched by name. Numbers, and specifieds that are functions, expressions or
            SampledInputs, are the same for all samples.
        times : array_like, shape (m,), optional
        ode_solver : {'dop853', 'tsit5', 'vern9', 'rk4', 'radau'} or Solver, optional
            By default the System's, or ``'dop853'`` if that is not native.
        product : bool, optional
            Whether each one-dimensional array gets its own dimension, named after its symbol
            (``initial_q1`` for an initial condition of ``q1``), so that the samples are all
            combinations.
        sensitivities : symbol, name, group, or iterable of these, optional
            Parameters with respect to which every trajectory is differentiated, as in `simulate`.
            The variable ``sensitivity`` has the dimensions ``quantity`` (states and outputs) and
            ``parameter``.
        control_sensitivities : bool, optional
            As in `simulate`.
        reduce : optional
            What to return instead of the values at all times: ``'final'``; ``('max', name)`` or
            ``('min', name)`` of a state or output; ``'events'`` or ``('events', number)`` for the
            first times of each event; a list of these; or a function that takes the Dataset of some
            samples and returns a Dataset that keeps the sample dimensions.
        chunks : int, 'auto' or dict of str to int, optional
            Sizes of blocks of samples. The Dataset is then lazy: it contains Dask arrays, computed
            by the scheduler that you choose. With `store`, this only sets the sizes.
        store : path, optional
            Path of a Zarr store, to which every finished block is written immediately, with
            checksums; so has what describes its arrays.
        resume : bool or str, optional
            Whether `store` may exist; only its missing, damaged or misplaced blocks are then
            computed. All that is data must be as in the first call, which is checked. Python
            functions in `reduce` and `specifieds` are not looked at: with them, `resume` must be
            your own name for them, a string, which you pass from the first call on and change when
            the functions change.
        workers : int, optional
            Number of threads; by default one for each processor.
        progress : bool, optional
            Whether to show a progress bar; requires tqdm.
        units : dict of symbols or names to str, optional
            Values of the attribute ``units`` of the variables.
        contacts : pydy.contact.Contacts, optional
            Contacts of this System: trajectories are those of `Contacts.simulate`, one by one, with
            its outputs. Samples share the compiled modes. `reduce='events'` has the transitions.
        **solver_kwargs
            Options of the solver, and `events`, `constraints` and `gain` as in `integrate`.

        Returns
        -------
        xarray.Dataset
            One variable for each state and output along the sample dimensions and ``time``; varied
            quantities as coordinates; ``steps``, ``rejected``, ``evaluations``, ``end_time``, and
            ``status``, whose attribute ``flag_meanings`` explains its values. A sample that fails
            is NaN from then on; the others are not affected.

        Raises
        ------
        ValueError
            A value, name or shape is not valid; raised before anything is computed.
        ImportError
            A package is missing: ``pip install 'pydy[ensemble]'``.
        EnsembleInterrupted
            The user interrupted the computation; without a store, the exception contains the
            finished samples.

        Warns
        -----
        PyDyUserWarning
            Outputs are not finite, or samples do not begin on the constraints: dependent initial
            conditions are not solved for again where others vary. Or a reset leaves them; or a load
            jumps on the way, which `sensitivities` do not know.

        Notes
        -----
        Trajectories are integrated one by one, by the same solvers, if specifieds are Python
        functions, with `control_sensitivities`, sensitivities with respect to samples, `events` or
        ``constraints='project'``, with `events` and ``constraints='project'`` together, with resets
        and SampledInputs together, and with 'radau'. Samples that fail are repeated in this way.

        Examples
        --------
        >>> import numpy as np
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> x0, v0 = system.states
        >>> results = system.integrate_ensemble(
        ...     initial_conditions={x0: [1.0, 2.0, 3.0]}, times=np.linspace(0.0, 1.0, num=11)
        ... )
        >>> dict(results.sizes)
        {'sample': 3, 'time': 11}
        >>> results.x0.isel(time=-1).values.round(4)
        array([0.6597, 1.3194, 1.9791])
        >>> (results.status == 0).all().item()
        True
        """
        if contacts is not None:
            self._checked_contacts(contacts)
        problem = self._now(solver_kwargs.get("events"), constants, contacts)
        return integrate_ensemble(
            problem,
            initial_conditions=initial_conditions,
            constants=constants,
            specifieds=specifieds,
            times=times,
            solver=native_solver(self._ode_solver) if ode_solver is None else ode_solver,
            product=product,
            sensitivities=sensitivities,
            control_sensitivities=control_sensitivities,
            reduce=reduce,
            chunks=chunks,
            store=store,
            resume=resume,
            workers=workers,
            progress=progress,
            units=units,
            options=dict(solver_kwargs),
        )
