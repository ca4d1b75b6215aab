"""A document: its object table, tolerances and units, and what else scripts ask of one."""

from ..values import Plane
from ..values.base import DotNet, not_supported
from ..values.enums import UnitSystem
from ..values.netlist import NetList
from .objects import ObjectTable


class Layer(DotNet):
    """The one layer of a document without a model."""

    _namespace = "Rhino.DocObjects"
    Name, FullPath, Index, IsDeleted, IsVisible, IsLocked = "Default", "Default", 0, False, True, False


class Linetype(DotNet):
    """The one line type of a document without a model."""

    _namespace = "Rhino.DocObjects"
    Name, Index = "Continuous", -1


class LayerTable(NetList):
    CurrentLayer = property(lambda self: self[0])
    CurrentLayerIndex = property(lambda self: 0)

    def FindName(self, name, *rules):
        return next((layer for layer in self if layer.Name == name), None)

    def FindByFullPath(self, path, *rules):
        return next((layer.Index for layer in self if layer.FullPath == path), -1)


class _Viewport:
    """The view that scripts ask for a construction plane: there is no window, so it is the world's XY."""

    Name = "Top"

    def ConstructionPlane(self):
        return Plane.WorldXY

    def SetConstructionPlane(self, plane):
        return True


class _View:
    ActiveViewport = MainViewport = _Viewport()

    def Redraw(self):
        pass


class Views:
    """Nothing is drawn: redrawing does nothing."""

    ActiveView = _View()
    RedrawEnabled = True

    def Redraw(self):
        pass

    def EnableRedraw(self, *arguments):
        pass


class Document(DotNet):
    """ghdoc, or RhinoDoc."""

    _namespace, _net_name = "Rhino", "RhinoDoc"

    def __init__(self, kind):
        self._kind = kind
        self.Objects = ObjectTable()
        self.Views = Views()
        self.Layers = LayerTable([Layer()])
        self.Linetypes = NetList([Linetype()])
        #: Guids by the name of their group, and texts by key.
        self._groups, self._strings = {}, {}
        self._settle({})

    def _settle(self, settings):
        self.ModelAbsoluteTolerance = settings.get("tolerance", 0.01)
        self.ModelAngleToleranceRadians = settings.get("angle_tolerance", 0.017453292519943295)
        self.ModelRelativeTolerance = 0.01
        units = settings.get("units") or "Millimeters"
        self.ModelUnitSystem = getattr(UnitSystem, units, UnitSystem.Millimeters)
        self.PageUnitSystem = self.ModelUnitSystem
        self.PageAbsoluteTolerance = self.ModelAbsoluteTolerance
        self.Path = settings.get("path") or ""
        self.Name = settings.get("name") or ""

    @property
    def ModelAngleToleranceDegrees(self):
        import math
        return math.degrees(self.ModelAngleToleranceRadians)

    PageAngleToleranceRadians = property(lambda self: self.ModelAngleToleranceRadians)
    RuntimeSerialNumber = DocumentId = property(lambda self: 1)
    IsHeadless = property(lambda self: True)

    def AdjustModelUnitSystem(self, units, scale):
        self.ModelUnitSystem = units

    def GetUnitSystemName(self, *rules):
        return str(self.ModelUnitSystem).lower()

    def BeginUndoRecord(self, name):
        return 1

    def EndUndoRecord(self, number):
        return True

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        raise not_supported("Rhino.RhinoDoc." + name)
