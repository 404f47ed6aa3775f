from .assumptions import (
    check_evaluated_orientations as check_evaluated_orientations,
    check_orientations as check_orientations,
    check_sample_orientations as check_sample_orientations,
    free_quaternions as free_quaternions,
)
from .constraint_drift import (
    check_resets as check_resets,
    check_samples as check_samples,
    contradiction as contradiction,
    drift_programs as drift_programs,
    first_violation as first_violation,
    rates as rates,
    start_program as start_program,
    warn_of_redundant as warn_of_redundant,
)
from .diagnostics import (
    diagnosis_of as diagnosis_of,
    explain as explain,
    explain_columns as explain_columns,
    warn_not_finite as warn_not_finite,
    warn_of_outputs as warn_of_outputs,
)
from .discontinuities import (
    jumps_by_time as jumps_by_time,
    node_of as node_of,
    warn_of_jumps as warn_of_jumps,
    watched as watched,
)
from .judges import judge_motion as judge_motion, judge_start as judge_start
from .kinks import (
    warn_of_kinks as warn_of_kinks,
    warn_of_protected_states as warn_of_protected_states,
)
from .missing_derivatives import warn_of_missing_derivatives as warn_of_missing_derivatives
from .passages import (
    MotionPath as MotionPath,
    WatchedQuantities as WatchedQuantities,
    jump_message as jump_message,
)
from .sliding import stuck_at as stuck_at
