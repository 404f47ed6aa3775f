"""Names and functions that expressions may hold."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

import zoo
from pydy.codegen.ode_function_generators import generate_ode_function
from zoo.cases import close

T = zoo.T
GENERATORS = ["llvm", "lambdify"]
X, V = me.dynamicsymbols("x v")
M, K = sm.symbols("m k")

# names and functions


@pytest.mark.parametrize("generator", [*GENERATORS, "cython"])
def test_any_name_will_do(generator):
    names = ["lambda", "double", "x y", "∫ a dt", "1st", "a'", "a_", "a", "sin", "t0", "x", "np"]
    symbols = [sm.Symbol(n) for n in names] + [sm.Symbol("a", positive=True), sm.Dummy("a")]
    total = sum((i + 1) * s for i, s in enumerate(symbols))
    rhs = generate_ode_function(
        sm.Matrix([V, total * sm.sin(X)]), [X], [V], symbols, generator=generator
    )
    p = np.linspace(0.1, 1.7, len(symbols))
    close(rhs([0.3, 0.4], 0.0, p), [0.4, np.dot(np.arange(1, len(p) + 1), p) * np.sin(0.3)])


x, v = X, V
FUNCTIONS = [
    sm.sqrt(x) + x**v + x**-3 + x ** sm.Rational(2, 3) + 1 / v + sm.cbrt(x),
    sm.exp(-x) + sm.log(x + 2) + sm.E**v,
    sm.sin(x) + sm.cos(3 * x) + sm.tan(v) + sm.cot(x) + sm.sec(x) + sm.csc(v),
    sm.sinh(x) + sm.cosh(v) + sm.tanh(x),
    sm.asin(x) + sm.acos(v) + sm.atan(x * 3) + sm.atan2(v - 1, x - 1),
    sm.asinh(x) + sm.acosh(v + 1) + sm.atanh(x),
    sm.Abs(x - 2) + sm.sign(v - 3) + sm.Abs(v),
    sm.Min(x, v, 0.7) + sm.Max(x, v, 0.1) * 3,
    sm.Piecewise((x, x > v), (v**2, x < v / 2), (3, True)),
    sm.Piecewise((1, (x > 0.2) & (v > 0.9)), (2, (x > 5) | ~(v > 0.1)), (x, True)),
    sm.Heaviside(x - 0.2) * 3 + sm.Heaviside(v - 5),
    sm.floor(7 * x) + sm.ceiling(7 * v),
    sm.pi * x + sm.Rational(1, 3) + sm.Float("1e-7") * v + sm.Integer(10) ** 20 * x,
]


@pytest.mark.parametrize("generator", [*GENERATORS, "cython"])
def test_functions_of_a_modeller_agree_with_sympy(generator):
    rhs = generate_ode_function(sm.Matrix([v, x]), [x], [v], outputs=FUNCTIONS, generator=generator)
    for a, b in ((0.31, 0.77), (0.83, 0.27), (0.55, 0.91)):
        _, y = rhs([a, b], 0.0, [])
        expected = [
            float(f.subs({x: sm.Float(a, 30), v: sm.Float(b, 30)}).evalf(20)) for f in FUNCTIONS
        ]
        np.testing.assert_allclose(y, expected, rtol=1e-13)
