//! Surface / Freeform: surfaces through sections.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::LoftOptions;
use katydid_geometry::{
    Curve, Direction, KnotSpacing, NurbsCurve, NurbsSurface, Point3, Surface, compatible_curves,
};

use super::{shared, warning};

/// A surface through section curves, in the order of the list.
///
/// Every section is used in its own direction; sections that run against each other twist the surface. Through three
/// and more sections it is smooth, unless the options say otherwise. Between its sections it may differ a little from
/// Rhino's.
#[component("a7a41d0a-2188-4f7a-82cc-1a2c4e4ec850", name = "Loft", nick = "Loft", at = "Surface/Freeform")]
#[output("Loft", "L", "The surface: u runs along the sections, v from one to the next.", kind = Brep)]
fn loft(
    context: &Context<'_>,
    /// The sections, at least two.
    #[port("Curves", "C")]
    curves: List<Shared<Curve>>,
    /// How the sections are joined.
    #[port("Options", "O", default = LoftOptions::default())]
    options: LoftOptions,
) -> Result<Shared<Surface>, Message> {
    let mut sections: Vec<Curve> = curves.present().map(|c| (*c).clone()).collect();
    if sections.len() < 2 {
        return Err(Message::warning("A loft needs at least two sections"));
    }
    if options.adjust {
        adjust(context, &mut sections);
    }
    let sections = sections.iter().map(|c| simplified(c, &options)).collect::<Result<Vec<_>, Message>>()?;
    let mut sections = compatible_curves(&sections).map_err(warning)?;
    let controls = sections.first().map_or(0, NurbsCurve::point_count);
    context.bytes(controls.saturating_mul(sections.len()).saturating_mul(32))?;
    if sections.len() == 2 && !(options.closed && options.kind == 1) && options.kind != 4 {
        let [a, b] = sections.as_slice() else { return Err(Message::error("Internal error: two sections")) };
        return Ok(shared(NurbsSurface::ruled(a, b).map_err(warning)?));
    }
    let made = match options.kind {
        0 => smooth(&sections, KnotSpacing::Chord, options.closed),
        2 => smooth(&sections, KnotSpacing::SquareRootChord, options.closed),
        5 => smooth(&sections, KnotSpacing::Uniform, options.closed),
        1 => netted(&sections, 3, options.closed),
        3 => {
            if options.closed {
                sections.extend(sections.first().cloned());
            }
            netted(&sections, 1, false)
        }
        4 => Err(Message::error("Developable lofts cannot be made yet")),
        other => Err(Message::error(format!("There is no loft of type {other}"))),
    };
    Ok(shared(made?))
}

/// Turns open sections round whose ends lie nearer to the other ends of the section before.
fn adjust(context: &Context<'_>, sections: &mut [Curve]) {
    let tolerance = context.tolerance().absolute;
    if sections.iter().any(|c| c.start().distance_to(c.end()) <= tolerance) {
        context.warn("The seams of closed sections are used as they are: they cannot be adjusted yet");
        return;
    }
    for i in 1..sections.len() {
        let Some([before, section]) = sections.get_mut(i - 1..=i) else { continue };
        let along = before.start().distance_to(section.start()) + before.end().distance_to(section.end());
        let against = before.start().distance_to(section.end()) + before.end().distance_to(section.start());
        if against < along {
            *section = section.reversed();
        }
    }
}

/// The NURBS form of a section, rebuilt or refitted as the options say.
fn simplified(curve: &Curve, options: &LoftOptions) -> Result<NurbsCurve, Message> {
    if options.rebuild > 0 {
        let count = usize::try_from(options.rebuild).unwrap_or(2).max(2);
        return Ok(curve.rebuilt((count - 1).min(3), count, false).map_err(warning)?.curve);
    }
    if options.refit > 0.0 {
        return Ok(curve.refitted(3, options.refit).map_err(warning)?.curve);
    }
    curve.to_nurbs().map_err(warning)
}

/// One number or point of every control point of every section: all sections of the first control point, then all of
/// the next.
fn net<T>(sections: &[NurbsCurve], of: impl Fn(&NurbsCurve) -> Vec<T>) -> Vec<T> {
    let mut columns: Vec<_> = sections.iter().map(|s| of(s).into_iter()).collect();
    let n = sections.first().map_or(0, NurbsCurve::point_count);
    (0..n).flat_map(|_| columns.iter_mut().filter_map(Iterator::next).collect::<Vec<T>>()).collect()
}

