"""`katydid mcp` through the protocol's official client: a vase is made and exported, what is wrong is refused, and calls stay
quick on a large definition while it is solved."""

import base64
import os
import time
from pathlib import Path

import pytest
from mcp import ClientSession, StdioServerParameters
from mcp.client.stdio import stdio_client

KATYDID = os.environ["KATYDID"]
SHARED = os.environ.get("KATYDID_TEST_DEFINITIONS")

# The most that a call may take beyond the solve, in seconds.
MOST = 0.1

VASE = """\
height = Number Slider(200.0, 50..400)
belly = Number Slider(60.0, 20..120)
neck = Number Slider(25.0, 10..60)
foot = Number Slider(40.0, 10..80)
profile = Interpolate([Construct Point(foot, 0, 0), Construct Point(belly, 0, Multiplication(height, 0.4)), Construct Point(neck, 0, Multiplication(height, 0.8)), Construct Point(Multiplication(neck, 1.4), 0, height)])
vase = Revolution(profile, Line SDL((0, 0, 0), (0, 0, 1), 1))
"""


class Client:
    def __init__(self, session):
        self.session = session

    async def __call__(self, tool, **arguments):
        result = await self.session.call_tool(tool, arguments)
        assert not failed(result), (tool, arguments, result.content[0].text)
        return structured(result)

    async def refused(self, tool, **arguments):
        try:
            result = await self.session.call_tool(tool, arguments)
        except Exception as error:  # An error of the protocol.
            return str(error)
        assert failed(result), (tool, arguments, result.content)
        return result.content[0].text


def failed(result):
    return getattr(result, "is_error", getattr(result, "isError", False))


def structured(result):
    found = getattr(result, "structured_content", None)
    return found if found is not None else result.structuredContent


def run(work, *words, env=None):
    """Runs work with a client of a new server."""
    import anyio

    async def main():
        server = StdioServerParameters(command=KATYDID, args=["mcp", *words], env=env)
        async with stdio_client(server) as (read, write):
            async with ClientSession(read, write) as session:
                await session.initialize()
                await work(Client(session))

    anyio.run(main)


def test_a_vase_is_made_and_exported(tmp_path):
    async def work(call):
        tools = (await call.session.list_tools()).tools
        assert len(tools) >= 20 and all(tool.description for tool in tools)
        found = await call("find_components", words="revolution surface of a profile curve")
        assert any(one["name"] == "Revolution" for one in found["components"]), found
        made = await call("new_definition", kd=VASE, name="vase")
        assert {one["name"] for one in made["inputs"]} == {"height", "belly", "neck", "foot"}
        solved = await call("solve")
        assert solved["state"] == "done" and solved["outcome"]["objects"]["error"] == 0, solved
        first = await call("measure", port="vase")
        size = first["box"]["size"]
        assert abs(size[2] - 200) < 1e-6 and size[0] >= 120, first
        await call("set_inputs", values={"height": 300, "belly": 80})
        await call("solve")
        second = await call("measure", port="vase")
        assert abs(second["box"]["size"][2] - 300) < 1e-6 and second["area"] > first["area"]
        for of in ("result", "canvas"):
            told = await call.session.call_tool("picture", {"of": of})
            png = base64.b64decode(told.content[1].data)
            assert png.startswith(b"\x89PNG") and len(png) > 5000
            (tmp_path / f"{of}.png").write_bytes(png)
            if keep := os.environ.get("KATYDID_KEEP_PICTURES"):
                Path(keep, f"{of}.png").write_bytes(png)
        for extension in ("3dm", "step", "glb", "stl", "obj"):
            told = await call("export_geometry", path=f"vase.{extension}", objects=["vase"])
            assert told["objects"] == 1 and (tmp_path / f"vase.{extension}").stat().st_size == told["bytes"]
        await call("save_definition", path="vase.gh")
        assert (await call("diff_definition"))["total"] == 0
        assert (await call("undo"))["steps"] == ["Set belly, height"]

    run(work, "--folder", str(tmp_path))


