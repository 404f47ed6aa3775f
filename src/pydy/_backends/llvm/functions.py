"""The native functions of a Program or Tangent, compiled when they are first called.

Compiled loops and gates read the addresses at each call, so that the code can be replaced during a
run.
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


class LinkedFunctions:
    """The addresses of the functions `kernel` and `prepare` of a Program.

    `link` compiles the code, unless `replace` sets other functions. `addresses` is a (2,) array,
    zero before that. Callers read it at each call.
    """

    def __init__(self, program: Program | Tangent | None = None) -> None:
        self._program = program
        self._lock = _forks.Lock()
        self.addresses = np.zeros(2, dtype=np.int64)
        self._owners: list[Any] = []  # replaced code stays in memory: a call of it may be running
        self._copies: list[np.ndarray] = []

    def link(self) -> None:
        """Compile the code or load it from a cache, unless this has been done."""
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
    """Return the code for one state, and the complete code if the first has no fallbacks."""
    if not leaves_out_fallbacks(program):
        return jit.load(source_for_one_state(program), routines_of(program, 1)), None
    complete = CompleteCode.shared(program)
    routines = routines_of(program, 1, fallbacks=False)
    return jit.load(source_without_fallbacks(program), [*routines, complete]), complete


_KERNEL = ctypes.CFUNCTYPE(ctypes.c_int32, *[ctypes.c_void_p] * 5)


class CompleteCode:
    """The code of a Program or Tangent with all fallbacks, compiled when a guard is not sound.

    Code without fallbacks calls it once, by the address of a Python function. Then it is replaced
    by the complete code.
    """

    addresses: dict[str, int]

    def __init__(self, program: Program | Tangent) -> None:
        self._program = program
        self._lock = _forks.Lock()
        self._code: jit.Code | None = None
        self._waiting: WeakSet[LinkedFunctions] = WeakSet()
        weak_self = ref(self)  # the code that calls it keeps this object
        self._callback = _KERNEL(lambda *arrays: cast("CompleteCode", weak_self())._call(*arrays))
        self.addresses = {COMPLETE: ctypes.cast(self._callback, ctypes.c_void_p).value or 0}

    @staticmethod
    def shared(program: Program | Tangent) -> CompleteCode:
        """Return the object that all users of a Program or Tangent share."""
        with _COMPLETE_LOCK:
            code = _COMPLETE.get(program.digest)
            if code is None:
                code = _COMPLETE[program.digest] = CompleteCode(program)
        return code

    def link_in_place(self, functions: LinkedFunctions) -> None:
        """Replace the code of these functions by the complete code once it is compiled."""
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
        """Compile the code or load it from a cache, and switch all callers to it."""
        with self._lock:
            if self._code is None:
                source = source_for_one_state(self._program)
                code = jit.load(source, routines_of(self._program, 1))
                for functions in [*self._waiting]:
                    functions.use(code)
                self._code = code
            return self._code


def _interrupt_after() -> None:
    """Interrupt the main thread as soon as it runs no code of this module.

    This includes the function around `CompleteCode._call`, which ctypes calls.
    """
    main = threading.main_thread().ident
    this_file = _interrupt_after.__code__.co_filename
    while True:
        frame = sys._current_frames().get(main or 0)
        while frame is not None and frame.f_code.co_filename != this_file:
            frame = frame.f_back
        if frame is None:
            break
        time.sleep(0.001)
    _thread.interrupt_main()


_COMPLETE: WeakValueDictionary[str, CompleteCode] = WeakValueDictionary()
_COMPLETE_LOCK = _forks.Lock()
