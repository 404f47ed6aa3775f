"""Loads: drawn, in numbers for the oracle, and in SymPy for the front ends.

A new load is a class and an entry of `LOADS`; without ``potential`` it has an energy of its own.
"""

import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

from mechanisms.drawing import T, decimal, decimals, draw_spot, vector
from mechanisms.taylor import (
    LONG,
)


class Push:
    """A constant force, in the axes of a body or of the ground."""

    potential = None

    def draw(self, rng, data):
        return draw_spot(rng, len(data["bodies"])) | {
            "push": decimals(rng, 3, 3, 1),
            "fixed": bool(rng.integers(2)),
        }

    def symbols(self, model, load):
        axes = model.ground if load["fixed"] else model.frames[load["body"]]
        return [(model.spot(load), vector(load["push"], axes))]

    def numbers(self, world, load):
        force = np.array(load["push"], LONG)
        world.push(load, force if load["fixed"] else world.turn(load["body"]) @ force)


class Motor:
    """A torque on a body, and its reaction on the body before."""

    potential = None

    def draw(self, rng, data):
        body = int(rng.integers(len(data["bodies"])))
        return {
            "body": body,
            "moment": decimal(rng, -3, 3),
            "about": decimals(rng, 3, 1, 1),
            "held": bool(rng.integers(2)),
        }

    def symbols(self, model, load):
        own = model.frames[load["body"]]
        if not any(load["about"]):
            return []
        parent = model.parents[load["body"]]
        if not load["held"]:
            return [(own, load["moment"] * vector(load["about"], own))]
        other = model.ground if parent < 0 else model.frames[parent]
        return [me.TorqueActuator(load["moment"], vector(load["about"], own), own, other)]

    def numbers(self, world, load):
        torque = load["moment"] * (world.turn(load["body"]) @ np.array(load["about"], LONG))
        world.twist(load["body"], torque)
        if load["held"]:
            world.twist(world.parents[load["body"]], -torque)


class Between:
    """What acts along the line between two points."""

    own = ()

    def draw(self, rng, data):
        n = len(data["bodies"])
        return {
            "from": draw_spot(rng, n, ground=True), "to": draw_spot(rng, n),
            **{name: decimal(rng, *limits) for name, *limits in self.own},
        }  # fmt: skip

    def symbols(self, model, load):
        if load["from"]["body"] == load["to"]["body"]:
            return []
        pathway = me.LinearPathway(model.spot(load["from"]), model.spot(load["to"]))
        return [self.actuator(load, pathway)]

    def numbers(self, world, load):
        if load["from"]["body"] == load["to"]["body"]:
            return
        (a, va), (b, vb) = world.motion(load["from"]), world.motion(load["to"])
        length = np.sqrt((b - a) @ (b - a))
        along = (b - a) / length
        pull = self.tension(load, length, along @ (vb - va))
        world.push(load["from"], pull * along)
        world.push(load["to"], -pull * along)


class Spring(Between):
    own = (
        ("stiffness", 0.5, 4),
        ("length", 0.2, 1.5),
    )

    def actuator(self, load, pathway):
        return me.LinearSpring(load["stiffness"], pathway, load["length"])

    def tension(self, load, length, speed):
        return load["stiffness"] * (length - load["length"])

    def potential(self, world, load):
        if load["from"]["body"] == load["to"]["body"]:
            return LONG(0)
        way = world.motion(load["to"])[0] - world.motion(load["from"])[0]
        return load["stiffness"] * (np.sqrt(way @ way) - load["length"]) ** 2 / 2


class Damper(Between):
    own = (("damping", 0.1, 1),)

    def actuator(self, load, pathway):
        return me.LinearDamper(load["damping"], pathway)

    def tension(self, load, length, speed):
        return load["damping"] * speed

    def potential(self, world, load):
        return LONG(0)


class Drag:
    """A force against a point's velocity, and as its square."""

    def draw(self, rng, data):
        return draw_spot(rng, len(data["bodies"])) | {"drag": decimal(rng, 0.1, 0.9)}

    def symbols(self, model, load):
        point = model.spot(load)
        velocity = model.velocity(point)
        return [(point, -load["drag"] * sm.sqrt(velocity.dot(velocity)) * velocity)]

    def numbers(self, world, load):
        velocity = world.motion(load)[1]
        world.push(load, -load["drag"] * np.sqrt(velocity @ velocity) * velocity)

    def potential(self, world, load):
        return LONG(0)


class AtCoordinate:
    """A torque about the axis of a pin, as a function of its angle and rate."""

    own = ()

    def draw(self, rng, data):
        pins = [k for k, body in enumerate(data["bodies"]) if body["joint"] == "pin"]
        if not pins:
            return None
        return {
            "body": int(rng.choice(pins)),
            **{name: decimal(rng, *limits) for name, *limits in self.own},
        }

    def symbols(self, model, load):
        k = load["body"]
        if model.kinds[k] != "pin":
            return []
        other = model.ground if model.parents[k] < 0 else model.frames[model.parents[k]]
        return [
            me.TorqueActuator(
                self.symbolic(load, *model.joint_motion(k)), model.axes[k], model.frames[k], other
            )
        ]

    def numbers(self, world, load):
        k = load["body"]
        if world.kinds[k] != "pin":
            return
        torque = self.numeric(load, *world.joint_motion(k)) * world.axis(k)
        world.twist(k, torque)
        world.twist(world.parents[k], -torque)


class Coil(AtCoordinate):
    own = (
        ("twist", 0.5, 4),
        ("rest", -0.5, 0.5),
    )

    def symbolic(self, load, q, rate):
        return -load["twist"] * (q - load["rest"])

    numeric = symbolic

    def potential(self, world, load):
        if world.kinds[load["body"]] != "pin":
            return LONG(0)
        return load["twist"] * (world.joint_motion(load["body"])[0] - load["rest"]) ** 2 / 2


class Friction(AtCoordinate):
    own = (
        ("friction", 0.1, 0.9),
        ("cubic", 0.1, 0.9),
    )

    def symbolic(self, load, q, rate):
        return -load["friction"] * rate

    numeric = symbolic

    def potential(self, world, load):
        return LONG(0)


class Stop(AtCoordinate):
    """A spring on one side, Piecewise."""

    own = (
        ("twist", 0.5, 4),
        ("rest", -0.5, 0.5),
    )

    def symbolic(self, load, q, rate):
        return sm.Piecewise((-load["twist"] * (q - load["rest"]), q > load["rest"]), (0, True))

    def numeric(self, load, q, rate):
        return -load["twist"] * (q - load["rest"]) if q > load["rest"] else LONG(0)

    def potential(self, world, load):
        if world.kinds[load["body"]] != "pin":
            return LONG(0)
        return (
            load["twist"]
            * max(world.joint_motion(load["body"])[0] - load["rest"], LONG(0)) ** 2
            / 2
        )


class Wind(Push):
    """A force that swings with time."""

    def draw(self, rng, data):
        return super().draw(rng, data) | {"frequency": decimal(rng, 0.5, 2)}

    def symbols(self, model, load):
        ((point, force),) = super().symbols(model, load)
        return [(point, force * sm.sin(load["frequency"] * T))]

    def numbers(self, world, load):
        force = np.array(load["push"], LONG) * np.sin(load["frequency"] * world.time)
        world.push(load, force if load["fixed"] else world.turn(load["body"]) @ force)


LOADS = {
    "push": Push(), "motor": Motor(), "spring": Spring(), "damper": Damper(), "drag": Drag(),
    "coil": Coil(), "friction": Friction(), "stop": Stop(), "wind": Wind(),
}  # fmt: skip
