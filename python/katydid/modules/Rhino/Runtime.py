"""Rhino.Runtime."""

from katydid.values.base import not_supported as _not_supported


class HostUtils:
    RunningOnWindows = False
    RunningOnOSX = False
    RunningInRhino = False

    @staticmethod
    def DebugString(text):
        print(text)


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    raise _not_supported("Rhino.Runtime." + name)
