"""Points and vectors in two and three dimensions, in double and single precision.

Coordinates are slots, so reading them costs no call; assigning goes through `__setattr__`, which makes floats of
integers as C# does. (A coordinate that stayed an integer would divide differently in Python 2 scripts.)
"""

import math

from .base import UNSET, ZERO_TOLERANCE, Struct, is_number, is_set, number_text, single, static_value


class Coordinates(Struct):
    """What points and vectors of any dimension share."""

    __slots__ = ()
    _rounded = False

    def __setattr__(self, name, value):
        value = float(value)
        object.__setattr__(self, name, single(value) if self._rounded else value)

    def __len__(self):
        return len(self._fields)

    def __bool__(self):
        return True

    def __iter__(self):
        return iter(self._parts())

    def __getitem__(self, index):
        return self._parts()[index]

    def __setitem__(self, index, value):
        setattr(self, self._fields[index], value)

    def __lt__(self, other):
        return self._parts() < other._parts() if type(other) is type(self) else NotImplemented

    def __le__(self, other):
        return self._parts() <= other._parts() if type(other) is type(self) else NotImplemented

    def __gt__(self, other):
        return self._parts() > other._parts() if type(other) is type(self) else NotImplemented

    def __ge__(self, other):
        return self._parts() >= other._parts() if type(other) is type(self) else NotImplemented

    def CompareTo(self, other):
        a, b = self._parts(), other._parts()
        return (a > b) - (a < b)

    @property
    def IsValid(self):
        return all(map(is_set, self._parts()))

    @property
    def MaximumCoordinate(self):
        return max(map(abs, self._parts())) if self.IsValid else 0.0

    @property
    def MinimumCoordinate(self):
        return min(map(abs, self._parts())) if self.IsValid else 0.0

    def ToString(self, *format_and_culture):
        return ",".join(map(number_text, self._parts()))

    @classmethod
    def _of(cls, *numbers):
        made = object.__new__(cls)
        for name, number in zip(cls._fields, numbers):
            object.__setattr__(made, name, single(number) if cls._rounded else number)
        return made

    @classmethod
    def TryParse(cls, text):
        """Reads "1, 2, 3", with or without brackets: (True, value), or (False, unset)."""
        try:
            numbers = [float(part) for part in str(text).strip().strip("(){}[]").split(",")]
        except ValueError:
            numbers = []
        if len(numbers) != len(cls._fields):
            return False, cls._of(*[UNSET] * len(cls._fields))
        return True, cls._of(*numbers)

    Unset = static_value(lambda cls: cls._of(*[UNSET] * len(cls._fields)))


class PointLike(Coordinates):
    """What points share; `_vector` is the class of their differences."""

    __slots__ = ()
    _vector = None

    def DistanceToSquared(self, other):
        return sum((a - b) ** 2 for a, b in zip(self._parts(), coordinates(other, len(self._fields))))

    def DistanceTo(self, other):
        return math.sqrt(self.DistanceToSquared(other))

    def __add__(self, other):
        if not isinstance(other, Coordinates) and not isinstance(other, (tuple, list)):
            return NotImplemented
        return self._of(*[a + b for a, b in zip(self._parts(), coordinates(other, len(self._fields)))])

    def __radd__(self, other):
        # sum([...]) of points starts from 0.
        return self._copy() if type(other) is int and other == 0 else self.__add__(other)

    def __sub__(self, other):
        if isinstance(other, PointLike):
            cls = self._vector
        elif isinstance(other, (Coordinates, tuple, list)):
            cls = type(self)
        else:
            return NotImplemented
        return cls._of(*[a - b for a, b in zip(self._parts(), coordinates(other, len(self._fields)))])

    def __mul__(self, other):
        if is_number(other):
            return self._of(*[a * float(other) for a in self._parts()])
        return NotImplemented

    __rmul__ = __mul__

    def __truediv__(self, other):
        return self._of(*[a / float(other) for a in self._parts()]) if is_number(other) else NotImplemented

    __div__ = __truediv__

    def __neg__(self):
        return self._of(*[-a for a in self._parts()])

    @classmethod
    def Add(cls, a, b):
        if not isinstance(a, PointLike) and isinstance(b, PointLike):
            a, b = b, a
        return cls._of(*coordinates(a, len(cls._fields))) + b

    @staticmethod
    def Subtract(a, b):
        return a - b

    @staticmethod
    def Multiply(a, b):
        return a * b

    @staticmethod
    def Divide(a, b):
        return a / b

    Origin = static_value(lambda cls: cls._of(*[0.0] * len(cls._fields)))


