"""The extension module. Use it through the package `katydid`."""

import os
from collections.abc import Callable, Iterator, Sequence
from typing import Any, Union

StrPath = Union[str, "os.PathLike[str]"]
_Counts = tuple[int, int, int, int, float]
_Summed = tuple[_Counts, int, list[StrPath]]
_Columns = tuple[list[Any], list[Any], list[str], list[str]]
#: A NumPy array where NumPy is installed, else a list.
Array = Any
ArrayLike = Any
PointLike = Union["Point", Sequence[float], Array]
VectorLike = Union["Vector", Sequence[float], Array]
IntervalLike = Union["Interval", Sequence[float]]
PlaneLike = Union["Plane", PointLike, None]

class KatydidError(Exception):
    """What went wrong in Katydid; all its exceptions are of this class."""

class FileError(KatydidError):
    """A file cannot be read or written."""

class InputError(KatydidError):
    """There is no such input, or it does not take that value."""

class SolveError(KatydidError):
    """Components of a definition reported errors."""

class LimitError(KatydidError):
    """A limit of time, memory or items was reached."""

class GeometryError(KatydidError):
    """Geometry that cannot be made of what was given."""

class NotSupportedError(KatydidError):
    """What Katydid does not do, by its name."""

class BoundingBox:
    """A box along the world's axes: what geometry is inside of."""

    def __init__(self, a: PointLike, b: PointLike) -> None:
        """The box between two opposite corners."""

    @staticmethod
    def of_points(points: ArrayLike) -> BoundingBox | None:
        """The box around points, an array of shape (n, 3)."""

    @property
    def min(self) -> Point:
        """The corner with the smallest coordinates."""

    @property
    def max(self) -> Point:
        """The corner with the largest coordinates."""

    @property
    def center(self) -> Point:
        """The middle."""

    @property
    def diagonal(self) -> float:
        """The length of the diagonal."""

    def __contains__(self, point: PointLike) -> bool: ...

    def union(self, other: BoundingBox) -> BoundingBox:
        """The box around both."""

    def __eq__(self, other: object) -> bool: ...

    def __repr__(self) -> str: ...

class Box:
    """A box in a plane's frame, by its ranges along the three axes."""

    def __init__(self, plane: PlaneLike, x: IntervalLike, y: IntervalLike, z: IntervalLike) -> None:
        """The box in a frame with ranges along its axes."""

    @property
    def plane(self) -> Plane:
        """The frame."""

    @property
    def x(self) -> Interval:
        """The range along the x axis."""

    @property
    def y(self) -> Interval:
        """The range along the y axis."""

    @property
    def z(self) -> Interval:
        """The range along the z axis."""

    @property
    def center(self) -> Point:
        """The middle."""

    @property
    def area(self) -> float:
        """The area of the six sides."""

    @property
    def volume(self) -> float:
        """The volume."""

    @property
    def corners(self) -> Array:
        """The eight corners as an array of shape (8, 3)."""

    def to_brep(self) -> Brep:
        """The solid of its six sides."""

    def contains(self, point: PointLike, tolerance: float = 0.0) -> bool:
        """Whether a point is inside, or outside by no more than the tolerance."""

    def __eq__(self, other: object) -> bool: ...

    def __repr__(self) -> str: ...

class Brep:
    """Faces on trimmed surfaces, joined along edges: a solid where they enclose a volume."""

    @property
    def face_count(self) -> int:
        """How many faces there are."""

    @property
    def edge_count(self) -> int:
        """How many edges there are."""

    @property
    def vertices(self) -> Array:
        """The corners as an array of shape (n, 3)."""

    @property
    def edges(self) -> list[Curve]:
        """The edges as curves; an edge without a length is left out."""

    @property
    def faces(self) -> list[Brep]:
        """The faces, each as a Brep of its own."""

    def face_surface(self, face: int) -> Surface:
        """The surface that a face lies on, without its trims."""

    @property
    def is_solid(self) -> bool:
        """Whether it encloses a volume."""

    @property
    def is_valid(self) -> bool:
        """Whether it keeps to all rules of its kind."""

    @property
    def area(self) -> float:
        """The area of all faces in square units."""

    @property
    def volume(self) -> float:
        """The volume of a solid in cubic units."""

    @property
    def centroid(self) -> Point:
        """The mean of all points: of the volume of a solid, else of the area."""

    @property
    def bounding_box(self) -> BoundingBox:
        """The box along the world's axes around it."""

    @property
    def naked_edges(self) -> list[Curve]:
        """Where edges have a face on one side only, as curves."""

    def closest_point(self, point: PointLike) -> tuple[Point, float, Vector | None]:
        """The nearest place to a point: the point, the distance, and the normal there."""

    def contains(self, point: PointLike, tolerance: float = 0.001) -> int:
        """Whether a point is in a solid: 1 inside, 0 on its faces, -1 outside."""

    def section(self, plane: PlaneLike, tolerance: float = 0.001) -> list[Curve]:
        """The curves in which a plane cuts it."""

    def split(self, plane: PlaneLike, tolerance: float = 0.001) -> tuple[list[Brep], list[Brep]]:
        """The parts on both sides of a plane, first those that its normal points away from."""

    def union(self, other: Brep | Sequence[Brep], tolerance: float = 0.001) -> list[Brep]:
        """The solids that this one and another, or several, fill together; all must be closed. What is not decided is an
        error that names the case, the faces and the place."""

    def difference(self, other: Brep | Sequence[Brep], tolerance: float = 0.001) -> list[Brep]:
        """What is left of this Brep outside of another, or of several: any number of Breps. An open one divides what it meets,
        and what lies behind it is inside."""

    def intersection(self, other: Brep | Sequence[Brep], tolerance: float = 0.001) -> list[Brep]:
        """What this Brep has in common with another, or with any of several."""

    def __or__(self, other: Brep | Sequence[Brep]) -> list[Brep]: ...

    def __sub__(self, other: Brep | Sequence[Brep]) -> list[Brep]: ...

    def __and__(self, other: Brep | Sequence[Brep]) -> list[Brep]: ...

    def __ror__(self, other: Sequence[Brep]) -> list[Brep]: ...

    def __rsub__(self, other: Sequence[Brep]) -> list[Brep]: ...

    def __rand__(self, other: Sequence[Brep]) -> list[Brep]: ...

    @staticmethod
    def join(breps: Sequence[Brep], tolerance: float = 0.001) -> list[Brep]:
        """Breps joined along naked edges that run together within a tolerance."""

    def capped(self, tolerance: float = 0.001) -> tuple[Brep, int]:
        """The Brep with its flat openings closed, and how many were."""

    def filleted(self, edges: Sequence[int], radius: ArrayLike, *, blend: str = "arc", tolerance: float = 0.001) -> Brep:
        """The Brep with edges rounded: their places, and a radius or one for each. `blend` is "arc", "smooth" or "chamfer"."""

    def extruded(self, direction: VectorLike, tolerance: float = 0.001) -> Brep:
        """The Brep moved along a direction, and what it passes through, as a solid."""

    def offset(self, distance: float, tolerance: float = 0.001) -> list[Brep]:
        """Breps at a distance along the normals."""

    def flipped(self) -> Brep:
        """The Brep with its normals the other way."""

    def to_mesh(self, tolerance: float | None = None) -> Mesh:
        """A mesh, its faces joined along the edges. Without a tolerance it is as fine as Rhino shades with: about 0.0005 of
        the size."""

    def transformed(self, transform: Transform) -> Brep:
        """The Brep under a transform."""

    def to_json(self) -> str:
        """The form that rhino3dm and Rhino.Compute speak, as JSON text."""

    def __eq__(self, other: object) -> bool: ...

    def __repr__(self) -> str: ...

