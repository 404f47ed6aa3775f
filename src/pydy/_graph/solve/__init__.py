"""Linear systems inside a Program: their unknowns, and how their matrices are factorised."""
