//! Meshes made anew of quads.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::QuadSettings;
use katydid_geometry::{Curve, GuideKind, Mesh, Point3, QuadOptions, Vector3};

use crate::mesh::{room, shared};

/// Where faces meet at more than this angle is a hard edge: 30 degrees.
const HARD: f64 = std::f64::consts::FRAC_PI_6;
/// Faces of a Brep of less than so many quads count little.
const SMALL: f64 = 4.0;
/// The most faces on the way.
const MOST_FACES: usize = 4_000_000;
/// At so many places a guide curve leads the quads.
const PLACES: usize = 64;
/// Where edges lie on a curve, it is followed at so many places for each quad.
const PLACES_A_QUAD: f64 = 8.0;
/// The most places at which a curve is followed.
const MOST_PLACES: f64 = 20_000.0;

/// Makes a mesh anew of quads that follow its shape.
///
/// The number of quads comes near to the wanted one, and vertices lie on the mesh. A closed mesh gives a closed mesh, and
/// the border of an open one keeps its shape. A guide curve turns the quads near it so that edges run along it; by the
/// settings a loop of edges lies on it, or a strip of quads runs along it whose edges it crosses. With an adaptive size quads are smaller where the mesh curves and larger where it is flat. Seam edges are those along which
/// the mesh is not welded: where it was made of a Brep, the edges between its faces.
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
    let seams = match settings.seams {
        0 => Vec::new(),
        1 => mesh.seams(Some(SMALL * mesh.area() / count as f64)),
        _ => mesh.seams(None),
    };
    let side = (mesh.area() / count as f64).sqrt();
    let options = QuadOptions {
        count,
        crease: settings.hard_edges.then_some(HARD),
        seams,
        adaptive: (0.01 * settings.adaptive_size).clamp(0.0, 1.0),
        more: settings.adaptive_count,
        guides: guides.present().flat_map(|curve| along(&curve)).collect(),
        loops: match settings.guides {
            1 => guides.present().map(|curve| (GuideKind::Ring, followed(&curve, side))).collect(),
            2 => guides.present().map(|curve| (GuideKind::Loop, followed(&curve, side))).collect(),
            _ => Vec::new(),
        },
        limit: MOST_FACES,
    };
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

