"""Thresholds of the assembly, each with what it was found by.

Those of numbers compare them at random states, which are of order one.
"""

from __future__ import annotations

SAME_RATE = 1e-9
"""The relative difference of rows that are the rates of velocity constraints."""

SAME_SHARE = 1e-8
"""What is left of a velocity constraint that is the rate of holonomic ones, in units of it, and
how far constant factors differ from state to state: ten times what a solve of rank 1e-9 leaves."""

NO_SHARE = 1e-12
"""Factors and entries that are zero."""

INTERPRETED = 64
"""How often a Program is interpreted before it is compiled: an operation takes about a microsecond
each time, and some 50 to be compiled. Who waits for both waits twice as long as need be at most."""
