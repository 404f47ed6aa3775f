"""The light, where scripts for PyDy's viz import it from."""

from pydy.viz.views import PointLight

__all__ = ["PointLight"]
__dir__ = __all__.copy
