"""Vehicles: tires, from measured coefficients or physical parameters, to forces at the road.

`read_tir` reads a tire property file, `MagicFormula` makes a tire of it; `LinearTire`, `BrushTire`
and `TMeasy` need a few parameters only. A tire is asked for its forces with numbers, arrays, or
SymPy expressions, which go into loads, outputs and specifieds. `WheelContact` makes loads of a tire
for a wheel that moves freely. `fit_tire` fits the parameters of a tire to measurements.
"""

import lazy_loader

__getattr__, _, _ = lazy_loader.attach_stub(__name__, __file__)
__all__ = [
    "BrushTire",
    "LinearTire",
    "MagicFormula",
    "TMeasy",
    "TireFile",
    "TireFit",
    "TireForces",
    "WheelContact",
    "fit_tire",
    "plot_tire",
    "plot_tire_carpet",
    "read_tir",
]

__dir__ = __all__.copy  # the stub lists what other rooms take, too
