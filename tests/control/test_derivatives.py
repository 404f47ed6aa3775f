"""Rows, Jacobian and Hessian of a transcription against mpmath at 40 digits.

The reference evaluates the equations as SymPy writes them, at the points that `Points` tables
describe; derivatives are central differences, whose error is below 1e-18.
"""

import mpmath as mp
import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from oracles import optima
from oracles.optima import TF, T
from pydy import System
from pydy.control import OptimalControl
from pydy.control.identification import Experiment, Identification, _CombinedExperiments
from pydy.control.transcription import Transcription
from pydy.inputs import SampledInput

STEP = mp.mpf(10) ** -10


def nlp_of(problem, seed, unit=True):
    """Return the program, unknowns at random and the transcription."""
    transcription = Transcription(problem._problem, problem._scheme, problem._mesh)
    size = sum(transcription.sizes)
    rng = np.random.default_rng(seed)
    z = rng.uniform(0.2, 1.2, size)
    sizes = np.ones(size) if unit else rng.uniform(0.1, 9.0, size)
    everywhere = np.full(size, np.inf)
    nlp = transcription.nlp(-everywhere, everywhere, sizes)
    return (nlp if unit else nlp.scaled_at(z)), z, transcription


class Reference:
    """The same rows and objective, in mpmath."""

    def __init__(self, problem, made, residuals, path, running, ends, cost, symbols):
        self.problem, self.made, self.ends, self.cost = problem, made, ends, cost
        arguments = [symbols[k] for k in ("x", "d", "u", "s", "c")]
        arguments = [[sm.Dummy() for _ in part] for part in arguments]
        order = [s for k in ("d", "x", "u", "s", "c") for s in symbols[k]]
        new = dict(zip(order, [a for k in (1, 0, 2, 3, 4) for a in arguments[k]], strict=True))
        t, tf = sm.Dummy(), sm.Dummy()

        def ready(expression):
            for old, dummy in new.items():  # derivatives before what they are derivatives of
                expression = expression.subs(old, dummy)
            return expression.subs({T: t, TF: tf})

        rows = [ready(e) for e in (*residuals, *path)]
        self.rows = sm.lambdify([*arguments, t, tf], rows, "mpmath")
        self.running = sm.lambdify([*arguments, t, tf], ready(running), "mpmath")

    def __call__(self, z):
        """Return the objective and the rows in the order of the program."""
        made, p = self.made, self.made.problem
        slots, own, n = len(made.state_slots[0]), len(made.control_times), p.states
        x = [z[k * slots : (k + 1) * slots] for k in range(n)]
        first = n * slots
        u = [z[first + k * own : first + (k + 1) * own] for k in range(len(p.controls))]
        rest = z[first + len(u) * own :]
        c, duration = rest[: len(p.free)], rest[-1] if p.duration is None else mp.mpf(p.duration)
        cost, found = mp.mpf(0), []
        for points in made.scheme.points(made.mesh):
            table = []
            for j in range(len(points.fractions)):
                h, data = duration * mp.mpf(points.lengths[j]), iter(points.coefficients[:, j])
                sides = []
                for terms in (points.state, points.rate):
                    known = [(y, next(data) if a is None else a, e) for y, a, e in terms]
                    sides.append(
                        [
                            sum(mp.mpf(a) * x[k][points.slots[y, j]] * h**e for y, a, e in known)
                            for k in range(n)
                        ]
                    )
                time = mp.mpf(p.begin) + duration * mp.mpf(points.fractions[j])
                signals = [value for _, s in p.signals for value in signal(s, time)]
                controls = [row[points.controls[j]] for row in u]
                at = (*sides, controls, signals, c, time, duration)
                table.append(self.rows(*at))
                cost += duration * mp.mpf(points.weights[j]) * self.running(*at)
            found += [row[i] for i in range(len(table[0])) for row in table]

        def value(kind, index, fraction):
            places, weights, h = made.located(kind, fraction)
            values = (x if kind == "state" else u)[index]
            powers = (
                made.scheme.states.basis(np.zeros(1))[1] if kind == "state" else [0] * len(places)
            )
            return sum(
                values[s] * mp.mpf(w) * (duration * mp.mpf(h)) ** int(e)
                for s, w, e in zip(places, weights, powers, strict=True)
            )

        found += self.ends(value, duration, c)
        return cost + self.cost(value, duration, c), found


def signal(samples, time):
    """Return the values of a SampledInput at a time."""
    k = int(np.searchsorted(samples.breaks, float(time), "right")) - 1
    s = time - mp.mpf(samples.breaks[k])
    return [mp.polyval([mp.mpf(a) for a in cubic], s) for cubic in samples.coefficients[k].T]


