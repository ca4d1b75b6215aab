//! What several test files share: the oracle data and comparisons.
#![allow(
    dead_code,
    unreachable_pub,
    clippy::unwrap_used,
    clippy::panic,
    reason = "each test file uses a part of this"
)]

use katydid_geometry::{Interval, NurbsCurve, NurbsSurface, Plane, Point3, Vector3};
use serde_json::Value;

/// The answers of another kernel, or `None` with a printed line when the shared data is absent.
pub fn oracle(file: &str) -> Option<Value> {
    shared(&format!("oracle/{file}")).map(|text| serde_json::from_str(&text).unwrap())
}

/// A text file of the shared data, or `None` with a printed line when it is absent.
pub fn shared(file: &str) -> Option<String> {
    let path = format!("{}/../../../shared/data/{file}", env!("CARGO_MANIFEST_DIR"));
    match std::fs::read_to_string(&path) {
        Ok(text) => Some(text),
        Err(_) if std::env::var_os("KATYDID_REQUIRE_SHARED").is_some() => panic!("{path} is missing"),
        Err(_) => {
            println!("skipped: {path} is absent");
            None
        }
    }
}

pub fn numbers(v: &Value) -> Vec<f64> {
    v.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

pub fn number(v: &Value) -> f64 {
    v.as_f64().unwrap()
}

pub fn point(v: &Value) -> Point3 {
    let n = numbers(v);
    Point3::new(n[0], n[1], n.get(2).copied().unwrap_or(0.0))
}

pub fn vector(v: &Value) -> Vector3 {
    point(v).to_vector()
}

pub fn interval(v: &Value) -> Interval {
    let n = numbers(v);
    Interval::new(n[0], n[1])
}

pub fn plane(v: &Value) -> Plane {
    Plane { origin: point(&v[0]), x_axis: vector(&v[1]), y_axis: vector(&v[2]), z_axis: vector(&v[3]) }
}

pub fn curve(v: &Value) -> NurbsCurve {
    let degree = v["order"].as_u64().unwrap() as usize - 1;
    let knots = numbers(&v["knots"]);
    let rows: Vec<Vec<f64>> = v["cv"].as_array().unwrap().iter().map(numbers).collect();
    if v["rat"].as_u64().unwrap() == 1 {
        let rows = rows
            .iter()
            .map(|r| if r.len() == 3 { [r[0], r[1], 0.0, r[2]] } else { [r[0], r[1], r[2], r[3]] });
        NurbsCurve::rational(degree, rows.collect(), knots).unwrap()
    } else {
        let rows = rows.iter().map(|r| Point3::new(r[0], r[1], r.get(2).copied().unwrap_or(0.0)));
        NurbsCurve::new(degree, rows.collect(), knots).unwrap()
    }
}

#[track_caller]
pub fn close(a: f64, b: f64, tolerance: f64, what: &str) {
    let scale = 1.0_f64.max(a.abs()).max(b.abs());
    assert!((a - b).abs() <= tolerance * scale, "{what}: {a} against {b}");
}

#[track_caller]
pub fn close_points(a: Point3, b: Point3, tolerance: f64, what: &str) {
    let scale = 1.0_f64.max(b.to_vector().length());
    assert!(a.distance_to(b) <= tolerance * scale, "{what}: {a:?} against {b:?}");
}

#[track_caller]
pub fn close_vectors(a: Vector3, b: Vector3, tolerance: f64, what: &str) {
    close_points(a.to_point(), b.to_point(), tolerance, what);
}

#[track_caller]
pub fn close_curves(a: &NurbsCurve, b: &NurbsCurve, tolerance: f64, what: &str) {
    assert_eq!(a.degree(), b.degree(), "{what}: degree");
    assert_eq!(a.is_rational(), b.is_rational(), "{what}: rational");
    assert_eq!(a.knots().len(), b.knots().len(), "{what}: knot count");
    for (x, y) in a.knots().iter().zip(b.knots()) {
        close(*x, *y, tolerance, what);
    }
    for (x, y) in a.homogeneous_points().iter().zip(b.homogeneous_points()) {
        for (x, y) in x.iter().zip(y) {
            close(*x, y, tolerance, what);
        }
    }
}

pub fn surface(v: &Value) -> NurbsSurface {
    let pair = |name: &str| [0, 1].map(|i| v[name][i].as_u64().unwrap() as usize);
    let degrees = pair("order").map(|o| o - 1);
    let knots = [numbers(&v["knots"][0]), numbers(&v["knots"][1])];
    let rows: Vec<Vec<f64>> = v["cv"].as_array().unwrap().iter().map(numbers).collect();
    if v["rat"].as_u64().unwrap() == 1 {
        let rows = rows.iter().map(|r| [r[0], r[1], r[2], r[3]]).collect();
        NurbsSurface::rational(degrees, pair("n"), rows, knots).unwrap()
    } else {
        let rows = rows.iter().map(|r| Point3::new(r[0], r[1], r[2])).collect();
        NurbsSurface::new(degrees, pair("n"), rows, knots).unwrap()
    }
}

#[track_caller]
pub fn close_surfaces(a: &NurbsSurface, b: &NurbsSurface, tolerance: f64, what: &str) {
    use katydid_geometry::Direction;
    assert_eq!(a.degrees(), b.degrees(), "{what}: degrees");
    assert_eq!(a.counts(), b.counts(), "{what}: counts");
    assert_eq!(a.is_rational(), b.is_rational(), "{what}: rational");
    for d in Direction::BOTH {
        for (x, y) in a.knots(d).iter().zip(b.knots(d)) {
            close(*x, *y, tolerance, what);
        }
    }
    for (x, y) in a.homogeneous_points().iter().zip(b.homogeneous_points()) {
        for (x, y) in x.iter().zip(y) {
            close(*x, y, tolerance, what);
        }
    }
}

/// The inputs on which the peers were measured, with reference answers.
pub struct Bench {
    inputs: String,
    pub reference: Value,
}

/// The bench inputs, or `None` with a printed line when the shared data is absent.
pub fn bench() -> Option<Bench> {
    let read = |file: &str| shared(&format!("kernel-bench/{file}"));
    let reference = serde_json::from_str(&read("reference.json")?).unwrap();
    Some(Bench { inputs: read("inputs.txt")?, reference })
}

impl Bench {
    /// The curve of a name.
    pub fn curve(&self, name: &str) -> katydid_geometry::Curve {
        let mut words = self.inputs.split_whitespace();
        while let Some(word) = words.next() {
            if word != "curve" || words.next() != Some(name) {
                continue;
            }
            let header: Vec<usize> = words.by_ref().take(3).map(|w| w.parse().unwrap()).collect();
            let mut rest = words.map(|w| w.parse::<f64>().unwrap());
            let knots: Vec<f64> = rest.by_ref().take(header[1] + header[0] + 1).collect();
            let cvs: Vec<f64> = rest.take(4 * header[1]).collect();
            let points: Vec<_> = cvs.chunks_exact(4).map(|c| Point3::new(c[0], c[1], c[2])).collect();
            let knots = knots[1..knots.len() - 1].to_vec();
            return NurbsCurve::new(header[0], points, knots).unwrap().into();
        }
        panic!("no curve {name}")
    }
}

/// Numbers in −1…1 that look random (xorshift).
pub struct Numbers(pub u64);

impl Numbers {
    pub fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    pub fn point(&mut self, size: f64) -> Point3 {
        Point3::new(size * self.next(), size * self.next(), size * self.next())
    }
}
