"""Grasshopper's data trees and paths."""

from . import codec
from .values.base import DotNet
from .values.netlist import NetList


class GH_Path(DotNet):
    """The address of a branch. It is made once and not changed, but for its items."""

    __slots__ = ("_indices",)
    _namespace = "Grasshopper.Kernel.Data"

    def __init__(self, *indices):
        if len(indices) == 1 and isinstance(indices[0], GH_Path):
            indices = indices[0]._indices
        elif len(indices) == 1 and isinstance(indices[0], str):
            text = indices[0].strip().strip("{}")
            indices = [part for part in text.replace(",", ";").split(";") if part.strip()]
        elif len(indices) == 1 and hasattr(indices[0], "__iter__"):
            indices = indices[0]
        elif len(indices) == 2 and isinstance(indices[0], GH_Path):
            indices = indices[0]._indices + (indices[1],)
        self._indices = tuple(int(index) for index in indices)

    def _lower(self):
        return codec.Path(self._indices)

    Indices = property(lambda self: NetList(self._indices))
    Length = property(lambda self: len(self._indices))
    Count = Length
    Valid = property(lambda self: bool(self._indices) and min(self._indices) >= 0)

    def __len__(self):
        return len(self._indices)

    def __iter__(self):
        return iter(self._indices)

    def __getitem__(self, index):
        return self._indices[index]

    Dimension = property(lambda self: self)

    def AppendElement(self, index, *second):
        """A path with one more index; (path position, index) inserts."""
        if second:
            return GH_Path(*self._indices[:index] + (second[0],) + self._indices[index:])
        return GH_Path(*self._indices + (index,))

    def PrependElement(self, index):
        return GH_Path(*(index,) + self._indices)

    def CullElement(self):
        return GH_Path(*self._indices[:-1])

    def CullFirstElement(self):
        return GH_Path(*self._indices[1:])

    def Increment(self, index, *offset):
        """Adds to one index; (-1) counts from the end."""
        step = offset[0] if offset else 1
        changed = list(self._indices)
        changed[index] += step
        return GH_Path(*changed)

    def Decrement(self, index, *offset):
        return self.Increment(index, -(offset[0] if offset else 1))

    def IsAncestor(self, ancestor, *place_holders):
        """(True, generations) where the other path begins this one."""
        other = ancestor._indices
        if len(other) < len(self._indices) and self._indices[:len(other)] == other:
            return True, len(self._indices) - len(other)
        return False, 0

    def IsCoincident(self, other):
        return self == other

    def CompareTo(self, other):
        a, b = self._indices, other._indices
        return (a > b) - (a < b)

    def __eq__(self, other):
        return self._indices == other._indices if isinstance(other, GH_Path) else NotImplemented

    def __lt__(self, other):
        return self._indices < other._indices

    def __hash__(self):
        return hash(self._indices)

    def ToString(self, *brackets):
        text = ";".join(map(str, self._indices))
        return text if brackets and brackets[0] is False else "{%s}" % text


class _OfType(type):
    """`DataTree[object]` is the class itself."""

    def __getitem__(cls, types):
        return cls


