"""System.Collections.Generic: List, Dictionary and their kin, over Python's own."""

from katydid.values.netlist import NetList as _NetList


class _OfType(type):
    """`List[float]` is the class: Python's lists hold anything."""

    def __getitem__(cls, types):
        return cls


class List(_NetList, metaclass=_OfType):
    """List<T>; a number alone is the capacity, which is not needed."""

    def __init__(self, source=()):
        _NetList.__init__(self, () if isinstance(source, int) else source)


IEnumerable = IList = ICollection = List


class KeyValuePair(metaclass=_OfType):
    def __init__(self, key=None, value=None):
        self.Key, self.Value = key, value

    def __iter__(self):
        return iter((self.Key, self.Value))


class Dictionary(dict, metaclass=_OfType):
    """Dictionary<K, V>. In a loop it gives pairs with Key and Value, as .NET does."""

    Count = property(len)
    Keys = property(lambda self: _NetList(dict.keys(self)))
    Values = property(lambda self: _NetList(dict.values(self)))

    def Add(self, key, value):
        if key in self:
            raise ValueError("an item with the same key has already been added: %s" % (key,))
        self[key] = value

    def ContainsKey(self, key):
        return key in self

    def ContainsValue(self, value):
        return value in dict.values(self)

    def Remove(self, key):
        return dict.pop(self, key, None) is not None

    def TryGetValue(self, key, *place_holders):
        return key in self, self.get(key)

    def Clear(self):
        self.clear()

    def __iter__(self):
        return (KeyValuePair(key, value) for key, value in dict.items(self))


SortedDictionary = Dictionary


class HashSet(set, metaclass=_OfType):
    Count = property(len)

    def Add(self, item):
        new = item not in self
        self.add(item)
        return new

    def Contains(self, item):
        return item in self

    def Remove(self, item):
        there = item in self
        self.discard(item)
        return there

    def Clear(self):
        self.clear()

    def UnionWith(self, other):
        self.update(other)

    def IntersectWith(self, other):
        self.intersection_update(other)

    def ExceptWith(self, other):
        self.difference_update(other)


class Queue(_NetList, metaclass=_OfType):
    Enqueue = _NetList.append
    Peek = lambda self: self[0]  # noqa: E731

    def Dequeue(self):
        return self.pop(0)


class Stack(_NetList, metaclass=_OfType):
    Push = _NetList.append
    Pop = _NetList.pop
    Peek = lambda self: self[-1]  # noqa: E731
