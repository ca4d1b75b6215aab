"""Geometry that the host holds: RhinoCommon's classes over handles."""

from .call import as_curve, call, construct, member_call, static_call
from .classes import CLASSES, of_handle
from .host_object import HostObject
from .meshing import MeshingParameters
from .point_object import Point
from .split import split as _split

__all__ = ["CLASSES", "HostObject", "MeshingParameters", "Point", "as_curve", "call", "construct", "member_call",
           "of_handle", "static_call"]

del _split
