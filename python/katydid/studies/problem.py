"""Studies for optimisers that ask for batches of points: pymoo, cma, Optuna, or any other."""

import math


class Problem:
    """What is to be small or large in a study, and what must hold.

    `minimise` and `maximise` are names of outputs; `at_most` and `at_least` are dicts from names of outputs to numbers. More
    arguments are those of `Study.evaluate`: the engine, say. All points that are asked for are rows of the study's tables.
    """

    def __init__(self, study, minimise=(), maximise=(), at_most=None, at_least=None, **how):
        from .._katydid import InputError
        self.study, self.how = study, how
        signed = [(name, 1.0) for name in _names(minimise)] + [(name, -1.0) for name in _names(maximise)]
        bounds = [(name, 1.0, bound) for name, bound in (at_most or {}).items()]
        bounds += [(name, -1.0, bound) for name, bound in (at_least or {}).items()]
        #: The objectives, names of outputs with 1 where they are to be small and -1 where they are to be large.
        self.objectives = signed
        #: The constraints: names of outputs with a sign and a bound; `sign * (value - bound)` is to be 0 or less.
        self.constraints = bounds
        if not signed:
            raise InputError("nothing is to be small or large: name outputs in minimise or maximise")
        unknown = [part[0] for part in signed + bounds if part[0] not in study.outputs]
        if unknown:
            raise InputError("the study has no output '%s', but %s" % (unknown[0], ", ".join(study.outputs)))
        self._worst = 0.0

    @property
    def inputs(self):
        """The inputs of the study."""
        return self.study.inputs

    def evaluate(self, points):
        """Goals and constraints of points: two lists with a list for each point.

        Goals are to be small; constraints hold where they are 0 or less. A point without a usable result has infinities.
        """
        table = self.study.evaluate(points, **self.how)

        def column(name, sign, bound):
            cells = table["out." + name]
            return [sign * (float(cell) - bound) if good and _is_number(cell) else math.inf
                    for cell, good in zip(cells, table.ok)]
        goals = [column(name, sign, 0.0) for name, sign in self.objectives]
        misses = [column(name, sign, bound) for name, sign, bound in self.constraints]
        failed = [any(math.isinf(goal[at]) for goal in goals) for at in range(table.rows)]
        return ([[math.inf if failed[at] else goal[at] for goal in goals] for at in range(table.rows)],
                [[math.inf if failed[at] else miss[at] for miss in misses] for at in range(table.rows)])

    def scalar(self, points):
        """One number for each point, for methods without constraints; of one goal only.

        Where constraints do not hold it is the largest goal at which they held, plus by how much they are missed (Deb 2000).
        """
        from .._katydid import NotSupportedError
        if len(self.objectives) != 1:
            raise NotSupportedError("%d goals as one number are not supported: name one output" % len(self.objectives))
        goals, misses = self.evaluate(points)
        missed = [sum(max(miss, 0.0) for miss in row) for row in misses]
        held = [goal[0] for goal, miss in zip(goals, missed) if miss == 0.0 and math.isfinite(goal[0])]
        self._worst = max([self._worst] + held)
        return [goal[0] if miss == 0.0 else self._worst + miss for goal, miss in zip(goals, missed)]


def pymoo_problem(study, minimise=(), maximise=(), at_most=None, at_least=None, *, mixed=None, **how):
    """A problem for pymoo, evaluated in batches of a generation.

    Where all inputs are numbers it takes arrays, for NSGA2 and the like, and whole numbers are rounded as sliders round them.
    Where one is a toggle or a list, or with `mixed`, its variables are pymoo's Real, Integer, Binary and Choice, for
    MixedVariableGA. Points without a result are worse than all others.
    """
    import numpy
    from pymoo.core.problem import Problem as Base
    problem = Problem(study, minimise, maximise, at_most, at_least, **how)
    inputs = problem.inputs
    if mixed is None:
        mixed = any(given.choices is not None for given in inputs)
    _bounded(inputs, mixed)
    sizes = {"n_obj": len(problem.objectives), "n_ieq_constr": len(problem.constraints)}
    if mixed:
        space = {"vars": {given.name: _pymoo_variable(given) for given in inputs}}
    else:
        space = {"n_var": len(inputs), "xl": numpy.array([given.low for given in inputs], dtype=float),
                 "xu": numpy.array([given.high for given in inputs], dtype=float)}

    class KatydidProblem(Base):
        def _evaluate(self, x, out, *args, **kwargs):
            points = [_plain(point) for point in x] if mixed else x
            goals, misses = problem.evaluate(points)
            out["F"] = numpy.array(goals)
            if misses and misses[0]:
                out["G"] = numpy.array(misses)
    return KatydidProblem(**space, **sizes)


