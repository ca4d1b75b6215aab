"""Writes what the wheel has of licences: THIRD-PARTY, those of all that is linked into it, with their texts; beside it
copies of the two that Katydid itself is under.

    python third_party.py [FILE]

Asks cargo, without the network, which crates the extension module is made of, and copies the texts that their archives
have. A crate whose archive has no text is named with its authors. `make wheel` runs it.
"""

import json
import os
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
#: The licences of the project itself.
OWN = ("LICENSE-APACHE", "LICENSE-MIT")
#: How files of licences begin.
WORDS = ("license", "licence", "copying", "copyright", "notice", "unlicense")
#: A text has more characters than this.
SHORTEST = 200


def cargo(*words):
    """What cargo prints."""
    return subprocess.run([os.environ.get("CARGO", "cargo"), *words], cwd=ROOT, stdout=subprocess.PIPE, check=True,
                          universal_newlines=True).stdout


def linked(crate):
    """Names and versions of the crates that one of ours is linked with: neither what builds it nor what tests it."""
    lines = cargo("tree", "--offline", "--locked", "-p", crate, "-e", "normal", "--prefix", "none",
                  "--format", "{p}").splitlines()
    words = [line.split() for line in lines if line.strip()]
    return {(line[0], line[1].lstrip("v")) for line in words}


def packages(crate="katydid-python"):
    """The crates that are not of this workspace, sorted."""
    known = json.loads(cargo("metadata", "--offline", "--locked", "--format-version", "1"))
    wanted = linked(crate)
    found = [one for one in known["packages"] if (one["name"], one["version"]) in wanted and one["source"]]
    return sorted(found, key=lambda one: (one["name"], one["version"]))


def page():
    """The npm packages that the studio's page is built of, which the program takes in; none where they are not installed."""
    with open(os.path.join(ROOT, "studio", "package-lock.json"), encoding="utf-8") as file:
        locked = json.load(file)["packages"]
    found = []
    for path, one in sorted(locked.items()):
        folder = os.path.join(ROOT, "studio", *path.split("/"))
        if path and not one.get("dev") and "@types/" not in path and os.path.isdir(folder):
            found.append({"name": path.split("node_modules/")[-1], "version": one["version"], "source": "npm",
                          "license": one.get("license"), "authors": [], "manifest_path": os.path.join(folder, "package.json")})
    return found


def texts(package):
    """The texts of a package's archive, by the names of their files."""
    folder = os.path.dirname(package["manifest_path"])
    found = {}
    for name in sorted(os.listdir(folder)):
        path = os.path.join(folder, name)
        if name.lower().startswith(WORDS) and os.path.isfile(path) and not name.endswith((".rs", ".toml", ".html")):
            with open(path, encoding="utf-8", errors="replace") as file:
                text = file.read().replace("\r\n", "\n").strip()
            # Some archives have the path of a text above their folder, which is not in them.
            if len(text) > SHORTEST:
                found[name] = text
    return found


def common(package):
    """The text of a licence whose words are the same for all, for a package without one."""
    name = "LICENSE-APACHE" if "Apache-2.0" in package["license"] else "LICENSE-MIT"
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        text = file.read().strip()
    if name == "LICENSE-MIT":
        # Its first lines name the holder.
        holder = "Copyright (c) %s" % (", ".join(name.split(" <")[0] for name in package["authors"]) or "the authors of %s" % package["name"])
        text = "\n".join(holder if line.startswith("Copyright") else line for line in text.split("\n"))
    return {name: text}


def document(what, crates, npm=()):
    """The whole text: the packages with their licences, then each text once with the packages that have it."""
    parts = ["Katydid's %s is linked with the crates below%s. Their licences follow."
             % (what, ", and its page is built of the npm packages after them" if npm else ""), ""]
    holders = {}
    found = [*crates, *npm]
    for one in found:
        licence = one["license"] or "see its text"
        own = texts(one)
        note = "" if own else "; its archive has no text; by %s" % (", ".join(one["authors"]) or "its authors")
        if not own and "Apache-2.0" in licence:
            own = common(one)
        if not own:
            # Of the same authors under the same licence: the text of their other crate is the one.
            kin = (texts(other) for other in found
                   if one["authors"] and (other["authors"], other["license"]) == (one["authors"], licence))
            own = next((text for text in kin if text), {})
        if not own and "MIT" in licence:
            own = common(one)
        parts.append("%s %s: %s%s" % (one["name"], one["version"], licence, note))
        for text in own.values():
            holders.setdefault(text, []).append("%s %s" % (one["name"], one["version"]))
    for text, names in sorted(holders.items(), key=lambda pair: pair[1]):
        parts += ["", "=" * 80, ", ".join(sorted(set(names))), "=" * 80, "", text]
    return "\n".join(parts) + "\n"


def main():
    target = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "python", "katydid", "THIRD-PARTY")
    found, npm = packages(), page()
    with open(target, "w", encoding="utf-8") as file:
        file.write(document("extension module", found, npm))
    for name in OWN:
        shutil.copyfile(os.path.join(ROOT, name), os.path.join(os.path.dirname(os.path.abspath(target)), name))
    print("%s: %d crates, %d npm packages" % (target, len(found), len(npm)))


if __name__ == "__main__":
    main()
