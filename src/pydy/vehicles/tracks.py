"""Tracks: roads in the plane, and the least time in which a vehicle drives along them.

`Track` is a road, `read_track` reads one from a file; `along` brings a planar vehicle into
coordinates along a track, in which `TrackSystem.least_time` finds the fastest `Lap`.
"""

from pydy.vehicles.curvilinear import TrackSystem, along
from pydy.vehicles.lap import Lap
from pydy.vehicles.track import Track, read_track

__all__ = ["Lap", "Track", "TrackSystem", "along", "read_track"]
