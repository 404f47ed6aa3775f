"""The command line: ``python -m pydy demo`` and ``python -m pydy run``.

The one module that prints.  What takes long to import is imported by the command that needs it, so
that ``--help`` and ``--version`` answer at once.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from pydy._names import printable
from pydy._version import __version__

if TYPE_CHECKING:
    from pydy.examples import Ride
    from pydy.system import System

__all__ = ["main"]
__dir__ = __all__.copy

PLOT = "bicycle.png"
ANIMATION = "bicycle.html"
LIVE = "bicycle-live.html"
# What the demo promises; it fails when a number is worse.
DRIFT_LIMIT = 1e-6
EIGENVALUE_LIMIT = 1e-9  # 1/s
RUN_TOLERANCE = 1e-9  # for all digits that `run` prints


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line.

    Parameters
    ----------
    arguments : sequence of str, optional
        Those of the process by default.

    Returns
    -------
    int
        Zero, or 1 when a check of the demo or an integration failed, or nobody reads the output.

    Raises
    ------
    SystemExit
        Wrong arguments (code 2), or a request for help or the version (code 0).

    Examples
    --------
    >>> from pydy.cli import main
    >>> main(["run", "springs", "--masses", "1", "--duration", "2", "--points", "3"])
    springs: 2 states, 2 s, every constant 1 but g = 9.81
    <BLANKLINE>
         t [s]        x0 [m]
        0.0000      0.000000
        1.0000      3.338341
        2.0000      8.332865
    0
    """
    if arguments is not None:
        # Checked here: `_checks` would load NumPy for `--version`.
        is_list = isinstance(arguments, (list, tuple))
        if not (is_list and all(type(word) is str for word in arguments)):
            raise TypeError(f"`arguments` must be a list of texts, got {arguments!r:.80}.")
    options = _parser().parse_args(arguments)
    command: Callable[[argparse.Namespace], int] = options.command
    try:
        result = command(options)
        sys.stdout.flush()
    except BrokenPipeError:
        # Who read the output wants no more of it; Python would flush the rest at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    return result


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m pydy",
        description="Fast simulation of multibody systems described with SymPy.",
    )
    parser.add_argument("--version", action="version", version=f"pydy {__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)

    demo = commands.add_parser(
        "demo",
        help="push a bicycle and check the results",
        description="Derive the Carvallo-Whipple bicycle with its published parameters, push it "
        "sideways, and compare its linear model with the published eigenvalues. Takes a few "
        "seconds; the exit code is 1 when a check fails.",
    )
    demo.add_argument(
        "--output",
        type=Path,
        default=Path("build"),
        metavar="DIR",
        help=f"directory for {PLOT}, {ANIMATION} and {LIVE}, made when missing "
        "(default: %(default)s)",
    )
    demo.add_argument("--no-plot", action="store_true", help="save no plot and no animation")
    demo.set_defaults(command=_demo, refuse=demo.error)

    run = commands.add_parser(
        "run",
        help="simulate a sample model and print its coordinates",
        description="Simulate a sample model and print its coordinates. Every constant is 1 but "
        "gravity, 9.81; nothing pushes.",
    )
    models = run.add_subparsers(title="models", metavar="MODEL", required=True)
    pendulum = models.add_parser(
        "pendulum", help="links on a sliding cart, released 0.5 rad from upright"
    )
    pendulum.add_argument("--links", dest="size", type=_whole(1, 1000), default=2, metavar="N")
    pendulum.set_defaults(model=_pendulum)
    springs = models.add_parser(
        "springs", help="masses on springs, released with all springs unstretched"
    )
    springs.add_argument("--masses", dest="size", type=_whole(1, 1000), default=2, metavar="N")
    springs.set_defaults(model=_springs)
    for model in (pendulum, springs):
        model.add_argument(
            "--duration", type=_seconds, default=5.0, metavar="T", help="in s (default: 5)"
        )
        model.add_argument(
            "--points",
            type=_whole(2, 10**6),
            default=11,
            metavar="N",
            help="rows to print (default: 11)",
        )
        model.set_defaults(command=_run)
    return parser


def _whole(least: int, most: int) -> Callable[[str], int]:
    def read(text: str) -> int:
        if not text.isdecimal() or not least <= int(text[:9]) <= most:
            must = f"must be a whole number from {least} to {most}"
            raise argparse.ArgumentTypeError(f"{must}, got {text!r}")
        return int(text)

    return read


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"must be a positive number of seconds, got {text!r}")
    return value