class Change:
    """One thing that differs between two definitions."""

    @property
    def kind(self) -> str:
        """What sort of change it is: "added", "removed", "wires", "value" and so on."""

    @property
    def clusters(self) -> list[str]:
        """The clusters that it is in, from the outside in."""

    @property
    def object(self) -> str:
        """The object, as its author calls it; empty where the change is the document's."""

    @property
    def id(self) -> str | None:
        """The object's id."""

    @property
    def text(self) -> str:
        """What happened to it, in words."""

    def __str__(self) -> str: ...

    def __repr__(self) -> str: ...

class Colour:
    """A colour of four channels from 0 to 255 each: red, green, blue, and opacity."""

    def __init__(self, r: int, g: int, b: int, a: int = 255) -> None:
        """The colour of its channels."""

    @property
    def r(self) -> int:
        """Red."""

    @property
    def g(self) -> int:
        """Green."""

    @property
    def b(self) -> int:
        """Blue."""

    @property
    def a(self) -> int:
        """Opacity: 255 is opaque."""

    def __len__(self) -> int: ...

    def __iter__(self) -> Iterator[Any]: ...

    def __eq__(self, other: object) -> bool: ...

    def __hash__(self) -> int: ...

    def __repr__(self) -> str: ...

class Curve:
    """A curve: a line, an arc, a polyline, a NURBS curve, or several joined. It never changes; what edits it gives another.

    Parameters are those of its `domain`. Functions ending in `s` take arrays of parameters of shape (n,), and give arrays
    of shape (n,) or (n, 3)."""

    @property
    def kind(self) -> str:
        """What it is: "line", "arc", "circle", "polyline", "nurbs" or "polycurve"."""

    @property
    def domain(self) -> Interval:
        """The range of the parameter."""

    @property
    def start(self) -> Point:
        """The first point."""

    @property
    def end(self) -> Point:
        """The last point."""

    @property
    def length(self) -> float:
        """The length in model units."""

    @property
    def is_closed(self) -> bool:
        """Whether it ends where it begins."""

    @property
    def is_periodic(self) -> bool:
        """Whether it goes on smoothly over its ends, as a periodic NURBS curve does."""

    @property
    def bounding_box(self) -> BoundingBox:
        """The box along the world's axes around it."""

    def point_at(self, t: float) -> Point:
        """The point at a parameter."""

    def points_at(self, t: ArrayLike) -> Array:
        """The points at parameters, an array of shape (n,), as an array of shape (n, 3)."""

    def tangent_at(self, t: float) -> Vector:
        """The direction of length 1 at a parameter."""

    def tangents_at(self, t: ArrayLike) -> Array:
        """The directions of length 1 at parameters, an array of shape (n,), as an array of shape (n, 3); zero where the curve
        has none."""

    def derivatives_at(self, t: float, count: int = 1) -> list[Vector]:
        """The derivatives of order 1, 2 … `count` by the parameter, at most 64."""

    def curvature_at(self, t: float) -> Vector:
        """The curvature vector at a parameter: towards the centre of the osculating circle, as long as 1/radius."""

    def curvatures_at(self, t: ArrayLike) -> Array:
        """The curvature vectors at parameters, an array of shape (n,), as an array of shape (n, 3)."""

    def torsion_at(self, t: float) -> float:
        """The torsion at a parameter in 1/units."""

    def frame_at(self, t: float) -> Plane:
        """The plane at a parameter with the tangent for its x axis and the curvature for its y axis."""

    def perpendicular_frames(self, t: ArrayLike) -> list[Plane | None]:
        """Planes across the curve at parameters, an array of shape (n,), that turn about it as little as can be."""

    def length_between(self, domain: IntervalLike) -> float:
        """The length from the start to a parameter, or between two."""

    def parameter_at_length(self, length: float, *, normalized: bool = False) -> float:
        """The parameter at a length from the start, or of a fraction of the length where `normalized`."""

    def divide(self, count: int) -> Array:
        """Parameters that divide the curve into so many parts of equal length, as an array of shape (n,).

        An open curve has both its ends among them; a closed one its seam once."""

    def divide_by_length(self, length: float) -> Array:
        """Parameters at equal lengths from the start on, as an array of shape (n,)."""

    def closest_point(self, point: PointLike) -> tuple[float, Point, float]:
        """The nearest place to a point: the parameter, the point there, and the distance."""

    def closest_points(self, points: ArrayLike) -> list[Array]:
        """The nearest places to points, an array of shape (n, 3): arrays of parameters (n,), points (n, 3), distances (n,)."""

    def plane(self, tolerance: float = 0.001) -> Plane | None:
        """The plane that the curve lies in; none where it lies in none within the tolerance."""

    def area_and_centroid(self, tolerance: float = 0.001) -> tuple[float, Point]:
        """The area that a closed planar curve encloses, and its centroid."""

    def contains(self, point: PointLike, plane: PlaneLike | None = None, tolerance: float = 0.001) -> int:
        """Whether a point is inside a closed curve as seen in a plane: 1 inside, 0 on the curve, -1 outside."""

    def turning_points(self, direction: VectorLike) -> list[float]:
        """The parameters at which the curve goes farthest in a direction or turns back, in order."""

    def transformed(self, transform: Transform) -> Curve:
        """The curve under a transform."""

    def to_json(self) -> str:
        """The form that rhino3dm and Rhino.Compute speak, as JSON text."""

    def __eq__(self, other: object) -> bool: ...

    def __repr__(self) -> str: ...

    def reversed(self) -> Curve:
        """The curve run through the other way."""

    def trimmed(self, domain: IntervalLike) -> Curve:
        """The part over a range of parameters."""

    def with_domain(self, domain: IntervalLike) -> Curve:
        """The same curve with another range of parameters."""

    def with_seam(self, t: float) -> Curve:
        """The closed curve with its seam at a parameter."""

    def split(self, t: ArrayLike) -> list[Curve]:
        """The parts between parameters, an array of shape (n,)."""

    def explode(self, *, recursive: bool = True) -> list[Curve]:
        """The segments of which it is joined."""

    def extended(self, start: float = 0.0, end: float = 0.0, *, style: str = "line") -> Curve:
        """The curve made longer at its ends. `style` is "line", "arc" or "smooth"."""

    def offset(self, distance: float, plane: PlaneLike | None = None, *, corner: str = "sharp", tolerance: float = 0.001) -> list[Curve]:
        """Curves at a distance in a plane, its own where none is given: positive to the right as seen along the normal's
        tip. `corner` is "none", "sharp", "round", "smooth" or "chamfer"."""

    def filleted(self, radius: float, *, tolerance: float = 0.001) -> Curve:
        """The curve with its corners rounded by arcs of a radius, where there is room."""

    def rebuilt(self, count: int, degree: int = 3, *, keep_tangents: bool = True) -> tuple[Curve, float]:
        """A curve of a degree and a number of control points that follows this one, and the largest distance from it."""

    def tween(self, other: Curve, x: float) -> Curve:
        """The curve between this one and another: this one at 0, the other at 1."""

    def to_polyline(self, tolerance: float = 0.001) -> Array:
        """Points on the curve, as an array of shape (n, 3), such that it stays within a distance of the polyline through them."""

    def corners(self) -> Array | None:
        """The corners of a polyline as an array of shape (n, 3); none for a curve that is not made of straight segments."""

    @staticmethod
    def line(start: PointLike, end: PointLike) -> Curve:
        """The straight line between two points."""

    @staticmethod
    def polyline(points: ArrayLike, *, closed: bool = False) -> Curve:
        """The polyline through points, an array of shape (n, 3)."""

    @staticmethod
    def circle(plane: PlaneLike, radius: float) -> Curve:
        """The circle of a radius about the origin of a plane, in that plane."""

    @staticmethod
    def arc(plane: PlaneLike, radius: float, angles: IntervalLike) -> Curve:
        """The part of a circle between two angles in radians from the plane's x axis."""

    @staticmethod
    def arc_through(a: PointLike, b: PointLike, c: PointLike) -> Curve:
        """The arc from a point through a second to a third."""

    @staticmethod
    def ellipse(plane: PlaneLike, radius_x: float, radius_y: float) -> Curve:
        """The ellipse with its radii along a plane's axes."""

    @staticmethod
    def rectangle(plane: PlaneLike, width: float, height: float) -> Curve:
        """The rectangle about a plane's origin, with its sides along the axes."""

    @staticmethod
    def polygon(plane: PlaneLike, radius: float, sides: int) -> Curve:
        """The regular polygon with its corners on a circle, the first on the plane's x axis."""

    @staticmethod
    def nurbs(points: ArrayLike, degree: int = 3, *, weights: ArrayLike | None = None, knots: ArrayLike | None = None, periodic: bool = False) -> Curve:
        """The NURBS curve of control points, an array of shape (n, 3).

        Without knots they are uniform; with them there are n + degree - 1, as in openNURBS. Weights have shape (n,)."""

    @staticmethod
    def interpolate(points: ArrayLike, degree: int = 3, *, spacing: str = "chord", start_tangent: VectorLike | None = None, end_tangent: VectorLike | None = None, closed: bool = False) -> Curve:
        """The curve through points, an array of shape (n, 3). `spacing` is "uniform", "chord" or "sqrt"."""

    @staticmethod
    def join(curves: Sequence[Curve], tolerance: float = 0.001) -> list[Curve]:
        """Curves that meet end to end within a tolerance as one each."""

    @property
    def degree(self) -> int:
        """The degree; of a curve of another kind that of its NURBS form."""

    @property
    def control_points(self) -> Array:
        """The control points as an array of shape (n, 3); of a curve of another kind those of its NURBS form."""

    @property
    def weights(self) -> Array:
        """The weights of the control points as an array of shape (n,)."""

    @property
    def knots(self) -> Array:
        """The knots as an array of shape (n + degree - 1,), as openNURBS has them."""

    def to_nurbs(self) -> Curve:
        """The same curve as one NURBS curve, exactly."""

