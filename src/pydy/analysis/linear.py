"""Linear models of the motions that satisfy the constraints.

The states x satisfy the constraints c(x) = 0; some of them, z, are chosen as independent. With the
Jacobian J of c every small motion on the constraints is δx = T δz with J T = 0, where the rows of T
that belong to z are those of the identity. These rows of δx' = A δx + B δr are δz' = (A T) δz + B
δr, at an equilibrium and along any motion, since they are constant (D. L. Peterson, G. Gede and M.
Hubbard, "Symbolic linearization of equations of motion of constrained multibody systems", Multibody
System Dynamics 33 (2015) 143-161).

The unknowns of an `Implicit` are coordinates that follow from the other states and the inputs. They
are never independent. Their derivatives by the inputs contribute to B and D.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._axes import axes_of, legend_beside, rows_of_axes, typeset
from pydy._checks import choice, one_or_more, real_array
from pydy._errors import warn_user
from pydy._judges import (
    check_orientations,
    first_violation,
    warn_of_kinks,
    warn_of_missing_derivatives,
    warn_of_protected_states,
)
from pydy._motion import constraint_names
from pydy._names import few, some, unique_names
from pydy._optional import require
from pydy._problem import CallArguments, Problem, with_unknowns
from pydy._states import EvaluationPoints
from pydy.analysis.equilibria import Equilibrium
from pydy.analysis.tuning import ZERO_REAL_PART
from pydy.analysis.unsteadiness import departure_that_changes_the_model

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from scipy.signal import StateSpace

    from pydy._sympy_types import SymbolOrName


@dataclass(frozen=True, eq=False)
class LinearModel:
    """``z' = A z + B r`` and ``y = C z + D r`` for small deviations z, r and y.

    Attributes
    ----------
    A, B, C, D : ndarray
        Shapes (n, n), (n, s), (o, n) and (o, s), with an additional first axis for several states.
    states, inputs, outputs : tuple of str
        Names; the states are the independent ones.
    rates : ndarray, shape (n,) or (m, n)
        The derivatives of the independent states at the point of linearisation; at an equilibrium
        they are zero, except for coordinates that move steadily.

    Examples
    --------
    >>> from pydy.models import multi_mass_spring_damper
    >>> system = multi_mass_spring_damper(apply_external_forces=True)
    >>> model = system.linearize()
    >>> model.A, model.B, model.states, model.inputs
    (array([[ 0.,  1.],
           [-1., -1.]]), array([[0.],
           [1.]]), ('x0', 'v0'), ('f0',))
    >>> model.eigenvalues.round(3)
    array([-0.5+0.866j, -0.5-0.866j])
    """

    A: np.ndarray
    B: np.ndarray
    C: np.ndarray
    D: np.ndarray
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    rates: np.ndarray

    @property
    def eigenvalues(self) -> np.ndarray:
        """Eigenvalues of A, shape (n,) or (m, n), in 1/s: the largest real part first."""
        values = np.linalg.eigvals(self.A).astype(complex)
        order = np.lexsort((-values.imag, -values.real), axis=-1)
        return np.take_along_axis(values, order, axis=-1)

    def __repr__(self) -> str:
        """Return names and eigenvalues; A, B, C and D are attributes."""
        parts = [f"{kind}: {some(names) or 'none'}" for kind, names in self._names.items()]
        if self.A.ndim == 3:
            parts.append(f"{len(self.A)} models")
        else:
            poles = [
                f"{v.real:.4g}" + (f" +- {v.imag:.4g}j" if v.imag else "")
                for v in self.eigenvalues
                if v.imag >= 0.0
            ]
            parts.append(f"eigenvalues (1/s): {some(poles)}")
        return f"LinearModel with {'; '.join(parts)}"

    def plot_poles(self, axes: Any = None) -> Any:
        """Plot the eigenvalues in the complex plane.

        Those of several models are coloured from the first to the last.

        Parameters
        ----------
        axes : matplotlib Axes, optional

        Returns
        -------
        matplotlib Axes
        """
        ax, eigenvalues = complex_plane(axes), self.eigenvalues
        ax.axhline(0.0, color="0.7", linewidth=0.8)
        colours: dict[str, object] = {"color": "C0"}
        if eigenvalues.ndim == 2:
            colours = {
                "c": np.broadcast_to(np.arange(len(eigenvalues))[:, None], eigenvalues.shape)
            }
        ax.scatter(eigenvalues.real, eigenvalues.imag, marker="x", **colours)
        return ax

    def to_state_space(self) -> StateSpace:
        """Return the model as a `scipy.signal.StateSpace`."""
        from scipy.signal import StateSpace

        return StateSpace(*self._single_model("to_state_space"))

    def to_control(self) -> Any:
        """Return the model as a ``control.StateSpace`` of python-control, with its names."""
        control = require("control", "control", "to_control()")
        names = {kind: list(names) for kind, names in self._names.items()}
        return control.ss(*self._single_model("to_control"), **names)

    def frequency_response(self, frequencies: ArrayLike) -> np.ndarray:
        """Return the complex amplitudes of the outputs for inputs of amplitude one.

        Parameters
        ----------
        frequencies : array_like, shape (f,)
            In rad/s.

        Returns
        -------
        ndarray of complex, shape (f, o, s)
            ``C (iω − A)⁻¹ B + D``.

        Raises
        ------
        numpy.linalg.LinAlgError
            A frequency is that of an undamped eigenvalue, or 0 where there is one of zero.

        Notes
        -----
        Inputs are continuous. A controller that holds its output for a sample period T multiplies
        the response by ``(1 − exp(−iωT)) / (iωT)``, a delay of T/2 at low frequencies.
        """
        omega = real_array(frequencies, "`frequencies`")
        if omega.ndim != 1 or not np.isfinite(omega).all():
            raise ValueError("`frequencies` must be a list of finite numbers, in rad/s.")
        A, B, C, D = self._single_model("frequency_response")
        resolvent = 1j * omega[:, None, None] * np.eye(len(A)) - A
        try:
            response: np.ndarray = C @ np.linalg.solve(resolvent, B.astype(complex)[None]) + D
        except np.linalg.LinAlgError:
            k = int(np.linalg.svd(resolvent, compute_uv=False)[:, -1].argmin())
            raise np.linalg.LinAlgError(
                f"`frequencies` has {omega[k]:.10g} rad/s at index {k}, where {omega[k]:.10g}i is "
                "an eigenvalue of A: there is no steady response. Leave this frequency out."
            ) from None
        return response

    def plot_bode(
        self,
        input: str,
        output: str,
        frequencies: ArrayLike | None = None,
        axes: Any = None,
        *,
        unit: str = "rad/s",
    ) -> Any:
        """Plot magnitude and phase of the response of one output to one input.

        The phase is continuous: unwrapped from the first frequency on, so frequencies must be dense
        enough that it changes by less than 180° between neighbours.

        Parameters
        ----------
        input, output : str
            Names, of `inputs` and `outputs`.
        frequencies : array_like, shape (f,), optional
            In rad/s, also if `unit` is 'Hz'; by default from a tenth of the slowest eigenvalue to
            ten times the fastest.
        axes : pair of matplotlib Axes, optional
        unit : {'rad/s', 'Hz'}
            Unit of the frequency axis.

        Returns
        -------
        pair of matplotlib Axes
        """
        unit = choice(unit, ("rad/s", "Hz"), "`unit`")
        j = self.inputs.index(choice(input, self.inputs, "`input`"))
        i = self.outputs.index(choice(output, self.outputs, "`output`"))
        if frequencies is None:
            frequencies = _bode_frequencies(self._single_model("plot_bode")[0])
        frequencies = real_array(frequencies, "`frequencies`")
        response = self.frequency_response(frequencies)[:, i, j]
        if (frequencies < 0.0).any():
            raise ValueError(
                f"`frequencies` must not be negative, got {frequencies.min():g} rad/s: the axis is "
                "logarithmic."
            )
        axes, (magnitude_ax, phase_ax) = rows_of_axes(axes, 2, "of magnitude and phase")
        label = f"{typeset(input, '')} → {typeset(output, '')}"
        in_unit = frequencies / (2.0 * np.pi) if unit == "Hz" else frequencies
        with np.errstate(divide="ignore"):
            magnitude = 20.0 * np.log10(np.abs(response))
        phase = np.degrees(np.unwrap(np.angle(response)))
        magnitude_ax.semilogx(in_unit, magnitude, label=label)
        phase_ax.semilogx(in_unit, phase, label=label)
        for ax in (magnitude_ax, phase_ax):
            ax.grid(which="both", alpha=0.3)
        magnitude_ax.set_ylabel("magnitude (dB)")
        phase_ax.set_ylabel("phase (°)")
        phase_ax.set_xlabel(f"frequency ({unit})")
        legend_beside(magnitude_ax)
        return axes

    @property
    def _names(self) -> dict[str, tuple[str, ...]]:
        return {"states": self.states, "inputs": self.inputs, "outputs": self.outputs}

    def _single_model(self, method: str) -> tuple[np.ndarray, ...]:
        if self.A.ndim != 2:
            raise ValueError(
                f"{method}() needs a single linear model, but there are {len(self.A)}, one for "
                "each state in `at`. Linearize at one state."
            )
        return self.A, self.B, self.C, self.D


def _bode_frequencies(A: np.ndarray) -> np.ndarray:
    """Return frequencies from a tenth of the slowest eigenvalue to ten times the fastest."""
    magnitudes = np.abs(np.linalg.eigvals(A))
    nonzero = magnitudes[magnitudes > ZERO_REAL_PART * magnitudes.max(initial=0.0)]
    low, high = (nonzero.min(), nonzero.max()) if nonzero.size else (1.0, 1.0)
    return np.geomspace(0.1 * low, 10.0 * high, num=400)


def complex_plane(ax: Any) -> Any:
    """Return Axes for eigenvalues, with the imaginary axis."""
    ax = axes_of(ax, "a plot")
    ax.axvline(0.0, color="0.7", linewidth=0.8)
    ax.set_xlabel("real part (1/s)")
    ax.set_ylabel("imaginary part (1/s)")
    return ax


# -- the linear model of a Problem -----------------------------------------------------------------


def linearize(
    problem: Problem,
    at: ArrayLike | Mapping[SymbolOrName, float] | Equilibrium | None = None,
    t: ArrayLike | None = None,
    *,
    inputs: SymbolOrName | Iterable[SymbolOrName] | None = None,
    outputs: SymbolOrName | Iterable[SymbolOrName] | None = None,
) -> LinearModel:
    """Return the linear model of a Problem; see `System.linearize`."""
    warn_of_missing_derivatives(problem)
    definition = problem.definition
    point, single = _evaluation_point(problem, at, t)
    T, free = point.tangents()
    violated = definition.equations.constraints.are_present and _warn_of_violations(point)
    if not violated:
        check_orientations(point, lambda k: f"In {_state_text(k, len(point.x))},")
    A = point.directional("rates", T)[:, free]
    symbols = definition.specifieds if inputs is None else one_or_more("inputs", inputs)
    columns = definition.places["specifieds"].columns(symbols, "inputs").tolist()
    by_inputs = _InputDerivatives(point, columns)
    by_inputs.refuse_prescribed_motions(by_default=inputs is None)
    B = by_inputs.total("rates")[:, free]
    C, D, output_names = _outputs(point, outputs, T, by_inputs)
    parts = [A, B, C, D, point.value(point.model.compiled("rates"))[:, free]]
    _check_finite(parts)
    if at is None and t is None:
        _warn_of_motion(problem, point)
    _warn_of_constant_derivatives(point, columns, T, free, outputs)
    warn_of_kinks(point, T, free, columns)
    warn_of_protected_states(point, T, free, A)
    A, B, C, D, rates = (part[0] if single else part for part in parts)
    return LinearModel(
        A, B, C, D,
        tuple(np.array(unique_names(definition.states))[free].tolist()),
        tuple(np.array(unique_names(definition.specifieds))[columns].tolist()),
        output_names, rates,
    )  # fmt: skip


def _evaluation_point(
    problem: Problem,
    at: ArrayLike | Mapping[SymbolOrName, float] | Equilibrium | None,
    t: ArrayLike | None,
) -> tuple[EvaluationPoints, bool]:
    """Return the states to linearize at, and whether there is only one."""
    definition, arguments = problem.definition, CallArguments(problem)
    plan, p, state = problem.plan, problem.p, at
    is_user_state = at is not None and not isinstance(at, Equilibrium)
    if isinstance(at, Equilibrium):
        numbers = {**at.given, **at.constants, **at.specifieds}
        specifieds = {s: numbers[s] for s in definition.specifieds if s in numbers}
        constants = {s: numbers[s] for s in definition.constants if s in numbers}
        plan, p = arguments.plan(specifieds or None), arguments.constants(constants)
        state = at.state
    x, times, single = arguments.samples(state, t, "at")
    if is_user_state:  # in states of an Equilibrium, zeros may be rounding errors
        arguments.warn_of_states(x, "at")
    model = problem.model.with_compiled_inputs(plan, perturbed=True)
    r = plan.inputs.rows(x, times)
    point = EvaluationPoints(definition, model, times, x, r, p, plan)
    return with_unknowns(point, state, plan.inputs.rows), single


class _InputDerivatives:
    """Derivatives of blocks by some of the specifieds, the inputs, at m states.

    The inputs' indices among the specifieds are `columns` (k,).
    """

    def __init__(self, point: EvaluationPoints, columns: list[int]) -> None:
        self.point, self.columns = point, columns
        residuals = point.definition.equations.constraints.residuals
        # Of an Implicit: rows of the holonomic constraints, and columns of x.
        self._rows, self._unknowns = [*residuals.rows], [*residuals.columns]
        self._by_input = self._unknowns_by_input()

    def direct(self, block: str) -> np.ndarray:
        """Return the derivatives of a block with all states constant, shape (m, rows, k)."""
        model, num_specifieds = self.point.model, self.point.r.shape[1]
        if not self.columns:
            return np.zeros((len(self.point.x), len(getattr(model.assembly.blocks, block)), 0))
        by_specified = self.point.value(model.compiled_jacobian(block, "r"), num_specifieds)
        return by_specified[:, :, self.columns]

    def total(self, block: str) -> np.ndarray:
        """Return the derivatives of a block while the unknowns of an `Implicit` follow."""
        direct = self.direct(block)
        return self.with_unknowns(direct, self.point.slopes(block)) if self._unknowns else direct

    def with_unknowns(self, direct: np.ndarray, by_state: np.ndarray) -> np.ndarray:
        """Return total derivatives from `direct` ones and those `by_state`, shape (m, rows, n)."""
        if not self._unknowns:
            return direct
        with np.errstate(all="ignore"):  # `_check_finite` reports entries that are not finite
            total: np.ndarray = direct + by_state[:, :, self._unknowns] @ self._by_input
        return total

    def _unknowns_by_input(self) -> np.ndarray:
        """Return the derivatives of an Implicit's unknowns, shape (m, unknowns, k)."""
        if not (self._unknowns and self.columns):
            return np.zeros((len(self.point.x), len(self._unknowns), len(self.columns)))
        by_input = self.direct("holonomic")[:, self._rows]
        by_unknown = self.point.slopes("holonomic")[:, self._rows][:, :, self._unknowns]
        pairs = zip(by_unknown, by_input, strict=True)
        return np.array([-np.linalg.lstsq(matrix, right)[0] for matrix, right in pairs])

    def refuse_prescribed_motions(self, by_default: bool) -> None:
        """Raise an error if a constraint depends on an input; it names the other inputs.

        `by_default` is True if the user named no inputs.
        """
        parts = []
        for block in self.point.blocks if self.columns else ():
            depends = self.total(block) != 0.0
            if block == "holonomic":
                depends[:, self._rows] = False
            parts.append(depends.any(axis=0))
        if not any(part.any() for part in parts):
            return
        dependence = np.concatenate(parts)  # of constraints (rows) on inputs
        definition = self.point.definition
        inputs = np.array(unique_names(definition.specifieds))[self.columns]
        row = int(dependence.any(axis=1).argmax())
        prescribing = few([f"`{name}`" for name in inputs[dependence[row]]])
        others = inputs[~dependence.any(axis=0)].tolist()
        reason = "is an input because all are by default" if by_default else "is one of `inputs`"
        raise ValueError(
            f"The {constraint_names(definition.equations)[row]} depends on the specified "
            f"{prescribing}, which {reason}. It prescribes a motion: the states then do not follow "
            "from independent ones alone. The linear model has inputs that no constraint depends "
            f"on: `inputs={others}`."
        )


