"""Simulations of a System: a solver called, its result with names."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Literal, overload

import numpy as np

from pydy._checks import flag
from pydy._optional import progress_of
from pydy._simulation.dependent_states import (
    check_dependents,
    default_dependents,
    given_values,
    solve_dependents,
)
from pydy._simulation.diagnostics import warn_of_outputs
from pydy._simulation.discontinuities import warn_of_jumps
from pydy._simulation.integration import integrate_states, simulate
from pydy._simulation.problem import Problem
from pydy._simulation.scipy_solvers import (
    SolveIvp,
    is_odeint,
)
from pydy._simulation.sensitivities import SensitivityRequest
from pydy._system.setup import Setup
from pydy.codegen.right_hand_side import rates_function
from pydy.solvers.solver import Solver
from pydy.trajectory import Trajectory


class Simulation(Setup):
    """Integration, and the initial conditions that it begins with."""

    def set_dependent_initial_conditions(
        self, dep_vars: Iterable[Any] | None = None, use_jac: bool = False, **root_kwargs: Any
    ) -> None:
        """Set the dependent states' initial conditions so that the constraints are satisfied.

        The holonomic constraints are solved for the dependent coordinates with
        `scipy.optimize.root`, starting from their current values; then the velocity constraints,
        which are linear, for the dependent speeds.

        Parameters
        ----------
        dep_vars : iterable of functions of time, optional
            One coordinate for each holonomic constraint and one speed for each velocity constraint;
            by default the dependent ones of the method, but speeds that you gave a value other than
            zero are kept, as far as the constraints determine others; coordinates too, unless you
            chose the dependent ones: then their values are what the search begins with, as is a
            whole state.
        use_jac : bool, optional
            Whether the root finder gets the exact Jacobian.
        **root_kwargs
            For `scipy.optimize.root`.

        Raises
        ------
        ValueError
            The system has no constraints, or `dep_vars` does not match their number.

        Warns
        -----
        PyDyUserWarning
            The root finder did not converge; its result is set nevertheless. Or a value that you
            gave had to change.
        """
        problem, own = self._now(), self._definition.places["states"]
        # A new dictionary: the old one may be the caller's own. Its keys may be names.
        conditions, latest = dict(self._initial_conditions), self._dependent or {}
        keys = {own.symbols[own.find(key, "initial_conditions")]: key for key in conditions}
        given: dict[Any, float] = {}
        if dep_vars is None:
            given = given_values(problem, keys, latest)
            dep_vars = default_dependents(problem, given)
        places = check_dependents(self._definition, dep_vars)
        x = solve_dependents(problem, places, given, flag(use_jac, "`use_jac`"), root_kwargs)
        solved = {own.symbols[k]: float(x[k]) for part in places for k in part}
        self._initial_conditions = conditions | {keys.get(s, s): v for s, v in solved.items()}
        self._dependent = solved

    def _shown(self, given: Mapping[str, Any]) -> Problem:
        """Return the Problem of a call, and show what is made before the motion begins.

        That bar goes where the solver's own begins.
        """
        if not isinstance(self.ode_solver, Solver):
            return self._now(given.get("events"))
        with progress_of(True, " parts", desc="preparation", leave=False) as told:
            told(0, part="equations")
            problem = self._now(given.get("events"))
            told(1)
            told(0, part="machine code")
            rates_function(problem.code, problem.plan)
            told(1)
        return problem

    @overload
    def integrate(
        self, *, full_output: Literal[True], **solver_kwargs: Any
    ) -> tuple[np.ndarray, dict[str, Any]]: ...

    @overload
    def integrate(self, **solver_kwargs: Any) -> np.ndarray: ...

    def integrate(self, **solver_kwargs: Any) -> Any:
        """Integrate the equations over `times` from the initial conditions.

        The function of the derivatives is generated first if necessary.

        Parameters
        ----------
        **solver_kwargs
            Options of the `ode_solver`, and these:

            ``constraints='project'``
                With a native solver: positions and velocities are projected onto the constraints
                after every step and at every output.
            ``constraints='baumgarte', gain=g``
                With any solver: constraint forces are added to the equations so that a residual c
                decays according to c'' + 2 g c' + g² c = 0.
            ``events``
                With a native solver: a list of `pydy.solvers.Event`. Symbols that occur only in
                them are constants; set their values with ``system.constants['e'] = 0.8``.

        Returns
        -------
        ndarray, shape (len(times), n)
            The states, including auxiliary states, or whatever a custom solver returns.

        Raises
        ------
        ValueError
            There are fewer than two times, or an option is not valid.
        SingularMatrixError
            The mass matrix became singular; the message contains time and state.
        IntegrationError
            The solver, odeint or a native one, could not continue, or the motion left the
            constraints or changed its energy without a cause; the error contains the results so
            far. With ``full_output=True``, what odeint returns where it gives up is returned
            unchanged.

        Warns
        -----
        PyDyUserWarning
            The initial conditions violate the constraints by more than rounding to six digits
            explains, and `constraints` is not set.
        """
        solver = self.ode_solver
        shown = solver_kwargs.get("progress") is True
        problem = self._shown(solver_kwargs) if shown else self._now(solver_kwargs.get("events"))
        full = solver_kwargs.get("full_output", False)
        if isinstance(solver, (Solver, SolveIvp)) or is_odeint(solver):
            full = full is True or (full is not False and flag(full, "`full_output`"))
        return integrate_states(
            problem, self._times, solver=solver, checked=not full, **solver_kwargs
        )

    def simulate(
        self,
        *,
        sensitivities: Any = None,
        control_sensitivities: Any = False,
        **solver_kwargs: Any,
    ) -> Trajectory:
        """Integrate like `integrate`, and return a Trajectory with named quantities.

        Parameters
        ----------
        sensitivities : symbol, name, group, or iterable of these, optional
            Parameters with respect to which the states are differentiated along the motion:
            constants; states, for their initial conditions; specifieds that are numbers or samples;
            ``'constants'``, ``'states'`` or ``'specifieds'`` for all of a kind. The derivatives are
            integrated together with the states, through events and constraints, and are the
            trajectory's `sensitivity`. Dependent initial conditions that
            `set_dependent_initial_conditions` solved for depend on the others through the
            constraints.
        control_sensitivities : bool, optional
            Whether the step-size control of a native solver includes the sensitivities, with
            tolerances as those of the states. By default their tolerances are 1000 times as large:
            steps are those of the states alone unless a derivative varies much more quickly.
        **solver_kwargs
            Options of the `ode_solver`. A solver may return ``(states, info)``; of the dictionary
            ``info``, ``'times'`` (where the solver stopped early), ``'events'`` and
            ``'dense_output'`` are used by the trajectory, and the rest is its `statistics`.
            `scipy.integrate.odeint` and the solvers of `pydy.solvers` are called with
            ``full_output=True``, the latter with ``dense_output=True`` unless you pass False.

        Returns
        -------
        Trajectory
            The states, the outputs and specifieds along the motion, and the values that were used;
            later changes of the System do not affect it. It ends at a terminal event.

        Raises
        ------
        ValueError, SingularMatrixError, IntegrationError
            As in `integrate`; IntegrationError is raised even with ``full_output=True``.

        Warns
        -----
        PyDyUserWarning
            As in `integrate`; or outputs are not finite; or a load jumps on the way, which
            `sensitivities` do not know.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> x0, v0 = system.states
        >>> system.initial_conditions = {x0: 1.0}
        >>> system.times = [0.0, 0.5, 1.0]
        >>> trajectory = system.simulate(rtol=1e-10, atol=1e-10)
        >>> trajectory[x0].round(6)
        array([1.      , 0.895595, 0.6597  ])
        """
        if isinstance(solver_kwargs.get("events"), Iterator):
            solver_kwargs["events"] = [*solver_kwargs["events"]]
        shown = solver_kwargs.get("progress") is True
        problem = self._shown(solver_kwargs) if shown else self._now(solver_kwargs.get("events"))
        wanted, control = None, False
        if control_sensitivities is not False:
            control = flag(control_sensitivities, "`control_sensitivities`")
        if sensitivities is not None:
            wanted = SensitivityRequest(sensitivities, control)
        trajectory = simulate(
            problem, self._times, solver=self.ode_solver, sensitivities=wanted, **solver_kwargs
        ).trajectory
        if not np.isfinite(trajectory.outputs).all():
            warn_of_outputs(trajectory, problem)
        if wanted is not None:
            warn_of_jumps(problem, lambda: trajectory, wanted.sensitive)
        return trajectory