class Definition:
    """A Grasshopper definition.

    It keeps its last results: a solve computes only what hangs on the inputs that changed. Several threads may solve it at
    once."""

    def __init__(self, path: StrPath, *, allow_scripts: bool = False, python: StrPath | None = None) -> None:
        """Opens a definition: a .gh, .ghx or .kd file. `katydid.open` is the same.

        Its Python scripts run only where `allow_scripts` says so: they are programs, and may do what you may. They run in
        a process of their own, with the interpreter `python`."""

    @property
    def path(self) -> StrPath:
        """The file."""

    @property
    def name(self) -> str:
        """The title that its author gave it, else the name of the file."""

    @property
    def inputs(self) -> list[Input]:
        """What it can be given, what is marked as input first."""

    @property
    def outputs(self) -> list[Output]:
        """What it gives: what is marked as output, or, where nothing is, what no wire leads on from."""

    @property
    def is_changed(self) -> bool:
        """Whether `set` has changed it since it was opened."""

    @property
    def problems(self) -> list[str]:
        """What is wrong with its inputs and outputs, in words: two of one name, say."""

    def __len__(self) -> int:
        """How many objects it has, notes and groups among them."""

    def __bool__(self) -> bool: ...

    def solve(self, inputs: dict[Any, Any] | None = None, *, time_limit: float | None = None, byte_limit: int | None = None, item_limit: int | None = None, progress: Callable[[int, int, str], object] | None = None, **named: Any) -> Solution:
        """Solves it with inputs by their names, as keywords or in a dict; what is not named has what the definition says. The
        definition itself does not change.

        An input takes one item, a list, an array, a dict of lists by paths, or a `Tree`. `progress` is called with the
        objects done, the objects to do, and the name of the last; an exception in it ends the solve, as Ctrl+C does.

        Errors of components are no exceptions: `messages` and `check()` of the solution tell them. Raises `InputError`,
        and `LimitError` where `time_limit`, in seconds, or `byte_limit` is reached."""

    def set(self, name: str, value: Any) -> None:
        """Changes an input of the definition itself, as one does on its canvas, so that `save` keeps it."""

    def save(self, path: StrPath) -> list[str]:
        """Saves the definition as .gh, .ghx or .kd, whole or not at all; gives what the form cannot hold, in words."""

    def picture(self, size: tuple[int, int] = (800, 600), *, canvas: bool = False, view: str | None = None) -> bytes:
        """A picture as PNG: of what the definition shows with its own inputs, or of its canvas where `canvas`.

        `view` is "perspective", "top", "front", "right" or "iso"; without one it is found."""

    def __repr__(self) -> str: ...

