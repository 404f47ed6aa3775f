"""Constraints that were left out as redundant take part where those that were kept lose rank."""

import numpy as np
import pytest
import sympy as sm
from scipy.integrate import solve_ivp

from pydy import System
from zoo import loops
from zoo.cases import close

LENGTHS, OFFSETS, TWISTS = loops.SCHATZ.values()


def places(angles):
    """Return the axes of Schatz's hinges, points on them, and the frames and ends of the links."""
    turn, at, found = np.eye(3), np.zeros(3), []
    for angle, a, d, twist in zip(angles, LENGTHS, OFFSETS, TWISTS, strict=True):
        c, s, ct, st = np.cos(angle), np.sin(angle), np.cos(twist), np.sin(twist)
        axis, base = turn[:, 2].copy(), at
        at = at + d * axis + turn @ (a * np.array([c, s, 0.0]))
        turn = turn @ np.array([[c, -s * ct, s * st], [s, c * ct, -c * st], [0.0, st, ct]])
        found.append((axis, base, turn, at))
    return found


def screws(links):
    """Return the velocities of the last link's origin and its rate, of each hinge."""
    return np.array([[*np.cross(axis, -base), *axis] for axis, base, _, _ in links]).T


def off(angles):
    """Return how far the linkage is from closed."""
    _, _, turn, at = places(angles)[-1]
    return np.concatenate(
        [at, [turn[:, 0] @ [0, 1, 0], turn[:, 1] @ [0, 0, 1], turn[:, 2] @ [1, 0, 0]]]
    )


def closed(angles):
    for _ in range(20):
        links = places(angles)
        _, _, turn, at = links[-1]
        spin = turn - turn.T
        error = np.array([*at, spin[2, 1] / 2, spin[0, 2] / 2, spin[1, 0] / 2])
        velocity = screws(links)
        velocity[:3] += np.cross(velocity[3:].T, at).T
        angles = angles - np.linalg.pinv(velocity, rcond=1e-4) @ error
    return angles


def along(angles, rate, gravity):
    """Return the direction of motion with u1 = 1, the mass for u1 and the potential energy."""
    links = places(angles)
    direction = np.linalg.svd(screws(links))[2][-1]
    direction = direction / direction[0]
    mass = height = 0.0
    spin, moved = np.zeros(3), np.zeros(3)
    for k, (axis, base, turn, at) in enumerate(links[:5]):
        spin = spin + axis * direction[k]
        moved = moved + np.cross(axis, -base) * direction[k]
        velocity, own = moved + np.cross(spin, at), turn.T @ spin
        mass += (1 + 0.1 * k) * velocity @ velocity + own**2 @ [0.1, 0.12, 0.15]
        height += (1 + 0.1 * k) * gravity * (at[2] + 0.03 * at[0])
    return direction, mass, height


def turn_of(start, rate, gravity=9.81):
    """Return the time of one turn, and the state after it, from the energy: t = ∫ dq1 / u1."""
    _, mass, height = along(start, rate, gravity)
    energy = mass * rate**2 / 2 + height

    def slopes(_, y):
        direction, mass, height = along(y[1:], rate, gravity)
        return np.array([np.sqrt(mass / 2 / (energy - height)), *direction])

    found = solve_ivp(
        slopes, (0.0, np.sign(rate) * 2 * np.pi), [0.0, *start], "DOP853", rtol=1e-12, atol=1e-12
    )
    return abs(found.y[0, -1]), found.y[1:, -1]


def schatz(unit=1.0, rate=1.0, **options):
    definition, start = loops.schatz(unit, **options)
    system = System(definition, {loops.GRAVITY: 9.81 * unit}, ode_solver="dop853")
    angles = closed(np.array([start[q] for q in definition.coordinates]))
    speeds = rate * along(angles, rate, 9.81)[0]
    names = (*definition.coordinates, *definition.speeds)
    system.initial_conditions = dict(zip(names, [*angles, *speeds], strict=True))
    return system, angles


def in_order(system, states):
    """Return the angles and the speeds of hinges, one after the other."""
    d = system.eom_method
    found = [[system.states.index(s) for s in part] for part in (d.coordinates, d.speeds)]
    return states[..., found[0]], states[..., found[1]]


PROJECT, BAUMGARTE = {"constraints": "project"}, {"constraints": "baumgarte", "gain": 10.0}


