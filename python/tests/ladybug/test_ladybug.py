"""Ladybug's packages, as the user installs them, in a script of our own: sun hours of a box.

A box is convex, so a face sees the sun whenever the sun stands before it: that is the closed form. `make test-ladybug`
installs the packages; nothing of theirs is part of the project.
"""

import pytest
from hosts import Members, WorkerProcess, errors, program
from katydid.values import BoundingBox, Box

pytest.importorskip("ladybug_rhino", reason="ladybug-rhino is not installed: Ladybug was not tested")
pytestmark = pytest.mark.skipif(program() is None, reason="KATYDID names no program: Ladybug was not tested")

CODE = """
from ladybug.sunpath import Sunpath
from ladybug_rhino.togeometry import to_joined_gridded_mesh3d
from ladybug_rhino.fromgeometry import from_point3d, from_vector3d
from ladybug_rhino.intersect import join_geometry_to_mesh, intersect_mesh_rays
from ladybug_rhino.grasshopper import give_warning

path = Sunpath(48.0, 11.0)
suns = [path.calculate_sun(6, 21, hour) for hour in range(6, 19)]
toward = [from_vector3d(sun.sun_vector_reversed) for sun in suns]
mesh = to_joined_gridded_mesh3d([box], 1.0)
places = [from_point3d(p.move(n * 0.01)) for p, n in zip(mesh.face_centroids, mesh.face_normals)]
normals = [from_vector3d(n) for n in mesh.face_normals]
matrix, angles = intersect_mesh_rays(join_geometry_to_mesh([box]), places, toward, normals, 1)
hours = [sum(row) for row in matrix]
expected = [sum(1 for v in toward if v.Z > 0 and n * v > 0) for n in normals]
altitude = max(sun.altitude for sun in suns)
give_warning(ghenv.Component, 'seen')
"""


def test_sun_hours_of_a_box():
    members = Members(program())
    worker = WorkerProcess(members)
    box = members.call("Brep.CreateFromBox", Box(BoundingBox(0, 0, 0, 2, 3, 4)))
    values, result = worker.run(CODE, {"box": box}, outputs=("hours", "expected", "altitude"))
    worker.close()
    members.close()
    assert not errors(result), errors(result)[0]
    # One face a square metre of the 52 of a box of 2 by 3 by 4.
    assert len(values["hours"]) == 52 and values["hours"] == values["expected"]
    # On the longest day the sun stands 23.4 degrees above 90 - latitude at noon.
    assert 65.0 < values["altitude"] < 65.45
    assert result["messages"] == [["warning", "seen", -1]]
