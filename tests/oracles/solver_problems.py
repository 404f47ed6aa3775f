"""Published problems for the tests of solvers, as compiled right-hand sides with exact answers."""

from dataclasses import dataclass
from functools import cache

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from scipy.special import ellipj

from pydy.codegen.ode_function_generators import generate_ode_function

__all__ = ["arenstorf", "hires", "oscillator", "pleiades", "rigid_body", "van_der_pol"]


@dataclass(frozen=True, eq=False)
class Problem:
    """x' = f(x, t) from x0 at 0 to `final` at `end`."""

    f: object
    x0: np.ndarray
    end: float
    final: np.ndarray
    args: tuple = ()


def function(rates, coordinates, speeds, constants=()):
    return generate_ode_function(rates, coordinates, speeds, constants)


@cache
def arenstorf():
    """A closed orbit of three bodies.

    E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, section II.0.
    """
    x, y, u, v = me.dynamicsymbols("x y u v")
    mass = sm.Float("0.012277471", 20)
    other = 1 - mass
    near, far = sm.sqrt((x + mass) ** 2 + y**2) ** 3, sm.sqrt((x - other) ** 2 + y**2) ** 3
    rates = [
        u,
        v,
        x + 2 * v - other * (x + mass) / near - mass * (x - other) / far,
        y - 2 * u - other * y / near - mass * y / far,
    ]
    start = np.array([0.994, 0.0, 0.0, -2.00158510637908252240537862224])
    f = function(rates, [x, y], [u, v])
    return Problem(f, start, 17.0652165601579625588917206249, start, ((),))


@cache
def pleiades():
    """Seven stars in a plane.

    F. Mazzia, C. Magherini, Test Set for Initial Value Problem Solvers, release 2.4, problem PLEI.
    """
    x, y, u, v = (me.dynamicsymbols(f"{name}1:8") for name in "xyuv")
    pulls = [[], []]
    for i in range(7):
        total = [0, 0]
        for j in range(7):
            if j != i:
                dx, dy = x[j] - x[i], y[j] - y[i]
                cube = sm.sqrt(dx**2 + dy**2) ** 3
                total[0] += (j + 1) * dx / cube
                total[1] += (j + 1) * dy / cube
        pulls[0].append(total[0])
        pulls[1].append(total[1])
    start = [
        *(3, 3, -1, -3, 2, -2, 2),
        *(3, -3, 2, 0, 0, -4, 4),
        *(0, 0, 0, 0, 0, 1.75, -1.5),
        *(0, 0, 0, -1.25, 1, 0, 0),
    ]
    final = [
        *(0.3706139143970502, 3.237284092057233, -3.222559032418324, 0.6597091455775310),
        *(0.3425581707156584, 1.562172101400631, -0.7003092922212495),
        *(-3.943437585517392, -3.271380973972550, 5.225081843456543, -2.590612434977470),
        *(1.198213693392275, -0.2429682344935824, 1.091449240428980),
        *(3.417003806314313, 1.354584501625501, -2.590065597810775, 2.025053734714242),
        *(-1.155815100160448, -0.8072988170223021, 0.5952396354208710),
        *(-3.741244961234010, 0.3773459685750630, 0.9386858869551073, 0.3667922227200571),
        *(-0.3474046353808490, 2.344915448180937, -1.947020434263292),
    ]
    f = function([*u, *v, *pulls[0], *pulls[1]], [*x, *y], [*u, *v])
    return Problem(f, np.array(start, dtype=float), 3.0, np.array(final), ((),))


@cache
def rigid_body():
    """Euler's equations of a free rigid body, whose solution are Jacobi's elliptic functions.

    E. T. Whittaker, Analytical Dynamics, section 69.
    """
    w = me.dynamicsymbols("w1:4")
    A, B, C = 3.0, 2.0, 1.2
    rates = [(B - C) / A * w[1] * w[2], (C - A) / B * w[2] * w[0], (A - B) / C * w[0] * w[1]]
    f = function(rates, w, [])
    # w = (a cn, −b sn, c dn)(λ t, m) fulfils these if the products of the amplitudes do.
    a, c = 0.5, 1.7
    # From w1' and w3': λ a = (B − C)/A b c, m λ c = (A − B)/C a b; from w2': λ b = (A − C)/B c a.
    b = a * np.sqrt((A - C) * A / (B * (B - C)))
    rate = (B - C) / A * b * c / a
    m = (A - B) / C * a * b / (rate * c)

    def exact(t):
        sn, cn, dn, _ = ellipj(rate * np.asarray(t), m)
        return np.stack([a * cn, -b * sn, c * dn], axis=-1)

    f.exact = exact
    return Problem(f, exact(0.0), 20.0, exact(20.0), ((),))


@cache
def oscillator():
    """A damped linear oscillator, for which an implicit method's iteration is exact."""
    x, v = me.dynamicsymbols("x v")
    f = function([v, -4 * x - v / 5], [x], [v])
    decay = complex(-0.1, np.sqrt(4.0 - 0.01))

    def exact(t):
        wave = np.exp(decay * np.asarray(t))
        slope = decay.real / decay.imag  # x = Re − a/b Im starts at 1 with x' = 0
        position = wave.real - slope * wave.imag
        rate = decay * wave
        return np.stack([position, rate.real - slope * rate.imag], axis=-1)

    f.exact = exact
    return Problem(f, exact(0.0), 4.0, exact(4.0), ((),))


@cache
def van_der_pol():
    """Van der Pol's oscillator, stiff with ε = 1e-6; Test Set, problem VDPOL."""
    y, z = me.dynamicsymbols("y z")
    f = function([z, ((1 - y**2) * z - y) / sm.Float("1e-6", 20)], [y], [z])
    final = np.array([1.706167732170483, -0.8928097010247975])
    return Problem(f, np.array([2.0, 0.0]), 2.0, final, ((),))


@cache
def hires():
    """Eight chemical reactions, stiff; Test Set, problem HIRES."""
    y = me.dynamicsymbols("y1:9")
    fast = 280 * y[5] * y[7]
    rates = [
        -1.71 * y[0] + 0.43 * y[1] + 8.32 * y[2] + 0.0007,
        1.71 * y[0] - 8.75 * y[1],
        -10.03 * y[2] + 0.43 * y[3] + 0.035 * y[4],
        8.32 * y[1] + 1.71 * y[2] - 1.12 * y[3],
        -1.745 * y[4] + 0.43 * y[5] + 0.43 * y[6],
        -fast + 0.69 * y[3] + 1.71 * y[4] - 0.43 * y[5] + 0.69 * y[6],
        fast - 1.81 * y[6],
        -fast + 1.81 * y[6],
    ]
    final = [
        *(0.7371312573325668e-3, 0.1442485726316185e-3, 0.5888729740967575e-4),
        *(0.1175651343283149e-2, 0.2386356198831331e-2, 0.6238968252742796e-2),
        *(0.2849998395185769e-2, 0.2850001604814231e-2),
    ]
    start = np.array([1.0, 0, 0, 0, 0, 0, 0, 0.0057])
    return Problem(function(rates, y, []), start, 321.8122, np.array(final), ((),))
