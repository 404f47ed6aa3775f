"""Linear, brush and TMeasy tires against closed forms, for numbers, arrays and expressions."""

import itertools
from dataclasses import asdict

import mpmath as mp
import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles import BrushTire, LinearTire, TMeasy
from zoo import inertial_frame

LINEAR = LinearTire(
    4000,
    cornering_stiffness=60e3,
    slip_stiffness=80e3,
    camber_stiffness=3e3,
    trail=0.03,
    rolling_resistance=0.004,
)
BRUSH = BrushTire(4000, stiffness=80e3, friction=0.9, half_length=0.06)
TMEASY = TMeasy(
    3200,
    rise_x=(90e3, 160e3), peak_x=(3300, 6500), peak_slip_x=(0.11, 0.12),
    sliding_x=(3200, 6000), sliding_slip_x=(0.5, 0.8),
    rise_y=(70e3, 100e3), peak_y=(3100, 5400), peak_slip_y=(0.18, 0.2),
    sliding_y=(3100, 5300), sliding_slip_y=(0.6, 0.8),
    trail=(0.054, 0.06), zero_slip=(0.2, 0.22), end_slip=(0.35, 0.4),
)  # fmt: skip
TIRES = {"linear": LINEAR, "brush": BRUSH, "TMeasy": TMEASY}


def linear(Fz, kappa, alpha, gamma):
    n = Fz / 4000
    return 80e3 * n * kappa, -n * (60e3 * alpha + 3e3 * gamma), 0, -0.004 * Fz, 1800 * n * alpha


def brush(Fz, kappa, alpha, gamma):
    """The isotropic brush model, by integrals over its contact patch."""
    a = mp.mpf("0.06") * mp.sqrt(Fz / 4000)
    cp = mp.mpf(80e3) / (2 * mp.mpf("0.06") ** 2)  # per length, at any load
    sx, sy = kappa / (1 + kappa), mp.tan(alpha) / (1 + kappa)
    size = mp.hypot(sx, sy)

    def limit(x):  # parabolic pressure
        return mp.mpf("0.9") * 3 * Fz / (4 * a) * (1 - (x / a) ** 2)

    # Deflection grows from the front edge until friction is reached, at a + x = 2 a θσ.
    theta = 2 * cp * a**2 / (3 * mp.mpf("0.9") * Fz)
    edge = min(2 * a * theta * size - a, a)
    stuck = mp.quad(lambda x: cp * size * (a - x), [edge, a])
    force = stuck + mp.quad(limit, [-a, edge])
    first = mp.quad(lambda x: x * cp * size * (a - x), [edge, a])
    moment = first + mp.quad(lambda x: x * limit(x), [-a, edge])
    return force * sx / size, -force * sy / size, 0, 0, -moment * sy / size


def tmeasy(Fz, kappa, alpha, gamma):
    p, Fn = asdict(TMEASY), mp.mpf(3200)
    r = Fz / Fn

    def Y(name):
        one, two = map(mp.mpf, p[name])
        return r * (2 * one - two / 2 - (one - two / 2) * r)

    def X(name):
        one, two = map(mp.mpf, p[name])
        return one + (two - one) * (r - 1)

    sy = mp.tan(alpha)
    ratio = {k: Y(f"peak_{k}") / Y(f"rise_{k}") for k in "xy"}
    slips = {k: X(f"peak_slip_{k}") for k in "xy"}
    hat = {k: slips[k] / sum(slips.values()) + ratio[k] / sum(ratio.values()) for k in "xy"}
    nx, ny = kappa / hat["x"], -sy / hat["y"]
    s = mp.hypot(nx, ny)
    c, d = nx / s, ny / s

    def both(x, y):
        return mp.hypot(x * c, y * d)

    dF = both(Y("rise_x") * hat["x"], Y("rise_y") * hat["y"])
    FM, FS = both(Y("peak_x"), Y("peak_y")), both(Y("sliding_x"), Y("sliding_y"))
    sM = both(slips["x"] / hat["x"], slips["y"] / hat["y"])
    sS = both(X("sliding_slip_x") / hat["x"], X("sliding_slip_y") / hat["y"])
    if s <= sM:
        t = s / sM
        F = sM * dF * t / (1 + t * (t + dF * sM / FM - 2))
    elif s <= sS:
        t = (s - sM) / (sS - sM)
        F = FM - (FM - FS) * t**2 * (3 - 2 * t)
    else:
        F = FS
    Fx, Fy = F * c, F * d
    zero, end, size = X("zero_slip"), X("end_slip"), abs(sy)
    w = zero / end
    if size <= zero:
        t = size / zero
        n = (1 - w) * (1 - t) + w * (1 - (3 - 2 * t) * t**2)
    elif size < end:
        n = -(1 - w) * (size - zero) / zero * ((end - size) / (end - zero)) ** 2
    else:
        n = 0
    return Fx, Fy, 0, 0, -X("trail") * n * Fy