/// The surface whose control points are those of the sections.
fn netted(sections: &[NurbsCurve], degree: usize, closed: bool) -> Result<NurbsSurface, Message> {
    let (Some(first), n) = (sections.first(), sections.len()) else {
        return Err(Message::error("Internal error: no sections"));
    };
    let m = first.point_count();
    let degree = degree.min(if closed { n } else { n - 1 });
    // Only the knots across are wanted of this one: the sections bring their own.
    let across = NurbsSurface::uniform([1, degree], [2, n], &vec![Point3::ORIGIN; 2 * n], [false, closed]);
    let knots = [first.knots().to_vec(), across.map_err(warning)?.knots(Direction::V).to_vec()];
    let wrapped: Vec<NurbsCurve> = if closed {
        sections.iter().chain(sections.iter().take(degree)).cloned().collect()
    } else {
        sections.to_vec()
    };
    let (degrees, counts) = ([first.degree(), degree], [m, wrapped.len()]);
    let made = if first.is_rational() {
        NurbsSurface::rational(degrees, counts, net(&wrapped, NurbsCurve::homogeneous_points), knots)
    } else {
        NurbsSurface::new(degrees, counts, net(&wrapped, NurbsCurve::control_points), knots)
    };
    made.map_err(warning)
}

/// The surface through the sections, each control point interpolated across.
fn smooth(sections: &[NurbsCurve], spacing: KnotSpacing, closed: bool) -> Result<NurbsSurface, Message> {
    let (Some(first), n) = (sections.first(), sections.len()) else {
        return Err(Message::error("Internal error: no sections"));
    };
    let m = first.point_count();
    let weights = first.weights();
    let same = |s: &NurbsCurve| s.weights().iter().zip(&weights).all(|(a, b)| (a - b).abs() <= 1e-9 * b);
    if !sections.iter().all(same) {
        return Err(Message::error(
            "Sections of different weights can only be lofted straight or loosely yet",
        ));
    }
    let degree = if closed { 3 } else { (n - 1).min(3) };
    let points = net(sections, NurbsCurve::control_points);
    // Along the sections degree 1 leaves the points as they are.
    let across = NurbsSurface::interpolate([1, degree], [m, n], &points, spacing, [false, closed]);
    let across = across.map_err(warning)?;
    let knots = [first.knots().to_vec(), across.knots(Direction::V).to_vec()];
    let (degrees, counts) = ([first.degree(), degree], across.counts());
    let made = if first.is_rational() {
        let weights: Vec<f64> = weights.iter().flat_map(|w| std::iter::repeat_n(*w, counts[1])).collect();
        NurbsSurface::with_weights(degrees, counts, &across.control_points(), &weights, knots)
    } else {
        NurbsSurface::new(degrees, counts, across.control_points(), knots)
    };
    made.map_err(warning)
}

