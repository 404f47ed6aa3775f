"""Values of a System and their exact derivatives at one state or several."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from pydy._checks import flag
from pydy._simulation.energy import Energy
from pydy._simulation.evaluation import BLOCKS, evaluate_block, evaluate_product, variables
from pydy._simulation.function import Function
from pydy._system.setup import Setup


class Evaluation(Setup):
    """Values and exact derivatives of the equations at one state or several."""

    def evaluate_ode(
        self, x: Any = None, t: Any = None, *, r: Any = None, p: Any = None
    ) -> np.ndarray:
        """Return the derivatives of the states.

        Parameters
        ----------
        x : array_like, shape (n,) or (m, n), or dict, optional
            States, in the order of `states`; the initial conditions by default. A dictionary gives
            some of them instead, by symbol or name.
        t : float or array_like, shape (m,), optional
            Time; by default the first of `times` (all of them for m states), or zero if `times` is
            empty.
        r : dict, array_like, shape (s,) or (m, s), or callable, optional
            Specifieds for this call instead of the System's.
        p : dict or array_like, shape (k,), optional
            Constants for this call instead of the System's.

        Returns
        -------
        ndarray, shape (n,) or (m, n)

        Raises
        ------
        ValueError
            A shape is not valid.
        SingularMatrixError
            The mass matrix is singular; a subclass of `numpy.linalg.LinAlgError`.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.evaluate_ode([1.0, 0.0])
        array([ 0., -1.])
        """
        return evaluate_block(self._now(), "rates", (x, t, r, p))

    def evaluate_outputs(
        self, x: Any = None, t: Any = None, *, r: Any = None, p: Any = None
    ) -> np.ndarray:
        """Return the outputs, in the order of `outputs_symbols`.

        The parameters are those of `evaluate_ode`.

        Returns
        -------
        ndarray, shape (o,) or (m, o)

        Examples
        --------
        >>> import sympy as sm
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> x0, v0 = system.states
        >>> system.outputs = {sm.Symbol('speed'): v0, sm.Symbol('twice'): 2*x0}
        >>> system.evaluate_outputs([1.0, 3.0])
        array([3., 2.])
        """
        return evaluate_block(self._now(), "outputs", (x, t, r, p))

    def evaluate_energy(
        self, x: Any = None, t: Any = None, *, r: Any = None, p: Any = None
    ) -> Energy:
        """Return the kinetic, the potential and the total energy.

        Parameters
        ----------
        x, t, r, p
            As in `evaluate_ode`.

        Returns
        -------
        kinetic, potential, total : float or ndarray, shape (m,)
            A named tuple.

        Raises
        ------
        ValueError
            The method has no bodies, or the potential energy cannot be determined; see
            `potential_energy`.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.evaluate_energy([1.0, 3.0])
        Energy(kinetic=4.5, potential=0.5, total=5.0)
        >>> system.evaluate_energy([[1.0, 3.0], [2.0, 0.0]]).total
        array([5., 2.])
        """
        problem = self._now(constants=p)
        names = partial(problem.definition.row_names, "energy")
        values = Function(problem, problem.model.energies.kernel, names)(t, x, r, p)
        return Energy(*(values.tolist() if values.ndim == 1 else values.T.copy()))

    def evaluate_constraints(
        self, x: Any = None, t: Any = None, *, r: Any = None, p: Any = None
    ) -> np.ndarray:
        """Return the residuals of the holonomic, then the nonholonomic constraints.

        The parameters are those of `evaluate_ode`.

        Returns
        -------
        ndarray, shape (o,) or (m, o)
            o is `num_constraints`.

        Raises
        ------
        ValueError
            The system has no constraints.

        Warns
        -----
        PyDyUserWarning
            All of them hold, but one that was left out as redundant does not.
        """
        self._need(self.num_constraints, "constraints")
        return evaluate_block(self._now(), "constraints", (x, t, r, p))

    def evaluate_holonomic_constraints(
        self, x: Any = None, t: Any = None, *, r: Any = None, p: Any = None
    ) -> np.ndarray:
        """Return the residuals of the holonomic constraints.

        The parameters are those of `evaluate_ode`.

        Returns
        -------
        ndarray, shape (o,) or (m, o)
            o is `num_holonomic_constraints`.

        Raises
        ------
        ValueError
            The system has no holonomic constraints.
        """
        self._need(self.num_holonomic_constraints, "holonomic constraints")
        return evaluate_block(self._now(), "holonomic", (x, t, r, p))

    def evaluate_velocity_constraints(
        self, x: Any = None, t: Any = None, *, r: Any = None, p: Any = None
    ) -> np.ndarray:
        """Return the residuals of all velocity constraints.

        The parameters are those of `evaluate_ode`.

        Returns
        -------
        ndarray, shape (o,) or (m, o)
            o is `num_velocity_constraints`.

        Raises
        ------
        ValueError
            The system has no velocity constraints.
        """
        self._need(self.num_velocity_constraints, "velocity constraints")
        return evaluate_block(self._now(), "velocity", (x, t, r, p))

    @staticmethod
    def _need(count: int, what: str) -> None:
        if not count:
            raise ValueError(f"The system has no {what} to evaluate.")

    def evaluate_jacobian(
        self,
        x: Any = None,
        t: Any = None,
        wrt: Any = "states",
        *,
        of: Any = "ode",
        r: Any = None,
        p: Any = None,
    ) -> np.ndarray:
        """Return exact partial derivatives, computed by differentiating the expression graph.

        If a specified is given as an expression, derivatives with respect to states and constants
        include it; those with respect to the specified are for an addition to its value. Specifieds
        given as functions, samples or numbers, or all specifieds if `r` is passed, are held
        constant.

        Parameters
        ----------
        x, t, r, p
            As in `evaluate_ode`.
        wrt : {'states', 'specifieds', 'constants'}, symbol or name, or a list, optional
            The variables, in the order of the arrays x, r and p; a list may contain states,
            specifieds, constants and groups of these.
        of : {'ode', 'outputs', 'holonomic', 'velocity'}, output, expression, or list, optional
            What is differentiated: the state derivatives, all outputs, residuals of constraints, or
            any outputs and expressions of states, specifieds and constants.

        Returns
        -------
        ndarray, shape (o, k) or (m, o, k)
            One column for each variable, even if there is only one.

        Raises
        ------
        ValueError
            An option is not one of the above, or the system has no variable of that name.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.evaluate_jacobian()
        array([[ 0.,  1.],
               [-1., -1.]])
        >>> system.evaluate_jacobian({'x0': 2.0}, wrt=['k0', 'v0'])
        array([[ 0.,  1.],
               [-2., -1.]])
        """
        if isinstance(of, str) and of in BLOCKS:
            by = variables(self._definition, wrt)
            return evaluate_block(self._now(), BLOCKS[of], (x, t, r, p), by)
        return evaluate_product(self._now(), "jacobian", of, wrt, None, (x, t, r, p))

    def evaluate_gradient(
        self,
        of: Any,
        x: Any = None,
        t: Any = None,
        wrt: Any = "states",
        *,
        r: Any = None,
        p: Any = None,
        value: bool = False,
    ) -> Any:
        """Return the exact gradient of one quantity, by reverse accumulation.

        It costs a small multiple of evaluating the quantity itself, regardless of the number of
        variables.

        Parameters
        ----------
        of : output or expression
            An output, by symbol or name, or an expression of states, specifieds and constants.
        x, t, wrt, r, p
            As in `evaluate_jacobian`.
        value : bool, optional
            Also return the quantity, which is computed anyway.

        Returns
        -------
        ndarray, shape (k,) or (m, k)
            With `value`, a tuple of the quantity, a float or of shape (m,), and its gradient.

        Raises
        ------
        ValueError
            The system has no such name or symbol.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> x0, v0 = system.states
        >>> system.evaluate_gradient(system.kinetic_energy + 3*x0**2, {'x0': 0.5, 'v0': 2.0})
        array([3., 2.])
        """
        out = evaluate_product(self._now(), "gradient", of, wrt, None, (x, t, r, p))
        if not flag(value, "`value`"):
            return out[..., 1:]
        return (float(out[0]) if out.ndim == 1 else out[:, 0]), out[..., 1:]

    def evaluate_jacobian_vector(
        self,
        v: Any,
        x: Any = None,
        t: Any = None,
        wrt: Any = "states",
        *,
        of: Any = "ode",
        r: Any = None,
        p: Any = None,
    ) -> np.ndarray:
        """Return exact directional derivatives: the Jacobian times vectors, without the Jacobian.

        Parameters
        ----------
        v : array_like, shape (k,) or (k, d)
            A direction with one component for each variable of `wrt`, or d of them as columns. For
            several states, (m, k) or (m, k, d) is also possible.
        x, t, wrt, of, r, p
            As in `evaluate_jacobian`.

        Returns
        -------
        ndarray, shape (o,), (o, d), (m, o) or (m, o, d)

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> multi_mass_spring_damper().evaluate_jacobian_vector([1.0, 2.0])
        array([ 2., -3.])
        """
        return evaluate_product(self._now(), "jacobian-vector", of, wrt, v, (x, t, r, p))

    def evaluate_vector_jacobian(
        self,
        v: Any,
        x: Any = None,
        t: Any = None,
        wrt: Any = "states",
        *,
        of: Any = "ode",
        r: Any = None,
        p: Any = None,
    ) -> np.ndarray:
        """Return vectors times the exact Jacobian, by reverse accumulation.

        Parameters
        ----------
        v : array_like, shape (o,) or (o, d)
            A weight for each row of `of`, or d sets of weights as columns. For several states, (m,
            o) or (m, o, d) is also possible.
        x, t, wrt, of, r, p
            As in `evaluate_jacobian`.

        Returns
        -------
        ndarray, shape (k,), (k, d), (m, k) or (m, k, d)

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> multi_mass_spring_damper().evaluate_vector_jacobian([0.0, 1.0], wrt=['v0', 'x0'])
        array([-1., -1.])
        """
        return evaluate_product(self._now(), "vector-jacobian", of, wrt, v, (x, t, r, p))

    def evaluate_hessian_vector(
        self,
        v: Any,
        of: Any,
        x: Any = None,
        t: Any = None,
        wrt: Any = "states",
        *,
        r: Any = None,
        p: Any = None,
    ) -> np.ndarray:
        """Return exact second derivatives of one quantity times vectors.

        These are directional derivatives of its gradient. The identity as `v` gives the Hessian.

        Parameters
        ----------
        v : array_like, shape (k,) or (k, d)
            As in `evaluate_jacobian_vector`.
        of : output or expression
            As in `evaluate_gradient`.
        x, t, wrt, r, p
            As in `evaluate_jacobian`.

        Returns
        -------
        ndarray, shape (k,), (k, d), (m, k) or (m, k, d)

        Examples
        --------
        >>> import numpy as np
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> x0, v0 = system.states
        >>> system.evaluate_hessian_vector(np.eye(2), x0**2*v0, [1.0, 5.0])
        array([[10.,  2.],
               [ 2.,  0.]])
        """
        return evaluate_product(self._now(), "hessian-vector", of, wrt, v, (x, t, r, p))
