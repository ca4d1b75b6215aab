"""GH_IO, the assembly that reads and writes Grasshopper's files: scripts import it, and what they would use of it is not here."""

from katydid.rhino import missing

__getattr__ = missing(__name__)
