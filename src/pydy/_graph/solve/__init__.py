"""How linear systems inside a Program are solved: how their matrices are factorised."""
