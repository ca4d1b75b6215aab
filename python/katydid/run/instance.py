"""Scripts that are a class with RunScript: one object a component, kept between runs."""

import inspect

from ..values.base import DotNet
from .component import current


class ComponentBase(DotNet):
    """What componentbase.executingcomponent and GH_ScriptInstance are: the component's members are its own."""

    _namespace = "Grasshopper.Kernel"

    def __init__(self, *arguments):
        pass

    @property
    def Component(self):
        return self.__dict__.get("_component") or current()

    RhinoDocument = property(lambda self: _model())
    GrasshopperDocument = property(lambda self: self.Component.OnPingDocument())
    Iteration = property(lambda self: self.Component.Iteration)

    def RunScript(self, *inputs):
        return None

    def BeforeRunScript(self):
        pass

    def AfterRunScript(self):
        pass

    def AppendAdditionalMenuItems(self, items):
        pass

    def Print(self, text, *items):
        print(str(text).format(*items) if items else text)

    def Reflect(self, thing, *name):
        print("\n".join(member for member in dir(thing) if not member.startswith("_")))

    def __getattr__(self, name):
        if name.startswith("_") or self.Component is None:
            raise AttributeError(name)
        return getattr(self.Component, name)


def _model():
    from ..document import model
    return model()


def find(variables, component):
    """An object of the script's own component class, or None where it has none."""
    for value in list(variables.values()):
        if inspect.isclass(value) and issubclass(value, ComponentBase) and "RunScript" in _own(value):
            made = value()
            made.__dict__["_component"] = component
            return made
    return None


def _own(cls):
    """The names that a script's classes define, without those of our base."""
    names = set()
    for base in cls.__mro__:
        if base.__module__ == "__main__":
            names.update(base.__dict__)
    return names


def outputs(made, component, inputs, names):
    """Runs it once: a tuple or list gives the outputs in order, anything else the first."""
    made.__dict__["_component"] = component
    made.BeforeRunScript()
    try:
        result = made.RunScript(*inputs)
    finally:
        made.AfterRunScript()
    wanted = [name for name in names if name != "out"]
    several = isinstance(result, tuple) or (isinstance(result, list) and len(wanted) > 1)
    given = dict(zip(wanted, result if several else (result,)))
    return [given.get(name) for name in names]
