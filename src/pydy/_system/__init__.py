"""The parts of `pydy.system.System`: checks, definition, evaluation, dependent states."""
