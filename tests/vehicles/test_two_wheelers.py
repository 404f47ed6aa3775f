"""Bicycles and motorcycles against the published benchmark and equations that are written down."""

import cProfile
import pstats
from dataclasses import replace
from functools import cache

import mpmath as mp
import numpy as np
import pytest

from oracles.two_wheelers import benchmark_eigenvalues, sharp_eigenvalues
from pydy.vehicles import BrushTire, LinearTire
from pydy.vehicles.two_wheelers import (
    BICYCLES,
    MOTORCYCLES,
    FrameBody,
    Rider,
    WheelBody,
    bicycle,
    motorcycle,
)

BENCHMARK, SHARP = BICYCLES["benchmark"], MOTORCYCLES["sharp_1971"]
SPEEDS = [0.0, 1.0, 2.0, 4.0, 5.0, 6.0, 8.0, 10.0]  # no eigenvalue of the benchmark is double
TIGHT = {"rtol": 1e-11, "atol": 1e-12}


@cache
def rolling():
    return bicycle(BENCHMARK)


@cache
def on_linear_tires():
    """The benchmark bicycle on tires whose stiffnesses are constants."""
    loads = BENCHMARK.static_loads
    return bicycle(BENCHMARK, [LinearTire(load, 1e4, 1e4) for load in loads])


@cache
def machine():
    return motorcycle(SHARP)


def straight(data, speed):
    """Return the states of straight running that change with the speed."""
    spins = speed / data.front_wheel.radius, speed / data.rear_wheel.radius
    return dict(zip(("u", "omega_f", "omega_r"), (speed, *spins), strict=True))


def eigenvalues(system, data, speed):
    return system.linearize(at=straight(data, speed)).eigenvalues


def outputs(system, states=None):
    """Return the outputs by name, at the initial conditions with some other states."""
    values = system.evaluate_outputs(states)
    return dict(zip(map(str, system.outputs_symbols), values, strict=True))


def distance(found, expected):
    """Return how far the expected eigenvalues are from the nearest ones."""
    return max(np.abs(found - value).min() for value in expected)


@pytest.mark.parametrize("speed", SPEEDS)
def test_a_bicycle_that_rolls_has_the_published_eigenvalues(speed):
    found = eigenvalues(rolling(), BENCHMARK, speed)
    assert distance(found, benchmark_eigenvalues(speed)) < 1e-11
    # All others are those of the position, the heading and the speed.
    rest = sorted(found, key=lambda value: np.abs(benchmark_eigenvalues(speed) - value).min())[4:]
    assert np.abs(rest).max() < 1e-5


def test_the_weave_and_capsize_speeds_are_the_published_ones():
    sweep = rolling().eigenvalues({"u": np.linspace(1.0, 8.0, 8)}, moving=["x"])
    weave, capsize = (crossing.value for crossing in sweep.crossings())
    assert (weave, capsize) == pytest.approx((4.292382536341, 6.024262015388), abs=5e-12)


def test_the_outputs_of_a_bicycle_that_rolls_are_the_forces_of_the_road():
    system = rolling()
    values = outputs(system)
    front, rear = BENCHMARK.static_loads
    assert values["Fz_f"] == pytest.approx(front, rel=1e-12)
    assert values["Fz_r"] == pytest.approx(rear, rel=1e-12)


@cache
def stiff_eigenvalues(stiffness, speed):
    """Return the four eigenvalues that are nearest to those of wheels that roll.

    By inverse iteration with 30 digits: in a stiff matrix those of LAPACK have errors of 1e-9.
    """
    model = bicycle_on_tires(stiffness).linearize(at=straight(BENCHMARK, speed))
    found = []
    with mp.workdps(30):
        matrix, unit = mp.matrix(model.A.tolist()), mp.eye(len(model.A))
        for expected in benchmark_eigenvalues(speed):
            nearest = model.eigenvalues[np.abs(model.eigenvalues - expected).argmin()]
            value, vector = mp.mpc(complex(nearest)), mp.matrix([1] * len(model.A))
            for _ in range(4):
                value += mp.mpf(10) ** -20  # else the matrix becomes singular
                solution = mp.lu_solve(matrix - value * unit, vector)
                k = max(range(len(solution)), key=lambda i: abs(solution[i]))
                value += vector[k] / solution[k]
                vector = solution / solution[k]
            found.append(complex(value))
    return np.array(found)


