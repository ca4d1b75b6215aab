"""Values as bytes between a Python process and the host.

A message is a u32 length and one value. All numbers are little-endian; a value is a tag of one byte and its body:

    N T F      null, true, false           i d   i64, f64
    s b        text, bytes: u32 length, bytes
    l m        list, map: u32 count, values (a map: key, value)
    D J P W    columns: u32 count, then f64 / i64 / 3 f64 (points) / 3 f64 (vectors) each
    p 2 v      Point3d, Point2d, Vector3d: f64 each
    q n I X    Plane (origin, x, y, z axis), Line (from, to), Interval, Transform (row by row)
    c e a      Circle (plane, radius), Ellipse (plane, radii), Arc (plane, radius, angles)
    O R B x S  Polyline (u32 count, 3 f64 each), Rectangle3d, BoundingBox (min, max), Box, Sphere
    C g z t f  colour (A R G B), Guid (bytes in the order of the text), complex, ticks, mesh face (4 i32)
    u U        data path (u32 count, i32 each); tree (u32 branches, each path body, u32 count, values)
    G          geometry: u64 handle, text body: its class in RhinoCommon
    y          an object of the script's own, by token: u64
    k          enumeration: text body (type), i64
    E          error: text body (kind), text body (message)

What has no tag travels as a map of its properties by their names in RhinoCommon: Cylinder, Cone, Torus, Ray3d,
MeshingParameters; a domain in two directions as {"U": interval, "V": interval}. A list that belongs to an object
(mesh.Vertices) is sent as its object. A result of several named values (AreaMassProperties) is geometry by handle.

Requests of a Python process: `["call", "Class.Member", arguments...]`, `["component", id, [inputs]]`, `["components"]`,
`["members"]`, answered by `["ok", value]` or an error; `["release", handles]`, not answered. Runs of the host, and what
answers them: see `worker` and `run.execute`.

Every length is checked against the bytes that are there before anything is made, and values nest at most 64 deep.
"""

import struct
import sys
from array import array
from collections import deque
from itertools import repeat

from .values import (Arc, BoundingBox, Box, Circle, Color, Complex, Cone, Cylinder, DateTime, Ellipse, Guid, Interval,
                     Line, MeshFace, Plane, Point2d, Point3d, Point3f, Polyline, Ray3d, Rectangle3d, Sphere, Torus,
                     Transform, Vector3d, Vector3f)
from .values.enums import NetEnum, member
from .values.netlist import NetList
from .values.point import Point2f, Point4d
from .values.polyline import Point3dList
from .values.vector import Vector2d, Vector2f

DEPTH = 64
#: The longest message that is read: what follows a damaged length is not waited for.
LONGEST = 1 << 31

_I64 = struct.Struct("<q")
_U64 = struct.Struct("<Q")
_F64 = struct.Struct("<d")
_U32 = struct.Struct("<I")
_BIG = sys.byteorder == "big"


class CodecError(ValueError):
    """Bytes that are no value, or a value that has no bytes."""


class HostError(Exception):
    """An error that the host answered: its kind is one of the contract's words."""

    def __init__(self, kind, message):
        Exception.__init__(self, message)
        self.kind, self.message = kind, message


class Error:
    """The value of tag E."""

    __slots__ = ("kind", "message")

    def __init__(self, kind, message):
        self.kind, self.message = kind, message


class Tree:
    """Branches by path, as they travel: a list of (path, values). A path is a tuple of integers."""

    __slots__ = ("branches",)

    def __init__(self, branches):
        self.branches = branches


class Path:
    """The value of tag u."""

    __slots__ = ("indices",)

    def __init__(self, indices):
        self.indices = tuple(indices)


class Token:
    """The value of tag y."""

    __slots__ = ("number",)

    def __init__(self, number):
        self.number = number


