"""Random expressions: back ends, rewriting and order against 50-digit arithmetic."""

from itertools import islice

import mpmath as mp
import numpy as np
import pytest
import sympy as sm
from hypothesis import HealthCheck, Phase, assume, given, seed, settings, strategies as st
from sympy.core.cache import clear_cache

import zoo
from graphs import P, X, program_of
from oracles.rounding import SAFETY, OutsideError, UnclearError, bounded
from parts import PART, WHOLE
from pydy._backends.llvm.native import LLVMBackend
from pydy._backends.numpy_ import NumPyBackend
from pydy._graph.passes import rewriting
from pydy.system import System

NAMES = [*X, *P]
PARTS = 8


def quiet(max_examples):
    """Settings of a test that tries so many examples, of which this run's part is drawn."""
    own = settings(
        derandomize=True,
        database=None,
        deadline=None,
        phases=[Phase.generate, Phase.shrink],
        suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
        max_examples=max_examples * (PARTS if WHOLE else 1),
    )
    return lambda test: own(seed(PART % PARTS)(test))


# -- expressions from recipes ---------------------------------------------------------------------

NUMBERS = [
    *map(sm.Integer, (1, 2, -3)),
    *(sm.Rational(*q) for q in ((1, 3), (-5, 2), (7, 10))),
    sm.Float(0.1),
    sm.pi,
]


def _when(relation):
    return lambda a, b, c: sm.Piecewise((a, relation(b, c)), (c, True))


def _between(a, b, c):
    return sm.Piecewise((a * b, sm.And(a > -1, b < c)), (a - b, sm.Or(a > 2, c > 1)), (c, True))


# Operation -> (number of operands, function); the frequent ones stand more than once.
OPERATIONS = [
    *[(2, lambda a, b: a + b), (2, lambda a, b: a * b)] * 4,
    *[(2, lambda a, b: a - b), (2, lambda a, b: a / b), (3, lambda a, b, c: a * b + c)] * 2,
    (3, lambda a, b, c: a * b + a * c),
    (3, lambda a, b, c: a * b - 3 * b * c + a * c),
    *((1, lambda a, n=n: a**n) for n in (2, 3, -1, -2, 5)),
    *((1, lambda a, n=n: a ** sm.Rational(n, 2)) for n in (1, 3, -1, -3)),
    (2, lambda a, b: sm.sqrt(a**2 + b**2)),
    *((1, f) for f in (sm.exp, sm.log, sm.asin, sm.atan, sm.sinh, sm.tanh, sm.tan)),
    *[(1, sm.sin), (1, sm.cos)] * 2,
    (2, sm.atan2),
    *((1, f) for f in (sm.Abs, sm.sign, sm.floor)),
    (2, sm.Min),
    (2, sm.Max),
    *((3, _when(r)) for r in (sm.Lt, sm.Le, sm.Gt, sm.Ge, sm.Ne)),
    (3, _between),
]
SHOWN = 6
LARGEST = 120  # nodes of a tree; SymPy's own rules for nested choices take long beyond
STEEPEST = 12  # powers of powers: SymPy may multiply them out to tell whether a tanh is real

recipes = st.lists(
    st.tuples(
        st.integers(0, len(OPERATIONS) - 1), st.tuples(*[st.integers(0, 2**16) for _ in range(3)])
    ),
    min_size=2 * SHOWN,
    max_size=4 * SHOWN,
)
"""What to do with which earlier results; those are shared, so that expressions are graphs."""


