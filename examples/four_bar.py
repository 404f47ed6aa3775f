"""
Four-bar linkage
================

A crank, a coupler and a rocker on a fixed base: the linkage behind wipers, pumps and oil wells.
The crank is spun up by hand and let go; gravity is off, so that only the linkage's own changing
inertia slows it down and speeds it up again.

Two equations close the loop.  Where the rocker must be for each crank angle can also be found by
cutting two circles, which is what we compare with; and the energy must not change.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.system import System

# %%
# Equations
# ---------
# All three angles are measured from the base.  The crank's is independent; the other two follow
# from the loop: crank plus coupler must end where the rocker ends.
#
# The path of a point beside the coupler, the coupler curve, is what such linkages are built for.

LENGTHS = {"a": 0.1, "b": 0.25, "c": 0.2, "base": 0.28}  # m: crank, coupler, rocker, base


def derive():
    """Return the KanesMethod, values of its constants, and the points to draw."""
    a, b, c, base = sm.symbols("a b c base")
    m1, m2, m3 = sm.symbols("m1:4")
    q1, q2, q3, u1, u2, u3 = me.dynamicsymbols("q1:4 u1:4")
    t = me.dynamicsymbols._t

    N = me.ReferenceFrame("N")
    O = me.Point("O")
    O.set_vel(N, 0)
    Q = O.locatenew("Q", base * N.x)
    Q.set_vel(N, 0)

    def rod(name, start, end, length, mass, q, u):
        """A uniform rod from a point: its body and its end."""
        frame = N.orientnew(name, "Axis", (q, N.z))
        frame.set_ang_vel(N, u * N.z)
        centre = start.locatenew(f"{name}_centre", length / 2 * frame.x)
        end = start.locatenew(end, length * frame.x)
        centre.v2pt_theory(start, N, frame)
        end.v2pt_theory(start, N, frame)
        inertia = (me.inertia(frame, 0, 0, mass * length**2 / 12), centre)
        return me.RigidBody(name, centre, frame, mass, inertia), end

    crank, A = rod("crank", O, "A", a, m1, q1, u1)
    coupler, B = rod("coupler", A, "B", b, m2, q2, u2)
    rocker, C = rod("rocker", Q, "C", c, m3, q3, u3)
    tracer = A.locatenew("T", b / 2 * coupler.frame.x + b / 3 * coupler.frame.y)

    kane = me.KanesMethod(
        N,
        q_ind=[q1],
        q_dependent=[q2, q3],
        u_ind=[u1],
        u_dependent=[u2, u3],
        kd_eqs=[q1.diff(t) - u1, q2.diff(t) - u2, q3.diff(t) - u3],
        configuration_constraints=[B.pos_from(C).dot(N.x), B.pos_from(C).dot(N.y)],
        velocity_constraints=[(B.vel(N) - C.vel(N)).dot(N.x), (B.vel(N) - C.vel(N)).dot(N.y)],
        constraint_solver="CRAMER",
    )
    kane.kanes_equations([crank, coupler, rocker])
    constants = {a: 0.1, b: 0.25, c: 0.2, base: 0.28, m1: 0.4, m2: 0.3, m3: 0.25}
    points = {p.name: p.pos_from(O).to_matrix(N)[:2] for p in (O, A, B, Q, tracer)}
    return kane, constants, points, me.kinetic_energy(N, crank, coupler, rocker)


def two_circles(crank):
    """The rocker's angle for angles of the crank, from where two circles cut."""
    a, b, c, base = LENGTHS.values()
    dx, dy = base - a * np.cos(crank), -a * np.sin(crank)
    distance = np.hypot(dx, dy)
    # The angle at Q in the triangle of coupler, rocker and the line from A to Q.
    at_rocker = np.arccos((distance**2 + c**2 - b**2) / (2 * distance * c))
    return np.arctan2(-dy, -dx) - at_rocker


# %%
# Simulation
# ----------
# Only the crank's angle and rate are given; `set_dependent_initial_conditions` finds the others,
# starting from a rough guess, which decides between the linkage's two ways of being assembled.


def main(small=False):
    """Simulate two seconds, compare the rocker with the closed form, draw."""
    kane, constants, points, energy = derive()
    q1, q2, q3 = kane.q
    u1 = kane.u[0]
    system = System(
        kane,
        constants=constants,
        initial_conditions={q1: 0.5, q2: 0.7, q3: 1.8, u1: 12.0},
        times=np.linspace(0.0, 0.2 if small else 2.0, num=101 if small else 1001),
        outputs={
            sm.Symbol("energy"): energy,
            **{tuple(sm.symbols(f"{p}_x {p}_y")): list(place) for p, place in points.items()},
        },
    )
    system.set_dependent_initial_conditions(use_jac=True)
    x = system.integrate(rtol=1e-11, atol=1e-11)

    error = np.abs(np.sin(x[:, 2] - two_circles(x[:, 0]))).max()
    print(f"rocker against two circles: {error:.0e} rad")
    assert error < 1e-7
    outputs = system.evaluate_outputs(x=x)
    drift = np.abs(outputs[:, 0] / outputs[0, 0] - 1).max()
    print(f"energy: {outputs[0, 0]:.4f} J, relative change: {drift:.0e}")
    assert drift < 1e-7
    path = {p: outputs[:, 2 * k + 1 : 2 * k + 3] for k, p in enumerate(points)}
    draw(system.times, x, path)


def draw(times, x, path):
    """The linkage with the coupler curve, and rates over time."""
    _, (left, right) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
    left.plot(*path["T"].T, color="tab:orange", label="coupler curve")
    k = len(times) // 20
    bars = np.array([path[p][k] for p in ("O", "A", "B", "Q")])
    left.fill(*np.array([path[p][k] for p in ("A", "B", "T")]).T, color="tab:blue", alpha=0.2)
    left.plot(*bars.T, "o-", color="tab:blue", linewidth=3)
    left.plot(*path["T"][k], "o", color="tab:orange")
    left.plot(*bars[[0, 3]].T, "^", color="black", markersize=9)
    left.set(aspect="equal", xlabel="x [m]", ylabel="y [m]")
    left.legend(loc="upper right")

    for column, name in ((3, "crank"), (4, "coupler"), (5, "rocker")):
        right.plot(times, x[:, column], label=name)
    right.set(xlabel="time [s]", ylabel="angular velocity [rad/s]", xlim=(0, times[-1]))
    right.legend(loc="upper right")
    for axes in (left, right):
        axes.grid(alpha=0.3)


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
