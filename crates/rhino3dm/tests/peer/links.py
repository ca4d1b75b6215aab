"""What refers to something: linked blocks, hatches and their patterns, details, files inside archives."""

import base64
import pathlib
import struct
import tempfile
import zlib

import rhino3dm

from .common import VERSIONS, dumped, example

BLOCKS = [
    ("static", "Static", ""),
    ("unset", "Static", ""),
    ("embedded", "LinkedAndEmbedded", "/models/größe/far 🦗.3dm"),
    ("embedded, relative", "LinkedAndEmbedded", ""),
    ("active", "Linked", "/models/größe/far 🦗.3dm"),
    ("apart", "Linked", "/models/größe/far 🦗.3dm"),
    ("relative", "Linked", ""),
]
FILES = {"größe 🦗.txt": b"x" * 5000, "few.bin": bytes(range(100)), "empty.bin": b""}


def check_blocks(file, version):
    for (name, kind, path), block in zip(BLOCKS, file.InstanceDefinitions, strict=True):
        what = f"block {name} in version {version}"
        # Nobody tells a block that is not set from a static one.
        assert block.Name == name and block.Description == "Beschreibung", what
        assert block.UpdateType.name in (kind, "Static" if name == "unset" else kind), f"{what}: {block.UpdateType}"
        assert block.SourceArchive == path, f"{what}: {block.SourceArchive}"


def check_links(version):
    """Written here, read there, written there and read here."""
    with tempfile.TemporaryDirectory() as folder:
        path, again = pathlib.Path(folder) / "links.3dm", pathlib.Path(folder) / "again.3dm"
        example("write_links", path, version)
        file = rhino3dm.File3dm.Read(str(path))
        assert file is not None, version
        check_blocks(file, version)
        objects = {o.Attributes.Name: o.Geometry for o in file.Objects}
        assert [objects[f"hatched {i}"].PatternIndex for i in (2, 0, -1)] == [2, 0, -1], version
        assert all(geometry.IsValid for name, geometry in objects.items()), version
        assert objects["detail"].ObjectType.name == "Detail", version
        assert file.Write(str(again), version // 10 or version)
        ours, theirs = (dumped(p)[0]["tables"]["blocks"] for p in (path, again))
    for a, b in zip(ours, theirs, strict=True):
        # It makes full paths of relative ones and the other way round, as it lies where the file is saved, and does
        # not keep a relative path alone before version 60.
        parts = ["name", "id", "description", "source", "skips", "appearance", "file" if a["file"] else "relative"]
        if version >= 60 or version == 50 and a["file"] or a["source"] == "static":
            assert [a[key] for key in parts] == [b[key] for key in parts], f"{version}: {a} {b}"


def set_number(data, at, number, header, nested=None):
    """Another number in a chunk, whose check sum covers its bytes but for those of the chunk nested in it."""
    data[at : at + 4] = struct.pack("<i", number)
    wide = data[32 - 8 : 32].strip() not in (b"4", b"3", b"2")
    size, form = (12, "<q") if wide else (8, "<i")
    start = header + size
    end = start + struct.unpack_from(form, data, header + 4)[0] - 4
    own = bytes(data[start:end])
    if nested:
        length = size + struct.unpack_from(form, data, nested + 4)[0]
        own = bytes(data[start:nested] + data[nested + length : end])
    data[end : end + 4] = struct.pack("<I", zlib.crc32(own))


def renumber(data, version):
    """Numbers of hatch patterns that are not their places."""
    header = 12 if version >= 50 else 8
    for i, name in enumerate(("solid", "lines", "more")):
        text = struct.pack("<I", len(name) + 1) + name.encode("utf-16-le")
        # The number stands before the name, before version 60 with the kind between them.
        if version >= 60:
            at = data.index(text) - 4
            set_number(data, at, 7 - i, at - 28 - header)
        else:
            at = data.index(text) - 8
            set_number(data, at, 7 - i, at - 1 - header)
    # A reference to a pattern that is not there. Before it stand the version and the plane, behind it a count, and
    # version and kind of the loop.
    found = data.index(struct.pack("<ddi", 1.5, 0.25, 0))
    set_number(data, found + 16, 9, found - 129 - header, found + 16 + 4 + 4 + 5)


def check_renumbered(version):
    """Hatches refer to patterns by their places, whatever the patterns state."""
    with tempfile.TemporaryDirectory() as folder:
        path, again = pathlib.Path(folder) / "links.3dm", pathlib.Path(folder) / "again.3dm"
        example("write_links", path, version)
        data = bytearray(path.read_bytes())
        renumber(data, version)
        path.write_bytes(data)
        head, *objects = dumped(path)
        assert not head["warnings"], head["warnings"]
        file = rhino3dm.File3dm.Read(str(path))
        theirs = [o.Geometry.PatternIndex for o in file.Objects if isinstance(o.Geometry, rhino3dm.Hatch)]
        ours = [o["geometry"]["detail"]["pattern"] for o in objects if o["geometry"]["class"] == "Hatch"]
        example("convert", path, again, version)
        file = rhino3dm.File3dm.Read(str(again))
        written = [o.Geometry.PatternIndex for o in file.Objects if isinstance(o.Geometry, rhino3dm.Hatch)]
    assert ours == theirs == written == [2, 9, -1], f"{version}: {ours} here, {theirs} there, {written} written"


def check_embedded_files():
    """Files that rhino3dm puts into archives, here and back."""
    with tempfile.TemporaryDirectory() as folder:
        model, path, again = rhino3dm.File3dm(), pathlib.Path(folder) / "in.3dm", pathlib.Path(folder) / "out.3dm"
        for name, content in FILES.items():
            (pathlib.Path(folder) / name).write_bytes(content)
            model.EmbeddedFiles.Add(rhino3dm.EmbeddedFile.Read(str(pathlib.Path(folder) / name)))
        assert model.Write(str(path), 8)
        theirs = rhino3dm.File3dm.Read(str(path))
        paths = list(theirs.EmbeddedFilePaths())
        ours = dumped(path)[0]["tables"]["embedded_files"]
        assert [file["path"] for file in ours] == paths, f"{ours} {paths}"
        for file in ours:
            expected = FILES[pathlib.PurePath(file["path"]).name]
            assert base64.b64decode(file["content"]) == expected, file["path"]
        for version in VERSIONS:
            example("convert", path, again, version)
            read = rhino3dm.File3dm.Read(str(again))
            assert list(read.EmbeddedFilePaths()) == paths, version
            for name in paths:
                assert read.GetEmbeddedFileAsBase64(name) == theirs.GetEmbeddedFileAsBase64(name), (version, name)
    print(f"{len(paths)} files inside archives of {len(VERSIONS)} versions equal")


def check_all():
    for version in VERSIONS:
        check_links(version)
        check_renumbered(version)
    check_embedded_files()
    print(f"{len(BLOCKS)} blocks, 3 hatches and a detail in {len(VERSIONS)} versions as rhino3dm reads them")
