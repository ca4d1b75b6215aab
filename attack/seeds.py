"""Sound files of every format, to be damaged: those beside the repository, and what the program itself writes."""

import random
import struct
import subprocess
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SHARED = ROOT.parent / "shared" / "data"
# Larger files take longer and show nothing else.
LARGEST = 300_000
# What models are made of: a curve, surfaces, a trimmed solid and a mesh.
SHAPES = """katydid 1
plane = XY Plane()
box = Center Box(plane, 2, 3, 4)
ball = Sphere(plane, 2.5)
rings = Circle(plane, [3, 1])
trimmed = Boundary Surfaces(rings)
curve = Interpolate([(0, 0, 0), (1, 2, 0), (3, 1, 1), (4, 0, 0)])
mesh = Mesh Sphere(plane, 1, 8, 6)
"""
# The same for formats of meshes, where a ball would be a million bytes.
MESHES = """katydid 1
mesh = Mesh Sphere(XY Plane(), 1, 8, 6)
line = PolyLine([(0, 0, 0), (1, 2, 0), (3, 1, 1)])
"""
WRITTEN = {"3dm": SHAPES, "step": SHAPES, "svg": SHAPES, "gh": SHAPES, "ghx": SHAPES}
WRITTEN |= dict.fromkeys(["obj", "stl", "ply", "glb", "gltf"], MESHES)


def near(folder, suffix):
    """Files beside the repository, if they are there."""
    found = [p for p in sorted((SHARED / folder).rglob(f"*{suffix}")) if p.is_file()]
    return [p.read_bytes() for p in found if p.stat().st_size <= LARGEST]


def written(katydid, folder):
    """What the program writes of a few shapes, by format."""
    source = Path(folder) / "shapes.kd"
    files = {}
    for suffix, text in WRITTEN.items():
        source.write_text(text)
        target = Path(folder) / f"shapes.{suffix}"
        word = ["convert", source, target] if suffix in ("gh", "ghx") else ["run", source, "-o", target]
        subprocess.run([katydid, *map(str, word)], capture_output=True, timeout=120, check=True)
        files[suffix] = target.read_bytes()
    picture = Path(folder) / "shapes.png"
    source.write_text(SHAPES)
    subprocess.run([katydid, "view", str(source), "-o", str(picture)], capture_output=True, timeout=120, check=True)
    return files | {"png": picture.read_bytes()}


def shapefile():
    """A polygon and a line, by the description of ESRI."""

    def record(number, kind, points):
        xs, ys = [p[0] for p in points], [p[1] for p in points]
        body = struct.pack("<i4dii", kind, min(xs), min(ys), max(xs), max(ys), 1, len(points)) + struct.pack("<i", 0)
        body += b"".join(struct.pack("<2d", *p) for p in points)
        return struct.pack(">ii", number, len(body) // 2) + body

    body = record(1, 5, [(0, 0), (0, 4), (4, 4), (4, 0), (0, 0)]) + record(2, 5, [(5, 5), (5, 6), (6, 6), (5, 5)])
    head = struct.pack(">i20xi", 9994, (100 + len(body)) // 2) + struct.pack("<ii8d", 1000, 5, 0, 0, 6, 6, 0, 0, 0, 0)
    return head + body


def molecule():
    """Four atoms and their bonds."""
    atom = "ATOM  {:5d}  C   ALA A{:4d}    {:8.3f}{:8.3f}{:8.3f}  1.00  0.00           C\n"
    lines = "".join(atom.format(k + 1, 1, k * 1.5, k % 2, 0.5 * k) for k in range(4))
    return (lines + "CONECT    1    2\nCONECT    2    3\nCONECT    3    4\nEND\n").encode()


def picture():
    """A small picture in PNG."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + bytes(range(24)) for _ in range(8))
    head = struct.pack(">IIBBBBB", 8, 8, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def bitmap():
    """A small picture in BMP."""
    pixels = bytes(range(192))
    info = struct.pack("<IiiHHIIiiII", 40, 8, 8, 1, 24, 0, len(pixels), 2835, 2835, 0, 0)
    return struct.pack("<2sIHHI", b"BM", 54 + len(pixels), 0, 0, 54) + info + pixels


def gif():
    """A picture of one pixel in GIF."""
    return bytes.fromhex("47494638396101000100800000000000ffffff21f90401000000002c00000000010001000002024401003b")


def all_of(katydid, folder):
    """Files by format."""
    seeds = {suffix: [data] for suffix, data in written(katydid, folder).items()}
    for folder, suffix in [("gh", "gh"), ("gh", "ghx"), ("3dm", "3dm")]:
        seeds.setdefault(suffix, []).extend(near(folder, f".{suffix}"))
    texts = sorted(ROOT.glob("book/*/definition.kd")) + sorted(ROOT.glob("examples/*.kd"))
    seeds["kd"] = [SHAPES.encode(), *(p.read_bytes() for p in texts)]
    seeds.setdefault("png", []).append(picture())
    seeds |= {"shp": [shapefile()], "pdb": [molecule()], "bmp": [bitmap()], "gif": [gif()]}
    for data in seeds.values():
        random.Random(1).shuffle(data)
    return seeds
