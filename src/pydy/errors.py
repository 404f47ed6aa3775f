"""The package's exceptions and warnings, to catch by name.

Each one subclasses the built-in that a caller would catch.
"""

from pydy._errors import (
    AnalysisInterrupted,
    ContactError,
    EnsembleInterrupted,
    EquilibriumError,
    FitInterrupted,
    GeneratorError,
    IntegrationError,
    IntegrationInterrupted,
    MissingDependencyError,
    OptimizationError,
    PeriodicOrbitError,
    PyDyUserWarning,
    RobotFileError,
    SingularMatrixError,
    TireFileError,
    UnsupportedFunctionError,
)

__all__ = [
    "AnalysisInterrupted",
    "ContactError",
    "EnsembleInterrupted",
    "EquilibriumError",
    "FitInterrupted",
    "GeneratorError",
    "IntegrationError",
    "IntegrationInterrupted",
    "MissingDependencyError",
    "OptimizationError",
    "PeriodicOrbitError",
    "PyDyUserWarning",
    "RobotFileError",
    "SingularMatrixError",
    "TireFileError",
    "UnsupportedFunctionError",
]
