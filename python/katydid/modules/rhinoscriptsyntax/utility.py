"""The document's settings, small tools, and what only makes sense with a window."""

import math
import time

import scriptcontext
from katydid.values.enums import UnitSystem



def UnitAbsoluteTolerance(tolerance=None, in_model_units=True):
    before = scriptcontext.doc.ModelAbsoluteTolerance
    if tolerance is not None:
        scriptcontext.doc.ModelAbsoluteTolerance = float(tolerance)
    return before


def UnitAngleTolerance(angle_tolerance_degrees=None, in_model_units=True):
    before = scriptcontext.doc.ModelAngleToleranceDegrees
    if angle_tolerance_degrees is not None:
        scriptcontext.doc.ModelAngleToleranceRadians = math.radians(float(angle_tolerance_degrees))
    return before


def UnitRelativeTolerance(relative_tolerance=None, in_model_units=True):
    return scriptcontext.doc.ModelRelativeTolerance


def UnitSystem_(unit_system=None, scale=False, in_model_units=True):
    """The number of the document's units."""
    return int(scriptcontext.doc.ModelUnitSystem)


def UnitSystemName(capitalize=False, singular=True, abbreviate=False, model_units=True):
    name = str(scriptcontext.doc.ModelUnitSystem).lower()
    name = name[:-1] if singular and name.endswith("s") else name
    return name.capitalize() if capitalize else name


def UnitScale(unit_system_to, unit_system_from=None):
    from Rhino.RhinoMath import RhinoMath
    start = scriptcontext.doc.ModelUnitSystem if unit_system_from is None else UnitSystem(int(unit_system_from))
    return RhinoMath.UnitScale(start, UnitSystem(int(unit_system_to)))


def DocumentName():
    return scriptcontext.doc.Name or None


def DocumentPath():
    import os
    path = scriptcontext.doc.Path
    return os.path.dirname(path) + os.sep if path else None


def EnableRedraw(enable=True):
    """Nothing is drawn by a script."""
    return True


def Redraw():
    pass


def Sleep(milliseconds):
    time.sleep(milliseconds / 1000.0)


def Prompt(message=None):
    print(message)


def Print(text):
    print(text)


def MessageBox(message, buttons=0, title=""):
    from katydid.run.component import remark
    remark(str(message))
    return 1


def ContextIsRhino():
    return False


def ContextIsGrasshopper():
    return True


def ToDegrees(angle_radians):
    return math.degrees(angle_radians)


def ToRadians(angle_degrees):
    return math.radians(angle_degrees)


def CurrentLayer(layer=None):
    return "Default"


def LayerNames(sort=False):
    return ["Default"]


def IsLayer(layer):
    return str(layer) == "Default"


def LayerCount():
    return 1


def frange(start, stop, step):
    """Numbers from start to stop, both included where the steps meet it."""
    count = int(math.floor((stop - start) / step + 1e-9))
    for i in range(count + 1):
        yield start + i * step


def _asks(name):
    """A function that asks a user, whom a script in a definition has not."""
    def ask(*arguments, **keywords):
        raise NotImplementedError("rhinoscriptsyntax.%s needs a window: give the component an input instead" % name)
    ask.__name__ = name
    return ask


GetObject, GetObjects, GetPoint, GetPoints = map(_asks, ("GetObject", "GetObjects", "GetPoint", "GetPoints"))
GetReal, GetInteger, GetString, GetBoolean = map(_asks, ("GetReal", "GetInteger", "GetString", "GetBoolean"))
GetCurveObject, GetSurfaceObject, GetColor = map(_asks, ("GetCurveObject", "GetSurfaceObject", "GetColor"))
GetRectangle, GetLine, GetBox, ListBox = map(_asks, ("GetRectangle", "GetLine", "GetBox", "ListBox"))
OpenFileName, SaveFileName, BrowseForFolder = map(_asks, ("OpenFileName", "SaveFileName", "BrowseForFolder"))
