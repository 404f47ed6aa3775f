"""Thresholds of the assembly, each with what it was found by."""

from __future__ import annotations

INTERPRETED = 64
"""How often a Program is interpreted before it is compiled: an operation takes about a microsecond
each time, and some 50 to be compiled. Who waits for both waits twice as long as need be at most."""
