"""Every public answer about a mechanism against the oracle's."""

import ctypes
import importlib.util
import json
import shutil
import subprocess
import tempfile
import warnings
from functools import cached_property
from itertools import permutations
from pathlib import Path

import numpy as np
import sympy as sm
from scipy.integrate._ivp import dop853_coefficients as dop853

from mechanisms.build import FRONT_ENDS, definition, permuted
from mechanisms.drawing import T
from mechanisms.generate import numbers_of, replaced
from mechanisms.oracle import World
from mechanisms.taylor import LONG, pivots, solved
from pydy._mechanics.symbols import find_symbols
from pydy.system import System

TOLERANCE = 1e-9  # of sizes times the condition, which the oracle gives
SPAN = 0.02  # of integrations, in units of time
FINE_STEPS = 2000  # of the span, where derivatives have a kink
MOST_STEPS = 64  # of them: in the 64th part of the span whatever is drawn is smooth
# Central differences of the eighth order.
STENCIL = [
    (LONG(s * a) / b, s * k)
    for k, (a, b) in enumerate([(4, 5), (-1, 5), (4, 105), (-1, 280)], start=1)
    for s in (1, -1)
]


class DisagreementError(AssertionError):
    """What was found, what the oracle says, and how many times more than allowed they differ."""


class Check:
    """One mechanism by one front end; the model is None where that has no such mechanisms."""

    def __init__(self, data, front_end):
        self.front_end, self.worst, self.drawn = front_end, {}, data
        self.model = model = {**FRONT_ENDS, "permuted": permuted}[front_end](data)
        if model is None:
            return
        self.system = system = System(model.method)
        if system.states != getattr(model, "order", system.states):
            raise DisagreementError(f"{front_end}: order of states[0] is {system.states}")
        self._know()
        self.data = data = model.real
        self.world = World(data, data["q"], data["u"])
        places = {s: k for k, s in enumerate([*model.q, *model.u])}
        self.order = [places[s] for s in system.states]
        self.x, self.t = np.array([*data["q"], *data["u"]])[self.order], data["time"]
        system.initial_conditions = dict(zip(system.states, self.x, strict=True))
        system.ode_solver = "dop853"
        self.rng = np.random.default_rng(data["seed"])

    def _know(self):
        """Set the numbers of all constants and specifieds that the System has by now."""
        for kind in ("constants", "specifieds"):
            own = getattr(self.system, f"{kind}_symbols")
            numbers = {s: v for s, v in getattr(self.model, kind).items() if s in own}
            setattr(self.system, kind, numbers)

    def compare(self, what, found, expected, bound):
        found, expected, bound = (np.atleast_1d(np.asarray(a)) for a in (found, expected, bound))
        allowed = np.maximum(TOLERANCE * bound, 1e-290)
        with np.errstate(invalid="ignore"):
            ratios = np.abs(found.astype(LONG) - expected) / allowed
        ratios = np.where(np.isfinite(ratios), ratios, np.inf).astype(float)
        worst = float(ratios.max(initial=0.0))
        self.worst[what] = max(self.worst.get(what, 0.0), worst)
        if worst > 1:
            k = int(np.argmax(ratios))
            raise DisagreementError(
                f"{self.front_end}: {what}[{k}] is {float(found[k])!r}, the oracle says "
                f"{float(expected[k])!r}: {worst:.1e} times what is allowed (size "
                f"{float(bound[k]):.1e}, condition {self.world.condition:.1e})"
            )

    # -- at one state ---------------------------------------------------------------------------

    def rates(self):
        found = self.system.evaluate_ode(self.x, self.t)
        self.compare(
            "rates", found, self.world.rates[self.order], self.world.rates_bound[self.order]
        )

    def outputs(self):
        """A place, an acceleration, the multipliers and a reaction, as outputs of one program."""
        model, system, w = self.model, self.system, self.world
        last = len(model.bodies) - 1
        wanted = [("place", model.centres[last].pos_from(model.origin).to_matrix(model.ground))]
        wanted += [("acceleration", [3 * model.u[-1].diff(T)])]
        forces = system.constraint_forces
        rows = list(getattr(model, "rows", range(len(w.A))))
        # Rows that are redundant come behind those that complete the others: all orders are tried.
        redundant = len(w.kept) < len(w.A) == len(rows)
        if len(forces) == len(rows) > 0 and not (redundant and len(rows) > 6):
            wanted += [("multipliers", list(forces.values()))]
        body = len(model.bodies) // 2
        beyond = w.beyond(body)
        if self.front_end != "lagrange" and not any(
            a["body"] in beyond for a in self.data["auxiliary"]
        ):
            held = [model.bodies[k] for k in beyond]
            # What is fixed to a particle without mass is told: its frame, and points beside it.
            for k in (k for k in beyond if self.data["bodies"][k]["inertia"] is None):
                held += [model.frames[k], *model.spots.get(k, [])]
            cut = system.reaction(held, model.hinges[body], frame=model.ground, loads=[])
            if not rows:  # nothing else holds them: this is not warned of
                system.reaction(held, model.hinges[body])
            wanted += [("reaction", list(cut.outputs("joint").values()))]
        found = self._evaluated(wanted)
        where = w.centres(last)[0, 0]
        self.compare("place", found["place"], where, np.abs(where) + w.reach())
        self.compare("acceleration", found["acceleration"], 3 * w.a[-1], 3 * w.a_bound[-1])
        if "multipliers" in found:
            lam = found["multipliers"].astype(LONG)
            orders = permutations(rows) if redundant else [rows]
            sums = [w.A[[*order]].T @ lam for order in orders]
            best = min(sums, key=lambda total: np.abs(total - w.generalised).sum())
            self.compare("constraint forces", best, w.generalised, w.generalised_bound)
            if len(w.kept) == len(w.A):
                back = np.argsort(w.kept)
                self.compare("multipliers", lam, w.multipliers[back], w.multipliers_bound[back])
        if "reaction" in found:
            self.compare("reaction", found["reaction"], *w.reaction(body))
        for force in model.forces:
            system.noncontributing_forces = [force]
            self._know()
            x = [*self.x, *[0.0] * len(system.auxiliaries)]
            value = system.evaluate_outputs(x, self.t)[-1]
            system.constants = system.specifieds = {}
            system.noncontributing_forces = []
            self._know()
            if (expected := w.joint_force(self.data["auxiliary"][0])) is not None:
                self.compare("noncontributing force", value, *expected)

    def _evaluated(self, wanted):
        """The values of lists of expressions by name; they may bring constants of their own."""
        outputs = {sm.Symbol(f"{name}_{k}"): e for name, part in wanted for k, e in enumerate(part)}
        self.system.outputs = outputs
        self._know()
        values = self.system.evaluate_outputs(self.x, self.t)
        self.system.constants = self.system.specifieds = {}
        self.system.outputs = {}
        self._know()
        found, first = {}, 0
        for name, part in wanted:
            found[name] = values[first : first + len(part)]
            first += len(part)
        return found

    def energies(self):
        w, data = self.world, self.data
        potential = w.potential()
        if potential is None or self.model.forces:
            return
        q = np.array(data["q"]) * 0.875
        for element, of_q, _ in (place for elements in w.places for place in elements):
            if len(element.lengths) == 4:  # of length one, as at all states
                e = q[of_q] * np.array([0.5, 1.0, 1.0, 1.0])
                q[of_q] = e / np.sqrt(e @ e)
        other = World(data, q, data["u"], rows=w.kept)
        # Energies hold constants and motions that the equations need not hold.
        held = find_symbols([self.system.kinetic_energy, self.system.potential_energy])
        self.system.constants |= {s: v for s, v in self.model.constants.items() if s in held}
        self.system.specifieds |= {s: v for s, v in self.model.specifieds.items() if s in held}
        here = self.system.evaluate_energy(self.x, self.t)
        there = self.system.evaluate_energy(np.array([*q, *data["u"]])[self.order], self.t)
        self.compare("kinetic energy", here.kinetic, w.kinetic, w.kinetic_bound)
        bound = w.potential_size() + other.potential_size()
        change = potential - other.potential()
        self.compare("potential energy", here.potential - there.potential, change, bound)

    # -- derivatives ----------------------------------------------------------------------------

    def jacobians(self):
        """The rates' derivatives along a direction of states, constants and specifieds."""
        names, paths = self._parameters(self.system.specifieds_symbols)
        step = self._direction(paths)
        expected = self._derivative(step, paths, lambda w: w.rates)
        found = self.system.evaluate_jacobian(self.x, self.t, wrt=["states", *names])
        found = found.astype(LONG) @ self._ordered(step)
        bound = (self.world.rates_bound + np.abs(expected)) * self.world.condition
        self.compare("jacobian", found, expected[self.order], bound[self.order])

    def linear_models(self):
        step = self._direction([])
        expected = self._derivative(step, [], lambda w: w.rates)
        # Constraints may hold prescribed motions, which are no inputs then.
        held = [sm.Function(path)(T) for path in self.data["fixed_inputs"]]
        inputs = [s for s in self.system.specifieds_symbols if not s.has(*held)]
        linear = self.system.linearize(self.x, self.t, inputs=inputs)
        names = [s.name if hasattr(s, "name") else str(s) for s in self.system.states]
        names = [
            n if n in linear.states else n.replace("Derivative(", "").split("(")[0] + "'"
            for n in names
        ]
        places = [names.index(n) for n in linear.states]
        bound = ((self.world.rates_bound + np.abs(expected)) * self.world.condition)[self.order]
        found = linear.A.astype(LONG) @ self._ordered(step)[places]
        self.compare("linear model", found, expected[self.order][places], bound[places])

    def sensitivities(self):
        names, paths = self._parameters(())
        step = self._direction(paths)
        motion = self._motion(
            lambda s: s.simulate(sensitivities=["states", *names], **self._precise())
        )
        size = self._size_at_end()
        self._compare_end(motion)
        expected = self._derivative(step, paths, self._end)
        # Of states that a method calls dependent there are no columns: they follow the others.
        columns, every = (
            motion.sensitivity.parameters,
            [str(s) for s in [*self.system.states, *names]],
        )
        given = self._ordered(step)[[every.index(str(c)) for c in columns]]
        found = motion.sensitivity.values[-1].astype(LONG) @ given
        bound = (size + np.abs(expected)) * self.world.condition
        self.compare("sensitivity", found, expected[self.order], bound[self.order])

    def motions(self):
        self._compare_end(self._motion(lambda s: s.simulate(**self._precise())))

    def _compare_end(self, motion):
        end, size = self._end(World(self.data, self.data["q"], self.data["u"])), self._size_at_end()
        self.compare("motion", motion.states[-1], end[self.order], size[self.order])

    def orders(self):
        """The same Definition with coordinates and speeds in another order."""
        other = Check(self.drawn, "permuted")
        for name, ratio in other(("rates", "outputs", "motions")).items():
            self.worst[name] = max(self.worst.get(name, 0.0), ratio)

    def returns(self):
        """The motion there and back ends where it began."""
        forth = self._motion(lambda s: s.simulate(**self._precise()))
        system, start = self.system, self.system.initial_conditions
        system.initial_conditions = dict(zip(system.states, forth.states[-1], strict=True))
        system.times = system.times[::-1]
        back = system.simulate(**self._precise())
        system.initial_conditions = start
        bound = (self._size_at_end() * self.world.condition)[self.order]
        self.compare("return", back.states[-1], self.x, bound)

    def assumptions(self):
        """A speed that is assumed positive: one warning where the motion leaves that, else none.

        It goes on until the speed that is first to vanish is as large on the other side.
        """
        speeds, rates = np.array(self.data["u"]), self.world.a.astype(float)
        with np.errstate(all="ignore"):
            spans = np.where((speeds > 0) & (rates < 0), -2 * speeds / rates, np.inf)
        if not (speeds > 0).any() or self.model.auxiliary:
            return
        k = int(np.argmin(spans) if np.isfinite(spans).any() else np.argmax(speeds > 0))
        span = min(spans[k], 5 * SPAN * self.data["units"][2])
        told, motions = [], []
        for positive in (None, k):
            other = definition(self.drawn, positive=positive)
            system = System(other.method, ode_solver="dop853")
            for kind in ("constants", "specifieds"):
                known = getattr(other, kind).items()
                own = getattr(system, f"{kind}_symbols")
                setattr(system, kind, {s: v for s, v in known if s in own})
            start = zip([*other.q, *other.u], [*self.data["q"], *self.data["u"]], strict=True)
            system.initial_conditions = dict(start)
            system.times = self.t + np.linspace(0.0, span, 9)
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                motions.append(system.simulate(**self._precise())[f"u{k}"])
            told.append([str(w.message) for w in caught])
        least, size = motions[0].min(), np.abs(motions[0]).max() + self._sizes()[-len(speeds) + k]
        if abs(least) < 1e-8 * size:
            return  # rounding decides
        self.compare("warnings without assumptions", len(told[0]), 0, 0)
        named = [text for text in told[1] if text.startswith(f"`u{k}(t)` is -")]
        self.compare("warnings of an assumption", len(named), int(least < 0), 0)
        self.compare("other warnings", len(told[1]) - len(named), 0, 0)

    def adjoints(self):
        names, paths = self._parameters(())
        step, last = self._direction(paths), self.system.states[-1]
        final = 2 * last
        found = self._motion(
            lambda s: s.adjoint_gradient(names or "states", final=final, **self._precise())
        )
        values = np.concatenate([found.by_state, found.values if names else []]).astype(LONG)
        place = self.order[-1]
        expected = 2 * self._derivative(step, paths, self._end)[place]
        bound = (2 * self._size_at_end()[place] + abs(expected)) * self.world.condition
        self.compare("adjoint", values @ self._ordered(step), expected, bound)

    def _precise(self):
        # Absolute tolerances by the units, which a vector of them would be for.
        options = {"rtol": 1e-12, "atol": 1e-13 * float(np.min(self._sizes()))}
        if self._has_turned:  # the step control looks at the states, whose error shows no kink
            options["max_step"] = SPAN * self.data["units"][2] / FINE_STEPS
        return options

    def _motion(self, run):
        span = SPAN * self.data["units"][2]
        self.system.times = [self.t, self.t + span]
        return run(self.system)

    def _end(self, world):
        """The state after the span, by as many steps of the eighth order as leave no error."""
        return self._stepped(world, self._steps)

    @cached_property
    def _steps(self):
        """Where twice as many steps make no difference, by far; drag has kinks where steps err."""
        world, allowed = self.world, TOLERANCE / 20 * self._size_at_end()
        count, end = 1, self._stepped(world, 1)
        if self._has_turned:
            return MOST_STEPS
        while count < MOST_STEPS:
            finer = self._stepped(world, 2 * count)
            if np.all(np.abs(finer - end) <= allowed):
                break
            count, end = 2 * count, finer
        return count

    @cached_property
    def _has_turned(self):
        return self._turns_back(self._stepped(self.world, 1))

    def _turns_back(self, end):
        """Whether what drag holds turns back: the end hardly errs then, but its derivatives do."""
        world = self.world
        later = World(self.data, end[: world.nq], end[world.nq :], rows=world.kept)
        drags = [load for load in self.data["loads"] if load["kind"] == "drag"]
        return any(world.motion(load)[1] @ later.motion(load)[1] < 0 for load in drags)

    def _stepped(self, world, count):
        start = LONG(self.t)
        h = (LONG(self.t + float(LONG(SPAN * self.data["units"][2]))) - start) / count
        x, n = np.concatenate([world.q, world.u]), world.nq
        for step in range(count):
            time, stages = start + step * h, []
            for i in range(dop853.N_STAGES):
                y = x + h * sum((a * k for a, k in zip(dop853.A[i], stages, strict=False)), 0 * x)
                data = {**world.data, "time": time + dop853.C[i] * h}
                stages.append(World(data, y[:n], y[n:], rows=self.world.kept).rates)
            x = x + h * sum(b * k for b, k in zip(dop853.B, stages, strict=True))
        return x

    def _size_at_end(self):
        span = SPAN * self.data["units"][2]
        x = np.abs([*self.data["q"], *self.data["u"]])
        return x + self._sizes() + span * self.world.rates_bound

    def _sizes(self):
        """Natural sizes of coordinates and speeds."""
        by_q = [self.data["units"][0] ** k for k in self.world.lengths]
        return np.array([*by_q, *self.world.natural], float)

    def _parameters(self, inputs):
        """A few constants, and specifieds, with their paths in the data."""
        of = self.model.path_of
        names = [s for s in [*self.system.constants_symbols, *inputs] if s in of]
        names = [names[k] for k in sorted(self.rng.permutation(len(names))[:5])]
        return names, [of[s] for s in names]

    def _ordered(self, step):
        m = len(self.order)
        return np.concatenate([step[:m][self.order], step[m:]])

    def _direction(self, paths):
        """A direction of states and numbers along which the constraints stay satisfied."""
        known = numbers_of(self.data)
        steps = np.concatenate([self._sizes(), [abs(known[p]) or 1.0 for p in paths]]).astype(LONG)
        scaled = self.rng.uniform(-1, 1, len(steps)).astype(LONG)
        if len(self.world.A) or self.world.norms().size:
            J = np.array([self._residuals(paths, k, h) for k, h in enumerate(steps)]).T
            size = np.abs(J).max(axis=1, initial=0)
            J = J / np.where(size == 0, 1, size)[:, None]
            rows = pivots(J, np.ones_like(J), 1e-10)[0]
            if rows:
                scaled = scaled - J[rows].T @ solved(J[rows] @ J[rows].T, J[rows] @ scaled)
        return scaled * steps

    def _residuals(self, paths, k, size):
        step = np.zeros(len(self._sizes()) + len(paths), LONG)
        step[k] = size
        h = LONG(2) ** -9
        worlds = [(weight, self._at(at * h * step, paths)) for weight, at in STENCIL]
        return sum(c * np.concatenate([w.position, w.residual, w.norms()]) for c, w in worlds) / h

    def _derivative(self, step, paths, of):
        h = LONG(2) ** -9 / LONG(max(1.0, self.world.condition / 100))

        def slope(h):
            return sum(weight * of(self._at(at * h * step, paths)) for weight, at in STENCIL) / h

        drag = any(load["kind"] == "drag" for load in self.data["loads"])
        if drag and not np.any(self.data["u"]):  # |v| v has a kink in its slope: errors are of h
            h /= 2**10
            return 2 * slope(h / 2) - slope(h)
        return slope(h)

    def _at(self, step, paths):
        n, m = self.world.nq, len(self._sizes())
        change = dict(zip(paths, step[m:], strict=True))
        data = replaced(self.data, lambda path, value: LONG(value) + change.get(path, 0))
        q, u = np.array(self.data["q"], LONG) + step[:n], np.array(self.data["u"], LONG) + step[n:m]
        return World(data, q, u, rows=self.world.kept)

    # -- exports --------------------------------------------------------------------------------

    def exports(self):
        w, system = self.world, self.system
        r = np.array([self.model.specifieds[s] for s in system.specifieds_symbols])
        p = np.array([self.model.constants[s] for s in system.constants_symbols])
        with tempfile.TemporaryDirectory() as folder:
            for how in (python, c, javascript):
                found = how(system, Path(folder), self.t, self.x, r, p)
                if found is not None:
                    self.compare(
                        f"export to {how.__name__}",
                        found,
                        w.rates[self.order],
                        w.rates_bound[self.order],
                    )

    ALWAYS = ("rates", "outputs")
    IN_TURN = ("jacobians", "energies", "sensitivities", "adjoints", "linear_models", "exports")

    # These have turns of their own.
    BESIDE = ("orders", "returns", "assumptions")

    ALONG_MOTIONS = ("sensitivities", "adjoints", "motions", "returns", "assumptions")

    @cached_property
    def _moves(self):
        """Whether the constraints can be kept: none holds a drive, whose rates are numbers here."""
        held = find_symbols([*self.model.positions, *self.model.speeds])
        drives = {sm.Function(path)(T) for path in self.data["fixed_inputs"]}
        return drives.isdisjoint(s.expr if isinstance(s, sm.Derivative) else s for s in held)

    def __call__(self, answers=()):
        for name in answers or (*self.ALWAYS, *self.IN_TURN, *self.BESIDE):
            if self._moves or name not in self.ALONG_MOTIONS:
                getattr(self, name)()
        return self.worst


