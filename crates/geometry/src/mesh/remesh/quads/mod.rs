//! Meshes made anew of quads that follow the shape.

mod cells;
mod field;
mod lattice;
mod levels;
mod relax;
mod symmetry;

use super::net::Net;
use super::target::Target;
use super::too_many;
use crate::patience::check;
use crate::{Error, Mesh, Point3, Result, Vector3};
use levels::{Hold, Level};

/// What [`Mesh::quad_remeshed`] shall reach.
#[derive(Debug, Clone, PartialEq)]
pub struct QuadOptions {
    /// How many quads, about; at least 1.
    pub count: usize,
    /// Edges where faces meet at more than this angle between their normals, in radians, stay edges.
    pub crease: Option<f64>,
    /// Places near the mesh with directions in which edges shall run there.
    pub guides: Vec<(Point3, Vector3)>,
    /// The most faces that there may be on the way.
    pub limit: usize,
}

impl QuadOptions {
    /// About so many quads, sharp edges not kept.
    pub fn new(count: usize) -> Self {
        Self { count, crease: None, guides: Vec::new(), limit: 4_000_000 }
    }
}

/// Rounds of making the triangles even on the way.
const EVEN: usize = 5;
/// Edges of the triangles on the way, as a part of the sides of the cells.
const FINE: f64 = 1.0 / 3.0;
/// So often the size of the cells is corrected for their number.
const TRIES: usize = 4;
/// A number of quads that is off by less is not corrected.
const NEAR: f64 = 0.05;

impl Mesh {
    /// The same shape in quads of about one size whose edges follow its creases, borders and curvature.
    ///
    /// W. Jakob, M. Tarini, D. Panozzo, O. Sorkine-Hornung, *Instant Field-Aligned Meshes*, 2015: on even triangles a
    /// field of crosses is smoothed, then a field of lattices along the crosses, both over a hierarchy of coarser
    /// graphs and by distances in space, which aligns them to features. The cells are then put together in a way of our
    /// own that leaves no holes: vertices that share a point of the lattice become one by collapses that keep the
    /// surface what it is, two triangles along a diagonal of a cell become a quad, and every face is divided about its
    /// middle, which leaves quads only. Vertices lie on the mesh, those of creases and borders on them. A closed mesh
    /// gives a closed mesh; vertices in one place count as one. The same mesh always gives the same quads.
    ///
    /// # Errors
    /// The count is 0 or would take more than `limit` faces, a guide is not finite, the mesh has no faces with an
    /// area, or nobody waits any more.
    pub fn quad_remeshed(&self, options: &QuadOptions) -> Result<Self> {
        let wanted = options.count as f64;
        if options.count == 0 {
            return Err(Error::OutOfRange { what: "number of quads", value: 0.0, must: "at least 1" });
        }
        if options.guides.iter().any(|(p, d)| !(p.is_finite() && d.is_finite())) {
            return Err(Error::NotFinite("guide"));
        }
        let base = Net::new(self, options.crease)?;
        let surface = Target::new(self, base.lines())?;
        let area = self.area();
        // Each cell becomes four quads.
        let mut side = (4.0 * area / wanted).sqrt();
        let mut best: Option<(f64, Self)> = None;
        for _ in 0..TRIES {
            let made = self.in_cells(side, options, &surface)?;
            let share = made.faces().len() as f64 / wanted;
            let off = share.ln().abs();
            if best.as_ref().is_none_or(|(least, _)| off < *least) {
                best = Some((off, made));
            }
            if off <= NEAR || !(share > 0.0) {
                break;
            }
            side *= share.sqrt().clamp(0.5, 2.0);
        }
        best.map(|(_, mesh)| mesh).ok_or(Error::degenerate("mesh to remesh", "it has no faces with an area"))
    }

    /// Quads from cells with sides of a length.
    fn in_cells(&self, side: f64, options: &QuadOptions, surface: &Target) -> Result<Self> {
        let fine = side * FINE;
        // An equilateral triangle has √3/4 times the square of its side.
        if !(self.area() / (0.25 * 3.0_f64.sqrt() * fine * fine) <= options.limit as f64) {
            return Err(too_many());
        }
        let mut net = Net::new(self, options.crease)?;
        for _ in 0..EVEN {
            check()?;
            net.split_long(4.0 / 3.0 * fine, options.limit)?;
            net.collapse_short(4.0 / 5.0 * fine, 4.0 / 3.0 * fine);
            net.flip();
            net.smooth(|p| surface.nearest(p), |p| surface.nearest_on_line(p));
        }
        let (vertices, level) = level_of(&net, &options.guides);
        let places = field::solve(level, side)?;
        let mut at = vec![Point3::ORIGIN; net.vertex_count()];
        for (&v, place) in vertices.iter().zip(places) {
            if let Some(at) = at.get_mut(v as usize) {
                *at = place;
            }
        }
        cells::gather(&mut net, &mut at, side)?;
        let quads = cells::quads(&net, &at);
        relax::finished(&net, at, &quads, surface)
    }
}

