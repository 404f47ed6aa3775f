from .constraint_drift import (
    check_samples as check_samples,
    contradiction as contradiction,
    drift_programs as drift_programs,
    first_violation as first_violation,
    rates as rates,
)
from .definition import (
    DefinitionBuilder as DefinitionBuilder,
    SymbolSet as SymbolSet,
    base_symbols as base_symbols,
    check_forces as check_forces,
    check_times as check_times,
    read_term as read_term,
    refuse_descending as refuse_descending,
    sort_out as sort_out,
)
from .dependence import follow as follow
from .dependent_states import (
    check_dependents as check_dependents,
    consistent as consistent,
    default_dependents as default_dependents,
    given_values as given_values,
    solve_dependents as solve_dependents,
    with_dependents as with_dependents,
)
from .diagnostics import diagnosis_of as diagnosis_of, warn_of_outputs as warn_of_outputs
from .discontinuities import (
    node_of as node_of,
    warn_of_jumps as warn_of_jumps,
    warn_of_kinks as warn_of_kinks,
    watched as watched,
)
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
from .energy import Energy as Energy, EnergyModel as EnergyModel, check_potential as check_potential
from .evaluation import (
    BLOCKS as BLOCKS,
    evaluate_block as evaluate_block,
    evaluate_product as evaluate_product,
    variables as variables,
)
from .events_and_constraints import (
    ConstraintNames as ConstraintNames,
    EnsembleOptions as EnsembleOptions,
    check_events as check_events,
    constraint_names as constraint_names,
    native_solver as native_solver,
    with_all as with_all,
    with_residuals_held as with_residuals_held,
)
from .exporting import exported_model as exported_model, live_system as live_system
from .function import Function as Function
from .generated import (
    Generated as Generated,
    checked_options as checked_options,
    generate as generate,
)
from .inertial import (
    BaseParameters as BaseParameters,
    base_parameters as base_parameters,
    inertial_parameters as inertial_parameters,
    regressor as regressor,
)
from .integration import (
    explain_failure as explain_failure,
    integrate as integrate,
    integrate_states as integrate_states,
    motion_so_far as motion_so_far,
    simulate as simulate,
)
from .judges import judge_motion as judge_motion, judge_start as judge_start
from .missing_derivatives import warn_of_missing_derivatives as warn_of_missing_derivatives
from .model import Model as Model
from .model_summary import shortened as shortened, summary as summary
from .motion import Motion as Motion, Segment as Segment
from .parameters import Parameter as Parameter, by_samples as by_samples, marker as marker
from .passages import Passed as Passed, Watched as Watched, jump_message as jump_message
from .preparation import PreparedIntegration as PreparedIntegration, prepare as prepare
from .problem import (
    At as At,
    Problem as Problem,
    check_specifieds as check_specifieds,
    checked_plan as checked_plan,
    read_numbers as read_numbers,
    samples as samples,
)
from .scene import make_scene as make_scene
from .scipy_solvers import (
    SolveIvp as SolveIvp,
    call_odeint as call_odeint,
    is_odeint as is_odeint,
    resolve_ode_solver as resolve_ode_solver,
)
from .sensitivities import (
    AugmentedSystem as AugmentedSystem,
    SensitivityRequest as SensitivityRequest,
    changed_by as changed_by,
    compiled_event as compiled_event,
    least_sizes as least_sizes,
    program_of_event as program_of_event,
)
from .states import (
    GROUPS as GROUPS,
    ForcesWithoutConstraints as ForcesWithoutConstraints,
    Point as Point,
    energetic_motions as energetic_motions,
    located as located,
)
from .tuning import FIT as FIT
