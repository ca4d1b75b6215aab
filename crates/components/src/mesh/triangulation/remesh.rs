//! Meshes of triangles of about one size.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Geometry, Kind, Value, cast};
use katydid_geometry::{Line, Mesh, Point3, RemeshOptions};

use crate::mesh::shared;

/// Where faces meet at more than this angle is a crease: 30 degrees.
const CREASE: f64 = std::f64::consts::FRAC_PI_6;
/// More rounds change nothing that is seen.
const MOST_ROUNDS: i32 = 1000;
/// The most faces on the way.
const MOST_FACES: usize = 4_000_000;

/// Makes a mesh anew of triangles whose edges are all about as long as wanted.
///
/// Borders keep their shape, and sharp edges if wanted; elsewhere vertices spread evenly over the surface. Takes meshes
/// and what becomes one on a mesh port.
#[component(
    "866222ee-6093-4af8-8944-2f9264885385",
    name = "TriRemesh",
    nick = "TriRemesh",
    at = "Mesh/Triangulation"
)]
#[output("Triangulation", "T", "The mesh of triangles.")]
#[output("Dual", "D", "A mesh with a vertex in every triangle and a face around every vertex inside.")]
#[output("Creases", "C", "The sharp edges that were kept, in pieces.")]
fn tri_remesh(
    context: &Context<'_>,
    /// The mesh.
    #[port("Geometry", "Geometry")]
    geometry: Geometry,
    /// Another mesh to pull the vertices to; without one they stay on the first.
    #[port("Target", "Target", optional)]
    target: Option<Shared<Mesh>>,
    /// Whether edges stay where faces meet at more than 30 degrees.
    #[port("Sharp", "Sharp", default = true)]
    sharp: bool,
    /// Points at which there shall be a vertex.
    #[port("Features", "Features", optional)]
    features: List<Value>,
    /// The length of the edges, greater than 0.
    #[port("Length", "Length", default = 1.0)]
    length: f64,
    /// How many rounds of splitting, collapsing, flipping and smoothing, at least 0; ten settle most meshes.
    #[port("Iterations", "Iters", default = 10)]
    iterations: i32,
) -> Result<(Shared<Mesh>, Shared<Mesh>, Vec<Line>), Message> {
    let Some(Value::Mesh(mesh)) = cast::value(&geometry.0, Kind::Mesh, context.rules()) else {
        let name = geometry.0.kind().name();
        return Err(Message::error(format!("Only meshes can be remeshed; a {name} must be meshed before")));
    };
    let iterations = match usize::try_from(iterations) {
        Ok(n) if iterations <= MOST_ROUNDS => n,
        _ => return Err(Message::error(format!("The iterations must be from 0 to {MOST_ROUNDS}"))),
    };
    let mut points: Vec<Point3> = Vec::new();
    for feature in features.present() {
        match cast::value(&feature, Kind::Point, context.rules()) {
            Some(Value::Point(p)) => points.push(p),
            _ => context.warn(format!(
                "A {} is not a feature that can be kept: only points are",
                feature.kind().name()
            )),
        }
    }
    let crease = sharp.then_some(CREASE);
    let options = RemeshOptions { length, iterations, crease, points, limit: MOST_FACES };
    if !(length > 0.0) {
        return Err(Message::error("The length must be greater than 0"));
    }
    // As many equilateral triangles as the area holds, and half as many vertices.
    context.items((2.0 * 2.31 * mesh.area() / (length * length)) as usize)?;
    let done = mesh.remeshed(&options, target.as_deref())?;
    let dual = done.mesh.dual()?;
    Ok((shared(done.mesh), shared(dual), done.creases))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Line, Point3};

    fn number(texts: &[String]) -> f64 {
        texts[0].split([':', ',']).nth(1).and_then(|t| t.trim().parse().ok()).unwrap_or(f64::NAN)
    }

    #[test]
    fn a_box_in_triangles() {
        let made = Trial::of("Mesh Box").run().outputs[0].clone();
        let area = number(&Trial::of("Area").tree(made.clone()).texts(0));
        let side = (area / 6.0).sqrt();
        let trial = |sharp: bool| {
            Trial::of("TriRemesh").tree(made.clone()).default().item(sharp).default().item(side / 8.0).item(6)
        };
        let run = trial(true).run();
        assert!(run.messages.is_empty(), "{:?}", run.messages);
        assert!((number(&Trial::of("Area").tree(run.outputs[0].clone()).texts(0)) / area - 1.0).abs() < 1e-6);
        assert!(run.outputs[2].item_count() > 80);
        assert!(texts(&run.outputs[1])[0].contains("Mesh"));
        let round = trial(false).run();
        assert!(number(&Trial::of("Area").tree(round.outputs[0].clone()).texts(0)) < area);
        assert_eq!(round.outputs[2].item_count(), 0);
    }

    #[test]
    fn odd_inputs() {
        let mesh = Trial::of("Mesh Box").run().outputs[0].clone();
        let trial = |length: f64, n: i32| {
            Trial::of("TriRemesh").tree(mesh.clone()).default().item(true).default().item(length).item(n)
        };
        assert!(trial(0.0, 3).message().contains("length"));
        assert!(trial(1.0, -3).message().contains("iterations"));
        assert!(trial(1e-7, 3).message().len() > 10);
        let line = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
        assert!(Trial::of("TriRemesh").item(line).message().contains("Only meshes"));
    }
}
