"""The npm package of the engine."""

from place import OUT, ROOT, VERSION, Missing, run


def make():
    """Packs what `make wasm` left."""
    if not (ROOT / "wasm" / "pkg" / "katydid_bg.wasm").exists():
        raise Missing("wasm/pkg is not there: `make wasm` builds it, in half an hour of a processor")
    run(ROOT / "studio" / "with-node", "npm", "pack", ROOT / "wasm", "--pack-destination", OUT)
    return [OUT / f"katydid-engine-{VERSION}.tgz"]
