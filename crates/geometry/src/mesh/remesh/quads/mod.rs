//! Meshes made anew of quads that follow the shape.

mod cells;
mod field;
mod guides;
mod lattice;
mod levels;
mod relax;
mod sizes;
mod symmetry;

use katydid_elementary::Elementary;

use super::imprint::{Course, imprint};
use super::net::Net;
use super::target::Target;
use super::too_many;
use crate::cancellation::check;
use crate::{Error, Line, Mesh, Point3, Result, Vector3};
pub use guides::GuideKind;
use guides::Guides;
use levels::{Hold, Level, Places};
use sizes::Sizes;

/// What [`Mesh::quad_remeshed`] shall reach.
#[derive(Debug, Clone, PartialEq)]
pub struct QuadOptions {
    /// How many quads, about; at least 1.
    pub count: usize,
    /// Edges where faces meet at more than this angle between their normals, in radians, stay edges.
    pub crease: Option<f64>,
    /// Edges of the mesh that lie on these lines stay edges; [`Mesh::seams`] has those between its parts.
    pub seams: Vec<Line>,
    /// How much smaller quads are where the mesh curves and larger where it is flat: from 0, all of one size, to 1.
    pub adaptive: f64,
    /// Whether there may be more quads than wanted for what curves: then none is larger than if all were of one size.
    pub more: bool,
    /// Places near the mesh with directions in which edges shall run there.
    pub guides: Vec<(Point3, Vector3)>,
    /// Polylines near the mesh, and what the edges do along each; what is farther from it than a quad counts for nothing.
    pub loops: Vec<(GuideKind, Vec<Point3>)>,
    /// The most faces that there may be on the way.
    pub limit: usize,
}

impl QuadOptions {
    /// About so many quads of one size, sharp edges not kept.
    pub fn new(count: usize) -> Self {
        Self {
            count,
            crease: None,
            seams: Vec::new(),
            adaptive: 0.0,
            more: false,
            guides: Vec::new(),
            loops: Vec::new(),
            limit: 4_000_000,
        }
    }
}

/// The curvature that sizes follow is taken on at least so many triangles.
const TRIANGLES: f64 = 4000.0;
/// Rounds of making the triangles even on the way.
const EVEN: usize = 5;
/// Rounds of making them even again after curves were laid into them.
const AGAIN: usize = 3;
/// Edges of the triangles on the way, as a part of the sides of the cells.
const FINE: f64 = 1.0 / 3.0;
/// So often the size of the cells is corrected for their number.
const TRIES: usize = 4;
/// A number of quads that is off by less is not corrected.
const NEAR: f64 = 0.05;

