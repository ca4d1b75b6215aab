"""Names and behaviour of Python 2's library that scripts use, for Python 3."""

import builtins
import collections
import collections.abc
import functools
import itertools
import math
import operator
import sys

from .net import method

_VIEWS = (type({}.keys()), type({}.values()), type({}.items()))


def divide(a, b):
    """`/` of Python 2: two integers give the floor."""
    if isinstance(a, int) and isinstance(b, int):
        return a // b
    return a / b


def listed(value):
    """A list of what a dictionary gave; anything else as it is."""
    return list(value) if isinstance(value, _VIEWS) else value


def view(thing, name, old):
    """iteritems() and its kin."""
    return getattr(thing, old)() if hasattr(thing, old) else iter(getattr(thing, name)())


def has_key(thing, key):
    return thing.has_key(key) if hasattr(thing, "has_key") else key in thing


def next_of(thing):
    return next(thing) if hasattr(thing, "__next__") else thing.next()


def error(kind, value):
    """raise A, "x": a class is called with the value, an instance stays itself."""
    if isinstance(kind, type) and isinstance(value, kind):
        return value
    if isinstance(kind, type):
        return kind() if value is None else kind(*value) if isinstance(value, tuple) else kind(value)
    return kind


def sort(thing, *arguments, **keywords):
    """x.sort(compare): the comparison of two items becomes a key."""
    compare = keywords.pop("cmp", None)
    arguments = list(arguments)
    if arguments:
        compare = arguments.pop(0)
    if arguments:
        keywords.setdefault("key", arguments.pop(0))
    if not isinstance(thing, list):
        return thing.sort(compare, **keywords) if compare else thing.sort(**keywords)
    return thing.sort(**_keyed(compare, keywords))


def _keyed(compare, keywords):
    if compare is not None:
        by, key = functools.cmp_to_key(compare), keywords.get("key")
        keywords["key"] = (lambda item: by(key(item))) if key else by
    return keywords


def sorted2(items, cmp=None, key=None, reverse=False):
    keywords = {"reverse": reverse}
    if key is not None:
        keywords["key"] = key
    return builtins.sorted(items, **_keyed(cmp, keywords))


def cmp(a, b):
    return (a > b) - (a < b)


def compare_method(sign):
    """A comparison of Python 3 by the class's own __cmp__."""
    work = getattr(operator, sign)
    return lambda self, other: work(self.__cmp__(other), 0)


def round2(number, digits=0):
    """Halves go away from zero, and the result is a float."""
    scale = 10.0 ** digits
    scaled = number * scale
    if math.isinf(scaled) or math.isnan(scaled):
        return float(number)
    whole = math.floor(abs(scaled) + 0.5)
    # 0.5 - 2^-54 plus a half rounds up to 1.
    if abs(scaled) + 0.5 == whole and abs(scaled) < whole - 0.5:
        whole -= 1
    return math.copysign(whole / scale, number)


def map2(function, *sequences):
    """A list; several sequences are filled up with None, and no function makes tuples."""
    if function is None and len(sequences) == 1:
        return list(sequences[0])
    if len(sequences) == 1:
        return [function(item) for item in sequences[0]]
    rows = itertools.zip_longest(*sequences)
    return [row if function is None else function(*row) for row in rows]


def filter2(function, sequence):
    kept = [item for item in sequence if (item if function is None else function(item))]
    if isinstance(sequence, str):
        return "".join(kept)
    return tuple(kept) if isinstance(sequence, tuple) else kept


def apply(function, arguments=(), keywords=None):
    return function(*arguments, **(keywords or {}))


def execfile(path, *scopes):
    from . import compile_python2
    with open(path) as source:
        exec(compile_python2(source.read(), path), *scopes)


#: The global names of a Python 2 script that Python 3 has not, or has otherwise.
NAMES = {
    "xrange": range, "range": lambda *bounds: list(builtins.range(*bounds)), "unicode": str, "basestring": str,
    "long": int, "unichr": chr, "raw_input": input, "reduce": functools.reduce, "cmp": cmp, "apply": apply,
    "map": map2, "filter": filter2, "zip": lambda *sequences: list(builtins.zip(*sequences)), "sorted": sorted2,
    "round": round2, "intern": sys.intern, "execfile": execfile, "StandardError": Exception,
    "__py2_divide__": divide, "__py2_list__": listed, "__py2_view__": view, "__py2_has_key__": has_key,
    "__py2_next__": next_of, "__py2_error__": error, "__py2_sort__": sort, "__py2_method__": method,
    "__py2_compare__": compare_method,
}

#: Modules that have another name now.
MODULES = {
    "copy_reg": "copyreg", "cPickle": "pickle", "cStringIO": "io", "StringIO": "io", "Queue": "queue",
    "__builtin__": "builtins", "ConfigParser": "configparser", "HTMLParser": "html.parser", "urlparse": "urllib.parse",
    "urllib2": "urllib.request", "httplib": "http.client", "thread": "_thread", "repr": "reprlib",
}


class RenamedModules:
    """Finds a module of Python 2 under its new name, after all other finders have failed."""

    def find_spec(self, fullname, path=None, target=None):
        if fullname not in MODULES:
            return None
        import importlib
        import importlib.util
        module = importlib.import_module(MODULES[fullname])
        return importlib.util.spec_from_loader(fullname, _Given(module))


class _Given:
    def __init__(self, module):
        self.module, self.spec = module, getattr(module, "__spec__", None)

    def create_module(self, spec):
        return self.module

    def exec_module(self, module):
        # The import machinery has put the old name's specification on the module.
        module.__spec__ = self.spec


_finder = RenamedModules()


#: A name that the variables of converted scripts alone have.
MARK = "__py2_divide__"
#: What itertools had.
_ITERTOOLS = {"izip": zip, "imap": map, "ifilter": filter, "izip_longest": itertools.zip_longest,
              "ifilterfalse": itertools.filterfalse}


def _of_itertools(name):
    """Old names of itertools, for converted scripts alone: packages ask for them to learn which Python runs them."""
    found = _ITERTOOLS.get(name)
    if found is None or MARK not in sys._getframe(1).f_globals:
        raise AttributeError("module 'itertools' has no attribute %r" % name)
    return found


def install():
    """Gives the standard library the names that it lost: for the whole process, so only in a worker."""
    if _finder not in sys.meta_path:
        sys.meta_path.append(_finder)
    for name in ("Iterable", "Iterator", "Sequence", "Mapping", "MutableMapping", "MutableSequence", "Callable",
                 "Hashable", "Set", "Sized", "Container"):
        if name not in vars(collections):
            setattr(collections, name, getattr(collections.abc, name))
    itertools.__getattr__ = _of_itertools
    sys.maxint = sys.maxsize
    import string
    import time
    string.letters, string.lowercase, string.uppercase = (string.ascii_letters, string.ascii_lowercase,
                                                          string.ascii_uppercase)
    string.join = lambda words, separator=" ": separator.join(words)
    if not hasattr(time, "clock"):
        time.clock = time.perf_counter
