"""System: a multibody model with its numbers, ready to evaluate and to simulate.

The class here is the friendly layer only: it keeps what the user set, checks it when it is set and
again when it is used (a dictionary may have been edited in place), and hands ordered arrays to
compiled code.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np
import sympy as sm
from scipy.integrate import odeint

from pydy._assembly.definition import Definition
from pydy._assembly.model import CompiledModel
from pydy._assembly.specifieds import check_expressions
from pydy._checks import check_mapping, file_of, flag, text
from pydy._mechanics.extract import extract, method_of
from pydy._names import nearest
from pydy._system.analysis import linearize, variables
from pydy._system.balance import find_equilibrium
from pydy._system.definition import Definer
from pydy._system.dependents import check_dependents, latest_dependents, solve_dependents
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
    """A multibody system: its equations of motion and the numbers to evaluate them with.

    All arguments but `eom_method` are attributes too and can be changed at any time.

    Parameters
    ----------
    eom_method : KanesMethod, LagrangesMethod or System of sympy.physics.mechanics, or Definition
        A KanesMethod either with ``kanes_equations()`` called, or with bodies and loads, from which
        the equations of motion are then formed, in a fraction of the time. Those of a
        LagrangesMethod are formed from its Lagrangian and its constraints; its speeds are the
        derivatives of the coordinates. A System of SymPy, before or after
        ``form_eoms()``, is read with its joints; `pydy.mechanics.Definition` has the same content
        without a method object.
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
        When the states are wanted: ascending, not negative.
    outputs : dict, optional
        Maps names to expressions that are evaluated beside the equations. See `outputs`.
    noncontributing_forces : iterable of functions of time, optional
        Names, in the KanesMethod's loads, of the forces that its auxiliary speeds bring into
        evidence; they are then computed as outputs.
    constants_symbols : iterable of Symbol, optional
        Skips the search for constants in the equations.
    specifieds_symbols : iterable of functions of time, optional
        Skips the search for specifieds in the equations.
    equations : {'graph', 'method'}, optional
        Where the equations of motion come from: formed from the bodies and loads, or from the
        Lagrangian; or those that ``kanes_equations()`` or ``form_lagranges_equations()`` derived.
        By default they are formed. Where a KanesMethod has derived its own, those are used if the
        formed ones give other numbers or take no fewer operations.

    Raises
    ------
    TypeError
        `eom_method` is none of these.
    ValueError
        A value or a symbol does not fit; the message names the argument.

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
        self._generated: Generated | None = None
        self._constants: dict[Any, Any] = {}
        self._specifieds: dict[Any, Any] = {}
        self._initial_conditions: dict[Any, Any] = {}
        self._dependent: tuple[Any, ...] | None = None  # initial conditions solved for last
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
            self._ode_solver,
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
        # The user may have edited the dictionaries of outputs and specifieds in place.
        return self._define(self._outputs, self._forces, self._specifieds)

    def _compiled(self) -> Generated:
        """Return what is generated for the definition as it is now."""
        definition, made = self._definition, self._generated
        if made is None or (made.definition is not definition and made.definition != definition):
            made = self._generated = generate(definition, self._eom_method, self._options)
        return made

    def _now(self) -> Snapshot:
        """Return everything as it is now: each public call takes one and works on that."""
        made = self._compiled()
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
        """What the definition compiles to, to look inside: arrays' layout, blocks, machine code.

        ``print(system.model)`` tells what is compiled so far, ``system.model.assembly`` holds the
        equations as a graph. It is not changed by what is set later: there is then another one.

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
        """The KanesMethod that the equations come from. Read-only."""
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
        """Set of the constants: symbols of the equations and outputs that are not functions."""
        return SymbolSet(self._definition.constants)

    @property
    def specifieds_symbols(self) -> SymbolSet:
        """Set of the specifieds: functions of time that are not given by the equations."""
        return SymbolSet(self._definition.specifieds)

    @property
    def constraints(self) -> Any:
        """Column matrix of the holonomic, then the nonholonomic constraint expressions."""
        rows = [*self._equations.holonomic, *self._equations.nonholonomic]
        return sm.Matrix(rows) if rows else sm.Matrix()

    @property
    def kinetic_energy(self) -> Any:
        """The kinetic energy of the method's bodies: an expression in states and symbols.

        It is not simplified. Auxiliary speeds are zero in it.

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
        """The potential energy: an expression in coordinates, constants, specifieds and time.

        It is found from the loads: forces that are constant in the inertial frame, such as gravity;
        equal and opposite forces along the line between two points that depend on their distance
        alone; and loads whose work is a closed form that SymPy integrates along the coordinates,
        such as those of springs, -K sin 2q, or a Piecewise contact.
        Parts of loads that depend on speeds, time or specifieds (dampers, motors) have none: what
        they do changes the total energy. Where a load depends on the configuration in another
        way, the bodies' own `potential_energy` is taken if the power of the loads agrees with it.

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
        given = check_potential(energy, self._equations.coordinates, others)
        self._energies = EnergyModel(self._equations, given)

    @property
    def constraint_forces(self) -> Multipliers:
        """Multipliers of the constraints: a dictionary of symbols to expressions.

        ``lambda0`` belongs to the first row of `constraints`, and so on. With a row c, its
        multiplier adds lambda ∂c'/∂u to the equation of each speed u: a force in the direction in
        which c grows. Its unit times that of c is that of work (holonomic), or of power
        (nonholonomic). A row whose rate no velocity constraint implies, such as the norm of a
        quaternion, has no multiplier.

        The expressions depend on states, derivatives of the speeds, constants and specifieds.
        They may be written into outputs, events and scenes; outputs of their names are
        ``system.outputs = system.constraint_forces``. Keys may be names.

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
        """Return the force and torque that hold some bodies: of a joint, a bearing, a contact.

        They are what Newton's and Euler's laws ask for beyond the loads on these bodies: the
        resultant, about a point, of all that acts on them from outside, without the loads.

        Parameters
        ----------
        bodies : RigidBody, Particle, str, or list of them, or Joint
            All bodies on one side of the cut; those beyond a joint, for its reaction on them. A
            joint of a `sympy.physics.mechanics.System`, or its name, stands for its child and all
            beyond. A load is counted if the point or the frame it acts on moves with one of them,
            and with no body outside. Massless points and frames whose loads are to be counted, and
            hinges, may be in the list too.
        point : Point
            Where the force acts, and about which the torque is taken; by default a joint's own.
        frame : ReferenceFrame, optional
            For the components; the inertial one by default.
        loads : iterable of loads, optional
            What else acts on these bodies from outside, elsewhere than at `point`: the reaction of
            another joint or contact, from multipliers or from another call. Pairs of a Point and a
            force, or of a ReferenceFrame and a torque.

        Returns
        -------
        Reaction
            ``force`` and ``torque``, SymPy vectors, to be projected, added, drawn as arrows; its
            method ``outputs(name)`` gives the six components for `outputs`.

        Raises
        ------
        TypeError, ValueError
            An argument does not fit, a position is not known, the method knows no bodies, or it is
            a LagrangesMethod: a Lagrangian does not tell what acts on which body.

        Notes
        -----
        Masses and inertias on which the motion does not depend may occur, such as the products of
        inertia that a RigidBody names itself. They are then constants of the System, 1.0 by
        default as all others: set them.

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
        doc="Number of motion constraints, differentiated holonomic ones included.",
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
    def constants(self) -> dict[Any, Any]:
        """Dictionary of the constants' values, as the user gave them; all others are 1.0."""
        return self._constants

    @constants.setter
    def constants(self, constants: Mapping[Any, Any] | None) -> None:
        values = check_mapping("constants", constants)
        definition = self._definition
        if not definition.places["constants"].fits(values):
            read_constants(definition, values)
        self.__dict__["_constants"] = values  # by itself, as a short call

    @property
    def specifieds(self) -> dict[Any, Any]:
        """Dictionary of the specifieds' values; all others are 0.0.

        In the first format keys are specifieds or tuples of them, values are numbers, arrays,
        functions ``g(x, t)`` of the state and time that return numbers or arrays, SymPy expressions
        of states, time, constants and other specifieds, or `pydy.inputs.SampledInput`::

            system.specifieds = {(a, b): np.ones(2), c: lambda x, t: -3.0*x[0], d: -k*q + sin(t)}

        One number for a tuple holds for each. Expressions are compiled into the code. Symbols that
        occur only in them become constants of the system, functions of time specifieds. Where the
        equations hold derivatives of a function of time, they follow from its expression; with any
        other value they need values of their own.

        In the second, which is faster with functions, all are given together::

            system.specifieds = {'symbols': (a, b, c), 'values': lambda x, t: np.ones(3)}

        The order of ``'symbols'`` is the order of r in the generated function.
        """
        return self._specifieds

    @specifieds.setter
    def specifieds(self, specifieds: Mapping[Any, Any] | None) -> None:
        values = check_mapping("specifieds", specifieds)
        definition = self._define(self._outputs, self._forces, values)
        told: set[Any] = set()
        check_expressions(definition, checked_plan(definition, values, told))
        self._specifieds, self._told = values, told

    @property
    def initial_conditions(self) -> dict[Any, Any]:
        """Dictionary of the states' values at the first time; all others are 0.0."""
        return self._initial_conditions

    @initial_conditions.setter
    def initial_conditions(self, initial_conditions: Mapping[Any, Any] | None) -> None:
        values = check_mapping("initial_conditions", initial_conditions)
        read_states(self._definition, values)
        self._initial_conditions = values

    @property
    def times(self) -> np.ndarray:
        """Array of the times at which the states are wanted, shape (n,)."""
        return self._times

    @times.setter
    def times(self, times: ArrayLike | None) -> None:
        self._times = check_times(times)

    @property
    def outputs(self) -> dict[Any, Any]:
        """Dictionary of what is evaluated beside the equations.

        Keys are names (symbols or functions of time) or tuples of names; values are as many
        expressions. Three forms are possible::

            outputs[p] = k*x                                    a function of the states
            outputs[(f1, f2)] = (k*x, c*v)                      several
            outputs[(m1, m2)] = (m1 - 4*m2 + k*v.diff(t) + 2,   linear equations, zero when
                                 m1 + 3*m2 - w.diff(t))         satisfied

        Expressions may contain the derivatives of the speeds. Equations that contain their own
        names and such derivatives make each name's time integral an auxiliary state. The residuals
        of the constraints, and the noncontributing forces when they are named, follow the user's
        own outputs.
        """
        return self._outputs

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
        """Function that integrates, with the signature of `scipy.integrate.odeint`.

        It may be set to ``'odeint'`` or ``'lsoda'``, the default; to the name of a native solver,
        such as ``'dop853'`` for `pydy.solvers.dop853`; or to `scipy.integrate.solve_ivp` or the
        name of one of its methods: ``'RK45'``, ``'RK23'``, ``'DOP853'``, ``'Radau'``, ``'BDF'``,
        ``'LSODA'``. Upper case counts: ``'DOP853'`` is SciPy's, ``'dop853'`` the native one.
        Tolerances that you do not give are the solver's own; those of ``solve_ivp`` are coarse.

        ``x_history = ode_solver(f, x0, t, args=(r, p), **options)`` with ``f(x, t, r, p)``, which
        returns the derivatives as a fresh array.

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
        return self._ode_solver

    @ode_solver.setter
    def ode_solver(self, ode_solver: Callable[..., Any] | str | None) -> None:
        self._ode_solver: Callable[..., Any] = resolve_ode_solver(ode_solver)

    # -- generation -------------------------------------------------------------------------------

    @property
    def evaluate_ode_function(self) -> Any:
        """Function that computes the derivatives, or None before it has been generated.

        See ``help(system.evaluate_ode_function)`` for the order of its arguments' entries.
        """
        if self._generated is None:
            return None
        return self._compiled().function(any_layout=self._ode_solver is not odeint)

    def generate_ode_function(self, **kwargs: Any) -> Any:
        """Generate the function that evaluates the derivatives, and keep it.

        Parameters
        ----------
        **kwargs
            Options of `pydy.codegen.ode_function_generators.generate_ode_function`:
            `linear_sys_solver`, `constants_arg_type`, `specifieds_arg_type`, `time_first`,
            `generator` and the generator's own. They are kept for later generations.

        Returns
        -------
        function
            ``rhs(x, t, r, p)``, also available as `evaluate_ode_function`.

        Raises
        ------
        TypeError
            An option that the System decides itself.
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
        function = made.function(any_layout=self._ode_solver is not odeint)
        self._options, self._generated = kwargs, made
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
            Time; by default the first of `times`, or all of them for m states, or zero.
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
            Shapes that do not fit.
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
            The method knows no bodies, or the potential energy is not known; see
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
        return evaluate_energy(self._now(), x, t, r, p)

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
        """Return exact partial derivatives, from differentiating the expression graph.

        Where a specified is given as an expression, derivatives by states and constants go through
        it; those by specifieds are by a small addition to each one's value. Functions, samples and
        numbers, and an `r` that gives all specifieds, are held.

        Parameters
        ----------
        x, t, r, p
            As in `evaluate_ode`.
        wrt : {'states', 'specifieds', 'constants'}, symbol or name, or a list, optional
            With respect to what, in the order of the arrays x, r and p; a list may hold states,
            specifieds, constants and groups of these together.
        of : {'ode', 'outputs', 'holonomic', 'velocity'}, output, expression, or list, optional
            Of the state derivatives, all outputs, the residuals of constraints, or of any outputs
            and expressions of states, specifieds and constants.

        Returns
        -------
        ndarray, shape (o, k) or (m, o, k)
            A column for each variable, also for a single one.

        Raises
        ------
        ValueError
            An option that is none of the above, or a name that is none of the system's.

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

        It costs a small multiple of the quantity itself, however many variables there are.

        Parameters
        ----------
        of : output or expression
            An output, by symbol or name, or an expression of states, specifieds and constants.
        x, t, wrt, r, p
            As in `evaluate_jacobian`.
        value : bool, optional
            Return the quantity too; it is computed on the way.

        Returns
        -------
        ndarray, shape (k,) or (m, k)
            With `value`, a tuple of the quantity, a float or of shape (m,), and its gradient.

        Raises
        ------
        ValueError
            A name or symbol is none of the system's.

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
            A direction with a component for each variable of `wrt`, or d of them as columns. For
            several states also (m, k) or (m, k, d).
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
            A weight for each row of `of`, or d sets of them as columns. For several states also
            (m, o) or (m, o, d).
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
        """Find a state in which the system stays, or moves on steadily.

        Numbers that are neither unknown nor given are those of the System; the search starts from
        its initial conditions.

        Parameters
        ----------
        unknowns : iterable of symbols or names, optional
            States, constants and specifieds to solve for; by default all coordinates and speeds
            that are neither given nor moving.
        given : dict, optional
            Values of other states, constants and specifieds for this search.
        moving : iterable of coordinates, optional
            Those that may change steadily, such as the position of a vehicle along its way.
        bounds : dict, optional
            Pairs of the lowest and the highest value of unknowns.

        Returns
        -------
        Equilibrium
            `initial_conditions` and the like fit the System's attributes of those names.

        Raises
        ------
        EquilibriumError
            None was found; the message tells how near the search came and which rows are left.
        ValueError
            A name is none of the system's.

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
        """Return the linear model of small motions that keep the constraints.

        Parameters
        ----------
        at : array_like, shape (n,) or (m, n), or dict, optional
            States; the initial conditions by default. With several, such as along a trajectory,
            each matrix has a first axis for them. A dictionary gives some of the initial conditions
            instead, by symbol or name.
        t : float or array_like, shape (m,), optional
            As in `evaluate_ode`.
        inputs : iterable of specifieds or names, optional
            All by default. Where one is given as an expression or as a function, the input is an
            addition to it: feedback is part of A. Functions are differentiated numerically.
        outputs : iterable of states, outputs or names, optional
            All states by default.

        Returns
        -------
        LinearModel

        Raises
        ------
        ValueError
            A name is none of the system's, the configuration is singular, or the equations are not
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
    ) -> EigenvalueSweep:
        """Return the eigenvalues of the linear models along a parameter, in branches.

        At each value of the parameter the equilibrium is found that the one before leads to, and
        the motions near it that keep the constraints are linearised.

        Parameters
        ----------
        over : dict
            One state, constant or specified, by symbol or name, and its values, ascending or
            descending.
        at : array_like, shape (n,) or (m, n), or dict, optional
            States to linearise at as they are, instead of equilibria; one, or one for each value.
        unknowns, given, moving
            As in `find_equilibrium`.

        Returns
        -------
        EigenvalueSweep

        Raises
        ------
        EquilibriumError
            There is no equilibrium at a value of the parameter.
        ValueError
            A name is none of the system's, or the values are not in order.

        Examples
        --------
        >>> import numpy as np
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> sweep = system.eigenvalues({'c0': np.linspace(-1.0, 3.0, num=9)})
        >>> [(round(c.value, 9), c.eigenvalue, c.oscillatory) for c in sweep.crossings()]
        [(0.0, 1j, True)]
        """
        return eigenvalues(self._now(), over, at, unknowns, given, moving)

    def follow_equilibria(
        self,
        over: dict[Any, Any],
        unknowns: Iterable[Any] | None = None,
        given: dict[Any, float] | None = None,
        *,
        moving: Iterable[Any] = (),
        step: float = 0.02,
        most: int = 500,
    ) -> EquilibriumBranch:
        """Follow equilibria along a parameter, around folds, and notice bifurcations.

        Parameters
        ----------
        over : dict
            One state, constant or specified, and where to begin and where to end: a list of the
            first and the last value. An equilibrium is found at the first.
        unknowns, given, moving
            As in `find_equilibrium`.
        step : float, optional
            The longest step along the branch, as a share of the parameter's range.
        most : int, optional
            The most points.

        Returns
        -------
        EquilibriumBranch
            It ends where the parameter leaves its range, or the branch comes back to its beginning.

        Raises
        ------
        EquilibriumError
            There is none at the first value.
        ValueError
            A name is none of the system's.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> (point,) = system.follow_equilibria({'c0': [1.0, -1.0]}).special
        >>> point.kind, abs(round(point.value, 9)), round(point.frequency, 9)
        ('Hopf', 0.0, 1.0)
        """
        return follow_equilibria(self._now(), over, unknowns, given, moving, step, most)

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

        The search starts from the System's numbers; what is no parameter keeps them.

        Parameters
        ----------
        parameters : symbol, name, or iterable of these
            Constants, those in expressions for specifieds too, specifieds that are numbers, and
            states for their initial conditions; all trials share them. Initial conditions of single
            trials are named in `Trial.unknown`.
        trials : Trial or iterable of Trial
            The measurements.
        bounds : dict, optional
            Pairs of the lowest and the highest value of parameters.
        priors : dict, optional
            Pairs of the mean and the standard deviation of what is known of parameters beforehand.
        segments : int, optional
            Into how many pieces each trial is cut, with states of their own that have to meet in
            the end: multiple shooting, for long or unstable motions.
        most : int, optional
            The most evaluations.
        progress : bool, optional
            Show a bar; needs tqdm.
        **solver_kwargs
            Options of the native solver, ``'dop853'`` where `ode_solver` is none; `rtol` and `atol`
            are 1e-9 by default.

        Returns
        -------
        FitResult

        Raises
        ------
        ValueError, TypeError
            A parameter that the system does not have, a specified without derivatives, or data
            that do not fit.
        FitInterrupted
            Ctrl-C; it hands over the best estimates so far.

        Warns
        -----
        PyDyUserWarning
            The data leave combinations of parameters undetermined, a bound holds a parameter, or
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
        """Return a scalar of a simulation and its derivatives by any number of parameters.

        The scalar is the value of an expression at the end of the motion, an integral along it, or
        the sum of both. The motion is integrated once, then the adjoint of its steps goes back
        through them: the cost hardly depends on how many parameters there are. Few parameters, or
        many quantities, take `simulate` with `sensitivities`.

        Parameters
        ----------
        wrt : {'constants', 'states', 'specifieds'}, symbol, name, or iterable of these
            Constants; states, for their initial conditions; specifieds that are numbers or samples.
        final : output or expression, optional
            Of states, specifieds, constants and time at the last of the times, or after a terminal
            event, whose time depends on the parameters too.
        integral : output or expression, optional
            Integrated from the first time to the end, as a further state under the error control.
        **solver_kwargs
            Options of an explicit native solver, ``'dop853'`` where `ode_solver` is none; `events`,
            `constraints` and `gain` as in `integrate`.

        Returns
        -------
        AdjointGradient

        Raises
        ------
        ValueError
            A parameter that the system does not have, a specified that is a Python function, or a
            solver that is not explicit.
        SingularMatrixError, IntegrationError
            As `integrate`; also where an event that acts is only grazed.

        Examples
        --------
        How far a mass on a spring gets in a second:

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

        dependent = latest_dependents(self)
        return adjoint_gradient(
            self._now(), self._ode_solver, wrt, final, integral, solver_kwargs, dependent
        )

    def find_periodic_orbit(
        self,
        period: float,
        *,
        moving: Iterable[Any] = (),
        until: Event | None = None,
        **solver_kwargs: Any,
    ) -> PeriodicOrbit:
        """Find a motion that repeats itself, by shooting, and its Floquet multipliers.

        The search starts from the initial conditions.

        Parameters
        ----------
        period : float
            In s. Where the equations depend on time, the period itself; otherwise where to begin
            the search for it.
        moving : iterable of coordinates, optional
            Those that may move on from period to period, such as the position of a vehicle.
        until : Event, optional
            The period ends when this happens, after its reset: the impact of a walker's foot, say.
        **solver_kwargs
            Options of the native solver, ``'dop853'`` where `ode_solver` is none; `rtol` and `atol`
            are 1e-12 by default. Where constraints tie states, they are held by projection.

        Returns
        -------
        PeriodicOrbit

        Raises
        ------
        PeriodicOrbitError
            None was found; the message tells how near the search came.

        Examples
        --------
        A damped oscillator under a force of sin(t):

        >>> import numpy as np
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper(1, False, True, external_force_as_sin_of_t=True)
        >>> orbit = system.find_periodic_orbit(2 * np.pi)
        >>> bool(np.allclose(np.abs(orbit.multipliers), np.exp(-np.pi))), orbit.stable
        (True, True)
        """
        return find_orbit(self, self._now(), period, moving, until, solver_kwargs)

    # -- simulation -------------------------------------------------------------------------------

    def set_dependent_initial_conditions(
        self, dep_vars: Iterable[Any] | None = None, use_jac: bool = False, **root_kwargs: Any
    ) -> None:
        """Set the dependent states' initial conditions so that the constraints are satisfied.

        The holonomic constraints are solved for the dependent coordinates with
        `scipy.optimize.root`, starting from their present values; then the velocity constraints,
        which are linear, for the dependent speeds.

        Parameters
        ----------
        dep_vars : iterable of functions of time, optional
            One coordinate for each holonomic and one speed for each velocity constraint; by
            default the dependent ones of the KanesMethod.
        use_jac : bool, optional
            Whether the root finder gets the exact Jacobian.
        **root_kwargs
            For `scipy.optimize.root`.

        Raises
        ------
        ValueError
            The system has no constraints, or `dep_vars` does not fit their number.

        Warns
        -----
        PyDyUserWarning
            The root finder did not converge; the results are set all the same.
        """
        places = check_dependents(self._definition, dep_vars)
        x = solve_dependents(self._now(), places, flag(use_jac, "`use_jac`"), root_kwargs)
        # A new dictionary: the old one may be the caller's own. Its keys may be names.
        conditions, own = dict(self._initial_conditions), self._definition.places["states"]
        keys = {own.find(key, "initial_conditions"): key for key in conditions}
        solved = [k for part in places for k in part]
        conditions.update({keys.get(k, own.symbols[k]): float(x[k]) for k in solved})
        self._initial_conditions = conditions
        self._dependent = tuple(own.symbols[k] for k in solved)

    @overload
    def integrate(
        self, *, full_output: Literal[True], **solver_kwargs: Any
    ) -> tuple[np.ndarray, dict[str, Any]]: ...

    @overload
    def integrate(self, **solver_kwargs: Any) -> np.ndarray: ...

    def integrate(self, **solver_kwargs: Any) -> Any:
        """Integrate the equations over `times` from the initial conditions.

        The function is generated first if it has not been.

        Parameters
        ----------
        **solver_kwargs
            Options of the `ode_solver`. These are understood here:

            ``constraints='project'``
                With a native solver: positions and velocities are brought back onto the
                constraints after every step and at every output.
            ``constraints='baumgarte', gain=g``
                With any solver: constraint forces that let a residual c die out as in
                c'' + 2 g c' + g² c = 0 are added to the equations.
            ``events``
                With a native solver: a list of `pydy.solvers.Event`.

        Returns
        -------
        ndarray, shape (len(times), n)
            The states, auxiliary ones included, or whatever the solver returns.

        Raises
        ------
        ValueError
            There are fewer than two times, or an option makes no sense.
        SingularMatrixError
            The mass matrix became singular; the message tells where.
        IntegrationError
            The solver, odeint or a native one, could not go on; the error holds what was computed.
            With ``full_output=True``, what odeint returns is returned as it is.

        Warns
        -----
        PyDyUserWarning
            The initial conditions are farther from the constraints than numbers of six digits, and
            `constraints` does not say what to do about it.
        """
        return integrate(self._now(), self._ode_solver, solver_kwargs)

    def simulate(
        self,
        *,
        sensitivities: Any = None,
        control_sensitivities: Any = False,
        **solver_kwargs: Any,
    ) -> Trajectory:
        """Integrate like `integrate`, and return the result with its names.

        Parameters
        ----------
        sensitivities : symbol, name, group, or iterable of these, optional
            Parameters by which the states are differentiated along the motion: constants; states,
            for their initial conditions; specifieds that are numbers or samples; ``'constants'``,
            ``'states'`` or ``'specifieds'`` for all of a kind. The derivatives are integrated
            beside the states, through events and constraints, and are the trajectory's
            `sensitivity`. Dependent initial conditions, as `set_dependent_initial_conditions`
            solved for them last, follow the others.
        control_sensitivities : bool, optional
            Whether the step control of a native solver looks at them too, and not at the states
            alone.
        **solver_kwargs
            Options of the `ode_solver`. A solver may return ``(states, info)``; of the dictionary
            ``info``, ``'times'`` (where the solver stopped early), ``'events'`` and
            ``'dense_output'`` are the trajectory's, and the rest is its `statistics`.
            `scipy.integrate.odeint` and the solvers of `pydy.solvers` are called with
            ``full_output=True``.

        Returns
        -------
        Trajectory
            The states, the outputs and specifieds along them, and the numbers that were used;
            later changes of the System do not reach it. It ends where an event ended it.

        Raises
        ------
        ValueError, SingularMatrixError, IntegrationError
            As `integrate`; the last with ``full_output=True`` too.

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
        return simulate(self._now(), self._ode_solver, solver_kwargs, wanted)

    def integrate_ensemble(
        self,
        *,
        initial_conditions: Mapping[Any, Any] | None = None,
        constants: Mapping[Any, Any] | None = None,
        specifieds: Mapping[Any, Any] | None = None,
        times: ArrayLike | None = None,
        ode_solver: Any = "dop853",
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
        """Integrate many trajectories of the system, with other numbers for each.

        Values that are not given here are those of the System. Eight trajectories at a time share
        the processor's vector registers, and blocks of them its cores. The results are the same to
        the last bit for any `chunks`, `workers` and scheduler.

        Parameters
        ----------
        initial_conditions, constants, specifieds : dict, optional
            As the attributes of these names; but a value may also be a one-dimensional array, with
            one entry for each sample, or an `xarray.DataArray` along any dimensions, which are
            matched by name. Numbers are the same for all samples, and so are specifieds that are
            functions, expressions or SampledInputs.
        times : array_like, shape (m,), optional
        ode_solver : {'dop853', 'tsit5', 'vern9', 'rk4', 'radau'} or Solver, optional
        product : bool, optional
            Whether each one-dimensional array gets a dimension of its own, named after its symbol
            (``initial_q1`` for an initial condition of ``q1``): the samples are all combinations.
        sensitivities : symbol, name, group, or iterable of these, optional
            Parameters by which every trajectory is differentiated, as in `simulate`: the variable
            ``sensitivity`` along ``quantity``, states and outputs, and ``parameter``.
        control_sensitivities : bool, optional
            As in `simulate`.
        reduce : optional
            What to keep instead of all times: ``'final'``; ``('max', name)`` or ``('min', name)``
            of a state or output; ``'events'`` or ``('events', number)`` for the first times of each
            event; a list of these; or a function that takes the Dataset of some samples and returns
            a Dataset that keeps the sample dimensions.
        chunks : int, 'auto' or dict of str to int, optional
            Sizes of blocks of samples. The Dataset is then lazy: Dask arrays, computed by whichever
            scheduler of Dask is chosen. With `store`, only the sizes.
        store : path, optional
            Of a Zarr store, to which every finished block is written at once.
        resume : bool or str, optional
            Whether `store` may exist: only what is missing there is computed. The functions in
            `reduce` and `specifieds` must be those of the first call: they are compared by their
            code and all that they use. A text compares itself instead: a name of yours for them,
            given from the first call on, to change when they do.
        workers : int, optional
            How many threads; all processors by default.
        progress : bool, optional
            Whether a bar counts samples; needs tqdm.
        units : dict of symbols or names to str, optional
            For the attribute ``units`` of variables.
        **solver_kwargs
            Options of the solver, and `events`, `constraints` and `gain` as in `integrate`.

        Returns
        -------
        xarray.Dataset
            One variable for each state and output along the sample dimensions and ``time``; what
            was varied as coordinates; ``steps``, ``rejected``, ``evaluations``, ``end_time``, and
            ``status``, whose attribute ``flag_meanings`` tells its values. A sample that fails is
            NaN from there on, and the others do not notice.

        Raises
        ------
        ValueError
            A value, name or shape that does not fit, before anything is computed.
        ImportError
            A package is missing: ``pip install 'pydy[ensemble]'``.
        EnsembleInterrupted
            The user interrupted it; the error holds the finished samples, where there is no store.

        Notes
        -----
        Trajectories are integrated one by one, by the same solvers, where specifieds are Python
        functions, with `control_sensitivities`, sensitivities by samples, `events` or
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
            self._now(),
            (initial_conditions, constants, specifieds),
            times,
            ode_solver,
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
            raise ValueError("`resume=True` needs `store`, the Zarr store to go on with.")
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

        now = self._now()
        numbers = now.x, now.p, now.times
        return export_model(now.definition, now.model, now.plan, numbers, **options)

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
            lambda: self.model.assembly,
            visuals,
            reference_frame,
            origin,
            options,
            lambda: self._times,
            lambda times, states: self._now().motion(times, states),
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
