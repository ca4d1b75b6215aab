//! Points and derivatives of curves.

use std::error::Error;

use katydid_geometry::{Point3, Vector3};

use super::{Operation, keep, operation};
use crate::Inputs;
use crate::timing::Contender;

/// Curve points one by one and sorted, and derivatives.
///
/// # Errors
/// The inputs lack something, or a kernel refuses it.
pub fn evaluate(inputs: &Inputs) -> Result<Vec<Operation>, Box<dyn Error>> {
    let mut out = Vec::new();
    let t = inputs.t()?;
    let sorted: Vec<f64> = (0..10_000).map(|i| f64::from(i) / 10_000.0).collect();
    for (name, kind, point, batch) in [("c_nr", "plain", 0.35, 0.15), ("c_r", "rational", 0.45, 0.2)] {
        let record = inputs.curve(name)?;
        let (ours, curvo) = (record.katydid()?, record.curvo()?);
        let n = t.len();
        let (a, b, c) = (ours.clone(), curvo.clone(), record.truck());
        let (s, u, v) = (t.clone(), t.clone(), t.clone());
        out.push(operation(
            format!("curve point, {kind}"),
            point,
            "curvo",
            vec![
                Contender::new("katydid", n, move || s.iter().for_each(|&t| keep(a.point_at(t)))),
                Contender::new("curvo", n, move || u.iter().for_each(|&t| keep(b.point_at(t)))),
                Contender::new("truck", n, move || v.iter().for_each(|&t| keep(c.point(t)))),
            ],
        ));
        let (a, b, s, u) = (ours.clone(), curvo.clone(), sorted.clone(), t.clone());
        let mut places = vec![Point3::ORIGIN; s.len()];
        let (a2, s2) = (ours.clone(), sorted.clone());
        out.push(operation(
            format!("curve points, 10,000 sorted, {kind}"),
            batch,
            "curvo",
            vec![
                Contender::new("katydid", s.len(), move || keep(a.points_at(&s))),
                Contender::new("curvo", n, move || u.iter().for_each(|&t| keep(b.point_at(t)))),
                Contender::new("katydid in place", s2.len(), move || {
                    a2.points_into(&s2, &mut places);
                    keep(&places);
                }),
            ],
        ));
        let (a, b, c) = (ours.clone(), curvo.clone(), record.truck());
        let (s, u, v) = (t.clone(), t.clone(), t.clone());
        let (a2, s2) = (ours.clone(), sorted.clone());
        let (a3, s3) = (ours.clone(), t.clone());
        let mut places = vec![[Vector3::ZERO; 3]; s2.len()];
        out.push(operation(
            format!("curve point + 2 derivatives, {kind}"),
            0.2,
            "curvo",
            vec![
                Contender::new("katydid", n, move || {
                    s.iter().for_each(|&t| keep(a.jet_at::<3>(t, false)));
                }),
                Contender::new("curvo", n, move || {
                    u.iter().for_each(|&t| keep(b.rational_derivatives(t, 2)));
                }),
                Contender::new("truck", n, move || v.iter().for_each(|&t| keep(c.jet(t)))),
                Contender::new("katydid, 10,000 sorted", s2.len(), move || {
                    a2.jets_into(&s2, &mut places);
                    keep(&places);
                }),
                Contender::new("katydid derivatives_into", n, move || {
                    let mut d = [Vector3::ZERO; 3];
                    for &t in &s3 {
                        a3.derivatives_into(t, false, &mut d);
                        keep(&d);
                    }
                }),
            ],
        ));
    }
    Ok(out)
}
