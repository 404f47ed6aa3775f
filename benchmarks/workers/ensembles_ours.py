"""This project's ensembles: in lanes on one thread or more, or a loop over its solver for one."""

from __future__ import annotations

import resource
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
from harness.frozen import read
from harness.pendulums import TIMES, samples
from harness.program import assembly_of
from harness.serve import serve

from pydy._assembly.programs import block_program
from pydy._backends.registry import compile_program
from pydy._kernel import Inputs, KernelCall
from pydy.ensemble.engine import Ensemble
from pydy.ensemble.model import EnsembleModel
from pydy.ensemble.samples import Samples
from pydy.ensemble.work import Work, read_reductions
from pydy.solvers.options import read_options
from pydy.solvers.solver import SOLVERS
from pydy.system import System

sys.path.insert(0, str(Path(__file__).parents[2] / "tests"))

from zoo.loops import bricard


class Ours:
    def load(self, links: int, count: int) -> None:
        model = read(f"pendulum-{links}")
        self.program = block_program(assembly_of(model), "rates")
        self.x, self.p = samples(links, count)
        self.r = np.zeros((1, self.program.signature.num_specifieds))

    def _ensemble(
        self, method: str, options: dict[str, Any], threads: int, reduce: Any, count: int
    ) -> Ensemble:
        names = tuple(f"x{k}" for k in range(self.x.shape[1]))
        read = read_options(method, True, options)
        model = EnsembleModel(self.program, None, names, (), method, read, TIMES)
        work = Work(model, read_reductions(reduce, model, str), {})
        dims = {"sample": count}
        rows = (np.resize(self.x, (count, len(names))), np.resize(self.p, (count, len(self.p[0]))))
        x, p = (tuple(rows_.T) for rows_ in rows)
        r = tuple(np.zeros((self.program.signature.num_specifieds, 1)))
        return Ensemble(Work(model, work.reductions, {}), Samples(dims, x, r, p), 2048, {}, threads)

    def lanes(self, method: str, tol: float, threads: int, count: int) -> dict[str, Any]:
        """Time the ensemble of the first samples; the states come from the Dataset."""
        ensemble = self._ensemble(method, {"rtol": tol, "atol": tol}, threads, None, count)
        ensemble.run()
        start = time.perf_counter()
        dataset = ensemble.run()
        taken = time.perf_counter() - start
        self.states = np.stack([dataset[f"x{k}"].values for k in range(self.x.shape[1])], axis=-1)
        return {"seconds": taken, "steps": float(dataset.steps.mean())}

    def loop(self, method: str, tol: float, count: int) -> dict[str, Any]:
        """Time the solver for one in a loop over some samples."""
        kernel = compile_program(self.program, "llvm", {})
        solver = SOLVERS[method]

        def f(x: Any, t: Any, r: Any, p: Any) -> None: ...

        f.native = lambda args: KernelCall(kernel, args[1], Inputs(args[0]))  # type: ignore[attr-defined]
        states = np.empty((count, len(TIMES), self.x.shape[1]))
        for k in range(2):
            solver(f, self.x[k], TIMES, args=(self.r[0], self.p[k]), rtol=tol, atol=tol)
        start = time.perf_counter()
        for k in range(count):
            states[k] = solver(f, self.x[k], TIMES, args=(self.r[0], self.p[k]), rtol=tol, atol=tol)
        taken = time.perf_counter() - start
        self.states = states
        return {"seconds": taken}

    def held(self, count: int, loop: bool) -> float:
        """Time motions of a closed loop, projected: as an ensemble, or one by one."""
        made, start = bricard((1, -1, 1))
        times, gravities = np.linspace(0.0, 5.0, num=51), np.linspace(5.0, 15.0, num=count)
        system = System(made, {"g": 9.81}, initial_conditions=start, times=times)
        system.ode_solver, options = "dop853", {"constraints": "project", "rtol": 1e-8}
        for some in (gravities[:16], gravities):
            begin = time.perf_counter()
            if loop:
                for gravity in some:
                    system.constants["g"] = gravity
                    system.integrate(**options)
            else:
                system.integrate_ensemble(constants={"g": some}, workers=1, **options)
            taken = time.perf_counter() - begin
        return taken

    def save(self, path: str, count: int) -> None:
        """Write the first trajectories, for errors."""
        np.save(path, self.states[:count])

    def kernel(self, threads: int) -> float:
        """Return the seconds that sweeps of the bare kernel of eight lanes take, all threads."""
        from concurrent.futures import ThreadPoolExecutor

        kernel = compile_program(self.program, "llvm", {"lanes": 8})
        x = np.asfortranarray(np.resize(self.x, (100_000, self.x.shape[1])))
        t = np.zeros(len(x))

        def sweep(_: int) -> None:
            for _ in range(10):
                kernel.evaluate(t, x, self.r, self.p[0])

        with ThreadPoolExecutor(threads) as pool:
            list(pool.map(sweep, range(threads)))
            start = time.perf_counter()
            list(pool.map(sweep, range(8)))
            return time.perf_counter() - start

    def final(self, tol: float, count: int, threads: int, limit: float | None) -> dict[str, Any]:
        """Reduce many trajectories to final states, within a limit of memory in GiB."""
        if limit is not None:
            size = int(limit * 2**30)
            resource.setrlimit(resource.RLIMIT_AS, (size, size))
        ensemble = self._ensemble("dop853", {"rtol": tol, "atol": tol}, threads, "final", count)
        start = time.perf_counter()
        ensemble.run()
        taken = time.perf_counter() - start
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
        return {"seconds": taken, "peak_GiB": peak}


if __name__ == "__main__":
    ours = Ours()
    serve(
        {n: getattr(ours, n) for n in ("load", "lanes", "loop", "save", "kernel", "final", "held")}
    )
