"""Which rewriting passes run. All do by default; a benchmark leaves one out to see its effect."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["Passes"]


@dataclass(frozen=True)
class Passes:
    """Switches of the passes that lower the number of operations.

    Attributes
    ----------
    merge : bool
        Make nodes that are equal as functions one (`pydy._graph.identities`).
    factor : bool
        Take common factors out of sums of products (`pydy._graph.factor`).
    expand : bool
        Multiply short sums out where what comes of it has factors in common with other terms
        (`pydy._graph.expand`).
    share_products, share_sums : bool
        Make the pair of factors, or terms, that occurs most often a value of its own, again and
        again (`pydy._graph.share`).
    separate : bool
        Solve in O(n) where the rows and columns of a mass matrix separate
        (`pydy._graph.semiseparable`).
    rebase : bool
        Solve for other unknowns where that takes less: differences of neighbouring rows
        (`pydy._graph.structure`), bodies' own angular velocities (`pydy._graph.body_basis`).
    """

    merge: bool = True
    factor: bool = True
    expand: bool = True
    share_products: bool = True
    share_sums: bool = True
    separate: bool = True
    rebase: bool = True

    @classmethod
    def none(cls) -> Passes:
        """Return the switches all off."""
        return cls(**dict.fromkeys(cls.__dataclass_fields__, False))
