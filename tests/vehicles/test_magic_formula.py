"""The Magic Formula against its published equations, by symmetry, and at its singular points."""

import itertools
import re
from functools import cache
from importlib.resources import files

import mpmath as mp
import numpy as np
import pytest
import sympy as sm
import sympy.physics.mechanics as me

from pydy.codegen.ode_function_generators import generate_ode_function
from pydy.errors import PyDyUserWarning
from pydy.mechanics import Definition
from pydy.system import System
from pydy.vehicles import MagicFormula, read_tir
from zoo import inertial_frame, tires
from zoo.tires import COMMON, NAMES, TABLE_A31, TIRES, slip_states


def tire_of(name, **options):
    version, equations, values = TIRES[name]
    return MagicFormula(values, version, equations=equations, **options)


@pytest.fixture(scope="module", params=list(TIRES))
def published(request):
    """A tire, its twenty states, and the results of the published equations there."""
    with mp.workdps(30):
        results = [
            [float(v) for v in tires.magic_formula(request.param, *state)]
            for state in slip_states()
        ]
    return request.param, slip_states(), np.array(results)


def assert_within_range(found, expected, relative=1e-10):
    for name, a, b in zip(NAMES, np.transpose(found), np.transpose(expected), strict=True):
        span = np.ptp(b) or 1.0
        assert np.abs(a - b).max() <= relative * span, name


def test_numbers_and_arrays_are_those_of_the_published_equations(published):
    name, states, expected = published
    Fz, kappa, alpha, gamma, speed, pressure = states.T
    tire = tire_of(name)
    found = tire.forces(Fz, kappa, alpha, gamma, speed=speed, pressure=pressure)
    assert_within_range(np.transpose(found), expected)
    one = tire.forces(*states[3, :4], speed=states[3, 4], pressure=states[3, 5])
    assert all(type(v) is float for v in one)
    np.testing.assert_allclose(one, np.transpose(found)[3], rtol=1e-13)


SYMBOLS = sm.symbols("Fz kappa alpha gamma speed pressure")


def compiled(tire, **options):
    """Return a compiled function from inputs to the five results; its state is idle."""
    forces = tire.forces(*SYMBOLS[:4], speed=SYMBOLS[4], pressure=SYMBOLS[5])
    rhs = generate_ode_function(
        sm.Matrix([0]), [me.dynamicsymbols("x")], [], constants=SYMBOLS, outputs=forces, **options
    )
    return lambda state: rhs(np.zeros(1), 0.0, np.asarray(state, dtype=float))[1]


@pytest.mark.parametrize("generator", ["llvm", "lambdify"])
def test_expressions_compile_to_the_same_numbers(published, generator):
    name, states, expected = published
    evaluate = compiled(tire_of(name), generator=generator)
    assert_within_range([evaluate(state) for state in states], expected)


def test_a_slip_angle_that_is_an_arctangent_costs_no_function():
    Fz, slip = SYMBOLS[:2]
    tire = tire_of("Table A3.1")
    found = tire.forces(Fz, 0, sm.atan(slip)).Fy
    assert not found.has(sm.tan)
    assert float(found.subs({Fz: 3000, slip: 0.1})) == pytest.approx(
        tire.forces(3000, 0, np.arctan(0.1)).Fy, rel=1e-12
    )


# ---- Symmetry ----


def test_a_mirrored_tire_is_the_image_of_the_measured_one():
    left, right = (MagicFormula(_file(COMMON, "left"), side=side) for side in ("left", "right"))
    assert (left.mirrored, right.mirrored) == (False, True)
    Fx, Fy, Mx, My, Mz = left.forces(4000, 0.05, 0.03, 0.02)
    image = right.forces(4000, 0.05, -0.03, -0.02)
    assert image == (Fx, -Fy, -Mx, My, -Mz)
    # Conicity does not cancel: both push outwards or inwards.
    assert left.forces(4000, 0, 0).Fy == -right.forces(4000, 0, 0).Fy != 0.0


def _file(values, side):
    from pydy.vehicles import TireFile

    return TireFile("car.tir", "6.1", side, None, dict(values), {}, {})


def symmetric(name):
    """Return a tire without shifts, conicity or other differences of its sides."""
    version, equations, values = TIRES[name]
    sides = ("PHX", "PHY1", "PHY2", "PVX", "PVY1", "PVY2", "PEX4", "PEY3", "QEZ4", "QHZ1", "QHZ2")
    sides += ("RHX", "RHY", "RVY1", "RVY2", "RBY3", "QDZ6", "QDZ7", "SSZ1", "QSX1", "QBZ4", "QDZ3")
    return MagicFormula(
        {k: v for k, v in values.items() if not k.startswith(sides)}, version, equations=equations
    )


