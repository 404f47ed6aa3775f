"""The double-track car on springs: equilibrium, load transfer, vibrations and energy."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy as sm

from pydy.vehicles import CARS, LinearTire, TireForces, steady_turn
from pydy.vehicles.sprung_car import _Mirrored
from pydy.vehicles.suspensions import SPRUNG_AXLES, SprungAxles, sprung_double_track

G = 9.81
CAR, AXLES = CARS["bmw_320i"], SPRUNG_AXLES["bmw_320i"]
FRONT, REAR = CAR.front_track, CAR.rear_track
CORNERS = (
    (CAR.front, FRONT / 2),
    (CAR.front, -FRONT / 2),
    (-CAR.rear, REAR / 2),
    (-CAR.rear, -REAR / 2),
)
SPRINGS = [AXLES.front_spring] * 2 + [AXLES.rear_spring] * 2
DAMPERS = [AXLES.front_damping] * 2 + [AXLES.rear_damping] * 2
BARS = (AXLES.front_bar / FRONT**2, AXLES.rear_bar / REAR**2)
MASSES = [AXLES.front_unsprung / 2] * 2 + [AXLES.rear_unsprung / 2] * 2
SPRUNG = CAR.mass - sum(MASSES)
AHEAD = -sum(m * x for m, (x, _) in zip(MASSES, CORNERS, strict=True)) / SPRUNG
ABOVE = sum(MASSES) * (CAR.height - CAR.wheel_radius) / SPRUNG
LOADS = [CAR.mass * G * d / CAR.wheelbase / 2 for d in (CAR.rear, CAR.rear, CAR.front, CAR.front)]
WHEELS = ("fl", "fr", "rl", "rr")
INPUTS = {"delta": 0.0, "T_drive": 0.0, "T_brake": 0.0}


@cache
def derived(frictionless):
    tire = LinearTire(3000.0, 0.0) if frictionless else None
    return sprung_double_track(CAR, AXLES, tire)


def car(frictionless=False, start=None, **constants):
    """Return the System with its usual values, but for some."""
    system = derived(frictionless)
    fresh = sprung_values()
    system.constants = {**fresh[0], **constants}
    system.initial_conditions = {**fresh[1], **(start or {})}
    system.specifieds = INPUTS
    system.times = np.linspace(0.0, 2.0, 201)
    return system


@cache
def sprung_values():
    system = derived(False)
    return dict(system.constants), {
        str(k).removesuffix("(t)"): v for k, v in system.initial_conditions.items()
    }


def values_of(system, state=None):
    outputs = system.evaluate_outputs() if state is None else system.evaluate_outputs(state)
    return dict(zip((str(o) for o in system.outputs), outputs, strict=True))


def vertical_matrices():
    """Return masses and stiffnesses for u, v, r, and z, θ, φ and the four travels.

    The stiffness is the Hessian of the potential energy. The road's force acts where the wheel
    plane meets the road, at the distance of the loaded radius, about which the wheel tilts.
    """
    z, theta, phi = sm.symbols("z theta phi")
    travel = sm.symbols("z:4")
    unknown = (z, theta, phi, *travel)

    def height(x, y, up):
        down = -sm.sin(theta) * x + sm.cos(theta) * (sm.sin(phi) * y + sm.cos(phi) * up)
        return CAR.height + z + down

    energy = SPRUNG * G * height(AHEAD, 0, ABOVE)
    for (x, y), c, k, mass, load in zip(CORNERS, travel, SPRINGS, MASSES, LOADS, strict=True):
        center = height(x, y, CAR.wheel_radius - CAR.height + c)
        radius = CAR.wheel_radius + load / AXLES.tire_stiffness
        gap = center - radius
        gap += CAR.wheel_radius * (1 - sm.sqrt(1 - (sm.sin(phi) * sm.cos(theta)) ** 2))
        energy += mass * G * center + AXLES.tire_stiffness * gap**2 / 2
        energy += (load - mass * G) * c + k * c**2 / 2
    for bar, (left, right) in zip(BARS, (travel[:2], travel[2:]), strict=True):
        energy += bar * (left - right) ** 2 / 2
    zero = dict.fromkeys(unknown, 0)
    gradient = [float(energy.diff(q).subs(zero)) for q in unknown]
    assert np.abs(gradient).max() < 1e-9 * CAR.mass * G  # an equilibrium
    hessian = np.array(sm.hessian(energy, unknown).subs(zero), float)
    # Columns of the velocities of mass centers and of the angular velocity: u, v, r, w, q, p, w_i.
    yaw_sprung = CAR.yaw_inertia - SPRUNG * AHEAD**2
    yaw_sprung -= sum(m * (x * x + y * y) for m, (x, y) in zip(MASSES, CORNERS, strict=True))
    turning = np.zeros((3, 10))
    turning[2, 2], turning[1, 4], turning[0, 5] = 1.0, 1.0, 1.0
    inertia = np.diag([AXLES.roll_inertia, AXLES.pitch_inertia, yaw_sprung])
    mass = turning.T @ inertia @ turning
    places = [(SPRUNG, (AHEAD, 0.0, ABOVE), None)]
    places += [
        (m, (x, y, CAR.wheel_radius - CAR.height), 6 + i)
        for i, (m, (x, y)) in enumerate(zip(MASSES, CORNERS, strict=True))
    ]
    for m, arm, own in places:
        velocity = np.zeros((3, 10))
        velocity[0, 0] = velocity[1, 1] = velocity[2, 3] = 1.0
        velocity += np.cross(turning.T, arm).T
        if own is not None:
            velocity[2, own] += 1.0
        mass += m * velocity.T @ velocity
    stiffness = np.zeros((10, 10))
    stiffness[3:, 3:] = hessian
    return mass, stiffness


def test_at_rest_each_wheel_has_its_static_load():
    system = car(start={"u": 15.0, **{f"omega_{w}": 15.0 / CAR.wheel_radius for w in WHEELS}})
    outputs = values_of(system)
    assert [outputs[f"Fz_{w}"] for w in WHEELS] == pytest.approx(LOADS, rel=1e-12)
    rates = np.asarray(system.evaluate_ode())
    assert rates[0] == 15.0
    assert np.abs(rates[1:]).max() < 1e-9


def test_its_vibrations_are_those_of_the_closed_form():
    system = car(frictionless=True, start={"u": 0.0, **{f"omega_{w}": 0.0 for w in WHEELS}},
                 c_f=0.0, c_r=0.0)  # fmt: skip
    values = system.linearize().eigenvalues
    mass, stiffness = vertical_matrices()
    squares = np.linalg.eigvals(np.linalg.solve(mass, stiffness))
    frequencies = np.sqrt(np.sort(squares.real)[3:])  # three motions in the plane are free
    # Heave, pitch and roll of the body, and four wheels.
    assert (frequencies[:3] < 2 * np.pi * 3.0).all()
    assert (frequencies[3:] > 2 * np.pi * 7.0).all()
    measured = np.sort(values.imag[values.imag > 1.0])
    assert measured == pytest.approx(frequencies, rel=1e-9)


def test_a_symmetric_car_heaves_pitches_and_rolls_as_masses_on_springs_in_series():
    # Without unsprung mass: each corner is the spring and the tire in series.
    half, light = 1.3, 1e-3
    even = replace(CAR, front=half, rear=half, rear_track=FRONT)
    k, bar, tire = 25e3, 3e3, 2e5
    axles = SprungAxles(k, k, 0.0, 0.0, bar, bar, light, light, 250.0, 1500.0, tire)
    system = car(
        frictionless=True, start={"u": 0.0, **{f"omega_{w}": 0.0 for w in WHEELS}},
        a=half, b=half, T_r=FRONT, k_f=k, k_r=k, c_f=0.0, c_r=0.0, K_f=bar, K_r=bar,
        m_uf=light, m_ur=light, I_x=axles.roll_inertia, I_y=axles.pitch_inertia, k_t=tire,
    )  # fmt: skip
    values = system.linearize().eigenvalues
    slow = np.sort(values.imag[(values.imag > 1.0) & (values.imag < 60.0)])
    corner = 1 / (1 / k + 1 / tire)
    heave = 4 * corner / even.mass
    pitch = 4 * corner * half**2 / axles.pitch_inertia
    # Each axle with its bar in series with its tires; the weight tilts by the height of the center.
    axle = 1 / (1 / (k * FRONT**2 / 2 + bar) + 2 / (tire * FRONT**2))
    weight = even.mass * G
    roll = (2 * axle - weight * even.height) / axles.roll_inertia
    # The weight acts at the deflected tires: corrections of the order of the weight times lengths.
    expected = np.sqrt(np.sort([heave, pitch, roll]))
    order = np.argsort([heave, pitch, roll])
    assert slow[list(order).index(0)] == pytest.approx(np.sqrt(heave), rel=1e-6)
    assert slow == pytest.approx(expected, rel=0.05)


def test_in_a_steady_turn_it_rolls_and_transfers_load_by_the_roll_stiffnesses():
    system = car(J=1e-3)  # the wheels' gyroscopic moments would add some per cent
    target = 0.2
    turn = steady_turn(system, 200.0, [0.1, target, 0.3], inputs=("delta", "T_drive"))
    state = turn.states[1]
    names = [str(s).removesuffix("(t)") for s in system.states]
    at = dict(zip(names, state, strict=True))
    # Inertia forces at the heights of the masses and the tires' at the road: the moment m a h.
    _, stiffness = vertical_matrices()
    moment = np.zeros(7)
    moment[2] = CAR.mass * target * CAR.height
    expected = np.linalg.solve(stiffness[3:, 3:], moment)
    assert at["phi"] == pytest.approx(expected[2], rel=0.02)
    for i, wheel in enumerate(WHEELS):
        assert at[f"z_{wheel}"] == pytest.approx(expected[3 + i], rel=0.03)
    # Springs and bars of an axle carry its load transfer.
    front = AXLES.front_spring * FRONT**2 / 2 + AXLES.front_bar
    rear = AXLES.rear_spring * REAR**2 / 2 + AXLES.rear_bar
    transfers = [front * (at["z_fr"] - at["z_fl"]) / FRONT, rear * (at["z_rr"] - at["z_rl"]) / REAR]
    loads = -AXLES.tire_stiffness * np.array(
        [expected[0] + y * expected[2] + expected[3 + i] for i, (_, y) in enumerate(CORNERS)]
    )
    measured = [(loads[1] - loads[0]) * FRONT / 2, (loads[3] - loads[2]) * REAR / 2]
    assert transfers == pytest.approx(measured, rel=0.03)
    # Both together carry the moment and that of the tilted weight, by the share of the car.
    assert sum(transfers) > CAR.mass * target * CAR.height
    assert transfers[0] / sum(transfers) == pytest.approx(CAR.front_roll_share, rel=0.04)


def test_the_roll_share_of_the_cars_is_that_of_their_springs_and_bars():
    for name, axles in SPRUNG_AXLES.items():
        one = CARS[name]
        front = axles.front_spring * one.front_track**2 / 2 + axles.front_bar
        rear = axles.rear_spring * one.rear_track**2 / 2 + axles.rear_bar
        assert front / (front + rear) == pytest.approx(one.front_roll_share, rel=1e-12)


def test_under_braking_it_pitches_by_the_moment_of_its_deceleration():
    system = car(J=1e-3)
    system.specifieds = {**INPUTS, "T_brake": 400.0}
    system.times = np.linspace(0.0, 3.0, 31)
    motion = system.simulate()
    deceleration = -motion["a_x"][-1]
    assert deceleration == pytest.approx(400.0 / CAR.wheel_radius / CAR.mass, rel=0.01)
    _, stiffness = vertical_matrices()
    moment = np.zeros(7)
    moment[1] = CAR.mass * deceleration * CAR.height
    expected = np.linalg.solve(stiffness[3:, 3:], moment)
    assert motion["theta"][-1] == pytest.approx(expected[1], rel=0.01)
    transfer = CAR.mass * deceleration * CAR.height / CAR.wheelbase / 2
    # The contact points move to the rear as the body pitches, by some per cent of the transfer.
    assert motion["Fz_fl"][-1] - LOADS[0] == pytest.approx(transfer, rel=0.03)
    for i, wheel in enumerate(WHEELS):
        deflection = expected[0] - CORNERS[i][0] * expected[1] + expected[3 + i]
        change = motion[f"Fz_{wheel}"][-1] - LOADS[i]
        assert change == pytest.approx(-AXLES.tire_stiffness * deflection, rel=0.01)


@pytest.mark.parametrize("damped", [False, True])
def test_energy_changes_by_what_the_dampers_take(damped):
    # Without roll: a tire that tilts moves the force of the road within its flattened part.
    # Without roll: a tire that tilts moves the force of the road within its flattened part.
    start = {"u": 3.0, "v": 0.5, "w": 0.2, "q": -0.2, "w_fl": 0.3, "w_fr": 0.3}
    start |= {f"omega_{w}": 9.0 for w in WHEELS}
    system = car(frictionless=True, start=start, **({} if damped else {"c_f": 0.0, "c_r": 0.0}))
    system.times = np.linspace(0.0, 0.5, 501)
    motion = system.simulate(rtol=1e-10, atol=1e-10)
    energy = np.array([mechanical(system, x) for x in motion.states[::50]])
    power = sum(c * motion[f"w_{w}"] ** 2 for c, w in zip(DAMPERS, WHEELS, strict=True))
    lost = np.concatenate([[0.0], np.cumsum((power[1:] + power[:-1]) / 2 * 1e-3)])[::50]
    scale = np.ptp(motion["z"]) * CAR.mass * G
    expected = energy[0] - (lost if damped else 0.0)
    assert energy == pytest.approx(expected, abs=(1e-3 if damped else 1e-6) * scale)
    assert min(motion[f"Fz_{w}"].min() for w in WHEELS) > 0.0


def mechanical(system, x):
    """Return the energy of all masses and springs, from their positions and velocities."""
    names = [str(s).removesuffix("(t)") for s in system.states]
    at = dict(zip(names, x, strict=True))
    sin, cos = np.sin, np.cos
    th, ph = at["theta"], at["phi"]
    pitch = np.array([[cos(th), 0, sin(th)], [0, 1, 0], [-sin(th), 0, cos(th)]])
    roll = np.array([[1, 0, 0], [0, cos(ph), -sin(ph)], [0, sin(ph), cos(ph)]])
    B = pitch @ roll  # columns are the body's axes, in those of the heading
    turning = np.array([0, 0, at["r"]]) + at["q"] * np.array([0, 1, 0]) + at["p"] * pitch[:, 0]
    start = np.array([at["u"], at["v"], at["w"]])
    yaw = CAR.yaw_inertia - SPRUNG * AHEAD**2
    yaw -= sum(m * (a * a + b * b) for m, (a, b) in zip(MASSES, CORNERS, strict=True))
    inertia = B @ np.diag([AXLES.roll_inertia, AXLES.pitch_inertia, yaw]) @ B.T
    arm = B @ [AHEAD, 0.0, ABOVE]
    velocity = start + np.cross(turning, arm)
    energy = SPRUNG * (velocity @ velocity / 2 + G * (at["z"] + arm[2]))
    energy += turning @ inertia @ turning / 2
    travels = [at[f"z_{w}"] for w in WHEELS]
    for i, w in enumerate(WHEELS):
        forward, left = CORNERS[i]
        arm = B @ [forward, left, CAR.wheel_radius - CAR.height + travels[i]]
        velocity = start + np.cross(turning, arm) + at[f"w_{w}"] * B[:, 2]
        energy += MASSES[i] * (velocity @ velocity / 2 + G * (at["z"] + arm[2]))
        about = turning @ B[:, 1] + at[f"omega_{w}"]
        energy += CAR.wheel_inertia * about**2 / 2
        radius = CAR.wheel_radius + LOADS[i] / AXLES.tire_stiffness
        gap = CAR.height + at["z"] + arm[2] - radius * np.sqrt(1 - B[2, 1] ** 2)
        energy += AXLES.tire_stiffness * gap**2 / 2
        energy += (LOADS[i] - MASSES[i] * G) * travels[i] + SPRINGS[i] * travels[i] ** 2 / 2
    for bar, k in zip(BARS, (0, 2), strict=True):
        energy += bar * (travels[k] - travels[k + 1]) ** 2 / 2
    return energy


class OneSidedTire:
    """A tire without any symmetry: all slips and constants in all forces."""

    def forces(self, Fz, kappa, alpha, gamma=0.0, **conditions):
        slips = np.array([1.0, Fz, kappa, alpha, gamma])
        return TireForces(*np.random.default_rng(0).uniform(1.0, 2.0, (5, 5)) @ slips)


def test_the_tires_of_the_other_side_are_mirror_images():
    """In y → −y forces are mirrored as vectors, torques and angles as those of a rotation."""
    tire, slips = OneSidedTire(), (0.3, 0.2, 0.1)  # κ, α, γ
    Fx, Fy, Mx, My, Mz = tire.forces(3.0, *slips)
    mirror = np.diag([1.0, -1.0, 1.0])
    force = mirror @ (Fx, Fy, 0.0)
    torque = np.linalg.det(mirror) * mirror @ (Mx, My, Mz)
    image = _Mirrored(tire).forces(3.0, slips[0], -slips[1], -slips[2])
    assert image == pytest.approx((*force[:2], *torque))


def test_unsprung_masses_that_are_too_large_are_refused():
    with pytest.raises(ValueError, match="`axles` must have unsprung masses below the mass of the"):
        sprung_double_track(CAR, replace(AXLES, front_unsprung=2000.0))
    with pytest.raises(ValueError, match="unsprung masses whose yaw inertia is below"):
        sprung_double_track(replace(CAR, yaw_inertia=200.0), AXLES)
    with pytest.raises(TypeError, match="`axles` must be SprungAxles"):
        sprung_double_track(CAR, CAR)
    with pytest.raises(ValueError, match="`rear_spring` must be positive"):
        replace(AXLES, rear_spring=0.0)
