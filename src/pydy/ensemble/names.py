"""The names of quantities in the results of an ensemble."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from pydy._assembly import Definition
from pydy._checks import SymbolIndex, check_mapping, refuse_twice, unit_of_unconverted
from pydy._dataset import SENSITIVITY
from pydy._names import latex_of, name_of, some, unique_names
from pydy._problem import Problem
from pydy.ensemble.samples import PARAMETER, QUANTITY
from pydy.ensemble.work import COUNTS

if TYPE_CHECKING:
    from pydy._sympy_types import AnySymbol, SymbolOrName


class ResultNames:
    """The names of a definition's states, outputs and constants in results.

    `reserved` lists further names of a result, besides states, outputs and `COUNTS`.
    """

    def __init__(
        self,
        definition: Definition,
        reserved: Iterable[str],
        outputs: Iterable[AnySymbol] | None = None,
    ) -> None:
        equations, n = definition.equations, len(definition.states)
        outputs = definition.outputs.symbols if outputs is None else outputs
        variables = (*definition.states, *outputs)
        self._variables = SymbolIndex(variables, "states and outputs of the system")
        names = unique_names(variables)
        self._name_of = dict(zip(variables, names, strict=True))
        self.states, self.outputs = names[:n], names[n:]
        self.used_names = {*names}  # names of the result's variables
        for name in ("time", "occurrence", *COUNTS, *reserved):
            if name in self.used_names:
                raise ValueError(
                    f"The result of an ensemble has a variable or dimension `{name}` of its own, "
                    "but that is the name of a state or output too. Rename that."
                )
            self.used_names.add(name)
        # The names of xarray coordinates; for constants, also their attributes.
        self.labels = {s: f"initial_{self._name_of[s]}" for s in definition.states}
        self.labels |= {s: f"{v} (state)" for s, v in self.labels.items() if v in self.used_names}
        symbols = (*definition.constants, *definition.specifieds)
        for s, name in zip(symbols, unique_names(symbols), strict=True):
            self.labels[s] = f"{name} (constant)" if name in self.used_names else name
        self.constants = tuple(
            (self.labels[s], {"role": "constant", "latex": latex_of(s)})
            for s in definition.constants
        )
        roles = {**dict.fromkeys(equations.coordinates, "coordinate")}
        roles |= dict.fromkeys(equations.speeds, "speed")
        roles |= dict.fromkeys(definition.auxiliaries, "auxiliary")
        self.attributes = {
            name: {"role": roles.get(s, "output"), "latex": latex_of(s)}
            for s, name in self._name_of.items()
        }

    @staticmethod
    def latest(problem: Problem, sensitive: bool) -> ResultNames:
        """Return the names of a Problem's results, cached in its model."""
        key = "names beside sensitivities" if sensitive else "names"
        reserved = (SENSITIVITY, QUANTITY, PARAMETER) if sensitive else ()
        names: ResultNames | None = problem.model.code.latest.get(key)
        if names is None:
            names = problem.model.code.latest[key] = ResultNames(problem.definition, reserved)
        return names

    def name(self, key: SymbolOrName) -> str:
        """Return the name of a state or output, from its symbol or name."""
        symbol = self._variables.meaning(key, "reduce")
        return self._name_of[symbol] if symbol in self._name_of else name_of(key)

    def described(
        self, units: Mapping[SymbolOrName, str | tuple[str, float]]
    ) -> dict[str, dict[str, str]]:
        """Return the attributes of variables, including their units."""
        result = {name: dict(attributes) for name, attributes in self.attributes.items()}
        units = check_mapping("units", units)
        names = [self.name(key) for key in units]
        refuse_twice(names, "units")
        for name, (key, unit) in zip(names, units.items(), strict=True):
            if name not in result:
                raise ValueError(
                    f"`units` has the key `{key}`, which is neither a state nor an output: "
                    f"{some(result)}."
                )
            state = "" if result[name]["role"] == "output" else name
            result[name]["units"] = unit_of_unconverted(unit, f"units[{key}]", state)
        return result
