"""Compares the signatures of RhinoCommon's members here with published stubs.

    pip download --no-deps rhino-stubs-typed; unzip it; KATYDID=... python measure_signatures.py FOLDER [--missing] [CLASS ...]

For each overload of the stubs: is there one here with as many parameters of the same kinds, and as many values in its
answer? Members of the host's table have kinds; those written in Python have names and numbers of parameters alone, and
count as "by number". A member agrees where one of its overloads does; all overloads are counted too.
"""

import ast
import inspect
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from katydid import rhino  # noqa: E402
from katydid.backend import current  # noqa: E402
from katydid.geometry.call import given  # noqa: E402
from measure_members import CLASSES, is_there  # noqa: E402

#: What every .NET object has, and what no script calls: disposal, serialisation, operators.
SKIP = {"Equals", "GetHashCode", "GetType", "ToString", "Finalize", "MemberwiseClone", "Dispose", "GetObjectData", "CompareTo",
        "EpsilonEquals", "NonConstOperation", "OnSwitchToNonConst", "ConstructConstObject"}

#: Kinds by the words of both sides.
NUMBERS = {"float": "number", "int": "whole", "bool": "truth", "str": "text", "Double": "number", "Single": "number",
           "Int32": "whole", "UInt32": "whole", "Int64": "whole", "Boolean": "truth", "String": "text", "Number": "number"}
#: Structs and enumerations that are handed over as another kind.
SAME = {"Point3f": "Point3d", "Vector3f": "Vector3d", "Point3dList": "list", "Guid": "Guid", "Object": "any", "Any": "any",
        "object": "any", "None": "nothing", "Void": "nothing", "CurveOnSurface": "Curve", "BrepLoop": "BrepLoop"}
#: Classes that stand for those that inherit from them.
CURVES = {"LineCurve", "ArcCurve", "PolylineCurve", "NurbsCurve", "PolyCurve", "BrepEdge", "BrepTrim", "CurveProxy"}
SURFACES = {"PlaneSurface", "NurbsSurface", "RevSurface", "SumSurface", "Extrusion", "SurfaceProxy"}


#: The names of enumerations, as the stubs have them.
ENUMS = {"Enum"}


def kind(text):
    """The kind of a type as either side writes it."""
    text = text.strip().strip("'\"")
    if text.rpartition(".")[2] in ENUMS:
        return "Enum"
    if text.endswith("[]"):
        return "list"
    head, _, inside = text.partition("[")
    head = head.rpartition(".")[2]
    if head in ("Iterable", "List", "Sequence", "Array", "IEnumerable", "IList", "Set"):
        return "list"
    if head in ("Optional", "Nullable", "Ref", "Out"):
        return kind(inside.rstrip("]"))
    if head in NUMBERS:
        return NUMBERS[head]
    head = SAME.get(head, head)
    return "Curve" if head in CURVES else "Surface" if head in SURFACES else head


def agree(a, b):
    """Whether two kinds may stand for each other: enumerations are numbers to one of the sides."""
    if a == b or "any" in (a, b):
        return True
    return {a, b} in ({"number", "whole"}, {"Enum", "whole"})


class Overload:
    """Kinds of parameters (None where only their number is known) and how many values come back."""

    def __init__(self, parameters, optional, results):
        self.parameters, self.optional, self.results = parameters, optional, results

    def fits(self, other):
        """Whether this one of ours does what one of the stubs says; `None` where only numbers can be compared."""
        count = len(other.parameters)
        if not len(self.parameters) - self.optional <= count <= len(self.parameters):
            return False
        if self.results is not None and other.results is not None and self.results != other.results:
            return False
        if any(own is None for own in self.parameters[:count]):
            return None
        return all(map(agree, self.parameters, other.parameters))


def stub_overloads(folder):
    """By class and member the overloads of the stubs; `__init__` is `new`."""
    with open(os.path.join(folder, "Rhino", "Geometry", "__init__.pyi"), encoding="utf-8") as source:
        tree = ast.parse(source.read())
    found = {}
    ENUMS.update(node.name for node in tree.body if isinstance(node, ast.ClassDef)
                 and any(ast.unparse(base).endswith("Enum") for base in node.bases))
    for node in tree.body:
        if not isinstance(node, ast.ClassDef):
            continue
        members = found.setdefault(node.name, {})
        for item in node.body:
            if not isinstance(item, ast.FunctionDef) or item.name in SKIP or item.name.startswith("op_"):
                continue
            if item.name.startswith("__") and item.name != "__init__":
                continue
            marks = {ast.unparse(mark) for mark in item.decorator_list}
            if any(mark.endswith(".setter") for mark in marks):
                continue
            words = [ast.unparse(word.annotation) if word.annotation else "Any" for word in item.args.args]
            words = words if "staticmethod" in marks else words[1:]
            back = ast.unparse(item.returns) if item.returns else "None"
            results = len(split(back[6:-1])) if back.startswith("tuple[") else 0 if back in ("None", "Void") else 1
            name = "new" if item.name == "__init__" else item.name
            members.setdefault(name, []).append(Overload([kind(word) for word in words], 0,
                                                         None if name == "new" or "property" in marks else results))
    return found


