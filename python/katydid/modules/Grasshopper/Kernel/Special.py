"""Grasshopper.Kernel.Special: the kinds of objects on a canvas, to compare with; a script sees none of them."""

from katydid.values.base import not_supported as _not_supported


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


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    raise _not_supported("Grasshopper.Kernel.Special." + name)
