"""
Andrews' squeezing mechanism
============================

Andrews' mechanism is a standard test problem for solvers of differential-algebraic equations
([1]_, [2]_): seven bodies in a plane, three closed loops, one degree of freedom.  A motor of
constant torque turns the crank K1, and a stiff spring holds the rest.  In 30 milliseconds the crank
makes two and a half revolutions.  The positions at the end are published to 15 digits, and we
compare with them.

We keep all seven angles of the original.  The crank angle β is the independent coordinate.  Six
holonomic constraints close the loops, and KanesMethod solves their rates for the other six speeds.

.. [1] W. Schiehlen (ed.), "Multibody Systems Handbook", Springer 1990, where the mechanism is the
   first planar problem; it is due to G. C. Andrews.
.. [2] E. Hairer and G. Wanner, "Solving Ordinary Differential Equations II", Springer 1996,
   section VII.7.
.. [3] F. Mazzia and C. Magherini, "Test Set for Initial Value Problem Solvers", release 2.4,
   University of Bari 2008, https://archimede.uniba.it/~testset/, problem ANDREWS.
"""

from typing import Any, NamedTuple

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy import System
from pydy.viz import Line, Sphere, Visual

# %%
# The published numbers
# ---------------------
# From the Test Set for IVP Solvers [3]_, problem ANDREWS: SI units, angles in
# radians, bodies K1 to K7.  The names are those of the test set.

CONSTANTS = {
    # masses and central moments of inertia
    **{"m1": 0.04325, "m2": 0.00365, "m3": 0.02373, "m4": 0.00706},
    **{"m5": 0.07050, "m6": 0.00706, "m7": 0.05498},
    **{"I1": 2.194e-6, "I2": 4.410e-7, "I3": 5.255e-6, "I4": 5.667e-7},
    **{"I5": 1.169e-5, "I6": 5.667e-7, "I7": 1.912e-5},
    # the fixed points A and B, and the spring's end C; the crank turns about the origin
    **{"xa": -0.06934, "ya": -0.00227, "xb": -0.03635, "yb": 0.03273, "xc": 0.014, "yc": 0.072},
    # lengths
    **{"d": 0.028, "da": 0.0115, "e": 0.02, "ea": 0.01421, "rr": 0.007, "ra": 0.00092},
    **{"ss": 0.035, "sa": 0.01874, "sb": 0.01043, "sc": 0.018, "sd": 0.02},
    **{"ta": 0.02308, "tb": 0.00916, "u": 0.04, "ua": 0.01228, "ub": 0.00449},
    **{"zf": 0.02, "zt": 0.04, "fa": 0.01421},
    # spring: stiffness and free length; motor: torque
    **{"c0": 4530.0, "l0": 0.07785, "mom": 0.033},
}

# β, Θ, γ, Φ, δ, Ω, ε at rest when the motor is switched on, ...
INITIAL = [
    *(-0.0617138900142764496, 0.0, 0.455279819163070380, 0.222668390165885885),
    *(0.487364979543842550, -0.222668390165885885, 1.230547444549821192),
]
# ... their accelerations at that time and the constraints' multipliers, ...
INITIAL_ACCELERATIONS = [14222.44391995411387, -10666.83293996558540, 0.0, 0.0, 0.0, 0.0, 0.0]
INITIAL_MULTIPLIERS = [98.56687039624108961, -6.122688344255662655, 0.0, 0.0, 0.0, 0.0]
# ... and angles and their rates 30 ms later.
END = 0.03
FINAL = [
    *(15.81077119629904, -15.75637105984298, 0.04082224013073101, -0.5347301163226948),
    *(0.5244099658805304, 0.5347301163226948, 1.048080741042263),
]

# %%
# Equations
# ---------
# Each body gets a frame, rotated by the sum of angles that the test set gives for it.  Each mass
# centre is located along the chain of bodies, from the origin O or from the fixed points A and B.


class Mechanism(NamedTuple):
    """The equations, the numbers for them, and what the drawing and the checks need."""

    frame: Any
    kane: Any
    constants: dict
    initial_conditions: dict
    points: dict
    energy: Any


