"""System: a multibody model with its numerical values, ready to evaluate and simulate.

Each public method has its documentation here and its work elsewhere: an analysis is a function of a
Problem, a model with its numbers at one state, which `_now` returns.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, MutableMapping, Sequence
from copy import copy
from dataclasses import replace
from functools import partial
from operator import attrgetter
from typing import TYPE_CHECKING, Any, Literal, Self, TypeAlias, TypeVar, overload

import numpy as np
import sympy as sm

from pydy._assembly import CompiledModel, Definition, check_expressions
from pydy._checks import (
    SymbolDict,
    check_mapping,
    choice,
    flag,
    instance,
    listed,
    merged,
    shown,
    suggest_arguments,
    text,
)
from pydy._errors import warn_user
from pydy._evaluation import (
    BLOCKS,
    BaseParameters,
    Evaluator,
    Quantity,
    all_accelerations,
    base_parameters,
    checked_options,
    evaluate,
    evaluate_block,
    evaluate_product,
    exported_model,
    frame_jacobian,
    frame_position,
    frame_rotation,
    generated_function,
    gravity,
    inertial_parameters,
    inverse_dynamics,
    live_system,
    mass_matrix,
    regressor,
    required_forces,
    shortened,
    summary,
    variables,
)
from pydy._files import file_of
from pydy._html import html_table
from pydy._integration import integrate_states, simulate
from pydy._judges import warn_of_jumps, warn_of_missing_derivatives, warn_of_outputs
from pydy._mechanics import (
    EquationsOfMotion,
    Implicit,
    Multipliers,
    Reaction,
    Reactions,
    equations_to_read,
    extract,
    method_of,
)
from pydy._motion import (
    SolveIvp,
    is_odeint,
    native_solver,
    odeint,
    public_odeint,
    resolve_ode_solver,
)
from pydy._names import name_of, nearest, some
from pydy._option_checks import refuse_solver
from pydy._optional import progress_of
from pydy._problem import (
    Energy,
    EnergyModel,
    ModelBuilder,
    Problem,
    Settings,
    SymbolSet,
    check_forces,
    check_potential,
    check_times,
    checked_plan,
    evaluate_specifieds,
    problem_of,
    read_numbers,
)
from pydy._states import check_dependents, default_dependents, given_values, solve_dependents
from pydy.codegen import rates_function
from pydy.solvers import Event, Solver
from pydy.trajectory import Trajectory

if TYPE_CHECKING:
    from os import PathLike
    from typing import Unpack

    from numpy.typing import ArrayLike
    from sympy.physics.mechanics import Point, ReferenceFrame, Vector
    from sympy.physics.mechanics.joint import Joint
    from xarray import Dataset

    from pydy._mechanics import EomMethod
    from pydy._motion import EnsembleOptions
    from pydy._sympy_types import (
        AnySymbol,
        Body,
        ExpressionOrName,
        Load,
        Location,
        SymbolOrName,
        TimeFunction,
    )
    from pydy.analysis import (
        AdjointGradient,
        EigenvalueSweep,
        Equilibrium,
        EquilibriumBranch,
        FitResult,
        LinearModel,
        PeriodicOrbit,
        Trial,
    )
    from pydy.control import OptimalTrajectory
    from pydy.export import Exported
    from pydy.inputs import SampledInput
    from pydy.layers import Layer, LayerFunctions
    from pydy.viz import LiveSystem, Scene, Visual

    Value = TypeVar("Value")
    # By symbols or names; these are Any, as a mapping of the union would refuse a `dict[str, …]`.
    BySymbol: TypeAlias = Mapping[Any, Value]
    # Numbers of states, inputs and constants in one call: the arguments x, q, v and a; r; p.
    StateValues: TypeAlias = ArrayLike | BySymbol[float]
    InputValues: TypeAlias = ArrayLike | BySymbol[object] | Callable[..., ArrayLike]
    ConstantValues: TypeAlias = ArrayLike | BySymbol[float]
    # A value of `specifieds`: also the symbols, in its second format.
    Specified: TypeAlias = (
        ArrayLike | sm.Expr | SampledInput | Callable[..., ArrayLike] | tuple[AnySymbol, ...]
    )
    Output: TypeAlias = sm.Expr | float | tuple[sm.Expr | float, ...]
    Variables: TypeAlias = SymbolOrName | Iterable[SymbolOrName]
    Bounds: TypeAlias = tuple[float | None, float | None]
    # Of optimal control, where it may vary over the motion.
    SignalBound: TypeAlias = ArrayLike | SampledInput | None
    OdeSolver: TypeAlias = Callable[..., Any]
    Reduction: TypeAlias = str | tuple[str, SymbolOrName | int] | Callable[[Dataset], Dataset]
    Contacts: TypeAlias = Any  # `pydy.contact.Contacts`, whose module imports this one

__all__ = ["System"]
__dir__ = __all__.copy


# Names in other versions of PyDy, and what has their place.
_OF_OTHER_VERSIONS = {
    "evaluate_holonomic": "`evaluate_holonomic_constraints`",
    "evaluate_nonholonomic": "`evaluate_constraints`, whose last `num_nonholonomic_constraints` "
    "entries are the nonholonomic ones; `evaluate_velocity_constraints` has these after the "
    "differentiated holonomic ones",
    "lqr": "`system.linearize().to_control()` with python-control, as in `control.lqr`",
    "bode": "`system.linearize().plot_bode(input, output)`",
    "natural_frequencies": "`abs(system.linearize().eigenvalues)`, in rad/s",
    "eigenvectors": "`numpy.linalg.eig(system.linearize().A)`",
    "energy": "`evaluate_energy()`, `kinetic_energy` or `potential_energy`; along a motion "
    "`system.simulate().energy`",
}
_NAMES_OF_METHODS = dict.fromkeys(
    (
        "frame", "fixed_point", "bodies", "loads", "forcelist", "joints", "actuators", "kd_eqs",
        "kdes", "kinematic_equations", "coordinates", "speeds", "q_ind", "u_ind", "q_dependent",
        "u_dependent", "u_auxiliary", "auxiliary_speeds", "configuration_constraints",
        "velocity_constraints", "holonomic_constraints", "nonholonomic_constraints",
    ),
    "it belongs to the method, pass a KanesMethod, a System of sympy.physics.mechanics or a "
    "pydy.mechanics.Definition that has it as `eom_method`",
)  # fmt: skip


class System:
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

    @suggest_arguments("System", _NAMES_OF_METHODS)
    def __init__(
        self,
        eom_method: EomMethod,
        constants: BySymbol[float] | None = None,
        specifieds: BySymbol[Specified] | None = None,
        ode_solver: OdeSolver | str | None = None,
        initial_conditions: BySymbol[float] | None = None,
        times: ArrayLike | None = None,
        outputs: BySymbol[Output] | None = None,
        noncontributing_forces: Iterable[TimeFunction] | None = None,
        constants_symbols: Iterable[sm.Symbol] | None = None,
        specifieds_symbols: Iterable[TimeFunction] | None = None,
        equations: Literal["graph", "method"] | None = None,
        implicit: Implicit | None = None,
    ) -> None:
        if equations is not None:
            choice(equations, ("graph", "method"), "`equations`")
        if implicit is not None:
            instance(implicit, Implicit, "`implicit`", "a pydy.mechanics.Implicit")
        self._equations = extract(eom_method, equations, implicit)
        self._eom_method = eom_method
        self._models = ModelBuilder(
            self._equations, eom_method, constants_symbols, specifieds_symbols
        )
        self._arguments: dict[str, object] = {}  # how the generated function reads r and p
        self._constants: dict[SymbolOrName, float] = {}
        self._implied: dict[sm.Symbol, float] = {}  # constants that are not the user's: of contacts
        self._has_contacts = False  # whether Contacts were made of it
        self._specifieds: dict[SymbolOrName | tuple[SymbolOrName, ...], Specified] = {}
        self._initial_conditions: dict[SymbolOrName, float] = {}
        # Initial conditions that were solved for last.
        self._dependent: dict[TimeFunction, float] | None = None
        self._told: set[AnySymbol] = set()  # derivatives of specifieds that were warned of
        # Symbols of which the user knows that values contradict their assumptions; None where
        # that is not judged, as in a fit, which only tries numbers.
        self._contradicted: set[str] | None = set()
        self._outputs: dict[SymbolOrName | tuple[SymbolOrName, ...], Output] = {}
        self._forces: list[TimeFunction] = []
        self._set_outputs(outputs, noncontributing_forces)
        self.specifieds = specifieds  # first: an expression may bring constants of its own
        self.constants = constants
        self.ode_solver = ode_solver
        self.initial_conditions = initial_conditions
        self.times = times

    def __copy__(self) -> Self:
        twin = object.__new__(type(self))
        kinds = (dict, list, set, np.ndarray, ModelBuilder)  # what may change in place
        vars(twin).update(
            (k, copy(v) if isinstance(v, kinds) else v) for k, v in vars(self).items()
        )
        return twin

    def __repr__(self) -> str:
        lines = self._facts()
        width = max(len(title) for title, _ in lines)
        return "\n".join(["System", *(f"  {title:<{width}}  {text}" for title, text in lines)])

    def _repr_html_(self) -> str:
        return html_table("System", self._facts())

    def _facts(self) -> list[tuple[str, str]]:
        """Return the lines of a summary: titles and texts."""
        # The last definition that was sound: to print a System never fails.
        values: dict[str, BySymbol[object]] = {
            "initial_conditions": self._initial_conditions,
            "constants": {**self._implied, **self._constants},
            "specifieds": self._specifieds,
        }
        method, of_events = type(self._eom_method).__name__, self._models.of_events
        definition = self._models.latest
        return summary(definition, method, self._solver, self._times, values, of_events)

    @property
    def _definition(self) -> Definition:
        # The user may have edited the dictionaries of outputs, specifieds and constants in place.
        return self._defined(self._constants)

    def _defined(self, constants: BySymbol[object]) -> Definition:
        """Return the definition with these constants, which the equations need not hold."""
        return self._models.definition(self._outputs, self._forces, self._specifieds, constants)

    def _now(
        self,
        events: Event | Iterable[Event] | None = None,
        constants: ConstantValues | BySymbol[ArrayLike] | None = None,
        contacts: Contacts | None = None,
        further: Iterable[AnySymbol] = (),
    ) -> Problem:
        """Return everything as it is now, with the symbols that one call brings.

        Those of events are constants, and so are `further` symbols.
        """
        settings = Settings(
            {**self._implied, **self._constants},
            dict(self._specifieds),
            dict(self._initial_conditions),
            self._times,
            dict(self._outputs),
            self._forces,
            self._contradicted,
            self._told,
            None if self._dependent is None else tuple(self._dependent),
        )
        named = constants if isinstance(constants, Mapping) else None
        return problem_of(
            self._models, settings, events=events, constants=named, further=further, hybrid=contacts
        )

    def _told_again(self, definition: Definition, what: str) -> set[str] | None:
        """Forget that values of a kind contradict assumptions; return what remains told."""
        if self._contradicted and (assumed := definition.assumptions.get(what)) is not None:
            self._contradicted -= {assumed.names[k] for k in assumed.columns}
        return self._contradicted

    def _checked_contacts(self, contacts: Contacts | None) -> Contacts | None:
        """Return an argument `contacts`, None or Contacts of this System."""
        if contacts is not None and getattr(contacts, "system", None) is not self:
            raise TypeError(f"`contacts` must be Contacts of this System, got {shown(contacts)}.")
        return contacts

    def _set_outputs(
        self, outputs: BySymbol[Output] | None, forces: Iterable[TimeFunction] | None
    ) -> None:
        names = check_forces(self._equations, forces)
        own = self._models.define.users(outputs, self._forces)
        self._models.definition(own, names, self._specifieds, {})
        self._outputs, self._forces = self._models.define.merged(own, names), names

    @property
    def model(self) -> CompiledModel:
        """The compiled definition, for inspection: layout of arrays, output blocks, machine code.

        ``print(system.model)`` shows what has been compiled so far; ``system.model.assembly``
        contains the equations as a graph. A model never changes: after a change of the System's
        definition, this attribute is another model.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> sum(system.model.compiled('rates').program.operation_count['run'].values())
        5
        """
        return self._models.model(self._definition).code

    @property
    def eom_method(self) -> Any:
        """The method object that the equations come from. Read-only."""
        return method_of(self._eom_method)

    @property
    def coordinates(self) -> list[TimeFunction]:
        """List of the generalized coordinates, functions of time."""
        return list(self._equations.coordinates)

    @property
    def speeds(self) -> list[TimeFunction]:
        """List of the generalized speeds, functions of time."""
        return list(self._equations.speeds)

    @property
    def auxiliaries(self) -> list[AnySymbol]:
        """List of the auxiliary states: time integrals of outputs that depend on u' linearly."""
        return list(self._definition.auxiliaries)

    @property
    def states(self) -> list[AnySymbol]:
        """List of the states in the order of all arrays: coordinates, speeds, auxiliaries.

        Coordinates and speeds have the order in which they were given to a `Definition` or a
        LagrangesMethod, whatever is dependent; those of a KanesMethod or a System of SymPy have the
        order of its attributes ``q`` and ``u``. Quantities of an `Implicit` follow the coordinates.
        """
        return list(self._definition.states)

    @property
    def constants_symbols(self) -> SymbolSet:
        """Set of the constants: symbols of the equations and outputs that are not functions.

        Symbols that cancel from the equations but occur in energies or positions, and those of the
        events of earlier calls, are constants too as soon as `constants` gives them a value.
        ``print(system)`` lists them, and values that no call has used yet, under ``elsewhere``.
        """
        return SymbolSet(self._definition.constants)

    @property
    def specifieds_symbols(self) -> SymbolSet:
        """Set of the specifieds: functions of time that the equations do not determine."""
        return SymbolSet(self._definition.specifieds)

    @property
    def constraints(self) -> sm.Matrix:
        """Column matrix of the holonomic, then the nonholonomic constraint expressions."""
        rows = [*self._equations.constraints.holonomic, *self._equations.constraints.nonholonomic]
        return sm.Matrix(rows) if rows else sm.Matrix()

    @property
    def kinetic_energy(self) -> sm.Expr:
        """The kinetic energy of the method's bodies, as an expression in states and symbols.

        The expression is not simplified. Auxiliary speeds are set to zero.

        Raises
        ------
        ValueError
            The method knows no bodies.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> multi_mass_spring_damper().kinetic_energy
        m0*v0(t)**2/2
        """
        return self._models.energies.kinetic

    @property
    def potential_energy(self) -> sm.Expr:
        """The potential energy, as an expression in coordinates, constants, specifieds and time.

        It is derived from the loads: forces that are constant in the inertial frame, such as
        gravity; equal and opposite forces along the line between two points that depend on their
        distance alone; forces of floors, by the height of a point above them; and loads whose work
        is a closed form that SymPy integrates along the coordinates, such as those of springs,
        -K sin 2q, or a Piecewise contact. Parts of loads
        that depend on speeds, time or specifieds (dampers, motors) have no potential energy: their
        work changes the total energy. If a load depends on the configuration in another way, the
        bodies' own `potential_energy` is used if the power of the loads agrees with it.

        Set it when it cannot be found, for all loads together; None means to find it again.

        Raises
        ------
        ValueError
            A load depends on the configuration in a way that is not recognised; the message names
            it. Or an expression with other symbols is set.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper(apply_gravity=True)
        >>> system.potential_energy
        -g*m0*x0(t) + k0*x0(t)**2/2
        """
        return self._models.energies.potential

    @potential_energy.setter
    def potential_energy(self, energy: sm.Expr | float | None) -> None:
        definition = self._definition
        others = [self._equations.time, *definition.constants, *definition.specifieds]
        others += EnergyModel(self._equations).symbols
        self._models.set_potential(check_potential(energy, self._equations.coordinates, others))

    @property
    def outputs_symbols(self) -> list[AnySymbol]:
        """List of the names of all outputs, in the order of `evaluate_outputs`.

        An output may be called like a state, constant or specified. Where names are labels, in
        trajectories, tables, plots and files, it is then called ``q_output``.
        """
        outputs = self._definition.outputs
        return list(outputs.as_named_by_user(outputs.symbols))

    num_coordinates = property(lambda self: len(self.coordinates), doc="Number of coordinates.")
    num_speeds = property(lambda self: len(self.speeds), doc="Number of speeds.")
    num_auxiliaries = property(
        lambda self: len(self.auxiliaries), doc="Number of auxiliary states."
    )
    num_states = property(lambda self: len(self.states), doc="Number of states.")
    num_constants = property(lambda self: len(self.constants_symbols), doc="Number of constants.")
    num_specifieds = property(
        lambda self: len(self.specifieds_symbols), doc="Number of specifieds."
    )
    num_outputs = property(lambda self: len(self.outputs_symbols), doc="Number of outputs.")
    num_holonomic_constraints = property(
        lambda self: len(self._equations.constraints.holonomic),
        doc="Number of configuration constraints.",
    )
    num_velocity_constraints = property(
        lambda self: len(self._equations.constraints.velocity),
        doc="Number of velocity constraints, including differentiated holonomic ones.",
    )
    num_nonholonomic_constraints = property(
        lambda self: len(self._equations.constraints.nonholonomic),
        doc="Number of motion constraints beyond the differentiated configuration constraints: a "
        "difference of ranks, whatever axes the constraints are written in.",
    )
    num_constraints = property(
        lambda self: self.num_holonomic_constraints + self.num_nonholonomic_constraints,
        doc="Number of holonomic and nonholonomic constraints together.",
    )

    @property
    def constants(self) -> MutableMapping[SymbolOrName, float]:
        """Dictionary of the constants' values that the user has set; all others are 1.0.

        A symbol and its name are one key: ``system.constants['m'] = 2.0`` replaces the value
        that was set by the symbol.
        """
        return SymbolDict(self._constants)

    @constants.setter
    def constants(self, constants: BySymbol[float] | None) -> None:
        values = check_mapping("constants", constants)
        definition = self._defined(values)
        told = self._told_again(definition, "constants")
        read_numbers(definition, "constants", values, told)
        if self._constants and values:
            self._warn_of_dropped("constants", self._constants, values, 1.0)
        self.__dict__["_constants"] = values  # by itself, as a short call

    @property
    def specifieds(self) -> MutableMapping[Any, Any]:
        """Dictionary of the specifieds' values; all others are 0.0.

        In the first format keys are specifieds or tuples of them, values are numbers, arrays,
        functions ``g(x, t)`` of the state and time that return numbers or arrays, SymPy expressions
        of states, time, constants and other specifieds, or `pydy.inputs.SampledInput`::

            system.specifieds = {(a, b): np.ones(2), c: lambda x, t: -3.0*x[0], d: -k*q + sin(t)}

        A single number for a tuple applies to each of its specifieds. Expressions are compiled into
        the code. Symbols that occur only in them become constants of the system, and functions of
        time become specifieds. If the equations contain derivatives of a function of time, they are
        computed from its expression; with any other kind of value, they need values of their own.

        In the second format, which is faster for functions, all are given together::

            system.specifieds = {'symbols': (a, b, c), 'values': lambda x, t: np.ones(3)}

        The order of ``'symbols'`` is the order of r in the generated function.
        """
        return SymbolDict(self._specifieds)

    @specifieds.setter
    def specifieds(self, specifieds: BySymbol[Specified] | None) -> None:
        values = check_mapping("specifieds", specifieds)
        definition = self._models.definition(self._outputs, self._forces, values, {})
        told: set[AnySymbol] = set()
        contradicted = self._told_again(definition, "specifieds")
        plan = checked_plan(definition, values, told, contradicted)
        if plan.expressions:
            check_expressions(definition, plan)
        self._specifieds, self._told = values, told

    @property
    def initial_conditions(self) -> MutableMapping[SymbolOrName, float]:
        """Dictionary of the states' values at the first time; all others are 0.0.

        A symbol and its name are one key: ``system.initial_conditions['q1'] = 2.0`` replaces the
        value that was set by the symbol.
        """
        return SymbolDict(self._initial_conditions)

    @initial_conditions.setter
    def initial_conditions(self, initial_conditions: BySymbol[float] | None) -> None:
        remedy = "Use `dict(zip(system.states, values))`."
        values = check_mapping("initial_conditions", initial_conditions, remedy)
        definition = self._definition
        told = self._told_again(definition, "states")
        read_numbers(definition, "initial_conditions", values, told)
        self._initial_conditions = values

    def _warn_of_dropped(
        self, argument: str, before: BySymbol[float], values: BySymbol[float], default: float
    ) -> None:
        """Warn of values that an assignment sets back to the default; an empty one says so."""
        if self._contradicted is None or before is values:
            return
        known = SymbolDict({**values})
        dropped = {
            key: value
            for key, value in merged(before).items()
            if key not in values
            and not (isinstance(value, (int, float)) and value == default)
            and key not in known
        }
        if dropped:
            lost = some([f"{name_of(key)} = {shortened(value)}" for key, value in dropped.items()])
            warn_user(
                f"`{argument}` was assigned without {lost}: an assignment replaces all values, and "
                f"what is not in it is {default} again. To change some and leave the others, write "
                f"`system.{argument}[...] = ...` or `system.{argument}.update(...)`; to drop all, "
                "assign {} first."
            )

    @property
    def times(self) -> np.ndarray:
        """Array of the times at which the states are computed, shape (n,)."""
        return self._times

    @times.setter
    def times(self, times: ArrayLike | None) -> None:
        self._times = check_times(times)

    @property
    def outputs(self) -> MutableMapping[Any, Any]:
        """Dictionary of the expressions that are evaluated together with the equations.

        Keys are names (symbols or functions of time) or tuples of names; values are the same number
        of expressions. Three forms are possible::

            outputs[p] = k*x                                    a function of the states
            outputs[(f1, f2)] = (k*x, c*v)                      several
            outputs[(m1, m2)] = (m1 - 4*m2 + k*v.diff(t) + 2,   linear equations, zero when
                                 m1 + 3*m2 - w.diff(t))         satisfied

        Expressions may contain the derivatives of the speeds. For equations that contain their own
        names and such derivatives, the time integral of each name becomes an auxiliary state. The
        user's outputs are followed by the residuals of the constraints, and by the noncontributing
        forces if there are any.
        """
        return SymbolDict(self._outputs)

    @outputs.setter
    def outputs(self, outputs: BySymbol[Output] | None) -> None:
        self._set_outputs(outputs, self._forces)

    @property
    def noncontributing_forces(self) -> list[TimeFunction]:
        """List of the names of the noncontributing forces that are computed as outputs."""
        return list(self._forces)

    @noncontributing_forces.setter
    def noncontributing_forces(self, forces: Iterable[TimeFunction] | None) -> None:
        self._set_outputs(self._outputs, forces)

    @property
    def ode_solver(self) -> OdeSolver:
        """Solver: a function with the signature of `scipy.integrate.odeint`.

        It may be set to ``'odeint'`` or ``'lsoda'``, the default; to the name of a native solver,
        such as ``'dop853'`` for `pydy.solvers.dop853`; or to `scipy.integrate.solve_ivp` or the
        name of one of its methods: ``'RK45'``, ``'RK23'``, ``'DOP853'``, ``'Radau'``, ``'BDF'``,
        ``'LSODA'``. Names are case-sensitive: ``'DOP853'`` is SciPy's, ``'dop853'`` the native one.
        Tolerances that you do not pass are the solver's defaults; those of ``solve_ivp`` are
        coarse.

        It is called as ``x_history = ode_solver(f, x0, t, args=(r, p), **options)``, where
        ``f(x, t, r, p)`` returns the derivatives in a new array.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.initial_conditions[system.coordinates[0]] = 1.0
        >>> system.times = [1.0, 2.0, 3.0]
        >>> system.ode_solver = 'RK45'
        >>> system.integrate(rtol=1e-10, atol=1e-10)[:, 0]
        array([1.        , 0.65970..., 0.1505...])
        """
        return public_odeint() if self._ode_solver is None else self._ode_solver

    @ode_solver.setter
    def ode_solver(self, ode_solver: OdeSolver | str | None) -> None:
        self._ode_solver: OdeSolver | None = resolve_ode_solver(ode_solver)

    @property
    def _solver(self) -> OdeSolver:
        """The solver; `odeint` without loading its package."""
        return odeint if self._ode_solver is None else self._ode_solver

    @property
    def evaluate_ode_function(self) -> Any:
        """Function that computes the derivatives; None before it is generated.

        ``help(system.evaluate_ode_function)`` shows the order of the entries of its arguments.
        """
        if not self._models.has_compiled:
            return None
        any_layout = self._ode_solver is not None
        return generated_function(self.model, self._arguments, any_layout=any_layout)

    def generate_ode_function(self, **kwargs: Any) -> Callable[..., np.ndarray]:
        """Generate the function that evaluates the derivatives, and keep it.

        Parameters
        ----------
        **kwargs
            Options of `pydy.codegen.ode_function_generators.generate_ode_function`:
            `linear_sys_solver`, `constants_arg_type`, `specifieds_arg_type`, `time_first`,
            `generator` and the generator's own options. They are also used when code is generated
            again later.

        Returns
        -------
        function
            ``rhs(x, t, r, p)``, also available as `evaluate_ode_function`. Its first call warns of
            a quaternion that is not of unit length; later states may be those inside of a step.

        Raises
        ------
        TypeError
            An option that the System sets itself.
        NotImplementedError
            The generator is unknown.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> rhs = system.generate_ode_function(generator='lambdify')
        >>> rhs([1.0, 0.0], 0.0, [0.1, 2.0, 1.0])
        array([ 0., -2.])
        """
        arguments, options = checked_options(kwargs)
        definition = self._definition
        models = self._models.with_options(options)
        code = models.model(definition).code
        if self._equations.constraints.undifferentiated_holonomic:
            warn_of_missing_derivatives(self._now())
        function: Callable[..., np.ndarray] = generated_function(
            code, arguments, any_layout=self._ode_solver is not None
        )
        self._arguments, self._models = arguments, models
        return function

    if not TYPE_CHECKING:  # or type checkers would let any attribute pass

        def __setattr__(self, name: str, value: object) -> None:
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

    # -- Simulation --------------------------------------------------------------------------------

    def set_dependent_initial_conditions(
        self,
        dep_vars: Iterable[SymbolOrName] | None = None,
        use_jac: bool = False,
        **root_kwargs: Any,
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
        given: dict[TimeFunction, float] = {}
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
        if not isinstance(self._solver, Solver):
            return self._now(given.get("events"))
        with progress_of(True, " parts", desc="preparation", leave=False) as told:
            told(0, part="equations")
            problem = self._now(given.get("events"))
            told(1)
            told(0, part="machine code")
            rates_function(problem.code, problem.inputs)
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
        solver = self._solver
        shown = solver_kwargs.get("progress") is True
        problem = self._shown(solver_kwargs) if shown else self._now(solver_kwargs.get("events"))
        full = solver_kwargs.get("full_output", False)
        if isinstance(solver, (Solver, SolveIvp)) or is_odeint(solver):
            full = full is True or (full is not False and flag(full, "`full_output`"))
        if "solver" in solver_kwargs:
            refuse_solver(solver_kwargs["solver"])
        return integrate_states(
            problem, self._times, solver=solver, checked=not full, **solver_kwargs
        )

    def simulate(
        self,
        *,
        sensitivities: Any = None,  # or else `**` of a dict of numbers would be refused
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
        if "solver" in solver_kwargs:
            refuse_solver(solver_kwargs["solver"])
        motion = simulate(
            problem,
            self._times,
            solver=self._solver,
            sensitivities=sensitivities,
            control_sensitivities=control_sensitivities,
            **solver_kwargs,
        )
        trajectory = motion.trajectory
        if not np.isfinite(trajectory.outputs).all():
            warn_of_outputs(trajectory, problem)
        if sensitivities is not None:
            warn_of_jumps(problem, lambda: trajectory, motion.segments[0].augmented)
        return trajectory

    # -- Values and exact derivatives --------------------------------------------------------------

    def evaluate_ode(
        self,
        x: StateValues | None = None,
        t: ArrayLike | None = None,
        *,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
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

        Warns
        -----
        PyDyUserWarning
            A quaternion among the states is not of unit length, so that it orients no frame. Every
            evaluation that depends on it warns, once.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.evaluate_ode([1.0, 0.0])
        array([ 0., -1.])
        """
        return evaluate_block(self._now(), "rates", (x, t, r, p))

    def evaluate_outputs(
        self,
        x: StateValues | None = None,
        t: ArrayLike | None = None,
        *,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
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
        self,
        x: StateValues | None = None,
        t: ArrayLike | None = None,
        *,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
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
        values = Evaluator(problem, problem.model.energies.kernel, names)(t, x, r, p)
        return Energy(*(values.tolist() if values.ndim == 1 else values.T.copy()))

    def evaluate_constraints(
        self,
        x: StateValues | None = None,
        t: ArrayLike | None = None,
        *,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
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
        self,
        x: StateValues | None = None,
        t: ArrayLike | None = None,
        *,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
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
        self,
        x: StateValues | None = None,
        t: ArrayLike | None = None,
        *,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
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
        x: StateValues | None = None,
        t: ArrayLike | None = None,
        wrt: Variables = "states",
        *,
        of: ExpressionOrName | Iterable[ExpressionOrName] = "ode",
        r: InputValues | None = None,
        p: ConstantValues | None = None,
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
        of: ExpressionOrName,
        x: StateValues | None = None,
        t: ArrayLike | None = None,
        wrt: Variables = "states",
        *,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
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
        v: ArrayLike,
        x: StateValues | None = None,
        t: ArrayLike | None = None,
        wrt: Variables = "states",
        *,
        of: ExpressionOrName | Iterable[ExpressionOrName] = "ode",
        r: InputValues | None = None,
        p: ConstantValues | None = None,
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
        v: ArrayLike,
        x: StateValues | None = None,
        t: ArrayLike | None = None,
        wrt: Variables = "states",
        *,
        of: ExpressionOrName | Iterable[ExpressionOrName] = "ode",
        r: InputValues | None = None,
        p: ConstantValues | None = None,
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
        v: ArrayLike,
        of: ExpressionOrName,
        x: StateValues | None = None,
        t: ArrayLike | None = None,
        wrt: Variables = "states",
        *,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
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

    # -- Equations to read -------------------------------------------------------------------------

    def equations_of_motion(self, short: bool = True) -> EquationsOfMotion:
        """Return the equations of motion as SymPy expressions, to print and to work with.

        With up to three coordinates they are written as in a textbook: terms cancel, sums of angles
        are used where that is shorter, and common factors are factored out. With more, they are
        the compiled equations, with names for subexpressions that occur more than once.

        Parameters
        ----------
        short : bool, optional
            Whether sines and cosines are named as usual in robotics: s1 for the sine of q1, c12
            for the cosine of q1 + q2, s1m2 for the sine of q1 − q2.

        Returns
        -------
        EquationsOfMotion
            ``mass_matrix``, ``forcing`` and ``kinematics`` are matrices: ``M u' = F``, ``q' = …``,
            for all speeds. With constraints ``constraint_jacobian`` is J of ``M u' = F + Jᵀ λ``.
            ``names`` maps the short names to expressions, ``written_out(M)`` substitutes them. It
            is shown as LaTeX in notebooks.

        Raises
        ------
        ValueError
            There are constraints, and the method has no bodies.

        Examples
        --------
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1, cart_force=False)
        >>> print(system.equations_of_motion())
        M u' = F, with u = (u0, u1)
        M11 = m0 + m1
        M12 = -c1*l0*m1
        M22 = l0**2*m1
        F1 = -l0*m1*s1*u1**2
        F2 = g*l0*m1*s1
        q'1 = u0
        q'2 = u1
        c1 = cos(q1)
        s1 = sin(q1)
        """
        if self._equations.constraints.undifferentiated_holonomic:
            warn_of_missing_derivatives(self._now())
        made = equations_to_read(self._equations, tuple(self._forces))
        return made if flag(short, "`short`") else made.without_names()

    # -- Constraint forces -------------------------------------------------------------------------

    @property
    def constraint_forces(self) -> Multipliers:
        """Multipliers of the constraints: a dictionary that maps symbols to expressions.

        ``lambda0`` belongs to the first row of `constraints`, and so on; redundant constraints that
        were left out follow behind all others. The multiplier lambda of a row c adds lambda ∂c'/∂u
        to the equation of each speed u: a force in the direction in which c increases. Its unit
        times that of c is the unit of work (holonomic) or of power (nonholonomic). A row whose rate
        is not implied by any velocity constraint, such as the norm of a quaternion, has no
        multiplier.

        The expressions depend on states, derivatives of the speeds, constants and specifieds. They
        can be used in outputs, events and scenes; ``system.outputs = system.constraint_forces``
        makes each an output with its own name. Names can be used as keys. Forces that
        `noncontributing_forces` names by then are zero in them: the expressions include them.

        Raises
        ------
        ValueError
            The method knows no bodies.

        Examples
        --------
        The tension of a string is minus the multiplier of its length:

        >>> import sympy as sm
        >>> import sympy.physics.mechanics as me
        >>> from pydy.system import System
        >>> x, y, u, v = me.dynamicsymbols('x, y, u, v')
        >>> N, O = me.ReferenceFrame('N'), me.Point('O')
        >>> O.set_vel(N, 0)
        >>> P = O.locatenew('P', x*N.x + y*N.y)
        >>> kane = me.KanesMethod(
        ...     N, [x], [u], kd_eqs=[x.diff() - u, y.diff() - v], q_dependent=[y],
        ...     u_dependent=[v], configuration_constraints=[sm.sqrt(x**2 + y**2) - 2],
        ...     velocity_constraints=[x*u + y*v], bodies=[me.Particle('bob', P, 3)],
        ...     forcelist=[(P, -30*N.y)],
        ... )
        >>> system = System(kane)
        >>> system.outputs = {'tension': -system.constraint_forces['lambda0']}
        >>> system.evaluate_outputs([0.0, -2.0, 1.0, 0.0])[0].round(12)  # 3*10 + 3*1**2/2
        np.float64(31.5)
        """
        if self._equations.constraints.undifferentiated_holonomic:
            warn_of_missing_derivatives(self._now())
        return Reactions(self._equations, self._forces).multipliers()

    def reaction(
        self,
        bodies: Body | str | Joint | Iterable[Body | Location | str],
        point: Point | None = None,
        *,
        frame: ReferenceFrame | None = None,
        loads: Iterable[Load] | None = None,
    ) -> Reaction:
        """Return the force and torque of a joint, bearing or contact on a group of bodies.

        They follow from the Newton–Euler equations: the resultant, about a point, of everything
        that acts on these bodies from outside, except the loads.

        Parameters
        ----------
        bodies : RigidBody, Particle, str, or list of them, or Joint
            All bodies on one side of the cut; for the reaction of a joint on the bodies beyond it,
            those bodies. A joint of a `sympy.physics.mechanics.System`, or its name, stands for its
            child and all bodies beyond. A load is included if the point or frame it acts on moves
            with one of the bodies and with no body outside, nor with the ground; of bodies
            welded together, it belongs to the one it was located or oriented from. The list may
            also contain hinges, and massless points and frames whose loads are to be included.
        point : Point
            Point of action of the force, and reference point of the torque; by default the joint's
            own point.
        frame : ReferenceFrame, optional
            Frame of the components; by default the inertial frame.
        loads : iterable of loads, optional
            Other loads that act on these bodies from outside, not at `point`: the reaction of
            another joint or contact, from multipliers or from another call. Pairs of a Point and a
            force, or of a ReferenceFrame and a torque. An empty list says that the resultant of all
            is wanted.

        Returns
        -------
        Reaction
            ``force`` and ``torque``, SymPy vectors, which can be projected, added, or drawn as
            arrows. The method ``outputs(name)`` returns the six components for `outputs`.

        Raises
        ------
        TypeError, ValueError
            An argument is not valid, a position is not known, the method has no bodies, or it is a
            LagrangesMethod: a Lagrangian does not contain which load acts on which body.

        Warns
        -----
        PyDyUserWarning
            A constraint that closes a loop also holds the bodies, and neither its multiplier nor a
            reaction where it acts is in `loads`; or the coordinates join the bodies to others
            elsewhere as well, and there are no `loads`. The result is not the reaction of one
            joint. Or a torque on a massless link of particles among the bodies is not counted.

        Notes
        -----
        The result may contain masses and inertias that do not affect the motion, such as the
        products of inertia that a RigidBody names itself. They become constants of the System when
        the reaction is used, and are 1.0 by default like all others: set them.

        Examples
        --------
        >>> import sympy.physics.mechanics as me
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1)
        >>> cart, bob = system.eom_method.bodies
        >>> pin = system.reaction(bob, cart.masscenter)  # of the cart on the rod
        >>> system.outputs = pin.outputs('pin')
        >>> system.constants = {'m1': 3.0, 'g': 10.0}
        >>> system.evaluate_outputs([0.0, 0.0, 0.0, 0.0]).round(12)[:2] + 0.0
        array([ 0., 30.])
        """
        reactions = Reactions(self._equations, self._forces)
        found = reactions.reaction(bodies, point, frame, loads)
        if self._equations.constraints.undifferentiated_holonomic:
            warn_of_missing_derivatives(self._now())
        return found

    # -- Inverse dynamics, terms of the equations of motion, frames --------------------------------

    def _evaluated(
        self,
        made: Quantity,
        q: StateValues | None,
        t: ArrayLike | None,
        r: InputValues | None,
        p: ConstantValues | None,
        wrt: Variables | None,
    ) -> np.ndarray:
        """Evaluate what depends on no speeds."""
        at = q, None, np.zeros(0), t
        return evaluate(self._now(constants=p), made, at, r, p, wrt, self._values)

    @property
    def _values(self) -> Mapping[sm.Symbol, float]:
        """The method's values of constants that the motion does not depend on."""
        values: Mapping[sm.Symbol, float] = getattr(self._eom_method, "values", {})
        return values

    def inverse_dynamics(
        self,
        q: StateValues | None = None,
        v: StateValues | None = None,
        a: StateValues | None = None,
        t: ArrayLike | None = None,
        *,
        at: str | Iterable[SymbolOrName] | None = None,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
        wrt: Variables | None = None,
    ) -> np.ndarray:
        """Return the generalised forces that a motion needs in addition to the loads.

        τ = M(q) a + b(q, v), with `mass_matrix` and `bias`. They are what has to be added to the
        system's loads, specifieds included, so that the speeds change at the rates a. The force at
        a speed times that speed is a power: N for m/s, N m for rad/s. The recursive Newton–Euler
        algorithm gives them, in about half of the operations of `evaluate_ode`.

        Without `at` these are forces at all speeds, with which the motion needs no constraint
        forces: in a mechanism with loops, those of the tree that is left when the loops are cut.
        With `at` they act at some speeds alone, such as those of the motors, and constraints do the
        rest.

        Parameters
        ----------
        q, v : array_like, shape (n,) or (m, n), or dict, optional
            Coordinates, and speeds, in the orders of `coordinates` and `speeds`; by default the
            initial conditions. A dictionary gives some of these instead, by symbol or name; a
            warning reports a state that then violates the constraints.
        a : array_like, shape (n,) or (m, n), or dict, optional
            Derivatives of the speeds. Those of as many speeds as the constraints leave free bring
            the others along, as the constraints say: of the independent ones, by shape, or of those
            that a dictionary names. Where it names independent speeds alone, those of other
            independent speeds are zero, as all are by default.
        t : float or array_like, shape (m,), optional
            Time; by default the first of `times`, or zero.
        at : {'independent'} or list of speeds or names, optional
            Where the forces act, in this order: as many speeds as the constraints leave free.
        r, p
            As in `evaluate_ode`.
        wrt : {'coordinates', 'speeds', 'accelerations', 'specifieds', 'constants'}, list, optional
            Return the exact derivatives by these instead, or by symbols or names.

        Returns
        -------
        ndarray, shape (k,) or (m, k)
            One force for each speed, or for each in `at`. With `wrt` one more axis, for the
            variables.

        Raises
        ------
        ValueError
            A shape or a name is not valid, or constraints are known but no bodies.
        SingularMatrixError
            Forces at these speeds cannot give this motion: the mechanism is singular there.

        References
        ----------
        Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, section 5.3.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.inverse_dynamics([1.0], [0.0], [0.0])  # holds the spring
        array([1.])
        >>> system.inverse_dynamics([1.0], [0.0], system.evaluate_ode([1.0, 0.0])[1:])
        array([0.])
        """
        problem = self._now(constants=p)
        return inverse_dynamics(problem, (q, v, a, t), at, r, p, wrt, self._values)

    def mass_matrix(
        self,
        q: StateValues | None = None,
        t: ArrayLike | None = None,
        *,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
        wrt: Variables | None = None,
    ) -> np.ndarray:
        """Return the mass matrix of all speeds, before any constraint reduces it.

        Parameters
        ----------
        q, t, r, p, wrt
            As in `inverse_dynamics`.

        Returns
        -------
        ndarray, shape (n, n) or (m, n, n)
            Entries times a product of two speeds are energies. It is symmetric, unless loads hold
            accelerations.

        Examples
        --------
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1, cart_force=False)
        >>> system.mass_matrix([0.0, 0.0])
        array([[ 2., -1.],
               [-1.,  1.]])
        """
        return self._evaluated(mass_matrix(self._equations), q, t, r, p, wrt)

    def bias(
        self,
        q: StateValues | None = None,
        v: StateValues | None = None,
        t: ArrayLike | None = None,
        *,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
        wrt: Variables | None = None,
    ) -> np.ndarray:
        """Return the generalised forces at zero accelerations, one for each speed.

        They balance gravity and all other loads, and what the speeds bring: Coriolis and
        centrifugal forces.

        Parameters
        ----------
        q, v, t, r, p, wrt
            As in `inverse_dynamics`.

        Returns
        -------
        ndarray, shape (n,) or (m, n)

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> multi_mass_spring_damper().bias([1.0], [2.0])  # k0*x0 + c0*v0
        array([3.])
        """
        made, at = required_forces(self._equations, (), None, zero=True), (q, v, np.zeros(0), t)
        return evaluate(self._now(constants=p), made, at, r, p, wrt, self._values)

    def gravity(
        self,
        q: StateValues | None = None,
        t: ArrayLike | None = None,
        *,
        acceleration: Vector | None = None,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
        wrt: Variables | None = None,
    ) -> np.ndarray:
        """Return the generalised forces that hold all masses against gravity.

        Gravity is what the loads at all mass centres have in common: forces for each body with a
        mass, this mass times one constant acceleration. In one vector with others it is not known.

        Parameters
        ----------
        q, t, r, p, wrt
            As in `inverse_dynamics`.
        acceleration : Vector, optional
            Of free fall, such as ``-g*N.z``, if it cannot be found from the loads.

        Returns
        -------
        ndarray, shape (n,) or (m, n)

        Raises
        ------
        ValueError
            The loads at mass centres have no acceleration in common, one of them may contain
            other forces than a weight, or gravity is in a Lagrangian; give `acceleration`.

        Examples
        --------
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1)
        >>> system.constants = {'g': 10.0}
        >>> system.gravity({'q1': 0.5}).round(6)
        array([ 0.      , -4.794255])
        """
        return self._evaluated(gravity(self._equations, acceleration), q, t, r, p, wrt)

    def frame_position(
        self,
        where: str | Body | Location | tuple[ReferenceFrame, Point],
        q: StateValues | None = None,
        t: ArrayLike | None = None,
        *,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
        wrt: Variables | None = None,
    ) -> np.ndarray:
        """Return where a point is, in the axes of the inertial frame.

        It is measured from the point at rest that is next to the bodies.

        Parameters
        ----------
        where : str, RigidBody, Particle, Point, or pair of a ReferenceFrame and a Point
            A name is one of the `frames` of a `pydy.mechanics.Definition`, such as the links of a
            robot from a file, or that of a body, whose mass centre is meant.
        q, t, r, p, wrt
            As in `inverse_dynamics`.

        Returns
        -------
        ndarray, shape (3,) or (m, 3)

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> body = system.eom_method.bodies[0]
        >>> system.frame_position(body, [2.0])
        array([2., 0., 0.])
        """
        made = frame_position(self._equations, self._eom_method, where)
        return self._evaluated(made, q, t, r, p, wrt)

    def frame_rotation(
        self,
        where: str | Body | Location | tuple[ReferenceFrame, Point],
        q: StateValues | None = None,
        t: ArrayLike | None = None,
        *,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
        wrt: Variables | None = None,
    ) -> np.ndarray:
        """Return the rotation matrix of a frame: its axes as columns, in the inertial frame.

        Parameters
        ----------
        where : str, RigidBody, ReferenceFrame, or pair of a ReferenceFrame and a Point
            As in `frame_position`.
        q, t, r, p, wrt
            As in `inverse_dynamics`.

        Returns
        -------
        ndarray, shape (3, 3) or (m, 3, 3)
        """
        made = frame_rotation(self._equations, self._eom_method, where)
        return self._evaluated(made, q, t, r, p, wrt)

    def frame_jacobian(
        self,
        where: str | Body | Location | tuple[ReferenceFrame, Point],
        q: StateValues | None = None,
        t: ArrayLike | None = None,
        *,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
        wrt: Variables | None = None,
    ) -> np.ndarray:
        """Return how fast a frame moves with each speed, all speeds free.

        Parameters
        ----------
        where : str, RigidBody, Particle, Point, ReferenceFrame, or pair of the last two
            As in `frame_position`.
        q, t, r, p, wrt
            As in `inverse_dynamics`.

        Returns
        -------
        ndarray, shape (6, n) or (m, 6, n)
            Three rows for the velocity of the point, then three for the angular velocity, in the
            axes of the inertial frame: the derivatives of both by the speeds. For a point or a
            frame alone, its three rows. The transpose gives the generalised forces of a force and
            a torque there.

        Examples
        --------
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1)
        >>> cart, bob = system.eom_method.bodies
        >>> system.frame_jacobian(bob, [0.0, 0.0]) + 0.0
        array([[ 1., -1.],
               [ 0.,  0.],
               [ 0.,  0.]])
        """
        made = frame_jacobian(self._equations, self._eom_method, where)
        return self._evaluated(made, q, t, r, p, wrt)

    # -- Inertial parameters -----------------------------------------------------------------------

    def inertial_parameters(self, *, p: ConstantValues | None = None) -> dict[str, float]:
        """Return mass, first moments and inertia of each body, as `regressor` takes them.

        Parameters
        ----------
        p
            As in `evaluate_ode`.

        Returns
        -------
        dict
            ``'m of arm'`` (kg); ``'mx of arm'`` and so on, the mass times the way to the mass
            centre from where the model has it (kg m), which are zero; ``'Ixx of arm'`` and so on,
            the inertia about that point in the axes of the body (kg m²). A Particle has its mass
            alone.
        """
        made = inertial_parameters(self._equations)
        values = self._evaluated(made, None, None, None, p, None)
        return dict(zip(made.rows, values.tolist(), strict=True))

    def regressor(
        self,
        q: StateValues | None = None,
        v: StateValues | None = None,
        a: StateValues | None = None,
        t: ArrayLike | None = None,
        *,
        acceleration: Vector | None = None,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
    ) -> np.ndarray:
        """Return the matrix Y that is multiplied by the inertial parameters in `inverse_dynamics`.

        The forces of a motion are Y π, and those that balance loads other than gravity. They are
        linear in the parameters π of `inertial_parameters`, whatever constants the model has.

        Parameters
        ----------
        q, v, a, t, r, p
            As in `inverse_dynamics`; here a has all speeds.
        acceleration
            Of free fall, as in `gravity`, if it cannot be found from the loads.

        Returns
        -------
        ndarray, shape (n, k) or (m, n, k)
            One column for each parameter.

        Raises
        ------
        ValueError
            Gravity cannot be found from the loads: give `acceleration`. Or a mass may change with
            time.

        Examples
        --------
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1)
        >>> system.regressor([0.0, 0.0], [0.0, 0.0], [1.0, 0.0])
        array([[ 1.,  1.],
               [ 0., -1.]])
        >>> system.inertial_parameters()
        {'m of Pa0': 1.0, 'm of Pa1': 1.0}
        """
        made = regressor(self._equations, acceleration)
        at = (q, v, all_accelerations(a, self._equations), t)
        return evaluate(self._now(constants=p), made, at, r, p, None, self._values)

    def base_parameters(
        self,
        q: StateValues,
        v: StateValues,
        a: StateValues,
        t: ArrayLike | None = None,
        *,
        acceleration: Vector | None = None,
        r: InputValues | None = None,
        p: ConstantValues | None = None,
    ) -> BaseParameters:
        """Return the combinations of inertial parameters that some motions determine.

        Parameters
        ----------
        q, v, a, t, acceleration, r, p
            As in `regressor`: many states, measured ones or random ones.

        Returns
        -------
        BaseParameters
            ``places``, the independent columns of the regressor, and ``matrix``.

        Examples
        --------
        >>> import numpy as np
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1)
        >>> q, v, a = np.random.default_rng(0).normal(size=(3, 9, 2))
        >>> system.base_parameters(q, v, a).places
        [0, 1]
        """
        columns = self.regressor(q, v, a, t, acceleration=acceleration, r=r, p=p)
        return base_parameters(self._equations, columns)

    # -- Linear models -----------------------------------------------------------------------------

    @np.errstate(under="ignore")  # shares of sizes may be zero
    def linearize(
        self,
        at: StateValues | Equilibrium | None = None,
        t: ArrayLike | None = None,
        *,
        inputs: SymbolOrName | Iterable[SymbolOrName] | None = None,
        outputs: SymbolOrName | Iterable[SymbolOrName] | None = None,
    ) -> LinearModel:
        """Return the linear model of small motions that satisfy the constraints.

        Parameters
        ----------
        at : array_like, shape (n,) or (m, n), dict or Equilibrium, optional
            States; the initial conditions by default, which should be an equilibrium: ``at={}``
            says that they need not. For several states, such as along a trajectory, each matrix has
            an additional first axis. A dictionary replaces some of the initial conditions, by
            symbol or name. An Equilibrium also provides the constants and specifieds that were
            found or given.
        t : float or array_like, shape (m,), optional
            As in `evaluate_ode`.
        inputs : specified or name, or iterable of them, optional
            All by default. The derivatives of a prescribed motion are inputs of their own: a
            warning names one that matters and is missing. If a specified is given as an expression
            or a function, the input is an addition to its value, and its feedback is part of A.
            Functions are differentiated numerically.
        outputs : state, output or name, or iterable of them, optional
            All states by default.

        Returns
        -------
        LinearModel

        Raises
        ------
        ValueError
            The system has no such name, the configuration is singular, or the equations are not
            finite there.

        Warns
        -----
        PyDyUserWarning
            A state does not satisfy the constraints, or a quaternion is not of unit length; a load
            or rate has a kink or a jump there, of which the model knows one side; a Piecewise
            avoids a division by zero there, with a branch of another slope; or neither `at` nor
            `t` is given, the initial conditions are no equilibrium, and the model changes along
            the motion from there. Coordinates that no other rate depends on, such as the position
            of a vehicle, do not count. A change that begins in the third or a higher order of time
            is not seen, nor one by inputs that are functions of time.

        Examples
        --------
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart()
        >>> model = system.linearize(outputs=['q1'])
        >>> model.A[3].round(6)
        array([0., 2., 0., 0.])
        >>> float(model.eigenvalues.real.max().round(6))
        1.414214
        """
        from pydy.analysis import linearize

        return linearize(self._now(), at, t, inputs=inputs, outputs=outputs)

    # -- Equilibria --------------------------------------------------------------------------------

    @np.errstate(under="ignore")  # shares of sizes may be zero
    def find_equilibrium(
        self,
        unknowns: Iterable[SymbolOrName] | None = None,
        given: BySymbol[float] | None = None,
        *,
        moving: Iterable[SymbolOrName] = (),
        bounds: BySymbol[Bounds] | None = None,
    ) -> Equilibrium:
        """Find a state in which the system remains at rest or moves steadily.

        All other values are those of the System; the search starts from its initial conditions,
        and where none is near, from where the system settles if its swings die out. Quaternions
        have unit length there, with or without a constraint, and angles are within half a
        revolution of the start.

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
        from pydy.analysis import find_equilibrium

        return find_equilibrium(self._now(), unknowns, given, bounds, moving)

    # -- Eigenvalues and equilibria over a parameter -----------------------------------------------

    @np.errstate(under="ignore")  # shares of sizes may be zero
    def eigenvalues(
        self,
        over: BySymbol[ArrayLike],
        at: StateValues | None = None,
        *,
        unknowns: Iterable[SymbolOrName] | None = None,
        given: BySymbol[float] | None = None,
        moving: Iterable[SymbolOrName] = (),
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
        from pydy.analysis import eigenvalues

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
        over: BySymbol[ArrayLike],
        unknowns: Iterable[SymbolOrName] | None = None,
        given: BySymbol[float] | None = None,
        *,
        moving: Iterable[SymbolOrName] = (),
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
            A branch that ends elsewhere, after `most` points or because it was lost, warns.

        Raises
        ------
        AnalysisInterrupted
            The user interrupted it; the error holds the branch so far. So does a MemoryError.
        EquilibriumError
            There is no equilibrium at the first value.
        ValueError
            A name is not one of the system's; or the first value is at a fold with free unknowns,
            and nothing tells the branch from these.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> (point,) = system.follow_equilibria({'c0': [1.0, -1.0]}).special
        >>> point.kind, abs(round(point.value, 9)), round(point.frequency, 9)
        ('Hopf', 0.0, 1.0)
        """
        from pydy.analysis import follow_equilibria

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

    # -- Periodic orbits ---------------------------------------------------------------------------

    @np.errstate(under="ignore")  # shares of sizes may be zero
    def find_periodic_orbit(
        self,
        period: float,
        *,
        moving: Iterable[SymbolOrName] = (),
        until: Event | None = None,
        progress: bool = False,
        contacts: Contacts | None = None,
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
            Other events on the way are given as `events`.
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
        from pydy.analysis import find_periodic_orbit

        if until is not None:
            instance(until, Event, "`until`", "a pydy.solvers.Event")
        further = solver_kwargs.get("events", ())
        events = [further] if isinstance(further, Event) else listed("events", further, "events")
        # All events of a model may be listed, the one that ends the period among them.
        further = [event for event in events if event != until]
        if further:
            solver_kwargs["events"] = further
        else:
            solver_kwargs.pop("events", None)
        events = further if until is None else [until, *further]
        problem = self._now(events or None, contacts=self._checked_contacts(contacts))
        return find_periodic_orbit(
            problem,
            period,
            moving=moving,
            until=until,
            solver=native_solver(self._solver),
            progress=progress,
            **solver_kwargs,
        )

    # -- Gradients ---------------------------------------------------------------------------------

    def adjoint_gradient(
        self,
        wrt: Variables,
        *,
        final: ExpressionOrName | None = None,
        integral: ExpressionOrName | None = None,
        contacts: Contacts | None = None,
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
            derivatives do not include the jump. Or the steps are those of the states' errors alone,
            as derivatives could not be integrated with the motion.

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
        from pydy.analysis import adjoint_gradient, explicit_solver

        if final is None and integral is None:
            raise ValueError(
                "`final` or `integral` must be given: an output or an expression of states, "
                "specifieds, constants and time."
            )
        solver = explicit_solver(self._solver)
        contacts = self._checked_contacts(contacts)
        if contacts is not None:
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

    # -- Fits --------------------------------------------------------------------------------------

    def fit(
        self,
        parameters: Variables,
        trials: Trial | Iterable[Trial],
        *,
        bounds: BySymbol[Bounds] | None = None,
        priors: BySymbol[tuple[float, float]] | None = None,
        segments: int = 1,
        method: str = "shooting",
        mesh: int | ArrayLike | None = None,
        process_noise: BySymbol[float] | None = None,
        solver: str | None = None,
        most: int = 100,
        progress: bool = False,
        contacts: Contacts | None = None,
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
            Show a progress bar of the evaluations, or iterations, with the motions that each of
            them has simulated so far if there are several; requires tqdm.
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
            the search did not converge, or neighbouring residuals are correlated: standard errors
            are too small, or the model does not describe the data, as in a local minimum. White
            noise causes this warning in one of 10 000 fits.

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
        from pydy.analysis import FittedSystem, fit

        self._checked_contacts(contacts)
        return fit(
            FittedSystem(self._now(contacts=contacts), self._solver),
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

    # -- Optimal control ---------------------------------------------------------------------------

    def optimize_trajectory(
        self,
        objective: sm.Expr,
        duration: float | sm.Symbol,
        *,
        start: BySymbol[float | Bounds | None] | None = None,
        end: BySymbol[float | Bounds | None] | None = None,
        boundary: Iterable[sm.Basic] = (),
        path: Iterable[sm.Basic] | None = None,
        bounds: BySymbol[tuple[SignalBound, SignalBound]] | None = None,
        free: Iterable[SymbolOrName] = (),
        mesh: int | ArrayLike = 20,
        method: str = "radau",
        order: int = 3,
        hessian: str = "exact",
        guess: Any = None,
        mesh_tol: float | None = None,
        options: Mapping[str, object] | None = None,
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
        >>> x, F, t = system.states[0], *system.specifieds_symbols, me.dynamicsymbols._t
        >>> rest = {s: 0.0 for s in system.states}
        >>> found = system.optimize_trajectory(sm.Integral(F**2, t), 2.0, end={**rest, x: 0.5})
        >>> found['q0'][-1].round(9), found.message
        (np.float64(0.5), 'solved')
        """
        from pydy.control import OptimalControl

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

    # -- Ensembles ---------------------------------------------------------------------------------

    def integrate_ensemble(
        self,
        *,
        initial_conditions: BySymbol[ArrayLike] | None = None,
        constants: BySymbol[ArrayLike] | None = None,
        specifieds: BySymbol[Specified] | None = None,
        times: ArrayLike | None = None,
        ode_solver: Solver | str | None = None,
        product: bool = False,
        sensitivities: Variables | None = None,
        control_sensitivities: bool = False,
        reduce: Reduction | Sequence[Reduction] | None = None,
        chunks: int | str | Mapping[str, int] | None = None,
        store: str | PathLike[str] | None = None,
        resume: bool | str = False,
        workers: int | None = None,
        progress: bool = False,
        units: BySymbol[str | tuple[str, float]] | None = None,
        contacts: Contacts | None = None,
        **solver_kwargs: Unpack[EnsembleOptions],
    ) -> Dataset:
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
            What to return instead of the values at all times: ``'final'``, those at the last time,
            or after the terminal event that ended a sample; ``('max', name)`` or ``('min', name)``
            of a state or output; ``'events'`` or ``('events', number)`` for the first times of each
            event; a list of these; or a function that takes the Dataset of some samples and returns
            a Dataset that keeps the sample dimensions.
        chunks : int, 'auto' or dict of str to int, optional
            Sizes of blocks of samples. The Dataset is then lazy: it contains Dask arrays, computed
            by the scheduler that you choose. 'auto' makes blocks of at most 8 MB of results, and
            for a cluster that is connected blocks of up to 32 MB. With `store`, this only sets the
            sizes.
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
            Values of the attribute ``units`` of the variables. Values are not converted: degrees
            of states are refused, but for ``('deg', 1)``, where the equations are in degrees.
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
            jumps on the way, which `sensitivities` do not know. Or a quaternion does not begin with
            unit length; of many samples, 64 are checked for it.

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
        from pydy.ensemble import integrate_ensemble

        if contacts is not None:
            self._checked_contacts(contacts)
        problem = self._now(solver_kwargs.get("events"), constants, contacts)
        results: Dataset = integrate_ensemble(
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
        return results

    # -- JAX and PyTorch ---------------------------------------------------------------------------

    def _layer_functions(
        self, contacts: Contacts | None, options: dict[str, Any]
    ) -> LayerFunctions:
        """Return the functions of the System as it is now."""
        from pydy.layers import LayerFunctions

        if contacts is not None:
            self._checked_contacts(contacts)
        problem = self._now(options.get("events"), contacts=contacts)
        return LayerFunctions(problem, native_solver(self._solver), options)

    def as_jax(self, *, contacts: Contacts | None = None, **solver_kwargs: Any) -> Layer:
        """Return the equations and simulations as functions of JAX.

        They are compiled as for `evaluate_ode` and `simulate`. They work under `jax.jit`,
        `jax.vmap` (one call for all samples; simulations as an ensemble), `jax.grad`, `jax.vjp` and
        `jax.jvp`. Second derivatives are refused.

        Parameters
        ----------
        contacts : pydy.contact.Contacts, optional
            Contacts of this System, which simulations are done with; their constants are arguments
            too.
        **solver_kwargs
            Options of the `ode_solver` for simulations, as in `simulate`; ``'dop853'`` is used if
            it is not native.

        Returns
        -------
        Layer
            ``ode``, ``outputs``, ``simulate`` and ``final``, of the system as it is now.

        Raises
        ------
        ImportError
            A package is missing: ``pip install 'pydy[jax]'``.
        TypeError
            JAX computes with float32: ``jax.config.update('jax_enable_x64', True)``.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> import jax  # doctest: +SKIP
        >>> jax.config.update('jax_enable_x64', True)  # doctest: +SKIP
        >>> layer = system.as_jax()  # doctest: +SKIP
        >>> jax.jit(layer.ode)([1.0, 0.0])  # doctest: +SKIP
        Array([ 0., -1.], dtype=float64)
        """
        from pydy.layers import JaxArrays, Layer

        return Layer(self._layer_functions(contacts, solver_kwargs), JaxArrays(), "JAX")

    def as_torch(self, *, contacts: Contacts | None = None, **solver_kwargs: Any) -> Layer:
        """Return the equations and simulations as functions of PyTorch.

        They take and return tensors of float64, and work with autograd, and with `torch.func`:
        `grad`, `vjp`, `jvp` and `vmap`. Second derivatives are refused.

        Parameters
        ----------
        contacts, **solver_kwargs
            As in `as_jax`.

        Returns
        -------
        Layer
            As of `as_jax`.

        Raises
        ------
        ImportError
            A package is missing: ``pip install 'pydy[torch]'``.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> layer = multi_mass_spring_damper().as_torch()  # doctest: +SKIP
        >>> layer.ode([1.0, 0.0])  # doctest: +SKIP
        tensor([ 0., -1.], dtype=torch.float64)
        """
        from pydy.layers import Layer, TorchArrays

        return Layer(self._layer_functions(contacts, solver_kwargs), TorchArrays(), "PyTorch")

    # -- Pictures ----------------------------------------------------------------------------------

    def _motion(self, times: np.ndarray, states: np.ndarray) -> Trajectory:
        """Return a trajectory of checked arrays, and the model that moves the scene."""
        problem = self._now()
        kinds = problem.definition.symbols_by_kind
        symbols = {k: v for k, v in kinds.items() if k not in ("output", "constraint", "force")}
        along = evaluate_specifieds(problem, times, states)
        return Trajectory(times, states, symbols, specifieds=along, constants=problem.constants)

    def _live_system(
        self, *, events: Event | Iterable[Event] | None = None, **options: Any
    ) -> LiveSystem:
        """Return what a page that simulates needs."""
        return live_system(self._now(events), events=events, **options)

    def scene(
        self,
        *visuals: Visual | Body,
        reference_frame: ReferenceFrame | None = None,
        origin: Point | None = None,
        **options: Any,
    ) -> Scene:
        """Return a scene of the system, which can be animated and written as an HTML page.

        Parameters
        ----------
        *visuals : pydy.viz.Visual, RigidBody or Particle
            By default what points and frames show: bars between the joints of bodies, ropes,
            springs, dampers, wheels and supports; a ball for each Particle; and a solid with the
            same inertia for a RigidBody without further points.
        reference_frame : ReferenceFrame, optional
            By default the inertial frame.
        origin : Point, optional
            By default a point at rest in that frame, connected with the bodies.
        **options
            `loads`: whether to show forces and torques as arrows. Options of `pydy.viz.Scene`:
            `up` (by default against gravity), `ground`, `follow`, `view`, `series`, `units`,
            `title` and `constants`: values of symbols that only positions and shapes depend on.

        Returns
        -------
        pydy.viz.Scene

        Raises
        ------
        ValueError
            There are no bodies to show, or no point that can be the origin.

        Warns
        -----
        PyDyUserWarning
            Points that depend on symbols without values are not drawn.

        Examples
        --------
        >>> import numpy as np
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(2)
        >>> system.initial_conditions = {system.coordinates[1]: 0.5}
        >>> system.times = np.linspace(0.0, 1.0, num=61)
        >>> scene = system.scene().animate(system.simulate())
        >>> scene.poses.shape
        (61, 5, 4, 4)

        ``scene.to_html('pendulum.html')`` writes the page, ``scene.show()`` opens it.
        """
        from pydy._problem import make_scene

        definition = self._definition
        constants = read_numbers(definition, "constants", self._constants, None)
        given = {"reference_frame": reference_frame, "origin": origin, **options}
        numbers = dict(zip(definition.constants, constants.tolist(), strict=True))
        assembly = partial(attrgetter("model.assembly"), self)
        moving = partial(attrgetter("_times"), self), self._motion, self._live_system
        return make_scene(definition, numbers, assembly, visuals, given, moving)

    def _moved(self, contacts: Contacts | None, method: str) -> Trajectory:
        """Simulate with contacts or without; refuse to leave out those that were made."""
        if contacts is not None:
            self._checked_contacts(contacts)
            moved: Trajectory = contacts.simulate()
            return moved
        if self._has_contacts:
            raise ValueError(
                f"`system.{method}()` knows no contacts, and `Contacts` were made of this system: "
                f"bodies would fall through the ground. Pass `system.{method}(contacts=contacts)`, "
                "or, for the motion without them, use what `system.simulate()` returns."
            )
        return self.simulate()

    def plot(
        self,
        names: list[SymbolOrName] | None = None,
        *,
        contacts: Contacts | None = None,
        **options: Any,
    ) -> Any:
        """Simulate, and plot the states or selected quantities over time.

        Equivalent to ``system.simulate().plot(...)``; see `pydy.trajectory.Trajectory.plot`. For
        several plots, keep the trajectory and use its own method.

        Parameters
        ----------
        names : list of symbols or names, optional
        contacts : pydy.contact.Contacts, optional
            Contacts of this system, with which it is simulated.
        **options
            Those of `pydy.trajectory.Trajectory.plot`.

        Raises
        ------
        ValueError
            There are `Contacts` of this system, and none were passed.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.initial_conditions = {'x0': 1.0}
        >>> system.times = [0.0, 0.5, 1.0]
        >>> system.plot(['x0']).get_xlabel()
        'time'
        """
        return self._moved(contacts, "plot").plot(names, **options)

    def animate(
        self, *visuals: Visual | Body, contacts: Contacts | None = None, **options: Any
    ) -> Scene:
        """Simulate, and return an animated scene, which a notebook displays.

        Equivalent to ``system.scene(...).animate(system.simulate())``, with the arguments of
        `scene`.

        Parameters
        ----------
        *visuals
            As in `scene`.
        contacts : pydy.contact.Contacts, optional
            Contacts of this system, with which it is simulated.
        **options
            Those of `scene`.

        Raises
        ------
        ValueError
            There are `Contacts` of this system, and none were passed; or as in `scene`.
        """
        return self.scene(*visuals, **options).animate(self._moved(contacts, "animate"))

    # -- Exports -----------------------------------------------------------------------------------

    def export(
        self,
        path: str | PathLike[str],
        *,
        name: str | None = None,
        events: Event | Iterable[Event] | None = None,
        inputs: Iterable[SymbolOrName] = (),
        progress: bool = False,
        **options: Any,
    ) -> Exported:
        """Write the system as code for another program: C, an FMU, JavaScript or Python.

        Parameters
        ----------
        path : path
            The suffix selects the format: ``.c`` (C99, with a header next to it), ``.fmu`` (a
            functional mock-up unit for Model Exchange and Co-Simulation), ``.js`` (an ECMAScript
            module) or ``.py`` (functions that need only NumPy, JAX or CasADi).
        name : str, optional
            Name of the model; by default the stem of the file.
        events : Event or sequence of Event, optional
            Events to export with their resets; event indicators in an FMU.
        inputs : iterable of specifieds, optional
            Specifieds given by a function or by samples that become inputs. Their order does not
            matter: inputs are numbered as in `specifieds_symbols`.
        progress : bool, optional
            Whether to show which part is made, the C compiler's included; requires tqdm.
        **options
            ``fmi`` ('3.0' or '2.0') and ``binary`` (False omits the compiled library) for
            ``.fmu``; ``target`` ('numpy', 'jax' or 'casadi') for ``.py``.

        Returns
        -------
        Exported
            ``path``, ``files``, and ``names``, the identifiers of names that are not valid ones.

        Raises
        ------
        ValueError
            Unknown suffix, a specified given by a function or by samples, or one in `inputs` that
            an expression gives.
        GeneratorError
            No C compiler was found for the binary of an FMU, or it failed.

        Examples
        --------
        >>> import os, tempfile
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1)
        >>> folder = tempfile.mkdtemp()
        >>> exported = system.export(os.path.join(folder, 'pendulum.c'))
        >>> [file.name for file in exported.files]
        ['pendulum.c', 'pendulum.h']
        """
        from pydy.export import check_options, solves, write

        target = file_of(path, "`path`")
        check_options(target, options)
        title = target.stem if name is None else text(name, "`name`")
        inputs = listed("inputs", inputs, "specifieds of the system", hashable=True)
        with progress_of(flag(progress, "`progress`"), " parts") as told:
            told(0, part="equations")
            model = exported_model(
                self._now(events),
                name=title,
                events=events,
                inputs=inputs,
                max_step=np.inf if solves(target) else None,
            )
            told(1)
            return write(replace(model, told=told), target, **options)
