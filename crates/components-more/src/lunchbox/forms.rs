//! LunchBox Math: surfaces given by formulas.
//!
//! The plug-in's pages name the parameters and tell roughly what each is for; which place in the formula each has is our reading,
//! as the help of each says.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_elementary::Elementary;
use katydid_geometry::{Direction, Interval, KnotSpacing, NurbsSurface, Point3, Surface};

/// The most divisions of a surface in one direction.
const MOST: i32 = 1000;

/// What a point of the net takes while it is interpolated: itself, its row of the banded system, and its control point.
const POINT_BYTES: usize = 300;

/// Even divisions of the domains of two parameters.
struct Net {
    counts: [usize; 2],
    domains: [Interval; 2],
}

impl Net {
    /// # Errors
    /// A number of divisions is not positive or too large, a domain has no length, there is no room for the points.
    fn new(context: &Context<'_>, divisions: [i32; 2], domains: [Interval; 2]) -> Result<Self, Message> {
        let mut counts = [0; 2];
        for ((slot, n), name) in counts.iter_mut().zip(divisions).zip(["U", "V"]) {
            *slot = usize::try_from(n)
                .ok()
                .filter(|_| (1..=MOST).contains(&n))
                .ok_or_else(|| Message::error(format!("{name} is {n}: it must be from 1 to {MOST}")))?;
        }
        for (domain, name) in domains.iter().zip(["D1", "D2"]) {
            if !domain.is_finite() || domain.is_singleton() {
                return Err(Message::error(format!("{name} has no length, or its ends are not finite")));
            }
        }
        context.bytes((counts[0] + 1).saturating_mul(counts[1] + 1).saturating_mul(POINT_BYTES))?;
        Ok(Self { counts, domains: domains.map(Interval::ordered) })
    }

    /// The surface through the points of a formula at the divisions; its parameters are those of the formula.
    ///
    /// # Errors
    /// A point is not finite.
    fn surface(&self, scale: f64, form: impl Fn(f64, f64) -> [f64; 3]) -> Result<Shared<Surface>, Message> {
        let [m, n] = self.counts;
        let [d1, d2] = self.domains;
        let mut points = Vec::with_capacity((m + 1) * (n + 1));
        for i in 0..=m {
            for j in 0..=n {
                let (s, t) = (d1.at(i as f64 / m as f64), d2.at(j as f64 / n as f64));
                let point = Point3::from(form(s, t).map(|x| scale * x));
                if !point.is_finite() {
                    return Err(Message::error(format!("The formula has no finite point at ({s}, {t})")));
                }
                points.push(point);
            }
        }
        let degrees = self.counts.map(|count| count.min(3));
        let counts = self.counts.map(|count| count + 1);
        let through = NurbsSurface::interpolate(degrees, counts, &points, KnotSpacing::Uniform, [false; 2])?;
        let half = Surface::from(through).with_domain(Direction::U, d1)?;
        Ok(Shared::new(half.with_domain(Direction::V, d2)?))
    }
}

