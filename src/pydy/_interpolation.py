"""States and sensitivities between the times of a trajectory, and motions that go on after them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import Any, NamedTuple, Protocol

import numpy as np

from pydy._checks import descends, monotonic, number, real_array, shown


def evenly(count: int, most: int) -> np.ndarray:
    """Return up to `most` of the numbers below `count`, spread over all, the last one included."""
    return np.unique(np.linspace(0, count - 1, min(count, most)).astype(int))


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

    def scene(self, *visuals: Any, **options: Any) -> Any:
        """Return a scene that shows the model."""


class SensitivityModel(Protocol):
    """The interface of the model of a trajectory's sensitivities.

    At times (m,), states (m, n) and sensitivities of the states (m, n, k).
    """

    def rates(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the derivatives of the sensitivities by time, shape (m, n, k)."""

    def outputs(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the sensitivities of the outputs, shape (m, o, k)."""


def check_sensitivities(given: Any, shape: tuple[int, int]) -> None:
    """Refuse what is no pair of parameters and derivatives of the states of some shape."""
    pair = isinstance(given, (tuple, list)) and len(given) == 2
    if not pair or not isinstance(given[0], Mapping):
        raise TypeError(
            "`sensitivities` must be a pair, (parameters, values), of a dictionary and an array, "
            f"got {shown(given)}."
        )
    wanted = (*shape, sum(given[0].values()))
    if (found := np.shape(given[1])) != wanted:
        raise ValueError(
            f"`sensitivities` must have values of the shape {wanted}, by the numbers of columns "
            f"of its parameters, got {found}."
        )


def checked_times(times: Any, own: np.ndarray) -> np.ndarray:
    """Check that times ascend or descend and lie within those of a trajectory."""
    checked = monotonic(np.atleast_1d(real_array(times, "`times`")), "`times`")
    first, last = _span(own)
    outside = checked[~((checked >= first) & (checked <= last))]
    if outside.size:
        raise ValueError(
            f"`times` must be within the simulated time, {own[0]} to {own[-1]}, got {outside[0]}."
        )
    return checked


def _span(own: np.ndarray) -> tuple[float, float]:
    """Return the least and the largest of monotonic times; of none, an empty span."""
    if not len(own):
        return np.inf, -np.inf
    return min(own[0], own[-1]), max(own[0], own[-1])


def in_order(trajectory: Any) -> Any:
    """Return a trajectory with ascending times: itself, or its rows in the opposite order."""
    own = hasattr(trajectory, "_sensitivities") and descends(trajectory.times)
    return turned(trajectory) if own else trajectory


def turned(trajectory: Any) -> Any:
    """Return the same motion with the rows of a Trajectory in the opposite order."""
    own = object.__new__(type(trajectory))
    own.__dict__.update(trajectory.__dict__)
    for name in ("times", "states", "outputs", "specifieds", "_derivatives", "_energy"):
        table = getattr(trajectory, name)
        setattr(own, name, None if table is None else table[::-1].copy())
    if trajectory._sensitivities is not None:
        parameters, values = trajectory._sensitivities
        own._sensitivities, own._known_sensitivity = (parameters, values[::-1].copy()), None
    elif (known := trajectory._known_sensitivity) is not None:  # of a file
        own._take_sensitivity(known.names, known.table()[::-1].copy())
    return own


def filled(trajectory: Any, step_of: Callable[[float], float]) -> Any:
    """Refine a trajectory where its times are two or more steps apart.

    `step_of` returns the step for a span of time. Without the solver's continuous extension, it is
    the trajectory itself: what is known at its times alone would be made up between them. Its times
    ascend.
    """
    trajectory = in_order(trajectory)
    if getattr(trajectory, "_dense", None) is None or len(trajectory.times) < 2:
        return trajectory
    own = trajectory.times
    gaps = np.diff(own)
    parts = np.maximum(np.floor(gaps / step_of(float(own[-1] - own[0]))), 1.0).astype(int)
    if not (parts > 1).any():
        return trajectory
    k = np.repeat(np.arange(len(gaps)), parts)
    part = np.arange(len(k)) - (np.cumsum(parts) - parts)[k]
    return trajectory.at(np.append(own[k] + gaps[k] * (part / parts[k]), own[-1]))


# Places within steps of a solver that a curve is evaluated at, at most: chains of up to 20 links
# take 0.3 s for them.
STEPS = 100_000
PARTS = 16  # of a step, which may be half a period long: 0.5 % of an amplitude are missed at most


def detailed(trajectory: Any, step_of: Callable[[float], float]) -> Any:
    """Refine a trajectory for curves: what is narrower than its times, and what jumps, is seen.

    It has the times of `filled`, those of the solver's own steps and some within them, and at each
    event, and where an input jumps, the rows of both sides at the same time.
    """
    if isinstance(getattr(trajectory, "_detail", None), Detail):
        return trajectory
    trajectory = in_order(trajectory)
    found = filled(trajectory, step_of)
    starts = getattr(getattr(trajectory, "_dense", None), "starts", None)
    if starts is not None and len(trajectory.times) > 1:
        first, last = _span(trajectory.times)
        nodes = np.append(np.unique(np.clip(starts, first, last)), last)
        parts = int(np.clip(STEPS // len(nodes), 1, PARTS))
        inside = nodes[:-1, None] + np.diff(nodes)[:, None] * (np.arange(parts) / parts)
        more = np.setdiff1d(inside, found.times)
        if len(more):
            found = trajectory.at(np.sort(np.concatenate([found.times, more])))
    return _with_sides(trajectory, found)


def _with_sides(known: Any, found: Any) -> Any:
    """Insert both sides of the events of a Trajectory into the same motion at some times."""
    if not hasattr(known, "_sensitivities") or not len(found.times):
        return found
    known._keep_jumps()
    if not breaks(known) or (known._model is None and known._sides is None):
        return found
    moments, states = _at_events(known)
    first, last = _span(found.times)
    inside = (moments >= first) & (moments <= last)
    if not inside.any():
        return found
    m, moments, states = len(found.times), moments[inside], states[inside]
    early = np.tile([True, False], len(moments) // 2)
    # Just before, in the modes and with the inputs that end there.
    just = np.where(early, np.fmax(np.nextafter(moments, -np.inf), first), moments)
    model = known._model
    if known._sides is not None:
        rates, outputs, specifieds = (table[inside] for table in known._sides)
    else:
        rates = None
        outputs, specifieds = model.outputs(just, states), model.specifieds(just, states)
    tables = [
        (found.states, states),
        (found.outputs, np.reshape(outputs, (len(moments), -1))),
        (found.specifieds, np.reshape(specifieds, (len(moments), -1))),
        (found.times[:, None], just[:, None]),
    ]
    if rates is not None and found._derivatives is not None:
        tables.append((found._derivatives, rates))

    def interpolated(table: np.ndarray) -> np.ndarray:
        flat = table.reshape(m, -1)
        return straight(found, moments, flat, None).reshape(len(moments), *table.shape[1:])

    energy, values, table = None, None, None
    if model is None and found._energy is not None:
        energy = found._energy
        tables.append((energy, interpolated(energy)))
    if found._sensitivities is not None:
        values = found._sensitivities[1]
        sides = _sensitivities_at(known)
        tables.append((values, interpolated(values) if sides is None else sides[inside]))
    elif found._known_sensitivity is not None:  # of a file
        table = found._known_sensitivity.table()
        tables.append((table, interpolated(table)))
    times, merged = _with_events(found, moments, tables)
    own = object.__new__(type(found))
    own.__dict__.update(found.__dict__)
    own.times, own.states, own.outputs, own.specifieds, just, *more = times, *merged
    own._derivatives = more.pop(0) if len(tables) > 4 and tables[4][1] is rates else None
    own._energy = more.pop(0) if energy is not None else None
    if values is not None:
        own._sensitivities, own._known_sensitivity = (found._sensitivities[0], more.pop(0)), None
    elif table is not None:
        own._take_sensitivity(found._known_sensitivity.names, more.pop(0))
    own._detail = Detail(model, just[:, 0])
    own._model = None if model is None else own._detail
    other = found._sensitivity_model
    own._sensitivity_model = None if other is None else Detail(other, just[:, 0])
    return own


class Detail:
    """A model at rows of which some are just before an event, though their times are the event's.

    It is the Model or SensitivityModel of a Trajectory that `detailed` made.
    """

    def __init__(self, model: Any, times: np.ndarray) -> None:
        self.model, self.times = model, times
        for name in ("derivatives", "outputs", "specifieds", "energy", "rates"):
            if hasattr(model, name):
                setattr(self, name, partial(self._evaluate, name))

    def _evaluate(self, name: str, times: np.ndarray, *tables: np.ndarray) -> np.ndarray:
        result: np.ndarray = getattr(self.model, name)(self.times, *tables)
        return result


class Sides(NamedTuple):
    """What breaks have on both sides, beside the states: rows before and after each of them."""

    derivatives: np.ndarray
    outputs: np.ndarray
    specifieds: np.ndarray

    @classmethod
    def of(cls, known: Any) -> Any:
        """Return those of a Trajectory from a file, or evaluate its model there."""
        if known._sides is not None:
            return known._sides
        moments, states = _at_events(known)
        # Just before, in the modes and with the inputs that end there.
        moments[::2] = np.fmax(np.nextafter(moments[::2], -np.inf), _span(known.times)[0])
        model, rows = known._model, len(moments)
        tables = (f(moments, states) for f in (model.derivatives, model.outputs, model.specifieds))
        return cls(*(np.reshape(table, (rows, -1)) for table in tables))

    @classmethod
    def joined(cls, parts: list[Any]) -> Any:
        """Join those of each break; older files have none."""
        if not parts or None in parts:
            return None
        return cls(*(np.concatenate([own[name] for own in parts]) for name in cls._fields))


def between(known: Any, times: np.ndarray) -> tuple[np.ndarray, np.ndarray | None]:
    """Interpolate the states of a Trajectory, and its sensitivities if it has any.

    The times ascend.
    """
    known = in_order(known)
    m, n = known.states.shape
    values = None if known._sensitivity is None else known._sensitivity.values
    whole = known._dense(times) if known._dense else _hermite(known, times, values)
    if values is None:
        return whole, None
    if whole.shape[1] == n:  # no derivatives by time: straight lines
        sides = _sensitivities_at(known)
        sides = None if sides is None else sides.reshape(len(sides), -1)
        whole = np.hstack([whole, straight(known, times, values.reshape(m, -1), sides)])
    return whole[:, :n].copy(), whole[:, n:].reshape(len(times), n, values.shape[2])


def breaks(known: Any) -> tuple[Any, ...]:
    """Return where derivatives jump: at events, and where a Trajectory keeps jumps of inputs."""
    found: tuple[Any, ...] = known.events + known._jumps
    return found


def states_at_jumps(known: Any) -> list[tuple[float, np.ndarray, np.ndarray | None]]:
    """Return where a Trajectory's inputs jump, away from events: times, states, sensitivities."""
    if known._dense is None or known._model is None:
        return []
    jumps = np.setdiff1d(known._model.jumps(), [event.time for event in known.events])
    first, last = _span(known.times)
    times = jumps[(jumps > first) & (jumps <= last)]
    states, columns = between(known, times)
    each = [None] * len(times) if columns is None else columns
    return list(zip(times.tolist(), states, each, strict=True))


def _hermite(known: Any, times: np.ndarray, values: np.ndarray | None) -> np.ndarray:
    """Interpolate states, followed by sensitivities if their derivatives are known."""
    nodes = known.times
    x, rates = _beside(known, nodes, known.states, known.derivatives, values)
    if known._sides is not None or (breaks(known) and known._model is not None):
        moments, sides = _at_events(known)
        columns = None if values is None else _sensitivities_at(known)
        own = _beside(known, moments, sides, Sides.of(known).derivatives, columns)
        nodes, (x, rates) = _with_events(known, moments, zip((x, rates), own, strict=True))
    elif any((e.before != e.after).any() for e in known.events):
        raise ValueError(
            "The trajectory has events that change states, and does not know how these go on from "
            "there: it was created or saved without. Use the Trajectory that `System.simulate` "
            "returned, or save that again."
        )
    k, after, h, s = _places(nodes, times)
    value = x[k] + (3.0 - 2.0 * s) * s**2 * (x[after] - x[k])
    slope = h * s * (1.0 - s) * ((1.0 - s) * rates[k] - s * rates[after])
    result: np.ndarray = value + slope
    return result


def straight(
    known: Any, times: np.ndarray, table: np.ndarray, sides: np.ndarray | None
) -> np.ndarray:
    """Interpolate a table of a Trajectory by lines, which end at `sides` of events, if known."""
    nodes = known.times
    if sides is not None:
        nodes, (table,) = _with_events(known, _at_events(known)[0], [(table, sides)])
    k, after, _, s = _places(nodes, times)
    result: np.ndarray = table[k] + s * (table[after] - table[k])
    return result


def _places(nodes: np.ndarray, times: np.ndarray) -> tuple[np.ndarray, ...]:
    """Return the nodes before and after some times, their distance, and the part that is over."""
    # The last of equal times, so that an interval has a length wherever there is one.
    k = np.clip(np.searchsorted(nodes, times, side="right") - 1, 0, len(nodes) - 1)
    after = np.minimum(k + 1, len(nodes) - 1)
    h = (nodes[after] - nodes[k])[:, None]
    s = np.divide((times - nodes[k])[:, None], h, out=np.zeros_like(h), where=h > 0.0)
    return k, after, h, s


def _beside(
    known: Any, times: np.ndarray, states: np.ndarray, rates: np.ndarray, values: Any
) -> tuple[np.ndarray, np.ndarray]:
    """Append sensitivities and their derivatives by time to states and theirs."""
    model, m = known._sensitivity_model, len(times)
    if model is None or values is None:
        return states, rates
    slopes = model.rates(times, states, values)
    return (
        np.concatenate([states, values.reshape(m, -1)], axis=1),
        np.concatenate([rates, slopes.reshape(m, -1)], axis=1),
    )


def _at_events(known: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return the times of both sides of each event, and the states there."""
    moments = np.repeat([e.time for e in breaks(known)], 2)
    return moments, np.array([side for e in breaks(known) for side in (e.before, e.after)])


def _sensitivities_at(known: Any) -> np.ndarray | None:
    """Return the sensitivities of the states on both sides of each event, if all have them."""
    pairs = [(e.sensitivity_before, e.sensitivity_after) for e in breaks(known)]
    values = [value for pair in pairs for value in pair]
    return None if not values or any(v is None for v in values) else np.array(values)


def _with_events(
    known: Any, moments: np.ndarray, tables: Iterable[tuple[np.ndarray, np.ndarray]]
) -> tuple[np.ndarray, list[np.ndarray]]:
    """Insert both sides of each event into the times, and into tables with rows for these."""
    # A node at the time of an event may be of either side: the event's own replace it.
    other = ~np.isin(known.times, moments)
    nodes = np.concatenate([moments, known.times[other]])
    order = np.argsort(nodes, kind="stable")
    return nodes[order], [np.concatenate([own, t[other]])[order] for t, own in tables]


# -- beyond the end -------------------------------------------------------------------------------


class Leg(Protocol):
    """What is known of a motion's end."""

    @property
    def end(self) -> float:
        """The time, of a terminal event too."""

    @property
    def refusal(self) -> str:
        """Why the motion cannot be continued, or ''."""

    def continued(self, times: np.ndarray) -> Any:
        """Return the Trajectory from the end on."""


class Continued:
    """A motion that may be continued; the base of `pydy.trajectory.Trajectory`."""

    times: np.ndarray
    _leg: Leg | None = None
    # Attributes that describe the whole motion, such as modes of contacts: they are the same at
    # other times, and in files (as JSON).
    _facts: Mapping[str, Any] = {}

    def _describe(self, facts: Mapping[str, Any]) -> None:
        """Set the attributes that describe the whole motion."""
        self._facts = facts
        vars(self).update(facts)

    def continue_to(self, t: Any) -> Any:
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
        leg = self._leg
        if leg is None:
            raise ValueError(
                "This trajectory does not know how to go on: it was loaded, pickled, or made at "
                "other times. Continue what `simulate` returned, or set the initial conditions and "
                "`system.times` and simulate again."
            )
        if leg.refusal.startswith("`sensitivities`"):
            raise NotImplementedError(leg.refusal)
        if leg.refusal:
            raise ValueError(leg.refusal)
        given, way = real_array(t, "`t`"), -1.0 if descends(self.times) else 1.0
        if given.ndim == 0:
            last = number(t, "`t`")
            if not (np.isfinite(last) and way * (last - leg.end) > 0.0):
                raise ValueError(f"`t` must be after the end of the motion, {leg.end!r}, got {t}.")
            return leg.continued(np.linspace(leg.end, last, num=max(2, len(self.times))))
        times = monotonic(given, "`t`")
        ahead = way * (times - leg.end)
        if not len(times) or ahead[0] < 0.0 or ahead[-1] <= 0.0 or ahead[-1] < ahead[0]:
            raise ValueError(
                f"`t` must have times after the end of the motion, {leg.end!r}, and none before, "
                f"got {shown(times)}."
            )
        return leg.continued(times if times[0] == leg.end else np.append(leg.end, times))
