"""Motions in phases against closed forms."""

import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from oracles import optima
from oracles.optima import TF, T
from pydy import System
from pydy.control import OptimalControl
from pydy.errors import OptimizationError, PyDyUserWarning
from pydy.mechanics import Definition
from pydy.models import n_link_pendulum_on_cart
from zoo import inertial_frame


def moved(mass, speed, distance):
    """Return the least ∫ F² dt from rest to a speed, or from it to rest, over a distance in 1 s."""
    return mass**2 * (12 * distance**2 - 12 * distance * speed + 4 * speed**2)


@pytest.mark.parametrize("method", ["radau", "hermite-simpson"])
@pytest.mark.parametrize("restitution", [0.5, 0.8])
def test_a_mass_that_bounces_off_a_wall(restitution, method):
    # Each way costs 12 − 12 V + 4 V² at the speed V at the wall (the cubic through the ends), so
    # that the sum is least at V = 12 (1 + e) / (8 (1 + e²)).
    system, (x, v, F) = optima.double_integrator()
    effort = sm.Integral(F**2, T)
    there = OptimalControl(system, effort, 1.0, end={x: 1.0}, mesh=4, method=method)
    back = OptimalControl(system, effort, 1.0, end={x: 0.0, v: 0.0}, mesh=5)
    e = restitution
    solution = OptimalControl.phases([there, back], [{"v": -e * v}]).solve()
    assert solution.objective == pytest.approx(24 - 9 * (1 + e) ** 2 / (1 + e**2), rel=1e-8)
    assert solution[0][v][-1] == pytest.approx(12 * (1 + e) / (8 * (1 + e**2)), rel=1e-6)
    assert solution[1][v][0] == pytest.approx(-e * solution[0][v][-1], rel=1e-8)
    assert sum(phase.objective for phase in solution) == pytest.approx(solution.objective, rel=1e-8)
    assert (len(solution), solution.duration, solution.message) == (2, 2.0, "solved")


def test_a_problem_in_other_phases_is_linked_to_their_states():
    """The code of a link is kept with the problem before it, whatever the links and states."""
    x, v, F, w = me.dynamicsymbols("x v F w")
    effort = sm.Integral(F**2, T)
    system = optima.first_order([x], v, F)
    there = OptimalControl(system, effort, 1.0, end={x: 1.0}, mesh=4)
    back = OptimalControl(system, effort, 1.0, end={x: 0.0, v: 0.0}, mesh=4)
    kinematics = [w.diff() - 2 * v, x.diff() - v]
    wider = optima.first_order([w, x], v, F, 1, kinematics)
    beside = OptimalControl(wider, effort, 1.0, start={w: 7.0}, end={x: 0.0, v: 0.0}, mesh=4)
    for last, link in ((back, {v: -v}), (back, {v: -v / 2}), (beside, {v: -v / 2})):
        motions = OptimalControl.phases([there, last], [link]).solve()
        before, after = motions
        assert after[x][0] == pytest.approx(before[x][-1], abs=1e-8)
        assert after[v][0] == pytest.approx(float(link[v] / v) * before[v][-1], rel=1e-8)


