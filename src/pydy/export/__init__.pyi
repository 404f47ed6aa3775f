from .javascript import javascript_object as javascript_object
from .model import (
    PARTS as PARTS,
    EventData as EventData,
    Exported as Exported,
    Model as Model,
    Variable as Variable,
    identifiers as identifiers,
    with_inputs as with_inputs,
)
from .writing import check_options as check_options, solves as solves, write as write
