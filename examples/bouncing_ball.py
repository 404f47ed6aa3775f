"""
Bouncing ball
=============

A ball is thrown and bounces on.  Each bounce turns its vertical velocity round and leaves a share e
of it, so that bounces follow each other faster and faster and accumulate at a finite time.

A bounce is an event: the solver finds when the height crosses zero, resets the velocity, and goes
on from there.  Between bounces the ball flies a parabola, so that the time of every bounce is
known: t₁ (1 + 2 e + 2 e² + …) with the time t₁ of the first one.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.solvers import Event
from pydy.system import System

HEIGHT, FORWARD, GRAVITY, RESTITUTION = 1.0, 0.5, 9.81, 0.8  # m, m/s, m/s²

# %%
# Equations
# ---------


def derive():
    """Return the KanesMethod and values of its constants."""
    m, g = sm.symbols("m g")
    x, y, v_x, v_y = me.dynamicsymbols("x y v_x v_y")
    t = me.dynamicsymbols._t
    N = me.ReferenceFrame("N")
    origin = me.Point("O")
    origin.set_vel(N, 0)
    ball = origin.locatenew("B", x * N.x + y * N.y)
    ball.set_vel(N, v_x * N.x + v_y * N.y)
    kane = me.KanesMethod(N, [x, y], [v_x, v_y], [x.diff(t) - v_x, y.diff(t) - v_y])
    kane.kanes_equations([me.Particle("ball", ball, m)], [(ball, -m * g * N.y)])
    return kane, {m: 0.05, g: GRAVITY}


# %%
# Simulation
# ----------
# The event looks at y, and only at its way down; its reset is written in states before the bounce.


def main(small=False):
    """Let the ball bounce, compare the times of the bounces with the closed form, draw."""
    kane, constants = derive()
    _, y = kane.q
    v_x, v_y = kane.u
    first = np.sqrt(2 * HEIGHT / GRAVITY)
    end = first * (1 + RESTITUTION) / (1 - RESTITUTION)  # where the bounces accumulate
    system = System(
        kane,
        constants=constants,
        ode_solver="dop853",
        initial_conditions={y: HEIGHT, v_x: FORWARD},
        times=np.linspace(0.0, 0.5 * end if small else 0.97 * end, num=101 if small else 1001),
    )
    bounce = Event(y, direction=-1, reset={v_y: -RESTITUTION * v_y}, name="bounce")
    trajectory = system.simulate(rtol=1e-10, atol=1e-10, events=[bounce])

    found = np.array([event.time for event in trajectory.events])
    exact = first * (1 + 2 * np.cumsum(RESTITUTION ** np.arange(len(found))) - 2)
    error = np.abs(found - exact).max()
    print(f"{len(found)} bounces, their times against the closed form: {error:.0e} s")
    assert len(found) == np.sum(exact < system.times[-1])
    assert error < 1e-9

    speeds = np.array([[event.before[3], event.after[3]] for event in trajectory.events])
    error = np.abs(speeds[:, 1] + RESTITUTION * speeds[:, 0]).max()
    print(f"speeds after the bounces: {error:.0e} m/s off")
    assert error < 1e-12
    draw(trajectory)


def draw(trajectory):
    """The ball's path, and where it bounces."""
    _, axes = plt.subplots(figsize=(9, 3), layout="constrained")
    axes.plot(trajectory["x"], trajectory["y"], color="tab:orange")
    places = [event.before[0] for event in trajectory.events]
    axes.plot(places, np.zeros(len(places)), "k.", markersize=4, label="bounce")
    axes.set(xlabel="x [m]", ylabel="y [m]", aspect="equal", ylim=(-0.05, 1.05 * HEIGHT))
    axes.grid(alpha=0.3)
    axes.legend()


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
