"""Models of cars against CommonRoad's package, which writes them out in Python.

`pydy.vehicles.commonroad_car` and commonroad-vehicle-models: derivatives along four manoeuvres of
each car, their trajectories, and evaluations per second of processor time: of one state for each
call from Python, and of 4,096 states in one call here; trajectories by DOP853 of SciPy there. Fails
where derivatives or trajectories differ by more than 1e-6 of the size of a quantity, which is taken
as at least one. A motion of MB is compared until a wheel that has stopped starts again, which it
never does there; a column has that time.

Then the four manoeuvres as users of that package drive them, by `odeint` with its own tolerances
over the Python function, at 101 times; here by `System.integrate`, at the loosest tolerance whose
error is no larger, with the fastest of three solvers. Times are the least of several runs in turn.
Where `odeint` fails, at a wheel that stops, there is no ratio.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from functools import partial
from itertools import product
from typing import Any

import numpy as np
from harness.driver import Worker, in_turn
from harness.options import add_measuring, add_pythons, rounds
from harness.report import pairwise, save, table
from harness.serve import processor_time

from pydy.solvers import dop853, radau, tsit5
from pydy.vehicles import CARS, commonroad_car

TOLERANCE = 1e-6
SPEED, MANY = 15.0, 4096
STOPPED = 1e-3  # rad/s, of a wheel
# The states of MB in the order of the other package.
MB = (
    *("x", "y", "delta", "u", "psi", "r", "phi", "p", "theta", "q", "v", "z", "w"),
    *("phi_f", "p_f", "v_f", "z_f", "w_f", "phi_r", "p_r", "v_r", "z_r", "w_r"),
    *("omega_fl", "omega_fr", "omega_rl", "omega_rr", "y_f", "y_r"),
)
PATIENCE = 15.0  # s, until code is compiled for the last time
TIMES = np.linspace(0.0, 1.0, 21)
SHOWN = np.linspace(0.0, 1.0, 101)  # the times of a manoeuvre, as in the package's examples
TOLERANCES = tuple(float(f"{digit}e-{power}") for power in range(6, 12) for digit in (1, 0.3))
SOLVERS = (dop853, tsit5, radau)
FAILED = 1e-3  # an error that no tolerance of 1e-8 explains
# The steering rate (rad/s) and the acceleration (m/s²), constant for one second.
MANOEUVRES = {
    "cornering": (0.15, 0.0),
    "braking": (0.15, -0.5 * 9.81),
    "accelerating": (0.15, 0.63 * 9.81),
    "oversteer": (0.4, -0.35 * 9.81),  # braked while the steering turns, the tail comes out
}


class Ours:
    """One model here, with the states in the order of the other package."""

    def __init__(self, vehicle: str, model: str) -> None:
        self.model = model
        self.system = commonroad_car(vehicle, model, speed=SPEED)
        names = [str(state).removesuffix("(t)") for state in self.system.states]
        self.order = [names.index(name) for name in MB] if model == "MB" else []

    def _theirs(self, x: np.ndarray) -> np.ndarray:
        """Return x, y, δ, v, ψ, ψ', β, and the speeds of the wheels for STD; `MB`."""
        if self.model == "MB":
            return x[..., self.order]
        if self.model == "ST":
            return x[..., [0, 1, 2, 5, 3, 6, 4]]
        u, v = x[..., 4], x[..., 5]
        speed, beta = np.hypot(u, v), np.arctan2(v, u)
        columns = (x[..., 0], x[..., 1], x[..., 3], speed, x[..., 2], x[..., 6], beta)
        return np.stack([*columns, x[..., 7], x[..., 8]], axis=-1)

    def _their_rates(self, x: np.ndarray, dx: np.ndarray) -> np.ndarray:
        if self.model != "STD":
            return self._theirs(dx)
        result, (u, v), (du, dv) = self._theirs(dx), x[:, [4, 5]].T, dx[:, [4, 5]].T
        result[:, 3] = (u * du + v * dv) / np.hypot(u, v)
        result[:, 6] = (u * dv - v * du) / (u**2 + v**2)
        return result

    def motion(self, inputs: tuple[float, float]) -> tuple[np.ndarray, np.ndarray]:
        """Return the states along a manoeuvre and their derivatives, as far as models agree."""
        r = dict(zip(("v_delta", "a_long"), inputs, strict=True))
        self.system.specifieds = r
        self.system.times, self.system.ode_solver = TIMES, dop853
        x = self.system.simulate(rtol=1e-11, atol=1e-11).states
        if self.model == "MB":
            spins = x[:, [k for k, name in zip(self.order, MB, strict=True) if "omega" in name]]
            stopped = np.logical_or.accumulate(spins < STOPPED, axis=0)
            again = (stopped & (spins > STOPPED)).any(axis=1)
            x = x[: int(np.argmax(again)) or None]
        return self._theirs(x), self._their_rates(x, self.system.evaluate_ode(x, TIMES[: len(x)]))

    def simulated(self, solver: Any, tolerance: float) -> np.ndarray:
        """Return the states of the manoeuvre that `motion` chose."""
        self.system.ode_solver = solver
        return self._theirs(self._simulation(tolerance)())

    def _simulation(self, tolerance: float) -> Callable[[], Any]:
        return partial(self.system.integrate, rtol=tolerance, atol=tolerance)

    def manoeuvre(
        self, theirs: np.ndarray, times: np.ndarray
    ) -> tuple[float, float, str, Callable[[], Any]]:
        """Return their error and ours, how we simulate, and that simulation, to be timed."""
        self.system.times = times
        exact = self.simulated(dop853, 1e-13)
        limit, found = difference(theirs, exact), []
        for solver in SOLVERS:
            for tolerance in TOLERANCES:
                error = difference(self.simulated(solver, tolerance), exact)
                if error <= (limit if limit < FAILED else 1e-6):
                    seconds = processor_time(self._simulation(tolerance))
                    found.append((seconds, error, tolerance, solver))
                    break
        _, error, tolerance, solver = min(found, key=lambda entry: entry[0])
        self.system.ode_solver = solver
        return limit, error, f"{solver.name} {tolerance:.0e}", self._simulation(tolerance)

    def prepare(self) -> None:
        """Compile what `seconds` calls, the faster code that follows later included."""
        system = self.system
        self.rhs, problem = system.generate_ode_function(), system._now()
        self.one, self.p = np.array(problem.x), np.array(problem.p)
        self.one[-3:] *= 1.01  # the car turns and the wheels slip a little
        self.calls: dict[str, Callable[[], Any]] = {
            "alone": lambda: self.rhs(self.one, 0.0, np.zeros(2), self.p),
            "many": partial(system.evaluate_ode, np.tile(self.one, (MANY, 1)), np.zeros(MANY)),
            "trajectory": partial(system.simulate, rtol=1e-11, atol=1e-11),
        }
        end = time.perf_counter() + PATIENCE
        while time.perf_counter() < end:
            for call in self.calls.values():
                call()

    def seconds(self) -> dict[str, float]:
        """Return how long one evaluation takes, in a call of its own and in one of many."""
        taken = {name: processor_time(call) for name, call in self.calls.items()}
        return {**taken, "many": taken["many"] / MANY}


