"""Equations as named blocks of one graph, from which Programs are lowered."""
