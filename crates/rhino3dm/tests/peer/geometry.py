"""One object of any class."""

import rhino3dm

from .breps import check_brep, check_extrusion
from .classes import check_class
from .clouds import check_cloud
from .common import close, xyz
from .curves import check_curve
from .meshes import check_mesh
from .subd import check_subd
from .surfaces import check_surface


def check_geometry(ours, theirs, what):
    """Compares one object; says whether it was taken apart here."""
    detail = ours["detail"]
    if check_class(ours, theirs, what):
        return True
    if isinstance(theirs, rhino3dm.Mesh) and not ours["kept"]:
        check_mesh(detail, theirs, what)
    elif isinstance(theirs, rhino3dm.PointCloud):
        check_cloud(detail, theirs, what)
    elif isinstance(theirs, rhino3dm.SubD) and not ours["kept"]:
        check_subd(detail, theirs, what)
    elif isinstance(theirs, rhino3dm.Point):
        close(detail["point"], xyz(theirs.Location), what)
    elif isinstance(theirs, rhino3dm.Surface) and not isinstance(theirs, rhino3dm.Extrusion):
        if ours["class"] == "ClippingPlaneSurface":
            check_surface(detail["surface"], theirs, what)
        elif not ours["kept"]:
            check_surface(detail, theirs, what)
    elif isinstance(theirs, rhino3dm.Curve):
        assert not ours["kept"], f"{what}: a curve is kept as bytes"
        check_curve(detail, theirs, what)
    elif isinstance(theirs, rhino3dm.Brep) and ours["class"] == "Brep":
        assert not ours["kept"], f"{what}: a brep is kept as bytes"
        check_brep(detail, theirs, what)
    elif isinstance(theirs, rhino3dm.Extrusion):
        check_extrusion(detail, theirs, what)
    return not ours["kept"]
