"""A run seen from Python: its problem, arrays, options, callbacks and interrupts."""
