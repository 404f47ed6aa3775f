"""Many trajectories of one model: `pydy.system.System.integrate_ensemble` and what is behind it.

Nothing here knows a System: a `Model` of Programs, names and options, `Samples` of numbers, and an
engine that brings them together in blocks, on threads or as Dask's tasks.
"""