def slopes(function, z):
    """Return central differences of a vector function, as columns."""
    columns = []
    for k in range(len(z)):
        sides = []
        for sign in (1, -1):
            moved = list(z)
            moved[k] += sign * STEP
            sides.append(function(moved))
        columns.append([(a - b) / (2 * STEP) for a, b in zip(*sides, strict=True)])
    return np.array(columns, dtype=object).T


def dense(shape, at, values):
    """Return a matrix of triplets."""
    matrix = np.zeros(shape)
    np.add.at(matrix, at, values)
    return matrix


def compare(nlp, z, reference):
    with mp.workdps(40):
        exact = [mp.mpf(v) for v in z]
        cost, rows = reference(exact)
        J = slopes(lambda y: reference(y)[1], exact)
        g = slopes(lambda y: [reference(y)[0]], exact)[0]
        multipliers = np.random.default_rng(9).normal(size=nlp.rows)
        weights = [mp.mpf(m) for m in multipliers]

        def lagrangian(w):
            cost, rows = reference(w)
            return [mp.mpf(0.7) * cost + sum(a * b for a, b in zip(weights, rows, strict=True))]

        # The Hessian along two directions, which meet every entry.
        directions = np.random.default_rng(8).normal(size=(2, len(z)))

        def gradient_along(direction):
            sides = []
            for sign in (1, -1):
                moved = [a + sign * STEP * mp.mpf(d) for a, d in zip(exact, direction, strict=True)]
                sides.append(slopes(lagrangian, moved)[0])
            return [(a - b) / (2 * STEP) for a, b in zip(*sides, strict=True)]

        H = [gradient_along(direction) for direction in directions]
        J, g, H = (np.array(a, dtype=float) for a in (J, g, H))
        cost, rows = float(cost), np.array(rows, dtype=float)
    assert nlp.native("cost", z)[0][0] == pytest.approx(cost, rel=1e-13)
    own, fine = nlp.native("rows", z)
    assert fine
    np.testing.assert_allclose(own, rows, rtol=1e-12, atol=1e-12)
    own, fine = nlp.native("gradient", z)
    assert fine
    np.testing.assert_allclose(own, g, rtol=1e-11, atol=1e-12)
    own, fine = nlp.native("jacobian", z)
    assert fine
    np.testing.assert_allclose(dense(J.shape, nlp.jacobian_at, own), J, rtol=1e-11, atol=1e-11)
    own, fine = nlp.native("hessian", z, 0.7, multipliers)
    assert fine
    lower = dense((nlp.size, nlp.size), nlp.hessian_at, own)
    assert (nlp.hessian_at[0] >= nlp.hessian_at[1]).all()
    both = lower + np.tril(lower, -1).T
    np.testing.assert_allclose(directions @ both, H, rtol=1e-10, atol=1e-10)


METHODS = [("radau", 2), ("hermite-simpson", 1), ("midpoint", 1)]


@pytest.mark.parametrize(("method", "order"), METHODS)
def test_a_pendulum_on_a_cart_with_everything_free(method, order):
    system, (q1, q2, u1, u2, F) = optima.cart_pole()
    _m1, m2, l, _g = sm.symbols("m1 m2 l g")
    integrand = F**2 * sm.cos(q2) + T * u2**2
    problem = OptimalControl(
        system,
        TF * l * sm.Integral(integrand, T) + q1.subs(T, TF) ** 2 * TF,
        TF,
        boundary=[
            sm.Eq(u1.subs(T, TF), u1.subs(T, 0) * q2.subs(T, TF / 3)),
            F.subs(T, TF / 2) * q1.subs(T, TF / 2) <= l,
        ],
        path=[u1 * F + sm.sin(q2) * T <= m2 * 3],
        free=[l, m2],
        bounds={TF: (0.1, 3.0)},
        mesh=[0.0, 0.3, 1.0],
        method=method,
        order=order,
    )
    nlp, z, made = nlp_of(problem, 3)
    s, c = sm.sin(q2), sm.cos(q2)
    residuals = [
        q1.diff() - u1,
        q2.diff() - u2,
        (1 + m2) * u1.diff() + m2 * l * c * u2.diff() - m2 * l * s * u2**2 - F,
        m2 * l * c * u1.diff() + m2 * l**2 * u2.diff() + m2 * 9.81 * l * s,
    ]
    symbols = {
        "x": [q1, q2, u1, u2],
        "d": [s.diff() for s in (q1, q2, u1, u2)],
        "u": [F],
        "s": [],
        "c": [l, m2],
    }
    third = sm.Rational(1, 3)

    def ends(value, tf, c):
        first = value("state", 2, 1.0) - value("state", 2, 0.0) * value("state", 1, float(third))
        second = value("control", 0, 0.5) * value("state", 0, 0.5) - c[0]
        return [first, second]

    reference = Reference(
        problem,
        made,
        residuals,
        [u1 * F + sm.sin(q2) * T - m2 * 3],
        TF * l * integrand,
        ends,
        lambda value, tf, c: value("state", 0, 1.0) ** 2 * tf,
        symbols,
    )
    assert problem._free == (l, m2)
    compare(nlp, z, reference)


