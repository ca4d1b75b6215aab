"""Rhino.Runtime."""

from katydid.rhino import missing as _missing


class HostUtils:
    RunningOnWindows = False
    RunningOnOSX = False
    RunningInRhino = False

    @staticmethod
    def DebugString(text):
        print(text)


__getattr__ = _missing(__name__)
