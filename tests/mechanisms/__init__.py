"""Random mechanisms against an oracle that shares no code with the package.

A seed gives a mechanism as plain data (`generate`), made of what `parts` lists. `build` says it in
SymPy for each front end, `oracle` computes what it does in numbers of 80 bits, `check` compares
every public answer, `shrink` finds the smallest part of a mechanism that still disagrees.
"""
