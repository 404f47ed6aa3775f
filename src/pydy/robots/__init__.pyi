from .assemble import (
    JointSymbols as JointSymbols,
    LinkFrame as LinkFrame,
    TendonSymbols as TendonSymbols,
)
from .robot import Robot as Robot, read as read
