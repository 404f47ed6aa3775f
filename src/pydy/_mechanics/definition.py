"""A multibody system without a method object: bodies, loads, kinematics and constraints."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, TypeAlias

import sympy as sm
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from pydy._checks import (
    SymbolIndex,
    check_mapping,
    describe,
    instance,
    listed,
    number,
    shown,
    suggest_arguments,
)
from pydy._forks import cached_property
from pydy._mechanics.dependents import constrained
from pydy._mechanics.equations import Equations
from pydy._mechanics.implicit import Implicit
from pydy._mechanics.kinematic_constraints import DependentStates
from pydy._mechanics.kinematic_equations import KinematicEquations
from pydy._mechanics.multibody import Multibody
from pydy._mechanics.rates import solve_rates
from pydy._mechanics.reader import activation_states, check_bodies, read_loads
from pydy._mechanics.select_formulation import equations_of
from pydy._mechanics.symbols import find_symbols, rate_of
from pydy._names import counted

if TYPE_CHECKING:
    from sympy.physics.mechanics import ActuatorBase, KanesMethod, LagrangesMethod, System
    from sympy.physics.mechanics.jointsmethod import JointsMethod

    from pydy._sympy_types import AnySymbol, Body, Load, TimeFunction

# What `pydy.system.System` takes as `eom_method`.
EomMethod: TypeAlias = "KanesMethod | LagrangesMethod | JointsMethod | System | Definition"

_COORDINATES = "pass all of them in `coordinates`, and the dependent ones also in"
_SPEEDS = "pass all of them in `speeds`, and the dependent ones also in"
_NAMES_OF_SYMPY = {
    **dict.fromkeys(("kd_eqs", "kdes"), "pass these equations as `kinematic_equations`"),
    **dict.fromkeys(("q", "qs", "q_ind"), f"{_COORDINATES} `dependent_coordinates`"),
    **dict.fromkeys(("q_dep", "q_dependent"), f"{_COORDINATES} `dependent_coordinates`"),
    **dict.fromkeys(("u", "u_ind"), f"{_SPEEDS} `dependent_speeds`"),
    **dict.fromkeys(("u_dep", "u_dependent"), f"{_SPEEDS} `dependent_speeds`"),
    **dict.fromkeys(("u_aux", "u_auxiliary"), "pass them as `auxiliary_speeds`"),
    **dict.fromkeys(
        ("configuration_constraints", "hol_coneqs"), "pass them as `holonomic_constraints`"
    ),
    "nonhol_coneqs": "pass them as `nonholonomic_constraints`",
    "acceleration_constraints": "they follow from the others, leave them out",
    **dict.fromkeys(("forcelist", "force_list", "actuators"), "pass them as `loads`"),
    **dict.fromkeys(("inertial", "inertial_frame"), "pass it as `frame`"),
    "fixed_point": "the place of a body's mass centre leads to it, leave it out",
    "joints": "pass a System of sympy.physics.mechanics, which has joints, to pydy.system.System",
}


class Definition:
    """The bodies, loads, kinematics and constraints of a multibody system.

    What `pydy.system.System` needs to form equations of motion, without the work that the
    constructors of SymPy's methods do: `KanesMethod` takes minutes for some hundred bodies.

    Parameters
    ----------
    frame : ReferenceFrame
        The inertial frame.
    coordinates : sequence of functions of time
        The states are the coordinates in this order, then the speeds in theirs.
    speeds : sequence of functions of time, or of the coordinates' derivatives, optional
        By default the derivatives of the coordinates.
    bodies : sequence of Particle and RigidBody
    loads : sequence, optional
        Pairs of a point and a force or of a frame and a torque, `Force`, `Torque`, and actuators
        with ``to_loads()``.
    kinematic_equations : sequence of expressions, optional
        Zero, and linear in the derivatives of the coordinates, which they give. By default each
        coordinate's derivative is the speed at its place.
    holonomic_constraints : sequence of expressions, optional
        Of the coordinates and time; zero when satisfied. Redundant ones do no harm.
    nonholonomic_constraints : sequence of expressions, optional
        Linear in the speeds; zero when satisfied.
    velocity_constraints : sequence of expressions, optional
        All constraints of the speeds, in place of the derivatives of the holonomic ones and the
        nonholonomic ones: for shorter forms of them.
    dependent_coordinates, dependent_speeds : sequence of functions of time, optional
        Those that the constraints give. By default they are chosen so that the constraints can be
        solved for them at random states. They keep their places among the states.
    auxiliary_speeds : sequence of functions of time, optional
        Speeds that are zero, and bring noncontributing forces into evidence.
    configuration : mapping of coordinates and constants to numbers, optional
        Roughly how the mechanism is assembled. Which constraints are redundant is found out at
        random states that satisfy all of them; a linkage that can also be assembled in degenerate
        ways, in which more of them are redundant, may need to be told which way is meant. Speeds
        in it are not used: it may be the ``initial_conditions`` of a System.
    frames : mapping of names to pairs of a ReferenceFrame and a Point, optional
        Places that `System.frame_position`, `frame_rotation` and `frame_jacobian` know by name.
    values : mapping of constants to numbers, optional
        What these have there in place of 1.0, if the motion does not depend on them and the System
        has no value either: the place of a robot's base.
    potential_energy : expression, optional
        Of the coordinates, time and constants: the potential energy of all loads, or of all but
        those that are constant in the inertial frame, such as weights. `System.potential_energy`
        is searched for among the forms of loads that it knows if the power of the loads does not
        agree with this expression.

    Raises
    ------
    TypeError, ValueError
        An argument is not what it should be; the message names it.

    Examples
    --------
    >>> import sympy as sm
    >>> import sympy.physics.mechanics as me
    >>> from pydy import System
    >>> from pydy.mechanics import Definition
    >>> x, v = me.dynamicsymbols('x v')
    >>> m, k = sm.symbols('m k')
    >>> ground, rest = me.ReferenceFrame('N'), me.Point('O')
    >>> rest.set_vel(ground, 0)
    >>> end = rest.locatenew('P', x*ground.x)
    >>> definition = Definition(ground, [x], [v], bodies=[me.Particle('bob', end, m)],
    ...                         loads=[(end, -k*x*ground.x)])
    >>> System(definition, {m: 2.0, k: 8.0}).evaluate_ode([0.5, 0.0])
    array([ 0., -2.])
    """

    @suggest_arguments("Definition", _NAMES_OF_SYMPY)
    def __init__(
        self,
        frame: ReferenceFrame,
        coordinates: Sequence[TimeFunction],
        speeds: Sequence[TimeFunction] | None = None,
        *,
        bodies: Iterable[Body],
        loads: Iterable[Load | ActuatorBase] = (),
        kinematic_equations: Sequence[sm.Expr] | None = None,
        holonomic_constraints: Sequence[sm.Expr] = (),
        nonholonomic_constraints: Sequence[sm.Expr] = (),
        velocity_constraints: Sequence[sm.Expr] | None = None,
        dependent_coordinates: Sequence[TimeFunction] | None = None,
        dependent_speeds: Sequence[TimeFunction] | None = None,
        auxiliary_speeds: Sequence[TimeFunction] = (),
        configuration: Mapping[AnySymbol | str, float] | None = None,
        frames: Mapping[str, tuple[ReferenceFrame, Point]] | None = None,
        values: Mapping[sm.Symbol, float] | None = None,
        potential_energy: sm.Expr | None = None,
    ) -> None:
        instance(frame, ReferenceFrame, "`frame`")
        t = dynamicsymbols._t
        self.frame = frame
        self.coordinates = _functions("coordinates", coordinates)
        rates = self._rates = tuple(rate_of(q, t) for q in self.coordinates)
        self.speeds = rates if speeds is None else _functions("speeds", speeds, rates)
        self.bodies = check_bodies(listed("bodies", bodies, "Particle and RigidBody objects"))
        if not self.bodies:
            raise ValueError("`bodies` must have at least one Particle or RigidBody.")
        load_list = listed("loads", loads, "loads")
        self.loads = read_loads(load_list)
        self._activations = tuple(activation_states(load_list, self.coordinates))
        self.auxiliary_speeds = _functions("auxiliary_speeds", auxiliary_speeds)
        self._each_a_rate = kinematic_equations is None
        self.kinematic_equations = self._kinematic(kinematic_equations, rates)
        self.holonomic_constraints = _expressions("holonomic_constraints", holonomic_constraints)
        self.nonholonomic_constraints = _expressions(
            "nonholonomic_constraints", nonholonomic_constraints
        )
        self._given_motion = (
            None
            if velocity_constraints is None
            else _expressions("velocity_constraints", velocity_constraints)
        )
        self.dependent_coordinates = _subset(
            "dependent_coordinates", dependent_coordinates, self.coordinates, "coordinates"
        )
        self.dependent_speeds = _subset("dependent_speeds", dependent_speeds, self.speeds, "speeds")
        self.configuration = self._near(configuration)
        self.frames = _named_positions(frames)
        self.values = {
            key: number(value, f"`values[{key}]`", finite=True)
            for key, value in check_mapping("values", values).items()
        }
        self.potential_energy = _energy(potential_energy)
        self._check_names()
        self._check_motion()
        self.as_method: Callable[[Definition], EomMethod] | None = None

    def __repr__(self) -> str:
        constraints = len(self.holonomic_constraints) + len(self.nonholonomic_constraints)
        parts = (
            f"{len(self.bodies)} {'body' if len(self.bodies) == 1 else 'bodies'}",
            counted(len(self.loads), "load"),
            counted(len(self.coordinates), "coordinate"),
            counted(len(self.speeds), "speed"),
            counted(constraints, "constraint"),
        )
        return f"<Definition in {self.frame}: {', '.join(parts)}>"

    @cached_property
    def velocity_constraints(self) -> tuple[sm.Expr, ...]:
        """All constraints of the speeds, differentiated by SymPy."""
        return self._constraints_of_speeds(evaluate=True)

    @cached_property
    def _motion(self) -> tuple[sm.Expr, ...]:
        """The same, differentiated on the graph.

        SymPy's take longer than all the rest for constraints of several hundred terms.
        """
        return self._constraints_of_speeds(evaluate=False)

    def _constraints_of_speeds(self, evaluate: bool) -> tuple[sm.Expr, ...]:
        if self._given_motion is not None:
            return self._given_motion
        t = dynamicsymbols._t
        rates = (sm.Derivative(e, t, evaluate=evaluate) for e in self.holonomic_constraints)
        return (*rates, *self.nonholonomic_constraints)

    @cached_property
    def method(self) -> EomMethod:
        """The System's `eom_method`: this object, or the result of `as_method`, made once."""
        return self if self.as_method is None else self.as_method(self)

    def _kinematic(
        self, equations: Sequence[sm.Expr] | None, rates: Sequence[sm.Derivative]
    ) -> tuple[sm.Expr, ...]:
        if equations is not None:
            return _expressions("kinematic_equations", equations)
        if len(self.speeds) != len(rates):
            raise ValueError(
                f"`kinematic_equations` are needed with {counted(len(rates), 'coordinate')} and "
                f"{counted(len(self.speeds), 'speed')}: give as many as coordinates, each zero, "
                "that give the derivatives of the coordinates."
            )
        return tuple(q - u for q, u in zip(rates, self.speeds, strict=True))

    def _near(
        self, configuration: Mapping[AnySymbol | str, float] | None
    ) -> dict[AnySymbol, float]:
        values = check_mapping("configuration", configuration)
        if not values:
            return {}
        inside = find_symbols((*self.holonomic_constraints, *self._motion))
        index = SymbolIndex(
            [*dict.fromkeys((*self.coordinates, *self.speeds, *inside))],
            "coordinates, and constants of the constraints",
        )
        return {
            key: number(value, f"`configuration[{key}]`", finite=True)
            for key, value in index.by_symbol(values, "configuration").items()
        }

    def _check_names(self) -> None:
        counts = Counter((*self.coordinates, *self.speeds, *self.auxiliary_speeds))
        twice = [s for s, count in counts.items() if count > 1]
        if twice:
            raise ValueError(
                "`coordinates`, `speeds` and `auxiliary_speeds` must differ from each other, got "
                f"{describe(twice)} more than once."
            )

    def _check_motion(self) -> None:
        moving = {*self.speeds, *self.auxiliary_speeds}
        for k, row in enumerate(self.nonholonomic_constraints):
            symbols = find_symbols((row,))
            is_static = not any(s in moving or isinstance(s, sm.Derivative) for s in symbols)
            if is_static and not symbols.keys().isdisjoint(self.coordinates):
                raise ValueError(
                    f"`nonholonomic_constraints[{k}]` must restrict speeds, got {shown(row)}, "
                    "which has none. Coordinates are constrained by `holonomic_constraints`."
                )

    @cached_property
    def multibody(self) -> Multibody:
        """The Multibody, with q' solved for and dependent coordinates and speeds chosen."""
        return self.multibody_with(None)

    def multibody_with(self, implicit: Implicit | None) -> Multibody:
        """Return the Multibody with the unknowns of residuals as coordinates."""
        rates, speeds = self._rates, set(self.speeds)
        if self._each_a_rate and (self.speeds == rates or speeds.isdisjoint(rates)):
            solved = dict(zip(rates, self.speeds, strict=True))
        else:
            unknown_rates = [rate for rate in rates if rate not in speeds]
            equations = [e for e in self.kinematic_equations if e != 0]
            solution = solve_rates(equations, unknown_rates, "kinematic_equations")
            solved = dict(zip(unknown_rates, solution, strict=True))
        time, derivatives = dynamicsymbols._t, [solved.get(rate, rate) for rate in rates]
        body = Multibody(
            frame=self.frame,
            bodies=self.bodies,
            loads=self.loads,
            time=time,
            coordinates=self.coordinates,
            speeds=self.speeds,
            kinematics=KinematicEquations.of(
                time, self.speeds, rates, derivatives, self.auxiliary_speeds
            ),
            dependents=DependentStates(all_speeds=self.speeds),
            auxiliary=self.auxiliary_speeds,
            activations=self._activations,
            potential=self.potential_energy,
        )
        if implicit is not None:
            body = implicit.added_to(body)
        if not self.holonomic_constraints and not self._motion:
            names = ("dependent_coordinates", "dependent_speeds")
            given = [argument for argument in names if getattr(self, argument)]
            if given and not body.constraints.holonomic:
                raise ValueError(f"`{given[0]}` are given, but there are no constraints.")
            if not given:  # the only dependent coordinates are the unknowns of residuals, if any
                return body
        chosen, near = self.dependent_coordinates, self.configuration
        if implicit is not None and near:
            near = implicit.start | near
        return constrained(
            body,
            (*self.holonomic_constraints, *body.constraints.holonomic),
            self._motion,
            None if chosen is None else (*chosen, *body.dependents.coordinates),
            self.dependent_speeds,
            near,
        )


