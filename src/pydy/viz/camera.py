"""The cameras, where scripts for PyDy's viz import them from."""

from pydy.viz.views import OrthoGraphicCamera, PerspectiveCamera

__all__ = ["OrthoGraphicCamera", "PerspectiveCamera"]
__dir__ = __all__.copy