@cache
def symbolic_tires():
    """The benchmark bicycle on tires with the constant C: as a motorcycle without camber forces."""
    values = {
        "front_stiffness": 1.0, "rear_stiffness": 1.0, "front_camber_stiffness": 0.0,
        "rear_camber_stiffness": 0.0, "front_relaxation": 0.0, "rear_relaxation": 0.0,
        "steering_damping": 0.0,
    }  # fmt: skip
    return motorcycle(replace(SHARP, **vars(BENCHMARK), **values))


def bicycle_on_tires(stiffness):
    system = symbolic_tires()
    system.constants.update({"C_f": stiffness, "C_r": stiffness})
    return system


@pytest.mark.parametrize("speed", SPEEDS)
def test_on_stiff_tires_the_eigenvalues_tend_to_those_of_wheels_that_roll(speed):
    stiffnesses = 2e6 * 2.0 ** np.arange(5)
    expected = benchmark_eigenvalues(speed)
    table = np.array([stiff_eigenvalues(stiffness, speed) for stiffness in stiffnesses])
    errors = np.abs(table - expected).max(axis=1)
    assert errors[:-1] / errors[1:] == pytest.approx(2.0, rel=0.03)  # of first order in 1/C
    for order in range(1, len(table)):
        table = (2.0**order * table[1:] - table[:-1]) / (2.0**order - 1.0)
    assert np.abs(table[-1] - expected).max() < 1e-8


@pytest.mark.parametrize("speed", [5.0, 10.0, 20.0, 40.0, 60.0])
def test_the_motorcycle_has_the_eigenvalues_of_sharps_equations(speed):
    expected = sharp_eigenvalues(SHARP, speed)
    found = eigenvalues(machine(), SHARP, speed)
    assert distance(found, expected) < 1e-9 * np.abs(expected).max()


def test_a_motorcycle_without_relaxation_has_those_of_sharps_equations_without_it():
    plain = replace(SHARP, front_relaxation=0.0, rear_relaxation=0.0)
    found = eigenvalues(motorcycle(plain), SHARP, 25.0)
    expected = sharp_eigenvalues(plain, 25.0)
    assert distance(found, expected) < 1e-9 * np.abs(expected).max()


def test_weave_wobble_and_capsize_are_as_sharp_describes_them():
    sweep = machine().eigenvalues({"u": np.linspace(8.0, 50.0, 8)}, moving=["x"])
    # Of lightly damped motion; the machine bounces and pitches on its tires at 5.4 and 7.2 Hz.
    slow, *_, fast = modes = [row[row.real > -10.0] for row in sweep.eigenvalues]
    wobbles = [row[(row.imag > 53.0) & (row.imag < 63.0)] for row in modes]
    assert [len(row) for row in wobbles] == [1] * 8
    # The wobble loses its damping with the speed; the weave becomes faster, up to 4 Hz.
    assert -7.0 < wobbles[0][0].real < wobbles[-1][0].real - 3.0 < -3.0
    first, last = (row[(row.imag > 1.0) & (row.imag < 25.0)].imag for row in (slow, fast))
    assert len(first) == len(last) == 1
    assert 0.5 < first[0] / (2 * np.pi) < last[0] / (2 * np.pi) < 4.0
    # The capsize is slowly unstable at speed, the rest is stable.
    assert (fast.real > 1e-3).sum() == 1
    assert fast.real.max() < 0.1


def test_wheels_that_lean_are_pushed_into_their_lean():
    system = motorcycle(replace(SHARP, front_relaxation=0.0, rear_relaxation=0.0))
    states = {"phi": 0.1, "delta": 0.05}
    values = outputs(system, states)
    assert values["gamma_r"] == pytest.approx(0.1)
    assert 0.05 < values["gamma_f"] < 0.1  # steering to the left takes some of the lean
    assert values["alpha_r"] == pytest.approx(0.0, abs=1e-12)
    assert values["alpha_f"] < 0.0
    stiffness, load = SHARP.rear_camber_stiffness, values["Fz_r"] / SHARP.static_loads[1]
    assert values["Fy_r"] == pytest.approx(-stiffness * 0.1 * load)  # to the right


