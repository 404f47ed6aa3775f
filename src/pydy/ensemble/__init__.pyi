from .integration import integrate_ensemble as integrate_ensemble
from .samples import after_end as after_end
