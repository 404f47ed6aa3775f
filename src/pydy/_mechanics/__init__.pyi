from .acceleration_constraints import AccelerationConstraints as AccelerationConstraints
from .components import dot as dot
from .definition import Definition as Definition, EomMethod as EomMethod
from .equation_graph import EquationGraph as EquationGraph
from .equations import Equations as Equations, Mechanism as Mechanism
from .equations_of_motion import (
    EquationsOfMotion as EquationsOfMotion,
    equations_to_read as equations_to_read,
)
from .extraction import (
    extract as extract,
    method_of as method_of,
    symbolic_matrices as symbolic_matrices,
)
from .frame_tree import FrameTree as FrameTree
from .frames import orthogonality_residuals as orthogonality_residuals
from .generic import generic_values as generic_values
from .implicit import Implicit as Implicit
from .inverse import BodyDynamics as BodyDynamics, SymbolicNodes as SymbolicNodes
from .multibody import Multibody as Multibody
from .potential import find_potential as find_potential
from .reactions import Multipliers as Multipliers, Reaction as Reaction, Reactions as Reactions
from .reader import checked_vector as checked_vector
from .symbols import (
    find_symbols as find_symbols,
    function_of_time as function_of_time,
    replace_symbols as replace_symbols,
    sort_symbols as sort_symbols,
)
from .to_sympy import written as written
