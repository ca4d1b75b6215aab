"""The licences of all that is in the program, with their texts: by what the wheel has for that."""

import functools
import importlib.util

from place import OUT, ROOT

_spec = importlib.util.spec_from_file_location("third_party", ROOT / "python" / "third_party.py")
third_party = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(third_party)


@functools.cache
def text():
    """The crates that the program is linked with, and the npm packages in its page."""
    return third_party.document("program", third_party.packages("katydid"), third_party.page())


def make():
    """Writes them."""
    path = OUT / "THIRD-PARTY"
    path.write_text(text(), encoding="utf-8")
    return [path]
