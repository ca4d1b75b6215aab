//! `Surface` and its classes: evaluation, parts, and changes in place.

use katydid_geometry::{
    Cone, Curve, Cylinder, Direction, Interval, Line, NurbsSurface, Plane, PlaneSurface, RevolutionSurface,
    Side, Sphere, Surface, SurfaceCurvature, Torus, Vector3, construct,
};

use super::curve::within;
use crate::geometry::answer::Outcome;
use crate::geometry::argument::Count;
use crate::geometry::choice::Along;
use crate::geometry::table::Endpoints;
use crate::shape::{Record, Shape};
use crate::wire::Read;
use crate::{Fault, Value};

pub(super) fn enter(table: &mut Endpoints) {
    table.member("Surface.Domain this direction", |s: Surface, along: Along| Ok(s.domain(along.0)));
    table.member("Surface.SetDomain &this direction domain", |s: Surface, along: Along, to: Interval| {
        Ok((true, s.with_domain(along.0, to)?))
    });
    table.member("Surface.Degree this direction", |s: Surface, along: Along| {
        Ok(s.to_nurbs()?.degree(along.0))
    });
    table.member("Surface.SpanCount this direction", |s: Surface, along: Along| {
        Ok(s.span_parameters(along.0).len().saturating_sub(1))
    });
    table.member("Surface.GetSpanVector this direction", |s: Surface, along: Along| {
        Ok(s.span_parameters(along.0))
    });
    table.member("Surface.PointAt this u v", |s: Surface, u: f64, v: f64| Ok(s.point_at(u, v)));
    table.member("Surface.NormalAt this u v", |s: Sided, u: f64, v: f64| Ok(s.normal_at(u, v)));
    table.member("Surface.FrameAt this u v", |s: Surface, u: f64, v: f64| {
        let frame = s.frame_at(u, v);
        Ok((frame.is_some(), frame))
    });
    table.member("Surface.CurvatureAt this u v", |s: Surface, u: f64, v: f64| {
        Ok(curvature(u, v, &s.curvature_at(u, v)?))
    });
    table.member("Surface.IsoCurve this direction constantParameter", |s: Surface, along: Along, at: f64| {
        Ok(s.isocurve(along.0, at)?)
    });
    table.member("Surface.IsClosed this direction", |s: Surface, along: Along| Ok(s.is_closed(along.0)));
    table.member("Surface.IsPeriodic this direction", |s: Surface, along: Along| Ok(s.is_periodic(along.0)));
    table.member("Surface.IsAtSingularity this u v exact", |s: Surface, u: f64, v: f64, _: bool| {
        Ok(s.is_at_singularity(u, v))
    });
    table.member("Surface.get_IsSolid this", |s: Surface| Ok(s.is_solid()));
    table.member("Surface.IsPlanar this", |s: Surface| Ok(s.is_planar(within(None))));
    table.member("Surface.IsPlanar this tolerance", |s: Surface, t: f64| Ok(s.is_planar(within(Some(t)))));
    table.member("Surface.TryGetPlane this", |s: Surface| Ok(found(s.plane(within(None)))));
    table.member("Surface.TryGetPlane this tolerance", |s: Surface, t: f64| {
        Ok(found(s.plane(within(Some(t)))))
    });
    table.member("Surface.IsSphere this", |s: Surface| Ok(s.as_sphere(within(None)).is_some()));
    table.member("Surface.IsCylinder this", |s: Surface| Ok(s.as_cylinder(within(None)).is_some()));
    table.member("Surface.IsCone this", |s: Surface| Ok(s.as_cone(within(None)).is_some()));
    table.member("Surface.IsTorus this", |s: Surface| Ok(s.as_torus(within(None)).is_some()));
    table.member("Surface.TryGetSphere this", |s: Surface| Ok(found(s.as_sphere(within(None)))));
    table.member("Surface.TryGetSphere this tolerance", |s: Surface, t: f64| {
        Ok(found(s.as_sphere(within(Some(t)))))
    });
    table.member("Surface.TryGetCylinder this", |s: Surface| Ok(found(s.as_cylinder(within(None)))));
    table.member("Surface.TryGetCylinder this tolerance", |s: Surface, t: f64| {
        Ok(found(s.as_cylinder(within(Some(t)))))
    });
    table.member("Surface.TryGetCone this", |s: Surface| Ok(found(s.as_cone(within(None)))));
    table.member("Surface.TryGetCone this tolerance", |s: Surface, t: f64| {
        Ok(found(s.as_cone(within(Some(t)))))
    });
    table.member("Surface.TryGetTorus this", |s: Surface| Ok(found(s.as_torus(within(None)))));
    table.member("Surface.TryGetTorus this tolerance", |s: Surface, t: f64| {
        Ok(found(s.as_torus(within(Some(t)))))
    });
    table.member("Surface.HasNurbsForm this", |s: Surface| Ok(i32::from(s.to_nurbs().is_ok())));
    table.member("Surface.IsSingular this side", |s: Surface, side: Count<0, 3>| {
        // South, east, north and west, as openNURBS numbers them.
        let sides = [Side::South, Side::East, Side::North, Side::West];
        Ok(sides.get(side.0).is_some_and(|side| s.is_singular(*side)))
    });
    table.member("Surface.IsAtSeam this u v", |s: Surface, u: f64, v: f64| {
        let [at_u, at_v] = s.is_at_seam(u, v);
        Ok(i32::from(at_u) + 2 * i32::from(at_v))
    });
    table.member(
        "Surface.Evaluate this u v numberDerivatives",
        |s: Surface, u: f64, v: f64, n: Count<0, 8>| {
            let found = s.derivatives(u, v, n.0, s.inner_quadrant(u, v));
            let orders = (1..=n.0).flat_map(|order| (0..=order).map(move |j| (order - j, j)));
            let derivatives: Vec<Vector3> = orders.map(|(i, j)| found.get(i, j)).collect();
            Ok((true, found.point(), derivatives))
        },
    );
    table.member("Surface.ToNurbsSurface this", |s: Surface| Ok(Surface::from(s.to_nurbs()?)));
    table.member("Surface.ToBrep this", |s: Surface| Ok(katydid_geometry::Brep::from_surface(s)?));
    table.member("Surface.Reverse this direction", |s: Surface, along: Along| Ok(s.reversed(along.0)));
    table.member("Surface.Transpose this", |s: Surface| Ok(s.transposed()));
    table.member("Surface.Trim this u v", |s: Surface, u: Interval, v: Interval| Ok(s.sub_surface(u, v)?));
    table.member("Surface.Split this direction parameter", |s: Surface, along: Along, at: f64| {
        let (below, above) = s.split(along.0, at)?;
        Ok(vec![below, above])
    });
    kinds(table);
}

