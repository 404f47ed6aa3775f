"""Exact derivatives through tires against differences: of a small car, and of its motion."""

from functools import cache
from types import SimpleNamespace

import mpmath as mp
import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles import BrushTire, LinearTire, MagicFormula, TMeasy
from pydy.vehicles.forces import TireInputs
from zoo import inertial_frame, tires

M, I, J, R, ARM, LOWEST, G0 = 400.0, 300.0, 1.2, 0.31, 1.1, 0.1, 9.81
SIMPLE = {
    "linear": LinearTire(4000, 60e3, 80e3, 3e3, trail=0.03, rolling_resistance=0.004),
    "brush": BrushTire(4000, stiffness=80e3, friction=0.9, half_length=0.06),
    "TMeasy": TMeasy(
        3200,
        rise_x=(90e3, 160e3), peak_x=(3300, 6500), peak_slip_x=(0.11, 0.12),
        sliding_x=(3200, 6000), sliding_slip_x=(0.5, 0.8),
        rise_y=(70e3, 100e3), peak_y=(3100, 5400), peak_slip_y=(0.18, 0.2),
        sliding_y=(3100, 5300), sliding_slip_y=(0.6, 0.8),
        trail=(0.054, 0.06), zero_slip=(0.2, 0.22), end_slip=(0.35, 0.4),
    ),
}  # fmt: skip
NAMES = [*SIMPLE, *tires.TIRES]
VARIABLES = ("u", "v", "r", "w", "delta", "load", "camber")


@cache
def tire_of(name):
    if name in SIMPLE:
        return SIMPLE[name]
    version, equations, values = tires.TIRES[name]
    return MagicFormula(values, version, equations=equations)


# The functions of a tire's equations by mpmath, with as many digits as it works with.
HIGH_PRECISION = SimpleNamespace(
    symbolic=False,
    sin=mp.sin, cos=mp.cos, tan=mp.tan, atan=mp.atan, exp=mp.exp, sqrt=mp.sqrt,
    abs=mp.fabs, sign=mp.sign, minimum=min, maximum=max, constant=mp.mpf,
    where_negative=lambda x, yes, no: yes if x < 0 else no,
    side=lambda x: -1 if x < 0 else 1,
)  # fmt: skip


def rates(name, u, v, r, w, delta, load, camber):
    """Return u', v', r' and w' of a car with one steered wheel in front, by mpmath.

    The road is banked by the camber angle: tires without camber have derivatives by it, too.
    """
    m, inertia, spin, radius, arm, lowest = map(mp.mpf, (M, I, J, R, ARM, LOWEST))
    sin, cos = mp.sin(delta), mp.cos(delta)
    aside = v + arm * r
    ahead, left = u * cos + aside * sin, aside * cos - u * sin
    size = max(abs(ahead), lowest)
    slip, angle = (radius * w - ahead) / size, mp.atan(left / size)
    state = TireInputs(load, slip, angle, camber, ahead, None)
    Fx, Fy, _, My, Mz = tire_of(name)._equations(HIGH_PRECISION, state)
    forward, side = Fx * cos - Fy * sin, Fx * sin + Fy * cos
    return [
        v * r + forward / m,
        -u * r + side / m + mp.mpf(G0) * mp.sin(camber),
        (arm * side + Mz) / inertia,
        (My - radius * Fx) / spin,
    ]