class Handles:
    """What a codec asks about values that are more than bytes: geometry, trees, tokens. This one knows none."""

    def geometry(self, number, kind):
        raise CodecError("geometry without a host")

    def token(self, number):
        return Token(number)

    def tree(self, branches):
        return Tree(branches)

    def path(self, indices):
        return Path(indices)

    def lower(self, value):
        """A value that the codec knows, for one that it does not; raise CodecError where there is none."""
        raise CodecError("a %s cannot travel" % type(value).__name__)


PLAIN = Handles()


def encode(value, handles=PLAIN):
    """The bytes of a value, without the length of a message."""
    out = bytearray()
    _Encoder(out, handles).value(value, 0)
    return out


def message(value, handles=PLAIN):
    """A whole message."""
    body = encode(value, handles)
    if len(body) >= LONGEST:
        raise CodecError("a message of %d bytes is too long" % len(body))
    return _U32.pack(len(body)) + body


def _doubles(numbers):
    column = array("d", numbers)
    if _BIG:
        column.byteswap()
    return column.tobytes()


def _integers(numbers):
    column = array("q", numbers)
    if _BIG:
        column.byteswap()
    return column.tobytes()


class _Encoder:
    def __init__(self, out, handles):
        self.out, self.handles = out, handles

    def value(self, value, depth):
        write = _WRITERS.get(type(value))
        if write is not None:
            write(self, value, depth)
        elif depth > DEPTH:
            raise CodecError("values nest more than %d deep" % DEPTH)
        else:
            self.other(value, depth)

    def other(self, value, depth):
        """Subclasses of what is known, and what the handles know."""
        if isinstance(value, NetEnum):
            self.out += b"k"
            self.text(type(value).__name__)
            self.out += _I64.pack(int(value))
            return
        for cls in (bool, int, float, str, Polyline):
            if isinstance(value, cls):
                _WRITERS[cls](self, value, depth)
                return
        lowered = self.handles.lower(value)
        if lowered is value:
            raise CodecError("a %s cannot travel" % type(value).__name__)
        self.value(lowered, depth + 1)

    def text(self, text):
        raw = text.encode("utf-8", "replace")
        self.out += _U32.pack(len(raw)) + raw

    def none(self, value, depth):
        self.out += b"N"

    def boolean(self, value, depth):
        self.out += b"T" if value else b"F"

    def integer(self, value, depth):
        if -(1 << 63) <= value < 1 << 63:
            self.out += b"i" + _I64.pack(value)
        else:
            # Beyond 64 bits: the nearest double, as .NET casts BigInteger.
            try:
                self.double(float(value), depth)
            except OverflowError:
                self.double(float("inf") if value > 0 else float("-inf"), depth)

    def double(self, value, depth):
        self.out += b"d" + _F64.pack(value)

    def string(self, value, depth):
        self.out += b"s"
        self.text(value)

    def raw(self, value, depth):
        self.out += b"b" + _U32.pack(len(value)) + bytes(value)

    def list(self, values, depth):
        """A list; long ones of one type as a column."""
        if depth > DEPTH:
            raise CodecError("values nest more than %d deep" % DEPTH)
        out = self.out
        if len(values) > 1:
            kinds = set(map(type, values))
            if len(kinds) == 1:
                kind = kinds.pop()
                if kind is float:
                    out += b"D" + _U32.pack(len(values)) + _doubles(values)
                    return
                if kind is Point3d or kind is Vector3d:
                    out += (b"P" if kind is Point3d else b"W") + _U32.pack(len(values))
                    out += _doubles([c for v in values for c in (v.X, v.Y, v.Z)])
                    return
                if kind is int:
                    try:
                        column = _integers(values)
                        out += b"J" + _U32.pack(len(values)) + column
                        return
                    except OverflowError:
                        pass
        out += b"l" + _U32.pack(len(values))
        for value in values:
            self.value(value, depth + 1)

    def map(self, value, depth):
        if depth > DEPTH:
            raise CodecError("values nest more than %d deep" % DEPTH)
        self.out += b"m" + _U32.pack(len(value))
        for key, item in value.items():
            self.value(key, depth + 1)
            self.value(item, depth + 1)

    def numbers(self, tag, *numbers):
        self.out += tag + struct.pack("<%dd" % len(numbers), *numbers)

    def polyline(self, value, depth):
        self.out += b"O" + _U32.pack(len(value))
        self.out += _doubles([c for p in value for c in (p.X, p.Y, p.Z)])

    def colour(self, value, depth):
        self.out += b"C" + bytes(value._argb)

    def guid(self, value, depth):
        self.out += b"g" + value._bytes

    def face(self, value, depth):
        try:
            self.out += b"f" + struct.pack("<4i", value.A, value.B, value.C, value.D)
        except struct.error:
            raise CodecError("a mesh face has an index outside 32 bits")

    def path_body(self, indices):
        try:
            self.out += _U32.pack(len(indices)) + struct.pack("<%di" % len(indices), *indices)
        except struct.error:
            raise CodecError("a path has an index outside 32 bits")

    def path(self, value, depth):
        self.out += b"u"
        self.path_body(value.indices)

    def tree(self, value, depth):
        if depth > DEPTH:
            raise CodecError("values nest more than %d deep" % DEPTH)
        self.out += b"U" + _U32.pack(len(value.branches))
        for path, items in value.branches:
            self.path_body(path)
            self.out += _U32.pack(len(items))
            for item in items:
                self.value(item, depth + 1)

    def token(self, value, depth):
        self.out += b"y" + _U64.pack(value.number)

    def error(self, value, depth):
        self.out += b"E"
        self.text(value.kind)
        self.text(value.message)

    def geometry(self, number, kind):
        """Written by handle classes: see `Reference`."""
        self.out += b"G" + _U64.pack(number)
        self.text(kind)

    def reference(self, value, depth):
        self.geometry(value.number, value.kind)


