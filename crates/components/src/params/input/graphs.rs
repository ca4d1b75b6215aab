//! The curves of a graph mapper: functions of a number between 0 and 1.

use katydid_component::Message;
use katydid_definition::archive::Chunk;
use katydid_elementary::Elementary;

/// A graph in the unit square.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Graph {
    /// A cubic Bézier curve by its control points.
    Bezier([[f64; 2]; 4]),
    /// slope · x + height at 0.
    Linear { slope: f64, at_zero: f64 },
    /// The parabola with this vertex through this point.
    Parabola { vertex: [f64; 2], through: [f64; 2] },
    /// x to a power.
    Power(f64),
    /// The bell curve of this mean and deviation, times a factor.
    Gaussian { mean: f64, deviation: f64, factor: f64 },
    /// The mean of cosine waves, each by two neighbouring extremes.
    Waves(Vec<[[f64; 2]; 2]>),
}

impl Graph {
    /// Reads the chunk `Graph` of a graph mapper.
    ///
    /// # Errors
    /// For a kind of graph without a known formula, and when a part of it is missing.
    pub(super) fn read(chunk: &Chunk) -> Result<Self, Message> {
        let name = chunk.str("container_name").unwrap_or_default();
        let part = |item: &str| chunk.f64(item).filter(|x| x.is_finite()).ok_or_else(|| lacks(name, item));
        Ok(match name {
            "Bezier" => {
                let mut points = [[0.0; 2]; 4];
                for (k, point) in (0..).zip(&mut points) {
                    let at = |item| {
                        chunk.f64_at(item, k).filter(|x| x.is_finite()).ok_or_else(|| lacks(name, item))
                    };
                    *point = [at("cpx")?, at("cpy")?];
                }
                Self::Bezier(points)
            }
            "Linear" => Self::Linear { slope: part("A")?, at_zero: part("B")? },
            "Parabola" => {
                let vertex = [part("Ox")?, part("Oy")?];
                Self::Parabola { vertex, through: [part("Px")?, part("Py")?] }
            }
            "Power" => Self::Power(part("power")?),
            "Gaussian" => {
                Self::Gaussian { mean: part("mean")?, deviation: part("sdev")?, factor: part("factor")? }
            }
            "Sine" | "Sine Summation" => {
                let waves: Vec<_> = chunk.chunks.iter().filter(|c| c.name == "Equation").map(wave).collect();
                let waves: Option<Vec<_>> = waves.into_iter().collect();
                Self::Waves(waves.filter(|w| !w.is_empty()).ok_or_else(|| lacks(name, "Equation"))?)
            }
            _ => return Err(Message::error(format!("The graph type {name} is not supported"))),
        })
    }

    /// The height at `x`, 0 to 1.
    pub(super) fn at(&self, x: f64) -> f64 {
        match self {
            Self::Bezier(points) => bezier(points, x),
            Self::Linear { slope, at_zero } => slope * x + at_zero,
            Self::Parabola { vertex: [ox, oy], through: [px, py] } => {
                let t = (x - ox) / (px - ox);
                if t.is_finite() { oy + (py - oy) * t * t } else { *oy }
            }
            Self::Power(power) => x.raised_to(*power),
            Self::Gaussian { mean, deviation, factor } => {
                let t = (x - mean) / deviation;
                factor / (deviation * std::f64::consts::TAU.sqrt()) * (-0.5 * t * t).exponential()
            }
            Self::Waves(waves) => {
                let sum: f64 = waves.iter().map(|[a, b]| cosine(*a, *b, x)).sum();
                sum / waves.len().max(1) as f64
            }
        }
    }
}

fn lacks(graph: &str, item: &str) -> Message {
    Message::error(format!("The {graph} graph has no valid {item} stored"))
}

fn wave(equation: &Chunk) -> Option<[[f64; 2]; 2]> {
    let point = |k| Some([equation.f64_at("px", k)?, equation.f64_at("py", k)?]);
    Some([point(0)?, point(1)?])
}

/// The cosine wave with neighbouring extremes at `a` and `b`; level where they stand above one another.
fn cosine(a: [f64; 2], b: [f64; 2], x: f64) -> f64 {
    let phase = std::f64::consts::PI * (x - a[0]) / (b[0] - a[0]);
    let middle = 0.5 * (a[1] + b[1]);
    if phase.is_finite() { middle - 0.5 * (b[1] - a[1]) * phase.cosine() } else { middle }
}

/// The height of a Bézier curve at the first place where it reaches `x`.
fn bezier(points: &[[f64; 2]; 4], x: f64) -> f64 {
    let coordinate = |t: f64, k: usize| {
        let [a, b, c, d] = points.map(|p| p.get(k).copied().unwrap_or_default());
        let s = 1.0 - t;
        s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d
    };
    // Handles beyond the frame make the curve turn back: the first of several places has to be looked for.
    let turns = points.iter().any(|p| !(0.0..=1.0).contains(&p[0]));
    let steps = if turns { 64 } else { 1 };
    let place = |k: i32| f64::from(k) / f64::from(steps);
    let reached = (1..=steps).find(|&k| coordinate(place(k), 0) >= x);
    let (mut low, mut high) = match reached {
        Some(k) => (place(k - 1), place(k)),
        None => return coordinate(1.0, 1),
    };
    // Halving to the last bit: it cannot miss, and needs no derivative.
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if coordinate(middle, 0) < x {
            low = middle;
        } else {
            high = middle;
        }
    }
    coordinate(0.5 * (low + high), 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closed_forms() {
        let straight =
            Graph::Bezier([[0.0, 0.0], [1.0 / 3.0, 1.0 / 3.0], [2.0 / 3.0, 2.0 / 3.0], [1.0, 1.0]]);
        for x in [0.0, 0.1, 0.5, 0.77, 1.0] {
            assert!((straight.at(x) - x).abs() < 1e-15);
        }
        // x = 3s²t·0.5 + 3st²·0.5 + t³ is 0.5 at t = 0.5 by symmetry.
        let curve = Graph::Bezier([[0.0, 0.0], [0.5, 0.0], [0.5, 1.0], [1.0, 1.0]]);
        assert!((curve.at(0.5) - 0.5).abs() < 1e-15);
        assert_eq!(Graph::Power(2.0).at(0.5), 0.25);
        assert_eq!(Graph::Linear { slope: -1.0, at_zero: 1.0 }.at(0.25), 0.75);
        assert_eq!(Graph::Parabola { vertex: [0.5, 0.0], through: [1.0, 1.0] }.at(0.0), 1.0);
        let bell = Graph::Gaussian { mean: 0.5, deviation: 0.1, factor: 0.2426 };
        assert!((bell.at(0.5) - 0.9678).abs() < 1e-4);
        let waves = Graph::Waves(vec![[[0.25, 0.0], [0.75, 1.0]]]);
        assert!(waves.at(0.25).abs() < 1e-15 && (waves.at(0.75) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_curve_that_turns_back_takes_the_first_place() {
        let curve = Graph::Bezier([[0.0, 0.0], [2.0, 0.0], [-1.0, 1.0], [1.0, 1.0]]);
        let y = curve.at(0.5);
        assert!(y < 0.2, "{y}");
    }
}
