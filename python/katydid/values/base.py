"""What all value types share: .NET's methods on objects, number texts, and the constants of RhinoMath."""

import math
import struct

#: The coordinate of points that are not set (openNURBS' ON_UNSET_VALUE).
UNSET = -1.23432101234321e308
#: Lengths below this count as zero (2^-32).
ZERO_TOLERANCE = 2.0 ** -32
#: The square root of the relative precision of doubles.
SQRT_EPSILON = 1.490116119385e-8
#: One degree in radians.
DEFAULT_ANGLE_TOLERANCE = math.pi / 180.0


class NotSupported(AttributeError, NotImplementedError):
    """A member of RhinoCommon or Grasshopper that is not here; the text names it."""


def not_supported(name):
    """The error for a member, by its full name."""
    return NotSupported(name + " is not supported by Katydid yet")


def is_set(number):
    """Whether a coordinate is a number that can be computed with."""
    return -1e300 < number < 1e300


def is_number(value):
    """Whether a value counts as a number where .NET expects a double."""
    kind = type(value)
    if kind is float or kind is int:
        return True
    return isinstance(value, (int, float)) or (hasattr(value, "__float__") and not isinstance(value, str)
                                               and not hasattr(value, "__getitem__"))


def number_text(number):
    """A double as .NET writes it by default: the shortest digits that read back, an exponent from 1E+15 on."""
    if number != number:
        return "NaN"
    if number in (math.inf, -math.inf):
        return "∞" if number > 0 else "-∞"
    text = repr(float(number))
    mantissa, _, exponent = text.partition("e")
    sign = "-" if mantissa.startswith("-") else ""
    whole, _, fraction = mantissa.lstrip("-").partition(".")
    if fraction == "0":
        fraction = ""
    digits = (whole + fraction).lstrip("0")
    if not digits:
        return sign + "0"
    # The decimal point stands after this many of the digits.
    point = len(whole) + int(exponent or 0) - (len(whole + fraction) - len(digits))
    digits = digits.rstrip("0")
    if -4 < point <= 15:
        if point <= 0:
            return sign + "0." + "0" * -point + digits
        if point >= len(digits):
            return sign + digits + "0" * (point - len(digits))
        return sign + digits[:point] + "." + digits[point:]
    power = point - 1
    return "%s%s%sE%s%02d" % (sign, digits[0], "." + digits[1:] if len(digits) > 1 else "", "-+"[power > 0], abs(power))


def single(number):
    """A number rounded to single precision."""
    try:
        return struct.unpack("f", struct.pack("f", number))[0]
    except OverflowError:
        return math.copysign(math.inf, number)


class DotNetType:
    """What GetType() gives: the name of a type and little else."""

    __slots__ = ("cls",)

    def __init__(self, cls):
        self.cls = cls

    @property
    def Name(self):
        return getattr(self.cls, "_net_name", self.cls.__name__)

    @property
    def Namespace(self):
        return getattr(self.cls, "_namespace", "Rhino.Geometry")

    @property
    def FullName(self):
        return self.Namespace + "." + self.Name

    def IsSubclassOf(self, other):
        cls = getattr(other, "cls", other)
        return self.cls is not cls and issubclass(self.cls, cls)

    def IsAssignableFrom(self, other):
        return issubclass(getattr(other, "cls", other), self.cls)

    def IsInstanceOfType(self, thing):
        return isinstance(thing, self.cls)

    def ToString(self):
        return self.FullName

    __str__ = ToString

    def __repr__(self):
        return "<System.Type %s>" % self.FullName

    def __eq__(self, other):
        return self.cls is getattr(other, "cls", other)

    def __hash__(self):
        return hash(self.cls)


class DotNet:
    """The methods that every .NET object has."""

    __slots__ = ()

    def GetType(self):
        return DotNetType(type(self))

    def ToString(self):
        kind = DotNetType(type(self))
        return kind.FullName

    def Equals(self, other):
        return self == other

    def GetHashCode(self):
        return hash(self) & 0x7FFFFFFF

    def __str__(self):
        return self.ToString()

    def __repr__(self):
        return self.ToString()


class Struct(DotNet):
    """A value type: equal by its fields, copied by Duplicate, Clone and the copy module.

    A class lists the fields that make it in `_fields`; `_raw` makes one of them without checks.
    """

    __slots__ = ()
    _fields = ()

    def _parts(self):
        return tuple(getattr(self, field) for field in self._fields)

    def __eq__(self, other):
        if type(other) is not type(self):
            return NotImplemented
        return self._parts() == other._parts()

    def __ne__(self, other):
        same = self.__eq__(other)
        return same if same is NotImplemented else not same

    def __hash__(self):
        return hash(self._parts())

    def _copy(self):
        made = object.__new__(type(self))
        for field in self._fields:
            value = getattr(self, field)
            object.__setattr__(made, field, value._copy() if isinstance(value, Struct) else value)
        return made

    def Duplicate(self):
        return self._copy()

    Clone = Duplicate

    def __copy__(self):
        return self._copy()

    def __deepcopy__(self, memo):
        return self._copy()

    def __reduce__(self):
        return (_restore, (type(self),) + self._parts())

    def EpsilonEquals(self, other, epsilon):
        """Whether all numbers differ by no more than epsilon."""
        return type(other) is type(self) and all(
            abs(a - b) <= epsilon for a, b in zip(flat_numbers(self), flat_numbers(other)))


def _restore(cls, *parts):
    made = object.__new__(cls)
    for field, value in zip(cls._fields, parts):
        object.__setattr__(made, field, value)
    return made


def flat_numbers(value):
    """The numbers that a value type is made of, in the order of its fields."""
    if isinstance(value, Struct):
        found = []
        for part in value._parts():
            found.extend(flat_numbers(part))
        return found
    if isinstance(value, (tuple, list)):
        return [number for part in value for number in flat_numbers(part)]
    return [value]


class static_value:
    """A static property: a fresh value each time it is read, as C# copies structs."""

    __slots__ = ("make",)

    def __init__(self, make):
        self.make = make

    def __get__(self, instance, owner):
        return self.make(owner)


class dual:
    """A name that is both an instance method and a static one, as BoundingBox.Union."""

    __slots__ = ("instance", "static")

    def __init__(self, instance, static):
        self.instance, self.static = instance, static

    def __get__(self, thing, owner):
        return self.static if thing is None else self.instance.__get__(thing, owner)


class field:
    """A property over a slot that holds a struct: reading copies, assigning converts.

    So `plane.Origin.X = 3` changes nothing, as in C#, and `plane.Origin = (1, 2, 3)` works.
    """

    __slots__ = ("slot", "convert")

    def __init__(self, slot, convert):
        self.slot, self.convert = slot, convert

    def __get__(self, thing, owner):
        if thing is None:
            return self
        return getattr(thing, self.slot)._copy()

    def __set__(self, thing, value):
        object.__setattr__(thing, self.slot, self.convert(value))


class number:
    """A property over a slot that holds a number: assigning makes it a float."""

    __slots__ = ("slot",)

    def __init__(self, slot):
        self.slot = slot

    def __get__(self, thing, owner):
        return self if thing is None else getattr(thing, self.slot)

    def __set__(self, thing, value):
        object.__setattr__(thing, self.slot, float(value))
