"""An object that the host holds, by its number. Members come from the host's table: there is no list of them here."""

from .. import codec
from ..backend import current
from ..values.base import DotNet, not_supported
from .call import full_name, invoke, shaped
from .list_names import LISTS, PICKED_FIELDS, RECORD_METHODS, has_list


class Member:
    """A method of an object, or, without one, a member of a class."""

    __slots__ = ("owner", "name", "names", "bound")

    def __init__(self, owner, name, names, bound=()):
        self.owner, self.name, self.names, self.bound = owner, name, names, bound

    def __call__(self, *arguments, **keywords):
        everything = self.bound + arguments
        try:
            return invoke(self.owner, self.name, self.names, everything, keywords)
        finally:
            # What was read of an object that the member changes is read again.
            if everything and hasattr(type(everything[0]), "_stale") and \
                    current().table.changes(self.names, self.name):
                everything[0]._stale()

    def __getitem__(self, types):
        """`Member[type](...)` and `Member.Overloads[...]`: the host picks the overload by the arguments."""
        return self

    Overloads = property(lambda self: self)

    @property
    def __doc__(self):
        return "\n".join(s for name in self.names for s in current().table.signatures(name, self.name))

    __name__ = property(lambda self: self.name)

    def __repr__(self):
        return "<member %s>" % full_name(self.owner, self.name)


class HostClass(type):
    """The type of host classes: static members are asked of the host's table."""

    def __getattr__(cls, name):
        if name.startswith("_"):
            raise AttributeError(name)
        table = current().table
        for owner in cls._names():
            if table.has(owner, name):
                return Member(cls._host_name(), name, cls._names())
            if table.has(owner, "get_" + name) and not any("(this" in s for s in
                                                           table.signatures(owner, "get_" + name)):
                return invoke(owner, "get_" + name, [owner], ())
        raise not_supported(full_name(cls._host_name(), name))

    def _host_name(cls):
        return cls.__dict__.get("_net_name", cls.__name__)

    def _names(cls):
        """The class and those that it inherits from, as the table names them."""
        return [base._host_name() for base in cls.__mro__ if isinstance(base, HostClass) and base is not HostObject]

    def __getitem__(cls, types):
        return cls

    Overloads = property(lambda cls: cls)


class HostObject(DotNet, metaclass=HostClass):
    """Holds a handle. What is not found on the Python class is a member of the host's table."""

    __slots__ = ("_number", "_kind", "_cache", "__weakref__")

    def __init__(self, *arguments):
        name = type(self)._host_name()
        if not current().table.has(name, "new"):
            raise not_supported("Rhino.Geometry.%s(...)" % name)
        self._adopt(invoke(name, "new", [name], arguments))

    def _adopt(self, made):
        """Takes over the handle of another object, which is left without one."""
        if not isinstance(made, HostObject):
            raise TypeError("%s gave no object" % type(self).__name__)
        object.__setattr__(self, "_number", made._number)
        object.__setattr__(self, "_kind", made._kind)
        object.__setattr__(self, "_cache", None)
        object.__setattr__(made, "_number", 0)

    @classmethod
    def _of(cls, number, kind):
        made = object.__new__(cls)
        object.__setattr__(made, "_number", number)
        object.__setattr__(made, "_kind", kind)
        object.__setattr__(made, "_cache", None)
        return made

    def _stale(self):
        """Forgets what was read of the object's lists."""
        object.__setattr__(self, "_cache", None)

    def _settle(self):
        """Tells the host what waits in Python: see `Mesh`."""

    def _lower(self):
        if not self._number:
            raise ValueError("this %s has been disposed of" % type(self).__name__)
        return codec.Reference(self._number, self._kind)

    def __del__(self):
        number = getattr(self, "_number", 0)
        if number:
            try:
                current().release(number)
            except Exception:  # The interpreter is closing: nobody counts any more.
                pass

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        cls, table = type(self), current().table
        for owner in cls._names():
            if has_list(table, owner, name):
                from .lists import list_of
                return list_of(self, LISTS[owner][name], name)
            if table.has(owner, "get_" + name):
                return shaped(current().call("%s.get_%s" % (cls._host_name(), name), self),
                              table.signatures(owner, "get_" + name))
            if table.has(owner, name):
                return Member(cls._host_name(), name, cls._names(), (self,))
        if name in PICKED_FIELDS.get(cls._host_name(), ()):
            return lambda index: getattr(self, "%s%d" % (name, index + 1))
        if getattr(cls, "_is_record", False):
            value = shaped(current().call("%s.get_%s" % (cls._host_name(), name), self), ())
            # A record holds what RhinoCommon computes in a method too.
            return (lambda *arguments: value) if name in RECORD_METHODS.get(cls._host_name(), ()) else value
        raise not_supported(full_name(cls._host_name(), name))

    def __setattr__(self, name, value):
        if name.startswith("_") or isinstance(getattr(type(self), name, None) if name in dir(type(self)) else None,
                                              property):
            object.__setattr__(self, name, value)
            return
        cls, table = type(self), current().table
        for owner in cls._names():
            if table.has(owner, "set_" + name):
                current().call("%s.set_%s" % (cls._host_name(), name), self, value)
                self._stale()
                return
        raise not_supported(full_name(cls._host_name(), name) + " (to write)")

    def Dispose(self):
        """Lets the host forget the object now."""
        number = self._number
        object.__setattr__(self, "_number", 0)
        if number:
            current().release(number)

    def __enter__(self):
        return self

    def __exit__(self, *exception):
        self.Dispose()

    def _twin(self):
        return current().call(type(self)._host_name() + ".Duplicate", self)

    def __copy__(self):
        return self._twin()

    def __deepcopy__(self, memo):
        return self._twin()
