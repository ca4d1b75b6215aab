"""Rhino.Input: nothing of it is here yet; a member raises an error that names it."""

from katydid.rhino import missing as _missing

__getattr__ = _missing(__name__)
