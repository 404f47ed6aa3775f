"""The expression graph: built once from SymPy, then simplified, differentiated and lowered.

The stub beside this file is the door: it lists what other rooms take. Nothing is imported before it
is used, so that a worker process which only runs compiled code never loads SymPy.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
