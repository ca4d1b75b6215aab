//! How a curve or a surface bends at one place.

use katydid_geometry::{Circle, Curve, Direction, NurbsSurface, Plane, Point3, Vector3};
use katydid_scene::Origin;

use super::Subjects;
use crate::protocol::{BendView, CircleView, Probe, ProbePlace, Probed};

/// What an item, or a member of it, is.
enum Member<'a> {
    Curve(&'a Curve),
    Surface(&'a NurbsSurface),
}

/// What is at a place of what an object shows; nothing where there is no such curve or surface, or no curvature: at the
/// pole of a sphere, for one.
pub fn probe(subjects: &Subjects, probe: &Probe) -> Option<Probed> {
    let is_meant = |origin: &Origin| {
        let path = subjects.branches.get(origin.branch as usize);
        (origin.output, origin.index) == (probe.output, probe.index)
            && path.is_some_and(|path| path.to_string() == probe.path)
    };
    let curves = subjects.curves.iter().filter(|(origin, _)| is_meant(origin));
    let surfaces = subjects.surfaces().filter(|(origin, _)| is_meant(origin));
    let members: Vec<Member<'_>> = curves
        .map(|(_, curve)| Member::Curve(curve.as_ref()))
        .chain(surfaces.map(|(_, surface)| Member::Surface(surface)))
        .collect();
    let (member, parameter) = match &probe.at {
        ProbePlace::Near { point: [x, y, z] } => nearest(&members, Point3::new(*x, *y, *z))?,
        ProbePlace::Parameter { member, parameter } => (*member as usize, parameter.clone()),
    };
    let (parameter, point, bend) = match members.get(member)? {
        Member::Curve(curve) => {
            let [t] = *parameter.as_slice() else { return None };
            on_curve(curve, t)?
        }
        Member::Surface(surface) => {
            let [u, v] = *parameter.as_slice() else { return None };
            on_surface(surface, u, v)?
        }
    };
    let member = u32::try_from(member).ok()?;
    point.is_finite().then_some(Probed { member, parameter, point: point.into(), bend })
}

/// The member that comes nearest to a point, and the parameter there.
fn nearest(members: &[Member<'_>], to: Point3) -> Option<(usize, Vec<f64>)> {
    let place = |member: &Member<'_>| match member {
        Member::Curve(curve) => {
            let place = curve.closest_point(to).ok()?;
            Some((place.distance, vec![place.parameter]))
        }
        Member::Surface(surface) => {
            let place = surface.closest_point(to).ok()?;
            Some((place.distance, vec![place.u, place.v]))
        }
    };
    let places = members.iter().enumerate().filter_map(|(k, member)| Some((k, place(member)?)));
    let (k, (_, parameter)) = places.min_by(|a, b| a.1.0.total_cmp(&b.1.0))?;
    Some((k, parameter))
}

type Found = (Vec<f64>, Point3, BendView);

fn on_curve(curve: &Curve, t: f64) -> Option<Found> {
    let domain = curve.domain();
    let t = finite(t)?.clamp(domain.start, domain.end);
    let bend = BendView::Curve {
        tangent: curve.tangent_at(t).map(Into::into),
        curvature: finite(curve.curvature_at(t).length())?,
        circle: curve.osculating_circle_at(t).and_then(|circle| seen(&circle)),
    };
    Some((vec![t], curve.point_at(t), bend))
}

fn on_surface(surface: &NurbsSurface, u: f64, v: f64) -> Option<Found> {
    let [us, vs] = Direction::BOTH.map(|direction| surface.domain(direction));
    let [u, v] = [finite(u)?.clamp(us.start, us.end), finite(v)?.clamp(vs.start, vs.end)];
    let found = surface.curvature_at(u, v).ok()?;
    let section = |k: usize| {
        let (curvature, along) = (*found.principal.get(k)?, *found.directions.get(k)?);
        touching(found.point, found.normal, along, curvature)
    };
    let [greater, less] = found.principal;
    let bend = BendView::Surface {
        normal: found.normal.into(),
        principal: [finite(greater)?, finite(less)?],
        directions: found.directions.map(Into::into),
        gaussian: finite(found.gaussian)?,
        mean: finite(found.mean)?,
        circles: [section(0), section(1)],
    };
    Some((vec![u, v], found.point, bend))
}

/// The circle through a point along a direction that bends towards the normal with a curvature.
fn touching(point: Point3, normal: Vector3, along: Vector3, curvature: f64) -> Option<CircleView> {
    let out = normal * -curvature.signum();
    let radius = 1.0 / curvature.abs();
    let plane = Plane::from_axes(point - out * radius, out, along).ok()?;
    Circle::new(plane, radius).ok().and_then(|circle| seen(&circle))
}

fn seen(circle: &Circle) -> Option<CircleView> {
    let plane = &circle.plane;
    let is_finite = circle.radius.is_finite() && plane.origin.is_finite();
    is_finite.then(|| CircleView {
        centre: plane.origin.into(),
        radius: circle.radius,
        x: plane.x_axis.into(),
        y: plane.y_axis.into(),
    })
}

fn finite(x: f64) -> Option<f64> {
    Some(x).filter(|x| x.is_finite())
}
