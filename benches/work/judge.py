"""One row in a process of its own, because the peers are large: verifies the answer, and then times the peer.

    python benches/work/judge.py target/release/katydid "Closest Point"

Prints an object: `wrong` says how the answers at the largest size differ, `seconds` is what the peer took at the least
and at the largest.
"""

import json
import sys
import tempfile
import time

import answers
import definitions
import peers

# A peer runs so often, or until it has taken so many seconds; the least counts.
TIMES = 5
ENOUGH = 2.0


def seconds(peer):
    """The least seconds of processor time that the peer's work takes, what it is given made before."""
    best, total = float("inf"), 0.0
    for _ in range(TIMES):
        given = peer.given()
        start = time.process_time()
        peer.work(given)
        taken = time.process_time() - start
        best, total = min(best, taken), total + taken
        if total > ENOUGH:
            break
    return best


def judge(katydid, row):
    least, largest = row.sizes()[0], row.sizes()[-1]
    peer = peers.peer(row.name, largest)
    with tempfile.TemporaryDirectory() as folder:
        if row.saves:
            ours = answers.saved(katydid, row, largest, folder, peer.read)
        else:
            ours = answers.answer(katydid, row, largest, folder)
    theirs = peer.answer(peer.work(peer.given()))
    wrong = answers.difference(row, ours, theirs)
    timed = row.peer is not None and wrong is None
    return {"wrong": wrong, "seconds": [seconds(peers.peer(row.name, least)), seconds(peer)] if timed else None}


def main():
    katydid, name = sys.argv[1:]
    row = next(row for row in definitions.ROWS if row.name == name)
    print(json.dumps(judge(katydid, row)))


if __name__ == "__main__":
    main()
