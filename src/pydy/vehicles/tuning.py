"""Thresholds of tires, relative to the quantities that they are compared with."""

SMALLEST_LOAD = 1e-6
"""Load at which ratios of the load are evaluated where the load itself is smaller, relative to the
nominal load. Forces are in proportion to the load below. A larger value would change the forces of
a wheel that is about to lift; the square of a smaller one would be lost beside 1 in derivatives."""

SMALLEST_SLIP = 1e-12
"""Slip below which the direction of combined slip is not resolved, absolute. It is added in
quadrature: slips of 1e-6, which cause some 0.1 N, are changed by rounding alone."""

SHORTEST_RELAXATION = 1 / 32
"""Smallest relaxation length of those that depend on the load, relative to the wheel's radius: they
vanish with the load, and the deflections would decay without a bound. A lifted wheel that goes on
rolling loses them to a tenth in a fourteenth of a radian, which explicit solvers can follow; under
load relaxation lengths are of the size of the radius."""

SMALLEST_SLIDING = 1e-9
"""Sliding speed below which its direction is not resolved, relative to `low_speed`. It is added in
quadrature: the sliding of a wheel that holds on a slope is a small fraction of it."""

SMALLEST_DEFLECTION = 1e-9
"""Deflection of a flat tread below which the lever arm of its camber is reduced, relative to the
radius: an upright wheel that begins to touch has the arm 0/0. Loads are of that order there."""

UNEVEN_SPACING = 1e-6
"""Distance of samples of a profile from even places that is ignored, relative to the spacing: sums
of steps have rounding errors, and lengths in other units were rounded."""

COARSEST_DIGIT = 1e-2
"""Largest last digit of places in files, relative to the spacing, by which places that are rounded
to it may differ from even ones: thirds of a metre are 0.333 and 0.667. With fewer digits places at
1, 2 and 4 could not be told from even ones."""

POSITIONS_PER_ARM = 16
"""Number of positions by which a suspension is followed while its wheel travels by the length of an
arm. An arm turns by about a sixteenth of a radian between them, for which Newton's method takes
three steps; too few would let it reach another branch of the closed loop."""

SHORTEST_JUMP = 1e-9
"""Length within which the curvature of a track jumps where a straight meets an arc, relative to the
length of the track: samples of the curvature are linear between places. Twice as long moves a place
by that share; rounding of arc lengths is a millionth of it."""

FLAT_OBJECTIVE = 1e-14
"""Change of the largest acceleration at which a search for it ends, relative to its scale: some 45
roundings. Rounding ends most searches; whether an end is an optimum is judged by multipliers."""
