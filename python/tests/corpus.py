"""Reads the Python scripts out of Grasshopper files, for tests over a folder of real definitions.

Only what the tests need: the binary tree (.gh, raw DEFLATE) and the XML form (.ghx), script components at any
depth of clusters. The files themselves are no part of the project; the folder is named by KATYDID_TEST_DEFINITIONS.
"""

import base64
import hashlib
import os
import struct
import xml.etree.ElementTree as ElementTree
import zlib

GHPYTHON = "410755b1-224a-4c1e-a407-bf32fb45ea7e"
IRONPYTHON = "97aa26ef-88ae-4ba6-98a6-ed6ddeca11d1"
PYTHON3 = "719467e6-7cf5-4848-99b0-c5dd57e5442c"
SCRIPT = "c9b2d725-6f87-4b07-af90-bd9aefef68eb"

# The bytes of each item type of fixed size.
SIZES = {1: 1, 2: 1, 3: 4, 4: 8, 5: 4, 6: 8, 7: 16, 8: 8, 9: 16, 30: 8, 31: 8, 32: 8, 33: 8, 34: 16, 35: 16, 36: 4,
         50: 16, 51: 24, 52: 32, 60: 16, 61: 32, 70: 48, 71: 48, 72: 72, 80: 12}


class Chunk:
    """A node of the archive: items and chunks by (name, index)."""

    def __init__(self, name, index):
        self.name, self.index, self.items, self.chunks = name, index, {}, []

    def item(self, name, index=-1, default=None):
        return self.items.get((name, index), default)

    def child(self, name, index=None):
        for chunk in self.chunks:
            if chunk.name == name and (index is None or chunk.index == index):
                return chunk
        return None

    def children(self, name):
        return [chunk for chunk in self.chunks if chunk.name == name]


class _Binary:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, count):
        if count < 0 or self.at + count > len(self.data):
            raise ValueError("the archive ends early")
        part = self.data[self.at:self.at + count]
        self.at += count
        return part

    def int(self):
        return struct.unpack("<i", self.take(4))[0]

    def text(self):
        length = shift = 0
        while True:
            byte = self.take(1)[0]
            length |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return self.take(length).decode("utf-8", "replace")

    def chunk(self):
        made = Chunk(self.text(), self.int())
        items, chunks = self.int(), self.int()
        for _ in range(items):
            name, index, kind = self.text(), self.int(), self.int()
            made.items[(name, index)] = self.payload(kind)
        for _ in range(chunks):
            made.chunks.append(self.chunk())
        return made

    def payload(self, kind):
        if kind == 10:
            return self.text()
        if kind in (20, 37):
            return self.take(self.int())
        if kind == 21:
            return self.take(8 * self.int())
        raw = self.take(SIZES[kind])
        if kind == 1:
            return raw[0] != 0
        if kind in (3, 4):
            return int.from_bytes(raw, "little", signed=True)
        if kind == 9:
            a, b, c = struct.unpack("<IHH", raw[:8])
            text = "%08x%04x%04x%s" % (a, b, c, raw[8:].hex())
            return "-".join((text[:8], text[8:12], text[12:16], text[16:20], text[20:]))
        return raw


def _xml_chunk(element):
    made = Chunk(element.get("name"), int(element.get("index", -1)))
    for item in element.findall("items/item"):
        code, text = int(item.get("type_code")), item.text or ""
        value = text
        if code == 1:
            value = text.strip().lower() == "true"
        elif code in (3, 4):
            value = int(text)
        elif code == 20:
            stream = item.find("stream")
            value = base64.b64decode((stream.text if stream is not None else text) or "")
        made.items[(item.get("name"), int(item.get("index", -1)))] = value
    for chunk in element.findall("chunks/chunk"):
        made.chunks.append(_xml_chunk(chunk))
    return made


def read(data):
    """The root chunk of a file's bytes."""
    if data[:3] == b"\xef\xbb\xbf":
        data = data[3:]
    if not data.lstrip()[:1] == b"<":
        data = zlib.decompress(data, -15)
        if not data.lstrip()[:1] == b"<":
            return _Binary(data).chunk()
    return _xml_chunk(ElementTree.fromstring(data))


def _ports(container, kind):
    """Name, access and hint of each port of a script component."""
    found = []
    data = container.child("ParameterData")
    chunks = data.children("InputParam" if kind == "in" else "OutputParam") if data is not None else \
        container.children("param_input" if kind == "in" else "param_output")
    for chunk in sorted(chunks, key=lambda c: c.index):
        access = chunk.item("ScriptParamAccess")
        if access is None:
            access = chunk.item("Access", default=0)
        found.append({
            "name": chunk.item("NickName") or chunk.item("Name") or "",
            "access": ("item", "list", "tree")[access if access in (0, 1, 2) else 0],
            "hint": (chunk.item("TypeHintID") or "").lower(),
            "description": chunk.item("Description") or "",
        })
    return found


def _objects(root):
    holder = root.child("Definition") or root
    objects = holder.child("DefinitionObjects")
    return objects.children("Object") if objects is not None else []


def scripts_of(root):
    """Each Python script of a definition, those in clusters too: code, language, ports."""
    for thing in _objects(root):
        guid = str(thing.item("GUID") or "").lower()
        container = thing.child("Container")
        if container is None:
            continue
        cluster = container.item("ClusterDocument")
        if isinstance(cluster, bytes) and cluster:
            try:
                yield from scripts_of(read(cluster))
            except (ValueError, zlib.error, KeyError, ElementTree.ParseError):
                pass
        code, language = None, "python2"
        if guid == GHPYTHON:
            code = container.item("CodeInput")
        script = container.child("Script")
        if code is None and script is not None and script.item("Text"):
            spec = script.child("LanguageSpec")
            taxon = (spec.item("Taxon") if spec is not None else "") or ""
            if "python" in taxon or guid in (PYTHON3, IRONPYTHON):
                code = base64.b64decode(script.item("Text")).decode("utf-8", "replace")
                version = (spec.item("Version") if spec is not None else "") or ""
                language = "python2" if "iron" in taxon.lower() or str(version).startswith("2") or guid == IRONPYTHON \
                    else "python3"
        if code:
            yield {"code": code, "language": language, "inputs": _ports(container, "in"),
                   "outputs": _ports(container, "out"), "name": container.item("Name") or "",
                   "nickname": container.item("NickName") or ""}


def folder():
    """The folder of real definitions, or None."""
    named = os.environ.get("KATYDID_TEST_DEFINITIONS")
    return named if named and os.path.isdir(named) else None


def all_scripts(where):
    """Distinct scripts under a folder, in order of path; each says the file that it comes from."""
    seen = set()
    for base, folders, names in os.walk(where):
        folders.sort()
        for name in sorted(names):
            if not name.endswith((".gh", ".ghx", ".ghuser")):
                continue
            path = os.path.join(base, name)
            try:
                with open(path, "rb") as handle:
                    root = read(handle.read())
                found = list(scripts_of(root))
            except (ValueError, zlib.error, KeyError, ElementTree.ParseError, RecursionError, struct.error):
                continue
            for script in found:
                key = hashlib.sha1(script["code"].encode("utf-8", "replace")).hexdigest()
                if key not in seen:
                    seen.add(key)
                    script["file"] = os.path.relpath(path, where)
                    yield script