def _outputs(
    point: EvaluationPoints,
    outputs: Iterable[SymbolOrName] | None,
    T: np.ndarray,
    by_inputs: _InputDerivatives,
) -> tuple[np.ndarray, np.ndarray, tuple[str, ...]]:
    """Return C, D and the outputs' names, for states and outputs of the System."""
    definition = point.definition
    m, n = point.x.shape
    symbols = definition.states if outputs is None else one_or_more("outputs", outputs)
    rows = definition.variables.columns(symbols, "outputs").tolist()
    by_state = np.broadcast_to(np.eye(n), (m, n, n))
    by_input = np.zeros((m, n, len(by_inputs.columns)))
    if any(row >= n for row in rows):
        by_state = np.concatenate([by_state, point.slopes("outputs")], axis=1)
        by_input = np.concatenate([by_input, by_inputs.direct("outputs")], axis=1)
    by_state, by_input = by_state[:, rows], by_input[:, rows]
    with np.errstate(all="ignore"):  # `_check_finite` reports entries that are not finite
        C = by_state @ T
    D = by_inputs.with_unknowns(by_input, by_state)
    names = unique_names(definition.variables.symbols)
    return C, D, tuple(names[row] for row in rows)


def _warn_of_constant_derivatives(
    point: EvaluationPoints,
    columns: list[int],
    T: np.ndarray,
    free: np.ndarray,
    outputs: Iterable[SymbolOrName] | None,
) -> None:
    """Warn of derivatives of the inputs that change the rates or outputs and are no inputs.

    The equations contain the derivatives of a prescribed motion as specifieds of their own. The
    response to the motion is the sum of the responses to all of them.
    """
    definition = point.definition
    specifieds = list(definition.specifieds)
    inputs = {specifieds[k] for k in columns}
    missing = [
        specifieds.index(derivative)
        for derivative, lower in definition.lower_derivatives.items()
        if derivative not in inputs and not inputs.isdisjoint(lower)
    ]
    if not missing:
        return
    by_missing = _InputDerivatives(point, missing)
    effects = [by_missing.total("rates")[:, free], _outputs(point, outputs, T, by_missing)[1]]
    largest = np.abs(np.concatenate(effects, axis=1)).max(axis=(0, 1), initial=0.0)
    k = int(largest.argmax())
    if largest[k] > 0.0:
        derivative = specifieds[missing[k]]
        motion = {**definition.lower_derivatives}[derivative][0]
        warn_user(
            f"`inputs` has a motion without its derivative `{derivative}`, which the model holds "
            f"constant although it changes rates or outputs by up to {largest[k]:.3g} per unit: "
            f"the response to `{motion}` is incomplete. Pass the derivatives in `inputs` "
            "too, and sum the columns of the frequency response, that of the k-th derivative times "
            "(iω)^k."
        )


