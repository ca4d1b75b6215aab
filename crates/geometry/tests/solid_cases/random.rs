//! Random numbers from a seed, and random curves, many of them degenerate.

use katydid_geometry::{
    Arc, Circle, Curve, Ellipse, Interval, KnotSpacing, Line, NurbsCurve, Plane, Point3, PolyCurve,
    PolylineCurve, Result, Vector3,
};

/// The generator splitmix64 (S. Vigna), and how large what it makes is.
pub struct Random {
    state: u64,
    /// What lengths are multiplied by.
    pub scale: f64,
}

impl Random {
    /// That of a seed. Every eighth makes things of a size from 1e-6 to 1e6, the others of a few units.
    pub fn of(seed: u64) -> Self {
        let power = (seed / 8 % 13) as i32 - 6;
        let scale = if seed % 8 == 7 { 10.0_f64.powi(power) } else { 1.0 };
        Self { state: seed, scale }
    }

    pub fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    /// Whether an event of chance one in `n` happens.
    pub fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    pub fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * ((self.next() >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// A direction, of any length up to √3.
    pub fn way(&mut self) -> Vector3 {
        Vector3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0))
    }

    pub fn vector(&mut self, size: f64) -> Vector3 {
        self.way() * (size * self.scale)
    }

    /// A point, now and then on a grid so that coincidences happen.
    pub fn point(&mut self, size: f64) -> Point3 {
        let p = self.way() * size;
        let p = if self.one_in(4) { Vector3::new(p.x.round(), p.y.round(), p.z.round()) } else { p };
        (p * self.scale).to_point()
    }

    pub fn plane(&mut self, size: f64) -> Plane {
        if self.one_in(3) {
            return Plane::XY;
        }
        let (origin, x, y) = (self.point(size), self.way(), self.way());
        Plane::from_axes(origin, x, y).unwrap_or(Plane::XY)
    }

    pub fn range(&mut self, size: f64) -> Interval {
        let size = size * self.scale;
        let (a, b) = (self.between(-size, size), self.between(-size, size));
        if self.one_in(20) { Interval::new(a, a) } else { Interval::new(a.min(b), a.max(b)) }
    }

    /// A number that is now and then 0, negative, tiny or not finite.
    pub fn size(&mut self) -> f64 {
        match self.below(24) {
            0 => 0.0,
            1 => -1.0,
            2 => 1e-7,
            3 => f64::NAN,
            4 => f64::INFINITY,
            5 => 1e4,
            _ => self.between(0.1, 5.0) * self.scale,
        }
    }
}

/// A closed planar curve.
pub fn closed(random: &mut Random, plane: &Plane) -> Result<Curve> {
    let (r, scale) = (random.between(0.2, 4.0), random.scale);
    let at = |x: f64, y: f64| plane.at(x * scale, y * scale, 0.0);
    Ok(match random.below(6) {
        0 => Circle::new(*plane, r * scale)?.into(),
        1 => Ellipse { plane: *plane, rx: r * scale, ry: (0.3 * r + 0.1) * scale }.to_nurbs()?.into(),
        2 => {
            let mut corners = vec![at(-r, -1.0), at(r, -1.0), at(r, 1.0), at(-r, 1.0)];
            corners.push(corners[0]);
            PolylineCurve::new(corners)?.into()
        }
        3 => {
            let count = 3 + random.below(6);
            let mut corners: Vec<Point3> = (0..count)
                .map(|k| {
                    let angle = std::f64::consts::TAU * k as f64 / count as f64;
                    let reach = random.between(0.3, 1.0) * r;
                    at(reach * angle.cos(), reach * angle.sin())
                })
                .collect();
            corners.push(corners[0]);
            PolylineCurve::new(corners)?.into()
        }
        4 => {
            // A slot: lines and arcs that meet smoothly.
            let (a, b, c, d) = (at(-r, -1.0), at(r, -1.0), at(r, 1.0), at(-r, 1.0));
            let arcs = [Arc::through(b, at(r + 1.0, 0.0), c)?, Arc::through(d, at(-r - 1.0, 0.0), a)?];
            let segments =
                vec![Line::new(a, b).into(), arcs[0].into(), Line::new(c, d).into(), arcs[1].into()];
            PolyCurve::new(segments)?.into()
        }
        _ => {
            let count = 4 + random.below(6);
            let points: Vec<Point3> = (0..count)
                .map(|k| {
                    let angle = std::f64::consts::TAU * k as f64 / count as f64;
                    let reach = random.between(0.5, 1.0) * r;
                    at(reach * angle.cos(), reach * angle.sin())
                })
                .collect();
            NurbsCurve::interpolate_periodic(3, &points, KnotSpacing::Chord)?.into()
        }
    })
}

