from .integration import integrate_ensemble as integrate_ensemble
