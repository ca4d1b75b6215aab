"""The rows: a definition as a user would write it, of a size, and further lines that tell its answer.

Numbers come from sines and remainders, so that a peer makes the same ones.
"""

from dataclasses import dataclass
from math import isqrt
from typing import Callable


@dataclass
class Row:
    """A definition and the sizes it runs at.

    `text` gives the definition of a size, and `check` what is added to it to learn the answer, which is not timed: the
    peer's answer has a value for each label in it. A number may differ from the peer's by `within` of the largest of
    its label; `why` says what allows more than rounding.
    """

    name: str
    text: Callable[[int], str]
    check: str
    size: int
    peer: str | None = None
    # Items for a size: what the bytes are counted by.
    items: Callable[[int], int] = lambda n: n
    # The size of the run that counts as start-up, as near zero as the definition can be.
    smallest: int = 0
    # No better way is known than one that sorts or searches: n log n.
    sorting: bool = False
    within: float = 1e-9
    why: str = ""
    # The ending of the file that the run writes, if it writes one.
    saves: str | None = None

    def sizes(self):
        return [self.size, 2 * self.size, 4 * self.size]


def grid(n, step, z="0"):
    """Points in a square, `step` apart."""
    side = max(1, isqrt(n))
    return f"Construct Point(n |{{(x % {side})*{step}}}, n |{{Floor(x/{side})*{step}}}, {z})"


def series(n):
    return f"n = Series(0, 1, {n})\n"


def cloud(name, a, b, c=None):
    """Points without order in a cube (or square) of 200, one for each n."""
    z = f"n |{{Sin(x*{c})*100}}" if c else "0"
    return f"{name} = Construct Point(n |{{Sin(x*{a})*100}}, n |{{Sin(x*{b}+1)*100}}, {z})\n"


def waves(name, phase):
    """A cubic wave for each n, 10 apart in y. Of shorter waves Open CASCADE misses crossings."""
    return (
        f"{name} base = Construct Point(k |{{x}}, k |{{Sin(x*1.3+{phase})*3}}, 0)\n"
        f"{name} moved = Move({name} base, Vector XYZ(0, n |graft |{{x*10}}, 0) |graft)\n"
    )


def texts(name, start, step, count):
    return f'{name} = Format("item {{0}}", _, Series({start}, {step}, {count}) |{{x % 100003}})\n'


