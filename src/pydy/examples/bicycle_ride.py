"""The demo: a bicycle without a rider's help is pushed sideways, and everything is checked.

`ride` does the work and returns numbers, `draw` makes the figure, `animate` the page, `simulate`
the page that computes the motion itself; nothing is printed here.  Read `ride` from top to bottom
to see each part of `pydy.system.System` at work: constants, consistent initial conditions, a force
that is a Python function, outputs, constraint residuals, contact forces, and the exact linear
model.

Examples
--------
>>> from pydy.examples.bicycle_ride import push
>>> push(1.1)
300.0
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from math import pi, sin
from pathlib import Path
from time import perf_counter

import numpy as np
import sympy as sm

from pydy._files import replacing
from pydy.examples import bicycle_scene, whipple_bicycle
from pydy.linearize import constrained_eigenvalues
from pydy.solvers import Event
from pydy.system import System
from pydy.trajectory import Trajectory
from pydy.viz import Live, Scene, Slider

__all__ = ["Ride", "animate", "draw", "push", "ride", "simulate"]
__dir__ = __all__.copy

SPEED = 5.0  # m/s; the riderless bicycle is stable between 4.29 and 6.02 m/s
ROLL = STEER = 0.05  # rad at the start
ROLL_RATE = 0.2  # rad/s at the start
PUSH, PUSH_START, PUSH_END = 300.0, 1.0, 1.2  # N, s, s
TIMES = np.linspace(0.0, 5.0, num=501)
# A step of odeint could skip the push, hence the limit of its length.
SOLVER = {"rtol": 1e-10, "atol": 1e-10, "hmax": 0.02}
TITLE = f"Carvallo–Whipple bicycle at {SPEED:g} m/s, hands off: it recovers from a push"
LIVE_TITLE = "Carvallo–Whipple bicycle, hands off: slower than 4.29 m/s it sways, and falls"
FALLEN, STEERED = 0.8, 1.2  # rad of roll and of steer, where the ride ends
MODES = ("weave", "weave", "capsize", "castering")  # in the order they were published


@dataclass(frozen=True)
class Ride:
    """What the demo found.  Arrays over time have the shape (n,), n times.

    Attributes
    ----------
    states : Mapping of str to int
        How many coordinates, speeds and auxiliary states the system has.
    dependent : Mapping of str to float
        The initial conditions that the constraints determined, in rad, rad/s and m/s.
    times, force, roll, steer, roll_rate : ndarray
        In s, N, rad, rad and rad/s.
    contact_forces : ndarray, shape (n, 2)
        The ground's upward push on the rear and the front wheel, in N.
    static_forces : ndarray, shape (2,)
        The same when the bicycle rides straight ahead.
    weight : float
        In N.
    holonomic, velocity : ndarray
        The largest residual of the constraints, in m and m/s.
    energy : float
        In J, without the push, at the start.
    energy_drift, drift_off_ground : float
        Without the push: the largest change of energy relative to `energy`, and the largest
        residual of the holonomic constraint relative to the wheel base.
    eigenvalues, published : ndarray of complex, shape (4,)
        Of the linear model at `SPEED`, in 1/s, in the order of `MODES`.
    other_eigenvalues : ndarray of complex
        Those of position, heading, wheel angles, speed and auxiliary states: zero.
    seconds : Mapping of str to float
        How long each stage took.
    trajectory : pydy.trajectory.Trajectory
        The ride with the push.
    scene : pydy.viz.Scene
        The same, ready to be shown.
    bicycle : pydy.examples.whipple_bicycle.Bicycle
    system : pydy.system.System
        The model with the numbers of the ride.
    """

    states: Mapping[str, int]
    dependent: Mapping[str, float]
    times: np.ndarray
    force: np.ndarray
    roll: np.ndarray
    steer: np.ndarray
    roll_rate: np.ndarray
    contact_forces: np.ndarray
    static_forces: np.ndarray
    weight: float
    holonomic: np.ndarray
    velocity: np.ndarray
    energy: float
    energy_drift: float
    drift_off_ground: float
    eigenvalues: np.ndarray
    published: np.ndarray
    other_eigenvalues: np.ndarray
    seconds: Mapping[str, float]
    trajectory: Trajectory
    scene: Scene
    bicycle: whipple_bicycle.Bicycle
    system: System

    @property
    def eigenvalue_error(self) -> float:
        """The largest distance of an eigenvalue from the published one, in 1/s."""
        return float(np.abs(self.eigenvalues - self.published).max())


@contextmanager
def _stage(seconds: dict[str, float], name: str) -> Iterator[None]:
    """Note how long a stage takes."""
    start = perf_counter()
    yield
    seconds[name] = seconds.get(name, 0.0) + perf_counter() - start


def push(t: float) -> float:
    """Return the sideways push on the rear frame at a time: a smooth pulse, in N.

    Parameters
    ----------
    t : float
        In s.

    Returns
    -------
    float
        Zero but between `PUSH_START` and `PUSH_END`.
    """
    if not PUSH_START < t < PUSH_END:
        return 0.0
    return PUSH * sin(pi * (t - PUSH_START) / (PUSH_END - PUSH_START)) ** 2


def ride() -> Ride:
    """Derive the bicycle, ride it with and without the push, and linearise it.

    Returns
    -------
    Ride
        It takes a few seconds, most of them to derive the equations.
    """
    seconds: dict[str, float] = {}
    stage = partial(_stage, seconds)
    with stage("derive"):
        bicycle = whipple_bicycle.derive()
        kinetic, potential = whipple_bicycle.energy(bicycle)
    with stage("extract"):
        constants = whipple_bicycle.benchmark_parameters(bicycle)
        system = System(
            bicycle.definition,
            constants=constants,
            times=TIMES,
            outputs={sm.Symbol("energy"): kinetic + potential},
            noncontributing_forces=bicycle.contact_forces,
        )
    with stage("generate"):
        system.generate_ode_function()

    straight = whipple_bicycle.equilibrium(bicycle, SPEED)
    with stage("linearise"):
        system.initial_conditions = straight
        static = system.evaluate_outputs()[-2:]
        A = system.evaluate_jacobian()
        C = np.vstack([system.evaluate_jacobian(of=kind) for kind in ("holonomic", "velocity")])
        eigenvalues = constrained_eigenvalues(A, C)
    published = np.array(whipple_bicycle.PUBLISHED_EIGENVALUES[SPEED])
    nearest = [int(np.abs(eigenvalues - value).argmin()) for value in published]

    with stage("initial conditions"):
        # Only independent states: position, lean, roll, steer and speed.
        dependent = bicycle.coordinates[7:] + bicycle.speeds[3:]
        start = {state: straight[state] for state in straight if state not in dependent}
        start[bicycle["u_phi"]] = ROLL_RATE
        start[bicycle["phi"]] = ROLL
        start[bicycle["delta"]] = STEER
        system.initial_conditions = start
        system.set_dependent_initial_conditions(use_jac=True)

    with stage("simulate"):
        free = system.integrate(**SOLVER)
        system.specifieds = {bicycle.push: lambda x, t: push(t)}
        pushed = system.simulate(**SOLVER)
    with stage("evaluate"):
        energy = system.evaluate_outputs(x=free)[:, 0]
        off_ground = np.abs(system.evaluate_holonomic_constraints(x=free)).max()
        holonomic = np.abs(system.evaluate_holonomic_constraints(x=pushed.states)).max(axis=1)
        velocity = np.abs(system.evaluate_velocity_constraints(x=pushed.states)).max(axis=1)
    with stage("animate"):
        scene = bicycle_scene.scene(system, bicycle, TITLE).animate(pushed)

    return Ride(
        states={
            "coordinates": system.num_coordinates,
            "speeds": system.num_speeds,
            "auxiliaries": system.num_auxiliaries,
        },
        dependent={state.name: system.initial_conditions[state] for state in dependent},
        times=TIMES,
        force=pushed[bicycle.push],
        roll=pushed[bicycle["phi"]],
        steer=pushed[bicycle["delta"]],
        roll_rate=pushed[bicycle["u_phi"]],
        contact_forces=pushed.outputs[:, -2:],
        static_forces=static,
        weight=sum(constants[body.mass] for body in bicycle.bodies) * constants[bicycle["g"]],
        holonomic=holonomic,
        velocity=velocity,
        energy=float(energy[0]),
        energy_drift=float(np.abs(energy / energy[0] - 1).max()),
        drift_off_ground=float(off_ground / constants[bicycle["w"]]),
        eigenvalues=eigenvalues[nearest],
        published=published,
        other_eigenvalues=np.delete(eigenvalues, nearest),
        seconds=seconds,
        trajectory=pushed,
        scene=scene,
        bicycle=bicycle,
        system=system,
    )


def animate(ride: Ride, path: Path) -> None:
    """Write the page with a ride's animation.

    Parameters
    ----------
    ride : Ride
        What `ride` returned.
    path : Path
        Where to, conventionally with the suffix ``.html``.
    """
    ride.scene.to_html(path)


def simulate(ride: Ride, path: Path) -> None:
    """Write the page that simulates: its reader chooses speed, push and start.

    Slower than 4.29 m/s it sways more and more, and falls; there the motion ends.

    Parameters
    ----------
    ride : Ride
        What `ride` returned.
    path : Path
        Where to, conventionally with the suffix ``.html``.
    """
    bicycle = ride.bicycle
    t, speed, most = bicycle.coordinates[0].args[0], sm.Symbol("speed"), sm.Symbol("push")
    pulse = most * sm.sin(sm.pi * (t - PUSH_START) / (PUSH_END - PUSH_START)) ** 2
    pushing = (t > PUSH_START) & (t < PUSH_END)
    phi, delta = bicycle["phi"], bicycle["delta"]
    states = (*bicycle.coordinates, *bicycle.speeds)
    system = System(
        bicycle.definition,
        constants={**whipple_bicycle.benchmark_parameters(bicycle), most: PUSH},
        specifieds={bicycle.push: sm.Piecewise((pulse, pushing), (0, True))},
        initial_conditions={s: ride.system.initial_conditions[s] for s in states},
        times=2.0 * TIMES,
        ode_solver="dop853",
    )
    scene = bicycle_scene.scene(system, bicycle, LIVE_TITLE)
    scene.animate(system.simulate(constraints="project", max_step=0.02), fps=50)
    sliders = {
        speed: Slider(1.0, 8.0, SPEED, "m/s", sets={bicycle["omega_R"]: -speed / bicycle["r_R"]}),
        most: Slider(0.0, 600.0, PUSH, "N"),
        phi: Slider(-0.3, 0.3, unit="rad", label="initial roll"),
        delta: Slider(-0.3, 0.3, unit="rad", label="initial steer"),
    }
    falls = [
        Event(phi**2 - FALLEN**2, direction=1, terminal=True, name="fall"),
        Event(delta**2 - STEERED**2, direction=1, terminal=True, name="fork across"),
    ]
    scene.to_html(path, live=Live(sliders, events=falls, max_step=0.02))


def draw(ride: Ride, path: Path) -> None:
    """Save a figure of a ride: roll and steer, contact forces, residuals over time.

    Parameters
    ----------
    ride : Ride
        What `ride` returned.
    path : Path
        Where to; the suffix decides on the format.

    Raises
    ------
    ImportError
        Matplotlib is not installed.
    """
    # Not pyplot, which would open a window if it can.
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8, 8.5), layout="constrained")
    angles, forces, residuals = figure.subplots(3, 1, sharex=True)
    figure.suptitle(TITLE, fontsize=12)

    angles.plot(ride.times, np.degrees(ride.roll), color="tab:blue", label="roll")
    angles.plot(ride.times, np.degrees(ride.steer), color="tab:orange", label="steer")
    angles.axhline(0, color="0.6", linewidth=0.8, zorder=0)
    angles.set_ylabel("angle [deg]")

    for k, (name, colour) in enumerate((("rear", "tab:red"), ("front", "tab:green"))):
        static_force = float(ride.static_forces[k])
        label = f"{name} wheel (riding straight: {static_force:.1f} N)"
        forces.plot(ride.times, ride.contact_forces[:, k] - static_force, color=colour, label=label)
    forces.axhline(0, color="0.6", linewidth=0.8, zorder=0)
    forces.set_ylabel("change of vertical contact force [N]")

    # A logarithmic axis cannot show a residual of zero.
    for values, label, colour in (
        (ride.holonomic, "holonomic [m]", "tab:purple"),
        (ride.velocity, "velocity [m/s]", "tab:brown"),
    ):
        positive = np.where(values > 0, values, np.nan)
        residuals.semilogy(ride.times, positive, color=colour, label=label)
    residuals.set_ylabel("largest constraint residual")
    residuals.set_xlabel("time [s]")
    residuals.set_xlim(ride.times[0], ride.times[-1])

    for axes, corner in (
        (angles, "upper right"),
        (forces, "upper right"),
        (residuals, "lower right"),
    ):
        axes.axvspan(PUSH_START, PUSH_END, color="0.88", zorder=0, label=f"push, up to {PUSH:g} N")
        axes.grid(alpha=0.3)
        axes.legend(loc=corner, fontsize=9)
    with replacing(path) as (temporary_path,):
        figure.savefig(temporary_path, dpi=150)
