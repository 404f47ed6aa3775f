from .advancing import advancing_states as advancing_states
from .dependence import follow as follow
from .dependent_states import (
    check_dependents as check_dependents,
    consistent as consistent,
    default_dependents as default_dependents,
    given_values as given_values,
    solve_dependents as solve_dependents,
    with_dependents as with_dependents,
)
from .states import (
    GROUPS as GROUPS,
    EvaluationPoints as EvaluationPoints,
    ForcesWithoutConstraints as ForcesWithoutConstraints,
    energetic_motions as energetic_motions,
    located as located,
    members as members,
)
