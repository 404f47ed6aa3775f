"""What is compiled for a System with contacts: its modes, as they occur."""

from __future__ import annotations

from copy import copy
from typing import Any

from pydy import _forks
from pydy._system.snapshot import Snapshot
from pydy.contact.conditions import Contact
from pydy.contact.modes import Mode, check_names, output_symbols
from pydy.contact.rows import ContactRows
from pydy.system import System

_GAP, _FRICTION = ("closes", "opens", "rests"), ("slips", "stops")


class Compiled:
    """What is made for a definition: rows of the contacts, and modes as they occur."""

    def __init__(
        self, system: System, now: Snapshot, contacts: tuple[Contact, ...], hypothesis: str
    ) -> None:
        self.hypothesis = hypothesis  # of restitution
        self.definition, self.contacts = now.definition, contacts
        self.rows = ContactRows(
            now.definition.equations, contacts, now.definition.constants, now.definition.specifieds
        )
        kinds = now.definition.symbols_by_kind
        others = (s for kind, symbols in kinds.items() if kind != "output" for s in symbols)
        check_names(self.rows, kinds["output"], (*others, *now.definition.constants))
        self.stated = list(output_symbols(contacts).values())
        self.constants = (*self.definition.constants, *self.rows.hidden)
        self.modes: dict[tuple[tuple[str, ...], tuple[int, ...]], tuple[Mode, System]] = {}
        self._users = system._define.users(system._outputs, system._forces)
        self._system = system
        self._lock = _forks.Lock()

    def __reduce__(self) -> tuple[Any, ...]:  # another process compiles its own
        return type(None), ()

    @property
    def outputs(self) -> tuple[Any, ...]:
        """The symbols of a trajectory's outputs."""
        definition = self.definition
        users = definition.symbols_by_kind["output"]
        return (*users, *self.stated, *definition.residuals)

    @property
    def transitions(self) -> tuple[str, ...]:
        """The names of the events of contacts."""
        found: list[str] = []
        for c in self.contacts:
            found += [f"{c.name} {what}" for what in _GAP] if c.unilateral is not None else []
            found += [f"{c.name} {what}" for what in _FRICTION] if c.stick is not None else []
        return tuple(found)

    def mode(self, modes: tuple[str, ...], held: tuple[int, ...], every: Any) -> Any:
        """Return a Mode and its System."""
        key = modes, held
        with self._lock:
            known = self.modes.get(key)
        if known is None:
            made = Mode(self.rows, modes, held, every)
            system = System(
                made.equations,
                outputs={**self._users, **made.outputs},
                specifieds=dict(self._system._specifieds),
                constants_symbols=self.constants,
                specifieds_symbols=self.definition.specifieds,
            )
            system._now()  # copies share what has been compiled from here on
            with self._lock:
                known = self.modes.setdefault(key, (made, system))
        return known[0], copy(known[1])  # it is changed by one simulation, of several at a time

    def columns(self, mode: Mode, definition: Any) -> list[int]:
        """Return which outputs of a mode are those of the trajectory."""
        own = list(definition.outputs_symbols)
        base = self.definition
        h, n = len(base.equations.holonomic), len(base.equations.nonholonomic)
        residuals = list(definition.residuals)
        kept = [*residuals[:h], *residuals[len(residuals) - n :]] if n else residuals[:h]
        users = base.symbols_by_kind["output"]
        return [own.index(s) for s in (*users, *self.stated, *kept)]
