"""Linear models of the motions that satisfy the constraints.

Of the states that satisfy the constraints c(x) = 0 some can be chosen as independent. With the
Jacobian J of c every small motion on the constraints is δx = T δz with J T = 0, where the rows of T
that belong to the independent states z are those of the identity. From δx' = A δx + B δr these rows
give δz' = (A T) δz + B δr, at an equilibrium and along any motion, since they are constant (D. L.
Peterson, G. Gede and M. Hubbard, "Symbolic linearization of equations of motion of constrained
multibody systems", Multibody System Dynamics 33 (2015) 143-161).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pydy._assembly import Definition, errors_of
from pydy._checks import SymbolIndex, choice, listed, real_array
from pydy._errors import warn_user
from pydy._judges import (
    first_violation,
    warn_of_kinks,
    warn_of_missing_derivatives,
    warn_of_protected_states,
)
from pydy._motion import constraint_names
from pydy._names import few, some, unique_names
from pydy._optional import require
from pydy._problem import (
    AssumptionChecks,
    CallArguments,
    Problem,
    read_samples,
    with_unknowns,
)
from pydy._rank import ROUNDED
from pydy._states import EvaluationPoints
from pydy.analysis.equilibria import Equilibrium
from pydy.analysis.tuning import ZERO_REAL_PART
from pydy.analysis.unsteadiness import departure_that_changes_the_model
from pydy.plot import axes_of, rows_of_axes, typeset

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
        kinds = (("states", self.states), ("inputs", self.inputs), ("outputs", self.outputs))
        names = (f"{kind}: {some(members) or 'none'}" for kind, members in kinds)
        if self.A.ndim == 3:
            values = f"{len(self.A)} models"
        else:
            poles = [
                f"{v.real:.4g}" + (f" +- {v.imag:.4g}j" if v.imag else "")
                for v in self.eigenvalues
                if v.imag >= 0.0
            ]
            values = f"eigenvalues (1/s): {some(poles)}"
        return f"LinearModel with {'; '.join((*names, values))}"

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
        names = {"states": self.states, "inputs": self.inputs, "outputs": self.outputs}
        return control.ss(
            *self._single_model("to_control"),
            **{kind: list(members) for kind, members in names.items()},
        )

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
            In rad/s, whatever the axis shows; by default from a tenth of the slowest eigenvalue to
            ten times the fastest.
        axes : pair of matplotlib Axes, optional
        unit : {'rad/s', 'Hz'}
            Of the axis of frequencies, which says it.

        Returns
        -------
        pair of matplotlib Axes
        """
        unit = choice(unit, ("rad/s", "Hz"), "`unit`")
        j = self.inputs.index(choice(input, self.inputs, "`input`"))
        i = self.outputs.index(choice(output, self.outputs, "`output`"))
        if frequencies is None:
            sizes = np.abs(np.linalg.eigvals(self._single_model("plot_bode")[0]))
            sizes = sizes[sizes > ZERO_REAL_PART * sizes.max(initial=0.0)]
            low, high = (sizes.min(), sizes.max()) if sizes.size else (1.0, 1.0)
            frequencies = np.geomspace(0.1 * low, 10.0 * high, num=400)
        frequencies = real_array(frequencies, "`frequencies`")
        response = self.frequency_response(frequencies)[:, i, j]
        if (frequencies < 0.0).any():
            raise ValueError(
                f"`frequencies` must not be negative, got {frequencies.min():g} rad/s: the axis is "
                "logarithmic."
            )
        axes, (magnitude_ax, phase_ax) = rows_of_axes(axes, 2, "of magnitude and phase")
        title = f"{typeset(input, '')} → {typeset(output, '')}"
        across = frequencies / (2.0 * np.pi) if unit == "Hz" else frequencies
        with np.errstate(divide="ignore"):
            magnitude = 20.0 * np.log10(np.abs(response))
        phase = np.degrees(np.unwrap(np.angle(response)))
        magnitude_ax.semilogx(across, magnitude, label=title)
        phase_ax.semilogx(across, phase, label=title)
        for ax in (magnitude_ax, phase_ax):
            ax.grid(which="both", alpha=0.3)
        magnitude_ax.set_ylabel("magnitude (dB)")
        phase_ax.set_ylabel("phase (°)")
        phase_ax.set_xlabel(f"frequency ({unit})")
        magnitude_ax.legend()
        return axes

    def _single_model(self, method: str) -> tuple[np.ndarray, ...]:
        if self.A.ndim != 2:
            raise ValueError(
                f"{method}() needs a single linear model, but there are {len(self.A)}, one for "
                "each state in `at`. Linearize at one state."
            )
        return self.A, self.B, self.C, self.D


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
    inputs: Iterable[SymbolOrName] | None = None,
    outputs: Iterable[SymbolOrName] | None = None,
) -> LinearModel:
    """Return the linear model of a Problem; see `System.linearize`."""
    warn_of_missing_derivatives(problem)
    definition = problem.definition
    n, s = len(definition.states), len(definition.specifieds)
    plan, p, arguments = problem.plan, problem.p, CallArguments(problem)
    is_user_state = at is not None and not isinstance(at, Equilibrium)
    if isinstance(at, Equilibrium):
        fixed_values = {**at.given, **at.constants, **at.specifieds}
        kinds = ("specifieds", "constants")
        r, c = (
            {s: fixed_values[s] for s in getattr(definition, k) if s in fixed_values} for k in kinds
        )
        plan, p, at = arguments.plan(r or None), arguments.constants(c), at.state
    times = problem.settings.times
    user_t = t
    x, t, single = read_samples(arguments.states(at, "at"), t, lambda: problem.x, times, n, "at")
    model = problem.model.with_compiled_inputs(plan, perturbed=True)
    if is_user_state:  # in states of an Equilibrium, zeros may be rounding errors
        AssumptionChecks(problem).columns("states", x, "`at` for ", allowed=errors_of(x, ROUNDED))
    point = EvaluationPoints(definition, model, t, x, plan.inputs.rows(x, t), p, plan)
    point = with_unknowns(point, at, plan.inputs.rows)
    value, slopes, blocks = point.value, point.slopes, point.blocks
    T, free = point.tangents()
    if definition.equations.constraints.are_present:
        _warn_of_violations(point)
    A = point.directional("rates", T)[:, free]
    symbols = definition.specifieds if inputs is None else listed("inputs", inputs)
    columns = definition.places["specifieds"].columns(symbols, "inputs").tolist()
    kernel = model.compiled_jacobian("rates", "r") if columns else None
    by_input = np.zeros((len(x), n, s)) if kernel is None else value(kernel, s)
    residuals = definition.equations.constraints.residuals
    unknowns_by_input, unknowns = _unknowns_by_inputs(point, columns), [*residuals.columns]

    def with_implicit_unknowns(block: str, by_input: np.ndarray) -> np.ndarray:
        """Return total derivatives by inputs, including those through an Implicit's unknowns."""
        return (
            by_input + slopes(block)[:, :, unknowns] @ unknowns_by_input
            if unknowns_by_input.size
            else by_input
        )

    dependence = []  # which constraints (rows) depend on which inputs
    for block in blocks if columns else ():
        by_block = value(model.compiled_jacobian(block, "r"), s)[:, :, columns]
        total = with_implicit_unknowns(block, by_block)
        if block == "holonomic":
            total[:, residuals.rows] = 0.0
        dependence.append(total.any(axis=0))
    if any(rows.any() for rows in dependence):
        _refuse_prescribed(definition, np.concatenate(dependence), columns, inputs is None)
    with np.errstate(all="ignore"):  # `_check_finite` reports entries that are not finite
        B = with_implicit_unknowns("rates", by_input[:, :, columns])[:, free]
    C, D, titles = _outputs(problem, outputs, point, T, columns, unknowns_by_input)
    parts = [A, B, C, D, value(model.compiled("rates"))[:, free]]
    _check_finite(parts)
    if at is None and user_t is None:
        _warn_of_motion(problem, point)
    warn_of_kinks(point, T, free, columns)
    warn_of_protected_states(point, T, free, A)
    A, B, C, D, rates = (part[0] if single else part for part in parts)
    return LinearModel(
        A, B, C, D,
        tuple(np.array(unique_names(definition.states))[free].tolist()),
        tuple(np.array(unique_names(definition.specifieds))[columns].tolist()),
        titles, rates,
    )  # fmt: skip


