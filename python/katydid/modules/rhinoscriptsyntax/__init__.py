"""rhinoscriptsyntax: functions over the objects of a document, by Guid.

Written anew from how the functions behave. What is not here raises an error that names it.
"""

from katydid.rhino import missing as _missing

from .coerce import *  # noqa: F401,F403
from .colors import *  # noqa: F401,F403
from .curves_ask import *  # noqa: F401,F403
from .curves_change import *  # noqa: F401,F403
from .curves_make import *  # noqa: F401,F403
from .groups import *  # noqa: F401,F403
from .hatches import *  # noqa: F401,F403
from .meshes import *  # noqa: F401,F403
from .object_state import *  # noqa: F401,F403
from .objects import *  # noqa: F401,F403
from .objects import BoundingBox_ as BoundingBox  # noqa: F401
from .planes import *  # noqa: F401,F403
from .points_vectors import *  # noqa: F401,F403
from .surfaces_ask import *  # noqa: F401,F403
from .surfaces_change import *  # noqa: F401,F403
from .surfaces_make import *  # noqa: F401,F403
from .transforms import *  # noqa: F401,F403
from .user_text import *  # noqa: F401,F403
from .utility import *  # noqa: F401,F403
from .utility import UnitSystem_ as UnitSystem  # noqa: F401

# What the modules import for themselves is no function of rhinoscriptsyntax.
for _name in [name for name in globals() if getattr(globals()[name], "__module__", "rhinoscriptsyntax").partition(".")[0]
              == "katydid" or name in ("colorsys", "PATTERNS", "added", "all_added", "is_many", "radians", "degrees", "math", "time", "re",
                                       "tolerance", "angle_tolerance", "document", "event_rows")]:
    if not _name.startswith("_"):
        del globals()[_name]


__getattr__ = _missing(__name__)