def derive(constrained=True):
    """Derive the mechanism.

    With `constrained=False` the loops stay open: seven degrees of freedom and no constraints.
    """
    c = {name: sm.Symbol(name) for name in CONSTANTS}
    q = me.dynamicsymbols("beta Theta gamma Phi delta Omega epsilon")
    w = me.dynamicsymbols("u_beta u_Theta u_gamma u_Phi u_delta u_Omega u_epsilon")
    t = me.dynamicsymbols._t

    N = me.ReferenceFrame("N")
    O = me.Point("O")
    O.set_vel(N, 0)

    def body_frame(name, *members):
        """A frame turned by the sum of some of the angles."""
        frame = N.orientnew(name, "Axis", (sum(q[k] for k in members), N.z))
        frame.set_ang_vel(N, sum(w[k] for k in members) * N.z)
        return frame

    def fixed(name, x, y):
        point = O.locatenew(name, c[x] * N.x + c[y] * N.y)
        point.set_vel(N, 0)
        return point

    def attached(name, frame, start, x, y):
        """A point at (x, y) from another one of the same body, in the body's frame."""
        point = start.locatenew(name, x * frame.x + y * frame.y)
        point.v2pt_theory(start, N, frame)
        return point

    K1, K2, K3 = body_frame("K1", 0), body_frame("K2", 0, 1), body_frame("K3", 2)
    K4, K5 = body_frame("K4", 3, 4), body_frame("K5", 4)
    K6, K7 = body_frame("K6", 5, 6), body_frame("K7", 6)

    A, B, C = fixed("A", "xa", "ya"), fixed("B", "xb", "yb"), fixed("C", "xc", "yc")
    P = attached("P", K1, O, c["rr"], 0)  # crank pin
    J = attached("J", K2, P, -c["d"], 0)  # the joint in which K2, K3, K4 and K6 meet
    D = attached("D", K3, B, c["sd"], -c["sc"])  # where the spring pulls
    E = attached("E", K5, A, c["zt"], 0)
    F = attached("F", K7, A, 0, -c["u"])
    # The joint once more, seen as a point of each of the other three bodies.
    J3 = attached("J3", K3, B, 0, -c["ss"])
    J4 = attached("J4", K4, E, 0, -c["e"])
    J6 = attached("J6", K6, F, c["zf"], 0)

    centres = {
        K1: attached("G1", K1, O, c["ra"], 0),
        K2: attached("G2", K2, P, -c["da"], 0),
        K3: attached("G3", K3, B, c["sb"], -c["sa"]),
        K4: attached("G4", K4, E, 0, c["ea"] - c["e"]),
        K5: attached("G5", K5, A, c["ta"], c["tb"]),
        K6: attached("G6", K6, F, c["zf"] - c["fa"], 0),
        K7: attached("G7", K7, A, -c["ub"], -c["ua"]),
    }
    bodies = []
    for k, (frame, centre) in enumerate(centres.items(), start=1):
        inertia = (me.inertia(frame, 0, 0, c[f"I{k}"]), centre)
        bodies.append(me.RigidBody(f"body{k}", centre, frame, c[f"m{k}"], inertia))

    # The spring is a straight line from C to D; the motor stands on the ground.
    stretched = D.pos_from(C)
    length = sm.sqrt(sum(stretched.dot(axis) ** 2 for axis in (N.x, N.y)))
    pull = -c["c0"] * (length - c["l0"]) / length * stretched
    loads = [(K1, c["mom"] * N.z), (D, pull)]

    # Two equations for each loop: its two ways to the joint lead to the same place.
    ends = [(end, axis) for end in (J3, J4, J6) for axis in (N.x, N.y)]
    closed = [J.pos_from(end).dot(axis) for end, axis in ends]
    rates = [(J.vel(N) - end.vel(N)).dot(axis) for end, axis in ends]
    kinematics = [a.diff(t) - b for a, b in zip(q, w, strict=True)]
    if constrained:
        kane = me.KanesMethod(
            N,
            q_ind=q[:1],
            u_ind=w[:1],
            kd_eqs=kinematics,
            q_dependent=q[1:],
            configuration_constraints=closed,
            u_dependent=w[1:],
            velocity_constraints=rates,
            constraint_solver="CRAMER",
        )
    else:
        kane = me.KanesMethod(N, q_ind=q, u_ind=w, kd_eqs=kinematics)
    kane.kanes_equations(bodies, loads)

    return Mechanism(
        frame=N,
        kane=kane,
        constants={c[name]: value for name, value in CONSTANTS.items()},
        initial_conditions=dict(zip(q, INITIAL, strict=True)),
        points={p.name: p for p in (O, A, B, C, D, E, F, J, P)},
        energy=me.kinetic_energy(N, *bodies) + c["c0"] * (length - c["l0"]) ** 2 / 2,
    )


# %%
# The constraints have six rows and depend on seven coordinates: one degree of freedom is left.  The
# published initial accelerations are a first check, before anything is integrated.

