"""`katydid mcp --studio` through the protocol's official client: a person's definition is edited in an open studio, and taken
back there."""

import http.client
import json
import os
import subprocess
import urllib.parse

import pytest

from test_assistant import KATYDID, run

START = """\
katydid 1
r = Number Slider(2.0, 0..10)
ball = Sphere(_, r)
volume = Volume(ball)
"""


class Studio:
    """A studio that runs, and what its page asks."""

    def __init__(self, folder, *words):
        self.file = folder / "ball.kd"
        self.file.write_text(START)
        self.state = {**os.environ, "XDG_STATE_HOME": str(folder / "state")}
        command = [KATYDID, "studio", str(self.file), "--no-open", "--port", "0", *words]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env=self.state)
        self.url = self.process.stdout.readline().strip()
        parts = urllib.parse.urlsplit(self.url)
        self.host, self.query = parts.netloc, dict(urllib.parse.parse_qsl(parts.query))

    def ask(self, method, path, **query):
        query = urllib.parse.urlencode({**query, "token": self.query["token"]})
        connection = http.client.HTTPConnection(self.host, timeout=30)
        connection.request(method, f"{path}?{query}")
        answer = connection.getresponse()
        return answer.status, answer.read()

    def text(self):
        """The definition as the page would save it."""
        status, body = self.ask("GET", "/api/save", document=self.query["document"], format="kd")
        assert status == 200, body
        return body.decode()

    def end(self):
        self.process.terminate()
        self.process.wait(30)


@pytest.fixture
def studio(tmp_path):
    studio = Studio(tmp_path, "--allow-assistant")
    yield studio
    studio.end()


def test_a_definition_is_edited_where_the_person_has_it_open(studio, tmp_path):
    async def work(call):
        (one,) = (await call("list_definitions"))["open"]
        assert one["name"] == "ball.kd"
        described = await call("describe_definition")
        assert described["studio"]["name"] == "ball.kd" and described["objects"] == 3
        before = studio.text()
        await call("edit_text", append="double = Multiplication(r, 2)\nbox = Center Box(_, double, double, double)\n")
        after = studio.text()
        assert "double = " in after and "box = " in after and "double" not in before
        await call("solve")
        assert abs((await call("measure", port="box"))["volume"] - 8 * 4**3) < 1e-6
        png = await call.session.call_tool("picture", {"of": "canvas"})
        assert png.content[1].data
        assert (await call("undo"))["steps"] == ["Edit text"]
        assert studio.text() == before
        assert (await call("redo"))["steps"] == ["Edit text"]
        assert studio.text() == after
        await call("set_inputs", values={"r": 3})
        assert "r = Number Slider(3" in studio.text()
        for tool in ("new_definition", "open_definition"):
            arguments = {"path": "a.gh"} if tool == "open_definition" else {}
            assert "the person" in await call.refused(tool, **arguments)
        assert "the person saves" in await call.refused("save_definition")
        await call("save_definition", path="copy.gh")
        assert (tmp_path / "out" / "copy.gh").stat().st_size > 1000
        assert studio.file.read_text() == START

    (tmp_path / "out").mkdir()
    run(work, "--studio", studio.url, "--folder", str(tmp_path / "out"))


def test_the_studio_is_found_by_itself_and_again(tmp_path):
    first = Studio(tmp_path, "--allow-assistant")

    async def work(call):
        nonlocal first
        assert (await call("describe_definition"))["objects"] == 3
        first.end()
        assert "no studio" in await call.refused("describe_definition")
        first = Studio(tmp_path, "--allow-assistant")
        assert (await call("describe_definition"))["objects"] == 3

    try:
        run(work, "--studio", env=first.state)
    finally:
        first.end()
    assert not (tmp_path / "state" / "katydid" / "studio-address").exists()


def test_a_studio_that_lets_nobody_in_is_not_joined(tmp_path):
    studio = Studio(tmp_path)

    async def work(call):
        assert "--allow-assistant" in await call.refused("list_definitions")

    try:
        run(work, "--studio", studio.url)
        status, body = studio.ask("GET", "/api/assistant")
        assert status == 403 and "error" in json.loads(body)
    finally:
        studio.end()


@pytest.mark.parametrize("url", ["http://192.168.1.5:6510/?token=a", "https://127.0.0.1/?token=a", "http://127.0.0.1:6510/", "6510"])
def test_other_addresses_are_refused(url):
    done = subprocess.run([KATYDID, "mcp", "--studio", url], capture_output=True, text=True, stdin=subprocess.DEVNULL)
    assert done.returncode == 2 and "--studio" in done.stderr
