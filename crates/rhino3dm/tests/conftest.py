"""Ends the process as soon as the results are told."""

import os
import sys

status = 0


def pytest_sessionfinish(session, exitstatus):
    global status
    status = int(exitstatus)


def pytest_unconfigure(config):
    # When the interpreter ends, it frees models before the objects out of them, and rhino3dm crashes on that.
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)
