"""Programs as C: the source, and the module that Cython makes of it."""
