"""What a process on another machine needs to solve points of a study."""

import atexit
import os
import shutil
import tempfile
import threading
import time

#: The solvers of this process, by the key of the recipe and the thread.
_OPEN = {}


class Recipe:
    """The words of the study's call and the files that they name, with their content."""

    def __init__(self, words, files, inputs):
        self.words = list(words)
        self.inputs = list(inputs)
        self.files = [None if path is None else (os.path.abspath(path), _content(path)) for path in files]
        #: Recipes of different studies have different keys.
        self.key = "%s-%d-%d" % (os.path.basename(self.files[0][0]), os.getpid(), time.monotonic_ns())

    @property
    def size(self):
        """The bytes of the files."""
        return sum(len(file[1]) for file in self.files if file is not None)

    def open(self):
        """The prepared definition."""
        from .._katydid import StudySolver
        return StudySolver(self.words, tuple(self._placed()), self.inputs)

    def _placed(self):
        """Where each file lies on this machine: where it lay, when it is the same there, else in a folder of its own."""
        folder = None
        for file in self.files:
            if file is None:
                yield None
                continue
            path, content = file
            if not _is(path, content):
                if folder is None:
                    folder = tempfile.mkdtemp(prefix="katydid-study-")
                    atexit.register(shutil.rmtree, folder, ignore_errors=True)
                path = os.path.join(folder, os.path.basename(path))
                with open(path, "wb") as copy:
                    copy.write(content)
            yield path


class PointWorker:
    """Holds the prepared definition of a recipe."""

    def __init__(self, recipe):
        self.solver = recipe.open()

    def ready(self):
        """Answers when the definition is prepared: the id of the process."""
        return os.getpid()

    def solve(self, points):
        """The records of points, their files, and the seconds that it took."""
        begun = time.monotonic()
        records, files = self.solver.solve(points)
        return records, files, time.monotonic() - begun


def solve(recipe, points):
    """The same in a process that keeps its solvers from one call to the next."""
    place = (recipe.key, threading.get_ident())
    if place not in _OPEN:
        _OPEN[place] = PointWorker(recipe)
    return _OPEN[place].solve(points)


def _content(path):
    with open(path, "rb") as file:
        return file.read()


def _is(path, content):
    try:
        return os.path.getsize(path) == len(content) and _content(path) == content
    except OSError:
        return False