@cache
def car(name):
    """Return the same car as a System."""
    N, O = inertial_frame()
    x, y, psi = me.dynamicsymbols("x y psi")
    u, v, r, w, delta = me.dynamicsymbols("u v r w delta")
    load, camber = sm.symbols("load camber")
    B = me.ReferenceFrame("B")
    B.orient_axis(N, N.z, psi)
    B.set_ang_vel(N, r * N.z)
    G = O.locatenew("G", x * N.x + y * N.y)
    G.set_vel(N, u * B.x + v * B.y)
    C = G.locatenew("C", ARM * B.x)
    W = me.ReferenceFrame("W")
    W.orient_axis(B, B.y, 0)
    W.set_ang_vel(B, w * B.y)
    body = me.RigidBody("body", G, B, M, (me.inertia(B, 0, 0, I), G))
    wheel = me.RigidBody("wheel", C, W, 0, (me.inertia(W, 0, J, 0), C))
    aside = v + ARM * r
    ahead = u * sm.cos(delta) + aside * sm.sin(delta)
    left = aside * sm.cos(delta) - u * sm.sin(delta)
    size = sm.Max(sm.Abs(ahead), LOWEST)
    tire = tire_of(name)
    forces = tire.forces(load, (R * w - ahead) / size, sm.atan(left / size), camber, speed=ahead)
    S = B.orientnew("S", "Axis", (delta, B.z))
    kinematics = [
        x.diff() - u * sm.cos(psi) + v * sm.sin(psi),
        y.diff() - u * sm.sin(psi) - v * sm.cos(psi),
        psi.diff() - r,
    ]
    definition = Definition(
        N,
        [x, y, psi],
        [u, v, r, w],
        bodies=[body, wheel],
        loads=[
            (G, M * G0 * sm.sin(camber) * B.y),
            (C, forces.Fx * S.x + forces.Fy * S.y),
            (B, forces.Mz * B.z),
            (W, (forces.My - R * forces.Fx) * B.y),
        ],
        kinematic_equations=kinematics,
    )
    return System(definition, {load: 4000.0, camber: 0.0}, {delta: 0.0}, ode_solver="dop853")


def derivatives(name, state, sides=(1, -1)):
    """Return the rates of a state and their derivatives, by differences of 60 digits."""
    with mp.workdps(60):
        step = mp.mpf(10) ** -25
        at = dict(zip(VARIABLES, map(mp.mpf, state), strict=True))
        columns = []
        for variable in VARIABLES:
            there, back = (rates(name, **{**at, variable: at[variable] + s * step}) for s in sides)
            width = (sides[0] - sides[1]) * step
            columns.append([float((a - b) / width) for a, b in zip(there, back, strict=True)])
        return np.array([float(rate) for rate in rates(name, **at)]), np.transpose(columns)


def jacobian(name, state):
    """Return the same, exact ones of the System."""
    system = car(name)
    u, v, r, w, delta, load, camber = state
    system.constants = {"load": load, "camber": camber}
    system.specifieds = {"delta": delta}
    system.initial_conditions = {"u": u, "v": v, "r": r, "w": w}
    wrt = [me.dynamicsymbols(n) for n in VARIABLES[:5]] + list(sm.symbols("load camber"))
    return system.evaluate_ode()[3:], system.evaluate_jacobian(wrt=wrt)[3:]


def near(found, expected):
    """Return which derivatives are equal, relative to themselves or the largest of their rate."""
    scale = np.maximum(np.abs(expected), 1e-3 * np.abs(expected).max(axis=1, keepdims=True))
    return np.abs(found - expected) <= 1e-10 * (scale + 1e-3)


def assert_same(name, state):
    (rates_, found), (expected_rates, expected) = jacobian(name, state), derivatives(name, state)
    np.testing.assert_allclose(rates_, expected_rates, rtol=1e-11, atol=1e-10)
    assert near(found, expected).all(), np.abs(found - expected)


def random_states():
    random = np.random.default_rng(11)
    for _ in range(8):
        u = random.uniform(3.0, 40.0) * random.choice([-1.0, 1.0])
        w = u / R * random.uniform(0.6, 1.4)
        yield (
            u,
            random.normal() * 0.1 * u,
            random.normal() * 0.3,
            w,
            random.normal() * 0.1,
            (random.uniform(500.0, 7000.0)),
            random.normal() * 0.05,
        )


@pytest.mark.parametrize("name", NAMES)
def test_derivatives_of_a_small_car_are_those_of_differences(name):
    for state in random_states():
        assert_same(name, state)


