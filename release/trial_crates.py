"""The crates as they were packaged, built into a program that is not of this workspace."""

import json
import os
import subprocess
import tarfile

import expected
from place import OUT, ROOT, VERSION, Missing
from trial_program import radii

MAIN = """\
use katydid_definition::document::Document;
use katydid_definition::archive::Limits;
use katydid_session::{Items, Session};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    katydid_components::link();
    let document = Document::read(&std::fs::read("attractor.ghx")?, &Limits::default())?;
    let mut session = Session::new(document, Default::default());
    session.set("columns", "20")?;
    session.set("attractor x", "80")?;
    session.solve();
    println!("{}", serde_json::to_string(&session.report_with(Items::Values))?);
    Ok(())
}
"""


def run(folder):
    """Unpacks them, and lets a package of its own take them in place of those of crates.io."""
    archives = sorted((OUT / "crates").glob("*.crate"))
    if not archives:
        raise Missing("there are no crates")
    for file in archives:
        with tarfile.open(file) as packed:
            packed.extractall(folder / "crates", filter="data")
    names = [file.name.removesuffix(f"-{VERSION}.crate") for file in archives]
    package = folder / "package"
    (package / "src").mkdir(parents=True)
    (package / "src/main.rs").write_text(MAIN, encoding="utf-8")
    (package / "attractor.ghx").write_bytes((ROOT / "examples/attractor.ghx").read_bytes())
    needs = "".join(f'{name} = "{VERSION}"\n' for name in names)
    patches = "".join(f'{name} = {{ path = "../crates/{name}-{VERSION}" }}\n' for name in names)
    (package / "Cargo.toml").write_text(
        f'[package]\nname = "trial"\nversion = "0.0.0"\nedition = "2024"\n\n[dependencies]\nserde_json = "1"\n{needs}\n'
        f"[patch.crates-io]\n{patches}\n[profile.dev]\ndebug = false\nincremental = false\n", encoding="utf-8")
    # The same versions of other people's crates as here: they were fetched already.
    head, *blocks = (ROOT / "Cargo.lock").read_text(encoding="utf-8").split("[[package]]\n")
    lock = "[[package]]\n".join([head, *(block for block in blocks if not block.startswith('name = "katydid'))])
    (package / "Cargo.lock").write_text(lock, encoding="utf-8")
    given = {name: value for name, value in os.environ.items() if name not in ("CARGO_TARGET_DIR", "RUSTFLAGS")}
    # What is built is kept for the next time, outside of the folder that goes away.
    given["CARGO_TARGET_DIR"] = str(ROOT / "target" / "trial")
    done = subprocess.run(["cargo", "run", "--quiet"], cwd=package, env=given, stdout=subprocess.PIPE, text=True)
    if done.returncode:
        raise RuntimeError("the packaged crates do not build into a program, see above")
    wrong = expected.compare(radii(json.loads(done.stdout)), columns=20, at=(80.0, 55.0))
    if wrong:
        raise RuntimeError(wrong)
    return f"{len(names)} crates built from their archives; 210 radii are those of the formula"
