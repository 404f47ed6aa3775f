"""Thresholds of scenes, each with its reason."""

from __future__ import annotations

ALIKE = 1e-6
"""Moments of inertia that differ by no more than this part of the greatest count as equal."""

AT_REST = 1e-9
"""What moves by less than this part of its size is sent once."""

TRACK = 1e-8
"""Distances, in units of a scene's size, below what a 32-bit float tells apart."""

RIGID = 1e-11
"""The same in double precision at random states, of points that are rigidly joined."""

FILLED = 7200
"""Parts of a film, two minutes of 60 a second, finer than which no instants are added."""

FLAT = 1e-9
"""The thickness of points that lie in a plane, in units of their extent."""

ON_TIME = 1e-6
"""The part of a frame's time by which rounding may have it early."""

ROUND = 1e-9
"""By what part a length that is 1, 2 or 5 may be less."""

USUAL = 0.9
"""The part of the time for which an arrow is no longer than its usual length."""
