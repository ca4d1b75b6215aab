"""System.Drawing: colours, points and rectangles. Pictures and fonts are not here."""

from katydid.rhino import missing as _missing
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


__getattr__ = _missing(__name__)
