"""What all parts of mechanisms are drawn with, and the dimensions of their numbers."""

import numpy as np
import sympy.physics.mechanics as me

T = me.dynamicsymbols._t
DIMENSIONS = {
    "at": (1, 0, 0), "centre": (1, 0, 0), "mass": (0, 1, 0), "inertia": (2, 1, 0),
    "gravity": (1, 0, -2), "time": (0, 0, 1), "pitch": (1, 0, 0), "bend": (-1, 0, 0),
    "frequency": (0, 0, -1), "push": (1, 1, -2), "moment": (2, 1, -2), "stiffness": (0, 1, -2),
    "damping": (0, 1, -1), "twist": (2, 1, -2), "friction": (2, 1, -1), "drag": (-1, 1, 0),
    "length": (1, 0, 0), "radius": (1, 0, 0), "height": (1, 0, 0), "drive_rate": (0, 0, -1),
    "drive_bend": (0, 0, -2), "added": (0, 1, 0),
}  # fmt: skip
AXES = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}


def vector(parts, frame):
    return sum((p * e for p, e in zip(parts, frame, strict=True)), 0 * frame.x)


def draw_axis(rng):
    if rng.random() < 0.4:
        return list(map(float, rng.permutation([1, 0, 0])))
    return decimals(rng, 3, 1.5, 2)


def decimals(rng, n, size, digits):
    return [float(v) for v in np.round(rng.uniform(-size, size, n), digits)]


def decimal(rng, low, high, digits=2):
    return float(np.round(rng.uniform(low, high), digits))


def draw_spot(rng, bodies, ground=False):
    first = -1 if ground and rng.random() < 0.4 else 0
    return {
        "body": int(rng.integers(first, bodies)),
        "at": decimals(rng, 3, 1.5, int(rng.integers(1, 4))),
    }
