"""System.Array: `Array[float]((1, 2))`, `Array.CreateInstance(float, 3)`."""

from ..values.netlist import NetList

#: What an item of a type is before it is set.
_ZERO = {float: 0.0, int: 0, bool: False}


class ArrayList(NetList):
    """A list of fixed length in .NET; here a list."""

    _net_name = "Array"
    _namespace = "System"
    Rank = property(lambda self: 1)
    LongLength = property(len)

    def GetLength(self, dimension):
        return len(self) if dimension == 0 else len(self[0])

    def GetUpperBound(self, dimension):
        return self.GetLength(dimension) - 1

    def GetLowerBound(self, dimension):
        return 0

    def GetValue(self, index):
        return self[index]

    def SetValue(self, value, index):
        self[index] = value

    def Clone(self):
        return type(self)(self)


class _Generic:
    """`Array[type]`: makes arrays of that type, of a sequence or of a length."""

    def __init__(self, kind):
        self.kind = kind

    def __call__(self, source=()):
        if isinstance(source, int):
            return ArrayList([_ZERO.get(self.kind)] * source)
        convert = self.kind if self.kind in (float, int, bool) else None
        return ArrayList(map(convert, source) if convert else source)

    def __instancecheck__(self, thing):
        return isinstance(thing, ArrayList)


class _ArrayClass(type):
    def __getitem__(cls, kind):
        return _Generic(kind)

    def __instancecheck__(cls, thing):
        return isinstance(thing, ArrayList)


class Array(metaclass=_ArrayClass):
    """The static members of System.Array."""

    @staticmethod
    def CreateInstance(kind, *lengths):
        if len(lengths) == 1:
            return ArrayList([_ZERO.get(kind)] * lengths[0])
        return ArrayList([Array.CreateInstance(kind, *lengths[1:]) for _ in range(lengths[0])])

    @staticmethod
    def Sort(array, *items):
        if items and isinstance(items[0], list):
            order = sorted(range(len(array)), key=array.__getitem__)
            items[0][:] = [items[0][i] for i in order]
        array.sort()

    @staticmethod
    def Reverse(array):
        array.reverse()

    @staticmethod
    def IndexOf(array, item):
        return array.index(item) if item in array else -1

    @staticmethod
    def Copy(source, target, length):
        target[:length] = source[:length]

    @staticmethod
    def ConvertAll(array, convert):
        return ArrayList(map(convert, array))

    @staticmethod
    def Empty():
        return ArrayList()
