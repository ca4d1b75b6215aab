"""Katydid's answer of a row, and whether it is the peer's."""

import json
import re
import subprocess
from pathlib import Path

LABEL = re.compile(r"^(\w+) = ", re.MULTILINE)


def inside_cluster(row, n):
    """The definition with its checks in a cluster whose outputs are the checks, so that nothing else is printed."""
    labels = LABEL.findall(row.checks())
    outputs = "".join(f"out {label} = Cluster Output({label})\n" for label in labels)
    inner = row.definition(n) + row.checks() + outputs
    return f"katydid 1\nw = Cluster() -> {', '.join('out ' + label for label in labels)} inside {{\n{inner}}}\n"


def answer(katydid, row, n, folder):
    """The values of each label, those of all branches behind one another; points as their coordinates."""
    file = Path(folder) / "checked.kd"
    file.write_text(inside_cluster(row, n))
    command = [katydid, "run", file, "--json=values", "--threads", "1"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise ValueError(done.stderr.strip().splitlines()[0])
    outputs = json.loads(done.stdout)["objects"][0]["outputs"]
    return {output["name"].removeprefix("out "): flat(output["branches"]) for output in outputs}


def saved(katydid, row, n, folder, read):
    """What the peer reads in the file that the row writes."""
    file = Path(folder) / "saved.kd"
    file.write_text("katydid 1\n" + row.definition(n))
    written = file.with_suffix("." + row.saves)
    subprocess.run([katydid, "run", file, "--threads", "1", "-o", written], check=True, capture_output=True)
    return read(str(written))


def flat(branches):
    items = [item for branch in branches for item in branch["items"]]
    return [one for item in items for one in (item if isinstance(item, list) else [item])]


def difference(row, ours, theirs):
    """How the answers differ, in words; None where they do not."""
    if set(ours) != set(theirs):
        return f"answers to {sorted(ours)} and {sorted(theirs)}"
    for label, ours_of in ours.items():
        theirs_of = theirs[label]
        if len(ours_of) != len(theirs_of):
            return f"{label}: {len(ours_of)} values and not {len(theirs_of)}"
        first = unequal(ours_of, theirs_of, row.within)
        if first is not None:
            return f"{label}: {ours_of[first]} and not {theirs_of[first]} (value {first} of {len(ours_of)})"
    return None


def unequal(ours, theirs, within):
    """Where the first value is that differs by more than is allowed."""
    if any(isinstance(one, str) for one in theirs):
        return next((i for i, (a, b) in enumerate(zip(ours, theirs)) if a != b), None)
    allowed = within * max((abs(one) for one in theirs), default=0)
    same = (isinstance(a, (int, float)) and abs(a - b) <= allowed for a, b in zip(ours, theirs))
    return next((i for i, one in enumerate(same) if not one), None)
