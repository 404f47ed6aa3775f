"""A Program: the straight-line list of elementary operations that a back end compiles.

Nodes are elementary here (two operands, no coefficients); `pydy._graph.lowering` makes them of the
n-ary graph. A Program has two stages. The *setup* stage depends on the constants p alone and runs
once for each set of them; its results that are needed later are *carried* in an array c. The *run*
stage is what every call costs.

Operations and their arguments::

    const (value,)   bool (value,)   input (group, index)
    add sub mul div min max pow atan2 lt le eq ne and or (a, b)
    neg not sqrt exp ... ceil (a,)            select (condition, a, b)
    factor (n, entries)                       LU factors with partial pivoting, or LDLᵀ in a loop
    solve  (factor, column)                   a vector
    guard  (n, entries, column, sound, fast)  the vector `fast` where `sound` is true, else by LU;
                                              several right-hand sides may follow each other, and
                                              without `fast` there is no solution while it is sound
    item   (vector, k)                        one component of a vector
"""

from __future__ import annotations

import hashlib
import struct
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from pydy._forks import cached_property
from pydy._program.nodes import Nodes
from pydy._program.operations import OPERATIONS
from pydy._program.signature import Signature

if TYPE_CHECKING:
    from pydy._program import Args

FREE = OPERATIONS.solves | {"const", "bool", "input", "item"}
# Operations that must not be moved into a guard's fallback: back ends read or compute them in
# groups.
_NEVER_DEFERRED = (FREE - {"guard", "item"}) | set(OPERATIONS.angles)


