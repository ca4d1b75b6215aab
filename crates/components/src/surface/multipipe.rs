//! Surface / SubD: branching pipes.

use katydid_component::{Context, List, Message, component};
use katydid_data::Kind;
use katydid_data::{Geometry, Value, cast};
use katydid_geometry::subd::{MultiPipe, MultiPipeCap, MultiPipeNetwork, SubDNet};
use katydid_geometry::{Curve, Mesh, Point3};

use super::subd::kept;
use super::warning;

/// A smooth branching pipe around curves that meet at their ends, as a SubD.
///
/// Ends nearer than the tolerance are one node. Where more than two struts meet, or two meet sharply, there is a joint;
/// curves that cross elsewhere are not joined. Where struts are short, or meet at small angles, the pipe is thinner.
#[component("4bfe1bf6-fbc9-4ad2-bf28-a7402e1392ee", name = "MultiPipe", nick = "MP", at = "Surface/SubD")]
#[output("Pipe", "P", "The pipe.", kind = SubD)]
#[allow(clippy::too_many_arguments, reason = "an argument is a port")]
fn multi_pipe(
    context: &Context<'_>,
    /// The curves, and meshes, whose edges are taken.
    #[port("Curves", "Curves")]
    curves: List<Geometry>,
    /// The radius of the pipe, greater than 0: one for all nodes, or one for each of the points below.
    #[port("NodeSize", "NodeSize", default = 0.5)]
    sizes: List<f64>,
    /// The places whose nearest nodes get the radii; radii of nodes between go over evenly.
    #[port("SizePoints", "SizePoints", optional)]
    points: List<Point3>,
    /// How far from a node the first loop of edges is at least, in radii; 0 for as near as it can be.
    #[port("EndOffset", "EndOffset", default = 1.0)]
    end_offset: f64,
    /// The thickness of struts between their nodes: below 1 they are waisted, above 1 they bulge.
    #[port("StrutSize", "StrutSize", default = 1.0)]
    strut_size: f64,
    /// About how far loops of edges are from each other along a strut, in units; 0 for none.
    #[port("Segment", "Segment", default = 0.0)]
    segment: f64,
    /// By how much smooth curves may turn from one straight piece to the next, in radians.
    #[port("KinkAngle", "KinkAngle", default = 0.6)]
    kink_angle: f64,
    /// How willingly nodes become cubes: 0 never, 1 wherever each strut finds a side of its own, between them where
    /// struts are near enough to right angles.
    #[port("CubeFit", "CubeFit", default = 0.0)]
    cube_fit: f64,
    /// Ends that meet nothing: 0 open, 1 round, 2 flat.
    #[port("Caps", "Caps", default = 0, optional)]
    caps: i32,
) -> Result<Value, Message> {
    let caps = match caps {
        0 => MultiPipeCap::Open,
        1 => MultiPipeCap::Round,
        2 => MultiPipeCap::Flat,
        other => return Err(Message::error(format!("There is no cap {other}: 0 is none, 1 round, 2 flat"))),
    };
    let pipe = options(&sizes, &points, [end_offset, strut_size, segment, cube_fit], caps);
    kept(context, piped(context, &curves, kink_angle, &pipe)?)
}

/// A smooth branching pipe around curves that meet at their ends, as a SubD with open ends: the first version.
#[component(
    "f1b75016-5818-4ece-be56-065253a2357d",
    name = "MultiPipe",
    nick = "MP",
    at = "Surface/SubD",
    old
)]
#[output("Pipe", "P", "The pipe.", kind = SubD)]
#[allow(clippy::too_many_arguments, reason = "an argument is a port")]
fn multi_pipe_without_caps(
    context: &Context<'_>,
    /// The curves, and meshes, whose edges are taken.
    #[port("Curves", "Curves")]
    curves: List<Geometry>,
    /// The radius of the pipe, greater than 0: one for all nodes, or one for each of the points below.
    #[port("NodeSize", "NodeSize", default = 0.5)]
    sizes: List<f64>,
    /// The places whose nearest nodes get the radii; radii of nodes between go over evenly.
    #[port("SizePoints", "SizePoints", optional)]
    points: List<Point3>,
    /// How far from a node the first loop of edges is at least, in radii; 0 for as near as it can be.
    #[port("EndOffset", "EndOffset", default = 1.0)]
    end_offset: f64,
    /// The thickness of struts between their nodes: below 1 they are waisted, above 1 they bulge.
    #[port("StrutSize", "StrutSize", default = 1.0)]
    strut_size: f64,
    /// About how far loops of edges are from each other along a strut, in units; 0 for none.
    #[port("Segment", "Segment", default = 0.0)]
    segment: f64,
    /// By how much smooth curves may turn from one straight piece to the next, in radians.
    #[port("KinkAngle", "KinkAngle", default = 0.6)]
    kink_angle: f64,
    /// How willingly nodes become cubes: 0 never, 1 wherever each strut finds a side of its own, between them where
    /// struts are near enough to right angles.
    #[port("CubeFit", "CubeFit", default = 0.0)]
    cube_fit: f64,
) -> Result<Value, Message> {
    let pipe = options(&sizes, &points, [end_offset, strut_size, segment, cube_fit], MultiPipeCap::Open);
    kept(context, piped(context, &curves, kink_angle, &pipe)?)
}