fn kinds(table: &mut Endpoints) {
    table.member("PlaneSurface.new plane xExtents yExtents", |plane: Plane, x: Interval, y: Interval| {
        Ok(Surface::from(PlaneSurface::new(plane, x, y)?))
    });
    table.member("PlaneSurface.get_Plane this", |s: Surface| match &s {
        Surface::Plane(own) => Ok(*own.plane()),
        _ => Err(Fault::bad_request("this is no PlaneSurface")),
    });
    table.member("NurbsSurface.get_CountU this", |s: Surface| Ok(s.to_nurbs()?.count(Direction::U)));
    table.member("NurbsSurface.get_CountV this", |s: Surface| Ok(s.to_nurbs()?.count(Direction::V)));
    table.member("NurbsSurface.get_OrderU this", |s: Surface| Ok(s.to_nurbs()?.order(Direction::U)));
    table.member("NurbsSurface.get_OrderV this", |s: Surface| Ok(s.to_nurbs()?.order(Direction::V)));
    table.member("NurbsSurface.get_IsRational this", |s: Surface| Ok(s.to_nurbs()?.is_rational()));
    table.member("NurbsSurface.CreateRuledSurface curveA curveB", |a: Curve, b: Curve| {
        Ok(Surface::from(NurbsSurface::ruled(&a.to_nurbs()?, &b.to_nurbs()?)?))
    });
    table.member("NurbsSurface.CreateFromSphere sphere", |sphere: Sphere| {
        Ok(Surface::from(sphere.to_revolution().to_nurbs()?))
    });
    table.member("NurbsSurface.CreateFromTorus torus", |torus: Torus| {
        Ok(Surface::from(torus.to_revolution().to_nurbs()?))
    });
    table.member("NurbsSurface.CreateFromCylinder cylinder", |cylinder: Cylinder| {
        Ok(Surface::from(cylinder.to_revolution().to_nurbs()?))
    });
    table.member("NurbsSurface.CreateFromCone cone", |cone: Cone| {
        Ok(Surface::from(cone.to_revolution().to_nurbs()?))
    });
    table.member("NurbsSurface.IncreaseDegreeU &this desiredDegree", |s: Surface, degree: Count<1, 11>| {
        raised(&s, Direction::U, degree.0)
    });
    table.member("NurbsSurface.IncreaseDegreeV &this desiredDegree", |s: Surface, degree: Count<1, 11>| {
        raised(&s, Direction::V, degree.0)
    });
    table.member("NurbsSurface.MakeRational &this", |s: Surface| {
        Ok((true, Surface::from(s.to_nurbs()?.to_rational())))
    });
    table.member("RevSurface.CreateFromCylinder cylinder", |cylinder: Cylinder| {
        Ok(Surface::from(cylinder.to_revolution()))
    });
    table.member("RevSurface.CreateFromCone cone", |cone: Cone| Ok(Surface::from(cone.to_revolution())));
    table.member("RevSurface.get_Axis this", |s: Surface| match &s {
        Surface::Revolution(own) => Ok(own.axis()),
        _ => Err(Fault::bad_request("this is no RevSurface")),
    });
    table.member("RevSurface.get_Angle this", |s: Surface| match &s {
        Surface::Revolution(own) => Ok(own.angle()),
        _ => Err(Fault::bad_request("this is no RevSurface")),
    });
    table.member("RevSurface.get_Curve this", |s: Surface| match &s {
        Surface::Revolution(own) => Ok(own.profile().clone()),
        _ => Err(Fault::bad_request("this is no RevSurface")),
    });
    table.member("RevSurface.CreateFromSphere sphere", |sphere: Sphere| {
        Ok(Surface::from(sphere.to_revolution()))
    });
    table.member("RevSurface.CreateFromTorus torus", |torus: Torus| Ok(Surface::from(torus.to_revolution())));
    table.member("RevSurface.Create revoluteCurve axisOfRevolution", |profile: Curve, axis: Line| {
        revolved(profile, axis, 0.0, std::f64::consts::TAU)
    });
    table.member(
        "RevSurface.Create revoluteCurve axisOfRevolution startAngleRadians endAngleRadians",
        revolved,
    );
    table.member("SumSurface.Create curve extrusionDirection", |profile: Curve, direction: Vector3| {
        Ok(Surface::from(katydid_geometry::SumSurface::extrusion(profile, direction)?))
    });
    table.member("Extrusion.Create planarCurve height cap", |profile: Curve, height: f64, cap: bool| {
        let tolerance = katydid_geometry::Tolerance::default();
        let plane = profile.plane(tolerance.absolute);
        let plane = plane.ok_or_else(|| Fault::bad_request("planarCurve is not planar"))?;
        let capped = cap && profile.is_closed();
        Ok(construct::extrude(&profile, plane.z_axis * height, capped, &tolerance)?)
    });
}

