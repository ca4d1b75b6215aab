"""SubDs: no peer has them as Katydid does. The answer is Catmull and Clark's rules, on a cube, by themselves."""

import numpy as np

from .work import closed


def cube(parts):
    """The squares on the sides of a unit cube, each side cut in so many both ways, as vertices and faces."""
    places, faces = {}, []
    for axis in range(3):
        for side in (0, parts):
            for i in range(parts):
                for j in range(parts):
                    corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                    cell = [np.insert(np.array(corner), axis, side) for corner in corners]
                    outwards = (side > 0) == (axis != 1)
                    face = [places.setdefault(tuple(corner.tolist()), len(places)) for corner in cell]
                    faces.append(face if outwards else face[::-1])
    return np.array(list(places), dtype=float) / parts, np.array(faces)


def edges_of(faces):
    """The edges, and for each side of each face the number of its edge."""
    sides = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    edges, which = np.unique(sides, axis=0, return_inverse=True)
    return edges, which.reshape(-1, 4)


def sums(count, at, values):
    total = np.zeros((count, 3))
    np.add.at(total, at.ravel(), values)
    return total


def valences(vertices, edges):
    return np.bincount(edges.ravel(), minlength=len(vertices))[:, None]


def subdivided(vertices, faces):
    """One step of Catmull and Clark's on a closed mesh of quads."""
    edges, which = edges_of(faces)
    n = valences(vertices, edges)
    middles = vertices[faces].mean(axis=1)
    halves = vertices[edges].mean(axis=1)
    around = sums(len(edges), which, np.repeat(middles, 4, axis=0)) / 2
    moved = (
        sums(len(vertices), faces, np.repeat(middles, 4, axis=0)) / n
        + 2 * sums(len(vertices), edges, np.repeat(halves, 2, axis=0)) / n
        + (n - 3) * vertices
    ) / n
    of_edge, of_face = len(vertices), len(vertices) + len(edges)
    quads = [
        np.stack(
            [faces[:, k], of_edge + which[:, k], of_face + np.arange(len(faces)), of_edge + which[:, k - 1]], axis=1
        )
        for k in range(4)
    ]
    return np.concatenate([moved, (halves + around) / 2, middles]), np.concatenate(quads)


def at_limit(vertices, faces):
    """Where the vertices come to in the end (Halstead, Kass and DeRose, 1993)."""
    edges, _ = edges_of(faces)
    n = valences(vertices, edges)
    beside = sums(len(vertices), edges, vertices[edges[:, ::-1]].reshape(-1, 3))
    across = sums(len(vertices), faces, vertices[np.roll(faces, 2, axis=1)].reshape(-1, 3))
    return (n * n * vertices + 4 * beside + across) / (n * (n + 5))


def volume(vertices, faces):
    """The volume within quads, each cut in two from its first corner."""
    a, b, c, d = (vertices[faces[:, k]] for k in range(4))
    return (np.cross(a, b) * c + np.cross(a, c) * d).sum() / 6


def subd_boxes(n):
    vertices, faces = cube(2)
    for _ in range(3):
        vertices, faces = subdivided(vertices, faces)
    # A box is a cube, scaled, and so is all that comes of it.
    once = volume(at_limit(vertices, faces), faces)
    return closed({"faces": [len(faces)] * n, "volume": [2 * (1 + 0.01 * i) * once for i in range(n)]})


SUBD = {"SubD boxes": subd_boxes}
