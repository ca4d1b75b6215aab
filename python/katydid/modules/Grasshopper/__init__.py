"""Grasshopper's API, as far as scripts reach: trees, paths, messages, wrappers."""

from katydid.grasshopper import DataTree  # noqa: F401
from katydid.rhino import missing as _missing

from . import Kernel  # noqa: F401


class Folders:
    """Where Grasshopper keeps files: there are none here."""

    DefaultAssemblyFolder = AppDataFolder = UserObjectFolders = ""


class Instances:
    """The windows of Grasshopper: there are none."""

    ActiveCanvas = DocumentEditor = None


__getattr__ = _missing(__name__)