def test_a_known_signal_time_and_a_fixed_duration():
    x, v, F, wind, push = me.dynamicsymbols("x v F wind push")
    k = sm.Symbol("k")
    system = optima.first_order([x], v, F * v - k * x**3 + wind * x + push * v, 2, None, {k: 3.0})
    samples = SampledInput([0.0, 1.0, 2.0], [1.0, 3.0, 2.0])
    system.specifieds = {wind: samples, push: sm.sin(3 * T) * x}
    integrand = sm.exp(F) * wind + v.diff() ** 2
    problem = OptimalControl(system, sm.Integral(integrand, T), 1.7, mesh=3, order=2)
    assert problem._controls == (F,)
    nlp, z, made = nlp_of(problem, 4)
    force = F * v - 3 * x**3 + wind * x + sm.sin(3 * T) * x * v
    symbols = {"x": [x, v], "d": [x.diff(), v.diff()], "u": [F], "s": [wind], "c": []}
    reference = Reference(
        problem, made, [x.diff() - v, 2 * v.diff() - force], [], integrand,
        lambda value, tf, c: [], lambda value, tf, c: mp.mpf(0), symbols,
    )  # fmt: skip
    compare(nlp, z, reference)


@pytest.mark.parametrize(("method", "order"), METHODS)
def test_known_signals_at_times_that_move_with_the_duration(method, order):
    x, v, F, wind, gust, push = me.dynamicsymbols("x v F wind gust push")
    system = optima.first_order([x], v, F * v + wind * x + gust * sm.sin(v) + push * wind, 2)
    times = np.array([0.0, 0.31, 0.47, 0.8, 1.6])
    values = np.random.default_rng(6).normal(size=(5, 2))
    system.specifieds = {
        (gust, wind): SampledInput(times, values, "pchip"),
        push: SampledInput([-0.1, 0.5, 1.3], [1.0, 3.0, -2.0]),
    }
    integrand = sm.exp(F) * wind + push**2
    problem = OptimalControl(
        system,
        sm.Integral(integrand, T),
        TF,
        path=[F * gust <= T],
        bounds={TF: (0.1, 1.3)},
        mesh=[0.0, 0.3, 1.0],
        method=method,
        order=order,
    )
    nlp, z, made = nlp_of(problem, 4)
    force = F * v + wind * x + gust * sm.sin(v) + push * wind
    names = {"gust": gust, "wind": wind, "push": push}
    order = [names[str(problem._snapshot.plan.symbols[k].func)] for c, _ in made.problem.signals
             for k in c]  # fmt: skip
    symbols = {"x": [x, v], "d": [x.diff(), v.diff()], "u": [F], "s": order, "c": []}
    reference = Reference(
        problem, made, [x.diff() - v, 2 * v.diff() - force], [F * gust - T], integrand,
        lambda value, tf, c: [], lambda value, tf, c: mp.mpf(0), symbols,
    )  # fmt: skip
    for duration in (z[-1], 0.62, 1.29):
        z[-1] = duration
        compare(nlp, z, reference)
    np.testing.assert_array_equal(
        nlp.native("rows", z)[0],
        np.concatenate([p.evaluate("rows", z).ravel() for p in nlp.groups]),
    )


