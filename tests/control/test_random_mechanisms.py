"""Derivatives of collocation points of random mechanisms against differences of 50 digits.

The rows and the cost are evaluated as their Programs say, which hold no derivatives, in mpmath.
"""

import mpmath as mp
import numpy as np
import pytest
import sympy as sm

from mechanisms.build import definition
from mechanisms.generate import draw
from oracles.optima import TF, T
from pydy import System
from pydy.control import OptimalControl
from pydy.control.transcription import Transcription
from pydy.inputs import SampledInput

# Small ones: of large ones the equations take SymPy and the compiler a minute.
SEEDS = [5000, 5001, 5004, 5006, 5007, 5009, 5011, 5014, 5015, 5018, 5019, 5026, 5041]
STEP = mp.mpf(10) ** -12
OPERATIONS = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b,
    "neg": lambda a: -a,
    "powi": lambda a, n: a**n,
    "abs": abs,
    "pow": mp.power,
    "min": min,
    "max": max,
    "lt": lambda a, b: a < b,
    "le": lambda a, b: a <= b,
    "select": lambda condition, a, b: a if condition else b,
    **{name: getattr(mp, name) for name in ("sqrt", "exp", "log", "sin", "cos", "tan", "atan",
                                            "asin", "acos", "atan2", "sign", "tanh")},
}  # fmt: skip


def value(program, x, r, p):
    """Return the outputs of a Program in mpmath."""
    given, found = {"x": x, "r": r, "p": p}, []
    for op, args in zip(program.ops, program.args, strict=True):
        if op == "const":
            found.append(mp.mpf(args[0]))
        elif op == "bool":
            found.append(args[0])
        elif op == "input":
            found.append(given[args[0]][args[1]])
        elif op == "powi":
            found.append(found[args[0]] ** args[1])
        else:
            found.append(OPERATIONS[op](*(found[k] for k in args)))
    return mp.matrix([found[k] for k in program.outputs])


def problem_of(seed):
    """Return a problem of a mechanism of two or three bodies, whose inputs are its controls.

    Three of its constants are free. Every second one has a free duration, and samples for one input
    if it has any.
    """
    model = definition(draw(seed))
    start = {**dict(zip(model.q, model.real["q"], strict=True)),
             **dict(zip(model.u, model.real["u"], strict=True))}  # fmt: skip
    system = System(model.method, initial_conditions=start)
    known = system.constants_symbols  # inertias that nothing turns are none
    system.constants = {s: value for s, value in model.constants.items() if s in known}
    states = sum(s**2 * sm.cos(s + T) for s in system.states)
    inputs = sorted(system.specifieds_symbols, key=str)
    controls = sum(c**2 * sm.exp(system.states[0] / 10) for c in inputs)
    effort, free = sm.Integral(states + controls, T), sorted(known, key=str)[:3]
    if seed % 2:
        given = {s: SampledInput([0.0, 0.4, 1.0], [0.3, -0.2, 0.9], "pchip") for s in inputs[:1]}
        system.specifieds = given
        bounds = {"bounds": {TF: (0.1, 1.0)}}
        return OptimalControl(system, effort * TF, TF, free=free, mesh=2, order=2, **bounds)
    return OptimalControl(system, effort, 0.3, free=free, mesh=2, order=2)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_random_mechanism(seed):
    problem = problem_of(seed)
    transcription = Transcription(problem._problem, problem._scheme, problem._mesh)
    (points,) = transcription.scheme.points(transcription.mesh)
    group = transcription.groups[0]
    functions, rng = group.functions, np.random.default_rng(seed)
    x = np.repeat(np.array(problem._snapshot.x)[None], len(points.slots), axis=0)
    x = x + np.max(np.abs(x), initial=1e-3, axis=0) * 0.1 * rng.normal(size=x.shape)
    rest = rng.uniform(0.2, 1.2, functions.sizes[0] - x.size)
    X = np.concatenate([x.ravel(), rest])[:, None]
    R, P = group.data[:, :1].copy(), group.constants
    m = functions.outputs[0]
    weights = rng.normal(size=m + 1)
    J, g, H = (np.empty((len(at), 1)) for at in (
        functions.jacobian_at, functions.gradient_at, functions.hessian_at))  # fmt: skip
    J = functions("jacobian", X, R, P)
    g = functions("gradient", X, R, P)
    H = functions("hessian", X, np.concatenate([R, weights[:, None]]), P)
    n = len(X)
    jacobian, slope, second = np.zeros((m, n)), np.zeros(n), np.zeros((n, n))
    jacobian[tuple(functions.jacobian_at.T)] = J[:, 0]
    slope[functions.gradient_at] = g[:, 0]
    i, j = functions.hessian_at.T
    second[i, j] = second[j, i] = H[:, 0]
    programs = [functions.programs[name] for name in ("rows", "cost")]
    with mp.workdps(50):
        numbers = [[mp.mpf(v) for v in array] for array in (R[:, 0], P)]

        def at(step, direction):
            z = [mp.mpf(a) + step * mp.mpf(d) for a, d in zip(X[:, 0], direction, strict=True)]
            return [*value(programs[0], z, *numbers), *value(programs[1], z, *numbers)]

        for _ in range(3):
            d = X[:, 0] * rng.normal(size=n)
            low, middle, high = (at(k * STEP, d) for k in (-1, 0, 1))
            first = [float((b - a) / (2 * STEP)) for a, b in zip(low, high, strict=True)]
            curved = [(a - 2 * b + c) / STEP**2 for a, b, c in zip(low, middle, high, strict=True)]
            curvature = float(sum(mp.mpf(w) * c for w, c in zip(weights, curved, strict=True)))
            sizes = np.append(np.abs(jacobian) @ np.abs(d), np.abs(slope) @ np.abs(d))
            found = np.append(jacobian @ d, slope @ d)
            assert np.all(np.abs(found - first) <= 1e-10 * sizes)
            size = np.abs(d) @ np.abs(second) @ np.abs(d)
            assert abs(d @ second @ d - curvature) <= 1e-10 * size
