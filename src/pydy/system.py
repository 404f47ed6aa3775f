"""System: a multibody model with its numerical values, ready to evaluate and simulate.

This class is only the user-facing layer: it stores the values that the user sets, checks them when
they are set and again when they are used (a dictionary may have been edited in place), and passes
ordered arrays to compiled code.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, MutableMapping
from functools import partial
from operator import attrgetter
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np
import scipy
import sympy as sm

from pydy._assembly.definition import Definition
from pydy._assembly.model import CompiledModel
from pydy._assembly.specifieds import check_expressions
from pydy._checks import Keyed, check_mapping, file_of, flag, text
from pydy._mechanics.extract import extract, method_of
from pydy._names import nearest
from pydy._system.analysis import linearize, variables
from pydy._system.balance import find_equilibrium
from pydy._system.definition import Definer
from pydy._system.dependents import (
    check_dependents,
    default_dependents,
    given_values,
    latest_dependents,
    solve_dependents,
)
from pydy._system.energy import Energy, EnergyModel, check_potential
from pydy._system.ensemble_inputs import make_ensemble
from pydy._system.fits import fit
from pydy._system.forces import Multipliers, Reaction, find_multipliers, find_reaction
from pydy._system.generation import Generated, checked_options, generate
from pydy._system.inputs import (
    SymbolSet,
    base_symbols,
    check_forces,
    check_times,
    named_forces,
)
from pydy._system.numbers import read_constants, read_states
from pydy._system.orbits import find_orbit
from pydy._system.products import BLOCKS
from pydy._system.scipy_ivp import resolve_ode_solver
from pydy._system.simulation import integrate, simulate
from pydy._system.snapshot import Snapshot, checked_plan
from pydy._system.solving import native_solver
from pydy._system.summary import as_html, as_text, facts
from pydy._system.sweeps import eigenvalues, follow_equilibria
from pydy._system.values import evaluate_block, evaluate_energy, evaluate_product
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
from pydy.trajectory import Trajectory

if TYPE_CHECKING:
    from typing import Unpack

    from numpy.typing import ArrayLike

    from pydy._system.solving import EnsembleOptions
    from pydy.export import Exported, Model
    from pydy.solvers.events import Event
    from pydy.viz.scene import Scene

__all__ = ["System"]


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
        Times at which the states are computed: ascending, not negative.
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
    ) -> None:
        if equations not in (None, "graph", "method"):
            raise ValueError(f"`equations` must be 'graph' or 'method', got {equations!r}.")
        self._equations = extract(eom_method, equations)
        self._eom_method = eom_method
        self._energies = EnergyModel(self._equations)
        base = base_symbols(self._equations, constants_symbols, specifieds_symbols)
        self._define = Definer(self._equations, base)
        self._options: dict[str, Any] = {}
        self._generated: list[Generated] = []  # the latest first
        self._constants: dict[Any, Any] = {}
        self._specifieds: dict[Any, Any] = {}
        self._initial_conditions: dict[Any, Any] = {}
        self._dependent: dict[Any, float] | None = None  # initial conditions solved for last
        self._told: set[Any] = set()  # derivatives of specifieds that were warned of
        self._outputs: dict[Any, Any] = {}
        self._forces: list[Any] = []
        self._set_outputs(outputs, noncontributing_forces)
        self.specifieds = specifieds  # first: an expression may bring constants of its own
        self.constants = constants
        self.ode_solver = ode_solver
        self.initial_conditions = initial_conditions
        self.times = times

    def __repr__(self) -> str:
        return as_text(self._facts())

    def _repr_html_(self) -> str:
        return as_html(self._facts())

    def _facts(self) -> list[tuple[str, str]]:
        # The last definition that was sound: to print a System never fails.
        return facts(
            type(self._eom_method).__name__,
            self._define.latest,
            self._constants,
            self._specifieds,
            self._initial_conditions,
            self._times,
            self.ode_solver,
        )

    if not TYPE_CHECKING:  # or type checkers would let any attribute pass

        def __setattr__(self, name: str, value: Any) -> None:
            # A misspelt attribute would be set, and never read.
            if name[0] != "_" and type(self) is System and not hasattr(System, name):
                settable = [n for n, p in vars(System).items() if getattr(p, "fset", None)]
                raise AttributeError(
                    f"System has no attribute `{name}`, so it cannot be set. "
                    f"{nearest(name, settable)}",
                    name=name,
                    obj=self,
                )
            object.__setattr__(self, name, value)

    # -- the symbolic side ------------------------------------------------------------------------

    @property
    def _definition(self) -> Definition:
        # The user may have edited the dictionaries of outputs, specifieds and constants in place.
        return self._defined(self._constants)

    def _defined(self, constants: Mapping[Any, Any]) -> Definition:
        """Return the definition with these constants, which the equations need not hold."""
        definition = self._define(self._outputs, self._forces, self._specifieds)
        return self._define.holding(definition, constants, lambda: self._energies.symbols)

    def _compiled(self, definition: Definition | None = None) -> Generated:
        """Return what is generated for a definition, by default the present one."""
        definition = self._definition if definition is None else definition
        for made in self._generated:
            if made.definition is definition or made.definition == definition:
                return made
        made = generate(definition, self._eom_method, self._options)
        self._generated = [made, *self._generated[:1]]
        return made

    def _now(self, events: Any = None, constants: Any = None) -> Snapshot:
        """Return everything as it is now: each public call takes one and works on that.

        What the call is given may bring constants that the equations do not hold.
        """
        found = [] if events is None else self._define.constants_of(self._definition, events)
        more = constants if isinstance(constants, Mapping) else {}
        definition = self._defined({**self._constants, **more} if more else self._constants)
        made = self._compiled(self._define.widened(definition, found))
        user = {
            "constants": dict(self._constants),
            "specifieds": dict(self._specifieds),
            "initial_conditions": dict(self._initial_conditions),
        }
        return Snapshot(made.definition, made.model, user, self._times, self._energies, self._told)

    def _set_outputs(self, outputs: Any, forces: Any) -> None:
        names = check_forces(self._equations, named_forces(self._equations, forces))
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
        return self._compiled().model

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
        """List of the states in the order of all arrays: coordinates, speeds, auxiliaries."""
        return list(self._definition.states)

    @property
    def constants_symbols(self) -> SymbolSet:
        """Set of the constants: symbols of the equations and outputs that are not functions.

        Symbols that cancel from the equations but stand in energies or positions, and those of the
        events of earlier calls, are constants too as soon as `constants` gives them a value.
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
        distance alone; and loads whose work is a closed form that SymPy integrates along the
        coordinates, such as those of springs, -K sin 2q, or a Piecewise contact. Parts of loads
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
        self._energies = EnergyModel(self._equations, given)

    @property
    def constraint_forces(self) -> Multipliers:
        """Multipliers of the constraints: a dictionary that maps symbols to expressions.

        ``lambda0`` belongs to the first row of `constraints`, and so on. The multiplier lambda of a
        row c adds lambda ∂c'/∂u to the equation of each speed u: a force in the direction in which
        c increases. Its unit times that of c is the unit of work (holonomic) or of power
        (nonholonomic). A row whose rate is not implied by any velocity constraint, such as the norm
        of a quaternion, has no multiplier.

        The expressions depend on states, derivatives of the speeds, constants and specifieds. They
        can be used in outputs, events and scenes; ``system.outputs = system.constraint_forces``
        makes each an output with its own name. Names can be used as keys.

        Raises
        ------
        ValueError
            The method knows no bodies.

        Examples
        --------
        The tension of a string is minus the multiplier of its length:

        >>> import sympy as sm
        >>> import sympy.physics.mechanics as me
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
        return find_multipliers(self._equations)

    def reaction(
        self, bodies: Any, point: Any = None, *, frame: Any = None, loads: Iterable[Any] = ()
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
            with one of the bodies and with no body outside, nor with the ground. The list may also
            contain hinges, and massless points and frames whose loads are to be included.
        point : Point
            Where the force acts, and about which the torque is taken; by default the joint's own
            point.
        frame : ReferenceFrame, optional
            Frame of the components; by default the inertial frame.
        loads : iterable of loads, optional
            Other loads that act on these bodies from outside, not at `point`: the reaction of
            another joint or contact, from multipliers or from another call. Pairs of a Point and a
            force, or of a ReferenceFrame and a torque.

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
        >>> system.evaluate_outputs([0.0, 0.0, 0.0, 0.0]).round(12)[:2]
        array([ 0., 30.])
        """
        return find_reaction(self._equations, bodies, point, frame, loads)

    @property
    def outputs_symbols(self) -> list[Any]:
        """List of the names of all outputs, in the order of `evaluate_outputs`."""
        return list(self._definition.outputs_symbols)

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

    # -- the numbers ------------------------------------------------------------------------------

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
        if not definition.places["constants"].fits(values):
            read_constants(definition, values)
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
        check_expressions(definition, checked_plan(definition, values, told))
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
        read_states(self._definition, values)
        self._initial_conditions = values

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

    # -- generation -------------------------------------------------------------------------------

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
        function = made.function(any_layout=self._ode_solver is not None)
        self._options, self._generated = kwargs, [made]
        return function

    # -- evaluation -------------------------------------------------------------------------------

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
        return evaluate_block(self._now(), "rates", x, t, r, p)

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
        return evaluate_block(self._now(), "outputs", x, t, r, p)

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
        return evaluate_energy(self._now(constants=p), x, t, r, p)

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
        """
        self._need(self.num_constraints, "constraints")
        return evaluate_block(self._now(), "constraints", x, t, r, p)

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
        return evaluate_block(self._now(), "holonomic", x, t, r, p)

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
        return evaluate_block(self._now(), "velocity", x, t, r, p)

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
            return evaluate_block(self._now(), BLOCKS[of], x, t, r, p, by)
        return evaluate_product(self._now(), "jacobian", of, wrt, None, x, t, r, p)

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
        out = evaluate_product(self._now(), "gradient", of, wrt, None, x, t, r, p)
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
        return evaluate_product(self._now(), "jacobian-vector", of, wrt, v, x, t, r, p)

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
        return evaluate_product(self._now(), "vector-jacobian", of, wrt, v, x, t, r, p)

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
        return evaluate_product(self._now(), "hessian-vector", of, wrt, v, x, t, r, p)

    def find_equilibrium(
        self,
        unknowns: Iterable[Any] | None = None,
        given: dict[Any, float] | None = None,
        *,
        moving: Iterable[Any] = (),
        bounds: dict[Any, Any] | None = None,
    ) -> Equilibrium:
        """Find a state in which the system remains at rest or moves steadily.

        All other values are those of the System; the search starts from its initial conditions.

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
            its path.
        bounds : dict, optional
            Maps unknowns to pairs of the lowest and the highest value.

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
        return find_equilibrium(self._now(), unknowns, given, moving, bounds)

    def linearize(
        self,
        at: Any = None,
        t: Any = None,
        *,
        inputs: Iterable[Any] | None = None,
        outputs: Iterable[Any] | None = None,
    ) -> LinearModel:
        """Return the linear model of small motions that satisfy the constraints.

        Parameters
        ----------
        at : array_like, shape (n,) or (m, n), dict or Equilibrium, optional
            States; the initial conditions by default. For several states, such as along a
            trajectory, each matrix has an additional first axis. A dictionary replaces some of the
            initial conditions, by symbol or name. An Equilibrium also provides the constants and
            specifieds that were found or given.
        t : float or array_like, shape (m,), optional
            As in `evaluate_ode`.
        inputs : iterable of specifieds or names, optional
            All by default. If a specified is given as an expression or a function, the input is an
            addition to its value, and its feedback is part of A. Functions are differentiated
            numerically.
        outputs : iterable of states, outputs or names, optional
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
            A state does not satisfy the constraints.

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
        return linearize(self._now(), at, t, inputs, outputs)

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
            The user interrupted it; the error holds the sweep over the first values.
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
        return eigenvalues(self._now(), over, at, unknowns, given, moving, progress)

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
            The user interrupted it; the error holds the branch so far.
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
        return follow_equilibria(self._now(), over, unknowns, given, moving, step, most, progress)

    def fit(
        self,
        parameters: Iterable[Any],
        trials: Trial | Iterable[Trial],
        *,
        bounds: dict[Any, Any] | None = None,
        priors: dict[Any, Any] | None = None,
        segments: int = 1,
        most: int = 100,
        progress: bool = False,
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
            Maps parameters to pairs of the lowest and the highest value.
        priors : dict, optional
            Maps parameters to pairs of the mean and the standard deviation of prior knowledge.
        segments : int, optional
            Number of segments into which each trial is divided. Each has its own initial state, and
            all must meet in the end: multiple shooting, for long or unstable motions.
        most : int, optional
            The maximum number of evaluations.
        progress : bool, optional
            Show a progress bar; requires tqdm.
        **solver_kwargs
            Options of the native solver (``'dop853'`` if `ode_solver` is not native); `rtol` and
            `atol` are 1e-9 by default.

        Returns
        -------
        FitResult

        Raises
        ------
        ValueError, TypeError
            The system has no such parameter, a specified has no derivatives, or the data are not
            valid.
        FitInterrupted
            The user pressed Ctrl-C; the exception contains the best estimates so far.

        Warns
        -----
        PyDyUserWarning
            The data do not determine some combinations of parameters, a parameter is at a bound, or
            the search did not converge.

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
        return fit(
            self, parameters, trials, bounds, priors, segments, most, progress, solver_kwargs
        )

    def adjoint_gradient(
        self,
        wrt: Any,
        *,
        final: Any = None,
        integral: Any = None,
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
        IntegrationInterrupted
            The user interrupted it; the error holds the motion so far, or all of it if it was
            interrupted on the way back.

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
        from pydy._system.adjoints import adjoint_gradient  # with the loops behind the solvers

        now = self._now(solver_kwargs.get("events"))
        dependent = latest_dependents(now.definition, self._dependent)
        return adjoint_gradient(
            now, self.ode_solver, wrt, final, integral, solver_kwargs, dependent
        )

    def find_periodic_orbit(
        self,
        period: float,
        *,
        moving: Iterable[Any] = (),
        until: Event | None = None,
        progress: bool = False,
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
        until : Event, optional
            The period ends when this happens, after its reset: the impact of a walker's foot, say.
        progress : bool, optional
            Whether to show a progress bar, with the remaining gap; requires tqdm.
        **solver_kwargs
            Options of the native solver (``'dop853'`` if `ode_solver` is not native); `rtol` and
            `atol` are 1e-12 by default. Constraints are enforced by projection.

        Returns
        -------
        PeriodicOrbit

        Raises
        ------
        PeriodicOrbitError
            No periodic orbit was found; the message says how close the search came.
        AnalysisInterrupted
            The user interrupted it; the error holds the motion that came nearest to an orbit.

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
        return find_orbit(self, self._now(), period, moving, until, progress, solver_kwargs)

    # -- simulation -------------------------------------------------------------------------------

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
        now, own = self._now(), self._definition.places["states"]
        # A new dictionary: the old one may be the caller's own. Its keys may be names.
        conditions, latest = dict(self._initial_conditions), self._dependent or {}
        keys = {own.symbols[own.find(key, "initial_conditions")]: key for key in conditions}
        given: dict[Any, float] = {}
        if dep_vars is None:
            given = given_values(now, keys, latest)
            dep_vars = default_dependents(now, given)
        places = check_dependents(self._definition, dep_vars)
        x = solve_dependents(now, places, given, flag(use_jac, "`use_jac`"), root_kwargs)
        solved = {own.symbols[k]: float(x[k]) for part in places for k in part}
        self._initial_conditions = conditions | {keys.get(s, s): v for s, v in solved.items()}
        self._dependent = solved

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
            The solver, odeint or a native one, could not continue; the error contains the results
            so far. With ``full_output=True``, the result of odeint is returned unchanged.

        Warns
        -----
        PyDyUserWarning
            The initial conditions violate the constraints by more than rounding to six digits
            explains, and `constraints` is not set.
        """
        now = self._now(solver_kwargs.get("events"))
        return integrate(now, self.ode_solver, solver_kwargs)

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
            Whether the step-size control of a native solver includes the sensitivities; by default
            it considers only the states.
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
        wanted = (sensitivities, control_sensitivities, self._dependent)
        now = self._now(solver_kwargs.get("events"))
        return simulate(now, self.ode_solver, solver_kwargs, wanted)

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
            Path of a Zarr store, to which every finished block is written immediately.
        resume : bool or str, optional
            Whether `store` may exist; only its missing blocks are then computed. The functions in
            `reduce` and `specifieds` must be those of the first call: they are compared by their
            code and everything they use. If `resume` is a string, the strings are compared instead:
            it is your name for the functions, which you pass from the first call on and change when
            the functions change.
        workers : int, optional
            Number of threads; by default one for each processor.
        progress : bool, optional
            Whether to show a progress bar; requires tqdm.
        units : dict of symbols or names to str, optional
            Values of the attribute ``units`` of the variables.
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

        Notes
        -----
        Trajectories are integrated one by one, by the same solvers, if specifieds are Python
        functions, with `control_sensitivities`, sensitivities with respect to samples, `events` or
        ``constraints='project'``, and with 'radau'.

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
        product, progress = flag(product, "`product`"), flag(progress, "`progress`")
        if not (isinstance(resume, str) and resume):
            resume = flag(resume, "`resume`, unless it is a name for functions,")
        ensemble = make_ensemble(
            self._now(solver_kwargs.get("events"), constants),
            (initial_conditions, constants, specifieds),
            times,
            native_solver(self._ode_solver) if ode_solver is None else ode_solver,
            solver_kwargs,
            product=product,
            chunks=chunks,
            reduce=reduce,
            workers=workers,
            progress=progress,
            units=units,
            sensitivities=(sensitivities, control_sensitivities, self._dependent),
        )
        if store is not None:
            return ensemble.into(store, resume)
        if resume:
            raise ValueError("`resume=True` needs `store`, the Zarr store to resume.")
        return ensemble.run() if chunks is None else ensemble.lazy()

    # -- export -----------------------------------------------------------------------------------

    def export(
        self,
        path: Any,
        *,
        name: str | None = None,
        events: Any = None,
        inputs: Iterable[Any] = (),
        **options: Any,
    ) -> Exported:
        """Write the system as code for another program: C, an FMU, JavaScript or Python.

        Parameters
        ----------
        path : path
            The suffix selects the format: ``.c`` (C99, with a header beside it), ``.fmu`` (a
            functional mock-up unit for Model Exchange and Co-Simulation), ``.js`` (an ECMAScript
            module) or ``.py`` (functions that need only NumPy or JAX).
        name : str, optional
            Name of the model; by default the stem of the file.
        events : Event or sequence of Event, optional
            Events to export with their resets; event indicators in an FMU.
        inputs : iterable of specifieds, optional
            Specifieds given by a function or by samples that become inputs.
        **options
            ``fmi`` ('3.0' or '2.0') and ``binary`` (False omits the compiled library) for
            ``.fmu``; ``target`` ('numpy' or 'jax') for ``.py``.

        Returns
        -------
        Exported
            ``path``, ``files``, and ``names``, the identifiers of names that are not valid ones.

        Raises
        ------
        ValueError
            Unknown suffix, or a specified given by a function or by samples.
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
        from pydy.export.writing import check_options, write

        target = file_of(path, "`path`")
        check_options(target, options)
        title = target.stem if name is None else text(name, "`name`")
        model = self._exportable(name=title, events=events, inputs=inputs)
        return write(model, target, **options)

    def _exportable(self, **options: Any) -> Model:
        """Return the Programs, names and numbers of what is exported."""
        from pydy._system.exporting import export_model

        now = self._now(options.get("events"))
        numbers = now.x, now.p, now.times
        return export_model(now.definition, now.model, now.plan, numbers, **options)

    def _motion(self, times: Any, states: Any) -> Trajectory:
        """Return a trajectory of checked arrays."""
        return self._now().motion(times, states)

    def _live_system(self, **options: Any) -> Any:
        """Return what a page that simulates needs."""
        from pydy._system.exporting import live_system

        now = self._now()
        numbers = now.x, now.p, now.times
        return live_system(now.definition, now.model, now.plan, numbers, self._dependent, **options)

    # -- animation --------------------------------------------------------------------------------

    def scene(
        self, *visuals: Any, reference_frame: Any = None, origin: Any = None, **options: Any
    ) -> Scene:
        """Return a scene of the system, which can be animated and written as an HTML page.

        Parameters
        ----------
        *visuals : pydy.viz.Visual, RigidBody or Particle
            By default all bodies of the method (a solid with the same inertia for each RigidBody,
            a ball for each Particle), and lines between points that were located from each other.
        reference_frame : ReferenceFrame, optional
            By default the inertial frame.
        origin : Point, optional
            By default a point at rest in that frame, connected with the bodies.
        **options
            `loads`: whether to show forces and torques as arrows. Options of `pydy.viz.Scene`:
            `up` (by default against gravity), `ground`, `follow`, `view`, `series`, `units` and
            `title`.

        Returns
        -------
        pydy.viz.Scene

        Raises
        ------
        ValueError
            There are no bodies to show, or no point that can be the origin.

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
        from pydy._system.scene import make_scene

        definition = self._definition
        constants = read_constants(definition, self._constants)
        return make_scene(
            definition,
            dict(zip(definition.constants, constants.tolist(), strict=True)),
            partial(attrgetter("model.assembly"), self),
            visuals,
            reference_frame,
            origin,
            options,
            partial(attrgetter("_times"), self),
            self._motion,
            self._live_system,
        )

    def plot(self, names: list[Any] | None = None, **options: Any) -> Any:
        """Simulate, and plot the states or selected quantities over time.

        Equivalent to ``system.simulate().plot(...)``; see `pydy.trajectory.Trajectory.plot`. For
        several plots, keep the trajectory and use its own method.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.initial_conditions = {'x0': 1.0}
        >>> system.times = [0.0, 0.5, 1.0]
        >>> system.plot(['x0']).get_ylabel()
        'value'
        """
        return self.simulate().plot(names, **options)

    def animate(self, *visuals: Any, **options: Any) -> Scene:
        """Simulate, and return an animated scene, which a notebook displays.

        Equivalent to ``system.scene(...).animate(system.simulate())``, with the arguments of
        `scene`.
        """
        return self.scene(*visuals, **options).animate(self.simulate())