@pytest.mark.parametrize(
    ("unit", "last", "options"),
    [
        *((unit, False, PROJECT) for unit in (1.0, 1e-9, 1e9)),
        (1.0, True, PROJECT),
        (1e-9, False, BAUMGARTE),
        (1e9, True, BAUMGARTE),
    ],
)
def test_schatz_linkage_turns_all_the_way_round(unit, last, options):
    system, angles = schatz(unit, last=last)
    period, after = turn_of(angles, 1.0)
    system.times = np.linspace(0.0, period, 101)
    rows = system.eom_method.multibody.constraints
    assert (len(rows.velocity), len(rows.redundant.velocity)) == (5, 1)
    run = system.simulate(rtol=1e-11, atol=1e-11, **options)
    energy = system.evaluate_energy(run.states, run.times)
    assert np.abs(energy.total - energy.total[0]).max() < 1e-7 * np.ptp(energy.kinetic)
    q, u = in_order(system, run.states)
    held = options["constraints"] == "project"
    assert max(np.abs(off(x)).max() for x in q) < (1e-12 if held else 1e-7)
    close(q[-1], after, 1e-7)
    close(u[-1], u[0], 1e-6)
    close(np.abs(after[0] - angles[0]), 2 * np.pi, 1e-9)


@pytest.mark.parametrize("last", [True, False])
def test_accelerations_near_the_linkage_satisfy_all_rows(last):
    # A step leaves the constraints by its error: kept rows that lose rank would make much of it.
    system, angles = schatz(last=last)
    period, _ = turn_of(angles, 1.0)
    system.times = np.linspace(0.0, period, 201)
    states = system.integrate(constraints="project")
    found = system.evaluate_ode(states, system.times)
    rng = np.random.default_rng(3)
    shifted = states + 1e-9 * rng.standard_normal(states.shape)
    moved = system.evaluate_ode(shifted, system.times)
    assert np.abs(moved - found).max() < 1e-6


def test_samples_of_an_ensemble_have_the_bits_of_single_runs():
    system, _ = schatz()
    system.times = np.linspace(0.0, 2.0, 21)
    gravities = np.linspace(8.0, 10.0, 9)
    options = {"constraints": "project", "rtol": 1e-9, "atol": 1e-9}
    many = system.integrate_ensemble(constants={"g": gravities}, **options)
    assert many.attrs["lanes"] == 8
    names = [s.name for s in system.states]
    for k in (0, 8):
        system.constants["g"] = gravities[k]
        states = system.integrate(**options)
        found = np.stack([many[name].values[k] for name in names], axis=-1)
        np.testing.assert_array_equal(found, states)
        assert max(np.abs(off(x)).max() for x in in_order(system, states)[0]) < 1e-12


@pytest.mark.parametrize("way", ["forward", "backward", "in lanes"])
def test_derivatives_hold_all_rows_too(way):
    system, _ = schatz()
    system.times = np.linspace(0.0, 1.5, 16)
    options = {"constraints": "project", "rtol": 1e-11, "atol": 1e-11}
    if way == "in lanes":
        many = system.integrate_ensemble(constants={"g": [9.81]}, sensitivities=["g"], **options)
        assert many.status.values[0] == 0
        return
    run = system.simulate(sensitivities=["g"], **options)
    if way == "backward":
        wanted = system.eom_method.coordinates[0]
        back = system.adjoint_gradient(["g"], final=wanted, **options)
        close(back["g"], run.sensitivity[wanted, "g"][-1], 1e-7)
        return
    ends = []
    for g in (9.81 - 1e-4, 9.81 + 1e-4):
        system.constants["g"] = g
        ends.append(system.integrate(**options)[-1])
    found = np.array([run.sensitivity[x, "g"][-1] for x in system.states])
    close(found, (ends[1] - ends[0]) / 2e-4, 1e-5)


SCALED = {
    "bricard": lambda unit: {"edges": (unit / 2, unit, 1.5 * unit)},
    "spatial_four_bar": lambda unit: {"lengths": (unit, 1.5 * unit)},
    "parallelogram": lambda unit: {"crank": unit / 2, "base": unit, "angle": 1.9},
    "sarrus": lambda unit: {"unit": unit},
}


@pytest.mark.parametrize("name", SCALED)
def test_loops_move_alike_in_any_units(name):
    found = []
    for unit in (1.0, 1e-9, 1e9):
        definition, start = getattr(loops, name)(**SCALED[name](unit))
        system = System(
            definition,
            {loops.GRAVITY: 9.81 * unit},
            initial_conditions=start,
            times=np.linspace(0.0, 1.5, 31),
            ode_solver="dop853",
        )
        system.set_dependent_initial_conditions()
        assert any(system.eom_method.multibody.constraints.redundant.velocity)
        run = system.simulate(constraints="project", rtol=1e-10, atol=1e-10)
        q, u = in_order(system, run.states)
        rows = sm.lambdify([definition.coordinates], definition.holonomic_constraints)
        # Rows are lengths, or directions that are as small where they hold.
        assert max(np.abs(rows(x)).max() for x in q) < 1e-12 * max(unit, 1.0)
        energy = system.evaluate_energy(run.states, run.times)
        assert np.abs(energy.total - energy.total[0]).max() < 1e-7 * np.ptp(energy.kinetic)
        found.append(np.concatenate([q, u], axis=1))
    close(found[1], found[0], 1e-6)
    close(found[2], found[0], 1e-6)
