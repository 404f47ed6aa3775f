"""How an integration ended: a code, its name, and the message made from it.

Compiled code returns these codes; ``info['code']`` and the `status` of an ensemble hold them. Texts
are made from codes and are never read back.
"""

from __future__ import annotations

from typing import NamedTuple

# Stores of ensembles keep these numbers: new ones go to the end.
NOT_COMPUTED = -1
FINISHED, TOO_MANY_STEPS, STEP_UNDERFLOW, SINGULAR, NOT_FINITE, TERMINATED = range(6)
CONSTRAINTS_NOT_MET, NO_CONVERGENCE, EVENTS_ACCUMULATE, START_OFF_CONSTRAINTS = range(6, 10)
INTERRUPTED, TOLERANCE_TOO_SMALL, EVENT_CONSTANT, RESET_NOT_FINITE = range(10, 14)
SINGULAR_CONFIGURATION, EVENT_GRAZES, SPEEDS_NOT_GIVEN, DEPENDENTS_NOT_GIVEN = range(14, 18)
RESET_OFF_CONSTRAINTS, LEFT_CONSTRAINTS, ENERGY_CHANGED, EVENT_UNDEFINED = range(18, 22)
CONTACTS_IMPOSSIBLE, EVENT_JUMPS = 22, 23


class Outcome(NamedTuple):
    """A code with its meaning."""

    name: str  # one word, for flags
    text: str  # what the solver did; details are inserted in the braces
    remedy: str = ""


