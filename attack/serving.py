"""A server of the program, run under limits, and requests to it."""

import http.client
import json
import os
import re
import resource
import signal
import socket
import subprocess
import threading
import time
from pathlib import Path

# Nothing takes longer to be answered.
PATIENCE = 30.0


class Remote:
    """A server somewhere, as its clients know it."""

    def __init__(self, host, port):
        self.host, self.port = host, port

    def ask(self, method, path, body=None, headers=None, patience=PATIENCE):
        """The status and the body of an answer."""
        connection = http.client.HTTPConnection(self.host, self.port, timeout=patience)
        try:
            connection.request(method, path, body, headers or {})
            answer = connection.getresponse()
            return answer.status, answer.read()
        finally:
            connection.close()

    def post(self, path, value, headers=None, patience=PATIENCE):
        return self.ask("POST", path, json.dumps(value), headers, patience)

    def connect(self, patience=PATIENCE):
        return socket.create_connection((self.host, self.port), timeout=patience)

    def raw(self, request, patience=PATIENCE):
        """What is answered to some bytes, until the other side closes or is silent."""
        answer = b""
        try:
            with self.connect(patience) as connection:
                connection.sendall(request)
                connection.shutdown(socket.SHUT_WR)
                while part := connection.recv(65536):
                    answer += part
                    if len(answer) > 10_000_000:
                        break
        except (ConnectionError, BrokenPipeError, OSError):
            pass
        return answer


class Serving(Remote):
    """`katydid serve` or `katydid studio`, until it is closed."""

    def __init__(self, katydid, words, addresses=4 << 30, env=None):
        def limited():
            resource.setrlimit(resource.RLIMIT_AS, (addresses, addresses))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

        self.process = subprocess.Popen(
            [katydid, *map(str, words)],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            preexec_fn=limited,
            env=os.environ | (env or {}),
        )
        line = self.process.stdout.readline().decode()
        found = re.search(r"http://([\d.]+):(\d+)/(?:\S*[?&]token=([^\s&]+))?", line)
        if not found:
            self.process.kill()
            raise RuntimeError(f"no address: {line} {self.process.stderr.read().decode()}")
        super().__init__(found[1], int(found[2]))
        self.token = found[3]
        self.said = b""
        # What it says is kept, and does not fill the pipe.
        for stream in (self.process.stdout, self.process.stderr):
            threading.Thread(target=self._listen, args=(stream,), daemon=True).start()

    def _listen(self, stream):
        for line in stream:
            self.said = (self.said + line)[-100_000:]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.runs():
            self.process.send_signal(signal.SIGTERM)
            try:
                self.process.wait(5)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()

    def runs(self):
        return self.process.poll() is None

    def trouble(self):
        """What is wrong with the server itself, if anything; a panic is told once."""
        last = self.said[-300:].decode(errors="replace")
        if not self.runs():
            return f"the server ended: {last}"
        if b"panicked" in self.said:
            self.said = b""
            return f"it panicked: {last}"
        return None

    def processes(self):
        """Its process, and the one that it has started."""
        pid = self.process.pid
        try:
            tasks = [task.read_text() for task in Path(f"/proc/{pid}/task").glob("*/children")]
        except OSError:
            tasks = []
        return [pid, *(int(child) for line in tasks for child in line.split())]

    def megabytes(self):
        """The most memory that it has taken so far."""
        return self.memory().get("VmHWM", 0.0)

    def memory(self):
        """What it takes now and has taken at most, in megabytes: of memory and of addresses."""
        sums = {}
        for pid in self.processes():
            try:
                lines = Path(f"/proc/{pid}/status").read_text().splitlines()
            except OSError:
                continue
            for line in lines:
                name, _, value = line.partition(":")
                if name in ("VmRSS", "VmSize", "VmHWM"):
                    sums[name] = sums.get(name, 0.0) + int(value.split()[0]) / 1024
        return sums

    def seconds(self):
        """The processor time that it has taken so far."""
        ticks = 0
        for pid in self.processes():
            try:
                fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
                ticks += int(fields[11]) + int(fields[12])
            except OSError:
                continue
        return ticks / os.sysconf("SC_CLK_TCK")

    def is_well(self):
        """Whether a small definition is solved within the time of patience."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end and self.runs():
            try:
                if self.ask("GET", "/healthcheck")[1] == b"Healthy":
                    return True
            except (OSError, http.client.HTTPException):
                pass
            time.sleep(0.2)
        return False


def status(answer):
    """The status of each answer in some bytes."""
    return [int(code) for code in re.findall(rb"HTTP/1\.1 (\d{3})", answer)]
