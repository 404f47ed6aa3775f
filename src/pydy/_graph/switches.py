"""Which rewriting passes and solve strategies run. All do; a benchmark leaves some out."""

from __future__ import annotations

from dataclasses import dataclass

from pydy._graph.passes import ONCE, ROUND, SHARING


@dataclass(frozen=True)
class Passes:
    """Switches, by the names in the lists of passes and strategies.

    ``name in passes`` tells whether one is on.
    """

    off: frozenset[str] = frozenset()

    def __contains__(self, name: object) -> bool:
        return name not in self.off

    @staticmethod
    def names() -> list[str]:
        """Return all names, in the order in which they run."""
        rewriting = [name for name, _ in [*ONCE, *ROUND]]
        return list(dict.fromkeys(["differences", *rewriting, *SHARING, "ldl", "lu"]))

    @classmethod
    def without(cls, *names: str) -> Passes:
        """Return the switches with some of them off."""
        for name in names:
            if name not in cls.names():
                raise ValueError(
                    f"`names` has {name!r}, which is no pass or strategy: they are "
                    f"{', '.join(cls.names())}."
                )
        return cls(frozenset(names))

    @classmethod
    def none(cls) -> Passes:
        """Return the switches all off except for the plain eliminations, which rewrite nothing."""
        return cls(frozenset(cls.names()) - {"ldl", "lu"})

    def running(self) -> tuple[str, ...]:
        """Return the names of the passes that are on."""
        return tuple(name for name in self.names() if name in self)
