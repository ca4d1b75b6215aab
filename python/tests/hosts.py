"""A worker process as the host starts it, and a host of few members for tests without the program."""

import os
import struct
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
PACKAGE = os.path.join(os.path.dirname(HERE), "katydid")
sys.path.insert(0, os.path.dirname(PACKAGE))

from katydid import codec  # noqa: E402


def no_members(request):
    """A host that has nothing."""
    if request[0] in ("members", "components"):
        return ["ok", []]
    return codec.Error("not_supported", "%s" % (request[1:2] or request))


class WorkerProcess:
    """A worker; what it calls is answered by a function of (member, arguments), or by another host's process."""

    def __init__(self, answer=None):
        self.answer = answer or no_members
        self.process = subprocess.Popen([sys.executable, "-I", "-B", "-u", os.path.join(PACKAGE, "worker.py")],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.handles = codec.PLAIN
        self.requests = []

    def send(self, value):
        self.process.stdin.write(codec.message(value, self.handles))
        self.process.stdin.flush()

    def read(self):
        head = self.process.stdout.read(4)
        if len(head) < 4:
            raise EOFError("the worker has gone")
        return codec.decode(self.process.stdout.read(struct.unpack("<I", head)[0]), _Plain())

    def ask(self, message):
        """Sends a message and answers calls until it is done; gives the result."""
        self.send(message)
        while True:
            request = self.read()
            if request[0] == "done":
                return request[1]
            self.requests.append(request)
            answer = self.answer(request)
            if request[0] != "release":
                self.send(answer)

    def run(self, code, inputs=None, outputs=("a",), language="python3", **more):
        """One iteration of a script with inputs by name; gives its outputs by name, the result and what was printed."""
        inputs = inputs or {}
        ports = []
        for name, value in inputs.items():
            access = "tree" if isinstance(value, codec.Tree) else "list" if isinstance(value, list) else "item"
            ports.append({"name": name, "access": access, "hint": more.get("hints", {}).get(name, ""), "optional": True,
                          "description": ""})
        message = {"run": 1, "code": code, "language": language, "key": more.get("key", "k"), "name": "Python",
                   "nickname": "Py", "inputs": ports, "outputs": [{"name": n, "description": ""} for n in outputs],
                   "iterations": [list(inputs.values())],
                   "doc": {"tolerance": 0.001, "angle_tolerance": 0.0174, "units": "Millimeters"}}
        if "iterations" in more:
            message["iterations"] = more["iterations"]
        result = self.ask(message)
        return dict(zip(outputs, result["iterations"][0])) if result["iterations"] else {}, result

    def close(self):
        try:
            self.send({"quit": True})
        except (BrokenPipeError, ValueError):
            pass
        self.process.stdin.close()
        self.process.wait(10)
        self.process.stdout.close()


class _Plain(codec.Handles):
    """Geometry as (number, kind), so that a test sees what travels."""

    def geometry(self, number, kind):
        return codec.Reference(number, kind)


def errors(result):
    """The error messages of a result."""
    return [text for kind, text, _ in result["messages"] if kind == "error"] + \
        ([result["error"]] if result["error"] else [])


class Members:
    """The program's own host, `katydid members --stdio`: answers what a worker asks, and makes geometry for inputs."""

    def __init__(self, program):
        self.process = subprocess.Popen([program, "members", "--stdio"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def __call__(self, request):
        self.process.stdin.write(codec.message(request))
        self.process.stdin.flush()
        if request[0] == "release":
            return None
        head = self.process.stdout.read(4)
        return codec.decode(self.process.stdout.read(struct.unpack("<I", head)[0]), _Plain())

    def call(self, member, *arguments):
        """The value of a call; an error is raised."""
        answer = self(["call", member] + list(arguments))
        if isinstance(answer, codec.Error):
            raise RuntimeError("%s: %s" % (member, answer.message))
        return answer[1]

    def close(self):
        self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait(10)


def program():
    """The program to test with: KATYDID names it. None where there is none."""
    named = os.environ.get("KATYDID")
    return named if named and os.access(named, os.X_OK) else None
