//! Meshes made anew of quads.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::QuadSettings;
use katydid_geometry::{Curve, Mesh, Point3, QuadOptions, Vector3};

use crate::mesh::{room, shared};

/// Where faces meet at more than this angle is a hard edge: 30 degrees.
const HARD: f64 = std::f64::consts::FRAC_PI_6;
/// The most faces on the way.
const MOST_FACES: usize = 4_000_000;
/// At so many places a guide curve leads the quads.
const PLACES: usize = 64;

/// Makes a mesh anew of quads of about one size that follow its shape.
///
/// The number of quads comes near to the wanted one, and vertices lie on the mesh. A closed mesh gives a closed mesh, and
/// the border of an open one keeps its shape. A guide curve turns the quads near it so that edges run along it. Quads
/// are of one size: the settings for adaptive size and count are left aside.
#[component(
    "1a17d3f0-c8f8-4ee9-8dab-ea1c29db6a49",
    name = "Quad Remesh",
    nick = "QRMesh",
    at = "Mesh/Triangulation"
)]
#[output("Quad result", "Q", "The mesh of quads.")]
fn quad_remesh(
    context: &Context<'_>,
    /// The mesh, or what becomes one on a mesh port.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// Curves near the mesh along which edges shall run.
    #[port("Guides", "G", optional)]
    guides: List<Shared<Curve>>,
    /// How many quads, and what is kept.
    #[port("Settings", "S", default = QuadSettings::default())]
    settings: QuadSettings,
) -> Result<Shared<Mesh>, Message> {
    let count = usize::try_from(settings.count).ok().filter(|n| *n > 0);
    let count = count.ok_or_else(|| Message::error("The target count must be at least 1"))?;
    room(context, count)?;
    if settings.adaptive_size > 0.0 || settings.adaptive_count {
        context.tell(Message::remark("The quads are of one size: adaptive sizes are not supported"));
    }
    // Faces of a mesh have no seams but its hard edges.
    let crease = (settings.hard_edges || settings.seams > 0).then_some(HARD);
    let guides = guides.present().flat_map(|curve| along(&curve)).collect();
    let options = QuadOptions { count, crease, guides, limit: MOST_FACES };
    let axes = [1, 2, 4].map(|bit| settings.symmetry & bit != 0);
    Ok(shared(mesh.quad_remeshed_symmetric(&options, axes, context.tolerance().absolute)?))
}

/// Places along a curve with its direction there.
fn along(curve: &Curve) -> Vec<(Point3, Vector3)> {
    let domain = curve.domain();
    (0..=PLACES)
        .map(|k| domain.at(k as f64 / PLACES as f64))
        .filter_map(|t| Some((curve.point_at(t), curve.tangent_at(t)?)))
        .collect()
}

