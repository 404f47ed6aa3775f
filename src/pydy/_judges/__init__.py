"""Functions of a Motion that say what is wrong with it, and warnings before there is one."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
