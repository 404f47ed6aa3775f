"""Robots from URDF and MJCF files, as multibody systems in symbols."""

import lazy_loader

__getattr__, __dir__, _ = lazy_loader.attach_stub(__name__, __file__)
__all__ = [
    "JointSymbols",
    "Place",
    "Robot",
    "TendonSymbols",
    "read",
]
