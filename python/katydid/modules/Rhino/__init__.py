"""RhinoCommon, as far as Katydid has it. What is not here raises an error that names it."""

from katydid import document as _document
from katydid.rhino import missing as _missing
from katydid.values.base import not_supported as _not_supported
from katydid.values.enums import UnitSystem  # noqa: F401

from . import Geometry  # noqa: F401
from .RhinoMath import RhinoMath  # noqa: F401


class _DocumentClass(type):
    """RhinoDoc: the active document is the one that stands for the model."""

    ActiveDoc = property(lambda cls: _document.model())

    def __instancecheck__(cls, thing):
        return isinstance(thing, _document.Document)

    def CreateHeadless(cls, template=None):
        return _document.Document("RhinoDoc")

    def OpenDocuments(cls, *headless):
        return [_document.model()]

    def FromRuntimeSerialNumber(cls, number):
        return _document.model()

    def __getattr__(cls, name):
        if name.startswith("_"):
            raise AttributeError(name)
        raise _not_supported("Rhino.RhinoDoc." + name)


class RhinoDoc(metaclass=_DocumentClass):
    """The document."""


class RhinoApp:
    """The program: it writes what a script writes, and runs no commands."""

    Version = "8.0 (Katydid)"
    ExeVersion = 8
    BuildDate = "Katydid"

    @staticmethod
    def WriteLine(text="", *items):
        print(str(text).format(*items) if items else text)

    @staticmethod
    def Write(text="", *items):
        print(str(text).format(*items) if items else text, end="")

    @staticmethod
    def RunScript(*command):
        raise _not_supported("Rhino.RhinoApp.RunScript")

    @staticmethod
    def Wait():
        pass

    @staticmethod
    def InvokeOnUiThread(work, *arguments):
        work(*arguments)


__getattr__ = _missing(__name__)