mechanism = derive()
points = mechanism.points
N, O = mechanism.frame, points["O"]
places = {
    tuple(sm.symbols(f"{name}_x {name}_y")): list(point.pos_from(O).to_matrix(N)[:2])
    for name, point in points.items()
}
system = System(
    mechanism.kane,
    constants=mechanism.constants,
    initial_conditions=mechanism.initial_conditions,
    times=np.linspace(0.0, END, num=601),
    outputs={"energy": mechanism.energy, **places},
)
print(f"{system.num_coordinates} coordinates, {system.num_constraints} constraints")
accelerations = system.evaluate_ode()[system.num_coordinates :]
error = np.abs(accelerations - INITIAL_ACCELERATIONS).max() / INITIAL_ACCELERATIONS[0]
print(f"initial accelerations, relative error: {error:.0e}")
assert error < 1e-12

# %%
# Simulation
# ----------
# The positions of the joints and the energy are outputs, so that the trajectory holds them.

motion = system.simulate(rtol=1e-12, atol=1e-12)
angles = motion.states[:, :7]

figure, axes = plt.subplots(figsize=(9, 4), layout="constrained")
names = ("β", "Θ", "γ", "Φ", "δ", "Ω", "ε")
for k, name in enumerate(names):
    if name not in "βΘ":
        axes.plot(1000 * motion.times, angles[:, k], label=name)
        axes.plot(1000 * END, FINAL[k], "k+", markersize=9)
axes.plot([], [], "k+", markersize=9, label="published")
axes.set(xlabel="time [ms]", ylabel="angle [rad]", xlim=(0, 1000 * END + 0.3))
axes.grid(alpha=0.3)
axes.legend(ncols=6, loc="upper center", bbox_to_anchor=(0.5, 1.12), frameon=False)

# %%
# Three checks.  The angles at the end are the published ones.  The motor's work, torque times
# angle, equals the energy of the moving bodies and the spring.  The loops stay closed.

error = np.abs(angles[-1] - FINAL).max()
print(f"angles after {1000 * END:g} ms, largest error: {error:.0e} rad")
assert error < 1e-7

work = CONSTANTS["mom"] * (motion["beta"] - motion["beta"][0])
leak = np.abs(motion["energy"] - motion["energy"][0] - work).max() / work.max()
print(f"energy balance: off by {leak:.0e} of the motor's work")
assert leak < 1e-7

open_loops = np.abs(system.evaluate_holonomic_constraints(x=motion.states)).max()
print(f"loops open by {open_loops:.0e} m at most")
assert open_loops < 1e-9

# %%
# The mechanism in motion
# -----------------------
# The links are lines through the joints; K3 is the triangle of B, D and J.  The animation runs a
# few hundred times slower than the mechanism.

bars = {
    "crank": "OP",
    "K2": "PJ",
    "K3": "BJDB",
    "K5": "AE",
    "K4": "EJ",
    "K7": "AF",
    "K6": "FJ",
}
visuals = [
    Visual(Line([points[p] for p in path], radius=0.0012), name=name) for name, path in bars.items()
]
visuals.append(
    Visual(Line([points["C"], points["D"]], radius=0.0004, color="seagreen"), name="spring")
)
visuals.append(Visual(Sphere(0.0025, color="crimson"), points["J"], name="joint", trail=True))
scene = system.scene(*visuals, origin=O, up="y", title="Andrews' mechanism")
scene.animate(motion)

# %%
# Four instants, with the path of the joint in which four bodies meet:


def trace(name):
    """Return the path of a point, in mm."""
    return 1000 * np.column_stack([motion[f"{name}_x"], motion[f"{name}_y"]])


paths = {name: trace(name) for name in points}
figure, panels = plt.subplots(1, 4, figsize=(9, 2.6), layout="constrained")
for axes, moment in zip(panels, (0.0, 0.28, 0.37, 0.46), strict=True):
    k = round(moment * (len(motion.times) - 1))
    axes.plot(*paths["J"].T, color="0.8", linewidth=1)
    axes.plot(*np.array([paths["C"][k], paths["D"][k]]).T, ":", color="tab:green")
    for path in bars.values():
        axes.plot(*np.array([paths[p][k] for p in path]).T, color="tab:blue", linewidth=2)
    for name in "DEFJP":
        axes.plot(*paths[name][k], "o", color="tab:blue", markersize=3)
    for name in "OABC":
        axes.plot(*paths[name][k], "^", color="black", markersize=5)
    axes.set(aspect="equal", xlim=(-76, 21), ylim=(-26, 79))
    axes.set_title(f"{1000 * motion.times[k]:.0f} ms", fontsize=10)
    axes.axis("off")

plt.show()
