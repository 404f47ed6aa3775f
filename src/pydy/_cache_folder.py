"""The cache on disk: machine code and simplified Programs, so that nothing is compiled twice.

An entry is a file named by its key, a SHA-256, with a checksum before its content: whatever is
truncated, foreign or unreadable is a miss. No file of another name is ever touched. Files are
written aside and renamed, so several processes can share a folder and a killed one leaves nothing
that counts. No failure of the disk is ever an error.

Entries are run as code. A checksum is no proof of who wrote one, since anybody can compute it: what
proves it is the file system. As ssh does with keys, a folder or an entry is used only if it belongs
to the effective user and nobody else can write to it, and a folder's parents only if nobody else
can put another folder in its place; a group of the user's alone may write to parents. An entry is
opened first and then checked, so that it cannot be exchanged in between. Windows has no such
owners; its folders of users are private.

The environment variable PYDY_CACHE_DIR names the folder in which ``pydy-cache`` is made instead, or
turns the cache off (``off``). Where nobody knows the user's home, as in a container with an unknown
user, it is a folder of the user's among the temporary files.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
import stat
import tempfile
import time
import warnings
from functools import cache
from pathlib import Path

from pydy._errors import PyDyUserWarning, warn_user

_STALE_SECONDS = 3600.0

LIMIT_BYTES = 256 * 2**20
_MAGIC = b"pydy code 1\n"
# Entries, and what is to become one: nothing else in the folder is ours.
_OURS = re.compile(r"[0-9a-f]{64}\.(code|[a-z0-9_]{8}\.tmp)")
_warned: set[str] = set()
_stored: dict[Path, int] = {}  # bytes by this process since it looked for what to remove


# -- who can write --------------------------------------------------------------------------------


def _reason(status: os.stat_result, parent: bool = False) -> str | None:
    """Return how another user could change a file or folder with this status, or None."""
    if not hasattr(os, "geteuid"):
        return None
    # The administrator can do anything anyway, and owns most parents.
    if status.st_uid != os.geteuid() and not (parent and status.st_uid == 0):
        return f"belongs to another user (uid {status.st_uid})"
    # In a sticky folder, such as /tmp, only its owner renames what lies there. Many systems give
    # every user a group of his own, which then may write to all that he makes (umask 002).
    others = stat.S_IWGRP | stat.S_IWOTH
    if parent and _is_private(status.st_gid, os.geteuid()):
        others = stat.S_IWOTH
    if status.st_mode & others and not (parent and status.st_mode & stat.S_ISVTX):
        return f"can be written by others (mode {stat.S_IMODE(status.st_mode):04o})"
    return None


@cache
def _is_private(group: int, user_id: int) -> bool:
    """Return whether a group is a user's own: his first one, of his name, without others.

    The same rule as that of Debian's ssh for the folders above its keys.
    """
    try:
        import grp
        import pwd

        user, found = pwd.getpwuid(user_id), grp.getgrgid(group)
    except (ImportError, KeyError):  # Windows has none; a container may not know the user
        return False
    own = user.pw_gid == group and found.gr_name == user.pw_name
    return own and not {*found.gr_mem} - {user.pw_name}


def unsafe(place: Path) -> str | None:
    """Return the first folder above `place` that another user could change, and how, or None.

    The place has no symbolic links; what does not exist yet is safe.
    """
    for part in (*reversed(place.parents), place):
        try:
            status = os.lstat(part)
        except OSError:
            return None
        reason = _reason(status, parent=part != place)
        if reason is not None:
            return f"'{part}' {reason}"
    return None


def _warn_once(trouble: str, remedy: str) -> None:
    if trouble not in _warned:
        _warned.add(trouble)
        warnings.warn(
            f"{trouble}, so that compiled code kept there could be somebody else's; it is not "
            f"used. {remedy}",
            PyDyUserWarning,
            stacklevel=3,
        )


# -- places ---------------------------------------------------------------------------------------


def folder() -> Path | None:
    """Return the cache's folder, or None when the cache is turned off or not safe to use.

    Warns
    -----
    PyDyUserWarning
        Somebody else could write there; once for each folder.
    """
    chosen = os.environ.get("PYDY_CACHE_DIR")
    if chosen and chosen.lower() == "off":
        return None
    try:
        place = Path(os.path.realpath(_chosen(chosen) or _homeless()))
    except OSError:  # a relative path where the working directory has been removed
        return None
    trouble = unsafe(place)
    if trouble is None:
        return place
    _warn_once(
        trouble,
        "Take the right to write from group and others (chmod go-w) if it is yours, or let the "
        "environment variable PYDY_CACHE_DIR name a folder that only you can write to, or be 'off'",
    )
    return None


def _chosen(given: str | None) -> str | None:
    """Return the folder that the user or the system chose, or None where it needs a home."""
    if given:
        known = os.path.join(os.path.expanduser(given), "pydy-cache")
    else:
        import platformdirs

        try:
            known = platformdirs.user_cache_dir("pydy", appauthor=False)
        except RuntimeError:  # no HOME, and no entry in the user database
            return None
    # Without a home `~` stays, and would name a folder in the working directory.
    return None if known.startswith("~") else known


def _homeless() -> str:
    """Return the user's cache among the temporary files, whose owner is checked as any other's."""
    user_id = os.geteuid() if hasattr(os, "geteuid") else "user"
    place = os.path.join(tempfile.gettempdir(), f"pydy-cache-{user_id}")
    if place not in _warned:
        _warned.add(place)
        warn_user(
            "The user has no home folder (no HOME, and no entry in the user database): compiled "
            f"code is kept in '{place}'. To choose another folder, set the environment variable "
            "PYDY_CACHE_DIR; 'off' keeps none."
        )
    return place


def _make(place: Path) -> None:
    """Make a folder and its parents, accessible to this user only."""
    if not place.is_dir():
        _make(place.parent)
        with contextlib.suppress(FileExistsError):
            place.mkdir(0o700)


def _head(key: str, content: bytes) -> bytes:
    """Return an entry's header, which contains its name: a renamed entry is not accepted."""
    return _MAGIC + hashlib.sha256(key.encode() + content).digest()