@pytest.mark.parametrize("seed", range(2))
def test_random_equations(seed):
    rng = np.random.default_rng(seed)
    a, b, v, u = me.dynamicsymbols("a b v u")

    def random_expression(symbols):
        functions = [sm.sin, sm.exp, sm.tanh, lambda e: sm.sqrt(1 + e**2), lambda e: e**3]
        terms = []
        for _ in range(3):
            one, two = rng.choice(len(symbols), 2)
            f = functions[rng.integers(len(functions))]
            terms.append(sm.Integer(rng.integers(1, 5)) * symbols[one] * f(symbols[two] / 2))
        return sm.Add(*terms)

    rates = [random_expression([a, b, v, u]) for _ in range(2)]
    force = random_expression([a, b, v, u])
    mass = 2 + sm.sin(a)
    inertia = mass * v.diff() + sm.cos(a) * a.diff() * v  # of a particle whose mass changes
    system = optima.first_order([a, b], v, force, mass, [a.diff() - rates[0], b.diff() - rates[1]])
    integrand = random_expression([a, b, v, u])
    problem = OptimalControl(
        system, sm.Integral(integrand, T), TF, bounds={TF: (0.1, 2.0)}, mesh=2, order=2
    )
    nlp, z, made = nlp_of(problem, seed)
    residuals = [
        a.diff() - rates[0],
        b.diff() - rates[1],
        inertia.subs(a.diff(), rates[0]) - force,
    ]
    symbols = {"x": [a, b, v], "d": [s.diff() for s in (a, b, v)], "u": [u], "s": [], "c": []}
    reference = Reference(
        problem, made, residuals, [], integrand,
        lambda value, tf, c: [], lambda value, tf, c: mp.mpf(0), symbols,
    )  # fmt: skip
    compare(nlp, z, reference)


def test_units_divide_functions_and_derivatives():
    system, (_q1, _q2, _u1, _u2, F) = optima.cart_pole()
    problem = OptimalControl(system, sm.Integral(F**2, T), 2.0, mesh=3)
    plain, z, _ = nlp_of(problem, 1)
    scaled, _, _ = nlp_of(problem, 1, unit=False)
    y = z / scaled.sizes
    values = [plain.native("rows", z)[0], scaled.native("rows", y)[0]]
    np.testing.assert_allclose(values[1] * scaled.row_sizes, values[0], atol=1e-12)
    J = scaled.native("jacobian", y)[0]
    largest = np.zeros(plain.rows)
    np.maximum.at(largest, plain.jacobian_at[0], np.abs(J))
    assert largest.max() <= 1.0 + 1e-12
    costs = [nlp.native("cost", at)[0][0] for nlp, at in ((scaled, y), (plain, z))]
    assert costs[0] * scaled.cost_size == pytest.approx(costs[1])


def test_evaluation_is_the_same_for_few_and_for_many_points():
    system, (x, v, F) = optima.double_integrator()
    assert isinstance(system, System)
    for mesh in (1, 2, 7, 8, 9, 31):
        problem = OptimalControl(system, sm.Integral(F**2 + x * v, T), 1.0, mesh=mesh, order=2)
        nlp, z, made = nlp_of(problem, 5)
        own = nlp.native("rows", z)[0]
        states, controls, _, _ = made.split(z)
        (points,) = made.scheme.points(made.mesh)
        rates = np.einsum("cp,ncp->np", points.coefficients, states[:, points.slots])
        rates /= points.lengths
        at = states[:, points.slots[0]]
        expected = [rates[0] - at[1], rates[1] - controls[0, points.controls]]
        np.testing.assert_allclose(own, np.ravel(expected), atol=1e-11)


