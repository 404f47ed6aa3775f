"""Closed loops with an event, projected, into a store: on threads, or on a Dask cluster."""

from __future__ import annotations

import json
import os
import signal
import sys
import threading
import time
from contextlib import ExitStack
from pathlib import Path
from resource import RUSAGE_SELF, getrusage
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[2] / "tests"))

from pydy.solvers import Event
from zoo.loops import system_of


def blocks(store: Path) -> int:
    """Return how many blocks of a store are finished."""
    return sum(path.is_file() for path in (store / "status" / "c").rglob("*"))


def peak() -> float:
    """Return the most memory that this process had, in GiB."""
    return getrusage(RUSAGE_SELF).ru_maxrss / 2**20


def _kill_one(client: Any, store: Path, after: int) -> None:
    """Kill a worker as soon as so many blocks are finished."""
    victim = next(iter(client.run(os.getpid).values()))
    while blocks(store) < after:
        time.sleep(0.05)
    os.kill(victim, signal.SIGKILL)


def main() -> None:
    """Run and print what it took."""
    store, count, size, processes = Path(sys.argv[1]), *map(int, sys.argv[2:5])
    system = system_of("even_slider_crank", np.linspace(0.0, 0.5, num=6), "dop853")
    falling = Event(system.speeds[0] + 5.0, name="slower")
    found: dict[str, Any] = {"left": -(-count // size) - blocks(store)}
    with ExitStack() as stack:
        if processes:
            from distributed import Client, LocalCluster

            own = {"threads_per_worker": 1, "dashboard_address": ":0"}
            cluster = stack.enter_context(LocalCluster(n_workers=processes, **own))
            client = stack.enter_context(Client(cluster))
            later = threading.Thread(
                target=_kill_one, args=(client, store, found["left"] // 3), daemon=True
            )
            later.start()
        start = time.perf_counter()
        made = system.integrate_ensemble(
            constants={"g": np.linspace(5.0, 15.0, num=count)},
            constraints="project",
            events=[falling],
            reduce=["final", ("events", 1)],
            rtol=1e-8,
            atol=1e-8,
            store=store,
            chunks=size,
            resume=True,
        )
        found["seconds"] = time.perf_counter() - start
        if processes:
            found["workers_GiB"] = max(client.run(peak).values())
    found["GiB"] = peak()
    found["finished"] = int((made.status == 0).sum())
    found["happened"] = int(made.slower_count.sum())
    sums = (int(made[name].values.view(np.uint64).sum()) for name in ("q1", "u1", "slower_times"))
    print(json.dumps(found | {"bits": [*sums]}))


if __name__ == "__main__":
    main()
