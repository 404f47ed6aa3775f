"""Models as files for other programs: C, functional mock-up units, JavaScript, Python.

Users call `System.export`; `write` takes a `Model`, which contains Programs and names.
"""

from pydy.export.model import EventData, Exported, Model, Variable
from pydy.export.writing import write

__all__ = ["EventData", "Exported", "Model", "Variable", "write"]
