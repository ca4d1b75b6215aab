"""Math, String, Convert, Enum, Environment, Object and Type of System."""

import math
import os
import sys

from ..values.base import DotNetType, not_supported, number_text


class _AnyClass(type):
    def __instancecheck__(cls, thing):
        return True


class Object(metaclass=_AnyClass):
    """The base of everything, which every value is one of. `System.Object` as a type of generics."""

    def GetType(self):
        return DotNetType(type(self))

    def ToString(self):
        return str(self)


def _half_even(value, digits=0, *mode):
    """.NET rounds halves to even unless told MidpointRounding.AwayFromZero (1)."""
    if mode and int(mode[0]) == 1:
        scale = 10.0 ** digits
        return math.copysign(math.floor(abs(value) * scale + 0.5), value) / scale
    return float(round(value, digits))


class Math:
    """System.Math."""

    PI, E = math.pi, math.e
    Abs = staticmethod(abs)
    Sqrt = staticmethod(lambda x: math.sqrt(x) if x >= 0.0 else math.nan)
    Pow = staticmethod(lambda x, y: math.pow(x, y))
    Exp, Floor = staticmethod(math.exp), staticmethod(lambda x: float(math.floor(x)))
    Ceiling = staticmethod(lambda x: float(math.ceil(x)))
    Truncate = staticmethod(lambda x: float(math.trunc(x)))
    Round = staticmethod(_half_even)
    Sin, Cos, Tan = staticmethod(math.sin), staticmethod(math.cos), staticmethod(math.tan)
    Asin, Acos, Atan = staticmethod(math.asin), staticmethod(math.acos), staticmethod(math.atan)
    Atan2, Sinh, Cosh, Tanh = (staticmethod(math.atan2), staticmethod(math.sinh), staticmethod(math.cosh),
                               staticmethod(math.tanh))
    Log = staticmethod(lambda x, *base: math.log(x, *base) if x > 0.0 else -math.inf if x == 0.0 else math.nan)
    Log10 = staticmethod(lambda x: math.log10(x) if x > 0.0 else -math.inf if x == 0.0 else math.nan)
    Min, Max = staticmethod(min), staticmethod(max)
    Sign = staticmethod(lambda x: (x > 0) - (x < 0))
    IEEERemainder = staticmethod(math.remainder)
    DivRem = staticmethod(lambda a, b: (int(math.trunc(a / b)), int(math.fmod(a, b))))


class _TextClass(type):
    def __instancecheck__(cls, thing):
        return isinstance(thing, str)

    def __call__(cls, value="", *count):
        return str(value) * count[0] if count else "".join(value)


class String(metaclass=_TextClass):
    """System.String: static members; every Python text is one."""

    Empty = ""
    Format = staticmethod(lambda form, *items: str(form).format(*items))
    Join = staticmethod(lambda separator, *items: separator.join(
        map(str, items[0] if len(items) == 1 and not isinstance(items[0], str) else items)))
    Concat = staticmethod(lambda *items: "".join(map(str, items)))
    IsNullOrEmpty = staticmethod(lambda text: not text)
    IsNullOrWhiteSpace = staticmethod(lambda text: not text or not text.strip())
    Compare = staticmethod(lambda a, b, *rules: (a > b) - (a < b))


def _whole(value, *base):
    if isinstance(value, str):
        return int(value, *base)
    return int(round(value))


class Convert:
    """System.Convert: numbers round halves to even."""

    ToDouble = ToSingle = ToDecimal = staticmethod(float)
    ToInt32 = ToInt64 = ToInt16 = ToByte = staticmethod(_whole)
    ToBoolean = staticmethod(lambda value: value.strip().lower() == "true" if isinstance(value, str) else bool(value))
    ToString = staticmethod(lambda value, *rules: number_text(value) if isinstance(value, float) else str(value))

    @staticmethod
    def ToBase64String(data):
        import base64
        return base64.b64encode(bytes(data)).decode("ascii")

    @staticmethod
    def FromBase64String(text):
        import base64
        return base64.b64decode(text)


class Enum:
    """System.Enum, for the enumerations that are here."""

    @staticmethod
    def ToObject(kind, value):
        kind = getattr(kind, "cls", kind)
        try:
            return kind(int(value))
        except ValueError:
            return int(value)

    @staticmethod
    def GetNames(kind):
        return [member._name_ for member in getattr(kind, "cls", kind)._value2member_map_.values()]

    @staticmethod
    def GetValues(kind):
        return list(getattr(kind, "cls", kind)._value2member_map_.values())

    @staticmethod
    def GetName(kind, value):
        return Enum.ToObject(kind, value)._name_

    @staticmethod
    def Parse(kind, name, ignore_case=False):
        for member in Enum.GetValues(kind):
            if member._name_ == name or (ignore_case and member._name_.lower() == name.lower()):
                return member
        raise ValueError("%s has no member %s" % (getattr(kind, "__name__", kind), name))

    @staticmethod
    def IsDefined(kind, value):
        return value in Enum.GetNames(kind) or value in Enum.GetValues(kind)


class _StaticProperty:
    def __init__(self, read):
        self.read = read

    def __get__(self, thing, owner):
        return self.read()


class Environment:
    """System.Environment: nothing of the machine but what a script needs to run."""

    NewLine = "\n"
    ProcessorCount = _StaticProperty(lambda: os.cpu_count() or 1)
    UserName = _StaticProperty(lambda: os.environ.get("USER", ""))
    CurrentDirectory = _StaticProperty(os.getcwd)
    Version = _StaticProperty(lambda: ".".join(map(str, sys.version_info[:3])))

    @staticmethod
    def GetEnvironmentVariable(name, *target):
        return os.environ.get(name)

    @staticmethod
    def ExpandEnvironmentVariables(text):
        import re
        return re.sub("%([^%]+)%", lambda found: os.environ.get(found.group(1), found.group(0)), text)

    @staticmethod
    def GetFolderPath(folder):
        raise not_supported("System.Environment.GetFolderPath")


class Type:
    """System.Type: types are Python's classes here."""

    @staticmethod
    def GetType(name):
        raise not_supported("System.Type.GetType(%r)" % name)


class Activator:
    CreateInstance = staticmethod(lambda kind, *arguments: getattr(kind, "cls", kind)(*arguments))


class _Generic:
    def __class_getitem__(cls, types):
        return cls


class Nullable(_Generic):
    def __new__(cls, value=None):
        return value


class Tuple(_Generic):
    """System.Tuple, as a Python tuple."""

    def __new__(cls, *items):
        return tuple(items)

    Create = staticmethod(lambda *items: tuple(items))


class Uri:
    def __init__(self, text):
        self.OriginalString = self.AbsoluteUri = text

    def ToString(self):
        return self.AbsoluteUri

    __str__ = ToString
