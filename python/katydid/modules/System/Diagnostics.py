"""System.Diagnostics: the stopwatch."""

import time as _time

from katydid.rhino import missing as _missing


class Stopwatch:
    def __init__(self):
        self._elapsed, self._since = 0.0, None

    @staticmethod
    def StartNew():
        made = Stopwatch()
        made.Start()
        return made

    def Start(self):
        if self._since is None:
            self._since = _time.perf_counter()

    def Stop(self):
        self._elapsed, self._since = self._seconds(), None

    def Reset(self):
        self._elapsed, self._since = 0.0, None

    def Restart(self):
        self._elapsed, self._since = 0.0, _time.perf_counter()

    def _seconds(self):
        return self._elapsed + (_time.perf_counter() - self._since if self._since is not None else 0.0)

    ElapsedMilliseconds = property(lambda self: int(self._seconds() * 1000.0))
    IsRunning = property(lambda self: self._since is not None)


__getattr__ = _missing(__name__)
