"""Thresholds of tires, relative to the quantities that they are compared with."""

SMALLEST_LOAD = 1e-6
"""Load at which ratios of the load are evaluated where the load itself is smaller, relative to the
nominal load. Forces are in proportion to the load below. A larger value would change the forces of
a wheel that is about to lift; the square of a smaller one would be lost beside 1 in derivatives."""

SMALLEST_SLIP = 1e-12
"""Slip below which the direction of combined slip is not resolved, absolute. It is added in
quadrature: slips of 1e-6, which cause some 0.1 N, are changed by rounding alone."""

SHORTEST_RELAXATION = 0.01
"""Smallest relaxation length (m) of those that depend on the load. At 50 m/s the deflections of a
wheel in the air then decay in 0.2 ms, which explicit solvers can follow."""

SMALLEST_SPEED = 1e-9
"""Sliding speed (m/s) below which its direction is not resolved. It is added in quadrature. On a
slope a tire with relaxation creeps by a small fraction of it."""