# -- run ------------------------------------------------------------------------------------------


def _pendulum(size: int) -> System:
    from pydy.models import n_link_pendulum_on_cart

    system = n_link_pendulum_on_cart(size)
    system.initial_conditions = dict.fromkeys(system.coordinates[1:], 0.5)
    return system


def _springs(size: int) -> System:
    from pydy.models import multi_mass_spring_damper

    return multi_mass_spring_damper(size, apply_gravity=True)


def _run(options: argparse.Namespace) -> int:
    import numpy as np

    from pydy.errors import IntegrationError

    system: System = options.model(options.size)
    system.constants = {symbol: 9.81 for symbol in system.constants_symbols if symbol.name == "g"}
    system.times = np.linspace(0.0, options.duration, options.points)
    # `odeint` gives up after 500 steps between two times. A million steps take seconds.
    system.ode_solver = "dop853"
    try:
        states = system.integrate(rtol=RUN_TOLERANCE, atol=RUN_TOLERANCE, max_steps=1_000_000)
    except IntegrationError as error:
        print(f"python -m pydy run: {error}", file=sys.stderr)
        return 1

    pendulum = options.model is _pendulum
    print(
        f"{'pendulum' if pendulum else 'springs'}: {system.num_states} states, "
        f"{options.duration:g} s, every constant 1 but g = 9.81"
    )
    print()
    units = ["rad" if pendulum and k else "m" for k in range(system.num_coordinates)]
    names = [f"{q.name} [{unit}]" for q, unit in zip(system.coordinates, units, strict=True)]
    print(f"{'t [s]':>10s}" + "".join(f"{name:>14s}" for name in names))
    for t, x in zip(system.times, states, strict=True):
        print(f"{t:10.4f}" + "".join(f"{value:14.6f}" for value in x[: len(names)]))
    return 0


# -- demo -----------------------------------------------------------------------------------------


def _demo(options: argparse.Namespace) -> int:
    if not options.no_plot:
        # Before the work, so that a slip in the path costs no time.
        try:
            options.output.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            options.refuse(f"argument --output: cannot make the directory: {error}")

    print("Carvallo-Whipple bicycle: deriving, compiling and riding it takes a few seconds.")
    sys.stdout.flush()
    from pydy.examples import animate, draw, ride as ride_bicycle, simulate

    ride = ride_bicycle()
    _print_model(ride)
    _print_ride(ride)
    _print_eigenvalues(ride)
    _print_seconds(ride)
    if not options.no_plot:
        _title("Plot")
        path = options.output / PLOT
        try:
            draw(ride, path)
        except ImportError:
            print("  none: it needs Matplotlib, python -m pip install matplotlib")
        except OSError as error:
            print(f"python -m pydy demo: cannot save the plot: {error}", file=sys.stderr)
            return 1
        else:
            print(f"  {printable(str(path), sys.stdout)}")
        for title, name, write in (
            ("Animation (open it in a browser)", ANIMATION, animate),
            (
                "Live page (drag the speed: below 4.29 m/s the bicycle sways, at 3 it falls)",
                LIVE,
                simulate,
            ),
        ):
            _title(title)
            path = options.output / name
            try:
                write(ride, path)
            except OSError as error:
                print(f"python -m pydy demo: cannot save the page: {error}", file=sys.stderr)
                return 1
            print(f"  {printable(str(path), sys.stdout)}")
    return _verdict(ride)


def _title(text: str) -> None:
    print(f"\n{text}\n{'-' * len(text)}")


def _line(label: str, text: str) -> None:
    print(f"  {label:<42s}{text}")


def _print_model(ride: Ride) -> None:
    from pydy.examples import ROLL, ROLL_RATE, SPEED, STEER

    _title("Model")
    counts = ride.states
    _line("coordinates, speeds", f"{counts['coordinates']}, {counts['speeds']}")
    _line("auxiliary states (integrals of N_r, N_f)", f"{counts['auxiliaries']}")
    _title("Initial conditions that the constraints determine")
    _line("given: spin of the rear wheel", f"that of {SPEED:g} m/s")
    _line("given: roll, steer, roll rate", f"{ROLL:g} rad, {STEER:g} rad, {ROLL_RATE:g} rad/s")
    units = {"theta": "rad", "u_x": "m/s", "u_y": "m/s"}
    for name, value in ride.dependent.items():
        _line(name, f"{value:14.9f} {units.get(name, 'rad/s')}")


