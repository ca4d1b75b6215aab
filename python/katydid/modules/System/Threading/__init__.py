"""System.Threading: work runs in order, on one thread."""

from katydid.rhino import missing as _missing


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


__getattr__ = _missing(__name__)
