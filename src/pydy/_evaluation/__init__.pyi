from .dynamics import (
    Quantity as Quantity,
    all_accelerations as all_accelerations,
    evaluate as evaluate,
    frame_jacobian as frame_jacobian,
    frame_position as frame_position,
    frame_rotation as frame_rotation,
    gravity as gravity,
    inverse_dynamics as inverse_dynamics,
    mass_matrix as mass_matrix,
    required_forces as required_forces,
)
from .evaluation import (
    BLOCKS as BLOCKS,
    evaluate_block as evaluate_block,
    evaluate_product as evaluate_product,
    variables as variables,
)
from .exporting import exported_model as exported_model, live_system as live_system
from .function import Evaluator as Evaluator
from .generated import (
    checked_options as checked_options,
    generated_function as generated_function,
)
from .inertial import (
    BaseParameters as BaseParameters,
    base_parameters as base_parameters,
    inertial_parameters as inertial_parameters,
    regressor as regressor,
)
from .model_summary import shortened as shortened, summary as summary
