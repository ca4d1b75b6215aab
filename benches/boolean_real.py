"""Cuts the solids of real .3dm files by boxes, cylinders and each other, beside Open CASCADE.

    make module                    # or an installed `katydid`
    python benches/boolean_real.py FOLDER [PAIRS] [SEED]
    python benches/boolean_real.py FOLDER PAIRS SEED --pairs OUT   # the pairs alone, an archive each, for `make cut-solids`

With cadquery-ocp (benches/work/requirements.txt). FOLDER holds .3dm files; PAIRS is how many pairs are tried (2000), SEED
where the random numbers start (1). For each pair the common part and the difference are asked of both kernels. Where both
answer, and their volumes are apart by more than 1e-4 of the smaller operand's and twice the model's tolerance times its area, points inside the box that both operands have
in common tell who is right: how many lie in both, by their place in each operand alone. Each disagreement is printed with
its verdict. The exit status is 1 when Katydid's volume is outside of what the points allow.

Open CASCADE works in a process of its own that is ended after a minute: some pairs never end there.
"""

import math
import multiprocessing
import pathlib
import random
import statistics
import sys
import tempfile
import time

import katydid

# Volumes agree within this part of the smaller operand's, beside what the tolerance allows.
AGREE = 1e-4
# Points for the verdict; the volume that they tell is off by more than four deviations once in 16,000 times.
POINTS = 20_000
DEVIATIONS = 4.0
SECONDS = 60
# Solids with more faces are left out: a pair of them takes minutes in Open CASCADE.
MOST_FACES = 200


def others(jobs, answers):
    """Open CASCADE: pairs of STEP files in; volumes and seconds out, or words where it has no answer."""
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common, BRepAlgoAPI_Cut
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps
    from OCP.IFSelect import IFSelect_RetDone
    from OCP.STEPControl import STEPControl_Reader

    def read(path):
        reader = STEPControl_Reader()
        if reader.ReadFile(path) != IFSelect_RetDone:
            raise ValueError("the STEP file is not read")
        reader.TransferRoots()
        return reader.OneShape()

    def volume(shape):
        found = GProp_GProps()
        # Without a bound of its own the error reaches a hundredth on trimmed splines.
        BRepGProp.VolumeProperties_s(shape, found, 1e-6, False, False)
        return found.Mass()

    while True:
        pair = jobs.get()
        try:
            first, second = (read(path) for path in pair)
            out = {"operands": [volume(first), volume(second)]}
            for name, operation in (("common", BRepAlgoAPI_Common), ("difference", BRepAlgoAPI_Cut)):
                start = time.perf_counter()
                made = operation(first, second)
                seconds = time.perf_counter() - start
                sound = made.IsDone() and BRepCheck_Analyzer(made.Shape()).IsValid()
                out[name] = (volume(made.Shape()), seconds) if sound else "not sound"
            answers.put(out)
        except Exception as why:  # whatever it is, the next pair is asked
            answers.put({"error": str(why)})


class Other:
    """The process of the other kernel, started again when it does not answer."""

    def __init__(self):
        self.start()

    def start(self):
        context = multiprocessing.get_context("spawn")
        self.jobs, self.answers = context.Queue(), context.Queue()
        self.process = context.Process(target=others, args=(self.jobs, self.answers), daemon=True)
        self.process.start()

    def ask(self, pair):
        self.jobs.put(pair)
        end = time.monotonic() + SECONDS
        while time.monotonic() < end:
            try:
                return self.answers.get(timeout=0.5)
            except Exception:
                if not self.process.is_alive():
                    break
        self.process.kill()
        self.process.join()
        self.start()
        return {"error": "no answer in a minute, or the process fell"}


def solids_of(folder):
    """The valid solids of all files, with their names and the tolerances of their models."""
    out = []
    for path in sorted(pathlib.Path(folder).glob("*.3dm")):
        try:
            model = katydid.read(str(path))
        except katydid.KatydidError:
            continue
        for place, item in enumerate(model.geometry):
            if isinstance(item, katydid.Brep) and item.is_valid and item.is_solid and item.face_count <= MOST_FACES:
                out.append((f"{path.stem[:48]}#{place}", item, model.tolerance))
    return out


def corners(brep):
    box = brep.bounding_box
    return list(box.min), list(box.max)


def turned(rng):
    """A random direction."""
    while True:
        way = [rng.uniform(-1, 1) for _ in range(3)]
        if 0.1 < math.hypot(*way) <= 1:
            return way


def tool(rng, brep, all_solids):
    """A box, a cylinder or another solid that reaches into a solid's box."""
    low, high = corners(brep)
    size = [b - a for a, b in zip(low, high)]
    at = [rng.uniform(a, b) for a, b in zip(low, high)]
    kind = rng.choice(["box", "upright box", "cylinder", "solid"])
    if kind == "solid":
        name, other, _ = rng.choice(all_solids)
        from_low, from_high = corners(other)
        middle = [(a + b) / 2 for a, b in zip(from_low, from_high)]
        factor = rng.uniform(0.5, 1.2) * max(size) / max(b - a for a, b in zip(from_low, from_high))
        moved = (katydid.Transform.translation([p - m for p, m in zip(at, middle)])
                 @ katydid.Transform.rotation(rng.uniform(0, 6), turned(rng), middle)
                 @ katydid.Transform.scale(factor, middle))
        return name, moved @ other
    length = rng.uniform(0.2, 0.9) * max(size)
    if kind == "cylinder":
        plane = katydid.Plane(at, normal=turned(rng)) if rng.random() < 0.7 else katydid.Plane(at)
        return kind, katydid.cylinder(plane, 0.3 * length, length)
    square = katydid.Curve.polyline([
        [at[0] - length / 2, at[1] - length / 2, at[2]], [at[0] + length / 2, at[1] - length / 2, at[2]],
        [at[0] + length / 2, at[1] + length / 2, at[2]], [at[0] - length / 2, at[1] + length / 2, at[2]],
        [at[0] - length / 2, at[1] - length / 2, at[2]]])
    box = katydid.extrude(square, [0, 0, length], capped=True)
    return kind, box if kind == "upright box" else katydid.Transform.rotation(rng.uniform(0, 6), turned(rng), at) @ box