class Host:
    """The functions of RhinoCommon that Python's `Rhino.Geometry` calls: what `katydid members --stdio` answers, without a
    process of its own. `katydid.backend` speaks with it."""

    def __init__(self) -> None:
        """A host that holds no geometry yet."""

    def answer(self, message: bytes) -> bytes | None:
        """Answers a message of `katydid.codec`, without its length; nothing for one that has no answer."""

class Input:
    """What a definition can be given: a slider, a panel, a toggle, a list, a parameter without a wire, a contextual input, or
    a group that is marked as input."""

    @property
    def name(self) -> str:
        """The name that `solve` takes."""

    @property
    def kind(self) -> str:
        """The name of the type of its values."""

    @property
    def minimum(self) -> float | None:
        """The smallest number it takes, where there is one."""

    @property
    def maximum(self) -> float | None:
        """The largest number it takes, where there is one."""

    @property
    def description(self) -> str | None:
        """What its author says of it."""

    @property
    def marked(self) -> bool:
        """Whether the author marked it as an input: a contextual input, or one in a group called `RH_IN:name`."""

    @property
    def choices(self) -> list[str] | None:
        """What can be chosen, of a value list."""

    @property
    def value(self) -> str | None:
        """The number, text, truth value or choice that it has now, where it is one."""

    @property
    def id(self) -> str:
        """The id of its object in the definition."""

    def __repr__(self) -> str: ...

class Interval:
    """A directed range of numbers, from `start` to `end`: the domain of a curve, say.

    Wherever a range is asked for, any two numbers will do."""

    def __init__(self, start: float = 0.0, end: float = 1.0) -> None:
        """The range from a start to an end."""

    @property
    def start(self) -> float:
        """Where the range begins."""

    @property
    def end(self) -> float:
        """Where it ends."""

    @property
    def length(self) -> float:
        """The length; negative where the end is smaller than the start."""

    def at(self, x: float) -> float:
        """The number at `x` of the way: the start at 0, the end at 1."""

    def linspace(self, count: int) -> Array:
        """So many numbers evenly from start to end, both among them, as an array of shape (n,)."""

    def __contains__(self, number: float) -> bool: ...

    def __len__(self) -> int: ...

    def __getitem__(self, index: int) -> float: ...

    def __iter__(self) -> Iterator[Any]: ...

    def __eq__(self, other: object) -> bool: ...

    def __hash__(self) -> int: ...

    def __repr__(self) -> str: ...

class Item:
    """A value that Python has no class for: a material, a field, an object of a Rhino model. It goes back into a definition
    as it is."""

    @property
    def kind(self) -> str:
        """The name of its type."""

    def __str__(self) -> str:
        """The text that a panel shows."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: object) -> bool: ...

class Mesh:
    """Vertices, and faces of three or four of them."""

    def __init__(self, vertices: ArrayLike, faces: ArrayLike, *, normals: ArrayLike | None = None, colors: ArrayLike | None = None) -> None:
        """The mesh of vertices, an array of shape (n, 3), and faces, places of vertices in an array of shape (m, 3) or (m, 4),
        or a list of both kinds. A face of four with its last two corners the same is a triangle.

        Normals have shape (n, 3); colours, from 0 to 255, shape (n, 3) or (n, 4) with opacity."""

    @property
    def vertices(self) -> Array:
        """The vertices as an array of shape (n, 3)."""

    @property
    def faces(self) -> Array:
        """The faces as places of vertices, an array of shape (m, 4); the last two corners of a triangle are the same."""

    @property
    def triangles(self) -> Array:
        """The faces cut into triangles, as places of vertices in an array of shape (k, 3)."""

    @property
    def normals(self) -> Array:
        """The normals at the vertices as an array of shape (n, 3): those that it has, or means of its faces' normals."""

    @property
    def face_normals(self) -> Array:
        """The normals of the faces as an array of shape (m, 3)."""

    @property
    def colors(self) -> Array | None:
        """The colours of the vertices as an array of shape (n, 4), from 0 to 255; none where it has none."""

    @property
    def area(self) -> float:
        """The area in square units."""

    @property
    def volume(self) -> float:
        """The volume in cubic units of a closed mesh; negative where its normals point inward."""

    @property
    def centroid(self) -> Point:
        """The mean of all points: of the volume of a closed mesh, else of the area."""

    @property
    def is_closed(self) -> bool:
        """Whether every edge has a face on both sides."""

    @property
    def is_manifold(self) -> bool:
        """Whether no edge has more than two faces."""

    @property
    def bounding_box(self) -> BoundingBox | None:
        """The box along the world's axes around it; none for a mesh without vertices."""

    def transformed(self, transform: Transform) -> Mesh:
        """The mesh under a transform."""

    def to_json(self) -> str:
        """The form that rhino3dm and Rhino.Compute speak, as JSON text."""

    def __len__(self) -> int: ...

    def __bool__(self) -> bool: ...

    def __eq__(self, other: object) -> bool: ...

    def __repr__(self) -> str: ...

    def union(self, other: Mesh) -> Mesh:
        """The solid of both closed meshes together."""

    def difference(self, other: Mesh) -> Mesh:
        """This closed mesh without what is in the other."""

    def intersection(self, other: Mesh) -> Mesh:
        """What is in both closed meshes."""

    def __or__(self, other: Mesh) -> Mesh: ...

    def __sub__(self, other: Mesh) -> Mesh: ...

    def __and__(self, other: Mesh) -> Mesh: ...

    @staticmethod
    def join(meshes: Sequence[Mesh]) -> Mesh:
        """Several meshes as one; vertices are not joined."""

    def pieces(self) -> list[Mesh]:
        """The connected parts."""

    def flipped(self) -> Mesh:
        """The mesh with its faces the other way round."""

    def welded(self, angle: float = ...) -> Mesh:
        """The mesh with vertices in one place joined where faces meet at no more than an angle in radians."""

    def decimated(self, faces: int, *, max_error: float = ...) -> Mesh:
        """The mesh with fewer triangles: about so many."""

    def smoothed(self, iterations: int = 1, strength: float = 0.5, *, keep_naked: bool = False) -> Mesh:
        """The mesh smoothed: each vertex drawn towards the mean of its neighbours, so many times."""

    def remeshed(self, length: float, *, iterations: int = 10, crease: float | None = None) -> Mesh:
        """Triangles with edges of about one length; edges sharper than `crease`, in radians, stay."""

    def quad_remeshed(self, count: int, *, crease: float | None = None) -> Mesh:
        """Quads, about so many; edges sharper than `crease`, in radians, stay."""

    def offset(self, distance: float) -> Mesh:
        """The mesh moved along its normals."""

    def section(self, plane: PlaneLike) -> list[Array]:
        """The polylines in which a plane cuts it, each an array of shape (n, 3)."""

    def closest_point(self, point: PointLike) -> tuple[Point, float, int]:
        """The nearest place to a point: the point, the distance, and the face."""

    def closest_points(self, points: ArrayLike) -> list[Array]:
        """The nearest places to points, an array of shape (n, 3): arrays of points (n, 3) and of distances (n,)."""

    def ray_hits(self, origin: PointLike, direction: VectorLike) -> list[tuple[float, Point, int]]:
        """Where a ray meets it: for each place the distance in lengths of the direction, the point and the face, in order."""

