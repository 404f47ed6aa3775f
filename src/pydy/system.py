"""System: a multibody model with its numerical values, ready to evaluate and simulate.

System is a sum of themes. Each stands with its documented methods and their work in one file of
`pydy._system`; `Setup` there holds the state.
"""

from __future__ import annotations

from inspect import isfunction, unwrap
from typing import TYPE_CHECKING, Any

from pydy._names import nearest
from pydy._system.adjoints import Gradients
from pydy._system.ensembles import Ensembles
from pydy._system.equilibria import Equilibria
from pydy._system.exporting import Exporting
from pydy._system.fits import Fitting
from pydy._system.forces import Forces
from pydy._system.inertial import InertialParameters
from pydy._system.layers import Layers
from pydy._system.linear_models import LinearModels
from pydy._system.optimal import Optimisation
from pydy._system.orbits import Orbits
from pydy._system.pictures import Pictures
from pydy._system.reading import Reading
from pydy._system.simulation import Simulation
from pydy._system.sweeps import Sweeps
from pydy._system.values import Evaluation

__all__ = ["System"]


# Names in other versions of PyDy, and what has their place.
_OF_OTHER_VERSIONS = {
    "evaluate_holonomic": "`evaluate_holonomic_constraints`",
    "evaluate_nonholonomic": "`evaluate_constraints`, whose last `num_nonholonomic_constraints` "
    "entries are the nonholonomic ones; `evaluate_velocity_constraints` has these after the "
    "differentiated holonomic ones",
}


class System(
    Layers,
    Sweeps,
    LinearModels,
    Equilibria,
    Gradients,
    Ensembles,
    Pictures,
    Orbits,
    Fitting,
    Optimisation,
    Simulation,
    Evaluation,
    InertialParameters,
    Reading,
    Exporting,
    Forces,
):
    """A multibody system: its equations of motion and numerical values for them.

    The arguments from `constants` to `noncontributing_forces` are also attributes, which can be
    changed at any time.

    Parameters
    ----------
    eom_method : KanesMethod, LagrangesMethod or System of sympy.physics.mechanics, or Definition
        A KanesMethod after ``kanes_equations()``, or with bodies and loads, from which the
        equations of motion are then formed, in a fraction of the time. The equations for a
        LagrangesMethod are formed from its Lagrangian and constraints; its speeds are the
        derivatives of the coordinates. A System of SymPy, before or after ``form_eoms()``, is read
        with its joints; `pydy.mechanics.Definition` has the same content without a method object.
        It is read once: ``kanes_equations()`` with other loads, called later, needs a new System.
    constants : dict, optional
        Maps constants (SymPy symbols) to numbers; those without a value are 1.0.
    specifieds : dict, optional
        Maps specified functions of time, or tuples of them, to numbers, arrays, functions
        ``g(x, t)``, SymPy expressions or `pydy.inputs.SampledInput`; those without a value are
        0.0. See `specifieds` for the second format.
    ode_solver : callable, optional
        A solver with the signature of `scipy.integrate.odeint`, which is the default.
    initial_conditions : dict, optional
        Maps states to numbers; those without a value are 0.0.
    times : array_like, shape (n,), optional
        Times at which the states are computed: ascending or descending. The initial conditions are
        those at the first one; descending times integrate backward.
    outputs : dict, optional
        Maps names to expressions that are evaluated together with the equations. See `outputs`.
    noncontributing_forces : iterable of functions of time, optional
        Names, in the KanesMethod's loads, of the forces that its auxiliary speeds bring into
        evidence; they are then computed as outputs.
    constants_symbols : iterable of Symbol, optional
        Skips the search for constants in the equations.
    specifieds_symbols : iterable of functions of time, optional
        Skips the search for specifieds in the equations.
    equations : {'graph', 'method'}, optional
        Which equations of motion are used: ``'graph'`` forms them from the bodies and loads, or
        from the Lagrangian; ``'method'`` uses those derived by ``kanes_equations()`` or
        ``form_lagranges_equations()``. By default they are formed; if a KanesMethod has derived its
        own, these are used unless the formed ones have the same values.
    implicit : pydy.mechanics.Implicit, optional
        Functions of time that residuals give, solved numerically inside the equations: the nearest
        point of a curved surface, say. They become coordinates.

    Raises
    ------
    TypeError
        `eom_method` is not one of these types.
    ValueError
        A value or a symbol is not valid; the message names the argument.

    Examples
    --------
    >>> import numpy as np
    >>> from sympy.physics.mechanics.models import n_link_pendulum_on_cart
    >>> from pydy.system import System
    >>> kane = n_link_pendulum_on_cart(1)
    >>> system = System(kane, initial_conditions={kane.q[1]: 0.5}, times=np.linspace(0.0, 5.0, 3))
    >>> system.integrate().shape
    (3, 4)
    """

    if not TYPE_CHECKING:  # or type checkers would let any attribute pass

        def __setattr__(self, name: str, value: Any) -> None:
            # A misspelt attribute would be set, and never read.
            if name[0] != "_" and type(self) is System and not hasattr(System, name):
                settable = [n for n in dir(System) if getattr(getattr(System, n), "fset", None)]
                raise AttributeError(
                    f"System has no attribute `{name}`, so it cannot be set. "
                    f"{nearest(name, settable)}",
                    name=name,
                    obj=self,
                )
            object.__setattr__(self, name, value)

        def __getattr__(self, name: str) -> Any:
            # Called for what there is not: names of other versions get the one that is meant.
            if (meant := _OF_OTHER_VERSIONS.get(name)) is not None:
                raise AttributeError(f"System has no `{name}`. Use {meant}.", name=name)
            if name[0] != "_" and not hasattr(type(self), name):
                public = [n for n in dir(type(self)) if n[0] != "_"]
                if hint := nearest(name, public, or_all=False):
                    raise AttributeError(f"System has no attribute `{name}`. {hint}", name=name)
            return object.__getattribute__(self, name)  # its error says the rest


# Errors, `help` and pickles name what users write, `System.fit`, not the theme that holds it.
for _theme in System.__mro__[1:-1]:
    for _name, _member in vars(_theme).items():
        if isfunction(_member):
            _member.__module__, _member.__qualname__ = __name__, f"System.{_name}"
            unwrap(_member).__qualname__ = _member.__qualname__  # the one that Python's errors name