@pytest.mark.parametrize("make", [rolling, machine])
def test_a_mirrored_vehicle_has_the_mirrored_motion(make):
    system = make()
    data = BENCHMARK if make is rolling else SHARP
    start = {"z": data.rear_wheel.radius, **straight(data, 5.0)}
    odd = {"y", "psi", "phi", "delta", "v", "r", "p", "delta_rate"}
    odd |= {f"{name}_{end}" for name in ("e_y", "gamma_lag", "gamma", "Fy") for end in "fr"}
    system.times = np.linspace(0.0, 1.0, 11)
    motions = []
    for side in (1.0, -1.0):
        system.initial_conditions = {**start, "phi": 0.1 * side, "delta": 0.03 * side}
        if make is rolling:
            system.set_dependent_initial_conditions()
        motions.append(system.simulate(**TIGHT))
    left, right = motions
    assert np.ptp(left["y"]) > 0.1
    for state in (*map(str, system.states), "Fy_f(t)", "gamma_r(t)"):
        name = state.removesuffix("(t)")
        sign = -1.0 if name in odd else 1.0
        np.testing.assert_allclose(right[name], sign * left[name], rtol=1e-9, atol=1e-9)


def test_a_bicycle_that_rolls_keeps_its_energy_and_stays_on_the_road():
    system = rolling()
    system.times = np.linspace(0.0, 3.0, 31)
    system.initial_conditions = {"z": 0.3, **straight(BENCHMARK, 4.6), "p": 0.5}
    system.set_dependent_initial_conditions()
    motion = system.simulate(**TIGHT, constraints="project")
    assert np.ptp(motion["phi"]) > 0.05
    np.testing.assert_allclose(motion.energy[:, 2], motion.energy[0, 2], rtol=1e-9)
    assert np.abs(system.evaluate_holonomic_constraints(x=motion.states)).max() < 1e-10


def test_the_normal_forces_of_tires_carry_the_weight_in_straight_running():
    system = on_linear_tires()
    assert np.abs(np.delete(system.evaluate_ode(), 0)).max() < 1e-10  # but for x
    values = outputs(system)
    assert (values["Fz_f"], values["Fz_r"]) == pytest.approx(BENCHMARK.static_loads, rel=1e-12)


def test_a_leaning_wheel_with_a_crown_is_as_high_as_a_torus():
    wheels = {
        name: replace(getattr(BENCHMARK, name), crown_radius=0.1)
        for name in ("rear_wheel", "front_wheel")
    }
    system = bicycle(replace(BENCHMARK, **wheels))
    system.initial_conditions = {"phi": 0.3, "omega_r": 10.0}
    system.set_dependent_initial_conditions()
    heights = {str(s): value for s, value in system.initial_conditions.items()}
    assert heights["z(t)"] == pytest.approx(0.2 * np.cos(0.3) + 0.1, rel=1e-12)


def test_a_rider_who_is_held_fast_is_part_of_the_frame():
    # The frame and the rider together are the frame of the benchmark.
    rider = Rider(20.0, 0.3, 1.1, 1.0, 1.0, 0.5, hinge_height=0.9, stiffness=1e9, damping=0.0)
    whole = BENCHMARK.rear_frame
    mass = whole.mass - rider.mass
    height = (whole.mass * whole.height - rider.mass * rider.height) / mass
    apart = rider.mass * (rider.height - 0.9) ** 2 + mass * (height - 0.9) ** 2
    rest = FrameBody(
        mass, 0.3, height, whole.Ixx - 1.0 - apart, whole.Iyy - 1.0 - apart, whole.Izz - 0.5,
        whole.Ixz,
    )  # fmt: skip
    system = bicycle(replace(BENCHMARK, rear_frame=rest), rider=rider)
    assert distance(eigenvalues(system, BENCHMARK, 5.0), benchmark_eigenvalues(5.0)) < 1e-4
    # A torque to the right leans the rider to the right, and the frame to the left.
    system.constants["k_U"] = 0.0
    system.specifieds = {"T_U": 1.0}
    rates = dict(zip(map(str, system.states), system.evaluate_ode(), strict=True))
    assert rates["p_U(t)"] > 0.0 > rates["p(t)"]


