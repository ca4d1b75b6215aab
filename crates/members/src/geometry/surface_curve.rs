//! Curves on surfaces, through places that are given by parameters or by points.

use katydid_geometry::{ClosestOnSurface, Curve, KnotSpacing, NurbsCurve, Point3, Surface};

use super::answer::Outcome;
use super::argument::{Some1, Waiting, Within};
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add(
        "surface/interpolatedcurveonsurfaceuv-surface_point2darray_double",
        |s: Surface, places: Places, t: Within, w: Waiting| through(&s, &places.0, false, t, &w),
    );
    table.add(
        "surface/interpolatedcurveonsurfaceuv-surface_point2darray_double_bool_int",
        |s: Surface, places: Places, t: Within, closed: bool, _: i32, w: Waiting| {
            through(&s, &places.0, closed, t, &w)
        },
    );
    table.add(
        "surface/interpolatedcurveonsurface-surface_point3darray_double",
        |s: Surface, points: Places, t: Within, w: Waiting| {
            let nearest = ClosestOnSurface::new(&s)?;
            let place =
                |p: &Point3| Ok(nearest.nearest(*p).map(|found| Point3::new(found.u, found.v, 0.0))?);
            let places = points.0.iter().map(place).collect::<Outcome<Vec<Point3>>>()?;
            through(&s, &places, false, t, &w)
        },
    );
    table.add(
        "nurbssurface/createcurveonsurface-surface_point2darray_double_bool",
        |s: Surface, places: Places, t: Within, periodic: bool, w: Waiting| {
            through(&s, &places.0, periodic, t, &w)
        },
    );
}

type Places = Some1<Point3>;

/// Points beyond which an image is not made finer.
const MOST: usize = 1 << 14;

/// The image on a surface of the cubic through places in its parameter plane, within a tolerance: a cubic through more
/// and more of its points. A place outside the domain counts as the nearest inside.
fn through(
    surface: &Surface,
    places: &[Point3],
    closed: bool,
    tolerance: Within,
    waiting: &Waiting,
) -> Outcome<Curve> {
    let flat: Vec<Point3> = places.iter().map(|p| Point3::new(p.x, p.y, 0.0)).collect();
    let flat = cubic(&flat, closed)?;
    let [u, v] = katydid_geometry::Direction::BOTH.map(|direction| surface.domain(direction));
    let image = |t: f64| {
        let p = flat.point_at(t);
        surface.point_at(p.x.clamp(u.start, u.end), p.y.clamp(v.start, v.end))
    };
    let spans = flat.span_parameters();
    let mut parts = 4_usize;
    loop {
        waiting.check()?;
        let mut stops: Vec<f64> = Vec::new();
        for pair in spans.windows(2) {
            let [a, b] = *pair else { continue };
            stops.extend((0..parts).map(|k| a + (b - a) * k as f64 / parts as f64));
        }
        stops.extend(spans.last().copied());
        let mut points: Vec<Point3> = stops.iter().map(|t| image(*t)).collect();
        let ends = points.first().zip(points.last());
        // One whose parameters return, but not its image, closes with a corner at best.
        let returns = closed && ends.is_some_and(|(a, b)| a.distance_to(*b) <= tolerance.0);
        if returns {
            points.pop();
        }
        let curve = Curve::from(cubic(&points, returns)?);
        let middle = |pair: &[f64]| 0.5 * (pair.iter().sum::<f64>());
        let mut worst = 0.0_f64;
        for pair in stops.windows(2) {
            worst = worst.max(curve.closest_point(image(middle(pair)))?.distance);
        }
        if worst <= tolerance.0 {
            return Ok(curve);
        }
        if stops.len() > MOST {
            return Err(Fault::failed(format!("the curve cannot be followed within {}", tolerance.0)));
        }
        parts *= 2;
    }
}

fn cubic(points: &[Point3], closed: bool) -> Outcome<NurbsCurve> {
    Ok(if closed {
        NurbsCurve::interpolate_periodic(3, points, KnotSpacing::Chord)?
    } else {
        NurbsCurve::interpolate(3, points, KnotSpacing::Chord, None, None)?
    })
}
