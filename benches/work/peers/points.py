"""The points of `definitions.py`, by the same formulas."""

from math import isqrt

import numpy as np


def grid(n, step):
    side = max(1, isqrt(n))
    i = np.arange(n)
    return np.stack([i % side * step, i // side * step, np.zeros(n)], axis=1)


def cloud(n, a, b, c=None):
    i = np.arange(n, dtype=float)
    z = np.sin(i * c) * 100 if c else np.zeros(n)
    return np.stack([np.sin(i * a) * 100, np.sin(i * b + 1) * 100, z], axis=1)


ORIGIN = np.zeros(3)


def sphere(centre, radius, u, v, quads=False):
    """The vertices and faces of a mesh sphere: rings from the south, `u` around and `v` up. Its faces are triangles, or
    with `quads` lists of three and of four."""
    around = np.arange(u) * (2 * np.pi / u)
    up = np.arange(1, v) * (np.pi / v) - np.pi / 2
    ring = np.stack([np.cos(around), np.sin(around), np.zeros(u)], axis=1)
    pole = np.array([[0, 0, 1.0]])
    rings = ring[None] * np.cos(up)[:, None, None] + pole * np.sin(up)[:, None, None]
    vertices = np.concatenate([-pole, rings.reshape(-1, 3), pole]) * radius + centre
    first = np.arange(u)
    after = (first + 1) % u
    low = 1 + u * np.arange(v - 2)[:, None]
    a, b, c, d = (corner.ravel() for corner in (low + first, low + after, low + u + after, low + u + first))
    top = 1 + (v - 2) * u
    south = np.stack([np.zeros(u, int), 1 + after, 1 + first], axis=1)
    north = np.stack([top + first, top + after, np.full(u, len(vertices) - 1)], axis=1)
    if quads:
        return vertices, [*south.tolist(), *np.stack([a, b, c, d], axis=1).tolist(), *north.tolist()]
    return vertices, np.concatenate([south, np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1), north])
