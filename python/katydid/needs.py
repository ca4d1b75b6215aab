"""What a script needs that is not here: packages that cannot be imported, members of the API that are missing.

Nothing of the script runs. Names are followed from its imports (`import Rhino.Geometry as rg`, then `rg.Brep.Create...`);
what is asked of a value whose type only a run can tell is not looked at.
"""

import ast
import importlib
import importlib.util
import sys

from . import rhino
from .backend import current
from .packages import missing, plain_name
from .python2 import convert
from .python2.lexer import ConvertError
from .python2.library import MODULES as RENAMED
from .python2.rewrite import rewrite


def needs(code, language):
    """A map: `modules` that cannot be imported, `members` by full name, `packages` that `# r:` lines ask for and that are not installed, and
    `error` where the source cannot be read."""
    result = {"modules": [], "members": [], "packages": missing(code), "error": None}
    try:
        tree = ast.parse(convert(code) if language == "python2" else code)
        tree = rewrite(tree) if language == "python2" else tree
    except ConvertError as error:
        result["error"] = str(error)
        return result
    except (SyntaxError, ValueError, RecursionError) as error:
        result["error"] = "line %s: %s" % (getattr(error, "lineno", "?"), error)
        return result
    names = _Names(language)
    names.visit(tree)
    # A module whose package is asked for by name is told once, as the package.
    told = {plain_name(one) for one in result["packages"]}
    result["modules"] = sorted(name for name in names.modules if plain_name(name) not in told)
    result["members"] = sorted(names.members)
    return result


def has_module(name, language="python3"):
    """Whether a module can be imported, without importing any that is not ours."""
    top = name.partition(".")[0]
    if top in rhino.NAMES:
        return _ours(name) is not None
    if language == "python2" and top in RENAMED:
        return True
    try:
        return importlib.util.find_spec(top) is not None
    except (ImportError, ValueError):
        return False


def _ours(name):
    """One of our modules or what stands for one (a class), or None. It is found by our own way, installed or not."""
    was = rhino._finder in sys.meta_path
    rhino.install()
    try:
        return importlib.import_module(name)
    except (ImportError, AttributeError):
        return None
    finally:
        if not was:
            sys.meta_path.remove(rhino._finder)


class _Names(ast.NodeVisitor):
    def __init__(self, language):
        self.language = language
        self.modules, self.members = set(), set()
        #: Local names that stand for something of ours, by its full name.
        self.aliases = {}
        self.assigned = set()

    def visit_Import(self, node):
        for name in node.names:
            if not has_module(name.name, self.language):
                self.modules.add(name.name)
            elif name.name.partition(".")[0] in rhino.NAMES:
                if name.asname:
                    self.aliases[name.asname] = name.name
                else:
                    top = name.name.partition(".")[0]
                    self.aliases[top] = top

    def visit_ImportFrom(self, node):
        if node.level or not node.module:
            return
        if not has_module(node.module, self.language):
            self.modules.add(node.module)
            return
        if node.module.partition(".")[0] not in rhino.NAMES:
            return
        for name in node.names:
            if name.name == "*":
                continue
            full = node.module + "." + name.name
            if self._there(full):
                self.aliases[name.asname or name.name] = full
            else:
                self.members.add(full)

    def visit_Attribute(self, node):
        chain, base = [node.attr], node.value
        while isinstance(base, ast.Attribute):
            chain.append(base.attr)
            base = base.value
        if isinstance(base, ast.Name) and base.id in self.aliases:
            self._check(self.aliases[base.id], list(reversed(chain)))
        else:
            self.generic_visit(node)

    def _check(self, start, chain):
        """Follows a chain as far as it names modules and classes; the first step that fails is what is missing."""
        thing, name = resolve(start), start
        if start.startswith("scriptcontext") or start == "clr":
            return
        for step in chain:
            name += "." + step
            found = _step(thing, step)
            if found is _MISSING:
                self.members.add(name)
                return
            if found is _VALUE:
                return
            thing = found

    def _there(self, full):
        parent, _, name = full.rpartition(".")
        return _step(resolve(parent), name) is not _MISSING or has_module(full)


_MISSING, _VALUE = object(), object()


def resolve(full):
    """The module or class of a full name."""
    thing = _ours(full)
    if thing is not None:
        return thing
    parent, _, name = full.rpartition(".")
    return _VALUE if not parent else _step(resolve(parent), name)


def _step(thing, name):
    """What a member of a module or class is: another of them, _VALUE for anything else, or _MISSING."""
    if thing is _VALUE or thing is _MISSING:
        return _VALUE
    if name.startswith("__"):
        return _VALUE
    names = getattr(type(thing), "_names", None) if isinstance(thing, type) else None
    if names is not None:
        return _host_member(thing, name)
    if not isinstance(thing, type) and type(thing).__name__ != "module":
        return _VALUE
    try:
        found = getattr(thing, name)
    except (AttributeError, NotImplementedError):
        full = getattr(thing, "__name__", "")
        found = _ours(full + "." + name) if type(thing).__name__ == "module" else None
        if found is None:
            return _MISSING
    return found if isinstance(found, type) or type(found).__name__ == "module" else _VALUE


def _host_member(cls, name):
    """A member of a class whose members the host knows: on the class, by an object's property, or in Python."""
    if any(name in base.__dict__ for base in cls.__mro__):
        return _VALUE
    from .geometry.list_names import has_list
    table = current().table
    for owner in cls._names():
        if table.has(owner, name) or table.has(owner, "get_" + name) or has_list(table, owner, name):
            return _VALUE
    return _MISSING
