"""Every function that is read from SymPy, against SymPy's own evaluation with 40 digits."""

import math

import numpy as np
import pytest
import sympy as sm
from sympy.functions.elementary.piecewise import ExprCondPair
from sympy.physics.biomechanics import TendonForceLengthDeGroote2016

from graphs import P, T, X, evaluate, nodes_of, on_tape, program_of, values
from pydy._backends.llvm.native import LLVMBackend
from pydy._errors import UnsupportedFunctionError
from pydy._graph.from_sympy import HANDLERS, Formula, NodeExpression, SymPyReader
from pydy._graph.node import Graph
from pydy._program.operations import OPERATIONS

x, y, z, w = X
f = sm.Function("f")

LINE = [-2.5, -1.0, -0.3, 1e-9, 0.4, 1.0, 2.0, 7.25]
NONZERO = [-2.5, -1.0, -1e-3, 0.4, 1.0, 2.0, 7.25]
POSITIVE = [1e-9, 0.4, 1.0, 2.5, 1e6]
INSIDE = [-0.999, -0.5, -1e-9, 0.3, 0.75]
STEPS = [-2.0, -1.5, -0.5, -1e-300, 0.0, 1e-300, 0.5, 1.0, 2.0]

# function -> (expression in x, values of x)
OF_ONE = {
    sm.exp: (sm.exp(x), [*LINE, -700.0, 700.0]),
    sm.log: (sm.log(x), POSITIVE),
    sm.sin: (sm.sin(x), [*LINE, 0.0, 1e5]),
    sm.cos: (sm.cos(x), [*LINE, 0.0, 1e5]),
    sm.tan: (sm.tan(x), [*LINE, 0.0, 1.5707963]),
    sm.cot: (sm.cot(x), NONZERO),
    sm.sec: (sm.sec(x), LINE),
    sm.csc: (sm.csc(x), NONZERO),
    sm.sinc: (sm.sinc(x), [*LINE, 0.0, -1e-200]),
    sm.asin: (sm.asin(x), [*INSIDE, -1.0, 0.0, 1.0]),
    sm.acos: (sm.acos(x), [*INSIDE, -1.0, 0.0, 1.0]),
    sm.atan: (sm.atan(x), [*LINE, 0.0, 1e300]),
    sm.acot: (sm.acot(x), [*NONZERO, 0.0]),
    sm.asec: (sm.asec(x), [-7.5, -1.0, 1.0, 1.5, 30.0]),
    sm.acsc: (sm.acsc(x), [-7.5, -1.0, 1.0, 1.5, 30.0]),
    sm.sinh: (sm.sinh(x), [*LINE, 0.0]),
    sm.cosh: (sm.cosh(x), [*LINE, 0.0]),
    sm.tanh: (sm.tanh(x), [*LINE, 0.0, 50.0]),
    sm.coth: (sm.coth(x), NONZERO),
    sm.sech: (sm.sech(x), [*LINE, 0.0, 300.0]),
    sm.csch: (sm.csch(x), NONZERO),
    sm.asinh: (sm.asinh(x), [*LINE, 0.0]),
    sm.acosh: (sm.acosh(x), [1.0, 1.5, 30.0]),
    sm.atanh: (sm.atanh(x), [*INSIDE, 0.0]),
    sm.acoth: (sm.acoth(x), [-30.0, -1.5, 1.5, 30.0]),
    sm.asech: (sm.asech(x), [1e-3, 0.5, 1.0]),
    sm.acsch: (sm.acsch(x), NONZERO),
    sm.erf: (sm.erf(x), [*LINE, 0.0]),
    sm.erfc: (sm.erfc(x), [*LINE, 0.0]),
    sm.Abs: (sm.Abs(x), STEPS),
    sm.sign: (sm.sign(x), STEPS),
    sm.floor: (sm.floor(x), STEPS),
    sm.ceiling: (sm.ceiling(x), STEPS),
    sm.frac: (sm.frac(x), [v for v in STEPS if v != -1e-300]),
    sm.Heaviside: (sm.Heaviside(x), STEPS),
}
PAIRS = [(0.7, 2.5), (-0.7, 2.5), (0.7, -2.5), (-0.7, -2.5), (1.5, 1.5), (-3.0, 1.5)]
# function -> (expression in x and y, values of x and y)
OF_TWO = {
    sm.Add: (x + y, PAIRS),
    sm.Mul: (-3 * x * y / 7, PAIRS),
    sm.atan2: (sm.atan2(x, y), [*PAIRS, (0.0, 1.0), (1.0, 0.0), (-1.0, 0.0)]),
    sm.Mod: (sm.Mod(x, y), [*PAIRS, (7.25, 2.0), (-7.25, 2.0), (7.25, -2.0), (-6.0, 3.0)]),
    sm.Min: (sm.Min(x, y, sm.Rational(1, 5)), PAIRS),
    sm.Max: (sm.Max(x, y, -sm.Rational(1, 5)), PAIRS),
    sm.log: (sm.log(x * x + 1, y * y + 2), PAIRS),
    sm.Heaviside: (sm.Heaviside(x, y), [(0.0, 0.25), (-1.0, 0.25), (1.0, 0.25)]),
}
EXPONENTS = [
    *(sm.Integer(n) for n in (-3, -1, 2, 5, 65, -70)),
    *(sm.Rational(n, 2) for n in (-3, -1, 1, 3, 131)),
    sm.Rational(1, 3),
    sm.Float(2.0),
    sm.Float(-0.75),
    sm.pi,
]
CORNERS = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 1.0), (1.0, 0.0)]
CONDITIONS = {
    sm.StrictLessThan: x < y,
    sm.LessThan: x <= y,
    sm.StrictGreaterThan: x > y,
    sm.GreaterThan: x >= y,
    sm.Equality: sm.Eq(x, y),
    sm.Unequality: sm.Ne(x, y),
    sm.And: sm.And(x > 0, y > 0, x < y),
    sm.Or: sm.Or(x > 0, y > 0),
    sm.Not: sm.Not(sm.And(x > 0, y > 0), evaluate=False),
    sm.Xor: sm.Xor(x > 0, y > 0, x < y),
    sm.ITE: sm.ITE(x > 0, y > 0, x < y),
    sm.Implies: sm.Implies(x > 0, y > 0, evaluate=False),
    sm.Equivalent: sm.Equivalent(x > 0, y > 0, x < y),
}
ELSEWHERE = {sm.Pow, sm.Piecewise, ExprCondPair, sm.re, sm.im, sm.conjugate, sm.UnevaluatedExpr}
ELSEWHERE |= {NodeExpression, Formula}  # nodes of another graph


