"""Thresholds of the System's tasks, each with its reason."""

from __future__ import annotations

BESIDE = 1e-3
"""How far beside a state, relative to it, the size of a constraint's gradient is taken.

In a singular configuration itself the gradient is rounding errors; they are far below this.
"""

FIT, ORBIT = 1e-9, 1e-12
"""Tolerances of the integrations of fits and of periodic orbits: their results are differenced.

What moves by less than the second over a period, in units of its size, does not move."""

LEAST_SPREAD = 1e-2
"""The least scale of the states at which a fit joins parts, in units of their sizes."""

BEGINNING = 1e-3
"""An event that ends a period may be where it begins: it is looked for after this share."""

TEXTBOOK_UP_TO = 3
"""Coordinates of a model whose equations are multiplied out to be read, as textbooks do.

The terms of an arm in space grow tenfold with each joint: beyond three nobody prints them.
"""

LARGEST_SAMPLE = 2.0**255
"""The largest sample of a fit: SciPy's search forms the third power of residuals, and sums."""
