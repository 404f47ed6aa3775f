"""Tire property files: sections of ``NAME = value``, tables, and units, in TYDEX's style."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from os import PathLike
from typing import Any

import numpy as np

from pydy._checks import number
from pydy._errors import TireFileError, warn_user
from pydy._files import path_of
from pydy._names import some
from pydy.vehicles.coefficients import ALIASES
from pydy.vehicles.units import factors, in_si

# Sections of words: what stands there is text, and numbers there are not coefficients.
_WORDS = ("UNITS", "MDI_HEADER", "HEADER", "COMMENTS", "FILE_HEADER")
_OF_FORMAT = {
    "PAC2002": "PAC2002",
    "PAC02": "PAC2002",
    "MF_05": "5.2",
    "MF_52": "5.2",
    "MF52": "5.2",
    "MF_61": "6.1",
    "MF61": "6.1",
    "MF_62": "6.2",
    "MF62": "6.2",
}
_OF_FITTYP = {5: "5.2", 6: "5.2", 21: "5.2", 60: "6.1", 61: "6.1", 62: "6.2"}
# What a file says of itself, beside its coefficients.
SETTINGS = ("PROPERTY_FILE_FORMAT", "FITTYP", "TYRESIDE", "USE_MODE")
# Tires of motorcycles: other equations of the side force and of camber, partly by the same names.
OTHER_FITTYP = {51.0: ", MF-MCTyre 1.0", 52.0: ", MF-MCTyre 1.1"}
# Formats without a FITTYP that have other equations under names that are partly the same.
_OTHER_MODELS = re.compile(
    r"PAC_?MC|MF_?MC(_?TYRE)?|PAC_?(89|94|96)|FIALA|FTIRE|5\.2\.1|UA|CDTIRE|RMOD|TMEASY"
)


@dataclass(frozen=True)
class TireFile:
    """What a tire property file says, in SI units.

    Attributes
    ----------
    path : str
    version : str or None
        The Magic Formula that the coefficients belong to: ``'5.2'``, ``'6.1'``, ``'6.2'`` or
        ``'PAC2002'``. None if the file is for another model.
    side : str or None
        The side of the vehicle that the tire was measured for: ``'left'`` or ``'right'``.
    use_mode : int or None
        The file's own choice of what is computed.
    coefficients : dict of str to float
        All numbers of the file by name, without those of the section [UNITS].
    sections : dict of str to dict
        The sections as they stand in the file: numbers in its own units, and words.
    tables : dict of str to dict
        For each section with a table, its columns by name; without names they are ``'0'``, ``'1'``.
    """

    path: str
    version: str | None
    side: str | None
    use_mode: int | None
    coefficients: dict[str, float]
    sections: dict[str, dict[str, float | str]] = field(repr=False)
    tables: dict[str, dict[str, np.ndarray]] = field(repr=False)

    def __repr__(self) -> str:
        kind = f"Magic Formula {self.version}" if self.version else "another model"
        return f"<TireFile {self.path}: {kind}, {len(self.coefficients)} numbers>"


def file_of(coefficients: Mapping[str, Any]) -> TireFile | None:
    """Return what a dictionary with settings of files says, as if it were read; else None."""
    if not any(name in coefficients for name in SETTINGS):
        return None
    words = ("PROPERTY_FILE_FORMAT", "TYRESIDE")
    numbers = {name: value for name, value in coefficients.items() if name not in words}
    for name in ("FITTYP", "USE_MODE"):
        if name in numbers:
            numbers[name] = number(numbers[name], f"`{name}`", finite=True)
    side = str(coefficients.get("TYRESIDE", "")).lower()
    version = _version(dict(coefficients), numbers)
    if not {"FITTYP", "PROPERTY_FILE_FORMAT"} & coefficients.keys():
        version = version or "6.1"
    mode = numbers.get("USE_MODE")
    return TireFile(
        path="`coefficients`",
        version=version,
        side=side if side in ("left", "right") else None,
        use_mode=None if mode is None else int(mode),
        coefficients=numbers,
        sections={},
        tables={},
    )


def read_tir(path: str | PathLike[str]) -> TireFile:
    """Read a tire property file (.tir).

    Numbers with a unit are converted to SI units by the file's section [UNITS]; lengths, forces,
    angles, masses, times, pressures, and what is made of them. The coefficients of the Magic
    Formula have no unit, or belong to angles in radians. Comments begin with ``!`` or ``$``. Files
    are read as UTF-8, or if that fails as Latin-1.

    Parameters
    ----------
    path : str or path-like
        The file.

    Returns
    -------
    TireFile
        Its numbers; `MagicFormula` makes a tire of it, and says which coefficients are missing.

    Raises
    ------
    TireFileError
        A line has no meaning in such a file, or a unit is unknown.

    References
    ----------
    J. J. M. van Oosten et al., TYDEX workshop: standardisation of data exchange in tyre testing and
    tyre modelling, Vehicle System Dynamics 27(S1), 1997, pp. 272–288.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> from pydy.vehicles import read_tir
    >>> with TemporaryDirectory() as folder:
    ...     path = Path(folder, 'small.tir')
    ...     _ = path.write_text('''
    ... [UNITS]
    ... LENGTH = 'mm'    $ also of speeds
    ... [MODEL]
    ... FITTYP = 61      ! the version of the Magic Formula
    ... [DIMENSION]
    ... UNLOADED_RADIUS = 313
    ... [SHAPE]
    ... {radial width}
    ... 1.0 0.0
    ... 0.9 1.0
    ... ''')
    ...     file = read_tir(path)
    >>> file.version, file.coefficients['UNLOADED_RADIUS']
    ('6.1', 0.313)
    >>> file.tables['SHAPE']['radial']
    array([1. , 0.9])
    """
    place = path_of(path, "`path`")
    data = place.read_bytes()
    try:
        content = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        content = data.decode("latin-1")
    reader = _Reader(str(place))
    for k, line in enumerate(content.splitlines(), 1):
        reader.read_line(k, line)
    return reader.finished()


class _Reader:
    """The sections of a file as they are read, line by line."""

    def __init__(self, path: str) -> None:
        self.path = path
        self.sections: dict[str, dict[str, float | str]] = {}
        self.rows: dict[str, list[list[float]]] = {}
        self.columns: dict[str, list[str]] = {}
        self.section = ""
        self.in_comment_block = False
        self.given_twice: dict[str, None] = {}

    def error(self, line: int, message: str) -> TireFileError:
        return TireFileError(f"{self.path}, line {line}: {message}.")

    def read_line(self, number: int, raw: str) -> None:
        line = _without_comment(raw)
        if not line:
            return
        if line.startswith("["):
            if not line.endswith("]"):
                raise self.error(number, f"the name of a section has no end: {line!r}")
            self.section = line[1:-1].strip().upper()
            self.sections.setdefault(self.section, {})
            self.in_comment_block = False
        elif line.startswith("("):  # `(COMMENTS)`: a block of text inside a section
            self.in_comment_block = True
        elif line.startswith("{"):
            self.columns[self.section] = line.strip("{}").split()
        elif "=" in line:
            name, _, value = line.partition("=")
            self.read_value(number, name.strip().upper(), value.strip())
        elif (row := _row(line)) is not None:
            self.rows.setdefault(self.section, []).append(row)
        elif not (self.in_comment_block or self.section in ("", *_WORDS)):
            raise self.error(
                number,
                f"{line!r} is neither a section, nor NAME = value, nor a row of a table; comments "
                "begin with ! or $",
            )

    def read_value(self, number: int, name: str, value: str) -> None:
        if not value:
            return  # as if it were not there: it is missing
        values = self.sections.setdefault(self.section, {})
        if value[0] in "'\"":
            result: float | str = value.strip(value[0]).strip()
        elif (numbers := _row(value)) is not None and len(numbers) == 1:
            (result,) = numbers
        elif self.section in _WORDS or re.fullmatch(r"[A-Za-z_][\w./-]*", value):
            result = value
        else:
            raise self.error(number, f"{name} must be a number or a word in quotes, got {value!r}")
        if values.setdefault(name, result) != result:
            self.given_twice[name] = None
            values[name] = result

    def finished(self) -> TireFile:
        units = {k: str(v) for k, v in self.sections.get("UNITS", {}).items()}
        try:
            by_quantity = factors(units)
        except ValueError as error:
            raise TireFileError(f"{self.path}: {error}.") from None
        coefficients: dict[str, float] = {}
        for section, values in self.sections.items():
            if section in _WORDS:
                continue
            for name, value in values.items():
                if isinstance(value, float):
                    spelling = ALIASES.get(name, name)
                    value_in_si = in_si(name, value, by_quantity)
                    if coefficients.setdefault(spelling, value_in_si) != value_in_si:
                        self.given_twice[name] = None
                        coefficients[spelling] = value_in_si
        if self.given_twice:
            warn_user(
                f"{self.path} has several values of {some(list(self.given_twice))}. The last is "
                "used."
            )
        words = {k: v for values in self.sections.values() for k, v in values.items()}
        side = str(words.get("TYRESIDE", "")).lower()
        mode = coefficients.get("USE_MODE")
        return TireFile(
            path=self.path,
            version=_version(words, coefficients),
            side=side if side in ("left", "right") else None,
            use_mode=None if mode is None else int(mode),
            coefficients=coefficients,
            sections=self.sections,
            tables={s: self.table(s, rows, by_quantity) for s, rows in self.rows.items()},
        )

    def table(
        self, section: str, rows: list[list[float]], by_quantity: dict[str, float]
    ) -> dict[str, np.ndarray]:
        widths = {len(row) for row in rows}
        names = self.columns.get(section, [str(k) for k in range(max(widths))])
        if widths != {len(names)}:
            raise TireFileError(
                f"{self.path}: the table of [{section}] has rows of {sorted(widths)} numbers, and "
                f"{len(names)} columns."
            )
        array = np.array(rows)
        return {
            name: array[:, k] * in_si(name.upper(), 1.0, by_quantity)
            for k, name in enumerate(names)
        }


def _without_comment(line: str) -> str:
    """Return a line up to the first ``!`` or ``$`` that is not in quotes."""
    quote = ""
    for k, character in enumerate(line):
        if quote:
            quote = "" if character == quote else quote
        elif character in "'\"" and _opens(line, k):
            quote = character
        elif character in "!$":
            return line[:k].strip()
    return line.strip()


def _opens(line: str, k: int) -> bool:
    """Return whether a quotation mark has a partner: comments contain inches and apostrophes."""
    return line[k] in line[k + 1 :]


def _row(line: str) -> list[float] | None:
    """Return the numbers of a line, with exponents of Fortran too, or None."""
    numbers = []
    for word in line.replace(",", " ").split():
        try:
            number = float(re.sub(r"(?<=[\d.])[dD](?=[+-]?\d)", "e", word))
        except ValueError:
            return None
        if not np.isfinite(number):
            return None
        numbers.append(number)
    return numbers or None


def _version(words: dict[str, Any], coefficients: dict[str, float]) -> str | None:
    """Return the Magic Formula that a file is for."""
    name = str(words.get("PROPERTY_FILE_FORMAT", "")).upper().replace("-", "_")
    if name in _OF_FORMAT and name.startswith("PAC"):
        return _OF_FORMAT[name]
    kind = coefficients.get("FITTYP")
    if kind is not None and kind in _OF_FITTYP:
        return _OF_FITTYP[int(kind)]
    if name in _OF_FORMAT:
        return _OF_FORMAT[name]
    if kind is not None:
        return None
    if _OTHER_MODELS.fullmatch(name):
        return None
    return next(_guesses(coefficients), None)


def _guesses(coefficients: dict[str, float]) -> Iterator[str]:
    """Yield the versions that the coefficients' names fit, where the file does not say one."""
    if "PCY1" in coefficients:
        if {"QSX12", "QSX13", "QSX14"} & coefficients.keys():
            yield "6.2"
        if {"PKY6", "PKY4", "PPX1", "PPY1"} & coefficients.keys():
            yield "6.1"
        yield "5.2"
