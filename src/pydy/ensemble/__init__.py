"""Many trajectories of one model: the implementation of `System.integrate_ensemble`.

`integration` turns a Problem and the varied numbers into an `EnsembleModel` (Programs, names and
options) and `Samples` (arrays of numbers). An engine runs them in blocks, in threads or as Dask
tasks. Workers need only these objects, and not SymPy.
"""

import lazy_loader

__getattr__, _, _ = lazy_loader.attach_stub(__name__, __file__)
__all__: list[str] = []

__dir__ = __all__.copy  # the stub lists what other rooms take
