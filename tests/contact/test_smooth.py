"""Gaps without kinks and sliding speeds without jumps."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me
from sympy.functions.special.bsplines import bspline_basis

from pydy.contact import Contacts, Stick, Unilateral
from zoo.touching import N, O, block, k, r, slope, vx, vy, x, y

t = me.dynamicsymbols._t
first, then = sm.symbols("first then")
wave = sm.Mod(x, 1)

KINKS = [
    y - sm.Piecewise((0, t < 1.013), (-(t - 1.013), True)),  # a floor that begins to sink
    y - sm.Piecewise((0, x < 1), (1 - x, True)),  # a table edge
    y - sm.Piecewise((0, x < 1e-9), (-1e-9, True)),  # a step
    y - sm.Piecewise((0, x < first), (k, True)),
    y - k * sm.Piecewise((0, x**2 + t < first), (x**2 + t - first, True)),
    y - sm.Abs(x),
    y - sm.sqrt(sm.Abs(x) ** 2 + sm.Abs(x)),
    y - r * sm.sign(x),
    y - r * sm.Heaviside(t - first),
    y - sm.floor(x),
    y - sm.ceiling(t / first),
    y - sm.Mod(t, 2),
    sm.Min(x, 2 - x),
    sm.Max(x, y, -y),
    y + sm.Abs(sm.sin(x)),
    y - sm.Piecewise((0, (x < 1) | (t < 2)), (1, True)),
    y - sm.sqrt(sm.Abs(x)),
    y - sm.Max(0, sm.sin(x) - sm.Rational(1, 2)),
    y - k * sm.sqrt(x**2),
    y - x / sm.sqrt(x**2 * r**2),
    y - sm.acos(sm.cos(x)),
    y - k * sm.asin(sm.cos(x + r)),
    y - sm.atan(sm.tan(t)),
    y - sm.acot(x),
]

SMOOTH = [
    y - sm.Abs(k),
    y - sm.Piecewise((r * x, k > 0), (x**2, True)),
    y - sm.Min(k, r) * x,
    sm.sqrt(x**2 + y**2) - r,
    sm.sqrt(sm.Abs(x) ** 2 + sm.Abs(y) ** 2) - r,
    y - x * sm.Abs(x),
    y - sm.Max(0, x - first) ** 2,
    y - sm.Max(0, sm.sin(t)) ** 2,
    y - sm.Piecewise((0, t < 0.1), (3 * (t - 0.1) ** 2, t < 0.3), (3 * (0.4 * t - 0.08), True)),
    y - sm.Piecewise((0, x < first), (k * (x - first) ** 2, x < then),
                     (k * (then - first) * (2 * x - first - then), True)),
    y - sm.Piecewise((1 - sm.cos(x), x > 0), (0, True)),
    y - sm.Piecewise((1, sm.Eq(x, 0)), (sm.sin(x) / x, True)),
    y - sm.Piecewise((wave**2 * (1 - wave) ** 2, wave < 0.5), ((wave - wave**2) ** 2, True)),
    y - r * sm.sin(2 * sm.pi * sm.frac(t)),
    y - sm.Abs(x) ** 1.5,
    y - sm.Max(0, sm.sin(x) - 0.5) ** 2,
    y - sm.Piecewise((0, x**2 > r**2), ((r**2 - x**2) ** 2, True)),
    y - sm.Abs(2 + sm.sin(t)),
    y + sm.Max(0, sm.cos(x) / 2 - sm.sin(t) - 2),
    y - sm.Min(3, 1 + sm.tanh(x)),
    y - x * sm.sqrt(x**2),
    y - sm.asin(sm.cos(x) / 2),
    y - sm.acos(sm.cos(x)) ** 2 * sm.sin(x) ** 2,
    y - sm.atan(x) - sm.acot(2 + sm.sin(x)),
]  # fmt: skip


@pytest.mark.parametrize("gap", KINKS)
def test_gaps_with_kinks_or_jumps_are_named(gap):
    system, _ = block()
    with pytest.raises(ValueError, match="gap of 'edge' must have no jumps and no kinks, got `"):
        Contacts(system, [Unilateral(gap, name="edge")])


@pytest.mark.parametrize("gap", SMOOTH)
def test_gaps_that_are_smooth_may_be_written_in_pieces(gap):
    system, _ = block()
    Contacts(system, [Unilateral(gap)])


def test_splines_are_taken_by_their_degree():
    """SymPy takes a third of a second for them: they are not made when tests are collected."""
    test_gaps_with_kinks_or_jumps_are_named(y - sm.interpolating_spline(1, x, [0, 1, 2], [0, 1, 0]))
    parabolas = sm.interpolating_spline(2, x, [0, 1, 2, 3], [0, 1, 0, 0.3])
    for spline in (parabolas, bspline_basis(3, range(6), 1, x)):
        test_gaps_that_are_smooth_may_be_written_in_pieces(y - spline)


JUMPS = [
    vx - sm.Piecewise((0, t < 1.013), (2, True)),
    vx - k * sm.sign(sm.sin(t)),
    vx - k * sm.Heaviside(x - first),
    vx * sm.Piecewise((1, x < 0), (2, True)),
    vx - sm.DiracDelta(t - first),
    vx - sm.floor(t),
]
CONTINUOUS = [
    vx - sm.Piecewise((0.7 * t, t < 0.3), (0.21, t < 3), (0.21 - 0.7 * (t - 3), True)),
    vx - k * sm.Min(1, sm.Max(0, t - first)),
    vx - sm.Abs(sm.sin(t)) - sm.Abs(k) * sm.sign(r),
    vx + sm.Abs(x) * vy,
]


@pytest.mark.parametrize("speed", JUMPS)
def test_sliding_speeds_that_jump_are_named(speed):
    system, _ = block()
    with pytest.raises(ValueError, match="sliding speed of 'belt' must not jump, got `"):
        Contacts(system, [Stick(speed, mu=0.2, normal=1, name="belt")])


@pytest.mark.parametrize("speed", CONTINUOUS)
def test_sliding_speeds_may_have_kinks(speed):
    system, _ = block()
    Contacts(system, [Stick(speed, mu=0.2, normal=1)])


def test_the_speed_of_a_point_that_is_moved_is_looked_at():
    system, P = block()
    moved = O.locatenew("belt", sm.Piecewise((0, t < 1), (2 * (t - 1), True)) * N.x)
    moved.set_vel(N, moved.pos_from(O).dt(N))
    with pytest.raises(ValueError, match=r"must not jump, got `Piecewise\(\(0, t < 1\), \(2, True"):
        Contacts(system, [Stick(P, mu=0.2, normal=1, along=N.x, against=moved)])


def test_pieces_that_no_longer_meet_are_named_when_their_constants_are_known():
    system, _ = block()
    system.times, system.initial_conditions = np.linspace(0.0, 1.0, 3), {y: 20.0}
    ramp = sm.Piecewise((0, t < first), (k * (t - first), t < then), (k * (then - first), True))
    contacts = Contacts(system, [Stick(vx - ramp, mu=slope, normal=1, name="belt")])
    system.constants.update({first: 0.25, then: 0.5})
    contacts.simulate()
    system.constants[then] = 0.125
    with pytest.raises(ValueError, match="sliding speed of 'belt' must not jump"):
        contacts.simulate()