def difference(one: np.ndarray, other: np.ndarray) -> float:
    """Return the largest difference, relative to the largest value of its column, at least one."""
    scale = np.maximum(np.abs(other).max(axis=0), 1.0)
    return float((np.abs(one - other) / scale).max())


def manoeuvres(
    ours: Ours, worker: Worker, about: dict[str, Any], options: argparse.Namespace
) -> list[list[str]]:
    """Return a row for each manoeuvre: errors, tolerance, times and their ratio."""
    rows = []
    for name, inputs in MANOEUVRES.items():
        states = ours.motion(inputs)[0]
        times = SHOWN[TIMES[len(states) - 1] >= SHOWN]
        asked = {**about, "inputs": inputs, "start": states[0].tolist(), "times": times.tolist()}
        theirs = np.array(worker.ask("manoeuvre", **asked))
        limit, error, chosen, call = ours.manoeuvre(theirs, times)
        measures = {
            "theirs": lambda asked=asked: worker.ask("manoeuvre_seconds", **asked),
            "ours": lambda call=call: processor_time(call),
        }
        taken = in_turn(measures, **rounds(options, most=7))
        there, here = (min(x[who] for x in taken) for who in measures)
        cells = (f"{limit:.0e}", f"{error:.0e}", chosen, f"{1e3 * there:.1f}", f"{1e3 * here:.2f}")
        rows.append([name, *cells, f"{there / here:.0f}" if limit < FAILED else "fails"])
    return rows


