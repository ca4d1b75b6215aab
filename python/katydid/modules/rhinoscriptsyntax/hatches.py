"""Hatches: closed planar curves, filled with a pattern of a new document."""

from katydid.geometry import CLASSES, static_call

from .coerce import coercecurve, coercegeometry, coercerhinoobject
from .support import all_added, degrees, is_many, radians

#: The patterns of a new document, by their indices.
PATTERNS = ("Solid", "Hatch1", "Hatch2", "Hatch3", "HatchDash", "Grid", "Grid60", "Plus", "Squares")


def _pattern(pattern):
    """The index of a pattern by its name or index; the first where none is given."""
    if pattern is None:
        return 0
    if isinstance(pattern, str):
        lower = [name.lower() for name in PATTERNS]
        if pattern.lower() not in lower:
            raise ValueError("there is no hatch pattern %s" % pattern)
        return lower.index(pattern.lower())
    return int(pattern)


def _name(index):
    return PATTERNS[index] if 0 <= index < len(PATTERNS) else "Pattern%d" % index


def _hatch(hatch_id):
    found = coercegeometry(hatch_id, True)
    if not isinstance(found, CLASSES["Hatch"]):
        raise ValueError("%s is no hatch" % hatch_id)
    return found


def AddHatches(curve_ids, hatch_pattern=None, scale=1.0, rotation=0.0, tolerance=None):
    """A hatch for each region; curves inside others are its holes. `rotation` in degrees."""
    from .support import tolerance as usual
    curves = [coercecurve(one, -1, True) for one in (curve_ids if is_many(curve_ids) else [curve_ids])]
    within = usual() if tolerance is None or tolerance < 0 else float(tolerance)
    made = static_call("Hatch", "Create", curves, _pattern(hatch_pattern), radians(rotation), float(scale), within)
    return all_added(made)


def AddHatch(curve_id, hatch_pattern=None, scale=1.0, rotation=0.0, tolerance=None):
    made = AddHatches([curve_id], hatch_pattern, scale, rotation, tolerance)
    return made[0] if made else None


def IsHatch(object_id):
    return isinstance(coercegeometry(object_id), CLASSES["Hatch"])


def _kept(hatch_id, hatch):
    found = coercerhinoobject(hatch_id, True)
    found.value = hatch
    found._geometry = hatch


def HatchPattern(hatch_id, hatch_pattern=None):
    """The name of the pattern, as it was."""
    hatch = _hatch(hatch_id)
    before = _name(hatch.PatternIndex)
    if hatch_pattern is not None:
        hatch.PatternIndex = _pattern(hatch_pattern)
        _kept(hatch_id, hatch)
    return before


def HatchRotation(hatch_id, rotation=None):
    """In degrees, as it was."""
    hatch = _hatch(hatch_id)
    before = degrees(hatch.PatternRotation)
    if rotation is not None:
        hatch.PatternRotation = radians(rotation)
        _kept(hatch_id, hatch)
    return before


def HatchScale(hatch_id, scale=None):
    hatch = _hatch(hatch_id)
    before = hatch.PatternScale
    if scale is not None:
        hatch.PatternScale = float(scale)
        _kept(hatch_id, hatch)
    return before


def HatchPatternCount():
    return len(PATTERNS)


def HatchPatternNames():
    return list(PATTERNS)


def IsHatchPattern(name):
    return str(name).lower() in [one.lower() for one in PATTERNS]


def CurrentHatchPattern(hatch_pattern=None):
    return PATTERNS[0]
