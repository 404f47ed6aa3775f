"""Constraints: drawn, settled at a state, in numbers for the oracle, in SymPy for the front ends.

A new one is a class and an entry of `LOOPS`.
"""

import numpy as np
import sympy as sm

from mechanisms.drawing import decimal, decimals, draw_axis, draw_spot, vector
from mechanisms.taylor import (
    LONG,
    dot,
    rate,
    rotate,
    square_root,
)


class Closure:
    """Draws two points of which the second is settled so that they meet."""

    def draw(self, rng, data):
        n = len(data["bodies"])
        body = int(rng.integers(n))
        other = int(rng.integers(-1, n))
        if other == body:
            other = -1
        spot = {"body": body, "at": decimals(rng, 3, 1, 1)}
        return {"from": {"body": other, "at": [0.0, 0.0, 0.0]}, "to": spot}

    def settle(self, world, loop):
        """Put the first point where the second is."""
        loop["from"]["at"] = [float(v) for v in world.offset(loop["from"]["body"], loop["to"])]

    def gap(self, world, loop):
        a, b = world.series(loop["from"]), world.series(loop["to"])
        size = np.abs(a[1, 1:]).sum(-1) + np.abs(b[1, 1:]).sum(-1)
        return b - a, size


class Meet(Closure):
    """Two points meet: three rows."""

    def numbers(self, world, loop):
        gap, size = self.gap(world, loop)
        return [("position", gap[..., k], size) for k in range(3)]

    def symbols(self, model, loop):
        gap = model.spot(loop["to"]).pos_from(model.spot(loop["from"]))
        return [("position", gap.dot(e)) for e in model.ground]


class Hinge(Meet):
    """Two points meet and two axes are parallel: five rows."""

    def settle(self, world, loop):
        super().settle(world, loop)
        axis = world.turn(loop["to"]["body"]) @ np.array(loop["axis"], LONG)
        own = world.turn(loop["from"]["body"]).T @ axis
        other = np.cross(own, np.eye(3)[int(np.argmin(abs(own)))])
        loop["across"] = [[float(v) for v in other], [float(v) for v in np.cross(own, other)]]

    def draw(self, rng, data):
        return super().draw(rng, data) | {
            "axis": list(data.get("plane") or draw_axis(rng)),
            "across": [],
        }

    def numbers(self, world, loop):
        rows = super().numbers(world, loop)
        axis = rotate(world.turns(loop["to"]["body"]), np.array(loop["axis"], LONG))
        for across in loop["across"]:
            other = rotate(world.turns(loop["from"]["body"]), np.array(across, LONG))
            size = np.abs(other[0, 1:]).max() * np.abs(axis[1, 1:]).sum(-1)
            size = size + np.abs(axis[0, 1:]).max() * np.abs(other[1, 1:]).sum(-1)
            rows.append(("position", dot(axis, other), size))
        return rows

    def symbols(self, model, loop):
        rows = super().symbols(model, loop)
        axis = vector(loop["axis"], model.frame(loop["to"]["body"]))
        frame = model.frame(loop["from"]["body"])
        return rows + [("position", axis.dot(vector(a, frame))) for a in loop["across"]]


class Slot(Closure):
    """A point of one body lies in a plane of another: one row."""

    def draw(self, rng, data):
        return super().draw(rng, data) | {"axis": draw_axis(rng)}

    def numbers(self, world, loop):
        gap, size = self.gap(world, loop)
        axis = rotate(world.turns(loop["from"]["body"]), np.array(loop["axis"], LONG))
        return [("position", dot(gap, axis), size * np.abs(axis[0, 0]).max())]

    def symbols(self, model, loop):
        gap = model.spot(loop["to"]).pos_from(model.spot(loop["from"]))
        return [("position", gap.dot(vector(loop["axis"], model.frame(loop["from"]["body"]))))]


