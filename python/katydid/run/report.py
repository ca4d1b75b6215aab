"""Errors of a script in the words of Grasshopper, with the line."""

import linecache
import traceback

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


def show_source(code):
    """Lets Python's own tracebacks show the script's lines."""
    global _shown
    if code == _shown:
        return
    _shown = code
    linecache.cache[SCRIPT] = (len(code), None, code.splitlines(True), SCRIPT)
