"""The compiled loops of one trajectory, as they are written for numba."""
