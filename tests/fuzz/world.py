"""What the arguments belong to: systems, functions and results, made once before forking."""

from __future__ import annotations

from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import sympy as sm
from sympy.physics.mechanics import KanesMethod, Particle, Point, ReferenceFrame, dynamicsymbols

from pydy.codegen.ode_function_generators import generate_ode_function
from pydy.solvers import dop853, radau, rk4
from pydy.system import System
from pydy.viz import Scene, Sphere, Visual

__all__ = ["world"]

TIMES = np.linspace(0.0, 1.0, num=3)


def oscillator() -> SimpleNamespace:
    """A driven oscillator: states x and v, constants k and m, specifieds f and g."""
    x, v, f, g = dynamicsymbols("x, v, f, g")
    k, m = sm.symbols("k, m")
    N, O, P = ReferenceFrame("N"), Point("O"), Point("P")
    O.set_vel(N, 0)
    P.set_pos(O, x * N.x)
    P.set_vel(N, v * N.x)
    body = Particle("body", P, m)
    kane = KanesMethod(N, q_ind=[x], u_ind=[v], kd_eqs=[v - x.diff()])
    kane.kanes_equations([body], [(P, (-k * x + f - g) * N.x)])
    return SimpleNamespace(kane=kane, x=x, v=v, f=f, g=g, k=k, m=m, N=N, O=O, P=P, body=body)


def pendulum() -> SimpleNamespace:
    """A pendulum in Cartesian coordinates: one holonomic constraint."""
    x, y, u, w = dynamicsymbols("x, y, u, w")
    g, m, r = sm.symbols("g, m, r")
    N, O, P = ReferenceFrame("N"), Point("O"), Point("P")
    O.set_vel(N, 0)
    P.set_pos(O, x * N.x + y * N.y)
    P.set_vel(N, u * N.x + w * N.y)
    circle = x**2 + y**2 - r**2
    kane = KanesMethod(
        N,
        q_ind=[x],
        q_dependent=[y],
        u_ind=[u],
        u_dependent=[w],
        kd_eqs=[u - x.diff(), w - y.diff()],
        configuration_constraints=[circle],
        velocity_constraints=[2 * x * u + 2 * y * w],
    )
    kane.kanes_equations([Particle("body", P, m)], [(P, -m * g * N.y)])
    return SimpleNamespace(kane=kane, x=x, y=y, u=u, w=w, g=g, m=m, r=r)


@cache
def world() -> SimpleNamespace:
    """Return everything, compiled: children of a fork need not do it again."""
    o, c = oscillator(), pendulum()
    o.system = driven(o)
    o.system.evaluate_jacobian()
    o.native = driven(o, ode_solver="dop853")
    o.native.integrate()
    o.trajectory = o.native.simulate()
    o.trajectory.save("good.nc")
    with open("damaged.nc", "wb") as file, open("good.nc", "rb") as good:
        file.write(good.read()[:200] + b"\0" * 300)
    open("empty.nc", "wb").close()
    o.system.integrate_ensemble(initial_conditions={o.x: [1.0, 2.0]})
    c.system = System(
        c.kane, initial_conditions={c.x: 0.6, c.y: -0.8}, times=TIMES, ode_solver="dop853"
    )
    c.system.integrate(constraints="project")
    c.system.integrate(constraints="baumgarte", gain=5.0)
    form = ([o.v, (-o.k * o.x + o.f - o.g) / o.m], [o.x], [o.v], [o.k, o.m])
    made = {
        generator: generate_ode_function(*form, specifieds=[o.f, o.g], generator=generator)
        for generator in ("llvm", "lambdify")
    }
    for rhs in made.values():
        rhs([1.0, 2.0], 0.0, [0.0, 0.0], [1.0, 2.0])
    scene = Scene(o.N, o.O, Visual(Sphere(0.1), o.P), series={"x": o.x})
    scene.animate(TIMES, np.sin(TIMES)[:, None], symbols=[o.x])
    scene.html()
    scene.to_matplotlib()
    still = Scene(o.N, o.O, Visual(Sphere(0.1), o.P))
    still.animate([0.0, 0.05], np.zeros((2, 1)), symbols=[o.x])

    def plain(x: Any, t: float) -> list[float]:
        return [x[1], -x[0]]

    for solver in (dop853, radau):
        solver(plain, [1.0, 0.0], TIMES)
    rk4(plain, [1.0, 0.0], TIMES, step=0.1)
    return SimpleNamespace(o=o, c=c, made=made, form=form, scene=scene, still=still, plain=plain)


def driven(o: SimpleNamespace, **options: Any) -> System:
    """Return a System of the oscillator, with numbers."""
    options = {
        "constants": {o.k: 2.0, o.m: 0.5},
        "specifieds": {o.f: 0.25, o.g: 0.125},
        "initial_conditions": {o.x: 1.0},
        "times": TIMES,
        **options,
    }
    return System(o.kane, **options)
