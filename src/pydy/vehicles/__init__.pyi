from .brush import BrushTire as BrushTire
from .cars import (
    CARS as CARS,
    DoubleTrackCar as DoubleTrackCar,
    SingleTrackCar as SingleTrackCar,
)
from .commonroad.car import commonroad_car as commonroad_car
from .double_track import double_track as double_track
from .fit import TireFit as TireFit, fit_tire as fit_tire
from .forces import TireForces as TireForces
from .handling import LinearHandling as LinearHandling, linear_handling as linear_handling
from .lane_change import LaneChange as LaneChange, lane_change as lane_change
from .linear import LinearTire as LinearTire
from .magic_formula import MagicFormula as MagicFormula
from .manoeuvres import (
    SteadyTurn as SteadyTurn,
    StepResponse as StepResponse,
    steady_turn as steady_turn,
    step_steer as step_steer,
)
from .plots import plot_tire as plot_tire, plot_tire_carpet as plot_tire_carpet
from .profiles import RoadProfile as RoadProfile, iso_road as iso_road
from .road import RoadSurface as RoadSurface
from .single_track import single_track as single_track
from .tir import TireFile as TireFile, read_tir as read_tir
from .tmeasy import TMeasy as TMeasy
from .trailer import car_trailer as car_trailer
from .wheel import WheelContact as WheelContact
