"""An archive of version 1 with what the shared files do not hold, put together here byte by byte."""

import struct

END = struct.pack("<Ii", -1 & 0xFFFFFFFF, 0)


def chunk(typecode, body):
    return struct.pack("<II", typecode, len(body)) + body


def short(typecode, value):
    return struct.pack("<II", typecode, value & 0xFFFFFFFF)


def doubles(*numbers):
    return struct.pack(f"<{len(numbers)}d", *numbers)


def ints(*numbers):
    return struct.pack(f"<{len(numbers)}i", *numbers)


def text(string):
    data = string.encode()
    return ints(len(data)) + data


def attributes(name="", layer=0, colour=0x00FFFFFF, **extra):
    result = chunk(0x02000001, text(name)) + short(0xA0000001, layer) + short(0x80400001, colour)
    if extra.get("density"):
        result += short(0x80400022, extra["density"])
    if extra.get("transparency"):
        result += short(0x80400004, extra["transparency"])
    if extra.get("material"):
        result += chunk(0x00400007, ints(1) + text(extra["material"]))
    for word, data in extra.get("data", {}).items():
        result += chunk(0x40000001, ints(len(word) + 1, len(data)) + word.encode() + b"\0" + data)
    return result


def point(xyz, **how):
    return chunk(0x00100001, doubles(*xyz) + attributes(**how) + END)


def mesh():
    corners = [(0, 0, 0), (65535, 0, 0), (65535, 65535, 0), (0, 65535, 65535), (30000, 12345, 54321)]
    faces = [(0, 1, 2, 3), (1, 2, 4, 4)]
    body = ints(len(corners), len(faces), 1, 1) + doubles(-1, 0, 2.5, 1, 2, 4)
    body += b"".join(struct.pack("<3H", *c) for c in corners) + b"".join(struct.pack("<4H", *f) for f in faces)
    body += struct.pack("<15b", *([0, 0, 127] * 4 + [-127, 30, 0])) + struct.pack("<10H", *range(0, 65530, 6553))
    return chunk(0x00100015, chunk(0x00100017, body) + attributes("mesh", 1, 0x320000FF) + END)


PLANE = doubles(1, 2, 3, 0, 1, 0, -1, 0, 0)


def annotations():
    yield 0x00200004, ints(2, 1) + PLANE + text("a text") + ints(0, 0) + text("Arial") + ints(400) + doubles(2.5)
    yield 0x00200004, ints(1, 1) + PLANE + text("older") + ints(0, 0) + text("Arial") + ints(700) + doubles(1, 0, 0)
    yield 0x00200005, ints(1, 9) + PLANE + ints(0, 0, 3) + doubles(0, 0, 0, 1, 1, 0, 2, 1, 0)
    eleven = [x for i in range(11) for x in (i * 0.5, i % 3, 0)]
    yield 0x00200006, ints(1, 4) + PLANE + doubles(*eleven) + text("<>") + text("5.00") + ints(0, 0, 0)


def dimension_points(count):
    return doubles(*[x for i in range(count) for x in (i + 0.5, i * i, 0)])


def toolkit_curve():
    data = ints(101, 3, 0, 4, 5, 0) + doubles(0, 0, 0, 1, 2, 2, 2) + doubles(*range(15))
    return chunk(0x00020008, chunk(0x0002FFFE, data) + attributes("toolkit curve") + chunk(0x0002FFFF, b""))


def toolkit_surface():
    data = ints(100, 3, 0, 2, 3, 2, 3, 0) + doubles(0, 1, 0, 0, 1, 1)
    data += doubles(*[x for u in range(2) for v in range(3) for x in (u, v, u * v * 0.25)])
    return chunk(0x00020009, chunk(0x0002FFFE, data) + attributes("toolkit surface") + chunk(0x0002FFFF, b""))


def layer(name, colour, state):
    return chunk(0x00400010, chunk(0x00400011, text(name)) + short(0x80400001, colour) + short(0x80400033, state) + END)


def camera(projection, target, angles, size, distance):
    return chunk(0x02000002, ints(projection, 1) + doubles(*target, *angles, size, distance))


