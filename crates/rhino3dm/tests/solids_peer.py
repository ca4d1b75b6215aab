"""Breps of every constructor, on seeded random and degenerate inputs, are valid to rhino3dm after a trip by .3dm.

Needs `pip install rhino3dm`. Each constructor gets a few inputs, or as many as `KATYDID_CASES` says.
"""

import os
import pathlib
import sys
import tempfile
from collections import Counter

import rhino3dm

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from peer.common import example


def check(count):
    with tempfile.TemporaryDirectory() as folder:
        example("write_solids", folder, str(count))
        wrong, total = [], Counter()
        for path in sorted(pathlib.Path(folder).glob("*.3dm")):
            model = rhino3dm.File3dm.Read(str(path))
            assert model is not None, path
            for item in model.Objects:
                brep = item.Geometry
                name, seed, state = item.Attributes.Name.split("/")
                total[name] += 1
                valid = brep.IsValidWithLog
                valid, log = valid if isinstance(valid, tuple) else (brep.IsValid, str(valid))
                if not valid:
                    wrong.append(f"{name} of seed {seed}: {log}")
                elif brep.IsSolid != (state == "closed"):
                    wrong.append(f"{name} of seed {seed}: said to be {state}, IsSolid {brep.IsSolid}")
        for name, n in sorted(total.items()):
            print(f"{name}: {n} breps, {sum(w.startswith(name + ' of') for w in wrong)} wrong")
        assert total
        assert not wrong, "\n".join(wrong[:20])


def test_breps_of_all_constructors_are_valid():
    check(int(os.environ.get("KATYDID_CASES", "8")))


if __name__ == "__main__":
    test_breps_of_all_constructors_are_valid()
