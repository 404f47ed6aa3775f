"""Thresholds of the System's tasks, each with its reason."""

FIT, ORBIT = 1e-9, 1e-12
"""Tolerances of the integrations of fits and of periodic orbits: their results are differenced.

What moves by less than the second over a period, in units of its size, does not move."""

BEGINNING = 1e-3
"""An event that ends a period may be where it begins: it is looked for after this share."""

TOGETHER = 1024
"""States that are evaluated together: their inputs fit in a cache."""
