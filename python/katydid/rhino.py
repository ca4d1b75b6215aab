"""Makes the modules that Rhino's scripts import available: Rhino, System, rhinoscriptsyntax and their kin.

Nothing is replaced until `install()` is called, so a package that is really called `System` elsewhere is untouched.
"""

import importlib
import importlib.machinery
import importlib.util
import os
import sys

from .values.base import not_supported

#: The top-level names that are ours once installed.
NAMES = ("Rhino", "System", "Grasshopper", "ghpythonlib", "rhinoscriptsyntax", "scriptcontext", "clr", "GhPython",
         "GH_IO")

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "modules")


class _Nothing:
    """The loader of `import System.Array`, which names a class: there is nothing more to run."""

    def __init__(self, thing):
        self.thing = thing

    def create_module(self, spec):
        return self.thing

    def exec_module(self, module):
        pass


class Finder:
    """Finds our modules, and lets classes be imported as modules, as IronPython does."""

    def find_spec(self, fullname, path=None, target=None):
        parent, _, name = fullname.rpartition(".")
        if fullname.partition(".")[0] not in NAMES:
            return None
        if not parent:
            return importlib.machinery.PathFinder.find_spec(fullname, [FOLDER])
        spec = importlib.machinery.PathFinder.find_spec(fullname, path) if path else None
        if spec is None:
            holder = sys.modules.get(parent)
            thing = vars(holder).get(name) if holder is not None else None
            if thing is not None:
                return importlib.util.spec_from_loader(fullname, _Nothing(thing))
        return spec


def missing(module):
    """The `__getattr__` of one of our modules: a submodule is imported when it is named, anything else is not here."""
    def ask(name):
        if name.startswith("_"):
            raise AttributeError(name)
        if hasattr(sys.modules.get(module), "__path__"):
            try:
                return importlib.import_module(module + "." + name)
            except ModuleNotFoundError:
                pass
        raise not_supported(module + "." + name)
    return ask


_finder = Finder()


def install():
    """Lets `import Rhino` and the rest find Katydid's modules, in this process, from now on."""
    if _finder not in sys.meta_path:
        sys.meta_path.insert(0, _finder)


def uninstall():
    """Takes the modules away again."""
    if _finder in sys.meta_path:
        sys.meta_path.remove(_finder)
    for name in [name for name in sys.modules if name.partition(".")[0] in NAMES]:
        del sys.modules[name]
