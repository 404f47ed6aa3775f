"""Joints as rows of elements: in numbers for the oracle, in SymPy for the front ends.

A new joint is an entry of `JOINTS`.
"""

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from mechanisms.drawing import AXES, T, decimal, draw_axis, vector
from mechanisms.taylor import (
    LONG,
    constant,
    cos_sin,
    multiply,
    turned,
)


class Turn:
    """A rotation about a fixed axis."""

    lengths = (0,)

    def __init__(self, axis=None):
        self.axis = axis

    def along(self, data):
        return data["axis"] if self.axis is None else AXES[self.axis]

    def numbers(self, data, q, time):
        return turned(self.along(data), q[0]), None

    def symbols(self, model, data, frame, point, q, rates):
        own = me.ReferenceFrame(model.name("F"))
        axis = vector(self.along(data), frame)
        own.orient_axis(frame, axis, q[0])
        if model.said:
            own.set_ang_vel(frame, rates[0] * axis.normalize())
        return own, point, {}


class Slide(Turn):
    lengths = (1,)

    def numbers(self, data, q, time):
        axis = np.array(self.along(data), LONG)
        return None, q[0][..., None] * (axis / np.sqrt(axis @ axis))

    def symbols(self, model, data, frame, point, q, rates):
        axis = vector(self.along(data), frame).normalize()
        return frame, model.moved(point, q[0] * axis, rates[0] * axis, frame), {}


class Screw(Turn):
    """A rotation that moves along its axis by a pitch."""

    def numbers(self, data, q, time):
        axis = np.array(self.along(data), LONG)
        way = data["pitch"] * q[0][..., None] * (axis / np.sqrt(axis @ axis))
        return turned(axis, q[0]), way

    def symbols(self, model, data, frame, point, q, rates):
        axis = vector(self.along(data), frame).normalize()
        point = model.moved(
            point, data["pitch"] * q[0] * axis, data["pitch"] * rates[0] * axis, frame
        )
        return super().symbols(model, data, frame, point, q, rates)


class Track(Slide):
    """A parabola: along the axis x, and aside by the bend times the square."""

    def numbers(self, data, q, time):
        aside = data["bend"] * multiply(q[0], q[0])
        return None, np.stack([q[0], aside, 0 * aside], axis=-1)

    def symbols(self, model, data, frame, point, q, rates):
        way = q[0] * frame.x + data["bend"] * q[0] ** 2 * frame.y
        speed = rates[0] * frame.x + 2 * data["bend"] * q[0] * rates[0] * frame.y
        return frame, model.moved(point, way, speed, frame), {}


class Quaternion:
    """Four coordinates, three speeds: the angular velocity in the body's axes."""

    lengths = (0, 0, 0, 0)

    def numbers(self, data, q, time):
        p = [[multiply(a, b) for b in q] for a in q]
        a, b, c, d = (p[k][k] for k in range(4))
        rows = [
            [a + b - c - d, 2 * (p[1][2] - p[0][3]), 2 * (p[0][2] + p[1][3])],
            [2 * (p[1][2] + p[0][3]), a - b + c - d, 2 * (p[2][3] - p[0][1])],
            [2 * (p[1][3] - p[0][2]), 2 * (p[2][3] + p[0][1]), a - b - c + d],
        ]
        return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2), None

    def symbols(self, model, data, frame, point, q, rates):
        own = me.ReferenceFrame(model.name("F"))
        own.orient_quaternion(frame, q)
        own.set_ang_vel(frame, vector(rates, own))
        return own, point, {}


class Driven:
    """A rotation about an axis by an angle that is a function of time, or a specified."""

    lengths = ()

    def numbers(self, data, q, time):
        motions = time.shape[1]
        angle = constant(0, motions)
        if "drive" in data:
            angle[0] = data["drive"]
            angle[1, 0], angle[2, 0] = data["drive_rate"], data["drive_bend"] / 2
        else:
            angle = data["swing"] * cos_sin(data["frequency"] * time)[1]
        return turned(data["axis"], angle), None

    def symbols(self, model, data, frame, point, q, rates):
        own = me.ReferenceFrame(model.name("F"))
        if "drive" in data:
            angle = model.prescribed([data["drive"], data["drive_rate"], data["drive_bend"]])
        else:
            angle = data["swing"] * sm.sin(data["frequency"] * T)
        axis = vector(data["axis"], frame)
        own.orient_axis(frame, axis, angle)
        if model.said:
            own.set_ang_vel(frame, sm.sympify(angle).diff(T) * axis.normalize())
        return own, point, {}


# How often each is drawn, its elements, what it draws, and SymPy's joint where there is one.
JOINTS = {
    "pin": (8, [Turn()], lambda rng: {"axis": draw_axis(rng)}, me.PinJoint),
    "slide": (4, [Slide()], lambda rng: {"axis": draw_axis(rng)}, me.PrismaticJoint),
    "cylinder": (2, [Turn(), Slide()], lambda rng: {"axis": draw_axis(rng)}, me.CylindricalJoint),
    "planar": (1, [Slide("y"), Slide("z"), Turn("x")], lambda rng: {}, me.PlanarJoint),
    "ball": (2, [Turn("x"), Turn("y"), Turn("z")], lambda rng: {}, me.SphericalJoint),
    "weld": (1, [], lambda rng: {}, me.WeldJoint),
    "cardan": (2, [Turn("x"), Turn("z")], lambda rng: {}, None),
    "screw": (
        1, [Screw()], lambda rng: {"axis": draw_axis(rng), "pitch": decimal(rng, 0.1, 0.6)}, None,
    ),
    "track": (1, [Track("x")], lambda rng: {"bend": decimal(rng, -0.6, 0.6)}, None),
    "free": (
        1, [Slide("x"), Slide("y"), Slide("z"), Quaternion()], lambda rng: {}, None,
    ),
    "gyro": (1, [Quaternion()], lambda rng: {}, None),
    "swung": (
        1, [Driven()],
        lambda rng: {"axis": draw_axis(rng)}
        | {"swing": decimal(rng, 0.2, 0.9), "frequency": decimal(rng, 0.5, 2)},
        None,
    ),
    "driven": (
        1, [Driven()],
        lambda rng: {"axis": draw_axis(rng)}
        | {f"drive{part}": decimal(rng, 0.1, 0.9) for part in ("", "_rate", "_bend")},
        None,
    ),
}  # fmt: skip
