"""Rhino.Collections: lists of geometry."""

from katydid.geometry import as_curve as _as_curve
from katydid.rhino import missing as _missing
from katydid.values import Point3dList  # noqa: F401
from katydid.values.netlist import NetList as _NetList


class RhinoList(_NetList):
    """A list of anything."""

    def __class_getitem__(cls, types):
        return cls


class CurveList(_NetList):
    """A list of curves; lines, circles and arcs become curves."""

    _item = staticmethod(_as_curve)

    def __init__(self, curves=()):
        _NetList.__init__(self, () if isinstance(curves, int) else map(_as_curve, curves))


RhinoList._namespace = CurveList._namespace = "Rhino.Collections"


class ArchivableDictionary(dict):
    """A dictionary; `Set` and `Item` as in .NET."""

    Set = dict.__setitem__
    ContainsKey = dict.__contains__
    Count = property(len)


__getattr__ = _missing(__name__)
