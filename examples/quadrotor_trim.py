"""
Trim and feedback of a quadrotor
================================

A quadrotor that flies straight ahead against the air leans into it.  How far, and how hard its
rotors must push, is a trim: states and inputs at which nothing changes but the place.  Its linear
model there goes to python-control, whose linear-quadratic regulator brings the vehicle back after
a gust.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from pydy.system import System

SPEED, MASS, DRAG, ARM, GRAVITY = 8.0, 1.2, 0.25, 0.22, 9.81

# %%
# Equations
# ---------
# In the vertical plane: a body with a rotor on either side of its centre, and drag along the path
# that grows in proportion to the speed.


def derive():
    """Return the KanesMethod, values of its constants, and the thrusts of both rotors."""
    x, z, pitch, u, w, rate = me.dynamicsymbols("x z theta u w q")
    front, rear = me.dynamicsymbols("T_f T_r")
    m, inertia, d, g, c = sm.symbols("m I d g c")
    t = me.dynamicsymbols._t
    ground = me.ReferenceFrame("N")
    body = ground.orientnew("B", "Axis", (pitch, ground.y))
    body.set_ang_vel(ground, rate * ground.y)
    origin = me.Point("O")
    origin.set_vel(ground, 0)
    centre = origin.locatenew("C", x * ground.x + z * ground.z)
    centre.set_vel(ground, u * ground.x + w * ground.z)
    vehicle = me.RigidBody("vehicle", centre, body, m, (me.inertia(body, 0, inertia, 0), centre))
    loads = [
        (centre, -m * g * ground.z + (front + rear) * body.z),
        (centre, -c * (u * ground.x + w * ground.z)),
        (body, d * (rear - front) * ground.y),
    ]
    kane = me.KanesMethod(
        ground,
        [x, z, pitch],
        [u, w, rate],
        [x.diff(t) - u, z.diff(t) - w, pitch.diff(t) - rate],
        bodies=[vehicle],
        forcelist=loads,
    )
    kane.kanes_equations()
    return kane, {m: MASS, inertia: 0.03, d: ARM, g: GRAVITY, c: DRAG}, (front, rear)


# %%
# Trim, linear model, regulator
# -----------------------------


def main(small=False):
    """Trim at a speed, compare with statics, close the loop, draw a recovery from a gust."""
    import control

    kane, constants, thrusts = derive()
    x, z, pitch, u, w, _ = (*kane.q, *kane.u)
    system = System(kane, constants=constants, ode_solver="dop853")
    trim = system.find_equilibrium(
        [pitch, *thrusts], given={u: SPEED, thrusts[0]: 5.0, thrusts[1]: 5.0}, moving=[x]
    )
    lean, push = trim.values[pitch], sum(trim.values[T] for T in thrusts)
    print(f"at {SPEED:g} m/s it leans by {np.degrees(lean):.3f}° and pushes with {push:.4f} N")
    assert np.isclose(lean, np.arctan2(DRAG * SPEED, MASS * GRAVITY))
    assert np.isclose(push, np.hypot(DRAG * SPEED, MASS * GRAVITY))

    system.initial_conditions = trim.initial_conditions
    system.specifieds = trim.specifieds
    model = system.linearize().to_control()
    weights = np.diag([1.0, 4.0, 1.0, 1.0, 1.0, 0.1])
    gain, _, poles = control.lqr(model, weights, 0.1 * np.eye(2))
    print("closed loop:", np.sort_complex(poles).round(3))

    # The gust leaves it slow, sinking and turned; feedback is an expression in the equations.
    t = me.dynamicsymbols._t
    target = [SPEED * t, *(trim.initial_conditions[s] for s in system.states[1:])]
    error = sm.Matrix([s - r for s, r in zip(system.states, target, strict=True)])
    feedback = -sm.Matrix(gain) * error
    system.specifieds = {T: trim.values[T] + f for T, f in zip(thrusts, feedback, strict=True)}
    names = [s.name for s in system.specifieds_symbols]
    print("inputs:", ", ".join(names))
    start = {**trim.initial_conditions, u: SPEED - 2.0, w: -1.0, pitch: lean + 0.3}
    system.initial_conditions = start
    system.times = np.linspace(0.0, 8.0, num=201 if small else 801)
    flight = system.simulate(rtol=1e-9, atol=1e-9)
    left = flight.states[-1] - [float(sm.sympify(r).subs(t, 8.0)) for r in target]
    print(f"largest deviation after 8 s: {np.abs(left).max():.1e}")
    assert np.abs(left).max() < 5e-2
    closed = system.linearize(trim.initial_conditions).eigenvalues
    assert np.allclose(np.sort_complex(closed), np.sort_complex(poles), atol=1e-8)

    _, (upper, lower) = plt.subplots(2, sharex=True, layout="constrained")
    upper.plot(flight.times, flight[x] - SPEED * flight.times, label="ahead")
    upper.plot(flight.times, flight[z], label="up")
    upper.set_ylabel("deviation (m)")
    upper.legend()
    lower.plot(flight.times, np.degrees(flight[pitch]))
    lower.axhline(np.degrees(lean), color="0.7")
    lower.set_ylabel("pitch (°)")
    lower.set_xlabel("time (s)")


if __name__ == "__main__":
    main(small="--small" in sys.argv)
    plt.show()