/// A component for a surface: its own parameters stand between the divisions and the scale.
macro_rules! form {
    (
        $(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal,
        [$($(#[$($attribute:tt)*])+ $parameter:ident: $kind:ty),* $(,)?],
        $first:expr, $second:expr, |$s:ident, $t:ident| $body:expr
    ) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "LunchBox/Math")]
        #[output("Surface", "Srf", "The surface, of degree 3, through the points at the divisions.")]
        fn $function(
            context: &Context<'_>,
            /// The number of divisions of the first domain, from 1 to 1000.
            #[port("U Divisions", "U", default = 40)]
            u: i32,
            /// The number of divisions of the second domain, from 1 to 1000.
            #[port("V Divisions", "V", default = 40)]
            v: i32,
            $($(#[$($attribute)*])+ $parameter: $kind,)*
            /// How many times as large the surface is.
            #[port("Scale", "S", default = 1.0)]
            scale: f64,
            /// The domain of the first parameter, along u.
            #[port("Domain 1", "D1", default = $first)]
            first: Interval,
            /// The domain of the second parameter, along v.
            #[port("Domain 2", "D2", default = $second)]
            second: Interval,
        ) -> Result<Shared<Surface>, Message> {
            Net::new(context, [u, v], [first, second])?.surface(scale, |$s, $t| $body)
        }
    };
}

form!(
    /// An Enneper surface, which is minimal: its mean curvature is 0. Stands for LunchBox's Enneper Surface. Of order n, at
    /// the radius r (D1) and the angle φ (D2), it is x = r cos φ − rᵏ cos kφ / k, y = −(r sin φ + rᵏ sin kφ / k),
    /// z = 2 rⁿ⁺¹ cos (n+1)φ / (n+1) with k = 2n + 1 (U. Dierkes and others, Minimal Surfaces, 2010); that a is the order, and
    /// D1 the radius, is our reading.
    enneper, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c31", "Enneper Surface", "Enneper",
    [
        /// The order n, at least 1: the rim turns up n + 1 times.
        #[port("R Parameter", "a", default = 1)]
        order: i32,
    ],
    Interval::new(0.0, 1.5), Interval::new(-PI, PI),
    |r, angle| enneper_point(order, r, angle)
);

/// The point of the Enneper surface of an order; not finite for an order below 1.
fn enneper_point(order: i32, r: f64, angle: f64) -> [f64; 3] {
    if order < 1 {
        return [f64::NAN; 3];
    }
    let n = f64::from(order);
    let k = 2.0 * n + 1.0;
    let (sin, cos) = angle.sine_cosine();
    let (sin_k, cos_k) = (k * angle).sine_cosine();
    let high = r.raised_to(k) / k;
    [
        r * cos - high * cos_k,
        -(r * sin + high * sin_k),
        2.0 * r.raised_to(n + 1.0) * ((n + 1.0) * angle).cosine() / (n + 1.0),
    ]
}

form!(
    /// A helicoid: a line that turns about an axis while it rises. Stands for LunchBox's Helicoid Surface. With s in D1 along
    /// the line and the angle t in D2 it is x = s cos t, y = s sin t, z = (R / T) t; that R is what it rises in a radian and T
    /// divides that is our reading.
    helicoid, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c32", "Helicoid Surface", "Helicoid",
    [
        /// How far it rises while it turns by a radian.
        #[port("R Parameter", "R", default = 1.0)]
        rise: f64,
        /// What the rise is divided by; not 0.
        #[port("T Parameter", "T", default = 1.0)]
        part: f64,
    ],
    Interval::new(-1.0, 1.0), Interval::new(0.0, TAU),
    |s, t| [s * t.cosine(), s * t.sine(), rise / part * t]
);

form!(
    /// A Klein bottle in the form of a figure of eight that goes round a ring and turns half round on the way. Stands for
    /// LunchBox's Klein Surface. With s in D1 round the ring and t in D2 along the eight, and h = T s / 2, it is
    /// w = R + cos h sin t − sin h sin 2t, x = w cos s, y = w sin s, z = sin h sin t + cos h sin 2t; which form of the bottle
    /// is made, and what R and T are, is our reading.
    klein, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c33", "Klein Surface", "Klein",
    [
        /// The radius of the ring.
        #[port("R Parameter", "R", default = 3.0)]
        radius: f64,
        /// How many half turns the eight makes in one round: with an odd number it is a Klein bottle.
        #[port("T Parameter", "T", default = 1.0)]
        turns: f64,
    ],
    Interval::new(0.0, TAU), Interval::new(0.0, TAU),
    |s, t| {
        let (sin, cos) = (0.5 * turns * s).sine_cosine();
        let (across, along) = (t.sine(), (2.0 * t).sine());
        let w = radius + cos * across - sin * along;
        [w * s.cosine(), w * s.sine(), sin * across + cos * along]
    }
);

form!(
    /// A Möbius strip: a line that goes round a ring and turns half round on the way. Stands for LunchBox's Mobius Surface. With
    /// s in D1 round the ring, t in D2 along the line and h = T s / 2, it is x = (R + t cos h) cos s, y = (R + t cos h) sin s,
    /// z = t sin h; what R and T are is our reading.
    mobius, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c34", "Mobius Surface", "Mobius",
    [
        /// The radius of the ring.
        #[port("R Parameter", "R", default = 2.0)]
        radius: f64,
        /// How many half turns the line makes in one round: with an odd number the strip has one side.
        #[port("T Parameter", "T", default = 1.0)]
        turns: f64,
    ],
    Interval::new(0.0, TAU), Interval::new(-1.0, 1.0),
    |s, t| {
        let (sin, cos) = (0.5 * turns * s).sine_cosine();
        let w = radius + t * cos;
        [w * s.cosine(), w * s.sine(), t * sin]
    }
);

form!(
    /// A hyperbolic paraboloid, the saddle. Stands for LunchBox's Hyperbolic Paraboloid. With s in D1 and t in D2 it is x = s,
    /// y = t, z = s² / a² − t² / b²; which of the two goes up is our reading.
    paraboloid, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c35", "Hyperbolic Paraboloid", "Paraboloid",
    [
        /// The larger it is, the flatter the saddle is along x; not 0.
        #[port("a Parameter", "a", default = 1.0)]
        a: f64,
        /// The larger it is, the flatter the saddle is along y; not 0.
        #[port("b Parameter", "b", default = 1.0)]
        b: f64,
    ],
    Interval::new(-1.0, 1.0), Interval::new(-1.0, 1.0),
    |s, t| [s, t, (s / a) * (s / a) - (t / b) * (t / b)]
);

form!(
    /// Plücker's conoid: a level line that turns about an axis while it goes up and down. Stands for LunchBox's Conoid Surface.
    /// With s in D1 along the line and the angle t in D2 it is x = s cos t, y = s sin t, z = R sin (T t); that R is the height
    /// and T the number of folds is our reading.
    conoid, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c36", "Conoid Surface", "Conoid",
    [
        /// How far the line goes up and down from the middle.
        #[port("R Parameter", "R", default = 1.0)]
        height: f64,
        /// How often it goes up and down in a turn.
        #[port("T Parameter", "T", default = 2.0)]
        folds: f64,
    ],
    Interval::new(0.0, 1.0), Interval::new(0.0, TAU),
    |s, t| [s * t.cosine(), s * t.sine(), height * (folds * t).sine()]
);

form!(
    /// A torus: an ellipse that goes round an axis. Stands for LunchBox's Torus Surface. With s in D1 about the axis and t in D2
    /// about the ellipse it is x = (C + R cos t) cos s, y = (C + R cos t) sin s, z = T sin t; that R and T are the half width and
    /// the half height of the ellipse is our reading.
    torus, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c37", "Torus Surface", "Torus",
    [
        /// The distance of the middle of the ellipse from the axis.
        #[port("C Parameter", "C", default = 3.0)]
        middle: f64,
        /// Half of the width of the ellipse.
        #[port("R Parameter", "R", default = 1.0)]
        across: f64,
        /// Half of its height.
        #[port("T Parameter", "T", default = 1.0)]
        up: f64,
    ],
    Interval::new(0.0, TAU), Interval::new(0.0, TAU),
    |s, t| {
        let w = middle + across * t.cosine();
        [w * s.cosine(), w * s.sine(), up * t.sine()]
    }
);

/// Gielis's superformula: r(φ) = (|cos(mφ/4) / a|ⁿ² + |sin(mφ/4) / b|ⁿ³)^(−1/n1) (J. Gielis, *A generic geometric
/// transformation that unifies a wide range of natural and abstract shapes*, American Journal of Botany 90, 2003).
#[derive(Debug, Clone, Copy)]
struct Superformula {
    m: f64,
    a: f64,
    b: f64,
    n: [f64; 3],
}

impl Superformula {
    fn radius(&self, angle: f64) -> f64 {
        let (sin, cos) = (0.25 * self.m * angle).sine_cosine();
        let [n1, n2, n3] = self.n;
        let sum = (cos / self.a).abs().raised_to(n2) + (sin / self.b).abs().raised_to(n3);
        sum.raised_to(-1.0 / n1)
    }
}

/// A surface whose meridians and parallels follow Gielis's superformula. Stands for LunchBox's 3D Supershape. With the
/// longitude s in D1 and the latitude t in D2 it is x = r(s) cos s · r(t) cos t, y = r(s) sin s · r(t) cos t, z = r(t) sin t,
/// with r(φ) = (|cos(mφ/4)/a|ⁿ² + |sin(mφ/4)/b|ⁿ³)^(−1/n1) (J. Gielis, 2003). That both have the same numbers is our reading. Where
/// the formula has a sharp edge the surface, which is smooth, goes round it.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c38",
    name = "3D Supershape",
    nick = "3DSupershape",
    at = "LunchBox/Math"
)]
#[output("Surface", "Srf", "The surface, of degree 3, through the points at the divisions.")]
fn supershape(
    context: &Context<'_>,
    /// The number of divisions of the first domain, from 1 to 1000.
    #[port("U Divisions", "U", default = 60)]
    u: i32,
    /// The number of divisions of the second domain, from 1 to 1000.
    #[port("V Divisions", "V", default = 60)]
    v: i32,
    /// How many corners a parallel has.
    #[port("m Parameter", "m", default = 4.0)]
    m: f64,
    /// What the cosine is divided by; not 0.
    #[port("a Parameter", "a", default = 1.0)]
    a: f64,
    /// What the sine is divided by; not 0.
    #[port("b Parameter", "b", default = 1.0)]
    b: f64,
    /// The exponent of the whole; not 0.
    #[port("n1 Parameter", "n1", default = 2.0)]
    n1: f64,
    /// The exponent of the cosine.
    #[port("n2 Parameter", "n2", default = 2.0)]
    n2: f64,
    /// The exponent of the sine.
    #[port("n3 Parameter", "n3", default = 2.0)]
    n3: f64,
    /// How many times as large the surface is.
    #[port("Scale Parameter", "S", default = 1.0)]
    scale: f64,
    /// The domain of the longitude, along u.
    #[port("D1 Interval", "D1", default = Interval::new(-PI, PI))]
    first: Interval,
    /// The domain of the latitude, along v.
    #[port("D2 Interval", "D2", default = Interval::new(-FRAC_PI_2, FRAC_PI_2))]
    second: Interval,
) -> Result<Shared<Surface>, Message> {
    if [a, b, n1].contains(&0.0) {
        return Err(Message::error("a, b and n1 must not be 0: the formula divides by them"));
    }
    let formula = Superformula { m, a, b, n: [n1, n2, n3] };
    Net::new(context, [u, v], [first, second])?.surface(scale, |s, t| {
        let (around, up) = (formula.radius(s), formula.radius(t));
        let level = around * up * t.cosine();
        [level * s.cosine(), level * s.sine(), up * t.sine()]
    })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};
    use std::sync::Arc;

    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_elementary::Elementary;
    use katydid_geometry::{Direction, Interval, Point3, Surface};

    fn made(trial: Trial) -> Arc<Surface> {
        match trial.run().outputs[0].column().get(0) {
            Some(Value::Surface(surface)) => surface,
            other => panic!("{other:?}"),
        }
    }

    fn divided(name: &str) -> Trial {
        Trial::of(name).item(40).item(40)
    }

    /// Points at the divisions, with the parameters there.
    fn places(surface: &Surface) -> Vec<(f64, f64, Point3)> {
        let [u, v] = [Direction::U, Direction::V].map(|d| surface.domain(d));
        let place = |i: usize| {
            let (s, t) = (u.at((i / 9 * 5) as f64 / 40.0), v.at((i % 9 * 5) as f64 / 40.0));
            (s, t, surface.point_at(s, t))
        };
        (0..81).map(place).collect()
    }

    #[test]
    fn surfaces_lie_on_their_equations() {
        for (s, t, p) in places(&made(divided("Helicoid Surface").item(3.0).item(2.0).item(2.0))) {
            assert!((p.z - 3.0 * t).abs() < 1e-9, "{p:?}");
            assert!((p.x * t.sine() - p.y * t.cosine()).abs() < 1e-9);
            assert!((p.x.hypotenuse(p.y) - 2.0 * s.abs()).abs() < 1e-9);
        }
        for (s, t, p) in places(&made(divided("Hyperbolic Paraboloid").item(2.0).item(0.5).item(3.0))) {
            assert!((p.x - 3.0 * s).abs() < 1e-9 && (p.y - 3.0 * t).abs() < 1e-9);
            assert!((p.z - 3.0 * (s * s / 4.0 - 4.0 * t * t)).abs() < 1e-9);
        }
        for (_, _, p) in places(&made(divided("Torus Surface").item(5.0).item(2.0).item(1.0))) {
            let across = (p.x.hypotenuse(p.y) - 5.0) / 2.0;
            assert!((across * across + p.z * p.z - 1.0).abs() < 1e-9, "{p:?}");
        }
        // z (x² + y²) = 2 R x y for two folds.
        for (_, _, p) in places(&made(divided("Conoid Surface").item(1.5))) {
            assert!((p.z * (p.x * p.x + p.y * p.y) - 3.0 * p.x * p.y).abs() < 1e-9, "{p:?}");
        }
        // With all exponents 2 the superformula is a circle, whatever m is.
        for (_, _, p) in places(&made(divided("3D Supershape").item(6.0))) {
            assert!((p.distance_to(Point3::ORIGIN) - 1.0).abs() < 1e-9, "{p:?}");
        }
    }

    #[test]
    fn strips_and_bottles_close_with_a_half_turn() {
        let strip = made(divided("Mobius Surface"));
        let bottle = made(divided("Klein Surface"));
        for k in 0..=8 {
            let t = f64::from(k) / 4.0 - 1.0;
            assert!(strip.point_at(0.0, t).distance_to(strip.point_at(TAU, -t)) < 1e-9, "{t}");
        }
        for k in 0..=8 {
            let t = TAU * f64::from(k) / 8.0;
            assert!(bottle.point_at(0.0, t).distance_to(bottle.point_at(TAU, TAU - t)) < 1e-9, "{t}");
        }
    }

    #[test]
    fn an_enneper_surface_is_minimal() {
        for order in [1, 2, 3] {
            let trial = Trial::of("Enneper Surface").item(80).item(80).item(order).default();
            let surface = made(trial.item(Interval::new(0.2, 1.2)).item(Interval::new(-PI, PI)));
            for (u, v) in [(0.5, 0.3), (0.8, -1.0), (1.0, 2.0), (0.4, -2.5)] {
                let curvature = surface.curvature_at(u, v).unwrap();
                let [k1, k2] = curvature.principal;
                assert!(curvature.mean.abs() < 0.01 * k1, "{order}: {k1} {k2}");
                // K = −(2 n rⁿ⁻¹ / (1 + r²ⁿ)²)².
                let n = f64::from(order);
                let r = u;
                let k = 2.0 * n * r.raised_to(n - 1.0) / (1.0 + r.raised_to(2.0 * n)).raised_to(2.0);
                assert!((curvature.gaussian + k * k).abs() < 0.02 * k * k, "{order}: {curvature:?} {k}");
            }
        }
    }

    #[test]
    fn refused() {
        for n in [0, -3, 1001, i32::MAX] {
            assert!(Trial::of("Torus Surface").item(n).message().contains("from 1 to 1000"), "{n}");
        }
        let flat = divided("Mobius Surface").default().default().default().item(Interval::new(1.0, 1.0));
        assert!(flat.message().contains("D1"));
        assert!(divided("Helicoid Surface").default().item(0.0).message().contains("no finite point"));
        assert!(divided("Enneper Surface").item(0).message().contains("no finite point"));
        assert!(divided("3D Supershape").item(4.0).item(0.0).message().contains("must not be 0"));
        assert!(divided("3D Supershape").item(f64::NAN).message().contains("no finite point"));
        let one = made(Trial::of("Hyperbolic Paraboloid").item(1).item(1));
        assert!(one.point_at(1.0, -1.0).distance_to(Point3::new(1.0, -1.0, 0.0)) < 1e-12);
    }
}
