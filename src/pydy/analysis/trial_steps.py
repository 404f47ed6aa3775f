"""How many steps the trial motions of a search may take."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydy.analysis.tuning import MOST_TRIAL_STEPS


def limited_steps(options: Mapping[str, Any], best: int) -> dict[str, Any]:
    """Return a solver's options for a trial motion, if the `best` one so far took so many steps.

    Steps of a fixed length are as many in each motion.
    """
    if options.get("step") is not None or best == 0:
        return {**options}
    most = MOST_TRIAL_STEPS * best
    return {**options, "max_steps": min(options.get("max_steps", most), most)}
