"""System.IO: paths. Files are Python's own business, within what a script may open."""

import os as _os

from katydid.values.base import not_supported as _not_supported


class Path:
    DirectorySeparatorChar = _os.sep
    Combine = staticmethod(_os.path.join)
    GetFileName = staticmethod(_os.path.basename)
    GetDirectoryName = staticmethod(_os.path.dirname)
    GetExtension = staticmethod(lambda path: _os.path.splitext(path)[1])
    GetFileNameWithoutExtension = staticmethod(lambda path: _os.path.splitext(_os.path.basename(path))[0])


class File:
    Exists = staticmethod(_os.path.isfile)


class Directory:
    Exists = staticmethod(_os.path.isdir)


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    raise _not_supported("System.IO." + name)
