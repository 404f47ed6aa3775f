"""`VisualizationFrame`, where scripts for PyDy's viz import it from."""

from pydy.viz.views import VisualizationFrame

__all__ = ["VisualizationFrame"]
__dir__ = __all__.copy
