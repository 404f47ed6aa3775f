"""Processes of a `dask.distributed` cluster: the same bits, even when one of them is killed."""

import os
import signal
import sys
import time

import numpy as np
import pytest

from optional import optional
from zoo.ensemble_cases import identical, same_bits

dask = optional("dask")
optional("zarr")

# Processes that end while their sockets are open tell so.
pytestmark = pytest.mark.filterwarnings("ignore::ResourceWarning")


@pytest.fixture(scope="module")
def client():
    """One cluster, whose processes import everything once; the last test kills one of them."""
    distributed = pytest.importorskip("distributed")
    with (
        dask.config.set(
            {"distributed.worker.daemon": True, "distributed.comm.timeouts.connect": "300s"}
        ),
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        client.wait_for_workers(2, timeout=300)
        yield client


def test_a_cluster_of_processes_gives_the_same_bits(reference, client):
    system, values, whole = reference
    lazy = system.integrate_ensemble(**values, chunks=20)
    identical(lazy.compute(), whole)
    loaded = client.run(lambda: "sympy" in sys.modules)
    assert not any(loaded.values())


def test_workers_of_a_cluster_write_a_store_themselves(reference, client, tmp_path):
    system, values, whole = reference
    made = system.integrate_ensemble(**values, store=tmp_path / "s.zarr", chunks=25)
    identical(made.load(scheduler="threads"), whole)


def test_a_cluster_gets_few_blocks_and_enough_for_all_of_its_threads(reference, client):
    system = reference[0]
    count, threads = 1_000_000, sum(client.nthreads().values())
    angles = {system.coordinates[0]: np.linspace(0.0, 1.0, count)}
    lazy = system.integrate_ensemble(initial_conditions=angles, reduce="final", chunks="auto")
    blocks = lazy.chunks["sample"]
    assert sum(blocks) == count
    # Threads that end first wait for one block at most; every block costs the scheduler time.
    assert 16 * threads <= len(blocks) <= 32 * threads
    lazy = system.integrate_ensemble(initial_conditions=angles, reduce="final", chunks=1000)
    assert lazy.chunks["sample"] == (1000,) * 1000
    few = {system.coordinates[0]: np.linspace(0.0, 1.0, 2000)}
    lazy = system.integrate_ensemble(initial_conditions=few, reduce="final", chunks="auto")
    assert len(lazy.chunks["sample"]) == threads


def _slow(dataset):
    time.sleep(0.1)
    return dataset[["q1"]]


def test_a_worker_that_is_killed_costs_nothing_but_time(reference, client):
    system, values, whole = reference
    lazy = system.integrate_ensemble(**values, chunks=5, reduce=_slow)
    future = client.compute(lazy)
    (victim, *_) = client.run(os.getpid).values()
    time.sleep(0.3)
    os.kill(victim, signal.SIGKILL)
    assert same_bits(future.result(timeout=300).q1, whole.q1)
