"""Interpolate states and sensitivities of a trajectory, and continue motions after their end."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache, partial
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, TypeVar

import numpy as np

from pydy._checks import descends, monotonic, number, real_array, shown
from pydy._names import nearest

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from pydy._sympy_types import SymbolOrName


@lru_cache(maxsize=64)
def evenly(count: int, most: int) -> np.ndarray:
    """Return at most `most` evenly spaced indices below `count`, including the last one.

    All callers share the array, which is read-only.
    """
    indices = np.unique(np.linspace(0, count - 1, min(count, most)).astype(int))
    indices.flags.writeable = False
    return indices


class Model(Protocol):
    """The interface of a trajectory's model, evaluated at times (m,) and states (m, n)."""

    def derivatives(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return x', shape (m, n)."""

    def outputs(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the outputs, shape (m, o)."""

    def specifieds(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the specifieds, shape (m, s)."""

    def energy(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return kinetic, potential and total energy, shape (m, 3)."""

    def jumps(self) -> np.ndarray:
        """Return the times at which sampled inputs jump."""

    def scene(self, *visuals: object, **options: object) -> Any:
        """Return a scene that shows the model."""


class SensitivityModel(Protocol):
    """The interface of the model of a trajectory's sensitivities.

    At times (m,), states (m, n) and sensitivities of the states (m, n, k).
    """

    def rates(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the derivatives of the sensitivities by time, shape (m, n, k)."""

    def outputs(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the sensitivities of the outputs, shape (m, o, k)."""


class EventStates(Protocol):
    """The interface of a record of an event: the states and sensitivities on both sides of it."""

    @property
    def time(self) -> float: ...
    @property
    def before(self) -> np.ndarray: ...
    @property
    def after(self) -> np.ndarray: ...
    @property
    def sensitivity_before(self) -> np.ndarray | None: ...
    @property
    def sensitivity_after(self) -> np.ndarray | None: ...


class SensitivityTable(Protocol):
    """The interface of a trajectory's `sensitivity`."""

    values: np.ndarray
    names: tuple[str, ...]

    def table(self) -> np.ndarray:
        """Return the derivatives of all states and outputs, shape (m, n + o, k)."""


class Interpolated(Protocol):
    """The interface of `pydy.trajectory.Trajectory`, whose module imports this one."""

    times: np.ndarray
    states: np.ndarray
    outputs: np.ndarray
    specifieds: np.ndarray
    _derivatives: np.ndarray | None
    _energy: np.ndarray | None
    _dense: Callable[[np.ndarray], np.ndarray] | None
    _model: Model | None
    _sides: Sides | None
    _sensitivity_model: SensitivityModel | None

    @property
    def derivatives(self) -> np.ndarray: ...
    @property
    def events(self) -> tuple[EventStates, ...]: ...
    @property
    def _jumps(self) -> tuple[EventStates, ...]: ...
    @property
    def _sensitivity(self) -> SensitivityTable | None: ...
    @property
    def _known_sensitivity(self) -> SensitivityTable | None: ...
    @property
    def _sensitivities(self) -> tuple[Mapping[SymbolOrName, int], np.ndarray] | None: ...
    def _keep_jumps(self) -> None: ...
    def at(self, times: ArrayLike) -> Interpolated: ...


AnyTrajectory = TypeVar("AnyTrajectory", bound=Interpolated)


def check_sensitivities(value: object, shape: tuple[int, int]) -> None:
    """Refuse a value that is not a pair of parameters and derivatives of states with `shape`."""
    if not (isinstance(value, (tuple, list)) and len(value) == 2 and isinstance(value[0], Mapping)):
        raise TypeError(
            "`sensitivities` must be a pair, (parameters, values), of a dictionary and an array, "
            f"got {shown(value)}."
        )
    expected = (*shape, sum(value[0].values()))
    if (actual := np.shape(value[1])) != expected:
        raise ValueError(
            f"`sensitivities` must have values of the shape {expected}, by the numbers of columns "
            f"of its parameters, got {actual}."
        )


def checked_times(times: object, trajectory: Interpolated) -> np.ndarray:
    """Check that times ascend or descend and lie within those of a trajectory."""
    if hasattr(times, "states") and hasattr(times, "times"):
        raise TypeError("`times` must be numbers, got a Trajectory: pass its `times`.")
    checked = monotonic(np.atleast_1d(real_array(times, "`times`")), "`times`")
    limits = _simulated_times(trajectory)
    first, last = _span(limits)
    outside = checked[~((checked >= first) & (checked <= last))]
    if outside.size:
        raise ValueError(
            f"`times` must be within the simulated time, {limits[0]} to {limits[-1]}, got "
            f"{outside[0]}."
        )
    return checked


def _simulated_times(trajectory: Interpolated) -> np.ndarray:
    """Return the first and last time of a trajectory, or of an event beyond its samples."""
    times = trajectory.times
    if not len(times):
        return times
    every = [times[0], times[-1], *(event.time for event in trajectory.events)]
    return np.array([max(every), min(every)] if descends(times) else [min(every), max(every)])


def _span(times: np.ndarray) -> tuple[float, float]:
    """Return the first and last of monotonic times in ascending order; (inf, -inf) if empty."""
    if not len(times):
        return np.inf, -np.inf
    return min(times[0], times[-1]), max(times[0], times[-1])


def in_order(trajectory: AnyTrajectory) -> AnyTrajectory:
    """Return a trajectory with ascending times: itself, or its rows in the opposite order."""
    is_descending = hasattr(trajectory, "_sensitivities") and descends(trajectory.times)
    return reversed_rows(trajectory) if is_descending else trajectory


def reversed_rows(trajectory: AnyTrajectory) -> AnyTrajectory:
    """Return a copy of a Trajectory with its rows in reverse order."""
    copied: Any = object.__new__(type(trajectory))
    copied.__dict__.update(trajectory.__dict__)
    for name in ("times", "states", "outputs", "specifieds", "_derivatives", "_energy"):
        table = getattr(trajectory, name)
        setattr(copied, name, None if table is None else table[::-1].copy())
    if trajectory._sensitivities is not None:
        parameters, values = trajectory._sensitivities
        copied._sensitivities, copied._known_sensitivity = (parameters, values[::-1].copy()), None
    elif (sensitivity := trajectory._known_sensitivity) is not None:  # of a file
        copied._take_sensitivity(sensitivity.names, sensitivity.table()[::-1].copy())
    reversed_trajectory: AnyTrajectory = copied
    return reversed_trajectory


def filled(trajectory: Any, step_of: Callable[[float], float]) -> Any:
    """Refine a trajectory where its times are two or more steps apart.

    `step_of` returns the step for a time span. The times of the result ascend. A dataset, and a
    trajectory without the solver's dense output, are returned as they are: their values between
    their times are unknown.
    """
    trajectory = in_order(trajectory)
    if getattr(trajectory, "_dense", None) is None or len(trajectory.times) < 2:
        return trajectory
    times = trajectory.times
    gaps = np.diff(times)
    parts = np.maximum(np.floor(gaps / step_of(float(times[-1] - times[0]))), 1.0).astype(int)
    if not (parts > 1).any():
        return trajectory
    k = np.repeat(np.arange(len(gaps)), parts)
    part = np.arange(len(k)) - (np.cumsum(parts) - parts)[k]
    return trajectory.at(np.append(times[k] + gaps[k] * (part / parts[k]), times[-1]))


# Most points within the solver's steps at which a curve is evaluated: 0.3 s for chains of 20 links.
STEPS = 100_000
# Points in a step, which may be half a period long: at most 0.5 % of an amplitude are missed.
PARTS = 16


def detailed(trajectory: Any, step_of: Callable[[float], float]) -> Any:
    """Refine a trajectory for curves, so that narrow peaks and jumps are visible.

    The result has the times of `filled`, those of the solver's steps and points within them. At
    events and jumps of inputs it has one row for each side, at the same time.
    """
    if isinstance(getattr(trajectory, "_detail", None), Detail):
        return trajectory
    trajectory = in_order(trajectory)
    refined = filled(trajectory, step_of)
    starts = getattr(getattr(trajectory, "_dense", None), "starts", None)
    if starts is not None and len(trajectory.times) > 1:
        first, last = _span(trajectory.times)
        nodes = np.append(np.unique(np.clip(starts, first, last)), last)
        parts = int(np.clip(STEPS // len(nodes), 1, PARTS))
        inside = nodes[:-1, None] + np.diff(nodes)[:, None] * (np.arange(parts) / parts)
        additional = np.setdiff1d(inside, refined.times)
        if len(additional):
            refined = trajectory.at(np.sort(np.concatenate([refined.times, additional])))
    return _with_sides(trajectory, refined)


def _with_sides(trajectory: Interpolated, refined: Interpolated) -> Interpolated:
    """Insert the rows of both sides of the trajectory's events into its refinement."""
    if not hasattr(trajectory, "_sensitivities") or not len(refined.times):
        return refined
    trajectory._keep_jumps()
    if not breaks(trajectory) or (trajectory._model is None and trajectory._sides is None):
        return refined
    moments, states = _at_events(trajectory)
    first, last = _span(refined.times)
    inside = (moments >= first) & (moments <= last)
    if not inside.any():
        return refined
    m, moments, states = len(refined.times), moments[inside], states[inside]
    is_before = np.tile([True, False], len(moments) // 2)
    # The model is evaluated just before the event, with the modes and inputs that end there.
    evaluated_at = np.where(is_before, np.fmax(np.nextafter(moments, -np.inf), first), moments)
    model = trajectory._model
    if trajectory._sides is not None:
        rates, outputs, specifieds = (table[inside] for table in trajectory._sides)
    else:
        rates = None
        assert model is not None
        outputs = model.outputs(evaluated_at, states)
        specifieds = model.specifieds(evaluated_at, states)
    # Of each quantity: its rows at the refined times, and those at both sides of each event.
    tables = [
        (refined.states, states),
        (refined.outputs, np.reshape(outputs, (len(moments), -1))),
        (refined.specifieds, np.reshape(specifieds, (len(moments), -1))),
        (refined.times[:, None], evaluated_at[:, None]),
    ]
    if rates is not None and refined._derivatives is not None:
        tables.append((refined._derivatives, rates))

    def interpolated(table: np.ndarray) -> np.ndarray:
        """Return the rows of a table whose values at the events are not known."""
        flat = table.reshape(m, -1)
        return straight(refined, moments, flat, None).reshape(len(moments), *table.shape[1:])

    energy, values, table = None, None, None
    if model is None and refined._energy is not None:
        energy = refined._energy
        tables.append((energy, interpolated(energy)))
    if refined._sensitivities is not None:
        values = refined._sensitivities[1]
        sides = _sensitivities_at(trajectory)
        tables.append((values, interpolated(values) if sides is None else sides[inside]))
    elif refined._known_sensitivity is not None:  # of a file
        table = refined._known_sensitivity.table()
        tables.append((table, interpolated(table)))
    times, merged = _with_events(refined, moments, tables)
    result: Any = object.__new__(type(refined))
    result.__dict__.update(refined.__dict__)
    result.times = times
    result.states, result.outputs, result.specifieds, evaluated_at, *remaining = merged
    result._derivatives = remaining.pop(0) if len(tables) > 4 and tables[4][1] is rates else None
    result._energy = remaining.pop(0) if energy is not None else None
    if values is not None:
        assert refined._sensitivities is not None
        result._sensitivities, result._known_sensitivity = (
            (refined._sensitivities[0], remaining.pop(0)),
            None,
        )
    elif table is not None:
        assert refined._known_sensitivity is not None
        result._take_sensitivity(refined._known_sensitivity.names, remaining.pop(0))
    result._detail = Detail(model, evaluated_at[:, 0])
    result._model = None if model is None else result._detail
    sensitivity_model = refined._sensitivity_model
    result._sensitivity_model = (
        None if sensitivity_model is None else Detail(sensitivity_model, evaluated_at[:, 0])
    )
    complete: Interpolated = result
    return complete


class Detail:
    """A model that is evaluated just before an event for rows that have the event's time.

    It is the model or sensitivity model of a Trajectory that `detailed` returned. `times` are those
    of the model, one for each row of that Trajectory.
    """

    def __init__(self, model: Model | SensitivityModel | None, times: np.ndarray) -> None:
        self.model, self.times = model, times
        for name in ("derivatives", "outputs", "specifieds", "energy", "rates"):
            if hasattr(model, name):
                setattr(self, name, partial(self._evaluate, name))

    def _evaluate(self, name: str, times: np.ndarray, *tables: np.ndarray) -> np.ndarray:
        result: np.ndarray = getattr(self.model, name)(self.times, *tables)
        return result


class Sides(NamedTuple):
    """Quantities on both sides of breaks, other than the states: rows before and after each."""

    derivatives: np.ndarray
    outputs: np.ndarray
    specifieds: np.ndarray

    @classmethod
    def of_trajectory(cls, trajectory: Interpolated) -> Sides:
        """Return those stored in a file's Trajectory, or evaluate its model at the breaks."""
        if trajectory._sides is not None:
            return trajectory._sides
        moments, states = _at_events(trajectory)
        # Just before the event, with the modes and inputs that end there.
        moments[::2] = np.fmax(np.nextafter(moments[::2], -np.inf), _span(trajectory.times)[0])
        model, rows = trajectory._model, len(moments)
        assert model is not None
        tables = (f(moments, states) for f in (model.derivatives, model.outputs, model.specifieds))
        return cls(*(np.reshape(table, (rows, -1)) for table in tables))

    @classmethod
    def concatenated(cls, parts: Sequence[Mapping[str, np.ndarray] | None]) -> Sides | None:
        """Concatenate those of each break; older files have none."""
        tables = [part for part in parts if part is not None]
        if not tables or len(tables) < len(parts):
            return None
        return cls(*(np.concatenate([part[name] for part in tables]) for name in cls._fields))


def states_between(
    trajectory: Interpolated, times: np.ndarray
) -> tuple[np.ndarray, np.ndarray | None]:
    """Interpolate the states of a Trajectory, and its sensitivities if it has any.

    The times ascend.
    """
    trajectory = in_order(trajectory)
    m, n = trajectory.states.shape
    values = None if trajectory._sensitivity is None else trajectory._sensitivity.values
    interpolated = (
        trajectory._dense(times) if trajectory._dense else _hermite(trajectory, times, values)
    )
    if values is None:
        return interpolated, None
    if interpolated.shape[1] == n:  # no derivatives by time: straight lines
        sides = _sensitivities_at(trajectory)
        sides = None if sides is None else sides.reshape(len(sides), -1)
        interpolated = np.hstack(
            [interpolated, straight(trajectory, times, values.reshape(m, -1), sides)]
        )
    return interpolated[:, :n].copy(), interpolated[:, n:].reshape(len(times), n, values.shape[2])


def breaks(trajectory: Interpolated) -> tuple[EventStates, ...]:
    """Return the records at which derivatives jump: events, and stored jumps of inputs."""
    records: tuple[EventStates, ...] = trajectory.events + trajectory._jumps
    return records


def states_at_jumps(trajectory: Interpolated) -> list[tuple[float, np.ndarray, np.ndarray | None]]:
    """Return times, states and sensitivities at jumps of a Trajectory's inputs, without events."""
    if trajectory._dense is None or trajectory._model is None:
        return []
    jumps = np.setdiff1d(trajectory._model.jumps(), [event.time for event in trajectory.events])
    first, last = _span(trajectory.times)
    times = jumps[(jumps > first) & (jumps <= last)]
    states, columns = states_between(trajectory, times)
    sensitivities = [None] * len(times) if columns is None else columns
    return list(zip(times.tolist(), states, sensitivities, strict=True))


def _hermite(trajectory: Interpolated, times: np.ndarray, values: np.ndarray | None) -> np.ndarray:
    """Interpolate states, followed by sensitivities if their derivatives are known."""
    nodes = trajectory.times
    x, rates = _with_sensitivities(
        trajectory, nodes, trajectory.states, trajectory.derivatives, values
    )
    if trajectory._sides is not None or (breaks(trajectory) and trajectory._model is not None):
        moments, sides = _at_events(trajectory)
        columns = None if values is None else _sensitivities_at(trajectory)
        event_tables = _with_sensitivities(
            trajectory, moments, sides, Sides.of_trajectory(trajectory).derivatives, columns
        )
        nodes, (x, rates) = _with_events(
            trajectory, moments, zip((x, rates), event_tables, strict=True)
        )
    elif any((e.before != e.after).any() for e in trajectory.events):
        raise ValueError(
            "The trajectory has events that change states, and does not know how these go on from "
            "there: it was created or saved without. Use the Trajectory that `System.simulate` "
            "returned, or save that again."
        )
    k, after, h, s = _brackets(nodes, times)
    value = x[k] + (3.0 - 2.0 * s) * s**2 * (x[after] - x[k])
    slope = h * s * (1.0 - s) * ((1.0 - s) * rates[k] - s * rates[after])
    result: np.ndarray = value + slope
    return result


def straight(
    trajectory: Interpolated, times: np.ndarray, table: np.ndarray, sides: np.ndarray | None
) -> np.ndarray:
    """Interpolate a table of a Trajectory linearly, discontinuously at the `sides` of events."""
    nodes = trajectory.times
    if sides is not None:
        nodes, (table,) = _with_events(trajectory, _at_events(trajectory)[0], [(table, sides)])
    k, after, _, s = _brackets(nodes, times)
    result: np.ndarray = table[k] + s * (table[after] - table[k])
    return result


def _brackets(nodes: np.ndarray, times: np.ndarray) -> tuple[np.ndarray, ...]:
    """Return the nodes before and after each time, their distance, and the elapsed fraction."""
    # The last of equal nodes, so that the interval has a length if possible.
    k = np.clip(np.searchsorted(nodes, times, side="right") - 1, 0, len(nodes) - 1)
    after = np.minimum(k + 1, len(nodes) - 1)
    h = (nodes[after] - nodes[k])[:, None]
    s = np.divide((times - nodes[k])[:, None], h, out=np.zeros_like(h), where=h > 0.0)
    return k, after, h, s


def _with_sensitivities(
    trajectory: Interpolated,
    times: np.ndarray,
    states: np.ndarray,
    rates: np.ndarray,
    values: np.ndarray | None,
) -> tuple[np.ndarray, np.ndarray]:
    """Append sensitivities to states, and their time derivatives to those of the states."""
    model, m = trajectory._sensitivity_model, len(times)
    if model is None or values is None:
        return states, rates
    slopes = model.rates(times, states, values)
    return (
        np.concatenate([states, values.reshape(m, -1)], axis=1),
        np.concatenate([rates, slopes.reshape(m, -1)], axis=1),
    )


def _at_events(trajectory: Interpolated) -> tuple[np.ndarray, np.ndarray]:
    """Return the times of both sides of each event, and the states there."""
    moments = np.repeat([e.time for e in breaks(trajectory)], 2)
    return moments, np.array([side for e in breaks(trajectory) for side in (e.before, e.after)])


def _sensitivities_at(trajectory: Interpolated) -> np.ndarray | None:
    """Return the sensitivities of the states on both sides of each event, if all have them."""
    pairs = [(e.sensitivity_before, e.sensitivity_after) for e in breaks(trajectory)]
    values = [value for pair in pairs for value in pair]
    return None if not values or any(v is None for v in values) else np.array(values)


def _with_events(
    trajectory: Interpolated, moments: np.ndarray, tables: Iterable[tuple[np.ndarray, np.ndarray]]
) -> tuple[np.ndarray, list[np.ndarray]]:
    """Insert both sides of each event into the times, and into tables with rows for these."""
    # A node at the time of an event may belong to either side: replace it by both.
    elsewhere = ~np.isin(trajectory.times, moments)
    nodes = np.concatenate([moments, trajectory.times[elsewhere]])
    order = np.argsort(nodes, kind="stable")
    return nodes[order], [
        np.concatenate([event_rows, t[elsewhere]])[order] for t, event_rows in tables
    ]


# -- Continuation ---------------------------------------------------------------------------------


class Continuation(NamedTuple):
    """The end of a motion, and how it is continued."""

    end: float  # also at a terminal event
    refusal: str  # why the motion cannot be continued, or ''
    # Returns the Trajectory at further times, which begin at the end.
    proceed: Callable[[np.ndarray], Interpolated] | None


# Names that other libraries use for what a Trajectory has.
_OF_OTHER_LIBRARIES = {
    "to_csv": "`to_dataframe().to_csv(path)`",
    "to_excel": "`to_dataframe().to_excel(path)`",
    "to_netcdf": "`save(path)`",
    "to_numpy": "`states`",
    "t": "`times`",
    "y": "`states`, with a row for each time",
}


class Continued:
    """A motion that may be continued; the base of `pydy.trajectory.Trajectory`."""

    times: np.ndarray
    _continuation: Continuation | None = None
    # Attributes that describe the full motion, such as modes of contacts: they are copied to
    # trajectories at other times, and to files (as JSON).
    _facts: Mapping[str, object] = {}

    if not TYPE_CHECKING:  # or type checkers would let any attribute pass

        def __getattr__(self, name: str) -> Any:
            # Called for what there is not.
            if name[0] != "_" and name in vars(self).get("_columns", ()):
                raise AttributeError(
                    f"A trajectory has no attribute `{name}`. Use `trajectory['{name}']` for the "
                    "quantity.",
                    name=name,
                )
            if (meant := _OF_OTHER_LIBRARIES.get(name)) is not None:
                raise AttributeError(f"A trajectory has no `{name}`. Use {meant}.", name=name)
            if name[0] != "_" and not hasattr(type(self), name):
                public = [n for n in dir(self) if n[0] != "_"]
                if hint := nearest(name, public, or_all=False):
                    raise AttributeError(f"A trajectory has no `{name}`. {hint}", name=name)
            return object.__getattribute__(self, name)  # its error says the rest

    def _describe(self, facts: Mapping[str, object]) -> None:
        """Set the attributes that describe the full motion."""
        self._facts = facts
        vars(self).update(facts)

    def continue_to(self, t: float | Sequence[float] | np.ndarray) -> Any:
        """Simulate on from where this motion ended, and return the motion from there on.

        It starts from the last state, that after the event if an event ended the motion, with the
        constants, specifieds, solver, options, events, and modes of contacts of this motion. Events
        at the end of this one are not counted again.

        Parameters
        ----------
        t : float or array_like, shape (m,)
            The last time: there are as many times as this trajectory has. Or the times, ascending;
            the end of this motion is put before them.

        Returns
        -------
        Trajectory

        Raises
        ------
        ValueError
            A time is before the end of this motion. Events accumulate at the end. Or the end is not
            known: of a trajectory that was loaded, pickled or made by `at`.
        NotImplementedError
            The motion has sensitivities.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.initial_conditions = {'x0': 1.0}
        >>> system.times = [0.0, 0.5]
        >>> system.simulate().continue_to(1.0)['x0'].round(6)
        array([0.895595, 0.6597  ])
        """
        if self._continuation is None:
            raise ValueError(
                "This trajectory does not know how to go on: it was loaded, pickled, or made at "
                "other times. Continue what `simulate` returned, or set the initial conditions and "
                "`system.times` and simulate again."
            )
        end, refusal, proceed = self._continuation
        if refusal.startswith("`sensitivities`"):
            raise NotImplementedError(refusal)
        if refusal or proceed is None:
            raise ValueError(refusal)
        requested, sign = real_array(t, "`t`"), -1.0 if descends(self.times) else 1.0
        if requested.ndim == 0:
            last = number(t, "`t`")
            if not (np.isfinite(last) and sign * (last - end) > 0.0):
                raise ValueError(f"`t` must be after the end of the motion, {end!r}, got {t}.")
            return proceed(np.linspace(end, last, num=max(2, len(self.times))))
        times = monotonic(requested, "`t`")
        ahead = sign * (times - end)
        if not len(times) or ahead[0] < 0.0 or ahead[-1] <= 0.0 or ahead[-1] < ahead[0]:
            raise ValueError(
                f"`t` must have times after the end of the motion, {end!r}, and none before, "
                f"got {shown(times)}."
            )
        return proceed(times if times[0] == end else np.append(end, times))
