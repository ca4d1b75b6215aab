"""Grasshopper.Kernel.Data."""

from katydid.grasshopper import DataTree as GH_Structure  # noqa: F401
from katydid.grasshopper import GH_Path  # noqa: F401
from katydid.values.base import not_supported as _not_supported


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    raise _not_supported("Grasshopper.Kernel.Data." + name)
