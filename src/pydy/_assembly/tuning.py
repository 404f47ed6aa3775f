"""Thresholds of the assembly, each with its reason."""

GLOBAL_ERRORS = 1e3
"""Errors of a motion, in units of the error that its solver allows in one step.

Sound motions over thousands of steps stay below it. A state that touches the limit of its
assumption within that has not left it."""

OF_RANGE = 1e-2
"""Share of a state's largest value that contradicts an assumption, whatever the tolerances."""
