"""Sampled data as values of specifieds: measured or computed values at discrete times."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from pydy._checks import ascending, choice, real_array
from pydy._rank import ROUNDED

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["SampledInput"]
__dir__ = __all__.copy

_INTERPOLATIONS = ("linear", "previous", "pchip")
_SLACK = 1e-9  # of the time span of samples: times may be accumulated sums


class SampledInput:
    """Values at sample times, with the interpolation between them.

    Use it as the value of a specified, or of a tuple of specifieds, in
    `pydy.system.System.specifieds`. It copies its arguments and is immutable.

    Parameters
    ----------
    times : array_like, shape (m,)
        At least two, strictly ascending.
    values : array_like, shape (m,) or (m, k)
        One value, or k of them, for each time.
    interpolation : {'linear', 'previous', 'pchip'}, optional
        Between two samples: a straight line; the earlier sample; or the cubic that preserves
        monotonicity and has a continuous first derivative [1]_.

    Attributes
    ----------
    breaks : ndarray, shape (m,)
        The times.
    coefficients : ndarray, shape (m − 1, 4, k)
        ``coefficients[i, :, j]`` are those of quantity j between ``breaks[i]`` and
        ``breaks[i + 1]``: a cubic polynomial in ``t − breaks[i]``, highest power first, as in
        `numpy.polyval` and `scipy.interpolate.PPoly`.
    first, last : ndarray, shape (k,)
        The values before the first time and after the last time.

    Raises
    ------
    ValueError
        The times are not strictly ascending, values are not finite, shapes do not match, or the
        interpolation is unknown.

    Notes
    -----
    A step of a native solver ends where an input with the interpolation 'previous' jumps; until
    there it sees the earlier sample. A step across other samples that was rejected is repeated up
    to one of them.

    Outside its times, a SampledInput returns the end values, because solvers step past the last
    time and return. `pydy.system.System.integrate` and the evaluations raise an error for times
    outside.

    References
    ----------
    .. [1] F. N. Fritsch and J. Butland, "A method for constructing local monotone piecewise cubic
       interpolants", SIAM J. Sci. Stat. Comput. 5 (1984) 300–304; computed by
       `scipy.interpolate.PchipInterpolator`.

    Examples
    --------
    >>> from pydy.inputs import SampledInput
    >>> push = SampledInput([0.0, 1.0, 3.0], [0.0, 2.0, 0.0])
    >>> push(0.5)
    1.0
    >>> push([0.0, 2.0, 9.0])
    array([0., 1., 0.])
    """

    breaks: np.ndarray
    coefficients: np.ndarray
    first: np.ndarray
    last: np.ndarray

    __slots__ = ("_knots", "_values", "breaks", "coefficients", "first", "interpolation", "last")

    def __init__(self, times: ArrayLike, values: ArrayLike, interpolation: str = "linear") -> None:
        self.interpolation = choice(
            interpolation, _INTERPOLATIONS, "`interpolation` of a SampledInput"
        )
        self.breaks = _frozen(_check_times(times))
        self._values = _frozen(_check_values(values, self.breaks))
        columns = self._values.reshape(len(self.breaks), -1)
        self.coefficients = _frozen(_coefficients(self.breaks, columns, self.interpolation))
        self.first, self.last = columns[0], columns[-1]
        self._knots: list[float] = self.breaks.tolist()  # bisect is ten times faster on a list

    @property
    def times(self) -> np.ndarray:
        """The times as given, shape (m,)."""
        return self.breaks

    @property
    def values(self) -> np.ndarray:
        """The values as given, shape (m,) or (m, k)."""
        return self._values

    @property
    def size(self) -> int:
        """The number of quantities, k."""
        return len(self.last)

    def __call__(self, t: ArrayLike) -> float | np.ndarray:
        """Return the values at one or several times.

        Parameters
        ----------
        t : float or array_like, shape (n,)

        Returns
        -------
        float or ndarray, shape (k,), (n,) or (n, k)
        """
        several = self._values.ndim == 2
        instants = real_array(t, "`t`")
        if instants.ndim == 0:
            values = self.at(float(instants))
            return np.array(values) if several else values[0]
        if instants.ndim != 1:
            raise ValueError(
                f"`t` must be a number or one-dimensional, got the shape {instants.shape}."
            )
        rows = self.rows(instants)
        return rows if several else rows[:, 0]

    def at(self, t: float) -> list[float]:
        """Return the k values at one time; called by solvers, so with little overhead."""
        knots = self._knots
        if t >= knots[-1]:
            return self.last.tolist()  # type: ignore[no-any-return]
        if t <= knots[0]:
            return self.first.tolist()  # type: ignore[no-any-return]
        i = min(bisect_right(knots, t), len(knots) - 1) - 1  # NaN bisects to the end
        s = t - knots[i]
        cubes, squares, slopes, starts = self.coefficients[i].tolist()
        return [
            ((a * s + b) * s + c) * s + d
            for a, b, c, d in zip(cubes, squares, slopes, starts, strict=True)
        ]

    def slopes_at(self, t: float) -> np.ndarray:
        """Return the time derivatives at one time, shape (k,); at a sample, those after it."""
        if not self.breaks[0] <= t < self.breaks[-1]:
            return np.zeros(self.size)
        i = bisect_right(self._knots, t) - 1
        s = t - self._knots[i]
        a, b, c, _ = self.coefficients[i]
        slopes: np.ndarray = (3.0 * a * s + 2.0 * b) * s + c
        return slopes

    def rows(self, t: np.ndarray) -> np.ndarray:
        """Return the values at n times, shape (n, k)."""
        t = np.clip(t, self.breaks[0], self.breaks[-1])
        intervals = np.searchsorted(self.breaks, t, side="right") - 1
        intervals = np.clip(intervals, 0, len(self.breaks) - 2)
        s = (t - self.breaks[intervals])[:, None]
        a, b, c, d = np.moveaxis(self.coefficients[intervals], 1, 0)
        values: np.ndarray = ((a * s + b) * s + c) * s + d
        values[t == self.breaks[-1]] = self.last
        return values

    def of(self, columns: list[int]) -> SampledInput:
        """Return a SampledInput of some of the quantities."""
        if len(columns) == self.size:
            return self
        return SampledInput(self.breaks, self._values[:, columns], self.interpolation)

    def covers(self, t: np.ndarray) -> bool:
        """Return whether all times lie within the samples, up to rounding."""
        start, end = self._knots[0], self._knots[-1]
        slack = max(_SLACK * (end - start), ROUNDED * max(abs(start), abs(end)))
        return not (np.any(t < start - slack) or np.any(t > end + slack))

    def __repr__(self) -> str:
        size_text = f" of {self.size} values" if self._values.ndim == 2 else ""
        return (
            f"SampledInput({len(self.breaks)} samples{size_text} from t = {self._knots[0]!r} to "
            f"{self._knots[-1]!r}, interpolation={self.interpolation!r})"
        )

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, SampledInput):
            return NotImplemented
        return self.interpolation == other.interpolation and all(
            np.array_equal(mine, its)
            for mine, its in ((self.breaks, other.breaks), (self._values, other._values))
        )

    def __hash__(self) -> int:
        return hash((self.interpolation, self._values.shape, self._knots[0], self._knots[-1]))

    def __copy__(self) -> SampledInput:
        return self

    def __deepcopy__(self, memo: dict[int, object]) -> SampledInput:
        return self  # it never changes

    def __reduce__(self) -> tuple[object, ...]:
        return (SampledInput, (self.breaks, self._values, self.interpolation))


def jumps_of(sampled: Sequence[tuple[object, SampledInput]]) -> np.ndarray:
    """Return rows (time, previous float, time) for the jumps of sampled inputs.

    The rows are those of `pydy._program.switch_times.SwitchTimes`.
    """
    times_of_jumps = [np.zeros(0)]
    for _, samples in sampled:
        if samples.interpolation == "previous":
            changes = np.diff(samples.values.reshape(len(samples.breaks), -1), axis=0)
            times_of_jumps.append(samples.breaks[1:][changes.any(axis=1)])
    times = np.unique(np.concatenate(times_of_jumps))
    return np.stack([times, np.nextafter(times, -np.inf), times], axis=1)


def merged_jumps(tables: Iterable[np.ndarray]) -> np.ndarray:
    """Return sorted rows of times and windows, in which overlapping windows are merged.

    The time of a merged row is that of a row whose window ends at its time, such as a sample's, if
    there is one.
    """
    rows = np.concatenate([np.zeros((0, 3)), *tables])
    if not len(rows):
        return rows
    rows = rows[np.lexsort((rows[:, 2], rows[:, 0], rows[:, 1]))]
    reach = np.maximum.accumulate(rows[:, 2])
    first = np.flatnonzero(np.append(True, rows[1:, 1] >= reach[:-1]))
    exact = np.where(rows[:, 2] == rows[:, 0], rows[:, 0], np.inf)
    times = np.minimum.reduceat(exact, first)
    times = np.where(np.isfinite(times), times, rows[first, 0])
    before, after = np.minimum.reduceat(rows[:, 1], first), np.maximum.reduceat(rows[:, 2], first)
    return np.stack([times, before, after], axis=1)


def _frozen(array: np.ndarray) -> np.ndarray:
    array.flags.writeable = False
    return array


def _check_times(times: object) -> np.ndarray:
    array = np.array(real_array(times, "`times` of a SampledInput"))
    if array.ndim != 1 or len(array) < 2:
        raise ValueError(
            "`times` of a SampledInput must be one-dimensional with at least two values, got the "
            f"shape {array.shape}. A value that never changes needs no samples: give the number."
        )
    return ascending(
        array,
        "`times` of a SampledInput",
        strict=True,
        remedy=" Sort the samples and drop repeated ones; for a jump use interpolation='previous'.",
    )


def _check_values(values: object, times: np.ndarray) -> np.ndarray:
    array = np.array(real_array(values, "`values` of a SampledInput"), order="C")
    m = len(times)
    if array.ndim not in (1, 2) or len(array) != m or 0 in array.shape:
        raise ValueError(
            f"`values` of a SampledInput must have the shape ({m},) or ({m}, k), one row for each "
            f"of its {m} times, got {array.shape}."
        )
    if not np.isfinite(array).all():
        index = tuple(int(k) for k in np.argwhere(~np.isfinite(array))[0])
        index_text = index[0] if len(index) == 1 else index
        raise ValueError(
            f"`values` of a SampledInput must be finite, got {array[index]} at index {index_text}. "
            "Drop or fill such samples first."
        )
    return array


def _coefficients(breaks: np.ndarray, values: np.ndarray, interpolation: str) -> np.ndarray:
    """Return piecewise cubics, shape (m − 1, 4, k), highest power first."""
    steps = np.diff(breaks)[:, None]
    cubics = np.zeros((len(steps), 4, values.shape[1]))
    cubics[:, 3] = values[:-1]
    with np.errstate(over="ignore", invalid="ignore"):
        if interpolation != "previous":
            cubics[:, 2] = np.diff(values, axis=0) / steps
        if interpolation == "pchip" and np.isfinite(cubics).all():
            from scipy.interpolate import PchipInterpolator  # a tenth of a second to import

            # SciPy adds a few slopes, which may be close to overflow.
            curves = PchipInterpolator(breaks, values / 16.0, axis=0).c
            cubics[:, :3] = 16.0 * np.moveaxis(curves, 0, 1)[:, :3]
        a, b, c, _ = np.moveaxis(np.abs(cubics), 1, 0)
        slopes = (3.0 * a * steps + 2.0 * b) * steps + c  # bounds all intermediate sums
        sound = np.isfinite(slopes * np.maximum(steps, 1.0)).all(axis=1)
    if not sound.all():
        k = int(sound.argmin())
        raise ValueError(
            f"The slope of a SampledInput between times {float(breaks[k])!r} and "
            f"{float(breaks[k + 1])!r} is beyond the range of floats. Drop one of the samples, or "
            "use interpolation='previous'."
        )
    return cubics
