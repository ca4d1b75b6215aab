//! Surfaces, rails, families of sections, and breps to work on.

use katydid_geometry::construct;
use katydid_geometry::{
    Arc, Box3, Brep, Cone, Curve, Cylinder, Direction, Error, Interval, KnotSpacing, Line, NurbsCurve,
    NurbsSurface, Plane, PlaneSurface, Point3, PolylineCurve, Result, Sphere, SumSurface, Surface, Torus,
    Vector3, Xform,
};

use super::TOLERANCE;
use super::random::{Random, closed, curve, open};

/// Sections of a loft.
pub fn family(random: &mut Random) -> Result<Vec<Curve>> {
    let count = 2 + random.below(4);
    if random.one_in(2) {
        return (0..count)
            .map(|k| {
                let plane = Plane::XY.offset(random.between(0.5, 2.0) * random.scale * k as f64);
                closed(random, &plane)
            })
            .collect();
    }
    (0..count).map(|_| if random.one_in(8) { curve(random) } else { open(random) }).collect()
}

/// A surface of any kind, of a size that curves fit on.
pub fn surface(random: &mut Random) -> Result<Surface> {
    let (plane, k) = (random.plane(5.0), random.scale);
    Ok(match random.below(7) {
        0 => PlaneSurface::new(plane, Interval::new(-3.0 * k, 3.0 * k), Interval::new(-2.0 * k, 4.0 * k))?
            .into(),
        1 => Sphere::new(plane, random.between(2.0, 5.0) * k)?.into(),
        2 => Cylinder::new(plane, random.between(1.0, 3.0) * k, Interval::new(0.0, 6.0 * k))?.into(),
        3 => Torus::new(plane, 5.0 * k, random.between(1.0, 3.0) * k)?.into(),
        4 => Cone::new(plane, 4.0 * k, 3.0 * k)?.into(),
        5 => SumSurface::new(open(random)?, open(random)?, Vector3::ZERO)?.into(),
        _ => {
            let points: Vec<Point3> = (0..25)
                .map(|n| {
                    let height = random.between(-1.0, 1.0);
                    Point3::new(2.0 * k * f64::from(n / 5), 2.0 * k * f64::from(n % 5), k * height)
                })
                .collect();
            NurbsSurface::clamped_uniform([3, 3], [5, 5], &points)?.into()
        }
    })
}

/// A closed curve in the parameter plane of a surface, now and then over its sides.
pub fn parameter_loop(random: &mut Random, surface: &Surface) -> Result<Curve> {
    let [u, v] = Direction::BOTH.map(|d| surface.domain(d));
    let shape = closed(random, &Plane::XY)?;
    let (x, y) = (random.between(0.05, 0.95), random.between(0.05, 0.95));
    let size = random.between(0.02, 0.12);
    let map = Xform::from_columns(
        Vector3::X * (size * u.length()),
        Vector3::Y * (size * v.length()),
        Vector3::Z,
        Point3::new(u.at(x), v.at(y), 0.0),
    );
    shape.transformed(&map)
}

/// A rail as designers draw them, now and then a wild one.
pub fn rail(random: &mut Random) -> Result<Curve> {
    if random.one_in(5) {
        return curve(random);
    }
    let (plane, scale) = (random.plane(5.0), random.scale);
    Ok(match random.below(5) {
        0 => closed(random, &plane)?,
        1 => {
            let points = (0..3 + random.below(3))
                .map(|k| (Vector3::X * (2.0 * scale * k as f64) + random.vector(1.0)).to_point());
            PolylineCurve::new(points.collect())?.into()
        }
        2 => {
            let points: Vec<Point3> = (0..3 + random.below(4))
                .map(|k| (Vector3::X * (2.0 * scale * k as f64) + random.vector(1.0)).to_point())
                .collect();
            NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None)?.into()
        }
        3 => Line::new(random.point(5.0), random.point(5.0)).into(),
        _ => Arc::through(random.point(5.0), random.point(5.0), random.point(5.0))?.into(),
    })
}

/// A curve from one place of an axis to another.
pub fn on_axis(random: &mut Random, axis: &Line) -> Result<Curve> {
    let (a, b) = (axis.at(random.between(-1.0, 1.0)), axis.at(random.between(-1.0, 2.0)));
    let via = random.point(5.0);
    if random.one_in(3) {
        return Ok(Arc::through(a, via, b)?.into());
    }
    Ok(PolylineCurve::new(vec![a, via, b])?.into())
}

/// An open brep.
pub fn base(random: &mut Random) -> Result<Brep> {
    let plane = random.plane(5.0);
    match random.below(3) {
        0 => {
            let outer = closed(random, &plane)?;
            let inner = outer.transformed(&Xform::scale(plane.origin, 0.5))?;
            let found = Brep::planar_faces(&[outer, inner], &TOLERANCE)?;
            found.breps.into_iter().next().ok_or(Error::Unsupported("a region without area"))
        }
        1 => construct::extrude(&open(random)?, random.vector(4.0), false, &TOLERANCE),
        _ => construct::extrude(&closed(random, &plane)?, random.vector(4.0), false, &TOLERANCE),
    }
}

/// A brep of several faces, most of them solids.
pub fn solid(random: &mut Random) -> Result<Brep> {
    let plane = random.plane(5.0);
    let (a, b, c) = (random.size(), random.size(), random.size());
    match random.below(8) {
        0 => {
            let [x, y, z] = [a, b, c].map(|n| Interval::new(0.0, n));
            construct::box_brep(&Box3 { plane, x, y, z })
        }
        1 => construct::sphere(&Sphere::new(plane, a)?),
        2 => construct::quad_sphere(&Sphere::new(plane, a)?),
        3 => construct::cylinder(&Cylinder::new(plane, a, Interval::new(0.0, b))?, [true; 2]),
        4 => construct::cone(&Cone::new(plane, a, b)?, true),
        5 => construct::torus(&Torus::new(plane, a + b, a)?),
        6 => construct::extrude(&closed(random, &plane)?, random.vector(4.0), true, &TOLERANCE),
        _ => {
            let base = base(random)?;
            construct::extrude_brep(&base, random.vector(4.0), &TOLERANCE)
        }
    }
}
