"""Rhino.Geometry.Collections: lists of the parts of geometry."""

from katydid.values.base import not_supported as _not_supported


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    raise _not_supported("Rhino.Geometry.Collections." + name)
