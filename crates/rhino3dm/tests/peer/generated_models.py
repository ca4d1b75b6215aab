"""Models that rhino3dm's interface can make, at random from a fixed seed, a list of geometry a family."""

import ctypes
import math
import random
import uuid

import rhino3dm as r

SEED = 20261121


class Maker:
    """Random geometry; every object comes with the same seed the same way."""

    def __init__(self, seed=SEED):
        self.random = random.Random(seed)

    def number(self, size=10.0):
        return self.random.choice([self.random.uniform(-size, size), float(self.random.randint(-9, 9))])

    def point(self, size=10.0):
        return r.Point3d(self.number(size), self.number(size), self.number(size))

    def vector(self):
        while True:
            v = r.Vector3d(*(self.random.gauss(0, 1) for _ in range(3)))
            if v.Length() > 0.1:
                return v

    def plane(self):
        plane = r.Plane(self.point(), self.vector())
        plane = plane.Rotate(self.random.uniform(0, 6), plane.ZAxis)
        return plane

    def domain(self):
        start = self.number()
        return r.Interval(start, start + self.random.uniform(0.1, 20))

    def moved(self, geometry):
        """Somewhere else, now and then mirrored or scaled."""
        geometry.Rotate(self.random.uniform(-3, 3), self.vector(), self.point())
        geometry.Translate(self.vector())
        return geometry

    def texts(self, geometry):
        for key in ("name", "größe", "日本語 🦗")[: self.random.randint(0, 3)]:
            geometry.SetUserString(key, self.random.choice(["", "x", "Ωmega\nline", "𝄞" * 5, "a" * 300]))
        return geometry

    def nurbs_curve(self, rational=None):
        degree = self.random.choice([1, 2, 3, 3, 4, 5, 9])
        count = degree + 1 + self.random.randint(0, 6)
        rational = self.random.random() < 0.5 if rational is None else rational
        curve = r.NurbsCurve(3, rational, degree + 1, count)
        for i in range(count):
            p, w = self.point(), self.random.uniform(0.2, 4) if rational else 1.0
            curve.Points[i] = r.Point4d(p.X * w, p.Y * w, p.Z * w, w)
        for i, knot in enumerate(self.knots(degree, count)):
            curve.Knots[i] = knot
        return curve

    def knots(self, degree, count):
        knot, knots = self.number(), []
        style = self.random.choice(["uniform", "clamped", "repeated"])
        for i in range(count + degree - 1):
            inside = degree <= i < count
            if style == "uniform" or inside and (style == "clamped" or self.random.random() < 0.6):
                knot += self.random.choice([1.0, self.random.uniform(0.01, 3)])
            elif style == "repeated" and inside and knots[-degree:].count(knot) == degree:
                knot += 1.0
            elif i == count - 1:
                knot += 1.0
            knots.append(knot)
        return knots

    def curves(self):
        points = [self.point() for _ in range(self.random.randint(4, 9))]
        arc = r.Arc(self.point(), self.point(), self.point())
        circle = r.Circle(self.point(), self.random.uniform(0.01, 50))
        circle.Plane = self.plane()
        part = r.Arc(circle, self.random.uniform(0.01, 6.2))
        closed = r.Point3dList()
        for p in [*points, points[0]]:
            closed.Add(p.X, p.Y, p.Z)
        kinds = [
            self.nurbs_curve(), self.nurbs_curve(True), self.nurbs_curve(False),
            r.NurbsCurve.Create(True, self.random.choice([2, 3, 4]), points),
            r.NurbsCurve.Create(False, 3, points), r.Curve.CreateControlPointCurve(points, 2),
            r.NurbsCurve.CreateFromArc(arc), r.NurbsCurve.CreateFromCircle(circle),
            r.NurbsCurve.CreateFromLine(r.Line(points[0], points[1])),
            r.LineCurve(points[0], points[1]), r.PolylineCurve(points), r.PolylineCurve(closed),
            r.ArcCurve.CreateFromArc(arc), r.ArcCurve.CreateFromCircle(circle), r.ArcCurve.CreateFromArc(part),
            r.ArcCurve.CreateFromArcParams(part, -3.5, 12.25), r.ArcCurve.CreateFromCircleParams(circle, 2.0, 2.5),
        ]
        for curve in kinds:
            self.moved(curve)
        kinds += [self.poly_curve(depth) for depth in (0, 1, 2)]
        for curve in list(kinds):
            whole = curve.Domain
            middle = whole.T0 + 0.37 * (whole.T1 - whole.T0)
            other = curve.Duplicate()
            other.Domain = self.domain()
            backwards = other.Duplicate()
            backwards.Reverse()
            flat = curve.Duplicate()
            flat.ChangeDimension(2)
            kinds += [other, backwards, flat]
            kinds += [p for p in (curve.Split(middle) or ()) if p]
            kinds += [p for p in [curve.Trim(whole.T0 + 0.2 * (middle - whole.T0), middle)] if p]
        return [self.texts(curve) for curve in kinds if curve is not None]

    def poly_curve(self, depth):
        poly, at = r.PolyCurve(), self.point()
        for _ in range(self.random.randint(1, 5)):
            to = self.point()
            kind = self.random.choice(["line", "arc", "nurbs", "polyline", "poly"])
            if kind == "line":
                poly.Append(r.Line(at, to))
            elif kind == "arc":
                poly.Append(r.Arc(at, self.point(), to))
            elif kind == "nurbs":
                poly.Append(r.NurbsCurve.Create(False, 3, [at, self.point(), self.point(), self.point(), to]))
            elif kind == "polyline" or not depth:
                poly.AppendSegment(r.PolylineCurve([at, self.point(), to]))
            else:
                inner = self.poly_curve(depth - 1)
                inner.Translate(r.Vector3d(*(a - b for a, b in zip((at.X, at.Y, at.Z), xyz(inner.PointAtStart)))))
                poly.AppendSegment(inner)
                to = inner.PointAtEnd
            at = to
        return poly

    def nurbs_surface(self):
        orders = [self.random.randint(2, 5) for _ in range(2)]
        counts = [order + self.random.randint(0, 4) for order in orders]
        rational = self.random.random() < 0.5
        surface = r.NurbsSurface.Create(3, rational, *orders, *counts)
        for i in range(counts[0]):
            for j in range(counts[1]):
                w = self.random.uniform(0.3, 3) if rational else 1.0
                p = r.Point3d(3 * i + self.random.random(), 2 * j + self.random.random(), self.number(4))
                surface.Points[i, j] = r.Point4d(p.X * w, p.Y * w, p.Z * w, w)
        for list_, order, count in zip((surface.KnotsU, surface.KnotsV), orders, counts):
            for i, knot in enumerate(self.knots(order - 1, count)):
                list_[i] = knot
        return surface

    def revolution(self, profile=None):
        profile = profile or self.random.choice([
            r.LineCurve(r.Point3d(1, 0, 0), r.Point3d(2, 0, 5)),
            r.ArcCurve.CreateFromArc(r.Arc(r.Point3d(2, 0, 0), r.Point3d(3, 0, 1), r.Point3d(2, 0, 2))),
            r.NurbsCurve.Create(False, 3, [r.Point3d(1 + abs(self.number(2)), 0, z) for z in range(6)]),
            r.PolylineCurve([r.Point3d(3, 0, 0), r.Point3d(4, 0, 1), r.Point3d(2, 0, 3)]),
        ])
        start = self.random.choice([0.0, self.number(3)])
        turn = self.random.choice([2 * math.pi, self.random.uniform(0.2, 6)])
        return r.RevSurface.Create(profile, r.Line(r.Point3d(0, 0, 0), r.Point3d(0, 0, 4)), start, start + turn)

    def solids(self):
        circle = r.Circle(self.point(), self.random.uniform(0.5, 4))
        circle.Plane = self.plane()
        cylinder = r.Cylinder(circle, self.random.uniform(1, 5))
        sphere = r.Sphere(self.point(), self.random.uniform(0.2, 30))
        return circle, cylinder, sphere

    def surfaces(self):
        circle, cylinder, sphere = self.solids()
        rail = r.NurbsCurve.Create(False, 3, [self.point() for _ in range(5)])
        kinds = [
            self.nurbs_surface(), self.nurbs_surface(), r.PlaneSurface(self.plane(), self.domain(), self.domain()),
            self.revolution(), self.revolution(), cylinder.ToNurbsSurface(), sphere.ToNurbsSurface(),
            r.NurbsSurface.CreateRuledSurface(rail, self.moved(rail.Duplicate())),
            r.NurbsSurface.CreateRuledSurface(r.ArcCurve.CreateFromCircle(circle), rail),
        ]
        for surface in list(kinds):
            other = surface.Duplicate()
            for direction in (0, 1):
                other.SetDomain(direction, self.domain())
            kinds.append(self.moved(other))
            if isinstance(surface, r.RevSurface):
                kinds.append(surface.ToNurbsSurface())
        return [self.texts(surface) for surface in kinds if surface is not None]

    def profile(self, size=5.0):
        kind = self.random.choice(["circle", "polyline", "nurbs", "poly"])
        around = [r.Point3d(size * math.cos(a), 0.7 * size * math.sin(a), 0) for a in
                  (2 * math.pi * i / 7 for i in range(8))]
        around[-1] = around[0]
        if kind == "circle":
            return r.ArcCurve.CreateFromCircle(r.Circle(r.Point3d(0.1, 0, 0), 0.8 * size))
        if kind == "polyline":
            return r.PolylineCurve(around)
        if kind == "nurbs":
            return r.NurbsCurve.Create(True, 3, around)
        poly = r.PolyCurve()
        poly.Append(r.Line(around[0], around[2]))
        poly.Append(r.Arc(around[2], around[3], around[4]))
        poly.AppendSegment(r.PolylineCurve([around[4], around[5], around[0]]))
        return poly

    def extrusions(self):
        circle, cylinder, _ = self.solids()
        box = r.Box(r.BoundingBox(r.Point3d(-1, -2, -3), r.Point3d(4, 5, 6)))
        kinds = [
            r.Extrusion.CreateBoxExtrusion(box, True), r.Extrusion.CreateCylinderExtrusion(cylinder, True, False),
            r.Extrusion.CreatePipeExtrusion(cylinder, 0.3, True, True),
            r.Extrusion.CreateWithPlane(self.profile(), r.Plane.WorldXY(), 3.0, True),
        ]
        for cap in (True, False):
            kinds.append(r.Extrusion.Create(self.profile(), self.random.uniform(1, 9), cap))
            hollow = r.Extrusion.Create(self.profile(), -2.5, cap)
            hollow.AddInnerProfile(r.ArcCurve.CreateFromCircle(r.Circle(r.Point3d(0.5, 0.5, 0), 0.7)))
            hollow.AddInnerProfile(r.PolylineCurve([r.Point3d(*p) for p in
                                                   ((-2, -1, 0), (-1, -1, 0), (-1, 0, 0), (-2, -1, 0))]))
            kinds.append(hollow)
        arch = r.NurbsCurve.Create(False, 2, [r.Point3d(0, 0, 0), r.Point3d(2, 3, 0), r.Point3d(5, 0, 0)])
        kinds.append(r.Extrusion.Create(arch, 4, False))
        kinds = [kind for kind in kinds if kind is not None]
        for extrusion in list(kinds[:4]):
            other = extrusion.Duplicate()
            other.SetDomain(0, self.domain())
            other.SetDomain(1, self.domain())
            kinds.append(self.moved(other))
            meshed = extrusion.Duplicate()
            meshed.SetMesh(given(self.mesh()), r.MeshType.Render)
            kinds.append(meshed)
        return [self.texts(extrusion) for extrusion in kinds]

    def breps(self):
        circle, cylinder, sphere = self.solids()
        box = r.BoundingBox(r.Point3d(0, 0, 0), r.Point3d(3, 4, 5))
        kinds = [
            r.Brep.CreateFromBoundingBox(box), r.Brep.CreateFromSphere(sphere), r.Brep.CreateQuadSphere(sphere),
            r.Brep.CreateFromCylinder(cylinder, True, True), r.Brep.CreateFromCylinder(cylinder, True, False),
            r.Brep.CreateFromRevSurface(self.revolution(), True, True),
            r.Brep.CreateFromMesh(self.mesh(), True), r.Brep.CreateFromMesh(self.mesh(), False),
            *(r.Brep.CreateTrimmedPlane(r.Plane.WorldXY(), self.profile()) for _ in range(3)),
            *(r.Brep.CreateFromSurface(surface) for surface in self.surfaces()),
            *(extrusion.ToBrep(split) for extrusion in self.extrusions()
              for split in (True, False)),
        ]
        kinds = [brep for brep in kinds if brep is not None]
        for brep in list(kinds[:9]):
            other = brep.Duplicate()
            other.Flip()
            kinds.append(self.moved(other))
            other.Faces[0].SetMesh(given(self.mesh()), r.MeshType.Render)
        faces = [kinds[0].Faces[2].DuplicateFace(True), kinds[3].Faces[0].DuplicateFace(False)]
        along = r.LineCurve(r.Point3d(0, 0, 0), r.Point3d(1, 2, 6))
        faces.append(kinds[0].Faces[5].CreateExtrusion(along, True))
        return [self.texts(brep) for brep in [*kinds, *faces] if brep is not None]

    def mesh(self, double=False):
        mesh, side = r.Mesh(), self.random.randint(1, 4)
        for i in range(side + 1):
            for j in range(side + 1):
                point = (i + self.random.random() / 3, j + self.random.random() / 3, self.random.random())
                (mesh.Vertices.AddPoint3d if double else mesh.Vertices.Add)(*point)
        for i in range(side):
            for j in range(side):
                a, b = i * (side + 1) + j, (i + 1) * (side + 1) + j
                if self.random.random() < 0.5:
                    mesh.Faces.AddFace(a, b, b + 1, a + 1)
                else:
                    mesh.Faces.AddFace(a, b, b + 1)
                    mesh.Faces.AddFace(a, b + 1, a + 1)
        return mesh

    def meshes(self):
        kinds = []
        for choice in range(16):
            mesh = self.mesh(double=bool(choice & 8))
            if choice & 1:
                mesh.Normals.ComputeNormals()
            count = len(mesh.Vertices)
            if choice & 2:
                for _ in range(count):
                    mesh.VertexColors.Add(*(self.random.randint(0, 255) for _ in range(3)))
            if choice & 4:
                mesh.SetTextureCoordinates(r.TextureMapping.CreatePlaneMapping(
                    self.plane(), self.domain(), self.domain(), self.domain()), r.Transform.Identity(), False)
            if choice % 5 == 4:
                mesh.Vertices.Hide(1)
            kinds.append(mesh)
        joined = self.mesh()
        joined.Append(self.mesh(double=True))
        mapped = self.mesh()
        mapped.Normals.ComputeNormals()
        for mapping in (r.TextureMapping.CreateSurfaceParameterMapping(),
                        r.TextureMapping.CreateSphereMapping(r.Sphere(self.point(), 2))):
            mapped.SetCachedTextureCoordinates(mapping, r.Transform.Identity())
        moved = [self.moved(mesh.Duplicate()) for mesh in kinds[::3]]
        return [self.texts(mesh) for mesh in [*kinds, joined, mapped, r.Mesh(), *moved]]

    def clouds(self):
        kinds = []
        for choice in range(9):
            cloud = r.PointCloud()
            for _ in range(self.random.randint(1, 12)):
                cloud.Add(self.point())
            for i in range(cloud.Count):
                item = cloud[i]
                if choice & 1:
                    item.Normal = self.vector()
                if choice & 2:
                    item.Color = (*(self.random.randint(0, 255) for _ in range(3)), 255)
                if choice & 4:
                    item.Value = self.number()
                if choice == 8:
                    item.Hidden = i % 2 == 0
            kinds.append(cloud)
        kinds += [self.moved(cloud.Duplicate()) for cloud in kinds]
        kinds += [r.Point(self.point()), r.Point(r.Point3d(1e300, -1e-300, 0)), r.PointCloud()]
        return [self.texts(cloud) for cloud in kinds]

    def lights(self):
        kinds = []
        for style in list(r.LightStyle.__members__.values()):
            light = r.Light()
            light.LightStyle = style
            light.Location, light.Direction = self.point(), self.vector()
            light.Length, light.Width = self.vector(), self.vector()
            light.Diffuse = light.Specular = (self.random.randint(0, 255), 7, 250, 255)
            light.Intensity, light.PowerWatts = self.random.uniform(0, 2), self.random.uniform(1, 100)
            light.SpotAngleRadians, light.HotSpot = self.random.uniform(0.1, 1.5), self.random.random()
            light.ShadowIntensity, light.IsEnabled = self.random.random(), self.random.random() < 0.7
            light.SetAttenuation(1, self.random.random(), self.random.random())
            light.Name = self.random.choice(["", "Licht", "灯"])
            kinds.append(light)
        return kinds

    def dots(self):
        kinds = []
        for text in ("", "dot", "Πunkt 🦗", "two\nlines", "x" * 500):
            dot = r.TextDot(text, self.point())
            dot.FontHeight = self.random.randint(3, 40)
            dot.FontFace = self.random.choice(["Arial", "Courier New", "ＭＳ ゴシック"])
            dot.SecondaryText = self.random.choice(["", "second", "zwei\r\nZeilen"])
            kinds.append(self.texts(dot))
        return kinds

    def blocks(self):
        kinds = []
        for _ in range(4):
            form = r.Transform.Identity()
            for row in range(3):
                for column in range(4):
                    setattr(form, f"M{row}{column}", self.number())
            kinds.append(self.texts(r.InstanceReference(uuid.UUID(int=self.random.getrandbits(128)), form)))
        return kinds


def given(mesh):
    """A mesh that its new owner frees, so that Python must not."""
    ctypes.pythonapi.Py_IncRef(ctypes.py_object(mesh))
    return mesh


def xyz(p):
    return p.X, p.Y, p.Z
