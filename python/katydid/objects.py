"""What travels by reference: geometry by handle, Grasshopper's trees and paths, objects of the script by token."""

import reprlib

from . import codec


#: Beyond so many objects of a run panels show no texts, and texts are cut at so many characters.
MOST_TEXTS, LONGEST_TEXT = 10000, 10000

#: Writes containers as `str` does, but not all of a large one.
_CONTAINERS = reprlib.Repr()
_CONTAINERS.maxlist = _CONTAINERS.maxtuple = _CONTAINERS.maxdict = _CONTAINERS.maxset = _CONTAINERS.maxfrozenset = 200
_CONTAINERS.maxdeque = _CONTAINERS.maxarray = 200
_CONTAINERS.maxstring = _CONTAINERS.maxother = _CONTAINERS.maxlong = 1000


def text_of(thing):
    """What a panel shows of an object: its text, or the name of its class where that cannot be made."""
    try:
        if isinstance(thing, (list, tuple, dict, set, frozenset)) and type(thing).__str__ is object.__str__ \
                and type(thing).__module__ == "builtins":
            text = _CONTAINERS.repr(thing)
        elif type(thing).__str__ is object.__str__ and type(thing).__repr__ is object.__repr__ \
                and callable(getattr(thing, "ToString", None)):
            # A class that is written as .NET's are.
            text = thing.ToString()
        else:
            text = str(thing)
        return str(text)[:LONGEST_TEXT]
    except (Exception, SystemExit):
        return type(thing).__name__


class Objects(codec.Handles):
    """The codec's questions, answered with the geometry classes and with one table of tokens."""

    def __init__(self):
        self._objects, self._next = {}, 1
        #: The numbers that were given since somebody asked.
        self._fresh = []

    def geometry(self, number, kind):
        from .geometry import of_handle
        return of_handle(number, kind)

    def tree(self, branches):
        from .grasshopper import DataTree
        return DataTree._of(branches)

    def path(self, indices):
        from .grasshopper import GH_Path
        return GH_Path(*indices)

    def token(self, number):
        return self._objects.get(number)

    def forget(self, numbers):
        """Drops objects that no wire holds any more."""
        for number in numbers:
            self._objects.pop(number, None)

    def keep(self, thing):
        """A token for any object. The same object may have several: each is dropped on its own."""
        number = self._next
        self._next += 1
        self._objects[number] = thing
        self._fresh.append(number)
        return codec.Token(number)

    def texts(self):
        """How Python writes the objects that were kept since this was asked last, by number."""
        fresh, self._fresh = self._fresh, []
        return {number: text_of(self._objects[number]) for number in fresh[:MOST_TEXTS] if number in self._objects}

    def lower(self, value):
        lower = getattr(type(value), "_lower", None)
        if lower is not None:
            return lower(value)
        if isinstance(value, (list, tuple)):
            return list(value)
        if isinstance(value, dict):
            return dict(value)
        raise codec.CodecError("a %s cannot be given to the host" % type(value).__name__)


class Outgoing(Objects):
    """For a run's answer: every object that is not ours travels as a token of another table."""

    def __init__(self, table):
        self.table = table

    def lower(self, value):
        lower = getattr(type(value), "_lower", None)
        return self.table.keep(value) if lower is None else lower(value)
