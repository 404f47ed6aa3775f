"""Redundant constraints, and motion through positions in which their rank falls."""

import mpmath as mp
import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.mechanics import Definition
from zoo import loops
from zoo.cases import close

T = me.dynamicsymbols._t
RANKS = {
    "bricard": (4, 1),
    "spatial_four_bar": (2, 3),
    "parallelogram": (2, 1),  # two rows vanish for all motions of the plane
    "three_cranks": (3, 1),
    "kite": (2, 0),
    "even_slider_crank": (2, 0),
    "sarrus": (5, 1),
}


def loop(name, **shape):
    return loops.system_of(name, np.linspace(0.0, 10.0, 101), "tsit5", **shape)


@pytest.mark.parametrize("name", RANKS)
def test_rows_of_full_rank_are_found(name):
    system = loop(name)
    rows = system.eom_method.multibody.constraints
    assert (len(rows.velocity), len(rows.redundant.velocity)) == RANKS[name]
    assert system.num_constraints == RANKS[name][0]
    close(system.evaluate_holonomic_constraints(), np.zeros(RANKS[name][0]), 1e-12)


@pytest.mark.parametrize("name", RANKS)
def test_a_loop_keeps_its_energy_through_singular_positions(name):
    system = loop(name)
    run = system.simulate(constraints="project", rtol=1e-10, atol=1e-10)
    energy = system.evaluate_energy(run.states, run.times)
    assert np.ptp(energy.kinetic) > 10.0
    assert np.abs(energy.total - energy.total[0]).max() < 1e-6


SHAPES = [
    ("bricard", {"edges": (sm.Rational(1, 2), 1, sm.Rational(3, 2))}),
    ("bricard", {"edges": (1, 2, 3)}),
    ("spatial_four_bar", {"rate": -4.0, "lengths": (2.0, 1.0), "twist": 1.0, "angle": -1.0}),
    ("spatial_four_bar", {"rate": 2.0, "lengths": (0.5, 0.7), "twist": 0.7, "angle": 0.4}),
    ("parallelogram", {"rate": 3.0, "crank": 0.5, "base": 1, "angle": 2.0}),
    ("parallelogram", {"rate": -9.0, "crank": 2, "base": 1, "angle": 0.3}),
    ("three_cranks", {"rate": -9.0, "crank": 2, "base": 1, "angle": 0.3}),
    ("three_cranks", {"rate": 8.0, "crank": 1.3, "base": 2.7, "angle": -1.0}),
]


@pytest.mark.parametrize(("name", "shape"), SHAPES)
def test_loops_of_other_sizes_keep_their_energy_too(name, shape):
    system = loop(name, **shape)
    rows = system.eom_method.multibody.constraints
    assert (len(rows.velocity), len(rows.redundant.velocity)) == RANKS[name]
    run = system.simulate(constraints="project", rtol=1e-10, atol=1e-10)
    energy = system.evaluate_energy(run.states, run.times)
    assert np.ptp(energy.kinetic) > 5.0
    assert np.abs(energy.total - energy.total[0]).max() < 1e-7 * np.ptp(energy.kinetic)


@pytest.mark.parametrize("name", ["parallelogram", "three_cranks"])
def test_a_parallelogram_moves_on_as_one(name):
    system = loop(name)
    run = system.simulate(constraints="project", rtol=1e-10, atol=1e-10)
    assert np.ptp(run["q1"]) > 4 * np.pi
    coupler = run["q1"] + run["q2"] if name == "parallelogram" else run["q4"]
    assert np.abs(coupler).max() < 1e-5


@pytest.mark.parametrize("name", RANKS)
def test_accelerations_keep_all_rows_at_consistent_states(name):
    system = loop(name)
    definition = system.eom_method
    found = dict(zip(system.states, system.evaluate_ode(), strict=True))
    rows = sm.lambdify([definition.coordinates], definition.holonomic_constraints, "mpmath")

    def left(t):  # along q + u t + u' t²/2
        return mp.matrix(rows([
            mp.mpf(float(system.initial_conditions[q])) + float(found[q]) * t
            + float(found[u]) * t**2 / 2
            for q, u in zip(definition.coordinates, definition.speeds, strict=True)
        ]))  # fmt: skip

    with mp.workdps(60):
        step = mp.mpf("1e-20")
        second = (left(step) - 2 * left(mp.mpf(0)) + left(-step)) / step**2
    close(np.array(second.tolist(), dtype=float).ravel(), np.zeros(len(second)), 1e-10)


def test_no_acceleration_is_lost_where_a_parallelogram_lies_flat():
    definition, start = loops.three_cranks()
    q1, q2, q3 = definition.coordinates[:3]
    system = System(definition, {loops.GRAVITY: 9.81})
    system.initial_conditions = {**start, q1: 0.0, q2: 0.0, q3: 0.0}
    found = dict(zip(system.states, system.evaluate_ode(), strict=True))
    # As one body: three cranks of inertia 1/3 and the coupler's mass 2 at the tips.
    cranks = [found[u] for u in definition.speeds[:3]]
    close(cranks, [-9.81 * (1.5 + 2.0) / 3.0] * 3, 1e-9)


