"""Makes the tables of docs/scripts.md from the members that are there.

    KATYDID=... python scripts_page.py --write
"""

import ast
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))

from katydid import rhino  # noqa: E402
from katydid.backend import current  # noqa: E402

PAGE = os.path.join(os.path.dirname(os.path.dirname(HERE)), "docs", "scripts.md")
MARK = "<!-- made by python/tests/scripts_page.py: from here on -->\n"

#: What every object of Python or .NET has.
_COMMON = {"Equals", "GetHashCode", "GetType", "ToString", "Dispose"}


def own_members(cls, listed):
    """The public names of a class without those that it inherits from one that is listed too."""
    names = set()
    for base in cls.__mro__:
        if base is not cls and base in listed:
            break
        if base is object or base.__module__.endswith("values.base"):
            continue
        names |= {name for name in vars(base) if not name.startswith("_")}
        names |= {slot for slot in vars(base).get("__slots__", ()) if isinstance(slot, str) and not slot.startswith("_")}
    if hasattr(cls, "_names"):
        classes = current().table.classes.get(cls._host_name(), {})
        for name in classes:
            names.add(name[4:] if name.startswith(("get_", "set_")) else name)
        names.discard("Item")
    names = {"(constructor)" if name == "new" else name for name in names}
    return sorted(names - _COMMON)


def classes():
    """The classes of Rhino.Geometry and Rhino.Geometry.Intersect that have members, by name."""
    import Rhino.Geometry as geometry
    import Rhino.Geometry.Intersect as intersect
    found = {}
    for space in (geometry, intersect):
        for name, thing in vars(space).items():
            if isinstance(thing, type) and not name.startswith("_") and name == thing.__name__:
                found[name] = thing
    return sorted(found.items())


def is_enumeration(cls):
    return hasattr(cls, "_value_names") or any("Enum" in base.__name__ for base in cls.__mro__)


def functions():
    """The functions of rhinoscriptsyntax, by the module that holds them."""
    folder = os.path.join(os.path.dirname(HERE), "katydid", "modules", "rhinoscriptsyntax")
    import rhinoscriptsyntax
    found = set()
    for name in sorted(os.listdir(folder)):
        if name.endswith(".py") and name not in ("support.py", "__init__.py"):
            with open(os.path.join(folder, name), encoding="utf-8") as source:
                for node in ast.parse(source.read()).body:
                    targets = [node.name] if isinstance(node, ast.FunctionDef) else [
                        part.id for target in getattr(node, "targets", ()) for part in ast.walk(target)
                        if isinstance(part, ast.Name)]
                    found.update(targets)
    return sorted(name for name in found if (name[0].isupper() or name.startswith("coerce")) and name.isalnum()
                  and not name.isupper() and callable(getattr(rhinoscriptsyntax, name, None)))


def tables():
    """The part of the page below its mark."""
    rhino.install()
    lines = ["", "### Rhino.Geometry", "", "Members of a class are those of the classes that it inherits from, too.", "",
             "| class | members |", "| --- | --- |"]
    enumerations, found = [], classes()
    listed = {cls for _, cls in found}
    for name, cls in found:
        if is_enumeration(cls):
            enumerations.append(name)
            continue
        members = own_members(cls, listed)
        if members:
            lines.append("| %s | %s |" % (name, ", ".join(members)))
    lists = sorted(name for name in current().table.classes if name.endswith("List"))
    lines += ["", "Lists of parts: " + ", ".join("%s (%s)" % (name, ", ".join(
        sorted({one.partition("_")[2] if one.startswith(("get_", "set_")) else one for one in current().table.classes[name]}
               - _COMMON))) for name in lists) + ".", ""]
    if enumerations:
        lines += ["Enumerations: " + ", ".join(enumerations) + ".", ""]
    names = functions()
    lines += ["### rhinoscriptsyntax", "", "%d functions: %s." % (len(names), ", ".join(names)), ""]
    return "\n".join(lines)


def main():
    with open(PAGE, encoding="utf-8") as page:
        head = page.read().partition(MARK)[0]
    text = head + MARK + tables()
    if "--write" in sys.argv:
        with open(PAGE, "w", encoding="utf-8") as page:
            page.write(text)
    else:
        print(tables())


if __name__ == "__main__":
    main()
