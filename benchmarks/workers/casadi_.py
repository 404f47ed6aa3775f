"""CasADi: its interpreted Function, and, by the argument "c", the C it generates, by gcc -O3."""

from __future__ import annotations

import ctypes
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
from harness.convert import Algebra, translate
from harness.elimination import pivots_of, solve_general
from harness.model import Model
from harness.peer import Peer, serve_peer

_LOOP = """
void loop(const double *x, const double *r, const double *p, double *out,
          casadi_int *iw, double *w, int count, int n, int s) {
  for (int k = 0; k < count; k++) {
    const double *arg[SZ_ARG] = {x + k * n, r + k * s, p};
    double *res[SZ_RES] = {out + k * n};
    f(arg, res, iw, w, 0);
  }
}
"""


class CasADi(Algebra):
    def __init__(self) -> None:
        super().__init__({name: getattr(ca, name) for name in ("sin", "cos", "tan", "sqrt")})

    def number(self, value: float) -> Any:
        return ca.SX(value)


def function_of(model: Model) -> Any:
    """Return x' as CasADi's Function of x, r and p."""
    n = len(model.speeds)
    x, r, p = (
        ca.SX.sym(name, size)
        for name, size in (
            ("x", len(model.coordinates) + n),
            ("r", len(model.specifieds)),
            ("p", len(model.constants)),
        )
    )
    matrix, forcing, rates = translate(model, CasADi(), x, r, p)
    if model.positive_definite:
        full = [k for k, entry in enumerate(matrix) if entry is not None]
        pattern = ca.Sparsity.triplet(n, n, [k // n for k in full], [k % n for k in full])
        m = ca.SX(pattern)
        for k in full:
            m[k // n, k % n] = matrix[k]
        solution = ca.ldl_solve(ca.vertcat(*forcing), *ca.ldl(m))
    else:
        # CasADi's own `solve` is a QR here, half as fast as this on the bicycle.
        solution = ca.vertcat(*solve_general(matrix, forcing, pivots_of(model)))
    return ca.Function("f", [x, r, p], [ca.vertcat(*rates, solution)])


def library_of(generator: Any, folder: Path, *flags: str, more: str = "") -> Path:
    """Return the shared library of a generator's ``f.c``, with more C at its end, by gcc."""
    generator.generate(f"{folder}/")
    with (folder / "f.c").open("a") as file:
        file.write(more)
    command = ["gcc", *flags, "-march=native", "-shared", "-fPIC", "f.c", "-o", "f.so", "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    return folder / "f.so"


class CasADiPeer(Peer):
    def build(self) -> Any:
        return function_of(self.model)

    def _over_all(self, function: Any) -> Any:
        arguments = [ca.DM(self.x.T), ca.DM(self.r.T), ca.DM(self.p)]
        mapped = function.map("all", "serial", self.count, [2], [])

        def evaluate() -> None:
            self._result = mapped(*arguments)

        return evaluate

    def scalar(self) -> Any:
        return self._over_all(self.build())

    batched = scalar  # its virtual machine takes one state at a time

    def values(self) -> np.ndarray:
        return np.array(self._result).T


class CasADiC(CasADiPeer):
    """The C code in a loop of C, so that no call from Python is in the measure."""

    def build(self) -> Any:
        function = super().build()
        sizes = {"SZ_ARG": function.sz_arg(), "SZ_RES": function.sz_res()}
        self._work = np.empty(function.sz_w() + 1), np.empty(function.sz_iw() + 1, dtype=np.int64)
        self._folder = tempfile.TemporaryDirectory()
        generator = ca.CodeGenerator("f.c")
        generator.add(function)
        flags = ("-O3", *(f"-D{key}={value}" for key, value in sizes.items()))
        return ctypes.CDLL(str(library_of(generator, Path(self._folder.name), *flags, more=_LOOP)))

    def _over_all(self, function: Any) -> Any:
        out = np.empty_like(self.x)
        w, iw = self._work
        arrays = [ctypes.c_void_p(a.ctypes.data) for a in (self.x, self.r, self.p, out, iw, w)]
        sizes = self.count, self.x.shape[1], self.r.shape[1]

        def evaluate() -> None:
            function.loop(*arrays, *sizes)
            self._result = out.T

        return evaluate


if __name__ == "__main__":
    serve_peer(CasADiC() if sys.argv[1:] == ["c"] else CasADiPeer())
