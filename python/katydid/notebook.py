"""How definitions, solutions and geometry show themselves in a notebook: a picture, and a viewer that turns.

The viewer is a page of its own inside the output cell (an iframe), with its code and its model in it: it asks no network.
"""

import base64
import html
import os

#: A model larger than this is only shown as a picture: the notebook would keep all of it.
MOST_BYTES = 16 << 20
_SIZE = (800, 500)
_HERE = os.path.dirname(os.path.abspath(__file__))


def viewer(glb, png):
    """The HTML of a viewer of a binary glTF file, with a picture until it has drawn."""
    picture = "data:image/png;base64," + base64.b64encode(png).decode()
    if len(glb) > MOST_BYTES:
        return '<img src="%s" width="%d" height="%d">' % ((picture,) + _SIZE)
    with open(os.path.join(_HERE, "viewer.js"), encoding="utf-8") as file:
        code = file.read()
    page = ('<!doctype html><style>body{margin:0;background:#fff url("%s") center/contain no-repeat}'
            'canvas{width:100vw;height:100vh;display:block;touch-action:none}</style><canvas></canvas>'
            '<script>const MODEL="%s";%s</script>') % (picture, base64.b64encode(glb).decode(), code)
    return ('<iframe sandbox="allow-scripts" width="%d" height="%d" style="border:1px solid #ddd;max-width:100%%" '
            'srcdoc="%s"></iframe>') % (_SIZE + (html.escape(page),))


def _table(rows, head):
    cells = lambda row, tag: "".join("<%s>%s</%s>" % (tag, html.escape(str(c)), tag) for c in row)  # noqa: E731
    return "<table><tr>%s</tr>%s</table>" % (cells(head, "th"), "".join("<tr>%s</tr>" % cells(r, "td") for r in rows))


def install(module):
    """Gives the classes of the extension module the methods that notebooks ask for."""

    def geometry_png(thing):
        return module.geometry_picture([thing], _SIZE)

    def geometry_html(thing):
        return viewer(module.geometry_glb([thing]), geometry_png(thing))

    def definition_png(definition):
        return definition.picture(_SIZE, canvas=True)

    def definition_html(definition):
        rows = [(i.name, i.kind, "" if i.minimum is None else "%g .. %g" % (i.minimum, i.maximum), i.value or "")
                for i in definition.inputs]
        picture = base64.b64encode(definition_png(definition)).decode()
        return "<b>%s</b>%s<img src='data:image/png;base64,%s'>" % (
            html.escape(definition.name), _table(rows, ("input", "type", "range", "value")), picture)

    def solution_png(solution):
        return solution.picture(_SIZE)

    def solution_html(solution):
        said = [(m.level, m.nickname, m.text) for m in solution.messages]
        return viewer(solution.to_glb(), solution_png(solution)) + (
            _table(said, ("level", "component", "message")) if said else "")

    for name in ("Curve", "Surface", "Brep", "Mesh", "SubD", "Box"):
        cls = getattr(module, name)
        cls._repr_png_, cls._repr_html_ = geometry_png, geometry_html
    module.Definition._repr_png_, module.Definition._repr_html_ = definition_png, definition_html
    module.Solution._repr_png_, module.Solution._repr_html_ = solution_png, solution_html
