//! Closest points.

use std::error::Error;

use katydid_geometry::{ClosestOnCurve, ClosestOnSurface, Curve};

use super::{Operation, keep, operation};
use crate::Inputs;
use crate::timing::Contender;

/// The closest point on a curve, and on a surface.
///
/// # Errors
/// The inputs lack something, or a kernel refuses it.
pub fn closest(inputs: &Inputs) -> Result<Vec<Operation>, Box<dyn Error>> {
    let mut out = Vec::new();
    for (name, kind) in [("c_nr", "plain"), ("c_r", "rational")] {
        let record = inputs.curve(name)?;
        let ours: Curve = record.katydid()?.into();
        let curvo = record.curvo()?;
        let queries = inputs.points("q_curve")?.to_vec();
        let theirs: Vec<_> = queries.iter().map(|p| nalgebra::Point3::new(p.x, p.y, p.z)).collect();
        let n = queries.len();
        let (a, b, c, once) = (ours.clone(), curvo.clone(), ours.clone(), queries.clone());
        out.push(operation(
            format!("closest point on a curve, {kind}"),
            1.0,
            "curvo",
            vec![
                // Made anew for each batch, so that its share of the time counts.
                Contender::new("katydid", n, move || {
                    let ready = ClosestOnCurve::new(&a);
                    queries.iter().for_each(|&q| keep(ready.nearest(q)));
                }),
                Contender::new("curvo", n, move || {
                    theirs.iter().for_each(|q| keep(b.find_closest_parameter(q)));
                }),
                Contender::new("katydid, one question a curve", once.len(), move || {
                    once.iter().for_each(|&q| keep(c.closest_point(q)));
                }),
            ],
        ));
    }
    // 50 µs where curvo's curve point takes 32 ns; curvo's own search of a surface takes 0.4 s a question.
    let (curvo, t) = (inputs.curve("c_nr")?.curvo()?, inputs.t()?);
    for (name, kind) in [("s_nr", "plain"), ("s_r", "rational")] {
        let ours = inputs.surface(name)?.katydid()?;
        let queries = inputs.points("q_surf")?.to_vec();
        let (n, yard, t) = (queries.len(), curvo.clone(), t.clone());
        out.push(operation(
            format!(
                "closest point on a surface, {kind}, against 50,000 ns where curvo's curve point takes 32"
            ),
            50_000.0 / 32.0,
            "curvo point",
            vec![
                // The index is made anew for each batch, so that its share of the time counts.
                Contender::new("katydid", n, move || {
                    let ready = ClosestOnSurface::of_nurbs(&ours);
                    queries.iter().for_each(|&q| keep(ready.nearest(q)));
                }),
                Contender::new("curvo point", t.len(), move || {
                    t.iter().for_each(|&t| keep(yard.point_at(t)));
                }),
            ],
        ));
    }
    Ok(out)
}
