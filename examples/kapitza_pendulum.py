"""
Kapitza's pendulum
==================

A pendulum can stand upright, upside down, when its pivot is shaken up and down fast enough.  With
the pivot at y = a cos Ωt it does so when aΩ > √(2 g l), and then oscillates about the top with a
low frequency near √(a²Ω²/2l² − g/l), according to Kapitza's averaging over the fast motion.

The pivot's motion is prescribed.  We leave y(t) open in the equations, where only its second
derivative appears, and give it as an expression of time.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.viz import Box, Line, Sphere, Visual

LENGTH, GRAVITY, AMPLITUDE = 0.2, 9.81, 0.01  # m, m/s², m
CRITICAL = np.sqrt(2 * GRAVITY * LENGTH) / AMPLITUDE  # rad/s, of the shaking

# %%
# Equations
# ---------
# The angle is zero when the pendulum is upright.

m, l, g = sm.symbols("m l g")
q, u, y = me.dynamicsymbols("q u y")
t = me.dynamicsymbols._t
N, O = me.ReferenceFrame("N"), me.Point("O")
O.set_vel(N, 0)
rod = N.orientnew("R", "Axis", (q, N.z))
rod.set_ang_vel(N, u * N.z)
pivot = O.locatenew("P", y * N.y)
pivot.set_vel(N, y.diff(t) * N.y)
bob = pivot.locatenew("B", l * rod.y)
bob.v2pt_theory(pivot, N, rod)
kane = me.KanesMethod(N, [q], [u], [q.diff(t) - u])
kane.kanes_equations([me.Particle("bob", bob, m)], [(bob, -m * g * N.y)])

system = System(
    kane,
    constants={m: 0.1, l: LENGTH, g: GRAVITY},
    initial_conditions={q: 0.1},
    times=np.linspace(0.0, 3.0, num=3001),
)
print("specified:", system.specifieds_symbols)

# %%
# Shaking
# -------
# Below the critical frequency the pendulum falls over; above, it stays up.  The expression is
# compiled with the equations, its derivatives included.


def shake(rate):
    """Simulate with the pivot shaken at an angular frequency."""
    system.specifieds = {y: AMPLITUDE * sm.cos(rate * t)}
    return system.simulate(rtol=1e-9, atol=1e-9, mxstep=5000)


rates = (0.8 * CRITICAL, 1.5 * CRITICAL, 3.0 * CRITICAL)
runs = [shake(rate) for rate in rates]

figure, axes = plt.subplots(figsize=(9, 3.6), layout="constrained")
for rate, run in zip(rates, runs, strict=True):
    axes.plot(run.times, np.degrees(run[q]), label=f"Ω = {rate / CRITICAL:g} × critical")
axes.set(xlabel="time [s]", ylabel="angle from the top [deg]", ylim=(-15, 40))
axes.set(xlim=(0, runs[0].times[-1]))
axes.grid(alpha=0.3)
axes.legend(loc="upper right")

# %%
# At three times the critical frequency, five times slower than in reality:

scene = system.scene(
    Visual(Box(0.05, 0.02, 0.05, color="grey"), N, pivot, name="pivot"),
    Visual(Line([pivot, bob], radius=0.003, color="steelblue"), name="rod"),
    Visual(Sphere(0.015, color="orangered"), bob, name="bob", trail=True),
    origin=O,
    up="y",
    ground=False,
    series=[q],
)
scene.animate(runs[2], speed=0.2)

# %%
# The slow oscillation
# --------------------
# Its frequency is found from the zeros of the angle, averaged over the shaking.


def slow_frequency(times, angle, fast_period):
    """Return the angular frequency of the slow oscillation."""
    step = times[1] - times[0]
    window = max(1, round(fast_period / step))
    smooth = np.convolve(angle, np.ones(window) / window, mode="valid")
    crossings = np.flatnonzero(smooth[:-1] * smooth[1:] < 0)
    fraction = smooth[crossings] / (smooth[crossings] - smooth[crossings + 1])
    zeros = (crossings + fraction) * step
    return np.pi * (len(zeros) - 1) / (zeros[-1] - zeros[0])


largest = np.abs(runs[0][q]).max()
print(f"largest angle below the critical frequency: {largest:.2f} rad")
assert largest > 1
for rate, run in zip(rates[1:], runs[1:], strict=True):
    assert np.abs(run[q]).max() < 0.2
    theory = np.sqrt((AMPLITUDE * rate / LENGTH) ** 2 / 2 - GRAVITY / LENGTH)
    found = slow_frequency(run.times, run[q], 2 * np.pi / rate)
    print(f"at {rate / CRITICAL:g} of it: {found:.2f} rad/s, theory {theory:.2f}")
    assert abs(found / theory - 1) < 0.02

# %%
# Stability, exactly
# ------------------
# Standing upright is a periodic orbit of the shaken pendulum.  Its Floquet multipliers tell whether
# it is stable, without an average and without a long simulation.

system.initial_conditions = {}
for rate in rates:
    system.specifieds = {y: AMPLITUDE * sm.cos(rate * t)}
    orbit = system.find_periodic_orbit(2 * np.pi / rate)
    multiplier = np.abs(orbit.multipliers).max()
    print(f"at {rate / CRITICAL:g} of it: largest Floquet multiplier {multiplier:.6f}")
    assert orbit.stable == (rate > CRITICAL)

plt.show()
