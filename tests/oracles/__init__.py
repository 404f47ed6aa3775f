"""What results are compared with: independent evaluations, laws, bounds and published problems.

- `oracle`: the equations of a KanesMethod, evaluated with 30 digits by SymPy and mpmath alone.
- `newton`: Newton's and Euler's laws along a motion.
- `rounding`: running bounds of rounding errors, which tolerances of bits and digits follow from.
- `solver_problems`, `optima`: published problems with exact answers, for solvers and collocation.
- `departures`: the table of motions that start on an event's surface, for every implementation.
"""