class Message:
    """What a component says of its run."""

    @property
    def level(self) -> str:
        """"error", "warning" or "remark"."""

    @property
    def text(self) -> str:
        """What it says."""

    @property
    def component(self) -> str:
        """The name of the component."""

    @property
    def nickname(self) -> str:
        """What its author calls it."""

    @property
    def id(self) -> str:
        """The id of the object in the definition."""

    def __str__(self) -> str: ...

    def __repr__(self) -> str: ...

class Model:
    """What a file holds: a sequence of objects."""

    @property
    def objects(self) -> list[ModelObject]:
        """The objects."""

    @property
    def units(self) -> str:
        """The length unit, such as "Millimeters"."""

    @property
    def tolerance(self) -> float:
        """The distance within which things count as one."""

    @property
    def left_out(self) -> list[str]:
        """What could not be read, in words."""

    @property
    def geometry(self) -> list[Array]:
        """The geometry of all objects."""

    def __len__(self) -> int: ...

    def __getitem__(self, index: int) -> ModelObject: ...

    def __iter__(self) -> Iterator[Any]: ...

    def __repr__(self) -> str: ...

class ModelObject:
    """One object of a model: its geometry, and what is said of it."""

    @property
    def geometry(self) -> Array:
        """The geometry."""

    @property
    def name(self) -> str:
        """The name; may be empty."""

    @property
    def layer(self) -> str:
        """The layer, with those it lies under: "Walls::Outer"."""

    @property
    def color(self) -> Colour | None:
        """Its own colour; none where it has that of its layer."""

    def __init__(self, geometry: Any, *, name: str = "", layer: str = "Default", color: Colour | None = None) -> None:
        """Geometry with a name, a layer and a colour."""

    def __repr__(self) -> str: ...

class Output:
    """What a definition gives."""

    @property
    def name(self) -> str:
        """The name by which a solution has it."""

    @property
    def kind(self) -> str:
        """The name of the type of its values."""

    @property
    def marked(self) -> bool:
        """Whether the author marked it as an output: Context Bake, Context Print, or a group called `RH_OUT:name`."""

    def __repr__(self) -> str: ...

class Plane:
    """A plane with an origin and two axes of length 1 at right angles; the third, its normal, follows from them."""

    def __init__(self, origin: PointLike | None = None, x_axis: VectorLike | None = None, y_axis: VectorLike | None = None, *, normal: VectorLike | None = None) -> None:
        """The plane at an origin along an x axis, with the y axis on the side of `y_axis`; or, where no axes are given,
        with a normal."""

    @staticmethod
    def xy() -> Plane:
        """The world's xy plane."""

    @staticmethod
    def yz() -> Plane:
        """The world's yz plane."""

    @staticmethod
    def zx() -> Plane:
        """The world's zx plane."""

    @staticmethod
    def from_points(a: PointLike, b: PointLike, c: PointLike) -> Plane:
        """The plane through three points: the origin at the first, the x axis towards the second."""

    @staticmethod
    def fit(points: ArrayLike) -> tuple[Plane, float]:
        """The plane with the least squares of distances from points, an array of shape (n, 3), and the largest distance."""

    @property
    def origin(self) -> Point:
        """The origin."""

    @property
    def x_axis(self) -> Vector:
        """The first axis."""

    @property
    def y_axis(self) -> Vector:
        """The second axis."""

    @property
    def normal(self) -> Vector:
        """The normal."""

    def point_at(self, u: float, v: float, w: float = 0.0) -> Point:
        """The point at coordinates along the axes."""

    def coordinates(self, point: PointLike) -> tuple[float, float, float]:
        """The coordinates of a point along the three axes."""

    def signed_distance(self, point: PointLike) -> float:
        """The distance of a point from the plane, positive on the side of the normal."""

    def closest_point(self, point: PointLike) -> Point:
        """The point of the plane nearest to a point."""

    def flipped(self) -> Plane:
        """The plane with its normal the other way."""

    def rotated(self, angle: float) -> Plane:
        """The plane turned about its normal by an angle in radians."""

    def offset(self, distance: float) -> Plane:
        """The plane moved along its normal."""

    def transformed(self, transform: Transform) -> Plane:
        """The plane under a transform."""

    def __eq__(self, other: object) -> bool: ...

    def __hash__(self) -> int: ...

    def __repr__(self) -> str: ...

class Point:
    """A location in space: three coordinates in model units.

    Wherever a point is asked for, any three numbers will do: a tuple, a list, a row of an array."""

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> None:
        """The point at three coordinates."""

    @property
    def x(self) -> float:
        """The first coordinate."""

    @property
    def y(self) -> float:
        """The second coordinate."""

    @property
    def z(self) -> float:
        """The third coordinate."""

    def distance_to(self, other: PointLike) -> float:
        """The distance to another point."""

    def lerp(self, other: PointLike, t: float) -> Point:
        """The point at `t` on the way to another one: this one at 0, the other at 1."""

    def transformed(self, transform: Transform) -> Point:
        """The point under a transform."""

    def __add__(self, vector: VectorLike) -> Point: ...

    def __sub__(self, other: Any) -> Any: ...

    def __len__(self) -> int: ...

    def __getitem__(self, index: int) -> float: ...

    def __iter__(self) -> Iterator[Any]: ...

    def __eq__(self, other: object) -> bool: ...

    def __hash__(self) -> int: ...

    def __repr__(self) -> str: ...

