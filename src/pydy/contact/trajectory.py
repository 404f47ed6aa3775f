"""The motion of a System with contacts: a Trajectory with modes and impacts."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import groupby
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._forks import cached_property
from pydy._interpolation import Continuation, states_between
from pydy._motion import Motion, Segment
from pydy._problem import AssumptionChecks, TrajectoryModel
from pydy.contact.conditions import Contact
from pydy.trajectory import Columns, Trajectory

if TYPE_CHECKING:
    import sympy as sm

_POINTS, _WEIGHTS = np.polynomial.legendre.leggauss(8)


class _Segmented:
    """Evaluates at each time the segment in force; a transition belongs to the one it begins."""

    def __init__(self, segments: Sequence[Segment]) -> None:
        self.segments = list(segments)

    def _by_segment(
        self, times: np.ndarray, value: Callable[[Segment, np.ndarray | slice], np.ndarray]
    ) -> np.ndarray:
        """Evaluate each time by its segment; at a transition, by the later one."""
        if len(self.segments) == 1:
            return value(self.segments[0], slice(None))
        starts = [segment.start for segment in self.segments[1:]]
        segment_index = np.searchsorted(starts, times, side="right")
        masks = [
            (k, segment_index == k)
            for k in (np.unique(segment_index) if len(segment_index) else (0,))
        ]
        values = [(rows, value(self.segments[k], rows)) for k, rows in masks]
        table = np.empty((len(times), *values[0][1].shape[1:]))
        for rows, part in values:
            table[rows] = part
        return table


class SegmentedModel(_Segmented):
    """The model of a motion in several modes; see `pydy.trajectory.Model`."""

    def __init__(self, segments: Sequence[Segment], base: TrajectoryModel) -> None:
        super().__init__(segments)
        self.specifieds, self.energy, self.scene = base.specifieds, base.energy, base.scene
        self.jumps = base.jumps

    def derivatives(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the derivatives of the states, shape (m, n)."""
        return self._by_segment(
            times, lambda s, rows: s.problem.at(times[rows], states[rows]).rates()
        )

    def outputs(self, times: np.ndarray, states: np.ndarray) -> np.ndarray:
        """Return the outputs, shape (m, o)."""
        return self._by_segment(
            times, lambda s, rows: s.problem.at(times[rows], states[rows]).outputs()[:, s.columns]
        )


class _SegmentedDense(_Segmented):
    """The dense output of all segments; like that of a segment, it is pickled as None."""

    @property
    def starts(self) -> np.ndarray:
        """The times at which the solver's steps begin."""
        return np.concatenate([segment.dense.starts for segment in self.segments])

    def __call__(self, times: np.ndarray) -> np.ndarray:
        """Return the states, and the sensitivities after them."""
        times = np.asarray(times, dtype=float)
        return self._by_segment(times, lambda segment, rows: segment.dense(times[rows]))

    def __deepcopy__(self, memo: object) -> _SegmentedDense:
        return self

    def __reduce__(self) -> tuple[object, ...]:
        return type(None), ()


