"""Colours as numbers: parts, and hue, lightness and saturation from 0 to 240 as Windows has them."""

import colorsys

from .coerce import coercecolor

#: The greatest hue, lightness and saturation.
_MOST = 240.0


def ColorRedValue(rgb):
    return int(coercecolor(rgb, True).R)


def ColorGreenValue(rgb):
    return int(coercecolor(rgb, True).G)


def ColorBlueValue(rgb):
    return int(coercecolor(rgb, True).B)


def ColorRGBToHLS(rgb):
    """(hue, lightness, saturation), each from 0 to 240."""
    own = coercecolor(rgb, True)
    return tuple(part * _MOST for part in colorsys.rgb_to_hls(own.R / 255.0, own.G / 255.0, own.B / 255.0))


def ColorHLSToRGB(hls):
    """A colour of hue, lightness and saturation, each from 0 to 240."""
    parts = [float(part) / _MOST for part in hls]
    if len(parts) != 3 or not all(0.0 <= part <= 1.0 for part in parts):
        raise ValueError("hue, lightness and saturation are three numbers from 0 to 240")
    return coercecolor([int(round(part * 255.0)) for part in colorsys.hls_to_rgb(*parts)], True)
