from .brush import BrushTire as BrushTire
from .fit import TireFit as TireFit, fit_tire as fit_tire
from .forces import TireForces as TireForces
from .linear import LinearTire as LinearTire
from .magic_formula import MagicFormula as MagicFormula
from .plots import plot_tire as plot_tire, plot_tire_carpet as plot_tire_carpet
from .tir import TireFile as TireFile, read_tir as read_tir
from .tmeasy import TMeasy as TMeasy
from .wheel import WheelContact as WheelContact