def reference(expression, *point):
    """SymPy's value with 40 digits, at exactly the doubles that are given."""
    exact = {s: sm.Rational(v) for s, v in zip(X, point, strict=False)}
    value = expression.subs(exact).evalf(40)
    assert value.is_Float or value.is_Integer or value.is_Rational, value
    return float(value)


def close(actual, expected, ulps=4):
    assert abs(actual - expected) <= ulps * np.spacing(abs(expected)), (actual, expected)


def test_no_function_is_left_out_here():
    of_the_table = {getattr(sm, row.sympy) for row in OPERATIONS.values() if row.sympy}
    assert {*HANDLERS, *of_the_table} == {*OF_ONE, *OF_TWO, *CONDITIONS, *ELSEWHERE}


@pytest.mark.parametrize("function", OF_ONE, ids=lambda f: f.__name__)
def test_a_function_of_one_argument_is_what_sympy_says(function):
    expression, points = OF_ONE[function]
    assert expression.has(function)
    for point in points:
        close(evaluate(expression, point), reference(expression, point))


@pytest.mark.parametrize("function", OF_TWO, ids=lambda f: f.__name__)
def test_a_function_of_more_arguments_is_what_sympy_says(function):
    expression, points = OF_TWO[function]
    for point in points:
        expected = reference(expression, *point)
        close(evaluate(expression, *point), expected, 4 if expected else 0)


