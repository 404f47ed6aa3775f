r"""Directory names for variables: each array of a store is a directory.

Zarr reads ``\`` as ``/`` and creates a directory for each part. Windows allows neither some
characters nor files called ``aux``; there and on macOS, ``q`` and ``Q`` are the same file. The
names of arrays avoid all of this on every system, so that a store can be written anywhere and
copied anywhere.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

__all__ = ["file_names"]

# Not in names of files on some system; blanks separate the names in the attribute `coordinates`.
_REFUSED = re.compile(r'[\x00-\x1f<>:"/\\|?*\s]')
_DEVICE = re.compile(r"(aux|con|nul|prn|com\d|lpt\d)(\..*)?")
_OF_ZARR = "zarr.json"


def file_names(names: Iterable[str]) -> dict[str, str]:
    r"""Return a file name for each name; the same one if it is valid everywhere.

    Examples
    --------
    >>> from pydy.ensemble.file_names import file_names
    >>> file_names(["q", "Q", "\\theta", "aux"])
    {'q': 'q', 'Q': 'Q_2', '\\theta': '_theta', 'aux': '_aux'}
    """
    given = list(dict.fromkeys(names))
    plain = {name for name in given if _serves(name)}
    found: dict[str, str] = {}
    taken: set[str] = set()
    for name in sorted(given, key=lambda name: name not in plain):  # these keep theirs if they can
        stem = name if name in plain else _REFUSED.sub("_", name).strip(".")
        if not _serves(stem):
            stem = "_" + stem.lstrip("_")
        chosen, number = stem, 2
        while chosen.casefold() in taken:
            chosen = f"{stem}_{number}"
            number += 1
        taken.add(chosen.casefold())
        found[name] = chosen
    return {name: found[name] for name in given}


def _serves(name: str) -> bool:
    folded = name.casefold()
    return not (
        _REFUSED.search(name)
        or name.endswith(".")
        or name.startswith((".", "__"))
        or folded == _OF_ZARR
        or _DEVICE.fullmatch(folded)
        or not name
    )
