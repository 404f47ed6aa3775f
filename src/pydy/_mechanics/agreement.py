"""Whether equations that a method derived may be replaced by those formed from its bodies.

They may where both give the same numbers at random states that keep the constraints and hold the
same symbols. What decides is logged.
"""

from __future__ import annotations

import logging

import numpy as np

from pydy._graph.collector import collector_paused
from pydy._graph.interpret import evaluator
from pydy._mechanics.choice import chosen
from pydy._mechanics.equations import Equations
from pydy._mechanics.form import Formed
from pydy._mechanics.generic import GenericStates, evaluator_of
from pydy._mechanics.reader import Multibody
from pydy._mechanics.tuning import AGREEING, CANCELLED

__all__ = ["formed_alike"]

_LOG = logging.getLogger("pydy")
_STATES = 2


@collector_paused()
def formed_alike(equations: Equations, body: Multibody) -> Formed | None:
    """Return the formed equations of motion, or None where those of the method hold.

    Parameters
    ----------
    equations : Equations
        With the method's mass matrix and forcing.
    body : Multibody
    """
    why = _unfit(equations, body)
    if not why:
        try:
            formed = chosen(body)
        except (ValueError, TypeError, NotImplementedError) as error:
            why = str(error)
        else:
            own = set(formed.symbols(equations.speed_rates))
            if more := [s for s in own if s not in equations.symbols]:
                why = f"they hold {more[0]}, which the method's do not"
            elif not _agree(equations, formed):
                why = "they give other numbers: a velocity or a load differs"
    if not why:
        return formed
    _LOG.info("The equations of the method are used, not those formed from its bodies: %s.", why)
    return None


def _unfit(equations: Equations, body: Multibody) -> str:
    if not body.bodies:
        return "it holds no bodies"
    if any(rate in equations.symbols for rate in equations.speed_rates):
        return "loads depend on accelerations"
    return ""


def _agree(equations: Equations, formed: Formed) -> bool:
    """Return whether both give the same accelerations.

    With those of the one, M u' − F of the other must vanish: u' itself is less accurate where M is
    nearly singular.
    """
    n = len(equations.speeds)
    written = [*equations.mass_matrix, *equations.forcing]
    symbols = [*formed.constants, *formed.specifieds]
    states = GenericStates(equations, [*written, *symbols], "the equations of motion")
    inputs = states.consistent(_STATES)
    block = "equations", (n * (n + 1),), states.read.all(written)
    theirs = evaluator_of(states.graph, [block])(*inputs)["equations"]
    numbers = states.by_symbol(inputs)
    own = formed.input_symbols(equations.time, (*equations.coordinates, *equations.speeds))
    nodes = [*(e for row in formed.matrix for e in row), *formed.forcing]
    values_at = evaluator(formed.graph, nodes)
    ours = values_at({node: numbers[symbol] for node, symbol in own.items()}, _STATES)
    finite = np.isfinite(theirs).all(axis=1) & np.isfinite(ours).all(axis=1)
    pairs = zip(theirs[finite], ours[finite], strict=True)
    return bool(finite.any()) and all(_alike(*pair, n) for pair in pairs)


def _alike(written: np.ndarray, formed: np.ndarray, n: int) -> bool:
    matrix, forcing = written[: n * n].reshape(n, n), written[n * n :]
    try:
        rates = np.linalg.solve(formed[: n * n].reshape(n, n), formed[n * n :])
    except np.linalg.LinAlgError:
        return False
    size = _magnitudes(matrix) @ np.abs(rates) + np.abs(forcing)
    return bool((np.abs(matrix @ rates - forcing) <= AGREEING * size + np.finfo(float).tiny).all())


def _magnitudes(matrix: np.ndarray) -> np.ndarray:
    """Return the sizes of entries; what is nearly nothing may be what cancelling terms left.

    Rows and columns are scaled until their largest entries are about 1, as units would do.
    """
    sizes = np.abs(matrix)
    scaled, scale = sizes, np.ones(matrix.shape)
    for axis in (0, 1, 0, 1):
        most = np.sqrt(scaled.max(axis=axis, keepdims=True))
        most[most == 0.0] = 1.0
        scaled, scale = scaled / most, scale * most
    found: np.ndarray = np.maximum(sizes, CANCELLED * scale)
    return found
