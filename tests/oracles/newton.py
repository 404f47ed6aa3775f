"""Newton's and Euler's laws, written along a motion whose q, q' and q'' are numbers.

Positions and direction cosines are SymPy's; everything is differentiated by time there. Nothing is
taken from the package or from Kane's method.
"""

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

T = me.dynamicsymbols._t
DIGITS = 40


def motion(coordinates, x, rates):
    """q(t) with the given q, q' and q'' at t = 0, as exact polynomials."""
    n = len(coordinates)
    parts = zip(coordinates, x[:n], rates[:n], rates[n : 2 * n], strict=True)
    return {
        q: sm.Rational(float(a)) + sm.Rational(float(b)) * T + sm.Rational(float(c)) / 2 * T**2
        for q, a, b, c in parts
    }


def needed(bodies, point, origin, frame, path, numbers, loads=()):
    """Force and torque about `point` that bodies need beside loads, in the axes of `frame`.

    `path` maps coordinates to functions of time, `numbers` other symbols to floats; `origin` rests
    in `frame`.
    """

    def put(matrix):
        given = {s: sm.Rational(float(v)) for s, v in numbers.items()}
        return sm.Matrix(matrix).xreplace(path).xreplace(given)

    def now(matrix):
        return put(matrix).subs(T, 0).evalf(DIGITS)

    def rate(matrix):
        return matrix.diff(T)

    pivot = now(point.pos_from(origin).to_matrix(frame))
    force, torque = sm.zeros(3, 1), sm.zeros(3, 1)
    for body in bodies:
        place = put(body.masscenter.pos_from(origin).to_matrix(frame))
        mass = put([body.mass])[0]
        change = rate(mass * rate(place)).subs(T, 0).evalf(DIGITS)
        force += change
        torque += (place.subs(T, 0).evalf(DIGITS) - pivot).cross(change)
        if isinstance(body, me.RigidBody):
            turn = put(frame.dcm(body.frame))
            spin = rate(turn) * turn.T
            rotation = sm.Matrix([spin[2, 1], spin[0, 2], spin[1, 0]])
            own = put(body.central_inertia.to_matrix(body.frame))
            torque += rate(turn * own * turn.T * rotation).subs(T, 0).evalf(DIGITS)
    for where, vector in loads:
        part = now(vector.to_matrix(frame))
        if isinstance(where, me.Point):
            force -= part
            arm = now(where.pos_from(origin).to_matrix(frame)) - pivot
            torque -= arm.cross(part)
        else:
            torque -= part
    return np.array([*force, *torque], dtype=float)
