"""The solvers' loops in C, and the header that says what Python hands them."""
