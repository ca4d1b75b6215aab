use katydid_geometry::Interval;

use crate::archive::Chunk;

/// A Graph Mapper: a function on the unit square, stretched to two ranges.
#[derive(Debug, Clone, PartialEq)]
pub struct GraphMapper {
    /// The range of the input.
    pub x: Interval,
    /// The range of the output.
    pub y: Interval,
    /// Whether the grips are locked on the canvas.
    pub locked: bool,
    /// The function; absent while its author has not chosen one.
    pub graph: Option<Graph>,
}

/// The functions of a Graph Mapper, by the places of their grips in the unit square.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Graph {
    /// A cubic Bézier curve: start, two handles, end.
    Bezier([[f64; 2]; 4]),
    /// The line through two heights, at x 0 and 1.
    Linear([f64; 2]),
    /// A parabola by its turning point and one more point.
    Parabola {
        /// The turning point.
        origin: [f64; 2],
        /// A point on it.
        point: [f64; 2],
    },
    /// A sine wave by two neighbouring extremes.
    Sine([[f64; 2]; 2]),
    /// The sum of sine waves, each by two neighbouring extremes.
    SineSummation(Vec<[[f64; 2]; 2]>),
    /// A bell curve.
    Gaussian {
        /// Where it is highest.
        mean: f64,
        /// How wide it is.
        deviation: f64,
        /// How high it is.
        factor: f64,
    },
    /// Perlin noise.
    Perlin {
        /// The height of the first octave.
        amplitude: f64,
        /// The frequency of the first octave.
        frequency: f64,
        /// How much less each octave counts.
        decay: f64,
        /// The shift along x and y.
        offset: [f64; 2],
    },
    /// A power, by a point on it.
    Power {
        /// The point.
        point: [f64; 2],
        /// The exponent.
        power: f64,
    },
    /// Another function: its name and its chunk.
    Other(String, Box<Chunk>),
}

impl GraphMapper {
    pub(super) fn read(container: &Chunk) -> Option<Self> {
        let chunk = container.child("LocalGraph")?;
        let domain = chunk.child("Domain");
        let end = |name, default| domain.and_then(|domain| domain.f64(name)).unwrap_or(default);
        Some(Self {
            x: Interval::new(end("x0", 0.0), end("x1", 1.0)),
            y: Interval::new(end("y0", 0.0), end("y1", 1.0)),
            locked: chunk.bool("LockGrips").unwrap_or(false),
            graph: chunk.child("Graph").map(|graph| {
                let name = graph.str("container_name").unwrap_or_default();
                known(name, graph).unwrap_or_else(|| Graph::Other(name.to_owned(), Box::new(graph.clone())))
            }),
        })
    }
}

fn known(name: &str, graph: &Chunk) -> Option<Graph> {
    let n = |name| graph.f64(name);
    Some(match name {
        "Bezier" => {
            let mut points = [[0.0; 2]; 4];
            for (k, point) in (0..).zip(&mut points) {
                *point = [graph.f64_at("cpx", k)?, graph.f64_at("cpy", k)?];
            }
            Graph::Bezier(points)
        }
        // y = A·x + B by its ends, which the file holds as well.
        "Linear" => Graph::Linear([n("y0")?, n("y1")?]),
        "Parabola" => Graph::Parabola { origin: [n("Ox")?, n("Oy")?], point: [n("Px")?, n("Py")?] },
        "Sine" => Graph::Sine(wave(graph.child("Equation")?)?),
        "Sine Summation" => {
            let waves = graph.chunks.iter().filter(|chunk| chunk.name == "Equation");
            Graph::SineSummation(waves.map(wave).collect::<Option<Vec<_>>>()?)
        }
        "Gaussian" => Graph::Gaussian { mean: n("mean")?, deviation: n("sdev")?, factor: n("factor")? },
        "Perlin" => Graph::Perlin {
            amplitude: n("amplitude")?,
            frequency: n("frequency")?,
            decay: n("decay")?,
            offset: [n("x_offset")?, n("y_offset")?],
        },
        "Power" => Graph::Power { point: [n("Gx")?, n("Gy")?], power: n("power")? },
        _ => return None,
    })
}

fn wave(equation: &Chunk) -> Option<[[f64; 2]; 2]> {
    let point = |k| Some([equation.f64_at("px", k)?, equation.f64_at("py", k)?]);
    Some([point(0)?, point(1)?])
}
