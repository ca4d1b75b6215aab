"""Grasshopper definitions without Rhino, and their geometry.

    import katydid
    d = katydid.open("facade.gh")
    r = d.solve(height=3.2)
    r["Area"].item
    katydid.study("facade.gh", "plan.json").run()

`help(katydid.Definition)`, `help(katydid.Curve)` and so on tell what there is. `katydid.rhino.install()` makes
`import Rhino`, `rhinoscriptsyntax` and the rest work in a notebook or a program.
"""


def __getattr__(name):
    # The process that runs script components imports parts of this package, and does without the extension module.
    if name.startswith("_"):
        raise AttributeError(name)
    import importlib
    if name in ("rhino", "interop", "notebook", "backend", "studies"):
        return importlib.import_module("." + name, __name__)
    try:
        api = importlib.import_module(".api", __name__)
    except ImportError as error:
        # So that `from katydid import landlock` goes on to look for a module of that name.
        raise AttributeError("module 'katydid' has no attribute %r: %s" % (name, error)) from error
    try:
        value = getattr(api, name)
    except AttributeError:
        raise AttributeError("module 'katydid' has no attribute %r" % name) from None
    globals()[name] = value
    return value


def __dir__():
    from . import api
    return sorted(set(globals()) | set(api.__all__))
