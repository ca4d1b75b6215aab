"""Errors of a script in the words of Grasshopper, with the line."""

import linecache
import traceback

try:
    import resource
except ImportError:  # pragma: no cover - systems without limits of processes
    resource = None

from ..rhino import NAMES as OURS

#: The name under which scripts are compiled.
SCRIPT = "<script>"

_shown = None


def line_of(error):
    """The line of the script at which an exception came up; -1 where it did not pass through the script."""
    if isinstance(error, SyntaxError) and error.filename in (SCRIPT, "<unknown>", None):
        return error.lineno or -1
    lines = [line for name, line, _ in frames(error) if name == SCRIPT]
    return lines[-1] if lines else -1


def frames(error):
    """File, line and function of each step of a traceback."""
    return [(frame.f_code.co_filename, line, frame.f_code.co_name)
            for frame, line in traceback.walk_tb(error.__traceback__)]


def describe(error, advise=None):
    """The text: kind and message, then the lines of the script that led there.

    `advise` is asked for the command that installs a module that could not be found.
    """
    kind, text = type(error).__name__, str(error)
    if isinstance(error, SyntaxError):
        where = "line %s" % error.lineno if error.lineno else ""
        return "Syntax error: %s%s" % (error.msg or text, " (%s)" % where if where else "")
    if kind == "HostError":
        kind = "Katydid"
    if isinstance(error, MemoryError) and not text:
        text = _too_much_memory()
    lines = ["Runtime error (%s): %s" % (kind, text)]
    if advise is not None and isinstance(error, ModuleNotFoundError) and error.name and \
            error.name.partition(".")[0] not in OURS:
        lines.append(advise(error.name))
    steps = [(line, name) for file, line, name in frames(error) if file == SCRIPT]
    if steps:
        lines += ["", "Traceback:"]
        # Deep recursion repeats itself: its two ends say enough.
        if len(steps) > 12:
            steps = steps[:6] + [None] + steps[-6:]
        for step in steps:
            lines.append("  ..." if step is None else "  line %d, in %s" % (
                step[0], "script" if step[1] == "<module>" else step[1]))
    return "\n".join(lines)


def _too_much_memory():
    """What Python itself says nothing of: the limit that was reached, in megabytes."""
    most = resource.getrlimit(resource.RLIMIT_AS)[0] if resource else -1
    limited = "the scripts of a definition may take %d MB together (--script-memory)" % (most >> 20)
    return limited if 0 < most < 1 << 50 else "there is no memory left"


def show_source(code):
    """Lets Python's own tracebacks show the script's lines."""
    global _shown
    if code == _shown:
        return
    _shown = code
    linecache.cache[SCRIPT] = (len(code), None, code.splitlines(True), SCRIPT)
