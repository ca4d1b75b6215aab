"""A study: a definition, the plan of its points, and the folder with its results."""

import collections
import json
import os
import weakref

from .recipe import Recipe
from .schedule import GRACE, Schedule
from .table import Table

#: How far a study has come: points of the plan, those known before, solved now, without a usable result of those, seconds.
Progress = collections.namedtuple("Progress", "points had solved failed seconds")
#: An input: its name, its limits, the distance of its numbers where it has only whole ones, what it can be chosen from.
StudyInput = collections.namedtuple("StudyInput", "name low high step choices")
ENGINES = ("local", "ray", "dask")


class Summary(collections.namedtuple("Summary", "points had solved failed seconds files")):
    """What a study came to: points, those known before, those solved now, rows without a usable result, seconds, the files."""

    @classmethod
    def of(cls, summed):
        """Of what the extension module gives."""
        (points, had, solved, _, seconds), failed, files = summed
        return cls(points, had, solved, failed, seconds, [str(file) for file in files])


class Study:
    """A definition that is solved at many points, into the tables of a folder. `katydid.study` makes one.

    `run` solves the points of the plan, `evaluate` points that a program asks for. Nothing is solved twice, whatever the engine:
    "local" for all processors of this machine, "ray" for a Ray cluster, "dask" for a Dask cluster.
    """

    def __init__(self, words, folder, has_points):
        from .._katydid import StudyCore
        #: The folder with the tables.
        self.folder = folder
        self._words = words
        self._core = StudyCore(words, points=has_points)
        self._has_points = has_points
        self._pool = None
        self._written = 0
        #: What is left to do when nobody has the study any more.
        self._state = {"dirty": False, "pool": None}
        weakref.finalize(self, _ended, self._core, self._state)

    @property
    def inputs(self):
        """The inputs that points have, in their order."""
        made = []
        for name, limits, step, choices in self._core.inputs:
            low, high = limits if limits is not None else (None, None)
            made.append(StudyInput(name, low, high, step, choices))
        return made

    @property
    def outputs(self):
        """The names of the outputs."""
        return self._core.outputs

    @property
    def points(self):
        """How many points the plan has."""
        return self._core.points

    def run(self, engine="local", *, workers=None, address=None, progress=None, options=None, grace=GRACE):
        """Solves the points of the plan that are not solved yet, and writes the tables: the same bytes for every engine.

        `workers` is how many points are solved side by side; without it as many as there are processors. For Ray it may be the
        least and the most, `(4, 64)`. `address` is that of the cluster; "local" starts one on this machine. `progress` is called
        with a `Progress` now and then; an exception in it ends the study, as Ctrl+C does, and what is solved by then is kept.
        `options` are those of Ray's actors. A point whose worker ends three times, or gives no answer within one and a half of
        its time limit and `grace` seconds, has the status "lost"; on this machine it is half a minute, whatever `grace` says.
        """
        if not self._has_points:
            from .._katydid import InputError
            raise InputError("the plan has no points: use evaluate, or give it a sample")
        _known(engine)
        if engine == "local":
            self.write()
            tell = None if progress is None else lambda counts: progress(Progress(*counts))
            summed = self._core.sweep(workers, tell)
            if tell is not None:
                tell(summed[0])
            return Summary.of(summed)
        self.close()
        self._core.open(asked=False)
        try:
            pool = self._made(engine, workers, address, options)
            try:
                self._drive(pool, self._core.next_points, self._left, progress, grace)
            finally:
                pool.close()
            return Summary.of(self._core.finish())
        finally:
            self._core.close()

    def evaluate(self, points, engine="local", *, workers=None, address=None, options=None, grace=GRACE):
        """Solves points and gives their rows as a `Table`, in the order of the points; all are rows of the study's tables too.

        `points` is a list of dicts by the names of the inputs, a dict of columns, or an array of shape (n, inputs) in the order
        of `inputs`. Inputs round as sliders do. A pool of workers is kept for the next call; `close` ends it.
        """
        _known(engine)
        self._core.open()
        points = self._core.fitted(self._ordered(points))
        wanted = self._core.ask(points)
        self._state["dirty"] = True
        if wanted and engine == "local":
            self._core.solve(wanted, workers)
        elif wanted:
            key = (engine, workers, str(address), str(options))
            if self._pool is None or self._pool[0] != key:
                self._end_pool()
                self._pool = (key, self._made(engine, workers, address, options))
                self._state["pool"] = self._pool[1]
            rest = list(wanted)

            def take(most):
                taken = rest[:most]
                del rest[:most]
                return taken
            try:
                self._drive(self._pool[1], take, lambda: len(rest), None, grace)
            except BaseException:
                # Batches of it may still run.
                self._end_pool()
                raise
        table = self._table(self._core.rows(points))
        # The tables are written again when they have grown by a quarter, so that all of it takes no more than the solves.
        if self._core.asked() >= self._written + max(64, self._written // 4):
            self.write()
        return table

    def table(self):
        """The rows of the study: those of `evaluate` where something was asked for, else those of the plan."""
        self._core.open()
        if self._core.asked() and (self._state["dirty"] or not self._has_points):
            return self._table(self._core.asked_rows())
        return self._table(self._core.plan_rows())

    def write(self):
        """Writes the tables with all points that were asked for."""
        if self._state["dirty"]:
            self._core.finish_asked()
            self._written = self._core.asked()
            self._state["dirty"] = False

    def close(self):
        """Writes the tables where points were asked for, ends workers, and lets others work on the study."""
        self._end_pool()
        try:
            self.write()
        finally:
            self._state["dirty"] = False
            self._core.close()

    def __enter__(self):
        return self

    def __exit__(self, kind, value, trace):
        self.close()

    def _ordered(self, points):
        """Points as lists of values in the order of the inputs."""
        from .._katydid import InputError
        names = [given.name for given in self.inputs]

        def values(of, what):
            missing = [name for name in names if name not in of]
            unknown = [name for name in of if name not in names]
            if missing or unknown:
                raise InputError("%s: %s" % (what, "; ".join(
                    ["there is no value for '%s'" % name for name in missing]
                    + ["there is no input '%s'" % name for name in unknown])))
            return [of[name] for name in names]
        if isinstance(points, dict):
            columns = [list(column) for column in values(points, "points")]
            if len({len(column) for column in columns}) > 1:
                raise InputError("points: the columns are not of one length")
            return [list(row) for row in zip(*columns)]
        return [values(point, "point %d" % at) if isinstance(point, dict) else list(point) for at, point in enumerate(points)]

    def _left(self):
        points, had, solved, _, _ = self._core.progress()
        return points - had - solved

    def _made(self, engine, workers, address, options):
        recipe = Recipe(self._words, self._core.files, [given.name for given in self.inputs])
        if engine == "ray":
            from .on_ray import RayPool
            return RayPool(recipe, workers, address, options)
        from .on_dask import DaskPool
        return DaskPool(recipe, workers, address)

    def _drive(self, pool, take, left, progress, grace):
        def told():
            if progress is not None:
                progress(Progress(*self._core.progress()))
        Schedule(pool, take, self._core.keep, self._core.give_up, left=left, limit=self._core.seconds, grace=grace,
                 told=told).run()

    def _end_pool(self):
        if self._pool is not None:
            pool, self._pool, self._state["pool"] = self._pool[1], None, None
            pool.close()

    def _table(self, columns):
        return Table([given.name for given in self.inputs], self.outputs, columns)

    def __repr__(self):
        names = ", ".join(given.name for given in self.inputs)
        return "<Study of %s in '%s': %d points, outputs %s>" % (names, self.folder, self.points, ", ".join(self.outputs))


def study(definition, plan, folder=None, *, set=None, model=None, units=None, lenient=False, allow_scripts=False, python=None,
          time_limit=None, byte_limit=None, retry=False, words=()):
    """A study of a definition: `run()` solves the points of a plan, `evaluate()` those that a program asks for.

    `definition` is a file, or a `Definition` that is as its file is. `plan` is a file, or a dict of the same form, which is
    written into the folder as plan.json; without a sample ("grid" and steps, "points" or "rows") it only names inputs and
    outputs. `folder` gets the tables; it is the file's name with "-study" when not given. The other arguments are those of
    `katydid sweep`: `set` is a dict, `time_limit` is in seconds, `words` are more of its words.
    """
    file = _file(definition)
    if folder is None:
        folder = os.path.splitext(os.path.basename(file))[0] + "-study"
    folder = os.path.abspath(os.fspath(folder))
    plan, has_points = _plan(plan, folder)
    call = [file, "--plan", plan, "--output", folder]
    for name, value in (set or {}).items():
        call += ["--set", "%s=%s" % (name, value)]
    for word, value in (("--model", model), ("--units", units), ("--python", python), ("--limit-seconds", time_limit),
                        ("--limit-bytes", byte_limit)):
        if value is not None:
            call += [word, os.fspath(value) if hasattr(value, "__fspath__") else str(value)]
    call += [word for word, on in (("--lenient", lenient), ("--allow-scripts", allow_scripts), ("--retry", retry)) if on]
    return Study(call + list(words), folder, has_points)


def _file(definition):
    """The file of a definition."""
    from .._katydid import Definition, InputError
    if isinstance(definition, Definition):
        if definition.is_changed:
            raise InputError("the definition was changed by set: save it, and study the file")
        definition = definition.path
    return os.path.abspath(os.fspath(definition))


def _plan(plan, folder):
    """The file of a plan, and whether it has points."""
    from .._katydid import FileError
    if not isinstance(plan, dict):
        return os.path.abspath(os.fspath(plan)), True
    if plan.get("rows") is not None:
        plan = {**plan, "rows": os.path.abspath(os.fspath(plan["rows"]))}
    ranges = [axis for axis in plan.get("inputs", {}).values() if isinstance(axis, dict)]
    has_points = "sample" in plan or not ranges or any("steps" in axis for axis in ranges)
    path = os.path.join(folder, "plan.json")
    try:
        os.makedirs(folder, exist_ok=True)
        with open(path + ".new", "w", encoding="utf-8") as file:
            json.dump(plan, file, ensure_ascii=False, indent=2)
        os.replace(path + ".new", path)
    except OSError as error:
        raise FileError("%s: %s" % (path, error.strerror)) from error
    return path, has_points


def _known(engine):
    if engine not in ENGINES:
        from .._katydid import NotSupportedError
        raise NotSupportedError("the engine %r is not supported: %s" % (engine, ", ".join(ENGINES)))


def _ended(core, state):
    """When nobody has the study any more: its tables are written, its workers ended."""
    if state["pool"] is not None:
        state["pool"].close()
    if state["dirty"]:
        core.finish_asked()
    core.close()
