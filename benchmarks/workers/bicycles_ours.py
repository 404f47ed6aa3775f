"""Many bicycles in one way: lanes of one thread, threads and a store, or a Dask cluster."""

from __future__ import annotations

import re
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from resource import RUSAGE_SELF, getrusage
from typing import Any

from harness.bicycles import Bicycles, computed
from harness.serve import serve

IDLE = 5.0  # s, for which the workers have nothing to do


def peak() -> float:
    """Return the most memory that this process had, in GiB.

    Linux's `ru_maxrss` of a child begins with its parent's, VmHWM does not.
    """
    status = Path("/proc/self/status")
    text = status.read_text() if status.exists() else ""
    found = re.search(r"VmHWM:\s+(\d+) kB", text)
    return (int(found[1]) if found else getrusage(RUSAGE_SELF).ru_maxrss) / 2**20


class Ours:
    def load(self) -> None:
        """Derive and compile."""
        self.bicycles = Bicycles()
        self.bicycles.run(64, workers=1)

    def lanes(self, count: int) -> dict[str, Any]:
        """Integrate on one thread."""
        cpu, start = time.process_time(), time.perf_counter()
        dataset = self.bicycles.run(count, workers=1)
        return self._answer(computed(dataset), cpu, start)

    def threads(self, count: int, threads: int) -> dict[str, Any]:
        """Integrate on threads into a store, which is reduced block by block."""
        with tempfile.TemporaryDirectory() as folder:
            cpu, start = time.process_time(), time.perf_counter()
            store = Path(folder, "bicycles.zarr")
            dataset = self.bicycles.run(count, workers=threads, store=store)
            return self._answer(computed(dataset), cpu, start)

    def cluster(self, count: int, processes: int, block: int | None) -> dict[str, Any]:
        """Integrate on a cluster, whose workers reduce their blocks.

        All workers start before, on a few trajectories each, which is measured by itself.
        """
        with _cluster(processes) as client:
            start = self._start(client, processes)
            return start | self._on(client, count, block)

    def costs(self, count: int, processes: int, blocks: tuple[int, int]) -> list[dict[str, Any]]:
        """Integrate as `cluster`, in small and in large blocks."""
        with _cluster(processes) as client:
            self._start(client, processes)
            return [self._on(client, count, block) for block in reversed(blocks)]

    def _start(self, client: Any, processes: int) -> dict[str, float]:
        """Let all workers import and compile; return what each needs for it, and when idle.

        The own work of workers and scheduler, such as their messages, takes a share of each second,
        whatever is computed. It is in all processor times: on a busy machine the seconds are many.
        """
        cpu, before, start = time.process_time(), _of(client), time.perf_counter()
        time.sleep(IDLE)
        after, seconds = _of(client), time.perf_counter() - start
        idle, scheduler = (after - before) / seconds, (time.process_time() - cpu) / seconds
        start = time.perf_counter()
        for _ in range(2):  # in the first, some workers may be ahead of the others
            self.bicycles.compute(64 * 8 * processes, chunks=64)
        busy = _of(client) - after - idle * (time.perf_counter() - start)
        return {"start": busy / processes, "idle": idle, "scheduler": scheduler}

    def _on(self, client: Any, count: int, block: int | None) -> dict[str, Any]:
        before = _of(client)
        cpu, start = time.process_time(), time.perf_counter()
        dataset = self.bicycles.run(count, chunks="auto" if block is None else block)
        built = time.process_time() - cpu
        graph = dict(dataset.__dask_graph__())
        answer = self._answer(computed(dataset), cpu, start)
        return answer | {
            "workers": _of(client) - before,
            "built": built,
            "block": max(dataset.chunks["sample"]),
            "blocks": len(dataset.chunks["sample"]),
            "tasks": len(graph),
            "sent": _sent(graph) / count,
            "workers_GiB": max(client.run(peak).values()),
        }

    def _answer(self, sums: dict[str, float], cpu: float, start: float) -> dict[str, Any]:
        seconds, own = time.perf_counter() - start, time.process_time() - cpu
        return {"sums": sums, "own": own, "workers": 0.0, "seconds": seconds, "GiB": peak()}


@contextmanager
def _cluster(processes: int) -> Iterator[Any]:
    """Return the client of a cluster with a thread in each process."""
    import dask
    from distributed import Client, LocalCluster

    patient = {"distributed.comm.timeouts.connect": "300s", "distributed.worker.daemon": True}
    # Its samples of the stack, a hundred a second, are taken while others compute.
    patient["distributed.worker.profile.enabled"] = False
    size = {"n_workers": processes, "threads_per_worker": 1, "dashboard_address": ":0"}
    with dask.config.set(patient), LocalCluster(**size) as cluster, Client(cluster) as client:
        client.wait_for_workers(processes, timeout=300)
        yield client


def _of(client: Any) -> float:
    """Return the processor time that all workers have taken."""
    return float(sum(client.run(time.process_time).values()))


def _sent(graph: dict[Any, Any]) -> int:
    """Return how many bytes the tasks with samples take."""
    from distributed.protocol.pickle import dumps

    return sum(len(dumps(task)) for key, task in graph.items() if key[0].startswith("block-"))


if __name__ == "__main__":
    ours = Ours()
    serve({n: getattr(ours, n) for n in ("load", "lanes", "threads", "cluster", "costs")})
