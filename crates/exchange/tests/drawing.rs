//! SVG: paths walked again from their text, and laid beside the curves.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::f64::consts::PI;

use common::{round, sample};
use katydid_exchange::{Format, Options, Scene, Shape, Thing, View, write};
use katydid_geometry::{Arc, Circle, Curve, Interval, NurbsCurve, Plane, Point3, PolyCurve, Vector3};
use quick_xml::Reader;
use quick_xml::events::Event;

fn drawing(scene: &Scene, view: View) -> String {
    let mut out = Vec::new();
    write(scene, Format::Svg, &Options { view, tolerance: Some(1e-4), ..Options::default() }, &mut out)
        .unwrap();
    String::from_utf8(out).unwrap()
}

fn of_curve(curve: &Curve, view: View) -> (String, Vec<[f64; 2]>) {
    let things = vec![Thing::named("", Shape::Curve(curve.clone()))];
    let svg = drawing(&Scene { things, ..Scene::default() }, view);
    let data = svg.split(" d=\"").nth(1).unwrap().split('"').next().unwrap().to_owned();
    let points = walk(&data);
    (data, points)
}

/// Many points along a path, by the rules of SVG 1.1 (chapter 8.3 and appendix F.6), y up again.
fn walk(data: &str) -> Vec<[f64; 2]> {
    let mut spaced = String::new();
    for c in data.chars() {
        if c.is_ascii_alphabetic() && c != 'e' {
            spaced.extend([' ', c, ' ']);
        } else {
            spaced.push(c);
        }
    }
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut points: Vec<[f64; 2]> = Vec::new();
    let (mut at, mut first, mut i) = ([0.0; 2], [0.0; 2], 0);
    const STEPS: u32 = 64;
    while i < words.len() {
        let letter = words[i];
        let numbers: Vec<f64> = words[i + 1..].iter().map_while(|w| w.parse().ok()).collect();
        i += 1 + numbers.len();
        let mut add = |f: &dyn Fn(f64) -> [f64; 2]| {
            (0..=STEPS).for_each(|k| points.push(f(f64::from(k) / f64::from(STEPS))))
        };
        match (letter, numbers.as_slice()) {
            ("M", &[x, y]) => (at, first) = ([x, y], [x, y]),
            ("h", [0.0]) => add(&|_| at),
            ("Z", []) => {
                add(&|s| [0, 1].map(|j| at[j] + (first[j] - at[j]) * s));
                at = first;
            }
            ("L", &[x, y]) => {
                add(&|s| [at[0] + (x - at[0]) * s, at[1] + (y - at[1]) * s]);
                at = [x, y];
            }
            ("Q", &[a, b, x, y]) => {
                add(&|s| {
                    let r = 1.0 - s;
                    [(at[0], a, x), (at[1], b, y)].map(|(p, q, e)| r * r * p + 2.0 * r * s * q + s * s * e)
                });
                at = [x, y];
            }
            ("C", &[a, b, c, d, x, y]) => {
                add(&|s| {
                    let r = 1.0 - s;
                    [(at[0], a, c, x), (at[1], b, d, y)].map(|(p, q, t, e)| {
                        r * r * r * p + 3.0 * r * r * s * q + 3.0 * r * s * s * t + s * s * s * e
                    })
                });
                at = [x, y];
            }
            ("A", &[rx, ry, degrees, large, sweep, x, y]) => {
                let (sin, cos) = degrees.to_radians().sin_cos();
                let half = [(at[0] - x) / 2.0, (at[1] - y) / 2.0];
                let (px, py) = (cos * half[0] + sin * half[1], -sin * half[0] + cos * half[1]);
                let inside = (rx * ry).powi(2) / ((rx * py).powi(2) + (ry * px).powi(2)) - 1.0;
                let root = inside.max(0.0).sqrt() * if large == sweep { -1.0 } else { 1.0 };
                let (cx, cy) = (root * rx * py / ry, -root * ry * px / rx);
                let center =
                    [cos * cx - sin * cy + (at[0] + x) / 2.0, sin * cx + cos * cy + (at[1] + y) / 2.0];
                let from = ((py - cy) / ry).atan2((px - cx) / rx);
                let mut turn = ((-py - cy) / ry).atan2((-px - cx) / rx) - from;
                if sweep == 0.0 && turn > 0.0 {
                    turn -= 2.0 * PI;
                } else if sweep == 1.0 && turn < 0.0 {
                    turn += 2.0 * PI;
                }
                add(&|s| {
                    let (q, p) = (from + turn * s).sin_cos();
                    [center[0] + cos * rx * p - sin * ry * q, center[1] + sin * rx * p + cos * ry * q]
                });
                at = [x, y];
            }
            other => panic!("{other:?} in {data}"),
        }
    }
    points.into_iter().map(|[x, y]| [x, -y]).collect()
}

