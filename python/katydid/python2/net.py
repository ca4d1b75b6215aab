"""Methods of .NET that IronPython finds on Python's own numbers and texts."""

from ..values.base import DotNetType, number_text

#: The name of each basic type in .NET.
_TYPES = {float: ("Double", "System"), int: ("Int32", "System"), bool: ("Boolean", "System"), str: ("String", "System")}


def text_of(value, *rules):
    """ToString(): a number as .NET writes it."""
    if isinstance(value, bool):
        return "True" if value else "False"
    return number_text(value) if isinstance(value, float) else str(value)


def type_of(value):
    """GetType() of a basic value."""
    made = DotNetType(type(value))
    if type(value) in _TYPES:
        name, space = _TYPES[type(value)]
        return DotNetType(type(name, (type(value),) if type(value) is not bool else (), {"_namespace": space}))
    return made


_ANY = {
    "ToString": text_of, "GetType": type_of, "Equals": lambda value, other: value == other,
    "CompareTo": lambda value, other: (value > other) - (value < other), "GetHashCode": lambda value: hash(value),
}

_TEXT = {
    "Split": lambda text, *by: _split(text, by), "Replace": str.replace, "Contains": lambda text, part: part in text,
    "StartsWith": str.startswith, "EndsWith": str.endswith, "ToUpper": str.upper, "ToLower": str.lower,
    "Trim": str.strip, "TrimStart": str.lstrip, "TrimEnd": str.rstrip, "IndexOf": str.find, "LastIndexOf": str.rfind,
    "Substring": lambda text, start, *length: text[start:start + length[0]] if length else text[start:],
    "PadLeft": str.rjust, "PadRight": str.ljust, "Insert": lambda text, at, more: text[:at] + more + text[at:],
}

#: The methods that a script's calls are looked at for.
NAMES = set(_ANY) | set(_TEXT)


def _split(text, by):
    marks = [mark for part in by for mark in (part if isinstance(part, (list, tuple)) else [part])]
    if not marks:
        return text.split()
    for mark in marks[1:]:
        text = text.replace(mark, marks[0])
    return text.split(marks[0])


def method(value, name):
    """The method of a value: its own, or .NET's for a basic type."""
    found = getattr(value, name, None)
    if found is not None:
        return found
    work = _TEXT.get(name) if isinstance(value, str) else None
    work = work or (_ANY.get(name) if type(value) in _TYPES or value.__class__.__module__ == "builtins" else None)
    if work is None:
        return getattr(value, name)
    return lambda *arguments: work(value, *arguments)