WRONG = [
    ("nothing", {}),
    ("describe_definition", {"document": "d7"}),
    ("describe_definition", {"document": ["d1"]}),
    ("describe_definition", {"surplus": 1}),
    ("open_definition", {}),
    ("open_definition", {"path": "../a.gh"}),
    ("open_definition", {"path": "/etc/passwd"}),
    ("open_definition", {"path": "/proc/self/environ.gh"}),
    ("open_definition", {"path": "none.gh"}),
    ("open_definition", {"path": "a\x00b.gh"}),
    ("open_definition", {"path": ""}),
    ("new_definition", {"kd": "x = ("}),
    ("new_definition", {"kd": "x = No Such Component()"}),
    ("new_definition", {"kd": "y" * (9 << 20)}),
    ("new_definition", {"kd": "x = Panel(1)", "example": "tower"}),
    ("save_definition", {"path": "../a.gh"}),
    ("save_definition", {"path": "/tmp/a.gh"}),
    ("save_definition", {"path": "a.exe"}),
    ("save_definition", {"path": "no/such/folder/a.gh"}),
    ("close_definition", {"document": "d1"}),
    ("list_objects", {"objects": ["nobody"]}),
    ("list_objects", {"group": "nobody"}),
    ("list_objects", {"from": -1}),
    ("edit_text", {"replace": [{"old": "absent", "new": "x"}]}),
    ("edit_text", {"whole": "x", "append": "y"}),
    ("edit_text", {"whole": "\u0000"}),
    ("edit_definition", {"operations": [{"op": "fly"}]}),
    ("edit_definition", {"operations": [{"op": "remove", "objects": ["nobody"]}]}),
    ("edit_definition", {"operations": [{"op": "remove", "objects": ["height"]}] * 1001}),
    ("edit_definition", {"operations": [{"op": "connect", "from": "vase", "to": "profile"}]}),
    ("edit_definition", {"operations": [{"op": "set", "object": "height", "value": "nan"}]}),
    ("edit_definition", {"operations": [{"op": "set", "object": "height", "value": {"a": 1}}]}),
    ("edit_definition", {"operations": [{"op": "group", "objects": ["00000000-0000-0000-0000-000000000000"], "label": "x"}]}),
    ("edit_definition", {"operations": [{"op": "settings", "tolerance": -1}]}),
    ("edit_definition", {"operations": [{"op": "settings", "units": "parsecs and a half"}]}),
    ("set_inputs", {"values": {"height": "inf"}}),
    ("set_inputs", {"values": {"height": 401}}),
    ("set_inputs", {"values": {"nobody": 1}}),
    ("read_values", {"port": "vase"}),
    ("measure", {"port": "vase"}),
    ("picture", {"width": 1_000_000}),
    ("picture", {"view": "behind"}),
    ("export_geometry", {"path": "a.glb"}),
    ("cancel_job", {"job": 99}),
    ("solve", {"wait_seconds": 1e9}),
    ("why", {"object": "nobody"}),
    ("component_help", {"name": ""}),
]


def test_what_is_wrong_is_refused_and_nothing_is_lost(tmp_path):
    async def work(call):
        await call("new_definition", kd=VASE)
        before = await call("read_text", blocks=True)
        for tool, arguments in WRONG:
            why = await call.refused(tool, **arguments)
            assert len(why) > 10 and "fault of Katydid" not in why, (tool, arguments, why)
        assert await call("read_text", blocks=True) == before
        assert sorted(tmp_path.iterdir()) == []

    run(work, "--folder", str(tmp_path))
    assert len(WRONG) >= 40


def test_a_cancelled_job_is_told():
    async def work(call):
        await call("new_definition", kd="n = Series(0, 1, 20000000)\n" + "".join(
            f"s{k} = Sine({'n' if k == 0 else f's{k - 1}'})\n" for k in range(8)))
        assert (await call("solve", wait_seconds=0))["state"] == "running"
        assert (await call("cancel_job"))["state"] == "cancelled"
        assert "ended" in await call.refused("cancel_job")

    run(work)


@pytest.mark.skipif(not SHARED, reason="needs the shared definitions")
def test_fifty_calls_on_a_large_definition_are_quick():
    largest = max(Path(SHARED).rglob("*.gh"), key=lambda path: path.stat().st_size if "the-book" in path.parts else 0)

    async def work(call):
        opened = await call("open_definition", path=str(largest))
        name = opened["inputs"][0]["name"] if opened["inputs"] else None
        slow, times = [], []
        tools = [
            ("describe_definition", {}), ("list_objects", {"limit": 50}), ("list_objects", {"word": "point"}),
            ("read_text", {"lines": 50}), ("job_status", {}), ("find_components", {"words": "divide curve"}),
            ("component_help", {"name": "Circle"}), ("diff_definition", {}), ("list_definitions", {}),
            ("edit_definition", {"operations": [{"op": "add", "component": "Panel"}]}),
        ]
        await call("solve", wait_seconds=0)
        for k in range(50):
            tool, arguments = tools[k % len(tools)]
            began = time.perf_counter()
            await call(tool, **arguments)
            times.append((time.perf_counter() - began, tool))
        print(largest.name, opened["objects"], name, sorted(times, reverse=True)[:12])
        slow = [one for one in times if one[0] > MOST]
        assert not slow, slow

    run(work, "--folder", SHARED)
