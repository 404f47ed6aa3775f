"""Systems for the tests from the models of the zoo."""

from itertools import pairwise

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import odeint, solve_ivp

import zoo
from oracles.oracle import oracle
from pydy.mechanics import Definition
from pydy.system import System

__all__ = [
    "OTHER_SOLVERS",
    "WAYS_OF_R",
    "Recorder",
    "arrays",
    "check_arguments",
    "close",
    "given",
    "system_of",
    "uncoupled",
    "wide",
]


def system_of(model, **options):
    """A System with the model's numbers; options replace them."""
    defaults = {
        "constants": dict(model.constants),
        "specifieds": dict(model.specifieds),
        "initial_conditions": dict(model.start),
        "noncontributing_forces": model.forces or None,
    }
    return System(model.kane, **{**defaults, **options})


def wide(system, x):
    """The state with something in the auxiliary places."""
    extra = np.full((*np.shape(x)[:-1], system.num_auxiliaries), 0.25)
    return np.concatenate([x, extra], axis=-1)


def close(actual, desired, tolerance=1e-10):
    """Equal shapes, and equal within the tolerance relative to the largest entry."""
    actual, desired = np.asarray(actual), np.asarray(desired, dtype=float)
    assert actual.shape == desired.shape
    scale = max(1.0, float(np.max(np.abs(desired), initial=0.0)))
    np.testing.assert_allclose(actual, desired, rtol=0, atol=tolerance * scale)


class Recorder:
    """odeint that keeps what it was given."""

    def __init__(self):
        self.f, self.x0, self.times, self.args, self.options = None, None, None, None, None

    def __call__(self, f, x0, t, args=(), **options):
        self.f, self.x0, self.times, self.args, self.options = f, x0, t, args, options
        return odeint(f, x0, t, args=args)


def given(model, form):
    """Arguments of generate_ode_function for one of the three forms."""
    kane = model.kane
    arguments = {
        "coordinates": list(kane.q),
        "speeds": list(kane.u),
        "constants": list(model.constants),
    }
    if model.specifieds:
        arguments["specifieds"] = list(model.specifieds)
    if form == "[1]":
        arguments["right_hand_side"] = kane.rhs()
    elif form == "[2]":
        arguments["right_hand_side"] = kane.forcing_full
        arguments["mass_matrix"] = kane.mass_matrix_full
    else:
        rates = kane.kindiffdict()
        arguments["right_hand_side"] = kane.forcing
        arguments["mass_matrix"] = kane.mass_matrix
        arguments["coordinate_derivatives"] = sm.Matrix(
            [rates[q.diff(me.dynamicsymbols._t)] for q in kane.q]
        )
    return arguments


def arrays(model):
    """r (if there are specifieds) and p."""
    p = np.array(list(model.constants.values()), dtype=float)
    return ([np.array(list(model.specifieds.values()))] if model.specifieds else []) + [p]


def rk4(f, x0, t, args=()):
    """A solver that keeps its stages."""
    rows = [np.array(x0)]
    for start, end in pairwise(t):
        x, h = rows[-1], (end - start) / 40
        for i in range(40):
            now = start + i * h
            a = f(x, now, *args)
            b = f(x + h / 2 * a, now + h / 2, *args)
            c = f(x + h / 2 * b, now + h / 2, *args)
            d = f(x + h * c, now + h, *args)
            x = x + h / 6 * (a + 2 * b + 2 * c + d)
        rows.append(x)
    return np.array(rows)


def adapted(f, x0, t, args=()):
    """SciPy's newer solver behind odeint's signature."""
    options = {"t_eval": t, "rtol": 1e-10, "atol": 1e-10}
    return solve_ivp(lambda t, x: f(x, t, *args), t[[0, -1]], x0, **options).y.T


OTHER_SOLVERS = [rk4, adapted]

FORCE = me.dynamicsymbols("F T1 T2")


def pushed(x, t):
    """Values of F, T1, T2 that depend on state and time."""
    return [x[0] - t, 2 * x[4], t**2]


def ways_of_r(x, t, time_first):
    """Every way to give r; all mean the same numbers at (x, t)."""
    f, t1, t2 = FORCE

    def function(g):
        return (lambda t, x: g(x, t)) if time_first else g

    a, b, c = pushed(x, t)
    return {
        "array": np.array([a, b, c]),
        "list": [a, b, c],
        "dictionary": {t2: c, f: a, t1: b},
        "dictionary of tuples": {(t2, f): np.array([c, a]), t1: b},
        "dictionary of functions": {
            t2: function(lambda x, t: t**2),
            (t1, f): function(lambda x, t: np.array([2 * x[4], x[0] - t])),
        },
        "mixed dictionary": {t2: function(lambda x, t: np.array([t**2])), (t1, f): (b, a)},
        "function": function(lambda x, t: np.array(pushed(x, t))),
        "function giving a list": function(pushed),
    }


WAYS_OF_R = list(ways_of_r(np.zeros(6), 0.0, False))


def check_arguments(rhs, r, p, time_first):
    model = zoo.pendulum()
    x, t = model.sample(9)
    expected = oracle(model).xdot(x, t, dict(zip(FORCE, pushed(x, t), strict=True)))
    values = {
        "array": np.array(list(model.constants.values())),
        "list": list(model.constants.values()),
        "dictionary": dict(reversed(model.constants.items())),
    }[p]
    first = (t, x) if time_first else (x, t)
    close(rhs(*first, ways_of_r(x, t, time_first)[r], values), expected)


def uncoupled(solver, ratio, damping=0.0, end=20.0, load=0):
    """Two oscillators: the first moves, the second is at rest, and that many times as fast.

    The second is also pushed by a constant P, which is zero, times the `load`.
    """
    x, u, y, v = me.dynamicsymbols("x u y v")
    c, K, P = sm.symbols("c K P")
    frame, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(frame, 0)
    point = origin.locatenew("point", x * frame.x + y * frame.y)
    force = -x * frame.x - (K * y + c * v - P * load) * frame.y
    bodies, loads = [me.Particle("body", point, 1)], [(point, force)]
    system = System(Definition(frame, [x, y], [u, v], bodies=bodies, loads=loads))
    system.constants, system.ode_solver = {K: ratio**2, c: damping}, solver
    if load != 0:
        system.constants[P] = 0.0
    system.initial_conditions, system.times = {x: 1.0}, np.linspace(0.0, end, 5)
    return system
