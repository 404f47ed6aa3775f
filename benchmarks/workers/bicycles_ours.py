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

from harness.bicycles import Bicycles, reduced
from harness.serve import serve


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
        sums = {name: float(value) for name, value in reduced(dataset).items()}
        return self._answer(sums, cpu, start)

    def threads(self, count: int, threads: int) -> dict[str, Any]:
        """Integrate on threads into a store, which is reduced block by block."""
        with tempfile.TemporaryDirectory() as folder:
            cpu, start = time.process_time(), time.perf_counter()
            store = Path(folder, "bicycles.zarr")
            dataset = self.bicycles.run(count, workers=threads, store=store)
            sums = {name: float(value) for name, value in reduced(dataset).items()}
            return self._answer(sums, cpu, start)

    def cluster(self, count: int, processes: int, block: int | None) -> dict[str, Any]:
        """Integrate on a cluster, whose workers reduce their blocks."""
        with _cluster(processes) as client:
            return self._on(client, count, block)

    def costs(self, count: int, processes: int, blocks: tuple[int, int]) -> list[dict[str, Any]]:
        """Integrate as `cluster` in small blocks, again, and in large blocks.

        Every worker computes some of the small ones, and has started when they are computed again.
        """
        with _cluster(processes) as client:
            return [self._on(client, count, block) for block in (blocks[1], *reversed(blocks))]

    def _on(self, client: Any, count: int, block: int | None) -> dict[str, Any]:
        import dask

        def of_workers() -> float:
            return sum(client.run(time.process_time).values())

        before = of_workers()
        cpu, start = time.process_time(), time.perf_counter()
        dataset = self.bicycles.run(count, chunks="auto" if block is None else block)
        built = time.process_time() - cpu
        graph = dataset.__dask_graph__()
        sums = {n: float(v) for n, v in dask.compute(reduced(dataset))[0].items()}
        answer = self._answer(sums, cpu, start)
        return answer | {
            "workers": of_workers() - before,
            "built": built,
            "block": max(dataset.chunks["sample"]),
            "blocks": len(dataset.chunks["sample"]),
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
    size = {"n_workers": processes, "threads_per_worker": 1, "dashboard_address": ":0"}
    with dask.config.set(patient), LocalCluster(**size) as cluster, Client(cluster) as client:
        client.wait_for_workers(processes, timeout=300)
        yield client


def _sent(graph: Any) -> int:
    """Return how many bytes the tasks with samples take."""
    from distributed.protocol.pickle import dumps

    parts = [task for key, task in dict(graph).items() if str(key).startswith("_compute")]
    return sum(len(dumps(task)) for task in parts)


if __name__ == "__main__":
    ours = Ours()
    serve({n: getattr(ours, n) for n in ("load", "lanes", "threads", "cluster", "costs")})
