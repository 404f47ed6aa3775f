"""Machine code on disk and in memory, so that nothing is compiled twice.

An entry is a file named by its key with a checksum before its content: whatever is truncated,
foreign or unreadable is a miss. Files are written aside and renamed, so several processes can share
a folder and a killed one leaves nothing that counts. No failure of the disk is ever an error.

The environment variable PYDY_CACHE_DIR names another folder; ``off`` turns the cache off.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import tempfile
import time
from collections import OrderedDict
from pathlib import Path
from typing import Any

from pydy._cache_folder import folder

__all__ = ["LIMIT_BYTES", "folder", "memory", "read", "write"]

LIMIT_BYTES = 256 * 2**20
_MAGIC = b"pydy code 1\n"
_STALE_SECONDS = 3600.0
_KEPT_IN_MEMORY = 64


class _Memory:
    """The most recently used machine code of this process."""

    def __init__(self) -> None:
        self._entries: OrderedDict[str, Any] = OrderedDict()

    def get(self, key: str) -> Any:
        """Return the entry or None."""
        entry = self._entries.get(key)
        if entry is not None:
            self._entries.move_to_end(key)
        return entry

    def put(self, key: str, entry: Any) -> None:
        """Keep an entry and forget the least recently used one beyond the limit."""
        self._entries[key] = entry
        while len(self._entries) > _KEPT_IN_MEMORY:
            self._entries.popitem(last=False)

    def clear(self) -> None:
        """Forget everything."""
        self._entries.clear()


memory = _Memory()


def _path(key: str) -> Path | None:
    place = folder()
    return None if place is None else place / f"{key}.code"


def _head(key: str, content: bytes) -> bytes:
    """Return what precedes the content: an entry under another entry's name is foreign too."""
    return _MAGIC + hashlib.sha256(key.encode() + content).digest()


def read(key: str) -> bytes | None:
    """Return the content of an entry, or None when there is no sound one."""
    path = _path(key)
    if path is None:
        return None
    try:
        data = path.read_bytes()
    except OSError:
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
    path = _path(key)
    if path is None:
        return
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(dir=path.parent, prefix="tmp-")
    except OSError:
        return
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(_head(key, content) + content)
        os.replace(name, path)
    except OSError:
        with contextlib.suppress(OSError):
            os.unlink(name)
        return
    _evict(path.parent)


def _evict(place: Path) -> None:
    """Remove the least recently used entries beyond the limit, and what killed processes left."""
    entries = []
    now = time.time()
    try:
        with os.scandir(place) as items:
            for item in items:
                with contextlib.suppress(OSError):
                    status = item.stat()
                    if item.name.startswith("tmp-"):
                        if now - status.st_mtime > _STALE_SECONDS:
                            os.unlink(item.path)
                    elif item.name.endswith(".code"):
                        entries.append((status.st_mtime, status.st_size, item.path))
    except OSError:
        return
    total = sum(size for _, size, _ in entries)
    for _, size, path in sorted(entries):
        if total <= LIMIT_BYTES:
            break
        with contextlib.suppress(OSError):
            os.unlink(path)
            total -= size