class Reference:
    """Geometry by handle, as `Handles.lower` gives it for an object that holds one."""

    __slots__ = ("number", "kind")

    def __init__(self, number, kind):
        self.number, self.kind = number, kind


def _plane(plane):
    return plane._numbers()


_WRITERS = {
    type(None): _Encoder.none, bool: _Encoder.boolean, int: _Encoder.integer, float: _Encoder.double,
    str: _Encoder.string, bytes: _Encoder.raw, bytearray: _Encoder.raw, list: _Encoder.list, tuple: _Encoder.list,
    NetList: _Encoder.list, Point3dList: _Encoder.list, dict: _Encoder.map, Polyline: _Encoder.polyline,
    Color: _Encoder.colour, Guid: _Encoder.guid, MeshFace: _Encoder.face, Path: _Encoder.path, Tree: _Encoder.tree,
    Token: _Encoder.token, Error: _Encoder.error, Reference: _Encoder.reference,
    Point3d: lambda e, v, d: e.numbers(b"p", v.X, v.Y, v.Z),
    Point3f: lambda e, v, d: e.numbers(b"p", v.X, v.Y, v.Z),
    Point4d: lambda e, v, d: e.value(Point3d(v), d),
    Vector3d: lambda e, v, d: e.numbers(b"v", v.X, v.Y, v.Z),
    Vector3f: lambda e, v, d: e.numbers(b"v", v.X, v.Y, v.Z),
    Point2d: lambda e, v, d: e.numbers(b"2", v.X, v.Y),
    Point2f: lambda e, v, d: e.numbers(b"2", v.X, v.Y),
    Vector2d: lambda e, v, d: e.numbers(b"2", v.X, v.Y),
    Vector2f: lambda e, v, d: e.numbers(b"2", v.X, v.Y),
    Plane: lambda e, v, d: e.numbers(b"q", *_plane(v)),
    Line: lambda e, v, d: e.numbers(b"n", *v._from._parts() + v._to._parts()),
    Interval: lambda e, v, d: e.numbers(b"I", v._t0, v._t1),
    Transform: lambda e, v, d: e.numbers(b"X", *v._m),
    Circle: lambda e, v, d: e.numbers(b"c", *_plane(v._plane) + (v._radius,)),
    Ellipse: lambda e, v, d: e.numbers(b"e", *_plane(v._plane) + (v._r1, v._r2)),
    Arc: lambda e, v, d: e.numbers(b"a", *_plane(v._plane) + (v._radius,) + v._angle._parts()),
    Rectangle3d: lambda e, v, d: e.numbers(b"R", *_plane(v._plane) + v._dx._parts() + v._dy._parts()),
    BoundingBox: lambda e, v, d: e.numbers(b"B", *v._min._parts() + v._max._parts()),
    Box: lambda e, v, d: e.numbers(b"x", *_plane(v._plane) + v._dx._parts() + v._dy._parts() + v._dz._parts()),
    Sphere: lambda e, v, d: e.numbers(b"S", *_plane(v._plane) + (v._radius,)),
    complex: lambda e, v, d: e.numbers(b"z", v.real, v.imag),
    Complex: lambda e, v, d: e.numbers(b"z", v.Real, v.Imaginary),
    DateTime: lambda e, v, d: e.out.extend(b"t" + _I64.pack(v.Ticks)),
    # What has no tag of its own travels by its properties.
    Cylinder: lambda e, v, d: e.map({"BasePlane": v._plane, "Radius": v._radius, "Height1": v._h1, "Height2": v._h2}, d),
    Cone: lambda e, v, d: e.map({"Plane": v._plane, "Height": v._height, "Radius": v._radius}, d),
    Torus: lambda e, v, d: e.map({"Plane": v._plane, "MajorRadius": v._major, "MinorRadius": v._minor}, d),
    Ray3d: lambda e, v, d: e.map({"Position": v._position, "Direction": v._direction}, d),
}