ROWS = [
    Row(
        "Million items",
        lambda n: (
            f"n = Series(0, 0.001, {n})\n"
            "p = Construct Point(n, Sine(n), 0)\n"
            "m = Move(p, (0, 0, 10))\n"
            "d = Distance(m.Geometry, (0, 0, 0))\n"
            "s = Mass Addition(d)\n"
        ),
        "sum = Number(s.Result) parameter\ncount = List Length(s.Partial Results)\n",
        250_000,
        "NumPy, by columns",
    ),
    Row(
        "Octagon prisms",
        lambda n: (
            series(n) + f"p = Polygon(XY Plane({grid(n, 3)}), 1, 8)\n"
            "e = Extrude(p, vector(0, 0, 2))\n"
            "k = Cap Holes(e)\n"
        ),
        "volume = Volume(k)\nfaces = List Length(Deconstruct Brep(k).Faces)\n",
        500,
        "Open CASCADE",
    ),
    Row(
        "Boxes to Breps",
        lambda n: (
            f"z = Series(1, 0.01, {n})\nb = Domain Box(plane((0, 0, 0)), 0..1, 0..2, z)\nd = Deconstruct Brep(b)\n"
        ),
        "faces = List Length(d.Faces)\nedges = List Length(d.Edges)\nvertices = List Length(d.Vertices)\n"
        "length = Sort List(Length(d.Edges |flatten))\n",
        2_500,
        "Open CASCADE",
    ),
    Row(
        "Areas and volumes of boxes",
        lambda n: (
            f"z = Series(1, 0.01, {n})\nb = Domain Box(plane((0, 0, 0)), 0..1, 0..2, z)\na = Area(b)\nv = Volume(b)\n"
        ),
        "area = Number(a.Area) parameter\nvolume = Number(v.Volume) parameter\n"
        "height = Number(Deconstruct Point(v.Centroid).2) parameter\n",
        1_250,
        "Open CASCADE",
    ),
    Row(
        "Mesh Brep, straight pipes",
        lambda n: (
            series(n) + f"l = Line SDL({grid(n, 3)}, vector(0, 0, 1), 10)\np = Pipe(l, 0.5, 1)\nm = Mesh Brep(p)\n"
        ),
        "area = Area(m)\nmeshes = List Length(m |flatten)\n",
        200,
        "Open CASCADE",
        within=0.03,
        why="facets lie within the round sides",
    ),
    Row(
        "Mesh Brep, curved pipes",
        lambda n: (
            series(n) + "a = Arc(XZ Plane(" + grid(n, 30) + "), 10, 0..1.5)\np = Pipe(a, 0.5, 1)\nm = Mesh Brep(p)\n"
        ),
        "area = Area(m)\nmeshes = List Length(m |flatten)\n",
        40,
        "Open CASCADE",
        within=0.03,
        why="facets lie within the round sides",
    ),
    Row(
        "Simplify Tree",
        lambda n: series(n) + "g = Graft Tree(n)\ns = Simplify Tree(g)\n",
        "paths = Tree Statistics(s)\nitems = Number(s |flatten) parameter\n",
        400_000,
    ),
    Row(
        "Replace Paths",
        lambda n: (
            series(n) + "g = Graft Tree(n)\nt = Tree Statistics(g)\nq = Replace Paths(g, t.Paths, t.Paths |reverse)\n"
        ),
        "paths = Tree Statistics(q)\nitems = Number(q |flatten) parameter\n",
        25_000,
        sorting=True,
    ),
    Row(
        "Mesh Closest Point",
        lambda n: (
            series(n) + f"m = Mesh Sphere(plane((0, 0, 0)), 10, {isqrt(2 * n)}, {isqrt(2 * n)})\n"
            "p = Construct Point(n |{Sin(x)*11}, n |{Cos(x*1.3)*11}, n |{Sin(x*1.7)*11})\n"
            "c = Mesh Closest Point(p, m)\n"
        ),
        "distance = Distance(p, c.Point)\n",
        5_000,
        "libigl",
        smallest=16,
        sorting=True,
    ),
    Row(
        "Closest Point",
        lambda n: (
            series(n) + cloud("p", 12.9898, 78.233, 37.7) + cloud("q", 1.98, 7.233, 3.7) + "c = Closest Point(p, q)\n"
        ),
        "distance = Number(c.Distance) parameter\nindex = Integer(c.CP Index) parameter\n",
        25_000,
        "SciPy, cKDTree",
        sorting=True,
    ),
    Row(
        "Region Union of circles",
        lambda n: series(n) + f"c = Circle(XY Plane({grid(n, 1.5)}), 1)\nu = Region Union(c)\n",
        "curves = List Length(u)\nlength = Mass Addition(Length(u))\narea = Mass Addition(Area(u).Area)\n",
        1_250,
        "shapely",
        within=0.02,
        why="shapely's circles are polygons of 64 sides",
        sorting=True,
    ),
    Row(
        "Region Union of hexagons",
        lambda n: series(n) + f"c = Polygon(XY Plane({grid(n, 1.5)}), 1, 6)\nu = Region Union(c)\n",
        "curves = List Length(u)\nlength = Mass Addition(Length(u))\narea = Mass Addition(Area(u).Area)\n",
        1_250,
        "shapely",
        sorting=True,
    ),
    Row(
        "Offset Polyline of stars",
        lambda n: (
            series(n) + "k = Series(0, 1, 10)\n"
            f"c = XY Plane({grid(n, 5)})\n"
            "p = Point Polar(c |graft, k |{x*Pi/5}, 0, [2, 1, 2, 1, 2, 1, 2, 1, 2, 1])\n"
            "s = PolyLine(p, true)\n"
            "o = Offset Polyline(s, 0.1)\n"
        ),
        "area = Area(o.Offset |flatten)\n",
        5_000,
        "shapely",
        within=1e-6,
    ),
    Row(
        "Make2D of spheres",
        lambda n: (
            series(n) + "s = Sphere(XY Plane(Construct Point(n |{x*1.5}, n |{x % 3}, n |{(x % 5)*0.7})), 1)\n"
            "v = Make2D Parallel View(rectangle(plane((0, 0, 20)), -50..50, -50..50))\n"
            "d = Make2D(s, View = v)\n"
        ),
        "visible = Mass Addition(Length(d.Visible curves))\n",
        20,
        "Open CASCADE",
        within=1e-4,
        why="outlines are followed to a tolerance",
        sorting=True,
    ),
    Row(
        "Project curves on a Brep",
        lambda n: (
            series(n) + "g = Series(0, 1, 400)\n"
            "s = Surface From Points(Construct Point(g |{Floor(x/20)}, g |{x % 20}, g |{Sin(x)*2}), 20, false)\n"
            "c = Circle(XY Plane(Construct Point(n |{1+(x % 30)*0.5}, n |{1+(Floor(x/30) % 30)*0.5}, -20)), 0.8)\n"
            "p = Util/Project(c, s, vector(0, 0, 1))\n"
        ),
        "count = List Length(p |flatten)\nlength = Length(p |flatten)\n",
        10,
        "Open CASCADE",
        within=1e-3,
        why="the curves are fitted to a tolerance",
    ),
    Row(
        "Capped pipes",
        lambda n: (
            series(n) + "a = Arc(XZ Plane(" + grid(n, 30) + "), 10, 0..1.5)\n"
            f"l = Line SDL({grid(n, 3)}, vector(0, 1, 1), 10)\n"
            "p = Pipe([a.Arc, l], 0.2, 1)\n"
        ),
        "volume = Volume(p |flatten)\n",
        250,
        "Open CASCADE",
        items=lambda n: 2 * n,
        within=1e-4,
        why="curved pipes are fitted to a tolerance",
    ),
    Row(
        "Cap Holes",
        lambda n: (
            series(n) + f"c = XY Plane({grid(n, 5)})\n"
            "k = Series(0, 1, 40)\n"
            "p = Point Polar(c |graft, k |{x*Pi/20}, 0, k |{1.5+Sin(x*x)*0.4})\n"
            "e = Extrude(Nurbs Curve(p, 3, true), vector(0, 0, 2))\n"
            "h = Cap Holes(e)\n"
        ),
        "volume = Volume(h |flatten)\n",
        100,
        "Open CASCADE",
        within=1e-8,
    ),
    Row(
        "Tree components",
        lambda n: (
            f"n = Series(0, 1, {10 * n})\n"
            f"t = Partition List(n, 10)\n"
            "f = Flip Matrix(t)\n"
            "g = Graft Tree(t)\n"
            "s = Simplify Tree(g)\n"
            "a = Flatten Tree(t)\n"
            "u = Unflatten Tree(a, t)\n"
            "h = Shift Paths(g, -1)\n"
            "m = Trim Tree(g, 1)\n"
            "r = Prune Tree(t, 5, 20)\n"
            "c = Clean Tree(true, true, true, t)\n"
            'w = Split Tree(t, ["{0;?;?}"])\n'
            "e = Tree Statistics(g)\n"
            "b = Tree Branch(g, e.Paths)\n"
            "x = Match Tree(h, t)\n"
            "y = Merge(t, r)\n"
        ),
        "flipped = List Length(f)\npaths = List Length(e.Paths)\nflat = Mass Addition(a)\n"
        "lists = List Length(List Length(u) |flatten)\nshifted = List Length(h)\ntrimmed = Mass Addition(m |flatten)\n"
        "pruned = List Length(r |flatten)\ncleaned = List Length(c |flatten)\nsplit = List Length(w.Positive |flatten)\n"
        "branches = Mass Addition(b |flatten)\nmatched = List Length(x |flatten)\nmerged = List Length(y)\n"
        "simple = Mass Addition(s |flatten)\n",
        25_000,
        items=lambda n: 10 * n,
    ),
    Row(
        "Expression",
        lambda n: series(n) + 'e = Expression("x^2 + Sin(x)", x = n)\n',
        "sum = Mass Addition(e)\n",
        1_000_000,
        "NumPy",
    ),
    Row(
        "Format",
        lambda n: f'n = Series(0, 0.37, {n})\ne = Format("{{0:0.00}}", _, n)\n',
        "text = Text(e) parameter\n",
        250_000,
        "CPython, str.format",
    ),
    Row(
        "Mesh booleans of spheres",
        lambda n: series(n) + f"m = Mesh Sphere(XY Plane({grid(n, 1.2)}), 1, 24, 24)\nu = Mesh Union(m)\n",
        "volume = Mass Addition(Volume(u))\nmeshes = List Length(u)\n",
        25,
        "manifold3d",
        within=1e-6,
        sorting=True,
    ),
    Row(
        "Variable pipes",
        lambda n: (
            series(n) + f"l = Line SDL({grid(n, 30)}, vector(0, 0, 1), 100)\n"
            "p = Pipe Variable(l |reparameterize, [0, 0.5, 1], [4, 6, 3], 1)\n"
            "m = Mesh Brep(p)\n"
        ),
        "volume = Volume(p |flatten)\nmeshed = Volume(m |flatten)\n",
        100,
        within=0.03,
        why="facets lie within the round sides",
    ),
    Row(
        "Sets of strings",
        lambda n: (
            texts("a", 0, 7, n) + texts("b", 3, 11, n) + "s = Create Set(a)\n"
            "u = Set Union(a, b)\n"
            "i = Set Intersection(a, b)\n"
            "d = Set Difference(a, b)\n"
        ),
        "created = Text(s.Set) parameter\nunion = List Length(u)\nboth = Text(i) parameter\nfirst = Text(d) parameter\n",
        25_000,
        "CPython, dict",
        items=lambda n: 2 * n,
    ),
    Row(
        "Lofts",
        lambda n: (
            series(n) + "k = Series(0, 1, 4)\n"
            "o = " + grid(n, 10) + "\n"
            "q = Move(o |graft, Vector XYZ(0, 0, k |{x*2}))\n"
            "c = Circle(XY Plane(q.Geometry), [1, 2, 3, 4])\n"
            "s = Loft(c)\n"
        ),
        "area = Area(s |flatten)\n",
        500,
        "Open CASCADE",
        within=1e-6,
    ),
    Row(
        "Curve with curve",
        lambda n: (
            series(n)
            + "k = Series(0, 1, 20)\n"
            + waves("a", 0)
            + waves("b", 1.9)
            + "x = `Curve | Curve`(Nurbs Curve(a moved.Geometry), Nurbs Curve(b moved.Geometry))\n"
        ),
        "counts = List Length(x.Points)\nat = Point(x.Points |flatten) parameter\n",
        1_000,
        "Open CASCADE",
        within=1e-6,
    ),
    Row(
        "Many lines",
        lambda n: (
            series(n) + f"p = {grid(n, 3)}\n"
            "v = Vector XYZ(n |{Sin(x*3.7)*9}, n |{Cos(x*5.1)*9}, 0)\n"
            "l = Line(p, Move(p, v).Geometry)\n"
            "x = Multiple Curves(l)\n"
        ),
        "count = List Length(x.Points)\n"
        "sum = Mass Addition(Deconstruct Point(x.Points).0)\nother = Mass Addition(Deconstruct Point(x.Points).1)\n",
        10_000,
        "shapely, STRtree",
        within=1e-7,
        why="ends that nearly meet may meet at either",
        sorting=True,
    ),
    Row(
        "Voronoi",
        lambda n: (
            series(n)
            + cloud("p", 12.9898, 78.233)
            + "v = Voronoi(p, _, rectangle(plane((0, 0, 0)), -101..101, -101..101))\n"
        ),
        "area = Sort List(Area(v).Area)\n",
        20_000,
        "shapely",
        smallest=8,
        within=1e-6,
        sorting=True,
    ),
    Row(
        "Delaunay",
        lambda n: series(n) + cloud("p", 12.9898, 78.233) + "m = Delaunay Mesh(p)\n",
        "area = Area(m)\nfaces = List Length(Deconstruct Mesh(m).Faces)\n",
        50_000,
        "SciPy",
        smallest=8,
        sorting=True,
    ),
    Row(
        "Contours of a mesh",
        lambda n: (
            f"m = Mesh Sphere(plane((0, 0, 0)), 10, {isqrt(n)}, {isqrt(n)})\n"
            "c = Mathematical/Contour(m, (0, 0, -10), vector(0.1, 0.2, 1), 0.37)\n"
        ),
        "count = List Length(c |flatten)\nlength = Mass Addition(Length(c |flatten))\n",
        20_000,
        "trimesh",
        smallest=16,
    ),
    Row(
        "Transforms of mesh spheres",
        lambda n: (
            series(n) + "m = Mesh Sphere(plane((0, 0, 0)), 1, 24, 24)\n"
            "r = Rotate(m, n |{x*0.1}, plane((0, 0, 0), (1, 0, 0), (0, 0.6, 0.8)))\n"
            "t = Move(r.Geometry, Vector XYZ(n |{x*3}, 0, 0))\n"
        ),
        "middle = Point(Area(t.Geometry).Centroid) parameter\narea = Area(t.Geometry)\n",
        1_000,
        "NumPy",
    ),
    Row(
        "SubD boxes",
        lambda n: (
            f"z = Series(1, 0.01, {n})\n"
            "b = Domain Box(plane((0, 0, 0)), 0..1, 0..2, z)\n"
            "s = SubD Box(b, 2, false)\n"
            "m = Mesh from SubD(s, 3)\n"
        ),
        "faces = List Length(Deconstruct Mesh(m).Faces)\nvolume = Volume(m)\n",
        100,
    ),
    Row(
        "Sort List",
        lambda n: series(n) + 'k = Expression("Sin(x*12.9898)", x = n)\ns = Sort List(k, n)\n',
        "keys = Number(s.Keys) parameter\nvalues = Number(s.Values A) parameter\n",
        250_000,
        "NumPy",
        sorting=True,
    ),
    Row(
        "Cross-matched lists",
        lambda n: (
            series(n) + "p = Construct Point(n |graft, Series(0, 0.5, 100), [1, 2, 3])\nd = Distance(p, (0, 0, 0))\n"
        ),
        "sum = Mass Addition(d |flatten)\n",
        5_000,
        "NumPy",
        items=lambda n: 100 * n,
    ),
    Row(
        "STEP of boxes",
        lambda n: series(n) + f"p = {grid(n, 5)} hidden\nb = Center Box(XY Plane(p), 1, 2, n |{{1+x*0.01}})\n",
        "",
        500,
        "Open CASCADE",
        saves="step",
        within=1e-6,
    ),
    Row(
        "3dm of meshes",
        lambda n: series(n) + f"p = {grid(n, 3)} hidden\nm = Mesh Sphere(XY Plane(p), 1, 24, 24)\n",
        "",
        100,
        "rhino3dm",
        saves="3dm",
        within=1e-6,
    ),
]
