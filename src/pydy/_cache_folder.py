"""The cache on disk: machine code and simplified Programs, so that nothing is compiled twice.

An entry is a file named by its key, a SHA-256, with a checksum before its content. Truncated,
foreign or unreadable entries are cache misses. Files with other names are never changed. Entries
are written to a temporary file and renamed, so that several processes can share a folder and a
killed process leaves no partial entry. Disk failures are never errors.

Entries are executed as code. A checksum does not prove who wrote an entry, because anybody can
compute it; the file system does. As with ssh keys, a folder or an entry is used only if it belongs
to the effective user and nobody else can write to it. A folder's parents must not allow others to
replace it; only the user's private group may write to them. An entry is opened before it is
checked, so that it cannot be exchanged in between. On Windows, which has no such owners, users'
folders are private.

The environment variable PYDY_CACHE_DIR names another folder, in which ``pydy-cache`` is created, or
turns the cache off (``off``). If the user has no home folder, as in a container with an unknown
user, the cache is a folder of this user among the temporary files.
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
# Entries and their temporary files. Other files in the folder belong to somebody else.
_OURS = re.compile(r"[0-9a-f]{64}\.(code|[a-z0-9_]{8}\.tmp)")
_warned: set[str] = set()
_stored: dict[Path, int] = {}  # bytes written by this process since its latest eviction


# -- Write permissions ----------------------------------------------------------------------------


def _reason(status: os.stat_result, parent: bool = False) -> str | None:
    """Return how another user could change a file or folder with this status, or None."""
    if not hasattr(os, "geteuid"):
        return None
    # The administrator has all rights and owns most parents.
    if status.st_uid != os.geteuid() and not (parent and status.st_uid == 0):
        return f"belongs to another user (uid {status.st_uid})"
    # In a sticky folder, such as /tmp, only owners can rename their files. Many systems give every
    # user a private group, which may write to all files of the user (umask 002).
    writable_by_others = stat.S_IWGRP | stat.S_IWOTH
    if parent and _is_private(status.st_gid, os.geteuid()):
        writable_by_others = stat.S_IWOTH
    if status.st_mode & writable_by_others and not (parent and status.st_mode & stat.S_ISVTX):
        return f"can be written by others (mode {stat.S_IMODE(status.st_mode):04o})"
    return None


@cache
def _is_private(group: int, user_id: int) -> bool:
    """Return whether a group is private: the user's primary group, with his name, without others.

    Debian's ssh has the same rule for the folders above its keys.
    """
    try:
        import grp
        import pwd

        user, group_entry = pwd.getpwuid(user_id), grp.getgrgid(group)
    except (ImportError, KeyError):  # Windows has none; a container may not know the user
        return False
    is_primary = user.pw_gid == group and group_entry.gr_name == user.pw_name
    return is_primary and not {*group_entry.gr_mem} - {user.pw_name}


def unsafe(path: Path) -> str | None:
    """Return the first folder above `path` that another user could change, and how, or None.

    The path has no symbolic links; folders that do not exist yet are safe.
    """
    for part in (*reversed(path.parents), path):
        try:
            status = os.lstat(part)
        except OSError:
            return None
        reason = _reason(status, parent=part != path)
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


# -- Folders --------------------------------------------------------------------------------------


def folder() -> Path | None:
    """Return the cache's folder, or None if the cache is turned off or not safe to use.

    Warns
    -----
    PyDyUserWarning
        Another user could write there; once for each folder.
    """
    chosen = os.environ.get("PYDY_CACHE_DIR")
    if chosen and chosen.lower() == "off":
        return None
    try:
        path = Path(os.path.realpath(_chosen(chosen) or _folder_without_home()))
    except OSError:  # a relative path where the working directory has been removed
        return None
    trouble = unsafe(path)
    if trouble is None:
        return path
    _warn_once(
        trouble,
        "Take the right to write from group and others (chmod go-w) if it is yours, or let the "
        "environment variable PYDY_CACHE_DIR name a folder that only you can write to, or be 'off'",
    )
    return None


def _chosen(setting: str | None) -> str | None:
    """Return the folder chosen by the user or the system, or None if that needs a missing home."""
    if setting:
        path = os.path.join(os.path.expanduser(setting), "pydy-cache")
    else:
        import platformdirs

        try:
            path = platformdirs.user_cache_dir("pydy", appauthor=False)
        except RuntimeError:  # no HOME, and no entry in the user database
            return None
    # Without a home `~` is not expanded, and would name a folder in the working directory.
    return None if path.startswith("~") else path


def _folder_without_home() -> str:
    """Return the user's cache folder among the temporary files; its owner is checked as usual."""
    user_id = os.geteuid() if hasattr(os, "geteuid") else "user"
    path = os.path.join(tempfile.gettempdir(), f"pydy-cache-{user_id}")
    if path not in _warned:
        _warned.add(path)
        warn_user(
            "The user has no home folder (no HOME, and no entry in the user database): compiled "
            f"code is kept in '{path}'. To choose another folder, set the environment variable "
            "PYDY_CACHE_DIR; 'off' keeps none."
        )
    return path


def _make(path: Path) -> None:
    """Make a folder and its parents, accessible to this user only."""
    if not path.is_dir():
        _make(path.parent)
        with contextlib.suppress(FileExistsError):
            path.mkdir(0o700)


def _head(key: str, content: bytes) -> bytes:
    """Return an entry's header, which contains its name: a renamed entry is not accepted."""
    return _MAGIC + hashlib.sha256(key.encode() + content).digest()


# Do not follow links, and do not wait for the other end of a pipe. Windows has neither flag.
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


# -- Entries --------------------------------------------------------------------------------------


def read(key: str) -> bytes | None:
    """Return the content of an entry, by its SHA-256 in hexadecimal digits, or None.

    The result is None if there is no valid entry of this user.
    """
    cache = folder()
    if cache is None:
        return None
    path = cache / f"{key}.code"
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
    cache = folder()
    if cache is None:
        return
    try:
        _make(cache)
        if folder() != cache:  # another user created it meanwhile
            return
        # mkstemp creates the file for this user only.
        handle, temporary = tempfile.mkstemp(dir=cache, prefix=f"{key}.", suffix=".tmp")
    except OSError:
        return
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(_head(key, content) + content)
        os.replace(temporary, cache / f"{key}.code")
    except OSError:
        with contextlib.suppress(OSError):
            os.unlink(temporary)
        return
    # Scanning the folder after each entry would take longer the more entries there are.
    stored = _stored.get(cache, LIMIT_BYTES) + len(content)
    if stored > LIMIT_BYTES // 64:
        stored = 0
        _evict(cache)
    _stored[cache] = stored


def _evict(cache: Path) -> None:
    """Remove the least recently used entries beyond the limit, and stale temporary files."""
    entries = []
    current_time = time.time()
    try:
        with os.scandir(cache) as items:
            for item in filter(lambda item: _OURS.fullmatch(item.name), items):
                with contextlib.suppress(OSError):
                    status = item.stat()
                    if item.name.endswith(".code"):
                        entries.append((status.st_mtime, status.st_size, item.path))
                    elif current_time - status.st_mtime > _STALE_SECONDS:
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