def equations_of_definition(
    definition: Definition, source: str | None = None, implicit: Implicit | None = None
) -> Equations:
    """Return the equations of a Definition, which are always formed."""
    if source == "method":
        raise ValueError(
            "`equations='method'` needs a method object, such as a KanesMethod; `eom_method` is a "
            "Definition, whose equations are formed from its bodies."
        )
    if not definition.speeds:
        raise ValueError(
            "`eom_method` has no speeds: nothing in it can move, so there are no equations of "
            "motion. Give `coordinates` and `speeds` to a Definition, or a joint that is no weld."
        )
    body = definition.multibody if implicit is None else definition.multibody_with(implicit)
    return equations_of(body)


def _functions(
    argument: str, symbols: Iterable[TimeFunction], rates: Sequence[TimeFunction] = ()
) -> tuple[TimeFunction, ...]:
    """Return functions of time, or derivatives that are among `rates`."""
    functions = tuple(listed(argument, symbols, "functions of time", hashable=True))
    for symbol in functions:
        of_time = isinstance(symbol, AppliedUndef) and symbol.args == (dynamicsymbols._t,)
        if not of_time and symbol not in rates:
            raise ValueError(
                f"`{argument}` must hold functions of time, such as dynamicsymbols('q'), got "
                f"{shown(symbol)}."
            )
    return functions


