"""Profiles of roads along a line: random ones by ISO 8608, and measured ones."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from pydy._checks import choice, integer, number, positive, real_array, shown
from pydy._rank import OF_FEW, ROUNDED
from pydy.vehicles.algebra import Quantity, checked_quantity, is_symbolic
from pydy.vehicles.tuning import COARSEST_DIGIT, UNEVEN_SPACING

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

# ISO 8608: geometric mean of the displacement PSD at 0.1 cycles/m, which rises fourfold by class.
_ROUGHNESS = {name: 16 * 4.0**k / 10**6 for k, name in enumerate("ABCDEFGH")}
_REFERENCE = 0.1  # n₀ (cycles/m)
_MOST_WAVES = 2**20
_LONGEST = 100.0  # wavelength (m)


@dataclass(frozen=True, eq=False)
class RoadProfile:
    """Height of a road along a line, a straight line and a sum of waves.

    It is ``z(x) = offset + gradient x + Σ aₖ cos(2π nₖ x + φₖ)``, smooth, and the same for numbers,
    arrays and SymPy expressions.

    Attributes
    ----------
    frequencies, amplitudes, phases : ndarray, shape (k,)
        nₖ (cycles/m), aₖ (m) and φₖ (rad).
    offset, gradient : float
        Of the straight line (m, and without unit). A plane at this height stays horizontal: only a
        `RoadSurface` of it has the force of a grade on a car.

    Examples
    --------
    >>> import sympy as sm
    >>> from pydy.vehicles import RoadProfile
    >>> bumps = RoadProfile.from_samples([0.0, 1.0, 2.0, 3.0, 4.0], [0.0, 0.1, 0.0, -0.1, 0.0])
    >>> bumps.height([0.0, 1.0, 1.5]).round(4)
    array([0.    , 0.1   , 0.0707])
    >>> bumps.height(sm.Symbol('x')).n(3)
    0.1*cos(1.5707963267949*x - 1.5707963267949)
    """

    frequencies: np.ndarray
    amplitudes: np.ndarray
    phases: np.ndarray
    offset: float = 0.0
    gradient: float = 0.0

    def __post_init__(self) -> None:
        shape = (None,)
        for name in ("frequencies", "amplitudes", "phases"):
            values = np.array(real_array(getattr(self, name), f"`{name}`"))
            if values.ndim != 1 or not np.isfinite(values).all():
                raise ValueError(
                    f"`{name}` must be one-dimensional and finite, got {shown(values.tolist())}."
                )
            if shape not in ((None,), values.shape):
                raise ValueError(
                    f"`{name}` must have as many values as `frequencies`, {shape[0]}, got "
                    f"{len(values)}."
                )
            shape = values.shape
            values.flags.writeable = False
            object.__setattr__(self, name, values)
        for name in ("offset", "gradient"):
            object.__setattr__(self, name, number(getattr(self, name), f"`{name}`", finite=True))

    def __repr__(self) -> str:
        return f"<RoadProfile of {len(self.frequencies)} waves, RMS {self.rms:.3g} m>"

    @classmethod
    def from_samples(cls, x: ArrayLike, heights: ArrayLike) -> Self:
        """Return the profile that passes through evenly spaced samples.

        Between the samples it is their trigonometric interpolation, after the straight line from
        the first to the last one is subtracted; beyond them it goes on periodically.

        Parameters
        ----------
        x : array_like, shape (m,)
            Places (m), ascending and evenly spaced, to the last of their decimals, at least three.
        heights : array_like, shape (m,)
            z (m).

        Returns
        -------
        RoadProfile
        """
        places, z = real_array(x, "`x`"), real_array(heights, "`heights`")
        if places.ndim != 1 or len(places) < 3 or not np.isfinite(places).all():
            raise ValueError(f"`x` must hold at least three numbers, got {shown(x)}.")
        if z.shape != places.shape or not np.isfinite(z).all():
            raise ValueError(
                f"`heights` must hold as many finite numbers as `x`, {len(places)}, got "
                f"{shown(heights)}."
            )
        count, length = len(places) - 1, places[-1] - places[0]
        if not _are_even(places):
            raise ValueError(
                f"`x` must be ascending and evenly spaced, got {shown(x)}. Interpolate the heights "
                "at even places first."
            )
        gradient = (z[-1] - z[0]) / length
        waves = np.fft.rfft((z - np.linspace(z[0], z[-1], count + 1))[:-1]) / count
        frequencies = np.arange(len(waves)) / length
        amplitudes = np.abs(waves)
        amplitudes[1 : (count + 1) // 2] *= 2.0  # all but the Nyquist frequency
        phases = np.angle(waves) - 2 * pi * frequencies * places[0]
        used = np.flatnonzero(amplitudes > np.finfo(float).eps * np.abs(z).max())
        mean = float(waves[0].real)
        used = used[used > 0]
        offset = float(z[0] - gradient * places[0]) + mean
        return cls(frequencies[used], amplitudes[used], phases[used], offset, float(gradient))

    @property
    def rms(self) -> float:
        """Root mean square of the waves (m)."""
        return float(np.sqrt(np.sum(self.amplitudes**2) / 2))

    def height(self, x: Quantity) -> Quantity:
        """Return z (m) at places.

        Parameters
        ----------
        x : number, array or expression
            Along the road (m); an expression such as ``20*t`` for a road that passes below.

        Returns
        -------
        number, array or expression
        """
        return self._sum(x, self.amplitudes, self.phases, lambda x: self.offset + self.gradient * x)

    def slope(self, x: Quantity) -> Quantity:
        """Return dz/dx at places.

        Parameters
        ----------
        x : number, array or expression
            As for `height`.

        Returns
        -------
        number, array or expression
        """
        steepness = 2 * pi * self.frequencies * self.amplitudes
        return self._sum(x, steepness, self.phases + pi / 2, lambda x: self.gradient + 0 * x)

    def _sum(self, x: Any, sizes: np.ndarray, phases: np.ndarray, line: Any) -> Any:
        place = checked_quantity(x, "`x`")
        rows = zip(
            sizes.tolist(), (2 * pi * self.frequencies).tolist(), phases.tolist(), strict=True
        )
        if is_symbolic(place):
            import sympy as sm

            return sm.Add(line(place), *(a * sm.cos(n * place + phase) for a, n, phase in rows))
        total = line(place)
        for a, n, phase in rows:
            total = total + a * np.cos(n * place + phase)
        return total if isinstance(place, np.ndarray) else float(total)


def _are_even(places: np.ndarray) -> bool:
    """Return whether places ascend evenly, or are even ones that were rounded to decimals."""
    length = places[-1] - places[0]
    spacing = length / (len(places) - 1)
    if not spacing > 0.0:
        return False
    allowed = UNEVEN_SPACING * spacing
    digits = (
        10.0**-n
        for n in range(16)
        if (np.abs(places - np.round(places, n)) <= OF_FEW * np.abs(places)).all()
    )
    digit = next(digits, 0.0)  # the last one
    if digit <= COARSEST_DIGIT * spacing:
        # Half of it is lost at a sample, and another half at the ends.
        allowed = max(allowed, digit * (1 + ROUNDED))
    even = places[0] + spacing * np.arange(len(places))
    return bool(np.abs(places - even).max() <= allowed)


def iso_road(
    road_class: str,
    length: float,
    *,
    longest: float | None = None,
    shortest: float = 0.5,
    seed: int | None = None,
) -> RoadProfile:
    """Return a random road profile of a class of ISO 8608.

    Its displacement PSD is ``G_d(n) = G_d(n₀) (n/n₀)⁻²`` with n₀ = 0.1 cycles/m, between the
    longest and the shortest wave. The waves have frequencies k/length and random phases: the
    profile repeats itself after the length. Each has the power of the band about its frequency, so
    that the RMS is n₀ √(G_d(n₀) (longest − shortest)).

    Parameters
    ----------
    road_class : {'A', 'B', 'C', 'D', 'E', 'F', 'G', 'H'}
        From very good to very poor: G_d(n₀) is the geometric mean of the class, 16 · 10⁻⁶ m³ for A
        and four times that of the class before for each other.
    length : float
        Of the road (m), not below `longest`, and above `shortest`.
    longest, shortest : float, optional
        Wavelengths (m). By default the longest is 100 m, or the length of a road that is shorter.
        The standard reports up to 1/0.011 m and down to 1/2.83 m; waves that are
        shorter than the contact patch do not move a wheel. There are length/shortest waves or
        fewer; each is a term of an expression.
    seed : int, optional
        Of the random phases.

    Returns
    -------
    RoadProfile

    References
    ----------
    ISO 8608:2016, Mechanical vibration – Road surface profiles – Reporting of measured data.

    M. Agostinacchio, D. Ciampa, S. Olita, The vibrations induced by surface irregularities in road
    pavements – a Matlab approach, European Transport Research Review 6(3), 2014, pp. 267–275.

    Examples
    --------
    >>> from pydy.vehicles import iso_road
    >>> iso_road('C', 200.0, seed=1)
    <RoadProfile of 399 waves, RMS 0.016 m>
    """
    roughness = _ROUGHNESS[choice(road_class, tuple(_ROUGHNESS), "`road_class`")]
    total = positive(length, "`length`", finite=True)
    short = positive(shortest, "`shortest`", finite=True)
    long = min(_LONGEST, total)
    if longest is not None:
        long = positive(longest, "`longest`", finite=True)
    if not short < long <= total:
        raise ValueError(
            f"`longest` must be above `shortest` and not above `length`, got {long:g}, {short:g} "
            f"and {total:g}."
        )
    if total / short > _MOST_WAVES:
        raise ValueError(
            f"`length` must be at most {_MOST_WAVES} times `shortest`, got {total:g} and "
            f"{short:g}: each wave is a term of the profile."
        )
    first, last = np.floor(total / long + 0.5), np.ceil(total / short - 0.5)
    waves = np.arange(first, max(first, last) + 1.0)  # one, if rounding passes a half
    edges = np.clip(np.append(waves - 0.5, waves[-1] + 0.5) / total, 1 / long, 1 / short)
    power = roughness * _REFERENCE**2 * -np.diff(1 / edges)  # the integral of the PSD
    phases = np.random.default_rng(_seed(seed)).uniform(0.0, 2 * pi, len(waves))
    return RoadProfile(waves / total, np.sqrt(2 * np.maximum(power, 0.0)), phases)


def _seed(seed: object) -> int | None:
    return None if seed is None else integer(seed, "`seed`", least=0)
