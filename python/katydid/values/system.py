"""Value types of System that travel with geometry: Color, Guid, Complex, DateTime; and MeshFace."""

import datetime
import math
import uuid

from .base import Struct, number_text, static_value

#: .NET's known colours that scripts name, as 0xRRGGBB.
NAMED = {
    "Black": 0x000000, "White": 0xFFFFFF, "Red": 0xFF0000, "Lime": 0x00FF00, "Blue": 0x0000FF, "Yellow": 0xFFFF00,
    "Cyan": 0x00FFFF, "Aqua": 0x00FFFF, "Magenta": 0xFF00FF, "Fuchsia": 0xFF00FF, "Green": 0x008000, "Gray": 0x808080,
    "DarkGray": 0xA9A9A9, "LightGray": 0xD3D3D3, "DimGray": 0x696969, "Silver": 0xC0C0C0, "Orange": 0xFFA500,
    "DarkOrange": 0xFF8C00, "Brown": 0xA52A2A, "Purple": 0x800080, "Pink": 0xFFC0CB, "Navy": 0x000080,
    "Teal": 0x008080, "Olive": 0x808000, "Maroon": 0x800000, "DarkRed": 0x8B0000, "DarkGreen": 0x006400,
    "DarkBlue": 0x00008B, "LightBlue": 0xADD8E6, "SkyBlue": 0x87CEEB, "SteelBlue": 0x4682B4, "RoyalBlue": 0x4169E1,
    "Gold": 0xFFD700, "Crimson": 0xDC143C, "Coral": 0xFF7F50, "Tomato": 0xFF6347, "OrangeRed": 0xFF4500,
    "Indigo": 0x4B0082, "Violet": 0xEE82EE, "Turquoise": 0x40E0D0, "Tan": 0xD2B48C, "Beige": 0xF5F5DC,
    "Salmon": 0xFA8072, "Khaki": 0xF0E68C, "Lavender": 0xE6E6FA, "Chocolate": 0xD2691E, "SlateGray": 0x708090,
    "LightGreen": 0x90EE90, "LimeGreen": 0x32CD32, "ForestGreen": 0x228B22, "SeaGreen": 0x2E8B57, "Plum": 0xDDA0DD,
    "HotPink": 0xFF69B4, "DeepPink": 0xFF1493, "Firebrick": 0xB22222, "WhiteSmoke": 0xF5F5F5, "Azure": 0xF0FFFF,
    "Ivory": 0xFFFFF0}


class Color(Struct):
    """A colour of four bytes: alpha, red, green, blue. It cannot be changed."""

    __slots__ = ("_argb",)
    _fields = ("_argb",)
    _namespace = "System.Drawing"

    def __init__(self):
        self._argb = (0, 0, 0, 0)

    @classmethod
    def _of(cls, a, r, g, b):
        for part in (a, r, g, b):
            if not 0 <= part <= 255:
                raise ValueError("a colour's parts go from 0 to 255, not %r" % part)
        made = object.__new__(cls)
        made._argb = (int(a), int(r), int(g), int(b))
        return made

    @staticmethod
    def FromArgb(*parts):
        """(r, g, b), (a, r, g, b), (alpha, colour) or one number of 32 bits."""
        if len(parts) == 1:
            bits = int(parts[0]) & 0xFFFFFFFF
            return Color._of(bits >> 24, bits >> 16 & 255, bits >> 8 & 255, bits & 255)
        if len(parts) == 2:
            return Color._of(int(parts[0]), *parts[1]._argb[1:])
        parts = [int(part) for part in parts]
        return Color._of(*([255] + parts if len(parts) == 3 else parts))

    @staticmethod
    def FromName(name):
        bits = {key.lower(): value for key, value in NAMED.items()}.get(str(name).lower())
        return Color() if bits is None else Color.FromArgb(0xFF000000 | bits)

    A = property(lambda self: self._argb[0])
    R = property(lambda self: self._argb[1])
    G = property(lambda self: self._argb[2])
    B = property(lambda self: self._argb[3])
    IsEmpty = property(lambda self: self._argb == (0, 0, 0, 0))

    def ToArgb(self):
        a, r, g, b = self._argb
        bits = a << 24 | r << 16 | g << 8 | b
        return bits - (1 << 32) if bits >= 1 << 31 else bits

    def GetBrightness(self):
        parts = self._argb[1:]
        return (max(parts) + min(parts)) / 510.0

    def GetHue(self):
        r, g, b = (part / 255.0 for part in self._argb[1:])
        high, low = max(r, g, b), min(r, g, b)
        if high == low:
            return 0.0
        span = high - low
        sixth = (g - b) / span if high == r else 2.0 + (b - r) / span if high == g else 4.0 + (r - g) / span
        return sixth * 60.0 % 360.0

    def GetSaturation(self):
        high, low = max(self._argb[1:]) / 255.0, min(self._argb[1:]) / 255.0
        if high == low:
            return 0.0
        total = high + low
        return (high - low) / (total if total <= 1.0 else 2.0 - total)

    @property
    def Name(self):
        bits = self.ToArgb() & 0xFFFFFF
        known = [name for name, value in NAMED.items() if value == bits] if self._argb[0] == 255 else []
        return known[0] if known else "%02x%02x%02x%02x" % self._argb

    def ToString(self, *format_and_culture):
        return "Color [A=%d, R=%d, G=%d, B=%d]" % self._argb

    Empty = static_value(lambda cls: cls())
    Transparent = static_value(lambda cls: cls._of(0, 255, 255, 255))