OUTCOMES = {
    NOT_COMPUTED: Outcome("not_computed", "not run"),
    FINISHED: Outcome("finished", "finished"),
    TOO_MANY_STEPS: Outcome(
        "too_many_steps",
        "took {max_steps} steps, `max_steps`",
        "Raise `max_steps`, loosen `rtol` and `atol`, or try 'radau' if the system is stiff. If a "
        "load jumps back and forth, as dry friction with `sign(v)` does where v = 0, smooth it.",
    ),
    STEP_UNDERFLOW: Outcome(
        "step_underflow",
        "needs ever smaller steps{size}",
        "The motion is not smooth there, or it diverges. Look for a jump in the loads, which an "
        "Event can handle, loosen `rtol` and `atol`, or try 'radau' if the system is stiff.",
    ),
    SINGULAR: Outcome(
        "singular",
        "met a singular mass matrix{size}",
        "Check that no mass or inertia is zero, that no constraint is redundant there, and that "
        "the configuration is not singular.",
    ),
    NOT_FINITE: Outcome(
        "not_finite",
        "met derivatives or errors that are not finite{size}",
        "Check the loads, specifieds and constants there for a division by zero or a function "
        "outside its domain.",
    ),
    TERMINATED: Outcome("terminated", "terminated by `{event}`"),
    CONSTRAINTS_NOT_MET: Outcome(
        "constraints_not_met",
        "could not bring the state back onto the constraints after a step of {step:.3g}",
        "Check that all constraints can be satisfied there and do not jump, nor does a solution of "
        "`Implicit`, or limit `max_step`.",
    ),
    NO_CONVERGENCE: Outcome(
        "no_convergence",
        "could not solve for its stages{size}",
        "Check that loads are continuous there; an Event can handle a jump.",
    ),
    EVENTS_ACCUMULATE: Outcome(
        "events_accumulate",
        "events `{event}` accumulate",
        "Make the event terminal, or let its reset stop the motion as it stops in reality.",
    ),
    START_OFF_CONSTRAINTS: Outcome(
        "start_off_constraints",
        "found initial conditions that do not satisfy the constraints (the projection {change})",
        "Call `system.set_dependent_initial_conditions()` first.",
    ),
    INTERRUPTED: Outcome(
        "interrupted",
        "was interrupted",
        "The results so far are in the attributes of this error.",
    ),
    TOLERANCE_TOO_SMALL: Outcome(
        "tolerance_too_small",
        "cannot start with rtol = {rtol:.3g} and atol = {atol:.3g}",
        "{advice}",
    ),
    EVENT_CONSTANT: Outcome(
        "event_constant",
        "cannot detect the event `{event}`, whose expression is constant,",
        "It must depend on the states, on specifieds or on time.",
    ),
    RESET_NOT_FINITE: Outcome(
        "reset_not_finite",
        "met the event `{event}`, whose reset gave {state}",
        "Check its expressions.",
    ),
    SINGULAR_CONFIGURATION: Outcome(
        "singular_configuration",
        "stopped at a singular configuration of the constraints, where a combination of these rows "
        "vanishes ({rows}): it {what},",
        "Several motions may continue from there, and the constraints do not determine which. "
        "Another step size or tolerance may pass it; a different formulation of the constraints "
        "may have no such configuration.",
    ),
    SPEEDS_NOT_GIVEN: Outcome(
        "speeds_not_given",
        "stopped where the constraints do not determine the dependent speeds: it {what},",
        "Choose other dependent coordinates and speeds, or pass System a "
        "`pydy.mechanics.Definition` without `dependent_speeds`, which needs no choice.",
    ),
    EVENT_GRAZES: Outcome(
        "event_grazes",
        "met the event `{event}`, which the motion only grazes: by {depth:.2g} beyond zero, where "
        "its tolerances explain {explained:.2g},",
        "The time of such an event, and the motion after it, have no derivatives with respect to "
        "the parameters. {lower} the event, start elsewhere, or simulate without "
        "`sensitivities`.",
    ),
    DEPENDENTS_NOT_GIVEN: Outcome(
        "dependents_not_given",
        "did not start, because the constraints do not determine how the dependent initial "
        "conditions follow from the others,",
        "Call `system.set_dependent_initial_conditions(dep_vars=…)` with variables for which they "
        "do, or simulate without `sensitivities`.",
    ),
    RESET_OFF_CONSTRAINTS: Outcome(
        "reset_off_constraints",
        "met the event `{event}`, whose reset leaves the constraints (the projection {change}),",
        "Let the reset give all states that change, the dependent ones too.",
    ),
    LEFT_CONSTRAINTS: Outcome(
        "left_constraints",
        "left the constraints, with a residual of {residual:.3g} in the {row}, where its "
        "tolerances explain {explained:.2g},",
        "It may have passed close to a singular position, or the rows contradict each other. Pass "
        "constraints='project', which needs a native solver, or smaller tolerances. The states are "
        "in the attributes of this error.",
    ),
    ENERGY_CHANGED: Outcome(
        "energy_changed",
        "changed the total energy by {change:.3g} without a cause, where its tolerances explain "
        "{explained:.2g} and the kinetic energy is up to {kinetic:.3g},",
        "It may have passed close to a singular position. Pass constraints='project', "
        "which needs a native solver, or other tolerances; other constraints may have no such "
        "position. The states are in the attributes of this error.",
    ),
    EVENT_UNDEFINED: Outcome(
        "event_undefined",
        "met the event `{event}`, whose expression becomes NaN there,",
        "Whether it crosses zero cannot be seen. Pass an expression that is defined on both sides, "
        "as `x - 1` is instead of `sqrt(x - 1)`. The states are in the attributes of this error.",
    ),
    CONTACTS_IMPOSSIBLE: Outcome(
        "contacts_impossible",
        "found no modes of the contacts that satisfy the equations",
        "Simulate that sample alone: the error tells whether it is Painlevé's paradox or jamming.",
    ),
    EVENT_JUMPS: Outcome(
        "event_jumps",
        "met the event `{event}`, whose expression jumps there, to {value:.3g},",
        "The time of such an event has no derivatives that are known. Pass an expression that "
        "passes through zero where that jumps, or simulate without `sensitivities`.",
    ),
}
