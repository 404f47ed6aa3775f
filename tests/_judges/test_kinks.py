"""Linear models at kinks and jumps: either both sides have them, or a warning comes."""

import warnings

import mpmath as mp
import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.errors import PyDyUserWarning
from pydy.mechanics import Definition
from zoo import inertial_frame

X, Y, V, W = me.dynamicsymbols("x y v w")


def particle_with(force, *more, directions=(X,), speeds=(V,)):
    """A particle of mass m with a force along x, and others along y."""
    frame, origin = inertial_frame()
    axes = list(frame)[: len(directions)]
    position = sum(q * axis for q, axis in zip(directions, axes, strict=True))
    velocity = sum(u * axis for u, axis in zip(speeds, axes, strict=True))
    point = origin.locatenew("P", position)
    point.set_vel(frame, velocity)
    load = sum(f * axis for f, axis in zip((force, *more), axes, strict=True))
    body = me.Particle("b", point, sm.Symbol("m"))
    definition = Definition(frame, directions, speeds, bodies=[body], loads=[(point, load)])
    return System(definition, constants={sm.Symbol("m"): 1.0})


@pytest.mark.parametrize(
    "drag",
    [
        lambda v: -sm.Max(v, 0) - sm.Min(v, 0),
        lambda v: -sm.Abs(v) * sm.sign(v),
        lambda v: -sm.Symbol("c1") * sm.Max(v, 0) - sm.Symbol("c2") * sm.Min(v, 0),
        lambda v: -sm.Max(v, 0) - sm.Min(sm.sin(v), 0),
        lambda v: -sm.Abs(sm.exp(-v) - 1) * sm.sign(v),
        lambda v: -sm.sign(v) * sm.Max(sm.Abs(v), v**2),
        lambda v: -sm.Max(v - (sm.Symbol("c1") - 1), 0) - sm.Min(v + (sm.Symbol("c1") - 1), 0),
    ],
    ids=[
        "max and min",
        "abs and sign",
        "two dampers",
        "sine",
        "exponential",
        "squared",
        "no backlash",
    ],
)
def test_a_slope_that_both_sides_have_is_that_of_the_linear_model(drag):
    system = particle_with(drag(V))
    system.constants = dict.fromkeys(system.constants_symbols, 1.0)
    assert system.linearize(at={}).A[1, 1] == -1.0  # a warning would be an error
    sweep = system.eigenvalues({sm.Symbol("m"): [1.0, 2.0]}, at={})
    np.testing.assert_allclose(sweep.A[:, 1, 1], [-1.0, -0.5])


@pytest.mark.parametrize(
    "drag",
    [
        -sm.Abs(V) - sm.Max(sm.sin(V), 0),
        -sm.Max(V, 0) - 3 * sm.Min(sm.tan(V), 0),
        -sm.Max(sm.Abs((X - 1) * V), sm.Abs((sm.cos(X) - 2) * V)),
    ],
)
def test_a_kink_where_several_terms_switch_is_told(drag):
    with pytest.warns(PyDyUserWarning, match="There is no linear model for both sides") as told:
        particle_with(drag).linearize(at={})
    assert len(told) == 1


@pytest.mark.parametrize(
    ("force", "what"),
    [
        (sm.Abs(2 * Y) * sm.sign(X), r"y\(t\) = 0: .* slope 0 by it alone and 2 where others"),
        (1e9 * Y * sm.sign(1e-9 * X), r"y\(t\) = 0: .* slope 0 by it alone and 1e\+09 where"),
        (sm.Max(X, 0) * sm.sign(W) + V, r"x\(t\) = 0: .* slope 0 by it alone and 1 where others"),
        (
            sm.Min(0, sm.Max(X, Y)),
            r"x\(t\) = 0, y\(t\) = 0: the load on v\(t\) has the slope 0 on one side and 0\.",
        ),
    ],
)
def test_a_kink_off_the_axes_is_told(force, what):
    """Derivatives along each axis alone exist there, but the load is not linear."""
    with pytest.warns(PyDyUserWarning, match=what) as told:
        plane_particle(force).linearize(at={})
    assert len(told) == 1


def test_a_side_that_no_slope_tells_is_told():
    """Whether V |V| + V**3 is positive where V is depends on a state that multiplies both."""
    argument = (X - 2) * V * sm.Abs(V) + (X - 2) * V**3
    force = 2 * sm.Max(V, 0) + sm.Piecewise((5 * V, argument > 0), (3 * V, True))
    with pytest.warns(PyDyUserWarning, match="slope 5 by it alone and 7 where others") as told:
        particle_with(force).linearize(at={})
    assert len(told) == 1


