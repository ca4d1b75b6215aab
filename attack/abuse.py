"""A compute server and a studio under requests that no client sends.

    python attack/abuse.py target/release/katydid

Every request is answered or its connection closed; none is answered 200 that must not be; the server stays under 512 MB,
and answers small requests all the while.
"""

import base64
import gzip
import json
import random
import socket
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

from bounded import alone
from serving import Serving, status

MOST_MEGABYTES = 512
SERVE = ["serve", "--port", "0", "--timeout", "3", "--limit-bytes", 128 << 20, "--total-bytes", 256 << 20]
SERVE += ["--max-body", 8 << 20, "--cache-bytes", 32 << 20]
SUM = 'katydid 1\na = Number Slider(2.0, 0..10)\nsum = Addition(a, 3)\n"RH_OUT:sum": sum\n'


def post(body, *headers, path="/grasshopper"):
    lines = [f"POST {path} HTTP/1.1", "Host: localhost", *headers]
    return "\r\n".join(lines).encode() + b"\r\n\r\n" + body


def long(body, *headers):
    return post(body, f"Content-Length: {len(body)}", "Connection: close", *headers)


def refused():
    """Requests that must not be answered 200, with their names."""
    body = json.dumps({"algo": "", "pointer": None, "values": []}).encode()
    chunked, length = "Transfer-Encoding: chunked", f"Content-Length: {len(body)}"
    yield "both lengths", post(b"0\r\n\r\nGET /version HTTP/1.1\r\nHost: localhost\r\n\r\n", chunked, "Content-Length: 6")
    yield "two lengths", post(body, length, "Content-Length: 3")
    yield "a length below 0", post(body, "Content-Length: -1")
    yield "a length beyond all", post(body, "Content-Length: 99999999999999999999")
    yield "a body that is too long", post(b"x", f"Content-Length: {1 << 40}")
    yield "an odd coding", post(body, "Transfer-Encoding: chunked, identity")
    yield "a bad chunk", post(b"zz\r\n{}\r\n0\r\n\r\n", chunked)
    yield "a huge chunk", post(b"ffffffffffffffff\r\n{}", chunked)
    yield "a chunk beyond all", post(b"1" * 400 + b"\r\n{}", chunked)
    yield "a wide header", post(b"", "X: " + "x" * 200_000)
    yield "many headers", post(b"", *[f"X{k}: y" for k in range(5000)])
    yield "a folded header", post(b"", "X: a\r\n Content-Length: 5")
    yield "a zero in a header", post(b"", "X: a\0b")
    yield "a space before a colon", post(body, f"Content-Length : {len(body)}")
    yield "no host twice", b"GET /grasshopper HTTP/1.1\r\n\r\n"
    yield "an old version", b"GET /grasshopper HTTP/0.9\r\n\r\n"
    yield "no version", b"GET /grasshopper\r\n\r\n"
    yield "another protocol", b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + bytes(500)
    yield "HTTP/2", b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n" + bytes(60)
    yield "a long line", b"GET /" + b"a" * 300_000 + b" HTTP/1.1\r\nHost: localhost\r\n\r\n"
    for method in ("TRACE", "CONNECT", "PUT", "PATCH", "DELETE", "BREW", "post"):
        yield method, f"{method} /grasshopper HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n".encode()
    for path in ("/../etc/passwd", "/..%2f..%2fetc/passwd", "/%2e%2e/", "/jobs/../metrics", "/%00", "/jobs/%ff", "//etc/passwd"):
        yield path, f"GET {path} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n".encode()
    yield "brackets", long(b"[" * 1_000_000)
    yield "braces", long(b'{"a":' * 200_000)
    yield "a long number", long(b'{"algo": ' + b"9" * 1_000_000 + b"}")
    yield "half a body", post(body, "Content-Length: 1000000", "Connection: close")
    yield "zeros, packed", long(gzip.compress(bytes(200 << 20)), "Content-Encoding: gzip")
    yield "noise, said to be packed", long(random.Random(1).randbytes(10_000), "Content-Encoding: gzip")
    yield "packed otherwise", long(body, "Content-Encoding: br")
    yield "another site", long(body, "Origin: https://evil.example")
    yield "another site's page", long(body, "Sec-Fetch-Site: cross-site")
    yield "another name", body and b"POST /grasshopper HTTP/1.1\r\nHost: evil.example\r\nContent-Length: 2\r\nConnection: close\r\n\r\n{}"
    for member in ("algo", "pointer", "values", "absolutetolerance", "modelunits", "dataversion", "cachesolve", "recursionlevel"):
        for value in ("null", "1e999", "-1", "[[[]]]", '{"a": {}}', '"\\ud800"', "true", '""', "[null]", '[{"ParamName": 7}]'):
            yield f"{member} {value}", long(f'{{"{member}": {value}}}'.encode())
    for pointer in ("/etc/passwd", "file:///etc/passwd", "http://127.0.0.1:1/x.gh", "http://169.254.169.254/", "md5_../../x", "C:\\\\x.gh"):
        yield pointer, long(f'{{"pointer": "{pointer}"}}'.encode())
    for kind in ("curve/getlength-curve", "brep/createfrombox-box", "mesh/createfrombrep-brep", "nothing/at-all"):
        for value in (b"[]", b"[[[[[[1]]]]]]", b'[{"version": 10000, "archive3dm": 70, "opennurbs": -1, "data": "AAAA"}]', b"[null, null]"):
            yield f"{kind} {value[:20]}", post(
                value, f"Content-Length: {len(value)}", "Connection: close", path=f"/rhino/geometry/{kind}"
            )