def decode(data, handles=PLAIN):
    """The value of some bytes: all of them."""
    reader = _Decoder(data, handles)
    value = reader.value(0)
    if reader.at != len(reader.data):
        raise CodecError("%d bytes follow the value" % (len(reader.data) - reader.at))
    return value


def many(cls, numbers):
    """Points or vectors of a list of floats. The loops run in C: this is three times as fast as a constructor."""
    made = list(map(object.__new__, repeat(cls, len(numbers) // 3)))
    for i, name in enumerate("XYZ"):
        deque(map(cls.__dict__[name].__set__, made, numbers[i::3]), maxlen=0)
    return made


class _Decoder:
    def __init__(self, data, handles):
        self.data, self.at, self.handles = memoryview(data), 0, handles

    def take(self, count):
        end = self.at + count
        if end > len(self.data):
            raise CodecError("the message ends at byte %d, where %d more are expected" % (len(self.data), count))
        part = self.data[self.at:end]
        self.at = end
        return part

    def count(self, each):
        """A u32 count of things that take at least so many bytes each."""
        count = _U32.unpack(self.take(4))[0]
        if count * each > len(self.data) - self.at:
            raise CodecError("%d values are more than the message holds" % count)
        return count

    def text(self):
        return bytes(self.take(self.count(1))).decode("utf-8", "replace")

    def doubles(self, count):
        column = array("d")
        column.frombytes(self.take(8 * count))
        if _BIG:
            column.byteswap()
        return column.tolist()

    def value(self, depth):
        if depth > DEPTH:
            raise CodecError("values nest more than %d deep" % DEPTH)
        tag = bytes(self.take(1))
        read = _READERS.get(tag)
        if read is None:
            raise CodecError("unknown tag %r at byte %d" % (tag, self.at - 1))
        return read(self, depth)

    def list(self, depth):
        return [self.value(depth + 1) for _ in range(self.count(1))]

    def map(self, depth):
        made = {}
        for _ in range(self.count(2)):
            key = self.value(depth + 1)
            try:
                made[key] = self.value(depth + 1)
            except TypeError:
                raise CodecError("a map has a key that is no key")
        return made

    def column(self, depth):
        return self.doubles(self.count(8))

    def integers(self, depth):
        column = array("q")
        column.frombytes(self.take(8 * self.count(8)))
        if _BIG:
            column.byteswap()
        return column.tolist()

    def points(self, depth):
        return many(Point3d, self.doubles(3 * self.count(24)))

    def vectors(self, depth):
        return many(Vector3d, self.doubles(3 * self.count(24)))

    def polyline(self, depth):
        made = Polyline()
        list.extend(made, self.points(depth))
        return made

    def path_body(self):
        count = self.count(4)
        return struct.unpack("<%di" % count, self.take(4 * count))

    def tree(self, depth):
        branches = []
        for _ in range(self.count(8)):
            path = self.path_body()
            branches.append((path, [self.value(depth + 1) for _ in range(self.count(1))]))
        return self.handles.tree(branches)

    def geometry(self, depth):
        number = _U64.unpack(self.take(8))[0]
        return self.handles.geometry(number, self.text())

    def plane(self):
        return Plane._of(self.doubles(12))

    def enumeration(self, depth):
        name = self.text()
        return member(name, _I64.unpack(self.take(8))[0])

    def error(self, depth):
        kind = self.text()
        return Error(kind, self.text())

    def interval(self):
        return Interval(*self.doubles(2))


_READERS = {
    b"N": lambda r, d: None, b"T": lambda r, d: True, b"F": lambda r, d: False,
    b"i": lambda r, d: _I64.unpack(r.take(8))[0], b"d": lambda r, d: _F64.unpack(r.take(8))[0],
    b"s": lambda r, d: r.text(), b"b": lambda r, d: bytes(r.take(r.count(1))),
    b"l": _Decoder.list, b"m": _Decoder.map, b"D": _Decoder.column, b"J": _Decoder.integers,
    b"P": _Decoder.points, b"W": _Decoder.vectors,
    b"p": lambda r, d: Point3d._make(*r.doubles(3)), b"v": lambda r, d: Vector3d._make(*r.doubles(3)),
    b"2": lambda r, d: Point2d(*r.doubles(2)), b"q": lambda r, d: r.plane(),
    b"n": lambda r, d: Line(*r.doubles(6)), b"I": lambda r, d: r.interval(),
    b"X": lambda r, d: Transform._of(r.doubles(16)),
    b"c": lambda r, d: Circle(r.plane(), *r.doubles(1)), b"e": lambda r, d: Ellipse(r.plane(), *r.doubles(2)),
    b"a": lambda r, d: Arc(r.plane(), r.doubles(1)[0], r.interval()), b"O": _Decoder.polyline,
    b"R": lambda r, d: Rectangle3d(r.plane(), r.interval(), r.interval()),
    b"B": lambda r, d: BoundingBox(*r.doubles(6)),
    b"x": lambda r, d: Box(r.plane(), r.interval(), r.interval(), r.interval()),
    b"S": lambda r, d: Sphere(r.plane(), *r.doubles(1)), b"C": lambda r, d: Color._of(*r.take(4)),
    b"g": lambda r, d: Guid._of(r.take(16)), b"z": lambda r, d: Complex(complex(*r.doubles(2))),
    b"t": lambda r, d: DateTime(_I64.unpack(r.take(8))[0]),
    b"f": lambda r, d: MeshFace(*struct.unpack("<4i", r.take(16))),
    b"u": lambda r, d: r.handles.path(r.path_body()), b"U": _Decoder.tree, b"G": _Decoder.geometry,
    b"y": lambda r, d: r.handles.token(_U64.unpack(r.take(8))[0]), b"k": _Decoder.enumeration, b"E": _Decoder.error,
}