for _name, _bits in NAMED.items():
    setattr(Color, _name, static_value(lambda cls, bits=_bits: cls.FromArgb(0xFF000000 | bits)))


class Guid(Struct):
    """A number of 128 bits that names one thing."""

    __slots__ = ("_bytes",)
    _fields = ("_bytes",)
    _namespace = "System"

    def __init__(self, text=None):
        if isinstance(text, Guid):
            self._bytes = text._bytes
        elif isinstance(text, (bytes, bytearray)) and len(text) == 16:
            # .NET's order of bytes: the first three fields are little-endian.
            self._bytes = uuid.UUID(bytes_le=bytes(text)).bytes
        elif text is None:
            self._bytes = bytes(16)
        else:
            try:
                self._bytes = uuid.UUID(str(text).strip("{}() ")).bytes
            except ValueError:
                raise ValueError("not a Guid: %s" % (text,))

    @classmethod
    def _of(cls, raw):
        made = object.__new__(cls)
        made._bytes = bytes(raw)
        return made

    @staticmethod
    def NewGuid():
        return Guid._of(uuid.uuid4().bytes)

    @staticmethod
    def Parse(text):
        return Guid(text)

    @staticmethod
    def TryParse(text, *place_holders):
        try:
            return True, Guid(text)
        except ValueError:
            return False, Guid()

    def ToByteArray(self):
        return uuid.UUID(bytes=self._bytes).bytes_le

    def CompareTo(self, other):
        return (self._bytes > other._bytes) - (self._bytes < other._bytes)

    def __lt__(self, other):
        return self._bytes < other._bytes

    def ToString(self, form="D"):
        text = str(uuid.UUID(bytes=self._bytes))
        return {"N": text.replace("-", ""), "B": "{%s}" % text, "P": "(%s)" % text}.get((form or "D").upper(), text)

    Empty = static_value(lambda cls: cls())


class Complex(Struct):
    """A complex number as Grasshopper and System.Numerics have it."""

    __slots__ = ("_c",)
    _fields = ("_c",)
    _namespace = "Grasshopper.Kernel.Types"

    def __init__(self, real=0.0, imaginary=0.0):
        self._c = real if isinstance(real, complex) else complex(float(real), float(imaginary))

    Real = property(lambda self: self._c.real)
    Imaginary = property(lambda self: self._c.imag)
    Magnitude = property(lambda self: abs(self._c))
    Modulus = Magnitude
    Phase = property(lambda self: math.atan2(self._c.imag, self._c.real))
    Argument = Phase

    @staticmethod
    def _bare(value):
        return value._c if isinstance(value, Complex) else complex(value)

    def __complex__(self):
        return self._c

    def __abs__(self):
        return abs(self._c)

    def __neg__(self):
        return Complex(-self._c)

    def ToString(self, *format_and_culture):
        sign = "-" if self._c.imag < 0 else "+"
        return "%s%s%si" % (number_text(self._c.real), sign, number_text(abs(self._c.imag)))


def _operators():
    import operator
    for name in ("add", "sub", "mul", "truediv", "pow"):
        work = getattr(operator, name)
        setattr(Complex, "__%s__" % name,
                lambda self, other, work=work: Complex(work(self._c, Complex._bare(other))))
        setattr(Complex, "__r%s__" % name,
                lambda self, other, work=work: Complex(work(Complex._bare(other), self._c)))