class SegmentedSensitivities(_Segmented):
    """The sensitivities of a motion in several modes; see `pydy.trajectory.SensitivityModel`."""

    def rates(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the derivatives of the sensitivities by time, shape (m, n, k)."""
        return self._by_segment(
            times, lambda s, rows: s.augmented.rates(times[rows], states[rows], values[rows])
        )

    def outputs(self, times: np.ndarray, states: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the sensitivities of the outputs, shape (m, o, k)."""
        return self._by_segment(
            times,
            lambda s, rows: s.augmented.outputs(times[rows], states[rows], values[rows])[
                :, s.columns
            ],
        )


class ContactTrajectory(Trajectory):
    """A Trajectory of a System with contacts.

    Its outputs include, for a contact of the name ``floor``, ``floor_gap``, ``floor_normal`` (the
    normal force), ``floor_friction``, ``floor_sliding`` (the sliding speed) and ``floor_power``
    (that of the friction, which is not positive). In a plane in space ``floor_friction_1`` and
    ``floor_friction_2`` are along the two vectors, and so are the sliding speeds. Its `events` are
    the transitions: ``'floor closes'``, ``'floor opens'``, ``'floor slips'`` (it stuck until then),
    ``'floor stops'`` (its sliding speed vanishes), and ``'floor rests'``, the limit of impacts that
    accumulate.

    Attributes
    ----------
    modes : list of (float, float, dict)
        When each part of the motion begins and ends, and the mode of each contact in it: 'open',
        'closed' (without friction), 'sticks', 'slides +' or 'slides -'; in a plane in space 'begins
        to slide' or 'slides'.
    impacts : list of (float, dict)
        The time of each impact, and the impulses of each contact: normal, then tangential.
    gaps : dict of str to expression
        The gap of each contact that has one.
    """

    def __init__(
        self,
        *args: Any,
        segments: SegmentedModel,
        contacts: Sequence[Contact],
        impacts: Sequence[tuple[float, dict[str, tuple[float, ...]], float]],
        **options: Any,
    ) -> None:
        all_dense = all(segment.dense is not None for segment in segments.segments)
        super().__init__(
            *args,
            model=segments,
            dense=_SegmentedDense(segments.segments) if all_dense else None,
            **options,
        )
        names: list[str] = []
        self.gaps: dict[str, sm.Expr] = {}  # scenes draw the planes that these belong to
        for contact in contacts:
            names.append(contact.name)
            if contact.unilateral is not None:
                self.gaps[contact.name] = contact.unilateral.gap
        self._segments, self._names = segments, tuple(names)
        # Consecutive segments may have the same modes, as before and after an impact.
        self.modes = [
            (parts[0].start, parts[-1].end, dict(zip(names, modes, strict=True)))
            for modes, group in groupby(segments.segments, key=lambda segment: segment.modes)
            for parts in [list(group)]
        ]
        self.impacts = [(time, impulses) for time, impulses, _ in impacts]
        self._describe({"modes": self.modes, "impacts": self.impacts})
        self._impact_work = [(time, work) for time, _, work in impacts]
        self._whole: ContactTrajectory | None = None  # of `at`, the motion that is resampled

    def __getstate__(self) -> dict[str, object]:
        state = super().__getstate__()
        # It needs the dense output of the whole motion.
        return {**state, "contact_work": self.contact_work, "_whole": None}

    def at(self, times: np.typing.ArrayLike) -> ContactTrajectory:
        """Return the trajectory at other times, as `Trajectory.at` does, with `contact_work`.

        Parameters
        ----------
        times : array_like, shape (k,)
            Ascending or descending, within the simulated time.

        Returns
        -------
        ContactTrajectory
            Its `modes`, `impacts` and `events` are those of the whole motion; its `contact_work` is
            counted from the first time of the whole motion.

        Raises
        ------
        ValueError
            The times are not monotonic, or one is outside the simulated time.
        """
        resampled = super().at(times)
        if isinstance(resampled, ContactTrajectory):  # descending times
            return resampled
        result = object.__new__(type(self))
        vars(result).update(
            vars(resampled),
            _segments=self._segments,
            _names=self._names,
            gaps=self.gaps,
            _impact_work=self._impact_work,
            _whole=self if self._whole is None else self._whole,
        )
        return result

    @cached_property
    def contact_work(self) -> np.ndarray:
        """Work of friction and impacts in the relative motion since the first time, shape (m,).

        It is that of each force and impulse along the velocity of one surface relative to the
        other, so it is never positive: minus the energy that became heat. Between surfaces of the
        system, or on a surface at rest, it is what the total energy has changed by where nothing
        else does work. On a surface that moves as prescribed, such as a belt, what drives the
        surface does work too, which may be positive: a block that a belt carries along gains energy
        while its `contact_work` becomes negative.

        That of friction is the integral of its power over the solver's steps, by Gauss's rule with
        8 points. Without the steps, which are kept up to 128 MB, the states are interpolated
        between `times`.
        """
        return (self if self._whole is None else self._whole)._work_until(self.times)

    def _work_until(self, ends: np.ndarray) -> np.ndarray:
        """Return the work of friction and impacts from the first time to others, shape (k,)."""
        power_names = {f"{name}_power" for name in self._names}
        powers = [k for k, symbol in enumerate(self.outputs_symbols) if str(symbol) in power_names]
        knots = [self.times, ends]
        for segment in self._segments.segments:
            inside = np.asarray(getattr(segment.dense, "starts", ()), dtype=float)
            knots += [inside, np.array([segment.start, segment.end])]
        nodes = np.unique(np.concatenate(knots))
        nodes = nodes[(nodes >= self.times[0]) & (nodes <= self.times[-1])]
        work = np.zeros(len(nodes))
        if powers and len(nodes) > 1:
            half, middle = np.diff(nodes) / 2, (nodes[1:] + nodes[:-1]) / 2
            times = (middle[:, None] + half[:, None] * _POINTS).ravel()
            outputs = self._segments.outputs(times, states_between(self, times)[0])
            power = outputs[:, powers].sum(axis=1).reshape(len(half), -1)
            work[1:] = np.cumsum(half * (power @ _WEIGHTS))
        for time, impact_work in self._impact_work:
            work[nodes >= time] += impact_work
        return work[np.searchsorted(nodes, ends)]


def _outputs(motion: Motion, model: SegmentedModel) -> np.ndarray:
    """Return the outputs at the times of a motion."""
    whole = motion.segments[0]
    if whole.outputs is not None and len(motion.segments) == 1:
        outputs: np.ndarray = whole.outputs[:, whole.columns]
        return outputs
    return model.outputs(motion.times, motion.states)


def contact_trajectory(
    columns: Columns,
    contacts: Sequence[Contact],
    impacts: Sequence[tuple[float, dict[str, tuple[float, ...]], float]],
    sensitivities: Any,
    proceed: Callable[[np.ndarray], Trajectory],
    refusal: str,
    motion: Motion,
) -> ContactTrajectory:
    """Return the Trajectory of a Motion, with modes.

    `columns` names the states and outputs. `sensitivities` are those passed
    through the transitions, or None. `proceed` continues the motion at further times; a `refusal`
    says why it cannot be continued.
    """
    problem, times, states = motion.problem, motion.times, motion.states
    if problem.definition.assumes_motions:
        AssumptionChecks(problem).motion(times, states)
    model = SegmentedModel(motion.segments, TrajectoryModel(problem))
    sensitivity_arguments = {}
    if sensitivities is not None:
        sensitivity_arguments = sensitivities.labels(motion.sensitivities, motion.segments)
    trajectory = ContactTrajectory(
        times,
        states,
        columns,
        outputs=_outputs(motion, model),
        specifieds=model.specifieds(times, states),
        constants=problem.constants,
        events=motion.events,
        statistics=dict(motion.statistics),
        segments=model,
        contacts=contacts,
        impacts=impacts,
        **sensitivity_arguments,
    )
    trajectory._continuation = Continuation(motion.segments[-1].end, refusal, proceed)
    return trajectory
