"""Trees: no peer has them, the answers are known beforehand."""

from .work import closed


def simplify_tree(n):
    return closed({"paths": [f"{{{i}}}" for i in range(n)], "items": list(range(n))})


def replace_paths(n):
    return closed({"paths": [f"{{0;0;{i}}}" for i in range(n)], "items": list(range(n - 1, -1, -1))})


TREES = {"Simplify Tree": simplify_tree, "Replace Paths": replace_paths}
