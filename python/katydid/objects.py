"""What travels by reference: geometry by handle, Grasshopper's trees and paths, objects of the script by token."""

from . import codec


class Objects(codec.Handles):
    """The codec's questions, answered with the geometry classes and with one table of tokens."""

    def __init__(self):
        self._objects, self._next = {}, 1

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
        return codec.Token(number)

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
