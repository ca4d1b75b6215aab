//! Offsets keep their distance, cross nothing, close up, and obey Steiner's law of area.

use std::f64::consts::{PI, TAU};

use katydid_geometry::{
    ClosestOnCurve, Curve, KnotSpacing, NurbsCurve, OffsetCorner, Plane, Point3, PolylineCurve, Tolerance,
    intersect::{curve_curve, curve_self},
};
use proptest::prelude::*;

const TOLERANCE: f64 = 1e-3;
const CORNERS: [OffsetCorner; 5] = [
    OffsetCorner::Round,
    OffsetCorner::Sharp,
    OffsetCorner::Chamfer,
    OffsetCorner::Smooth,
    OffsetCorner::None,
];

fn offset(c: &Curve, d: f64, corner: OffsetCorner) -> Vec<Curve> {
    c.offset(&Plane::XY, d, corner, &Tolerance { absolute: TOLERANCE, angle: 0.01 }).unwrap()
}

fn flat(points: &[(f64, f64)]) -> Vec<Point3> {
    points.iter().map(|&(x, y)| Point3::new(x, y, 0.0)).collect()
}

/// A curve of a kind: 0 to 2 closed around the origin by radii (a periodic cubic, interpolated points, a polyline),
/// 3 to 5 the same through points anywhere, 6 and 7 open, 8 a closed curve of splines that meet at kinks.
fn make(kind: usize, numbers: &[(f64, f64)]) -> Option<Curve> {
    let n = numbers.len() as f64;
    let around = |(i, &(a, b)): (usize, &(f64, f64))| {
        let angle = TAU * (i as f64 + 0.4 * b) / n;
        let r = 2.5 + 2.0 * a;
        (r * angle.cos(), r * angle.sin())
    };
    let radial: Vec<(f64, f64)> = numbers.iter().enumerate().map(around).collect();
    let anywhere: Vec<(f64, f64)> = numbers.iter().map(|&(x, y)| (5.0 * x, 5.0 * y)).collect();
    let list = flat(if kind < 3 || kind == 8 { &radial } else { &anywhere });
    let closed: Vec<Point3> = list.iter().copied().chain(list.first().copied()).collect();
    Some(match kind {
        0 | 3 => NurbsCurve::periodic_uniform(3, &list).ok()?.into(),
        1 | 4 => NurbsCurve::interpolate_periodic(3, &closed, KnotSpacing::Chord).ok()?.into(),
        2 | 5 => PolylineCurve::new(closed).ok()?.into(),
        6 => NurbsCurve::clamped_uniform(2, &list).ok()?.into(),
        7 => PolylineCurve::new(list).ok()?.into(),
        _ => {
            let bows = closed.windows(2).map(|w| {
                let side = (w[1] - w[0]).cross(katydid_geometry::Vector3::Z) * 0.3;
                Some(NurbsCurve::bezier(&[w[0], w[0].lerp(w[1], 0.5) + side, w[1]]).ok()?.into())
            });
            katydid_geometry::PolyCurve::new(bows.collect::<Option<Vec<Curve>>>()?).ok()?.into()
        }
    })
}