def plane():
    """A construction plane whose axes are neither of unit length nor at right angles."""
    return chunk(0x02000003, doubles(1, 2, 3, 1, 1, 0, 0, 1, 1, 2.5) + ints(20, 4))


def views():
    """Views as far as they go: all they can have, nothing at all, and numbers that cannot be any."""
    everything = camera(2, (1, 2, 3), (0.1, 0.7, -2.0), 0.33, 250) + plane()
    everything += chunk(0x0200000A, doubles(0.1, 0.2, 0.6, 0.9))
    everything += chunk(0x0200000B, PLANE + doubles(8, 5) + text("trace.bmp")) + chunk(0x02000012, text("wallpaper.bmp"))
    # What early programs wrote: no length, but a short chunk.
    everything += short(0x0200000E, 0)
    everything += short(0x82000007, 0) + short(0x82000011, 1) + short(0x82000015, 1)
    yield 0x02000006, chunk(0x02000001, text("everything")) + everything
    yield 0x02000006, chunk(0x02000001, text("nothing"))
    yield 0x02000006, chunk(0x02000001, text("impossible")) + camera(1, (0, 0, 0), (0, 0, 0), -1, 0)
    yield 0x02000006, chunk(0x02000001, text("turned")) + camera(1, (4, 5, 6), (1.5707963267948966, -1.5707963267948966, 3.141592653589793), 2, 30)
    yield 0x02000006, chunk(0x02000001, text("far")) + camera(2, (1e5, -1e-3, 7), (-0.4, 12.5, 1e-9), 1.5, 0.5)
    yield 0x02000005, chunk(0x02000001, text("größe")) + camera(2, (0, 0, 1), (1, 2, 3), 0.5, 10) + plane()
    yield 0x02000004, chunk(0x02000001, text("tilted")) + plane()


def archive():
    spotlight = doubles(1, 2, 3, 0.8, 0.6, 0, -0.6, 0.8, 0, 2, 5, 0.5) + attributes("spot", 1, 0x00102030) + END
    chunks = [
        chunk(1, b"Interface: Rhinoceros 1.1 - Education (12-May-2000)\x1a"),
        # The official reader looks for notes before layers only.
        chunk(0x0200000F, ints(1, 10, 20, 300, 400) + text("two\nlines")),
        layer("first", 0x00FF0000, 0),
        layer("second", 0x0000FF00, 2),
        layer("third", 0x000000FF, 1),
        *[chunk(code, body + END) for code, body in views()],
        chunk(0x02000010, ints(1, 8) + doubles(0.002, 0.02, 0.05)),
        point((1, 2, 3), name="point", layer=1, density=3, transparency=51),
        point((0, 0, 0), data={"RhAnnotateArrow": doubles(1, 2, 2)}),
        point((4, 5, 6), data={"RhAnnotateDot": b"dot"}, material="brick"),
        point((4, 5, 6), data={"RhHidePrevLayer": b"second"}, layer=2),
        point((7, 8, 9), layer=77),
        mesh(),
        toolkit_curve(),
        toolkit_surface(),
        chunk(0x00800001, spotlight),
        *[chunk(code, body + attributes(f"annotation {i}") + END) for i, (code, body) in enumerate(annotations())],
        # Something unknown, and a mark of the end that is none.
        chunk(0x00123456, b"what?"),
        chunk(0x00007FFF, ints(0)),
        point((9, 9, 9), name="behind"),
        chunk(0x00007FFF, ints(0)),
    ]
    return b"3D Geometry File Format        1" + b"".join(chunks)


def wrapped_version_2(archive_of_version_2):
    """The same archive under a header that says version 1, behind a chunk of version 1."""
    fluff = layer("of version 1", 0, 0) + chunk(0x0200000F, ints(1, 0, 0, 0, 0) + text("of version 1"))
    body = archive_of_version_2[32:]
    first = 8 + struct.unpack_from("<I", body, 4)[0]
    return b"3D Geometry File Format        1" + body[:first] + fluff + body[first:]