/// How a loft joins its sections.
#[component(
    "45f19d16-1c9f-4b0f-a9a6-45a77f3d206c",
    name = "Loft Options",
    nick = "Loft Opt",
    at = "Surface/Freeform"
)]
#[output("Options", "O", "The options, for Loft.")]
fn loft_options(
    /// Whether the last section is joined to the first.
    #[port("Closed", "Cls", default = false)]
    closed: bool,
    /// Whether open sections that run against the others are turned round.
    #[port("Adjust", "Adj", default = false)]
    adjust: bool,
    /// With how many control points sections are rebuilt; 0 leaves them.
    #[port("Rebuild", "Rbd", default = 0)]
    rebuild: i32,
    /// Within what tolerance sections are refitted; 0 leaves them. Rebuilding goes first.
    #[port("Refit", "Rft", default = 0.0)]
    refit: f64,
    /// 0 smooth, 1 loose (the sections only draw the surface), 2 tight, 3 straight, 5 uniform.
    #[port("Type", "T", default = 0)]
    kind: i32,
) -> Result<LoftOptions, Message> {
    if rebuild < 0 || !(refit >= 0.0) {
        return Err(Message::error("Rebuild and refit must not be negative"));
    }
    Ok(LoftOptions { closed, adjust, kind, rebuild, refit })
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{LoftOptions, Value};
    use katydid_geometry::{Circle, Direction, Line, Plane, Point3, Surface};

    fn surface(trial: Trial) -> Surface {
        match trial.run().outputs[0].column().get(0) {
            Some(Value::Surface(surface)) => (*surface).clone(),
            other => panic!("{other:?}"),
        }
    }

    fn rings(n: usize) -> Vec<Circle> {
        let radius = |i: usize| if i % 2 == 0 { 1.0 } else { 2.0 };
        (0..n).map(|i| Circle { plane: Plane::XY.offset(i as f64), radius: radius(i) }).collect()
    }

    fn loft(sections: Vec<Circle>, options: LoftOptions) -> Trial {
        Trial::of("Loft").list(sections).item(options)
    }

    #[test]
    fn two_sections_are_ruled() {
        let cone = surface(loft(rings(2), LoftOptions::default()));
        let exact = 3.0 * std::f64::consts::PI * 2f64.sqrt();
        assert!((cone.area().unwrap().area - exact).abs() < 1e-8);
        let line = |z: f64, x: f64| Line::new(Point3::new(0.0, 0.0, z), Point3::new(x, 0.0, z));
        assert_eq!(Trial::of("Loft").list([line(0.0, 1.0)]).texts(0), ["{0}: null"]);
        assert!(Trial::of("Loft").list([line(0.0, 1.0)]).message().contains("two sections"));
        let there_and_back =
            [line(0.0, 1.0), Line::new(Point3::new(1.0, 0.0, 1.0), Point3::new(0.0, 0.0, 1.0))];
        let adjusted = LoftOptions { adjust: true, ..LoftOptions::default() };
        let flat = surface(Trial::of("Loft").list(there_and_back).item(adjusted));
        assert!((flat.area().unwrap().area - 1.0).abs() < 1e-9);
    }

    #[test]
    fn sections_lie_on_the_surface_but_for_loose_ones() {
        for kind in [0, 2, 3, 5] {
            let made = surface(loft(rings(4), LoftOptions { kind, ..LoftOptions::default() }));
            for ring in rings(4) {
                for angle in [0.0, 0.7, 2.0, 5.0] {
                    assert!(made.closest_point(ring.at(angle)).unwrap().distance < 1e-9, "{kind}");
                }
            }
        }
        let loose = surface(loft(rings(4), LoftOptions { kind: 1, ..LoftOptions::default() }));
        let inside = rings(4)[1].at(0.7);
        assert!(loose.closest_point(inside).unwrap().distance > 0.1);
        assert!(
            loft(rings(3), LoftOptions { kind: 4, ..LoftOptions::default() })
                .message()
                .contains("Developable")
        );
        assert!(
            loft(rings(3), LoftOptions { kind: 9, ..LoftOptions::default() }).message().contains("type 9")
        );
    }

    #[test]
    fn closed_lofts_return() {
        // Four circles round an axis.
        let axes = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
        let round = || {
            axes.map(|(x, y)| {
                let (out, up) = ([x, y, 0.0].into(), [0.0, 0.0, 1.0].into());
                let plane = Plane::from_axes(Point3::new(3.0 * x, 3.0 * y, 0.0), out, up).unwrap();
                Circle { plane, radius: 1.0 }
            })
            .to_vec()
        };
        for kind in [0, 1, 3] {
            let made = surface(loft(round(), LoftOptions { closed: true, kind, ..LoftOptions::default() }));
            assert!(made.is_closed(Direction::V) && made.is_closed(Direction::U), "{kind}");
        }
    }

    #[test]
    fn options_go_from_one_to_the_other() {
        let made = Trial::of("Loft Options").item(true).item(false).item(0).item(0.0).item(3).run();
        let out = made.outputs[0].column().get(0);
        assert_eq!(out, Some(Value::from(LoftOptions { closed: true, kind: 3, ..LoftOptions::default() })));
        let rebuilt = loft(rings(3), LoftOptions { rebuild: 12, ..LoftOptions::default() });
        assert_eq!(rebuilt.texts(0), ["{0}: Untrimmed Surface"]);
        assert!(Trial::of("Loft Options").item(true).item(false).item(-1).message().contains("negative"));
    }
}
