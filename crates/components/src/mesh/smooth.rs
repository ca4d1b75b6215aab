//! Mesh / Util: vertices and colours moved towards each other.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_geometry::{Mesh, Smoothing};

use super::{integer, shared};

/// A number of steps.
fn steps(n: i32) -> Result<usize, Message> {
    usize::try_from(n)
        .map_err(|_| Message::error(format!("The number of iterations is {n}: it may not be negative")))
}

/// Evens a mesh out: in each step every vertex moves towards the middle of its neighbours.
///
/// Vertices in the same place stay together.
#[component("e45aa4a0-e40d-421c-a335-5185dd131836", name = "Smooth Mesh", nick = "MSmooth", at = "Mesh/Util")]
#[output("Mesh", "M", "The smoothed mesh.")]
fn smooth_mesh(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// How far a vertex goes in a step: 0 stays, 1 goes all the way to the middle of its neighbours.
    #[port("Strength", "S", default = 0.5)]
    strength: f64,
    /// Whether vertices on naked edges stay where they are.
    #[port("Skip Naked", "N", default = true)]
    skip_naked: bool,
    /// The number of steps, 0 or more.
    #[port("Iterations", "I", default = 1)]
    iterations: i32,
    /// The greatest distance that a vertex may move in all, in units; without it there is no limit.
    #[port("Limit", "L", optional)]
    limit: Option<f64>,
) -> Result<Shared<Mesh>, Message> {
    let options = Smoothing { strength, skip_naked, iterations: steps(iterations)?, limit };
    let mut state = Ok(());
    let smooth = mesh.smoothed(&options, || {
        state = context.check();
        state.is_ok()
    });
    state?;
    Ok(shared(smooth?))
}

/// Blurs the colours of a mesh: in each step every vertex takes the mean of its colour and those of its neighbours.
#[component("48a9fa10-8d3c-4767-aca6-81232271f6e0", name = "Blur Mesh", nick = "MBlur", at = "Mesh/Util")]
#[output("Mesh", "M", "The blurred mesh; one without colours as it was.")]
fn blur_mesh(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The number of steps, 0 or more.
    #[port("Iterations", "I", default = 1)]
    iterations: i32,
) -> Result<Shared<Mesh>, Message> {
    let mut state = Ok(());
    let blurred = mesh.blurred(steps(iterations)?, || {
        state = context.check();
        state.is_ok()
    });
    state?;
    Ok(shared(blurred))
}

/// Puts vertices together that lie nearer to each other than the tolerance: each moves to the nearest earlier one.
#[component(
    "db661dd7-63a4-44c6-91f2-6faab2471383",
    name = "Align Vertices",
    nick = "AlignVert",
    at = "Mesh/Util"
)]
#[output("Result", "R", "The mesh.")]
#[output("Count", "N", "How many vertices moved.")]
fn align_vertices(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The greatest distance, in units.
    #[port("Tolerance", "T", default = 0.1)]
    tolerance: f64,
) -> Result<(Shared<Mesh>, i32), Message> {
    let (aligned, moved) = mesh.with_aligned_vertices(tolerance)?;
    Ok((shared(aligned), integer(moved)))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Interval, Mesh, Plane, Point3, Rectangle};

    fn peak() -> Mesh {
        let side = Interval::new(0.0, 2.0);
        let flat = Mesh::plane(&Rectangle { plane: Plane::XY, x: side, y: side }, 2, 2).unwrap();
        let mut points = flat.vertices().to_vec();
        points[4].z = 1.0;
        let mut colours = vec![[0, 0, 0, 255]; 9];
        colours[4] = [100, 200, 50, 255];
        Mesh::from_parts(points, flat.faces().to_vec(), Vec::new(), colours).unwrap()
    }

    fn made(trial: Trial) -> std::sync::Arc<Mesh> {
        match trial.run().outputs[0].column().get(0) {
            Some(Value::Mesh(m)) => m,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn smoothed() {
        let height = |t: Trial| made(t).vertices()[4].z;
        assert_eq!(height(Trial::of("Smooth Mesh").item(peak())), 0.5);
        assert_eq!(height(Trial::of("Smooth Mesh").item(peak()).item(1.0)), 0.0);
        assert_eq!(
            height(Trial::of("Smooth Mesh").item(peak()).item(1.0).default().default().item(0.25)),
            0.75
        );
        assert_eq!(height(Trial::of("Smooth Mesh").item(peak()).default().default().item(0)), 1.0);
        assert!(
            Trial::of("Smooth Mesh").item(peak()).default().default().item(-1).message().contains("negative")
        );
        let whole = made(Trial::of("Smooth Mesh").item(peak()).default().item(false));
        assert!(whole.vertices()[0] != Point3::ORIGIN);
    }

    #[test]
    fn blurred_and_aligned() {
        assert_eq!(made(Trial::of("Blur Mesh").item(peak())).colours()[4], [20, 40, 10, 255]);
        assert_eq!(made(Trial::of("Blur Mesh").item(peak()).item(0)).colours()[4], [100, 200, 50, 255]);
        assert!(Trial::of("Blur Mesh").item(peak()).item(-3).message().contains("negative"));
        let near = Trial::of("Align Vertices").item(peak()).item(1.2).run();
        assert_eq!(texts(&near.outputs[1]), ["{0}: 4"]);
        assert_eq!(Trial::of("Align Vertices").item(peak()).texts(1), ["{0}: 0"]);
        assert!(!Trial::of("Align Vertices").item(peak()).item(-1.0).message().is_empty());
    }
}
