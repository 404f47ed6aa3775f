from .event_derivatives import (
    changed_by as changed_by,
    compiled_event as compiled_event,
    program_of_event as program_of_event,
)
from .initial_sensitivities import InitialSensitivities as InitialSensitivities
from .integration import (
    explain_failure as explain_failure,
    integrate as integrate,
    integrate_states as integrate_states,
    motion_so_far as motion_so_far,
    simulate as simulate,
)
from .parameters import (
    Parameter as Parameter,
    by_samples as by_samples,
    marker as marker,
    sample_weights as sample_weights,
)
from .sensitivities import (
    AugmentedSystem as AugmentedSystem,
    columns_of as columns_of,
    with_all_constraints as with_all_constraints,
    written_out as written_out,
)
from .sensitivity_request import SensitivityRequest as SensitivityRequest
from .step_control import (
    are_controlled as are_controlled,
    compiled_sensitivities as compiled_sensitivities,
    least_sizes as least_sizes,
    parameter_sizes as parameter_sizes,
    with_step_limit as with_step_limit,
)
