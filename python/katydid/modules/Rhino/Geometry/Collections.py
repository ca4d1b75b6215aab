"""Rhino.Geometry.Collections: lists of the parts of geometry."""

from katydid.rhino import missing as _missing


__getattr__ = _missing(__name__)