/// The vertices that have faces, and the graph of them that fields are smoothed on.
fn level_of(net: &Net, guides: &[(Point3, Vector3)]) -> (Vec<u32>, Level) {
    let vertices = net.vertices();
    let mut number = vec![u32::MAX; net.vertex_count()];
    for (&v, k) in vertices.iter().zip(0..) {
        number[v as usize] = k;
    }
    let points: Vec<Point3> = vertices.iter().map(|&v| net.at(v)).collect();
    let normals = vertices.iter().map(|&v| net.normal_at(v)).collect();
    let areas = vertices.iter().map(|&v| net.area_at(v)).collect();
    let links = vertices.iter().map(|&v| {
        net.neighbours(v).into_iter().map(|w| (number[w as usize], 1.0)).collect::<Vec<(u32, f64)>>()
    });
    let mut along = vec![None; points.len()];
    let mut held = vec![Hold::Free; points.len()];
    for (k, &v) in vertices.iter().enumerate() {
        let ends = net.kept_neighbours(v);
        match ends.as_slice() {
            [] => {}
            &[a, b] if net.goes_straight(v, &ends) => {
                if let Some(direction) = (net.at(b) - net.at(a)).unitized() {
                    along[k] = Some(direction);
                    held[k] = Hold::Line(points[k], direction);
                }
            }
            _ => held[k] = Hold::Point(points[k]),
        }
    }
    let level = Level::new(points, normals, areas, links, along, held);
    (vertices, level.guided(guides))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Box3, Interval, MeshFace, Plane, Rectangle, Torus};

    fn quads_only(mesh: &Mesh) -> bool {
        mesh.faces().iter().all(|f| matches!(f, MeshFace::Quad(_)))
    }

    fn sound(mesh: &Mesh, count: usize, closed: bool) {
        assert!(quads_only(mesh) && mesh.check().is_ok());
        assert!(mesh.is_manifold() && mesh.is_oriented());
        assert_eq!(mesh.is_closed(), closed);
        let share = mesh.faces().len() as f64 / count as f64;
        assert!((share - 1.0).abs() < 0.15, "{} faces, {count} wanted", mesh.faces().len());
    }

    /// The part of the corners that are within 30° of square.
    fn squareness(mesh: &Mesh) -> f64 {
        let (mut good, mut all) = (0, 0);
        for i in 0..mesh.faces().len() {
            let p = mesh.face_points(i).unwrap();
            for k in 0..4 {
                let (a, b) = (p[(k + 1) % 4] - p[k], p[(k + 3) % 4] - p[k]);
                all += 1;
                good +=
                    usize::from(a.angle_to(b).is_some_and(|x| {
                        (x - std::f64::consts::FRAC_PI_2).abs() < std::f64::consts::FRAC_PI_6
                    }));
            }
        }
        f64::from(good as u32) / f64::from(all)
    }

    /// The part of the vertices where four edges meet.
    fn regular(mesh: &Mesh) -> f64 {
        let mut valence = vec![0; mesh.vertices().len()];
        mesh.edges().iter().flat_map(|e| e.vertices).for_each(|v| valence[v as usize] += 1);
        valence.iter().filter(|n| **n == 4).count() as f64 / valence.len() as f64
    }

    #[test]
    fn spheres() {
        let sphere = Mesh::sphere(&Plane::XY, 2.0, 48, 24).unwrap();
        for count in [400, 2000] {
            let mesh = sphere.quad_remeshed(&QuadOptions::new(count)).unwrap();
            sound(&mesh, count, true);
            assert!(mesh.vertices().iter().all(|p| (p.to_vector().length() - 2.0).abs() < 0.02));
            let (square, even) = (squareness(&mesh), regular(&mesh));
            println!("sphere {count}: {} faces, square {square:.3}, regular {even:.3}", mesh.faces().len());
            assert!(square > 0.9 && even > 0.85, "{square} {even}");
        }
    }

    #[test]
    fn a_box_keeps_its_edges() {
        let side = Interval::new(-1.0, 1.0);
        let cube = Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 3, 3, 3).unwrap();
        let options = QuadOptions { crease: Some(0.5), ..QuadOptions::new(600) };
        let mesh = cube.quad_remeshed(&options).unwrap();
        sound(&mesh, 600, true);
        assert!((mesh.volume() - 8.0).abs() < 1e-9, "{}", mesh.volume());
        println!("box: square {:.3}, regular {:.3}", squareness(&mesh), regular(&mesh));
        assert!(squareness(&mesh) > 0.95 && regular(&mesh) > 0.95);
    }

    #[test]
    fn tori_and_cylinders() {
        let torus = Torus::new(Plane::XY, 3.0, 1.0).unwrap();
        let surface = crate::Surface::from(torus.to_revolution());
        let meshing = crate::SurfaceMeshing::default();
        let mesh = Mesh::from_surface(&surface, &meshing).unwrap().welded(3.0);
        let made = mesh.quad_remeshed(&QuadOptions::new(1500)).unwrap();
        sound(&made, 1500, true);
        println!("torus: square {:.3}, regular {:.3}", squareness(&made), regular(&made));
        assert!(squareness(&made) > 0.9);
    }

    #[test]
    fn sheets_keep_their_border() {
        let square = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 3.0), y: Interval::new(0.0, 2.0) };
        let mesh = Mesh::plane(&square, 5, 5).unwrap();
        let made = mesh.quad_remeshed(&QuadOptions::new(150)).unwrap();
        sound(&made, 150, false);
        assert!((made.area() - 6.0).abs() < 1e-9, "{}", made.area());
        assert!(made.face_normals().iter().all(|n| n.z > 0.99));
    }

    #[test]
    fn the_same_again_and_refused() {
        let sphere = Mesh::sphere(&Plane::XY, 1.0, 24, 12).unwrap();
        let options = QuadOptions::new(200);
        assert_eq!(sphere.quad_remeshed(&options), sphere.quad_remeshed(&options));
        assert!(sphere.quad_remeshed(&QuadOptions::new(0)).is_err());
        assert!(sphere.quad_remeshed(&QuadOptions::new(1_000_000_000)).is_err());
        assert!(Mesh::default().quad_remeshed(&options).is_err());
        let none = crate::Patience::new(|| false);
        assert_eq!(none.during(|| sphere.quad_remeshed(&options)), Err(Error::Stopped));
        let few = sphere.quad_remeshed(&QuadOptions::new(1)).unwrap();
        assert!(few.is_closed() && quads_only(&few));
    }
}
