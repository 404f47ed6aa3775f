"""Vehicles: tires and their forces at the road, single-track cars and their handling.

`read_tir` reads a tire property file, `MagicFormula` makes a tire of it; `LinearTire`, `BrushTire`
and `TMeasy` need a few parameters only. A tire is asked for its forces with numbers, arrays, or
SymPy expressions, which go into loads, outputs and specifieds. `WheelContact` makes loads of a tire
for a wheel that moves freely, on a plane or a `RoadSurface`; `iso_road` makes random profiles.
`fit_tire` fits the parameters of a tire to measurements.

`single_track` makes a System of a car, `CARS` has constants of some, `linear_handling` the closed
forms of the linear one. `step_steer` and `steady_turn` are manoeuvres of a System.
"""

import lazy_loader

__getattr__, _, _ = lazy_loader.attach_stub(__name__, __file__)
__all__ = [
    "CARS",
    "BrushTire",
    "LinearHandling",
    "LinearTire",
    "MagicFormula",
    "RoadProfile",
    "RoadSurface",
    "SingleTrackCar",
    "SteadyTurn",
    "StepResponse",
    "TMeasy",
    "TireFile",
    "TireFit",
    "TireForces",
    "WheelContact",
    "fit_tire",
    "iso_road",
    "linear_handling",
    "plot_tire",
    "plot_tire_carpet",
    "read_tir",
    "single_track",
    "steady_turn",
    "step_steer",
]

__dir__ = __all__.copy  # the stub lists what other rooms take, too
