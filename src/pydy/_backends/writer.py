"""A Program as straight-line code of any language.

A language is a `Dialect`: a table of templates for `str.format`. A `Writer` fills them in, one
operation after the other. C, JavaScript, NumPy, JAX and CasADi are such tables; "Add a language" in
the documentation writes another one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from pydy._program import OPERATIONS, Operation, Program, is_constrained


class Each(NamedTuple):
    """A line that is repeated for each node of a list, with its place {k} and its {value}."""

    nodes: str
    line: str


Template = Sequence[str | Each]
"""Lines; the line ``{body}`` stands for the operations within, indented as it is."""


@dataclass(frozen=True)
class Dialect:
    """A language, as templates."""

    # the expression of an operation from its row of `OPERATIONS`, with ``{0}``, ``{1}``, … for the
    # operands
    operation: Callable[[Operation], str]
    literals: Mapping[str, str]  # words for 'nan', 'inf', 'True' and 'False'
    # for each group 't', 'x', 'r', 'p' its entry ``{k}``; and for 'c', what the set-up stage has
    # computed, and 'c truth', a truth value of it
    inputs: Mapping[str, str]
    # For 'factor', 'solve', 'guard' and 'constrained' (a guard whose system has constraints, see
    # `pydy._program.interpret.constrained`), an expression, or lines that define an array
    # ``{name}``. Their fields are described in `Writer`. The fallback of a guard that is an
    # expression is computed whether it is needed or not.
    rules: Mapping[str, str | Template]
    item: str = "{vector}[{k}]"  # of a solution
    let: str = "{name} = {value}"  # gives a value a name
    let_truth: str = ""
    name: str = "v{node}"  # what values are called
    array: str = "v{node}"  # what the arrays of lines are called
    # lines by kinds of operations as in `rules`, which define an array outside of functions
    reserved: Mapping[str, Template] = field(default_factory=dict)
    empty: str = ""  # what a list without nodes has in it

    def literal(self, value: float | bool) -> str:
        """Return a number or truth value, exactly."""
        if isinstance(value, bool):
            return self.literals[str(value)]
        if math.isnan(value):
            return self.literals["nan"]
        text = self.literals["inf"] if math.isinf(value) else repr(abs(float(value)))
        return f"(-{text})" if math.copysign(1.0, value) < 0.0 else text


class Writer:
    """Writes a stage of a Program, or the whole.

    Rules have the fields ``{n}``, the rows of a system; ``{entries}``, its matrix row by row, and
    ``{column}``, its right-hand sides one after the other, ``{many}`` numbers; ``{fast}``, the
    solutions without pivoting, and ``{sound}``, the condition under which these are taken;
    ``{factor}``, the name of a factorisation. In lists there are commas between the values. Further
    `fields` are filled into all templates; values of the set-up stage are read from the array c if
    `carried`.
    """

    def __init__(
        self, program: Program, dialect: Dialect, carried: bool = False, **fields: Any
    ) -> None:
        self.program, self.dialect, self.fields = program, dialect, fields
        self.reserved: list[str] = []
        self.names: dict[int, str] = {}
        """What the nodes are called that are written."""
        for node, op in enumerate(program.ops):
            if op in ("const", "bool"):
                self.names[node] = dialect.literal(program.args[node][0])
        for k, node in enumerate(program.carried if carried else ()):
            group = "c truth" if program.ops[node] in OPERATIONS.truths else "c"
            self.names[node] = dialect.inputs[group].format(k=k)

    def lines(self, nodes: Iterable[int], condition: str | None = None) -> list[str]:
        """Write operations; within the fallback of a guard, its condition is given."""
        return [line for node in nodes for line in self._operation(node, condition)]

    def filled(
        self,
        template: Template,
        body: Sequence[str],
        lists: Mapping[str, Sequence[int]],
        **more: Any,
    ) -> list[str]:
        """Fill in a template, with lists of nodes that have been written."""
        fields = {**self.fields, **more}
        for key, nodes in lists.items():
            fields[key] = ", ".join([self.names[n] for n in nodes]) or self.dialect.empty
        lines: list[str] = []
        for part in template:
            if isinstance(part, Each):
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
            return self._let(node, self.dialect.operation(OPERATIONS[op]).format(*values))
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
            # Lines skip what is within; expressions compute it in any case, so that a guard among
            # it takes the solution that needs less where neither is needed.
            outer = condition if isinstance(self.dialect.rules[op], str) else None
            body = self.lines(self.program.fallback[node], outer)
            fields = {"n": n, "many": len(column), "sound": condition}
            lists = {"entries": entries, "column": column, "fast": fast}
        rule = self.dialect.rules[op]
        if isinstance(rule, str):
            [value] = self.filled([rule], (), lists, **fields)
            return body + self._let(node, value)
        self.names[node] = name = self.dialect.array.format(node=node, **self.fields)
        self.reserved += self.filled(self.dialect.reserved.get(op, ()), (), {}, name=name, **fields)
        return self.filled(rule, body, lists, name=name, **fields)

    def _let(self, node: int, value: str) -> list[str]:
        truth = self.program.ops[node] in OPERATIONS.truths
        let = (self.dialect.let_truth if truth else "") or self.dialect.let
        self.names[node] = self.dialect.name.format(node=node, **self.fields)
        return [let.format(name=self.names[node], value=value)]


def stages(program: Program) -> tuple[list[int], list[int]]:
    """Return the nodes of the set-up and run stages, without those of fallbacks."""
    put_off = {k for nodes in program.fallback.values() for k in nodes}
    nodes = [k for k in range(len(program.ops)) if k not in put_off]
    return [k for k in nodes if program.setup[k]], [k for k in nodes if not program.setup[k]]