def split(text):
    """The parts of a list of types, commas within brackets left alone."""
    parts, depth, start = [], 0, 0
    for i, letter in enumerate(text):
        depth += (letter in "[(<") - (letter in "])>")
        if letter == "," and not depth:
            parts.append(text[start:i])
            start = i + 1
    return parts + [text[start:]]


def ours(cls, name):
    """Our overloads of a member: of the host's table, else of Python."""
    names = getattr(cls, "_names", None)
    found = []
    if names is not None:
        table = current().table
        for owner in (names() if name != "new" else names()[:1]):
            for text in table.signatures(owner, name) + table.signatures(owner, "get_" + name):
                inside = re.match(r"[^(]*\((.*)\)\s*->", text).group(1)
                words = [word.strip() for word in split(inside) if word.strip()]
                words = [word for word in words if not word.startswith("this ")]
                back = [part for part in given(text) if part != "Void"]
                found.append(Overload([kind(word.rpartition(" ")[0]) for word in words], 0, len(back)))
    for base in cls.__mro__:
        own = vars(base).get("__init__" if name == "new" else name)
        if own is None or base is object:
            continue
        function = own.__func__ if isinstance(own, (staticmethod, classmethod)) else own
        if not inspect.isfunction(function):
            # A property, a slot or a field: it takes nothing.
            found.append(Overload([], 0, None))
            break
        parameters = list(inspect.signature(function).parameters.values())
        parameters = parameters if isinstance(own, staticmethod) else parameters[1:]
        many = any(one.kind is one.VAR_POSITIONAL for one in parameters)
        plain = [one for one in parameters if one.kind is one.POSITIONAL_OR_KEYWORD]
        optional = sum(one.default is not one.empty for one in plain)
        found.append(Overload([None] * (len(plain) + 12 * many), optional + 12 * many, None))
        break
    return found


def measure(stubs, wanted):
    """By class: members, those present, those that agree in kinds, those that agree by number, and what is missing."""
    import Rhino.Geometry as geometry
    for name in wanted:
        cls, members = getattr(geometry, name, None), stubs.get(name, {})
        present = agreeing = by_number = 0
        missing, other = [], []
        for member, overloads in sorted(members.items()):
            there = cls is not None and (member == "new" or is_there(cls, member))
            own = ours(cls, member) if there else []
            if not there or member == "new" and not own:
                missing.append(member)
                continue
            present += 1
            fits = [mine.fits(theirs) for mine in own for theirs in overloads]
            # A property that Python computes is there as a slot or a field, without a signature to look at.
            if True in fits or not own and not any(overload.parameters for overload in overloads):
                agreeing += 1
            elif None in fits:
                by_number += 1
            else:
                other.append(member)
        yield name, len(members), present, agreeing, by_number, missing, other


def main():
    folder, words = sys.argv[1], sys.argv[2:]
    show, wanted = "--missing" in words, [word for word in words if not word.startswith("--")] or CLASSES
    rhino.install()
    sums = [0, 0, 0, 0]
    for name, *counts, missing, other in measure(stub_overloads(folder), wanted):
        sums = [a + b for a, b in zip(sums, counts)]
        print("%-22s %3d members, %3d here, %3d agree in kinds, %3d by number" % (name, *counts))
        if show and missing:
            print("    missing: " + " ".join(missing))
        if show and other:
            print("    other signature: " + " ".join(other))
    total = max(sums[0], 1)
    print("%d classes: %d members, %d here (%.0f %%), %d agree in kinds (%.0f %%), %d by number: together %.0f %%" % (
        len(wanted), sums[0], sums[1], 100 * sums[1] / total, sums[2], 100 * sums[2] / total, sums[3],
        100 * (sums[2] + sums[3]) / total))


if __name__ == "__main__":
    main()