class Tape(Nodes):
    """Elementary operations, in the making of a Program."""

    never_deferred = _NEVER_DEFERRED

    def __init__(self) -> None:
        super().__init__()
        self.in_every_call = True  # whether the operations being added are needed at every call
        # The guard whose fallback is being added. An operation that several fallbacks need, but not
        # every call, is repeated in each: shared, it would be computed at every call.
        self.guard_of_fallback: int | None = None
        self._every: set[int] = set()  # nodes that every call needs

    def make(self, op: str, *args: object) -> int:
        """Return the node for `op` on `args`."""
        if self.guard_of_fallback is None or op in _NEVER_DEFERRED:
            node = self.node(op, args)
            if self.in_every_call:
                self._every.add(node)
            return node
        shared = self._node_of.get((op, args))
        if shared is not None and shared in self._every:
            return shared
        return self.node(op, args, self.guard_of_fallback)

    def const(self, value: float) -> int:
        """Return the node of a number."""
        return self.make("const", float(value) + 0.0)

    def value(self, node: int) -> float | None:
        """Return the number that a node is, or None."""
        return self.args[node][0] if self.ops[node] == "const" else None

    def add(self, a: int, b: int) -> int:
        """Return ``a + b``."""
        if self.value(a) == 0.0:
            return b
        if self.value(b) == 0.0:
            return a
        if self.ops[b] == "neg":
            return self.sub(a, self.args[b][0])
        if self.ops[a] == "neg":
            return self.sub(b, self.args[a][0])
        return self._fold("add", *sorted((a, b)))

    def sub(self, a: int, b: int) -> int:
        """Return ``a - b``."""
        if self.value(b) == 0.0:
            return a
        if self.value(a) == 0.0:
            return self.neg(b)
        if self.ops[b] == "neg":
            return self.add(a, self.args[b][0])
        return self._fold("sub", a, b)

    def mul(self, a: int, b: int) -> int:
        """Return ``a · b``."""
        for p, q in ((a, b), (b, a)):
            value = self.value(p)
            if value == 0.0:
                return self.const(0.0)
            if value == 1.0:
                return q
            if value == -1.0:
                return self.neg(q)
        if self.ops[a] == "neg":
            return self.neg(self.mul(self.args[a][0], b))
        if self.ops[b] == "neg":
            return self.neg(self.mul(a, self.args[b][0]))
        return self._fold("mul", *sorted((a, b)))

    def div(self, a: int, b: int) -> int:
        """Return ``a / b``."""
        if self.value(a) == 0.0 or self.value(b) == 1.0:
            return a
        if self.ops[a] == "neg":
            return self.neg(self.div(self.args[a][0], b))
        return self._fold("div", a, b)

    def neg(self, a: int) -> int:
        """Return ``-a``."""
        if self.ops[a] == "neg":
            inner: int = self.args[a][0]
            return inner
        value = self.value(a)
        return self.make("neg", a) if value is None else self.const(-value)

    def power(self, a: int, exponent: int) -> int:
        """Return ``a ** exponent`` for a positive exponent, by repeated squaring."""
        if exponent == 1:
            return a
        half = self.power(a, exponent // 2)
        square = self.mul(half, half)
        return self.mul(square, a) if exponent % 2 else square

    def _fold(self, op: str, a: int, b: int) -> int:
        x, y = self.value(a), self.value(b)
        if x is not None and y is not None and not (op == "div" and y == 0.0):
            result = {"add": x + y, "sub": x - y, "mul": x * y, "div": x / y if y else 0.0}[op]
            return self.const(result)
        return self.make(op, a, b)


@dataclass(frozen=True)
class Program:
    """Elementary operations with ordered inputs and named output blocks."""

    signature: Signature  # inputs and output blocks: all that its callers need to know
    ops: tuple[str, ...]  # the operations, see the module
    args: tuple[Args, ...]
    setup: tuple[bool, ...]  # whether a node belongs to the setup stage
    carried: tuple[int, ...]  # its nodes that the run stage or the outputs need: the array c
    outputs: tuple[int, ...]  # the flat output

    @property
    def num_operations(self) -> int:
        """Number of operations of both stages, constants and inputs included."""
        return len(self.ops)

    @classmethod
    def from_tape(
        cls,
        tape: Tape,
        sizes: tuple[int, int, int],
        blocks: Sequence[tuple[str, tuple[int, ...], Sequence[int]]],
    ) -> Program:
        """Make a Program of the operations in a tape that the blocks need, renumbered."""
        roots = [n for _, _, nodes in blocks for n in nodes]
        order = _in_order_of_need(tape, roots)
        new = {old: k for k, old in enumerate(order)}
        ops = tuple(tape.ops[n] for n in order)
        args = tuple(OPERATIONS.with_operands(tape.ops[n], tape.args[n], new) for n in order)
        setup = tuple(tape.constant[n] for n in order)
        outputs = tuple(new[n] for n in roots)
        needed = {
            k
            for op, a, s in zip(ops, args, setup, strict=True)
            if not s
            for k in OPERATIONS.operands(op, a)
            if setup[k]
        }
        needed.update(k for k in outputs if setup[k])
        carried = tuple(k for k in sorted(needed) if ops[k] not in ("const", "bool"))
        signature = Signature.of(sizes, ((name, shape) for name, shape, _ in blocks))
        for block, (_, _, nodes) in zip(signature.blocks, blocks, strict=True):
            assert block.stop - block.start == len(nodes), (block, len(nodes))
        return cls(signature, ops, args, setup, carried, outputs)

    def __str__(self) -> str:
        return listing(self)

    @cached_property
    def digest(self) -> str:
        """SHA-256 of everything that determines the Program's results."""
        sha = hashlib.sha256()
        sha.update(repr(self.signature.sizes).encode())
        for op, args in zip(self.ops, self.args, strict=True):
            if op == "const":
                sha.update(b"const" + struct.pack("<d", args[0]))
            else:
                sha.update(repr((op, args)).encode())
        sha.update(repr((self.outputs, self.signature.blocks)).encode())
        for op in sorted(OPERATIONS.keys() & set(self.ops)):
            sha.update(f"{op} {OPERATIONS[op].written}\n".encode())
        return sha.hexdigest()

    @cached_property
    def fallback(self) -> dict[int, list[int]]:
        """For each guard the nodes that only its fallback needs, so that back ends may defer them.

        A guard among them has nodes of its own. A node that two fallbacks need is deferred to the
        fallback of the innermost guard that contains both.
        """
        hot = -1
        user: dict[int, int] = dict.fromkeys(self.outputs, hot)
        deferred: dict[int, list[int]] = {k: [] for k, op in enumerate(self.ops) if op == "guard"}

        def common(a: int, b: int) -> int:
            while a != b:  # guards within others come before them
                if b == hot or (a != hot and a < b):
                    a = user[a]
                else:
                    b = user[b]
            return a

        for node in reversed(range(len(self.ops))):
            if self.setup[node] or node not in user:
                continue
            op, args = self.ops[node], self.args[node]
            if user[node] != hot and op in _NEVER_DEFERRED:
                user[node] = hot
            owner = user[node]
            if owner != hot:
                deferred[owner].append(node)
            if op == "guard":
                needs = [(k, owner) for k in (args[3], *args[4])]
                needs += [(k, node) for k in dict.fromkeys((*args[1], *args[2]))]
            else:
                needs = [(k, owner) for k in OPERATIONS.operands(op, args)]
            for operand, user_of_operand in needs:
                user[operand] = common(user.get(operand, user_of_operand), user_of_operand)
        return {guard: nodes[::-1] for guard, nodes in deferred.items()}

    @cached_property
    def without_fallbacks(self) -> frozenset[int]:
        """The nodes that are needed while all guards are sound."""
        needed = bytearray(len(self.ops))
        for node in self.outputs:
            needed[node] = 1
        for node in reversed(range(len(self.ops))):
            if needed[node]:
                op, args = self.ops[node], self.args[node]
                for operand in (
                    (args[3], *args[4]) if op == "guard" else OPERATIONS.operands(op, args)
                ):
                    needed[operand] = 1
        return frozenset(node for node, flag in enumerate(needed) if flag)

    @cached_property
    def operation_count(self) -> dict[str, Counter[str]]:
        """Operations by kind, for the stages 'setup' and 'run'.

        A subtraction counts as 'add'. A loop that factorises or solves counts what it executes
        as 'add', 'mul' and 'div'; the fallback behind a guard is not counted.
        """
        counts: dict[str, Counter[str]] = {"setup": Counter(), "run": Counter()}
        deferred = {k for nodes in self.fallback.values() for k in nodes}
        for k, (op, args, setup) in enumerate(zip(self.ops, self.args, self.setup, strict=True)):
            if k in deferred:
                continue
            counter = counts["setup" if setup else "run"]
            if op == "factor":
                n = args[1]
                work = n * (n * n - 1) // 3 if args[0] == "lu" else n * (n * n - 1) // 6
                counter.update(add=work, mul=work, div=n)
            elif op == "solve":
                n = len(args[1])
                counter.update(add=n * (n - 1), mul=n * n)
            elif op not in FREE:
                counter["add" if op == "sub" else op] += 1
        return counts

    def __getstate__(self) -> dict[str, object]:
        state = dict(self.__dict__)
        for name in ("operation_count", "fallback", "without_fallbacks"):
            state.pop(name, None)
        return state


def _in_order_of_need(tape: Tape, roots: Iterable[int]) -> list[int]:
    """Order the operations of the roots: each value as late as possible before its first use.

    Few values are then live at a time, so that machine code holds them in registers, and the
    register allocator, whose time grows with the number of live values, is faster. Of the operands
    of a sum, one that takes clearly more operations in a row comes first, so that the other does
    not stay live meanwhile.
    """
    order: list[int] = []
    done: set[int] = set()
    roots = list(roots)
    levels = _levels(tape)
    # All arguments of some functions come first: a back end can then do several at once.
    stack = [*roots[::-1], *_arguments_first(tape, roots)[::-1]]
    while stack:
        node = stack.pop()
        if node < 0:
            order.append(~node)
            continue
        if node in done:
            continue
        done.add(node)
        stack.append(~node)
        op, args = tape.ops[node], tape.args[node]
        if op == "guard":
            # The column from its end, since the loads on the outer bodies are terms of those on the
            # inner ones; then the entries of the matrix in the order of the elimination.
            _, entries, column, sound, fast = args
            needs: Sequence[int] = (*column[::-1], sound, *fast, *entries)
        else:
            needs = OPERATIONS.operands(op, args)
            if op in ("add", "sub") and levels[needs[1]] > levels[needs[0]] + 2:
                needs = needs[::-1]
        stack.extend(n for n in reversed(needs) if n not in done)
    return order


def _levels(tape: Tape) -> list[int]:
    """Return how many sums, products and quotients in a row lead to each node at every call."""
    levels: list[int] = []
    for op, args, setup in zip(tape.ops, tape.args, tape.constant, strict=True):
        if setup:
            levels.append(0)
        else:
            is_counted = op in ("add", "sub", "mul", "div")
            levels.append(
                is_counted + max((levels[n] for n in OPERATIONS.operands(op, args)), default=0)
            )
    return levels


def _arguments_first(tape: Tape, roots: Sequence[int]) -> list[int]:
    """Return the arguments of functions computed together, then these functions, innermost first.

    Each level has the functions whose arguments hold as many others in a row.
    """
    reached = set(roots)
    stack = list(roots)
    while stack:
        node = stack.pop()
        for operand in OPERATIONS.operands(tape.ops[node], tape.args[node]):
            if operand not in reached:
                reached.add(operand)
                stack.append(operand)
    depth: dict[int, int] = {}
    levels: dict[int, list[int]] = {}
    for node in sorted(reached):
        inner = max(
            (depth[k] for k in OPERATIONS.operands(tape.ops[node], tape.args[node])), default=0
        )
        if tape.ops[node] in OPERATIONS.together:
            levels.setdefault(inner, []).append(node)
            inner += 1
        depth[node] = inner
    order: list[int] = []
    for level in sorted(levels):
        order += dict.fromkeys(tape.args[node][0] for node in levels[level])
        order += levels[level]
    return order


# -- As text that a person can read ----------------------------------------------------------------

_ARGUMENTS = {"x": "states", "r": "specifieds", "p": "constants"}


def listing(
    program: Program,
    names: Mapping[str, Sequence[str]] | None = None,
    most_lines: int | None = 200,
) -> str:
    """Return the operations of a Program, line by line.

    `names` are those of the inputs, for the groups ``'x'`` (states), ``'r'`` (specifieds) and
    ``'p'`` (constants). Beyond `most_lines`, operations are counted; None writes all.
    """
    lines = [*_summary(program), *_ProgramListing(program, names or {}, most_lines).lines()]
    return "\n".join(lines)


def _summary(program: Program) -> Iterator[str]:
    blocks = ", ".join(f"{b.name} {_shape(b.shape)}" for b in program.signature.blocks)
    sizes = program.signature.sizes
    counts = ", ".join(
        f"{n} {noun}" for n, noun in zip(sizes, _ARGUMENTS.values(), strict=True) if n
    )
    yield f"Program: {counts or 'no inputs'} and time -> {blocks or 'nothing'}"
    for stage, text in (("setup", "set-up stage, once for each set of constants"), ("run", "run")):
        counted = program.operation_count[stage]
        kinds = ", ".join(f"{n} {op}" for op, n in sorted(counted.items(), key=lambda e: -e[1]))
        yield f"  {text}: {sum(counted.values())} operations{f' ({kinds})' if kinds else ''}"


def _shape(shape: tuple[int, ...]) -> str:
    return "(" + ", ".join(map(str, shape)) + ("," if len(shape) == 1 else "") + ")"


class _ProgramListing:
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
            stage = [
                k
                for k, op in enumerate(program.ops)
                if program.setup[k] == setup and op not in ("const", "bool", "input", "item")
            ]
            if not stage:
                continue
            yield f"{title}:"
            listed = stage if self.most_lines is None else stage[: self.most_lines]
            for k in listed:
                yield f"  {self._name(k)} = {self._text(k)}"
            if len(listed) < len(stage):
                yield f"  ... {len(stage) - len(listed)} more: listing(program, most_lines=None)"
        yield "outputs:"
        for block in program.signature.blocks:
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
            names = self.names.get(group, ())
            return names[index] if index < len(names) else f"{group}[{index}]"
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
        listed = ", ".join(self._name(k) for k in nodes[:8])
        return f"[{listed}{', ...' if len(nodes) > 8 else ''}]"


_KINDS = {"ldl": "LDL^T", "lu": "LU with partial pivoting"}