@pytest.mark.parametrize("exponent", EXPONENTS, ids=str)
def test_a_power_is_what_sympy_says(exponent):
    for base in [0.3, 1.0, 1.7]:
        # A power by repeated squaring doubles the relative error with every squaring.
        ulps = 4 + abs(exponent)
        close(evaluate(x**exponent, base), reference(x**exponent, base), ulps)


@pytest.mark.parametrize("exponent", [-3, -2, 2, 3, 65, 66])
def test_an_integer_power_takes_a_negative_base(exponent):
    close(evaluate(x**exponent, -1.2), reference(x**exponent, -1.2), 4 + abs(exponent))


@pytest.mark.parametrize("exponent", [sm.Rational(1, 3), sm.Rational(1, 2), sm.Rational(-3, 2)])
def test_a_broken_power_of_a_negative_base_is_nan(exponent):
    assert math.isnan(evaluate(x**exponent, -8.0))


def test_a_power_may_have_a_variable_exponent():
    for point in PAIRS:
        base, exponent = abs(point[0]), point[1]
        close(evaluate(x**y, base, exponent), reference(x**y, base, exponent))


def test_a_number_may_have_a_variable_exponent():
    close(evaluate(2**x, -2.5), reference(2**x, -2.5))


# -- conditions -----------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", CONDITIONS, ids=lambda f: f.__name__)
def test_a_condition_is_what_sympy_says_on_its_border_too(kind):
    condition = CONDITIONS[kind]
    assert isinstance(condition, kind)
    for point in CORNERS:
        truth = condition.subs(dict(zip(X, map(sm.Integer, map(int, point)), strict=False)))
        assert evaluate(sm.Piecewise((3, condition), (5, True)), *point) == (3 if truth else 5)


def test_a_piecewise_inside_a_condition_compiles():
    inner = sm.Piecewise((y, x > 0), (-1 - y, True))
    expression = sm.Piecewise((3, inner > 0), (5, True))
    kernel = LLVMBackend().compile(program_of([expression]))
    for point in [(1.0, 1.0), (1.0, -2.0), (-1.0, -2.0), (-1.0, 1.0)]:
        expected = 3 if (point[1] if point[0] > 0 else -1 - point[1]) > 0 else 5
        assert evaluate(expression, *point) == expected
        assert values(kernel.program, point, kernel=kernel)[0] == expected


PIECES = sm.Piecewise((x - 1, x < 0), (y, sm.And(x >= 0, x < 1)), (x**2, x < 2))


@pytest.mark.parametrize(
    ("at", "expected"), [(-0.5, -1.5), (0.0, 0.25), (0.75, 0.25), (1.0, 1.0), (1.5, 2.25)]
)
def test_the_first_piece_whose_condition_holds_is_taken(at, expected):
    assert evaluate(PIECES, at, 0.25) == expected


def test_where_no_condition_of_a_piecewise_holds_the_value_is_nan():
    assert math.isnan(evaluate(PIECES, 2.0, 0.25))


def test_overlapping_pieces_go_by_their_order():
    assert evaluate(sm.Piecewise((1, x > 0), (2, x > 1), (3, True)), 5.0) == 1.0


def test_a_piece_that_is_not_taken_may_be_undefined():
    expression = sm.Piecewise((0, x <= 0), (sm.log(x), True))
    assert evaluate(expression, -1.0) == 0.0


@pytest.mark.parametrize(
    "function", [sm.Heaviside, sm.sign, sm.Abs, sm.floor, sm.Min, sm.Max], ids=str
)
def test_nan_goes_through_a_function_with_a_switch(function):
    expression = function(x, y) if function in (sm.Min, sm.Max) else function(x)
    assert math.isnan(evaluate(expression, math.nan, 1.0))


