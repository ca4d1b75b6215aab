"""Numbers, texts and points: NumPy, SciPy and CPython itself."""

import numpy as np
from scipy.spatial import cKDTree

from .points import cloud
from .work import Peer


def million_items(n):
    def work(_):
        x = 0.001 * np.arange(n)
        y, z = np.sin(x), np.zeros(n)
        x, y, z = x + 0.0, y + 0.0, z + 10.0
        return np.cumsum(np.sqrt(x * x + y * y + z * z))

    return Peer(lambda: None, work, lambda partial: {"sum": [partial[-1]], "count": [n]})


def expression(n):
    return Peer(lambda: np.arange(n, dtype=float), lambda x: x**2 + np.sin(x), lambda result: {"sum": [result.sum()]})


def text_of_numbers(n):
    return Peer(
        lambda: (np.arange(n) * 0.37).tolist(),
        lambda numbers: [f"{number:.2f}" for number in numbers],
        lambda result: {"text": result},
    )


def sets_of_strings(n):
    def given():
        return tuple(
            [f"item {x % 100003}" for x in range(first, first + n * step, step)] for first, step in ((0, 7), (3, 11))
        )

    def work(lists):
        a, b = lists
        in_b = set(b)
        created = dict.fromkeys(a)
        return (
            list(created),
            list(dict.fromkeys(a + b)),
            [text for text in created if text in in_b],
            [text for text in created if text not in in_b],
        )

    def answer(result):
        created, union, both, first = result
        return {"created": created, "union": [len(union)], "both": both, "first": first}

    return Peer(given, work, answer)


def closest_point(n):
    def work(points):
        p, q = points
        return cKDTree(q).query(p)

    def answer(result):
        return {"distance": result[0].tolist(), "index": result[1].tolist()}

    return Peer(lambda: (cloud(n, 12.9898, 78.233, 37.7), cloud(n, 1.98, 7.233, 3.7)), work, answer)


def sort_list(n):
    def work(given):
        values, keys = given
        order = np.argsort(keys, kind="stable")
        return keys[order], values[order]

    def given():
        values = np.arange(n, dtype=float)
        return values, np.sin(values * 12.9898)

    return Peer(given, work, lambda result: {"keys": result[0].tolist(), "values": result[1].tolist()})


def cross_matched(n):
    def work(_):
        x = np.repeat(np.arange(n, dtype=float), 100)
        y = np.tile(0.5 * np.arange(100), n)
        z = np.tile(np.minimum(np.arange(100), 2) + 1.0, n)
        return np.sqrt(x * x + y * y + z * z)

    return Peer(lambda: None, work, lambda result: {"sum": [result.sum()]})


NUMBERS = {
    "Million items": million_items,
    "Expression": expression,
    "Format": text_of_numbers,
    "Sets of strings": sets_of_strings,
    "Closest Point": closest_point,
    "Sort List": sort_list,
    "Cross-matched lists": cross_matched,
}
