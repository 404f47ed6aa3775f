"""The models of CommonRoad: two with a single track, and one of several bodies."""
