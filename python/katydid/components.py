"""Components of the registry as Python functions.

Inputs come in the order of the ports, or by name; lists run the component over their items, as on a canvas. One output
is given by itself, several as a named tuple. A single value in gives a single value out, a list in gives lists.
"""

import collections
import keyword
import re

from .backend import current
from .grasshopper import DataTree
from .run.outputs import is_list
from .values.base import not_supported


def identifier(name):
    """A port's or component's name as a Python name: 'Curve | Curve' -> CurveXCurve, '2D' -> _2D."""
    text = name.replace("|", "X").replace("+", "").replace("=", "Equal")
    text = re.sub(r"\W", "", text)
    if text[:1].isdigit() or keyword.iskeyword(text):
        text = "_" + text
    return text


def nick_of(entry):
    """The short name of a component or port."""
    return entry.get("nickname") or entry.get("nick") or ""


class Names:
    """The functions of a registry, by identifier. `Plugin.Component` reaches components of a tab or plug-in."""

    def __init__(self):
        self._found, self._registry = {}, None

    def _load(self):
        if self._registry is None:
            self._registry = {}
            for entry in current().components():
                self._registry.setdefault(identifier(entry["name"]).lower(), entry)
                # A name of an old file or a nickname does not hide a name.
            for entry in list(self._registry.values()):
                nick = identifier(nick_of(entry)).lower()
                if nick:
                    self._registry.setdefault(nick, entry)
        return self._registry

    def all(self):
        return sorted({identifier(entry["name"]) for entry in self._load().values()})

    def find(self, name):
        if name not in self._found:
            entry = self._load().get(name.lower())
            if entry is None:
                raise not_supported("ghpythonlib.components." + name)
            self._found[name] = Function(entry)
        return self._found[name]


class Function:
    """One component."""

    def __init__(self, entry):
        self.entry = entry
        self.inputs = entry.get("inputs") or []
        self.outputs = entry.get("outputs") or []
        self.__name__ = identifier(entry["name"])
        names = [identifier(port["name"]).lower() or "_%d" % i for i, port in enumerate(self.outputs)]
        self._tuple = _tuple_class(self.__name__, _distinct(names)) if len(names) > 1 else None

    def __repr__(self):
        ins = ", ".join(port["name"] for port in self.inputs)
        return "<component %s(%s)>" % (self.__name__, ins)

    def place(self, name):
        """The input that a keyword names: by name or nickname, case aside."""
        wanted = name.lower()
        for i, port in enumerate(self.inputs):
            if wanted in (identifier(port["name"]).lower(), identifier(nick_of(port)).lower()):
                return i
        raise TypeError("%s has no input %s" % (self.__name__, name))

    def __call__(self, *arguments, **keywords):
        # More than the ports: some components take any number, and the host says where one does not.
        values = list(arguments) + [None] * (len(self.inputs) - len(arguments))
        for name, value in keywords.items():
            values[self.place(name)] = value
        values = [_input(value) for value in values]
        answer = current().component(self.entry.get("id") or self.entry["name"], values)
        several = any(isinstance(value, DataTree) or (
            isinstance(value, list) and port.get("access", "item") == "item")
            for value, port in zip(values, self.inputs + self.inputs[-1:] * len(values)))
        results = [_output(value, several) for value in answer]
        if not self._tuple:
            return results[0] if results else None
        return self._tuple(*results + [None] * (len(self.outputs) - len(results)))


def _tuple_class(name, names):
    """A named tuple whose names are found with and without underscores, in any case: `uv_point`, `uvPoint`."""
    base = collections.namedtuple(name if name.isidentifier() else "Output", names)

    def find(self, wanted):
        plain = wanted.replace("_", "").lower()
        if wanted.startswith("__") or plain not in names:
            raise AttributeError("%s has no output %s" % (name, wanted))
        return self[names.index(plain)]
    return type(base.__name__, (base,), {"__slots__": (), "__getattr__": find})


def _distinct(names):
    """Names for a tuple: valid, and each once."""
    made = []
    for name in names:
        name = name.lstrip("_") or "output"
        if keyword.iskeyword(name) or not name.isidentifier():
            name = "o" + re.sub(r"\W", "", name)
        base, count = name, 1
        while name in made:
            count += 1
            name = base + str(count)
        made.append(name)
    return made


def _input(value):
    """A value as an input takes it: Guids of the document become geometry, lists stay lists."""
    from .document import find
    from .values.system import Guid
    if isinstance(value, Guid):
        found = find(value)
        return value if found is None else found.Geometry
    if isinstance(value, DataTree) or value is None:
        return value
    if is_list(value):
        return [_input(one) for one in value]
    return value._unwrap() if hasattr(type(value), "_unwrap") else value


def _output(value, several):
    """A tree of one branch as its items; one item alone where a single value went in."""
    if isinstance(value, DataTree):
        branches = value.Branches
        if len(branches) > 1:
            # Results of several iterations of a component that gives lists: one list after the other.
            return [item for branch in branches for item in branch]
        value = list(branches[0]) if branches else []
    if isinstance(value, list) and not several and len(value) <= 1:
        return value[0] if value else None
    return value
