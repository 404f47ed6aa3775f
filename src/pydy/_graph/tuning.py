"""Thresholds of the graph, each with what it was found by.

Counts are those of `tests/test_operation_counts.py`, at every call of a whole right-hand side.
"""

from __future__ import annotations

# -- rewriting ------------------------------------------------------------------------------------

# Terms of a sum that is multiplied out, by how often it is used. Sums that are used twice: 893 and
# 2,528 operations without for 10 and 20 links (670 and 1,390 with).
LONGEST_MULTIPLIED_OUT = {1: 4, 2: 2}

# -- linear solves --------------------------------------------------------------------------------

# Multiply-adds of an elimination that is written out, about those of a full 24 by 24 matrix;
# beyond, compiling takes longer than the loop loses. Of constants four times as many: they run
# once.
UNROLL_LIMIT = 3500

# -- derivatives of linear solves -----------------------------------------------------------------

# How many times the operations of A x those of A and b may be, for residuals to be tried. What
# saves is that product: pendulums have 1.4 to 2.5 times as many and save 14 to 31 % of eight
# columns' operations, the rods 8.8, the bicycle 17 and its rider 43, and save 2 % at most.
MATRIX_OVER_PRODUCT = 6

# -- Jacobians in parts ---------------------------------------------------------------------------

# Columns of a Jacobian that are taken at a time, with AVX2; a part has at least so many.
COLUMNS_TOGETHER = 4
# How many turns of a part's columns weigh as much as compiling its code. With 2 instead of 0.5,
# operations to compile and to run over those of the function are 2.3 and 3.4 instead of 2.8 and 3.2
# for 20 links, 2.8 and 6.1 instead of 3.8 and 4.1 for the rods, 2.8 and 4.4 instead of 3.5 and 3.8
# for the bicycle. Code is compiled once and stored.
ANOTHER_PART = 0.5
# Operations of a Jacobian from which it is computed in parts, estimated without what columns share.
# Five links, of 1,146, take 0.6 to 0.8 of the time.
FROM_OPERATIONS = 500
# How many times fewer operations the vectors of columns must take: each value that the columns
# share is written to memory and read again. The frozen bicycle, with 1.45, gains nothing in parts:
# it builds in 1.17 and runs in 0.90 of the time.
LESS_WORK = 1.5


# -- arguments of switches that are zero together --------------------------------------------------

# Random lines through the space of states; the places on each, from −2 to 2, and powers of two
# beyond, up to this one, for zeros at a planet's radius; and the zeros of an argument on a line,
# from the middle on. For a car on four Magic Formula tires, with 137 arguments, that takes a sixth
# of the time of the Program of a Jacobian, on brush tires, with 39, a third.
LINES, PLACES, FARTHEST, ZEROS = 8, 64, 60, 2
# Zeros of all arguments together, about: of many on fewer lines, two at least.
INTERVALS = 800
# Samples by which multiples of one another are told.
COMPARED = 24
# Halvings of an interval with a zero, to its last digit.
HALVINGS = 54
# A distance from the zero, relative to its place, at which slopes are found: to eight digits, of a
# nanometre's functions among metres. Two zeros are the same number within this part of it: 64
# roundings.
BESIDE, SAME_ZERO = 2.0**-28, 2.0**-19
# A distance at which functions without a slope are larger than rounding errors: x − sin(x), that
# cannot be told from zero nearer to it, is 2⁻¹⁶ of this part there, or less.
WIDE, SAME_ZERO_BY_ROUNDING = 2.0**-10, 2.0**-16
# Exponents of the distance from a zero, measured over a doubling of it, are the same up to this:
# half of the difference between neighbouring powers of a square root.
SAME_ORDER = 0.25
# Three hundred arguments take a second. If there are more, those that are not multiples of one
# another are not compared.
MOST_ARGUMENTS = 300

# -- times at which a Program switches by time alone -----------------------------------------------

# Relative distance by which bounds of an interval are moved apart: four roundings, as functions of
# C libraries are in error by less than two.
INTERVAL_SLACK = 2.0**-50
# An interval of time is divided into so many; so many are evaluated together, since they fit the
# processor's cache; and so many are looked at, in less than a second.
DIVISIONS = 4
INTERVALS_AT_ONCE = 4096
MOST_INTERVALS = 2**20
# Of the whole time: in shorter intervals a zero without a change of sign is as good as none. Two
# zeros of a parabola that are nearer than 2⁻²⁶ may be lost in rounding anyway.
SHORTEST_INTERVAL = 2.0**-32
# If the intervals are used up, changes of sign in those that are left. A few are zeros of an
# expression whose bounds stay wide, since the same term cancels in it; more are too many zeros.
FEW_CHANGES = 64
# Times at which signs are computed where no bounds are known.
SIGN_SAMPLES = 2**14
# Times that rounding may decide about: at least so much of the whole time, and two roundings of a
# time; they are widened by factors of 4, to 2⁻³⁰ of it at most.
LEAST_WINDOW = 2.0**-60
WIDENINGS = 16
# What switches at an end may do so beyond it, by rounding: of the largest of the times.
BEYOND_ENDS = 2.0**-48
# Results of searches that are stored for other runs with the same numbers; ensembles ask for each
# sample once.
STORED_SEARCHES = 8
