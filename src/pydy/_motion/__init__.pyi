from .events_and_constraints import (
    ConstraintNames as ConstraintNames,
    EnsembleOptions as EnsembleOptions,
    check_events as check_events,
    constraint_names as constraint_names,
    event_bounds_program as event_bounds_program,
    event_input_rates_program as event_input_rates_program,
    event_rates_program as event_rates_program,
    event_redirects as event_redirects,
    native_solver as native_solver,
    projection_program as projection_program,
    with_all as with_all,
    with_residuals_projected as with_residuals_projected,
)
from .lsoda import (
    MORE_STEPS as MORE_STEPS,
    call_odeint as call_odeint,
    came_to_the_end as came_to_the_end,
    is_odeint as is_odeint,
    odeint as odeint,
    public_odeint as public_odeint,
)
from .motion import (
    EvaluationRecorder as EvaluationRecorder,
    Integrator as Integrator,
    Motion as Motion,
    Segment as Segment,
    labelled as labelled,
)
from .preparation import PreparedIntegration as PreparedIntegration, prepare as prepare
from .scipy_solvers import (
    SolveIvp as SolveIvp,
    is_implicit as is_implicit,
    of_states as of_states,
    resolve_ode_solver as resolve_ode_solver,
)
