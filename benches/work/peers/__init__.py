"""The peers by the names of the rows: each is made for a size, and gives the answer that Katydid must give."""

from .files import FILES
from .meshes import MESHES
from .numbers import NUMBERS
from .plane import PLANE
from .solids import SOLIDS
from .trees import TREES

PEERS = NUMBERS | TREES | PLANE | MESHES | SOLIDS | FILES