fn options(
    sizes: &List<f64>,
    points: &List<Point3>,
    [end_offset, strut_size, segment, cube_fit]: [f64; 4],
    caps: MultiPipeCap,
) -> MultiPipe {
    let (radii, size_points) = (sizes.present().collect(), points.present().collect());
    MultiPipe { radii, size_points, end_offset, strut_size, segment, cube_fit, caps }
}

/// What a face of a net takes as bytes of a SubD.
const FACE: usize = 400;

fn piped(
    context: &Context<'_>,
    shapes: &List<Geometry>,
    kink_angle: f64,
    pipe: &MultiPipe,
) -> Result<SubDNet, Message> {
    let mut lines = Vec::new();
    for shape in shapes.present() {
        match (cast::value(&shape.0, Kind::Curve, context.rules()), &shape.0) {
            (Some(Value::Curve(curve)), _) => lines.extend(pieces(&curve, kink_angle)?),
            (_, Value::Mesh(mesh)) => lines.extend(edges(mesh)),
            (_, other) => {
                return Err(Message::error(format!(
                    "A {} is neither a curve nor a mesh",
                    other.kind().name()
                )));
            }
        }
        context.bytes(lines.len().saturating_mul(8 * FACE))?;
    }
    let network = MultiPipeNetwork::of_lines(&lines, context.tolerance().absolute).map_err(warning)?;
    pipe.around(&network).map_err(warning)
}

fn pieces(curve: &Curve, angle: f64) -> Result<Vec<[Point3; 2]>, Message> {
    MultiPipeNetwork::lines_of(curve, angle).map_err(warning)
}

fn edges(mesh: &Mesh) -> Vec<[Point3; 2]> {
    let lines = mesh.edges();
    lines.iter().filter_map(|edge| mesh.edge_line(edge)).map(|line| [line.from, line.to]).collect()
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Box3, Interval, Line, Mesh, Plane, Point3};

    fn line(x: f64, y: f64, z: f64) -> Line {
        Line::new(Point3::ORIGIN, Point3::new(x, y, z))
    }

    /// Three struts along the axes, radius 0.2.
    fn tripod(caps: i32) -> Trial {
        let lines = [line(5.0, 0.0, 0.0), line(0.0, 5.0, 0.0), line(0.0, 0.0, 5.0)];
        let trial = Trial::of("MultiPipe").list(lines).list([0.2]).default();
        trial.default().default().default().default().default().item(caps)
    }

    fn volume(trial: Trial) -> f64 {
        let subd = trial.run().outputs.swap_remove(0);
        let mesh = Trial::of("Mesh from SubD").tree(subd).item(3).run().outputs.swap_remove(0);
        let text = Trial::of("Volume").tree(mesh).texts(0).join("");
        text.split(':').nth(1).and_then(|t| t.trim().parse().ok()).unwrap_or(f64::NAN)
    }

    /// Between the volume of three thin cylinders and that of somewhat thicker and longer ones.
    #[test]
    fn a_tripod() {
        let cylinders = 3.0 * std::f64::consts::PI * 0.04 * 5.0;
        for caps in [1, 2] {
            let volume = volume(tripod(caps));
            assert!(volume > 0.85 * cylinders && volume < 1.15 * cylinders, "{volume} {cylinders}");
        }
        assert!(tripod(3).run().messages.iter().any(|m| m.text.contains("no cap 3")));
    }

    #[test]
    fn edges_of_meshes_and_what_is_none() {
        let side = Interval::new(0.0, 3.0);
        let shape = Box3 { plane: Plane::XY, x: side, y: side, z: side };
        let mesh = Value::from(Mesh::cuboid(&shape, 1, 1, 1).unwrap());
        let made = Trial::of("MultiPipe").list([mesh]).list([0.3]).run();
        assert!(made.messages.is_empty(), "{:?}", made.messages);
        assert_eq!(made.outputs[0].item_count(), 1);
        let none = Trial::of("MultiPipe").list([line(0.0, 0.0, 0.0)]).run();
        assert!(none.messages.iter().any(|m| m.text.contains("no struts")));
        let negative = Trial::of("MultiPipe").list([line(1.0, 0.0, 0.0)]).list([-1.0]).run();
        assert!(!negative.messages.is_empty());
    }
}
