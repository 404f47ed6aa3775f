"""The exported model: its Programs, with their names and numbers."""

from __future__ import annotations

import keyword
import re
import unicodedata
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from importlib.resources import files
from pathlib import Path

from pydy._forks import cached_property
from pydy._names import unused_name
from pydy._program import Program

# -- Hand-written parts of exported files ----------------------------------------------------------


@cache
def resource(name: str) -> str:
    """Return the text of a file in `templates`."""
    return (files("pydy.export") / "templates" / name).read_text(encoding="utf-8")


def plain_text(text: str) -> str:
    """Replace unprintable characters by blanks."""
    return "".join(c if c.isprintable() else " " for c in text)


# -- The model -------------------------------------------------------------------------------------


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
    redirects : tuple of bool
        Whether its reset changes a state that its own rate depends on.
    """

    names: tuple[str, ...] = ()
    directions: tuple[int, ...] = ()
    terminal: tuple[bool, ...] = ()
    acting: tuple[bool, ...] = ()
    redirects: tuple[bool, ...] = ()

    def __len__(self) -> int:
        return len(self.names)


PARTS = ("mass_matrix", "forcing", "holonomic", "velocity")
"""Blocks of the equations: M (n, n) and f (n,) of M u' = f, and the residuals of constraints."""


def _ignore_progress(number: int, **details: str) -> None:
    """Show no progress."""


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
        states and inputs, 'events', 'event_rates' and 'event_bounds' (e,), 'event_input_rates' (e,)
        of inputs and their rates, 'resets' (e, n) the states after each event, 'projection' (see
        `pydy.solvers.constraints`), and those of `PARTS` that the equations have.
    events : EventData
    start, stop : float
        The default time span for importers.
    constraints : mapping of str to int, or places
        Sizes for the projection, and what follows; empty without projection.
    unknowns : sequence of int
        The places of states that residuals give.
    constraint_names : sequence of str
        The c constraints that code with a solver checks at its start: 'start_residuals' (3 c,) are
        their residuals and what typed digits and rounding allow.
    switches : int
        The number of times at which the rates switch whatever the states are, which the Program
        'switches' computes from the constants and inputs.
    told : callable
        Called as ``told(0, part=name)`` before a part is made, and as ``told(1)`` after it.
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
    constraints: Mapping[str, object] = field(default_factory=dict)
    unknowns: Sequence[int] = ()
    constraint_names: Sequence[str] = ()
    switches: int = 0
    told: Callable[..., None] = _ignore_progress

    @cached_property
    def _programs(self) -> dict[str, Program]:
        return {}

    def program(self, name: str) -> Program:
        """Return one of the Programs, built at most once."""
        if name not in self._programs:
            self.told(0, part=name)
            self._programs[name] = self.builders[name]()
            self.told(1)
        return self._programs[name]

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


def with_inputs(program: Program, columns: Sequence[int]) -> Program:
    """Restrict a Program to the specifieds in `columns`; it must not read others."""
    new = {old: k for k, old in enumerate(columns)}
    args = tuple(
        ("r", new[a[1]]) if op == "input" and a[0] == "r" else a
        for op, a in zip(program.ops, program.args, strict=True)
    )
    signature = replace(program.signature, num_specifieds=len(columns))
    return replace(program, signature=signature, args=args)


# Words of C, C++, JavaScript and Python, macros of C's headers in small letters, and the names that
# generated code uses itself.
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
    *("alignas", "alignof", "and_eq", "bitand", "bitor", "char8_t", "char16_t", "char32_t"),
    *("co_await", "co_return", "co_yield", "compl", "concept", "const_cast", "consteval"),
    *("constexpr", "constinit", "contract_assert", "decltype", "dynamic_cast", "explicit"),
    *("mutable", "noexcept", "not_eq", "nullptr", "or_eq", "reinterpret_cast", "requires"),
    *("static_assert", "static_cast", "thread_local", "typeid", "typename", "typeof_unqual"),
    *("wchar_t", "xor", "xor_eq", "debugger", "implements", "instanceof", "interface", "package"),
    *("asm", "assert", "cdecl", "complex", "d_fileno", "errno", "far", "fortran", "h_addr"),
    *("h_errno", "i386", "imaginary", "linux", "math_errhandling", "near", "noreturn", "offsetof"),
    *("pascal", "s6_addr", "s6_addr16", "s6_addr32", "sa_handler", "sa_sigaction", "setjmp"),
    *("sched_priority", "si_addr", "si_addr_lsb", "si_arch", "si_band", "si_call_addr", "si_fd"),
    *("si_int", "si_lower", "si_overrun", "si_pid", "si_pkey", "si_ptr", "si_status", "si_stime"),
    *("si_syscall", "si_timerid", "si_uid", "si_upper", "si_utime", "si_value", "small"),
    *("sigev_notify_attributes", "sigev_notify_function", "st_atime", "st_ctime", "st_mtime"),
    *("stderr", "stdin", "stdout", "unix", "va_arg", "va_copy", "va_end", "va_start"),
}
_LETTERS = re.compile(r"(?:GREEK|LATIN) (?:SMALL|CAPITAL) LETTER (?:FINAL )?([A-Z]+)\b")
_WORDS = {"∫": "integral ", "'": "_prime", "′": "_prime", "″": "_second", "∂": "d", "Δ": "Delta"}


def identifiers(names: Iterable[str]) -> list[str]:
    """Return an identifier for each name, none twice and none a word of C, JavaScript or Python.

    A name that is an identifier stays as it is, whatever others are spelled like.

    Examples
    --------
    >>> from pydy.export.model import identifiers
    >>> identifiers(["q1", "θ_1", "∫ N_r dt", "lambda", "q-1", "q+1"])
    ['q1', 'theta_1', 'integral_N_r_dt', 'lambda_', 'q_1', 'q_1_2']
    """
    names, used = list(names), set[str]()
    result = [*map(_identifier, names)]
    for k in sorted(range(len(names)), key=lambda k: result[k] != names[k]):
        result[k] = unused_name(result[k], used)
        used.add(result[k])
    return result


def _identifier(name: str) -> str:
    ascii_name = re.sub(r"_*[^A-Za-z0-9_]+_*", "_", "".join(map(_spelled, name)))
    # C keeps names that begin with an underscore.
    ascii_name = (
        ascii_name
        if ascii_name == name and ascii_name[:1] not in ("", "_")
        else ascii_name.strip("_") or "v"
    )
    ascii_name = f"v_{ascii_name}" if ascii_name[0].isdigit() else ascii_name
    return f"{ascii_name}_" if ascii_name in _RESERVED else ascii_name


def _spelled(letter: str) -> str:
    """Return a character in ASCII: Greek by name, digits and letters without their marks."""
    if letter.isascii() and letter not in _WORDS:
        return letter
    if letter in _WORDS:
        return _WORDS[letter]
    ascii_text = unicodedata.normalize("NFKD", letter).encode("ascii", "ignore").decode()
    if ascii_text.isalnum():
        return ascii_text
    match = _LETTERS.match(unicodedata.name(letter, ""))
    if match is None:
        return " "
    word = match[1].lower()
    return word.capitalize() if letter.isupper() else word
