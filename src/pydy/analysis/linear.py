"""Linear models of the motions that satisfy the constraints.

Of the states that satisfy the constraints c(x) = 0 some can be chosen as independent. With the
Jacobian J of c every small motion on the constraints is δx = T δz with J T = 0, where the rows of T
that belong to the independent states z are those of the identity. From δx' = A δx + B δr these rows
give δz' = (A T) δz + B δr, at an equilibrium and along any motion, since they are constant (D. L.
Peterson, G. Gede and M. Hubbard, "Symbolic linearization of equations of motion of constrained
multibody systems", Multibody System Dynamics 33 (2015) 143-161).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from pydy._checks import choice, real_array
from pydy._names import some
from pydy._optional import require
from pydy.analysis.tuning import CROSSED
from pydy.plot import axes_of, rows_of_axes, typeset


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
        names = (f"{kind}: {some(own) or 'none'}" for kind, own in kinds)
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
        ax, found = complex_plane(axes), self.eigenvalues
        ax.axhline(0.0, color="0.7", linewidth=0.8)
        colours: dict[str, Any] = {"color": "C0"}
        if found.ndim == 2:
            colours = {"c": np.broadcast_to(np.arange(len(found))[:, None], found.shape)}
        ax.scatter(found.real, found.imag, marker="x", **colours)
        return ax

    def to_state_space(self) -> Any:
        """Return the model as a `scipy.signal.StateSpace`."""
        from scipy.signal import StateSpace

        return StateSpace(*self._one("to_state_space"))

    def to_control(self) -> Any:
        """Return the model as a ``control.StateSpace`` of python-control, with its names."""
        control = require("control", "control", "to_control()")
        names = {"states": self.states, "inputs": self.inputs, "outputs": self.outputs}
        return control.ss(
            *self._one("to_control"), **{kind: list(given) for kind, given in names.items()}
        )

    def frequency_response(self, frequencies: Any) -> np.ndarray:
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
        A, B, C, D = self._one("frequency_response")
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
        frequencies: Any = None,
        axes: Any = None,
        *,
        unit: str = "rad/s",
    ) -> Any:
        """Plot magnitude and phase of the response of one output to one input.

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
            sizes = np.abs(np.linalg.eigvals(self._one("plot_bode")[0]))
            sizes = sizes[sizes > CROSSED * sizes.max(initial=0.0)]
            low, high = (sizes.min(), sizes.max()) if sizes.size else (1.0, 1.0)
            frequencies = np.geomspace(0.1 * low, 10.0 * high, num=400)
        frequencies = real_array(frequencies, "`frequencies`")
        response = self.frequency_response(frequencies)[:, i, j]
        if (frequencies < 0.0).any():
            raise ValueError(
                f"`frequencies` must not be negative, got {frequencies.min():g} rad/s: the axis is "
                "logarithmic."
            )
        axes, (magnitude, phase) = rows_of_axes(axes, 2, "of magnitude and phase")
        title = f"{typeset(input, '')} → {typeset(output, '')}"
        across = frequencies / (2.0 * np.pi) if unit == "Hz" else frequencies
        with np.errstate(divide="ignore"):
            magnitude.semilogx(across, 20.0 * np.log10(np.abs(response)), label=title)
        phase.semilogx(across, np.degrees(np.unwrap(np.angle(response))), label=title)
        for ax in (magnitude, phase):
            ax.grid(which="both", alpha=0.3)
        magnitude.set_ylabel("magnitude (dB)")
        phase.set_ylabel("phase (°)")
        phase.set_xlabel(f"frequency ({unit})")
        magnitude.legend()
        return axes

    def _one(self, what: str) -> tuple[np.ndarray, ...]:
        if self.A.ndim != 2:
            raise ValueError(
                f"{what}() needs a single linear model, but there are {len(self.A)}, one for each "
                "state in `at`. Linearize at one state."
            )
        return self.A, self.B, self.C, self.D


def complex_plane(ax: Any) -> Any:
    """Return Axes for eigenvalues, with the imaginary axis."""
    ax = axes_of(ax, "a plot")
    ax.axvline(0.0, color="0.7", linewidth=0.8)
    ax.set_xlabel("real part (1/s)")
    ax.set_ylabel("imaginary part (1/s)")
    return ax
