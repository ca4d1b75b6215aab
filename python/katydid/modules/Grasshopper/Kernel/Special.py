"""Grasshopper.Kernel.Special: the kinds of objects on a canvas, to compare with; a script sees none of them."""

from katydid.rhino import missing as _missing


class GH_Panel:
    """A panel."""


class GH_NumberSlider:
    """A number slider."""


class GH_Group:
    """A group."""


class GH_BooleanToggle:
    """A toggle."""


class GH_ValueList:
    """A value list."""


__getattr__ = _missing(__name__)
