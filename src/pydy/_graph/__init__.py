"""The expression graph: built once from SymPy, then simplified, differentiated and lowered.

Import the module you need; this file imports nothing, so that a worker process which only runs
compiled code never loads SymPy.
"""
