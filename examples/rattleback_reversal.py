"""
When does the rattleback turn back?
===================================

The stone of the :doc:`rattleback <rattleback>` stops and turns back after some seconds.  How many
depends on how askew its mass is, how high, and how it was set off.  The moment at which the spin
passes zero is an event; its derivatives by all of these come with one simulation, from the
variational equations, which are integrated beside the motion.

They are compared with differences between simulations with changed numbers, and multiplied by
tolerances of manufacture to tell which one decides.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
from rattleback import derive

from pydy.solvers import Event
from pydy.system import System

# What a stone may differ by from its drawing, and a hand from the plan.
TOLERANCES = {"I_12": 2e-6, "h": 1e-4, "b": 1e-4, "alpha": np.radians(0.05), "omega_3": 0.1}


def main(small=False):
    """Find the moment and its derivatives, check them, draw."""
    kane, constants, _ = derive()
    alpha, spin = kane.q[0], kane.u[2]
    system = System(kane, constants=constants, ode_solver="dop853")
    system.initial_conditions = {alpha: np.radians(0.5), spin: -5.0}
    system.times = np.linspace(0.0, 6.0, num=601)
    turning = Event(spin, direction=1, terminal=True, name="turns back")
    accuracy = {"events": [turning], "rtol": 1e-11, "atol": 1e-12}

    trajectory = system.simulate(sensitivities=list(TOLERANCES), **accuracy)
    event = trajectory.events[0]
    shares = dict(zip(TOLERANCES, event.time_sensitivity, strict=True))
    print(f"turns back after {event.time:.4f} s")
    for name, tolerance in TOLERANCES.items():
        print(f"  {name} ± {tolerance:.1e}: ± {abs(shares[name]) * tolerance:.3f} s")

    changed = "I_12", "alpha"
    for name in changed[:1] if small else changed:
        moments = []
        for change in (-1e-3, 1e-3):
            size = change * TOLERANCES[name]
            if name == "alpha":
                system.initial_conditions = {alpha: np.radians(0.5) + size, spin: -5.0}
                system.constants = constants
            else:
                symbol = sm.Symbol(name)
                system.constants = constants | {symbol: constants[symbol] + size}
            moments.append(system.simulate(**accuracy).events[0].time)
        difference = (moments[1] - moments[0]) / (2e-3 * TOLERANCES[name])
        print(f"by differences in {name}: {difference:.6g}, exactly {shares[name]:.6g}")
        assert abs(difference / shares[name] - 1.0) < 1e-4
    draw(trajectory)


def draw(trajectory):
    """The spin, and by how much each tolerance changes it."""
    _, (top, bottom) = plt.subplots(2, 1, figsize=(9, 5), sharex=True, layout="constrained")
    top.plot(trajectory.times, trajectory["omega_3"], color="tab:blue")
    top.axhline(0, color="0.5", linewidth=0.8)
    top.set(ylabel="spin [rad/s]")
    for name, tolerance in TOLERANCES.items():
        change = tolerance * trajectory.sensitivity["omega_3", name]
        bottom.plot(trajectory.times, np.abs(change), label=name)
    bottom.set(ylabel="change of the spin\nby one tolerance [rad/s]", xlabel="time [s]")
    bottom.set(yscale="log", ylim=(1e-6, None), xlim=(0, trajectory.times[-1]))
    bottom.legend(ncols=5, fontsize=9)
    for axes in (top, bottom):
        axes.grid(alpha=0.3)


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
