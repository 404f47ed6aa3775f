"""What the equations of a KanesMethod say, evaluated with 30 digits by SymPy and mpmath alone.

Nothing here shares a line with the package. Accelerations in the forcing are found by evaluating it
at unit vectors, not by differentiating it; the linear system is solved by mpmath.
"""

import mpmath as mp
import numpy as np
import sympy as sm
import sympy.physics.mechanics as me

T = me.dynamicsymbols._t
DIGITS = 30


class Oracle:
    """Evaluates a :class:`zoo.Model`, with other constants or specifieds if they are given."""

    def __init__(self, model):
        self.model, kane = model, model.kane
        self.numbers = {**model.constants, **model.specifieds}
        self.q, self.u = list(kane.q), list(kane.u)
        self.kane = kane
        auxiliary = list(kane._uaux)
        still = {s.diff(T): 0 for s in auxiliary} | dict.fromkeys(auxiliary, 0)
        self._rates = {k: v.xreplace(still) for k, v in kane.kindiffdict().items()}
        self._a = [sm.Dummy(f"a{i}") for i in range(len(self.u))]
        accelerations = dict(zip([i.diff(T) for i in self.u], self._a, strict=True))
        self._names = {s: sm.Dummy() for s in [*self.q, *self.u, *self.numbers]}
        # What is replaced as a whole is not looked into: a derivative goes before its function.
        known = self._names | accelerations | still
        self._plain = {k: v.xreplace(known) for k, v in self._rates.items()} | known
        self._cache = {}

    def _function(self, key, expressions, extra=()):
        """Compiled list of expressions; `extra` symbols become further arguments."""
        if key not in self._cache:
            names = {s: sm.Dummy() for s in extra}
            plain = [sm.sympify(e).xreplace(self._plain | names) for e in expressions]
            args = [T, *self._a, *(self._names[s] for s in self._names), *names.values()]
            stray = set().union(*(e.free_symbols for e in plain)) - set(args) if plain else set()
            assert not stray, f"the oracle has no number for {stray}"
            self._cache[key] = sm.lambdify(args, plain, "mpmath", cse=True)
        return self._cache[key]

    def _arguments(self, x, t, numbers, a=None, extra=()):
        values = self.numbers | (numbers or {})
        a = a if a is not None else [mp.mpf(0)] * len(self.u)
        rest = [*x, *(values[s] for s in self.numbers), *extra]
        return [mp.mpf(float(t)), *a, *(mp.mpf(float(v)) for v in rest)]

    def accelerations(self, x, t=0.0, numbers=None):
        """u' at one state, as a list of mpf."""
        n = len(self.u)
        f = self._function("MF", [*self.kane.mass_matrix, *self.kane.forcing])
        with mp.workdps(DIGITS):
            columns = []
            for k in range(-1, n):
                unit = [mp.mpf(int(i == k)) for i in range(n)]
                columns.append(f(*self._arguments(x, t, numbers, unit)))
            mass = mp.matrix(n, n)
            right = mp.matrix(columns[0][n * n :])
            for i in range(n):
                for j in range(n):
                    load = columns[j + 1][n * n + i] - columns[0][n * n + i]
                    mass[i, j] = columns[0][n * i + j] - load
            return list(mp.lu_solve(mass, right))

    def xdot(self, x, t=0.0, numbers=None):
        """q' and u'."""
        rates = self._function("qd", [self._rates[i.diff(T)] for i in self.q])
        with mp.workdps(DIGITS):
            first = rates(*self._arguments(x, t, numbers))
        return np.array([float(v) for v in [*first, *self.accelerations(x, t, numbers)]])

    def evaluate(self, expressions, x, t=0.0, numbers=None):
        """Any expressions in states, constants, specifieds, q', u' and t."""
        expressions = [sm.sympify(e) for e in expressions]
        f = self._function(tuple(expressions), expressions)
        with mp.workdps(DIGITS):
            a = self.accelerations(x, t, numbers)
            return np.array([float(v) for v in f(*self._arguments(x, t, numbers, a))])

    def solve(self, names, equations, x, t=0.0, numbers=None):
        """Values of `names` from equations that are linear in them, with u' solved beforehand."""
        names, equations = list(names), [sm.sympify(e) for e in equations]
        n = len(names)
        f = self._function((tuple(names), tuple(equations)), equations, names)
        with mp.workdps(DIGITS):
            a = self.accelerations(x, t, numbers)
            at = [
                f(*self._arguments(x, t, numbers, a, [int(i == k) for i in range(n)]))
                for k in range(-1, n)
            ]
            matrix = mp.matrix(n, n)
            for i in range(n):
                for j in range(n):
                    matrix[i, j] = at[j + 1][i] - at[0][i]
            return np.array([float(v) for v in mp.lu_solve(matrix, -mp.matrix(at[0]))])

    def forces(self, x, t=0.0, numbers=None):
        """Noncontributing forces from the auxiliary equations."""
        return self.solve(self.model.forces, self.kane.auxiliary_eqs, x, t, numbers)

    def holonomic(self, x, t=0.0, numbers=None):
        return self.evaluate(self.kane._f_h, x, t, numbers)

    def velocity(self, x, t=0.0, numbers=None):
        return self.evaluate(self.kane._k_nh * self.kane.u + self.kane._f_nh, x, t, numbers)


_ORACLES = {}


def oracle(model):
    """The oracle of a model, built once."""
    if model not in _ORACLES:
        _ORACLES[model] = Oracle(model)
    return _ORACLES[model]
