"""The sources are read by the oldest Python that the package is for: 3.9."""

import ast
import os

import pytest
from hosts import PACKAGE

OLDEST = (3, 9)


def sources():
    """All Python files of the package, and what the host adds to a worker."""
    found = []
    for folder, _, names in os.walk(PACKAGE):
        found += [os.path.join(folder, name) for name in names if name.endswith((".py", ".pyi"))]
    root = os.path.dirname(os.path.dirname(PACKAGE))
    return sorted(found) + [os.path.join(root, "crates", "script", "src", "guard.py")]


@pytest.mark.parametrize("path", sources(), ids=lambda path: os.path.basename(os.path.dirname(path)) + "/" +
                         os.path.basename(path))
def test_a_source_is_python_3_9(path):
    with open(path, encoding="utf-8") as source:
        ast.parse(source.read(), path, feature_version=OLDEST)