/// All that is wrong with an offset.
fn faults(c: &Curve, d: f64, corner: OffsetCorner) -> Vec<String> {
    let mut out = Vec::new();
    let result = match c.offset(&Plane::XY, d, corner, &Tolerance { absolute: TOLERANCE, angle: 0.01 }) {
        Ok(result) => result,
        Err(e) => return vec![format!("refused: {e}")],
    };
    let near = ClosestOnCurve::new(c);
    let mut kinks: Vec<Point3> = Vec::new();
    if matches!(corner, OffsetCorner::Chamfer | OffsetCorner::Smooth) {
        let cuts =
            c.discontinuities(katydid_geometry::Continuity::G1, &Tolerance { absolute: 1e-9, angle: 1e-7 });
        kinks.extend(cuts.iter().map(|&t| c.point_at(t)));
        kinks.push(c.start());
    }
    let (mut least, mut most) = (0.0_f64, 0.0_f64);
    for o in &result {
        for i in 0..=200 {
            let q = o.point_at(o.domain().at(f64::from(i) / 200.0));
            let found = near.nearest(q).unwrap();
            let gap = found.distance - d.abs();
            if !kinks.iter().any(|k| k.distance_to(found.point) < 1e-7) {
                least = least.min(gap);
            }
            most = most.max(gap);
        }
    }
    if least < -TOLERANCE {
        out.push(format!("too near by {least}"));
    }
    if most > TOLERANCE && corner == OffsetCorner::Round {
        out.push(format!("too far by {most}"));
    }
    let simple = c.is_closed() && curve_self(c, 1e-9).unwrap().is_empty();
    for (i, o) in result.iter().enumerate() {
        if simple && corner != OffsetCorner::None && !o.is_closed() {
            out.push(format!("open by {}, length {}", o.start().distance_to(o.end()), o.length()));
        }
        let found = curve_self(o, 1e-7).unwrap();
        if let Some(x) = found.crossings.first() {
            out.push(format!("crosses itself at {} {}, {:?}, {}", x.a, x.b, x.kind, o.domain().length()));
        }
        for other in &result[i + 1..] {
            if !curve_curve(o, other, 1e-7).unwrap().crossings.is_empty() {
                out.push("two curves cross".into());
            }
        }
    }
    if corner == OffsetCorner::Round {
        // What of the exact offset is clear of everything belongs to the result.
        let prepared: Vec<ClosestOnCurve<'_>> = result.iter().map(ClosestOnCurve::new).collect();
        let clear = |q: Point3| near.nearest(q).unwrap().distance >= d.abs() - 1e-9;
        let at = |x: f64| {
            let t = c.domain().at(x);
            let right = c.tangent_at(t)?.cross(katydid_geometry::Vector3::Z);
            Some(c.point_at(t) + right * d)
        };
        for i in 2..=198 {
            let places = [0.0, 2e-3, -2e-3].map(|s| at(f64::from(i) / 200.0 + s));
            if let [Some(q), Some(a), Some(b)] = places
                && [q, a, b].into_iter().all(clear)
            {
                let missing =
                    prepared.iter().map(|p| p.nearest(q).unwrap().distance).fold(f64::INFINITY, f64::min);
                if missing > 4.0 * TOLERANCE {
                    out.push(format!("a stretch is missing, nearest {missing}"));
                    break;
                }
            }
        }
    }
    out
}

#[test]
fn arms_within_the_tolerance_give_nothing_false() {
    // The arms of a fold lie some 0.0004 apart: the offset of the inner side of one runs that far inside the offset
    // of the outer side of the other.
    let points = [
        (3.899_094_631_972_855, 0.0),
        (-2.933_575_692_404_822_6, 2.796_566_031_360_995_5),
        (0.778_452_546_176_528_9, -2.519_122_674_812_237),
        (-1.528_606_835_019_550_7, 0.786_354_476_771_388_7),
        (0.0, 4.661_082_342_713_541),
    ];
    let c: Curve = NurbsCurve::clamped_uniform(2, &flat(&points)).unwrap().into();
    let d = -1.029_191_975_627_847;
    let out = offset(&c, d, OffsetCorner::Round);
    assert_eq!(out.len(), 2);
    assert_eq!(faults(&c, d, OffsetCorner::Round), Vec::<String>::new());
}

#[test]
fn a_figure_eight_keeps_both_outsides() {
    let eight = flat(&[(0., 0.), (3., 2.), (6., 0.), (3., -2.), (0., 0.1), (-3., 2.), (-6., 0.), (-3., -2.)]);
    let c: Curve = NurbsCurve::periodic_uniform(3, &eight).unwrap().into();
    for d in [0.3, -0.3, 0.9, -0.9] {
        let out = offset(&c, d, OffsetCorner::Round);
        assert!(!out.is_empty());
        assert_eq!(faults(&c, d, OffsetCorner::Round), Vec::<String>::new(), "{d}");
    }
}

