from .integration import (
    explain_failure as explain_failure,
    integrate as integrate,
    integrate_states as integrate_states,
    motion_so_far as motion_so_far,
    simulate as simulate,
)
from .parameters import Parameter as Parameter, by_samples as by_samples, marker as marker
from .sensitivities import (
    AugmentedSystem as AugmentedSystem,
    SensitivityRequest as SensitivityRequest,
    changed_by as changed_by,
    compiled_event as compiled_event,
    least_sizes as least_sizes,
    program_of_event as program_of_event,
)