PUBLISHED = {"linear": linear, "brush": brush, "TMeasy": tmeasy}


def slip_states():
    random = np.random.default_rng(5)
    low, high = [500.0, -0.4, -0.5, -0.1], [7000.0, 0.4, 0.5, 0.1]
    return random.uniform(low, high, (20, 4))


@pytest.mark.parametrize("name", list(TIRES))
def test_forces_are_those_of_the_published_equations(name):
    states = slip_states()
    with mp.workdps(30):
        expected = np.array(
            [[float(v) for v in PUBLISHED[name](*map(mp.mpf, state))] for state in states]
        )
    found = np.transpose(TIRES[name].forces(*states.T))
    spans = np.ptp(expected, axis=0)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10 * spans.max())
    for k in range(5):
        assert np.abs(found[:, k] - expected[:, k]).max() <= 1e-10 * (spans[k] or 1.0)


@pytest.mark.parametrize("name", list(TIRES))
def test_expressions_are_the_same_equations(name):
    symbols = sm.symbols("Fz kappa alpha gamma")
    forces = TIRES[name].forces(*symbols)
    function = sm.lambdify(symbols, list(forces), cse=True)
    for state in slip_states()[:5]:
        expected = TIRES[name].forces(*state)
        np.testing.assert_allclose(function(*state), expected, rtol=1e-12, atol=1e-9)


STATES = list(itertools.product((-1.0, 0.0, 4000.0), (-1.0, 0.0), (0.0, 1.5)))


@pytest.mark.parametrize("name", list(TIRES))
def test_values_and_slopes_are_finite_everywhere(name):
    inputs = me.dynamicsymbols("Fz kappa alpha gamma")
    forces = TIRES[name].forces(*inputs)
    N, O = inertial_frame()
    q, u = me.dynamicsymbols("q u")
    P = O.locatenew("P", q * N.x)
    P.set_vel(N, u * N.x)
    system = System(Definition(N, [q], [u], bodies=[me.Particle("P", P, sm.Symbol("m"))]))
    system.outputs = {sm.Symbol(n): f for n, f in zip("abcde", forces, strict=True) if f != 0}
    for state in STATES:
        given = zip(inputs, (*state, 0.0), strict=True)
        system.specifieds = {s: v for s, v in given if s in system.specifieds_symbols}
        found = system.evaluate_outputs()
        assert np.isfinite(found).all()
        assert np.isfinite(system.evaluate_jacobian(wrt="specifieds", of="outputs")).all()
        assert state[0] > 0.0 or not np.any(found)
        assert np.isfinite(TIRES[name].forces(*state)).all()


def test_linear_slopes_are_those_of_a_single_track_model():
    C = sm.Symbol("C")
    tire = LINEAR.replace(cornering_stiffness=C)
    alpha = sm.Symbol("alpha")
    assert tire.forces(4000, 0, alpha).Fy.diff(alpha).subs(C, 5.0) == -5.0


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
def test_rolling_resistance_fades_below_a_speed_of_ones_own(unit):
    tire = LINEAR.replace(rolling_resistance=0.01, low_speed=2.0 * unit)
    speeds = unit * np.array([-5.0, -1.0, 0.0, 1.0, 5.0])
    My = tire.forces(4000, 0, 0, speed=speeds).My
    np.testing.assert_allclose(My, [40.0, 27.5, 0.0, -27.5, -40.0], rtol=1e-14)


def test_combined_slip_of_the_brush_stays_within_friction():
    kappa, alpha = np.meshgrid(np.linspace(-1, 3, 41), np.linspace(-1.5, 1.5, 41))
    Fx, Fy, *_ = BRUSH.forces(4000, kappa, alpha)
    assert np.hypot(Fx, Fy).max() <= 3600.0 * (1 + 1e-12)
    locked = BRUSH.forces(4000, -1.0, 0.3)
    assert np.hypot(locked.Fx, locked.Fy) == pytest.approx(3600.0)
    assert locked.Fy / locked.Fx == pytest.approx(np.tan(0.3))


