"""Write a Program as straight-line code of a language.

A language is a `Dialect`: a table of templates for `str.format`. A `Writer` fills them in, one
operation after the other. C, JavaScript, NumPy, JAX and CasADi are such tables; the page "Add a
language" in the documentation defines another one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from pydy._program import OPERATIONS, Operation, Program, is_constrained


class RepeatedLine(NamedTuple):
    """A line that is repeated for each node of a list, with its index {k} and its {value}."""

    nodes: str
    line: str


Template = Sequence[str | RepeatedLine]
"""Lines. The line ``{body}`` is replaced by the inner operations, with its indentation."""


@dataclass(frozen=True)
class Dialect:
    """A language, as templates."""

    # The expression of an operation from its row of `OPERATIONS`, with ``{0}``, ``{1}``, … for the
    # operands.
    operation: Callable[[Operation], str]
    literals: Mapping[str, str]  # spellings of 'nan', 'inf', 'True' and 'False'
    # For each group 't', 'x', 'r', 'p' its entry ``{k}``; also for 'c', the values of the set-up
    # stage, and 'c truth', the truth values among them.
    inputs: Mapping[str, str]
    # For 'factor', 'solve', 'guard' and 'constrained' (a guard whose system has constraints, see
    # `pydy._program.interpret.constrained`), an expression, or lines that define an array
    # ``{name}``. Their fields are described in `Writer`. The fallback of a guard that is an
    # expression is computed whether it is needed or not.
    rules: Mapping[str, str | Template]
    item: str = "{vector}[{k}]"  # of a solution
    assignment: str = "{name} = {value}"
    truth_assignment: str = ""
    name: str = "v{node}"  # names of values
    array: str = "v{node}"  # names of arrays that rules define
    # Lines that define an array outside of functions, by kinds of operations as in `rules`.
    reserved: Mapping[str, Template] = field(default_factory=dict)
    empty: str = ""  # the text of an empty list

    def literal(self, value: float | bool) -> str:
        """Return a number or truth value, exactly."""
        if isinstance(value, bool):
            return self.literals[str(value)]
        if math.isnan(value):
            return self.literals["nan"]
        text = self.literals["inf"] if math.isinf(value) else repr(abs(float(value)))
        return f"(-{text})" if math.copysign(1.0, value) < 0.0 else text


class Writer:
    """Writes a stage of a Program, or both stages.

    Rules have the fields ``{n}``, the rows of a system; ``{entries}``, its matrix row by row, and
    ``{column}``, its right-hand sides one after the other, ``{many}`` numbers; ``{fast}``, the
    solutions without pivoting, and ``{sound}``, the condition under which these are taken;
    ``{factor}``, the name of a factorisation. In lists there are commas between the values. Further
    `fields` are filled into all templates. With `after_setup`, values of the set-up stage are read
    from the array c.
    """

    def __init__(
        self, program: Program, dialect: Dialect, after_setup: bool = False, **fields: Any
    ) -> None:
        self.program, self.dialect, self.fields = program, dialect, fields
        self.reserved: list[str] = []
        self.names: dict[int, str] = {}
        """The names of the nodes that have been written."""
        for node, op in enumerate(program.ops):
            if op in ("const", "bool"):
                self.names[node] = dialect.literal(program.args[node][0])
        for k, node in enumerate(program.carried if after_setup else ()):
            group = "c truth" if program.ops[node] in OPERATIONS.truths else "c"
            self.names[node] = dialect.inputs[group].format(k=k)

    def lines(self, nodes: Iterable[int], condition: str | None = None) -> list[str]:
        """Write operations; `condition` is that of the guard whose fallback contains them."""
        return [line for node in nodes for line in self._operation(node, condition)]

    def filled(
        self,
        template: Template,
        body: Sequence[str],
        lists: Mapping[str, Sequence[int]],
        **extra_fields: Any,
    ) -> list[str]:
        """Fill in a template, with lists of nodes that have been written."""
        fields = {**self.fields, **extra_fields}
        for key, nodes in lists.items():
            fields[key] = ", ".join([self.names[n] for n in nodes]) or self.dialect.empty
        lines: list[str] = []
        for part in template:
            if isinstance(part, RepeatedLine):
                for k, n in enumerate(lists[part.nodes]):
                    lines.append(part.line.format(**fields, k=k, value=self.names[n]))
            elif part.endswith("{body}"):
                lines += [part.removesuffix("{body}") + line for line in body]
            else:
                lines.append(part.format(**fields))
        return lines

    def _operation(self, node: int, condition: str | None) -> list[str]:
        op, args = self.program.ops[node], self.program.args[node]
        if op in ("const", "bool"):
            return []
        if op == "input":
            self.names[node] = self.dialect.inputs[args[0]].format(k=args[1])
            return []
        if op == "item":
            self.names[node] = self.dialect.item.format(vector=self.names[args[0]], k=args[1])
            return []
        if op in OPERATIONS:
            values = [self.names[k] for k in OPERATIONS.operands(op, args)]
            return self._assign(node, self.dialect.operation(OPERATIONS[op]).format(*values))
        lists: dict[str, Sequence[int]]
        body: list[str] = []
        if op == "factor":
            fields, lists = {"n": args[1]}, {"entries": args[2]}
        elif op == "solve":
            count = len(args[1])
            fields = {"n": count, "many": count, "factor": self.names[args[0]]}
            lists = {"column": args[1]}
        else:
            assert op == "guard", op
            n, entries, column, sound, fast = args
            op = "constrained" if is_constrained(self.program, entries) else "guard"
            condition = condition or self.names[sound]
            # A rule of lines skips the body. An expression computes it in any case, so that a
            # guard within it uses the cheaper solution where neither is needed.
            outer = condition if isinstance(self.dialect.rules[op], str) else None
            body = self.lines(self.program.fallback[node], outer)
            fields = {"n": n, "many": len(column), "sound": condition}
            lists = {"entries": entries, "column": column, "fast": fast}
        rule = self.dialect.rules[op]
        if isinstance(rule, str):
            [value] = self.filled([rule], (), lists, **fields)
            return body + self._assign(node, value)
        self.names[node] = name = self.dialect.array.format(node=node, **self.fields)
        self.reserved += self.filled(self.dialect.reserved.get(op, ()), (), {}, name=name, **fields)
        return self.filled(rule, body, lists, name=name, **fields)

    def _assign(self, node: int, value: str) -> list[str]:
        truth = self.program.ops[node] in OPERATIONS.truths
        template = (self.dialect.truth_assignment if truth else "") or self.dialect.assignment
        self.names[node] = self.dialect.name.format(node=node, **self.fields)
        return [template.format(name=self.names[node], value=value)]


def stages(program: Program) -> tuple[list[int], list[int]]:
    """Return the nodes of the set-up and run stages, without those of fallbacks."""
    put_off = {k for nodes in program.fallback.values() for k in nodes}
    nodes = [k for k in range(len(program.ops)) if k not in put_off]
    return [k for k in nodes if program.setup[k]], [k for k in nodes if not program.setup[k]]
