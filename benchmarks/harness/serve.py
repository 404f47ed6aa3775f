"""The worker's side: answer requests, one JSON object a line, until standard input ends."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any


def serve(commands: dict[str, Callable[..., Any]]) -> None:
    """Answer ``{"do": name, ...}`` with ``{"ok": result}`` or ``{"error": message}``."""
    channel = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # whatever a library prints goes to the log, not between the answers
    for line in sys.stdin:
        request = json.loads(line)
        print(json.dumps(_answer(commands, request)), file=channel, flush=True)


def _answer(commands: dict[str, Callable[..., Any]], request: dict[str, Any]) -> dict[str, Any]:
    try:
        return {"ok": commands[request.pop("do")](**request)}
    except Exception as error:  # noqa: BLE001 a peer that fails is a result, not the end of the run
        text = str(error).strip().splitlines() or [""]
        return {"error": f"{type(error).__name__}: {text[0][:200]}"}


def in_child(function: Callable[[], Any], cache: str | Path | None = None) -> Any:
    """Call `function` in a forked copy of this process, so that it leaves no warm cache behind.

    pydy's cache of machine code is a copy of the folder `cache` there, or empty.
    """
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        with contextlib.suppress(BaseException), tempfile.TemporaryDirectory() as folder:
            os.close(reading)
            if cache is not None:
                shutil.copytree(cache, folder, dirs_exist_ok=True)
            os.environ["PYDY_CACHE_DIR"] = folder
            answer = _answer({"call": function}, {"do": "call"})
            with os.fdopen(writing, "w") as pipe:
                json.dump(answer, pipe)
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading) as pipe:
        text = pipe.read()
    os.waitpid(child, 0)
    if not text:
        raise RuntimeError("the forked process died")
    answer = json.loads(text)
    if "error" in answer:
        raise RuntimeError(answer["error"])
    return answer["ok"]


def time_of(function: Callable[[], Any]) -> float:
    """Return the seconds that one call takes."""
    start = time.perf_counter()
    function()
    return time.perf_counter() - start


def processor_time(function: Callable[[], Any], least: float = 0.03) -> float:
    """Return the seconds of processor time per call, of calls for at least `least` seconds."""
    number = 1
    while True:
        start = time.process_time()
        for _ in range(number):
            function()
        seconds = time.process_time() - start
        if seconds >= least:
            return seconds / number
        number *= 2


class Repeated:
    """Seconds per call of a short function, in runs of at least `least` seconds."""

    def __init__(self, function: Callable[[], Any], least: float = 0.03) -> None:
        self.function = function
        self.number = 1
        while (seconds := self._run()) < least:
            self.number = max(2 * self.number, int(self.number * least / max(seconds, 1e-9)))

    def _run(self) -> float:
        function = self.function
        start = time.perf_counter()
        for _ in range(self.number):
            function()
        return time.perf_counter() - start

    def __call__(self) -> float:
        return self._run() / self.number


def module_at(path: str | Path) -> Any:
    """Import a module by its file's path, whatever package it belongs to."""
    from importlib.util import module_from_spec, spec_from_file_location

    name = Path(path).stem
    spec = spec_from_file_location(name, path)
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    sys.modules[name] = module  # dataclasses look their module up
    spec.loader.exec_module(module)
    return module
