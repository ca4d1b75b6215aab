"""The image for containers, by deploy/image, which needs no daemon."""

import os

import program
from place import OUT, ROOT, VERSION, needed, run, told


def make():
    """An archive in the form of the Open Container Initiative: `podman load` and `docker load` take it."""
    needed("buildah", "`apt-get install buildah`; `docker build -f deploy/Containerfile` makes the same where docker is")
    name = f"localhost/katydid:{VERSION}"
    # No layers over a kernel's file system, and no namespaces: it is made where neither is allowed, too.
    given = {"STORAGE_DRIVER": "vfs", "BUILDAH_ISOLATION": "chroot", **os.environ}
    run(ROOT / "deploy/image", program.made(), name, env=given)
    machine = told("uname", "-m").strip()
    path = OUT / f"katydid-{VERSION}-image-{machine}.tar"
    path.unlink(missing_ok=True)
    run("buildah", "push", "-q", name, f"oci-archive:{path}:{name}", env=given)
    run("buildah", "rmi", name, env=given)
    return [path]