def test_derivatives_of_two_disturbed_experiments():
    x, v, F, wind = me.dynamicsymbols("x v F wind")
    k = sm.Symbol("k")
    system = optima.first_order([x], v, F * v - k * x**3 + wind * x + sm.sin(T) * v, 2)
    system.outputs = {"power": F * v + k * x}
    outputs = system.outputs_symbols
    assert isinstance(system, System)
    experiments = []
    rng = np.random.default_rng(2)
    for begin, force in ((0.0, 0.5), (0.7, -0.3)):
        system.specifieds = {wind: force, F: SampledInput([0.0, 1.0, 3.0], [1.0, 3.0, 2.0])}
        times = begin + np.array([0.0, 0.31, 0.8, 1.1])
        values, weights = rng.normal(size=(4, 2)), rng.uniform(1.0, 3.0, size=(4, 2))
        weights[2, 0] = 0.0
        experiments.append(
            Experiment(
                system._now(), begin, times, (outputs[0], x), values, weights, (1,), (),
                np.ones((2, 2)), times[[0, -1]],
            )
        )  # fmt: skip
    definition = experiments[0].snapshot.definition
    open_ = np.full(5, np.inf)
    shared = [
        ("specifieds", wind),
        ("constants", definition.constants[0]),
        ("states", definition.states[0]),
    ]
    fit = Identification(experiments, shared, {F: 0.4}, (-open_, open_), [(0, 0.2, 0.5)])
    fit.scheme = type(fit.scheme)("radau", 2)
    joined = _CombinedExperiments(fit, [np.array([0.0, 0.4, 1.0])] * 2)
    slope = np.array([0.0, 0.3, 0.0, 0.0, -0.2])
    nlp, _, _ = joined.program(np.ones(5), [None, None], slope)
    ones = np.ones(joined.size)
    nlp = type(nlp)(nlp.groups, -np.inf * ones, np.inf * ones, ones)
    assert fit.problems[0]._compiled is fit.problems[1]._compiled
    force = F * v - k * x**3 + wind * x + sm.sin(T) * v
    disturbance = me.dynamicsymbols("disturbance")
    references = []
    for made in joined.transcriptions:
        symbols = {
            "x": [x, v], "d": [x.diff(), v.diff()], "u": [disturbance], "s": [F], "c": [wind, k],
        }  # fmt: skip
        rows = [x.diff() - v, 2 * v.diff() - force]
        rows = [row.subs(F, F + disturbance) for row in rows]
        references.append(
            Reference(
                fit, made, rows, [], disturbance**2 / 2 / sm.Float(0.4) ** 2,
                lambda value, tf, c: [], lambda value, tf, c: mp.mpf(0), symbols,
            )
        )  # fmt: skip

    def reference(z):
        cost, rows = mp.mpf(0), []
        for e, made, own, one in zip(
            experiments, joined.transcriptions, joined.positions, references, strict=True
        ):
            local = [z[k] for k in own]
            more, found = one(local)
            cost, rows = cost + more, rows + found
            duration = made.problem.duration
            slots, width = len(made.state_slots[0]), len(made.control_times)
            c = local[-2:]
            for j, time in enumerate(e.times):
                state = {}
                for kind, index in (("state", 0), ("state", 1), ("control", 0)):
                    places, weights, _ = made.located(kind, (time - e.begin) / duration)
                    first = index * slots if kind == "state" else 2 * slots + index * width
                    parts = zip(places, weights, strict=True)
                    state[kind, index] = sum(local[first + p] * mp.mpf(w) for p, w in parts)
                signal = mp.mpf(float(e.snapshot.inputs.sampled[0][1].rows(np.array([time]))[0, 0]))
                total = signal + state["control", 0]
                model = [total * state["state", 1] + c[1] * state["state", 0], state["state", 0]]
                for q in range(2):
                    missed = mp.mpf(e.weights[j, q]) * (model[q] - mp.mpf(e.values[j, q]))
                    cost += missed**2 / 2
        p = [z[k] for k in joined.parameters]
        cost += ((p[0] - mp.mpf(0.2)) / mp.mpf(0.5)) ** 2 / 2
        return cost + sum(mp.mpf(s) * one for s, one in zip(slope, p, strict=True)), rows

    z = np.random.default_rng(5).uniform(0.2, 1.2, joined.size)
    compare(nlp, z, reference)


def test_the_hessian_of_gauss_and_newton():
    x, v, F = me.dynamicsymbols("x v F")
    k = sm.Symbol("k")
    system = optima.first_order([x], v, F - k * sm.sin(x), 1, None, {k: 2.0})
    linear = sm.Integral(3 * F**2 + k * (x - v) ** 4 + (F - 2) ** 2, T) + (x.subs(T, 1.3) - 2) ** 2
    exact, made = [], None
    for hessian in ("exact", "gauss-newton"):
        problem = OptimalControl(
            system, linear, 1.3, mesh=2, order=2, boundary=[sm.Eq(v.subs(T, 1.3), 1)],
            hessian=hessian,
        )  # fmt: skip
        nlp, z, made = nlp_of(problem, 1)
        own = nlp.native("hessian", z, 0.7, np.zeros(nlp.rows))[0]
        exact.append(dense((nlp.size, nlp.size), nlp.hessian_at, own))
    # (x − v)⁴ = r² with r = (x − v)²: its exact Hessian is 12 (x − v)², that of r² 8 (x − v)².
    states, _controls, _, _ = made.split(z)
    slots = len(made.state_slots[0])
    weights = 0.7 * 1.3 * 2.0 * made.scheme.points(made.mesh)[0].weights
    missing = np.zeros_like(exact[0])
    for w, slot in zip(weights, made.scheme.points(made.mesh)[0].slots[0], strict=True):
        gap = (states[0, slot] - states[1, slot]) ** 2
        for i, j, sign in ((slot, slot, 1), (slots + slot,) * 2 + (1,), (slots + slot, slot, -1)):
            missing[i, j] += 4.0 * sign * w * gap
    np.testing.assert_allclose(exact[0] - exact[1], missing, atol=1e-12)
