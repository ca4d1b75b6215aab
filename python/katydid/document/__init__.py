"""The documents of scripts: objects by Guid, tolerances, units.

`active()` is the document of the current solve (ghdoc); `model()` stands for the Rhino document, which is empty.
"""

from .document import Document
from .geometry_of import geometry_of, is_geometry

#: What scripts keep between solves; it lives as long as the process.
STICKY = {}

_active = Document("ghdoc")
_model = Document("RhinoDoc")


def active():
    """The document of the current solve."""
    return _active


def model():
    """The document that stands for the model in Rhino."""
    return _model


def begin(settings):
    """A new document for a solve, with its tolerances and units; the model's are the same."""
    global _active
    _active = Document("ghdoc")
    for document in (_active, _model):
        document._settle(settings or {})
    return _active


def find(guid):
    """The object of a Guid in either document, or None."""
    found = _active.Objects.Find(guid)
    return found if found is not None else _model.Objects.Find(guid)


__all__ = ["Document", "STICKY", "active", "begin", "find", "geometry_of", "is_geometry", "model"]