/// The greatest distance of the walked points from the curve on the page, and the difference of the two lengths.
fn errors(curve: &Curve, points: &[[f64; 2]]) -> (f64, f64) {
    let far = points.iter().map(|[x, y]| {
        let p = Point3::new(*x, *y, 0.0);
        curve.closest_point(p).unwrap().point.distance_to(p)
    });
    let length: f64 = points.windows(2).map(|w| (w[0][0] - w[1][0]).hypot(w[0][1] - w[1][1])).sum();
    (far.fold(0.0, f64::max), (length - curve.length()).abs())
}

fn ring(radius: f64, from: f64, to: f64) -> Curve {
    Arc::new(Circle::new(Plane::XY, radius).unwrap(), Interval::new(from, to)).unwrap().into()
}

#[test]
fn curves_are_exact_where_svg_has_them() {
    let p = Point3::new;
    let points = [p(0.0, 0.0, 0.0), p(1.0, 2.0, 0.0), p(3.0, 3.0, 0.0), p(4.0, -1.0, 0.0), p(6.0, 0.5, 0.0)];
    let nurbs = |degree| Curve::from(NurbsCurve::clamped_uniform(degree, &points).unwrap());
    let circle = ring(2.5, 0.0, 2.0 * PI);
    for (curve, letters) in [
        (nurbs(1), "ML"),
        (nurbs(2), "MQ"),
        (nurbs(3), "MC"),
        (circle.clone(), "MAZ"),
        (ring(2.5, 1.0, 6.0), "MA"),
        (ring(2.5, 0.2, 0.3), "MA"),
        (circle.to_nurbs().unwrap().into(), "MAZ"),
        (ring(7.0, 3.0, 1.0 + 2.0 * PI).to_nurbs().unwrap().reversed().into(), "MA"),
    ] {
        let (data, walked) = of_curve(&curve, View::Top);
        let mut used: Vec<char> = data.chars().filter(|c| c.is_ascii_uppercase()).collect();
        used.dedup();
        assert_eq!(used.into_iter().collect::<String>(), letters, "{data}");
        let (far, length) = errors(&curve, &walked);
        assert!(far < 1e-9 && length < 5e-3, "{data}: {far} {length}");
    }
}

#[test]
fn other_curves_are_within_the_tolerance() {
    let wave = round().things.into_iter().nth(1).unwrap();
    let Shape::Curve(wave) = wave.shape else { panic!() };
    let flat = wave.transformed(&katydid_geometry::Xform::diagonal(1.0, 1.0, 0.0)).unwrap();
    let (data, walked) = of_curve(&wave, View::Top);
    let (far, length) = errors(&flat, &walked);
    assert!(far <= 1e-4 && length < 1e-2, "{far} {length}");
    assert!(data.matches('C').count() < 200, "{}", data.matches('C').count());
    // A hyperbola, whose middle weight is above 1.
    let points = [Point3::ORIGIN, Point3::new(1.0, 3.0, 0.0), Point3::new(4.0, 0.0, 0.0)];
    let conic = NurbsCurve::with_weights(2, &points, &[1.0, 2.5, 1.0], vec![0.0, 0.0, 1.0, 1.0]).unwrap();
    let conic = Curve::from(conic);
    let (far, _) = errors(&conic, &of_curve(&conic, View::Top).1);
    assert!(far <= 1e-4, "{far}");
}