def ours(first, second, tolerance):
    """Volumes and seconds by name, or the words of the refusal."""
    out = {}
    for name, call in (("common", first.intersection), ("difference", first.difference)):
        start = time.perf_counter()
        try:
            made = call(second, tolerance)
            seconds = time.perf_counter() - start
            out[name] = (sum(part.volume for part in made), seconds)
        except katydid.KatydidError as why:
            out[name] = str(why)
    return out


def seen(rng, first, second):
    """The volume that both have in common, as random points tell it, and its deviation."""
    a, b = corners(first), corners(second)
    low = [max(p, q) for p, q in zip(a[0], b[0])]
    high = [min(p, q) for p, q in zip(a[1], b[1])]
    if any(p >= q for p, q in zip(low, high)):
        return 0.0, 0.0
    hits = 0
    for _ in range(POINTS):
        p = [rng.uniform(x, y) for x, y in zip(low, high)]
        hits += first.contains(p, 1e-9) > 0 and second.contains(p, 1e-9) > 0
    share = hits / POINTS
    whole = math.prod(y - x for x, y in zip(low, high))
    return whole * share, whole * math.sqrt(max(share * (1 - share), 1 / POINTS) / POINTS)


def written(rng, solids, pairs, out):
    """Writes pairs of solids, an archive each, with the tolerance of the first one's model."""
    out = pathlib.Path(out)
    out.mkdir(parents=True, exist_ok=True)
    for number in range(pairs):
        _, first, tolerance = rng.choice(solids)
        _, second = tool(rng, first, solids)
        katydid.write(str(out / f"{number:04}.3dm"), [first, second], tolerance=tolerance)


def main():
    folder = sys.argv[1]
    pairs = int(sys.argv[2]) if len(sys.argv) > 2 else 2000
    rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    solids = solids_of(folder)
    if not solids:
        sys.exit("no solids in the folder")
    print(f"{len(solids)} solids", flush=True)
    if len(sys.argv) > 5 and sys.argv[4] == "--pairs":
        written(rng, solids, pairs, sys.argv[5])
        return
    other = Other()
    counts, reasons, ratios = {}, {}, []
    wrong = False

    def count(what):
        counts[what] = counts.get(what, 0) + 1

    with tempfile.TemporaryDirectory() as scratch:
        paths = [str(pathlib.Path(scratch) / name) for name in ("a.step", "b.step")]
        for number in range(pairs):
            name, first, tolerance = rng.choice(solids)
            kind, second = tool(rng, first, solids)
            least = min((first, second), key=lambda brep: brep.volume)
            near = AGREE * least.volume + 2 * tolerance * least.area
            mine = ours(first, second, tolerance)
            for path, brep in zip(paths, (first, second)):
                katydid.write(path, [brep])
            theirs = other.ask(paths)
            for operation in ("common", "difference"):
                own, its = mine[operation], theirs.get(operation, theirs.get("error"))
                if isinstance(own, str):
                    count("refused by Katydid" + (", and by Open CASCADE" if isinstance(its, str) else ""))
                    reason = own.split(":")[1].strip() if own.startswith("boolean refused") else own[:60]
                    reasons[reason] = reasons.get(reason, 0) + 1
                    print(f"{number}: {name} and {kind}, {operation}: {own}", flush=True)
                    continue
                # The volume in common is what a difference takes away.
                shared = own[0] if operation == "common" else first.volume - own[0]
                theirs_shared = None
                if not isinstance(its, str):
                    theirs_shared = its[0] if operation == "common" else theirs["operands"][0] - its[0]
                    if abs(shared - theirs_shared) <= near:
                        count("agree")
                        ratios.append(own[1] / its[1])
                        continue
                volume, deviation = seen(random.Random(number), first, second)
                right = abs(shared - volume) <= DEVIATIONS * deviation + near
                if theirs_shared is None:
                    count("Katydid alone, right by points" if right else "Katydid alone, wrong by points")
                else:
                    fits = abs(theirs_shared - volume) <= DEVIATIONS * deviation + near
                    count(f"disagree: Katydid {'right' if right else 'WRONG'}, Open CASCADE {'right' if fits else 'wrong'}")
                wrong |= not right
                print(f"{number}: {name} and {kind}, {operation}: {own[0]:.9g}, Open CASCADE {its}; in common "
                      f"{shared:.6g}, by points {volume:.6g} ± {deviation:.2g}", flush=True)
            if number % 100 == 99:
                print(f"{number + 1} pairs: {counts}", flush=True)
    for what, times in sorted(counts.items()):
        print(f"{times:6} {what}")
    for reason, times in sorted(reasons.items(), key=lambda r: -r[1]):
        print(f"{times:6} refused: {reason}")
    if ratios:
        print(f"seconds, Katydid / Open CASCADE: median {statistics.median(ratios):.2f}, "
              f"a tenth below {sorted(ratios)[len(ratios) // 10]:.2f}, a tenth above {sorted(ratios)[9 * len(ratios) // 10]:.2f}")
    sys.exit(wrong)


if __name__ == "__main__":
    main()
