"""What the bicycle of the demo looks like: tubes, wheels, a rider, and the tracks on the ground.

The measures are those of the benchmark where it gives them, the rest is drawn by eye.  All of it is
for looking at only; the equations of motion know four rigid bodies and no shapes.

Examples
--------
>>> from pydy.examples import bicycle_scene, whipple_bicycle
>>> visuals = bicycle_scene.visuals(whipple_bicycle.derive())
>>> sorted({visual.name for visual in visuals})[:3]
['front fork', 'front track', 'front wheel']
"""

from __future__ import annotations

from math import cos, pi, sin
from typing import TYPE_CHECKING

import sympy as sm

from pydy.examples.whipple_bicycle import BENCHMARK, Bicycle
from pydy.system import System
from pydy.viz import Arrow, Capsule, Line, Scene, Sphere, Torus, Trace, Visual

if TYPE_CHECKING:
    from sympy.physics.mechanics import Point, ReferenceFrame

__all__ = ["scene", "visuals"]
__dir__ = __all__.copy

TYRE, RIM, STEEL, DARK = "#4a505b", "#aab3c0", "#c9433e", "#5a6270"
SHIRT, TROUSERS, SKIN = "#3f7fc4", "#56617a", "#d9a27e"
PUSH = "#e0a92e"
TYRE_RADIUS = 0.016
SPOKES = 14


def visuals(bicycle: Bicycle) -> list[Visual]:
    """Return the visuals of a bicycle with the benchmark's measures.

    Parameters
    ----------
    bicycle : Bicycle
        What `pydy.examples.whipple_bicycle.derive` returned.

    Returns
    -------
    list of Visual
        Parts of one body have one name, so that they share a row of the legend.
    """
    parts = _BicycleVisuals(bicycle)
    rear, front = parts.rear, parts.front
    points = bicycle.points

    # Along the steer axis: above the ground by `s`, in the upright bicycle's x and z.
    def axis(s: float) -> tuple[float, float]:
        lam = BENCHMARK["lam"]
        return BENCHMARK["w"] + BENCHMARK["c"] - s * sin(lam), -s * cos(lam)

    bracket, saddle, seat = rear(0.44, -0.28), rear(0.24, -0.96), rear(0.28, -0.82)
    head_low, head_high = rear(*axis(0.76)), rear(*axis(0.90))
    for start, end, radius in (
        (bracket, saddle, 0.015),
        (bracket, head_low, 0.02),
        (seat, head_high, 0.016),
        (head_low, head_high, 0.024),
    ):
        parts.rod("rear frame", [start, end], radius, STEEL)
    for side in (-1, 1):
        drop = rear(0.0, -0.3, 0.06 * side)
        parts.rod("rear frame", [bracket, drop, seat], 0.009, STEEL)
    parts.add(Visual(Capsule(0.17, 0.035, "x", colour=DARK), parts.B, saddle, name="rear frame"))

    crown, stem = front(*axis(0.72)), front(*axis(0.97))
    bar = [(0.72, -0.99, -0.27), (0.86, -1.0, -0.2), (0.87, -0.99, 0.0)]
    bar += [(x, z, -y) for x, z, y in bar[1::-1]]
    parts.rod("front fork", [crown, stem, front(0.87, -0.99)], 0.015, STEEL)
    parts.rod("front fork", [front(*coordinates) for coordinates in bar], 0.012, DARK)
    for side in (-1, 1):
        shoulder, drop = front(*axis(0.72), 0.05 * side), front(1.02, -0.35, 0.055 * side)
        parts.rod("front fork", [crown, shoulder, drop], 0.012, STEEL)

    for name, frame, hub, radius in (
        ("rear wheel", "R", "Ro", BENCHMARK["r_R"]),
        ("front wheel", "F", "Fo", BENCHMARK["r_F"]),
    ):
        parts.wheel(name, bicycle.frames[frame], points[hub], radius)
    parts.rider()
    for name, point, colour in (("rear track", "P", "#ee8b3a"), ("front track", "Pf", "#35a883")):
        parts.add(Visual(Trace(colour=colour), points[point], name=name))
    # A newton is 3 mm of arrow.
    push = Arrow(bicycle.push * bicycle.frames["A"].y, scale=0.003, radius=0.018, colour=PUSH)
    parts.add(Visual(push, points["Bo"], name="push"))
    return parts.visuals


