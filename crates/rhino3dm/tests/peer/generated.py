"""Generated models in every version: read here as rhino3dm reads them, and written here as it would read them."""

import collections
import json
import pathlib
import tempfile
import uuid

import rhino3dm

from . import tables
from .common import VERSIONS, dumped, encoded, example, xyz
from .generated_documents import documents
from .generated_models import SEED
from .geometry import check_geometry

SOURCES = (2, 3, 4, 5, 6, 7, 8)
NO_STYLE = str(uuid.UUID(int=0))
MESH = uuid.UUID("4ED7D4E4-E947-11D3-BFE5-0010830122F0").bytes_le
# Where the body of a mesh has its box in single precision; that in double precision stands before the checksum.
BOX, DOUBLE_BOX, CRC = range(89, 89 + 24), 48, 4

# What is known to differ, each entry one thing: nothing.
KNOWN = ()


def is_known(difference):
    return any(known in difference for known in KNOWN)


def complaint(check, *arguments):
    """What a comparison complains of, if it does."""
    try:
        check(*arguments)
    except (AssertionError, KeyError) as error:
        return str(error) or f"failed: {check.__name__}"
    return None


def reading(path):
    """How a file read here differs from the same file read by rhino3dm."""
    head, *objects = dumped(path)
    if "error" in head:
        yield head["error"]
        return
    file = tables.read(path)
    if len(file.Objects) != len(objects):
        yield f"{len(objects)} objects here, {len(file.Objects)} there"
    for warning in head["warnings"]:
        # Units that the kernel has no name for are stated as such.
        if "treated as no unit" not in warning:
            yield f"warning: {warning}"
    styles = {style["id"] for style in head["tables"]["dimension_styles"]}
    for i, (ours, theirs) in enumerate(zip(objects, file.Objects)):
        detail = ours["geometry"]["detail"]
        if "rich_text" in detail and detail["style"] not in styles:
            # rhino3dm names another style then.
            detail["style"] = NO_STYLE
        what = f"object {i} ({type(theirs.Geometry).__name__})"
        if ours["geometry"]["kept"]:
            yield f"{what} is kept as bytes"
        # Forms that the kernel refuses are not printed; the comparison of what is written is for them.
        if detail.keys() - {"style"} and type(theirs.Geometry).__name__ != "SubD":
            yield complaint(check_geometry, ours["geometry"], theirs.Geometry, what)
    yield complaint(tables.check_reading, path)


def boxes(encoded):
    """The places of the boxes of meshes among encoded bytes, with the checksums behind them."""
    places, at = set(), encoded.find(MESH)
    while at >= 0:
        # The identifier and its checksum, the header of the body.
        length = int.from_bytes(encoded[at + 24:at + 32], "little")
        start = at + 32
        places.update(start + place for place in BOX)
        places.update(range(start + length - CRC - DOUBLE_BOX, start + length))
        at = encoded.find(MESH, start)
    return places


def same(old, again, new):
    """Whether an object is the same, but for what two readings of one file do not agree about either.

    rhino3dm gives meshes of files before version 6 the boxes that the file states, and others none.
    """
    old_bytes, again_bytes, new_bytes = (tables.encoded(geometry) for geometry in (old, again, new))
    if tables.alike(old_bytes, again_bytes, new_bytes):
        return True
    has_boxes = isinstance(old, (rhino3dm.Mesh, rhino3dm.Brep)) and new_bytes and len(old_bytes) == len(new_bytes)
    return has_boxes and {i for i, (a, b) in enumerate(zip(old_bytes, new_bytes)) if a != b} <= boxes(old_bytes)


def counted(brep):
    return len(brep.Faces), len(brep.Edges), len(brep.Vertices), brep.IsSolid