/// An open curve in space.
pub fn open(random: &mut Random) -> Result<Curve> {
    let size = 5.0;
    Ok(match random.below(8) {
        0 => Line::new(random.point(size), random.point(size)).into(),
        1 => Arc::through(random.point(size), random.point(size), random.point(size))?.into(),
        2 => {
            let count = 2 + random.below(5);
            PolylineCurve::new((0..count).map(|_| random.point(size)).collect())?.into()
        }
        3 => {
            let count = 3 + random.below(6);
            let points: Vec<Point3> = (0..count).map(|_| random.point(size)).collect();
            NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None)?.into()
        }
        4 => {
            // A gentle wave, as designers draw them.
            let count = 4 + random.below(6);
            let (step, scale) = (random.between(0.5, 2.0), random.scale);
            let points: Vec<Point3> = (0..count)
                .map(|k| (Vector3::X * (step * scale * k as f64) + random.vector(1.0)).to_point())
                .collect();
            NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None)?.into()
        }
        5 => {
            let degree = 1 + random.below(4);
            let count = degree + 1 + random.below(4);
            let points: Vec<Point3> = (0..count).map(|_| random.point(size)).collect();
            let weights: Vec<f64> = (0..count).map(|_| random.between(0.4, 2.5)).collect();
            let knots = katydid_geometry::clamped_uniform_knots(degree, count)?;
            NurbsCurve::with_weights(degree, &points, &weights, knots)?.into()
        }
        6 => {
            let (a, b, c) = (random.point(size), random.point(size), random.point(size));
            PolyCurve::new(vec![Line::new(a, b).into(), Line::new(b, c).into()])?.into()
        }
        _ => {
            // A line that goes over into an arc.
            let (a, b) = (random.point(size), random.point(size));
            let arc = Arc::from_start_direction_end(b, b - a, random.point(size))?;
            PolyCurve::new(vec![Line::new(a, b).into(), arc.into()])?.into()
        }
    })
}

/// Any curve, now and then a degenerate one.
pub fn curve(random: &mut Random) -> Result<Curve> {
    if random.one_in(10) {
        return degenerate(random);
    }
    if random.one_in(3) {
        let plane = random.plane(5.0);
        return closed(random, &plane);
    }
    open(random)
}

/// A curve of no length, on a line, that runs back over itself, touches itself, or has parts far too short.
pub fn degenerate(random: &mut Random) -> Result<Curve> {
    let (p, q, r) = (random.point(5.0), random.point(5.0), random.point(5.0));
    let near = p + random.way() * 1e-7;
    let polyline = |corners: Vec<Point3>| -> Result<Curve> { Ok(PolylineCurve::new(corners)?.into()) };
    Ok(match random.below(14) {
        0 => Line::new(p, p).into(),
        1 => polyline(vec![p, p, p])?,
        2 => NurbsCurve::new(2, vec![p; 3], vec![0.0, 0.0, 1.0, 1.0])?.into(),
        // There and back again.
        3 => polyline(vec![p, q, p])?,
        4 => polyline(vec![p, p.lerp(q, 0.5), q])?,
        5 => polyline(vec![p, q, p.lerp(q, 0.3), r])?,
        6 => polyline(vec![p, near, q, r])?,
        // A corner touches the middle of another side.
        7 => polyline(vec![p, q, r, p.lerp(q, 0.5), p])?,
        // A figure of eight.
        8 => polyline(vec![p, q, p.lerp(q, 0.5) + (r - p), q + (r - p), p])?,
        9 => NurbsCurve::clamped_uniform(3, &[p, p, p, q, r])?.into(),
        10 => NurbsCurve::clamped_uniform(3, &[p, p.lerp(q, 0.3), p.lerp(q, 0.6), q])?.into(),
        11 => NurbsCurve::with_weights(2, &[p, q, r], &[1.0, 1e-6, 1.0], vec![0.0, 0.0, 1.0, 1.0])?.into(),
        // A kink and a stretch without length inside one curve.
        12 => {
            let knots = vec![0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0];
            NurbsCurve::new(2, vec![p, p.lerp(q, 0.5), q, q, q, r, p], knots)?.into()
        }
        _ => NurbsCurve::periodic_uniform(3, &[p, q, r, p.lerp(r, 0.2)])?.into(),
    })
}
