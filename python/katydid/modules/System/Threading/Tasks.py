"""System.Threading.Tasks: loops run in order, so their results are the same each time."""

from katydid.rhino import missing as _missing


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


__getattr__ = _missing(__name__)
