//! Measures every operation beside curvo and prints a table: `cargo run --release -p katydid-kernel-bench --bin
//! ratios [WORD…]`. With words only the operations whose names hold one of them.

use std::error::Error;
use std::hint::black_box;
use std::time::Duration;

use katydid_geometry::{
    ClosestOnCurve, Curve, KnotSpacing, NurbsCurve, Point3, Quadrant, Vector3, Xform, intersect,
};
use katydid_kernel_bench::Inputs;
use katydid_kernel_bench::timing::{Contender, compete};

/// Lets no result be optimised away.
fn keep<T>(result: T) {
    black_box(result);
}

/// One line of the table.
struct Row<'a> {
    operation: String,
    /// The most that Katydid may take, as a part of the peer's time.
    wanted: f64,
    contenders: Vec<Contender<'a>>,
    /// By name: other contenders that are printed but not compared.
    peer: &'static str,
}

fn row<'a>(operation: impl Into<String>, wanted: f64, peer: &'static str, c: Vec<Contender<'a>>) -> Row<'a> {
    Row { operation: operation.into(), wanted, contenders: c, peer }
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let inputs = Inputs::read()?;
    println!("| operation | Katydid ns | peer ns | ratio | wanted | met | others ns |");
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    let chosen = |r: &Row<'_>| words.is_empty() || words.iter().any(|w| r.operation.contains(w.as_str()));
    for mut row in rows(&inputs)?.into_iter().filter(chosen) {
        let slow = row.contenders.iter().map(|c| c.items).max() == Some(1);
        let (rounds, turn) =
            if slow { (9, Duration::from_millis(3)) } else { (61, Duration::from_micros(700)) };
        compete(&mut row.contenders, rounds, turn);
        print(&row);
    }
    Ok(())
}

fn print(row: &Row<'_>) {
    let of = |name: &str| row.contenders.iter().find(|c| c.name == name).map(Contender::typical);
    let (ours, peer) = (of("katydid").unwrap_or(f64::NAN), of(row.peer).unwrap_or(f64::NAN));
    let others: Vec<String> = row
        .contenders
        .iter()
        .filter(|c| c.name != "katydid" && c.name != row.peer)
        .map(|c| format!("{} {}", c.name, number(c.typical())))
        .collect();
    let ratio = ours / peer;
    let met = if ratio <= row.wanted { "yes" } else { "**no**" };
    println!(
        "| {} | {} | {} {} | {ratio:.4} | {} | {met} | {} |",
        row.operation,
        number(ours),
        row.peer,
        number(peer),
        row.wanted,
        others.join(", ")
    );
}

fn number(x: f64) -> String {
    if x < 100.0 { format!("{x:.1}") } else { format!("{x:.0}") }
}

fn rows(inputs: &Inputs) -> Result<Vec<Row<'static>>, Box<dyn Error>> {
    let mut out = curves(inputs)?;
    out.extend(surfaces(inputs)?);
    out.extend(measures(inputs)?);
    out.extend(crossings(inputs)?);
    out.extend(constructions(inputs)?);
    Ok(out)
}

