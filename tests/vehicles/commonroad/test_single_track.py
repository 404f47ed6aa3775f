"""CommonRoad's single-track models against the package of its authors."""

import numpy as np
import pytest

from pydy.vehicles import CARS, commonroad_car, linear_handling

# Derivatives by commonroad-vehicle-models 3.0.2 at x, y, δ, v, ψ, ψ', β and, for STD, the speeds of
# the wheels; inputs 0.15 rad/s and −3 m/s². `benchmarks/vehicle_models.py` compares manoeuvres.
STATE = [1.0, 2.0, 0.05, 15.0, 0.3, 0.2, -0.04]
WHEELS = [42.0, 43.0]
RATES = {
    ("ford_escort", "ST"): [
        14.495849672017698, 3.8562082783823266, 0.15, -3.0,
        0.2, 3.807929133391236, 0.845120647500637,
    ],
    ("ford_escort", "STD"): [
        14.495849672017698, 3.8562082783823266, 0.15, -4.652712557730425,
        0.2, 1.4822305733361962, 0.39167523393981146, 260.4564137031817,
        -21.002689366627646,
    ],
    ("bmw_320i", "ST"): [
        14.495849672017698, 3.8562082783823266, 0.15, -3.0,
        0.2, 2.9316474865681537, 0.7851484086331153,
    ],
    ("bmw_320i", "STD"): [
        14.495849672017698, 3.8562082783823266, 0.15, -4.446384025654274,
        0.2, 1.1585674894171436, 0.38265093283014356, 219.55013591204172,
        -41.06516938000803,
    ],
    ("vw_vanagon", "ST"): [
        14.495849672017698, 3.8562082783823266, 0.15, -3.0,
        0.2, 3.421404230325037, 0.780830235858725,
    ],
    ("vw_vanagon", "STD"): [
        14.495849672017698, 3.8562082783823266, 0.15, -4.604590549317624,
        0.2, 1.463122879299423, 0.38015900349908877, 354.60810426033544,
        -66.71963336801562,
    ],
}  # fmt: skip


def state_of(system, model, values):
    """Return a state of a System that has the values of CommonRoad's state."""
    x, y, delta, v, psi, r, beta, *wheels = values
    if model == "ST":
        return [x, y, delta, psi, beta, v, r]
    return [x, y, psi, delta, v * np.cos(beta), v * np.sin(beta), r, *wheels]


def rates_of(model, state, rates):
    """Return derivatives in CommonRoad's order."""
    if model == "ST":
        return rates[[0, 1, 2, 5, 3, 6, 4]]
    (u, v), (du, dv) = state[4:6], rates[4:6]
    speed = np.hypot(u, v)
    path = (u * du + v * dv) / speed, (u * dv - v * du) / speed**2
    return np.array([*rates[[0, 1, 3]], path[0], rates[2], rates[6], path[1], *rates[7:]])


@pytest.mark.parametrize(("vehicle", "model"), RATES)
def test_derivatives_are_those_of_the_package(vehicle, model):
    system = commonroad_car(vehicle, model)
    values = STATE if model == "ST" else STATE + WHEELS
    state = state_of(system, model, values)
    inputs = {"v_delta": 0.15, "a_long": -3.0}
    found = rates_of(model, state, system.evaluate_ode(state, r=inputs))
    assert found == pytest.approx(np.array(RATES[vehicle, model]), rel=1e-11, abs=1e-12)


@pytest.mark.parametrize("vehicle", CARS)
def test_without_acceleration_the_linear_gains_are_those_of_the_closed_forms(vehicle):
    # `CARS` has the stiffnesses of this model.
    system = commonroad_car(vehicle, speed=18.0)
    linear = system.linearize(outputs=["v", "r", "beta"])
    moving = [linear.states.index(name) for name in ("beta", "r")]
    steered = linear.A[np.ix_(moving, [linear.states.index("delta")])]
    gains = -np.linalg.solve(linear.A[np.ix_(moving, moving)], steered)[:, 0]
    handling = linear_handling(CARS[vehicle], 18.0)
    assert gains == pytest.approx([*handling.sideslip_gain, *handling.yaw_rate_gain], rel=1e-9)


@pytest.mark.parametrize("model", ["ST", "STD"])
def test_the_inputs_are_limited(model):
    system = commonroad_car("bmw_320i", model, speed=20.0)
    state = [system.initial_conditions.get(s, 0.0) for s in system.states]
    within = {"v_delta": 0.4, "a_long": 11.5 * 7.319 / 20.0}
    limit = system.evaluate_ode(state, r=within)
    beyond = system.evaluate_ode(state, r={"v_delta": 3.0, "a_long": 9.0})
    assert beyond == pytest.approx(limit)
    less = system.evaluate_ode(state, r={"v_delta": 0.3, "a_long": 4.0})
    driven = {"ST": "v", "STD": "omega_r"}[model]
    changed = {str(s).removesuffix("(t)"): limit[k] - less[k] for k, s in enumerate(system.states)}
    assert changed["delta"] == pytest.approx(0.1)
    assert changed[driven] > 0.2


def test_a_braked_wheel_that_locks_does_not_turn_back():
    system = commonroad_car("vw_vanagon", "STD", speed=20.0)
    system.specifieds = {"v_delta": 0.0, "a_long": -8.0}
    motion = system.simulate()
    # The rear axle loses its load; its brake is weaker where the wheels nearly stand.
    assert 0.0 < motion["omega_r"][-1] < 0.3
    assert motion["kappa_r"][-1] == pytest.approx(-1.0, abs=0.01)
    assert motion["omega_f"][-1] > 10.0
