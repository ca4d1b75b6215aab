//! Offsets of random closed curves of every kind: they keep their distance, cross nothing and close up.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

use katydid_geometry::intersect::{ContactKind, Crossing, curve_curve, curve_self};
use katydid_geometry::{
    Arc, ClosestOnCurve, Continuity, Curve, Error, KnotSpacing, Line, NurbsCurve, OffsetCorner, Plane,
    Point3, PolyCurve, PolylineCurve, Tolerance, Vector3, clamped_uniform_knots, periodic_uniform_knots,
};

const TOLERANCE: Tolerance = Tolerance { absolute: 1e-3, angle: 0.01 };
const CORNERS: [OffsetCorner; 5] = [
    OffsetCorner::Round,
    OffsetCorner::Sharp,
    OffsetCorner::Chamfer,
    OffsetCorner::Smooth,
    OffsetCorner::None,
];

/// Random numbers by SplitMix64: each case has a seed of its own, so that it can be run alone.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn below(&mut self, n: usize) -> usize {
        ((self.unit() * n as f64) as usize).min(n - 1)
    }
}

fn wrapped<T: Copy>(list: &[T], more: usize) -> Vec<T> {
    list.iter().chain(list.iter().cycle().take(more)).copied().collect()
}

/// Points around the origin, or anywhere (then the curve mostly crosses itself), or on a grid.
fn places(r: &mut Random, count: usize) -> Vec<Point3> {
    let how = r.below(8);
    (0..count)
        .map(|i| {
            let angle = TAU * (i as f64 + r.between(-0.4, 0.4)) / count as f64;
            let radius = r.between(0.5, 4.5);
            let (x, y) = match how {
                0 | 1 => (r.between(-5.0, 5.0), r.between(-5.0, 5.0)),
                2 => (3.0 * angle.cos(), 2.0 * angle.sin()),
                3 => ((radius * angle.cos()).round(), (radius * angle.sin()).round()),
                _ => (radius * angle.cos(), radius * angle.sin()),
            };
            Point3::new(x, y, 0.0)
        })
        .collect()
}

/// One side of a poly-curve: a segment, an arc, or a Bézier curve of degree 2 to 4.
fn side(r: &mut Random, a: Point3, b: Point3, kind: usize) -> Option<Curve> {
    let across = (b - a).cross(Vector3::Z);
    Some(match kind {
        0 => Line::new(a, b).into(),
        1 => Arc::through(a, a.lerp(b, r.between(0.3, 0.7)) + across * r.between(-0.6, 0.6), b).ok()?.into(),
        _ => {
            let degree = 2 + r.below(3);
            let inner = (1..degree).map(|i| {
                a.lerp(b, (i as f64 + r.between(-0.4, 0.4)) / degree as f64) + across * r.between(-0.5, 0.5)
            });
            let points: Vec<Point3> = std::iter::once(a).chain(inner).chain([b]).collect();
            NurbsCurve::bezier(&points).ok()?.into()
        }
    })
}

/// A polygon whose corners are rounded by tangent arcs.
fn rounded(corners: &[Point3], share: f64) -> Option<Curve> {
    let n = corners.len();
    let mut parts: Vec<Curve> = Vec::new();
    let mut last: Option<Point3> = None;
    for i in 0..=n {
        let (a, v, b) = (corners[(i + n - 1) % n], corners[i % n], corners[(i + 1) % n]);
        let cut = share * v.distance_to(a).min(v.distance_to(b));
        let (p, q) = (v + (a - v).unitized()? * cut, v + (b - v).unitized()? * cut);
        if let Some(last) = last {
            parts.push(Line::new(last, p).into());
        }
        if i < n {
            parts.push(Arc::from_start_direction_end(p, v - p, q).ok()?.into());
        }
        last = Some(q);
    }
    Some(PolyCurve::new(parts).ok()?.into())
}

const KINDS: [&str; 10] = [
    "periodic",
    "periodic rational",
    "closed at a kink",
    "closed at a kink, rational",
    "interpolated",
    "full knots",
    "poly-curve",
    "polyline",
    "rounded polygon",
    "lines and arcs",
];

