"""Times at which a load switches by time alone, against closed forms."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy._graph.from_sympy import SymPyReader
from pydy._graph.intervals import bounds
from pydy._graph.linear_system import LinearSystem
from pydy._graph.lowering import lower
from pydy._graph.node import Graph
from pydy._graph.time_switches import SwitchTimes, TimeSwitches
from pydy.inputs import merged_jumps

t = me.dynamicsymbols._t
w, c = sm.symbols("w c")
PI = np.pi


def switches(*loads, varying=()):
    """Return the switches of a Program of expressions of t and the constants w and c."""
    graph = Graph()
    names = {t: graph.input("t", 0), w: graph.input("p", 0), c: graph.input("p", 1)}
    names |= {x: graph.input("x", 0), r: graph.input("r", 0)}
    nodes = SymPyReader(graph, names).all(loads)
    program = lower(graph, (1, 1, 2), [("loads", (len(nodes),), nodes)])
    return TimeSwitches.of(program, frozenset(varying))


def when(load, end, w=7.0, c=0.99, start=0.0) -> SwitchTimes:
    """Return the times at which an expression switches."""
    return switches(load).times(np.array([w, c]), np.zeros(1), start, end)


x, r = me.dynamicsymbols("x r")


def pulse(condition):
    """Return a load that a condition switches."""
    return sm.Piecewise((50, condition), (0, True))


def crossings(level, frequency, end):
    """Return the times in (0, end) at which sin(frequency t) passes a level."""
    turns = 2 * PI * np.arange(int(end * frequency) + 2)
    found = [turns + np.arcsin(level), turns + PI - np.arcsin(level)]
    times = np.sort(np.concatenate(found)) / frequency
    return times[(times > 0) & (times < end)]


CASES = {
    "a wave": (pulse(sm.sin(w * t) > c), 10.0, crossings(0.99, 7.0, 10.0)),
    "many periods": (pulse(sm.sin(1000 * t) > c), 10.0, crossings(0.99, 1000.0, 10.0)),
    "the larger of two": (sm.Max(sm.sin(w * t), c), 10.0, crossings(0.99, 7.0, 10.0)),
    "affine": (sm.Heaviside(w * t - 2), 5.0, [2.0 / 7.0]),
    "between two times": (pulse((t > 3) & (t < sm.Rational(7, 2))), 9.0, [3.0, 3.5]),
    "a square wave": (sm.sign(sm.sin(w * t)), 2.0, PI / 7.0 * np.arange(5)),
    "a kink": (sm.Abs(t - 1), 5.0, [1.0]),
    "whole numbers": (sm.floor(t), 2.5, [0.0, 1.0, 2.0]),
    "a period of one": (pulse(sm.Mod(t, 1) < 0.25), 2.5, [0.0, 0.25, 1.0, 1.25, 2.0, 2.25]),
    "within another": (
        pulse(sm.Max(0, sm.sin(t)) > 0.5),
        7.0,
        PI * np.array([0, 1 / 6, 5 / 6, 1, 2, 13 / 6]),
    ),
    "a pole": (pulse(sm.tan(t) > 1), 5.0, [PI / 4, PI / 2, 5 * PI / 4, 3 * PI / 2]),
    "a triple zero": (sm.sign((t - 1) ** 3), 5.0, [1.0]),
    "a narrow bell": (
        pulse(sm.exp(-((1000 * (t - 777)) ** 2)) > 0.5),
        1000.0,
        777 + np.array([-1, 1]) * np.sqrt(np.log(2)) / 1000,
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_times_are_those_of_closed_forms(name):
    load, end, expected = CASES[name]
    found = when(load, end)
    times, before, after = found.rows.T
    assert found.unresolved == 0
    # Rounding of the condition, not of the time, decides how near they are.
    np.testing.assert_allclose(times, expected, rtol=1e-13, atol=1e-15)
    assert ((before < times) & (times < after)).all()
    assert (after[:-1] <= before[1:]).all()


def test_rounding_does_not_decide_beside_a_switch():
    times, before, after = when(pulse(sm.sin(w * t) > c), 1000.0).rows.T
    signs = [np.sign(np.sin(7.0 * side) - 0.99) for side in (before, after)]
    np.testing.assert_array_equal(signs[0], -signs[1])
    np.testing.assert_array_equal(signs[1], np.where(np.arange(len(times)) % 2, -1, 1))
    assert (after - before < 1e-11).all()


@pytest.mark.parametrize("load", [pulse(sm.sin(7 * t) > 1), pulse((t - 1) ** 2 > 0)])
def test_a_condition_that_only_touches_zero_does_not_switch(load):
    assert len(when(load, 30.0).rows) == 0


def test_only_what_depends_on_time_alone_counts():
    assert switches(pulse(x > 1), sm.sin(t)) is None
    assert switches(pulse(sm.sin(t) > x), sm.Abs(w)) is None
    assert switches(pulse(r * t > 1), varying=[0]) is None
    found = switches(pulse(r * t > 1)).times(np.array([7.0, 0.99]), np.array([0.25]), 0.0, 9.0)
    np.testing.assert_allclose(found.rows[:, 0], [4.0])


def test_a_choice_between_two_ways_to_the_same_value_is_no_switch():
    """The condition of a guard, and what only its system needs, switch nothing: here |cos wt|.

    A system that is always solved is the one way to its values.
    """
    graph = Graph()
    names = {t: graph.input("t", 0), w: graph.input("p", 0), c: graph.input("p", 1)}
    read = SymPyReader(graph, names).all
    wave, load, size = read([sm.cos(w * t), pulse(sm.sin(w * t) > c), sm.Abs(sm.cos(w * t))])
    system = LinearSystem(graph, [[graph.one]])
    for sound, expected in ((graph.call("lt", wave, graph.zero), 1), (graph.boolean(False), 2)):
        nodes = system.guarded([graph.add(load, size)], sound, [load])
        program = lower(graph, (0, 0, 2), [("loads", (1,), nodes)])
        found = TimeSwitches.of(program, frozenset())
        assert len(found.nodes) == expected


def test_more_switches_than_steps_can_end_at_are_counted():
    found = when(pulse(sm.sin(w * t) > c), 1000.0, w=1e6)
    assert found.unresolved > 64
    assert len(found.rows) == 0


def test_bounds_contain_all_values():
    """Each operation's values at many points of an interval lie within its bounds."""
    graph = Graph()
    random = np.random.default_rng(4)
    low = np.concatenate([random.uniform(-4.0, 4.0, 300), np.linspace(-4.0, 4.0, 33)])
    high = low + np.abs(random.normal(0.0, 1.0, len(low))) * random.choice(
        [1e-3, 1.0, 5.0], len(low)
    )
    symbols = {t: graph.input("t", 0)}
    u = 1 + t**2 / 8
    loads = [
        *(f(t) for f in (sm.sin, sm.cos, sm.tan, sm.exp, sm.sinh, sm.cosh, sm.tanh, sm.atan)),
        *(f(t) for f in (sm.asinh, sm.erf, sm.erfc, sm.Abs, sm.sign, sm.floor, sm.ceiling)),
        *(sm.log(u), sm.sqrt(u), sm.asin(t / 10), sm.acos(t / 10), sm.acosh(u), sm.atanh(t / 10)),
        *(t**2, t**3, 1 / t, t**-2, u**t, sm.atan2(t, 1 - t), sm.atan2(1 - t, t), t * sm.cos(t)),
        *(sm.Max(t, sm.sin(t)), sm.Min(t**2, 1), sm.Piecewise((t, t**2 < 2), (-1, True))),
        *(sm.atan2(t, t - 1), sm.atan2(-t, t - 1)),  # they jump at t = 0, from π to −π or back
        sm.Piecewise((t, sm.Or(sm.And(t > 0, t <= 1), sm.Not(t < 3))), (1 - t, True)),
    ]
    nodes = SymPyReader(graph, symbols).all(loads)
    found = bounds(graph, nodes, lambda node: (low, high))
    points = np.linspace(low, high, 101)
    for load, (least, most) in zip(loads, found, strict=True):
        with np.errstate(all="ignore"):
            values = sm.lambdify(t, load, ["numpy", "scipy"])(points)
        assert np.isfinite(values).any()
        assert not (values < least - 1e-14 * np.abs(least)).any(), load
        assert not (values > most + 1e-14 * np.abs(most)).any(), load


def test_jumps_whose_windows_overlap_are_one_at_the_time_of_a_sample():
    sample, switch = [2.0, np.nextafter(2.0, 0.0), 2.0], [2.0 + 4e-16, 2.0 - 8e-16, 2.0 + 8e-16]
    later = [3.0, 3.0 - 1e-15, 3.0 + 1e-15]
    rows = merged_jumps([np.array([later]), np.array([sample]), np.array([switch])])
    np.testing.assert_array_equal(rows, [[2.0, 2.0 - 8e-16, 2.0 + 8e-16], later])
