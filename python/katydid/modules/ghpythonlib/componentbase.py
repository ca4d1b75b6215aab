"""componentbase: classes for scripts that are a component of their own."""

from katydid.run.instance import ComponentBase as _ComponentBase


class component(_ComponentBase):
    """The base of both."""


class executingcomponent(component):
    """A component with a RunScript method."""


class dotnetcompiledcomponent(component):
    """A component of a compiled assembly: here as any other."""