NEAR = {
    "no slip": (20.0, 0.0, 0.0, 20.0 / R, 0.0, 4000.0, 0.01),
    "slips of 1e-9": (20.0, 2e-8, 0.0, 20.0 / R * (1 + 1e-9), 0.0, 4000.0, 0.01),
    "slips of 1e-13": (20.0, 2e-12, 0.0, 20.0 / R * (1 + 1e-13), 0.0, 4000.0, 0.01),
    "standstill": (0.0, 0.0, 0.0, 0.0, 0.0, 4000.0, 0.01),
    "steered at standstill": (0.0, 0.0, 0.0, 0.0, 0.3, 4000.0, -0.02),
    "creeping": (1e-6, 2e-7, 0.0, 1e-6 / R, 0.1, 4000.0, 0.01),
    "locked": (15.0, 0.5, 0.1, 0.0, 0.05, 3000.0, 0.01),
    "almost no load": (20.0, 0.5, 0.0, 60.0, 0.05, 1e-3, 0.01),
    "lifted": (20.0, 0.5, 0.0, 60.0, 0.05, -10.0, 0.01),
}


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("where", list(NEAR))
def test_derivatives_are_exact_without_slip_at_rest_and_without_load(name, where):
    assert_same(name, NEAR[where])


KINKS = {
    "no load": (20.0, 0.5, 0.0, 60.0, 0.05, 0.0, 0.01),
    "the smallest speed of slips": (0.1, 0.01, 0.0, 0.4, 0.0, 3000.0, 0.01),
    "upright": (20.0, 0.5, 0.1, 20.0 / R * 1.02, 0.02, 4000.0, 0.0),
    "spinning at standstill": (0.0, 0.0, 0.0, 30.0, 0.1, 3000.0, 0.01),
    "sideways": (0.0, 3.0, 0.0, 1.0, 0.0, 3000.0, 0.01),
}


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("where", list(KINKS))
def test_at_a_kink_the_derivative_is_that_of_one_side(name, where):
    # The load ends where the wheel lifts off; the speed that slips are relative to has a minimum;
    # the size of camber has a kink in some equations, and others have the sign of the speed ahead.
    state = KINKS[where]
    _, found = jacobian(name, state)
    above, below = (derivatives(name, state, sides)[1] for sides in ((1, 0), (0, -1)))
    assert (near(found, above) | near(found, below)).all()
    if where == "no load":  # a brush tire that slides has no kink by the speed
        assert not near(above, below).all()


@pytest.mark.parametrize("name", ["brush", "TMeasy", "5.2"])
def test_sensitivities_of_a_manoeuvre_are_those_of_differences(name):
    system = car(name)
    system.constants = {"load": 4000.0, "camber": 0.02}
    system.specifieds = {"delta": 0.05}
    start = {"u": 20.0, "v": 0.0, "r": 0.0, "w": 0.9 * 20.0 / R}  # the wheel has been braked
    system.times = [0.0, 0.1, 0.2]
    tight = {"rtol": 1e-12, "atol": 1e-12}

    def ends(values):
        system.constants = {"load": 4000.0, "camber": values.get("camber", 0.02)}
        system.specifieds = {"delta": values.get("delta", 0.05)}
        system.initial_conditions = {**start, "w": values.get("w", start["w"])}
        return system.simulate(**tight).states[-1]

    system.initial_conditions = start
    motion = system.simulate(sensitivities=["delta", "w", "camber"], **tight)
    for variable, value, step in (
        ("delta", 0.05, 1e-4),
        ("w", start["w"], 0.05),
        ("camber", 0.02, 1e-4),
    ):
        one, two = (
            (ends({variable: value + k * step}) - ends({variable: value - k * step}))
            / (2 * k * step)
            for k in (1, 2)
        )
        expected = (4 * one - two) / 3  # of the fourth order
        found = [
            motion.sensitivity[str(s).removesuffix("(t)"), variable][-1] for s in system.states
        ]
        assert found == pytest.approx(expected, rel=2e-6, abs=2e-6 * np.abs(expected).max())