#[test]
fn circles_seen_aslant_are_ellipses_and_from_the_side_lines() {
    let normal = Vector3::new(1.0, 2.0, 3.0);
    let circle = Circle::from_normal(Point3::new(5.0, 6.0, 7.0), normal, 4.0).unwrap();
    for sweep in [Interval::new(0.0, 2.0 * PI), Interval::new(0.4, 4.0), Interval::new(-2.0, 0.1)] {
        let arc = Curve::from(Arc::new(circle, sweep).unwrap());
        for (view, flat) in [(View::Top, [0, 1]), (View::Front, [0, 2]), (View::Right, [1, 2])] {
            let (data, walked) = of_curve(&arc, view);
            let domain = arc.domain();
            // Each place of the arc is near a walked one, and the other way round by the count of them.
            for i in 0..=200 {
                let p = arc.point_at(domain.at(f64::from(i) / 200.0));
                let seen = [p.x, p.y, p.z];
                let (x, y) = (seen[flat[0]], seen[flat[1]]);
                let near = walked.iter().map(|[a, b]| (a - x).hypot(b - y)).fold(f64::INFINITY, f64::min);
                assert!(near < 0.08, "{view:?} {data}: {near}");
            }
        }
    }
    let (data, walked) = of_curve(&ring(3.0, 0.0, 2.0 * PI), View::Front);
    assert!(!data.contains('A'), "{data}");
    let right = walked.iter().map(|p| p[0]).fold(f64::NEG_INFINITY, f64::max);
    let left = walked.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
    assert!((right - 3.0).abs() < 1e-12 && (left + 3.0).abs() < 1e-12, "{data}");
}

#[test]
fn pieces_of_a_polycurve_are_one_path() {
    let p = Point3::new;
    let line = |a: Point3, b: Point3| Curve::from(katydid_geometry::Line::new(a, b));
    let half = Curve::from(Arc::new(Circle::new(Plane::XY, 1.0).unwrap(), Interval::new(0.0, PI)).unwrap());
    let curve = Curve::from(PolyCurve::new(vec![half, line(p(-1.0, 0.0, 0.0), p(1.0, 0.0, 0.0))]).unwrap());
    let (data, _) = of_curve(&curve, View::Top);
    assert_eq!((data.matches('M').count(), data.matches('Z').count()), (1, 1), "{data}");
}

#[test]
fn the_drawing_is_xml_in_true_size_with_layers() {
    let svg = drawing(&sample(), View::Isometric);
    let mut reader = Reader::from_str(&svg);
    let (mut depth, mut deepest, mut titles) = (0, 0, Vec::new());
    loop {
        match reader.read_event().unwrap() {
            Event::Start(_) => {
                depth += 1;
                deepest = deepest.max(depth);
            }
            Event::End(_) => depth -= 1,
            Event::Text(text) => titles.push(text.xml10_content().trim().to_owned()),
            Event::Eof => break,
            _ => {}
        }
    }
    assert_eq!((depth, deepest), (0, 6), "svg, g, outer, inner, path, title");
    assert!(svg.contains("<title>inner</title>") && !svg.contains("nothing on it"), "{svg}");
    assert!(svg.contains("<title>mesh &quot;&lt;&amp;&gt;&quot; ü </title>"), "{svg}");
    assert!(svg.contains("stroke=\"#c81e07\" stroke-opacity=\"0.502\""), "{svg}");
    let circle = Scene { things: round().things[..1].to_vec(), ..Scene::default() };
    assert!(
        drawing(&circle, View::Top)
            .contains(" width=\"20.8mm\" height=\"20.8mm\" viewBox=\"-10.4 -10.4 20.8 20.8\"")
    );
    let inches = Scene { units: katydid_geometry::Units::Inches, metres: 0.0254, ..circle };
    assert!(drawing(&inches, View::Top).contains(" width=\"20.8in\""));
}
