"""The parts of `pydy.trajectory.Trajectory`: its names, its interpolation, its tables and files."""
