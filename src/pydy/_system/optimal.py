"""Optimal trajectories of a System."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from pydy._system.simulation import Simulation

if TYPE_CHECKING:
    from pydy.control.result import OptimalTrajectory


class Optimisation(Simulation):
    """Motions that minimise an objective."""

    def optimize_trajectory(
        self,
        objective: Any,
        duration: Any,
        *,
        start: Mapping[Any, Any] | None = None,
        end: Mapping[Any, Any] | None = None,
        boundary: Iterable[Any] = (),
        path: Iterable[Any] | None = None,
        bounds: Mapping[Any, Any] | None = None,
        free: Iterable[Any] = (),
        mesh: Any = 20,
        method: str = "radau",
        order: int = 3,
        hessian: str = "exact",
        guess: Any = None,
        mesh_tol: float | None = None,
        options: Mapping[str, Any] | None = None,
        progress: bool = False,
        solver: str = "ipopt",
    ) -> OptimalTrajectory:
        """Find the motion, and the specifieds without a value, that minimise an objective.

        This states a `pydy.control.OptimalControl` and solves it. To solve several times, with
        other guesses, keep that object.

        Parameters
        ----------
        objective : SymPy expression
            Integrals over the motion, ``sm.Integral(T**2, t)``, values at instants,
            ``q.subs(t, tf)``, constants, and the duration.
        duration : float or Symbol
            In s; the motion begins at t = 0. A Symbol is found, between its `bounds`.
        start, end, boundary, path, bounds, free, mesh, method, order, hessian
            As for `pydy.control.OptimalControl`.
        guess, mesh_tol, options, progress, solver
            As for `pydy.control.OptimalControl.solve`.

        Returns
        -------
        pydy.control.OptimalTrajectory

        Raises
        ------
        OptimizationError, AnalysisInterrupted, MissingDependencyError
            As `pydy.control.OptimalControl.solve` raises them.

        Examples
        --------
        A cart with a pendulum moves half a metre in two seconds, and is at rest again:

        >>> import sympy as sm
        >>> import sympy.physics.mechanics as me
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1)
        >>> F, = system.specifieds_symbols
        >>> t = me.dynamicsymbols._t
        >>> rest = {s: 0.0 for s in system.states}
        >>> found = system.optimize_trajectory(sm.Integral(F**2, t), 2.0, end={**rest, 'q0': 0.5})
        >>> found['q0'][-1].round(9), found.message
        (np.float64(0.5), 'solved')
        """
        from pydy.control.problem import OptimalControl

        problem = OptimalControl(
            self,
            objective,
            duration,
            start=start,
            end=end,
            boundary=boundary,
            path=path,
            bounds=bounds,
            free=free,
            mesh=mesh,
            method=method,
            order=order,
            hessian=hessian,
        )
        return problem.solve(
            guess, mesh_tol=mesh_tol, options=options, progress=progress, solver=solver
        )