def same_in_another_form(old, new, theirs):
    """Whether an object that older versions have no class for says the same in the form they have.

    rhino3dm writes no text when it writes such versions, breps of extrusions that are not valid now and then, and
    extrusions of one wall as surfaces. Its planes of angles differ from ours in their last bits.
    """
    if isinstance(old, rhino3dm.Extrusion) and isinstance(new, rhino3dm.Brep):
        is_brep = isinstance(theirs, rhino3dm.Brep)
        return new.IsValid and (counted(new) == counted(theirs) if is_brep else not new.IsSolid)
    if isinstance(old, rhino3dm.Text) and isinstance(new, rhino3dm.Text):
        return (old.PlainText, flat(old.Plane)) == (new.PlainText, flat(new.Plane))
    if isinstance(old, rhino3dm.DimAngular) and isinstance(new, rhino3dm.DimAngular):
        pairs = zip(angle_points(old), angle_points(new))
        return all(abs(a - b) < 1e-9 for p, q in pairs for a, b in zip(p, q))
    return False


def flat(plane):
    return [xyz(part) for part in (plane.Origin, plane.XAxis, plane.YAxis)]


def angle_points(angle):
    return [xyz(angle.Points[name]) for name in ("centerpt", "defpt1", "defpt2", "arrowpt1", "arrowpt2")]


def conversion(path, version, reference, counts):
    """How a file read and written here differs from the file, both read by rhino3dm.

    What rhino3dm itself loses when it writes that version, as the file of reference shows, may be lost here, too.
    """
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.3dm"
        carried = json.loads(example("convert", path, out, version))
        if rhino3dm.File3dm.Read(str(out)) is None:
            yield "rhino3dm does not read the file"
            return
        before, again, after, theirs = (tables.read(p) for p in (path, path, out, reference))
    if len(carried) != len(before.Objects):
        left = [i for i in range(len(before.Objects)) if i not in carried]
        yield f"objects {left} are left out ({type(before.Objects[left[0]].Geometry).__name__} first)"
    if len(carried) != len(after.Objects):
        yield f"{len(after.Objects)} objects are read back of {len(carried)}"
        return
    for place, i in enumerate(carried):
        old, new = before.Objects[i].Geometry, after.Objects[place].Geometry
        counts["objects"] += 1
        if old.IsValid and not new.IsValid:
            yield f"object {i} ({type(old).__name__}) is not valid any more: {new.IsValidWithLog[1]}"
        reference_too = len(theirs.Objects) > i and encoded(theirs.Objects[i].Geometry) == encoded(new)
        other = theirs.Objects[i].Geometry if len(theirs.Objects) > i else None
        in_another_form = version < 60 and same_in_another_form(old, new, other)
        if same(old, again.Objects[i].Geometry, new) or reference_too or in_another_form:
            counts["encoded alike"] += 1
        else:
            yield f"object {i} ({type(old).__name__}, there {type(new).__name__}) is encoded otherwise"
    before, again, after, theirs = (tables.contents(file) for file in (before, again, after, theirs))
    for tables_ in (before, again, theirs):
        tables_["attributes"] = [a for i, a in enumerate(tables_["attributes"]) if i in carried]
    for table, entries in before.items():
        counts["entries"] += len(entries)
        if len(entries) != len(after[table]):
            yield f"{len(entries)} {table} before, {len(after[table])} after"
        for i, (a, b, c) in enumerate(zip(entries, again[table], after[table])):
            kept = i < len(theirs[table]) and tables.alike(theirs[table][i], theirs[table][i], c)
            if tables.alike(a, b, c) or kept:
                counts["entries alike"] += 1
            else:
                yield f"{table} {i} differs"


def differences(seed=SEED, sources=SOURCES, targets=VERSIONS, families=None):
    """Every difference of every generated file; and what was compared."""
    found, counts = [], collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        for family, file in documents(seed):
            if families and family not in families:
                continue
            paths = {version: pathlib.Path(folder) / f"{family}_{version}.3dm" for version in range(2, 9)}
            for version, path in paths.items():
                assert file.Write(str(path), version), f"rhino3dm does not write {family} as {version}"
            for source in sources:
                path = paths[source]
                counts["files"] += 1
                found += [f"{family} of version {source}: {d}" for d in reading(path) if d]
                for target in targets:
                    reference = paths[target if target < 10 else target // 10]
                    lost = conversion(path, target, reference, counts)
                    found += [f"{family} of version {source} as {target}: {d}" for d in lost]
    return found, counts
