"""A Program as text that a person can read."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from pydy._graph.operations import OPERATIONS

Program = Any  # `pydy._graph.program.Program`, which imports this module to print itself

_MOST_LINES = 200
_ARGUMENTS = {"x": "states", "r": "specifieds", "p": "constants"}


def listing(
    program: Program,
    names: Mapping[str, Sequence[str]] | None = None,
    most_lines: int | None = _MOST_LINES,
) -> str:
    """Return the operations of a Program, line by line.

    `names` are those of the inputs, for the groups ``'x'`` (states), ``'r'`` (specifieds) and
    ``'p'`` (constants). Beyond `most_lines`, operations are counted; None writes all.
    """
    lines = [*_summary(program), *_Writer(program, names or {}, most_lines).lines()]
    return "\n".join(lines)


def _summary(program: Program) -> Iterator[str]:
    blocks = ", ".join(f"{b.name} {_shape(b.shape)}" for b in program.blocks)
    sizes = (program.num_states, program.num_specifieds, program.num_constants)
    counts = ", ".join(
        f"{n} {what}" for n, what in zip(sizes, _ARGUMENTS.values(), strict=True) if n
    )
    yield f"Program: {counts or 'no inputs'} and time -> {blocks or 'nothing'}"
    for stage, text in (("setup", "set-up stage, once for each set of constants"), ("run", "run")):
        found = program.operation_count[stage]
        kinds = ", ".join(f"{n} {op}" for op, n in sorted(found.items(), key=lambda e: -e[1]))
        yield f"  {text}: {sum(found.values())} operations{f' ({kinds})' if kinds else ''}"


def _shape(shape: tuple[int, ...]) -> str:
    return "(" + ", ".join(map(str, shape)) + ("," if len(shape) == 1 else "") + ")"


class _Writer:
    def __init__(
        self, program: Program, names: Mapping[str, Sequence[str]], most_lines: int | None
    ) -> None:
        self.program = program
        self.names = names
        self.most_lines = most_lines

    def lines(self) -> Iterator[str]:
        """Yield both stages, then where the outputs come from."""
        program = self.program
        for setup, title in ((True, "set-up stage"), (False, "run stage")):
            made = [
                k
                for k, op in enumerate(program.ops)
                if program.setup[k] == setup and op not in ("const", "bool", "input", "item")
            ]
            if not made:
                continue
            yield f"{title}:"
            shown = made if self.most_lines is None else made[: self.most_lines]
            for k in shown:
                yield f"  {self._name(k)} = {self._text(k)}"
            if len(shown) < len(made):
                yield f"  ... {len(made) - len(shown)} more: listing(program, most_lines=None)"
        yield "outputs:"
        for block in program.blocks:
            nodes = program.outputs[block.start : block.stop]
            values = [self._name(k) for k in nodes]
            if self.most_lines is not None and len(values) > self.most_lines:
                values = [*values[: self.most_lines], "..."]
            yield f"  {block.name} = [{', '.join(values)}]"

    def _name(self, node: int) -> str:
        op, args = self.program.ops[node], self.program.args[node]
        if op == "const":
            return f"{args[0]:g}" if float(f"{args[0]:g}") == args[0] else repr(args[0])
        if op == "bool":
            return str(args[0]).lower()
        if op == "item":
            return f"{self._name(args[0])}[{args[1]}]"
        if op == "input":
            group, index = args
            if group == "t":
                return "t"
            known = self.names.get(group, ())
            return known[index] if index < len(known) else f"{group}[{index}]"
        return f"{'c' if self.program.setup[node] else 'v'}{node}"

    def _text(self, node: int) -> str:
        op, args = self.program.ops[node], self.program.args[node]
        if op in OPERATIONS:
            return OPERATIONS[op].c.format(*(self._name(k) for k in args))
        if op == "factor":
            kind, n, entries = args
            return f"factors of a {n} x {n} matrix, {_KINDS[kind]}: {self._several(entries)}"
        if op == "solve":
            return f"solution with {self._name(args[0])} for {self._several(args[1])}"
        n, _, _, sound, fast = args  # a guard
        system = f"the solution of that {n} x {n} system by LU with partial pivoting"
        return f"{self._several(fast)} where {self._name(sound)}, else {system}"

    def _several(self, nodes: Sequence[int]) -> str:
        shown = ", ".join(self._name(k) for k in nodes[:8])
        return f"[{shown}{', ...' if len(nodes) > 8 else ''}]"


_KINDS = {"ldl": "LDL^T", "lu": "LU with partial pivoting"}
