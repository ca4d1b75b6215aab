"""System.Collections."""

from katydid.values.netlist import NetList as ArrayList  # noqa: F401

IEnumerable = IList = ICollection = object
