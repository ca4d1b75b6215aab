"""The command `katydid`, as `python -m katydid` and as the script of that name."""

import signal
import sys


def main():
    from ._katydid import run_command
    # Python would only note Ctrl+C, and see to it when the command has ended.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return run_command(["katydid"] + sys.argv[1:], sys.executable)


if __name__ == "__main__":
    sys.exit(main())
