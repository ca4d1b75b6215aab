"""The npm package in an empty folder."""

import json
import subprocess

import expected
from place import ROOT, only
from trial_program import radii

MAIN = """\
import { readFile } from "node:fs/promises";
import { open } from "katydid-engine";

const definition = await open(await readFile("attractor.ghx"));
const named = (name) => definition.inputs.find((input) => input.name === name).id;
definition.set(named("columns"), 20);
definition.set(named("attractor x"), 80);
definition.solve();
console.log(JSON.stringify(definition.report({ values: true })));
definition.close();
"""


def run(folder):
    """Installs it without the network, and compares the radii."""
    package = only("katydid-engine-*.tgz")
    (folder / "package.json").write_text('{"private": true, "type": "module"}', encoding="utf-8")
    (folder / "main.mjs").write_text(MAIN, encoding="utf-8")
    (folder / "attractor.ghx").write_bytes((ROOT / "examples/attractor.ghx").read_bytes())
    node = ROOT / "studio" / "with-node"
    inside = f'cd "{folder}"'
    subprocess.run([node, "sh", "-c", f'{inside} && npm install --offline --no-audit --no-fund --silent "{package}"'], check=True)
    done = subprocess.run([node, "sh", "-c", f"{inside} && node main.mjs"], check=True, stdout=subprocess.PIPE, text=True)
    wrong = expected.compare(radii(json.loads(done.stdout)), columns=20, at=(80.0, 55.0))
    if wrong:
        raise RuntimeError(wrong)
    return "210 radii are those of the formula"
