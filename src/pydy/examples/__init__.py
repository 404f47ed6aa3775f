"""Worked examples: real mechanisms, derived in the open and checked against published numbers."""
