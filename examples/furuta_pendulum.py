"""
Furuta pendulum: swing-up and balance
=====================================

A motor turns an arm in the horizontal plane.  A pendulum without a motor hangs from the end of the
arm.  The motor has to swing the pendulum up and to balance it there (Furuta's rotary pendulum).

Two controllers share the work.  The first pumps energy into the pendulum (Åström and Furuta,
Automatica 36, 2000).  Near the top a linear-quadratic regulator takes over, designed on the exact
linear model.  Both are expressions of the states, so that they are compiled with the equations.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from scipy.integrate import simpson
from scipy.linalg import solve_continuous_are

from pydy import System
from pydy.mechanics import Definition
from pydy.solvers import Event
from pydy.viz import Cylinder, Line, Sphere, Visual

# %%
# Arm and pendulum
# ----------------
# α is the arm's angle, β the pendulum's, zero when it is upright.  The pendulum is a point mass at
# the end of a massless rod that turns about the arm.

alpha, beta, v, w = me.dynamicsymbols("alpha beta v w")
torque = me.dynamicsymbols("tau")
J, m, L, l, g = sm.symbols("J m L l g")

N, O = me.ReferenceFrame("N"), me.Point("O")
O.set_vel(N, 0)
A = N.orientnew("A", "Axis", (alpha, N.z))
B = A.orientnew("B", "Axis", (beta, A.x))
elbow = O.locatenew("elbow", L * A.x)
bob = elbow.locatenew("bob", l * B.z)
arm = me.RigidBody("arm", O, A, sm.Symbol("m_a"), (me.inertia(A, 0, 0, J), O))
mass = me.Particle("mass", bob, m)
model = Definition(
    N,
    [alpha, beta],
    [v, w],
    bodies=[arm, mass],
    loads=[(bob, -m * g * N.z), (A, torque * N.z)],
)
values = {J: 2e-2, m: 0.1, L: 0.2, l: 0.25, g: 9.81}
system = System(model, constants=values, ode_solver="dop853")

# %%
# The linear model at the top
# ---------------------------
# The upright equilibrium has one unstable eigenvalue, which has a closed form: with a = J + m L²,
# b = m l² and c = m L l its square is m g l a/(a b − c²).

linear = system.linearize({})
unstable = linear.eigenvalues.real.max()
a, b, c = values[J] + values[m] * values[L] ** 2, values[m] * values[l] ** 2, 0.1 * 0.2 * 0.25
expected = np.sqrt(values[m] * values[g] * values[l] * a / (a * b - c**2))
print(f"unstable eigenvalue: {unstable:.6f} 1/s, closed form {expected:.6f} 1/s")
assert np.isclose(unstable, expected, rtol=1e-9)

# %%
# Balance
# -------
# The regulator minimises a weighted sum of angles and torque.  With it as an expression in the
# equations, the linear model of the closed loop has exactly the poles that the design promises.

F, G = linear.A, linear.B
Q, R = np.diag([1.0, 5.0, 0.1, 0.1]), np.array([[20.0]])
gain = np.linalg.solve(R, G.T @ solve_continuous_are(F, G, Q, R))[0]
balance = -sum(k * s for k, s in zip(gain, system.states, strict=True))
system.specifieds = {torque: balance}
closed = np.sort_complex(system.linearize({}).eigenvalues)
print("poles:", closed.round(2))
assert np.allclose(closed, np.sort_complex(np.linalg.eigvals(F - G @ gain[None])), atol=1e-8)
assert closed.real.max() < 0

# %%
# Swing-up
# --------
# E is the pendulum's energy, zero at rest at the top.  While it is negative, the arm accelerates
# with β' cos β, which does positive work on the pendulum.  The hyperbolic tangent limits the
# torque.

E = m * l**2 * w**2 / 2 + m * g * l * (sm.cos(beta) - 1)
limit = 0.4  # N m
system.specifieds = {torque: limit * sm.tanh(-20 * (E - 0.02) * w * sm.cos(beta)) - 0.05 * v}
system.initial_conditions = {beta: np.pi, w: 0.1}
system.times = np.linspace(0.0, 20.0, num=8001)
near_top = Event(sm.cos(beta) - np.cos(0.25), direction=1, terminal=True, name="near the top")
rise = system.simulate(events=near_top, rtol=1e-9, atol=1e-9)
print(f"near the top after {rise.events[-1].time:.2f} s, β' = {rise[w][-1]:.2f} rad/s")

# %%
# Then the regulator takes over.  The angle counts from the nearest upright position.

state = rise.states[-1].copy()
turns = np.round(state[1] / (2 * np.pi))
state[1] -= 2 * np.pi * turns
state[0] -= 2 * np.pi * np.round(state[0] / (2 * np.pi))
system.specifieds = {torque: balance}
system.initial_conditions = dict(zip(system.states, state, strict=True))
system.times = np.linspace(0.0, 4.0, num=401)
hold = system.simulate(rtol=1e-9, atol=1e-9)

# %%
# Both parts in one animation:

times = np.concatenate([rise.times, rise.times[-1] + hold.times[1:]])
states = np.vstack([rise.states, hold.states[1:] + (rise.states[-1] - state)])
scene = system.scene(
    Visual(Cylinder(0.05, 0.03, axis="z", color="grey"), N, O, name="motor"),
    Visual(Line([O, elbow], radius=0.006, color="steelblue"), name="arm"),
    Visual(Line([elbow, bob], radius=0.004, color="darkorange"), name="pendulum"),
    Visual(Sphere(0.015, color="crimson"), bob, name="mass", trail=True),
    origin=O,
    up="z",
    ground=False,
    series=[alpha, beta],
)
scene.animate(times, states)

# %%

applied = np.concatenate([run["tau"] for run in (rise, hold)])
figure, (upper, lower) = plt.subplots(2, 1, sharex=True, figsize=(8, 5), layout="constrained")
upper.plot(times, np.degrees(states[:, 1]), label="pendulum, 0° and 360° are upright")
upper.plot(times, np.degrees(states[:, 0]), label="arm")
upper.axvline(rise.times[-1], color="0.5", linestyle=":")
upper.set(ylabel="angle [deg]")
upper.legend()
lower.plot(np.concatenate([rise.times, rise.times[-1] + hold.times]), applied)
lower.axvline(rise.times[-1], color="0.5", linestyle=":", label="regulator takes over")
lower.set(ylabel="torque [N m]", xlabel="time [s]")
lower.legend()
for axes in (upper, lower):
    axes.grid(alpha=0.3)

# %%
# Checks
# ------
# The pendulum stands at the end.  And the energy gained during the swing-up is the work of the
# motor, torque times angular velocity, integrated by Simpson's rule.

final = np.abs(hold.states[-1]).max()
print(f"largest deviation from upright after {hold.times[-1]:g} s: {final:.1e}")
assert final < 5e-2

gained = rise.energy[-1, 2] - rise.energy[0, 2]
work = simpson(rise["tau"] * rise[v], x=rise.times)
print(f"energy gained: {gained:.5f} J, work of the motor: {work:.5f} J")
assert abs(work / gained - 1) < 1e-3

plt.show()
