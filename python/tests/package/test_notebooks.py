"""What notebooks show, and the worked notebooks of the documentation."""

import base64
import html
import json
import os
import re
import shutil

import pytest

import katydid as k

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "docs", "notebooks")
NOTEBOOKS = sorted(file for file in os.listdir(FOLDER) if file.endswith(".ipynb"))


def test_geometry_shows_a_picture_and_a_viewer_without_a_network():
    sphere = k.sphere(None, 1)
    assert sphere._repr_png_().startswith(b"\x89PNG")
    shown = sphere._repr_html_()
    page = html.unescape(re.search(r'srcdoc="([^"]*)"', shown).group(1))
    assert "http" not in page and "import(" not in page and "fetch(" not in page
    model = base64.b64decode(re.search(r'const MODEL="([^"]*)"', page).group(1))
    assert model[:4] == b"glTF"
    gltf = json.loads(model[20:20 + int.from_bytes(model[12:16], "little")])
    assert gltf["meshes"]


def test_definitions_and_solutions_show_themselves(definition):
    d = definition("x = Number Slider(0, 0..1)\nd = Division(1, x)\nc = Circle(XY Plane(), 2)\n")
    assert "<td>x</td>" in d._repr_html_() and d._repr_png_().startswith(b"\x89PNG")
    shown = d.solve()._repr_html_()
    assert "Division" not in shown or "error" in shown
    assert "<iframe" in shown and "<td>error</td>" in shown


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_the_worked_notebooks_run(name, tmp_path, monkeypatch):
    """Runs the cells one after the other, as a kernel would, in a folder of their own."""
    with open(os.path.join(FOLDER, name), encoding="utf-8") as file:
        notebook = json.load(file)
    for other in os.listdir(FOLDER):
        if not other.endswith(".ipynb"):
            shutil.copy(os.path.join(FOLDER, other), tmp_path)
    monkeypatch.chdir(tmp_path)
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert len(cells) >= 3 and not any(cell["outputs"] for cell in cells)
    space = {"__name__": "__main__"}
    for place, cell in enumerate(cells):
        exec(compile("".join(cell["source"]), "%s[%d]" % (name, place), "exec"), space)