def _refuse_prescribed(
    definition: Definition, dependence: np.ndarray, columns: list[int], by_default: bool
) -> None:
    """Raise an error for inputs that prescribe motions; it names the other inputs.

    `dependence` (constraints, inputs) is True where a constraint depends on an input. `columns` are
    the inputs' indices among the specifieds; `by_default` is True if the user named none.
    """
    row = int(dependence.any(axis=1).argmax())
    titles = [unique_names(definition.specifieds)[column] for column in columns]
    names = few(
        [f"`{title}`" for title, depends in zip(titles, dependence[row], strict=True) if depends]
    )
    used = set(np.flatnonzero(dependence.any(axis=0)))
    free = [title for k, title in enumerate(titles) if k not in used]
    raise ValueError(
        f"The {constraint_names(definition.equations)[row]} depends on the specified {names}, "
        "which "
        f"{'is an input because all are by default' if by_default else 'is one of `inputs`'}. It "
        "prescribes a motion: the states then do not follow from independent ones alone. The "
        f"linear model has inputs that no constraint depends on: `inputs={free}`."
    )


def _state_text(k: int, m: int) -> str:
    return f"state {k} of `at`" if m > 1 else "the state"


def _warn_of_violations(at: EvaluationPoints) -> None:
    """Warn of the first state of `at` that violates the constraints."""
    if violation := first_violation(at):
        k, message = violation
        warn_user(
            f"The linear model is one of motions that keep the constraints, but "
            f"{_state_text(k, len(at.x))} does not satisfy them. {message} Call "
            "`system.set_dependent_initial_conditions()` first, or take states of a motion "
            "that was integrated with `constraints='project'`."
        )


