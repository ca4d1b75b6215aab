"""The codec: bytes by hand, values there and back, and no crash on any bytes."""

import random
import struct

import pytest
from katydid import codec
from katydid.grasshopper import DataTree, GH_Path
from katydid.objects import Objects
from katydid.values import (Arc, BoundingBox, Box, Circle, Color, Complex, DateTime, Ellipse, Guid, Interval, Line,
                            MeshFace, Plane, Point2d, Point3d, Polyline, Rectangle3d, Sphere, Transform, Vector3d)
from katydid.values.enums import LoftType

VALUES = [None, True, False, 0, -5, 1 << 62, 2.5, float("inf"), "", "é∞", b"\0\1", [], [1, "a", None], {"k": [1.5]},
          Point3d(1, 2, 3), Vector3d(-1, 0, 5), Point2d(1, 2), Plane.WorldZX, Line(0, 0, 0, 1, 2, 3), Interval(3, 1),
          Transform.Translation(1, 2, 3), Circle(Point3d(1, 2, 3), 4), Ellipse(Plane.WorldXY, 3, 2),
          Arc(Plane.WorldXY, 2, 1.5), Polyline([(0, 0, 0), (1, 2, 3)]), Rectangle3d(Plane.WorldXY, 3, 4),
          BoundingBox(0, 0, 0, 1, 2, 3), Box(BoundingBox(0, 0, 0, 1, 1, 1)), Sphere(Point3d(1, 1, 1), 3),
          Color.FromArgb(1, 2, 3, 4), Guid("57da07bd-ecab-415d-9d86-af36d7073abc"), Complex(1, -2), DateTime(2024, 5, 6),
          MeshFace(1, 2, 3), MeshFace(1, 2, 3, 4), [1.0, 2.0], [1, 2], [Point3d(1, 2, 3)] * 3, [Vector3d(1, 2, 3)] * 2,
          LoftType.Tight, GH_Path(1, -2)]


@pytest.mark.parametrize("value", VALUES, ids=lambda value: type(value).__name__)
def test_there_and_back(value):
    handles = Objects()
    back = codec.decode(codec.encode(value, handles), handles)
    assert back == value and type(back) is type(value)


def test_bytes_by_hand():
    assert bytes(codec.encode([True, 7, "hé"])) == b"l\x03\0\0\0T" + b"i" + struct.pack("<q", 7) + b"s\x03\0\0\0h\xc3\xa9"
    assert bytes(codec.encode(Point3d(1, 2, 3))) == b"p" + struct.pack("<3d", 1, 2, 3)
    assert bytes(codec.encode([1.0, 2.0])) == b"D\x02\0\0\0" + struct.pack("<2d", 1, 2)
    assert bytes(codec.encode(Color.FromArgb(4, 1, 2, 3))) == b"C\x04\x01\x02\x03"
    guid = Guid("00112233-4455-6677-8899-aabbccddeeff")
    assert bytes(codec.encode(guid)) == b"g" + bytes(range(0, 256, 17))
    assert codec.message(None) == b"\x01\0\0\0N"
    plane = codec.encode(Plane.WorldYZ)
    assert struct.unpack("<12d", plane[1:]) == (0, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0)


def test_trees():
    handles, tree = Objects(), DataTree()
    tree.AddRange([1, 2], GH_Path(0, 1))
    tree.EnsurePath(GH_Path(3))
    back = codec.decode(codec.encode(tree, handles), handles)
    assert back.Paths == [GH_Path(0, 1), GH_Path(3)] and back.Branch(GH_Path(0, 1)) == [1, 2] and back.Branch(1) == []


def test_mixed_lists_and_numbers_beyond_64_bits():
    assert codec.decode(codec.encode([1, 2.0])) == [1, 2.0]
    assert codec.decode(codec.encode([True, False])) == [True, False]
    assert codec.decode(codec.encode([1 << 70, 2])) == [float(1 << 70), 2]


def test_too_deep_is_an_error():
    value = []
    for _ in range(100):
        value = [value]
    with pytest.raises(codec.CodecError):
        codec.encode(value)
    with pytest.raises(codec.CodecError):
        codec.decode(b"l\x01\0\0\0" * 100 + b"N")


@pytest.mark.parametrize("data", [b"", b"?", b"s\xff\xff\xff\xff", b"D\xff\xff\xff\x7f", b"l\xff\xff\xff\xff", b"NN",
                                  b"m\x01\0\0\0l\0\0\0\0N", b"U\xff\xff\xff\xff", b"p\0"])
def test_broken_bytes_are_an_error(data):
    with pytest.raises(codec.CodecError):
        codec.decode(data)


def test_no_bytes_crash_the_reader():
    source, handles = random.Random(1), Objects()
    good = bytes(codec.encode([value for value in VALUES], handles))
    for _ in range(3000):
        damaged = bytearray(good)
        for _ in range(source.randrange(1, 6)):
            damaged[source.randrange(len(damaged))] = source.randrange(256)
        try:
            codec.decode(bytes(damaged[:source.randrange(1, len(damaged) + 1)]))
        except codec.CodecError:
            pass
