"""The rows: a definition as a user would write it, of a size, and further lines that tell its answer.

Numbers come from sines and remainders, so that a peer makes the same ones. In the text `$n` is the size, `$tens` ten
times the size, `$side` the side of a square of so many, and `$round` that of a square of twice as many.
"""

from dataclasses import dataclass
from math import isqrt
from string import Template
from textwrap import dedent


@dataclass
class Row:
    """A definition and the sizes it runs at.

    `check` is added to `text` to learn the answer, and is not timed: the peer's answer has values for each label in it.
    A number may differ from the peer's by `within` of the largest of its label; `why` says what allows more than
    rounding.
    """

    name: str
    text: str
    check: str
    size: int
    peer: str | None = None
    # Items for each of a size: what the bytes are counted by.
    items: int = 1
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

    def definition(self, n):
        """The definition of a size, without its first line."""
        sizes = {"n": n, "tens": 10 * n, "side": max(1, isqrt(n)), "round": isqrt(2 * n)}
        return Template(dedent(self.text).lstrip()).substitute(sizes)

    def checks(self):
        return dedent(self.check).lstrip()


ROWS = [
    Row(
        "Million items",
        """
        n = Series(0, 0.001, $n)
        p = Construct Point(n, Sine(n), 0)
        m = Move(p, (0, 0, 10))
        d = Distance(m.Geometry, (0, 0, 0))
        s = Mass Addition(d)
        """,
        """
        sum = Number(s.Result) parameter
        count = List Length(s.Partial Results)
        """,
        250_000,
        "NumPy, by columns",
    ),
    Row(
        "Octagon prisms",
        """
        n = Series(0, 1, $n)
        p = Polygon(XY Plane(Construct Point(n |{(x % $side)*3}, n |{Floor(x/$side)*3}, 0)), 1, 8)
        e = Extrude(p, vector(0, 0, 2))
        k = Cap Holes(e)
        """,
        """
        volume = Volume(k)
        faces = List Length(Deconstruct Brep(k).Faces)
        """,
        500,
        "Open CASCADE",
    ),
    Row(
        "Boxes to Breps",
        """
        z = Series(1, 0.01, $n)
        b = Domain Box(plane((0, 0, 0)), 0..1, 0..2, z)
        d = Deconstruct Brep(b)
        """,
        """
        faces = List Length(d.Faces)
        edges = List Length(d.Edges)
        vertices = List Length(d.Vertices)
        length = Sort List(Length(d.Edges |flatten))
        """,
        2_500,
        "Open CASCADE",
    ),
    Row(
        "Areas and volumes of boxes",
        """
        z = Series(1, 0.01, $n)
        b = Domain Box(plane((0, 0, 0)), 0..1, 0..2, z)
        a = Area(b)
        v = Volume(b)
        """,
        """
        area = Number(a.Area) parameter
        volume = Number(v.Volume) parameter
        height = Number(Deconstruct Point(v.Centroid).2) parameter
        """,
        1_250,
        "Open CASCADE",
    ),
    Row(
        "Mesh Brep, straight pipes",
        """
        n = Series(0, 1, $n)
        l = Line SDL(Construct Point(n |{(x % $side)*3}, n |{Floor(x/$side)*3}, 0), vector(0, 0, 1), 10)
        p = Pipe(l, 0.5, 1)
        m = Mesh Brep(p)
        """,
        """
        area = Area(m)
        meshes = List Length(m |flatten)
        """,
        200,
        "Open CASCADE",
        within=0.03,
        why="facets lie within the round sides",
    ),
    Row(
        "Mesh Brep, curved pipes",
        """
        n = Series(0, 1, $n)
        a = Arc(XZ Plane(Construct Point(n |{(x % $side)*30}, n |{Floor(x/$side)*30}, 0)), 10, 0..1.5)
        p = Pipe(a, 0.5, 1)
        m = Mesh Brep(p)
        """,
        """
        area = Area(m)
        meshes = List Length(m |flatten)
        """,
        40,
        "Open CASCADE",
        within=0.03,
        why="facets lie within the round sides",
    ),
    Row(
        "Simplify Tree",
        """
        n = Series(0, 1, $n)
        g = Graft Tree(n)
        s = Simplify Tree(g)
        """,
        """
        paths = Tree Statistics(s)
        items = Number(s |flatten) parameter
        """,
        400_000,
    ),
    Row(
        "Replace Paths",
        """
        n = Series(0, 1, $n)
        g = Graft Tree(n)
        t = Tree Statistics(g)
        q = Replace Paths(g, t.Paths, t.Paths |reverse)
        """,
        """
        paths = Tree Statistics(q)
        items = Number(q |flatten) parameter
        """,
        25_000,
        sorting=True,
    ),
    Row(
        "Mesh Closest Point",
        """
        n = Series(0, 1, $n)
        m = Mesh Sphere(plane((0, 0, 0)), 10, $round, $round)
        p = Construct Point(n |{Sin(x)*11}, n |{Cos(x*1.3)*11}, n |{Sin(x*1.7)*11})
        c = Mesh Closest Point(p, m)
        """,
        """
        distance = Distance(p, c.Point)
        """,
        5_000,
        "libigl",
        smallest=16,
        sorting=True,
    ),
    Row(
        "Closest Point",
        """
        n = Series(0, 1, $n)
        p = Construct Point(n |{Sin(x*12.9898)*100}, n |{Sin(x*78.233+1)*100}, n |{Sin(x*37.7)*100})
        q = Construct Point(n |{Sin(x*1.98)*100}, n |{Sin(x*7.233+1)*100}, n |{Sin(x*3.7)*100})
        c = Closest Point(p, q)
        """,
        """
        distance = Number(c.Distance) parameter
        index = Integer(c.CP Index) parameter
        """,
        25_000,
        "SciPy, cKDTree",
        sorting=True,
    ),
    Row(
        "Region Union of circles",
        """
        n = Series(0, 1, $n)
        c = Circle(XY Plane(Construct Point(n |{(x % $side)*1.5}, n |{Floor(x/$side)*1.5}, 0)), 1)
        u = Region Union(c)
        """,
        """
        curves = List Length(u)
        length = Mass Addition(Length(u))
        area = Mass Addition(Area(u).Area)
        """,
        1_250,
        "shapely",
        sorting=True,
        within=0.02,
        why="shapely's circles are polygons of 64 sides",
    ),
    Row(
        "Region Union of hexagons",
        """
        n = Series(0, 1, $n)
        c = Polygon(XY Plane(Construct Point(n |{(x % $side)*1.5}, n |{Floor(x/$side)*1.5}, 0)), 1, 6)
        u = Region Union(c)
        """,
        """
        curves = List Length(u)
        length = Mass Addition(Length(u))
        area = Mass Addition(Area(u).Area)
        """,
        1_250,
        "shapely",
        sorting=True,
    ),
    Row(
        "Offset Polyline of stars",
        """
        n = Series(0, 1, $n)
        k = Series(0, 1, 10)
        c = XY Plane(Construct Point(n |{(x % $side)*5}, n |{Floor(x/$side)*5}, 0))
        p = Point Polar(c |graft, k |{x*Pi/5}, 0, [2, 1, 2, 1, 2, 1, 2, 1, 2, 1])
        s = PolyLine(p, true)
        o = Offset Polyline(s, 0.1)
        """,
        """
        area = Area(o.Offset |flatten)
        """,
        5_000,
        "shapely",
        within=1e-06,
    ),
    # Each sphere overlaps its neighbours in the picture.
    Row(
        "Make2D of spheres",
        """
        n = Series(0, 1, $n)
        s = Sphere(XY Plane(Construct Point(n |{x*1.5}, n |{x % 3}, n |{(x % 5)*0.7})), 1)
        v = Make2D Parallel View(rectangle(plane((0, 0, 20)), -50..50, -50..50))
        d = Make2D(s, View = v)
        """,
        """
        visible = Mass Addition(Length(d.Visible curves))
        """,
        20,
        "Open CASCADE",
        sorting=True,
        within=0.0001,
        why="outlines are followed to a tolerance",
    ),
    Row(
        "Project curves on a Brep",
        """
        n = Series(0, 1, $n)
        g = Series(0, 1, 400)
        s = Surface From Points(Construct Point(g |{Floor(x/20)}, g |{x % 20}, g |{Sin(x)*2}), 20, false)
        c = Circle(XY Plane(Construct Point(n |{1+(x % 30)*0.5}, n |{1+(Floor(x/30) % 30)*0.5}, -20)), 0.8)
        p = Util/Project(c, s, vector(0, 0, 1))
        """,
        """
        count = List Length(p |flatten)
        length = Length(p |flatten)
        """,
        10,
        "Open CASCADE",
        within=0.001,
        why="the curves are fitted to a tolerance",
    ),
    Row(
        "Capped pipes",
        """
        n = Series(0, 1, $n)
        a = Arc(XZ Plane(Construct Point(n |{(x % $side)*30}, n |{Floor(x/$side)*30}, 0)), 10, 0..1.5)
        l = Line SDL(Construct Point(n |{(x % $side)*3}, n |{Floor(x/$side)*3}, 0), vector(0, 1, 1), 10)
        p = Pipe([a.Arc, l], 0.2, 1)
        """,
        """
        volume = Volume(p |flatten)
        """,
        250,
        "Open CASCADE",
        items=2,
        within=0.0001,
        why="curved pipes are fitted to a tolerance",
    ),
    Row(
        "Cap Holes",
        """
        n = Series(0, 1, $n)
        c = XY Plane(Construct Point(n |{(x % $side)*5}, n |{Floor(x/$side)*5}, 0))
        k = Series(0, 1, 40)
        p = Point Polar(c |graft, k |{x*Pi/20}, 0, k |{1.5+Sin(x*x)*0.4})
        e = Extrude(Nurbs Curve(p, 3, true), vector(0, 0, 2))
        h = Cap Holes(e)
        """,
        """
        volume = Volume(h |flatten)
        """,
        100,
        "Open CASCADE",
        within=1e-08,
    ),
    Row(
        "Tree components",
        """
        n = Series(0, 1, $tens)
        t = Partition List(n, 10)
        f = Flip Matrix(t)
        g = Graft Tree(t)
        s = Simplify Tree(g)
        a = Flatten Tree(t)
        u = Unflatten Tree(a, t)
        h = Shift Paths(g, -1)
        m = Trim Tree(g, 1)
        r = Prune Tree(t, 5, 20)
        c = Clean Tree(true, true, true, t)
        w = Split Tree(t, ["{0;?;?}"])
        e = Tree Statistics(g)
        b = Tree Branch(g, e.Paths)
        x = Match Tree(h, t)
        y = Merge(t, r)
        """,
        """
        flipped = List Length(f)
        paths = List Length(e.Paths)
        flat = Mass Addition(a)
        lists = List Length(List Length(u) |flatten)
        shifted = List Length(h)
        trimmed = Mass Addition(m |flatten)
        pruned = List Length(r |flatten)
        cleaned = List Length(c |flatten)
        split = List Length(w.Positive |flatten)
        branches = Mass Addition(b |flatten)
        matched = List Length(x |flatten)
        merged = List Length(y)
        simple = Mass Addition(s |flatten)
        """,
        25_000,
        items=10,
    ),
    Row(
        "Expression",
        """
        n = Series(0, 1, $n)
        e = Expression("x^2 + Sin(x)", x = n)
        """,
        """
        sum = Mass Addition(e)
        """,
        1_000_000,
        "NumPy",
    ),
    Row(
        "Format",
        """
        n = Series(0, 0.37, $n)
        e = Format("{0:0.00}", _, n)
        """,
        """
        text = Text(e) parameter
        """,
        250_000,
        "CPython, str.format",
    ),
    Row(
        "Mesh booleans of spheres",
        """
        n = Series(0, 1, $n)
        m = Mesh Sphere(XY Plane(Construct Point(n |{(x % $side)*1.2}, n |{Floor(x/$side)*1.2}, 0)), 1, 24, 24)
        u = Mesh Union(m)
        """,
        """
        volume = Mass Addition(Volume(u))
        meshes = List Length(u)
        """,
        25,
        "manifold3d",
        sorting=True,
        within=1e-06,
    ),
    Row(
        "Variable pipes",
        """
        n = Series(0, 1, $n)
        l = Line SDL(Construct Point(n |{(x % $side)*30}, n |{Floor(x/$side)*30}, 0), vector(0, 0, 1), 100)
        p = Pipe Variable(l |reparameterize, [0, 0.5, 1], [4, 6, 3], 1)
        m = Mesh Brep(p)
        """,
        """
        volume = Volume(p |flatten)
        meshed = Volume(m |flatten)
        """,
        100,
        within=0.03,
        why="facets lie within the round sides",
    ),
    Row(
        "Sets of strings",
        """
        a = Format("item {0}", _, Series(0, 7, $n) |{x % 100003})
        b = Format("item {0}", _, Series(3, 11, $n) |{x % 100003})
        s = Create Set(a)
        u = Set Union(a, b)
        i = Set Intersection(a, b)
        d = Set Difference(a, b)
        """,
        """
        created = Text(s.Set) parameter
        union = List Length(u)
        both = Text(i) parameter
        first = Text(d) parameter
        """,
        25_000,
        "CPython, dict",
        items=2,
    ),
    # Cones, which every way to loft gives alike.
    Row(
        "Lofts",
        """
        n = Series(0, 1, $n)
        k = Series(0, 1, 4)
        o = Construct Point(n |{(x % $side)*10}, n |{Floor(x/$side)*10}, 0)
        q = Move(o |graft, Vector XYZ(0, 0, k |{x*2}))
        c = Circle(XY Plane(q.Geometry), [1, 2, 3, 4])
        s = Loft(c)
        """,
        """
        area = Area(s |flatten)
        """,
        500,
        "Open CASCADE",
        within=1e-06,
    ),
    # Of shorter waves Open CASCADE misses crossings.
    Row(
        "Curve with curve",
        """
        n = Series(0, 1, $n)
        k = Series(0, 1, 20)
        a base = Construct Point(k |{x}, k |{Sin(x*1.3+0)*3}, 0)
        a moved = Move(a base, Vector XYZ(0, n |graft |{x*10}, 0) |graft)
        b base = Construct Point(k |{x}, k |{Sin(x*1.3+1.9)*3}, 0)
        b moved = Move(b base, Vector XYZ(0, n |graft |{x*10}, 0) |graft)
        x = `Curve | Curve`(Nurbs Curve(a moved.Geometry), Nurbs Curve(b moved.Geometry))
        """,
        """
        counts = List Length(x.Points)
        at = Point(x.Points |flatten) parameter
        """,
        1_000,
        "Open CASCADE",
        within=1e-06,
    ),
    Row(
        "Many lines",
        """
        n = Series(0, 1, $n)
        p = Construct Point(n |{(x % $side)*3}, n |{Floor(x/$side)*3}, 0)
        v = Vector XYZ(n |{Sin(x*3.7)*9}, n |{Cos(x*5.1)*9}, 0)
        l = Line(p, Move(p, v).Geometry)
        x = Multiple Curves(l)
        """,
        """
        count = List Length(x.Points)
        sum = Mass Addition(Deconstruct Point(x.Points).0)
        other = Mass Addition(Deconstruct Point(x.Points).1)
        """,
        10_000,
        "shapely, STRtree",
        sorting=True,
        within=1e-07,
        why="ends that nearly meet may meet at either",
    ),
    Row(
        "Voronoi",
        """
        n = Series(0, 1, $n)
        p = Construct Point(n |{Sin(x*12.9898)*100}, n |{Sin(x*78.233+1)*100}, 0)
        v = Voronoi(p, _, rectangle(plane((0, 0, 0)), -101..101, -101..101))
        """,
        """
        area = Sort List(Area(v).Area)
        """,
        20_000,
        "shapely",
        smallest=8,
        sorting=True,
        within=1e-06,
    ),
    Row(
        "Delaunay",
        """
        n = Series(0, 1, $n)
        p = Construct Point(n |{Sin(x*12.9898)*100}, n |{Sin(x*78.233+1)*100}, 0)
        m = Delaunay Mesh(p)
        """,
        """
        area = Area(m)
        faces = List Length(Deconstruct Mesh(m).Faces)
        """,
        50_000,
        "SciPy",
        smallest=8,
        sorting=True,
    ),
    Row(
        "Contours of a mesh",
        """
        m = Mesh Sphere(plane((0, 0, 0)), 10, $side, $side)
        c = Mathematical/Contour(m, (0, 0, -10), vector(0.1, 0.2, 1), 0.37)
        """,
        """
        count = List Length(c |flatten)
        length = Mass Addition(Length(c |flatten))
        """,
        20_000,
        "trimesh",
        smallest=16,
    ),
    Row(
        "Transforms of mesh spheres",
        """
        n = Series(0, 1, $n)
        m = Mesh Sphere(plane((0, 0, 0)), 1, 24, 24)
        r = Rotate(m, n |{x*0.1}, plane((0, 0, 0), (1, 0, 0), (0, 0.6, 0.8)))
        t = Move(r.Geometry, Vector XYZ(n |{x*3}, 0, 0))
        """,
        """
        middle = Point(Area(t.Geometry).Centroid) parameter
        area = Area(t.Geometry)
        """,
        1_000,
        "NumPy",
    ),
    Row(
        "SubD boxes",
        """
        z = Series(1, 0.01, $n)
        b = Domain Box(plane((0, 0, 0)), 0..1, 0..2, z)
        s = SubD Box(b, 2, false)
        m = Mesh from SubD(s, 3)
        """,
        """
        faces = List Length(Deconstruct Mesh(m).Faces)
        volume = Volume(m)
        """,
        100,
    ),
    Row(
        "Sort List",
        """
        n = Series(0, 1, $n)
        k = Expression("Sin(x*12.9898)", x = n)
        s = Sort List(k, n)
        """,
        """
        keys = Number(s.Keys) parameter
        values = Number(s.Values A) parameter
        """,
        250_000,
        "NumPy",
        sorting=True,
    ),
    Row(
        "Cross-matched lists",
        """
        n = Series(0, 1, $n)
        p = Construct Point(n |graft, Series(0, 0.5, 100), [1, 2, 3])
        d = Distance(p, (0, 0, 0))
        """,
        """
        sum = Mass Addition(d |flatten)
        """,
        5_000,
        "NumPy",
        items=100,
    ),
    Row(
        "STEP of boxes",
        """
        n = Series(0, 1, $n)
        p = Construct Point(n |{(x % $side)*5}, n |{Floor(x/$side)*5}, 0) hidden
        b = Center Box(XY Plane(p), 1, 2, n |{1+x*0.01})
        """,
        "",
        500,
        "Open CASCADE",
        within=1e-06,
        saves="step",
    ),
    Row(
        "3dm of meshes",
        """
        n = Series(0, 1, $n)
        p = Construct Point(n |{(x % $side)*3}, n |{Floor(x/$side)*3}, 0) hidden
        m = Mesh Sphere(XY Plane(p), 1, 24, 24)
        """,
        "",
        100,
        "rhino3dm",
        within=1e-06,
        saves="3dm",
    ),
]
