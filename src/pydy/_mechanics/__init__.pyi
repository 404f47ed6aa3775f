from .components import (
    dot as dot,
    flat as flat,
    identity as identity,
    in_rows as in_rows,
    transposed as transposed,
    turned as turned,
)
from .definition import Definition as Definition
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
from .form import Formed as Formed
from .frames import orientation_rows as orientation_rows, rotations as rotations
from .generic import evaluator_of as evaluator_of, generic_inputs as generic_inputs
from .held_accelerations import (
    Constraints as Constraints,
    accelerations as accelerations,
    accelerations_of_held as accelerations_of_held,
)
from .implicit import Implicit as Implicit
from .inverse import BodyDynamics as BodyDynamics
from .potential import find_potential as find_potential
from .reactions import (
    Multipliers as Multipliers,
    Reaction as Reaction,
    multipliers as multipliers,
    named as named,
    reaction as reaction,
)
from .reader import (
    Multibody as Multibody,
    breadth_first_from as breadth_first_from,
    checked_vector as checked_vector,
    distances as distances,
    given_velocity as given_velocity,
    oriented as oriented,
    places as places,
)
from .symbols import (
    find_symbols as find_symbols,
    function_of_time as function_of_time,
    replace_symbols as replace_symbols,
    sort_symbols as sort_symbols,
)
from .to_sympy import written as written
