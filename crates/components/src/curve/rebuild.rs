//! Curve / Util and Division: the same curve with another structure, or in parts that bend alike.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_geometry::{Curve, MAX_DEGREE, Point3, Vector3};

use super::{shared, warning};

/// The degree to use: the one asked for, or that of the curve.
fn degree(asked: Option<i32>, curve: &Curve) -> Result<usize, Message> {
    match asked {
        None => Ok(curve.to_nurbs()?.degree().min(11)),
        Some(n) => usize::try_from(n)
            .ok()
            .filter(|n| (1..=MAX_DEGREE.min(11)).contains(n))
            .ok_or_else(|| Message::error(format!("A degree of {n} is not possible: it goes from 1 to 11"))),
    }
}

/// A smooth curve that follows another one with few evenly spaced control points.
///
/// It is fitted to points at equal lengths, so that a small count also smooths. A closed smooth curve stays closed and
/// smooth. There must be more control points than the degree: with fewer the degree is lowered, with a warning.
#[component("9333c5b3-11f9-423c-bbb5-7e5156430219", name = "Rebuild Curve", nick = "ReB", at = "Curve/Util")]
#[output("Curve", "C", "The new curve.")]
fn rebuild_curve(
    context: &Context<'_>,
    /// The curve to follow.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The degree, 1 to 11; that of the curve when nothing is given.
    #[port("Degree", "D")]
    degree_: Option<i32>,
    /// The number of control points, at least 2.
    #[port("Count", "N", default = 10)]
    count: i32,
    /// Whether the directions at the ends are kept.
    #[port("Tangents", "T", default = false)]
    tangents: bool,
) -> Result<Shared<Curve>, Message> {
    let wanted = degree(degree_, curve)?;
    let count = usize::try_from(count).ok().filter(|&n| n >= 2).ok_or_else(|| {
        Message::error(format!("{count} control points make no curve: there must be at least 2"))
    })?;
    context.items(count)?;
    let degree = wanted.min(count - 1);
    if degree < wanted {
        context.warn(format!("{count} control points are too few for degree {wanted}: it is {degree} here"));
    }
    Ok(shared(curve.rebuilt(degree, count, tangents).map_err(warning)?.curve))
}

/// A curve of a degree with as few control points as a tolerance allows. Kinks stay.
#[component("a3f9f19e-3e6c-4ac7-97c3-946de32c3e8e", name = "Fit Curve", nick = "Fit", at = "Curve/Util")]
#[output("Curve", "C", "The new curve.")]
fn fit_curve(
    context: &Context<'_>,
    /// The curve to follow.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The degree, 1 to 11; that of the curve when nothing is given.
    #[port("Degree", "D")]
    degree_: Option<i32>,
    /// How far the new curve may stray, above 0; the document's tolerance when nothing is given.
    #[port("Tolerance", "Ft")]
    tolerance: Option<f64>,
) -> Result<Shared<Curve>, Message> {
    let tolerance = tolerance.unwrap_or(context.tolerance().absolute);
    Ok(shared(curve.refitted(degree(degree_, curve)?, tolerance).map_err(warning)?.curve))
}

/// Cuts a curve into segments that stray equally far from their chords: short ones where it bends much.
///
/// A straight curve is cut into equal lengths.
#[component(
    "6e9c0577-ae4a-4b21-8880-0ec3daf3eb4d",
    name = "Divide By Deviation",
    nick = "DivideDev",
    at = "Curve/Division"
)]
#[output("Points", "P", "The points between segments; both ends of an open curve are among them.")]
#[output("Tangents", "T", "The directions there, of length 1.")]
#[output("Parameters", "t", "The parameters there.")]
#[output("Deviation", "d", "For each segment its largest distance from its chord.")]
fn divide_by_deviation(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The number of segments, 1 to 10,000.
    #[port("Count", "N", default = 10)]
    count: i32,
) -> Result<(Vec<Point3>, Vec<Option<Vector3>>, Vec<f64>, Vec<f64>), Message> {
    let n = usize::try_from(count).unwrap_or(0);
    context.items(n.saturating_mul(4))?;
    let (parameters, deviations) = curve.divide_by_deviation(n)?;
    let tangents = parameters.iter().map(|&t| curve.tangent_at(t)).collect();
    Ok((curve.points_at(&parameters), tangents, parameters, deviations))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Circle, Curve, Line, Plane, Point3, PolylineCurve};

    fn curve(trial: Trial) -> Curve {
        let outcome = trial.run();
        match outcome.outputs[0].column().get(0) {
            Some(Value::Curve(curve)) => (*curve).clone(),
            other => panic!("{other:?} {:?}", outcome.messages),
        }
    }

    #[test]
    fn rebuilt_and_fitted() {
        let circle = Circle { plane: Plane::XY, radius: 5.0 };
        let rebuild = |d: i32, n: i32| Trial::of("Rebuild Curve").item(circle).item(d).item(n);
        let Curve::Nurbs(round) = curve(rebuild(3, 12)) else { panic!("a NURBS curve") };
        assert!(round.degree() == 3 && Curve::from(round.clone()).is_periodic());
        assert!((Curve::from(round).length() - 10.0 * std::f64::consts::PI).abs() < 0.01);
        assert!(rebuild(5, 3).message().contains("too few"));
        assert!(rebuild(0, 9).message().contains("degree of 0"));
        assert!(rebuild(3, 1).message().contains("at least 2"));
        let line = Line::new(Point3::ORIGIN, Point3::new(9.0, 0.0, 0.0));
        let Curve::Nurbs(own) = curve(Trial::of("Rebuild Curve").item(line)) else { panic!("a NURBS curve") };
        assert_eq!((own.degree(), own.point_count()), (1, 10));
        let Curve::Nurbs(fit) = curve(Trial::of("Fit Curve").item(circle).item(3).item(0.01)) else {
            panic!("a NURBS curve")
        };
        assert!(fit.point_count() < 60 && !fit.is_rational());
        for k in 0..100 {
            let p = fit.point_at(fit.domain().at(f64::from(k) / 100.0));
            assert!((p.distance_to(Point3::ORIGIN) - 5.0).abs() < 0.01);
        }
        assert!(!Trial::of("Fit Curve").item(circle).item(3).item(0.0).message().is_empty());
    }

    #[test]
    fn equal_deviations() {
        let circle = Circle { plane: Plane::XY, radius: 2.0 };
        let parts = Trial::of("Divide By Deviation").item(circle).item(4).run().outputs;
        assert_eq!((parts[0].item_count(), parts[3].item_count()), (4, 4));
        assert_eq!(texts(&parts[3]), ["{0;0}: 0.585786, 0.585786, 0.585786, 0.585786"]);
        let bent = PolylineCurve::new(
            [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0]].map(|[x, y]| Point3::new(x, y, 0.0)).into(),
        );
        let whole = Trial::of("Divide By Deviation").item(Curve::from(bent.unwrap())).item(1);
        assert_eq!(whole.texts(3), ["{0;0}: 2.4"]);
        assert!(!Trial::of("Divide By Deviation").item(circle).item(0).message().is_empty());
    }
}
