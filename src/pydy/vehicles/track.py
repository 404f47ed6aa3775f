"""Track: a road in the plane, by its center line and its widths."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from pydy._axes import axes_of
from pydy._checks import flag, number, positive, real_array, shown
from pydy._rank import ROUNDED
from pydy.inputs import SampledInput
from pydy.vehicles.center_line import DEGREE, CenterLine, SegmentLine, SplineLine

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike

_PLOTTED = 2001  # points of an edge
_PARTS = 10  # of the pieces of a center line, at which a nearest point is searched for
_MOST_STEPS = 50  # of Newton's method
_COLUMNS = "x, y, width to the right, width to the left"


@dataclass(frozen=True, eq=False)
class Track:
    """A closed or open road in the plane, by the arc length s of its center line.

    `Track.through` interpolates points, `read_track` reads them from a file, and `Track.segments`
    joins straights, arcs and clothoids. Points beside the center line have the offset n, positive
    to the left of it. s is periodic on a closed track.

    Attributes
    ----------
    length : float
        Of the center line (m).
    closed : bool
    breaks : ndarray, shape (k + 1,)
        The arc lengths (m) of the points, or of the ends of the segments.

    Examples
    --------
    >>> from pydy.vehicles.tracks import Track
    >>> track = Track.oval(200.0, 50.0, width=10.0)
    >>> track
    <Track: closed, 714.2 m, 10 to 10 m wide>
    >>> track.position([0.0, 200.0], n=2.0).round(6)
    array([[  0.,   2.],
           [200.,   2.]])
    """

    closed: bool
    _line: CenterLine
    _right: SampledInput
    _left: SampledInput

    @classmethod
    def through(
        cls,
        points: ArrayLike,
        right: ArrayLike,
        left: ArrayLike,
        *,
        closed: bool = True,
        smoothing: float = 0.0,
    ) -> Self:
        """Return a track whose center line is a spline of the fifth degree through points.

        Its curvature has two continuous derivatives. Widths are linear between the points.

        Parameters
        ----------
        points : array_like, shape (k, 2)
            x and y (m) in the direction of driving, at least six. The last point of a closed track
            may repeat the first.
        right, left : float or array_like, shape (k,)
            Distances (m) of the edges from the center line at the points, not negative.
        closed : bool, optional
        smoothing : float, optional
            Root-mean-square distance (m) of the line from the points, which is used up to make it
            smooth: the accuracy of measured points. By default the line meets the points.

        Returns
        -------
        Track

        References
        ----------
        P. Dierckx, Curve and surface fitting with splines, Oxford University Press, 1993.
        """
        xy = real_array(points, "`points`")
        closed = flag(closed, "`closed`")
        smoothing = positive(smoothing, "`smoothing`", zero=True, finite=True)
        if xy.ndim != 2 or xy.shape[1] != 2 or not np.isfinite(xy).all():
            raise ValueError(
                f"`points` must be finite, with the shape (k, 2), got {shown(points)}."
            )
        widths = [
            _widths(w, f"`{side}`", len(xy)) for side, w in (("right", right), ("left", left))
        ]
        if closed and len(xy) > 1 and (xy[0] == xy[-1]).all():
            xy, widths = xy[:-1], [w[:-1] for w in widths]
        if len(xy) <= DEGREE:
            raise ValueError(f"`points` must be at least {DEGREE + 1}, got {len(xy)}.")
        following = np.roll(xy, -1, axis=0) if closed else xy[1:]
        same = (xy[: len(following)] == following).all(axis=1)
        if same.any():
            k = int(same.argmax())
            raise ValueError(
                f"`points` must differ from those before them, got {xy[k].tolist()} twice, from "
                f"index {k} on. Drop repeated points."
            )
        line = SplineLine.through(xy, smoothing, closed=closed)
        if closed:
            widths = [np.append(w, w[0]) for w in widths]
        return cls(closed, line, *(SampledInput(line.breaks, w) for w in widths))

    @classmethod
    def segments(
        cls,
        segments: Sequence[Sequence[float]],
        right: ArrayLike,
        left: ArrayLike,
        *,
        closed: bool = True,
    ) -> Self:
        """Return a track of straights, arcs and clothoids, from the origin in the direction of x.

        Parameters
        ----------
        segments : sequence of pairs or triples
            The length (m) and the curvature (1/m), positive for a left turn, of each segment; or
            its length and the curvatures at its start and its end, between which it is linear.
        right, left : float or array_like, shape (k + 1,)
            Distances (m) of the edges from the center line, at the ends of the k segments.
        closed : bool, optional
            Whether the track ends where it begins; it must meet its start to rounding.

        Returns
        -------
        Track
        """
        closed = flag(closed, "`closed`")
        rows = _segments(segments)
        line = SegmentLine.of(*rows.T)
        if closed:
            _check_closed(line)
        sides = (("right", right), ("left", left))
        widths = [_widths(w, f"`{side}`", len(rows) + 1) for side, w in sides]
        return cls(closed, line, *(SampledInput(line.breaks, w) for w in widths))

    @classmethod
    def circle(cls, radius: float, width: float) -> Self:
        """Return a circle that is driven to the left.

        Parameters
        ----------
        radius : float
            Of the center line (m).
        width : float
            Of the road (m), less than twice the radius.

        Returns
        -------
        Track
        """
        r = positive(radius, "`radius`", finite=True)
        half = positive(width, "`width`", finite=True) / 2
        return cls.segments([(2 * np.pi * r, 1 / r)], half, half)

    @classmethod
    def oval(cls, straight: float, radius: float, width: float) -> Self:
        """Return two straights and two half circles, driven to the left.

        Parameters
        ----------
        straight : float
            Length of a straight (m); the first one begins at the origin.
        radius : float
            Of the center line in the turns (m).
        width : float
            Of the road (m), less than twice the radius.

        Returns
        -------
        Track
        """
        length = positive(straight, "`straight`", finite=True)
        r = positive(radius, "`radius`", finite=True)
        half = positive(width, "`width`", finite=True) / 2
        turn = np.pi * r
        if length + turn in (length, turn):
            raise ValueError(
                f"`straight` and `radius` must be of similar sizes, got {straight} and {radius} m: "
                "their sum has no digit of the smaller one."
            )
        return cls.segments([(length, 0.0), (turn, 1 / r)] * 2, half, half)

    def __repr__(self) -> str:
        total = self._right.values + self._left.values
        kind = "closed" if self.closed else "open"
        return (
            f"<Track: {kind}, {self.length:.4g} m, {total.min():.3g} to {total.max():.3g} m wide>"
        )

    @property
    def breaks(self) -> np.ndarray:
        """The arc lengths (m) of the points, or of the ends of the segments."""
        return self._line.breaks

    @property
    def length(self) -> float:
        """The length of the center line (m)."""
        return float(self._line.breaks[-1])

    def curvature(self, s: ArrayLike) -> float | np.ndarray:
        """Return the curvature κ (1/m) of the center line, positive in left turns.

        Parameters
        ----------
        s : float or array_like, shape (m,)
            Arc lengths (m).

        Returns
        -------
        float or ndarray, shape (m,)
            Where it jumps, the curvature after the jump.
        """
        at, alone = self._arc_lengths(s)
        return _shaped(self._line.curve(self._within(at))[2], alone)

    def heading(self, s: ArrayLike) -> float | np.ndarray:
        """Return the angle θ (rad) of the center line from the x-axis, continuous along the track.

        Parameters
        ----------
        s : float or array_like, shape (m,)
            Arc lengths (m).

        Returns
        -------
        float or ndarray, shape (m,)
        """
        at, alone = self._arc_lengths(s)
        within = self._within(at)
        heading = self._line.curve(within)[1]
        if self.closed:
            start, end = self._line.curve(np.array([0.0, self.length]))[1]
            heading = heading + np.floor(at / self.length) * (end - start)
        return _shaped(heading, alone)

    def position(self, s: ArrayLike, n: ArrayLike = 0.0) -> np.ndarray:
        """Return points of the plane.

        Parameters
        ----------
        s : float or array_like, shape (m,)
            Arc lengths (m).
        n : float or array_like, shape (m,), optional
            Offsets (m) to the left of the center line.

        Returns
        -------
        ndarray, shape (2,) or (m, 2)
            x and y (m).
        """
        at, _ = self._arc_lengths(s)
        offset = real_array(n, "`n`")
        if offset.ndim > 1 or (offset.ndim and np.ndim(s) and len(offset) != len(at)):
            raise ValueError(
                f"`n` must be a number, or one for each of the {len(at)} arc lengths, got "
                f"{shown(n)}."
            )
        points, heading, _ = self._line.curve(self._within(at))
        normal = np.stack([-np.sin(heading), np.cos(heading)], axis=-1)
        rows: np.ndarray = points + np.atleast_1d(offset)[:, None] * normal
        return rows[0] if np.ndim(s) == 0 and offset.ndim == 0 else rows

    def widths(self, s: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Return the distances of the edges from the center line, right and left.

        Parameters
        ----------
        s : float or array_like, shape (m,)
            Arc lengths (m).

        Returns
        -------
        pair of ndarray, shape (m,)
            (m).
        """
        at, _ = self._arc_lengths(s)
        within = self._within(at)
        return self._right.rows(within)[:, 0], self._left.rows(within)[:, 0]

    def locate(self, points: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Return the arc lengths and offsets of points, from the nearest points of the center line.

        Parameters
        ----------
        points : array_like, shape (m, 2)
            x and y (m).

        Returns
        -------
        s, n : ndarray, shape (m,)
            (m).
        """
        xy = real_array(points, "`points`")
        if xy.ndim != 2 or xy.shape[1] != 2 or not np.isfinite(xy).all():
            raise ValueError(
                f"`points` must be finite, with the shape (m, 2), got {shown(points)}."
            )
        even = np.arange(_PARTS * (len(self.breaks) - 1) + 1) / _PARTS
        samples = np.interp(even, np.arange(len(self.breaks)), self.breaks)
        count = int(np.ceil(self.length / np.diff(samples).max())) * _PARTS
        samples = np.union1d(samples, np.linspace(0.0, self.length, min(count, _PLOTTED)))
        line = self._line.curve(samples)[0]
        s = np.array([samples[np.hypot(*(line - p).T).argmin()] for p in xy])
        for _ in range(_MOST_STEPS):
            r, heading, curvature = self._line.curve(self._within(s))
            away = xy - r
            ahead = away[:, 0] * np.cos(heading) + away[:, 1] * np.sin(heading)
            n = away[:, 1] * np.cos(heading) - away[:, 0] * np.sin(heading)
            moved = s + ahead / np.maximum(1 - n * curvature, 0.5)
            moved = moved if self.closed else np.clip(moved, 0.0, self.length)
            done = not (np.abs(moved - s) > ROUNDED * self.length).any()
            s = moved
            if done:
                break
        return (np.mod(s, self.length) if self.closed else s), n

    def plot(self, ax: Axes | None = None) -> Axes:
        """Plot the edges, the center line and the start.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Where to draw; a new figure by default.

        Returns
        -------
        matplotlib Axes
        """
        ax = axes_of(ax, "pydy.vehicles")
        s = np.union1d(np.linspace(0.0, self.length, _PLOTTED), self.breaks)
        right, left = self._right.rows(s)[:, 0], self._left.rows(s)[:, 0]
        for n in (-right, left):
            ax.plot(*self.position(s, n).T, color="0.2", linewidth=0.9)
        ax.plot(*self.position(s).T, color="0.7", linewidth=0.8, linestyle="--")
        ax.plot(*self.position(s[[0, 0]], [-right[0], left[0]]).T, color="0.2", linewidth=2.0)
        ax.set_aspect("equal")
        ax.set_xlabel("x (m)")
        ax.set_ylabel("y (m)")
        return ax

    def _arc_lengths(self, s: ArrayLike) -> tuple[np.ndarray, bool]:
        """Return arc lengths as an array, and whether there is one alone."""
        values = real_array(s, "`s`")
        at = np.atleast_1d(values)
        slack = ROUNDED * self.length
        outside = not self.closed and bool(((at < -slack) | (at > self.length + slack)).any())
        if values.ndim > 1 or not np.isfinite(at).all() or outside:
            limits = "" if self.closed else f", from 0 to {self.length:.9g}"
            raise ValueError(
                f"`s` must be a finite arc length, or an array of them{limits}, got {shown(s)}."
            )
        return at, values.ndim == 0

    def _within(self, s: np.ndarray) -> np.ndarray:
        """Return arc lengths between the ends of the center line."""
        inside: np.ndarray = np.mod(s, self.length) if self.closed else np.clip(s, 0, self.length)
        return inside


def _shaped(values: np.ndarray, alone: bool) -> float | np.ndarray:
    return float(values[0]) if alone else values


def _widths(value: ArrayLike, label: str, count: int) -> np.ndarray:
    widths = real_array(value, label)
    if widths.shape not in ((), (count,)) or not (np.isfinite(widths) & (widths >= 0.0)).all():
        raise ValueError(
            f"{label} must be a distance of the edge from the center line, not negative, or one "
            f"for each of {count} points, got {shown(value)}."
        )
    return np.array(np.broadcast_to(widths, (count,)))


def _segments(segments: Any) -> np.ndarray:
    """Return lengths and curvatures at both ends, shape (k, 3)."""
    if not isinstance(segments, (list, tuple, np.ndarray)) or not len(segments):
        raise TypeError(
            "`segments` must be rows of a length and a curvature, or of a length and two "
            f"curvatures, got {shown(segments)}."
        )
    rows = []
    for k, segment in enumerate(segments):
        label = f"`segments[{k}]`"
        row = real_array(segment, label)
        if row.shape not in ((2,), (3,)) or not np.isfinite(row).all() or not row[0] > 0.0:
            raise ValueError(
                f"{label} must be a positive length and one curvature or two, got {shown(segment)}."
            )
        rows.append([row[0], row[1], row[-1]])
    return np.array(rows)


def _check_closed(line: SegmentLine) -> None:
    length = line.breaks[-1]
    points, headings, _ = line.curve(np.array([0.0, length]))
    gap = float(np.hypot(*(points[1] - points[0])))
    turn = float(headings[1] - headings[0])
    turns = round(turn / (2 * np.pi))
    # Positions are sums of integrals of angles that are sums of turns.
    rounding = ROUNDED * len(line.starts) * max(1.0, float(np.abs(line.headings).max()))
    if gap > rounding * length or abs(turn - 2 * np.pi * turns) > rounding:
        raise ValueError(
            f"`segments` must end where they begin, got a gap of {gap:.6g} m and a turn of "
            f"{np.degrees(turn):.6g}°. Change lengths or curvatures, or pass closed=False."
        )


def read_track(path: str | PathLike[str], *, closed: bool = True, smoothing: float = 0.0) -> Track:
    r"""Return the track of a file of points and widths.

    Its rows are x, y, and the widths to the right and to the left of the center line, all in m,
    separated by commas, semicolons or blanks; lines that begin with ``#`` are comments. This is the
    format ``# x_m,y_m,w_tr_right_m,w_tr_left_m`` of the racetrack database of TU Munich.

    Parameters
    ----------
    path : str or path
    closed : bool, optional
    smoothing : float, optional
        As for `Track.through`.

    Returns
    -------
    Track

    References
    ----------
    A. Heilmeier et al., Minimum curvature trajectory planning and control for an autonomous race
    car, Vehicle System Dynamics 58(10), 2020, pp. 1497–1527, whose racetrack database is
    https://github.com/TUMFTM/racetrack-database.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import mkdtemp
    >>> from pydy.vehicles.tracks import read_track
    >>> rows = [(100, 0), (50, 87), (-50, 87), (-100, 0), (-50, -87), (50, -87)]
    >>> path = Path(mkdtemp()) / 'ring.csv'
    >>> _ = path.write_text('# x_m,y_m,w_tr_right_m,w_tr_left_m\n'
    ...                     + ''.join(f'{x},{y},5.0,6.0\n' for x, y in rows))
    >>> read_track(path)
    <Track: closed, 629.7 m, 11 to 11 m wide>
    """
    if not isinstance(path, (str, PathLike)):
        raise TypeError(f"`path` must be the path of a file, got {shown(path)}.")
    rows = []
    for k, line in enumerate(Path(path).read_text(encoding="utf-8-sig").splitlines(), start=1):
        content = line.partition("#")[0].strip()
        if not content:
            continue
        try:
            row = [float(x) for x in content.replace(",", " ").replace(";", " ").split()]
        except ValueError:
            row = []
        if len(row) != 4:
            raise ValueError(
                f"Line {k} of `path`, {str(path)!r}, must have the four numbers {_COLUMNS} (m), "
                f"got {shown(content)}."
            )
        rows.append([number(x, f"A number in line {k} of `path`", finite=True) for x in row])
    table = np.array(rows).reshape(-1, 4)
    return Track.through(table[:, :2], table[:, 2], table[:, 3], closed=closed, smoothing=smoothing)
