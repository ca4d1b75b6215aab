"""System.IO: paths. Files are Python's own business, within what a script may open."""

import os as _os

from katydid.rhino import missing as _missing


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


__getattr__ = _missing(__name__)
