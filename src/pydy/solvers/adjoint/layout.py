"""What the way back through explicit steps works on, as compiled code opens it."""

from __future__ import annotations

from typing import NamedTuple

from pydy.solvers.run.layout import NumberRows, Numbers, Problem, Words

__all__ = ["BACK", "Backward"]

# Backward.words: the number of stages, the place in r of the weights, how many outputs of the
# kernel follow those by the states, how many of these, the last, are kept stage by stage, and the
# step whose equations could not be evaluated.
STAGES, WEIGHTS, FURTHER, KEPT, WRONG = range(5)


class Backward(NamedTuple):
    """Explicit steps, and what is needed to go through them from the last to the first.

    The kernel gives the derivatives of Σ weight · rate by the states and by what else is wanted.
    Rows are those of the stages' states, with places in `stages`, then those of their weights, with
    places in `adjoints`. Vectors are padded to whole blocks.
    """

    words: Words
    rows: Words  # where each row begins in the two arrays that follow
    offsets: Words
    coefficients: Numbers
    nodes: Numbers
    times: Numbers  # (steps,): where each begins
    sizes: Numbers  # (steps,)
    states: NumberRows  # (steps, ·): at the beginning of each
    stages: NumberRows  # (steps, ·): derivatives, vector after vector
    adjoints: Numbers  # of each stage's state; that of the state at the end of the step comes last
    step: Numbers
    zero: Numbers
    state: Numbers
    weighted: Numbers
    out: Numbers
    totals: Numbers  # (further,): sums over all stages
    kept: NumberRows  # (steps · stages, kept)


# The parts of the table of `step_back`.
BACK = (Problem, Backward)
