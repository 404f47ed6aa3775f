"""Models as files for other programs: C, functional mock-up units, JavaScript, Python.

Users call `System.export`; `write` takes a `Model`, which contains Programs and names.
"""

import lazy_loader

__getattr__, _, _ = lazy_loader.attach_stub(__name__, __file__)
__all__ = [
    "EventData",
    "Exported",
    "Model",
    "Variable",
    "write",
]

__dir__ = __all__.copy  # the stub lists what other rooms take, too