class VectorLike(Coordinates):
    """What vectors share."""

    __slots__ = ()

    @property
    def SquareLength(self):
        return sum(a * a for a in self._parts())

    @property
    def Length(self):
        return math.sqrt(self.SquareLength) if self.IsValid else 0.0

    @property
    def IsZero(self):
        return not any(self._parts())

    @property
    def IsUnitVector(self):
        return self.IsValid and abs(self.Length - 1.0) <= 1.490116119385e-8

    def IsTiny(self, tolerance=ZERO_TOLERANCE):
        return all(abs(a) <= tolerance for a in self._parts())

    def Unitize(self):
        """Makes the length 1: False, and no change, where there is none."""
        length = self.Length
        if not self.IsValid or length <= 0.0:
            return False
        for name, value in zip(self._fields, self._parts()):
            setattr(self, name, value / length)
        return True

    def Reverse(self):
        if not self.IsValid:
            return False
        for name, value in zip(self._fields, self._parts()):
            setattr(self, name, -value)
        return True

    def __add__(self, other):
        if isinstance(other, PointLike):
            return other + self
        if not isinstance(other, (Coordinates, tuple, list)):
            return NotImplemented
        return self._of(*[a + b for a, b in zip(self._parts(), coordinates(other, len(self._fields)))])

    def __radd__(self, other):
        return self._copy() if type(other) is int and other == 0 else self.__add__(other)

    def __sub__(self, other):
        if not isinstance(other, (Coordinates, tuple, list)):
            return NotImplemented
        return self._of(*[a - b for a, b in zip(self._parts(), coordinates(other, len(self._fields)))])

    def __mul__(self, other):
        """By a number; with another vector (or a point) the dot product."""
        if isinstance(other, Coordinates):
            return sum(a * b for a, b in zip(self._parts(), coordinates(other, len(self._fields))))
        return self._of(*[a * float(other) for a in self._parts()]) if is_number(other) else NotImplemented

    def __rmul__(self, other):
        return self.__mul__(other) if is_number(other) else NotImplemented

    def __truediv__(self, other):
        return self._of(*[a / float(other) for a in self._parts()]) if is_number(other) else NotImplemented

    __div__ = __truediv__

    def __neg__(self):
        return self._of(*[-a for a in self._parts()])

    @classmethod
    def Add(cls, a, b):
        return a + b

    @staticmethod
    def Subtract(a, b):
        return a - b

    @staticmethod
    def Multiply(a, b):
        return a * b

    @staticmethod
    def Divide(a, b):
        return a / b

    @staticmethod
    def Negate(a):
        return -a

    Zero = static_value(lambda cls: cls._of(*[0.0] * len(cls._fields)))


def coordinates(value, count):
    """The first `count` coordinates of a point, a vector or a sequence of numbers; missing ones are 0."""
    if isinstance(value, Coordinates):
        parts = value._parts()
    elif hasattr(value, "Location") and not isinstance(value, (str, bytes)):
        parts = value.Location._parts()
    elif isinstance(value, (str, bytes)) or not hasattr(value, "__iter__"):
        raise TypeError("expected Point3d, got %s" % type(value).__name__)
    else:
        try:
            parts = tuple(float(part) for part in value)
        except TypeError:
            raise TypeError("expected Point3d, got %s" % type(value).__name__)
        if not 2 <= len(parts) <= 4:
            raise TypeError("expected Point3d, got %d numbers" % len(parts))
    return parts[:count] if len(parts) >= count else parts + (0.0,) * (count - len(parts))


def fill(made, arguments):
    """Sets the fields of a new value from a constructor's arguments: numbers, or one thing with coordinates."""
    cls = type(made)
    count = len(cls._fields)
    if len(arguments) == count and is_number(arguments[0]):
        numbers = arguments
    elif not arguments:
        numbers = (0.0,) * count
    elif len(arguments) == 1:
        numbers = coordinates(arguments[0], count)
    else:
        raise TypeError("%s() takes %d numbers or one point, got %d arguments" % (cls.__name__, count, len(arguments)))
    for name, value in zip(cls._fields, numbers):
        setattr(made, name, value)
