"""Common pairs of terms or factors become values of their own."""

from pydy._graph.passes.share import is_pair, share_pairs


def plus(*names):
    return [(name, True) for name in names]


def mixed(text):
    """Signed operands: 'a-b+c'."""
    text = text if text[0] in "+-" else "+" + text
    return [(name, sign == "+") for sign, name in zip(text[::2], text[1::2], strict=True)]


def leaves(tree, positive=True):
    if not is_pair(tree):
        return {(tree, positive)}
    return set().union(*(leaves(t, p is positive) for t, p in tree))


def operations(rows):
    """Additions in all rows, shared ones counted once."""
    pairs = {}
    stack = [tree for row in rows for tree, _ in row]
    while stack:
        tree = stack.pop()
        if is_pair(tree) and id(tree) not in pairs:
            pairs[id(tree)] = tree
            stack += [t for t, _ in tree]
    return len(pairs) + sum(len(row) - 1 for row in rows)


def test_a_pair_in_two_rows_is_one_object():
    first, second = share_pairs([plus("a", "b", "c"), plus("a", "b", "d")])
    [one] = [tree for tree, _ in first if is_pair(tree)]
    [two] = [tree for tree, _ in second if is_pair(tree)]
    assert one is two


def test_rows_without_a_common_pair_stay_as_they_are():
    rows = [plus("a", "b"), plus("a", "c")]
    assert share_pairs(rows) == rows


def test_a_difference_is_shared_with_its_negative():
    rows = [mixed("a-b+c"), mixed("b-a+d")]
    shared = share_pairs(rows)
    assert operations(shared) == 3
    for row, found in zip(rows, shared, strict=True):
        assert set().union(*(leaves(*term) for term in found)) == set(row)


def test_a_difference_is_not_shared_with_a_sum():
    assert operations(share_pairs([mixed("a-b+c"), mixed("a+b+d")])) == 4


def test_sums_over_everything_below_cost_one_addition_each():
    for n in (8, 60):
        rows = [plus(*range(k, n), f"own {k}") for k in range(n - 1)]
        ordered = [sorted(row, key=lambda term: -str(term[0]).isdigit() * int(n)) for row in rows]
        # Each row: its own term on top of the sum that the row below has.
        assert operations(share_pairs([row[::-1] for row in ordered])) <= 2 * n
