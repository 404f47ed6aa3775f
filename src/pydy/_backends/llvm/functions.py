"""The native functions of a Program or Tangent, compiled when they are first called.

Compiled loops and gates read the addresses each time they call, so that other code can take the
place of the first in the middle of a run.
"""

from __future__ import annotations

import _thread
import ctypes
import sys
import threading
import time
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, cast
from weakref import WeakSet, WeakValueDictionary, ref

import numpy as np

from pydy import _forks
from pydy._backends.llvm import jit
from pydy._backends.llvm.sources import (
    leaves_out_fallbacks,
    routines_of,
    source_for_one_state,
    source_without_fallbacks,
)
from pydy._backends.llvm.text import COMPLETE
from pydy._program import Program, Tangent


class NativeFunctions:
    """The addresses of the functions `kernel` and `prepare` of a Program.

    The code is compiled by `link`, unless `replace` brings functions from elsewhere. `addresses`
    is a (2,) array of them, zero before that: who calls them reads them there, each time.
    """

    def __init__(self, program: Program | Tangent | None = None) -> None:
        self._program = program
        self._lock = _forks.Lock()
        self.addresses = np.zeros(2, dtype=np.int64)
        self._owners: list[Any] = []  # a call may be under way in the code before: it stays
        self._copies: list[np.ndarray] = []

    def link(self) -> None:
        """Compile the code, or take it from a cache, unless it is there."""
        if self.addresses[0]:
            return
        with self._lock:
            if not self.addresses[0] and self._program is not None:
                code, complete = _code(self._program)
                self.use(code)
                if complete is not None:
                    complete.link_in_place(self)

    def use(self, code: jit.Code) -> None:
        """Call these functions from now on."""
        self.replace((code.addresses["kernel"], code.addresses["prepare"]), code)

    def replace(self, addresses: tuple[int, int], owner: Any) -> None:
        """Call other functions from now on; `owner` keeps their code alive."""
        if addresses == (*self.addresses,):
            return
        self._owners.append(owner)
        for words in (self.addresses, *self._copies):
            words[:2] = addresses

    def bind(self, words: np.ndarray) -> None:
        """Keep the first two words of an array equal to the addresses."""
        self._copies.append(words)
        words[:2] = self.addresses


def _code(program: Program | Tangent) -> tuple[jit.Code, CompleteCode | None]:
    """Return the code for one state, and where it has no fallbacks, what stands in for them."""
    if not leaves_out_fallbacks(program):
        return jit.load(source_for_one_state(program), routines_of(program, 1)), None
    complete = CompleteCode.of(program)
    routines = routines_of(program, 1, fallbacks=False)
    return jit.load(source_without_fallbacks(program), [*routines, complete]), complete


_KERNEL = ctypes.CFUNCTYPE(ctypes.c_int32, *[ctypes.c_void_p] * 5)


class CompleteCode:
    """The code of a Program or Tangent with all fallbacks, compiled when a guard is not sound.

    Code without fallbacks calls it by the address of a Python function, once: then the complete
    code takes its place.
    """

    addresses: dict[str, int]

    def __init__(self, program: Program | Tangent) -> None:
        self._program = program
        self._lock = _forks.Lock()
        self._code: jit.Code | None = None
        self._waiting: WeakSet[NativeFunctions] = WeakSet()
        known = ref(self)  # the code that calls it keeps this object
        self._callback = _KERNEL(lambda *arrays: cast("CompleteCode", known())._call(*arrays))
        self.addresses = {COMPLETE: ctypes.cast(self._callback, ctypes.c_void_p).value or 0}

    @staticmethod
    def of(program: Program | Tangent) -> CompleteCode:
        """Return the one of a Program or Tangent: its code is shared, too."""
        with _COMPLETE_LOCK:
            known = _COMPLETE.get(program.digest)
            if known is None:
                known = _COMPLETE[program.digest] = CompleteCode(program)
        return known

    def link_in_place(self, functions: NativeFunctions) -> None:
        """Have the complete code take the place of these functions' code once it is compiled."""
        with self._lock:
            if self._code is None:
                self._waiting.add(functions)
                return
        functions.use(self._code)

    def _call(self, *arrays: int) -> int:
        try:
            kernel: Callable[..., int] = _KERNEL(self.link().addresses["kernel"])
        except KeyboardInterrupt:  # ctypes would lose it: it comes again after this call
            threading.Thread(target=_interrupt_after, daemon=True).start()
            return -1
        except Exception as error:  # noqa: BLE001  # whatever it is, ctypes would lose it
            # ctypes would go on with the status 0 and what lay in the results. No state is right.
            report: Any = SimpleNamespace(
                exc_type=type(error), exc_value=error, exc_traceback=error.__traceback__,
                err_msg=None, object=self._callback,
            )  # fmt: skip
            sys.unraisablehook(report)
            return -1
        return kernel(*arrays)

    def link(self) -> jit.Code:
        """Compile the code, or take it from a cache, and have it called from now on."""
        with self._lock:
            if self._code is None:
                source = source_for_one_state(self._program)
                code = jit.load(source, routines_of(self._program, 1))
                for functions in [*self._waiting]:
                    functions.use(code)
                self._code = code
            return self._code


def _interrupt_after() -> None:
    """Interrupt the main thread once it runs nothing of this module, however long that takes.

    `CompleteCode._call` is not all that ctypes calls: the function around it is left after it.
    """
    main = threading.main_thread().ident
    here = _interrupt_after.__code__.co_filename
    while True:
        frame = sys._current_frames().get(main or 0)
        while frame is not None and frame.f_code.co_filename != here:
            frame = frame.f_back
        if frame is None:
            break
        time.sleep(0.001)
    _thread.interrupt_main()


_COMPLETE: WeakValueDictionary[str, CompleteCode] = WeakValueDictionary()
_COMPLETE_LOCK = _forks.Lock()