def test_a_condition_on_nan_does_not_hold():
    assert evaluate(sm.Piecewise((1, x < 2), (2, True)), math.nan) == 2.0


# -- leaves ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "number",
    [
        sm.Integer(-7),
        sm.Rational(1, 3),
        sm.Float("0.1"),
        sm.pi,
        sm.E,
        sm.GoldenRatio,
        sm.EulerGamma,
        sm.Catalan,
        sm.sqrt(2),
        sm.oo,
    ],
    ids=str,
)
def test_a_number_is_its_nearest_double(number):
    assert evaluate(number) == float(number)


def test_time_and_constants_are_inputs_of_their_own():
    program = program_of([x + 10 * T + 100 * P[1]])
    assert values(program, [1.0, 0, 0, 0], [0, 3.0, 0], t=2.0)[0] == 321.0


def test_plain_python_numbers_are_read():
    assert evaluate(2.5) == 2.5


def test_functions_of_time_and_their_derivatives_are_names_of_their_own():
    q = f(T)
    graph = Graph()
    atoms = {q: graph.input("x", 0), q.diff(T): graph.input("x", 1)}
    node = SymPyReader(graph, atoms)(q**2 + q.diff(T))
    assert values(on_tape(graph, [node], (2, 0, 0)), [3.0, 0.5])[0] == 9.5


def test_a_name_that_is_defined_later_replaces_what_was_read_before():
    graph, (before,) = nodes_of([sm.sin(x)])
    read = SymPyReader(graph, {x: graph.input("x", 0), y: graph.input("x", 1)})
    assert read(sm.sin(x)) == before
    read.define(x, read(y))
    assert read(sm.sin(x)) == read(sm.sin(y))


def test_equal_expressions_that_were_built_apart_are_one_node():
    first = sm.Add(sm.sin(x, evaluate=False), y, evaluate=False)
    second = sm.Add(y, sm.sin(x, evaluate=False), evaluate=False)
    graph, (one, other) = nodes_of([first, second])
    assert one == other
    assert graph.ops[one] == "sum"


def test_real_and_imaginary_parts_of_what_is_real():
    assert evaluate(2 * sm.re(x) + sm.conjugate(x) + 5 * sm.im(x), 3.0) == 9.0


def test_what_sympy_was_told_to_leave_is_what_it_holds():
    assert evaluate(2 * sm.UnevaluatedExpr(x + 1) + sm.UnevaluatedExpr(sm.Integer(3)), 3.0) == 11.0


# -- derivatives that SymPy does not take ---------------------------------------------------------

# what is differentiated by x -> its derivative
UNTAKEN = {
    sm.Mod(x, y): 1,
    sm.Mod(y, x): -sm.floor(y / x),
    sm.Mod(x + 1, 2 * y) ** 2: 2 * sm.Mod(x + 1, 2 * y),
    sm.Mod(x**2, sm.Mod(3 * x, y)): 2 * x - 3 * sm.floor(x**2 / sm.Mod(3 * x, y)),
    x * sm.floor(x * y): sm.floor(x * y),
    sm.ceiling(x) * x: sm.ceiling(x),
    sm.sin(sm.frac(x)): sm.cos(sm.frac(x)),
    sm.sign(x) * x: sm.sign(x),
    sm.re(x) * sm.conjugate(x) + sm.im(x): 2 * x,
}


@pytest.mark.parametrize("function", UNTAKEN, ids=str)
def test_a_derivative_that_sympy_leaves_unevaluated_is_taken(function):
    derivative = function.diff(x)
    assert derivative.has(sm.Derivative)
    for point in [(0.7, 1.1), (2.3, 0.4), (-1.6, 0.9)]:
        close(evaluate(derivative, *point), evaluate(sm.sympify(UNTAKEN[function]), *point))


