//! Meshes every brep of archives and judges the meshes: `mesh_breps FRACTION PATH…`
//!
//! FRACTION is the tolerance as a fraction of each brep's size. Said of every brep that is wrong in some way: solids
//! whose mesh is open, triangles that look backwards, places farther from the surface than the tolerance; and the sums.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "an example stops at the first thing wrong")]

use std::time::Instant;

use katydid_geometry::brep::Brep;
use katydid_geometry::{BrepMesh, Direction, MeshSettings, Point3, Quadrant, Surface};

use breps_of::breps_of;

mod breps_of;

#[derive(Default, Debug)]
struct Sums {
    breps: usize,
    faces: usize,
    solids: usize,
    failed: usize,
    open: usize,
    backwards: usize,
    far: usize,
    triangles: usize,
    seconds: f64,
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let fraction: f64 = arguments[0].parse().unwrap();
    let only = std::env::var("ONLY").ok();
    let mut sums = Sums::default();
    for (name, brep) in breps_of(&arguments[1..]) {
        if only.as_ref().is_none_or(|place| name.split(' ').nth(1) == Some(place)) {
            judge(&name, &brep, fraction, &mut sums);
        }
    }
    println!("{sums:?}");
}

fn judge(name: &str, brep: &Brep, fraction: f64, sums: &mut Sums) {
    let Some(bounds) = brep.bounds_of_faces() else { return };
    let tolerance = fraction * bounds.diagonal().length();
    sums.breps += 1;
    let start = Instant::now();
    let mesh = match brep.mesh(&MeshSettings::within(tolerance)) {
        Ok(mesh) => mesh,
        Err(why) => {
            println!("{name}: {why}; {} faults", brep.faults().len());
            sums.failed += 1;
            return;
        }
    };
    let took = start.elapsed().as_secs_f64();
    sums.seconds += took;
    sums.faces += mesh.faces().len();
    sums.triangles += mesh.triangle_count();
    let mut said = Vec::new();
    if took > 1.0 {
        said.push(format!(
            "{took:.1} s for {} triangles, {} faces",
            mesh.triangle_count(),
            mesh.faces().len()
        ));
    }
    if brep.is_solid() {
        sums.solids += 1;
        let one = mesh.welded().unwrap();
        if !(one.is_closed() && one.is_oriented()) {
            sums.open += 1;
            let naked = one.edges().iter().filter(|e| e.faces == 1).count();
            let many = one.edges().iter().filter(|e| e.faces > 2).count();
            said.push(format!("open: {naked} naked, {many} crowded; oriented {}", one.is_oriented()));
        }
    }
    let (backwards, worst) = looked_at(brep, &mesh, tolerance);
    if !backwards.is_empty() {
        sums.backwards += 1;
        said.push(format!("backwards {} {:?}", backwards.len(), &backwards[..backwards.len().min(3)]));
    }
    if worst.0 > tolerance * 1.000_001 {
        sums.far += 1;
        let edges = brep.edges().iter().map(|e| e.tolerance).fold(0.0, f64::max);
        said.push(format!(
            "{:.3} of the tolerance in face {} at {:?} edges {:.3}",
            worst.0 / tolerance,
            worst.1,
            worst.2,
            edges / tolerance
        ));
    }
    if !said.is_empty() {
        println!(
            "{name} ({} faces, {} triangles, {} faults): {}",
            mesh.faces().len(),
            mesh.triangle_count(),
            brep.faults().len(),
            said.join("; ")
        );
    }
}

/// The triangles that look away from the normal, as (face, height, area), and the greatest distance from a surface.
fn looked_at(brep: &Brep, mesh: &BrepMesh, tolerance: f64) -> (Vec<(usize, f64)>, (f64, usize, Point3)) {
    let mut backwards = Vec::new();
    let mut worst = (0.0, 0, Point3::ORIGIN);
    let total: usize = mesh.triangle_count();
    let every = (total / 20_000).max(1);
    let steps = 10;
    for face in mesh.faces() {
        let surface = brep.face_surface(face.face).unwrap();
        let turned = brep.faces()[face.face].reversed;
        for (k, corners) in face.faces.iter().flat_map(|f| f.triangles()).enumerate() {
            let uv = corners.map(|v| face.parameters[v as usize]);
            let [a, b, c] = corners.map(|v| mesh.points()[face.places[v as usize] as usize]);
            let normal = (b - a).cross(c - a);
            let long = (b - a).length().max((c - a).length()).max((c - b).length());
            let height = normal.length() / long;
            let mean = |x: [f64; 3]| (x[0] + x[1] + x[2]) / 3.0;
            if let Some(n) = surface.normal_at(mean(uv.map(|p| p.x)), mean(uv.map(|p| p.y))) {
                let n = if turned { -n } else { n };
                if normal.dot(n) < 0.0 && height > 1e-9 * long {
                    backwards.push((face.face, height));
                }
            }
            if k % every != 0 {
                continue;
            }
            for i in 0..=steps {
                for j in 0..=steps - i {
                    let w = [i as f64, j as f64, (steps - i - j) as f64].map(|x| x / steps as f64);
                    let at = |p: [f64; 3]| p[0] * w[0] + p[1] * w[1] + p[2] * w[2];
                    let p = Point3::new(at([a.x, b.x, c.x]), at([a.y, b.y, c.y]), at([a.z, b.z, c.z]));
                    let mut far = distance(surface, p, [at(uv.map(|p| p.x)), at(uv.map(|p| p.y))]);
                    // The steps may stop short where the surface has a cusp.
                    if far > tolerance {
                        far = far.min(surface.closest_point(p).map_or(far, |near| near.distance));
                    }
                    if far > worst.0 {
                        worst = (far, face.face, p);
                    }
                }
            }
        }
    }
    (backwards, worst)
}

/// The distance from the surface near parameters, by Gauss–Newton steps.
fn distance(surface: &Surface, p: Point3, start: [f64; 2]) -> f64 {
    let mut best = f64::INFINITY;
    let [mut u, mut v] = start;
    let domain = Direction::BOTH.map(|d| surface.domain(d));
    for _ in 0..8 {
        let d = surface.derivatives(u, v, 1, Quadrant::new(u >= domain[0].end, v >= domain[1].end));
        let r = p - d.point();
        let far = r.length();
        if far >= best * (1.0 - 1e-6) {
            break;
        }
        best = far;
        let (a, b) = (d.get(1, 0), d.get(0, 1));
        let (e, f, g) = (a.dot(a), a.dot(b), b.dot(b));
        let det = e * g - f * f;
        if det.is_nan() || det <= 1e-12 * e * g {
            break;
        }
        // On a side of the domain what is nearest along the side is another place than the step's end drawn back to it.
        let steps = [
            [(g * r.dot(a) - f * r.dot(b)) / det, (e * r.dot(b) - f * r.dot(a)) / det],
            [r.dot(a) / e, 0.0],
            [0.0, r.dot(b) / g],
        ];
        let ends = steps.map(|[x, y]| [domain[0].clamp(u + x), domain[1].clamp(v + y)]);
        let far = |[u, v]: [f64; 2]| surface.point_at(u, v).distance_to(p);
        [u, v] = ends.into_iter().min_by(|a, b| far(*a).total_cmp(&far(*b))).unwrap_or([u, v]);
    }
    best
}
