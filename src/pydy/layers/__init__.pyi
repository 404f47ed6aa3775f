from .functions import LayerFunctions as LayerFunctions
from .layer import Layer as Layer
from .of_jax import JaxArrays as JaxArrays
from .of_torch import TorchArrays as TorchArrays
