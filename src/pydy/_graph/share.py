"""Share sub-products: greedy extraction of the pair of factors that occurs most often.

A product of k factors costs k − 1 multiplications in any order; which order is chosen decides how
much several products have in common. The most frequent pair becomes a factor of its own, again and
again (Breuer, Generation of optimal code for expressions via factorization, CACM 12(6), 1969).
"""

from __future__ import annotations

import heapq
from collections.abc import Hashable, Sequence

__all__ = ["Tree", "is_pair", "share_products"]

# A factor, or the product of two trees.
Tree = Hashable


class _Pair(tuple[Tree, Tree]):
    """A product of two trees; a type of its own, so that factors may be tuples too."""

    __slots__ = ()


def is_pair(tree: Tree) -> bool:
    """Tell whether a tree is a product and not a factor."""
    return isinstance(tree, _Pair)


def share_products(products: Sequence[Sequence[Tree]]) -> list[list[Tree]]:
    """Return the products with common pairs joined.

    Parameters
    ----------
    products : sequence of sequences of distinct factors

    Returns
    -------
    list of list
        For each product the factors that are left to multiply: those given, and pairs of trees
        (see `is_pair`), which are the same object in every product that has them.
    """
    trees: list[Tree] = []
    numbers: dict[Tree, int] = {}
    for factors in products:
        for factor in factors:
            if factor not in numbers:
                numbers[factor] = len(trees)
                trees.append(factor)
    rows = [{numbers[factor] for factor in factors} for factors in products]
    where: dict[tuple[int, int], set[int]] = {}
    for k, row in enumerate(rows):
        ordered = sorted(row)
        for i, a in enumerate(ordered):
            for b in ordered[i + 1 :]:
                where.setdefault((a, b), set()).add(k)
    heap = [(-len(users), pair) for pair, users in where.items() if len(users) > 1]
    heapq.heapify(heap)
    while heap:
        count, pair = heapq.heappop(heap)
        users = where.get(pair, set())
        if len(users) != -count:
            if len(users) > 1:
                heapq.heappush(heap, (-len(users), pair))
            continue
        a, b = pair
        new = len(trees)
        trees.append(_Pair((trees[a], trees[b])))
        touched: set[tuple[int, int]] = set()
        for k in sorted(users):
            row = rows[k]
            row -= {a, b}
            for other in row:
                for gone in (a, b):
                    where[min(gone, other), max(gone, other)].discard(k)
                key = (other, new)
                where.setdefault(key, set()).add(k)
                touched.add(key)
            row.add(new)
        del where[pair]
        for key in sorted(touched):
            if len(where[key]) > 1:
                heapq.heappush(heap, (-len(where[key]), key))
    return [[trees[n] for n in sorted(row)] for row in rows]