class Rod(Closure):
    """Two points keep their distance, as a root or as a square: one row."""

    def draw(self, rng, data):
        found = super().draw(rng, data)
        found["from"]["at"] = decimals(rng, 3, 2, 2)
        return found | {"length": 1.0, "root": bool(rng.integers(2))}

    def settle(self, world, loop):
        gap = self.gap(world, loop)[0][0, 0]
        loop["length"] = float(np.sqrt(gap @ gap))

    def numbers(self, world, loop):
        gap, size = self.gap(world, loop)
        square = dot(gap, gap)
        if loop["root"]:
            length = square_root(square)
            length[0] -= loop["length"]
            return [("position", length, size)]
        found = square.copy()
        found[0] -= loop["length"] ** 2
        return [("position", found, 2 * size * loop["length"])]

    def symbols(self, model, loop):
        gap = model.spot(loop["to"]).pos_from(model.spot(loop["from"]))
        square = gap.dot(gap)
        root = loop["root"]
        return [
            ("position", sm.sqrt(square) - loop["length"] if root else square - loop["length"] ** 2)
        ]


class Skate:
    """A point moves only in a plane of its body: one row of the speeds."""

    def draw(self, rng, data):
        return draw_spot(rng, len(data["bodies"])) | {"axis": draw_axis(rng)}

    def settle(self, world, loop):
        pass

    def numbers(self, world, loop):
        velocity = rate(world.series(loop))
        axis = rotate(world.turns(loop["body"]), np.array(loop["axis"], LONG))
        size = np.abs(velocity[0, 1:]).sum(-1) * np.abs(axis[0, 0]).max()
        return [("speed", dot(velocity, axis), size)]

    def symbols(self, model, loop):
        velocity = model.velocity(model.spot(loop))
        return [("speed", velocity.dot(vector(loop["axis"], model.frames[loop["body"]])))]


class Roll:
    """A sphere about a body's mass centre rolls on a plane z = height."""

    def draw(self, rng, data):
        return {
            "body": int(rng.integers(len(data["bodies"]))),
            "radius": decimal(rng, 0.2, 0.9),
            "height": 0.0,
        }

    def settle(self, world, loop):
        loop["height"] = float(
            world.series({"body": loop["body"], "at": [0, 0, 0]})[0, 0, 2] - loop["radius"]
        )

    def numbers(self, world, loop):
        place = world.series({"body": loop["body"], "at": [0, 0, 0]})
        spin = world.spins(loop["body"])
        arm = np.array([0, 0, -loop["radius"]], LONG)
        slip = rate(place) + np.cross(spin, arm)
        size = np.abs(place[1, 1:]).sum(-1) + np.abs(spin[0, 1:]).sum(-1) * loop["radius"]
        above = place[..., 2].copy()
        above[0] -= loop["height"] + loop["radius"]
        return [("position", above, size), *(("speed", slip[..., k], size) for k in (0, 1))]

    def symbols(self, model, loop):
        N, centre = model.ground, model.centres[loop["body"]]
        spin = model.frames[loop["body"]].ang_vel_in(N)
        slip = model.velocity(centre) + spin.cross(-loop["radius"] * N.z)
        above = centre.pos_from(model.origin).dot(N.z) - loop["height"] - loop["radius"]
        return [("position", above), ("speed", slip.dot(N.x)), ("speed", slip.dot(N.y))]


class Again:
    """A sum of the rows before it, of positions and of speeds: rows that are redundant."""

    def draw(self, rng, data):
        return {"weights": decimals(rng, 4, 2, 1)}

    def settle(self, world, loop):
        pass

    def combined(self, rows, loop, add):
        found = []
        for kind in ("position", "speed"):
            own = [row for row in rows if row[0] == kind]
            if own:
                found.append(
                    (kind, *add(own, [w for w, _ in zip(loop["weights"], own, strict=False)]))
                )
        return found


LOOPS = {
    "meet": Meet(), "hinge": Hinge(), "slot": Slot(), "rod": Rod(), "skate": Skate(),
    "roll": Roll(), "again": Again(),
}  # fmt: skip