def _expressions(argument: str, expressions: Iterable[sm.Expr | float]) -> tuple[sm.Expr, ...]:
    entries = tuple(listed(argument, expressions, "expressions"))
    for expression in entries:
        is_number = isinstance(expression, (int, float)) and not isinstance(expression, bool)
        if not (is_number or isinstance(expression, sm.Expr)):
            raise TypeError(
                f"`{argument}` must hold expressions that are zero, got {shown(expression)}."
            )
        if is_number:
            number(expression, f"`{argument}`", finite=True)
    return tuple(map(sm.sympify, entries))


def _energy(energy: sm.Expr | None) -> sm.Expr | None:
    expression = isinstance(energy, sm.Expr) and not (energy.is_Matrix or energy.is_number)
    if energy is None or expression:
        return energy
    if isinstance(energy, sm.Expr) and not energy.is_number:
        raise ValueError(
            f"`potential_energy` must be a scalar expression, got {shown(energy)}: a matrix."
        )
    return sm.Float(number(energy, "`potential_energy`, an expression or a number,", finite=True))


def _named_positions(
    frames: Mapping[str, tuple[ReferenceFrame, Point]] | None,
) -> dict[str, tuple[ReferenceFrame, Point]]:
    positions = {}
    for name, pair_ in check_mapping("frames", frames).items():
        pair = isinstance(pair_, tuple) and len(pair_) == 2
        if not (
            isinstance(name, str)
            and pair
            and isinstance(pair_[0], ReferenceFrame)
            and isinstance(pair_[1], Point)
        ):
            raise TypeError(
                "`frames` must map names to pairs of a ReferenceFrame and a Point, got "
                f"{shown(name)}: {shown(pair_)}."
            )
        positions[name] = (pair_[0], pair_[1])
    return positions


def _subset(
    argument: str,
    symbols: Iterable[TimeFunction] | None,
    allowed: Sequence[TimeFunction],
    kind: str,
) -> tuple[TimeFunction, ...] | None:
    if symbols is None:
        return None
    selected = tuple(listed(argument, symbols, kind, hashable=True))
    strange = [s for s in selected if s not in allowed]
    if strange:
        raise ValueError(f"`{argument}` must be some of the {kind}, got {describe(strange)}.")
    return selected
