"""The classical method of order 4, for fixed steps, with cubic Hermite interpolation.

W. Kutta, "Beitrag zur näherungsweisen Integration totaler Differentialgleichungen", Zeitschrift
für Mathematik und Physik 46 (1901) 435–453.
"""

from pydy.solvers.tableaus import Tableau

_WEIGHTS = {0: 1 / 6, 1: 1 / 3, 2: 1 / 3, 3: 1 / 6}

RK4 = Tableau(
    name="rk4",
    order=4,
    error_order=None,
    nodes=(0.0, 0.5, 0.5, 1.0, 1.0),
    stages=({}, {0: 0.5}, {1: 0.5}, {2: 1.0}),
    weights=_WEIGHTS,
    errors=(),
    dense_stages=(),
    interpolant=(),
)
