"""Thresholds of the judges, each with its reason."""

TYPED = 8 * 0.5e-4
"""How far from a rotation the matrix of a quaternion may be, which has no unit.

Four numbers rounded to four decimals, such as 0.7071, move q·q by at most 2·Σ|q|·0.00005 = 0.0002,
and its square, which the entries are off by, by twice that.
"""