def scene(system: System, bicycle: Bicycle, title: str) -> Scene:
    """Return the scene of a bicycle, with roll and steer plotted below.

    Parameters
    ----------
    system : System
        Made from the bicycle's equations.
    bicycle : Bicycle
    title : str
    """
    degrees = 180 / sm.pi
    return system.scene(
        *visuals(bicycle),
        origin=bicycle.points["O"],
        up="-z",
        ground=0.0,
        title=title,
        series={"roll [°]": bicycle["phi"] * degrees, "steer [°]": bicycle["delta"] * degrees},
    )


class _BicycleVisuals:
    """Collects visuals; positions are given as x, z and y of the upright bicycle."""

    def __init__(self, bicycle: Bicycle) -> None:
        self.visuals: list[Visual] = []
        self.B, self.H = bicycle.frames["B"], bicycle.frames["H"]
        self._hubs = bicycle.points["Ro"], bicycle.points["Fo"]

    def add(self, visual: Visual) -> None:
        self.visuals.append(visual)

    def rod(self, name: str, points: list[Point], radius: float, colour: str) -> None:
        self.add(Visual(Line(points, radius=radius, colour=colour), name=name))

    def rear(self, x: float, z: float, y: float = 0.0) -> Point:
        """Return a point of the rear frame."""
        B = self.B
        arm = x * B.x + y * B.y + (z + BENCHMARK["r_R"]) * B.z
        return self._hubs[0].locatenew("rear frame", arm)

    def front(self, x: float, z: float, y: float = 0.0) -> Point:
        """Return a point of the front frame."""
        H = self.H
        arm = (x - BENCHMARK["w"]) * H.x + y * H.y + (z + BENCHMARK["r_F"]) * H.z
        return self._hubs[1].locatenew("front frame", arm)

    def wheel(self, name: str, frame: ReferenceFrame, hub: Point, radius: float) -> None:
        tyre = Torus(radius - TYRE_RADIUS, TYRE_RADIUS, "y", colour=TYRE)
        rim = Torus(radius - 0.038, 0.009, "y", colour=RIM)
        self.add(Visual(tyre, frame, hub, name=name))
        self.add(Visual(rim, frame, hub, name=name))
        self.add(Visual(Capsule(0.07, 0.018, "y", colour=RIM), frame, hub, name=name))
        # One line that alternates between the rim and the two sides of the hub.
        stations = []
        for k in range(SPOKES):
            for angle, distance, y in (
                (2 * k, radius - 0.04, 0.0),
                (2 * k + 0.5, 0.016, 0.025 * (-1) ** k),
            ):
                turn = pi * angle / SPOKES
                vector = distance * (cos(turn) * frame.x + sin(turn) * frame.z) + y * frame.y
                stations.append(hub.locatenew("spoke", vector))
        self.rod(name, [*stations, stations[0]], 0.002, RIM)

    def rider(self) -> None:
        rear = self.rear
        hip, neck = rear(0.25, -1.04), rear(0.36, -1.47)
        self.rod("rider", [hip, neck], 0.1, SHIRT)
        self.add(Visual(Sphere(0.105, colour=SKIN), rear(0.40, -1.69), name="rider"))
        for side in (-1, 1):
            limbs = [(0.27, -1.03, 0.07), (0.62, -0.86 + 0.1 * side, 0.1)]
            foot = (0.45 + 0.16 * side, -0.31 + 0.04 * side, 0.11)
            thigh, knee, ankle = (rear(x, z, y * side) for x, z, y in (*limbs, foot))
            self.rod("rider", [thigh, knee], 0.068, TROUSERS)
            self.rod("rider", [knee, ankle], 0.045, TROUSERS)
            toe = rear(foot[0] + 0.12, foot[1] + 0.03, foot[2] * side)
            self.rod("rider", [ankle, toe], 0.035, DARK)
            # Hands off: they rest on the thighs.
            arm = [(0.36, -1.43, 0.17), (0.30, -1.16, 0.24), (0.50, -1.0, 0.14)]
            shoulder, elbow, hand = (rear(x, z, y * side) for x, z, y in arm)
            self.rod("rider", [neck, shoulder, elbow], 0.045, SHIRT)
            self.rod("rider", [elbow, hand], 0.036, SKIN)