class Solution:
    """The results of a solve: a mapping of the names of outputs to trees.

    Any other object of the definition is found by what its author calls it, or by its id, too."""

    @property
    def messages(self) -> list[Message]:
        """What the components say, errors, warnings and remarks, in the order of the definition."""

    @property
    def ok(self) -> bool:
        """Whether no component reported an error."""

    def check(self) -> Solution:
        """The solution itself; raises `SolveError` with all errors where there are any."""

    @property
    def milliseconds(self) -> float:
        """How long the solve took, in milliseconds."""

    @property
    def solved(self) -> int:
        """How many objects were computed; the others had their results from before."""

    def keys(self) -> list[str]:
        """The names of the outputs."""

    def values(self) -> list[Tree]:
        """The trees of the outputs."""

    def items(self) -> list[tuple[str, Tree]]:
        """Names and trees of the outputs."""

    def get(self, name: str, default: Any = None) -> Any:
        """The tree of an output or object, or what is given in its place."""

    def __getitem__(self, name: str) -> Tree: ...

    def __contains__(self, name: str) -> bool: ...

    def __iter__(self) -> Iterator[Any]: ...

    def __len__(self) -> int: ...

    def __bool__(self) -> bool: ...

    def picture(self, size: tuple[int, int] = (800, 600), *, view: str | None = None) -> bytes:
        """A picture of what the definition shows, as PNG. `view` is "perspective", "top", "front", "right" or "iso"."""

    def to_glb(self) -> bytes:
        """What the definition shows, or what is marked as output, as one binary glTF file."""

    def write(self, path: StrPath) -> list[str]:
        """Writes what is marked as output, or, where nothing is, what the definition shows, to a file: .3dm, .step, .obj,
        .stl, .ply, .glb, .gltf or .svg. Gives what the form cannot hold, in words."""

    def __repr__(self) -> str: ...

class StudyCore:
    """A definition, a plan and a folder: the part of a study that is not Python's. Use it through `katydid.study`."""

    def __init__(self, words: Sequence[StrPath], *, points: bool = True) -> None:
        """Opens what the words of `katydid sweep` name. Without `points` the plan only names inputs and outputs."""

    @property
    def points(self) -> int:
        """How many points the plan has."""

    @property
    def inputs(self) -> list[tuple[str, tuple[float, float] | None, float | None, list[Any] | None]]:
        """The inputs."""

    @property
    def outputs(self) -> list[str]:
        """The names of the outputs."""

    @property
    def files(self) -> tuple[StrPath, StrPath | None, StrPath]:
        """The files that the study stands on: the definition, the model or None, the plan."""

    @property
    def seconds(self) -> float | None:
        """How many seconds a point may take."""

    def sweep(self, workers: int | None = None, progress: Callable[[_Counts], object] | None = None) -> _Summed:
        """Solves the points of the plan on this machine, as `katydid sweep` does; `progress` is called with counts now and then."""

    def open(self, asked: bool = True) -> None:
        """Begins to hand out points. With `asked` the points of the table count as asked for before, and are held in memory."""

    def close(self) -> None:
        """Lets others work on the study."""

    def next_points(self, most: int) -> list[bytes]:
        """The next points of the plan that are to be solved, at most so many."""

    def keep(self, records: bytes, files: Sequence[tuple[str, bytes]]) -> int:
        """Takes what a `StudySolver` gave; gives how many points were new."""

    def give_up(self, point: bytes, reason: str, seconds: float) -> None:
        """Records that a point cannot be solved, and why."""

    def progress(self) -> _Counts:
        """Counts, as `progress` is called with."""

    def finish(self) -> _Summed:
        """Writes the tables of the plan."""

    def finish_asked(self) -> _Summed:
        """Writes the tables of the points that were asked for."""

    def fitted(self, points: Sequence[Sequence[Any]]) -> list[bytes]:
        """Points that a program asks for, each a sequence of values in the order of the inputs, as the inputs round them."""

    def ask(self, points: Sequence[bytes]) -> list[bytes]:
        """Asks for points, as `fitted` gives them; gives those that are to be solved."""

    def asked(self) -> int:
        """How many different points were asked for."""

    def solve(self, points: Sequence[bytes], workers: int | None = None) -> None:
        """Solves points that were asked for on this machine."""

    def rows(self, points: Sequence[bytes]) -> _Columns:
        """The columns of points that are solved."""

    def plan_rows(self) -> _Columns:
        """The columns of the plan's points."""

    def asked_rows(self) -> _Columns:
        """The columns of the points that were asked for."""

class StudySolver:
    """A definition that is prepared once, in a process of its own, and solves the points of a study that it is given."""

    def __init__(self, words: Sequence[StrPath], files: tuple[StrPath, StrPath | None, StrPath] | None, inputs: Sequence[str]) -> None:
        """Opens the definition that the words of `katydid sweep` name; its files lie where `files` says: the definition, the model
        or None, the plan. The inputs are those of these names."""

    def solve(self, points: Sequence[bytes]) -> tuple[bytes, list[tuple[str, bytes]]]:
        """Solves points; gives their records, and their pictures and geometry by the names of the files."""

class SubD:
    """A subdivision surface (Catmull-Clark) by its control net, with creases."""

    def __init__(self, mesh: Mesh, *, creases: bool = True, corners: bool = True) -> None:
        """The surface whose control net is a mesh. Edges where the mesh is not welded become creases where `creases`;
        vertices on the border of a single face become corners where `corners`."""

    @property
    def vertices(self) -> Array:
        """The control points as an array of shape (n, 3)."""

    @property
    def limit_points(self) -> Array:
        """Where the control points come to lie on the surface, as an array of shape (n, 3)."""

    @property
    def face_count(self) -> int:
        """How many faces the net has."""

    @property
    def edge_count(self) -> int:
        """How many edges the net has."""

    @property
    def bounding_box(self) -> BoundingBox:
        """The box along the world's axes around the control points, and so around the surface."""

    def to_mesh(self, levels: int = 3) -> Mesh:
        """A mesh with its vertices on the surface, the net divided so many times: 8 at most."""

    def to_control_mesh(self) -> Mesh:
        """The control net as a mesh."""

    def to_brep(self, tolerance: float = 0.001) -> Brep:
        """A Brep of bicubic faces within a tolerance."""

    def transformed(self, transform: Transform) -> SubD:
        """The surface under a transform."""

    def to_json(self) -> str:
        """The form that rhino3dm and Rhino.Compute speak, as JSON text."""

    def __eq__(self, other: object) -> bool: ...

    def __repr__(self) -> str: ...