def _check_finite(parts: list[np.ndarray]) -> None:
    """Raise an error if matrices or rates, one for each state, are not finite."""
    m = len(parts[0])
    finite = np.all([np.isfinite(part.reshape(m, -1)).all(axis=1) for part in parts], axis=0)
    if not finite.all():
        raise ValueError(
            "The equations or their derivatives are not finite at "
            f"{_state_text(int(finite.argmin()), m)}: there is no linear model. "
            "`evaluate_ode` and `evaluate_jacobian` say where they are not."
        )


def _warn_of_violations(point: EvaluationPoints) -> bool:
    """Warn of the first state that violates the constraints; return whether one does."""
    violation = first_violation(point)
    if violation:
        k, message = violation
        warn_user(
            f"The linear model is one of motions that keep the constraints, but "
            f"{_state_text(k, len(point.x))} does not satisfy them. {message} Call "
            "`system.set_dependent_initial_conditions()` first, or take states of a motion "
            "that was integrated with `constraints='project'`."
        )
    return violation is not None


def _warn_of_motion(problem: Problem, point: EvaluationPoints) -> None:
    """Warn if the initial conditions are no equilibrium, unless the model is the same all along."""
    if departure := departure_that_changes_the_model(problem, point):
        name, value = departure
        warn_user(
            f"The initial conditions are no equilibrium: {name} is {value:.3g}, and the linear "
            "model changes along the motion. Pass the result of `find_equilibrium()` as `at`, or "
            "`at={}` if you want the model at this state."
        )


def _state_text(k: int, m: int) -> str:
    return f"state {k} of `at`" if m > 1 else "the state"