def test_phases_are_swept_through_constants():
    x, v, F = me.dynamicsymbols("x v F")
    m, e = sm.symbols("m e")
    system = optima.first_order([x], v, F, m, None, {m: 1.0})
    other = optima.first_order([x], v, F, 1, None)
    effort = sm.Integral(F**2, T)
    there = OptimalControl(system, effort, 1.0, end={x: 1.0}, mesh=3)
    back = OptimalControl(system, effort, 1.0, end={x: 0.0, v: 0.0}, mesh=3)
    light = OptimalControl(other, effort, 1.0, end={x: 1.0, v: 0.0}, mesh=3)
    found = OptimalControl.phases([there, back], [{v: -v}]).sweep({"m": [1.0, 3.0]})
    for motion, mass in zip(found, (1, 3), strict=True):
        assert motion.objective == pytest.approx(mass**2 * 6.0, rel=1e-8)  # see above
        assert motion[1].constants[m] == mass
    # A second phase without that constant: the mass stops, to stay where it is.
    stop = OptimalControl(system, effort, 1.0, end={x: 1.0, v: 0.0}, mesh=3)
    phases = OptimalControl.phases([stop, light])
    assert phases.sweep({m: [2.0]})[0].objective == pytest.approx(4 * 12.0, rel=1e-8)
    with pytest.raises(ValueError, match="`values` has the key `e`, which is not one of"):
        phases.sweep({e: [1.0]})
    with pytest.raises(ValueError, match="`values` gives `m` more than once"):
        phases.sweep({m: [2.0], "m": [3.0]})
    with pytest.raises(ValueError, match=r"`links\[0\]\[v\(t\)\]` is True, but a link is"):
        OptimalControl.phases([there, back], [{v: sm.true}])
    with pytest.raises(ValueError, match=r"`links\[0\]\[v\(t\)\]` is t \+ v\(t\), but a link is"):
        OptimalControl.phases([there, back], [{v: v + T}])
    with pytest.raises(ValueError, match=r"`links\[0\]` gives `v\(t\)` more than once"):
        OptimalControl.phases([there, back], [{v: -v, "v": v}])
    free = OptimalControl(system, effort, 1.0, end={x: 1.0}, free=[m], bounds={m: (1, 2)})
    with pytest.raises(ValueError, match="`values` has `m`, which is `free`"):
        OptimalControl.phases([light, free]).sweep({"m": [1.0]})


def test_the_objective_of_phases_is_refined_too():
    system, (x, v, F) = optima.double_integrator()
    effort, options = sm.Integral(F**2, T), {"mesh": 10, "method": "midpoint"}
    there = OptimalControl(system, effort, 1.0, end={x: 1.0}, **options)
    back = OptimalControl(system, effort, 1.0, end={x: 0.0, v: 0.0}, **options)
    phases = OptimalControl.phases([there, back], [{v: -v}])
    least, coarse = 24 - 18, phases.solve()  # see above
    error = sum(phase.objective_error.sum() for phase in coarse)
    assert error == pytest.approx(least - coarse.objective, rel=0.1)
    assert phases.solve(mesh_tol=1e-4).objective == pytest.approx(least, rel=1e-4)


def test_phases_have_systems_of_their_own_and_share_free_constants():
    x, v, F = me.dynamicsymbols("x v F")
    m, k = sm.symbols("m k")
    heavy = optima.first_order([x], v, F, m, None, {m: 2.0})
    light = optima.first_order([x], v, F + k, 1, None, {k: 0.0})
    effort = sm.Integral(F**2, T)
    first = OptimalControl(heavy, effort, 1.0, mesh=3)
    second = OptimalControl(light, effort, 1.0, end={x: 1.0, v: 0.0}, mesh=3)
    solution = OptimalControl.phases([first, second]).solve()
    # The sum of two quadratic forms of x and v at the junction.
    X, V = sm.symbols("X V")
    total = moved(2, V, X) + moved(1, V, 1 - X)
    at = sm.solve([total.diff(X), total.diff(V)], [X, V])
    assert solution.objective == pytest.approx(float(total.subs(at)), rel=1e-8)
    assert solution[1][x][0] == pytest.approx(float(at[X]), rel=1e-6)
    both = [OptimalControl(light, effort + k**2, 1.0, free=[k], mesh=3, **ends)
            for ends in ({}, {"end": {x: 1.0, v: 0.0}})]  # fmt: skip
    solution = OptimalControl.phases(both).solve()
    assert solution[0].constants == solution[1].constants


def test_a_duration_that_phases_share_and_a_state_that_starts_anew():
    system, (x, v, F) = optima.double_integrator()
    bounds = {F: (-1.0, 1.0), TF: (0.1, 10.0)}
    first = OptimalControl(system, TF, TF, bounds=bounds, mesh=4)
    second = OptimalControl(system, TF, TF, end={x: 1.0, v: 0.0}, bounds=bounds, mesh=4)
    solution = OptimalControl.phases([first, second]).solve(mesh_tol=1e-6)
    assert solution.duration == pytest.approx(2.0, rel=1e-6)  # Bryson and Ho, 3.9
    assert solution[0].duration == solution[1].duration
    # Without a link of x, the second phase begins where its system does.
    alone = OptimalControl(system, TF, TF, end={x: 0.5}, bounds=bounds, mesh=4)
    solution = OptimalControl.phases([first, alone], [{x: None}]).solve(list(solution))
    assert solution[1][x][0] == 0.0


