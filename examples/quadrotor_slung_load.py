"""
Quadrotor with a slung load
===========================

A quadrotor carries a load on a cable.  Which thrusts move the *load* along a given path?

The system is differentially flat (Sreenath, Lee and Kumar, CDC 2013): the path of the load
determines everything else.  The load's acceleration gives the direction and tension of the cable,
hence the path of the quadrotor; its acceleration gives the thrust and the pitch; and the pitch
gives the moment.  We let SymPy differentiate, use the result as inputs, and the load must follow
its path.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me
from scipy.linalg import solve_continuous_are

from pydy import System
from pydy.mechanics import Definition
from pydy.viz import Arrow, Box, Cylinder, Line, Sphere, Trace, Visual

MASS, LOAD, CABLE, INERTIA, GRAVITY = 1.0, 0.4, 0.8, 0.02, 9.81

# %%
# The model
# ---------
# In the vertical plane: θ is the pitch, φ the angle of the cable from the vertical.  The inputs are
# the thrust of all rotors and their moment.

x, z, theta, phi = me.dynamicsymbols("x z theta phi")
v_x, v_z, w, rate = me.dynamicsymbols("v_x v_z w u")
thrust, moment = me.dynamicsymbols("f tau")
m, M, l, I, g = sm.symbols("m M l I g")
t = me.dynamicsymbols._t

N, O = me.ReferenceFrame("N"), me.Point("O")
O.set_vel(N, 0)
B, E = N.orientnew("B", "Axis", (theta, N.y)), N.orientnew("E", "Axis", (-phi, N.y))
centre = O.locatenew("C", x * N.x + z * N.z)
hook = centre.locatenew("P", -l * E.z)
quadrotor = me.RigidBody("quadrotor", centre, B, m, (me.inertia(B, 0, I, 0), centre))
load = me.Particle("load", hook, M)
model = Definition(
    N,
    [x, z, theta, phi],
    [v_x, v_z, w, rate],
    bodies=[quadrotor, load],
    loads=[
        (centre, -m * g * N.z + thrust * B.z),
        (hook, -M * g * N.z),
        (B, moment * N.y),
    ],
)
values = {m: MASS, M: LOAD, l: CABLE, I: INERTIA, g: GRAVITY}
system = System(model, constants=values, ode_solver="dop853")

# %%
# From the path of the load to the inputs
# ---------------------------------------
# The load flies a figure of eight.

up = sm.Matrix([0, GRAVITY])
pace = sm.Rational(6, 5)  # rad/s
path = sm.Matrix([sm.sin(pace * t) * 3 / 2, 2 + sm.sin(2 * pace * t) / 2])
pull = -LOAD * (path.diff(t, 2) + up)  # tension times the direction of the cable, downwards
tension = sm.sqrt(pull.dot(pull))
direction = pull / tension
body = path - CABLE * direction
push = MASS * (body.diff(t, 2) + up) - pull
reference = sm.Matrix(
    [body[0], body[1], sm.atan2(push[0], push[1]), sm.atan2(direction[0], -direction[1])]
)
inputs = {
    thrust: sm.sqrt(push.dot(push)),
    moment: INERTIA * reference[2].diff(t, 2),
}
print("operations in the moment:", sm.count_ops(inputs[moment]))

# %%
# Feedforward
# -----------
# Started where the reference starts, the inputs alone keep the load on its path.

states = [*reference, *reference.diff(t)]
system.initial_conditions = {
    symbol: float(expression.subs(t, 0))
    for symbol, expression in zip(system.states, states, strict=True)
}
system.specifieds = inputs
place = hook.pos_from(O)
system.outputs = {"load_x": place.dot(N.x), "load_z": place.dot(N.z)}
system.times = np.linspace(0.0, 10.0, num=601)
flight = system.simulate(rtol=1e-11, atol=1e-12)


def distance(motion):
    """Return how far the load is from its path over time."""
    wanted = sm.lambdify(t, list(path))(motion.times)
    return np.hypot(motion["load_x"] - wanted[0], motion["load_z"] - wanted[1])


print(f"the load leaves its path by {distance(flight).max():.0e} m at most")
assert distance(flight).max() < 1e-6

# %%


def scene_of(title):
    """Return a scene of quadrotor, cable and load."""
    visuals = [
        Visual(Box(0.5, 0.05, 0.03, color="grey"), quadrotor, name="body"),
        Visual(Line([centre, hook], radius=0.006, color="dimgrey"), name="cable"),
        Visual(Sphere(0.08, color="darkorange"), load, name="load"),
        Visual(Trace(duration=4.0, color="darkorange"), hook, name="path"),
        Visual(Arrow(thrust * B.z, scale=0.025), centre, name="thrust"),
    ]
    for side in (-0.25, 0.25):
        hub = centre.locatenew(f"hub {side}", side * B.x + 0.04 * B.z)
        visuals.append(
            Visual(Cylinder(0.01, 0.13, axis="z", color="steelblue"), B, hub, name="rotors")
        )
    return system.scene(
        *visuals, origin=O, up="z", ground=0.0, view=(0, -1, 0.15), series=[theta, phi], title=title
    )


scene_of("Feedforward").animate(flight)

# %%

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
left.plot(flight["load_x"], flight["load_z"], color="tab:orange", label="load")
left.plot(flight[x], flight[z], color="tab:blue", label="quadrotor")
for k in range(0, 300, 25):
    left.plot([flight[x][k], flight["load_x"][k]], [flight[z][k], flight["load_z"][k]], "0.7")
left.set(aspect="equal", xlabel="x [m]", ylabel="z [m]")
left.legend()
right.plot(flight.times, flight[thrust], label="thrust [N]")
right.plot(flight.times, np.degrees(flight[theta]), label="pitch [deg]")
right.plot(flight.times, np.degrees(flight[phi]), label="cable [deg]")
right.set(xlabel="time [s]")
right.legend()
for axes in (left, right):
    axes.grid(alpha=0.3)

# %%
# Feedback
# --------
# Nothing holds the load on its path when it is disturbed.  A linear-quadratic regulator, designed
# on the linear model of hovering, adds a feedback of the deviation from the reference.

hover = {thrust: (MASS + LOAD) * GRAVITY, moment: 0.0}
system.specifieds = hover
linear = system.linearize({z: 2.0})
Q, R = np.diag([20.0, 20.0, 1.0, 5.0, 4.0, 4.0, 0.1, 1.0]), np.diag([0.5, 5.0])
gain = np.linalg.solve(R, linear.B.T @ solve_continuous_are(linear.A, linear.B, Q, R))
columns = [linear.inputs.index(name) for name in ("f", "tau")]
deviation = sm.Matrix([a - b for a, b in zip(system.states, states, strict=True)])
feedback = -sm.Matrix(gain[columns]) * deviation
system.specifieds = {
    symbol: inputs[symbol] + correction
    for symbol, correction in zip((thrust, moment), feedback, strict=True)
}

# %%
# The flight begins half a metre off, with a swinging load.

system.initial_conditions[x] += 0.5
system.initial_conditions[rate] += 1.0
disturbed = system.simulate(rtol=1e-9, atol=1e-9)
scene_of("Feedback after a disturbance").animate(disturbed, compare={"undisturbed": flight})

# %%

figure, axes = plt.subplots(figsize=(7, 3), layout="constrained")
axes.semilogy(disturbed.times, distance(disturbed))
axes.set(xlabel="time [s]", ylabel="distance of the load\nfrom its path [m]")
axes.grid(alpha=0.3)
final = distance(disturbed)[-1]
print(f"distance of the load from its path after {disturbed.times[-1]:.1f} s: {final:.1e} m")
assert final < 0.02

plt.show()