def bead(*rows):
    x, y, vx, vy = me.dynamicsymbols("x y vx vy")
    m, g = sm.symbols("m g")
    frame, origin, end = me.ReferenceFrame("N"), me.Point("O"), me.Point("P")
    origin.set_vel(frame, 0)
    end.set_pos(origin, x * frame.x + y * frame.y)
    return System(
        Definition(
            frame,
            [x, y],
            [vx, vy],
            bodies=[me.Particle("bead", end, m)],
            loads=[(end, -m * g * frame.y)],
            holonomic_constraints=[row(x, y) for row in rows],
        ),
        {m: 2.0, g: 9.0},
    )


def multipliers(system):
    system.outputs = system.constraint_forces
    return system.evaluate_outputs([0.3, 0.09, 1.0, 0.6])[: len(system.constraint_forces)]


def test_constraints_that_say_the_same_share_the_force():
    single = bead(lambda x, y: y - x**2)
    double = bead(lambda x, y: y - x**2, lambda x, y: y - x**2)
    triple = bead(lambda x, y: y - x**2, lambda x, y: 3 * x**2 - 3 * y)
    (whole,) = multipliers(single)
    close(multipliers(double), [whole / 2, whole / 2], 1e-10)
    first, second = multipliers(triple)
    close(abs(first - 3 * second), abs(whole), 1e-10)
    assert set(map(str, triple.constraint_forces)) == {"lambda0", "lambda1"}


def mass_matrix(system, x):
    """The mass matrix of all speeds, from the kinetic energy."""
    n = system.num_speeds

    def energy(*moving):
        speeds = np.zeros(n)
        for k in moving:
            speeds[k] += 1.0
        return system.evaluate_energy([*x[:-n], *speeds]).kinetic

    return np.array([[energy(i, j) - energy(i) - energy(j) for j in range(n)] for i in range(n)])


@pytest.mark.parametrize("name", RANKS)
def test_multipliers_of_all_rows_balance_every_speed(name):
    system = loop(name)
    body = system.eom_method.multibody
    free = System(
        Definition(body.frame, body.coordinates, body.speeds, bodies=body.bodies, loads=body.loads),
        system.constants,
    )
    kinematics, constraints = body.kinematics, body.constraints
    pairs = zip(kinematics.coordinate_rates, kinematics.coordinate_derivatives, strict=True)
    rates, velocity = dict(pairs), (*constraints.velocity, *constraints.redundant.velocity)
    rows = [sm.sympify(row).doit().subs(rates) for row in velocity]
    slopes = [row.diff(u) for row in rows for u in body.speeds]
    forces = system.constraint_forces
    assert len(forces) == len(rows)
    system.outputs = {**forces, **{sm.Symbol(f"s{k}"): e for k, e in enumerate(slopes)}}
    x = np.array([system.initial_conditions[s] for s in system.states])
    values = system.evaluate_outputs(x)
    n, m = len(body.speeds), len(rows)
    slopes = values[m : m * (n + 1)].reshape(m, n)
    change = (system.evaluate_ode(x) - free.evaluate_ode(x))[n:]
    close(slopes.T @ values[:m], mass_matrix(free, x) @ change, 1e-10)


def straight(system):
    """Return how far the last joint of Peaucellier's linkage is from its line, at most."""
    q = dict(zip(map(str, system.coordinates), system.coordinates, strict=True))
    system.outputs = {"x": 3 * sm.cos(q["q2(t)"]) + 1.5 * sm.cos(q["q6(t)"])}
    run = system.simulate(constraints="project", rtol=1e-10, atol=1e-10)
    energy = system.evaluate_energy(run.states, run.times)
    return np.abs(run["x"] + 27.0 / 8.0).max(), np.abs(energy.total - energy.total[0]).max()


def test_peaucelliers_linkage_draws_a_straight_line():
    system = loop("peaucellier")
    system.times = np.linspace(0.0, 0.7, 71)
    off, lost = straight(system)
    assert off < 1e-12
    assert lost < 1e-7


@pytest.mark.parametrize("solver", ["dop853", "vern9"])
def test_a_singular_position_with_large_forces_takes_no_energy(solver):
    # It folds into a line at t = 0.776 and 2.415, where multipliers are large.
    system = loop("peaucellier")
    system.ode_solver, system.times = solver, np.linspace(0.0, 3.0, 31)
    off, lost = straight(system)
    assert off < 1e-12
    assert lost < 1e-5  # of 38


BENNETT = [{}, {"rate": 6.0}, *(shape for name, shape in SHAPES if name == "spatial_four_bar")]


@pytest.mark.parametrize(
    ("shape", "unit"), [*((shape, 1.0) for shape in BENNETT), ({}, 1e-9), ({}, 1e9)]
)
def test_baumgarte_holds_all_rows_of_bennetts_linkage(shape, unit):
    # The two rows that determine the dependent speeds lose rank where the linkage is regular.
    lengths = tuple(unit * a for a in shape.get("lengths", (1.0, 1.5)))
    system = loop("spatial_four_bar", **{**shape, "lengths": lengths})
    system.constants = {loops.GRAVITY: 9.81 * unit}
    system.times = np.linspace(0.0, 3.0, 61)
    run = system.simulate(constraints="baumgarte", gain=10.0, rtol=1e-10, atol=1e-10)
    rows = sm.lambdify([system.coordinates], system.eom_method.holonomic_constraints)
    places = [system.states.index(q) for q in system.coordinates]
    left = np.array([rows(x[places]) for x in run.states]) / ([unit] * 3 + [1.0] * 2)
    assert np.abs(left).max() < 1e-5
    energy = system.evaluate_energy(run.states, run.times)
    assert np.abs(energy.total - energy.total[0]).max() < 1e-5 * np.ptp(energy.kinetic)
