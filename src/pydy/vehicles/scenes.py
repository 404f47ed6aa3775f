"""Pictures of cars: a body, four wheels that steer, and the cones of a lane change."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import sympy.physics.mechanics as me

from pydy._checks import instance, positive
from pydy.system import System
from pydy.vehicles.cars import DoubleTrackCar, SingleTrackCar
from pydy.vehicles.lane_change import LaneChange
from pydy.vehicles.manoeuvres import check_name, coordinate_of, names_of, three_names

if TYPE_CHECKING:
    from pydy.viz import Scene

__all__ = ["car_scene"]
__dir__ = __all__.copy

# Measures (m) that no equation of motion knows: drawn by eye.
_RADIUS, _TIRE = 0.33, 0.2
_CLEARANCE, _SILL, _WAIST, _ROOF = 0.18, 0.46, 0.85, 1.4  # heights
# Shares of length and width.
_TRACK, _FLOOR, _FLOOR_WIDTH, _CABIN, _CABIN_WIDTH, _CABIN_REAR = 0.88, 0.95, 0.7, 0.5, 0.88, 0.04
_CONE_HEIGHT, _CONE_RADIUS = 0.5, 0.14
_PAINT, _GLASS, _RUBBER, _CONE, _TOUCHED = "#3f7fc4", "#5a6270", "#33373f", "#e8742c", "#c9433e"
_TRAILER, _TRAILER_ROOF, _TRAILER_LENGTH, _DRAWBAR = "#b9bfc9", 1.9, 1.3, 0.05


def car_scene(
    system: System,
    car: SingleTrackCar,
    *,
    change: LaneChange | None = None,
    width: float = 1.7,
    length: float = 4.5,
    steering: str = "delta",
    position: Sequence[str] = ("x", "y", "psi"),
    **options: Any,
) -> Scene:
    """Return a scene of a car in the plane, for animations and live pages.

    Wheels are where the car has its axles; those in front turn with the steering angle. They do not
    spin: the models have no angles of the wheels. A car with two axles and no track widths gets
    wheels at its sides. A trailer of `car_trailer` has a box about its axle, 1.3 times as long as
    the axle is behind the hitch, and as wide as the car.

    Parameters
    ----------
    system : System
        A car, such as `single_track` or `double_track` returns.
    car : SingleTrackCar
        Its constants.
    change : LaneChange, optional
        What `lane_change` returned: its cones are shown, those that are touched in red. Animate the
        scene with its `trajectory`.
    width, length : float, optional
        Of the body (m), which has its middle at the mass centre.
    steering : str, optional
        The specified that is the steering angle.
    position : three of str, optional
        The coordinates of the mass centre, and the yaw angle.
    **options
        Of `pydy.viz.Scene`: `follow`, `view`, `series`, `units` and `title`.

    Returns
    -------
    pydy.viz.Scene

    Examples
    --------
    >>> from pydy.vehicles import CARS, lane_change, single_track
    >>> from pydy.vehicles.scenes import car_scene
    >>> system = single_track(CARS['bmw_320i'], speed=18.0)
    >>> change = lane_change(system, 1.61)
    >>> scene = car_scene(system, CARS['bmw_320i'], change=change, width=1.61)
    >>> scene.animate(change.trajectory).poses.shape[1]  # body, four wheels, thirty cones
    37
    """
    # Pictures are loaded where they are made.
    from pydy.viz import Box, Cone, Cylinder, Line, Visual

    instance(system, System, "`system`", "a System, such as single_track returns")
    instance(car, SingleTrackCar, "`car`", "a SingleTrackCar, such as one of CARS")
    if change is not None:
        instance(change, LaneChange, "`change`", "what lane_change returns, or None")
    width = positive(width, "`width`", finite=True)
    length = positive(length, "`length`", finite=True)
    specifieds = {name: s for s in system.specifieds_symbols for name in names_of([s])}
    check_name(steering, "steering", list(specifieds))
    delta = specifieds[steering]
    x, y, psi = (coordinate_of(system, name, k) for k, name in enumerate(three_names(position)))

    N, B, S = (me.ReferenceFrame(name) for name in ("N", "B", "S"))
    B.orient_axis(N, N.z, psi)
    S.orient_axis(B, B.z, delta)
    O = me.Point("O")
    G = O.locatenew("G", x * N.x + y * N.y)

    def at(name: str, forward: float, left: float, up: float) -> me.Point:
        return G.locatenew(name, forward * B.x + left * B.y + up * B.z)

    radius, tracks = _RADIUS, (_TRACK * width, _TRACK * width)
    if isinstance(car, DoubleTrackCar):
        radius, tracks = car.wheel_radius, (car.front_track, car.rear_track)
    visuals = []
    for name, forward, x_edge, y_edge, low, high, colour in (
        ("body", 0.0, length, width, _SILL, _WAIST, _PAINT),
        ("floor", 0.0, _FLOOR * length, _FLOOR_WIDTH * min(tracks), _CLEARANCE, _SILL, _PAINT),
        ("cabin", -_CABIN_REAR * length, _CABIN * length, _CABIN_WIDTH * width, _WAIST, _ROOF,
         _GLASS),
    ):  # fmt: skip
        centre = at(name, forward, 0.0, (low + high) / 2)
        box = Box(x_edge, y_edge, high - low, colour=colour)
        visuals.append(Visual(box, B, centre, name="body"))
    wheel = Cylinder(_TIRE, radius, "y", colour=_RUBBER)
    for frame, forward, track, axle in (
        (S, car.front, tracks[0], "front"),
        (B, -car.rear, tracks[1], "rear"),
    ):
        for side, word in ((1, "left"), (-1, "right")):
            centre = at(f"{axle} {word}", forward, side * track / 2, radius)
            visuals.append(Visual(wheel, frame, centre, name=f"{axle} wheels"))
    bodies = getattr(system.eom_method, "bodies", None) or ()
    lengths = {str(symbol): symbol for symbol in system.constants_symbols}
    # A model of one's own may have a body of this name, and no such constants.
    if any(body.name == "trailer" for body in bodies) and {"c", "l"} <= lengths.keys():
        c, l = lengths["c"], lengths["l"]
        turned = B.orientnew("trailer", "Axis", (coordinate_of(system, "phi", 3), B.z))
        hitch = G.locatenew("hitch", -c * B.x + _SILL * B.z)
        axle = hitch.locatenew("trailer axle", -l * turned.x)
        height = _TRAILER_ROOF - _SILL
        box = Box(_TRAILER_LENGTH * l, width, height, colour=_TRAILER)
        visuals.append(
            Visual(box, turned, axle.locatenew("trailer", height / 2 * B.z), name="trailer")
        )
        bar = Line([hitch, axle], radius=_DRAWBAR, colour=_RUBBER)
        visuals.append(Visual(bar, name="trailer"))
        for side, word in ((1, "left"), (-1, "right")):
            place = side * tracks[1] / 2 * turned.y + (radius - _SILL) * B.z
            centre = axle.locatenew(f"trailer {word}", place)
            visuals.append(Visual(wheel, turned, centre, name="trailer wheels"))
    if change is not None:
        upright, fallen = (
            Cone(_CONE_HEIGHT, _CONE_RADIUS, "z", colour=colour) for colour in (_CONE, _TOUCHED)
        )
        for k, (cone, gap) in enumerate(zip(change.cones, change.clearances, strict=True)):
            where = float(cone[0]) * N.x + float(cone[1]) * N.y + _CONE_HEIGHT / 2 * N.z
            # A cone that the car never passes has no clearance.
            shape, name = (fallen, "touched cones") if gap <= 0.0 else (upright, "cones")
            visuals.append(Visual(shape, O.locatenew(f"cone {k + 1}", where), name=name))
    usual = {"up": "z", "ground": 0.0, "follow": True, "view": (-0.85, -0.35, 0.45)}
    frames = {"reference_frame": N, "origin": O}
    return system.scene(*visuals, **{**usual, **options, **frames})