def python(system, folder, t, x, r, p):
    path = system.export(folder / "mechanism.py").path
    spec = importlib.util.spec_from_file_location("exported_mechanism", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.rates(t, x)


def c(system, folder, t, x, r, p):
    path = system.export(folder / "mechanism.c").path
    library = folder / "mechanism.so"
    subprocess.run(["cc", "-O0", "-fPIC", "-shared", "-o", library, path, "-lm"], check=True)
    library = ctypes.CDLL(str(library))
    prepared, out = np.zeros(10_000), np.zeros(len(x))
    x, r, p, prepared_, out_ = (a.ctypes.data_as(ctypes.c_void_p) for a in (x, r, p, prepared, out))
    library.mechanism_prepare(p, prepared_)
    library.mechanism_rates(ctypes.c_double(t), x, r, prepared_, out_)
    return out


SCRIPT = """
import model from "./mechanism.mjs";
const out = new Float64Array({n});
model.rates({t!r}, Float64Array.from({x}), Float64Array.from({r}), out);
console.log(JSON.stringify([...out]));
"""


def javascript(system, folder, t, x, r, p):
    if shutil.which("node") is None:
        return None
    path = system.export(folder / "mechanism.js").path
    path.rename(folder / "mechanism.mjs")
    script = SCRIPT.format(n=len(x), t=t, x=x.tolist(), r=r.tolist())
    (folder / "run.mjs").write_text(script)
    done = subprocess.run(["node", folder / "run.mjs"], capture_output=True, text=True, check=True)
    return np.array(json.loads(done.stdout))


def turn_of(seed):
    """The front ends and answers that a seed is checked with where all of them would take long."""
    fronts, answers = list(FRONT_ENDS), Check.IN_TURN
    first = fronts[seed % len(fronts)]
    beside = Check.BESIDE[seed % len(Check.BESIDE)]
    own = answers[seed // len(fronts) % len(answers)]
    return [first, "definition"], [*Check.ALWAYS, own, beside]


def check(data, front_ends=None, answers=()):
    """Raise what disagrees; return the worst ratios to what is allowed.

    Without `front_ends`, the mechanism is checked with all of them. With two, the second is for
    mechanisms that the first does not have.
    """
    worst = {}
    for name in front_ends or FRONT_ENDS:
        one = Check(data, name)
        if one.model is not None:
            for key, value in one(answers).items():
                worst[key] = max(worst.get(key, 0.0), value)
            if front_ends:
                break
    return worst
