"""Values of a System at states: blocks of the equations, dynamics of robots, exports, summaries."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
