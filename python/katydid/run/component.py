"""ghenv and the component that a script sees itself as."""

from ..grasshopper import DataTree
from ..values.base import DotNet, not_supported
from ..values.enums import make
from ..values.netlist import NetList
from ..values.system import Guid

GH_RuntimeMessageLevel = make("GH_RuntimeMessageLevel", Blank=0, Remark=255, Warning=10, Error=20)

_LEVELS = {0: "remark", 255: "remark", 10: "warning", 20: "error"}

_current = None


def current():
    """The component whose script is running, or None."""
    return _current


def set_current(component):
    global _current
    before, _current = _current, component
    return before


def remark(text):
    """A remark on the component that is running."""
    if _current is not None:
        _current._messages.append(["remark", text, -1])


class Volatile(NetList):
    """The data of a port: branches of items."""

    def get_Branch(self, where):
        return self[where] if isinstance(where, int) else NetList()

    Branch = get_Branch
    PathCount = property(len)
    DataCount = property(lambda self: sum(map(len, self)))

    def AllData(self, skip_nulls=False):
        return NetList(item for branch in self for item in branch if item is not None or not skip_nulls)


class Port(DotNet):
    """An input or output as ghenv shows it."""

    _namespace = "Grasshopper.Kernel"

    def __init__(self, spec, data=()):
        self.Name = self.NickName = spec.get("name", "")
        self.Description = spec.get("description") or ""
        self.Access = {"item": 0, "list": 1, "tree": 2}.get(spec.get("access"), 0)
        self.Optional = bool(spec.get("optional"))
        self.TypeHint = spec.get("hint") or ""
        self.VolatileData = Volatile(NetList(branch) for branch in data)
        self.Sources, self.Recipients = NetList(), NetList()
        self.Hidden, self.Locked = False, False

    VolatileDataCount = property(lambda self: self.VolatileData.DataCount)
    SourceCount = property(lambda self: len(self.Sources))

    def ExpireSolution(self, *recompute):
        pass

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        raise not_supported("Grasshopper.Kernel.IGH_Param." + name)


class Params(DotNet):
    _namespace = "Grasshopper.Kernel"

    def __init__(self, inputs, outputs):
        self.Input, self.Output = NetList(inputs), NetList(outputs)

    def OnParametersChanged(self):
        pass

    def IndexOfInputParam(self, name):
        return next((i for i, port in enumerate(self.Input) if port.Name == name), -1)

    def IndexOfOutputParam(self, name):
        return next((i for i, port in enumerate(self.Output) if port.Name == name), -1)


class Definition(DotNet):
    """The definition that a component belongs to, as far as a script can see it."""

    _namespace = "Grasshopper.Kernel"

    def __init__(self, settings):
        self.FilePath = settings.get("path") or ""
        self.DisplayName = settings.get("name") or ""
        self.Objects = NetList()
        self.Enabled = True

    def ScheduleSolution(self, *delay_and_callback):
        remark("a script cannot start a solve: ScheduleSolution does nothing")

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        raise not_supported("Grasshopper.Kernel.GH_Document." + name)


class Component(DotNet):
    """ghenv.Component. What is set on it is kept between runs; messages go to the host."""

    _namespace = "Grasshopper.Kernel"

    def __init__(self, message):
        self._messages = []
        self._begin(message)
        self.Name = message.get("name") or "Python"
        self.NickName = message.get("nickname") or self.Name
        self.Description = self.Category = self.SubCategory = self.Message = ""
        self.Locked = self.Hidden = self.Obsolete = False
        self.AdditionalHelpFromDocStrings = ""

    def _begin(self, message):
        """Takes the ports and data of a new run."""
        self._messages = []
        key = message.get("key")
        found, guid = Guid.TryParse(key or "")
        self.InstanceGuid = guid if found else Guid.Empty
        self._settings = message.get("doc") or {}
        specs = message.get("inputs") or []
        iterations = message.get("iterations") or []
        data = [[_branch(row[i]) for row in iterations if i < len(row)] for i in range(len(specs))]
        for i, spec in enumerate(specs):
            if spec.get("access") not in ("list", "tree") and data[i]:
                # Items of all iterations lie in one branch.
                data[i] = [[item for branch in data[i] for item in branch]]
            if spec.get("access") == "tree" and data[i]:
                first = iterations[0][i]
                data[i] = list(first.Branches) if isinstance(first, DataTree) else data[i][:1]
        self.Params = Params([Port(spec, branches) for spec, branches in zip(specs, data)],
                             [Port(spec) for spec in message.get("outputs") or []])
        self.RunCount, self.Iteration = 0, 0

    def AddRuntimeMessage(self, level, text, *line):
        self._messages.append([_LEVELS.get(int(level), "remark"), str(text), -1])

    def ClearRuntimeMessages(self):
        del self._messages[:]

    def RuntimeMessages(self, level):
        wanted = _LEVELS.get(int(level))
        return NetList(text for kind, text, _ in self._messages if kind == wanted)

    @property
    def RuntimeMessageLevel(self):
        kinds = {kind for kind, _, _ in self._messages}
        name = "Error" if "error" in kinds else "Warning" if "warning" in kinds else "Remark" if kinds else "Blank"
        return getattr(GH_RuntimeMessageLevel, name)

    def OnPingDocument(self):
        return Definition(self._settings)

    def ExpireSolution(self, recompute=False):
        if recompute:
            remark("a script cannot start a solve: ExpireSolution does nothing")

    def OnDisplayExpired(self, *redraw):
        pass

    OnPreviewExpired = OnSolutionExpired = ExpirePreview = OnDisplayExpired

    def ToggleObsolete(self, *on):
        self.Obsolete = bool(on[0]) if on else not self.Obsolete

    def ToString(self):
        return self.Name

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        raise not_supported("Grasshopper.Kernel.GH_Component." + name)


def _branch(value):
    return value if isinstance(value, list) else [value]


class Environment:
    """ghenv."""

    LocalScope = None

    def __init__(self, component):
        self.Component = component

    @property
    def Script(self):
        raise not_supported("ghenv.Script")
