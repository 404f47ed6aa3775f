"""The solvers' loops in C, and the generated header with the layout of their arguments."""
