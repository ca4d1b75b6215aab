"""Grasshopper's API, as far as scripts reach: trees, paths, messages, wrappers."""

from katydid.grasshopper import DataTree  # noqa: F401
from katydid.values.base import not_supported as _not_supported

from . import Kernel  # noqa: F401


class Folders:
    """Where Grasshopper keeps files: there are none here."""

    DefaultAssemblyFolder = AppDataFolder = UserObjectFolders = ""


class Instances:
    """The windows of Grasshopper: there are none."""

    ActiveCanvas = DocumentEditor = None


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    raise _not_supported("Grasshopper." + name)
