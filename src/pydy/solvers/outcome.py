"""How an integration ended: a code, a flag, and the message made from it.

Compiled code returns these codes; ``info['code']`` and the `status` of an ensemble hold them as
plain integers. Messages are made from codes and are never parsed.
"""

from __future__ import annotations

from enum import IntEnum


class Outcome(IntEnum):
    """How an integration ended.

    Results and stores hold the number: new members go to the end, and what users see is an `int`.
    """

    text: str
    """What the solver did, after its name; details are inserted in the braces."""

    remedy: str
    """What the user can do, in sentences; empty if nothing is to be done."""

    is_valid: bool
    """Whether the motion up to its end is valid: it finished, or events ended it."""

    def __new__(  # noqa: D102
        cls, code: int, text: str = "", remedy: str = "", is_valid: bool = False
    ) -> Outcome:
        member = int.__new__(cls, code)
        member._value_, member.text, member.remedy, member.is_valid = code, text, remedy, is_valid
        return member

    @property
    def flag(self) -> str:
        """The name in small letters, as in the `flag_meanings` of an ensemble's `status`."""
        return self.name.lower()

    NOT_COMPUTED = -1, "not run"
    FINISHED = 0, "finished", "", True
    TOO_MANY_STEPS = (
        1,
        "took {max_steps} steps, `max_steps`",
        "Raise `max_steps`, loosen `rtol` and `atol`, or try 'radau' if the system is stiff. If a "
        "load jumps back and forth, as dry friction with `sign(v)` does where v = 0, smooth it.",
    )
    STEP_UNDERFLOW = (
        2,
        "needs ever smaller steps{size}",
        "The motion is not smooth there, or it diverges. Look for a jump in the loads, which an "
        "Event can handle, loosen `rtol` and `atol`, or try 'radau' if the system is stiff.",
    )
    SINGULAR = (
        3,
        "met a singular mass matrix{size}",
        "Check that no mass or inertia is zero, that no constraint is redundant there, and that "
        "the configuration is not singular.",
    )
    NOT_FINITE = (
        4,
        "met derivatives or errors that are not finite{size}",
        "Check the loads, specifieds and constants there for a division by zero or a function "
        "outside its domain.",
    )
    TERMINATED = 5, "terminated by `{event}`", "", True
    CONSTRAINTS_NOT_MET = (
        6,
        "could not bring the state back onto the constraints after a step of {step:.3g}",
        "Check that all constraints can be satisfied there and do not jump, nor does a solution of "
        "`Implicit`, or limit `max_step`.",
    )
    NO_CONVERGENCE = (
        7,
        "could not solve for its stages{size}",
        "Check that loads are continuous there; an Event can handle a jump.",
    )
    EVENTS_ACCUMULATE = (
        8,
        "events `{event}` accumulate",
        "Make the event terminal, or let its reset stop the motion as it stops in reality.",
        True,
    )
    START_OFF_CONSTRAINTS = (
        9,
        "found initial conditions that do not satisfy the constraints (the projection {change})",
        "Call `system.set_dependent_initial_conditions()` first.",
    )
    INTERRUPTED = (
        10,
        "was interrupted",
        "The results so far are in the attributes of this error.",
    )
    TOLERANCE_TOO_SMALL = (
        11,
        "cannot start with rtol = {rtol:.3g} and atol = {atol:.3g}",
        "{advice}",
    )
    EVENT_CONSTANT = (
        12,
        "cannot detect the event `{event}`, whose expression is constant,",
        "It must depend on the states, on specifieds or on time.",
    )
    RESET_NOT_FINITE = (
        13,
        "met the event `{event}`, whose reset gave {state}",
        "Check its expressions.",
    )
    SINGULAR_CONFIGURATION = (
        14,
        "stopped at a singular configuration of the constraints, where a combination of these rows "
        "vanishes ({rows}): it {failure},",
        "Several motions may continue from there, and the constraints do not determine which. "
        "Another step size or tolerance may pass it; a different formulation of the constraints "
        "may have no such configuration.",
    )
    EVENT_GRAZES = (
        15,
        "met the event `{event}`, which the motion only grazes: by {depth:.2g} beyond zero, where "
        "its tolerances explain {explained:.2g},",
        "The time of such an event, and the motion after it, have no derivatives with respect to "
        "the parameters. {lower} the event, start elsewhere, or simulate without "
        "`sensitivities`.",
    )
    SPEEDS_NOT_GIVEN = (
        16,
        "stopped where the constraints do not determine the dependent speeds: it {failure},",
        "Choose other dependent coordinates and speeds, or pass System a "
        "`pydy.mechanics.Definition` without `dependent_speeds`, which needs no choice.",
    )
    DEPENDENTS_NOT_GIVEN = (
        17,
        "did not start, because the constraints do not determine how the dependent initial "
        "conditions follow from the others,",
        "Call `system.set_dependent_initial_conditions(dep_vars=…)` with variables for which they "
        "do, or simulate without `sensitivities`.",
    )
    RESET_OFF_CONSTRAINTS = (
        18,
        "met the event `{event}`, whose reset leaves the constraints (the projection {change}),",
        "Let the reset give all states that change, the dependent ones too.",
    )
    LEFT_CONSTRAINTS = (
        19,
        "left the constraints, with a residual of {residual:.3g} in the {row}, where its "
        "tolerances explain {explained:.2g},",
        "It may have passed close to a singular position, or the rows contradict each other. Pass "
        "constraints='project', which needs a native solver, or smaller tolerances. The states are "
        "in the attributes of this error.",
    )
    ENERGY_CHANGED = (
        20,
        "changed the total energy by {change:.3g} without a cause, where its tolerances explain "
        "{explained:.2g} and the kinetic energy is up to {kinetic:.3g},",
        "It may have passed close to a singular position. Pass constraints='project', "
        "which needs a native solver, or other tolerances; other constraints may have no such "
        "position. The states are in the attributes of this error.",
    )
    EVENT_UNDEFINED = (
        21,
        "met the event `{event}`, whose expression becomes NaN there,",
        "Whether it crosses zero cannot be seen. Pass an expression that is defined on both sides, "
        "as `x - 1` is instead of `sqrt(x - 1)`. The states are in the attributes of this error.",
    )
    CONTACTS_IMPOSSIBLE = (
        22,
        "found no modes of the contacts that satisfy the equations",
        "Simulate that sample alone: the error tells whether it is Painlevé's paradox or jamming.",
    )
    EVENT_JUMPS = (
        23,
        "met the event `{event}`, whose expression jumps there, to {value:.3g},",
        "The time of such an event has no derivatives that are known. Pass an expression that "
        "passes through zero where that jumps, or simulate without `sensitivities`.",
    )