fn closed_curve(r: &mut Random, kind: usize) -> Option<Curve> {
    let degree = 2 + r.below(4);
    let count = (degree + 1).max(3) + r.below(9);
    let list = places(r, count);
    let ring = wrapped(&list, 1);
    let mut weights: Vec<f64> = (0..count).map(|_| (2.0 * r.unit() - 1.0).exp()).collect();
    Some(match kind {
        0 => NurbsCurve::periodic_uniform(degree, &list).ok()?.into(),
        1 => {
            let points = wrapped(&list, degree);
            let knots = periodic_uniform_knots(degree, points.len()).ok()?;
            NurbsCurve::with_weights(degree, &points, &wrapped(&weights, degree), knots).ok()?.into()
        }
        2 => NurbsCurve::clamped_uniform(degree, &ring).ok()?.into(),
        3 => {
            weights.push(r.between(0.5, 2.0));
            let knots = clamped_uniform_knots(degree, ring.len()).ok()?;
            NurbsCurve::with_weights(degree, &ring, &weights, knots).ok()?.into()
        }
        4 => NurbsCurve::interpolate_periodic(3, &ring, KnotSpacing::Chord).ok()?.into(),
        5 => {
            // Bézier curves end to end in one curve, with kinks.
            let mut points = vec![*list.first()?];
            for w in ring.windows(2) {
                let across = (w[1] - w[0]).cross(Vector3::Z);
                for i in 1..degree {
                    let on = w[0].lerp(w[1], i as f64 / degree as f64);
                    points.push(on + across * r.between(-0.4, 0.4));
                }
                points.push(w[1]);
            }
            let knots = (0..=count).flat_map(|i| std::iter::repeat_n(i as f64, degree)).collect();
            NurbsCurve::new(degree, points, knots).ok()?.into()
        }
        6 | 9 => {
            let mixed = if kind == 6 { 3 } else { 2 };
            let mut parts = Vec::new();
            for w in ring.windows(2) {
                let which = r.below(mixed);
                parts.push(side(r, w[0], w[1], which)?);
            }
            PolyCurve::new(parts).ok()?.into()
        }
        7 => PolylineCurve::new(ring).ok()?.into(),
        _ => rounded(&list, r.between(0.1, 0.5))?,
    })
}

struct Case {
    kind: usize,
    curve: Curve,
    distance: f64,
    corner: OffsetCorner,
}

fn case(seed: u64) -> Option<Case> {
    let mut r = Random(seed.wrapping_mul(0xd134_2543_de82_ef95));
    let kind = r.below(KINDS.len());
    let curve = closed_curve(&mut r, kind)?;
    let size = match r.below(4) {
        0 => (r.between(0.003_f64.ln(), 6.0_f64.ln())).exp(),
        1 => [0.25, 0.5, 1.0, 1.5, 2.0][r.below(5)],
        _ => r.between(0.02, 1.6),
    };
    let distance = if r.unit() < 0.5 { size } else { -size };
    let corner = CORNERS[r.below(CORNERS.len())];
    curve.is_closed().then_some(Case { kind, curve, distance, corner })
}

/// Whether two curves truly cross at a contact, and do not only touch there.
fn crosses(c: &Crossing, a: &Curve, b: &Curve) -> bool {
    let directions = |curve: &Curve, t: f64| -> Option<[f64; 2]> {
        let domain = curve.domain();
        let (mut before, mut after) = (t, t);
        if curve.is_closed() && t <= domain.start {
            before = domain.end;
        } else if curve.is_closed() && t >= domain.end {
            after = domain.start;
        }
        let back = -curve.tangent_on_side(before, true)?;
        let ahead = curve.tangent_on_side(after, false)?;
        Some([back.y.atan2(back.x), ahead.y.atan2(ahead.x)])
    };
    let (Some(p), Some(q)) = (directions(a, c.a), directions(b, c.b)) else { return true };
    let from = |x: f64| (x - p[0]).rem_euclid(TAU);
    let (limit, s, t) = (from(p[1]), from(q[0]), from(q[1]));
    let clear = |x: f64| x.min(TAU - x).min((x - limit).abs()) > 1e-3;
    if !(clear(s) && clear(t)) {
        // They run beside each other: what the finer look says.
        return c.kind == ContactKind::Transversal && c.gap < 1e-12 && (s < limit) != (t < limit);
    }
    (s < limit) != (t < limit)
}

/// The ends of the spans of a curve.
fn spans(curve: &Curve) -> Vec<f64> {
    match curve {
        Curve::Nurbs(c) => c.span_parameters(),
        Curve::Polyline(c) => c.parameters().to_vec(),
        Curve::Poly(c) => {
            let own = |(i, s)| spans(s).into_iter().map(move |t| c.from_segment_parameter(i, t));
            c.segments().iter().enumerate().flat_map(own).collect()
        }
        Curve::Line(_) | Curve::Arc(_) => vec![curve.domain().start, curve.domain().end],
    }
}

