"""What the functions share: adding results to the document, angles, failures."""

import math

import scriptcontext
from katydid.values import Guid


def tolerance():
    return scriptcontext.doc.ModelAbsoluteTolerance


def angle_tolerance():
    return scriptcontext.doc.ModelAngleToleranceRadians


def added(geometry):
    """The Guid of geometry that is added to the document; None where there is none."""
    if geometry is None or getattr(geometry, "IsValid", True) is False:
        return None
    guid = scriptcontext.doc.Objects.Add(geometry)
    return None if guid == Guid.Empty else guid


def all_added(items):
    """The Guids of several results; None where there are none."""
    guids = [guid for guid in map(added, items or ()) if guid is not None]
    return guids or None


def radians(degrees):
    return math.radians(degrees)


def degrees(radians):
    return math.degrees(radians)


def is_many(value):
    """Whether an argument is a list of objects rather than one."""
    return isinstance(value, (list, tuple)) and not hasattr(value, "_net_name") or hasattr(value, "__next__")
