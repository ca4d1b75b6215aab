"""Regions, polylines and diagrams in the plane: shapely and SciPy."""

import numpy as np
import shapely
from scipy.spatial import Delaunay

from .points import cloud, grid
from .work import Peer

# Sides a quarter of shapely's circles.
SIDES = 16


def union(shapes):
    def answer(result):
        rings = [ring for part in shapely.get_parts(result) for ring in [part.exterior, *part.interiors]]
        areas = shapely.area(shapely.polygons(rings))
        return {"curves": [len(rings)], "length": [shapely.length(rings).sum()], "area": [areas.sum()]}

    return Peer(shapes, shapely.union_all, answer)


def union_of_circles(n):
    return union(lambda: shapely.buffer(shapely.points(grid(n, 1.5)[:, :2]), 1, quad_segs=SIDES))


def polygons(centres, radii):
    """A polygon around each centre, its corners at equal angles."""
    angle = np.arange(len(radii)) * (2 * np.pi / len(radii))
    corners = np.stack([np.cos(angle), np.sin(angle)], axis=1) * np.asarray(radii, dtype=float)[:, None]
    return shapely.polygons(centres[:, None, :2] + corners)


def union_of_hexagons(n):
    return union(lambda: polygons(grid(n, 1.5), [1] * 6))


def offset_of_stars(n):
    return Peer(
        lambda: polygons(grid(n, 5), [2, 1] * 5),
        lambda stars: shapely.buffer(stars, 0.1, join_style="mitre", mitre_limit=10),
        lambda result: {"area": shapely.area(result).tolist()},
    )


def many_lines(n):
    def given():
        i = np.arange(n)
        start = grid(n, 3)[:, :2]
        along = 9 * np.stack([np.sin(i * 3.7), np.cos(i * 5.1)], axis=1)
        return shapely.linestrings(np.stack([start, start + along], axis=1))

    def work(lines):
        # What comes within the tolerance of a document in millimetres meets.
        a, b = shapely.STRtree(lines).query(lines, predicate="dwithin", distance=0.001)
        once = a < b
        return shapely.get_coordinates(shapely.shortest_line(lines[a[once]], lines[b[once]]))[::2]

    def answer(points):
        x, y = points.sum(axis=0)
        return {"count": [len(points)], "sum": [x], "other": [y]}

    return Peer(given, work, answer)


def voronoi(n):
    box = shapely.box(-101, -101, 101, 101)

    def work(points):
        cells = shapely.get_parts(shapely.voronoi_polygons(points, extend_to=box))
        return shapely.intersection(cells, box)

    return Peer(
        lambda: shapely.multipoints(cloud(n, 12.9898, 78.233)[:, :2]),
        work,
        lambda cells: {"area": sorted(shapely.area(cells).tolist())},
    )


def delaunay(n):
    def answer(result):
        corners = result.points[result.simplices]
        (ax, ay), (bx, by) = (corners[:, 1] - corners[:, 0]).T, (corners[:, 2] - corners[:, 0]).T
        return {"area": [np.abs(ax * by - ay * bx).sum() / 2], "faces": [len(result.simplices)]}

    return Peer(lambda: cloud(n, 12.9898, 78.233)[:, :2], Delaunay, answer)


PLANE = {
    "Region Union of circles": union_of_circles,
    "Region Union of hexagons": union_of_hexagons,
    "Offset Polyline of stars": offset_of_stars,
    "Many lines": many_lines,
    "Voronoi": voronoi,
    "Delaunay": delaunay,
}
