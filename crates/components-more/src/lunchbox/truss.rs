//! LunchBox Structure: trusses between curves.

use katydid_component::{Context, Message, component};
use katydid_geometry::{Curve, Line, Point3};

/// The most divisions of a truss.
const MOST: i32 = 100_000;

/// A flat truss between two curves, divided into parts of equal length. Stands for LunchBox's 2D Truss; that diagonals of type 0
/// turn from bay to bay is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c21",
    name = "2D Truss",
    nick = "2DTruss",
    at = "LunchBox/LunchBox Structure"
)]
#[output("LinesA", "LinesA", "The chords: those of the first curve, then those of the second.")]
#[output("LinesB", "LinesB", "The diagonals.")]
#[output("LinesC", "LinesC", "The posts, one at each division.")]
#[output("Nodes", "Nodes", "The points on the first curve, then those on the second.")]
fn truss(
    context: &Context<'_>,
    /// One chord.
    #[port("CrvA", "CrvA")]
    a: &Curve,
    /// The other chord, in the same direction.
    #[port("CrvB", "CrvB")]
    b: &Curve,
    /// The number of divisions.
    #[port("N", "N", default = 10)]
    n: i32,
    /// 0 diagonals both ways, 1 from the first curve on to the second, 2 from the second on to the first.
    #[port("T", "T", default = 0)]
    kind: i32,
) -> Result<(Vec<Line>, Vec<Line>, Vec<Line>, Vec<Point3>), Message> {
    let count = usize::try_from(n).ok().filter(|_| (1..=MOST).contains(&n));
    let count = count.ok_or_else(|| Message::error(format!("N is {n}: it must be from 1 to {MOST}")))?;
    if !(0..=2).contains(&kind) {
        return Err(Message::error("T must be 0, 1 or 2"));
    }
    context.items(count.saturating_mul(6))?;
    let nodes = |curve: &Curve| -> Vec<Point3> {
        let place = |i: usize| i as f64 / count as f64;
        let at =
            |part: f64| curve.parameter_at_normalized_length(part).unwrap_or_else(|| curve.domain().at(part));
        (0..=count).map(|i| curve.point_at(at(place(i)))).collect()
    };
    let (a, b) = (nodes(a), nodes(b));
    let chord = |points: &[Point3]| -> Vec<Line> {
        points.iter().zip(points.iter().skip(1)).map(|(p, q)| Line::new(*p, *q)).collect()
    };
    let mut chords = chord(&a);
    chords.extend(chord(&b));
    let bays = a.iter().zip(a.iter().skip(1)).zip(b.iter().zip(b.iter().skip(1)));
    let diagonals = bays.enumerate().map(|(i, ((a, next_a), (b, next_b)))| {
        let up = kind == 1 || (kind == 0 && i % 2 == 0);
        if up { Line::new(*a, *next_b) } else { Line::new(*b, *next_a) }
    });
    let diagonals = diagonals.collect();
    let posts = a.iter().zip(&b).map(|(a, b)| Line::new(*a, *b)).collect();
    Ok((chords, diagonals, posts, a.into_iter().chain(b).collect()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Line, Point3};

    #[test]
    fn a_truss_of_four_bays() {
        let line = |z: f64| Line::new(Point3::new(0.0, 0.0, z), Point3::new(8.0, 0.0, z));
        for (kind, first) in [(0, [0.0, 2.0]), (1, [0.0, 2.0]), (2, [2.0, 0.0])] {
            let trial = Trial::of("2D Truss").item(line(0.0)).item(line(2.0)).item(4).item(kind);
            let out = trial.run().outputs;
            assert_eq!([0, 1, 2, 3].map(|k| out[k].item_count()), [8, 4, 5, 10]);
            let total = |k: usize| -> f64 {
                let lines = out[k].column().iter().map(|item| match item {
                    Some(Value::Line(line)) => line.length(),
                    other => panic!("{other:?}"),
                });
                lines.sum()
            };
            assert!((total(0) - 16.0).abs() < 1e-9);
            assert!((total(1) - 4.0 * 8.0_f64.sqrt()).abs() < 1e-9);
            assert!((total(2) - 10.0).abs() < 1e-9);
            let Some(Value::Line(diagonal)) = out[1].branch(0).unwrap().get(0) else { panic!() };
            assert_eq!([diagonal.from.z, diagonal.to.z], first);
        }
        let refused = Trial::of("2D Truss").item(line(0.0)).item(line(2.0)).item(0).message();
        assert!(refused.contains("from 1 to"));
    }
}
