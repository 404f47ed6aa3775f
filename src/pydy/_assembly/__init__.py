"""Equations as named blocks of one graph, from which Programs are lowered."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
