"""System.Threading.Tasks: loops run in order, so their results are the same each time."""

from katydid.values.base import not_supported as _not_supported


class ParallelLoopResult:
    IsCompleted = True


class Parallel:
    @staticmethod
    def For(start, end, *options_and_body):
        for i in range(start, end):
            options_and_body[-1](i)
        return ParallelLoopResult()

    @staticmethod
    def ForEach(items, *options_and_body):
        for item in items:
            options_and_body[-1](item)
        return ParallelLoopResult()

    @staticmethod
    def Invoke(*actions):
        for action in actions:
            action()


class ParallelOptions:
    MaxDegreeOfParallelism = 1


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    raise _not_supported("System.Threading.Tasks." + name)
