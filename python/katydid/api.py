"""What `import katydid` gives: the extension module, with pictures and viewers in notebooks."""

from . import _katydid, notebook
from ._katydid import *  # noqa: F401,F403
from ._katydid import Definition
from .interop import (from_compas, from_rhino3dm, from_trimesh, to_compas, to_rhino3dm,  # noqa: F401
                      to_trimesh)
from .studies.study import study  # noqa: F401

#: What the package needs of the module for itself.
_INNER = {"Host", "StudyCore", "StudySolver", "run_command", "rebuild", "geometry_glb", "geometry_picture"}

__all__ = sorted({name for name in dir(_katydid) if not name.startswith("_")} - _INNER) + [
    "open", "from_json", "picture", "to_glb", "from_rhino3dm", "to_rhino3dm", "from_compas", "to_compas",
    "from_trimesh", "to_trimesh", "study"]


def open(path, *, allow_scripts=False, python=None):
    """Opens a definition: a .gh, .ghx or .kd file.

    Its Python scripts run only where `allow_scripts` says so: they are programs, and may do what you may. They run in a
    process of their own, with the interpreter `python`.
    """
    return Definition(path, allow_scripts=allow_scripts, python=python)


def from_json(form):
    """Geometry of the JSON text that `to_json()` gives, and that rhino3dm and Rhino.Compute speak."""
    return _katydid.rebuild(form)


def picture(*geometry, size=(800, 600), view=None):
    """A picture of geometry, as PNG. `view` is "perspective", "top", "front", "right" or "iso"."""
    return _katydid.geometry_picture(list(geometry), size, view=view)


def to_glb(*geometry):
    """Geometry as one binary glTF file, as bytes."""
    return _katydid.geometry_glb(list(geometry))


notebook.install(_katydid)