/// All that is wrong with an offset.
fn faults(case: &Case, result: &[Curve]) -> Vec<String> {
    let Case { curve, distance, corner, .. } = case;
    let mut out = Vec::new();
    let near = ClosestOnCurve::new(curve);
    let reach = distance.abs();
    // A chamfer or blend comes nearer to its corner, and to nothing else.
    let mut kinks: Vec<Point3> = Vec::new();
    if matches!(corner, OffsetCorner::Chamfer | OffsetCorner::Smooth) {
        let tight = Tolerance { absolute: 1e-9, angle: 1e-7 };
        kinks.extend(curve.discontinuities(Continuity::G1, &tight).iter().map(|&t| curve.point_at(t)));
        kinks.push(curve.start());
        let stands = |t: &f64| [true, false].iter().any(|&below| curve.tangent_on_side(*t, below).is_none());
        kinks.extend(spans(curve).into_iter().filter(stands).map(|t| curve.point_at(t)));
    }
    let (mut least, mut most) = ((0.0_f64, Point3::ORIGIN, Point3::ORIGIN), 0.0_f64);
    for o in result {
        if let Curve::Poly(c) = o
            && c.largest_gap() > 0.1 * TOLERANCE.absolute
        {
            out.push(format!("has a gap of {}", c.largest_gap()));
        }
        let mut stops = spans(o);
        let step = o.domain().length() / 60.0;
        stops.extend((0..60).map(|i| o.domain().start + step * f64::from(i)));
        stops.sort_by(f64::total_cmp);
        for w in stops.windows(2) {
            for i in 0..4 {
                let q = o.point_at(w[0] + (w[1] - w[0]) * f64::from(i) / 4.0);
                let gap = near.nearest(q).unwrap().distance - reach;
                most = most.max(gap);
                if gap >= -TOLERANCE.absolute {
                    continue;
                }
                let at_kink = |p: Point3| kinks.iter().any(|k| k.distance_to(p) < 1e-7);
                let others = curve.local_closest_points(q).unwrap();
                if let Some(f) = others.iter().find(|f| !at_kink(f.point))
                    && f.distance - reach < least.0
                {
                    least = (f.distance - reach, q, f.point);
                }
            }
        }
    }
    if least.0 < -TOLERANCE.absolute {
        out.push(format!("too near: {least:?}"));
    }
    if most > TOLERANCE.absolute && *corner == OffsetCorner::Round {
        out.push(format!("too far by {most}"));
    }
    let simple = curve_self(curve, 1e-9).unwrap().is_empty();
    for (i, o) in result.iter().enumerate() {
        if *corner != OffsetCorner::None && !o.is_closed() {
            let gap = o.start().distance_to(o.end());
            if simple {
                out.push(format!("open by {gap}, length {}", o.length()));
            } else {
                // Where a curve crosses itself, one side of its border ends at the other.
                for q in [o.start(), o.end()] {
                    let domain = curve.domain();
                    let side = |t: f64, p: Point3| {
                        // At a kink, and at the seam, either direction may say so.
                        let ends = [t, if t <= domain.start { domain.end } else { domain.start }];
                        let seam = t <= domain.start || t >= domain.end;
                        let at = |(&t, below)| curve.tangent_on_side(t, below);
                        let ends = ends.iter().take(1 + usize::from(seam));
                        let found = ends.flat_map(|t| [(t, true), (t, false)]).filter_map(at);
                        found.map(|d| (q - p).cross(d).z * distance.signum()).fold(f64::INFINITY, f64::min)
                    };
                    let seen = curve.local_closest_points(q).unwrap().into_iter().any(|f| {
                        (f.distance - reach).abs() < 4.0 * TOLERANCE.absolute
                            && side(f.parameter, f.point) < 1e-2 * reach
                    });
                    if !seen {
                        out.push(format!("ends at {q:?} by {gap}, length {}", o.length()));
                    }
                }
            }
        }
        let found = curve_self(o, 1e-7).unwrap();
        if let Some(x) = found.crossings.iter().find(|x| crosses(x, o, o)) {
            out.push(format!("crosses itself at {} {}, {:?}, {:?}", x.a, x.b, x.kind, o.domain()));
        }
        for other in &result[i + 1..] {
            let found = curve_curve(o, other, 1e-7).unwrap();
            if let Some(x) = found.crossings.iter().find(|x| crosses(x, o, other)) {
                out.push(format!("two cross at {:?}", x.point));
            }
        }
    }
    if *corner == OffsetCorner::Round
        && let Some(missing) = missing(case, &near, result)
    {
        out.push(format!("a stretch is missing, nearest {missing}"));
    }
    out
}

