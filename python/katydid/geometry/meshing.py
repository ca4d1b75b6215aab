"""MeshingParameters: a record of settings that the host reads by name."""

from ..values.base import DotNet, static_value
from .classes import CLASSES

_DEFAULTS = {"Tolerance": 0.0, "RelativeTolerance": 0.0, "MinimumTolerance": 0.0, "RefineGrid": True, "RefineAngle":
             0.3490658503988659, "GridAngle": 0.3490658503988659, "GridAspectRatio": 6.0, "GridAmplification": 1.0,
             "GridMinCount": 0, "GridMaxCount": 0, "MinimumEdgeLength": 0.0001, "MaximumEdgeLength": 0.0,
             "SimplePlanes": False, "JaggedSeams": False, "DoublePrecision": False, "ComputeCurvature": False,
             "ClosedObjectPostProcess": False}


class MeshingParameters(DotNet):
    """How a Brep becomes a mesh. Properties have the names and defaults of RhinoCommon."""

    def __init__(self, *density):
        self.__dict__.update(_DEFAULTS)
        if density:
            # A density from 0 to 1 is the host's to read.
            self.RelativeTolerance = float(density[0])
            if len(density) > 1:
                self.MinimumEdgeLength = float(density[1])

    def __setattr__(self, name, value):
        if name not in _DEFAULTS:
            raise AttributeError("MeshingParameters has no property %s" % name)
        self.__dict__[name] = value

    def _lower(self):
        return {name: self.__dict__[name] for name in _DEFAULTS}

    Default = static_value(lambda cls: cls())
    DefaultAnalysisMesh = Default
    Coarse = FastRenderMesh = static_value(lambda cls: cls._with(GridAspectRatio=0.0, RelativeTolerance=0.65,
                                                                 MinimumEdgeLength=0.0001))
    Smooth = QualityRenderMesh = static_value(lambda cls: cls._with(RelativeTolerance=0.8, GridAspectRatio=0.0,
                                                                    RefineAngle=0.3490658503988659))
    Minimal = static_value(lambda cls: cls._with(JaggedSeams=True, RefineGrid=False, SimplePlanes=False,
                                                 GridMinCount=16, GridMaxCount=400))

    @classmethod
    def _with(cls, **settings):
        made = cls()
        made.__dict__.update(settings)
        return made


CLASSES["MeshingParameters"] = MeshingParameters