def slow(server, seconds):
    """Clients that send a byte now and then, ask and do not listen, or say nothing."""
    sockets = []
    for k in range(200):
        try:
            connection = server.connect()
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            if k % 4 == 1:
                connection.sendall(b"POST /grasshopper HTTP/1.1\r\nHost: localhost\r\nContent-Length: 5000000\r\n\r\n{")
            if k % 4 == 2:
                connection.sendall(b"GET /sdk HTTP/1.1\r\nHost: localhost\r\n\r\n" * 200)
            sockets.append(connection)
        except OSError:
            break
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        for connection in sockets:
            try:
                connection.sendall(b" ")
            except OSError:
                pass
        time.sleep(0.5)
    for connection in sockets:
        connection.close()


def serve(katydid, found, end, algo):
    """A compute server."""
    with Serving(katydid, SERVE) as server:
        body = json.dumps({"algo": algo, "values": []})

        def note(name, wrong, cause=b""):
            found.note(f"serve, {name}", server.trouble() or wrong, cause)
            return server.runs()

        for name, request in refused():
            if time.monotonic() > end:
                break
            codes = status(server.raw(request))
            wrong = f"is answered {codes}" if any(code < 300 for code in codes) else None
            if not note(name, wrong, request):
                return
        dice = random.Random(2)
        plain = long(body.encode())
        for number in range(300):
            if time.monotonic() > end:
                break
            mutant = bytearray(plain)
            for _ in range(dice.choice([1, 3, 30])):
                mutant[dice.randrange(len(mutant))] = dice.randrange(256)
            server.raw(bytes(mutant[: dice.randrange(len(mutant))] if dice.random() < 0.2 else mutant), 5)
            if not note(f"mutant {number}", None, bytes(mutant)):
                return
        many = threading.Thread(target=slow, args=(server, min(20.0, max(1.0, end - time.monotonic()))))
        many.start()
        while many.is_alive():
            try:
                code, answer = server.ask("POST", "/grasshopper", body, patience=10)
                note("small among slow clients", None if code == 200 and b"5.0" in answer else f"{code} {answer[:200]}")
            except OSError as error:
                note("small among slow clients", f"{error}")
            time.sleep(0.2)
        many.join()
        note("health", None if server.is_well() else "it is not well in the end")
        taken = server.megabytes()
        note("memory", f"took {taken:.0f} MB" if taken > MOST_MEGABYTES else None)


UPGRADE = "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n"
PATHS = ["/", "/socket", "/api/start", "/api/open", "/api/upload", "/api/save", "/api/export", "/geometry/1", "/image/1"]


