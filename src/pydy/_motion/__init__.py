"""Motions, the results of integrations, and the calls of native, SciPy's and user-defined solvers."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
