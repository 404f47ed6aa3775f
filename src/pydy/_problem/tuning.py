"""Thresholds of the System's tasks, each with its reason."""

FIT = 1e-9
"""Tolerances of the integrations of fits: their results are differenced."""

TOGETHER = 1024
"""States that are evaluated together: their inputs fit in a cache."""
