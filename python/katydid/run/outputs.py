"""What an output variable gives the wires: items, lists or trees, as Grasshopper takes them from a script."""

import datetime
import enum
import uuid
from collections import deque
from itertools import islice

from ..document import find
from ..geometry import HostObject
from ..grasshopper import DataTree, GH_Path
from ..values.base import Struct
from ..values.enums import NetEnum
from ..values.interval import Interval
from ..values.polyline import Polyline
from ..values.system import DateTime, Guid, ticks_of

#: Types whose values go as they are.
_PLAIN = {type(None), bool, int, float, str, bytes, complex}

#: The most items of one output: a generator may have no end.
MOST_ITEMS = 10000000

_VIEWS = (type({}.keys()), type({}.values()), type({}.items()))


def is_list(value):
    """Whether a value is a list of items: lists, tuples, sets, ranges, and whatever is read one by one.

    Texts, dictionaries and geometry (a Polyline too) are one item.
    """
    if isinstance(value, (str, bytes, dict, Polyline, Struct, HostObject, DataTree, GH_Path)):
        return False
    if isinstance(value, (list, tuple, set, frozenset, range, deque) + _VIEWS) or hasattr(value, "__next__"):
        return True
    return _is_array(value) and getattr(value, "ndim", 0) > 0


def _is_array(value):
    return type(value).__module__.partition(".")[0] == "numpy" and hasattr(value, "tolist")


def output(value, objects):
    """An output's value, ready for the codec: an item, a list or a tree."""
    if isinstance(value, DataTree):
        made = DataTree()
        for path, items in value._branches.items():
            made._branches[path] = [item(one, objects) for one in items]
        return made
    if is_list(value):
        values = value.tolist() if _is_array(value) else list(islice(value, MOST_ITEMS + 1))
        if len(values) > MOST_ITEMS:
            raise ValueError("an output has more than %d items" % MOST_ITEMS)
        if values and _same_plain(values):
            return values
        return [item(one, objects) for one in values]
    return item(value, objects)


def _same_plain(values):
    """Whether a list needs no look at its items: all of one type that travels as it is."""
    kinds = set(map(type, values))
    return kinds <= _PLAIN or (len(kinds) == 1 and next(iter(kinds)).__name__ in ("Point3d", "Vector3d")
                               and next(iter(kinds)).__module__.startswith("katydid."))


def item(value, objects):
    """One item: geometry of a Guid, the value of a wrapper, a token for an object that is not ours."""
    kind = type(value)
    if kind in _PLAIN:
        return value
    if kind is Guid:
        found = find(value)
        return value if found is None else _geometry(found)
    if hasattr(kind, "_unwrap"):
        return item(value._unwrap(), objects)
    if isinstance(value, (Struct, Polyline, HostObject, NetEnum, GH_Path)) or hasattr(kind, "_lower"):
        return value
    if kind is dict and set(value) == {"U", "V"} and all(type(part) is Interval for part in value.values()):
        # A domain in two directions, as the host hands it over.
        return value
    if isinstance(value, uuid.UUID):
        return Guid._of(value.bytes)
    if isinstance(value, datetime.datetime):
        return DateTime(ticks_of(value))
    if isinstance(value, (bool, int, float, str)) and not isinstance(value, enum.Enum):
        return value
    if _is_array(value) and getattr(value, "ndim", 1) == 0:
        return value.item()
    return objects.keep(value)


def _geometry(found):
    """What a document's object gives: a point as a point, all else as geometry."""
    from ..values import Point3d, Point3f
    return found.value if isinstance(found.value, (Point3d, Point3f)) else found.Geometry
