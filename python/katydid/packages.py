"""Packages that a script asks for, and what to do when one is missing."""

import re
from importlib import metadata

#: Modules whose package has another name on PyPI.
NAMES = {"cv2": "opencv-python-headless", "PIL": "Pillow", "sklearn": "scikit-learn", "skimage": "scikit-image",
         "yaml": "PyYAML", "bs4": "beautifulsoup4", "OCC": "compas-occt", "ladybug": "ladybug-core",
         "ladybug_geometry": "ladybug-geometry", "ladybug_rhino": "ladybug-rhino", "ladybug_comfort": "ladybug-comfort",
         "honeybee": "honeybee-core", "honeybee_energy": "honeybee-energy", "honeybee_radiance": "honeybee-radiance",
         "dragonfly": "dragonfly-core", "dateutil": "python-dateutil", "Crypto": "pycryptodome", "serial": "pyserial"}

_LINES = re.compile(r"^[ \t]*#[ \t]*(?:r|requirements)[ \t]*:[ \t]*(.+)$", re.M)
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")


def asked(code):
    """The packages of lines such as `# r: numpy, scipy==1.10`."""
    found = []
    for line in _LINES.findall(code):
        found += [part.strip() for part in line.split(",") if part.strip()]
    return found


def plain_name(requirement):
    """The name of a package or a module in one form, without a version."""
    name = _NAME.match(requirement)
    return re.sub(r"[-_.]+", "-", name.group()).lower() if name else ""


def is_installed(requirement):
    """Whether a package is there, in whatever version."""
    name = _NAME.match(requirement)
    if name is None:
        return False
    try:
        metadata.distribution(name.group())
        return True
    except (metadata.PackageNotFoundError, OSError, ValueError):
        return False


def missing(code):
    """The packages that a script's lines ask for and that are not installed."""
    return [one for one in asked(code) if not is_installed(one)]


def advice(module, code, path):
    """The command that installs what a script could not import."""
    top = module.partition(".")[0]
    wanted = missing(code) or [NAMES.get(top, top)]
    words = " ".join('"%s"' % one if re.search(r"[^\w.-]", one) else one for one in wanted)
    beside = " --file %s" % ('"%s"' % path if " " in path else path) if path else ""
    return "to install it: katydid python add %s%s" % (words, beside)
