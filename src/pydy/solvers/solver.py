"""The public solvers: objects with odeint's signature."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import FunctionType
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np

from pydy._checks import instance, monotonic, real_array, shown
from pydy._errors import warn_user
from pydy._forks import fork_lock
from pydy.solvers.options import EventContinuation, read_options
from pydy.solvers.outcome import Outcome
from pydy.solvers.tableaus import Tableau, add_tableau, tableau_of

if TYPE_CHECKING:
    from typing import Unpack

    from numpy.typing import ArrayLike

    from pydy._kernel import KernelCall
    from pydy.solvers.options import SolverOptions
    from pydy.solvers.run.integration import Integration

_FLOAT = np.dtype(float)
_IMMUTABLE = frozenset((float, int, bool))  # an array may be edited between two calls


class Solver:
    """An integration method in machine code, with the signature of `scipy.integrate.odeint`.

    There is one object for each method: `pydy.solvers.dop853` and so on.

    Attributes
    ----------
    name : str
    adaptive : bool
        Whether it controls its step size.

    Examples
    --------
    >>> import numpy as np
    >>> from pydy.solvers import dop853
    >>> x = dop853(lambda x, t: [x[1], -x[0]], [1.0, 0.0], [0.0, np.pi], rtol=1e-10, atol=1e-10)
    >>> x.round(8) + 0.0
    array([[ 1.,  0.],
           [-1.,  0.]])
    """

    def __init__(self, name: str, adaptive: bool) -> None:
        self.name = name
        self.adaptive = adaptive

    def __repr__(self) -> str:
        return f"pydy.solvers.{self.name}"

    def __reduce__(self) -> str | tuple[Callable[[Tableau], Solver], tuple[Tableau]]:
        if SOLVERS.get(self.name) is self:
            return self.name  # unpickled as the one object of this method
        return Solver.from_tableau, (tableau_of(self.name),)

    @classmethod
    def from_tableau(cls, tableau: Tableau) -> Solver:
        """Return a solver for your own explicit Runge–Kutta method.

        It uses the compiled loops of the other explicit methods: nothing else is compiled.

        Parameters
        ----------
        tableau : Tableau

        Raises
        ------
        ValueError
            The tableau is not consistent, or another method has its name.

        Examples
        --------
        >>> import numpy as np
        >>> from pydy.solvers import Solver, Tableau
        >>> heun = Solver.from_tableau(Tableau(
        ...     name="heun", order=2, error_order=1, nodes=(0.0, 1.0, 1.0),
        ...     stages=({}, {0: 1.0}), weights={0: 0.5, 1: 0.5}, errors=({0: -0.5, 1: 0.5},),
        ... ))
        >>> x = heun(lambda x, t: [-x[0]], [1.0], [0.0, 1.0], rtol=1e-6, atol=1e-6)
        >>> bool(abs(x[-1, 0] - np.exp(-1.0)) < 1e-5)
        True
        """
        instance(tableau, Tableau, "`tableau`")
        if tableau.name in SOLVERS:
            raise ValueError(
                f"`tableau` has the name {tableau.name!r}, which is that of a solver of the "
                "package; give it another one."
            )
        add_tableau(tableau)
        return cls(tableau.name, tableau.error_order is not None)

    @overload
    def __call__(
        self,
        f: Callable[..., ArrayLike],
        x0: ArrayLike,
        t: ArrayLike,
        args: object = (),
        *,
        full_output: Literal[False] = False,
        **options: Unpack[SolverOptions],
    ) -> np.ndarray: ...

    @overload
    def __call__(
        self,
        f: Callable[..., ArrayLike],
        x0: ArrayLike,
        t: ArrayLike,
        args: object = (),
        *,
        full_output: Literal[True],
        **options: Unpack[SolverOptions],
    ) -> tuple[np.ndarray, dict[str, Any]]: ...

    def __call__(
        self,
        f: Callable[..., ArrayLike],
        x0: ArrayLike,
        t: ArrayLike,
        args: object = (),
        **options: Any,
    ) -> Any:
        """Integrate ``x' = f(x, t, *args)``.

        Parameters
        ----------
        f : callable
            A function made by `System` or `generate_ode_function` runs without Python; any other
            function is called back.
        x0 : array_like, shape (n,)
        t : array_like, shape (m,)
            Times at which the states are returned, ascending or descending; the state at the first
            one is `x0`, and descending times integrate backward. Equal times may follow each other.
        args : tuple, optional
            Further arguments of `f`.
        rtol, atol : float or array_like, shape (n,), optional
            The error allowed in a step is ``atol + rtol * abs(x)``.
        first_step, max_step : float, optional
        max_steps : int, optional
            Accepted and rejected steps together, 10 million by default.
        step : float
            Only for `rk4`, instead of tolerances: the step size. Each interval between two times is
            divided into equal steps not larger than this.
        full_output : bool, optional
        progress : bool, optional
            Show a progress bar of simulated time.
        dense_output : bool, optional
            Record the steps, up to 128 MB of them: with `full_output`, ``info['dense_output']`` is
            then a function of monotonic times, shape (k,), that returns the states, shape (k, n),
            by the interpolant of the method; None if they needed more memory.
        events, constraints
            Made by `System.integrate` from its arguments of these names.

        Returns
        -------
        x : ndarray, shape (m, n)
            NaN after the time at which an event ended the integration.
        info : dict
            Only with `full_output`: ``'steps'``, ``'rejected'``, ``'evaluations'``,
            ``'jacobians'``, ``'last_step'`` (its size), ``'time'`` (where it ended), ``'code'`` and
            ``'status'`` (how it ended: a number, 0 when finished, and the same in words),
            ``'events'`` (list of `EventRecord`), ``'nearness'`` (the least that constraints held by
            projection came to losing rank; 1 without).

        Raises
        ------
        TypeError
            An option is unknown or has the wrong type.
        ValueError
            A value is not valid; or times descend, and an event has a reset.
        IntegrationError
            The integration could not continue; the error contains the results so far.
        IntegrationInterrupted
            The user interrupted it; the exception contains the results so far.
        """
        key = (self.name, *options.items(), *map(type, options.values()))
        prepared = _take_prepared(f, key, x0, t, args)
        if prepared is None:
            prepared = self.prepare(f, x0, t, args, **options)
            prepared.key = key
            x0 = prepared.x0
        states = prepared(x0)
        result = (states, prepared.info) if options.get("full_output") else states
        _store_prepared(f, prepared)
        return result

    def prepare(
        self,
        f: Callable[..., ArrayLike],
        x0: ArrayLike,
        t: ArrayLike,
        args: object = (),
        **options: Unpack[SolverOptions],
    ) -> Prepared:
        """Prepare an integration that is run many times from different initial states.

        Arguments are checked and memory is allocated once, here: a short integration then takes
        only a few microseconds. The parameters are those of a call.

        Returns
        -------
        Prepared
            ``prepared(x0)`` returns the states, shape (m, n).

        Examples
        --------
        >>> from pydy.solvers import dop853
        >>> swing = dop853.prepare(lambda x, t: [x[1], -x[0]], [1.0, 0.0], [0.0, 0.5], rtol=1e-9)
        >>> [round(float(swing([angle, 0.0])[-1, 0]), 6) for angle in (1.0, 2.0)]
        [0.877583, 1.755165]
        """
        if not callable(f):
            raise TypeError(f"`f` must be a function f(x, t), got {shown(f)}.")
        read = read_options(self.name, self.adaptive, options)
        x0 = np.atleast_1d(real_array(x0, "`x0`"))
        if x0.ndim != 1:
            raise ValueError(f"`x0` must be one-dimensional, got the shape {x0.shape}.")
        if not np.isfinite(x0).all():
            raise ValueError(f"`x0` must be finite, got {x0}.")
        times = _checked_times(t)
        if not isinstance(args, tuple):
            args = (args,)
        return _prepared(self.name, f, x0, times, args, read)


def _prepared(name: str, f: Callable[..., ArrayLike], x0: np.ndarray, *arguments: Any) -> Prepared:
    """Return a prepared integration, which pickles as its arguments."""
    with fork_lock:
        from pydy.solvers.run.integration import Integration

    prepared = Prepared(Integration(name, f, len(x0), *arguments), x0)
    prepared.arguments = (name, f, x0, *arguments)
    return prepared


def _checked_times(times: ArrayLike) -> np.ndarray:
    array = monotonic(times, "`t`")
    if not array.size:
        raise ValueError("`t` must have one time or more, got none.")
    return array


# -- repeated calls: checking options and allocating memory would take most of a short one ---------


def _store_prepared(f: Callable[..., ArrayLike], prepared: Prepared) -> None:
    """Store an integration in its function, for the next call with these options."""
    immutable = _IMMUTABLE.issuperset(prepared.key[1 + len(prepared.key) // 2 :])
    if immutable and prepared.reusable and type(f) is FunctionType:
        f.__dict__["_prepared"] = prepared


def _take_prepared(
    f: Callable[..., ArrayLike], key: tuple[object, ...], x0: ArrayLike, t: Any, args: object
) -> Prepared | None:
    """Take the integration that an earlier call stored if it fits; no other thread can take it."""
    prepared: Prepared | None
    if type(f) is not FunctionType or (prepared := f.__dict__.pop("_prepared", None)) is None:
        return None
    fits = type(args) is tuple and _same_layout(x0, prepared.x0) and _same_layout(t, prepared.times)
    if not fits or key != prepared.key:
        return None
    if t.tobytes() != prepared.times.tobytes():
        _checked_times(t)
    native: Callable[[object], KernelCall] = f.__dict__["native"]
    return prepared if prepared.rebind(native(args), t) else None


def _same_layout(array: object, stored: np.ndarray) -> bool:
    return type(array) is np.ndarray and array.dtype is _FLOAT and array.shape == stored.shape


class Prepared:
    """An integration that is ready to run; see `Solver.prepare`.

    It has a single workspace: use a separate one in each thread.

    Attributes
    ----------
    x0 : ndarray, shape (n,)
        The initial state it was prepared with.
    reusable : bool
        Whether ``rebind(call, times)`` may assign it to another call of the same function.
    renumber : callable
        ``renumber(p, r, times)`` changes the numbers, or returns False if that is impossible.
    on_many_steps : callable, optional
        ``on_many_steps(steps, t, x)`` is called once in a run that takes more steps than that.
    """

    def __init__(self, integration: Integration, x0: np.ndarray) -> None:
        self.x0 = x0
        self.key: tuple[object, ...] = ()
        self.arguments: tuple[Any, ...] = ()
        self._integration = integration
        self._shape = x0.shape
        self._run = integration.run
        self.reusable = integration.reusable
        self.renumber, self.rebind = integration.renumber, integration.rebind

    def __call__(self, x0: ArrayLike) -> np.ndarray:
        """Return the states at the prepared times, shape (m, n), from another initial state.

        Raises
        ------
        ValueError
            `x0` has the wrong shape or is not finite.
        IntegrationError, IntegrationInterrupted
            As for a call of the solver.
        """
        if type(x0) is not np.ndarray or x0.dtype is not _FLOAT or x0.shape != self._shape:
            x0 = np.atleast_1d(real_array(x0, "`x0`"))
            if x0.shape != self._shape:
                raise ValueError(f"`x0` must have the shape {self._shape}, got {x0.shape}.")
        states = self._run(x0)
        events = self._integration.options.events
        run = self._integration
        if events is not None and (
            any(event.may_rest for event in events.traits)
            or run.departures_from_zero
            or run.inactive_at_start
        ):
            for warning in run.event_warnings():
                warn_user(warning)
        if self._integration.code == Outcome.EVENTS_ACCUMULATE:
            info, event = self.info, self._integration.details["event"]
            warn_user(
                f"`{info['method']}` stopped at t = {info['time']!r}: the events `{event}` follow "
                "each other ever faster and accumulate there (Zeno behaviour). "
                f"{Outcome.EVENTS_ACCUMULATE.remedy}"
            )
        return states

    def retune(self, solver: Solver, options: Mapping[str, object]) -> bool:
        """Change tolerances and step sizes of the same solver; return False if that is impossible.

        Raises
        ------
        TypeError, ValueError
            As for a call of the solver.
        """
        read = read_options(solver.name, solver.adaptive, options)
        if not self._integration.retune(read):
            return False
        self.arguments = (*self.arguments[:-1], read)
        return True

    def __reduce__(self) -> tuple[Callable[..., Prepared], tuple[Any, ...]]:
        if self._integration.rebound:
            raise TypeError(
                "A prepared integration whose numbers were changed cannot be pickled or copied: "
                "prepare another one with these numbers."
            )
        return _prepared, self.arguments

    @property
    def on_many_steps(self) -> Callable[[int, float, np.ndarray], None] | None:
        """A function that is called once in a run that takes very many steps."""
        return self._integration.on_many_steps

    @on_many_steps.setter
    def on_many_steps(self, call: Callable[[int, float, np.ndarray], None] | None) -> None:
        self._integration.on_many_steps = call

    @property
    def continuation(self) -> EventContinuation | None:
        """The state of the events if the next run continues another one."""
        return self._integration.continuation

    @continuation.setter
    def continuation(self, value: EventContinuation | None) -> None:
        self._integration.continuation = value

    @property
    def times(self) -> np.ndarray:
        """The times at which states are returned, shape (m,)."""
        return self._integration.times

    @property
    def info(self) -> dict[str, Any]:
        """The `info` of the latest run, as with `full_output`."""
        return self._integration.info()


dop853 = Solver("dop853", adaptive=True)
tsit5 = Solver("tsit5", adaptive=True)
vern9 = Solver("vern9", adaptive=True)
rk4 = Solver("rk4", adaptive=False)
radau = Solver("radau", adaptive=True)

SOLVERS = {solver.name: solver for solver in (dop853, tsit5, vern9, rk4, radau)}