def test_a_force_by_a_variable_sign_is_no_input_of_a_linear_model():
    push = me.dynamicsymbols("F")
    with pytest.warns(PyDyUserWarning, match=r"F\(t\) = 0: .* 0 by it alone and -1 where others"):
        plane_particle(-push * sm.sign(V)).linearize(at={})
    plane_particle(-push * sm.sign(V)).linearize(at={V: 1.0})  # a warning would be an error


@pytest.mark.parametrize(
    "force",
    [
        sm.Max(X, Y) + sm.Min(X, Y),
        sm.Abs(X * Y) + X,
        sm.sqrt((X - Y) ** 2) * sm.sign(X - Y),
        sm.Abs(V) * W * sm.Abs(X),
    ],
)
def test_what_is_linear_along_all_directions_is_not_told_of(force):
    variables = (X, Y, V, W)
    A = plane_particle(force).linearize(at={}).A  # a warning would be an error
    rng = np.random.default_rng(3)
    for direction in rng.normal(size=(20, 4)):
        step = dict(zip(variables, 2.0**-40 * direction, strict=True))
        np.testing.assert_allclose(A[2] @ direction, float(force.subs(step)) * 2.0**40, atol=1e-9)


def plane_particle(force):
    """A particle that moves in a plane, with a force along x."""
    return particle_with(force, sm.S.Zero, directions=(X, Y), speeds=(V, W))


@pytest.mark.parametrize("slope", [1e-9, 10.0, 1e12])
def test_a_slope_that_a_protected_division_hides_is_told(slope):
    sliding = sm.sqrt(V**2 + W**2)
    friction = sm.Piecewise((0, sm.Eq(sliding, 0)), (-sm.tanh(slope * sliding) / sliding, True))
    system = particle_with(friction * V, friction * W, directions=(X, Y), speeds=(V, W))
    message = rf"slope {-slope:.3g} by v\(t\) on both sides, but 0 is returned".replace("+", r"\+")
    with pytest.warns(PyDyUserWarning, match=message) as told:
        system.linearize(at={})
    assert len(told) == 1
    with pytest.warns(PyDyUserWarning, match=message):
        system.eigenvalues({sm.Symbol("m"): [1.0, 2.0]}, at={})
    system.linearize(at={V: 1e-6 / slope})  # a warning would be an error


def test_a_protected_division_whose_branch_is_right_is_not_told():
    ratio = sm.Piecewise((1, sm.Eq(V, 0)), (sm.sin(V) / V, True))
    assert particle_with(-X * ratio).linearize(at={}).A[1].tolist() == [-1.0, 0.0]


def random_load(rng):
    """A sum of terms that switch at the origin, some of them with a kink."""
    variables = (X, Y, V, W)

    def line():
        chosen = rng.choice(4, size=rng.integers(1, 3), replace=False)
        return sum(int(rng.choice([1, -1, 2, 3])) * variables[k] for k in chosen)

    def term():
        a, b = line(), line()
        forms = (
            lambda: sm.Abs(a) * sm.sign(b),
            lambda: sm.Max(a, b),
            lambda: sm.Min(a, b),
            lambda: a * sm.sign(b),
            lambda: sm.Max(a, 0) * sm.Heaviside(b, 0.5),
            lambda: sm.Piecewise((a, b > 0), (line(), True)),
            lambda: sm.Abs(sm.exp(a) - 1),
            lambda: sm.Abs(a) * b,
            lambda: a * b,
            lambda: sm.sin(a),
        )
        return int(rng.choice([1, -1, 2, -3])) * forms[rng.integers(len(forms))]()

    return sum((term() for _ in range(rng.integers(1, 4))), sm.S.Zero)


@pytest.mark.parametrize("seed", range(60))
def test_a_warning_comes_where_a_load_is_not_linear_and_only_there(seed):
    rng = np.random.default_rng(seed)
    force = random_load(rng)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        row = plane_particle(force).linearize(at={}).A[2]
    load = sm.lambdify((X, Y, V, W), force, "mpmath")
    with mp.workdps(60):
        directions = [*np.eye(4), *rng.normal(size=(40, 4))]
        slopes = [
            [load(*(h * mp.mpf(c) for c in d)) / h for h in (mp.mpf("1e-25"), mp.mpf("-1e-25"))]
            for d in directions
        ]
    differ = [
        max(abs(float(slope) - row @ d) for slope in both)
        for d, both in zip(directions, slopes, strict=True)
    ]
    assert bool(told) == (max(differ) > 1e-9)
