"""The way to the host: a member of a class is called by name, geometry is held by handle.

There is one backend at a time (`current()`): the worker's two pipes, a child process `katydid members --stdio`, or,
in the wheel, the extension module. What it answers is the same.
"""

import os
import re
import struct
import subprocess
import threading

from . import codec
from .values.base import NotSupported

_SIGNATURE = re.compile(r"^\s*(?:(?:static|instance)\s+)?([\w`]+)\.(\w+)\s*(?:\(|$)")


class Table:
    """The members that the host has: by class, the signatures of each name."""

    def __init__(self, signatures, changing=()):
        self.classes = {}
        #: The members that change their object. None where the host does not say: then any may.
        self.changing = None if changing is None else frozenset(changing)
        for signature in signatures:
            found = _SIGNATURE.match(str(signature))
            if found:
                self.classes.setdefault(found.group(1), {}).setdefault(found.group(2), []).append(str(signature))

    def has(self, cls, name):
        return name in self.classes.get(cls, ())

    def changes(self, names, member):
        """Whether a member, of one of these classes, changes its object."""
        return self.changing is None or any("%s.%s" % (name, member) in self.changing for name in names)

    def signatures(self, cls, name):
        return self.classes.get(cls, {}).get(name, [])


class Backend:
    """Calls over a way to send one message and read its answer: `exchange`, given by subclasses."""

    def __init__(self, handles):
        self.handles = handles
        self._table = None
        self._released = []
        self._lock = threading.RLock()

    def send(self, data):
        raise NotImplementedError

    def receive(self):
        """The body of the next message."""
        raise NotImplementedError

    def request(self, value):
        """One request and its answer; an error of the host is raised."""
        with self._lock:
            # Writing a value may send a request of its own (a mesh whose vertices wait), so it comes first.
            data = codec.message(value, self.handles)
            self.flush()
            self.send(data)
            answer = codec.decode(self.receive(), self.handles)
        if isinstance(answer, codec.Error):
            raise_error(answer)
        if not isinstance(answer, list) or len(answer) != 2 or answer[0] != "ok":
            raise codec.CodecError("the host's answer is none: %.80r" % (answer,))
        return answer[1]

    def call(self, name, *arguments):
        """A member of the table, by its name `Class.Member`."""
        return self.request(["call", name] + list(arguments))

    def component(self, name, inputs):
        return self.request(["component", name, list(inputs)])

    def components(self):
        return self.request(["components"])

    @property
    def table(self):
        if self._table is None:
            self._table = Table(self.request(["members"]), self._changing())
        return self._table

    def _changing(self):
        try:
            return self.request(["changing"])
        except NotSupported:
            return None

    def release(self, number):
        """A handle that nobody holds any more. It is told with the next request: this runs in the collector."""
        self._released.append(number)

    def flush(self):
        if self._released:
            numbers, self._released = self._released, []
            self.send(codec.message(["release", numbers], self.handles))


def raise_error(error):
    """Raises the Python exception for an error that the host answered."""
    if error.kind == "not_supported":
        raise NotSupported(error.message)
    if error.kind == "argument":
        raise TypeError(error.message)
    if error.kind == "cancelled":
        raise KeyboardInterrupt(error.message)
    if error.kind == "memory":
        raise MemoryError(error.message)
    raise codec.HostError(error.kind, error.message)


class Pipes(Backend):
    """Two files of bytes: the worker's own pipes."""

    def __init__(self, reader, writer, handles):
        Backend.__init__(self, handles)
        self.reader, self.writer = reader, writer

    def send(self, data):
        self.writer.write(data)
        self.writer.flush()

    def receive(self):
        head = self._exactly(4)
        length = struct.unpack("<I", head)[0]
        if length >= codec.LONGEST:
            raise codec.CodecError("a message of %d bytes is too long" % length)
        return self._exactly(length)

    def _exactly(self, count):
        # Read in pieces, so that a wrong length does not allocate what never comes.
        parts, missing = [], count
        while missing:
            part = self.reader.read(min(missing, 1 << 20))
            if not part:
                raise EOFError("the host has gone")
            parts.append(part)
            missing -= len(part)
        return parts[0] if len(parts) == 1 else b"".join(parts)


class Process(Pipes):
    """A host of our own: the program that KATYDID names, or `katydid` on the path."""

    def __init__(self, handles, program=None):
        program = program or os.environ.get("KATYDID") or "katydid"
        self.process = subprocess.Popen([program, "members", "--stdio"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        Pipes.__init__(self, self.process.stdout, self.process.stdin, handles)

    def close(self):
        self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait(10)


class Extension(Backend):
    """The host in this process: the extension module of the package."""

    def __init__(self, handles):
        from ._katydid import Host
        Backend.__init__(self, handles)
        self.host, self.answers = Host(), []

    def send(self, data):
        answer = self.host.answer(bytes(data[4:]))
        if answer is not None:
            self.answers.append(answer)

    def receive(self):
        return self.answers.pop()


class Absent(Backend):
    """No host: value types work, and geometry says what is missing."""

    def request(self, value):
        raise NotSupported("geometry needs Katydid's program: set KATYDID to it, or put katydid on the path")

    @property
    def table(self):
        return self.request(None)

    def release(self, number):
        pass


_current = None


def current():
    """The backend in use; the first question starts a process where there is a program."""
    global _current
    if _current is None:
        from .objects import Objects
        _current = _made(Objects())
    return _current


def _made(handles):
    """A program that was named goes before the extension module, and that before a program on the path."""
    if not os.environ.get("KATYDID"):
        try:
            return Extension(handles)
        except ImportError:
            pass
    try:
        return Process(handles)
    except OSError:
        return Absent(handles)


def use(backend):
    """Makes a backend the current one and gives the one before."""
    global _current
    before, _current = _current, backend
    return before
