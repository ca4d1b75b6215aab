from typing import Any, Optional

from . import backend as backend, interop as interop, notebook as notebook, rhino as rhino, studies as studies
from ._katydid import (
    BoundingBox as BoundingBox, Box as Box, Brep as Brep, Change as Change, Colour as Colour, Curve as Curve,
    Definition as Definition, FileError as FileError, GeometryError as GeometryError, Input as Input,
    InputError as InputError, Interval as Interval, Item as Item, KatydidError as KatydidError, LimitError as LimitError,
    Mesh as Mesh, Message as Message, Model as Model, ModelObject as ModelObject, NotSupportedError as NotSupportedError,
    Output as Output, Plane as Plane, Point as Point, Solution as Solution, SolveError as SolveError, StrPath, SubD as SubD,
    Surface as Surface, Transform as Transform, Tree as Tree, Vector as Vector, cone as cone, cylinder as cylinder,
    diff as diff, extrude as extrude, intersect as intersect, loft as loft, pipe as pipe, planar_faces as planar_faces,
    read as read, revolve as revolve, sphere as sphere, sweep as sweep, torus as torus, write as write)
from .interop import (
    from_compas as from_compas, from_rhino3dm as from_rhino3dm, from_trimesh as from_trimesh, to_compas as to_compas,
    to_rhino3dm as to_rhino3dm, to_trimesh as to_trimesh)
from .studies import study as study

def open(path: StrPath, *, allow_scripts: bool = False, python: Optional[StrPath] = None) -> Definition: ...
def from_json(form: str) -> Any: ...
def picture(*geometry: Any, size: tuple[int, int] = (800, 600), view: Optional[str] = None) -> bytes: ...
def to_glb(*geometry: Any) -> bytes: ...
