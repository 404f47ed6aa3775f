"""Thresholds of the mechanics, each with its reason.

Values at generic states are of order one: rounding errors are 1e-16 times a condition number, and
values that differ do so by 1e-3 or more.
"""

import sys

from pydy._rank import DEPENDENT, SOUND

CANCELLED = 1e-4
"""Fraction of its row and column below which an entry of a mass matrix may be the remainder of
cancelling terms: if half the digits agree, differences of 1e-12 of the terms are rounding."""

OPEN = 1e-7
"""Residuals of constraints, in their units, above which they are certainly violated."""

OMITTED_BELOW = (0.05, 1e-14)
"""Relative singular values below which Newton's steps omit a direction: large at first, since
redundant constraints attract full steps to singular positions; then small."""

SAME_DIRECTION = 1e-12
"""Difference below which two unit vectors, or two rotations, are equal: users normalise axes to
rounding, or to all digits that they type."""

NEARLY_DEPENDENT = (DEPENDENT, 1e-4)
"""Singular values in this interval are neither zero nor reliable: such states are ignored."""

SOUND_PIVOT = SOUND
"""Fraction of its row below which a pivot causes the full system to be solved: two digits are lost.
A row of J with such a pivot is nearly singular, and omitted if the state does not determine its
multiplier."""

SOUND_SHARE = 0.1
"""Further factor on `SOUND_PIVOT` in the equations of the independent speeds: at most three digits
are lost, where a wrong choice of dependent speeds would lose all."""

CLEAR = 1e-4
"""Fraction of its usual size below which a determinant indicates dependent constraints. With 1e-2 a
system of three rows took the fallback in every twelfth state of a rider's arms, far from singular
positions."""

GUARDED_UP_TO = 12
"""Independent speeds up to which their elimination is written out, with checked pivots."""

OFTEN, LESS_OFTEN = 0.03, 0.7
"""Fraction of random states with small pivots above which nearly parallel directions are
orthogonalised (1/9 for a rider's arms, 0 for a bicycle), and the factor by which this must reduce
it."""

LIGHT, LIGHTEST = 2e-7, 1e-4
"""Smallest ratio of an independent speed's own inertia to the inertia that it carries along: below,
three digits of the dependent speeds' derivatives are lost. The second applies if pivots are not
checked, since the equations of the independent speeds lose twice as many."""

READABLE = 2000
"""Largest number of terms that are expanded for printing: an arm of three joints in space, with all
moments and products of inertia, has some hundreds."""

DIGITS = sys.float_info.dig
"""Decimals that every float represents exactly as typed: a number with few bits but more decimals
is the remainder of a cancellation."""

NEAR = (2.0**-20, 2.0**-30)
"""Two relative distances from a switch at which only a jump has equal sizes: a term that tends to
zero shrinks by a factor of a thousand, an unbounded one grows."""

ACROSS = (-1.0, -0.1, -0.01)
"""Distances beyond a switch at which states are sampled, relative to the distance before it. Limbs
have a limited reach."""
