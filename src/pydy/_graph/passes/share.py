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

# An operand, or the combination of two trees.
Tree = Hashable
# A tree, and whether it counts positive; factors of a product always do.
Signed = tuple[Tree, bool]


class _Pair(tuple[Signed, Signed]):
    """Two trees joined; a type of its own, so that operands may be tuples too."""

    __slots__ = ()


def is_pair(tree: Tree) -> bool:
    """Tell whether a tree is two joined trees and not an operand."""
    return isinstance(tree, _Pair)


def share_pairs(rows: Sequence[Sequence[Signed]]) -> list[list[Signed]]:
    """Join common pairs of the rows; return the rows with what remains to be combined.

    Rows are the operands, each once, of products or of sums, and whether they are positive; a − b
    and b − a are the same pair. What is left are operands and pairs of signed trees (see
    `is_pair`), which are the same object in every row that has them.
    """
    # An entry of a row is twice its tree's number, plus one where it is negative.
    trees: list[Tree] = []
    numbers: dict[Tree, int] = {}
    for row in rows:
        for operand, _ in row:
            if operand not in numbers:
                numbers[operand] = len(trees)
                trees.append(operand)
    table = [[2 * numbers[tree] + (not positive) for tree, positive in row] for row in rows]
    rows_of_pair: dict[tuple[int, int], set[int]] = {}
    for k, numbered in enumerate(table):
        for pair in _candidates(numbered):
            rows_of_pair.setdefault(pair, set()).add(k)
    heap = [(-len(users), pair) for pair, users in rows_of_pair.items() if len(users) > 1]
    heapq.heapify(heap)
    while heap:
        count, pair = heapq.heappop(heap)
        users = rows_of_pair.get(pair, set())
        if len(users) != -count:
            if len(users) > 1:
                heapq.heappush(heap, (-len(users), pair))
            continue
        new = len(trees)
        trees.append(_Pair((_signed(trees, pair[0]), _signed(trees, pair[1]))))
        touched: set[tuple[int, int]] = set()
        for k in sorted(users):
            before = _candidates(table[k])
            table[k] = _with_pair(table[k], pair, new)
            after = _candidates(table[k])
            for removed in before - after:
                rows_of_pair[removed].discard(k)
            for added in after - before:
                rows_of_pair.setdefault(added, set()).add(k)
            touched |= after - before
        rows_of_pair.pop(pair, None)
        for key in sorted(touched):
            if len(rows_of_pair[key]) > 1:
                heapq.heappush(heap, (-len(rows_of_pair[key]), key))
    return [[_signed(trees, entry) for entry in row] for row in table]


def _signed(trees: list[Tree], entry: int) -> Signed:
    return trees[entry >> 1], not entry & 1


def _candidates(row: list[int]) -> set[tuple[int, int]]:
    """Return the pairs of a row; the first of each is made positive."""
    # All pairs of operands cost the square of their number, and what long sums share is mostly a
    # run of terms.
    if len(row) > 20:
        couples = [(min(a, b), max(a, b)) for a, b in pairwise(row)]
    else:
        ordered = sorted(row)
        couples = [(a, b) for i, a in enumerate(ordered) for b in ordered[i + 1 :]]
    return {(a ^ (a & 1), b ^ (a & 1)) for a, b in couples}


def _with_pair(row: list[int], pair: tuple[int, int], new: int) -> list[int]:
    """Return a row with the pair's first member replaced and the second left out."""
    first = pair[0] >> 1
    second = pair[1] >> 1
    sign = next(entry for entry in row if entry >> 1 == first) & 1
    result = []
    done = False
    for entry in row:
        if entry >> 1 not in (first, second):
            result.append(entry)
        elif not done:
            result.append(2 * new + sign)
            done = True
    return result