/// What of the exact offset is clear of everything belongs to the result; how far it is from it if not.
fn missing(case: &Case, near: &ClosestOnCurve<'_>, result: &[Curve]) -> Option<f64> {
    let Case { curve, distance, .. } = case;
    let prepared: Vec<ClosestOnCurve<'_>> = result.iter().map(ClosestOnCurve::new).collect();
    let clear = |q: Point3| near.nearest(q).unwrap().distance >= distance.abs() - 1e-9;
    let at = |x: f64| {
        let t = curve.domain().at(x);
        Some(curve.point_at(t) + curve.tangent_at(t)?.cross(Vector3::Z) * *distance)
    };
    for i in 2..=398 {
        let places = [0.0, 2e-3, -2e-3].map(|s| at(f64::from(i) / 400.0 + s));
        if let [Some(q), Some(a), Some(b)] = places
            && [q, a, b].into_iter().all(clear)
            && a.distance_to(b) > 4.0 * TOLERANCE.absolute
        {
            let gap = prepared.iter().map(|p| p.nearest(q).unwrap().distance).fold(f64::INFINITY, f64::min);
            if gap > 4.0 * TOLERANCE.absolute {
                return Some(gap);
            }
        }
    }
    None
}

#[derive(Default)]
struct Tally {
    cases: usize,
    simple: usize,
    empty: usize,
    refused: usize,
    bad: usize,
    kinds: BTreeMap<String, usize>,
    seconds: f64,
    slowest: (f64, u64),
    lines: Vec<String>,
}

fn examine(seed: u64, tally: &Mutex<Tally>) {
    let Some(case) = case(seed) else { return };
    if std::env::var_os("KATYDID_CASE").is_some() {
        println!("{:?}", case.curve);
    }
    let clock = std::time::Instant::now();
    let result = case.curve.offset(&Plane::XY, case.distance, case.corner, &TOLERANCE);
    let seconds = clock.elapsed().as_secs_f64();
    let name = format!("{:?} of {}", case.corner, KINDS[case.kind]);
    let found = match &result {
        Ok(result) => faults(&case, result),
        Err(Error::Invalid { .. }) => Vec::new(),
        Err(e) => vec![format!("refused: {e}")],
    };
    let mut tally = tally.lock().unwrap();
    tally.cases += 1;
    tally.seconds += seconds;
    if seconds > tally.slowest.0 {
        tally.slowest = (seconds, seed);
    }
    tally.simple += usize::from(curve_self(&case.curve, 1e-9).unwrap().is_empty());
    tally.empty += usize::from(result.as_ref().is_ok_and(Vec::is_empty));
    if let Err(e) = &result {
        tally.refused += 1;
        tally.lines.push(format!("case {seed}: {name} at {}: {e}", case.distance));
    }
    if !found.is_empty() {
        tally.bad += 1;
        *tally.kinds.entry(name.clone()).or_default() += 1;
        tally.lines.push(format!("case {seed}: {name} at {}: {found:?}", case.distance));
    }
}

/// A case of a long run that went wrong once: a corner at the foot of a perpendicular.
#[test]
fn offsets_that_failed() {
    let tally = Mutex::new(Tally::default());
    examine(60_110, &tally);
    let tally = tally.into_inner().unwrap();
    assert_eq!((tally.cases, tally.bad), (1, 0), "{:?}", tally.lines);
}

/// `KATYDID_CASES=10000 cargo test --release --test curves closed_offsets -- --nocapture` for a long run, `KATYDID_CASE=7`
/// for one case alone.
#[test]
fn offsets_of_random_closed_curves() {
    let number = |name: &str| std::env::var(name).ok().and_then(|s| s.parse::<u64>().ok());
    let (first, end) = match number("KATYDID_CASE") {
        Some(one) => (one, one + 1),
        None => (number("KATYDID_FIRST").unwrap_or(0), number("KATYDID_CASES").unwrap_or(300)),
    };
    let tally = Mutex::new(Tally::default());
    let next = AtomicU64::new(first);
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let seed = next.fetch_add(1, Ordering::Relaxed);
                    if seed >= end {
                        break;
                    }
                    examine(seed, &tally);
                }
            });
        }
    });
    let t = tally.into_inner().unwrap();
    for line in &t.lines {
        println!("{line}");
    }
    println!(
        "{} of {} with faults, {} simple, {} empty, {} refused, {:.1} ms each, slowest {:.2} s (case {}); {:#?}",
        t.bad,
        t.cases,
        t.simple,
        t.empty,
        t.refused,
        1e3 * t.seconds / t.cases.max(1) as f64,
        t.slowest.0,
        t.slowest.1,
        t.kinds
    );
    assert_eq!(t.bad, 0);
    assert!(t.refused * 200 <= t.cases, "{} of {} refused", t.refused, t.cases);
}