/// The surface with a higher degree; a lower one than it has changes nothing.
fn raised(surface: &Surface, along: Direction, degree: usize) -> Outcome<(bool, Surface)> {
    let nurbs = surface.to_nurbs()?;
    Ok(match degree < nurbs.degree(along) {
        true => (false, surface.clone()),
        false => (true, nurbs.raised_to(along, degree)?.into()),
    })
}

fn revolved(profile: Curve, axis: Line, start: f64, end: f64) -> Outcome<Surface> {
    Ok(Surface::from(RevolutionSurface::new(profile, axis, Interval::new(start, end))?))
}

fn found<T>(shape: Option<T>) -> (bool, Option<T>) {
    (shape.is_some(), shape)
}

/// A surface with its outside: that of a face may be the other side than its surface's.
struct Sided {
    surface: Surface,
    reversed: bool,
}

impl Read for Sided {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        Ok(Self { surface: Surface::read(json)?, reversed: false })
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        let reversed = match value {
            Value::Geometry(geometry) => match &geometry.shape {
                Shape::Face(brep, place) => brep.faces().get(*place).is_some_and(|face| face.reversed),
                _ => false,
            },
            _ => false,
        };
        Ok(Self { surface: Surface::of_value(value)?, reversed })
    }

    fn type_name() -> String {
        "Surface".into()
    }
}

impl Sided {
    /// The normal, zero where there is none.
    fn normal_at(&self, u: f64, v: f64) -> Vector3 {
        let normal = self.surface.normal_at(u, v).unwrap_or(Vector3::ZERO);
        if self.reversed { -normal } else { normal }
    }
}

/// A `SurfaceCurvature`.
fn curvature(u: f64, v: f64, found: &SurfaceCurvature) -> Record {
    let [first, second] = found.principal;
    let [along_first, along_second] = found.directions;
    let fields = vec![
        ("UVPoint", Value::Point2(katydid_geometry::Point2::new(u, v))),
        ("Point", Value::Point(found.point)),
        ("Normal", Value::Vector(found.normal)),
        ("Gaussian", Value::Number(found.gaussian)),
        ("Mean", Value::Number(found.mean)),
        ("Kappa1", Value::Number(first)),
        ("Kappa2", Value::Number(second)),
        ("Direction1", Value::Vector(along_first)),
        ("Direction2", Value::Vector(along_second)),
    ];
    Record { class: "SurfaceCurvature", fields }
}