impl Mesh {
    /// The same shape in quads whose edges follow its creases, borders and curvature, of about one size unless they
    /// adapt to the curvature.
    ///
    /// W. Jakob, M. Tarini, D. Panozzo, O. Sorkine-Hornung, *Instant Field-Aligned Meshes*, 2015: on even triangles a
    /// field of crosses is smoothed, then a field of lattices along the crosses, both over a hierarchy of coarser
    /// graphs and by distances in space, which aligns them to features. The cells are then put together in a way of our
    /// own that leaves no holes: vertices that share a point of the lattice become one by collapses that keep the
    /// surface what it is, two triangles along a diagonal of a cell become a quad, and every face is divided about its
    /// middle, which leaves quads only. Where sizes adapt, the lattices' steps differ from place to place: two neighbours
    /// are fitted with the mean of their steps. Vertices lie on the mesh, those of creases and borders on them. A closed mesh
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
        let guided = options.guides.iter().all(|(p, d)| p.is_finite() && d.is_finite());
        if !guided || options.loops.iter().flat_map(|l| &l.1).any(|p| !p.is_finite()) {
            return Err(Error::NotFinite("guide"));
        }
        if !(0.0..=1.0).contains(&options.adaptive) {
            let must = "from 0 to 1";
            return Err(Error::OutOfRange { what: "adaptation of sizes", value: options.adaptive, must });
        }
        let base = Net::with_lines(self, options.crease, &options.seams)?;
        let surface = Target::new(self, base.lines())?;
        let area = self.area();
        // Each cell becomes four quads.
        let mut side = (4.0 * area / wanted).sqrt();
        let sizes = self.sizes(side, options, &surface)?;
        let wanted = wanted * sizes.share;
        let guides = guides::guides(self, options, &surface, |p| 0.5 * side * sizes.at(p));
        let surface =
            surface.with_lines(guides.courses.iter().flat_map(|course| course.lines().iter().copied()));
        let mut best: Option<(f64, Self)> = None;
        for _ in 0..TRIES {
            let made = self.in_cells(side, &sizes, options, &surface, &guides)?;
            let share = made.faces().len() as f64 / wanted;
            let off = share.logarithm().abs();
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

    /// How large cells are where, as factors of a side.
    fn sizes(&self, side: f64, options: &QuadOptions, surface: &Target) -> Result<Sizes> {
        if options.adaptive == 0.0 {
            return Ok(Sizes::even());
        }
        let length = (side * FINE).min(triangle_side(self.area() / TRIANGLES));
        let net = self.even_net(|_| length, length, options, surface, &[])?;
        Ok(Sizes::by_curvature(&net, side, options.adaptive, options.more))
    }

    /// Even triangles whose edges have about the length that is wanted where they are; `mean` is what it is about.
    fn even_net(
        &self,
        length: impl Fn(Point3) -> f64,
        mean: f64,
        options: &QuadOptions,
        surface: &Target,
        courses: &[Course],
    ) -> Result<Net> {
        if !(self.area() / triangle_area(mean) <= options.limit as f64) {
            return Err(too_many());
        }
        let mut net = Net::with_lines(self, options.crease, &options.seams)?;
        let even_out = |net: &mut Net, rounds: usize| {
            for _ in 0..rounds {
                check()?;
                net.split_long(|p| 4.0 / 3.0 * length(p), options.limit)?;
                net.collapse_short(|p| 4.0 / 5.0 * length(p), |p| 4.0 / 3.0 * length(p));
                net.flip();
                net.smooth(|p| surface.nearest(p), |p| surface.nearest_on_line(p));
            }
            Ok(())
        };
        even_out(&mut net, EVEN)?;
        if !courses.is_empty() {
            for course in courses {
                imprint(&mut net, course, &length)?;
            }
            even_out(&mut net, AGAIN)?;
        }
        Ok(net)
    }

    /// Quads from cells with sides of a length, times what the sizes say.
    fn in_cells(
        &self,
        side: f64,
        sizes: &Sizes,
        options: &QuadOptions,
        surface: &Target,
        guides: &Guides,
    ) -> Result<Self> {
        let fine = side * FINE;
        let mean = fine / sizes.share.sqrt();
        let mut net = self.even_net(|p| fine * sizes.at(p), mean, options, surface, &guides.courses)?;
        let (vertices, level) = level_of(&net, &options.guides, |p| side * sizes.at(p));
        let mut sides = vec![side; net.vertex_count()];
        for (&v, own) in vertices.iter().zip(&level.sides) {
            if let Some(side) = sides.get_mut(v as usize) {
                *side = *own;
            }
        }
        let places = field::solve(level)?;
        let mut at = vec![Point3::ORIGIN; net.vertex_count()];
        for (&v, place) in vertices.iter().zip(places) {
            if let Some(at) = at.get_mut(v as usize) {
                *at = place;
            }
        }
        cells::gather(&mut net, &mut at, &sides)?;
        let quads = cells::quads(&net, &at);
        relax::finished(&net, at, &quads, surface, &guides.rings)
    }
}

/// The area of an equilateral triangle.
fn triangle_area(side: f64) -> f64 {
    0.25 * 3.0_f64.sqrt() * side * side
}

/// The side of an equilateral triangle of an area.
fn triangle_side(area: f64) -> f64 {
    (4.0 * area / 3.0_f64.sqrt()).sqrt()
}

/// The vertices that have faces, and the graph of them that fields are smoothed on.
fn level_of(net: &Net, guides: &[(Point3, Vector3)], side: impl Fn(Point3) -> f64) -> (Vec<u32>, Level) {
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
    let sides = points.iter().map(|&p| side(p)).collect();
    let level = Level::new(Places { points, normals, areas, sides, along, held }, links);
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

    /// An ellipsoid of half axes 1, 1 and 4: the greatest curvature is 1 at its waist and 4 at its tips.
    fn spindle() -> Mesh {
        let ball = Mesh::sphere(&Plane::XY, 1.0, 96, 96).unwrap();
        let points = ball.vertices().iter().map(|p| Point3::new(p.x, p.y, 4.0 * p.z)).collect();
        Mesh::new(points, ball.faces().to_vec()).unwrap()
    }

    /// The mean side of the quads whose middles are at heights within a range.
    fn mean_side(mesh: &Mesh, heights: Interval) -> f64 {
        let areas: Vec<f64> = (0..mesh.faces().len())
            .filter_map(|i| {
                let p = mesh.face_points(i)?;
                let height = 0.25 * p.iter().map(|p| p.z.abs()).sum::<f64>();
                heights.contains(height).then(|| 0.5 * (p[2] - p[0]).cross(p[3] - p[1]).length())
            })
            .collect();
        (areas.iter().sum::<f64>() / areas.len() as f64).sqrt()
    }

    #[test]
    fn sizes_adapt_to_curvature() {
        let (waist, tip) = (Interval::new(0.0, 0.5), Interval::new(3.7, 4.0));
        let spindle = spindle();
        let made = |adaptive: f64, more: bool| {
            let options = QuadOptions { adaptive, more, ..QuadOptions::new(2000) };
            spindle.quad_remeshed(&options).unwrap()
        };
        let even = made(0.0, false);
        let usual = mean_side(&even, waist);
        let ratio = |mesh: &Mesh| mean_side(mesh, tip) / mean_side(mesh, waist);
        println!("even: {} quads, tip over waist {:.3}", even.faces().len(), ratio(&even));
        assert!((ratio(&even) - 1.0).abs() < 0.2, "{}", ratio(&even));
        let mut last = ratio(&even);
        for adaptive in [0.5, 1.0] {
            let mesh = made(adaptive, false);
            sound(&mesh, 2000, true);
            let now = ratio(&mesh);
            println!("{adaptive}: tip over waist {now:.3}, square {:.3}", squareness(&mesh));
            assert!(now < 0.85 * last, "{now} after {last}");
            assert!(squareness(&mesh) > 0.85, "{}", squareness(&mesh));
            last = now;
            let more = made(adaptive, true);
            assert!(quads_only(&more) && more.is_closed() && more.is_manifold() && more.is_oriented());
            println!(
                "more: {} quads, {:.3} and {:.3}",
                more.faces().len(),
                mean_side(&more, waist),
                ratio(&more)
            );
            assert!(more.faces().len() > 2100, "{}", more.faces().len());
            assert!(mean_side(&more, waist) < 1.1 * usual);
        }
        assert!(last < 0.55, "{last}");
        // A ball curves the same everywhere.
        let ball = Mesh::sphere(&Plane::XY, 2.0, 48, 24).unwrap();
        let options = QuadOptions { adaptive: 1.0, more: true, ..QuadOptions::new(400) };
        sound(&ball.quad_remeshed(&options).unwrap(), 400, true);
        assert!(ball.quad_remeshed(&QuadOptions { adaptive: 1.5, ..options }).is_err());
    }

    #[test]
    fn seams_stay_edges() {
        // Two halves of a sheet that meet at x = 1.3: nothing but the seam tells of it.
        let half = |x: Interval, n: usize| {
            let square = Rectangle { plane: Plane::XY, x, y: Interval::new(0.0, 2.0) };
            Mesh::plane(&square, n, 5).unwrap()
        };
        let sheet =
            Mesh::join(&[half(Interval::new(0.0, 1.3), 4), half(Interval::new(1.3, 3.0), 5)]).unwrap();
        let along = |mesh: &Mesh| {
            let on = |p: Point3| (p.x - 1.3).abs() < 1e-9;
            let lines = mesh.edges().iter().filter_map(|e| mesh.edge_line(e)).collect::<Vec<_>>();
            lines.iter().filter(|l| on(l.from) && on(l.to)).map(|l| l.length()).sum::<f64>()
        };
        let seams = sheet.seams(None);
        let kept = sheet.quad_remeshed(&QuadOptions { seams, ..QuadOptions::new(150) }).unwrap();
        sound(&kept, 150, false);
        assert!((along(&kept) - 2.0).abs() < 1e-9, "{}", along(&kept));
        assert!((kept.area() - 6.0).abs() < 1e-9);
        let free = sheet.quad_remeshed(&QuadOptions::new(150)).unwrap();
        assert!(along(&free) < 1.0);
    }

    /// How much of a curve, given by points on it, lies within a distance of an edge of a mesh that runs along it, and
    /// how much crosses a quad by its middle third with edges at 70 to 110 degrees to both sides.
    fn along_and_across(mesh: &Mesh, course: &[Point3], within: f64) -> [f64; 2] {
        let edges: Vec<Line> = mesh.edges().iter().filter_map(|e| mesh.edge_line(e)).collect();
        let quads: Vec<Vec<Point3>> = (0..mesh.faces().len()).filter_map(|i| mesh.face_points(i)).collect();
        let (mut on, mut through) = (0.0, 0.0);
        for w in course.windows(2) {
            let (p, along) = (w[0].lerp(w[1], 0.5), w[1] - w[0]);
            let angle = |d: Vector3| d.angle_to(along).map_or(90.0, f64::to_degrees);
            on += f64::from(u8::from(edges.iter().any(|l| {
                let near = l.at(l.closest_parameter(p).clamp(0.0, 1.0)).distance_to(p) < within;
                near && angle(l.direction()).min(180.0 - angle(l.direction())) < 15.0
            })));
            through += f64::from(u8::from(quads.iter().any(|q| {
                (0..2).any(|k| {
                    // Two sides across the curve, and the places where it would cross them.
                    let [a, b] = [Line::new(q[k], q[k + 1]), Line::new(q[(k + 3) % 4], q[k + 2])];
                    let ends = [a, b].map(|l| l.at(l.closest_parameter(p)));
                    let s = [a, b].map(|l| l.closest_parameter(p));
                    let strip = Line::new(ends[0], ends[1]);
                    let t = strip.closest_parameter(p);
                    let square = [a, b].iter().all(|l| (angle(l.direction()) - 90.0).abs() < 20.0);
                    let middle = s.iter().all(|s| (1.0 / 3.0..=2.0 / 3.0).contains(s));
                    square && middle && (0.0..=1.0).contains(&t) && strip.at(t).distance_to(p) < 0.05
                })
            })));
        }
        [on, through].map(|n| n / (course.len() - 1) as f64)
    }

    /// A plane with a slanted wave, and a ball with a tilted circle.
    fn guided_cases() -> [(Mesh, usize, Vec<Point3>); 2] {
        let square = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 3.0), y: Interval::new(0.0, 2.0) };
        let sheet = Mesh::plane(&square, 5, 5).unwrap();
        let wave = (0..=200).map(|k| {
            let t = f64::from(k) / 200.0;
            Point3::new(0.3 + 2.4 * t, 0.5 + 0.9 * t + 0.15 * (5.0 * t).sin(), 0.0)
        });
        let ball = Mesh::sphere(&Plane::XY, 1.0, 64, 32).unwrap();
        let ring = (0..=300).map(|k| {
            let t = f64::from(k % 300) / 300.0 * std::f64::consts::TAU;
            let (x, y, z) = (0.9 * t.cos(), 0.9 * t.sin(), 0.19_f64.sqrt());
            Point3::new(x, 0.8 * y - 0.6 * z, 0.6 * y + 0.8 * z)
        });
        [(sheet, 400, wave.collect()), (ball, 800, ring.collect())]
    }

    #[test]
    fn loops_lie_on_curves_and_rings_cross_them() {
        for (mesh, count, course) in guided_cases() {
            let made = |loops: Vec<(GuideKind, Vec<Point3>)>| {
                let options = QuadOptions { loops, ..QuadOptions::new(count) };
                let made = mesh.quad_remeshed(&options).unwrap();
                sound(&made, count, mesh.is_closed());
                (along_and_across(&made, &course, 5e-3), squareness(&made))
            };
            let (free, square) = made(Vec::new());
            println!("free {free:.3?} square {square:.3}");
            let (on, square) = made(vec![(GuideKind::Loop, course.clone())]);
            println!("loop {on:.3?} square {square:.3}");
            let (across, square2) = made(vec![(GuideKind::Ring, course.clone())]);
            println!("ring {across:.3?} square {square2:.3}");
            assert!(free[0] < 0.5 && free[1] < 0.5, "{free:?}");
            assert!(on[0] > 0.9 && square > 0.85, "{on:?} {square}");
            assert!(across[1] > 0.8 && across[0] < 0.1 && square2 > 0.85, "{across:?} {square2}");
        }
    }

    #[test]
    fn curves_far_away_lead_nothing() {
        let (mesh, count, course) = guided_cases().into_iter().next().unwrap();
        let options = QuadOptions::new(count);
        let far: Vec<Point3> = course.iter().map(|p| *p + Vector3::Z * 5.0).collect();
        let loops = vec![(GuideKind::Loop, far), (GuideKind::Ring, vec![Point3::ORIGIN; 3])];
        assert_eq!(
            mesh.quad_remeshed(&QuadOptions { loops, ..options.clone() }),
            mesh.quad_remeshed(&options)
        );
        let loops = vec![(GuideKind::Loop, vec![Point3::new(f64::NAN, 0.0, 0.0)])];
        assert!(mesh.quad_remeshed(&QuadOptions { loops, ..options }).is_err());
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
        let none = crate::CancellationToken::new(|| false);
        assert_eq!(none.during(|| sphere.quad_remeshed(&options)), Err(Error::Stopped));
        let few = sphere.quad_remeshed(&QuadOptions::new(1)).unwrap();
        assert!(few.is_closed() && quads_only(&few));
    }
}
