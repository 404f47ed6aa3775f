"""Runs the blocks of an ensemble in threads or as Dask tasks, or writes them to a Zarr store."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ThreadPoolExecutor, wait
from contextlib import nullcontext
from dataclasses import dataclass, replace
from functools import partial
from math import prod
from threading import Event, Lock, Thread
from typing import TYPE_CHECKING, Any, TypeVar
from uuid import uuid4

import numpy as np

from pydy._errors import EnsembleInterrupted, note_finished
from pydy._files import path_of
from pydy._forks import cached_property
from pydy._interrupts import Interrupts
from pydy._optional import progress_of, require
from pydy._processes import LOOK
from pydy.ensemble import store as stores
from pydy.ensemble.samples import (
    ArrayForm,
    Block,
    LabelledArray,
    Samples,
    block_sizes,
    check_forms,
    to_dataset,
)
from pydy.ensemble.work import SMALLEST_BLOCK, Work
from pydy.solvers import Outcome

if TYPE_CHECKING:
    from xarray import Dataset

# Blocks are enlarged if eight samples, integrated one by one, take less time than this (s): each
# block costs 0.5 ms, and an interrupt then loses at most 0.2 s of work in a block of 64.
BRIEF = 0.02

# Dask tasks for each thread of a cluster. At the end a thread waits for half a task on average, 3 %
# of its work. With half as many tasks it waits twice as long; with twice as many, the overhead of
# short motions exceeds the gain.
BLOCKS_PER_THREAD = 16

T = TypeVar("T")

_ENDED: set[str] = set()  # Dask runs of this process that have ended or were interrupted


@dataclass(frozen=True, eq=False)
class Ensemble:
    """An ensemble that is ready to run."""

    work: Work
    samples: Samples
    chunks: int | str | Mapping[str, int] | None  # sizes of blocks, as passed by the user
    attrs: Mapping[str, object]  # of the Dataset
    workers: int | None = None  # number of threads; None means one for each processor
    progress: bool = False

    @cached_property
    def sizes(self) -> tuple[int, ...]:
        """The sizes of blocks along each dimension."""
        model = self.work.model
        # Few samples are distributed to all threads; large results are divided.
        row = 8.0 * len(self.work.names) * (8 if self.work.reductions else len(model.times))
        row *= 1 + len(model.columns)
        # Integration one by one is slow: blocks are small, so that an interrupt loses little.
        # In lanes, larger blocks would delay an interrupt and end at different times.
        most = 8192 if model.in_lanes else SMALLEST_BLOCK
        # About 8 MB of results fit into the processors' shared cache.
        default = int(min(max(8e6 / row, SMALLEST_BLOCK), most))
        return block_sizes(self.samples.dims, self.chunks, default)

    @cached_property
    def _task_sizes(self) -> tuple[int, ...]:
        """The sizes of the blocks that are Dask tasks, along each dimension.

        A task costs the scheduler tens of milliseconds, as much as hundreds of short motions. A
        cluster therefore gets few tasks: at least one for each thread, and with many samples
        `BLOCKS_PER_THREAD`, so that all threads end at about the same time.
        """
        is_automatic = isinstance(self.chunks, str) and self.work.model.in_lanes
        threads = self._threads_of_cluster() if is_automatic else 0
        if threads == 0:
            return self.sizes
        size = prod(self.sizes)
        smallest = max(SMALLEST_BLOCK, min(size, -(-self.samples.size // threads)))
        share = -(-self.samples.size // (BLOCKS_PER_THREAD * threads))
        default = max(smallest, min(share, 4 * size))
        return block_sizes(self.samples.dims, self.chunks, default)

    # -- in memory ----------------------------------------------------------------------------

    def run(self) -> Dataset:
        """Return the Dataset, computed on threads."""
        shape, model = self.samples.shape, self.work.model
        # Blocks are so small that all threads end at about the same time. Results do not depend on
        # the sizes.
        if self.samples.size <= SMALLEST_BLOCK and model.in_lanes and not self.progress:
            whole = tuple(slice(0, size) for size in shape)  # Ctrl-C works in this thread
            future = _SerialExecutor().submit(self.work, self.samples)
            _check(future, whole, self.samples)
            return self._dataset(future.result())
        quarter = -(-self.samples.size // (4 * self._threads()))  # of the samples of a thread
        # Slow integrations get small blocks: an interrupt preserves those that are finished.
        block_size = max(SMALLEST_BLOCK, min(prod(self.sizes), quarter)) if model.in_lanes else 8
        pending = self._blocks(block_size)
        results: dict[str, LabelledArray] = {}
        lock = Lock()
        states = None
        if not self.work.reductions:  # each block writes its states into the full array
            # (states, samples, times), in the order in which the results have them
            states = np.empty((len(model.states), self.samples.size, len(model.times)))
        written_in_place = {} if states is None else dict(zip(model.states, states, strict=True))

        def compute_block(block: Block, stop: Callable[[], bool]) -> None:
            part = self.samples.in_block(block)
            block_states = None
            if states is not None:  # blocks are contiguous samples: see `block_sizes`
                first = int(np.ravel_multi_index([s.start for s in block], shape)) if block else 0
                block_states = states[:, first : first + part.size]
            block_results = self.work(part, stop, block_states)
            with lock:
                if not results:  # allocate all arrays at once, in case memory runs out
                    results.update(self._allocated(block_results, written_in_place))
            check_forms(block_results, self._forms(results), block)
            for name, v in block_results.items():
                if name not in written_in_place:
                    results[name].values[block] = v.values
            with lock:
                pending.remove(block)

        try:
            with progress_of(self.progress, " samples", self.samples.size) as report:
                if not model.in_lanes and quarter > block_size:
                    first = pending[0]
                    if self._is_brief(first, compute_block):  # it is computed again
                        pending[:] = self._blocks(min(SMALLEST_BLOCK, quarter))
                    else:
                        report(_size(first))
                self._on_threads(tuple(pending), compute_block, report)
        except (KeyboardInterrupt, MemoryError) as error:
            if not results:
                raise
            finished = self._finished(results, pending)
            if isinstance(error, MemoryError):
                note_finished(error, f"{finished[0]} are finished,", results=finished[1])
                raise
            raise EnsembleInterrupted(
                f"The ensemble was interrupted: {finished[0]} are finished. They are in the "
                f"attribute `results` of this error; `status` is {Outcome.NOT_COMPUTED} for the "
                "others.",
                finished[1],
            ) from None
        return self._dataset(results)

    def _allocated(
        self, block_results: Mapping[str, LabelledArray], written_in_place: Mapping[str, np.ndarray]
    ) -> dict[str, LabelledArray]:
        """Return arrays for the results of all samples, like those of a block."""
        arrays = {}
        for name, v in block_results.items():
            sizes = (*self.samples.shape, *v.values.shape[len(self.samples.dims) :])
            values = written_in_place.get(name)
            values = np.empty(sizes, v.values.dtype) if values is None else values.reshape(sizes)
            arrays[name] = LabelledArray(v.dims, values, v.attrs)
        return arrays

    def _blocks(self, size: int) -> list[Block]:
        """Return blocks of at most `size` samples, in complete rows."""
        sizes = block_sizes(self.samples.dims, size, size)
        return [block for _, block in self.samples.blocks(sizes)]

    def _is_brief(self, block: Block, do: Callable[[Block, Callable[[], bool]], None]) -> bool:
        """Compute a block in this thread; return whether it is so fast that larger ones pay off."""
        began = time.perf_counter()
        _check(_SerialExecutor().submit(do, block, lambda: False), block, self.samples)
        return time.perf_counter() - began < BRIEF

    def _finished(
        self, results: dict[str, LabelledArray], pending: Sequence[Block]
    ) -> tuple[str, Dataset]:
        """Return the number of finished samples as text, and their Dataset."""
        for block in pending:
            for name, v in results.items():
                nothing = np.nan if v.values.dtype.kind in "fc" else np.zeros((), v.values.dtype)
                v.values[block] = Outcome.NOT_COMPUTED if name == "status" else nothing
        status = results["status"].values
        number = np.sum(status != Outcome.NOT_COMPUTED)
        return f"{number} of {status.size} samples", self._dataset(results)

    def _forms(self, variables: Mapping[str, LabelledArray]) -> dict[str, ArrayForm]:
        first = len(self.samples.dims)
        return {
            name: ArrayForm.from_array(v.dims, v.values.shape, v.values.dtype, first)
            for name, v in variables.items()
        }

    def _threads(self) -> int:
        return self.workers or _processors()

    def _dataset(self, variables: dict[str, LabelledArray]) -> Dataset:
        times = self.work.model.times
        labels = self.work.labels
        return to_dataset(variables, self.samples.coordinates, times, self.attrs, labels)

    def _on_threads(
        self,
        blocks: Sequence[Block],
        do: Callable[[Block, Callable[[], bool]], None],
        report: Callable[[int], None],
    ) -> None:
        """Call ``do(block, stop)`` for each block; calls return soon after ``stop()`` is true.

        The numbers of samples that are computed are passed to `report`.
        """
        # A KeyboardInterrupt while this thread takes the lock of a future leaves it locked: the
        # thread that sets its result would wait for ever. Without threads, solvers are interrupted.
        stop, interrupts = Event(), Interrupts()
        with interrupts:
            workers = _startable(min(self._threads(), len(blocks)))
        most = max(1, 2 * workers)
        todo = iter(blocks)
        running: dict[Future[None], Block] = {}
        with (
            interrupts if workers else nullcontext(),
            ThreadPoolExecutor(workers, "ensemble") if workers else _SerialExecutor() as pool,
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
                        report(_size(block))
                    interrupts.check()
            finally:
                stop.set()  # running blocks return soon
                for future in running:
                    future.cancel()

    # -- lazily -------------------------------------------------------------------------------

    def lazy(self) -> Dataset:
        """Return a Dataset of Dask arrays.

        A block is one task, and each variable has one more, which takes it from the results of the
        block: where that is reduced, Dask makes it a part of the reduction.
        """
        dask = require("dask", "ensemble", "`chunks`")
        array = require("dask.array", "ensemble", "`chunks`")
        from dask.highlevelgraph import HighLevelGraph

        work = dask.delayed(self.work, traverse=False)
        example, run = self._example(), uuid4().hex
        forms = self._forms(example)
        computed, first = f"block-{run}", len(self.samples.dims)
        tasks: dict[Any, Any] = {}
        positions: list[tuple[int, ...]] = []
        for position, block in self.samples.blocks(self._task_sizes):
            # Bound to the function: as arguments, Dask would take all their arrays and names apart.
            compute = partial(_compute, samples=self._sent(block), forms=forms)
            tasks[(computed, *position)] = (compute, work.key)
            positions.append(position)
        graph = HighLevelGraph.from_collections(computed, tasks, dependencies=[work])
        layers: dict[str, Any] = dict(graph.layers)
        dependencies = dict(graph.dependencies)
        chunks = [
            tuple(min(size, length - start) for start in range(0, length, size))
            for length, size in zip(self.samples.shape, self._task_sizes, strict=True)
        ]
        keys = {}
        for name in example:
            keys[name] = f"{name}-of-{computed}"
            rest = (0,) * (example[name].values.ndim - first)
            layers[keys[name]] = {
                (keys[name], *position, *rest): (_variable, (computed, *position), name)
                for position in positions
            }
            dependencies[keys[name]] = {computed}
        graph = HighLevelGraph(layers, dependencies)
        variables = {}
        for name, v in example.items():
            sizes = (*chunks, *((size,) for size in v.values.shape[first:]))
            values = array.Array(graph, keys[name], sizes, dtype=v.values.dtype)
            variables[name] = LabelledArray(v.dims, values, v.attrs)
        return self._dataset(variables)

    def _sent(self, block: Block) -> Samples:
        """Return the samples of a block for a Dask task.

        Coordinates are labels for the user's function; they double what is sent.
        """
        part = self.samples.in_block(block)
        return part if self.work.function else replace(part, coordinates={})

    def _example(self) -> dict[str, LabelledArray]:
        """Return the results of the first sample, which define names, sizes and types of all."""
        return self.work(self.samples.in_block(self._first()))

    def _first(self) -> Block:
        return tuple(slice(0, 1) for _ in self.samples.dims)

    # -- into a store -------------------------------------------------------------------------

    def into(self, path: str | os.PathLike[str], resume: bool | str) -> Dataset:
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
            first = self.samples.in_block(self._first())
            example = to_dataset(self._example(), first.coordinates, times, self.attrs)
            arguments = path, parts, example, self.samples, self.sizes, self.work.labels
            # In a separate thread: after an exception from a signal handler in this thread, Zarr's
            # threads would continue to write while the files are being removed.
            with ThreadPoolExecutor(1, "store") if _startable(1) else _SerialExecutor() as pool:
                pool.submit(stores.create, *arguments).result()
        pending = stores.missing(path, [block for _, block in self.samples.blocks(self.sizes)])
        scheduler = self._scheduler()
        if scheduler is None:
            with progress_of(self.progress, " samples", sum(map(_size, pending))) as report:
                self._on_threads(
                    pending,
                    lambda block, stop: stores.write(
                        path, block, self.work(self.samples.in_block(block), stop)
                    ),
                    report,
                )
        elif pending:
            dask = require("dask", "ensemble", "`store`")
            work = dask.delayed(self.work, traverse=False)
            run = uuid4().hex

            def write(block: Block) -> Any:
                samples = self._sent(block)
                task = partial(_compute_and_write, samples=samples, path=path, block=block, run=run)
                return dask.delayed(task, pure=False)(work)

            try:
                dask.compute([write(block) for block in pending])
            finally:
                _ENDED.add(run)
        return stores.open_dataset(path, {} if scheduler else None)

    def _parts(self, resume: bool | str) -> dict[str, str]:
        """Return the digests that identify the store; see `stores.parts_of`."""
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

    def _scheduler(self) -> object:
        try:
            from dask.base import get_scheduler
        except ImportError:
            return None
        return get_scheduler()

    def _threads_of_cluster(self) -> int:
        """Return the number of threads of the cluster that would compute, or 0 without one."""
        if "distributed" not in sys.modules:  # Dask would import it, to find no client
            return 0
        try:
            client = getattr(self._scheduler(), "__self__", None)
            threads_of_workers = getattr(client, "nthreads", dict)
            return sum(threads_of_workers().values())
        except (RuntimeError, OSError):  # an asynchronous client, or one without an answer
            return 0


def _size(block: Block) -> int:
    """Return the number of samples in a block."""
    return prod(s.stop - s.start for s in block)


def _processors() -> int:
    """Return the number of processors that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _startable(number: int) -> int:
    """Return the number of threads that can be started, limited to `number`."""
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