class Surface:
    """A surface without trims: a plane, an extrusion or sum, a revolution, or a NURBS surface.

    Parameters are those of its two `domains`. Functions ending in `s` take pairs of parameters, an array of shape (n, 2)."""

    @staticmethod
    def plane(plane: PlaneLike, x: IntervalLike, y: IntervalLike) -> Surface:
        """The rectangle of a plane over ranges along its axes."""

    @staticmethod
    def nurbs(points: ArrayLike, degree: tuple[int, int] = (3, 3)) -> Surface:
        """The NURBS surface of a grid of control points, an array of shape (rows, columns, 3): u runs along the rows.
        Knots are uniform."""

    @property
    def kind(self) -> str:
        """What it is: "plane", "sum", "revolution" or "nurbs"."""

    @property
    def domains(self) -> tuple[Interval, Interval]:
        """The ranges of the two parameters."""

    @property
    def area(self) -> float:
        """The area in square units."""

    @property
    def centroid(self) -> Point:
        """The mean of all its points."""

    @property
    def bounding_box(self) -> BoundingBox:
        """The box along the world's axes around it."""

    @property
    def is_closed(self) -> tuple[bool, bool]:
        """Whether it closes along u, and along v."""

    def point_at(self, u: float, v: float) -> Point:
        """The point at parameters."""

    def points_at(self, uv: ArrayLike) -> Array:
        """The points at pairs of parameters, an array of shape (n, 2), as an array of shape (n, 3)."""

    def grid_points(self, u: ArrayLike, v: ArrayLike) -> Array:
        """The points of a grid of parameters: arrays of shape (n,) and (m,) give an array of shape (n * m, 3), v the quicker."""

    def normal_at(self, u: float, v: float) -> Vector:
        """The normal of length 1 at parameters."""

    def normals_at(self, uv: ArrayLike) -> Array:
        """The normals at pairs of parameters, an array of shape (n, 2), as an array of shape (n, 3); zero where there is none."""

    def frame_at(self, u: float, v: float) -> Plane:
        """The plane that touches the surface at parameters, its x axis along u."""

    def derivative_at(self, u: float, v: float, du: int = 1, dv: int = 0) -> Vector:
        """The derivative by u so many times and by v so many times, at parameters; of order 8 at most together."""

    def curvatures_at(self, u: float, v: float) -> tuple[float, float]:
        """The principal curvatures at parameters in 1/units, the larger first."""

    def gaussian_and_mean_at(self, u: float, v: float) -> tuple[float, float]:
        """The Gaussian and the mean curvature at parameters."""

    def closest_point(self, point: PointLike) -> tuple[tuple[float, float], Point, float]:
        """The nearest place to a point: the parameters, the point there, and the distance."""

    def closest_points(self, points: ArrayLike) -> list[Array]:
        """The nearest places to points, an array of shape (n, 3): arrays of parameters (n, 2), points (n, 3), distances (n,)."""

    def isocurve(self, along: str, constant: float) -> Curve:
        """The curve along "u" or "v" at a value of the other parameter."""

    def trimmed(self, u: IntervalLike, v: IntervalLike) -> Surface:
        """The part over ranges of the parameters."""

    def reversed(self, along: str) -> Surface:
        """The surface with "u" or "v" run through the other way."""

    def transposed(self) -> Surface:
        """The surface with its parameters exchanged."""

    def offset(self, distance: float, tolerance: float = 0.001) -> Surface:
        """The surface at a distance along its normals, within a tolerance."""

    def to_mesh(self, tolerance: float | None = None) -> Mesh:
        """A mesh of it; see `Brep.to_mesh`."""

    def to_brep(self) -> Brep:
        """The Brep of one face that it is."""

    def to_nurbs(self) -> Surface:
        """The same surface as a NURBS surface."""

    def transformed(self, transform: Transform) -> Surface:
        """The surface under a transform."""

    def to_json(self) -> str:
        """The form that rhino3dm and Rhino.Compute speak, as JSON text."""

    def __eq__(self, other: object) -> bool: ...

    def __repr__(self) -> str: ...

class Transform:
    """An affine or projective map of space: four rows of four numbers, for columns of coordinates.

    `a @ b` is b first, then a. `a @ x` applies it to a point, a vector, a plane, geometry, or an array of points of shape
    (n, 3)."""

    def __init__(self, rows: ArrayLike | None = None) -> None:
        """The transform of four rows of four numbers; the identity without any."""

    @staticmethod
    def translation(vector: VectorLike) -> Transform:
        """The move along a vector."""

    @staticmethod
    def rotation(angle: float, axis: VectorLike = ..., center: PointLike = ...) -> Transform:
        """The rotation by an angle in radians about an axis through a centre, by the right-hand rule."""

    @staticmethod
    def scale(factor: float, center: PointLike = ...) -> Transform:
        """The scaling by a factor about a centre."""

    @staticmethod
    def mirror(plane: PlaneLike) -> Transform:
        """The reflection in a plane."""

    @staticmethod
    def plane_to_plane(source: PlaneLike, target: PlaneLike) -> Transform:
        """The map that takes one plane to another, axis to axis."""

    @staticmethod
    def planar_projection(plane: PlaneLike) -> Transform:
        """The projection onto a plane, at right angles."""

    @property
    def rows(self) -> list[list[float]]:
        """The four rows."""

    @property
    def determinant(self) -> float:
        """The determinant."""

    def inverse(self) -> Transform:
        """The transform that undoes this one."""

    def __matmul__(self, thing: Any) -> Any: ...

    def __eq__(self, other: object) -> bool: ...

    def __hash__(self) -> int: ...

    def __repr__(self) -> str: ...

class Tree:
    """Data of a definition: branches by their paths, each a list of items. It never changes.

    It is a mapping of paths, tuples of whole numbers, to branches. A branch of numbers, truth values, points or vectors is
    a NumPy array, where NumPy is installed and no item is missing; any other is a list, with `None` for what is missing."""

    def __init__(self, data: Any | None = None) -> None:
        """The tree of what may be given to an input: a dict of lists by paths, a list, a list of lists, an array, one item."""

    @property
    def paths(self) -> list[tuple[int, ...]]:
        """The paths of the branches, in order."""

    @property
    def kind(self) -> str:
        """The name of the type that all items have."""

    @property
    def item_count(self) -> int:
        """How many items there are in all branches together."""

    @property
    def item(self) -> Array:
        """The only item; an error where there are more or none."""

    def flat(self) -> list[Any]:
        """All items of all branches in order, as a list."""

    def array(self) -> Array:
        """All items of all branches in order, as an array: of shape (n,) for numbers and truth values, (n, 3) for points and
        vectors. An error where they are none of these, or some are missing."""

    def to_dict(self) -> dict[Any, Any]:
        """The branches by their paths, as a dict."""

    def keys(self) -> list[tuple[int, ...]]:
        """The paths."""

    def values(self) -> list[Array]:
        """The branches."""

    def items(self) -> list[tuple[tuple[int, ...], Array]]:
        """Paths and branches."""

    def get(self, path: Any, default: Any | None = None) -> Array | None:
        """The branch at a path, or what is given in its place."""

    def flattened(self) -> Tree:
        """One branch with all items."""

    def grafted(self) -> Tree:
        """A branch for each item."""

    def simplified(self) -> Tree:
        """The tree without what the beginnings of all paths have in common."""

    def __getitem__(self, path: Any) -> Array: ...

    def __contains__(self, path: Any) -> bool: ...

    def __iter__(self) -> Iterator[Any]: ...

    def __len__(self) -> int: ...

    def __eq__(self, other: object) -> bool: ...

    def __repr__(self) -> str: ...

    def __str__(self) -> str:
        """What a panel shows, a line an item."""

