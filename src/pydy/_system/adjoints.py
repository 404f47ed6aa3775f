"""Gradients of a scalar of a simulation; the work is in `pydy.analysis.adjoint`."""

from __future__ import annotations

from typing import Any

from pydy._system.setup import Setup
from pydy.analysis.adjoint import AdjointGradient, adjoint_gradient, explicit_solver


class Gradients(Setup):
    """Gradients of a scalar of a motion with respect to many parameters."""

    def adjoint_gradient(
        self,
        wrt: Any,
        *,
        final: Any = None,
        integral: Any = None,
        contacts: Any = None,
        **solver_kwargs: Any,
    ) -> AdjointGradient:
        """Return a scalar of a simulation and its derivatives with respect to many parameters.

        The scalar is the value of an expression at the end of the motion, an integral along it, or
        the sum of both. The motion is integrated once, then the adjoint of its steps is applied
        from the last to the first: the cost hardly depends on the number of parameters. For few
        parameters, or many quantities, use `simulate` with `sensitivities`.

        Parameters
        ----------
        wrt : {'constants', 'states', 'specifieds'}, symbol, name, or iterable of these
            Constants; states, for their initial conditions; specifieds that are numbers or samples.
        final : output or expression, optional
            A function of states, specifieds, constants and time, evaluated at the last of the
            times, or after a terminal event, whose time also depends on the parameters.
        integral : output or expression, optional
            Integrated from the first time to the end, as an additional state under error control.
        contacts : pydy.contact.Contacts, optional
            Contacts of this System, through whose transitions and impacts the motion goes; terms
            may hold their outputs, and parameters be their constants.
        **solver_kwargs
            Options of an explicit native solver (``'dop853'`` if `ode_solver` is not native);
            `events`, `constraints` and `gain` as in `integrate`. ``progress=True`` shows a bar for
            the motion, and one for the way back.

        Returns
        -------
        AdjointGradient

        Raises
        ------
        ValueError
            The system has no such parameter, a specified is a Python function, or the solver is not
            explicit.
        SingularMatrixError, IntegrationError
            As in `integrate`; also if the motion only grazes an event that changes it.
        NotImplementedError
            With contacts: events with resets, and what `Contacts.simulate`
            has no sensitivities of; or an integral that jumps where a body stops in a plane.
        IntegrationInterrupted
            The user interrupted it; the error holds the motion so far, or all of it if it was
            interrupted on the way back.

        Warns
        -----
        PyDyUserWarning
            As in `integrate`; or a load, another rate or the integrand jumps along the motion: the
            derivatives do not include the jump.

        Examples
        --------
        How far a mass on a spring moves in a second:

        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.constants = {'c0': 0.0}
        >>> system.initial_conditions = {'x0': 1.0}
        >>> system.times = [0.0, 1.0]
        >>> found = system.adjoint_gradient('constants', final='x0', rtol=1e-10, atol=1e-10)
        >>> round(found.value, 8), round(found['k0'], 8), round(found['m0'], 8)
        (0.54030231, -0.42073549, 0.42073549)
        """
        if final is None and integral is None:
            raise ValueError(
                "`final` or `integral` must be given: an output or an expression of states, "
                "specifieds, constants and time."
            )
        solver = explicit_solver(self.ode_solver)
        if self._checked_contacts(contacts) is not None:
            found: AdjointGradient = contacts.gradient(wrt, final, integral, **solver_kwargs)
            return found
        return adjoint_gradient(
            self._now(solver_kwargs.get("events")),
            self._times,
            wrt,
            final=final,
            integral=integral,
            solver=solver,
            **solver_kwargs,
        )
