"""`katydid sweep --ray ADDRESS`, and the same with Dask: `python -m katydid.studies --engine dask --address HOST:PORT -- WORDS`."""

import argparse
import sys
import time

#: The words of `katydid sweep` that this end looks at.
_FOLDER = ("-o", "--output")
#: The line changes at most this often, in seconds.
_PAUSE = 0.2


def main(words=None):
    """Solves the points of a sweep on a cluster; gives the exit code, as `katydid sweep` has it."""
    words = sys.argv[1:] if words is None else words
    parser = argparse.ArgumentParser(prog="python -m katydid.studies", description="Solves the points of `katydid sweep` on a cluster.")
    parser.add_argument("--engine", choices=["ray", "dask"], required=True)
    parser.add_argument("--address", help="of the cluster: auto, local, or what Ray or Dask take")
    parser.add_argument("words", nargs="*", help="the words of `katydid sweep`, behind --")
    asked = parser.parse_args(words)
    from .._katydid import KatydidError
    from .study import Study
    try:
        workers, rest = _workers(asked.words)
        study = Study(rest, _folder(rest), True)
        summary = study.run(asked.engine, workers=workers, address=asked.address, progress=_Line())
    except KatydidError as error:
        _say("\033[K" if sys.stderr.isatty() else "", "katydid: %s" % error)
        return 2
    except KeyboardInterrupt:
        _say("katydid: stopped; the same command goes on where it stopped")
        return 2
    rate = ", %.0f points a second" % (summary.solved / summary.seconds) if summary.solved and summary.seconds else ""
    _say("%d points: %d solved now, %d known before, %.1f s%s"
         % (summary.points, summary.solved, summary.had, summary.seconds, rate))
    if summary.failed:
        _say("%d without results: failed.csv says why" % summary.failed)
    return 1 if summary.failed else 0


def _workers(words):
    """How many workers the words of the sweep ask for; without that word, since the cluster has them, not this machine."""
    for at, word in enumerate(words):
        if word == "--workers" and at + 1 < len(words) and words[at + 1].isdigit():
            return int(words[at + 1]), words[:at] + words[at + 2:]
        if word.startswith("--workers=") and word[10:].isdigit():
            return int(word[10:]), words[:at] + words[at + 1:]
    return None, words


def _folder(words):
    for at, word in enumerate(words):
        if word in _FOLDER and at + 1 < len(words):
            return words[at + 1]
        if word.startswith("--output="):
            return word[len("--output="):]
    return ""


class _Line:
    """A line on a terminal with how far it has come."""

    def __init__(self):
        self.shown = 0.0

    def __call__(self, now):
        if not sys.stderr.isatty() or time.monotonic() - self.shown < _PAUSE:
            return
        self.shown = time.monotonic()
        failed = ", %d failed" % now.failed if now.failed else ""
        sys.stderr.write("\r\033[K%d of %d%s" % (now.had + now.solved, now.points, failed))
        sys.stderr.flush()


def _say(*parts):
    sys.stderr.write("".join(parts) + "\n")


if __name__ == "__main__":
    sys.exit(main())
