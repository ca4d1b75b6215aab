//! Curve / Spline: curves of surfaces.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{Brep, Curve, Direction, Interval, KnotSpacing, NurbsCurve, Point3, Surface, Xform};

use super::{measured, shared, warning};

/// The curves of constant parameter through a place: that along u, and that along v.
fn isocurves(brep: &Brep, at: Point3) -> Result<[Vec<Shared<Curve>>; 2], Message> {
    let [_] = brep.faces() else {
        return Err(Message::error("A Brep of several faces has no parameters: take it apart"));
    };
    let curves = |along, constant| -> Result<Vec<Shared<Curve>>, Message> {
        if let Some((surface, _)) = brep.as_surface() {
            return Ok(surface.isocurve(along, constant).ok().map(shared).into_iter().collect());
        }
        let parts = brep.face_isocurves(0, along, constant).map_err(warning)?;
        Ok(parts.into_iter().map(shared).collect())
    };
    Ok([curves(Direction::U, at.y)?, curves(Direction::V, at.x)?])
}

/// The two curves on a surface that run through a place along u and along v.
///
/// Their domains are those of the surface. Where trims cut a curve there are several. A curve that is a single point, such as at a pole, is left out.
#[component("d1d57181-d594-41e8-8efb-041e29f8a5ca", name = "Iso Curve", nick = "Iso", at = "Curve/Spline")]
#[output("U Isocurve", "U", "The curve along which u varies.")]
#[output("V Isocurve", "V", "The curve along which v varies.")]
fn iso_curve(
    /// The surface.
    #[port("Surface", "S")]
    surface: Shared<Brep>,
    /// The parameters of the place, u as x and v as y.
    #[port("UV point", "uv")]
    at: Point3,
) -> Result<(Vec<Shared<Curve>>, Vec<Shared<Curve>>), Message> {
    let [u, v] = isocurves(&surface, at)?;
    Ok((u, v))
}

/// The two curves on a surface that run through a place along u and along v.
#[component(
    "21ca41ee-bc18-4ac8-ba20-713e7edf541e",
    name = "Iso Curve",
    nick = "Iso",
    at = "Curve/Spline",
    old
)]
#[output("U Isocurve", "U", "The curve along which u varies.")]
#[output("V Isocurve", "V", "The curve along which v varies.")]
fn single_iso_curve(
    /// The surface.
    #[port("Surface", "S")]
    surface: Shared<Brep>,
    /// The parameters of the place, u as x and v as y.
    #[port("UV point", "uv")]
    at: Point3,
) -> Result<(Option<Shared<Curve>>, Option<Shared<Curve>>), Message> {
    let [u, v] = isocurves(&surface, at)?.map(|curves| curves.into_iter().next());
    Ok((u, v))
}

