"""Many trajectories of one model: the implementation of `System.integrate_ensemble`.

This package is independent of System: a `Model` of Programs, names and options, `Samples` of
numbers, and an engine that runs them in blocks, in threads or as Dask tasks.
"""