@pytest.mark.parametrize("function", [sm.Mod(f(T), 2), sm.frac(f(T)), f(T) * sm.sign(f(T))])
def test_derivatives_by_time_go_through_functions_of_time(function):
    q = f(T)
    inputs = dict(zip([q, q.diff(T), q.diff(T, 2)], X, strict=False))
    slope = {sm.Mod(q, 2): 1, sm.frac(q): 1, q * sm.sign(q): sm.sign(x)}[function]
    first, second = (sm.Derivative(function, (T, n), evaluate=False) for n in (1, 2))
    for derivative, expected in ((first, slope * y), (second, slope * z)):
        graph, found = nodes_of([expected])
        read = SymPyReader(graph, {s: graph.input("x", X.index(v)) for s, v in inputs.items()})
        for point in ([2.7, 0.3, -0.8, 0.0], [-0.4, 1.7, 2.2, 0.0]):
            got, due = values(on_tape(graph, [read(derivative), *found]), point)
            assert got == pytest.approx(due, rel=1e-14)


def test_what_was_read_can_be_differentiated_by_sympy():
    graph = Graph()
    node = SymPyReader(graph, {x: graph.input("x", 0), y: graph.input("x", 1)})(sm.sin(x) * y)
    whole = NodeExpression.of(graph, node, {graph.input("x", 0): x, graph.input("x", 1): x**2})
    expected = 2 * 0.7 * math.sin(0.7) + 0.7**2 * math.cos(0.7)
    assert evaluate((3 * whole).diff(x), 0.7) == pytest.approx(3 * expected, rel=1e-14)


@pytest.mark.parametrize(
    "expression",
    [
        sm.Derivative(x * f(2 * x), x, evaluate=False),
        sm.Derivative(sm.sin(x), (x, sm.Symbol("n", integer=True)), evaluate=False),
        sm.Derivative(sm.floor(f(T, x)), T, evaluate=False),
    ],
    ids=str,
)
def test_a_derivative_that_cannot_be_taken_is_named(expression):
    with pytest.raises(UnsupportedFunctionError, match=r"function `Derivative` occurs in .*, in `"):
        nodes_of([expression])


# -- what cannot be read --------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("expression", "real"),
    [
        (sm.exp(sm.I * x) + sm.exp(-sm.I * x), lambda x, y: 2.0 * np.cos(x)),
        ((sm.exp(sm.I * x) - sm.exp(-sm.I * x)) / (2 * sm.I), lambda x, y: np.sin(x)),
        ((x + sm.I * y) * (x - sm.I * y), lambda x, y: x**2 + y**2),
        (sm.Abs(x + sm.I * y), np.hypot),
    ],
)
def test_a_real_expression_may_be_written_with_the_imaginary_unit(expression, real):
    points = np.random.default_rng(0).uniform(-2.0, 2.0, (5, 2))
    found = [evaluate(expression, a, b) for a, b in points]
    np.testing.assert_allclose(found, real(*points.T), rtol=1e-14)


@pytest.mark.parametrize("number", [sm.I, sm.I * x + 1, sm.sqrt(-2), sm.log(-1) * x])
def test_what_may_not_be_real_is_refused_with_the_remedy(number):
    with pytest.raises(ValueError, match=r"imaginary unit occurs in .* Give its real part"):
        nodes_of([number])


@pytest.mark.parametrize("number", [sm.zoo, sm.nan], ids=str)
def test_a_number_that_is_not_real_is_refused(number):
    with pytest.raises(ValueError, match=r"^`(zoo|nan)` occurs in .* not a real number.* `oo`"):
        nodes_of([sm.sympify(number)])


def test_a_symbol_that_nothing_provides_is_named():
    with pytest.raises(
        ValueError, match=r"`stray` occurs in the expressions, .*`constants_symbols`"
    ):
        nodes_of([sm.sin(sm.Symbol("stray")) + x])


def test_an_unknown_function_of_time_is_named():
    with pytest.raises(ValueError, match=r"`f\(t\)` occurs in the expressions"):
        nodes_of([x * f(T)])


