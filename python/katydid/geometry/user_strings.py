"""Texts that geometry carries, by key, as .NET's collection of them."""

from ..values.base import DotNet


class NameValueCollection(DotNet):
    """Texts by key, in the order in which they were set. A key that is not there gives None."""

    __slots__ = ("_texts",)
    _namespace = "System.Collections.Specialized"

    def __init__(self, texts=()):
        self._texts = dict(texts)

    @property
    def AllKeys(self):
        from ..values.netlist import NetList
        return NetList(self._texts)

    Keys = AllKeys
    Count = property(lambda self: len(self._texts))

    def __len__(self):
        return len(self._texts)

    def __iter__(self):
        return iter(list(self._texts))

    def __contains__(self, key):
        return key in self._texts

    def __getitem__(self, key):
        """By key, or by place."""
        return list(self._texts.values())[key] if isinstance(key, int) else self._texts.get(key)

    def __setitem__(self, key, text):
        self._texts[str(key)] = text

    Get = Item = get_Item = __getitem__

    def GetKey(self, index):
        return list(self._texts)[index]

    def GetValues(self, key):
        found = self[key]
        return None if found is None else [found]

    Set = Add = set_Item = __setitem__

    def Remove(self, key):
        self._texts.pop(key, None)

    def Clear(self):
        self._texts.clear()

    def HasKeys(self):
        return bool(self._texts)

    def GetEnumerator(self):
        return iter(self)

    def keys(self):
        """So that dict(collection) has its pairs."""
        return list(self._texts)

    def items(self):
        return list(self._texts.items())

    def __repr__(self):
        return "NameValueCollection(%r)" % self._texts
