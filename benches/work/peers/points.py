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


def sphere(centre, radius, u, v):
    """The vertices and triangles of a mesh sphere: rings from the south, `u` around and `v` up."""
    around = np.arange(u) * (2 * np.pi / u)
    up = np.arange(1, v) * (np.pi / v) - np.pi / 2
    ring = np.stack([np.cos(around), np.sin(around), np.zeros(u)], axis=1)
    rings = ring[None] * np.cos(up)[:, None, None] + np.array([0, 0, 1]) * np.sin(up)[:, None, None]
    poles = np.array([[0, 0, -1.0]]), np.array([[0, 0, 1.0]])
    vertices = np.concatenate([poles[0], rings.reshape(-1, 3), poles[1]]) * radius + centre
    first = np.arange(u)
    after = (first + 1) % u
    faces = [np.stack([np.zeros(u, int), 1 + after, 1 + first], axis=1)]
    for low in range(1, 1 + (v - 2) * u, u):
        a, b, c, d = low + first, low + after, low + u + after, low + u + first
        faces += [np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]
    low = 1 + (v - 2) * u
    faces.append(np.stack([low + first, low + after, np.full(u, len(vertices) - 1)], axis=1))
    return vertices, np.concatenate(faces)
