"""The models of the package commonroad-vehicle-models."""

from __future__ import annotations

from typing import Any

import numpy as np
from harness.serve import processor_time, serve
from scipy.integrate import odeint, solve_ivp
from vehiclemodels.vehicle_dynamics_mb import vehicle_dynamics_mb
from vehiclemodels.vehicle_dynamics_st import vehicle_dynamics_st
from vehiclemodels.vehicle_dynamics_std import vehicle_dynamics_std
from vehiclemodels.vehicle_parameters import setup_vehicle_parameters

MODELS = {"ST": vehicle_dynamics_st, "STD": vehicle_dynamics_std, "MB": vehicle_dynamics_mb}


def rates(
    vehicle: int, model: str, states: list[list[float]], inputs: list[float]
) -> list[list[float]]:
    """Return the derivatives of states."""
    p = setup_vehicle_parameters(vehicle)
    return [list(map(float, MODELS[model](list(x), list(inputs), p))) for x in states]


def motion(
    vehicle: int, model: str, start: list[float], inputs: list[float], times: list[float]
) -> list[list[float]]:
    """Return the states at some times."""
    p, function = setup_vehicle_parameters(vehicle), MODELS[model]

    def derivative(_: float, x: np.ndarray) -> Any:
        return function(x.tolist(), list(inputs), p)

    span = (times[0], times[-1])
    found = solve_ivp(
        derivative, span, start, method="DOP853", t_eval=times, rtol=1e-11, atol=1e-11
    )
    return found.y.T.tolist()


def manoeuvre(
    vehicle: int, model: str, start: list[float], inputs: list[float], times: list[float]
) -> list[list[float]]:
    """Return the states at some times as the package's examples do: by `odeint` as it comes."""
    p, function = setup_vehicle_parameters(vehicle), MODELS[model]

    def derivative(x: Any, _: float, u: list[float], p: Any) -> Any:
        return function(x, u, p)

    return odeint(derivative, start, times, args=(inputs, p)).tolist()


def manoeuvre_seconds(**arguments: Any) -> float:
    """Return the processor time of `manoeuvre`."""
    return processor_time(lambda: manoeuvre(**arguments))


def seconds(
    vehicle: int, model: str, state: list[float], inputs: list[float], times: list[float]
) -> dict[str, float]:
    """Return the processor time of one evaluation, and of a trajectory."""
    p, function = setup_vehicle_parameters(vehicle), MODELS[model]
    return {
        "alone": processor_time(lambda: function(list(state), list(inputs), p)),
        "trajectory": processor_time(lambda: motion(vehicle, model, state, inputs, times)),
    }


if __name__ == "__main__":
    serve(
        {
            "rates": rates,
            "motion": motion,
            "seconds": seconds,
            "manoeuvre": manoeuvre,
            "manoeuvre_seconds": manoeuvre_seconds,
        }
    )