#[test]
fn polygons_keep_their_corners_apart() {
    // The fill of one sharp corner meets the side of another.
    let c: Curve = PolylineCurve::new(flat(&[(0., 0.), (4., 0.), (4., 3.), (2.2, 0.5), (0.2, 3.), (0., 0.)]))
        .unwrap()
        .into();
    for corner in CORNERS {
        for d in [0.2, 0.5, 1.5, -0.2, -0.4] {
            assert_eq!(faults(&c, d, corner), Vec::<String>::new(), "{corner:?} {d}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn offsets_are_borders(
        kind in 0_usize..9,
        numbers in proptest::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64), 4..12),
        d in -1.6..1.6_f64,
        corner in 0_usize..5,
    ) {
        let Some(c) = make(kind, &numbers) else { return Ok(()) };
        prop_assume!(d.abs() > 0.02);
        let found = faults(&c, d, CORNERS[corner]);
        prop_assert!(found.is_empty(), "{found:?}");
    }

    #[test]
    fn areas_of_convex_curves_grow_by_steiners_law(a in 1.0..4.0_f64, b in 1.0..4.0_f64, d in 0.05..2.0_f64, n in 3_u32..9, round in any::<bool>()) {
        let points: Vec<(f64, f64)> = (0..n).map(|i| {
            let angle = TAU * f64::from(i) / f64::from(n);
            (a * angle.cos(), b * angle.sin())
        }).collect();
        let c = if round { NurbsCurve::periodic_uniform(3, &flat(&points)).unwrap().into() } else { make_closed(&points) };
        let out = offset(&c, d, OffsetCorner::Round);
        prop_assert!(out.len() == 1 && out[0].is_closed());
        let area = |c: &Curve| c.area_and_centroid(1e-9).unwrap().0;
        let grown = area(&c) + d * c.length() + PI * d * d;
        prop_assert!((area(&out[0]) - grown).abs() <= TOLERANCE * out[0].length(), "{} {grown}", area(&out[0]));
    }
}

fn make_closed(points: &[(f64, f64)]) -> Curve {
    let list = flat(points);
    let first = list.first().copied();
    PolylineCurve::new(list.into_iter().chain(first).collect()).unwrap().into()
}

/// A long run, for a change of the algorithm: `KATYDID_CASES=3000 cargo test --release … -- --ignored --nocapture`.
#[test]
#[ignore = "minutes"]
fn many() {
    let cases: u64 = std::env::var("KATYDID_CASES").ok().and_then(|s| s.parse().ok()).unwrap_or(500);
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut random = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let (mut bad, mut slowest, mut simple, mut empty) = (0, 0.0_f64, 0, 0);
    let mut kinds = std::collections::BTreeMap::new();
    for case in 0..cases {
        let kind = (random() * 9.0) as usize;
        let count = 4 + (random() * 10.0) as usize;
        let numbers: Vec<(f64, f64)> =
            (0..count).map(|_| (2.0 * random() - 1.0, 2.0 * random() - 1.0)).collect();
        let d = (0.02 + 1.6 * random()) * if random() < 0.5 { -1.0 } else { 1.0 };
        let corner = CORNERS[(random() * 5.0) as usize % 5];
        let Some(c) = make(kind, &numbers) else { continue };
        let clock = std::time::Instant::now();
        let result = c.offset(&Plane::XY, d, corner, &Tolerance { absolute: TOLERANCE, angle: 0.01 });
        slowest = slowest.max(clock.elapsed().as_secs_f64());
        simple += usize::from(c.is_closed() && curve_self(&c, 1e-9).unwrap().is_empty());
        empty += usize::from(result.is_ok_and(|r| r.is_empty()));
        let found = faults(&c, d, corner);
        if !found.is_empty() {
            bad += 1;
            *kinds.entry((kind, format!("{corner:?}"))).or_insert(0) += 1;
            println!("case {case} kind {kind} {corner:?} d {d}: {found:?}");
            if bad <= 12 {
                println!("    make({kind}, &{numbers:?})");
            }
        }
    }
    println!("{bad} of {cases} with faults, {simple} simple, {empty} empty, slowest {slowest} s; {kinds:?}");
}