@pytest.mark.parametrize("name", list(TIRES))
def test_a_tire_without_sides_has_mirrored_forces(name):
    tire = symmetric(name)
    Fx, Fy, Mx, My, Mz = tire.forces(4000, 0.05, 0.03, 0.02)
    image = tire.forces(4000, 0.05, -0.03, -0.02)
    np.testing.assert_allclose(image, (Fx, -Fy, -Mx, My, -Mz), rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("name", list(TIRES))
def test_signs_are_those_that_are_documented(name):
    tire = symmetric(name)
    assert tire.forces(4000, 0.02, 0.0).Fx > 0.0 > tire.forces(4000, -0.02, 0.0).Fx
    drifting_left = tire.forces(4000, 0.0, 0.02)
    assert drifting_left.Fy < 0.0 < drifting_left.Mz
    # A wheel that leans to the right (γ > 0) is pushed into its lean.
    assert tire.forces(4000, 0.0, 0.0, 0.05).Fy < 0.0 < tire.forces(4000, 0.0, 0.0, -0.05).Fy
    assert tire.forces(4000, 0.0, 0.0, speed=20.0).My < 0.0
    assert tire.forces(4000, 0.0, 0.0, speed=-20.0).My > 0.0


# ---- Singular points ----


STATES = list(itertools.product((-10.0, 0.0, 1e-9, 4000.0), (-1.0, 0.0), (0.0, 1.5), (0.0, 2.0)))


@pytest.mark.parametrize("name", list(TIRES))
def test_values_and_derivatives_are_finite_at_rest_and_without_slip_or_load(name):
    system, inputs = system_of(name, *NAMES)
    for Fz, kappa, alpha, speed in STATES:
        given = zip(inputs, (Fz, kappa, alpha, 0.0, speed, 2.2e5), strict=True)
        system.specifieds = {s: v for s, v in given if s in system.specifieds_symbols}
        found = system.evaluate_outputs()
        assert np.isfinite(found).all()
        assert np.isfinite(system.evaluate_jacobian(wrt="specifieds", of="outputs")).all()
        assert Fz > 0.0 or not np.any(found)


@cache
def system_of(name, *wanted, rolling=True):
    """Return a System with a tire's forces as outputs, and its inputs, which are specifieds."""
    inputs = [me.dynamicsymbols(str(s)) for s in SYMBOLS]
    more = {"speed": inputs[4], "pressure": inputs[5]} if rolling else {}
    forces = tire_of(name).forces(*inputs[:4], **more)
    N, O = inertial_frame()
    q, u = me.dynamicsymbols("q u")
    P = O.locatenew("P", q * N.x)
    P.set_vel(N, u * N.x)
    system = System(Definition(N, [q], [u], bodies=[me.Particle("P", P, sm.Symbol("m"))]))
    system.outputs = {sm.Symbol(n): getattr(forces, n) for n in wanted}
    return system, inputs


def test_a_tire_at_rest_has_no_force_without_slip():
    assert tire_of("Table A3.1").forces(4000, 0.0, 0.0, 0.05, speed=0.0)[:3] == (0.0, 0.0, 0.0)
    moving = tire_of("Table A3.1").forces(4000, 0.0, 0.0, 0.05, speed=1.0)
    assert moving.Fy == tire_of("Table A3.1").forces(4000, 0.0, 0.0, 0.05).Fy != 0.0


def test_forces_are_proportional_to_a_load_that_vanishes():
    tire = tire_of("6.1, book")
    small, smaller = (np.array(tire.forces(load, 0.1, 0.1)) for load in (1e-4, 1e-5))
    np.testing.assert_allclose(small, 10 * smaller, rtol=1e-12)


# ---- Options ----


@pytest.mark.parametrize("name", ["6.1, book", "5.2", "PAC2002"])
def test_stiffnesses_are_the_slopes_of_the_forces(name):
    tire = symmetric(name)
    plain = {"LMUV": 0.0, "LGAY": 1.0}
    tire = tire.replace(**{k: v for k, v in plain.items() if k in tire.parameters})
    Kx, Ky, Kg = tire.slip_stiffnesses(3000)
    h = 1e-5

    def slope(name, *step):
        ahead = tire.forces(3000, *step)
        back = tire.forces(3000, *(-v for v in step))
        return (getattr(ahead, name) - getattr(back, name)) / (2 * h)

    assert slope("Fx", h, 0.0) == pytest.approx(Kx, rel=1e-5)
    assert slope("Fy", 0.0, h) == pytest.approx(Ky, rel=1e-5)
    assert slope("Fy", 0.0, 0.0, h) == pytest.approx(Kg, rel=1e-5)
    assert Ky < 0.0


@pytest.mark.parametrize("name", ["5.2", "PAC2002", "6.2, paper"])
def test_without_drive_slip_the_moment_is_that_of_pure_slip_with_tangents_too(name):
    tire = tire_of(name, slip="tangent").replace(SSZ1=0.0, SSZ2=0.0, SSZ3=0.0, SSZ4=0.0)
    version, equations, _ = TIRES[name]
    pure = MagicFormula(tire.parameters, version, equations=equations, slip="tangent", use_mode=3)
    alpha = np.radians([-80.0, -65.0, -30.0, -2.0, 3.0, 40.0, 72.3, 85.0])
    expected = pure.forces(4000.0, 0.0, alpha, 0.05).Mz
    np.testing.assert_allclose(tire.forces(4000.0, 0.0, alpha, 0.05).Mz, expected, rtol=1e-6)


def test_relaxation_lengths_of_the_old_versions_differ_in_a_sign():
    old, adams = tire_of("5.2"), tire_of("PAC2002")
    c = old.parameters
    Fz, Fz0 = 5000.0, c["FNOMIN"] * c["LFZO"]
    dfz = Fz / Fz0 - 1
    for tire, sign in ((old, -1), (adams, 1), (tire_of("5.2", relaxation_sign=1), 1),
                       (tire_of("PAC2002", relaxation_sign=-1), -1)):  # fmt: skip
        kappa, alpha = tire.relaxation_lengths(Fz)
        expected = Fz * (c["PTX1"] + c["PTX2"] * dfz) * np.exp(sign * c["PTX3"] * dfz)
        assert kappa == pytest.approx(expected * c["UNLOADED_RADIUS"] / c["FNOMIN"] * c["LSGKP"])
        peak = c["PTY1"] * np.sin(2 * np.arctan(Fz / (c["PTY2"] * Fz0)))
        assert alpha == pytest.approx(peak * c["UNLOADED_RADIUS"] * c["LFZO"] * c["LSGAL"])


def test_relaxation_lengths_of_the_new_versions_need_stiffnesses():
    tire = tire_of("Table A3.1")
    with pytest.raises(ValueError, match="LONGITUDINAL_STIFFNESS, LATERAL_STIFFNESS of version"):
        tire.relaxation_lengths(4000)
    tire = tire.replace(LONGITUDINAL_STIFFNESS=3.6e5, LATERAL_STIFFNESS=1e5)
    Kx, Ky, _ = tire.slip_stiffnesses(4000)
    assert tire.relaxation_lengths(4000) == pytest.approx((Kx / 3.6e5, -Ky / 1e5))


def test_the_normal_force_has_the_stiffness_at_the_nominal_load():
    k = 2.1e5
    tire = tire_of("Table A3.1").replace(VERTICAL_STIFFNESS=k, VERTICAL_DAMPING=50.0)
    assert tire.normal_force(-0.01, -0.2) == pytest.approx(0.01 * k + 10.0)
    assert tire.normal_force([0.001, -0.001], 10.0).tolist() == [0.0, 0.0]
    curved = tire.replace(Q_FZ2=14.0)
    gap = sm.Symbol("gap")
    force = curved.normal_force(gap)
    depth = float(sm.nsolve(force.args[0][0] - 4000.0, gap, -0.02))
    h = 1e-6
    slope = (curved.normal_force(depth - h) - curved.normal_force(depth + h)) / (2 * h)
    assert slope == pytest.approx(k, rel=1e-6)
    with pytest.raises(ValueError, match="VERTICAL_STIFFNESS is missing"):
        tire_of("Table A3.1").normal_force(-0.01)


def test_a_spring_that_is_bent_too_much_is_refused():
    tire = tire_of("Table A3.1").replace(VERTICAL_STIFFNESS=2e5)
    most = (2e5 * 0.313 / 4000) ** 2 / 4
    assert tire.replace(Q_FZ2=most).normal_force(-0.02) > 0.0
    with pytest.raises(ValueError, match=r"Q_FZ2 must be at most .* = 61.2306, got 61.3"):
        tire.replace(Q_FZ2=61.3).normal_force(-0.02)


def test_a_pressure_without_a_nominal_one_is_refused():
    tire = MagicFormula({k: v for k, v in TABLE_A31.items() if k != "NOMPRES"})
    assert tire.forces(4000, 0.0, 0.1).Fy == tire_of("Table A3.1").forces(4000, 0.0, 0.1).Fy
    for ask in (
        lambda: tire.forces(4000, 0.0, 0.1, pressure=2e5),
        lambda: tire.slip_stiffnesses(4000, pressure=2e5),
        lambda: tire.forces(4000, 0.0, 0.1, pressure=sm.Symbol("p")),
    ):
        with pytest.raises(ValueError, match="`pressure` needs the coefficient NOMPRES"):
            ask()


REFF = {"VERTICAL_STIFFNESS": 2e5, "BREFF": 8.4, "DREFF": 0.27, "FREFF": 0.045}


def test_the_effective_rolling_radius_is_that_of_the_published_equation():
    tire = tire_of("Table A3.1").replace(**REFF)
    for load in (0.0, 1500.0, 4000.0, 9000.0):
        x = mp.mpf(load) / 4000
        expected = mp.mpf("0.313") - mp.mpf("0.02") * (
            mp.mpf("0.27") * mp.atan(mp.mpf("8.4") * x) + mp.mpf("0.045") * x
        )
        assert tire.rolling_radius(load) == pytest.approx(float(expected), rel=1e-14)
    assert tire.rolling_radius(-100.0) == 0.313
    Fz = sm.Symbol("Fz")
    assert tire.rolling_radius(Fz).subs(Fz, 1500.0) == pytest.approx(tire.rolling_radius(1500.0))
    larger = tire.replace(Q_RE0=1.01)
    assert larger.rolling_radius(4000) - tire.rolling_radius(4000) == pytest.approx(0.00313)
    linear = tire.replace(BREFF=0.0, DREFF=0.0)
    assert linear.rolling_radius(4000) == pytest.approx(0.313 - 0.02 * 0.045)
    with pytest.raises(ValueError, match="no effective rolling radius: BREFF is missing"):
        tire.replace(BREFF=0.0).rolling_radius(4000)
    with pytest.raises(ValueError, match="VERTICAL_STIFFNESS, DREFF, FREFF are missing"):
        tire_of("Table A3.1").rolling_radius(4000)


def test_use_modes_leave_out_what_they_say():
    tire = {mode: MagicFormula(COMMON, use_mode=mode) for mode in (0, 1, 2, 3, 4, 14)}
    forces = {mode: np.array(t.forces(4000, 0.1, 0.1, 0.05)) for mode, t in tire.items()}
    acting = {mode: tuple(np.flatnonzero(f)) for mode, f in forces.items()}
    assert acting == {
        0: (),
        1: (0, 3),
        2: (1, 2, 4),
        3: (0, 1, 2, 3, 4),
        4: (0, 1, 2, 3, 4),
        14: (0, 1, 2, 3, 4),
    }
    assert forces[1][0] == forces[3][0] > forces[4][0]
    assert (forces[4] == forces[14]).all()
    with pytest.raises(ValueError, match=r"`use_mode` must be 0 to 4.*got 7"):
        MagicFormula(COMMON, use_mode=7)


def pure(values):
    return {k: v for k, v in values.items() if k[0] != "R"}


def test_combined_slip_without_coefficients_must_be_chosen():
    with pytest.raises(ValueError, match=re.escape("Choose `combined='ellipse'`")):
        MagicFormula(pure(COMMON))
    none = MagicFormula(pure(COMMON), combined="none")
    alone = MagicFormula(pure(COMMON), use_mode=3)
    assert none.forces(4000, 0.1, 0.1) == alone.forces(4000, 0.1, 0.1)


def test_friction_ellipses_are_pure_slip_on_the_axes_and_full_friction_between():
    tire = MagicFormula(pure(TABLE_A31), combined="ellipse").replace(
        PHX1=0, PHX2=0, PHY1=0, PHY2=0, PVY1=0, PVY2=0
    )
    alone = MagicFormula(dict(tire.parameters), use_mode=3)
    assert tire.forces(4000, 0.1, 0.0).Fx == pytest.approx(alone.forces(4000, 0.1, 0.0).Fx)
    assert tire.forces(4000, 0.0, 0.1).Fy == pytest.approx(alone.forces(4000, 0.0, 0.1).Fy)
    # On the ellipses of the largest friction of one and the friction that is used of the other.
    Fx, Fy, *_ = tire.forces(4000, 0.08, 0.1)
    X, Y, *_ = alone.forces(4000, 0.08, 0.1)
    Dx, Dy = 1.21 * 4000, 0.99 * 4000
    assert np.hypot(Fx / X, Fx / 0.08 * np.sin(0.1) / Dy) == pytest.approx(1.0)
    assert np.hypot(Fy / Y, Fy / np.sin(0.1) * 0.08 / Dx) == pytest.approx(1.0)


@pytest.mark.parametrize("name", ["5.2", "6.2, paper", "6.1, book"])
def test_with_friction_ellipses_the_trail_is_that_of_combined_slip(name):
    # The trail needs the slip stiffnesses only. With weights of 1 the coefficients' moment has it.
    version, equations, values = TIRES[name]
    values = {k: v for k, v in values.items() if not re.match("R|SSZ|QDZ[6-9]|QDZ1[01]", k)}
    both = {
        way: MagicFormula(
            values | {"RBX1": 1e-30, "RCX1": 1.0, "RBY1": 1e-30, "RCY1": 1.0},
            version,
            equations=equations,
            combined=way,
        )
        for way in ("coefficients", "ellipse")
    }
    for kappa in (-1.0, -0.2, 0.0, 0.1):
        trails = {}
        for way, tire in both.items():
            forces = tire.forces(4000, kappa, 0.05)
            trails[way] = -forces.Mz / forces.Fy
        assert trails["ellipse"] == pytest.approx(trails["coefficients"], rel=1e-12)
    free, locked = (both["ellipse"].forces(4000, kappa, 0.05) for kappa in (0.0, -1.0))
    assert abs(locked.Mz / locked.Fy) < 0.5 * abs(free.Mz / free.Fy)


def test_with_friction_ellipses_the_longitudinal_force_has_its_arm():
    values = {k: v for k, v in TABLE_A31.items() if not k.startswith(("R", "SSZ"))}
    tire = MagicFormula(values, combined="ellipse")
    arm = tire.replace(SSZ1=0.05)
    forces, moved = (one.forces(4000, 0.1, 0.05) for one in (tire, arm))
    radius = TABLE_A31["UNLOADED_RADIUS"]
    assert moved.Mz - forces.Mz == pytest.approx(0.05 * radius * forces.Fx)


def test_the_vertical_stiffness_is_scaled():
    spring = {"VERTICAL_STIFFNESS": 2e5, "BREFF": 8.0, "DREFF": 0.25, "FREFF": 0.05}
    for more in ({}, {"Q_FZ2": 10.0}):
        tire = MagicFormula({**COMMON, **spring, **more})
        stiff = tire.replace(LCZ=1.5)
        assert stiff.normal_force(-0.02) == pytest.approx(1.5 * tire.normal_force(-0.02))
        assert stiff.normal_force(0.0, -1.0) == tire.normal_force(0.0, -1.0)
    # Of what the radius falls by, the deflection, a stiffer tire has less: Pacejka 2012, (A3.7).
    falls = [COMMON["UNLOADED_RADIUS"] - one.rolling_radius(4000) for one in (tire, stiff)]
    assert falls[0] == pytest.approx(1.5 * falls[1])
    with pytest.raises(ValueError, match="The coefficient LCZ must be positive, got 0"):
        tire.replace(LCZ=0.0)


def test_what_is_missing_and_what_is_not_read_is_said():
    with pytest.warns(
        PyDyUserWarning, match=r"Version 6\.1 .* does not read PTX1\. Pass `version`"
    ):
        tire = MagicFormula({**TABLE_A31, "PTX1": 1.0, "PTX2": 0.0})
    assert {"QSX1", "LMUX", "QBZ4"} <= set(tire.missing)
    assert tire.unused == ("PTX1", "PTX2")
    assert MagicFormula({**TABLE_A31, "PTX1": 1.0}, "6.1").unused == ("PTX1",)
    with pytest.raises(
        ValueError, match=r"the key 'PDXl1', which no version .* Did you mean `PDX1`"
    ):
        MagicFormula({**TABLE_A31, "PDXl1": 1.0})
    assert tire.parameters["PKY4"] == 2.0
    assert MagicFormula(pure(COMMON) | {"PKY4": 1.5}, use_mode=3).parameters["PKY4"] == 1.5
    assert (tire.parameters["LMUX"], tire.parameters["LMUV"]) == (1.0, 0.0)
    assert "missing: " in repr(tire)
    with pytest.warns(PyDyUserWarning, match="no coefficients of the aligning moment: it is zero"):
        MagicFormula({k: v for k, v in TABLE_A31.items() if k[0] != "Q"})
    with pytest.raises(ValueError, match="The coefficient FNOMIN is missing"):
        MagicFormula({})
    with pytest.raises(ValueError, match="NOMPRES is missing, the pressure that PPX1 refer"):
        MagicFormula({k: v for k, v in TABLE_A31.items() if k != "NOMPRES"} | {"PPX1": 1.0})


def test_forms_can_be_chosen_one_by_one():
    book, angles = (MagicFormula(COMMON, slip=slip) for slip in ("tangent", "angle"))
    x = 0.2
    assert angles.forces(4000, 0.0, np.tan(x)).Fy == pytest.approx(book.forces(4000, 0.0, x).Fy)
    scaled = MagicFormula(COMMON, friction_saturation=1)
    difference = scaled.forces(4000, 0.0, 0.1).Fy - book.forces(4000, 0.0, 0.1).Fy
    assert difference != 0.0
    assert MagicFormula({**COMMON, "LMUX": 1, "LMUY": 1}).forces(4000, 0.1, 0.1) == MagicFormula(
        {**COMMON, "LMUX": 1, "LMUY": 1}, friction_saturation=1
    ).forces(4000, 0.1, 0.1)
    with pytest.raises(ValueError, match="`equations` must be one of 'pacejka', 'besselink'"):
        MagicFormula(COMMON, equations="tno")


def test_coefficients_may_be_constants_of_a_model():
    mu = sm.Symbol("mu")
    tire = tire_of("Table A3.1").replace(LMUY=mu)
    found = tire.forces(4000, 0.0, 0.1).Fy
    assert found.free_symbols == {mu}
    expected = tire.replace(LMUY=0.6).forces(4000, 0.0, 0.1).Fy
    assert float(found.subs(mu, 0.6)) == pytest.approx(expected, rel=1e-13)
    with pytest.raises(ValueError, match=r"'LMU' is no parameter of the tire. Did you mean `LMU"):
        tire.replace(LMU=1.0)
    with pytest.raises(TypeError, match="`alpha` must be a number or an expression"):
        tire.forces(4000, 0.0, [0.1, 0.2])


def test_a_dictionary_of_a_file_is_the_file():
    file = read_tir(files("pydy.examples") / "passenger_car.tir")
    state = (4000, -0.05, 0.05, 0.02)
    read = MagicFormula(file, side="right")
    given = MagicFormula({**file.coefficients, "TYRESIDE": "LEFT"}, side="right")
    assert given.mirrored
    assert (given.version, given.missing) == (read.version, read.missing)
    assert given.forces(*state) == read.forces(*state)
    assert given.forces(*state) != MagicFormula(file).forces(*state)
    assert MagicFormula({**TABLE_A31, "FITTYP": 62}).version == "6.2"
    assert MagicFormula({**TABLE_A31, "USE_MODE": 13}).use_mode == 13
    assert MagicFormula({**TABLE_A31, "TYRESIDE": "LEFT", "FZMAX": 9000}).version == "6.1"
    with pytest.raises(ValueError, match=r"`coefficients` is for another tire .*MF-MCTyre 1\.1"):
        MagicFormula({**TABLE_A31, "FITTYP": 52})
    with pytest.raises(ValueError, match="`FITTYP` must be"):
        MagicFormula({**TABLE_A31, "FITTYP": "61b"})


def test_inputs_are_checked_by_name():
    tire = tire_of("Table A3.1")
    with pytest.raises(ValueError, match="`kappa` must be finite"):
        tire.forces(4000, float("nan"), 0.0)
    with pytest.raises(ValueError, match=r"shapes that match, got `Fz` \(2,\), `alpha` \(3,\)"):
        tire.forces([1.0, 2.0], 0.0, [1.0, 2.0, 3.0])
    assert tire.forces(4000, 0.0, np.zeros((2, 3))).Fx.shape == (2, 3)


# ---- Cost ----


def test_operations_of_a_tire_under_combined_slip_do_not_grow():
    # At constant speed and pressure.
    system, _ = system_of("Table A3.1", "Fx", "Fy", "Mz", rolling=False)
    system.evaluate_outputs()
    counts = system.model.compiled("outputs").program.operation_count["run"]
    assert sum(counts.values()) <= 266
    assert counts["atan"] <= 14
