"""scriptcontext: the document of a solve, and what scripts keep between solves."""

from katydid import document as _document

#: Lives as long as the worker.
sticky = _document.STICKY
#: 2 says that the script runs in Grasshopper.
id = 2
errorhandler = None
#: The document that rhinoscriptsyntax works on. A script may set it; before each run it is the solve's own.
doc = _document.active()


def localize(text):
    return text


def escape_test(throw_exception=True, reset=False):
    """Whether the user wants to stop. The host interrupts a script by itself, so there is nothing to ask."""
    return False
