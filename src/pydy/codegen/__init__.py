"""Numerical functions from symbolic equations."""