def test_a_mesh_of_phases_that_is_too_coarse_is_warned_of(monkeypatch):
    system = n_link_pendulum_on_cart(1, cart_force=True)
    (force,), angle = system.specifieds_symbols, system.states[1]
    options = {"end": {angle: 0.0}, "mesh": 2, "order": 2}
    effort = sm.Integral(force**2, T)
    first = OptimalControl(system, effort, 400.0, start={angle: 1.0}, **options)
    phases = OptimalControl.phases([first, OptimalControl(system, effort, 1.0, **options)])
    with pytest.warns(PyDyUserWarning, match="The mesh is too coarse"):
        phases.solve()
    monkeypatch.setattr("pydy.control.search.MOST_REFINEMENTS", 1)
    with pytest.warns(PyDyUserWarning, match="After 0 refinements the mesh of 4 intervals has"):
        phases.solve(mesh_tol=1e-6)


def test_errors_of_the_objective_of_phases_add_up():
    # Twice a metre in the least time at ±1 N and 0.6 m/s: 1 / 0.6 + 0.6 s each.
    system, (x, v, F) = optima.double_integrator()
    bounds = {F: (-1.0, 1.0), v: (None, 0.6), TF: (0.1, 10.0)}
    options = {"end": {x: 1.0, v: 0.0}, "bounds": bounds, "method": "midpoint"}
    fast = [OptimalControl(system, TF, TF, mesh=m, **options) for m in (3, 3)]
    coarse = r"objective of 5 may be wrong by 1, .* to [0-9.]+ of phase [01]\. Use more"
    with pytest.warns(PyDyUserWarning, match=coarse):
        solution = OptimalControl.phases(fast, [{x: None}]).solve()
    errors = [float(np.abs(phase.objective_error).sum()) for phase in solution]
    assert sum(errors) > solution.objective - 2 * (1 / 0.6 + 0.6) > max(errors) * 0.5
    assert f" ± {sum(errors):.1g}: solved" in repr(solution)
    # A tolerance is one of the sum, too: ∫ |F| dt to go 1 m in 3 s, two times.
    x, v, p, n = me.dynamicsymbols("x v p n")
    system = optima.first_order([x], v, p - n)
    limits = {"end": {x: 1.0, v: 0.0}, "bounds": {p: (0.0, 1.0), n: (0.0, 1.0)}}
    limits |= {"mesh": 5, "method": "hermite-simpson"}
    saving = [OptimalControl(system, sm.Integral(p + n, T), 3.0, **limits) for _ in range(2)]
    solution = OptimalControl.phases(saving, [{x: None}]).solve(mesh_tol=0.01)
    assert solution.objective == pytest.approx(2 * (3 - 5**0.5), rel=0.01)
    errors = [float(np.abs(phase.objective_error).sum()) for phase in solution]
    assert sum(errors) <= 0.01 * solution.objective


def rod(place=(0.0, -1.0), constrained=True):
    """A bob of 1 kg pushed sideways, at the end of a rod of 1 m or free."""
    x, y, v, w, F = me.dynamicsymbols("x y v w F")
    ground, rest = inertial_frame()
    bob = rest.locatenew("P", x * ground.x + y * ground.y)
    bob.set_vel(ground, v * ground.x + w * ground.y)
    rows = [x**2 + y**2 - 1] if constrained else []
    definition = Definition(
        ground, [x, y], [v, w], bodies=[me.Particle("bob", bob, 1)],
        loads=[(bob, F * ground.x - 9.81 * ground.y)], holonomic_constraints=rows,
    )  # fmt: skip
    system = System(definition, initial_conditions=dict(zip((x, y), place, strict=True)))
    return system, sm.Integral(F**2, T), (x, y, v, w)


def off(motion):
    """Return how far the start is from the constraints of the rod and of its rate."""
    x, y, v, w = (motion[name][0] for name in "xyvw")
    return max(abs(x**2 + y**2 - 1.0), abs(x * v + y * w))