def _pymoo_variable(given):
    from pymoo.core.variable import Binary, Choice, Integer, Real
    if given.choices == [False, True]:
        return Binary()
    if given.choices is not None:
        return Choice(options=given.choices)
    if given.step is None:
        return Real(bounds=(given.low, given.high))
    if given.step == 1.0:
        return Integer(bounds=(math.ceil(given.low), math.floor(given.high)))
    return Choice(options=_steps(given))


class cma_objective:
    """A function for cma: of one place or a list of places, numbers from 0 to 1 for each input over its range.

    `cma.fmin2(None, f.x0, f.sigma0, f.options, parallel_objective=f)`, or `es.tell(places, f(places))`. `point(place)` says what
    inputs a place stands for. Inputs are numbers: toggles and lists are not supported. Constraints are counted in.
    """

    def __init__(self, study, minimise=(), maximise=(), at_most=None, at_least=None, **how):
        self.problem = Problem(study, minimise, maximise, at_most, at_least, **how)
        self.inputs = self.problem.inputs
        _bounded(self.inputs, False)
        #: Where to begin: the middle of the ranges.
        self.x0 = [0.5] * len(self.inputs)
        #: A first deviation that reaches over the ranges.
        self.sigma0 = 0.3
        #: Options of cma: the limits of places.
        self.options = {"bounds": [0, 1]}

    def point(self, place):
        """The inputs at a place."""
        return {given.name: float(given.low + (given.high - given.low) * min(max(u, 0.0), 1.0))
                for given, u in zip(self.inputs, place)}

    def __call__(self, places):
        single = len(places) > 0 and not hasattr(places[0], "__len__")
        values = self.problem.scalar([self.point(place) for place in ([places] if single else places)])
        return values[0] if single else values


def optuna_trials(optuna_study, study, minimise=(), maximise=(), at_most=None, at_least=None, *, trials=100, batch=8, **how):
    """Has Optuna ask for so many trials in batches, and tells it what they gave; gives its study.

    The directions of the Optuna study must be those of the outputs, first those to be small. Its trials have the user attribute
    "constraints": a sampler with `constraints_func=lambda trial: trial.user_attrs["constraints"]` heeds them. Points without a
    result are failed trials.
    """
    import optuna
    from .._katydid import InputError
    problem = Problem(study, minimise, maximise, at_most, at_least, **how)
    _bounded(problem.inputs, True)
    wanted = ["MINIMIZE" if sign > 0 else "MAXIMIZE" for _, sign in problem.objectives]
    if [direction.name for direction in optuna_study.directions] != wanted:
        raise InputError("the Optuna study must have the directions " + ", ".join(word.lower() for word in wanted))
    done = 0
    while done < trials:
        asked = [optuna_study.ask() for _ in range(min(batch, trials - done))]
        goals, misses = problem.evaluate([{given.name: _suggested(trial, given) for given in problem.inputs} for trial in asked])
        for trial, goal, miss in zip(asked, goals, misses):
            if math.inf in goal:
                optuna_study.tell(trial, state=optuna.trial.TrialState.FAIL)
                continue
            trial.set_user_attr("constraints", miss)
            optuna_study.tell(trial, [sign * value for (_, sign), value in zip(problem.objectives, goal)])
        done += len(asked)
    return optuna_study


def _suggested(trial, given):
    if given.choices is not None:
        return trial.suggest_categorical(given.name, given.choices)
    if given.step == 1.0:
        return trial.suggest_int(given.name, math.ceil(given.low), math.floor(given.high))
    if given.step is not None:
        return trial.suggest_categorical(given.name, _steps(given))
    return trial.suggest_float(given.name, given.low, given.high)


def _steps(given):
    """The numbers of an input in steps: even or odd ones."""
    count = int((given.high - given.low) // given.step) + 1
    return [given.low + given.step * at for at in range(count)]


def _bounded(inputs, with_choices):
    from .._katydid import NotSupportedError
    for given in inputs:
        if given.low is None and not (with_choices and given.choices is not None):
            raise NotSupportedError("the input '%s' is no number with limits: this optimiser does not support it" % given.name)


def _names(names):
    return [names] if isinstance(names, str) else list(names)


def _is_number(cell):
    return isinstance(cell, (int, float)) and not isinstance(cell, bool) and math.isfinite(cell)


def _plain(point):
    """A point of pymoo's with NumPy's scalars as Python's."""
    return {name: value.item() if hasattr(value, "item") else value for name, value in point.items()}
