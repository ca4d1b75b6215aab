"""clr: references to assemblies, and boxes for out parameters."""

#: Assemblies whose parts are here.
_KNOWN = {"mscorlib", "system", "system.core", "system.drawing", "system.windows.forms", "system.collections",
          "system.numerics", "system.linq", "system.data", "system.xml", "system.runtime", "rhinocommon", "grasshopper",
          "gh_io", "rhinoscript", "ghpython", "eto", "rhino.ui", "netstandard", "windowsbase", "presentationcore",
          "presentationframework", "rhino3dmio", "ghpythonlib", "grasshopper.dll", "rhinocommon.dll", "gh_io.dll"}


def AddReference(name):
    """Does nothing for the assemblies that stand behind the modules here; others are named in the error."""
    text = str(name).replace("\\", "/").rpartition("/")[2].split(",")[0].strip().lower()
    if text in _KNOWN or text.rpartition(".dll")[0] in _KNOWN:
        return None
    raise ImportError("the .NET assembly %s is not supported by Katydid: scripts run without .NET" % name)


AddReferenceByName = AddReferenceByPartialName = AddReferenceToFile = AddReferenceToFileAndPath = AddReference


def ImportExtensions(name):
    """Extension methods are not .NET's here; nothing is to be done."""


def GetClrType(kind):
    from katydid.values.base import DotNetType
    return DotNetType(kind)


class _Box(type):
    def __getitem__(cls, kind):
        return cls


class StrongBox(metaclass=_Box):
    """Waits for the value of an out parameter."""

    _is_box = True

    def __init__(self, value=None):
        self.Value = value


Reference = StrongBox


def Convert(value, kind):
    return kind(value)