# Never through a link, and never waiting for a pipe's other end. Windows knows neither.
_OPEN = os.O_RDONLY | sum(getattr(os, n, 0) for n in ("O_NOFOLLOW", "O_NONBLOCK", "O_BINARY"))


def _own_file(path: Path) -> bytes | None:
    """Return the content of a file if this user owns it, else None."""
    try:
        with open(path, "rb", opener=lambda path, _: os.open(path, _OPEN)) as file:
            status = os.fstat(file.fileno())
            if not stat.S_ISREG(status.st_mode):
                return None
            reason = _reason(status)
            if reason is None:
                return file.read()
    except OSError:
        return None
    _warn_once(f"'{path}' {reason}", "Remove it if you did not put it there")
    return None


# -- entries --------------------------------------------------------------------------------------


def read(key: str) -> bytes | None:
    """Return the content of an entry, by its SHA-256 in hexadecimal digits, or None.

    None is returned when there is no sound one of this user's.
    """
    place = folder()
    if place is None:
        return None
    path = place / f"{key}.code"
    data = _own_file(path)
    if data is None:
        return None
    head = len(_MAGIC) + 32
    content = data[head:]
    if data[:head] != _head(key, content):
        return None
    with contextlib.suppress(OSError):
        os.utime(path)  # the least recently used go first
    return content


def write(key: str, content: bytes) -> None:
    """Store an entry; a full or read-only disk only means that it is not there next time."""
    place = folder()
    if place is None:
        return
    try:
        _make(place)
        if folder() != place:  # what was not there before has been made by somebody else
            return
        # For the user alone.
        handle, aside = tempfile.mkstemp(dir=place, prefix=f"{key}.", suffix=".tmp")
    except OSError:
        return
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(_head(key, content) + content)
        os.replace(aside, place / f"{key}.code")
    except OSError:
        with contextlib.suppress(OSError):
            os.unlink(aside)
        return
    # A look at a whole folder after each entry would take longer the more there are.
    stored = _stored.get(place, LIMIT_BYTES) + len(content)
    if stored > LIMIT_BYTES // 64:
        stored = 0
        _evict(place)
    _stored[place] = stored


def _evict(place: Path) -> None:
    """Remove the least recently used entries beyond the limit, and what killed processes left."""
    entries = []
    now = time.time()
    try:
        with os.scandir(place) as items:
            for item in filter(lambda item: _OURS.fullmatch(item.name), items):
                with contextlib.suppress(OSError):
                    status = item.stat()
                    if item.name.endswith(".code"):
                        entries.append((status.st_mtime, status.st_size, item.path))
                    elif now - status.st_mtime > _STALE_SECONDS:
                        os.unlink(item.path)
    except OSError:
        return
    total = sum(size for _, size, _ in entries)
    for _, size, path in sorted(entries):
        if total <= LIMIT_BYTES:
            break
        with contextlib.suppress(OSError):
            os.unlink(path)
            total -= size
