"""Robots from URDF and MJCF files, as multibody systems in symbols."""

import lazy_loader

__getattr__, _, _ = lazy_loader.attach_stub(__name__, __file__)
__all__ = [
    "JointSymbols",
    "Place",
    "Robot",
    "TendonSymbols",
    "read",
]

__dir__ = __all__.copy  # the stub lists what other rooms take, too
