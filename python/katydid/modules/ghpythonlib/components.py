"""Components as functions, by name: `components.Voronoi(points)`. They are made from the host's registry."""

from katydid.components import Names as _Names

_names = _Names()


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    return _names.find(name)


def __dir__():
    return _names.all()
