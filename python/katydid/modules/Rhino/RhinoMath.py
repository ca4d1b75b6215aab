"""Rhino.RhinoMath."""

import math as _math

from katydid.values import base as _base

#: Millimetres in each unit of Rhino.UnitSystem, by its number.
_MILLIMETRES = {1: 1e-3, 2: 1.0, 3: 10.0, 4: 1000.0, 5: 1e6, 6: 2.54e-5, 7: 0.0254, 8: 25.4, 9: 304.8, 10: 1609344.0,
                12: 1e-7, 13: 1e-6, 14: 100.0, 15: 1e4, 16: 1e5, 17: 1e9, 18: 1e12, 19: 914.4}


class RhinoMath:
    """Constants and small functions."""

    UnsetValue = _base.UNSET
    UnsetSingle = -1.234321e38
    UnsetIntIndex = -2147483648
    ZeroTolerance = _base.ZERO_TOLERANCE
    SqrtEpsilon = _base.SQRT_EPSILON
    Epsilon = 2.2204460492503131e-16
    DefaultAngleTolerance = _base.DEFAULT_ANGLE_TOLERANCE
    DefaultDistanceToleranceMillimeters = 0.01
    TwoPI = 2.0 * _math.pi
    HalfPI = 0.5 * _math.pi

    ToRadians = staticmethod(lambda degrees: degrees * (_math.pi / 180.0))
    ToDegrees = staticmethod(lambda radians: radians * (180.0 / _math.pi))
    IsValidDouble = staticmethod(lambda x: x != _base.UNSET and not _math.isinf(x) and not _math.isnan(x))
    IsValidSingle = staticmethod(lambda x: x != -1.234321e38 and not _math.isinf(x) and not _math.isnan(x))
    EpsilonEquals = staticmethod(lambda x, y, epsilon: abs(x - y) <= epsilon)
    IntIsFinite = staticmethod(lambda n: n not in (-2147483648, 2147483647))

    @staticmethod
    def Clamp(value, bound1, bound2):
        low, high = min(bound1, bound2), max(bound1, bound2)
        return low if value < low else high if value > high else value

    @staticmethod
    def Wrap(value, bound1, bound2):
        """The value moved by whole spans into [bound1, bound2)."""
        low, high = min(bound1, bound2), max(bound1, bound2)
        span = high - low
        return low if span <= 0.0 else value - span * _math.floor((value - low) / span)

    @staticmethod
    def UnitScale(start, end):
        a, b = _MILLIMETRES.get(int(start)), _MILLIMETRES.get(int(end))
        return a / b if a and b else 1.0

    @staticmethod
    def TryParseNumber(text, *place_holders):
        try:
            return True, float(text)
        except ValueError:
            return False, _base.UNSET


for _name in [name for name in vars(RhinoMath) if not name.startswith("_")]:
    globals()[_name] = getattr(RhinoMath, _name)