/// A smooth curve on a surface through places that are given by their parameters.
///
/// The parameters are joined by a cubic spline, whose image on the surface is met within the tolerance. On a flat
/// surface it is exact.
#[component(
    "ffe2dbed-9b5d-4f91-8fe3-10c8961ac2f8",
    name = "Curve On Surface",
    nick = "CrvSrf",
    at = "Curve/Spline"
)]
#[output("Curve", "C", "The curve.")]
#[output("Length", "L", "Its length.")]
#[output("Domain", "D", "Its domain.")]
fn curve_on_surface(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// The parameters of the places, u as x and v as y; at least two.
    #[port("UV coordinates", "uv")]
    uv: List<Point3>,
    /// Whether the curve returns to its start smoothly.
    #[port("Closed", "C", default = false)]
    closed: bool,
) -> Result<(Shared<Curve>, f64, Interval), Message> {
    let places: Vec<Point3> = uv.present().map(|p| Point3::new(p.x, p.y, 0.0)).collect();
    let flat = if closed {
        NurbsCurve::interpolate_periodic(3, &places, KnotSpacing::Chord)
    } else {
        NurbsCurve::interpolate(3, &places, KnotSpacing::Chord, None, None)
    };
    let flat = flat.map_err(warning)?;
    if let Surface::Plane(plane) = surface {
        // The parameters are mapped to the plane's coordinates linearly.
        let [x, y] = Direction::BOTH.map(|d| {
            let (domain, extent) = (plane.domain(d), plane.extents()[d.index()]);
            let scale = extent.length() / domain.length();
            [scale, extent.start - domain.start * scale]
        });
        let rows =
            [[x[0], 0.0, 0.0, x[1]], [0.0, y[0], 0.0, y[1]], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
        let into_plane = Xform::plane_to_plane(&katydid_geometry::Plane::XY, plane.plane());
        let there = flat.transformed(&Xform { rows }).and_then(|c| c.transformed(&into_plane));
        return Ok(measured(there.map_err(warning)?));
    }
    Ok(measured(pushed(context, surface, &flat, closed)?))
}

/// The image of a curve of parameters on a surface, within the document's tolerance: a cubic through more and more of
/// its points.
fn pushed(
    context: &Context<'_>,
    surface: &Surface,
    flat: &NurbsCurve,
    closed: bool,
) -> Result<Curve, Message> {
    /// Points beyond which it is not halved further.
    const MOST: usize = 1 << 14;
    let at = |t: f64| {
        let p = flat.point_at(t);
        surface.point_at(p.x, p.y)
    };
    let tolerance = context.tolerance().absolute.max(1e-12);
    let spans = flat.span_parameters();
    let mut parts = 4;
    loop {
        context.check()?;
        let mut places: Vec<f64> = Vec::new();
        for w in spans.windows(2) {
            let [a, b] = *w else { continue };
            places.extend((0..parts).map(|i| a + (b - a) * (i as f64 / parts as f64)));
        }
        places.extend(spans.last().copied());
        context.bytes(places.len().saturating_mul(64))?;
        let mut points: Vec<Point3> = Vec::with_capacity(places.len());
        for some in places.chunks(1 << 10) {
            context.check()?;
            points.extend(some.iter().map(|&t| at(t)));
        }
        // A closed curve is open in space when only its parameters return, which cannot be smooth.
        let returns =
            closed && points.first().zip(points.last()).is_some_and(|(a, b)| a.distance_to(*b) <= tolerance);
        let curve = if returns {
            NurbsCurve::interpolate_periodic(
                3,
                points.get(..points.len() - 1).unwrap_or(&points),
                KnotSpacing::Chord,
            )
        } else {
            NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None)
        };
        let curve = Curve::from(curve.map_err(warning)?);
        let mut worst = 0.0_f64;
        for w in places.windows(2) {
            let [a, b] = *w else { continue };
            worst = worst.max(curve.closest_point(at(0.5 * (a + b)))?.distance);
        }
        if worst <= tolerance {
            return Ok(curve);
        }
        if places.len() >= MOST {
            context.warn("The curve misses the surface by more than the tolerance");
            return Ok(curve);
        }
        parts *= 2;
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Curve, Interval, Plane, PlaneSurface, Point3, Sphere, Surface};

    fn curve(trial: Trial, output: usize) -> Curve {
        match trial.run().outputs[output].column().get(0) {
            Some(Value::Curve(curve)) => (*curve).clone(),
            other => panic!("{other:?}"),
        }
    }

    fn ball() -> Surface {
        Sphere::around(Point3::ORIGIN, 2.0).unwrap().into()
    }

    fn at(u: f64, v: f64) -> Point3 {
        Point3::new(u, v, 0.0)
    }

    #[test]
    fn isocurves() {
        let iso = || Trial::of("Iso Curve").item(ball()).item(at(0.0, 0.0));
        let equator = curve(iso(), 0);
        assert!((equator.length() - 4.0 * std::f64::consts::PI).abs() < 1e-9);
        let meridian = curve(iso(), 1);
        assert!(meridian.end().distance_to(Point3::new(0.0, 0.0, 2.0)) < 1e-14);
        let pole = Trial::of("Iso Curve").item(ball()).item(at(0.0, std::f64::consts::FRAC_PI_2));
        assert_eq!(pole.run().outputs[0].item_count(), 0);
        let old = Trial::of_guid("21ca41ee-bc18-4ac8-ba20-713e7edf541e").item(ball()).item(at(0.0, 1.0));
        assert_eq!(old.texts(0).len(), 1);
    }

    #[test]
    fn curves_on_surfaces() {
        let half = Interval::new(0.0, 1.0);
        let flat = PlaneSurface::with_domains(
            Plane::XZ,
            [Interval::new(10.0, 30.0), Interval::new(0.0, 4.0)],
            [half; 2],
        );
        let flat = Surface::from(flat.unwrap());
        let places = || [at(0.0, 0.0), at(0.5, 0.5), at(1.0, 0.0)];
        let on_flat = curve(Trial::of("Curve On Surface").item(flat.clone()).list(places()), 0);
        for p in [Point3::new(10.0, 0.0, 0.0), Point3::new(20.0, 0.0, 2.0), Point3::new(30.0, 0.0, 0.0)] {
            assert!(on_flat.closest_point(p).unwrap().distance < 1e-12, "{p:?}");
        }
        let round =
            || Trial::of("Curve On Surface").item(ball()).list([at(0.0, -1.0), at(1.0, 0.5), at(2.0, 1.0)]);
        let on_ball = curve(round(), 0);
        for i in 0..=100 {
            let p = on_ball.point_at(on_ball.domain().at(f64::from(i) / 100.0));
            assert!((p.distance_to(Point3::ORIGIN) - 2.0).abs() <= 0.001);
        }
        let looped = curve(round().item(true), 0);
        assert!(looped.start().distance_to(looped.end()) < 1e-9);
        assert!(!Trial::of("Curve On Surface").item(flat).list([at(0.0, 0.0)]).message().is_empty());
    }
}
