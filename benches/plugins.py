"""Which objects of plug-ins in a folder of definitions do not run, and how many files each plug-in keeps from running whole.

    python benches/plugins.py PROGRAM FOLDER

PROGRAM is `katydid`. Prints for each plug-in the objects that are not supported and the files that lack nothing but it; then the
files that would run whole but for a few objects, those that lack least first.
"""

import collections
import json
import subprocess
import sys

FEW = 5
"""Files that lack more objects than this are not listed."""


def checked(program, folder):
    """What `katydid check` says of each file that it can open."""
    answer = subprocess.run([program, "check", "--json", folder], capture_output=True, text=True)
    if answer.returncode not in (0, 1, 2) or not answer.stdout:
        sys.exit(answer.stderr or f"{program} check failed")
    return [entry for entry in json.loads(answer.stdout) if "error" not in entry]


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    files = checked(sys.argv[1], sys.argv[2])
    objects, only = collections.Counter(), collections.Counter()
    near = []
    for entry in files:
        missing = entry["unsupported"]
        for kind in missing:
            if kind["plugin"]:
                objects[kind["plugin"]] += kind["count"]
        plugins = {kind["plugin"] for kind in missing}
        if len(plugins) == 1 and None not in plugins:
            only[plugins.pop()] += 1
        count = sum(kind["count"] for kind in missing)
        if 0 < count <= FEW and None not in {kind["plugin"] for kind in missing}:
            near.append((count, entry["file"], [kind["name"] for kind in missing]))
    whole = sum(entry["runnable"] for entry in files)
    print(f"{len(files)} files, {whole} run whole; {sum(objects.values())} objects of plug-ins are not supported")
    for plugin, count in sorted(objects.items(), key=lambda pair: (-only[pair[0]], -pair[1], pair[0])):
        print(f"{count:6} objects, {only[plugin]:4} files lack only this: {plugin}")
    for count, file, names in sorted(near):
        print(f"{count:6} missing in {file}: {', '.join(names)}")


if __name__ == "__main__":
    main()
