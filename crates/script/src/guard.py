"""Refuses what a script may not do, by Python's audit events, before anything else is loaded.

This is a fence for scripts that mean no harm and for mistakes: code that calls the operating system past Python is held
by the limits of the process, and by Landlock and its namespaces where the system has them.
"""

import os
import sys

FOLDER = os.path.dirname(os.path.abspath(__file__))
WORK = os.path.join(FOLDER, "work")


def folders(paths):
    return tuple(sorted({os.path.realpath(path) for path in paths if path and os.path.isdir(path)}))


# Python itself, its packages, time zones, and our own sources may be read; the working folder may be written.
READABLE = folders([FOLDER, sys.prefix, sys.base_prefix, sys.exec_prefix, "/usr/share/zoneinfo"] + sys.path) \
    if sys.prefix != "/" else folders([FOLDER] + sys.path)
if "/usr" in READABLE:
    READABLE = folders([FOLDER, "/usr/lib", "/usr/local/lib", "/usr/share/zoneinfo"] + sys.path)
READABLE += tuple(path for path in os.environ.get("KATYDID_READ", "").split(os.pathsep) if path)
DEVICES = ("/dev/null", "/dev/urandom", "/dev/random", "/dev/zero")
NETWORK = os.environ.get("KATYDID_NETWORK") == "1"
WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND

# Starting or ending other programs.
PROGRAMS = ("os.fork", "os.forkpty", "os.exec", "os.posix_spawn", "os.spawn", "os.startfile", "os.system", "os.kill",
            "os.killpg", "pty.spawn", "subprocess.Popen")
# Changing files.
CHANGES = {"os.chmod": 1, "os.chown": 1, "os.link": 2, "os.mkdir": 1, "os.remove": 1, "os.rename": 2, "os.rmdir": 1,
           "os.symlink": 2, "os.truncate": 1, "os.utime": 1, "os.setxattr": 1, "os.removexattr": 1,
           "shutil.copyfile": 2, "shutil.move": 2, "shutil.rmtree": 1}
# Reading folders.
LISTS = ("os.listdir", "os.scandir", "os.walk", "os.fwalk", "glob.glob", "os.chdir")


def inside(path, roots, real=os.path.realpath, join=os.path.join):
    if isinstance(path, int):
        return True
    try:
        full = real(os.fsdecode(path))
    except (TypeError, ValueError):
        return False
    return any(full == root or full.startswith(root.rstrip(os.sep) + os.sep) for root in roots)


def refuse(what):
    raise PermissionError("a script may not %s here" % what)


def guard(event, arguments, busy=[]):
    if event == "open":
        path, mode, flags = arguments
        if path is None or busy:
            return
        busy.append(1)
        try:
            writes = bool((flags or 0) & WRITING) or isinstance(mode, str) and any(c in mode for c in "wax+")
            if isinstance(path, (str, bytes)) and os.fsdecode(path) in DEVICES or inside(path, (WORK,)):
                return
            if writes:
                refuse("write the file %s" % os.fsdecode(path))
            if not inside(path, READABLE):
                refuse("read the file %s" % os.fsdecode(path))
        finally:
            busy.pop()
    elif event.startswith("socket.") and not NETWORK:
        if event not in ("socket.gethostname", "socket.__new__"):
            refuse("use the network")
        if event == "socket.__new__":
            refuse("use the network")
    elif event in PROGRAMS:
        refuse("start or end other programs")
    elif event in CHANGES:
        for path in arguments[:CHANGES[event]]:
            if not inside(path, (WORK,)):
                refuse("change the file %s" % (path,))
    elif event in LISTS:
        path = arguments[0] if arguments and arguments[0] is not None else "."
        if event == "glob.glob":
            return
        if not busy and not inside(path, READABLE + (WORK,)):
            refuse("read the folder %s" % (path,))
    elif event.startswith("ctypes.dlopen") or event == "ctypes.dlsym":
        if event == "ctypes.dlopen" and arguments and arguments[0] is None:
            refuse("call the system's libraries")


def limit():
    """Limits of the process, where the launcher could not set them."""
    try:
        import resource
    except ImportError:
        return
    for name, key in (("RLIMIT_AS", "KATYDID_MEMORY"), ("RLIMIT_CPU", "KATYDID_SECONDS"),
                      ("RLIMIT_NOFILE", "KATYDID_FILES"), ("RLIMIT_FSIZE", "KATYDID_FILE_SIZE"),
                      ("RLIMIT_NPROC", "KATYDID_PROCESSES"), ("RLIMIT_CORE", "KATYDID_CORE")):
        value = os.environ.get(key)
        kind = getattr(resource, name, None)
        if not value or kind is None:
            continue
        hard = resource.getrlimit(kind)[1]
        most = int(value) if hard == resource.RLIM_INFINITY else min(int(value), hard)
        try:
            resource.setrlimit(kind, (most, most))
        except (ValueError, OSError):
            pass


def main():
    import runpy
    os.makedirs(WORK, exist_ok=True)
    os.chdir(WORK)
    limit()
    sys.path.insert(0, FOLDER)
    # The system's own fence, for what goes past Python. Where there is none, the audit events stand alone.
    from katydid.landlock import restrict
    restrict(READABLE, WORK, NETWORK)
    worker = os.path.join(FOLDER, "katydid", "worker.py")
    sys.argv = [worker]
    sys.addaudithook(guard)
    runpy.run_path(worker, run_name="__main__")


if __name__ == "__main__":
    main()
