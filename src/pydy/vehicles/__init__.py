"""Vehicles: tires and their forces at the road, cars and their handling.

`read_tir` reads a tire property file, `MagicFormula` makes a tire of it; `LinearTire`, `BrushTire`
and `TMeasy` need a few parameters only. A tire is asked for its forces with numbers, arrays, or
SymPy expressions, which go into loads, outputs and specifieds. `WheelContact` makes loads of a tire
for a wheel that moves freely, on a plane or a `RoadSurface`; `iso_road` makes random profiles.
`fit_tire` fits the parameters of a tire to measurements.

`single_track` makes a System of a car, `CARS` has constants of some, `linear_handling` the closed
forms of the linear one. `step_steer`, `steady_turn` and `lane_change` are manoeuvres of a
System. `commonroad_car` has models of the CommonRoad benchmarks. `double_track` makes a System of a
car with four wheels that spin, `car_trailer` one with a trailer. Modules of their own have what
models of your own need: `pydy.vehicles.machines` motors, gears, differentials, clutches, bushings
and the air, `pydy.vehicles.suspensions` hard points, quarter cars and a car on springs,
`pydy.vehicles.two_wheelers` bicycles and motorcycles, `pydy.vehicles.tracks` roads and the fastest
laps on them, `pydy.vehicles.gg` the largest accelerations, `pydy.vehicles.scenes` pictures of cars.
"""

import lazy_loader

__getattr__, _, _ = lazy_loader.attach_stub(__name__, __file__)
__all__ = [
    "CARS",
    "BrushTire",
    "DoubleTrackCar",
    "LaneChange",
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
    "car_trailer",
    "commonroad_car",
    "double_track",
    "fit_tire",
    "iso_road",
    "lane_change",
    "linear_handling",
    "plot_tire",
    "plot_tire_carpet",
    "read_tir",
    "single_track",
    "steady_turn",
    "step_steer",
]

__dir__ = __all__.copy  # the stub lists what other rooms take, too
