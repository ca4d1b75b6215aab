"""Rhino.DocObjects: the objects of a document."""

from katydid.document.document import Layer  # noqa: F401
from katydid.document.objects import Attributes as ObjectAttributes  # noqa: F401
from katydid.document.objects import DocumentObject as RhinoObject  # noqa: F401
from katydid.rhino import missing as _missing
from katydid.values.enums import ObjectType, make  # noqa: F401

ObjectColorSource = make("ObjectColorSource", ColorFromLayer=0, ColorFromObject=1, ColorFromMaterial=2,
                         ColorFromParent=3)
ActiveSpace = make("ActiveSpace", **{"None": 0, "ModelSpace": 1, "PageSpace": 2})


__getattr__ = _missing(__name__)