def main() -> None:
    """Compare, measure, and print a table of both."""
    parser = argparse.ArgumentParser(description=__doc__)
    add_pythons(parser, "--peer-python")
    add_measuring(parser, budget=5.0, timeout=120.0)
    parser.add_argument("--vehicles", nargs="+", default=list(CARS), choices=list(CARS))
    options = parser.parse_args()
    agreement, speed, driven = [], [], []
    worst = 0.0
    with Worker(
        "commonroad", options.peer_python, "commonroad.py", timeout=options.timeout
    ) as worker:
        numbers = {vehicle: number for number, vehicle in enumerate(CARS, 1)}
        for vehicle, model in product(options.vehicles, ("ST", "STD", "MB")):
            number, ours = numbers[vehicle], Ours(vehicle, model)
            about: dict[str, Any] = {"vehicle": number, "model": model}
            for name, inputs in MANOEUVRES.items():
                states, rates = ours.motion(inputs)
                asked = {**about, "inputs": inputs}
                their_rates = worker.ask("rates", states=states.tolist(), **asked)
                start, times = states[0].tolist(), TIMES[: len(states)].tolist()
                motion = worker.ask("motion", start=start, times=times, **asked)
                pair = [
                    difference(rates, np.array(their_rates)),
                    difference(states, np.array(motion)),
                ]
                worst = max(worst, *pair)
                until = f"{times[-1]:.2f}"
                agreement.append([vehicle, model, name, *(f"{v:.0e}" for v in pair), until])
            ours.motion(MANOEUVRES["cornering"])  # whose inputs stay
            ours.prepare()
            asked = {**about, "state": states[0].tolist(), "inputs": MANOEUVRES["cornering"]}
            measures = {
                "ours": ours.seconds,
                "theirs": lambda asked=asked: worker.ask("seconds", **asked, times=TIMES.tolist()),
            }
            taken = in_turn(measures, **rounds(options, most=7))
            kinds = (("alone", "alone"), ("many", "alone"), ("trajectory", "trajectory"))
            ratios = [
                pairwise([x["theirs"][k] for x in taken], [x["ours"][j] for x in taken])
                for j, k in kinds
            ]
            speed.append([vehicle, model, *(f"{ratio:.0f}" for ratio in ratios)])
            driven += [[vehicle, model, *row] for row in manoeuvres(ours, worker, about, options)]
    save("vehicle_models", {"agreement": agreement, "speed": speed, "manoeuvres": driven})
    header = ("car", "model", "manoeuvre", "derivatives", "trajectory", "until (s)")
    table("Largest relative differences", header, agreement)
    header = ("car", "model", "one state a call", f"{MANY} states a call", "trajectory")
    table("How many times faster than CommonRoad's, by processor time", header, speed)
    header = ("car", "model", "manoeuvre", "their error", "ours", "solver", "their ms", "ours",
              "times faster")  # fmt: skip
    table("Manoeuvres by odeint there, at equal error, by least processor time", header, driven)
    if not worst < TOLERANCE:
        sys.exit(f"differs by {worst:.1e}")


if __name__ == "__main__":
    main()
