"""System.Drawing: colours, points and rectangles. Pictures and fonts are not here."""

from katydid.values.base import not_supported as _not_supported
from katydid.values.system import Color  # noqa: F401


class PointF:
    def __init__(self, x=0.0, y=0.0):
        self.X, self.Y = x, y


class SizeF:
    def __init__(self, width=0.0, height=0.0):
        self.Width, self.Height = width, height


class RectangleF:
    def __init__(self, x=0.0, y=0.0, width=0.0, height=0.0):
        self.X, self.Y, self.Width, self.Height = x, y, width, height


Point, Size, Rectangle = PointF, SizeF, RectangleF


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    raise _not_supported("System.Drawing." + name)