def frame(payload, code=0x81):
    """A masked frame of a WebSocket; the mask is 0."""
    size = len(payload)
    if size < 126:
        head = bytes([code, 0x80 | size])
    elif size < 65536:
        head = bytes([code, 0xFE]) + size.to_bytes(2, "big")
    else:
        head = bytes([code, 0xFF]) + size.to_bytes(8, "big")
    return head + bytes(4) + payload


def frames(dice):
    """What a client may send that was let in."""
    asks = ["undo", "redo", "solve", "save", "edit", "move", "set", "copy", "paste", "export", "open", "preview", 7, None, []]
    value = dice.choice([None, -1, 1e308, "x" * 100_000, [], {}, [[]] * 1000, {"at": [1e999, -1e999]}, "\u0000"])
    plain = json.dumps({"seq": dice.choice([1, -1, 2**70, "a"]), "ask": {"ask": dice.choice(asks), "id": value, "value": value}})
    yield frame(plain.encode())
    yield frame(b'{"seq": 1, "ask": ' + b"[" * 200_000)
    yield frame(dice.randbytes(50))
    yield frame(dice.randbytes(50), 0x82)
    yield frame(b"", dice.choice([0x80, 0x83, 0x8F, 0xF1, 0x01]))
    yield bytes([0x81, 0xFF]) + (1 << 62).to_bytes(8, "big") + bytes(4)
    yield frame(b"ping", 0x89) * 1000
    yield dice.randbytes(200)


def studio(katydid, found, end, folder):
    """A studio: who does not know the token gets nothing, and who does cannot end it."""
    path = Path(folder) / "sum.kd"
    path.write_text(SUM)
    words = ["studio", path, "--port", "0", "--no-open"]
    with Serving(katydid, words, env={"XDG_STATE_HOME": folder}) as server:

        def note(name, wrong, cause=b""):
            found.note(f"studio, {name}", server.trouble() or wrong, cause)
            return server.runs()

        host = f"Host: localhost:{server.port}"
        strangers = ["", "?token=", "?token=wrong", f"?token={'x' * 10_000}", "?token=%00", f"?token={server.token[:-1]}"]
        for address in PATHS:
            for token in strangers:
                for site in ("", "Origin: https://evil.example\r\n"):
                    upgrade = UPGRADE if address == "/socket" else "Connection: close\r\n"
                    request = f"GET {address}{token} HTTP/1.1\r\n{host}\r\n{site}{upgrade}\r\n".encode()
                    codes = status(server.raw(request, 5))
                    wrong = f"a stranger is answered {codes}" if any(code < 300 for code in codes) else None
                    note(f"{address}{token[:20]} {site[:6]}", wrong, request)
            forged = f"GET {address}?token={server.token} HTTP/1.1\r\nHost: evil.example\r\n{UPGRADE}\r\n".encode()
            codes = status(server.raw(forged, 5))
            note(f"{address} by another name", f"is answered {codes}" if any(c < 300 for c in codes) else None, forged)
        dice = random.Random(3)
        head = f"GET /socket?token={server.token} HTTP/1.1\r\n{host}\r\n{UPGRADE}\r\n".encode()
        for number in range(40):
            for kind, sent in enumerate(frames(dice)):
                if time.monotonic() > end:
                    break
                server.raw(head + sent, 5)
                if not note(f"frame {number}.{kind}", None, head + sent):
                    return
        code, _ = server.ask("GET", f"/api/start?token={server.token}")
        note("in the end", None if code < 400 else f"its owner is answered {code}")
        taken = server.megabytes()
        note("memory", f"took {taken:.0f} MB" if taken > MOST_MEGABYTES else None)


def attack(katydid, found, seconds=None):
    """Both, each for half of the time."""
    seconds = seconds or 240.0
    with tempfile.TemporaryDirectory() as folder:
        source, target = Path(folder) / "sum.kd", Path(folder) / "sum.gh"
        source.write_text(SUM)
        subprocess.run([katydid, "convert", source, target], check=True, capture_output=True)
        algo = base64.b64encode(target.read_bytes()).decode()
        serve(katydid, found, time.monotonic() + 0.6 * seconds, algo)
        studio(katydid, found, time.monotonic() + 0.4 * seconds, folder)


if __name__ == "__main__":
    sys.exit(alone("abuse", __doc__, attack))
