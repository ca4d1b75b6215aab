"""Grasshopper.Kernel."""

from katydid.rhino import missing as _missing
from katydid.run.component import Component as GH_Component  # noqa: F401
from katydid.run.component import Definition as GH_Document  # noqa: F401
from katydid.run.component import GH_RuntimeMessageLevel  # noqa: F401
from katydid.run.instance import ComponentBase
from katydid.values.enums import make as _make

from . import Data, Special, Types  # noqa: F401

GH_ParamAccess = _make("GH_ParamAccess", item=0, list=1, tree=2)
GH_Exposure = _make("GH_Exposure", hidden=-1, primary=2, secondary=4, tertiary=8, quarternary=16, quinary=32, senary=64,
                    septenary=128, obscure=65536)
GH_SolutionMode = _make("GH_SolutionMode", Default=0, CommandLine=1, Silent=2)


class IGH_BakeAwareData:
    """A mark of data that can be baked."""


class IGH_PreviewData:
    """A mark of data that is drawn."""


class IGH_Param:
    """A mark of parameters."""


class IGH_Component:
    """A mark of components."""


class GH_ScriptInstance(ComponentBase):
    """The base of scripts that are a class (Rhino 8)."""


__getattr__ = _missing(__name__)
