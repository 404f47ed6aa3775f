from .event_derivatives import (
    changed_by as changed_by,
    program_of_event as program_of_event,
)
from .gradient_equations import GradientEquations as GradientEquations
from .initial_sensitivities import InitialSensitivities as InitialSensitivities
from .integration import (
    integrate as integrate,
    integrate_states as integrate_states,
    requested_sensitivities as requested_sensitivities,
    simulate as simulate,
)
from .parameters import by_samples as by_samples, sample_weights as sample_weights
from .recorded_motion import (
    RecordedMotion as RecordedMotion,
    integrate_recorded as integrate_recorded,
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
    parameter_sizes as parameter_sizes,
    with_step_limit as with_step_limit,
)
