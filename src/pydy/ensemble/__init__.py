"""Many trajectories of one model: the implementation of `System.integrate_ensemble`.

`integration` makes a `Model` of Programs, names and options, and `Samples` of numbers, from a
Problem and what varies; an engine runs them in blocks, in threads or as Dask tasks. Workers need
these alone, without SymPy.
"""

import lazy_loader

__getattr__, _, _ = lazy_loader.attach_stub(__name__, __file__)
__all__: list[str] = []

__dir__ = __all__.copy  # the stub lists what other rooms take
