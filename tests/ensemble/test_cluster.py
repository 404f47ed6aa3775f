"""Processes of a `dask.distributed` cluster: the same bits, even when one of them is killed."""

import os
import signal
import sys
import time

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
