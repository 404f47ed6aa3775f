"""Curves over time below a scene: each with its own times, thinned without losing peaks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from pydy._checks import descends
from pydy.viz.motion import Geometry, SceneMotion, compute_placement

if TYPE_CHECKING:
    import sympy as sm
    from sympy.physics.mechanics import Point, ReferenceFrame

# Parts of the time that a thinned curve has points in: a strip has fewer columns of pixels than
# that on most screens, and is drawn like the whole curve. A part keeps at most seven points (see
# `thinned`), a smooth one four: that is up to 8,000 points of 16 bytes, 170 kB of a page, for a
# curve, and never more than 300 kB.
BUCKETS = 2000
UNTHINNED = 4 * BUCKETS  # curves of up to this many points are not thinned


class TimeSeries(NamedTuple):
    """A quantity over time; a jump is two points at the same time, a gap is NaN."""

    times: np.ndarray  # (k,), ascending
    values: np.ndarray  # (k,)


def curve(times: np.ndarray, values: np.ndarray) -> TimeSeries:
    """Return a TimeSeries of values at ascending or descending times."""
    return TimeSeries(times[::-1], values[::-1]) if descends(times) else TimeSeries(times, values)


def evaluated(
    reference: ReferenceFrame,
    origin: Point,
    formulas: Sequence[tuple[str, sm.Expr | float]],
    motion: SceneMotion,
) -> dict[str, TimeSeries]:
    """Return the curves of expressions, by label, at all instants of a motion."""
    if not formulas:
        return {}
    placed = compute_placement(Geometry(reference, origin, (), (), (), tuple(formulas)), motion)
    return {label: curve(motion.times, values) for label, values in placed.series.items()}


def thinned(series: TimeSeries) -> TimeSeries:
    """Return a curve with only the points that are needed to draw it.

    The time is divided into equal parts, of each of which the first, the lowest, the highest and
    the last point are kept: a curve of these covers the same pixels as the full one (U. Jugel
    et al., M4: A Visualization-Oriented Time Series Data Aggregation, VLDB 2014). Both ends of the
    largest jump in each part are kept too, and one point of a gap.

    Examples
    --------
    >>> import numpy as np
    >>> from pydy.viz.curves import TimeSeries, thinned
    >>> values = np.zeros(1_000_001)
    >>> values[616_161] = 129.6
    >>> drawn = thinned(TimeSeries(np.linspace(0.0, 1.0, 1_000_001), values))
    >>> len(drawn.times), drawn.times[drawn.values.argmax()], drawn.values.max()
    (4001, np.float64(0.616161), np.float64(129.6))
    """
    times, values = series
    count = len(times)
    if count <= UNTHINNED:
        return series
    span = times[-1] - times[0]
    part = (times - times[0]) / span if span > 0.0 else np.zeros(count)
    buckets = np.minimum((BUCKETS * part).astype(int), BUCKETS - 1)
    first = np.flatnonzero(np.diff(buckets, prepend=-1))
    number = np.repeat(np.arange(len(first)), np.diff(first, append=count))
    finite = np.isfinite(values)

    def largest(keys: np.ndarray) -> np.ndarray:
        """Return the row of the largest key of each part, the first one of several."""
        rows = np.flatnonzero(keys == np.maximum.reduceat(keys, first)[number])
        result: np.ndarray = rows[np.unique(number[rows], return_index=True)[1]]
        return result

    with np.errstate(over="ignore", invalid="ignore"):
        sides = (np.diff(times) == 0.0) & finite[1:] & finite[:-1]
        jumps = np.append(np.where(sides, np.abs(np.diff(values)), 0.0), 0.0)
    before = largest(jumps)
    before = before[jumps[before] > 0.0]
    gaps = largest(~finite)
    rows = (
        *(first, np.append(first[1:], count) - 1, before, before + 1, gaps[~finite[gaps]]),
        *(largest(np.where(finite, sign * values, -np.inf)) for sign in (1.0, -1.0)),
    )
    selected = np.unique(np.concatenate(rows))
    return TimeSeries(times[selected], values[selected])
