"""Rhino.DocObjects: the objects of a document."""

from katydid.document.document import Layer  # noqa: F401
from katydid.document.objects import Attributes as ObjectAttributes  # noqa: F401
from katydid.document.objects import DocumentObject as RhinoObject  # noqa: F401
from katydid.values.base import not_supported as _not_supported
from katydid.values.enums import ObjectType, make  # noqa: F401

ObjectColorSource = make("ObjectColorSource", ColorFromLayer=0, ColorFromObject=1, ColorFromMaterial=2,
                         ColorFromParent=3)
ActiveSpace = make("ActiveSpace", **{"None": 0, "ModelSpace": 1, "PageSpace": 2})


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    raise _not_supported("Rhino.DocObjects." + name)
