"""Arithmetic modulo a prime, to evaluate expressions at random points without rounding.

Rational expressions that agree at a random point are identical, except with a probability of about
their degree divided by 2⁶¹ (J. T. Schwartz, "Fast probabilistic algorithms for verification of
polynomial identities", Journal of the ACM 27 (1980) 701-717).
"""

from __future__ import annotations

import hashlib
from functools import lru_cache

# Floats are integers times powers of two. With p = 2 q + 1 and a prime q, the powers of two have
# the period q. Since p = 3 (mod 4), −1 is not a square and 1 + x² is never zero.
PRIME = 2**61 - 2373


def arbitrary(*seeds: object) -> int:
    """Return a pseudo-random number below the prime that depends only on the arguments."""
    digest = hashlib.blake2b(repr(seeds).encode(), digest_size=8).digest()
    return int.from_bytes(digest, "big") % PRIME


def residue(number: float) -> int:
    """Return a float modulo the prime."""
    if number != number or number in (float("inf"), float("-inf")):
        return arbitrary("const", number)
    top, bottom = number.as_integer_ratio()
    return top * pow(bottom, -1, PRIME) % PRIME


@lru_cache(maxsize=1024)  # sine and cosine of an angle are usually requested together
def _on_circle(angle: int) -> tuple[int, int]:
    """Return a pseudo-random point on the unit circle for each angle: its sine and cosine."""
    half = arbitrary("angle", angle)
    scale = pow(1 + half * half, -1, PRIME)
    return 2 * half * scale % PRIME, (1 - half * half) * scale % PRIME


def sine(angle: int) -> int:
    """Return the sine of an angle."""
    return _on_circle(angle)[0]


def cosine(angle: int) -> int:
    """Return the cosine of an angle."""
    return _on_circle(angle)[1]


def inverse(matrix: list[list[int]]) -> list[list[int]] | None:
    """Return the inverse of a matrix, or None for a singular one."""
    n = len(matrix)
    rows = [[*row, *(int(i == k) for k in range(n))] for i, row in enumerate(matrix)]
    for k in range(n):
        pivot = next((i for i in range(k, n) if rows[i][k]), None)
        if pivot is None:
            return None
        rows[k], rows[pivot] = rows[pivot], rows[k]
        scale = pow(rows[k][k], -1, PRIME)
        rows[k] = scaled = [value * scale % PRIME for value in rows[k]]
        for i in range(n):
            factor = rows[i][k]
            if i != k and factor:
                rows[i] = [(a - factor * b) % PRIME for a, b in zip(rows[i], scaled, strict=True)]
    return [row[n:] for row in rows]