class Vector:
    """A direction with a length: three coordinates in model units.

    Wherever a vector is asked for, any three numbers will do."""

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> None:
        """The vector with three coordinates."""

    @property
    def x(self) -> float:
        """The first coordinate."""

    @property
    def y(self) -> float:
        """The second coordinate."""

    @property
    def z(self) -> float:
        """The third coordinate."""

    @property
    def length(self) -> float:
        """The length."""

    def unitized(self) -> Vector:
        """The vector of length 1 in the same direction."""

    def dot(self, other: VectorLike) -> float:
        """The scalar product."""

    def cross(self, other: VectorLike) -> Vector:
        """The vector product: perpendicular to both, by the right-hand rule."""

    def angle_to(self, other: VectorLike) -> float:
        """The angle to another vector in radians, from 0 to π."""

    def rotated(self, angle: float, axis: VectorLike) -> Vector:
        """The vector turned about an axis by an angle in radians, by the right-hand rule."""

    def transformed(self, transform: Transform) -> Vector:
        """The vector under the linear part of a transform."""

    def __add__(self, other: Any) -> Any: ...

    def __sub__(self, other: VectorLike) -> Vector: ...

    def __mul__(self, factor: float) -> Vector: ...

    def __rmul__(self, factor: float) -> Vector: ...

    def __truediv__(self, divisor: float) -> Vector: ...

    def __neg__(self) -> Vector: ...

    def __abs__(self) -> float: ...

    def __len__(self) -> int: ...

    def __getitem__(self, index: int) -> float: ...

    def __iter__(self) -> Iterator[Any]: ...

    def __eq__(self, other: object) -> bool: ...

    def __hash__(self) -> int: ...

    def __repr__(self) -> str: ...

def cone(plane: PlaneLike, radius: float, height: float, *, capped: bool = True) -> Brep:
    """The cone with its base of a radius in a plane and its apex at a height over it, closed by a disc where `capped`."""

def cylinder(plane: PlaneLike, radius: float, height: float, *, capped: bool = True) -> Brep:
    """The cylinder of a radius and a height over a plane, closed by discs where `capped`."""

def diff(old: Definition | StrPath, new: Definition | StrPath, *, layout: bool = False) -> list[Change]:
    """What changed from one definition to another, each an open one or a file. Places on the canvas count where `layout`."""

def extrude(profile: Curve, direction: VectorLike, *, capped: bool = False, tolerance: float = 0.001) -> Brep:
    """The surface that a curve draws along a direction; a solid where the curve is closed and planar, and `capped`."""

def geometry_glb(objects: Sequence[Any]) -> bytes:
    """Geometry as one binary glTF file, for viewers."""

def geometry_picture(objects: Sequence[Any], size: tuple[int, int] = (800, 600), *, view: str | None = None) -> bytes:
    """A picture of geometry, as PNG."""

def intersect(curve: Curve, other: Curve | Surface | Brep | Plane, tolerance: float = 0.001) -> tuple[list[Point], list[float]]:
    """What a curve has in common with another curve, a plane, a surface or a Brep: the points, and the parameters on the
    curve where they are, in order."""

def loft(sections: Sequence[Curve], *, style: str = "normal", closed: bool = False, adjust: bool = True, tolerance: float = 0.001) -> Brep:
    """The surface through curves in their order. `style` is "normal", "loose", "tight", "straight", "developable" or
    "uniform"."""

def pipe(rail: Curve, radius: float, *, cap: str = "flat", tolerance: float = 0.001) -> Brep:
    """The pipe of a radius about a curve. `cap` is "none", "flat" or "round"."""

def planar_faces(curves: Sequence[Curve], tolerance: float = 0.001) -> list[Brep]:
    """The flat faces that closed planar curves bound; curves inside others are holes."""

def read(path: StrPath) -> Model:
    """Reads a model: .3dm, .step, .obj, .stl, .ply, .glb or .gltf.

    What a .3dm file holds and cannot be read is skipped, and told by `left_out`."""

def rebuild(form: str, class_name: str = "") -> Array:
    """Geometry of its form, the JSON text that `to_json()` gives and that rhino3dm's `Encode` has: `{"version",
    "archive3dm", "opennurbs", "data"}`. A class asked for by name is what comes out, where the form holds one."""

def revolve(profile: Curve, axis: tuple[PointLike, PointLike], angles: IntervalLike = ..., *, tolerance: float = 0.001) -> Brep:
    """The surface of a curve turned about the axis between two points, over angles in radians."""

def run_command(words: Sequence[str], interpreter: StrPath) -> int:
    """Runs the command `katydid` with words, the name of the program first; gives its exit code.

    A server starts itself a second time: as `interpreter -m katydid`, with the same words."""

def sphere(plane: PlaneLike, radius: float) -> Brep:
    """The sphere of a radius about a plane's origin or a point."""

def sweep(rail: Curve, sections: Sequence[Curve], *, second_rail: Curve | None = None, up: VectorLike | None = None, tolerance: float = 0.001) -> list[Brep]:
    """The surfaces that sections draw along one rail, or two. Along one they turn as little as they can, or keep upright
    against `up`."""

def torus(plane: PlaneLike, major_radius: float, minor_radius: float) -> Brep:
    """The torus about a plane's normal: the radius of its middle circle, and that of the tube."""

def write(path: StrPath, objects: Any, *, units: str = "millimeters", tolerance: float = 0.001) -> list[str]:
    """Writes geometry, or objects with names, layers and colours, or a whole model: .3dm, .step, .obj, .stl, .ply, .glb,
    .gltf or .svg. Gives what the form cannot hold, in words.

    `units` is the name of a length unit in English, as "millimeters"; `tolerance` how far meshes and polylines may be from
    what they stand for."""