class _SerialExecutor(Executor):
    """Calls functions immediately in the calling thread, if another is not possible or useful."""

    def submit(self, fn: Callable[..., T], /, *args: object, **kwargs: object) -> Future[T]:
        future: Future[T] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:  # noqa: BLE001 - the caller asks the future
            future.set_exception(error)
        return future


def _compute(work: Work, samples: Samples, forms: dict[str, ArrayForm]) -> dict[str, np.ndarray]:
    """Compute one block: the task of a lazy Dataset."""
    results = work(samples)
    check_forms(results, forms, tuple(samples.dims))
    return {name: v.values for name, v in results.items()}


def _variable(results: Mapping[str, np.ndarray], name: str) -> np.ndarray:
    """Return a variable of a block that was computed."""
    return results[name]


def _compute_and_write(work: Work, samples: Samples, path: str, block: Block, run: str) -> None:
    """Compute one block and write it: the task of a store.

    Dask's threads continue after Ctrl-C, and the process waits for them: those of this process
    check whether their run has ended.
    """
    stores.write(path, block, work(samples, lambda: run in _ENDED))


def _check(
    future: Future[None] | Future[dict[str, LabelledArray]], block: Block, samples: Samples
) -> None:
    """Raise the error of a block, with a note of the block's position."""
    try:
        future.result()
    except Exception as error:
        position = ", ".join(
            f"{dim} {s.start} to {s.stop - 1}" for dim, s in zip(samples.dims, block, strict=True)
        )
        error.add_note(f"This happened in the samples {position or 'given'} of the ensemble.")
        raise
