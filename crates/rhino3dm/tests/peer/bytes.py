"""The bytes that rhino3dm encodes objects in, taken apart as far as its properties do not reach."""

import base64
import struct
import uuid

NURBS_CURVE = uuid.UUID("4ED7D4DD-E947-11D3-BFE5-0010830122F0")
LINE_CURVE = uuid.UUID("4ED7D4DB-E947-11D3-BFE5-0010830122F0")
ARC_CURVE = uuid.UUID("CF33BE2A-09B4-11D4-BFFB-0010830122F0")
POLYLINE_CURVE = uuid.UUID("4ED7D4E6-E947-11D3-BFE5-0010830122F0")
POLY_CURVE = uuid.UUID("4ED7D4E0-E947-11D3-BFE5-0010830122F0")


class Bytes:
    """A body read from front to back; chunk lengths take 8 bytes."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, layout):
        values = struct.unpack_from("<" + layout, self.data, self.at)
        self.at += struct.calcsize("<" + layout)
        return values

    def int(self):
        return self.take("i")[0]

    def ints(self):
        return list(self.take(f"{self.int()}i"))

    def doubles(self, count):
        return list(self.take(f"{count}d"))

    def points(self, count):
        return [self.doubles(3) for _ in range(count)]

    def chunk(self):
        """The body of the next chunk, its checksum with it."""
        _, length = self.take("Iq")
        body = Bytes(self.data[self.at:self.at + length])
        self.at += length
        return body

    def class_object(self):
        """Identifier and body of a class object."""
        whole = self.chunk()
        name = uuid.UUID(bytes_le=bytes(whole.chunk().take("16B")))
        return name, whole.chunk()

    def items(self):
        """A list: a version byte and a count."""
        body = self.chunk()
        body.take("B")
        return body, body.int()


def encoded_brep(brep):
    """The lists of a brep, as rhino3dm encodes it."""
    _, body = Bytes(base64.b64decode(brep.Encode()["data"])).class_object()
    body.take("B")
    parts = {"curves_2d": curves(body), "curves_3d": curves(body)}
    body.chunk()  # Surfaces have properties.
    for name, read in (("vertices", vertex), ("edges", edge), ("trims", trim), ("loops", loop), ("faces", face)):
        items, count = body.items()
        parts[name] = [read(items) for _ in range(count)]
    body.doubles(6)
    count = len(parts["faces"])
    parts["render_meshes"], parts["analysis_meshes"] = (flags(body.chunk(), count) for _ in range(2))
    return parts


def flags(body, count):
    present = []
    for _ in range(count):
        present.append(body.take("B")[0] != 0)
        if present[-1]:
            body.chunk()
    return present


def curves(body):
    items, count = body.items()
    return [curve(*items.class_object()) if items.int() else None for _ in range(count)]


def vertex(body):
    _, at, edges, (tolerance,) = body.int(), body.doubles(3), body.ints(), body.doubles(1)
    return {"at": at, "edges": edges, "tolerance": tolerance}


def edge(body):
    _, curve, is_reversed, span = body.int(), body.int(), body.int() != 0, body.doubles(2)
    vertices, trims, (tolerance,) = list(body.take("2i")), body.ints(), body.doubles(1)
    part = {"curve": curve, "range": span, "reversed": is_reversed, "domain": body.doubles(2)}
    return {"part": part, "vertices": vertices, "trims": trims, "tolerance": tolerance}


def trim(body):
    _, curve, span, edge = body.int(), body.int(), body.doubles(2), body.int()
    vertices, is_reversed, kind, iso, loop = list(body.take("2i")), body.int() != 0, body.int(), body.int(), body.int()
    tolerance, domain = body.doubles(2), body.doubles(2)
    turned = body.take("32B")[0] == 1
    body.doubles(2)
    part = {"curve": curve, "range": span, "reversed": turned, "domain": domain}
    return {"part": part, "edge": edge, "vertices": vertices, "reversed": is_reversed, "kind": kind, "iso": iso,
            "loop": loop, "tolerance": tolerance}


def loop(body):
    return {"trims": (body.int(), body.ints())[1], "kind": body.int(), "face": body.int()}


def face(body):
    return {"loops": (body.int(), body.ints())[1], "surface": body.int(), "reversed": body.int() != 0,
            "material": body.int()}


def curve(name, body):
    """The numbers of a curve, named as the example `dump` names them."""
    body.take("B")
    if name == LINE_CURVE:
        start, end = body.points(2)
        return {"kind": "line", "from": start, "to": end, "domain": body.doubles(2)}
    if name == ARC_CURVE:
        plane = body.points(4)
        body.doubles(4)
        (radius,) = body.doubles(1)
        body.points(3)
        return {"kind": "arc", "plane": plane, "radius": radius, "angle": body.doubles(2), "domain": body.doubles(2)}
    if name == POLYLINE_CURVE:
        points = body.points(body.int())
        return {"kind": "polyline", "points": points, "parameters": body.doubles(body.int())}
    if name == POLY_CURVE:
        count, _, _ = body.take("3i")
        body.doubles(6)
        parameters = body.doubles(body.int())
        return {"kind": "poly", "parameters": parameters, "segments": [curve(*body.class_object()) for _ in range(count)]}
    assert name == NURBS_CURVE, name
    dimension, rational, order, count, _, _ = body.take("6i")
    body.doubles(6)
    knots = body.doubles(body.int())
    width = dimension + (rational != 0)
    points = [body.doubles(width) for _ in range(body.int())]
    pad = [0.0] * (3 - dimension)
    points = [p[:dimension] + pad + (p[dimension:] if rational else [1.0]) for p in points]
    return {"kind": "nurbs", "degree": order - 1, "rational": rational != 0, "knots": knots, "points": points}
