"""What a System is: its equations, what the user set, and what is compiled of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, MutableMapping
from copy import copy
from typing import TYPE_CHECKING, Any, Literal, Self

import numpy as np
import scipy
import sympy as sm

from pydy._assembly.definition import Definition
from pydy._assembly.model import CompiledModel
from pydy._assembly.specifieds import check_expressions
from pydy._checks import Keyed, check_mapping, choice, instance, merged, names_meant, shown
from pydy._errors import warn_user
from pydy._html import html_table
from pydy._mechanics.extract import extract, method_of
from pydy._mechanics.implicit import Implicit
from pydy._names import name_of, some
from pydy._simulation.definition import (
    DefinitionBuilder,
    SymbolSet,
    base_symbols,
    check_forces,
    check_times,
)
from pydy._simulation.energy import EnergyModel, check_potential
from pydy._simulation.generated import Generated, checked_options, generate
from pydy._simulation.missing_derivatives import warn_of_missing_derivatives
from pydy._simulation.model import Model
from pydy._simulation.problem import Problem, checked_plan, read_numbers
from pydy._simulation.scipy_solvers import resolve_ode_solver
from pydy._simulation.summary import shortened, summary
from pydy.solvers.events import Event

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

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


class Setup:
    """The state of a System, checked when set and when used: it may be edited in place."""

    @names_meant("System", _NAMES_OF_METHODS)
    def __init__(
        self,
        eom_method: Any,
        constants: Mapping[Any, Any] | None = None,
        specifieds: Mapping[Any, Any] | None = None,
        ode_solver: Callable[..., Any] | str | None = None,
        initial_conditions: Mapping[Any, Any] | None = None,
        times: ArrayLike | None = None,
        outputs: Mapping[Any, Any] | None = None,
        noncontributing_forces: Iterable[Any] | None = None,
        constants_symbols: Iterable[Any] | None = None,
        specifieds_symbols: Iterable[Any] | None = None,
        equations: Literal["graph", "method"] | None = None,
        implicit: Implicit | None = None,
    ) -> None:
        if equations is not None:
            choice(equations, ("graph", "method"), "`equations`")
        if implicit is not None:
            instance(implicit, Implicit, "`implicit`", "a pydy.mechanics.Implicit")
        self._equations = extract(eom_method, equations, implicit)
        self._eom_method = eom_method
        self._energies = EnergyModel(self._equations)
        base = base_symbols(self._equations, constants_symbols, specifieds_symbols)
        self._define = DefinitionBuilder(self._equations, base, self._energies)
        self._options: dict[str, Any] = {}
        self._generated: list[Generated] = []  # the latest first
        self._constants: dict[Any, Any] = {}
        self._implied: dict[Any, float] = {}  # constants that are not the user's: of contacts
        self._has_contacts = False  # whether Contacts were made of it
        self._specifieds: dict[Any, Any] = {}
        self._initial_conditions: dict[Any, Any] = {}
        self._dependent: dict[Any, float] | None = None  # initial conditions solved for last
        self._told: set[Any] = set()  # derivatives of specifieds that were warned of
        # Symbols of which the user knows that values contradict their assumptions; None where
        # that is not judged, as in a fit, which only tries numbers.
        self._contradicted: set[str] | None = set()
        self._outputs: dict[Any, Any] = {}
        self._forces: list[Any] = []
        self._set_outputs(outputs, noncontributing_forces)
        self.specifieds = specifieds  # first: an expression may bring constants of its own
        self.constants = constants
        self.ode_solver = ode_solver
        self.initial_conditions = initial_conditions
        self.times = times

    def __copy__(self) -> Self:
        twin = object.__new__(type(self))
        kinds = (dict, list, set, np.ndarray, DefinitionBuilder)  # what may change in place
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
        values = {
            "initial_conditions": self._initial_conditions,
            "constants": {**self._implied, **self._constants},
            "specifieds": self._specifieds,
        }
        method, of_events = type(self._eom_method).__name__, self._define.of_events
        definition = self._define.latest
        return summary(definition, method, self.ode_solver, self._times, values, of_events)

    @property
    def _definition(self) -> Definition:
        # The user may have edited the dictionaries of outputs, specifieds and constants in place.
        return self._defined(self._constants)

    def _defined(self, constants: Mapping[Any, Any]) -> Definition:
        """Return the definition with these constants, which the equations need not hold."""
        definition = self._define(self._outputs, self._forces, self._specifieds)
        silent = definition.places["constants"].unknown(constants, "constants")
        return self._define.holding(definition, silent) if silent else definition

    def _compiled(self, definition: Definition | None = None) -> Generated:
        """Return the function generated for a definition, by default the present one."""
        definition = self._definition if definition is None else definition
        for made in self._generated:
            if made.definition is definition or made.definition == definition:
                return made
        made = generate(definition, self._eom_method, self._options)
        self._generated = [made, *self._generated[:1]]
        return made

    def _now(
        self,
        events: Any = None,
        constants: Any = None,
        contacts: Any = None,
        further: Iterable[Any] = (),
    ) -> Problem:
        """Return everything as it is now, with the symbols that one call brings.

        Those of events are constants, and so are `further` symbols.
        """
        more = constants if isinstance(constants, Mapping) else {}
        if contacts is not None:
            if not contacts.given.keys() <= self._constants.keys():
                contacts.refuse_lost({**self._constants, **more})
            own = [events] if isinstance(events, Event) else events
            events = [*contacts.symbols, *(own if isinstance(own, (list, tuple)) else ())]
        definition = self._defined({**self._constants, **more} if more else self._constants)
        if events is not None:
            found = self._define.constants_of(definition, events)
            definition = self._define.widened(definition, found) if found else definition
        if further:
            definition = self._define.widened(definition, further)
        made = self._compiled(definition)
        user = {
            "constants": {**self._implied, **self._constants},
            "specifieds": dict(self._specifieds),
            "initial_conditions": dict(self._initial_conditions),
        }
        solved = None if self._dependent is None else tuple(self._dependent)
        return Problem(
            made.definition,
            Model(made.definition, made.code, self._energies, self._told),
            user,
            self._times,
            self._contradicted,
            solved,
            contacts,
        )

    def _told_again(self, definition: Definition, what: str) -> set[str] | None:
        """Forget that values of a kind contradict assumptions; return what remains told."""
        if self._contradicted and (assumed := definition.assumptions.get(what)) is not None:
            self._contradicted -= {assumed.names[k] for k in assumed.columns}
        return self._contradicted

    def _checked_contacts(self, contacts: Any) -> Any:
        """Return an argument `contacts`, None or Contacts of this System."""
        if contacts is not None and getattr(contacts, "system", None) is not self:
            raise TypeError(f"`contacts` must be Contacts of this System, got {shown(contacts)}.")
        return contacts

    def _set_outputs(self, outputs: Any, forces: Any) -> None:
        names = check_forces(self._equations, forces)
        own = self._define.users(outputs, self._forces)
        self._define(own, names, self._specifieds)
        self._outputs, self._forces = self._define.merged(own, names), names

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
        return self._compiled().code

    @property
    def eom_method(self) -> Any:
        """The method object that the equations come from. Read-only."""
        return method_of(self._eom_method)

    @property
    def coordinates(self) -> list[Any]:
        """List of the generalized coordinates, functions of time."""
        return list(self._equations.coordinates)

    @property
    def speeds(self) -> list[Any]:
        """List of the generalized speeds, functions of time."""
        return list(self._equations.speeds)

    @property
    def auxiliaries(self) -> list[Any]:
        """List of the auxiliary states: time integrals of outputs that depend on u' linearly."""
        return list(self._definition.auxiliaries)

    @property
    def states(self) -> list[Any]:
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
    def constraints(self) -> Any:
        """Column matrix of the holonomic, then the nonholonomic constraint expressions."""
        rows = [*self._equations.holonomic, *self._equations.nonholonomic]
        return sm.Matrix(rows) if rows else sm.Matrix()

    @property
    def kinetic_energy(self) -> Any:
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
        return self._energies.kinetic

    @property
    def potential_energy(self) -> Any:
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
        return self._energies.potential

    @potential_energy.setter
    def potential_energy(self, energy: Any) -> None:
        definition = self._definition
        others = [self._equations.time, *definition.constants, *definition.specifieds]
        others += EnergyModel(self._equations).symbols
        given = check_potential(energy, self._equations.coordinates, others)
        self._energies = self._define.energies = EnergyModel(self._equations, given)

    @property
    def outputs_symbols(self) -> list[Any]:
        """List of the names of all outputs, in the order of `evaluate_outputs`.

        An output may be called like a state, constant or specified. Where names are labels, in
        trajectories, tables, plots and files, it is then called ``q_output``.
        """
        return list(self._definition.outputs_given)

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
        lambda self: len(self._equations.holonomic), doc="Number of configuration constraints."
    )
    num_velocity_constraints = property(
        lambda self: len(self._equations.velocity),
        doc="Number of velocity constraints, including differentiated holonomic ones.",
    )
    num_nonholonomic_constraints = property(
        lambda self: len(self._equations.nonholonomic),
        doc="Number of motion constraints beyond the differentiated configuration constraints: a "
        "difference of ranks, whatever axes the constraints are written in.",
    )
    num_constraints = property(
        lambda self: len(self._define.residuals),
        doc="Number of holonomic and nonholonomic constraints together.",
    )

    @property
    def constants(self) -> MutableMapping[Any, Any]:
        """Dictionary of the constants' values that the user has set; all others are 1.0.

        A symbol and its name are one key: ``system.constants['m'] = 2.0`` replaces the value
        that was set by the symbol.
        """
        return Keyed(self._constants)

    @constants.setter
    def constants(self, constants: Mapping[Any, Any] | None) -> None:
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
        return Keyed(self._specifieds)

    @specifieds.setter
    def specifieds(self, specifieds: Mapping[Any, Any] | None) -> None:
        values = check_mapping("specifieds", specifieds)
        definition = self._define(self._outputs, self._forces, values)
        told: set[Any] = set()
        contradicted = self._told_again(definition, "specifieds")
        plan = checked_plan(definition, values, told, contradicted)
        check_expressions(definition, plan)
        self._specifieds, self._told = values, told

    @property
    def initial_conditions(self) -> MutableMapping[Any, Any]:
        """Dictionary of the states' values at the first time; all others are 0.0.

        A symbol and its name are one key: ``system.initial_conditions['q1'] = 2.0`` replaces the
        value that was set by the symbol.
        """
        return Keyed(self._initial_conditions)

    @initial_conditions.setter
    def initial_conditions(self, initial_conditions: Mapping[Any, Any] | None) -> None:
        values = check_mapping("initial_conditions", initial_conditions)
        definition = self._definition
        told = self._told_again(definition, "states")
        read_numbers(definition, "initial_conditions", values, told)
        self._initial_conditions = values

    def _warn_of_dropped(
        self, argument: str, before: Mapping[Any, Any], values: Mapping[Any, Any], default: float
    ) -> None:
        """Warn of values that an assignment sets back to the default; an empty one says so."""
        if self._contradicted is None or before is values:
            return
        known = Keyed({**values})
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
        return Keyed(self._outputs)

    @outputs.setter
    def outputs(self, outputs: Mapping[Any, Any] | None) -> None:
        self._set_outputs(outputs, self._forces)

    @property
    def noncontributing_forces(self) -> list[Any]:
        """List of the names of the noncontributing forces that are computed as outputs."""
        return list(self._forces)

    @noncontributing_forces.setter
    def noncontributing_forces(self, forces: Iterable[Any] | None) -> None:
        self._set_outputs(self._outputs, forces)

    @property
    def ode_solver(self) -> Callable[..., Any]:
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
        return scipy.integrate.odeint if self._ode_solver is None else self._ode_solver

    @ode_solver.setter
    def ode_solver(self, ode_solver: Callable[..., Any] | str | None) -> None:
        self._ode_solver: Callable[..., Any] | None = resolve_ode_solver(ode_solver)

    @property
    def evaluate_ode_function(self) -> Any:
        """Function that computes the derivatives; None before it is generated.

        ``help(system.evaluate_ode_function)`` shows the order of the entries of its arguments.
        """
        if not self._generated:
            return None
        return self._compiled().function(any_layout=self._ode_solver is not None)

    def generate_ode_function(self, **kwargs: Any) -> Any:
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
            ``rhs(x, t, r, p)``, also available as `evaluate_ode_function`.

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
        kwargs = checked_options(kwargs)
        made = generate(self._definition, self._eom_method, kwargs)
        if self._equations.forgotten:
            warn_of_missing_derivatives(self._now())
        function = made.function(any_layout=self._ode_solver is not None)
        self._options, self._generated = kwargs, [made]
        return function
