"""Trees: no peer has them, the answers are known beforehand."""

from .work import closed


def simplify_tree(n):
    return closed({"paths": [f"{{{i}}}" for i in range(n)], "items": list(range(n))})


def replace_paths(n):
    return closed({"paths": [f"{{0;0;{i}}}" for i in range(n)], "items": list(range(n - 1, -1, -1))})


def tree_components(n):
    """Of n branches with ten items each."""
    whole, total = 10 * n, 10 * n * (10 * n - 1) / 2
    return closed(
        {
            "flipped": [n] * 10,
            "paths": [whole],
            "flat": [total],
            "lists": [n],
            "shifted": [10] * n,
            "trimmed": [total],
            "pruned": [whole],
            "cleaned": [whole],
            "split": [whole],
            "branches": [total],
            "matched": [whole],
            "merged": [20] * n,
            "simple": [total],
        }
    )


TREES = {"Simplify Tree": simplify_tree, "Replace Paths": replace_paths, "Tree components": tree_components}