class DataTree(DotNet, metaclass=_OfType):
    """Lists by path, in the order of the paths' first use; `Paths` come sorted, as in Grasshopper."""

    _namespace = "Grasshopper"

    def __init__(self, *source):
        self._branches = {}
        if not source:
            return
        if isinstance(source[0], DataTree):
            filter_ = source[1] if len(source) > 1 else None
            for path, items in source[0]._branches.items():
                self._branches[path] = NetList(items if filter_ is None else filter(filter_, items))
        elif source[0] is not None:
            path = to_path(source[1]) if len(source) > 1 else GH_Path(0)
            items = source[0] if hasattr(source[0], "__iter__") and not isinstance(source[0], str) else [source[0]]
            self.AddRange(items, path)

    @classmethod
    def _of(cls, branches):
        made = cls()
        for path, items in branches:
            made._branches[GH_Path(*path)] = NetList(items)
        return made

    def _sorted(self):
        keys = list(self._branches)
        if any(b < a for a, b in zip(keys, keys[1:])):
            self._branches = {key: self._branches[key] for key in sorted(keys)}
        return self._branches

    def _lower(self):
        return codec.Tree([(path._indices, items) for path, items in self._sorted().items()])

    Paths = property(lambda self: NetList(self._sorted()))
    Branches = property(lambda self: NetList(self._sorted().values()))
    BranchCount = property(lambda self: len(self._branches))
    PathCount = BranchCount
    DataCount = property(lambda self: sum(map(len, self._branches.values())))
    TopologyDescription = property(lambda self: "\n".join(
        "%s (N = %d)" % (path, len(items)) for path, items in self._sorted().items()))

    def Path(self, index):
        return self.Paths[index]

    def Branch(self, *where):
        """By place, by path or by the path's indices; None for a path that is not there."""
        if len(where) == 1 and isinstance(where[0], int):
            return self.Branches[where[0]]
        return self._branches.get(to_path(*where))

    def PathExists(self, *path):
        return to_path(*path) in self._branches

    def ItemExists(self, path, index):
        return index < len(self._branches.get(to_path(path), ()))

    def _at(self, path):
        key = to_path(*path) if path else (self._last() or GH_Path(0))
        return self._branches.setdefault(key, NetList())

    def _last(self):
        return max(self._branches) if self._branches else None

    def Add(self, item, *path):
        """Adds an item; without a path at the end of the last branch."""
        self._at(path).append(item)

    def AddRange(self, items, *path):
        self._at(path).extend(items)

    def EnsurePath(self, *path):
        self._branches.setdefault(to_path(*path), NetList())

    def Insert(self, item, path, index):
        branch = self._at((path,))
        while len(branch) < index:
            branch.append(None)
        branch.insert(index, item)

    def RemovePath(self, *path):
        return self._branches.pop(to_path(*path), None) is not None

    def MergeTree(self, other):
        for path, items in other._branches.items():
            self._at((path,)).extend(items)

    def Clear(self):
        self._branches.clear()

    ClearData = Clear

    def AllData(self):
        return NetList(item for items in self._sorted().values() for item in items)

    def Flatten(self, *path):
        """One branch with everything, at a path or {0}."""
        self._branches = {to_path(*path) if path else GH_Path(0): self.AllData()}

    def Graft(self, *keep_nulls):
        """A branch of its own for each item."""
        self._branches = {path.AppendElement(i): NetList([item])
                          for path, items in self._sorted().items() for i, item in enumerate(items)}

    def SimplifyPaths(self):
        """Drops the indices that all paths begin with; the last index stays."""
        paths = list(self._sorted())
        if not paths:
            return True
        shortest = min(map(len, paths))
        shared = 0
        while shared < shortest - 1 and len({path._indices[shared] for path in paths}) == 1:
            shared += 1
        if len(paths) == 1:
            shared = len(paths[0]) - 1
        self._branches = {GH_Path(*path._indices[shared:]): items for path, items in self._branches.items()}
        return True

    def RenumberPaths(self):
        self._branches = {GH_Path(i): items for i, items in enumerate(self._sorted().values())}

    def TrimExcess(self):
        pass

    def get_Item(self, path, index):
        return self._branches[to_path(path)][index]

    Item = property(lambda self: self)

    def __getitem__(self, where):
        """tree[path, index], or the branch of a path."""
        if isinstance(where, tuple):
            return self._branches[to_path(where[0])][where[1]]
        return self.Branch(where)

    def __setitem__(self, where, value):
        self._branches[to_path(where[0])][where[1]] = value

    def __iter__(self):
        return iter(self.AllData())

    def __len__(self):
        return self.DataCount

    def __bool__(self):
        return True

    def Duplicate(self):
        return DataTree(self)

    def ToString(self):
        return "DataTree[%d branches]" % len(self._branches)


def to_path(*path):
    """A path of a path, a text or indices."""
    return path[0] if len(path) == 1 and isinstance(path[0], GH_Path) else GH_Path(*path)
