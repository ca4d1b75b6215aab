"""Lets these tests import what all of them share."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