/// Points of a curve, many for each quad with sides of a length.
fn followed(curve: &Curve, side: f64) -> Vec<Point3> {
    let domain = curve.domain();
    let places = (PLACES_A_QUAD * curve.length() / side).clamp(PLACES as f64, MOST_PLACES) as usize;
    (0..=places).map(|k| curve.point_at(domain.at(k as f64 / places as f64))).collect()
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
    /// How much quads may vary in size, 0 to 100: at 0 all are of one size, at 100 their sides go with the radius of
    /// curvature, up to four times smaller and larger than the mean.
    #[port("Adaptive Size", "As", default = 0.0)]
    adaptive_size: f64,
    /// Whether there may be more quads than the target: then they are smaller where the shape curves, by the adaptive size,
    /// and nowhere larger than the target makes them.
    #[port("Adaptive Count", "Ac", default = false)]
    adaptive_count: bool,
    /// Whether edges stay where faces meet at more than 30 degrees.
    #[port("Hard Edges", "He", default = false)]
    hard_edges: bool,
    /// Which edges between faces of a Brep stay edges, and in general where a mesh is not welded: 0 none, 1 those between
    /// faces larger than four quads, 2 all.
    #[port("Seam Edges", "Se", default = 0)]
    seams: i32,
    /// About which plane through the middle of its box the mesh is symmetric: 0 none, 1 that across x, 2 across y,
    /// 3 across z.
    #[port("Symmetry", "Sy", default = 0)]
    symmetry: i32,
    /// What guide curves do: 0 they lead the quads about, 1 a ring of edges crosses them, so that they run through the
    /// middle of a strip of quads, 2 a loop of edges lies on them.
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
    use katydid_geometry::construct::cylinder;
    use katydid_geometry::{Cylinder, Interval, Line, Mesh, MeshFace, Plane, Point3, Rectangle};

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

    /// A slanted line on a sheet of 400 quads with sides of 0.12: how much of it lies on edges along it, and how much runs
    /// between two of them, at least a quarter of a quad from each.
    #[test]
    fn guide_curves_by_the_settings() {
        let square = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 3.0), y: Interval::new(0.0, 2.0) };
        let sheet = Mesh::plane(&square, 5, 5).unwrap();
        let guide = Line::new(Point3::new(0.3, 0.4, 0.0), Point3::new(2.7, 1.5, 0.0));
        let [lead, ring, along] = [0, 1, 2].map(|guides| {
            let settings = QuadSettings { guides, ..plain(400) };
            let out = Trial::of("Quad Remesh").item(sheet.clone()).item(guide).item(settings).run();
            assert!(out.messages.is_empty(), "{:?}", out.messages);
            let Some(Value::Mesh(mesh)) = out.outputs[0].column().get(0) else { panic!("a mesh") };
            assert!((mesh.area() - 6.0).abs() < 1e-6, "{}", mesh.area());
            let lines = mesh.edges().iter().filter_map(|e| mesh.edge_line(e)).collect::<Vec<_>>();
            let aligned = |l: &&Line| {
                let angle = l.direction().angle_to(guide.direction()).unwrap().to_degrees();
                angle.min(180.0 - angle) < 20.0
            };
            let lines: Vec<&Line> = lines.iter().filter(aligned).collect();
            let gap = |k: u32| {
                let p = guide.at(0.05 + 0.9 * f64::from(k) / 200.0);
                let foot = |l: &&Line| l.at(l.closest_parameter(p).clamp(0.0, 1.0)).distance_to(p);
                lines.iter().map(foot).fold(f64::INFINITY, f64::min)
            };
            let share =
                |test: &dyn Fn(f64) -> bool| (0..=200).filter(|k| test(gap(*k))).count() as f64 / 201.0;
            [share(&|gap| gap < 1e-3), share(&|gap| (0.03..=0.09).contains(&gap))]
        });
        assert!(along[0] > 0.95, "{along:?}");
        assert!(ring[0] == 0.0 && ring[1] > 0.95, "{ring:?}");
        assert!(lead[0] < 0.5 && lead[1] < 0.95, "{lead:?}");
    }

    #[test]
    fn a_brep_keeps_its_seams_and_sizes_adapt() {
        // A cylinder without caps: where its surface closes no face bends, so only the seam can tell.
        let tube = Cylinder::new(Plane::XY, 1.0, Interval::new(0.0, 4.0)).unwrap();
        let remeshed = |settings: QuadSettings| {
            let brep = Value::from(cylinder(&tube, [true; 2]).unwrap());
            let out = Trial::of("Quad Remesh").item(brep).default().item(settings).run();
            assert!(out.messages.is_empty(), "{:?}", out.messages);
            let Some(Value::Mesh(mesh)) = out.outputs[0].column().get(0) else { panic!("a mesh") };
            (*mesh).clone()
        };
        // The rims, the line where the wall closes, and nothing.
        let on_lines = |mesh: &Mesh| {
            let wanted = |p: Point3, q: Point3| {
                let rim = |p: Point3| p.z.abs() < 1e-9 || (p.z - 4.0).abs() < 1e-9;
                let closing = |p: Point3| (p.x - 1.0).abs() < 1e-9 && p.y.abs() < 1e-9;
                let around = |p: Point3| p.x.hypot(p.y) > 0.98;
                [rim(p) && rim(q) && around(p) && around(q), closing(p) && closing(q)]
            };
            let lines = mesh.edges().iter().filter_map(|e| mesh.edge_line(e)).collect::<Vec<_>>();
            [0, 1].map(|k| lines.iter().filter(|l| wanted(l.from, l.to)[k]).map(|l| l.length()).sum::<f64>())
        };
        let [hard, none] = on_lines(&remeshed(QuadSettings { seams: 0, ..plain(600) }));
        assert!(hard > 12.3 && none < 3.0, "{hard} {none}");
        let smart = QuadSettings { hard_edges: false, seams: 1, ..plain(600) };
        let [rims, none] = on_lines(&remeshed(smart));
        assert!(rims > 12.3 && none < 3.0, "{rims} {none}");
        let [rims, closing] = on_lines(&remeshed(QuadSettings { seams: 2, ..smart }));
        assert!(rims > 12.3 && (closing - 4.0).abs() < 1e-9, "{rims} {closing}");
        // Caps are flat and the wall is not: with more quads for what curves there are more.
        let grown = remeshed(QuadSettings { adaptive_size: 100.0, adaptive_count: true, ..plain(600) });
        assert!(grown.faces().len() > 690, "{}", grown.faces().len());
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
    }
}
