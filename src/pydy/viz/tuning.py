"""Thresholds of scenes, each with its reason."""

from __future__ import annotations

PIXELS = 2000
"""Of a wide screen: what is narrower on its time axis is not seen."""

FILLED = 7200
"""Parts of a film, two minutes of 60 a second, finer than which no instants are added."""

USUAL = 0.9
"""The part of the time for which an arrow is no longer than its usual length."""
