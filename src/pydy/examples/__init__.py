"""Worked examples: real mechanisms, derived in the open and checked against published numbers."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
