"""Lets the kernel refuse what a script may not do with files, other programs and the network: Landlock, on Linux from 5.13.

It is asked for from inside the process, before a script runs: namespaces have to be made first, which writes files in
`/proc` that a script must not reach. What is refused stays refused for good, for whatever code runs in here.
Source: linux/Documentation/userspace-api/landlock.rst; the numbers of the calls are those of every architecture.
"""

import os
import sys

CREATE_RULESET, ADD_RULE, RESTRICT_SELF = 444, 445, 446
PR_SET_NO_NEW_PRIVS = 38
RULE_PATH_BENEATH = 1
O_PATH = getattr(os, "O_PATH", 0)

WRITE_FILE, READ_FILE, READ_DIR, TRUNCATE, IOCTL_DEVICE = 1 << 1, 1 << 2, 1 << 3, 1 << 14, 1 << 15
# Removing, making folders, files and links, and moving them; sockets, pipes and devices are not made.
CHANGE = 1 << 4 | 1 << 5 | 1 << 7 | 1 << 8 | 1 << 12 | 1 << 13
READ = READ_FILE | READ_DIR
WRITE = READ | WRITE_FILE | CHANGE | TRUNCATE

#: What the loader of shared libraries and Python itself read beyond Python's folders.
SYSTEM = ("/lib", "/lib64", "/usr/lib", "/usr/lib64", "/usr/local/lib", "/etc/ld.so.cache", "/etc/localtime",
          "/usr/share/zoneinfo", "/proc/self", "/proc/cpuinfo", "/proc/meminfo", "/sys/devices/system/cpu")
DEVICES = ("/dev/null", "/dev/zero", "/dev/random", "/dev/urandom")


def rights(version):
    """The rights over files that a version of Landlock knows."""
    return (1 << {1: 13, 2: 14, 3: 15, 4: 15}.get(version, 16)) - 1


def restrict(readable, work, network):
    """Refuses everything but reading `readable` and the system's libraries, and writing in `work`.

    Gives the version of Landlock that does it, 0 where there is none.
    """
    if not sys.platform.startswith("linux"):
        return 0
    try:
        import ctypes
        call = ctypes.CDLL(None, use_errno=True).syscall
        prctl = ctypes.CDLL(None, use_errno=True).prctl
    except (ImportError, OSError, AttributeError):
        return 0
    call.restype = ctypes.c_long

    def asked(number, *words):
        return call(ctypes.c_long(number), *words)

    none = ctypes.c_void_p(None)
    version = asked(CREATE_RULESET, none, ctypes.c_size_t(0), ctypes.c_uint32(1))
    if version < 1:
        return 0
    handled = rights(version)
    # TCP: binding and connecting. Then sockets without a name in the file system, and signals, to others than itself.
    words = [handled] + [0 if network else 3] * (version >= 4) + [3] * (version >= 6)
    attributes = (ctypes.c_uint64 * len(words))(*words)
    ruleset = asked(CREATE_RULESET, attributes, ctypes.c_size_t(8 * len(words)), ctypes.c_uint32(0))
    if ruleset < 0:
        return 0

    def allow(path, access):
        try:
            place = os.open(path, O_PATH | os.O_CLOEXEC)
        except OSError:
            return
        try:
            if not os.path.isdir(path):
                access &= READ_FILE | WRITE_FILE | TRUNCATE | IOCTL_DEVICE
            # A packed struct: the rights, then the folder.
            rule = (access & handled).to_bytes(8, sys.byteorder) + place.to_bytes(4, sys.byteorder)
            asked(ADD_RULE, ctypes.c_int(ruleset), ctypes.c_int(RULE_PATH_BENEATH), rule, ctypes.c_uint32(0))
        finally:
            os.close(place)

    try:
        for path in tuple(readable) + SYSTEM:
            allow(path, READ)
        for path in DEVICES:
            allow(path, READ | WRITE_FILE)
        allow(work, WRITE)
        done = prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 and \
            asked(RESTRICT_SELF, ctypes.c_int(ruleset), ctypes.c_uint32(0)) == 0
        return version if done else 0
    finally:
        os.close(ruleset)
