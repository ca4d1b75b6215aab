//! Constructors of curves and surfaces from arbitrary numbers: no panic, no hang, and points of what was accepted are
//! finite where the numbers were moderate.
#![no_main]

use katydid_geometry::{
    Arc, Circle, Curve, Direction, Interval, KnotSpacing, Line, NurbsCurve, NurbsSurface, Plane, Point3,
    PolylineCurve, Surface, Tolerance, Xform,
};
use libfuzzer_sys::fuzz_target;

/// Reads small choices and numbers off the fuzzer's bytes.
struct Tape<'a>(&'a [u8]);

impl Tape<'_> {
    fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    fn below(&mut self, n: usize) -> usize {
        usize::from(self.byte()) % n
    }

    /// Mostly small and often equal numbers, now and then any bits at all.
    fn number(&mut self) -> f64 {
        match self.byte() {
            0..=199 => f64::from(self.byte() as i8) / 8.0,
            200..=229 => f64::from(self.byte() as i8) * 1e-9,
            230..=239 => f64::from(self.byte() as i8) * 1e9,
            _ => {
                let mut bits = [0; 8];
                bits.iter_mut().for_each(|b| *b = self.byte());
                f64::from_le_bytes(bits)
            }
        }
    }

    fn numbers(&mut self, n: usize) -> Vec<f64> {
        (0..n).map(|_| self.number()).collect()
    }

    fn point(&mut self) -> Point3 {
        Point3::new(self.number(), self.number(), self.number())
    }

    fn points(&mut self, n: usize) -> Vec<Point3> {
        (0..n).map(|_| self.point()).collect()
    }

    fn knots(&mut self, n: usize) -> Vec<f64> {
        let mut knots = self.numbers(n);
        // One time in four they stay as they come, decreasing as they may be.
        if self.below(4) > 0 {
            knots.sort_by(f64::total_cmp);
        }
        knots
    }
}

fn curve(tape: &mut Tape<'_>) -> Option<Curve> {
    let (kind, degree, n) = (tape.below(9), tape.below(7), tape.below(12));
    let points = tape.points(n);
    let p = |i: usize| points.get(i).copied().unwrap_or(Point3::ORIGIN);
    Some(match kind {
        0 => Line::new(p(0), p(1)).into(),
        1 => Arc::through(p(0), p(1), p(2)).ok()?.into(),
        2 => Circle::new(Plane::from_points(p(0), p(1), p(2)).ok()?, tape.number()).ok()?.into(),
        3 => PolylineCurve::new(points).ok()?.into(),
        4 => NurbsCurve::clamped_uniform(degree, &points).ok()?.into(),
        5 => NurbsCurve::periodic_uniform(degree, &points).ok()?.into(),
        6 => NurbsCurve::interpolate(degree, &points, KnotSpacing::Chord, None, None).ok()?.into(),
        7 => {
            let knots = tape.knots((n + degree).saturating_sub(1));
            NurbsCurve::new(degree, points, knots).ok()?.into()
        }
        _ => {
            let (weights, knots) = (tape.numbers(n), tape.knots((n + degree).saturating_sub(1)));
            NurbsCurve::with_weights(degree, &points, &weights, knots).ok()?.into()
        }
    })
}

fn surface(tape: &mut Tape<'_>) -> Option<NurbsSurface> {
    let degrees = [tape.below(5), tape.below(5)];
    let counts = [tape.below(7), tape.below(7)];
    let points = tape.points(counts[0] * counts[1]);
    match tape.below(4) {
        0 => NurbsSurface::clamped_uniform(degrees, counts, &points).ok(),
        1 => NurbsSurface::bezier(counts, &points).ok(),
        _ => {
            let knots = [0, 1].map(|d| tape.knots((counts[d] + degrees[d]).saturating_sub(1)));
            let weights = tape.numbers(points.len());
            NurbsSurface::with_weights(degrees, counts, &points, &weights, knots).ok()
        }
    }
}

/// Whether sums and products of these stay far from overflow.
fn moderate(points: &[Point3], weights: &[f64]) -> bool {
    points.iter().all(|p| p.to_vector().length() < 1e100)
        && weights.iter().all(|w| (1e-30..1e30).contains(w))
}

fn try_curve(c: &Curve, tape: &mut Tape<'_>) {
    let domain = c.domain();
    assert!(domain.start < domain.end, "an empty domain was accepted");
    let tame = match c {
        Curve::Nurbs(n) => moderate(&n.control_points(), &n.weights()),
        other => moderate(&other.hull_points(), &[]),
    };
    for x in [0.0, 0.37, 1.0] {
        let point = c.point_at(domain.at(x));
        assert!(!tame || point.is_finite(), "{point:?} at {x} of {c:?}");
    }
    let (t, s, q) = (tape.number(), tape.number(), tape.point());
    let _ = (c.point_at(t), c.derivatives(t, 4, false), c.frame_at(t), c.curvature_at(t), c.torsion_at(t));
    let _ = (c.length(), c.divide_by_count(5), c.closest_point(q), c.bounding_box(), c.is_closed());
    let _ = (c.trimmed(Interval::new(t, s)), c.split_at(&[t, s]), c.with_domain(Interval::new(t, s)));
    let _ = (c.transformed(&Xform::scale(q, t)), c.plane(1e-3), c.as_arc(1e-3), c.to_nurbs());
    let _ = (c.offset_in_plane(&Plane::XY, t), c.continuity_with(c, &Tolerance::default()));
    if let Curve::Nurbs(n) = c {
        let _ = (n.insert_knot(t, 1), n.raised_to(n.degree() + 1), n.split(t), n.clamped(), n.de_boor(t));
    }
}

fn try_surface(s: &NurbsSurface, tape: &mut Tape<'_>) {
    let [du, dv] = [s.domain(Direction::U), s.domain(Direction::V)];
    assert!(du.start < du.end && dv.start < dv.end, "an empty domain was accepted");
    let tame = moderate(&s.control_points(), &s.weights());
    for (x, y) in [(0.0, 0.0), (0.3, 0.8), (1.0, 1.0)] {
        let point = s.point_at(du.at(x), dv.at(y));
        assert!(!tame || point.is_finite(), "{point:?} at {x}, {y} of {s:?}");
    }
    let (u, v) = (tape.number(), tape.number());
    let direction = if tape.below(2) == 0 { Direction::U } else { Direction::V };
    let _ = (s.isocurve(direction, u), s.insert_knot(direction, u, 1), s.split(direction, u), s.bounding_box());
    let whole = Surface::from(s.clone());
    let _ = (whole.normal_at(u, v), whole.frame_at(u, v), whole.curvature_at(u, v), whole.plane(1e-3));
    let _ = (whole.transformed(&Xform::scale(Point3::ORIGIN, v)), whole.as_sphere(1e-3), whole.as_cylinder(1e-3));
}

fuzz_target!(|bytes: &[u8]| {
    let mut tape = Tape(bytes);
    if tape.below(3) == 0 {
        if let Some(s) = surface(&mut tape) {
            try_surface(&s, &mut tape);
        }
    } else if let Some(c) = curve(&mut tape) {
        try_curve(&c, &mut tape);
        if let Some(d) = curve(&mut tape) {
            let _ = katydid_geometry::join_curves(&[c, d], 1e-3, false);
        }
    }
});
