"""Files: Open CASCADE writes and reads STEP, rhino3dm .3dm."""

import tempfile
from pathlib import Path

import rhino3dm
from OCP.BRep import BRep_Builder
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
from OCP.gp import gp_Pnt
from OCP.Message import Message
from OCP.STEPControl import STEPControl_AsIs, STEPControl_Reader, STEPControl_Writer
from OCP.TopAbs import TopAbs_SOLID
from OCP.TopoDS import TopoDS_Compound

from .points import grid, sphere
from .solids import every, volume
from .work import Peer


def written(ending, write):
    """Work that writes a file, and gives its bytes."""

    def work(given):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / ("peer." + ending)
            write(given, str(path))
            return path.read_bytes()

    return work


def answered(ending, read):
    """The answer of bytes, by what reads a file."""

    def answer(content):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / ("peer." + ending)
            path.write_bytes(content)
            return read(str(path))

    return answer


def read_step(path):
    reader = STEPControl_Reader()
    reader.ReadFile(path)
    reader.TransferRoots()
    volumes = sorted(volume(solid) for solid in every(reader.OneShape(), TopAbs_SOLID))
    return {"solids": [len(volumes)], "volume": volumes}


def step_of_boxes(n):
    # It would tell on standard output, where the judge speaks, what it transfers.
    messages = Message.DefaultMessenger_s()
    messages.ChangePrinters().Clear()

    def given():
        return [(x, y, 2 * (1 + 0.01 * i)) for i, (x, y, _) in enumerate(grid(n, 5).tolist())]

    def write(boxes, path):
        # One after another they would take it a time that grows with the square.
        together, builder = TopoDS_Compound(), BRep_Builder()
        builder.MakeCompound(together)
        for x, y, z in boxes:
            builder.Add(together, BRepPrimAPI_MakeBox(gp_Pnt(x - 1, y - 2, -z / 2), 2.0, 4.0, z).Shape())
        writer = STEPControl_Writer()
        writer.Transfer(together, STEPControl_AsIs)
        writer.Write(path)

    return Peer(given, written("step", write), answered("step", read_step), read_step)


def read_3dm(path):
    meshes = [one.Geometry for one in rhino3dm.File3dm.Read(path).Objects]
    boxes = [mesh.GetBoundingBox() for mesh in meshes]
    return {
        "vertices": [len(mesh.Vertices) for mesh in meshes],
        "faces": [mesh.Faces.Count for mesh in meshes],
        "middle": [one for box in boxes for one in (box.Center.X, box.Center.Y, box.Center.Z)],
    }


def mesh_of(vertices, faces):
    mesh = rhino3dm.Mesh()
    for vertex in vertices.tolist():
        mesh.Vertices.Add(*vertex)
    for face in faces:
        mesh.Faces.AddFace(*face)
    return mesh


def meshes_3dm(n):
    def given():
        return [mesh_of(*sphere(centre, 1, 24, 24, quads=True)) for centre in grid(n, 3)]

    def write(meshes, path):
        model = rhino3dm.File3dm()
        for mesh in meshes:
            model.Objects.AddMesh(mesh)
        model.Write(path, 8)

    return Peer(given, written("3dm", write), answered("3dm", read_3dm), read_3dm)


FILES = {"STEP of boxes": step_of_boxes, "3dm of meshes": meshes_3dm}