def test_tmeasy_has_the_values_that_it_is_made_of():
    for load, k in ((3200.0, 0), (6400.0, 1)):
        peak = TMEASY.forces(load, TMEASY.peak_slip_x[k], 0.0).Fx
        assert peak == pytest.approx(TMEASY.peak_x[k])
        assert TMEASY.forces(load, 1.0, 0.0).Fx == pytest.approx(TMEASY.sliding_x[k])
        h = 1e-7
        assert TMEASY.forces(load, h, 0.0).Fx / h == pytest.approx(TMEASY.rise_x[k], rel=1e-4)
        forces = TMEASY.forces(load, 0.0, h)
        assert -forces.Mz / forces.Fy == pytest.approx(TMEASY.trail[k], rel=1e-4)
        assert TMEASY.forces(load, 0.0, np.arctan(TMEASY.end_slip[k])).Mz == pytest.approx(0.0)


def test_parameters_are_checked_and_replaced():
    with pytest.raises(ValueError, match="`nominal_load` must be positive, got -1"):
        LinearTire(-1, 1e4)
    with pytest.raises(ValueError, match="`friction` must be positive"):
        BRUSH.replace(friction=0)
    with pytest.raises(TypeError, match="`rise_x` must be a pair of values"):
        TMEASY.replace(rise_x=1e5)
    with pytest.raises(ValueError, match="`sliding_slip_x` must be larger than `peak_slip_x`"):
        TMEASY.replace(sliding_slip_x=(0.1, 0.1))
    with pytest.raises(ValueError, match="'mu' is no parameter of the tire"):
        BRUSH.replace(mu=1.0)
    assert TMEASY.replace(**{"peak_x[1]": 7000.0}).peak_x == (3300.0, 7000.0)


def parabola(pair, n):
    """Return a force at n times the nominal load: the parabola through zero and both values."""
    one, two = pair
    return np.polyval(np.polyfit([0.0, 1.0, 2.0], [0.0, one, two], 2), n)


def test_tmeasy_keeps_the_forces_of_the_load_where_its_first_parabola_has_the_vertex():
    # The rise along y is 90e3 n − 20e3 n², whose vertex is at 2.25; other vertices are at larger n.
    loads = 3200 * np.array([2.2, 2.25, 2.3, 4.0, 10.0, 30.0])
    sliding = -TMEASY.forces(loads, 0.0, 1.5).Fy
    rising = -TMEASY.forces(loads, 0.0, 1e-7).Fy / 1e-7
    reached = np.minimum(loads / 3200, 2.25)
    np.testing.assert_allclose(sliding, parabola((3100, 5300), reached), rtol=1e-12)
    np.testing.assert_allclose(rising, parabola((70e3, 100e3), reached), rtol=1e-4)
    Fz = sm.Symbol("Fz")
    expression = TMEASY.forces(Fz, 0.0, 1.5).Fy
    assert float(expression.subs(Fz, 96e3)) == pytest.approx(-sliding[-1], rel=1e-12)


@pytest.mark.parametrize("slips", [(0.2, 0.1), (0.16, 0.04)])
def test_tmeasy_resists_at_any_load_with_slips_that_shrink(slips):
    tire = TMEASY.replace(peak_slip_y=slips)
    loads = np.geomspace(1.0, 1e6, 200)[:, None]
    angles = np.array([0.01, 0.05, 0.2, 1.0])
    assert (tire.forces(loads, 0.0, angles).Fy < 0.0).all()
    assert (tire.forces(loads, angles, 0.0).Fx > 0.0).all()


@pytest.mark.parametrize(
    ("name", "pair", "message"),
    [
        ("peak_slip_y", (0.1, 0.25), r"`peak_slip_y\[1\]` must be less than 2 times"),
        ("sliding_x", (1000.0, 4000.0), r"`sliding_x\[1\]` must be less than 4 times"),
        ("sliding_slip_y", (0.4, 0.7), "`sliding_slip_y` must be larger than `peak_slip_y` at sm"),
    ],
)
def test_tmeasy_refuses_pairs_that_are_negative_at_small_loads(name, pair, message):
    changes = {name: pair} | ({"peak_slip_y": (0.3, 0.45)} if name == "sliding_slip_y" else {})
    with pytest.raises(ValueError, match=message):
        TMEASY.replace(**changes)
    symbolic = TMEASY.replace(**changes | {name: (sm.Symbol("first"), pair[1])})
    assert symbolic.parameters[f"{name}[0]"] == sm.Symbol("first")
