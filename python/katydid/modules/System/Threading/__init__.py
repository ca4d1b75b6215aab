"""System.Threading: work runs in order, on one thread."""

from katydid.values.base import not_supported as _not_supported


class Thread:
    @staticmethod
    def Sleep(milliseconds):
        import time
        time.sleep(milliseconds / 1000.0)


class Interlocked:
    @staticmethod
    def Increment(reference):
        reference.Value += 1
        return reference.Value


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    raise _not_supported("System.Threading." + name)
