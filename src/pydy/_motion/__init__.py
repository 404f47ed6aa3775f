"""Motions, and the calls of solvers: native ones, those of SciPy, and user-defined ones."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