def _warn_of_motion(problem: Problem, point: EvaluationPoints) -> None:
    """Warn if the initial conditions are no equilibrium, unless the model is the same all along."""
    if departure := departure_that_changes_the_model(problem, point):
        name, value = departure
        warn_user(
            f"The initial conditions are no equilibrium: {name} is {value:.3g}, and the linear "
            "model changes along the motion. Pass the result of `find_equilibrium()` as `at`, or "
            "`at={}` if you want the model at this state."
        )


def _outputs(
    problem: Problem,
    outputs: Iterable[SymbolOrName] | None,
    point: EvaluationPoints,
    T: np.ndarray,
    columns: list[int],
    unknowns_by_input: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, tuple[str, ...]]:
    """Return C, D and the outputs' names, for states and outputs of the System."""
    definition = problem.definition
    m, n, s = len(T), len(definition.states), len(definition.specifieds)
    symbols = definition.states if outputs is None else listed("outputs", outputs)
    index = SymbolIndex([*definition.states, *definition.outputs.symbols], "states and outputs")
    rows = index.columns(symbols, "outputs").tolist()
    by_state = np.broadcast_to(np.eye(n), (m, n, n))
    by_input = np.zeros((m, n, s))
    if any(row >= n for row in rows):
        width = len(definition.outputs.symbols)
        by_state = np.concatenate([by_state, point.slopes("outputs")], axis=1)
        inputs = np.zeros((m, width, 0))
        if s:
            inputs = point.value(point.model.compiled_jacobian("outputs", "r"), s)
        by_input = np.concatenate([by_input, inputs], axis=1)
    with np.errstate(all="ignore"):  # `_check_finite` reports entries that are not finite
        C = by_state[:, rows] @ T
        D = by_input[:, rows][:, :, columns]
        if unknowns_by_input.size:
            unknowns = definition.equations.constraints.residuals.columns
            D = D + by_state[:, rows][:, :, unknowns] @ unknowns_by_input
    titles = unique_names([*definition.states, *definition.outputs.symbols])
    return C, D, tuple(titles[row] for row in rows)


def _unknowns_by_inputs(point: EvaluationPoints, columns: list[int]) -> np.ndarray:
    """Return derivatives of an Implicit's unknowns by some specifieds, (m, unknowns, k)."""
    residuals = point.definition.equations.constraints.residuals
    rows, unknowns = [*residuals.rows], [*residuals.columns]
    if not (unknowns and columns):
        return np.zeros((len(point.x), len(unknowns), len(columns)))
    by_input = point.value(point.model.compiled_jacobian("holonomic", "r"), point.r.shape[1])
    gradient = point.slopes("holonomic")[:, rows][:, :, unknowns]
    pairs = zip(gradient, by_input[:, rows][:, :, columns], strict=True)
    return np.array(
        [-np.linalg.lstsq(jacobian, input_slopes)[0] for jacobian, input_slopes in pairs]
    )


def _check_finite(parts: list[np.ndarray]) -> None:
    """Raise an error if matrices or rates, one for each state, are not finite."""
    m = len(parts[0])
    sound = [np.isfinite(part.reshape(m, -1)).all(axis=1) for part in parts]
    if not np.all(sound):
        raise ValueError(
            "The equations or their derivatives are not finite at "
            f"{_state_text(int(np.all(sound, axis=0).argmin()), m)}: there is no linear model. "
            "`evaluate_ode` and `evaluate_jacobian` say where they are not."
        )