/// How a mesh is made anew of quads, for Quad Remesh.
#[component(
    "f562505b-4c49-49d1-932d-c8804b3fcec6",
    name = "Quad Remesh Settings",
    nick = "QRSettings",
    at = "Mesh/Triangulation"
)]
#[output("Settings", "S", "The settings.")]
#[allow(clippy::too_many_arguments, reason = "an argument is a port")]
fn quad_remesh_settings(
    /// How many quads are wanted, at least 1.
    #[port("Target Count", "Tc", default = 1000)]
    count: i32,
    /// How much quads may vary in size, 0 to 100. Not followed: quads are of one size.
    #[port("Adaptive Size", "As", default = 0.0)]
    adaptive_size: f64,
    /// Whether there may be more quads where the shape curves. Not followed.
    #[port("Adaptive Count", "Ac", default = false)]
    adaptive_count: bool,
    /// Whether edges stay where faces meet at more than 30 degrees.
    #[port("Hard Edges", "He", default = false)]
    hard_edges: bool,
    /// Which edges between faces stay: 0 none, 1 those that matter, 2 all. Of a mesh, 1 and 2 keep its hard edges.
    #[port("Seam Edges", "Se", default = 0)]
    seams: i32,
    /// About which plane through the middle of its box the mesh is symmetric: 0 none, 1 that across x, 2 across y,
    /// 3 across z.
    #[port("Symmetry", "Sy", default = 0)]
    symmetry: i32,
    /// What guide curves do: 0 they lead the quads about, 1 a ring of edges crosses them, 2 a loop of edges runs along
    /// them. Here edges run along them in each case.
    #[port("Guide Curves", "Gc", default = 0)]
    guides: i32,
) -> Result<QuadSettings, Message> {
    if count < 1 {
        return Err(Message::error("The target count must be at least 1"));
    }
    if !(0.0..=100.0).contains(&adaptive_size) {
        return Err(Message::error("The adaptive size is a number from 0 to 100"));
    }
    let within = |n: i32, most: i32, what: &str| match n {
        n if (0..=most).contains(&n) => Ok(n),
        _ => Err(Message::error(format!("{what} is a number from 0 to {most}"))),
    };
    let symmetry = match within(symmetry, 3, "The symmetry")? {
        0 => 0,
        axis => 1 << (axis - 1),
    };
    Ok(QuadSettings {
        count,
        adaptive_size,
        adaptive_count,
        hard_edges,
        seams: within(seams, 2, "The seam edges")?,
        symmetry,
        guides: within(guides, 2, "The guide curves")?,
    })
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{QuadSettings, Value};
    use katydid_geometry::{Mesh, MeshFace, Plane};

    fn quads(settings: QuadSettings) -> Mesh {
        let sphere = Mesh::sphere(&Plane::XY, 2.0, 32, 16).unwrap();
        let out = Trial::of("Quad Remesh").item(sphere).default().item(settings).run();
        assert!(out.messages.is_empty(), "{:?}", out.messages);
        match out.outputs[0].column().get(0) {
            Some(Value::Mesh(mesh)) => (*mesh).clone(),
            other => panic!("{other:?}"),
        }
    }

    fn plain(count: i32) -> QuadSettings {
        let none = QuadSettings::default();
        QuadSettings { count, adaptive_size: 0.0, adaptive_count: false, ..none }
    }

    #[test]
    fn a_sphere_of_quads() {
        let mesh = quads(plain(300));
        assert!(mesh.is_closed() && mesh.faces().iter().all(|f| matches!(f, MeshFace::Quad(_))));
        assert!((255..=345).contains(&mesh.faces().len()), "{}", mesh.faces().len());
        let halves = quads(QuadSettings { symmetry: 1, ..plain(300) });
        assert!(halves.is_closed());
        // Every vertex has its mirror image.
        for p in halves.vertices() {
            let image = katydid_geometry::Point3::new(-p.x, p.y, p.z);
            assert!(halves.vertices().iter().any(|q| q.distance_to(image) < 1e-9), "{p:?}");
        }
    }

    #[test]
    fn settings_are_checked() {
        assert_eq!(Trial::of("Quad Remesh Settings").texts(0), ["{0}: Quad Remesh Settings"]);
        let made =
            Trial::of("Quad Remesh Settings").item(500).item(0.0).item(false).item(true).item(2).item(3);
        let Some(Value::QuadSettings(made)) = made.run().outputs[0].column().get(0) else { panic!() };
        assert_eq!((made.count, made.symmetry, made.seams, made.hard_edges), (500, 4, 2, true));
        assert!(Trial::of("Quad Remesh Settings").item(0).message().contains("at least 1"));
        assert!(Trial::of("Quad Remesh Settings").item(9).item(200.0).message().contains("0 to 100"));
        let wrong = Trial::of("Quad Remesh Settings").item(9).default().default().default().default().item(7);
        assert!(wrong.message().contains("0 to 3"));
        let sphere = Mesh::sphere(&Plane::XY, 2.0, 8, 4).unwrap();
        let remark = Trial::of("Quad Remesh").item(sphere);
        assert!(remark.message().contains("one size"));
    }
}
