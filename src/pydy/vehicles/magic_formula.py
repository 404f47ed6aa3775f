"""The Magic Formula of Pacejka: a tire from some hundred coefficients."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any, Self

from pydy._checks import check_mapping, choice
from pydy._names import some
from pydy.vehicles.algebra import Algebra, Quantity, is_symbolic
from pydy.vehicles.carcass import (
    LoadState,
    VerticalState,
    normal_force,
    relaxation_lengths,
    rolling_radius,
)
from pydy.vehicles.coefficients import ALIASES, ALL_NAMES, absent_groups, default, names_of
from pydy.vehicles.equations import (
    EquationInputs,
    camber_stiffness,
    condition,
    cornering_stiffness,
    lateral,
    longitudinal,
)
from pydy.vehicles.forces import TireEquations, TireInputs, evaluate, unknown_parameter
from pydy.vehicles.magic_checks import (
    ESSENTIAL,
    MODES,
    check_names,
    check_rolling_radius,
    check_vertical,
    checked_combination,
    checked_values,
    form_of,
    use_mode_of,
    version_of,
    warn_of_absent_groups,
    warn_of_other_versions,
)
from pydy.vehicles.moments import (
    aligning_moment,
    ellipse_weights,
    induced_side_force,
    lateral_weight,
    longitudinal_weight,
    overturning_moment,
    rolling_resistance,
)
from pydy.vehicles.tir import TireFile, file_of


class MagicFormula(TireEquations):
    """A tire by the Magic Formula.

    The equations are those of Pacejka 2012, section 4.3.2, without turn slip (all ζ are 1); for
    the older versions, those of their manuals. Axes and signs are ISO's: x forward along the wheel
    plane, y to the left, z up, all in the road's plane and at the contact point C, with::

        κ = −V_sx/|V_x|,  V_sx = V_x − r_e Ω   positive if driven; −1 if the wheel is locked
        tan α = V_y/|V_x|                      positive if the tire drifts to the left
        γ                                      positive if the wheel's top leans to the right

    A positive slip angle gives a negative side force and a positive aligning moment; a tire that
    leans to the right is pushed to the right, by a negative side force. Coefficients of files are
    meant for these signs: PKY1 is negative.

    Parameters
    ----------
    coefficients : TireFile or mapping of str to number or expression
        What `read_tir` returns, or coefficients in SI units by the names that such files use; a
        dictionary may say FITTYP, TYRESIDE and USE_MODE, too. A scaling factor (L…) that is missing
        is 1, PKY4 is 2, any other is 0. Symbols become constants of a System.
    version : {'5.2', '6.1', '6.2', 'PAC2002'}, optional
        That of the file by default, otherwise ``'6.1'``.
    equations : {'pacejka', 'besselink'}, optional
        Of the versions 6.1 and 6.2 there are two published forms. By default the book's (Pacejka
        2012): tan α and sin γ, A_μ = 10, the size of γ in the trail. ``'besselink'`` is the
        paper's (Besselink et al. 2010), which the MF-Tyre software follows: α and γ in rad,
        A_μ = 1, γ in the trail, the equivalent slip of the aligning moment by tan α, the arm of
        F_x relative to FNOMIN. In both, rolling resistance is in proportion to
        FNOMIN (F_z/FNOMIN)^QSY7, and cos α multiplies the residual moment once.
    side : {'left', 'right'}, optional
        The side of the vehicle that the tire is mounted on. If the file is for the other side, the
        tire is mirrored: α, γ, F_y, M_x and M_z change their signs. By default as measured.
    use_mode : int, optional
        What is computed: 0 no forces, 1 F_x and M_y, 2 F_y, M_x and M_z, 3 all of pure slip, 4 all
        of combined slip. Further digits are for transients (14 is 4 with relaxation), which
        `relaxation_lengths` is for. By default that of the file, otherwise 4. That of a file may be
        negative: the tire is mirrored then.
    combined : {'coefficients', 'ellipse', 'none'}, optional
        How combined slip reduces the forces: by the coefficients R…, the default; by friction
        ellipses as in Adams, which need none; or not at all, so that both forces can be at their
        largest together. Without the coefficients a choice must be made. But for the last, the
        trail becomes shorter with κ.
    slip : {'tangent', 'angle'}, optional
        Whether tan α and sin γ enter the equations, or α and γ; by default as `equations` says,
        and ``'angle'`` for the older versions.
    friction_saturation : number, optional
        A_μ of (4.E8), by which vertical shifts fade on slippery roads; 1 lets them scale with the
        friction. By default as `equations` says, and 1 for the older versions.
    relaxation_sign : {-1, 1}, optional
        Sign of PTX3 dfz in the exponent of σ_κ. By default −1, as in MF 5.2, and 1 for PAC2002.

    Attributes
    ----------
    version, equations : str
    side : str or None
    use_mode : int
    combined : str
    mirrored : bool
        Whether the tire is the mirror image of the one measured.
    missing : tuple of str
        Coefficients of this version that were not given, and have the values above.
    unused : tuple of str
        Coefficients that were given and that only another version reads.

    Raises
    ------
    ValueError
        A coefficient is essential and missing, combined slip has no coefficients, or no version has
        a coefficient of some name.

    Warns
    -----
    PyDyUserWarning
        A force or the aligning moment has no coefficients, and is zero; or the version, which is
        assumed, does not read some coefficients.

    Notes
    -----
    Forces and their derivatives are finite for κ = 0, α = 0, V = 0 and F_z = 0; without a load
    there is no force. Below the speed VXLOW (1 m/s if it is missing) shifts, and with them forces
    without slip, vanish with the speed: a car at rest does not creep. Loads and slips are not
    limited to the ranges of the file. Scaling factors of friction must be positive.

    References
    ----------
    H. B. Pacejka, Tire and Vehicle Dynamics, 3rd ed., Butterworth-Heinemann, 2012, section 4.3.2.

    I. J. M. Besselink, A. J. C. Schmeitz, H. B. Pacejka, An improved Magic Formula/Swift tyre model
    that can handle inflation pressure changes, Vehicle System Dynamics 48(S1), 2010, pp. 337–352.

    Examples
    --------
    >>> from pydy.vehicles import MagicFormula
    >>> tire = MagicFormula({
    ...     'FNOMIN': 4000, 'UNLOADED_RADIUS': 0.313,
    ...     'PCX1': 1.685, 'PDX1': 1.21, 'PEX1': 0.344, 'PKX1': 21.51,
    ...     'PCY1': 1.193, 'PDY1': -0.99, 'PEY1': -1.003, 'PKY1': -14.95, 'PKY2': 2.13,
    ...     'QBZ1': 8.964, 'QCZ1': 1.18, 'QDZ1': 0.1, 'QEZ1': -1.609,
    ...     'RBX1': 12.35, 'RBX2': -10.77, 'RCX1': 1.092,
    ...     'RBY1': 6.461, 'RBY2': 4.196, 'RCY1': 1.081})
    >>> pure, combined = tire.forces(4000, 0.0, 0.05), tire.forces(4000, -0.1, 0.05)
    >>> round(pure.Fy), round(combined.Fy), round(combined.Fx)
    (-2148, -1761, -4229)

    The same equations for arrays, and for expressions:

    >>> tire.forces(4000, 0.0, [-0.05, 0.0, 0.05]).Fy.round()
    array([ 2148.,     0., -2148.])
    >>> import sympy as sm
    >>> alpha = sm.Symbol('alpha')
    >>> round(tire.forces(4000, 0, alpha).Fy.subs(alpha, 0.05))
    -2148
    """

    def __init__(
        self,
        coefficients: TireFile | Mapping[str, Any],
        version: str | None = None,
        *,
        equations: str | None = None,
        side: str | None = None,
        use_mode: int | None = None,
        combined: str | None = None,
        slip: str | None = None,
        friction_saturation: float | None = None,
        relaxation_sign: float | None = None,
    ) -> None:
        file = coefficients if isinstance(coefficients, TireFile) else None
        is_file = file is not None
        given = check_mapping("coefficients", file.coefficients if file else coefficients)
        file = file or file_of(given)
        self.version = version_of(version, file)
        self.equations, form = form_of(
            self.version, equations, slip, friction_saturation, relaxation_sign
        )
        self._form = form
        measured = file.side if file else None
        self.side = measured if side is None else choice(side, ("left", "right"), "`side`")
        other = None not in (measured, self.side) and measured != self.side
        self.mirrored = other != (file is not None and (file.use_mode or 0) < 0)
        self.use_mode = use_mode_of(use_mode, file)
        names = names_of(self.version)
        spelled = {ALIASES.get(str(name), str(name)): value for name, value in given.items()}
        self.missing = tuple(name for name in names if name not in spelled)
        if not is_file:  # a file has other numbers, too: of other tire models, of its author
            check_names(spelled)
        self.unused = tuple(name for name in spelled if name in ALL_NAMES and name not in names)
        if version is None and file is None:
            warn_of_other_versions(self.version, {name: spelled[name] for name in self.unused})
        defaults = {name: default(name) for name in names}
        self._values = checked_values(
            {**defaults, **{n: v for n, v in spelled.items() if n in names}}, self.missing, form
        )
        self._absent = frozenset(absent_groups(self.version, self._values))
        self.combined = checked_combination(combined, file, self.use_mode, self._absent)
        warn_of_absent_groups(self.use_mode, self._absent)

    def __repr__(self) -> str:
        details = [f"version {self.version}", f"use mode {self.use_mode}"]
        if self.side:
            details.append(f"{self.side} side{', mirrored' * self.mirrored}")
        if self.missing:
            details.append(f"missing: {some(list(self.missing))}")
        return f"<MagicFormula: {', '.join(details)}>"

    @property
    def parameters(self) -> Mapping[str, Any]:
        """The coefficients by name, those that are missing too."""
        return MappingProxyType(self._values)

    def replace(self, **parameters: Any) -> Self:
        """Return the tire with some other coefficients, such as ``LMUY=0.8``.

        Parameters
        ----------
        **parameters
            Coefficients by name: numbers, or expressions whose symbols become constants of a
            System.

        Examples
        --------
        >>> from pydy.vehicles import MagicFormula
        >>> dry = MagicFormula({'FNOMIN': 4000, 'UNLOADED_RADIUS': 0.3, 'PCX1': 1.6, 'PDX1': 1.0,
        ...                     'PKX1': 20.0}, use_mode=1)
        >>> wet = dry.replace(LMUX=0.5)
        >>> round(wet.forces(4000, 1.0, 0.0).Fx / dry.forces(4000, 1.0, 0.0).Fx, 2)
        0.47
        """
        for name in parameters:
            if name not in self._values:
                raise unknown_parameter(name, self._values)
        tire = copy.copy(self)
        tire.missing = tuple(name for name in self.missing if name not in parameters)
        tire._values = checked_values({**self._values, **parameters}, tire.missing, self._form)
        tire._absent = frozenset(absent_groups(self.version, tire._values))
        return tire

    def slip_stiffnesses(
        self, Fz: Quantity, gamma: Quantity = 0.0, *, pressure: Quantity | None = None
    ) -> tuple[Quantity, Quantity, Quantity]:
        """Return the slopes of the forces where no slip is: K_xκ, K_yα and K_yγ.

        Parameters
        ----------
        Fz, gamma, pressure : number, array or expression
            As for `forces`.

        Returns
        -------
        tuple of three
            Of F_x by κ (N), (4.E15); of F_y by α (N/rad), negative, (4.E25); and of F_y by γ at
            γ = 0 (N/rad), (4.E30), or in the versions 5.2 and PAC2002 that of the shifts by γ.
        """

        def equations(m: Algebra, state: TireInputs) -> tuple[Any, ...]:
            s = condition(m, self._form, self._values, state)
            Kx = s.Fz * longitudinal(s).stiffness
            Ky = s.Fz * cornering_stiffness(s, s.camber * s.c.LGAY)
            return Kx, Ky, s.Fz * camber_stiffness(s)

        inputs = {"Fz": Fz, "kappa": 0.0, "alpha": 0.0, "gamma": gamma}
        return evaluate(equations, self._values, **inputs, speed=None, pressure=pressure)

    def relaxation_lengths(
        self, Fz: Quantity, gamma: Quantity = 0.0, *, pressure: Quantity | None = None
    ) -> tuple[Quantity, Quantity]:
        """Return the relaxation lengths σ_κ and σ_α (m), by which slips follow with a lag.

        In the versions 6.1 and 6.2 they are the slip stiffnesses divided by LONGITUDINAL_STIFFNESS
        and LATERAL_STIFFNESS. In the older ones they follow from PTX1 to PTY2. Both vanish without
        a load.

        Parameters
        ----------
        Fz, gamma, pressure : number, array or expression
            As for `forces`.

        Returns
        -------
        tuple of two
        """

        def equations(m: Algebra, state: TireInputs) -> tuple[Any, ...]:
            return relaxation_lengths(condition(m, self._form, self._values, state))

        needed = ["PTX1", "PTY1", "PTY2"]
        if self._form.camber_stiffness:
            needed = ["LONGITUDINAL_STIFFNESS", "LATERAL_STIFFNESS"]
        absent = [n for n in needed if not is_symbolic(self._values[n]) and not self._values[n]]
        if absent:
            raise ValueError(
                f"The tire has no relaxation lengths: {some(absent)} of version {self.version} "
                f"{'is' if len(absent) == 1 else 'are'} missing. Give values with `replace`."
            )
        inputs = {"Fz": Fz, "kappa": 0.0, "alpha": 0.0, "gamma": gamma}
        return evaluate(equations, self._values, **inputs, speed=None, pressure=pressure)

    def normal_force(self, gap: Quantity, rate: Quantity = 0.0) -> Quantity:
        """Return the normal force of a tire that is pressed on the road, for `WheelContact`.

        Its spring has VERTICAL_STIFFNESS k; with Q_FZ2, of the versions 6.1 and 6.2, it is the
        parabola F_z0 (Q_FZ1 ρ/R_0 + Q_FZ2 (ρ/R_0)²) of the deflection ρ, with the slope k at F_z0.
        LCZ scales the spring. A damper, VERTICAL_DAMPING, is parallel to it. Effects of speed, of
        pressure and of the other forces are left out.

        Parameters
        ----------
        gap : number, array or expression
            Distance to the road (m), negative where the tire is deflected: −ρ.
        rate : number, array or expression, optional
            Its time derivative (m/s).

        Returns
        -------
        number, array or expression
            F_z (N), not negative.
        """

        def equations(m: Algebra, state: VerticalState) -> tuple[Any, ...]:
            return (normal_force(m, self._values, state),)

        check_vertical(self._values)
        (force,) = evaluate(equations, self._values, VerticalState, gap=gap, rate=rate)
        return force

    def rolling_radius(self, Fz: Quantity) -> Quantity:
        """Return the effective rolling radius R_e of a load, for `WheelContact`.

        A wheel that rolls freely has V_x = R_e Ω, with ::

            R_e = R_0 Q_RE0 − F_z0/k (D_reff atan(B_reff F_z/F_z0) + F_reff F_z/F_z0)

        of BREFF, DREFF and FREFF, and k = LCZ VERTICAL_STIFFNESS. Q_RE0, of the versions 6.1 and
        6.2, is 1 if it is missing. The growth of the tire with its speed is left out.

        Parameters
        ----------
        Fz : number, array or expression
            Normal force (N).

        Returns
        -------
        number, array or expression
            R_e (m).

        Examples
        --------
        >>> from pydy.vehicles import MagicFormula
        >>> tire = MagicFormula({'FNOMIN': 4000, 'UNLOADED_RADIUS': 0.313, 'PCX1': 1.6, 'PDX1': 1.0,
        ...                      'PKX1': 20.0, 'VERTICAL_STIFFNESS': 2e5, 'BREFF': 8.4,
        ...                      'DREFF': 0.27, 'FREFF': 0.045}, use_mode=1)
        >>> round(tire.rolling_radius(4000), 4)  # the loaded radius is 0.293 m
        0.3043
        """

        def equations(m: Algebra, state: LoadState) -> tuple[Any, ...]:
            return (rolling_radius(m, self._values, state),)

        check_rolling_radius(self._values)
        (radius,) = evaluate(equations, self._values, LoadState, Fz=Fz)
        return radius

    def _equations(self, m: Algebra, state: TireInputs) -> tuple[Any, ...]:
        """Return the five results; the mirrored tire sees all from the other side."""
        if self.mirrored:
            state = replace(state, alpha=-state.alpha, gamma=-state.gamma)
        s = condition(m, self._form, self._values, state)
        Fx, Fy, Mx, My, Mz = (s.Fz * result for result in self._per_load(s))
        return (Fx, -Fy, -Mx, My, -Mz) if self.mirrored else (Fx, Fy, Mx, My, Mz)

    def _per_load(self, s: EquationInputs) -> tuple[Any, ...]:
        """Return the five results divided by the load."""
        parts = MODES[self.use_mode % 10]
        has = {part: part in parts and ESSENTIAL[part][0] not in self._absent for part in "xy"}
        x = longitudinal(s) if has["x"] else None
        y = lateral(s) if has["y"] else None
        Fx = x.force if x else 0
        Fy = y.force if y else 0
        weight, induced, with_kappa = 1, 0, None
        if "combined" in parts and x is not None and y is not None:
            alone = s.form.uncambered and s.form.upright_weight  # the weight without camber
            if self.combined == "coefficients":
                weight, induced, with_kappa = lateral_weight(s), induced_side_force(s, y), x
                Fx, Fy = Fx * longitudinal_weight(s), Fy * weight + induced
                weight = lateral_weight(s, upright=True) if alone else weight
            elif self.combined == "ellipse":
                (weight_x, weight), with_kappa = ellipse_weights(s, x, y), x
                Fx, Fy = Fx * weight_x, Fy * weight
                if alone:
                    _, weight = ellipse_weights(s, x, lateral(s, upright=True))
        Mx = My = Mz = 0
        if "y" in parts and "overturning moment" not in self._absent:
            Mx = overturning_moment(s, Fy)
        if "x" in parts and "rolling resistance" not in self._absent:
            My = rolling_resistance(s, Fx)
        if y is not None and "aligning moment" not in self._absent:
            Mz = aligning_moment(s, with_kappa, y, Fx, Fy, induced, weight)
        return Fx, Fy, Mx, My, Mz