def _print_ride(ride: Ride) -> None:
    import numpy as np

    from pydy.examples import PUSH, PUSH_END, PUSH_START

    _title(
        f"{ride.times[-1]:g} s with a sideways push, up to {PUSH:g} N "
        f"from {PUSH_START:g} to {PUSH_END:g} s"
    )
    for name, angle in (("roll", ride.roll), ("steer", ride.steer)):
        degrees = np.degrees(angle)
        _line(f"{name}, least and greatest", f"{degrees.min():9.3f} {degrees.max():9.3f} deg")
    _line("holonomic residual, largest", f"{ride.holonomic.max():9.1e} m")
    _line("velocity residual, largest", f"{ride.velocity.max():9.1e} m/s")
    print()
    print(f"  {'vertical contact force [N]':<42s}{'straight':>9s} {'least':>9s} {'greatest':>9s}")
    for k, name in enumerate(("rear wheel, N_r", "front wheel, N_f")):
        force = ride.contact_forces[:, k]
        _line(name, f"{ride.static_forces[k]:9.3f} {force.min():9.3f} {force.max():9.3f}")
    _line("both (the weight)", f"{ride.static_forces.sum():9.3f} ({ride.weight:.3f})")

    _title(f"{ride.times[-1]:g} s without the push")
    _line("energy", f"{ride.energy:9.3f} J")
    _line("energy drift, relative", f"{ride.energy_drift:9.1e}")
    _line("holonomic residual, relative to wheel base", f"{ride.drift_off_ground:9.1e}")


def _print_eigenvalues(ride: Ride) -> None:
    from pydy.examples import MODES, SPEED

    _title(
        f"Linear model at {SPEED:g} m/s: eigenvalues [1/s] beside those of Meijaard et al. (2007)"
    )
    print(f"  {'':<18s}{'computed':>20s}{'published':>20s}{'difference':>13s}")
    for name, computed, published in zip(MODES, ride.eigenvalues, ride.published, strict=True):
        rows = [(name, computed.real, published.real)]
        if published.imag > 0:
            rows = [
                (f"{name}, real", computed.real, published.real),
                (f"{name}, imag. +/-", computed.imag, published.imag),
            ]
        elif published.imag < 0:
            continue  # the conjugate of the one before
        for label, mine, theirs in rows:
            print(f"  {label:<18s}{mine:20.15g}{theirs:20.15g}{mine - theirs:13.1e}")
    print(f"  {'largest difference of the four, complex':<58s}{ride.eigenvalue_error:13.1e}")
    others = ride.other_eigenvalues
    print(
        f"  {f'largest of the other {len(others)}, which are zero in theory':<58s}"
        f"{abs(others).max():13.1e}"
    )


def _print_seconds(ride: Ride) -> None:
    _title("Time [s]")
    for stage, seconds in ride.seconds.items():
        _line(stage, f"{seconds:8.3f}")
    _line("total", f"{sum(ride.seconds.values()):8.3f}")


def _verdict(ride: Ride) -> int:
    """Say which promises hold; return the exit code."""
    checks = [
        ("energy drift", ride.energy_drift, DRIFT_LIMIT, ""),
        ("holonomic residual", ride.drift_off_ground, DRIFT_LIMIT, ""),
        ("eigenvalues' difference", ride.eigenvalue_error, EIGENVALUE_LIMIT, " 1/s"),
    ]
    _title("Checks")
    failed = []
    for name, value, limit, unit in checks:
        # `not <`, for a NaN must fail.
        good = value < limit
        _line(f"{name} below {limit:.0e}{unit}", "ok" if good else "FAILED")
        if not good:
            failed.append(f"{name} is {value:.3g}{unit}, must be below {limit:.0e}{unit}")
    for text in failed:
        print(f"python -m pydy demo: failed: {text}", file=sys.stderr)
    return 1 if failed else 0
