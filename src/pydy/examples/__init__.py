"""Worked examples: real mechanisms, derived in the open and checked against published numbers."""

import lazy_loader

__getattr__, _, _ = lazy_loader.attach_stub(__name__, __file__)
__all__: list[str] = []

__dir__ = __all__.copy  # the stub lists what other rooms take
