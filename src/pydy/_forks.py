"""Forks of the process while its other threads are at work.

A forked child has one thread, and every lock as it was: what another thread held stays locked for
ever. What compiling holds is of two kinds:

- `Lock` protects what is sound at any moment, such as a table that is looked up and then filled.
  The child finds it open, and does again what was under way.
- llvmlite changes structures of its own, which are not sound in between: a fork waits until it is
  done, as it does for `fork_lock`, which is held while modules are loaded.
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

    Nothing keeps a list of all locks: where such a list is told of a lock that goes, Python loses
    what a signal handler raises at that moment.
    """

    def __init__(self) -> None:
        self._locks: dict[int, threading.RLock] = {}  # by generation of forks

    def _own(self) -> threading.RLock:
        generation = _generation
        return self._locks.get(generation) or self._locks.setdefault(generation, threading.RLock())

    def __enter__(self) -> None:
        self._own().acquire()

    def __exit__(self, *_: object) -> None:
        self._own().release()


def once(function: Callable[..., T]) -> Callable[..., T]:
    """Cache a function's results, each computed once for all threads.

    `functools.cache` lets each thread that comes first make one and keeps the last of them. Machine
    code is handed on by its address, so that the others would go while they are in use.
    """
    lock, known = Lock(), dict[tuple[Any, ...], T]()

    @wraps(function)
    def called(*key: Any) -> T:
        if key not in known:
            with lock:
                if key not in known:
                    known[key] = function(*key)
        return known[key]

    called.cache_clear = known.clear  # type: ignore[attr-defined]
    return called


_generation = 0
fork_lock = threading.RLock()
"""Held while something happens that a fork waits for."""


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


_held: list[Any] = []


def _before() -> None:
    fork_lock.acquire()
    lock: Any = sys.modules.get("llvmlite.binding.ffi")
    for name in ("lib", "_lock"):
        lock = getattr(lock, name, None)
    if lock is not None:
        lock.__enter__()
        _held.append(lock)


def _after() -> None:
    while _held:
        _held.pop().__exit__(None, None, None)
    fork_lock.release()


def _after_in_child() -> None:
    global _generation
    _generation += 1
    _after()
    for function in _children:
        function()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_before, after_in_parent=_after, after_in_child=_after_in_child)