@pytest.mark.parametrize("method", ["radau", "midpoint", "hermite-simpson"])
def test_constraints_hold_after_a_link(method):
    system, effort, (x, _, v, w) = rod()
    there = OptimalControl(system, effort, 0.7, end={x: 0.5}, method=method)
    end, start = {x: 0.0, v: 0.0}, {w: None}
    back = OptimalControl(system, effort, 0.8, end=end, method=method)
    following = OptimalControl(system, effort, 0.8, end=end, start=start, method=method)
    # The speed w that the first link takes over does not suit v, unless both are zero.
    both = OptimalControl.phases([there, back], [{v: -v / 2}]).solve()
    follows = OptimalControl.phases([there, following], [{v: -v / 2, w: None}]).solve()
    assert max(off(both[1]), off(follows[1])) < 1e-9
    assert abs(both[1][v][0]) < 1e-9 < 0.1 < abs(follows[1][v][0])
    assert follows[1][v][0] == pytest.approx(-follows[0][v][-1] / 2, rel=1e-8)
    assert follows.objective < both.objective
    assert max(phase.error.max() for phase in (*both, *follows)) < 1e-3


def test_the_start_of_the_first_phase_is_checked():
    system, effort, _ = rod((0.5, -1.0))  # farther from the pivot than the rod is long
    one = OptimalControl(system, effort, 1.0)
    with pytest.raises(ValueError, match="The start does not satisfy the constraints"):
        OptimalControl.phases([one, one]).check()


def test_a_phase_begins_where_its_own_constraints_hold():
    """A free flight ends where the rod takes over, without being told so."""
    flying, effort, (x, _, v, _) = rod((0.5, 0.3), constrained=False)
    hanging = OptimalControl(rod()[0], effort, 0.8, end={x: 0.0, v: 0.0})
    solution = OptimalControl.phases([OptimalControl(flying, effort, 0.4), hanging]).solve()
    assert off(solution[1]) < 1e-9
    assert max(phase.error.max() for phase in solution) < 1e-5


def test_bad_phases_are_named():
    system, (x, v, F) = optima.double_integrator()
    assert isinstance(system, System)
    one = OptimalControl(system, sm.Integral(F**2, T), 1.0, end={x: 1.0}, mesh=3)
    for given, error, message in [
        (([one],), ValueError, "at least two phases, got 1"),
        (([one, 3],), TypeError, "`problems` must hold OptimalControl objects, got 3 at 1"),
        (([one, one], []), ValueError, r"for each junction between phases, 1, got 0"),
        (([one, one], [{"bogus": 1}]), ValueError, "has the key `bogus`"),
        (([one, one], [{v: F}]), ValueError, r"`links\[0\]\[v\(t\)\]` is F"),
        (([one, one], [{v: v.diff()}]), ValueError, "expression of the states of the phase before"),
    ]:
        with pytest.raises(error, match=message):
            OptimalControl.phases(*given)
    phases = OptimalControl.phases([one, one])
    phases.check()
    for search in (phases.solve, phases.check):
        with pytest.raises(ValueError, match="an entry for each of the 2 phases, got 1"):
            search([{}])
    still = OptimalControl(system, x.subs(T, 1.0), 1.0, end={x: 0.0, v: 0.0}, bounds={F: (0, 0)})
    with pytest.raises(ValueError, match="there is nothing left to choose"):
        OptimalControl.phases([still, still]).check()
    short, long = (OptimalControl(system, TF, TF, bounds={TF: b}) for b in ((1, 2), (3, 4)))
    with pytest.raises(ValueError, match=r"of `tf`, .* at least 3 in one phase and at most 2 in"):
        OptimalControl.phases([short, long]).check()
    with pytest.raises(ValueError, match=r"`end.x.t..` is 1.0, which the `bounds` .* exclude"):
        OptimalControl.phases(
            [OptimalControl(system, TF, TF, end={x: 1.0}, bounds={x: (0, 0.5), TF: (1, 2)}), short]
        ).check()
    with pytest.raises(OptimizationError, match=r"in 2 phases .*phase \d|link 0 of") as caught:
        phases.solve(options={"max_iter": 0})
    assert len(caught.value.trajectory) == 2
    assert np.isfinite(caught.value.trajectory.duration)
