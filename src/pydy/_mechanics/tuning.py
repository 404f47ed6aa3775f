"""Thresholds of the mechanics, each with what it was found by.

Numbers at generic states are of order one, so that rounding leaves 1e-16 times a condition number;
those that differ differ by 1e-3 or more.
"""

import sys

from pydy._rank import DEPENDENT, SOUND

CANCELLED = 1e-4
"""The share of its row and column below which an entry of a mass matrix may be what is left of
terms that cancel: where half the digits agree, differences of 1e-12 of them are rounding."""

OPEN = 1e-7
"""Residuals of constraints, in their units, above which they certainly do not hold."""

FULL_STEPS = (0.05, 1e-14)
"""Shares below which singular values are left out of Newton's steps: first with few directions,
since redundant constraints draw full steps to singular positions; then with all."""

SAME_DIRECTION = 1e-12
"""The difference of two unit vectors, and of two rotations, that are the same: users' axes are
normalised to rounding, or to all digits that they wrote."""

NEARLY_DEPENDENT = (DEPENDENT, 1e-4)
"""Singular values between are neither zero nor sound: such a state is not counted."""

SOUND_PIVOT = SOUND
"""A pivot below this share of its row's size has all rows take part: two digits are lost. A row of
J with such a pivot is nearly singular: left out where the state does not tell its multiplier."""

SOUND_SHARE = 0.1
"""What a size is multiplied with beside `SOUND_PIVOT` where independent speeds are solved for:
three digits are lost at most, where a wrong choice of dependent speeds would lose all."""

CLEAR = 1e-4
"""The share of a determinant's usual size below which constraints may depend on each other: with
1e-2 one of three rows took the fallback in every twelfth state of a rider's arms, far from any
singular position."""

GUARDED_UP_TO = 12
"""Independent speeds up to which their elimination is written out, with its pivots looked at."""

OFTEN, LESS_OFTEN = 0.03, 0.7
"""The share of random states from which independent speeds whose motions are nearly parallel are
taken apart, a ninth with a rider's arms, none with a bicycle; and how far that must lower it."""

LIGHT, LIGHTEST = 2e-7, 1e-4
"""What an independent speed moves by itself, as a share of what moves with it: below, three digits
of the dependent speeds' derivatives are lost; the second where pivots are not looked at, since of
the independent ones' equations twice as many are."""

READABLE = 2000
"""Terms of an equation that are multiplied out to be written like a textbook's: those of an arm of
three joints in space, with all moments and products of inertia, are some hundreds."""

DIGITS = sys.float_info.dig
"""Decimals that every float keeps as they were typed: what has few bits, but more decimals, is left
of others."""

NEAR = (2.0**-20, 2.0**-30)
"""So near to a switch, in sizes of what switches, that a jump alone is as large at both: what tends
to zero has become a thousandth of itself, and what has no bound has grown."""
