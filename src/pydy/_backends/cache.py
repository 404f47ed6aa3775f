"""The most recently used machine code of this process; what lies on disk is `_cache_folder`'s."""

from __future__ import annotations

from collections import OrderedDict
from typing import Any

__all__ = ["memory"]

_KEPT_IN_MEMORY = 64


class _Memory:
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
