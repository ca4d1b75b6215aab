"""Grasshopper.Kernel.Data."""

from katydid.grasshopper import DataTree as GH_Structure  # noqa: F401
from katydid.grasshopper import GH_Path  # noqa: F401
from katydid.rhino import missing as _missing


__getattr__ = _missing(__name__)
