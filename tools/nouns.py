"""Draw which noun gives which: the arrows of `docs/design.md`, from the types in the code.

    python tools/nouns.py

An arrow from A to B is a field or property of A of that type, or a method or function that takes an
A first and returns a B. `tests/test_house.py` compares the page with it.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

PACKAGE = Path(__file__).parents[1] / "src/pydy"
# Files with a noun or with functions of one.
FILES = (
    "system.py",
    "_problem/model.py",
    "_problem/problem.py",
    "_evaluation/function.py",
    "_states/dependent_states.py",
    "_integration/integration.py",
    "_motion/motion.py",
)
NOUNS = (
    "System", "Model", "Problem", "Evaluator", "Motion", "Definition", "CompiledModel",
    "Trajectory",
)  # fmt: skip


def named(annotation: ast.expr | None) -> str | None:
    """Return the noun of an annotation, if it is one."""
    text = "" if annotation is None else ast.unparse(annotation)
    return text if text in NOUNS else None


def arrows(path: Path) -> Iterator[tuple[str, str, str]]:
    """Yield the noun, the name and the noun that it gives, of one file."""
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.FunctionDef) and node.args.args and node.name[0] != "_":
            source, target = named(node.args.args[0].annotation), named(node.returns)
            if source and target:
                yield source, f"{node.name}(…)", target
        if not (isinstance(node, ast.ClassDef) and node.name in NOUNS):
            continue
        for member in node.body:
            if isinstance(member, ast.AnnAssign) and (target := named(member.annotation)):
                yield node.name, ast.unparse(member.target), target
            if isinstance(member, ast.FunctionDef) and (target := named(member.returns)):
                own = {ast.unparse(d) for d in member.decorator_list}
                if own & {"property", "cached_property"}:
                    yield node.name, member.name, target
                elif "staticmethod" not in own and (member.name[0] != "_" or member.name == "_now"):
                    yield node.name, f"{member.name}(…)", target


def diagram() -> str:
    """Return all arrows, a line for each pair of nouns."""
    names: dict[tuple[str, str], list[str]] = {}
    for file in FILES:
        for source, name, target in arrows(PACKAGE / file):
            names.setdefault((source, target), []).append(name)
    order = sorted(names, key=lambda pair: tuple(map(NOUNS.index, pair)))
    return "\n".join(
        f"{source:<10} ─► {target:<13} {', '.join(dict.fromkeys(names[source, target]))}"
        for source, target in order
    )


if __name__ == "__main__":
    print(diagram())