def expressions_of(recipe):
    """The last few expressions that a recipe makes."""
    pool = [*NAMES, *NUMBERS]
    leaves = len(pool)
    for operation, places in recipe:
        count, function = OPERATIONS[operation]
        # Half of the operands come from what was made last, so that depth grows.
        recent = pool[leaves:][-5:] or pool
        sources = [recent if k % 2 else pool for k in places[:count]]
        operands = [s[(k // 2) % len(s)] for k, s in zip(places, sources, strict=False)]
        try:
            expression = function(*operands)
        # SymPy compares nothing that it knows is not real; its sets of solutions fail otherwise.
        except (TypeError, ValueError, KeyError, NotImplementedError):
            continue
        if expression.is_Boolean or expression.has(sm.I, sm.zoo, sm.nan, sm.oo, sm.arg, sm.im):
            continue
        small = next(islice(sm.preorder_traversal(expression), LARGEST, None), None) is None
        if small and steepness(expression) <= STEEPEST:
            pool.append(expression)
    return [e for e in pool[leaves:][-SHOWN:] if e.free_symbols]


def steepness(expression):
    """The highest power of sums within an expression, were it multiplied out."""
    inner = [steepness(a) for a in expression.args]
    if expression.is_Pow and expression.exp.is_Rational:
        return abs(expression.exp) * inner[0]
    return sum(inner) if expression.is_Mul else max(inner, default=1)


def points_of(seed, count=8):
    """States and constants: generic numbers, and now and then one where something switches."""
    rng = np.random.default_rng(seed)
    values = rng.uniform(-2.5, 2.5, (count, len(NAMES)))
    special = rng.choice([0.0, 1.0, -1.0, 0.5, 2.0], values.shape)
    values = np.where(rng.random(values.shape) < 0.1, special, values)
    values[:, len(X) :] = values[0, len(X) :]  # the constants are the same for all states
    return values


def sweep(backend, program, points):
    m = len(points)
    x = np.ascontiguousarray(points[:, : len(X)])
    p = np.ascontiguousarray(points[0, len(X) :])
    return backend.compile(program).evaluate(np.zeros(m), x, np.empty((1, 0)), p)[0]


def expected(expressions, points):
    """For each clear point and expression its place, value and bound; NaN outside a domain."""
    table = []
    for i, point in enumerate(points):
        numbers = dict(zip(NAMES, point, strict=True))
        for j, expression in enumerate(expressions):
            try:
                table.append(((i, j), *bounded(expression, numbers)))
            except OutsideError:
                table.append(((i, j), mp.nan, mp.mpf(0)))
            except UnclearError:
                continue
    return table


def real_after_all(expression, numbers, actual):
    """Whether square roots of negative numbers met and made a real number, as √x · √x = x does."""
    value = complex(expression.evalf(20, subs=numbers))
    return abs(value - actual) <= 1e-9 * (1 + abs(value))


def check(found, table, expressions, points, who):
    for (i, j), value, bound in table:
        actual = float(found[i, j])
        told = f"{who}: {expressions[j]} at {dict(zip(NAMES, points[i].tolist(), strict=True))}"
        if mp.isnan(value):
            numbers = dict(zip(NAMES, points[i], strict=True))
            assert np.isnan(actual) or real_after_all(expressions[j], numbers, actual), (
                f"{actual}, outside the domain: {told}"
            )
        else:
            error = abs(mp.mpf(actual) - value)
            assert error <= SAFETY * bound, (
                f"{actual!r} is off by {mp.nstr(error, 3)}, more than {mp.nstr(bound, 3)}: {told}"
            )


# -- the bound itself -----------------------------------------------------------------------------


def test_the_bound_of_a_well_conditioned_expression_is_a_few_roundings():
    x, y, z, _ = X
    expression = sm.sqrt(x**2 + y**2) * sm.exp(z) + sm.sin(x) / y
    value, bound = bounded(expression, {x: 0.7, y: 1.3, z: -0.4})
    assert 1 <= bound / (value * 2.0**-53) < 10


def test_the_bound_grows_with_cancellation():
    x, y = X[:2]
    _, bound = bounded(sm.sin(x) - sm.sin(y), {x: 0.7, y: 0.7 + 1e-9})
    assert 2.0**-53 < bound < 8 * 2.0**-53


@pytest.mark.parametrize("function", [sm.sqrt, sm.log, sm.asin])
def test_the_bound_knows_where_a_function_is_not_real(function):
    with pytest.raises(OutsideError):
        bounded(function(X[0]), {X[0]: -1.5})


def test_the_bound_sees_a_switch_within_rounding():
    x = X[0]
    expression = sm.Piecewise((1, sm.sin(x) ** 2 + sm.cos(x) ** 2 > 1), (2, True))
    with pytest.raises(UnclearError):
        bounded(expression, {x: 0.7})


# -- random expressions ---------------------------------------------------------------------------

BACKENDS = {"lambdify": NumPyBackend(), "llvm": LLVMBackend()}


@quiet(10)
@given(recipe=recipes, numbers=st.integers(0, 2**32 - 1))
def test_a_random_expression_and_its_rewriting_stay_within_eight_times_its_rounding_bound(
    recipe, numbers
):
    expressions, points = expressions_of(recipe), points_of(numbers)
    table = expected(expressions, points)
    assume(table)
    plain = sweep(BACKENDS["lambdify"], program_of(expressions, rewriting()), points)
    check(plain, table, expressions, points, "as read")
    program = program_of(expressions)
    for name, backend in BACKENDS.items():
        found = sweep(backend, program, points)
        check(found, table, expressions, points, name)
        for (i, j), _, bound in table:
            moved = abs(found[i, j] - plain[i, j])
            assert moved <= SAFETY * bound or np.isnan([found[i, j], plain[i, j]]).all(), (
                f"{plain[i, j]!r} became {found[i, j]!r}: {expressions[j]} at {points[i].tolist()}"
            )


@quiet(4)
@given(recipe=recipes)
def test_building_a_random_expression_twice_gives_the_same_digest(recipe):
    digests = []
    for _ in range(2):
        clear_cache()  # every SymPy object is made anew
        digests.append(program_of(expressions_of(recipe)).digest)
    assert digests[0] == digests[1]


@quiet(4)
@given(recipe=recipes, data=st.data())
def test_the_order_in_which_expressions_are_read_moves_them_by_rounding_only(recipe, data):
    expressions, points = expressions_of(recipe), points_of(0)
    order = data.draw(st.permutations(range(len(expressions))))
    table = expected(expressions, points)
    assume(table)
    out = sweep(BACKENDS["lambdify"], program_of([expressions[k] for k in order]), points)
    found = np.empty_like(out)
    found[:, order] = out
    check(found, table, expressions, points, f"in the order {order}")


# -- systems --------------------------------------------------------------------------------------


def shuffled(mapping):
    return st.permutations(list(mapping.items())).map(dict)


@quiet(2)
@given(data=st.data())
def test_the_order_of_dict_entries_changes_no_bit_of_a_system(data):
    model = zoo.pendulum()
    x, t = model.sample(3)
    q, u = model.kane.q, model.kane.u
    outputs = {sm.Symbol("a"): u[0] ** 2, sm.Symbol("b"): sm.sin(q[1]), sm.Symbol("c"): q[0] - u[1]}

    def results(order):
        system = System(
            model.kane,
            constants=order(model.constants),
            specifieds=order(model.specifieds),
            initial_conditions=order(dict(zip(model.states, x.tolist(), strict=True))),
            outputs=order(outputs),
            times=[t, t + 0.1],
        )
        trajectory = system.integrate()
        columns = system.evaluate_outputs(trajectory)
        named = {str(s): columns[..., k] for k, s in enumerate(system.outputs)}
        return trajectory, [named[n] for n in "abc"]

    expected_x, expected_y = results(dict)
    found_x, found_y = results(lambda mapping: data.draw(shuffled(mapping)))
    np.testing.assert_array_equal(found_x, expected_x)
    np.testing.assert_array_equal(found_y, expected_y)
