"""Radau IIA of order 5: nodes, and the transformation that splits its stages into 1 + 2.

E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd edition, section IV.8 (code
RADAU5). With A the method's matrix, ``TI @ inv(A) @ T`` is block diagonal: the real eigenvalue, and
``[[α, −β], [β, α]]`` of the complex pair.
"""

from math import sqrt

_S = sqrt(6.0)

NODES = ((4.0 - _S) / 10.0, (4.0 + _S) / 10.0, 1.0)

REAL = 3.0 + 3.0 ** (2 / 3) - 3.0 ** (1 / 3)
COMPLEX = complex(
    3.0 + 0.5 * (3.0 ** (1 / 3) - 3.0 ** (2 / 3)), -0.5 * (3.0 ** (5 / 6) + 3.0 ** (7 / 6))
)

T = (
    (0.09443876248897524, -0.14125529502095421, 0.03002919410514742),
    (0.25021312296533332, 0.20412935229379994, -0.38294211275726192),
    (1.0, 1.0, 0.0),
)
TI = (
    (4.17871859155190428, 0.32768282076106237, 0.52337644549944951),
    (-4.17871859155190428, -0.32768282076106237, 0.47662355450055044),
    (0.50287263494578682, -2.57192694985560522, 0.59603920482822492),
)

# The embedded error is the real system's solution for h f(x) + Σ ERROR z.
ERROR = ((-13.0 - 7.0 * _S) / 3.0, (-13.0 + 7.0 * _S) / 3.0, -1.0 / 3.0)

# Coefficients of θ, θ², θ³ of the collocation polynomial, for each stage.
INTERPOLANT = (
    (13.0 / 3.0 + 7.0 * _S / 3.0, -23.0 / 3.0 - 22.0 * _S / 3.0, 10.0 / 3.0 + 5.0 * _S),
    (13.0 / 3.0 - 7.0 * _S / 3.0, -23.0 / 3.0 + 22.0 * _S / 3.0, 10.0 / 3.0 - 5.0 * _S),
    (1.0 / 3.0, -8.0 / 3.0, 10.0 / 3.0),
)
