"""Programs: what a graph is lowered to, and what runs it: operations, listings, the interpreter.

Whoever compiles, exports or evaluates a Program takes its names from here, workers of ensembles
too: nothing here knows graphs or SymPy. The stub beside this file lists what other rooms take.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
