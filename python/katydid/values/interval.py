"""Interval: two numbers, whose order is kept."""

from .base import UNSET, Struct, is_set, number, number_text, static_value


class Interval(Struct):
    """A domain from T0 to T1; decreasing ones are allowed."""

    __slots__ = ("_t0", "_t1")
    _fields = ("_t0", "_t1")

    T0 = number("_t0")
    T1 = number("_t1")

    def __init__(self, *arguments):
        if not arguments:
            self._t0 = self._t1 = 0.0
        elif len(arguments) == 1:
            other = to_interval(arguments[0])
            self._t0, self._t1 = other._t0, other._t1
        else:
            self._t0, self._t1 = float(arguments[0]), float(arguments[1])

    def __getitem__(self, index):
        return (self._t0, self._t1)[index]

    def __setitem__(self, index, value):
        setattr(self, ("_t0", "_t1")[index], float(value))

    def __iter__(self):
        return iter((self._t0, self._t1))

    def __len__(self):
        return 2

    IsValid = property(lambda self: is_set(self._t0) and is_set(self._t1))
    IsSingleton = property(lambda self: self.IsValid and self._t0 == self._t1)
    IsIncreasing = property(lambda self: self.IsValid and self._t0 < self._t1)
    IsDecreasing = property(lambda self: self.IsValid and self._t0 > self._t1)
    Min = property(lambda self: min(self._t0, self._t1) if self.IsValid else UNSET)
    Max = property(lambda self: max(self._t0, self._t1) if self.IsValid else UNSET)
    Mid = property(lambda self: 0.5 * (self._t0 + self._t1) if self.IsValid else UNSET)
    Length = property(lambda self: self._t1 - self._t0 if self.IsValid else 0.0)

    def ParameterAt(self, normalizedParameter):
        t = normalizedParameter
        return (1.0 - t) * self._t0 + t * self._t1 if self.IsValid else UNSET

    def NormalizedParameterAt(self, intervalParameter):
        if not self.IsValid:
            return UNSET
        if self._t0 == self._t1:
            return self._t0
        if intervalParameter == self._t1:
            return 1.0
        return (intervalParameter - self._t0) / (self._t1 - self._t0)

    def ParameterIntervalAt(self, normalizedInterval):
        a, b = to_interval(normalizedInterval)
        return Interval(self.ParameterAt(a), self.ParameterAt(b))

    def NormalizedIntervalAt(self, intervalParameter):
        a, b = to_interval(intervalParameter)
        return Interval(self.NormalizedParameterAt(a), self.NormalizedParameterAt(b))

    def IncludesParameter(self, t, strict=False):
        if not is_set(t) or not self.IsValid:
            return False
        return self.Min < t < self.Max if strict else self.Min <= t <= self.Max

    def IncludesInterval(self, interval, strict=False):
        return self.IncludesParameter(interval._t0, strict) and self.IncludesParameter(interval._t1, strict)

    def Grow(self, value):
        """Extends the interval to a value; a decreasing one becomes increasing first."""
        self.MakeIncreasing()
        self._t0, self._t1 = min(self._t0, float(value)), max(self._t1, float(value))

    def MakeIncreasing(self):
        if self.IsDecreasing:
            self.Swap()

    def Swap(self):
        self._t0, self._t1 = self._t1, self._t0

    def Reverse(self):
        """From -T1 to -T0, as openNURBS reverses parameters."""
        self._t0, self._t1 = -self._t1, -self._t0

    @staticmethod
    def FromIntersection(a, b):
        if not (a.IsValid and b.IsValid):
            return Interval.Unset
        low, high = max(a.Min, b.Min), min(a.Max, b.Max)
        return Interval(low, high) if low <= high else Interval.Unset

    @staticmethod
    def FromUnion(a, b):
        valid = [one for one in (a, b) if one.IsValid]
        if not valid:
            return Interval.Unset
        return Interval(min(one.Min for one in valid), max(one.Max for one in valid))

    def CompareTo(self, other):
        a, b = self._parts(), other._parts()
        return (a > b) - (a < b)

    __lt__ = lambda self, other: self._parts() < other._parts()  # noqa: E731
    __le__ = lambda self, other: self._parts() <= other._parts()  # noqa: E731
    __gt__ = lambda self, other: self._parts() > other._parts()  # noqa: E731
    __ge__ = lambda self, other: self._parts() >= other._parts()  # noqa: E731

    def __add__(self, value):
        return Interval(self._t0 + value, self._t1 + value)

    __radd__ = __add__

    def __sub__(self, value):
        return Interval(self._t0 - value, self._t1 - value)

    def __rsub__(self, value):
        return Interval(value - self._t0, value - self._t1)

    def ToString(self, *format_and_culture):
        return "%s,%s" % (number_text(self._t0), number_text(self._t1))

    Unset = static_value(lambda cls: cls(UNSET, UNSET))


def to_interval(value):
    """An Interval of an interval, a pair, or a number (from 0)."""
    if isinstance(value, Interval):
        return value._copy()
    if isinstance(value, (tuple, list)) and len(value) == 2:
        return Interval(*value)
    return Interval(0.0, float(value))