def test_a_derivative_of_an_undefined_function_is_named():
    with pytest.raises(ValueError, match=r"`Derivative\(.*, x0\)` occurs in"):
        nodes_of([sm.Derivative(f(x), x)])


@pytest.mark.parametrize(
    ("expression", "name"),
    [
        (sm.stieltjes(x), "stieltjes"),
        (sm.jn(1, x), "jn"),
        (sm.DiracDelta(x), "DiracDelta"),
        (sm.Integral(sm.sin(x) / x, x), "Integral"),
        (sm.Product(1 + sm.sin(x) / y**3, (y, 1, sm.oo)), "Product"),
        (sm.Integral(x * y, (x, 0, y), (y, 0, 1)), "Integral"),
        (sm.Subs(sm.Derivative(f(y), y), y, x), "Subs"),
    ],
    ids=lambda v: v if isinstance(v, str) else "",
)
def test_an_unsupported_function_is_named(expression, name):
    with pytest.raises(UnsupportedFunctionError, match=rf"The function `{name}` occurs in .*`"):
        nodes_of([1 + expression])


def test_a_function_that_stands_for_an_expression_is_read_as_that():
    curve = TendonForceLengthDeGroote2016.with_defaults(sm.sin(x) + 1)
    expected = float(curve.doit().subs(x, sm.Rational(3, 10)).evalf(30))
    assert evaluate(curve + curve**2, 0.3) == pytest.approx(expected + expected**2, rel=1e-13)


def test_what_was_being_read_is_named():
    graph = Graph()
    message = r"^The function `stieltjes` occurs in the outputs, in `"
    with pytest.raises(UnsupportedFunctionError, match=message):
        SymPyReader(graph, {x: graph.input("x", 0)}, "the outputs")(sm.stieltjes(x))


def test_a_long_expression_is_shortened_in_the_message():
    with pytest.raises(UnsupportedFunctionError) as caught:
        nodes_of([sm.stieltjes(sum(sm.sin(k * x) for k in range(100)))])
    assert "..." in str(caught.value)
    assert len(str(caught.value)) < 500


def test_a_truth_value_as_an_output_is_one_or_zero_or_is_refused_when_it_is_read():
    try:
        program = program_of([x > y])
    except (TypeError, ValueError, UnsupportedFunctionError):
        return
    kernel = LLVMBackend().compile(program)
    assert values(program, [2.0, 1.0, 0.0, 0.0], kernel=kernel)[0] == 1.0


# -- depth and size -------------------------------------------------------------------------------

DEPTH = 20_000


def test_twenty_thousand_nested_functions_are_no_obstacle():
    expression, expected = x, 0.3
    for _ in range(DEPTH):
        expression = sm.sin(expression, evaluate=False)
        expected = math.sin(expected)
    assert evaluate(expression, 0.3) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("function", [sm.Add, sm.Mul])
def test_twenty_thousand_nested_sums_or_products_are_no_obstacle(function):
    expression, expected = x, 0.5
    step = y if function is sm.Add else 1 + y / 1000
    for _ in range(DEPTH):
        expression = function(expression, step, evaluate=False)
        expected = expected + 1e-3 if function is sm.Add else expected * (1 + 1e-6)
    assert evaluate(expression, 0.5, 1e-3) == pytest.approx(expected, rel=1e-10)


def test_a_tree_of_two_to_the_sixty_leaves_is_a_graph_of_sixty_levels():
    levels = 60
    expression = x
    for _ in range(levels):
        # Unevaluated: SymPy's own x · x would walk the tree to compare.
        product = sm.Mul(expression, expression, evaluate=False)
        expression = sm.Add(product, expression, evaluate=False)
    program = program_of([expression])
    expected = 1e-3
    for _ in range(levels):
        expected = expected * expected + expected
    assert values(program, [1e-3, 0.0, 0.0, 0.0])[0] == pytest.approx(expected, rel=1e-13)
    assert program.operation_count["run"].total() <= 2 * levels
