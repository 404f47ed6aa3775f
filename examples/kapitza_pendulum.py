"""
Kapitza's pendulum
==================

A pendulum stands upright, upside down, when its pivot is shaken up and down fast enough.  With the
pivot at y = a cos Ωt it does so when aΩ > √(2 g l), and then sways about the top with a slow
frequency near √(a²Ω²/2l² − g/l), says Kapitza's averaging over the fast motion.

The pivot's motion is prescribed: y(t) is left open in the equations, and its second
derivative turns up there as a quantity to be specified.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.system import System

LENGTH, GRAVITY, AMPLITUDE = 0.2, 9.81, 0.01
CRITICAL = np.sqrt(2 * GRAVITY * LENGTH) / AMPLITUDE  # rad/s, of the shaking

# %%
# Equations
# ---------


def derive():
    """Return the KanesMethod, values of its constants, and the symbol of the pivot's height."""
    m, l, g = sm.symbols("m l g")
    q, u, y = me.dynamicsymbols("q u y")
    t = me.dynamicsymbols._t
    N = me.ReferenceFrame("N")
    rod = N.orientnew("R", "Axis", (q, N.z))  # q = 0 is upright
    rod.set_ang_vel(N, u * N.z)
    pivot, bob = me.Point("P"), me.Point("B")
    pivot.set_vel(N, y.diff(t) * N.y)
    bob.set_pos(pivot, l * rod.y)
    bob.v2pt_theory(pivot, N, rod)
    kane = me.KanesMethod(N, [q], [u], [q.diff(t) - u])
    kane.kanes_equations([me.Particle("bob", bob, m)], [(bob, -m * g * N.y)])
    return kane, {m: 0.1, l: LENGTH, g: GRAVITY}, y


# %%
# Simulation
# ----------
# Above and below the critical frequency.


def main(small=False):
    """Shake at several frequencies, compare with Kapitza's theory, draw."""
    kane, constants, y = derive()
    t = me.dynamicsymbols._t
    system = System(
        kane,
        constants=constants,
        initial_conditions={kane.q[0]: 0.1},
        times=np.linspace(0.0, 1.0 if small else 3.0, num=401 if small else 3001),
    )
    print("specified:", system.specifieds_symbols)
    (acceleration,) = system.specifieds_symbols  # y'' alone moves the pendulum
    assert acceleration == y.diff(t, 2)

    def shake(rate):
        """The angle over time. An expression as input is compiled into the equations."""
        system.specifieds = {acceleration: (AMPLITUDE * sm.cos(rate * t)).diff(t, 2)}
        return system.integrate(rtol=1e-9, atol=1e-9, mxstep=5000)[:, 0]

    rates = (0.8 * CRITICAL, 1.5 * CRITICAL, 3.0 * CRITICAL)
    angles = [shake(rate) for rate in rates]
    print(f"largest angle below the critical frequency: {np.abs(angles[0]).max():.2f} rad")
    assert np.abs(angles[0]).max() > 1
    for rate, angle in zip(rates[1:], angles[1:], strict=True):
        assert np.abs(angle).max() < 0.2
        theory = np.sqrt((AMPLITUDE * rate / LENGTH) ** 2 / 2 - GRAVITY / LENGTH)
        found = slow_frequency(system.times, angle, 2 * np.pi / rate)
        print(f"at {rate / CRITICAL:g} of it: sways with {found:.2f} rad/s, theory {theory:.2f}")
        assert abs(found / theory - 1) < 0.02
    floquet(system, acceleration, rates)
    draw(system.times, rates, angles)


def floquet(system, acceleration, rates):
    """Upright is a periodic orbit of the shaking; its multipliers tell exactly if it is stable."""
    t = me.dynamicsymbols._t
    system.initial_conditions = {}
    for rate in rates:
        system.specifieds = {acceleration: (AMPLITUDE * sm.cos(rate * t)).diff(t, 2)}
        orbit = system.find_periodic_orbit(2 * np.pi / rate)
        largest = np.abs(orbit.multipliers).max()
        print(f"at {rate / CRITICAL:g} of it: largest Floquet multiplier {largest:.6f}")
        assert orbit.stable == (rate > CRITICAL)


def slow_frequency(times, angle, fast_period):
    """The frequency of the zeros of the angle, averaged over the shaking."""
    window = max(1, round(fast_period / (times[1] - times[0])))
    smooth = np.convolve(angle, np.ones(window) / window, mode="valid")
    crossings = np.flatnonzero(smooth[:-1] * smooth[1:] < 0)
    step = times[1] - times[0]
    fraction = smooth[crossings] / (smooth[crossings] - smooth[crossings + 1])
    zeros = (crossings + fraction) * step
    return np.pi * (len(zeros) - 1) / (zeros[-1] - zeros[0])


def draw(times, rates, angles):
    """Angles over time."""
    _, axes = plt.subplots(figsize=(9, 3.6), layout="constrained")
    for rate, angle in zip(rates, angles, strict=True):
        axes.plot(times, np.degrees(angle), label=f"Ω = {rate / CRITICAL:g} × critical")
    axes.set(xlabel="time [s]", ylabel="angle from the top [deg]", ylim=(-15, 40))
    axes.set(xlim=(0, times[-1]))
    axes.grid(alpha=0.3)
    axes.legend(loc="upper right")


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
