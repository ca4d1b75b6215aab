"""A list with the methods of .NET's List<T> beside Python's own."""

from .base import DotNetType


class NetList(list):
    """A Python list that also answers Count, Add, RemoveAt and the rest of List<T>."""

    _net_name = "List`1"
    _namespace = "System.Collections.Generic"

    @staticmethod
    def _item(value):
        """What is stored for a value: lists of one type convert here."""
        return value

    Count = property(len)
    Length = property(len)
    Capacity = property(len, lambda self, value: None)

    def Add(self, item):
        self.append(self._item(item))

    def AddRange(self, items):
        self.extend(map(self._item, items))

    def Insert(self, index, item):
        if not 0 <= index <= len(self):
            raise IndexError("index %d is outside the list" % index)
        self.insert(index, self._item(item))

    def InsertRange(self, index, items):
        self[index:index] = list(map(self._item, items))

    def Remove(self, item):
        if item in self:
            self.remove(item)
            return True
        return False

    def RemoveAt(self, index):
        if not 0 <= index < len(self):
            raise IndexError("index %d is outside the list" % index)
        del self[index]

    def RemoveRange(self, index, count):
        del self[index:index + count]

    def RemoveAll(self, match):
        before = len(self)
        self[:] = [item for item in self if not match(item)]
        return before - len(self)

    def Clear(self):
        del self[:]

    def Contains(self, item):
        return item in self

    def IndexOf(self, item, start=0, *count):
        end = start + count[0] if count else len(self)
        return next((i for i in range(start, min(end, len(self))) if self[i] == item), -1)

    def LastIndexOf(self, item):
        return next((i for i in range(len(self) - 1, -1, -1) if self[i] == item), -1)

    def GetRange(self, index, count):
        return type(self)(self[index:index + count])

    def Reverse(self, *part):
        if part:
            index, count = part
            self[index:index + count] = self[index:index + count][::-1]
        else:
            self.reverse()

    def Sort(self, comparison=None):
        from functools import cmp_to_key
        self.sort(key=cmp_to_key(comparison) if comparison else None)

    def ToArray(self):
        return list(self)

    ToList = ToArray

    def CopyTo(self, array, index=0):
        array[index:index + len(self)] = list(self)

    def Exists(self, match):
        return any(map(match, self))

    def TrueForAll(self, match):
        return all(map(match, self))

    def Find(self, match):
        return next(filter(match, self), None)

    def FindLast(self, match):
        return next(filter(match, reversed(self)), None)

    def FindAll(self, match):
        return type(self)(filter(match, self))

    def FindIndex(self, match):
        return next((i for i, item in enumerate(self) if match(item)), -1)

    def ForEach(self, action):
        for item in self:
            action(item)

    def ConvertAll(self, converter):
        return NetList(map(converter, self))

    def GetEnumerator(self):
        return iter(self)

    def AsReadOnly(self):
        return tuple(self)

    def TrimExcess(self):
        pass

    def GetType(self):
        return DotNetType(type(self))

    def ToString(self):
        return DotNetType(type(self)).FullName

    def Equals(self, other):
        return self is other