def test_any_tire_will_do():
    tire = BrushTire(500.0, stiffness=1e4, friction=0.8, half_length=0.04)
    system = bicycle(BENCHMARK, tire, relaxation_lengths=(0.1, 0.2))
    states = {"phi": 0.1, "delta": 0.02, "e_y_f": 0.002, "e_y_r": -0.003}
    values = outputs(system, states)
    for end, side in (("f", -1.0), ("r", 1.0)):
        inputs = (values[f"{name}_{end}"] for name in ("Fz", "kappa", "alpha", "gamma"))
        force = tire.forces(*inputs).Fy
        assert values[f"Fy_{end}"] == pytest.approx(force, rel=1e-12)
        assert force * side > 20.0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"relaxation_lengths": (0.2, 0.2)}, "`tires` is None"),
        ({"vertical_stiffness": (1e5,)}, "`vertical_stiffness` must be a pair"),
        ({"vertical_damping": -1.0}, "`vertical_damping` must"),
        ({"speed": -1.0}, "`speed` must"),
        ({"rider": BENCHMARK.rear_frame}, "`rider` must"),
        ({"tires": 3.0}, "`tires` must"),
    ],
)
def test_arguments_are_checked(arguments, message):
    with pytest.raises((TypeError, ValueError), match=message):
        bicycle(BENCHMARK, **arguments)


def test_constants_are_checked():
    with pytest.raises(TypeError, match="`vehicle` must be a Motorcycle"):
        motorcycle(BENCHMARK)
    with pytest.raises(ValueError, match="`Ixz` must be smaller"):
        FrameBody(1.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.5)
    with pytest.raises(ValueError, match="`crown_radius` must be smaller"):
        WheelBody(0.3, 1.0, 0.1, crown_radius=0.3)
    with pytest.raises(ValueError, match="`steer_axis_tilt` must be between"):
        replace(BENCHMARK, steer_axis_tilt=2.0)
    with pytest.raises(TypeError, match="`front_wheel` must"):
        replace(BENCHMARK, front_wheel=0.3)


def test_the_scene_of_a_motorcycle_takes_few_calls():
    machine = motorcycle(SHARP)
    with cProfile.Profile() as profile:
        machine.scene()
    # 0.55 million; minutes where SymPy differentiates and prints the forces of the tires.
    assert pstats.Stats(profile).total_calls < 1.5e6


def test_wheels_let_a_motorcycle_lean_more_in_a_steady_turn():
    """Their gyroscopic moments add (J_f + J_r)/(R m h) to tan(lean)/(u²/(g radius))."""
    machine = motorcycle(SHARP)
    speed, radius = 15.0, 6000.0
    machine.initial_conditions = {**machine.initial_conditions, "u": speed, "r": speed / radius}
    given = {"x", "y", "psi", "u", "r"}
    unknowns = [s for s in machine.states if s.name not in given] + ["T_delta", "T_r"]
    leans, spins = [], (machine.constants["J_f"], machine.constants["J_r"])
    for share in (1.0, 0.5):
        machine.constants["J_f"], machine.constants["J_r"] = (share * J for J in spins)
        turn = machine.find_equilibrium(unknowns, moving=["x", "y", "psi"])
        leans.append(-np.tan(turn["phi"]) * 9.81 * radius / speed**2)
        assert abs(leans[-1] - 1.0) < 0.04
    c = machine.constants
    moment = c["m_B"] * c["z_B"] + c["m_H"] * c["z_H"]  # its wheels' masses are in the frames
    assert leans[0] - leans[1] == pytest.approx(0.5 * sum(spins) / (c["R_f"] * moment), rel=1e-3)