/// Points and derivatives of curves.
fn curves(inputs: &Inputs) -> Result<Vec<Row<'static>>, Box<dyn Error>> {
    let mut out = Vec::new();
    let t = inputs.t()?;
    let sorted: Vec<f64> = (0..10_000).map(|i| f64::from(i) / 10_000.0).collect();
    for (name, kind, point, batch) in [("c_nr", "plain", 0.35, 0.15), ("c_r", "rational", 0.45, 0.2)] {
        let record = inputs.curve(name)?;
        let (ours, curvo) = (record.katydid()?, record.curvo()?);
        let n = t.len();
        let (a, b, c) = (ours.clone(), curvo.clone(), record.truck());
        let (s, u, v) = (t.clone(), t.clone(), t.clone());
        out.push(row(
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
        out.push(row(
            format!("curve points, 10,000 sorted, {kind}"),
            batch,
            "curvo",
            vec![
                Contender::new("katydid", s.len(), move || keep(a.points_at(&s))),
                Contender::new("curvo", n, move || u.iter().for_each(|&t| keep(b.point_at(t)))),
                Contender::new("katydid in place", s2.len(), move || {
                    a2.points_into(&s2, &mut places);
                    black_box(&places);
                }),
            ],
        ));
        let (a, b, c) = (ours.clone(), curvo.clone(), record.truck());
        let (s, u, v) = (t.clone(), t.clone(), t.clone());
        let (a2, s2) = (ours.clone(), sorted.clone());
        let (a3, s3) = (ours.clone(), t.clone());
        let mut places = vec![[Vector3::ZERO; 3]; s2.len()];
        out.push(row(
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
                    black_box(&places);
                }),
                Contender::new("katydid derivatives_into", n, move || {
                    let mut d = [Vector3::ZERO; 3];
                    for &t in &s3 {
                        a3.derivatives_into(t, false, &mut d);
                        black_box(&d);
                    }
                }),
            ],
        ));
    }
    Ok(out)
}

