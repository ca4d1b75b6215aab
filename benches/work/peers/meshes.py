"""Meshes: libigl, manifold3d, trimesh, and NumPy on their vertices."""

from math import isqrt

import igl
import manifold3d
import numpy as np
import trimesh

from .points import ORIGIN, grid, sphere
from .work import Peer


def mesh_closest_point(n):
    def given():
        i = np.arange(n, dtype=float)
        points = np.stack([np.sin(i), np.cos(i * 1.3), np.sin(i * 1.7)], axis=1) * 11
        return points, *sphere(ORIGIN, 10, isqrt(2 * n), isqrt(2 * n))

    def answer(result):
        return {"distance": np.sqrt(result[0]).tolist()}

    return Peer(given, lambda given: igl.point_mesh_squared_distance(*given), answer)


def booleans_of_spheres(n):
    def given():
        return [sphere(centre, 1, 24, 24) for centre in grid(n, 1.2)]

    def work(meshes):
        solids = [
            manifold3d.Manifold(manifold3d.Mesh64(vertices, faces.astype(np.uint64))) for vertices, faces in meshes
        ]
        united = manifold3d.Manifold.batch_boolean(solids, manifold3d.OpType.Add)
        # It works when it is asked for a result.
        united.to_mesh64()
        return united

    def answer(united):
        return {"volume": [united.volume()], "meshes": [len(united.decompose())]}

    return Peer(given, work, answer)


def contours(n):
    step, direction = 0.37, np.array([0.1, 0.2, 1.0])
    direction /= np.linalg.norm(direction)
    start = np.array([0, 0, -10.0])

    def given():
        return trimesh.Trimesh(*sphere(ORIGIN, 10, isqrt(n), isqrt(n)), process=False)

    def work(mesh):
        heights = (mesh.vertices - start) @ direction
        first, last = np.ceil(heights.min() / step), np.floor(heights.max() / step)
        sections = mesh.section_multiplane(start, direction, np.arange(first, last + 1) * step)
        return [section for section in sections if section is not None]

    def answer(sections):
        return {
            "count": [sum(len(section.entities) for section in sections)],
            "length": [sum(section.length for section in sections)],
        }

    return Peer(given, work, answer)


def transforms(n):
    axis = np.array([1, 0, 0.0]), np.array([0, 0.6, 0.8])
    normal = np.cross(*axis)

    def work(given):
        vertices, _ = given
        moved = []
        for i in range(n):
            angle = i * 0.1
            turn = trimesh.transformations.rotation_matrix(angle, normal)[:3, :3]
            moved.append(vertices @ turn.T + np.array([i * 3.0, 0, 0]))
        return given[1], moved

    def answer(result):
        faces, moved = result
        areas, middles = [], []
        for vertices in moved:
            a, b, c = (vertices[faces[:, k]] for k in range(3))
            area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
            areas.append(area.sum())
            middles += ((a + b + c) / 3 * area[:, None]).sum(axis=0).tolist()
        return {"area": areas, "middle": [one / areas[0] for one in middles]}

    return Peer(lambda: sphere(ORIGIN, 1, 24, 24), work, answer)


MESHES = {
    "Mesh Closest Point": mesh_closest_point,
    "Mesh booleans of spheres": booleans_of_spheres,
    "Contours of a mesh": contours,
    "Transforms of mesh spheres": transforms,
}
