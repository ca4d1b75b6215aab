//! Things added up by shares: what tweens and averages of each type are.

use std::sync::Arc as Shared;

use katydid_component::Message;
use katydid_data::Colour;
use katydid_geometry::{
    Curve, Direction, Interval, Mesh, NurbsCurve, NurbsSurface, Plane, Point3, PolylineCurve, Quaternion,
    Surface, Vector3, Xform, combined_curves,
};

/// What can be added up by shares.
pub(super) trait Mix: Sized {
    /// The sum of things times their shares. What cannot be added up as it stands is replaced within the tolerance.
    ///
    /// # Errors
    /// The things do not go together, or the sum is none of them.
    fn mix(parts: &[(Self, f64)], tolerance: f64) -> Result<Self, Message>;
}

fn sum<T>(parts: &[(T, f64)], number: impl Fn(&T) -> f64) -> f64 {
    parts.iter().map(|(thing, share)| number(thing) * share).sum()
}

impl Mix for f64 {
    fn mix(parts: &[(Self, f64)], _: f64) -> Result<Self, Message> {
        Ok(sum(parts, |x| *x))
    }
}

impl Mix for Interval {
    fn mix(parts: &[(Self, f64)], _: f64) -> Result<Self, Message> {
        Ok(Self::new(sum(parts, |d| d.start), sum(parts, |d| d.end)))
    }
}

impl Mix for Point3 {
    fn mix(parts: &[(Self, f64)], _: f64) -> Result<Self, Message> {
        Ok(Self::new(sum(parts, |p| p.x), sum(parts, |p| p.y), sum(parts, |p| p.z)))
    }
}

impl Mix for Vector3 {
    fn mix(parts: &[(Self, f64)], _: f64) -> Result<Self, Message> {
        Ok(Self::new(sum(parts, |p| p.x), sum(parts, |p| p.y), sum(parts, |p| p.z)))
    }
}

impl Mix for Colour {
    fn mix(parts: &[(Self, f64)], _: f64) -> Result<Self, Message> {
        let channel = |of: fn(&Self) -> u8| sum(parts, |c| f64::from(of(c))).round().clamp(0.0, 255.0) as u8;
        Ok(Self::argb(channel(|c| c.a), channel(|c| c.r), channel(|c| c.g), channel(|c| c.b)))
    }
}

impl Mix for Xform {
    fn mix(parts: &[(Self, f64)], _: f64) -> Result<Self, Message> {
        let mut mixed = Self::IDENTITY;
        for (i, row) in mixed.rows.iter_mut().enumerate() {
            for (j, x) in row.iter_mut().enumerate() {
                *x = sum(parts, |map| map.rows.get(i).and_then(|row| row.get(j)).copied().unwrap_or(0.0));
            }
        }
        Ok(mixed)
    }
}

impl Mix for Plane {
    fn mix(parts: &[(Self, f64)], tolerance: f64) -> Result<Self, Message> {
        let origins: Vec<(Point3, f64)> = parts.iter().map(|(plane, share)| (plane.origin, *share)).collect();
        let along = |of: fn(&Self) -> Vector3| {
            let axes: Vec<(Vector3, f64)> = parts.iter().map(|(plane, share)| (of(plane), *share)).collect();
            Vector3::mix(&axes, tolerance)
        };
        let (x, y) = (along(|p| p.x_axis)?, along(|p| p.y_axis)?);
        Self::from_axes(Point3::mix(&origins, tolerance)?, x, y).map_err(|_| {
            Message::error("Axes that are opposite each other have no mean: turn by quaternions")
        })
    }
}

/// A plane a share of the way to another one, turned about one axis all the way.
pub(super) fn turned(a: &Plane, b: &Plane, share: f64) -> Result<Plane, Message> {
    let origin = a.origin.lerp(b.origin, share);
    let turn = Quaternion::between_planes(a, b).unitized().and_then(|q| q.pow(share));
    let axes = turn.and_then(|q| Some((q.rotate(a.x_axis)?, q.rotate(a.y_axis)?)));
    let (x, y) = axes.ok_or_else(|| Message::error("The planes have no turn between them"))?;
    Ok(Plane::from_axes(origin, x, y)?)
}

/// Curves over 0 to 1, so that points of equal parameters belong together.
fn over_unit(curves: &[Shared<Curve>]) -> Result<Vec<NurbsCurve>, Message> {
    let polylines: Option<Vec<Vec<Point3>>> = curves.iter().map(|curve| curve.as_polyline()).collect();
    match polylines {
        // Corners are matched by the lengths up to them, so that polylines of different counts keep their shapes.
        Some(polylines) => polylines.into_iter().map(by_length).collect(),
        None => {
            curves.iter().map(|curve| Ok(curve.with_domain(Interval::UNIT)?.to_nurbs()?.clamped()?)).collect()
        }
    }
}

/// A polyline over 0 to 1 in proportion to its length.
fn by_length(points: Vec<Point3>) -> Result<NurbsCurve, Message> {
    let mut parameters = Vec::with_capacity(points.len());
    let mut far = 0.0;
    let mut last: Option<Point3> = None;
    for p in &points {
        far += last.map_or(0.0, |last| last.distance_to(*p));
        parameters.push(far);
        last = Some(*p);
    }
    if !(far > 0.0) {
        return Err(Message::error("A polyline has no length"));
    }
    let parameters = parameters.into_iter().map(|t| t / far).collect();
    Ok(Curve::from(PolylineCurve::with_parameters(points, parameters)?).to_nurbs()?)
}

