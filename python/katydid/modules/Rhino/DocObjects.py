"""Rhino.DocObjects: the objects of a document."""

from katydid.document.document import Layer  # noqa: F401
from katydid.document.objects import Attributes as ObjectAttributes  # noqa: F401
from katydid.document.objects import DocumentObject as RhinoObject  # noqa: F401
from katydid.rhino import missing as _missing
from katydid.values.enums import ObjectType, make  # noqa: F401

ObjectColorSource = make("ObjectColorSource", ColorFromLayer=0, ColorFromObject=1, ColorFromMaterial=2,
                         ColorFromParent=3)
TextHorizontalAlignment = make("TextHorizontalAlignment", Left=0, Center=1, Right=2, Auto=3)
TextVerticalAlignment = make("TextVerticalAlignment", Top=0, MiddleOfTop=1, BottomOfTop=2, Middle=3, MiddleOfBottom=4,
                             Bottom=5, BottomOfBoundingBox=6)
ObjectMaterialSource = make("ObjectMaterialSource", MaterialFromLayer=0, MaterialFromObject=1, MaterialFromParent=3)
ActiveSpace = make("ActiveSpace", **{"None": 0, "ModelSpace": 1, "PageSpace": 2})


__getattr__ = _missing(__name__)