_operators()


class MeshFace(Struct):
    """Three or four vertices of a mesh; a triangle has its third vertex twice."""

    __slots__ = ("A", "B", "C", "D")
    _fields = ("A", "B", "C", "D")

    def __init__(self, a=-2147483648, b=-2147483648, c=-2147483648, d=None):
        self.Set(a, b, c, d)

    def Set(self, a, b, c, d=None):
        self.A, self.B, self.C, self.D = int(a), int(b), int(c), int(c if d is None else d)

    IsTriangle = property(lambda self: self.C == self.D)
    IsQuad = property(lambda self: self.C != self.D)

    def IsValid(self, vertices=2147483647):
        count = vertices if isinstance(vertices, int) else len(vertices)
        parts = self._parts()
        inside = all(0 <= part < count for part in parts)
        a, b, c, d = parts
        return inside and len({a, b, c}) == 3 and d not in (a, b)

    def Flip(self):
        if self.IsTriangle:
            return MeshFace(self.C, self.B, self.A)
        return MeshFace(self.D, self.C, self.B, self.A)

    def __getitem__(self, index):
        return self._parts()[index]

    def __setitem__(self, index, value):
        setattr(self, self._fields[index], int(value))

    def __iter__(self):
        return iter(self._parts())

    def __len__(self):
        return 4

    def ToString(self, *format_and_culture):
        return "T(%d, %d, %d)" % self._parts()[:3] if self.IsTriangle else "Q(%d, %d, %d, %d)" % self._parts()

    Unset = static_value(lambda cls: cls())



def ticks_of(moment):
    """Ticks of 100 ns from 0001-01-01 to a Python datetime."""
    span = moment.replace(tzinfo=None) - datetime.datetime(1, 1, 1)
    return (span.days * 86400 + span.seconds) * 10000000 + span.microseconds * 10


class DateTime(Struct):
    """A moment in ticks of 100 ns since 0001-01-01."""

    __slots__ = ("Ticks",)
    _fields = ("Ticks",)
    _namespace = "System"

    def __init__(self, *parts):
        if len(parts) == 1:
            self.Ticks = parts[0].Ticks if isinstance(parts[0], DateTime) else int(parts[0])
        elif not parts:
            self.Ticks = 0
        else:
            moment = datetime.datetime(*[int(part) for part in parts[:6]])
            self.Ticks = ticks_of(moment) + (int(parts[6]) * 10000 if len(parts) > 6 else 0)

    def _moment(self):
        return datetime.datetime(1, 1, 1) + datetime.timedelta(microseconds=self.Ticks // 10)

    Year = property(lambda self: self._moment().year)
    Month = property(lambda self: self._moment().month)
    Day = property(lambda self: self._moment().day)
    Hour = property(lambda self: self._moment().hour)
    Minute = property(lambda self: self._moment().minute)
    Second = property(lambda self: self._moment().second)
    Millisecond = property(lambda self: self.Ticks // 10000 % 1000)
    DayOfYear = property(lambda self: self._moment().timetuple().tm_yday)
    Date = property(lambda self: DateTime(self.Ticks - self.Ticks % 864000000000))
    Now = static_value(lambda cls: cls(ticks_of(datetime.datetime.now())))
    UtcNow = static_value(lambda cls: cls(ticks_of(datetime.datetime.now(datetime.timezone.utc))))
    Today = static_value(lambda cls: cls.Now.Date)

    def _plus(self, seconds):
        return DateTime(self.Ticks + round(seconds * 10000000))

    AddDays = lambda self, days: self._plus(days * 86400.0)  # noqa: E731
    AddHours = lambda self, hours: self._plus(hours * 3600.0)  # noqa: E731
    AddMinutes = lambda self, minutes: self._plus(minutes * 60.0)  # noqa: E731
    AddSeconds = _plus

    def __sub__(self, other):
        return datetime.timedelta(microseconds=(self.Ticks - other.Ticks) / 10)

    def __lt__(self, other):
        return self.Ticks < other.Ticks

    def __le__(self, other):
        return self.Ticks <= other.Ticks

    def __gt__(self, other):
        return self.Ticks > other.Ticks

    def __ge__(self, other):
        return self.Ticks >= other.Ticks

    def ToString(self, *format_and_culture):
        return self._moment().strftime("%m/%d/%Y %H:%M:%S")
