"""A System with contacts that open, close, stick and slide at exact times."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, cast

import numpy as np
import sympy as sm

from pydy._checks import SymbolDict, check_mapping, choice, flag, instance, shown
from pydy._errors import ContactError
from pydy._graph import inputs_of
from pydy._integration import AugmentedSystem, SensitivityRequest, requested_sensitivities
from pydy._judges import warn_of_jumps, warn_of_outputs
from pydy._motion import Motion, check_events, native_solver
from pydy._names import column_names
from pydy._problem import Problem, read_times, with_settings
from pydy.analysis import AdjointGradient
from pydy.contact.complementarity import OPEN, SLIDING, independent, rows_of_modes
from pydy.contact.conditions import InfeasibleError, Stick, Unilateral, paired
from pydy.contact.modes import CompiledModes, modes_of
from pydy.contact.rows import StartError
from pydy.contact.run import ContactRun, State
from pydy.contact.sensitivities import HybridSensitivities
from pydy.contact.trajectory import ContactTrajectory
from pydy.solvers import Event, Outcome, Solver
from pydy.system import System

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, ExpressionOrName

# Methods of a System that take contacts.
_TAKE_CONTACTS = (
    "adjoint_gradient", "animate", "as_jax", "as_torch", "find_periodic_orbit", "fit",
    "integrate_ensemble", "plot",
)  # fmt: skip
# Values of `constraints`; closed contacts are enforced by projection.
_ENFORCEMENTS = (None, "project", "baumgarte")


class Contacts:
    """A System with unilateral contacts and friction, simulated from transition to transition.

    In each combination of modes the equations of motion hold exactly those constraints that are
    active; they are compiled when the combination first occurs, and kept. Transitions are events of
    the native solvers: a gap closes, a normal force vanishes, friction reaches its limit, a sliding
    speed vanishes. Impacts follow Newton's hypothesis, with Coulomb's law for the impulses; what
    happens next is decided by complementarity, by trying all combinations.

    Parameters
    ----------
    system : System
        Has the values, times, outputs and solver, which must be native.
    contacts : sequence of Unilateral and Stick
        Up to eight. A Unilateral that a Stick is on need not be named again.
    constants : dict, optional
        Values of symbols that occur only in contacts. They are constants of the system, where they
        are set: later ``system.constants[mu] = 0.4``. A dictionary that is assigned there later
        must name them again.
    hypothesis : {'newton', 'poisson'}, optional
        What `restitution` is a ratio of: normal speeds after and before an impact, or normal
        impulses of its second phase and of compression. They differ where friction acts on a body
        that is not hit centrally, or where several contacts are hit; there Newton's may raise the
        energy, which is a `ContactError`.

    Raises
    ------
    TypeError, ValueError
        An argument is not what it should be; the message names it.
    NotImplementedError
        Auxiliary speeds, and loads that depend on accelerations.

    Examples
    --------
    A block slides up a slope, stops and stays where it is:

    >>> import numpy as np
    >>> import sympy as sm
    >>> import sympy.physics.mechanics as me
    >>> from pydy import System
    >>> from pydy.contact import Contacts, Stick, Unilateral
    >>> from pydy.mechanics import Definition
    >>> x, y, vx, vy = me.dynamicsymbols('x, y, v_x, v_y')
    >>> m, g, slope, mu = sm.symbols('m, g, slope, mu')
    >>> N, O = me.ReferenceFrame('N'), me.Point('O')
    >>> O.set_vel(N, 0)
    >>> P = O.locatenew('P', x*N.x + y*N.y)
    >>> P.set_vel(N, vx*N.x + vy*N.y)
    >>> block = Definition(N, [x, y], [vx, vy], bodies=[me.Particle('block', P, m)],
    ...     loads=[(P, -m*g*(sm.sin(slope)*N.x + sm.cos(slope)*N.y))])
    >>> ground = Unilateral(y, name='ground')
    >>> contacts = Contacts(System(block, {g: 9.81, slope: 0.2}, ode_solver='dop853',
    ...                            initial_conditions={vx: 1.0}, times=np.linspace(0.0, 1.0, 11)),
    ...                     [ground, Stick(P, on=ground, mu=mu, along=N.x)], {mu: 0.5})
    >>> trajectory = contacts.simulate(rtol=1e-10, atol=1e-10)
    >>> [(round(start, 6), modes['ground']) for start, _, modes in trajectory.modes]
    [(0.0, 'slides +'), (0.148013, 'sticks')]
    >>> trajectory['x'][-3:].round(6)
    array([0.074006, 0.074006, 0.074006])
    """

    # Without slots a misspelt attribute, or one of the System, could be set and would be ignored.
    __slots__ = (
        "_compiled_modes",
        "contact_constants",
        "contacts",
        "hypothesis",
        "names",
        "symbols",
        "system",
    )
    infeasible = InfeasibleError  # raised for values outside the domain; a search may try them

    def __init__(
        self,
        system: System,
        contacts: Iterable[Unilateral | Stick],
        constants: Mapping[Any, float] | None = None,
        *,
        hypothesis: str = "newton",
    ) -> None:
        instance(system, System, "`system`")
        self.system = system
        self.contacts = paired(contacts)
        self.hypothesis: str = choice(hypothesis, ("newton", "poisson"), "`hypothesis`")
        self.names = tuple(c.name for c in self.contacts)
        parts: list[sm.Expr] = []  # expressions that need numbers
        frame = getattr(system._equations.mechanism, "frame", None)
        if frame is None:
            raise ValueError("Contacts need a System with bodies and an inertial frame.")
        for c in self.contacts:
            parts += [] if c.unilateral is None else [c.unilateral.gap]
            parts += [*c.coefficients.values(), *(c.stick.speeds(frame) if c.stick else ())]
        self.symbols = [Event(part) for part in parts]
        self._compiled_modes: CompiledModes | None = None
        self.contact_constants = dict(check_mapping("constants", constants))
        if self.contact_constants:
            # The dictionary may be shared with other Systems of the user: do not modify it.
            system._constants = dict(system._constants)
            system.constants.update(self.contact_constants)
        self._problem()  # raises errors here, not at the first simulation
        system._has_contacts = True

    def __repr__(self) -> str:
        return f"<Contacts {', '.join(self.names)} of a System>"

    @property
    def compiled_modes(self) -> list[dict[str, str]]:
        """The combinations of modes that have been compiled so far."""
        keys = (
            {}
            if self._compiled_modes is None
            else dict.fromkeys(m for m, _ in self._compiled_modes.modes)
        )
        return [dict(zip(self.names, modes, strict=True)) for modes in keys]

    @property
    def depends_on_time(self) -> bool:
        """Whether gaps, sliding speeds or coefficients depend on time explicitly."""
        rows = self._problem()[1].rows
        nodes = [*rows.gaps, *rows.speeds, *rows.pressed, *rows.mu, *rows.static, *rows.restitution]
        return "t" in inputs_of(rows.graph, nodes).groups

    def _problem(
        self, events: Event | Iterable[Event] | None = None
    ) -> tuple[Problem, CompiledModes]:
        problem = self.system._now(events, contacts=self)
        return problem, self._compiled(problem)

    def _compiled(self, problem: Problem) -> CompiledModes:
        if self._compiled_modes is None or self._compiled_modes.definition != problem.definition:
            self._compiled_modes = CompiledModes(problem, self.contacts, self.hypothesis)
        return self._compiled_modes

    def integrate(
        self,
        problem: Problem,
        times: np.ndarray,
        *,
        solver: object,
        sensitivities: SensitivityRequest | None = None,
        events: Event | Iterable[Event] | None = (),
        **options: Any,
    ) -> Motion:
        """Integrate a Problem of the System; see `pydy._integration.integration.integrate`.

        A Problem with `modes` starts in these, projected onto their constraints; otherwise the
        modes follow from the state.
        """
        if len(times) and times is not problem.settings.times:
            problem = problem.replace(times=times, t=float(times[0]))
        run = self._run(problem, times, solver, events, **options)
        if sensitivities is not None:
            parameters, controlled = sensitivities.parameters, sensitivities.controlled
            run.transitions = HybridSensitivities(parameters, controlled, run.rows, problem)
            sensitivities.augmented = run.transitions.augmented
        run.start_modes = problem.modes
        return run.motion()

    def simulate(
        self,
        *,
        events: Sequence[Event] = (),
        sensitivities: Any = None,
        control_sensitivities: Any = False,
        **solver_kwargs: Any,
    ) -> ContactTrajectory:
        """Simulate the System over its `times`, and return a trajectory with modes.

        Parameters
        ----------
        events : sequence of Event, optional
            Further events, without resets.
        sensitivities, control_sensitivities
            As in `System.simulate`, with the constants of contacts. Transitions and impacts are
            taken into account.
        **solver_kwargs
            Options of the native solver, such as `rtol` and `atol`. Constraints, of the System and
            of closed contacts, are held by projection.

        Returns
        -------
        ContactTrajectory

        Raises
        ------
        ValueError
            A gap is negative at the first time by more than the tolerances, a coefficient is
            out of range or lost by an assignment to ``system.constants``, the solver is not native,
            or friction at a point is on a gap that is no length, or not along it.
        ContactError
            No combination of modes is possible (Painlevé's paradox, jamming), or an impact would
            raise the energy; the message has the state.
        NotImplementedError
            Events with resets; or `sensitivities` of contacts that depend on specifieds, and where
            a body begins to slide in a plane without an acceleration.
        IntegrationError
            As in `System.simulate`.

        Warns
        -----
        PyDyUserWarning
            Outputs are not finite; or a load jumps on the way, which `sensitivities` do not know.
        """
        request = requested_sensitivities(sensitivities, control_sensitivities)
        problem = self._problem(events)[0]
        motion = self.integrate(
            problem,
            problem.settings.times,
            solver=self.system.ode_solver,
            sensitivities=request,
            events=events,
            **solver_kwargs,
        )
        trajectory = cast(ContactTrajectory, motion.trajectory)
        if not np.isfinite(trajectory.outputs).all():
            warn_of_outputs(trajectory, problem)
        if request is not None:
            warn_of_jumps(problem, lambda: trajectory, request.augmented)
        return trajectory

    def in_modes(self, modes: Mapping[str, str]) -> System:
        """Return the System with fixed modes, for analyses without transitions.

        Linear models, equilibria and exports are those of one combination of modes: its active
        contacts are constraints, and no event ends it.

        Parameters
        ----------
        modes : dict of str to str
            The mode of each contact by its name; a gap that is not named is open.

        Returns
        -------
        System
            With the values that the System has now.

        Raises
        ------
        ValueError
            A name or a mode is not one of a contact.
        NotImplementedError
            A contact slides in a plane, where it has no direction of its own.
        """
        modes_by_name = check_mapping("modes", modes)
        if unknown := [name for name in modes_by_name if name not in self.names]:
            raise ValueError(
                f"`modes` has the key {unknown[0]!r}; the contacts are {', '.join(self.names)}."
            )
        combination = []
        for c in self.contacts:
            possible = modes_of(c)
            mode = modes_by_name.get(c.name, possible[0])
            is_possible = isinstance(mode, str) and mode in possible
            if not is_possible or (c.name not in modes_by_name and mode != OPEN):
                raise ValueError(
                    f"`modes[{c.name!r}]` must be one of {', '.join(map(repr, possible))}, got "
                    f"{shown(modes_by_name.get(c.name))}."
                )
            if mode == SLIDING:
                raise NotImplementedError(
                    f"`modes[{c.name!r}]`: sliding in a plane is not supported by itself."
                )
            combination.append(mode)
        problem, compiled = self._problem()
        run = ContactRun(
            compiled, native_solver(self.system.ode_solver), problem, np.array([problem.t]), [], {}
        )
        p = run.numbers(problem.t, problem.x)
        active = rows_of_modes(
            run.complementarity(p, State(problem.t, problem.x, set(), set(), set())), combination
        )
        enforced = tuple(independent(p.delassus, active))
        mode = compiled.mode(tuple(combination), enforced, active)[0]
        system = System(mode.equations, **compiled.settings(mode))
        system._contradicted = None  # do not warn about the same values again
        system._implied = dict.fromkeys(compiled.rows.hidden, 0.0)
        system.constants = dict(problem.constants)
        system.specifieds = dict(self.system.specifieds)
        system.ode_solver, system.times = self.system.ode_solver, self.system.times
        system.initial_conditions = dict(self.system.initial_conditions)
        system._contradicted = self.system._contradicted
        return system

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or not hasattr(System, name):
            raise AttributeError(f"Contacts have no attribute {name!r}.")
        if name in _TAKE_CONTACTS:
            raise AttributeError(f"Contacts have no `{name}`. Call system.{name}(contacts=…).")
        raise AttributeError(
            f"Contacts have no `{name}`: that of a System knows no transitions. A System of one "
            "combination of modes, which has it, is returned by `in_modes`."
        )

    def refuse_lost(self, constants: Mapping[Any, object]) -> None:
        """Refuse constants that lack those of the Contacts, which would default to 1.0."""
        if self.contact_constants.keys() <= constants.keys():
            return
        numbers = SymbolDict({**constants})
        if missing := [key for key in self.contact_constants if key not in numbers]:
            raise ValueError(
                f"`system.constants` has no value of `{missing[0]}`, "
                f"{self.contact_constants[missing[0]]} in `Contacts`: a dictionary that is "
                "assigned replaces all values. Give it one, or "
                "change others by `system.constants.update(...)`."
            )

    def motions(self, *arguments: Any) -> ContactMotions:
        """Return the motions of the samples of an ensemble, for `System.integrate_ensemble`."""
        return ContactMotions(self, *arguments)

    def gradient(
        self,
        wrt: object,
        final: ExpressionOrName | None,
        integral: ExpressionOrName | None,
        *,
        events: Event | Iterable[Event] | None = (),
        **options: Any,
    ) -> AdjointGradient:
        """Return the gradient of a motion, for `System.adjoint_gradient`."""
        from pydy.contact.backward import RecordedTransitions, gradient

        terms = {"final": final, "integral": integral}
        problem = self._problem(events)[0]
        run = self._run(problem, problem.settings.times, self.system.ode_solver, events, **options)
        run.transitions = RecordedTransitions(wrt, terms, run.rows, problem)
        return gradient(run)

    def _run(
        self,
        problem: Problem,
        times: np.ndarray,
        solver: object,
        events: Event | Iterable[Event] | None = (),
        **solver_kwargs: Any,
    ) -> ContactRun:
        """Return a simulation that has not started."""
        # The trajectory has everything that `full_output` would return.
        flag(solver_kwargs.pop("full_output", True), "`full_output`")
        enforcement = choice(solver_kwargs.get("constraints"), _ENFORCEMENTS, "`constraints`")
        if enforcement == "baumgarte" or not flag(
            solver_kwargs.get("dense_output", True), "`dense_output`"
        ):
            raise ValueError(
                "`constraints='baumgarte'` and `dense_output=False` are not supported with "
                "contacts."
            )
        if not isinstance(solver, Solver):
            raise ValueError(
                "Contacts need a native solver, which locates events: set `system.ode_solver = "
                "'dop853'`, or another one of pydy.solvers."
            )
        compiled = self._compiled(problem)
        user_events = check_events(events, problem.definition.places["states"])
        if any(e.reset for e in user_events):
            raise NotImplementedError("`events` with resets are not supported with contacts yet.")
        backward = "contacts cannot run backward: impacts and friction cannot be undone"
        times = read_times(problem, times, backward)
        if len(times) < 2 or times[0] == times[-1]:
            raise ValueError(
                "`times` must have at least two values that differ, got "
                f"{shown(times.tolist())}. Set `system.times`."
            )
        return ContactRun(compiled, solver, problem, times, user_events, solver_kwargs)


class ContactMotions:
    """The motions of the samples of an ensemble with contacts; a `pydy.ensemble.model.Motions`.

    Samples in several threads share the compiled modes.
    """

    def __init__(
        self,
        contacts: Contacts,
        problem: Problem,
        solver: Solver,
        specifieds: Mapping[AnySymbol, object],
        columns: Sequence[int],
        options: Mapping[str, Any],
    ) -> None:
        self.contacts, self.solver, self.options = contacts, solver, {**options}
        # The ensemble checks the assumptions for all samples.
        changed = {**problem.settings.specifieds, **specifieds}
        self._problem = replace(
            with_settings(problem, specifieds=changed, contradicted=None), hybrid=None
        )
        self.columns: tuple[str, ...] = ()
        requested, self._control = map(self.options.pop, ("sensitivities", "control_sensitivities"))
        if requested is not None:
            augmented = AugmentedSystem.for_parameters(
                problem, problem.model.code, problem.plan, requested
            )
            requested = [p.symbol for p in augmented.parameters]
            self.columns = column_names({p.symbol: p.count for p in augmented.parameters})
        self._parameters = requested
        events = self.options.pop("events", None)
        self._events = check_events(events, problem.definition.places["states"])
        definition, compiled = problem.definition, contacts._compiled(problem)
        self.outputs = compiled.outputs
        self.events = (*compiled.transitions, *(event.name for event in self._events))
        self._states, self._constants = definition.states, definition.constants
        self._varied = {definition.specifieds[k]: k for k in columns}

    @property
    def identity(self) -> tuple[object, ...]:
        """The data of a cache key, in addition to equations, numbers and options."""
        events = [
            (e.name, sm.srepr(e.expression), int(e.direction), bool(e.terminal))
            for e in self._events
        ]
        enforcement = self.options.get("constraints")
        settings = self.contacts.hypothesis, events, enforcement, self.columns, self._control
        return *settings, self.contacts._compiled(self._problem).rows.identity

    def __call__(
        self,
        x: np.ndarray,
        r: np.ndarray,
        p: np.ndarray,
        times: np.ndarray,
        stopped: Callable[[], bool],
    ) -> tuple[np.ndarray, np.ndarray, dict[str, Any]]:
        """Return states, outputs, and how the motion ended."""
        varied = {symbol: float(r[k]) for symbol, k in self._varied.items()}
        problem = with_settings(
            self._problem,
            constants=dict(zip(self._constants, p.tolist(), strict=True)),
            specifieds={**self._problem.settings.specifieds, **varied},
            initial_conditions=dict(zip(self._states, x.tolist(), strict=True)),
            times=times,
        )
        run = self.contacts._run(problem, times, self.solver, self._events, **self.options)
        if self._parameters is not None:
            run.transitions = HybridSensitivities(
                self._parameters, self._control, run.rows, problem
            )
        run.stopped = stopped
        code, motion = Outcome.FINISHED, None
        try:
            motion = run.motion()
            end = motion.segments[-1].end
            code = Outcome.FINISHED if run.reached == len(times) else Outcome.TERMINATED
        except StartError:
            code, end = Outcome.START_OFF_CONSTRAINTS, float(times[0])
        except ContactError as error:
            motion, end = run.motion_so_far(), error.time
            failure = getattr(error.__cause__, "info", None) or {}
            code = failure.get("code", Outcome.CONTACTS_IMPOSSIBLE)
        happened = [] if motion is None else motion.events
        records = [replace(record, index=self.events.index(record.name)) for record in happened]
        info = {**run.totals, "code": int(code), "time": end, "events": records, "nearness": 1.0}
        if motion is None:
            return np.empty((0, len(x))), np.empty((0, len(self.outputs))), info
        if self.columns:
            sensitivities = motion.trajectory.sensitivity
            info["columns"] = np.concatenate([sensitivities.values, sensitivities.outputs], axis=1)
        if code == Outcome.TERMINATED:
            info["end_outputs"] = motion.trajectory.at([end]).outputs[0]
        return motion.states, motion.trajectory.outputs, info
