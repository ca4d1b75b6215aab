"""The parts of .NET's System that scripts use."""

import random as _random

from katydid.rhino import missing as _missing
from katydid.system.array import Array  # noqa: F401
from katydid.system.basics import Activator, Convert, Enum, Environment, Math  # noqa: F401
from katydid.system.basics import Nullable, Object, String, Tuple, Type, Uri  # noqa: F401
from katydid.values.system import DateTime, Guid  # noqa: F401

Double = Single = Decimal = float
Int32 = Int64 = Int16 = UInt32 = UInt64 = Byte = int
Boolean = bool
Exception = Exception
ArgumentException = ValueError
ArgumentNullException = ValueError
InvalidOperationException = RuntimeError
NotImplementedException = NotImplementedError
IndexOutOfRangeException = IndexError
NullReferenceException = AttributeError
Action = Func = Predicate = Comparison = EventHandler = type("Delegate", (), {
    "__doc__": "A delegate is any callable.", "__class_getitem__": classmethod(lambda cls, types: cls),
    "__new__": lambda cls, call: call})


class Random:
    """Random numbers. The sequence of a seed is Python's, not .NET's."""

    def __init__(self, seed=None):
        self._source = _random.Random(seed)

    def Next(self, *bounds):
        low, high = bounds if len(bounds) == 2 else (0, bounds[0] if bounds else 2147483647)
        return low if high <= low else self._source.randrange(low, high)

    def NextDouble(self):
        return self._source.random()


class Console:
    WriteLine = staticmethod(print)
    Write = staticmethod(lambda text="": print(text, end=""))


class TimeSpan:
    """A span of time in seconds."""

    def __init__(self, *parts):
        days, hours, minutes, seconds = (0,) * (4 - len(parts)) + parts if len(parts) != 1 else (0, 0, 0, 0)
        self.TotalSeconds = parts[0] / 1e7 if len(parts) == 1 else \
            ((days * 24 + hours) * 60 + minutes) * 60.0 + seconds

    TotalMilliseconds = property(lambda self: self.TotalSeconds * 1000.0)
    TotalMinutes = property(lambda self: self.TotalSeconds / 60.0)


__getattr__ = _missing(__name__)