/// Points and derivatives of surfaces.
fn surfaces(inputs: &Inputs) -> Result<Vec<Row<'static>>, Box<dyn Error>> {
    let mut out = Vec::new();
    let uv = inputs.uv()?;
    let steps: Vec<f64> = (0..128).map(|i| f64::from(i) / 127.0).collect();
    for (name, kind) in [("s_nr", "plain"), ("s_r", "rational")] {
        let record = inputs.surface(name)?;
        let (ours, curvo) = (record.katydid()?, record.curvo());
        let n = uv.len();
        let (a, b, c) = (ours.clone(), curvo.clone(), record.truck());
        let (s, t, r) = (uv.clone(), uv.clone(), uv.clone());
        out.push(row(
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
        out.push(row(
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
        out.push(row(
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

/// Closest points, lengths.
fn measures(inputs: &Inputs) -> Result<Vec<Row<'static>>, Box<dyn Error>> {
    let mut out = Vec::new();
    for (name, kind) in [("c_nr", "plain"), ("c_r", "rational")] {
        let record = inputs.curve(name)?;
        let ours: Curve = record.katydid()?.into();
        let curvo = record.curvo()?;
        let queries = inputs.points("q_curve")?.to_vec();
        let theirs: Vec<_> = queries.iter().map(|p| nalgebra::Point3::new(p.x, p.y, p.z)).collect();
        let n = queries.len();
        let (a, b, c, once) = (ours.clone(), curvo.clone(), ours.clone(), queries.clone());
        out.push(row(
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
        let (a, b) = (ours.clone(), curvo.clone());
        out.push(row(
            format!("length, {kind}"),
            0.3,
            "curvo",
            vec![
                Contender::new("katydid", 1, move || keep(a.length())),
                Contender::new("curvo", 1, move || keep(b.try_length())),
            ],
        ));
        let (a, b) = (ours.clone(), curvo.clone());
        out.push(row(
            format!("parameter at length, 1,000 on one curve, {kind}"),
            0.03,
            "curvo",
            vec![
                Contender::new("katydid", 1000, move || {
                    let table = katydid_geometry::ArcLength::new(&a);
                    for i in 0..1000 {
                        black_box(table.parameter_at(table.total() * f64::from(i) / 1000.0));
                    }
                }),
                Contender::new("curvo", 50, {
                    let total = b.try_length()?;
                    move || {
                        for i in 0..50 {
                            black_box(
                                b.try_parameter_at_length(total * f64::from(i) / 50.0, Some(1e-9)).ok(),
                            );
                        }
                    }
                }),
            ],
        ));
    }
    Ok(out)
}

/// Curves that cross.
fn crossings(inputs: &Inputs) -> Result<Vec<Row<'static>>, Box<dyn Error>> {
    use curvo::prelude::{CurveIntersectionSolverOptions, Intersects};
    let mut out = Vec::new();
    for (a, b, operation, wanted) in [
        ("cc_a", "cc_b", "curve with curve, 7 crossings", 1.0),
        ("wv_a", "wv_b", "curve with curve, two weaving cubics with 67 crossings", 0.6),
    ] {
        let (a, b) = (inputs.curve(a)?, inputs.curve(b)?);
        let ours: [Curve; 2] = [a.katydid()?.into(), b.katydid()?.into()];
        let theirs = [a.curvo_flat()?, b.curvo_flat()?];
        let tight = theirs.clone();
        let options = CurveIntersectionSolverOptions::default()
            .with_minimum_distance(1e-9)
            .with_step_size_tolerance(1e-14)
            .with_cost_tolerance(1e-20);
        out.push(row(
            operation,
            wanted,
            "curvo",
            vec![
                Contender::new("katydid", 1, move || keep(intersect::curve_curve(&ours[0], &ours[1], 1e-9))),
                Contender::new("curvo", 1, move || {
                    keep(theirs[0].find_intersection(&theirs[1], None).ok());
                }),
                Contender::new("curvo to 1e-13", 1, move || {
                    keep(tight[0].find_intersection(&tight[1], Some(options.clone())).ok());
                }),
            ],
        ));
    }
    Ok(out)
}

/// Interpolation, higher degrees, transforms.
fn constructions(inputs: &Inputs) -> Result<Vec<Row<'static>>, Box<dyn Error>> {
    use curvo::prelude::Interpolation;
    let mut out = Vec::new();
    let points = inputs.points("interp1000")?.to_vec();
    let theirs: Vec<_> = points.iter().map(|p| nalgebra::Point3::new(p.x, p.y, p.z)).collect();
    out.push(row(
        "interpolate 1,000 points",
        0.003,
        "curvo",
        vec![
            Contender::new("katydid", 1, move || {
                black_box(NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None).ok());
            }),
            Contender::new("curvo", 1, move || {
                black_box(curvo::prelude::NurbsCurve3D::interpolate(&theirs, 3).ok());
            }),
        ],
    ));
    // openNURBS raises the degree in 6.5 µs where curvo's point takes 32 ns: 1 µs on that scale is 31 of curvo's
    // points.
    let record = inputs.curve("c_nr")?;
    let (ours, curvo) = (record.katydid()?, record.curvo()?);
    let (t, u) = (inputs.t()?, ours.clone());
    out.push(row(
        "raise degree 3→4, against 1,000 ns where curvo's point takes 32",
        1000.0 / 32.0,
        "curvo point",
        vec![
            Contender::new("katydid", 100, move || (0..100).for_each(|_| keep(ours.raised_to(4)))),
            Contender::new("curvo point", t.len(), move || {
                t.iter().for_each(|&t| keep(curvo.point_at(t)));
            }),
            Contender::new("katydid insert knot", 100, move || {
                (0..100).for_each(|_| keep(u.insert_knot(0.4321, 1)));
            }),
        ],
    ));
    let many: Vec<Point3> = (0..1_000_000).map(|i| Point3::new(f64::from(i), 1.0, -2.0)).collect();
    let turn = Xform::rotation(0.7, Vector3::new(0.3, 0.4, 0.5), Point3::new(1.0, 2.0, 3.0))?;
    let (mut a, b, mut to) = (many.clone(), many.clone(), many.clone());
    out.push(row(
        "transform 1,000,000 points in place",
        1.3,
        "copy",
        vec![
            Contender::new("katydid", many.len(), move || {
                turn.transform_points(&mut a);
                black_box(&a);
            }),
            Contender::new("copy", many.len(), move || {
                to.copy_from_slice(&b);
                black_box(&to);
            }),
        ],
    ));
    Ok(out)
}
