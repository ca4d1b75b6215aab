"""The process that runs the Python components of a document.

Started as `python3 -I -B -u katydid/worker.py`; messages come in on standard input and go out on standard output. What
a script prints is collected, and its standard input is empty. Messages of the host: a run (see `run.execute`),
`{"needs": code}`, `{"forget": [tokens]}`, `{"quit": true}`. While a run is going on, the script's calls go out and their
answers come in, strictly nested.
"""

import gc
import os
import signal
import sys

# An interrupt that comes before the first script has nothing to end.
if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.SIG_IGN)

if __package__ in (None, ""):
    # Started by path: -I keeps the script's folder off the path, and `katydid` must be found beside nothing else.
    _here = os.path.dirname(os.path.abspath(__file__))
    sys.path[:] = [part for part in sys.path if os.path.abspath(part or ".") != _here]
    sys.path.insert(0, os.path.dirname(_here))

from katydid import backend, codec, rhino  # noqa: E402
from katydid.objects import Objects, Outgoing  # noqa: E402
from katydid.python2 import library  # noqa: E402
from katydid.run import execute  # noqa: E402


class Interrupts:
    """SIGINT ends the script that runs, but never cuts an exchange with the host in two."""

    def __init__(self):
        self.running = self.pending = False
        #: How deep in exchanges: a value that is sent may have to tell the host something first.
        self.exchanging = 0

    def install(self):
        signal.signal(signal.SIGINT, self.on_signal)

    def on_signal(self, number, frame):
        if not self.running:
            return
        if self.exchanging:
            self.pending = True
        else:
            raise KeyboardInterrupt("cancelled")


class WorkerPipes(backend.Pipes):
    """The worker's pipes, with interrupts held back during an exchange."""

    def __init__(self, reader, writer, handles, interrupts):
        backend.Pipes.__init__(self, reader, writer, handles)
        self.interrupts = interrupts

    def request(self, value):
        interrupts = self.interrupts
        interrupts.exchanging += 1
        try:
            return backend.Pipes.request(self, value)
        finally:
            interrupts.exchanging -= 1
            if interrupts.pending and not interrupts.exchanging:
                interrupts.pending = False
                raise KeyboardInterrupt("cancelled")


#: The number of Linux's call that sets how many bytes a pipe holds, and how many we ask for.
F_SETPIPE_SZ, PIPE_SIZE = 1031, 1 << 20


def _widen(pipe):
    """Lets a pipe hold a message of thousands of points, so that it does not pass in many small turns."""
    try:
        import fcntl
        fcntl.fcntl(pipe, F_SETPIPE_SZ, PIPE_SIZE)
    except (ImportError, OSError):
        pass


def take_pipes():
    """Our own ends of standard input and output; scripts get an empty input and no way to write to the host."""
    reader, writer = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    for end in (reader, writer):
        os.set_inheritable(end.fileno(), False)
        _widen(end.fileno())
    nothing = os.open(os.devnull, os.O_RDWR)
    os.dup2(nothing, 0)
    os.dup2(2, 1)
    os.close(nothing)
    sys.stdin = open(os.devnull)
    sys.stdout = sys.stderr
    return reader, writer


class Worker:
    """Reads messages until the pipe ends or the host says quit."""

    def __init__(self, reader, writer):
        self.objects = Objects()
        self.outgoing = Outgoing(self.objects)
        self.interrupts = Interrupts()
        self.pipes = WorkerPipes(reader, writer, self.objects, self.interrupts)

    def loop(self):
        self.interrupts.install()
        backend.use(self.pipes)
        rhino.install()
        library.install()
        while True:
            try:
                data = self.pipes.receive()
            except EOFError:
                return
            message = codec.decode(data, self.objects)
            if not isinstance(message, dict) or message.get("quit"):
                return
            if "forget" in message:
                self.objects.forget(message["forget"])
                continue
            self.answer(self.work(message), message)
            # Handles that the run let go of are told now, and not with the next run.
            self.pipes.flush()

    def work(self, message):
        if "needs" in message:
            from katydid.needs import needs
            try:
                return needs(message["needs"], message.get("language") or "python3")
            except Exception as error:
                return {"modules": [], "members": [], "packages": [], "error": "%s: %s" % (type(error).__name__, error)}
        self.interrupts.running = True
        try:
            return execute.run(message, self.objects)
        except KeyboardInterrupt:
            return failed(message, "cancelled")
        except Exception as error:
            return failed(message, "the worker failed: %s: %s" % (type(error).__name__, error))
        finally:
            self.interrupts.running = self.interrupts.pending = False

    def answer(self, result, message):
        try:
            data = codec.message(["done", result], self.outgoing)
        except Exception as error:
            data = codec.message(["done", failed(message, "the result cannot travel: %s" % error)])
        self.pipes.send(data)


def failed(message, text):
    """The result of a run that gave none."""
    rows = len(message.get("iterations") or [])
    columns = len(message.get("outputs") or [])
    return {"iterations": [[None] * columns for _ in range(rows)], "out": [""] * rows, "messages": [], "error": text,
            "seconds": 0.0}


def main():
    reader, writer = take_pipes()
    # Scripts make many small values that hold no rings: what is loaded now is never looked at again, and the rest less
    # often than Python does by itself (700).
    gc.freeze()
    gc.set_threshold(20000, 20, 50)
    Worker(reader, writer).loop()


if __name__ == "__main__":
    main()
