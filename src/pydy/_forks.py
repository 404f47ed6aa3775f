"""Make forks safe while other threads of the process are running.

A forked child has one thread and a copy of every lock: a lock that another thread held remains
locked for ever. Compilation has locks of two kinds:

- `Lock` protects data that are consistent at any moment, such as a table of results. It is open in
  the child, which repeats interrupted work.
- llvmlite's internal structures are inconsistent during changes: a fork waits for llvmlite's lock,
  and for `fork_lock`, which is held while modules are loaded.
"""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable
from functools import wraps
from typing import Any, Generic, TypeVar, overload

T = TypeVar("T")


class Lock:
    """A reentrant lock that is open in a forked child.

    There is no list of all locks: with weak references, Python would lose an exception that a
    signal handler raises in the callback of a deleted lock.
    """

    def __init__(self) -> None:
        self._locks: dict[int, threading.RLock] = {}  # by generation of forks

    def _current(self) -> threading.RLock:
        generation = _generation
        return self._locks.get(generation) or self._locks.setdefault(generation, threading.RLock())

    def __enter__(self) -> None:
        self._current().acquire()

    def __exit__(self, *_: object) -> None:
        self._current().release()


def once(function: Callable[..., T]) -> Callable[..., T]:
    """Cache a function's results, each computed once for all threads.

    With `functools.cache`, concurrent threads may compute several results, of which only the last
    is stored. Machine code is passed on by address, so that the others would be freed while in use.
    """
    lock, results = Lock(), dict[tuple[Any, ...], T]()

    @wraps(function)
    def cached(*key: Any) -> T:
        if key not in results:
            with lock:
                if key not in results:
                    results[key] = function(*key)
        return results[key]

    cached.cache_clear = results.clear  # type: ignore[attr-defined]
    return cached


_generation = 0
fork_lock = threading.RLock()
"""Held during operations that a fork must wait for."""


class cached_property(Generic[T]):  # noqa: N801 - as functools has it
    """A property that is cached without a lock: concurrent threads may compute it twice.

    Before Python 3.12 that of functools holds a lock, the same for all objects of a class.
    """

    def __init__(self, function: Callable[[Any], T]) -> None:
        self._function = function
        self.__doc__ = function.__doc__

    @overload
    def __get__(self, instance: None, owner: type) -> cached_property[T]: ...
    @overload
    def __get__(self, instance: object, owner: type) -> T: ...
    def __get__(self, instance: Any, owner: type) -> Any:
        if instance is None:
            return self
        value = self._function(instance)
        return instance.__dict__.setdefault(self._function.__name__, value)


_children: list[Callable[[], None]] = []


def in_child(function: Callable[[], None]) -> Callable[[], None]:
    """Register a function to be called first in each forked child."""
    _children.append(function)
    return function


_acquired: list[Any] = []


def _before() -> None:
    fork_lock.acquire()
    lock: Any = sys.modules.get("llvmlite.binding.ffi")
    for name in ("lib", "_lock"):
        lock = getattr(lock, name, None)
    if lock is not None:
        lock.__enter__()
        _acquired.append(lock)


def _after() -> None:
    while _acquired:
        _acquired.pop().__exit__(None, None, None)
    fork_lock.release()


def _after_in_child() -> None:
    global _generation
    _generation += 1
    _after()
    for function in _children:
        function()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_before, after_in_parent=_after, after_in_child=_after_in_child)
