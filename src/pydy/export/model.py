"""The exported model: its Programs, with their names and numbers."""

from __future__ import annotations

import keyword
import re
import unicodedata
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from pydy._forks import cached_property
from pydy._graph.program import Program

__all__ = ["EventData", "Exported", "Model", "Variable", "identifiers", "with_inputs"]


@dataclass(frozen=True)
class Variable:
    """A state, input, constant or output.

    Attributes
    ----------
    name : str
        Name as the user wrote it.
    identifier : str
        Name in source code: ASCII letters, digits and underscores; unique in the model.
    value : float
        The initial condition, start value or default.
    """

    name: str
    identifier: str
    value: float = 0.0


@dataclass(frozen=True)
class EventData:
    """Properties of events other than their Programs.

    Attributes
    ----------
    names : tuple of str
    directions : tuple of int
    terminal, acting : tuple of bool
        Whether the event ends the motion, and whether it does that or resets states.
    """

    names: tuple[str, ...] = ()
    directions: tuple[int, ...] = ()
    terminal: tuple[bool, ...] = ()
    acting: tuple[bool, ...] = ()

    def __len__(self) -> int:
        return len(self.names)


@dataclass(frozen=True, eq=False)
class Model:
    """A model to be exported.

    Attributes
    ----------
    name : str
        An identifier; what generated names begin with.
    title : str
    states, inputs, constants, outputs : tuple of Variable
        In the order of x, r, p and of the outputs.
    builders : mapping of str to callable
        Return the Programs: 'rates' (n,), 'outputs' (m,), 'jacobian' (n + m, n + s) of both by
        states and inputs, 'events' (e,), 'event_rates' (e,), 'resets' (e, n) the states after each
        event, 'projection' (see `pydy.solvers.run.constraints`).
    events : EventData
    start, stop : float
        The default time span for importers.
    constraints : mapping of str to int
        Sizes for the projection; empty without projection.
    """

    name: str
    title: str
    states: tuple[Variable, ...]
    inputs: tuple[Variable, ...]
    constants: tuple[Variable, ...]
    outputs: tuple[Variable, ...]
    builders: Mapping[str, Callable[[], Program]]
    events: EventData = field(default_factory=EventData)
    start: float = 0.0
    stop: float = 1.0
    constraints: Mapping[str, int] = field(default_factory=dict)

    @cached_property
    def _made(self) -> dict[str, Program]:
        return {}

    def program(self, name: str) -> Program:
        """Return one of the Programs, built at most once."""
        if name not in self._made:
            self._made[name] = self.builders[name]()
        return self._made[name]

    @property
    def variables(self) -> tuple[Variable, ...]:
        """All variables: states, inputs, constants, outputs."""
        return (*self.states, *self.inputs, *self.constants, *self.outputs)

    @property
    def renamed(self) -> dict[str, str]:
        """Names that are no identifiers, and the identifiers that stand for them."""
        return {v.name: v.identifier for v in self.variables if v.name != v.identifier}


@dataclass(frozen=True)
class Exported:
    """The files written by an export.

    Attributes
    ----------
    path : Path
    files : tuple of Path
        All files, `path` first.
    names : dict of str to str
        Names that are not valid identifiers, and the identifiers used instead.
    """

    path: Path
    files: tuple[Path, ...]
    names: dict[str, str]


def with_inputs(program: Program, places: Sequence[int]) -> Program:
    """Return a Program that takes some of its specifieds only, which are all that it reads."""
    new = {old: k for k, old in enumerate(places)}
    args = tuple(
        ("r", new[a[1]]) if op == "input" and a[0] == "r" else a
        for op, a in zip(program.ops, program.args, strict=True)
    )
    return replace(program, num_specifieds=len(places), args=args)


# Words of C, C++, JavaScript and Python, and the names that generated code uses itself.
_RESERVED = {
    *keyword.kwlist,
    *("auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else"),
    *("enum", "extern", "float", "for", "goto", "if", "inline", "int", "long", "register"),
    *("restrict", "return", "short", "signed", "sizeof", "static", "struct", "switch", "typedef"),
    *("union", "unsigned", "void", "volatile", "while", "bool", "catch", "class", "delete"),
    *("export", "false", "friend", "function", "let", "namespace", "new", "null", "operator"),
    *("private", "protected", "public", "super", "template", "this", "throw", "true", "try"),
    *("typeof", "undefined", "using", "var", "virtual", "await", "yield", "arguments", "eval"),
    *("NAN", "INFINITY"),
}
_LETTERS = re.compile(r"(?:GREEK|LATIN) (?:SMALL|CAPITAL) LETTER (?:FINAL )?([A-Z]+)\b")
_WORDS = {"∫": "integral ", "'": "_prime", "′": "_prime", "″": "_second", "∂": "d", "Δ": "Delta"}


def identifiers(names: Iterable[str], taken: Iterable[str] = ()) -> list[str]:
    """Return an identifier for each name, none twice and none a word of C, JavaScript or Python.

    Examples
    --------
    >>> from pydy.export.model import identifiers
    >>> identifiers(["q1", "θ_1", "∫ N_r dt", "lambda", "q-1", "q+1"])
    ['q1', 'theta_1', 'integral_N_r_dt', 'lambda_', 'q_1', 'q_1_2']
    """
    used = set(taken)
    result = []
    for name in names:
        plain = re.sub(r"_*[^A-Za-z0-9_]+_*", "_", "".join(map(_spelled, name))).strip("_") or "v"
        plain = f"_{plain}" if plain[0].isdigit() else plain
        plain = re.sub(r"^_+", "v_", plain)  # C keeps names that begin with an underscore
        plain = f"{plain}_" if plain in _RESERVED else plain
        chosen, number = plain, 2
        while chosen in used:
            chosen = f"{plain}_{number}"
            number += 1
        used.add(chosen)
        result.append(chosen)
    return result


def _spelled(letter: str) -> str:
    """Return a character in ASCII: Greek by name, digits and letters without their marks."""
    if letter.isascii() and letter not in _WORDS:
        return letter
    if letter in _WORDS:
        return _WORDS[letter]
    plain = unicodedata.normalize("NFKD", letter).encode("ascii", "ignore").decode()
    if plain.isalnum():
        return plain
    found = _LETTERS.match(unicodedata.name(letter, ""))
    if found is None:
        return " "
    word = found[1].lower()
    return word.capitalize() if letter.isupper() else word
