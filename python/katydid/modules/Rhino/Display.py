"""Rhino.Display: colours and text as values. Nothing is drawn by a script."""

from katydid.rhino import missing as _missing
from katydid.values import Plane as _Plane
from katydid.values.system import Color as _Color


class ColorHSL:
    """Hue, saturation and luminance, each from 0 to 1."""

    def __init__(self, *parts):
        if len(parts) == 1:
            colour = parts[0]
            parts = (colour.GetHue() / 360.0, colour.GetSaturation(), colour.GetBrightness())
        self.A, (self.H, self.S, self.L) = (parts[0] if len(parts) == 4 else 1.0), parts[-3:]

    def ToArgbColor(self):
        import colorsys
        r, g, b = colorsys.hls_to_rgb(self.H % 1.0, self.L, self.S)
        return _Color.FromArgb(round(255 * self.A), round(255 * r), round(255 * g), round(255 * b))


class Text3d:
    """A text in a plane."""

    def __init__(self, text, plane=None, height=1.0):
        self.Text, self.TextPlane, self.Height = text, plane or _Plane.WorldXY, height
        self.FontFace, self.Bold, self.Italic = "Arial", False, False


class DisplayConduit:
    """What draws in a view. Nothing is drawn here, so a script's own conduit is never asked."""

    Enabled = False


__getattr__ = _missing(__name__)
