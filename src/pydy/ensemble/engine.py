"""Blocks of an ensemble in threads, as Dask tasks, and written to a Zarr store."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from math import prod
from threading import Event, Lock, Thread
from typing import Any
from uuid import uuid4

import numpy as np

from pydy._errors import EnsembleInterrupted, note_finished
from pydy._files import path_of
from pydy._forks import cached_property
from pydy._optional import progress_of, require
from pydy._processes import LOOK
from pydy.ensemble import store as stores
from pydy.ensemble.samples import (
    Block,
    Form,
    Samples,
    Variable,
    block_sizes,
    check_forms,
    to_dataset,
)
from pydy.ensemble.work import SMALLEST_BLOCK, Work
from pydy.solvers import Outcome

# Eight samples one after the other that take less, in seconds, come in larger blocks: each costs
# 0.5 ms, and of 64 an interrupt loses 0.2 s at most.
BRIEF = 0.02

_ENDED: set[str] = set()  # runs of Dask in this process that have ended, or were interrupted


@dataclass(frozen=True, eq=False)
class Ensemble:
    """An ensemble that is ready to run."""

    work: Work
    samples: Samples
    chunks: Any  # sizes of blocks as the user gave them
    attrs: dict[str, Any]  # of the Dataset
    workers: int | None = None  # number of threads; None for one for each processor
    progress: bool = False

    @cached_property
    def sizes(self) -> tuple[int, ...]:
        """The sizes of blocks along each dimension."""
        model = self.work.model
        # Work with few samples goes to all threads; large results come in pieces.
        row = 8.0 * len(self.work.names) * (8 if self.work.reductions else len(model.times))
        row *= 1 + len(model.columns)
        # One by one takes long: an interrupt should find blocks that are finished.
        # With more samples an interrupt waits, and threads end at different times.
        most = 8192 if model.in_lanes else SMALLEST_BLOCK
        # About 8 MB of results fit the cache that processors share.
        default = int(min(max(8e6 / row, SMALLEST_BLOCK), most))
        return block_sizes(self.samples.dims, self.chunks, default)

    # -- in memory ----------------------------------------------------------------------------

    def run(self) -> Any:
        """Return the Dataset, computed on threads."""
        shape, model = self.samples.shape, self.work.model
        # Small enough that all threads end at about the same time; sizes decide no bit.
        if self.samples.size <= SMALLEST_BLOCK and model.in_lanes and not self.progress:
            every = tuple(slice(0, size) for size in shape)  # interrupts are heeded here
            done = _Here().submit(self.work, self.samples)
            _check(done, every, self.samples)
            return self._dataset(done.result())
        share = -(-self.samples.size // (4 * self._threads()))
        # An interrupt keeps the finished blocks of what takes long.
        number = max(SMALLEST_BLOCK, min(prod(self.sizes), share)) if model.in_lanes else 8
        left = self._blocks(number)
        whole: dict[str, Variable] = {}
        lock = Lock()
        states = None
        if not self.work.reductions:  # each block writes its states where they belong
            states = np.empty((len(model.states), self.samples.size, len(model.times)))
        placed = {} if states is None else dict(zip(model.states, states, strict=True))

        def do(block: Block, stop: Callable[[], bool]) -> None:
            part = self.samples.of(block)
            here = None
            if states is not None:  # blocks are runs of samples: see `block_sizes`
                first = int(np.ravel_multi_index([s.start for s in block], shape)) if block else 0
                here = states[:, first : first + part.size]
            found = self.work(part, stop, here)
            with lock:
                if not whole:  # all of them at once: memory may end on the way
                    every = {}
                    for name, v in found.items():
                        sizes = (*shape, *v.values.shape[len(block) :])
                        known = placed.get(name)
                        values = np.empty(sizes, v.values.dtype) if known is None else known
                        every[name] = Variable(v.dims, values.reshape(sizes), v.attrs)
                    whole.update(every)
            check_forms(found, self._forms(whole), block)
            for name, v in found.items():
                if name not in placed:
                    whole[name].values[block] = v.values
            with lock:
                left.remove(block)

        try:
            if not model.in_lanes and share > number and self._is_brief(left[0], do):
                left[:] = self._blocks(min(SMALLEST_BLOCK, share))
            self._on_threads(tuple(left), do)
        except (KeyboardInterrupt, MemoryError) as error:
            if not whole:
                raise
            results = self._finished(whole, left)
            if isinstance(error, MemoryError):
                note_finished(error, f"{results[0]} are finished,", results=results[1])
                raise
            raise EnsembleInterrupted(
                f"The ensemble was interrupted: {results[0]} are finished. They are in the "
                f"attribute `results` of this error; `status` is {Outcome.NOT_COMPUTED} for the "
                "others.",
                results[1],
            ) from None
        return self._dataset(whole)

    def _blocks(self, number: int) -> list[Block]:
        """Return blocks of so many samples, as nearly as whole rows allow."""
        sizes = block_sizes(self.samples.dims, number, number)
        return [block for _, block in self.samples.blocks(sizes)]

    def _is_brief(self, block: Block, do: Callable[[Block, Callable[[], bool]], None]) -> bool:
        """Compute a block here; return whether that took so short that larger ones are better."""
        began = time.perf_counter()
        _check(_Here().submit(do, block, lambda: False), block, self.samples)
        return time.perf_counter() - began < BRIEF

    def _finished(self, whole: dict[str, Variable], left: Sequence[Block]) -> tuple[str, Any]:
        """Return the number of finished samples, in words, and their Dataset."""
        for block in left:
            for name, v in whole.items():
                nothing = np.nan if v.values.dtype.kind in "fc" else np.zeros((), v.values.dtype)
                v.values[block] = Outcome.NOT_COMPUTED if name == "status" else nothing
        status = whole["status"].values
        number = np.sum(status != Outcome.NOT_COMPUTED)
        return f"{number} of {status.size} samples", self._dataset(whole)

    def _forms(self, variables: Mapping[str, Variable]) -> dict[str, Form]:
        first = len(self.samples.dims)
        return {
            name: Form.of(v.dims, v.values.shape, v.values.dtype, first)
            for name, v in variables.items()
        }

    def _threads(self) -> int:
        return self.workers or _processors()

    def _dataset(self, variables: dict[str, Variable]) -> Any:
        times = self.work.model.times
        labels = self.work.labels
        return to_dataset(variables, self.samples.coordinates, times, self.attrs, labels)

    def _on_threads(
        self,
        blocks: Sequence[Block],
        do: Callable[[Block, Callable[[], bool]], None],
    ) -> None:
        """Call ``do(block, stop)`` for each block; it ends soon when ``stop()`` is true."""
        stop, total = Event(), sum(map(_size, blocks))
        workers = _startable(min(self._threads(), len(blocks)))
        most = max(1, 2 * workers)
        todo = iter(blocks)
        running: dict[Future[None], Block] = {}
        with (
            progress_of(self.progress, " samples", total) as told,
            ThreadPoolExecutor(workers, "ensemble") if workers else _Here() as pool,
        ):
            try:
                while True:
                    while len(running) < most and (block := next(todo, None)) is not None:
                        running[pool.submit(do, block, stop.is_set)] = block
                    if not running:
                        break
                    for future in wait(running, LOOK, FIRST_COMPLETED).done:
                        block = running.pop(future)
                        _check(future, block, self.samples)
                        told(_size(block))
            finally:
                stop.set()  # blocks that are under way end within a moment
                for future in running:
                    future.cancel()

    # -- lazily -------------------------------------------------------------------------------

    def lazy(self) -> Any:
        """Return a Dataset of Dask arrays, a task for each block."""
        blocks = list(self.samples.blocks(self.sizes))
        dask = require("dask", "ensemble", "`chunks`")
        array = require("dask.array", "ensemble", "`chunks`")
        work = dask.delayed(self.work, traverse=False)
        compute = dask.delayed(_compute, pure=False)
        example = self._example()
        forms = self._forms(example)
        tasks: dict[tuple[int, ...], tuple[Any, Block]] = {}
        for place, block in blocks:
            tasks[place] = compute(work, self.samples.of(block), forms), block
        numbers = [
            -(-whole // size) for whole, size in zip(self.samples.shape, self.sizes, strict=True)
        ]

        def gather(name: str, v: Variable, place: tuple[int, ...] = ()) -> Any:
            if len(place) == len(numbers):
                task, block = tasks[place]
                shape = (*(s.stop - s.start for s in block), *v.values.shape[len(block) :])
                return array.from_delayed(task[name], shape, v.values.dtype)
            axis = len(place)
            parts = [gather(name, v, (*place, k)) for k in range(numbers[axis])]
            return parts[0] if len(parts) == 1 else array.concatenate(parts, axis=axis)

        variables = {n: Variable(v.dims, gather(n, v), v.attrs) for n, v in example.items()}
        return self._dataset(variables)

    def _example(self) -> dict[str, Variable]:
        """Return the results of the first sample, for the names, sizes and types of all."""
        return self.work(self.samples.of(self._first()))

    def _first(self) -> Block:
        return tuple(slice(0, 1) for _ in self.samples.dims)

    # -- into a store -------------------------------------------------------------------------

    def into(self, path: Any, resume: bool | str) -> Any:
        """Write a Zarr store block by block, and return it as a Dataset.

        Blocks that are in the store are not computed again. The others are computed by Dask tasks
        if a Dask scheduler is chosen or a client is connected, and by threads otherwise. With
        `resume` the store may exist; a string is the user's name for the functions.
        """
        require("xarray", "ensemble", "System.integrate_ensemble")
        require("zarr", "ensemble", "`store`")
        path = str(path_of(path, "`store`"))
        parts, times = self._parts(resume), self.work.model.times
        if stores.check(path, parts, bool(resume)):
            stores.write_coordinates(path, self.samples, times)
        else:
            first = self.samples.of(self._first())
            example = to_dataset(self._example(), first.coordinates, times, self.attrs)
            about = path, parts, example, self.samples, self.sizes, self.work.labels
            # In a thread that is waited for: Zarr's own would go on writing after an exception
            # that a signal handler raises here, while what is written there is being removed.
            with ThreadPoolExecutor(1, "store") if _startable(1) else _Here() as pool:
                pool.submit(stores.create, *about).result()
        left = stores.missing(path, [block for _, block in self.samples.blocks(self.sizes)])
        scheduler = self._scheduler()
        if scheduler is None:
            self._on_threads(
                left,
                lambda block, stop: stores.write(
                    path, block, self.work(self.samples.of(block), stop)
                ),
            )
        elif left:
            dask = require("dask", "ensemble", "`store`")
            work = dask.delayed(self.work, traverse=False)
            write = dask.delayed(_compute_and_write, pure=False)
            run = uuid4().hex
            try:
                dask.compute([write(work, self.samples.of(b), path, b, run) for b in left])
            finally:
                _ENDED.add(run)
        return stores.opened(path, {} if scheduler else None)

    def _parts(self, resume: bool | str) -> dict[str, str]:
        """Return what the store is compared by; see `stores.parts_of`."""
        name = resume if isinstance(resume, str) else ""
        users = ["`reduce`"] if self.work.function else []
        users += ["`specifieds`"] if self.work.model.functions else []
        if users and resume is True:
            raise ValueError(
                f"`resume=True` needs more: there are Python functions in {' and '.join(users)}, "
                "and whether those of another call are the same is not looked at. Name them "
                "yourself, resume='name', from the first call on, and change the name when they "
                "change."
            )
        return stores.parts_of(self.work, self.samples, self.sizes, name)

    def _scheduler(self) -> Any:
        try:
            from dask.base import get_scheduler
        except ImportError:
            return None
        return get_scheduler()


def _size(block: Block) -> int:
    """Return the number of samples in a block."""
    return prod(s.stop - s.start for s in block)


def _processors() -> int:
    """Return how many processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _startable(number: int) -> int:
    """Return how many threads can be started, up to a given number."""
    end, started = Event(), []
    try:
        for _ in range(number):
            thread = Thread(target=end.wait)
            thread.start()
            started.append(thread)
    except RuntimeError:  # the system's limit
        pass
    finally:
        end.set()
        for thread in started:
            thread.join()
    return len(started)


class _Here(Executor):
    """Calls functions at once in the calling thread, where there is no use in another, or none."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:  # noqa: BLE001 - the caller asks the future
            future.set_exception(error)
        return future


def _compute(work: Work, samples: Samples, forms: dict[str, Form]) -> dict[str, np.ndarray]:
    """Compute one block: the task of a lazy Dataset."""
    found = work(samples)
    check_forms(found, forms, tuple(samples.dims))
    return {name: v.values for name, v in found.items()}


def _compute_and_write(work: Work, samples: Samples, path: str, block: Block, run: str) -> None:
    """Compute one block and write it: the task of a store.

    Dask's threads continue after Ctrl-C, and the process waits for them: those of this process
    check whether their run has ended.
    """
    stores.write(path, block, work(samples, lambda: run in _ENDED))


def _check(future: Future[None], block: Block, samples: Samples) -> None:
    """Raise the error that a block met, with the block's position."""
    try:
        future.result()
    except Exception as error:
        where = ", ".join(
            f"{dim} {s.start} to {s.stop - 1}" for dim, s in zip(samples.dims, block, strict=True)
        )
        error.add_note(f"This happened in the samples {where or 'given'} of the ensemble.")
        raise
