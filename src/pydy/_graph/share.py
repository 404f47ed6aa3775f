"""Share parts of products and sums: greedy extraction of the pair that occurs most often.

A product of k factors costs k − 1 multiplications in any order, a sum of k terms k − 1 additions;
which order is chosen decides how much several of them have in common. The most frequent pair
becomes a node of its own, again and again (Breuer, Generation of optimal code for expressions via
factorization, CACM 12(6), 1969).
"""

from __future__ import annotations

import heapq
from collections.abc import Hashable, Sequence
from itertools import pairwise

__all__ = ["Tree", "is_pair", "share_pairs"]

# An operand, or the combination of two trees.
Tree = Hashable

# In longer rows only neighbours are tried: all pairs would cost the square of the length, and what
# long sums share is mostly a run of terms (the loads on everything below a joint).
_LONG = 20


class _Pair(tuple[Tree, Tree]):
    """Two trees joined; a type of its own, so that operands may be tuples too."""

    __slots__ = ()


def is_pair(tree: Tree) -> bool:
    """Tell whether a tree is two joined trees and not an operand."""
    return isinstance(tree, _Pair)


def _candidates(row: list[int]) -> set[tuple[int, int]]:
    if len(row) > _LONG:
        return {(min(a, b), max(a, b)) for a, b in pairwise(row)}
    ordered = sorted(row)
    return {(a, b) for i, a in enumerate(ordered) for b in ordered[i + 1 :]}


def share_pairs(rows: Sequence[Sequence[Tree]]) -> list[list[Tree]]:
    """Return the rows with common pairs joined.

    Parameters
    ----------
    rows : sequence of sequences of distinct operands
        Of products or of sums: the order of operands does not matter.

    Returns
    -------
    list of list
        For each row what is left to combine: operands, and pairs of trees (see `is_pair`), which
        are the same object in every row that has them.
    """
    trees: list[Tree] = []
    numbers: dict[Tree, int] = {}
    for row in rows:
        for operand in row:
            if operand not in numbers:
                numbers[operand] = len(trees)
                trees.append(operand)
    table = [[numbers[operand] for operand in row] for row in rows]
    where: dict[tuple[int, int], set[int]] = {}
    for k, numbered in enumerate(table):
        for pair in _candidates(numbered):
            where.setdefault(pair, set()).add(k)
    heap = [(-len(users), pair) for pair, users in where.items() if len(users) > 1]
    heapq.heapify(heap)
    while heap:
        count, pair = heapq.heappop(heap)
        users = where.get(pair, set())
        if len(users) != -count:
            if len(users) > 1:
                heapq.heappush(heap, (-len(users), pair))
            continue
        new = len(trees)
        trees.append(_Pair((trees[pair[0]], trees[pair[1]])))
        touched: set[tuple[int, int]] = set()
        for k in sorted(users):
            before = _candidates(table[k])
            table[k] = _joined(table[k], pair, new)
            after = _candidates(table[k])
            for gone in before - after:
                where[gone].discard(k)
            for added in after - before:
                where.setdefault(added, set()).add(k)
            touched |= after - before
        where.pop(pair, None)
        for key in sorted(touched):
            if len(where[key]) > 1:
                heapq.heappush(heap, (-len(where[key]), key))
    return [[trees[n] for n in row] for row in table]


def _joined(row: list[int], pair: tuple[int, int], new: int) -> list[int]:
    """Return a row with the pair's first member replaced and the second left out."""
    result = []
    done = False
    for n in row:
        if n in pair:
            if not done:
                result.append(new)
                done = True
        else:
            result.append(n)
    return result