impl Mix for Shared<Curve> {
    fn mix(parts: &[(Self, f64)], tolerance: f64) -> Result<Self, Message> {
        if let [(curve, share)] = parts
            && *share == 1.0
        {
            return Ok(curve.clone());
        }
        if parts.is_empty() {
            return Err(Message::warning("There are no curves"));
        }
        let curves: Vec<Self> = parts.iter().map(|(curve, _)| curve.clone()).collect();
        let shares = parts.iter().map(|(_, share)| *share);
        let parts: Vec<(NurbsCurve, f64)> = over_unit(&curves)?.into_iter().zip(shares).collect();
        Ok(Self::new(Curve::from(combined_curves(&parts, tolerance)?)))
    }
}

/// Surfaces over 0 to 1 with the same degrees and knots.
fn compatible_surfaces(surfaces: &[Shared<Surface>]) -> Result<Vec<NurbsSurface>, Message> {
    const BOTH: [Direction; 2] = [Direction::U, Direction::V];
    /// Knots nearer to each other than this part of the domain are one.
    const SAME: f64 = 1e-9;
    let mut all: Vec<NurbsSurface> = Vec::with_capacity(surfaces.len());
    for surface in surfaces {
        let mut nurbs = surface.to_nurbs()?;
        for direction in BOTH {
            nurbs = nurbs.clamped(direction)?.with_domain(direction, Interval::UNIT)?;
        }
        all.push(nurbs);
    }
    for direction in BOTH {
        let degree = all.iter().map(|s| s.degree(direction)).max().unwrap_or(1);
        for surface in &mut all {
            *surface = surface.raised_to(direction, degree)?;
        }
        // The knots of all, each as often as the surface that has it most often.
        let mut knots: Vec<(f64, usize)> = Vec::new();
        for surface in &all {
            for (t, times) in counted(surface.knots(direction), SAME) {
                match knots.iter_mut().find(|(known, _)| (known - t).abs() <= SAME) {
                    Some((_, most)) => *most = times.max(*most),
                    None => knots.push((t, times)),
                }
            }
        }
        for surface in &mut all {
            let own = counted(surface.knots(direction), SAME);
            let mut missing: Vec<f64> = Vec::new();
            for (t, times) in &knots {
                let has = own.iter().find(|(known, _)| (known - t).abs() <= SAME).map_or(0, |(_, has)| *has);
                missing.extend(std::iter::repeat_n(*t, times.saturating_sub(has)));
            }
            missing.sort_by(f64::total_cmp);
            *surface = surface.refined(direction, &missing)?;
        }
    }
    let counts = all.first().map(NurbsSurface::counts);
    if all.iter().any(|s| Some(s.counts()) != counts) {
        return Err(Message::error("The surfaces' knots lie too close together to be merged"));
    }
    Ok(all)
}

/// The knots inside 0 to 1 with how often each is there.
fn counted(knots: &[f64], same: f64) -> Vec<(f64, usize)> {
    let mut found: Vec<(f64, usize)> = Vec::new();
    for t in knots.iter().copied().filter(|t| *t > same && *t < 1.0 - same) {
        match found.last_mut() {
            Some((known, times)) if (t - *known).abs() <= same => *times += 1,
            _ => found.push((t, 1)),
        }
    }
    found
}

impl Mix for Shared<Surface> {
    fn mix(parts: &[(Self, f64)], _: f64) -> Result<Self, Message> {
        let surfaces: Vec<Self> = parts.iter().map(|(surface, _)| surface.clone()).collect();
        let surfaces = compatible_surfaces(&surfaces)?;
        let first = surfaces.first().ok_or_else(|| Message::warning("There are no surfaces"))?;
        let mut points = vec![[0.0; 4]; first.point_count()];
        for (surface, (_, share)) in surfaces.iter().zip(parts) {
            for (point, own) in points.iter_mut().zip(surface.homogeneous_points()) {
                for (x, own) in point.iter_mut().zip(own) {
                    *x += own * share;
                }
            }
        }
        let knots = [Direction::U, Direction::V].map(|d| first.knots(d).to_vec());
        let surface = NurbsSurface::rational(first.degrees(), first.counts(), points, knots)?;
        Ok(Self::new(Surface::from(surface.to_non_rational().unwrap_or(surface))))
    }
}

impl Mix for Shared<Mesh> {
    fn mix(parts: &[(Self, f64)], _: f64) -> Result<Self, Message> {
        let (first, _) = parts.first().ok_or_else(|| Message::warning("There are no meshes"))?;
        if parts
            .iter()
            .any(|(m, _)| m.vertices().len() != first.vertices().len() || m.faces() != first.faces())
        {
            return Err(Message::error("The meshes do not have the same vertices and faces"));
        }
        let points = (0..first.vertices().len()).map(|i| {
            let at = |m: &Self| m.vertices().get(i).copied().unwrap_or(Point3::ORIGIN);
            Point3::new(sum(parts, |m| at(m).x), sum(parts, |m| at(m).y), sum(parts, |m| at(m).z))
        });
        let coloured = parts.iter().all(|(m, _)| m.colours().len() == first.vertices().len());
        let colours = match coloured {
            false => Vec::new(),
            true => (0..first.vertices().len())
                .map(|i| {
                    std::array::from_fn(|k| {
                        let channel = |m: &Self| m.colours().get(i).map_or(0.0, |c| f64::from(c[k]));
                        sum(parts, channel).round().clamp(0.0, 255.0) as u8
                    })
                })
                .collect(),
        };
        let mesh = Mesh::from_parts(points.collect(), first.faces().to_vec(), Vec::new(), colours)?;
        Ok(Self::new(mesh.with_normals()))
    }
}
