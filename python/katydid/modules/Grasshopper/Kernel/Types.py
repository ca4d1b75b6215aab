"""Grasshopper.Kernel.Types: the wrappers of values on wires."""

from katydid.rhino import missing as _missing
from katydid.values.base import DotNet as _DotNet
from katydid.values.system import Complex  # noqa: F401


class GH_Goo(_DotNet):
    """Holds one value."""

    _namespace = "Grasshopper.Kernel.Types"
    #: The field of GH_GeometricGoo. Classes of scripts that inherit set it without a call of the constructor.
    m_value = None

    def __init__(self, value=None):
        self.Value = getattr(value, "Value", value) if isinstance(value, GH_Goo) else value

    def _get_value(self):
        return self.m_value

    def _set_value(self, value):
        self.m_value = value

    Value = property(_get_value, _set_value)

    def _unwrap(self):
        return self.m_value

    def ScriptVariable(self):
        return self.Value

    IsValid = property(lambda self: self.Value is not None)
    TypeName = property(lambda self: type(self).__name__[3:])

    def Duplicate(self):
        return type(self)(self.Value)

    def ToString(self):
        return str(self.Value)

    def __eq__(self, other):
        return self.Value == (other.Value if isinstance(other, GH_Goo) else other)

    def __hash__(self):
        return hash(self.Value)


for _name in ("Number", "Integer", "Boolean", "String", "Point", "Vector", "Plane", "Line", "Circle", "Arc", "Curve",
              "Surface", "Brep", "Mesh", "SubD", "Box", "Rectangle", "Interval", "Interval2D", "Colour", "Guid", "Time",
              "Transform", "Matrix", "MeshFace", "ComplexNumber", "Culture", "GeometryGroup", "Material", "Extrusion",
              "PointCloud"):
    globals()["GH_" + _name] = type("GH_" + _name, (GH_Goo,), {"__doc__": "A wrapped value."})


class GH_ObjectWrapper(GH_Goo):
    """Holds any object, which then travels as one item."""


class GH_GeometricGoo(GH_Goo):
    """The base of wrapped geometry; `GH_GeometricGoo[Point3d]` is the class itself."""

    def __class_getitem__(cls, types):
        return cls


IGH_Goo = IGH_GeometricGoo = GH_Goo


__getattr__ = _missing(__name__)
