"""The typed stub names what the module has, and nothing else."""

import ast
import os
import subprocess
import sys

import pytest

import katydid
from katydid import _katydid

FOLDER = os.path.dirname(os.path.abspath(katydid.__file__))
#: What Python gives every class, and what notebooks are given.
EVERYWHERE = set(dir(object)) | {"_repr_png_", "_repr_html_", "__module__", "__getnewargs__"}


def stub():
    with open(os.path.join(FOLDER, "_katydid.pyi"), encoding="utf-8") as file:
        return ast.parse(file.read())


def public(names):
    return {name for name in names if not name.startswith("_")}


def test_the_stub_has_every_public_name_and_no_other():
    nodes = {node.name: node for node in stub().body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    assert set(nodes) == public(dir(_katydid))
    for name, node in nodes.items():
        thing = getattr(_katydid, name)
        if isinstance(node, ast.ClassDef) and not issubclass(thing, Exception):
            there = {part.name for part in node.body if isinstance(part, ast.FunctionDef)}
            assert public(there) == public(vars(thing)), name
            assert there - set(vars(thing)) - EVERYWHERE == set(), name


def test_signatures_agree():
    for node in stub().body:
        parts = node.body if isinstance(node, ast.ClassDef) else [node]
        for part in (part for part in parts if isinstance(part, ast.FunctionDef) and not part.name.startswith("__")):
            owner = getattr(_katydid, node.name)
            thing = getattr(owner, part.name) if isinstance(node, ast.ClassDef) else owner
            text = getattr(thing, "__text_signature__", None)
            if text is None:
                continue
            wanted = [a.strip(" *").split("=")[0] for a in text.strip("()").replace("$self", "self").split(",")]
            wanted = [a for a in wanted if a not in ("", "/")]
            args = part.args
            names = [a.arg for a in args.posonlyargs + args.args + args.kwonlyargs] + ([args.kwarg.arg] if args.kwarg else [])
            flat = [name for name in names]
            assert [a for a in wanted if a.isidentifier()] == [a for a in flat if a in wanted], (node.name, part.name)


def test_the_package_has_what_its_stub_names():
    with open(os.path.join(FOLDER, "__init__.pyi"), encoding="utf-8") as file:
        tree = ast.parse(file.read())
    names = {alias.asname or alias.name for node in tree.body if isinstance(node, ast.ImportFrom) for alias in node.names}
    names |= {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    names -= {"Any", "Optional", "StrPath"}
    from katydid import api
    assert names == set(api.__all__) | {"backend", "interop", "notebook", "rhino", "studies"}


EXAMPLE = """
import katydid
d = katydid.open("facade.gh")
r = d.solve(height=3.2, progress=lambda done, total, name: None)
area: float = r["Area"].item
names: list[str] = [m.component for m in r.messages]
c = katydid.Curve.circle((0, 0, 0), 2.0)
length: float = c.length
v: katydid.Vector = c.tangent_at(0.5)
mesh: katydid.Mesh = katydid.sphere(None, 1.0).to_mesh(tolerance=0.01)
"""


@pytest.mark.parametrize("code, fine", [(EXAMPLE, True), ("import katydid\nx: str = katydid.sphere(None, 1.0).volume\n", False),
                                        ("import katydid\nkatydid.Curve.circl(None, 1)\n", False)])
def test_a_type_checker_reads_the_stub(tmp_path, code, fine):
    pytest.importorskip("mypy")
    (tmp_path / "example.py").write_text(code)
    run = subprocess.run([sys.executable, "-m", "mypy", "--follow-imports=silent", "--cache-dir", str(tmp_path / "cache"),
                          "example.py"], cwd=tmp_path, capture_output=True, text=True,
                         env={**os.environ, "MYPYPATH": os.path.dirname(FOLDER)})
    assert (run.returncode == 0) == fine, run.stdout + run.stderr


def test_every_public_name_has_help():
    for name in public(dir(_katydid)):
        thing = getattr(_katydid, name)
        assert thing.__doc__, name
        for part in public(vars(thing)) if isinstance(thing, type) and not issubclass(thing, Exception) else ():
            assert getattr(thing, part).__doc__, (name, part)
