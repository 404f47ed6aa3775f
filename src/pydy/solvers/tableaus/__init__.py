"""Runge–Kutta methods as data, each with its source."""
