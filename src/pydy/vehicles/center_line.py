"""Center lines of tracks: splines through points; straights, arcs and clothoids."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np

from pydy._rank import ROUNDED
from pydy.inputs import SampledInput
from pydy.vehicles.tuning import SHORTEST_JUMP

if TYPE_CHECKING:
    from scipy.interpolate import BSpline

DEGREE = 5  # of a spline: its curvature has two continuous derivatives
# Gauss points of an integral over a part of a spline, or over a piece that turns by at most one
# radian: the remainder is below rounding.
_POINTS, _WEIGHTS = np.polynomial.legendre.leggauss(12)
_LARGEST_TURN = 1.0  # rad
_PARTS = 8  # of the span between two points
_MOST_STEPS = 50  # of Newton's method, which takes four


class CenterLine(Protocol):
    """A curve in the plane by its arc length s (m)."""

    @property
    def breaks(self) -> np.ndarray:
        """The arc lengths of the ends of its pieces, shape (k + 1,)."""

    def curve(self, s: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return positions (m, 2), headings and curvatures (m,) at arc lengths between the ends."""

    def curvature_input(self) -> SampledInput:
        """Return the curvature as an input over the arc length."""


@dataclass(frozen=True, eq=False)
class SplineLine:
    """A parametric spline; its arc length is an integral, inverted by Newton's method."""

    spline: BSpline  # of a parameter in m, with values in the plane
    breaks: np.ndarray
    # At the parts of all spans, shape (p,): parameter, arc length and continuous heading.
    parameters: np.ndarray
    lengths: np.ndarray
    headings: np.ndarray

    @classmethod
    def through(cls, points: np.ndarray, smoothing: float, *, closed: bool) -> SplineLine:
        """Return a spline whose root-mean-square distance from points (k, 2) is `smoothing`."""
        from scipy.interpolate import BSpline, splprep  # a tenth of a second to import

        rows = np.concatenate([points, points[:1]]) if closed else points
        knots = np.append(0.0, np.cumsum(np.hypot(*np.diff(rows, axis=0).T)))
        allowed = len(points) * smoothing**2
        (t, c, k), _ = splprep(rows.T, u=knots, k=DEGREE, s=allowed, per=closed)
        spline = BSpline(t, np.array(c).T, k)
        even = np.arange(_PARTS * (len(knots) - 1) + 1) / _PARTS
        parameters = np.interp(even, np.arange(len(knots)), knots)
        parts = _arc_lengths(spline, parameters[:-1], parameters[1:])
        lengths = np.append(0.0, np.cumsum(parts))
        headings = np.unwrap(np.arctan2(*spline(parameters, 1).T[::-1]))
        return cls(spline, lengths[::_PARTS], parameters, lengths, headings)

    def curve(self, s: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return positions, headings and curvatures at arc lengths."""
        at = np.clip(np.searchsorted(self.lengths, s, side="right") - 1, 0, len(self.lengths) - 2)
        u = self._parameters_at(s, at)
        (dx, dy), (ddx, ddy) = self.spline(u, 1).T, self.spline(u, 2).T
        turn = np.arctan2(dy, dx) - self.headings[at]
        heading = self.headings[at] + np.mod(turn + np.pi, 2 * np.pi) - np.pi
        points: np.ndarray = self.spline(u)
        return points, heading, (dx * ddy - dy * ddx) / np.hypot(dx, dy) ** 3

    def _parameters_at(self, s: np.ndarray, at: np.ndarray) -> np.ndarray:
        """Return the parameters at arc lengths, which lie in the parts `at`."""
        u: np.ndarray = np.interp(s, self.lengths, self.parameters)
        rounding = ROUNDED * self.lengths[-1]
        for _ in range(_MOST_STEPS):
            missing = s - self.lengths[at] - _arc_lengths(self.spline, self.parameters[at], u)
            u = u + missing / np.hypot(*self.spline(u, 1).T)
            if not (np.abs(missing) > rounding).any():
                break
        return u

    def curvature_input(self) -> SampledInput:
        """Return the curvature, sampled at the parts."""
        return SampledInput(self.lengths, self.curve(self.lengths)[2], "pchip")


def _arc_lengths(spline: BSpline, start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Return the lengths of a spline between parameters, shape (k,)."""
    half = (end - start) / 2
    u = ((start + end) / 2)[:, None] + half[:, None] * _POINTS
    speeds = np.hypot(*np.moveaxis(spline(u, 1), -1, 0))
    lengths: np.ndarray = half * (speeds @ _WEIGHTS)
    return lengths


@dataclass(frozen=True, eq=False)
class SegmentLine:
    """Pieces whose curvature is linear in the arc length: straights, arcs and clothoids."""

    # The user's segments, shape (k,): lengths (m), and curvatures (1/m) at both ends.
    lengths: np.ndarray
    first: np.ndarray
    last: np.ndarray
    # Pieces of them that turn little, shape (p,): where each begins, and the change of its
    # curvature over its arc length.
    starts: np.ndarray
    positions: np.ndarray  # (p, 2)
    headings: np.ndarray
    curvatures: np.ndarray
    slopes: np.ndarray

    @classmethod
    def of(cls, lengths: np.ndarray, first: np.ndarray, last: np.ndarray) -> SegmentLine:
        """Return the line that begins at the origin, in the direction of x."""
        turns = np.maximum(np.abs(first), np.abs(last)) * lengths / _LARGEST_TURN
        counts = np.maximum(np.ceil(turns), 1.0).astype(int)
        slopes = np.repeat((last - first) / lengths, counts)
        pieces = np.repeat(lengths / counts, counts)
        within = np.concatenate([np.arange(n) / n for n in counts])
        curvatures = np.repeat(first, counts) + slopes * within * np.repeat(lengths, counts)
        starts = np.repeat(np.append(0.0, np.cumsum(lengths))[:-1], counts)
        starts = starts + within * np.repeat(lengths, counts)
        turned = curvatures * pieces + slopes * pieces**2 / 2
        headings = np.append(0.0, np.cumsum(turned))[:-1]
        moved = _displacements(headings, curvatures, slopes, pieces)
        positions = np.concatenate([np.zeros((1, 2)), np.cumsum(moved, axis=0)])[:-1]
        return cls(lengths, first, last, starts, positions, headings, curvatures, slopes)

    @property
    def breaks(self) -> np.ndarray:
        """The arc lengths of the ends of the segments."""
        return np.append(0.0, np.cumsum(self.lengths))

    def curve(self, s: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return positions, headings and curvatures; where a curvature jumps, that after it."""
        at = np.searchsorted(self.starts, s, side="right") - 1
        d, heading = s - self.starts[at], self.headings[at]
        curvature, slope = self.curvatures[at], self.slopes[at]
        moved = _displacements(heading, curvature, slope, d)
        turned = curvature * d + slope * d**2 / 2
        return self.positions[at] + moved, heading + turned, curvature + slope * d

    def curvature_input(self) -> SampledInput:
        """Return the curvature, exact but for jumps beside clothoids, which are short ramps."""
        breaks = self.breaks
        if (self.first == self.last).all():
            return SampledInput(breaks, np.append(self.first, self.last[-1]), "previous")
        jumps = np.append(np.flatnonzero(self.last[:-1] != self.first[1:]) + 1, len(self.first))
        times = np.append(breaks[:-1], breaks[jumps] - SHORTEST_JUMP * breaks[-1])
        times[-1] = breaks[-1]
        order = np.argsort(times, kind="stable")
        return SampledInput(times[order], np.append(self.first, self.last[jumps - 1])[order])


def _displacements(
    headings: np.ndarray, curvatures: np.ndarray, slopes: np.ndarray, lengths: np.ndarray
) -> np.ndarray:
    """Return the integrals of (cos θ, sin θ) over the lengths, shape (m, 2)."""
    d = lengths[:, None] * (1 + _POINTS) / 2
    angles = headings[:, None] + curvatures[:, None] * d + slopes[:, None] * d**2 / 2
    weights = _WEIGHTS / 2
    means = np.stack([np.cos(angles) @ weights, np.sin(angles) @ weights], axis=1)
    displacements: np.ndarray = means * lengths[:, None]
    return displacements
