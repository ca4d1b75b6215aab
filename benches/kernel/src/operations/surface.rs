//! Points and derivatives of surfaces.

use std::error::Error;

use katydid_geometry::Quadrant;

use super::{Operation, keep, operation};
use crate::Inputs;
use crate::timing::Contender;

/// Surface points one by one and on a grid, and first partial derivatives.
///
/// # Errors
/// The inputs lack something, or a kernel refuses it.
pub fn surface(inputs: &Inputs) -> Result<Vec<Operation>, Box<dyn Error>> {
    let mut out = Vec::new();
    let uv = inputs.uv()?;
    let steps: Vec<f64> = (0..128).map(|i| f64::from(i) / 127.0).collect();
    for (name, kind) in [("s_nr", "plain"), ("s_r", "rational")] {
        let record = inputs.surface(name)?;
        let (ours, curvo) = (record.katydid()?, record.curvo());
        let n = uv.len();
        let (a, b, c) = (ours.clone(), curvo.clone(), record.truck());
        let (s, t, r) = (uv.clone(), uv.clone(), uv.clone());
        out.push(operation(
            format!("surface point, {kind}"),
            0.35,
            "curvo",
            vec![
                Contender::new("katydid", n, move || s.iter().for_each(|&[u, v]| keep(a.point_at(u, v)))),
                Contender::new("curvo", n, move || t.iter().for_each(|&[u, v]| keep(b.point_at(u, v)))),
                Contender::new("truck", n, move || r.iter().for_each(|&[u, v]| keep(c.point(u, v)))),
            ],
        ));
        let (a, b, c) = (ours.clone(), curvo.clone(), record.truck());
        let (s, t, r) = (uv.clone(), uv.clone(), uv.clone());
        let (a2, s2) = (ours.clone(), uv.clone());
        out.push(operation(
            format!("surface point + first partials, {kind}"),
            0.15,
            "curvo",
            vec![
                Contender::new("katydid", n, move || {
                    s.iter().for_each(|&[u, v]| keep(a.partials_at(u, v, Quadrant::NorthEast)));
                }),
                Contender::new("curvo", n, move || {
                    t.iter().for_each(|&[u, v]| keep(b.rational_derivatives(u, v, 1)));
                }),
                Contender::new("truck", n, move || r.iter().for_each(|&[u, v]| keep(c.partials(u, v)))),
                Contender::new("katydid, second partials too", n, move || {
                    s2.iter().for_each(|&[u, v]| keep(a2.second_partials_at(u, v, Quadrant::NorthEast)));
                }),
            ],
        ));
        let (a, b, s, t) = (ours.clone(), curvo.clone(), steps.clone(), uv.clone());
        let (a2, s2) = (ours.clone(), steps.clone());
        out.push(operation(
            format!("surface, grid of 128×128, {kind}"),
            0.04,
            "curvo",
            vec![
                Contender::new("katydid", 128 * 128, move || keep(a.points_grid(&s, &s))),
                Contender::new("curvo", n, move || t.iter().for_each(|&[u, v]| keep(b.point_at(u, v)))),
                Contender::new("katydid with partials", 128 * 128, move || keep(a2.partials_grid(&s2, &s2))),
            ],
        ));
    }
    Ok(out)
}
