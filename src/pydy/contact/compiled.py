"""What is compiled for a System with contacts: its modes, as they occur."""

from __future__ import annotations

from typing import Any

from pydy._system.snapshot import Snapshot
from pydy.contact.conditions import Contact
from pydy.contact.modes import Mode, output_symbols
from pydy.contact.rows import ContactRows
from pydy.system import System


class Compiled:
    """What is made for a definition: rows of the contacts, and modes as they occur."""

    def __init__(self, system: System, now: Snapshot, contacts: tuple[Contact, ...]) -> None:
        self.definition, self.contacts = now.definition, contacts
        self.rows = ContactRows(
            now.definition.equations, contacts, now.definition.constants, now.definition.specifieds
        )
        self.stated = list(output_symbols(contacts).values())
        self.constants = (*self.definition.constants, *self.rows.hidden)
        self.modes: dict[tuple[tuple[str, ...], tuple[int, ...]], tuple[Mode, System]] = {}
        self._users = system._define.users(system._outputs, system._forces)
        self._system = system

    def mode(self, modes: tuple[str, ...], held: tuple[int, ...], every: Any) -> Any:
        """Return a Mode and its System."""
        key = modes, held
        if key not in self.modes:
            made = Mode(self.rows, modes, held, every)
            system = System(
                made.equations,
                outputs={**self._users, **made.outputs},
                specifieds=dict(self._system._specifieds),
                constants_symbols=self.constants,
                specifieds_symbols=self.definition.specifieds,
            )
            self.modes[key] = made, system
        return self.modes[key]

    def columns(self, mode: Mode, definition: Any) -> list[int]:
        """Return which outputs of a mode are those of the trajectory."""
        own = list(definition.outputs_symbols)
        base = self.definition
        h, n = len(base.equations.holonomic), len(base.equations.nonholonomic)
        residuals = list(definition.residuals)
        kept = [*residuals[:h], *residuals[len(residuals) - n :]] if n else residuals[:h]
        users = base.symbols_by_kind["output"]
        return [own.index(s) for s in (*users, *self.stated, *kept)]
