from .assemble import (
    JointSymbols as JointSymbols,
    Place as Place,
    TendonSymbols as TendonSymbols,
)
from .robot import Robot as Robot, read as read
