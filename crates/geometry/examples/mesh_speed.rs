//! Meshes the surface `tess` of a file of kernel inputs, whole and with a hole, and writes what `check.py` judges.
//!
//! `mesh_speed INPUTS OUTDIR [REPEATS]`

#![allow(clippy::unwrap_used, clippy::panic, reason = "an example stops at the first thing wrong")]

use std::collections::HashMap;
use std::io::Write;
use std::time::Instant;

use katydid_geometry::brep::{Brep, CurvePart, Edge, Face, Iso, Loop, LoopKind, Parts, Trim, TrimKind};
use katydid_geometry::{
    Curve, Interval, Line, LineCurve, MeshSettings, NurbsCurve, NurbsSurface, Point3, Side, Surface,
};

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, inputs, out, rest @ ..] = arguments.as_slice() else {
        panic!("mesh_speed INPUTS OUTDIR [REPEATS]")
    };
    let repeats = rest.first().map_or(5, |n| n.parse().unwrap());
    let (curves, surfaces) = read(&std::fs::read_to_string(inputs).unwrap());
    let surface = &surfaces["tess"];
    let whole = brep(surface, None);
    let holed = brep(surface, Some(&curves["trim_hole_uv"]));
    std::fs::create_dir_all(out).unwrap();
    for (name, brep) in [("tess", &whole), ("trim", &holed)] {
        for tolerance in [1e-3, 1e-4] {
            let settings = MeshSettings::within(tolerance);
            let mut times: Vec<f64> = Vec::new();
            let mut mesh = brep.mesh(&settings).unwrap();
            for _ in 0..repeats {
                let start = Instant::now();
                mesh = brep.mesh(&settings).unwrap();
                times.push(start.elapsed().as_secs_f64() * 1e3);
            }
            times.sort_by(f64::total_cmp);
            let one = mesh.welded().unwrap();
            println!(
                "{name} {tolerance:e}: {} triangles, median {:.1} ms of {repeats}",
                mesh.triangle_count(),
                times[times.len() / 2]
            );
            let triangles: Vec<[u32; 3]> = one.faces().iter().flat_map(|f| f.triangles()).collect();
            let mut file = Vec::new();
            file.extend((one.vertices().len() as u64).to_le_bytes());
            file.extend((triangles.len() as u64).to_le_bytes());
            for p in one.vertices() {
                for x in [p.x, p.y, p.z] {
                    file.extend(x.to_le_bytes());
                }
            }
            file.extend(triangles.iter().flatten().flat_map(|i| i.to_le_bytes()));
            let path = format!("{out}/mesh_katydid_{name}_{tolerance:e}.bin");
            std::fs::File::create(path).unwrap().write_all(&file).unwrap();
        }
    }
}

type Named<T> = HashMap<String, T>;

fn read(text: &str) -> (Named<NurbsCurve>, Named<NurbsSurface>) {
    let mut words = text.split_ascii_whitespace();
    let (mut curves, mut surfaces) = (HashMap::new(), HashMap::new());
    while let Some(tag) = words.next() {
        let name = words.next().unwrap().to_owned();
        let mut count = || words.next().unwrap().parse::<usize>().unwrap();
        match tag {
            "curve" => {
                let [p, n, _] = [count(), count(), count()];
                let knots = numbers(&mut words, n + p + 1);
                let (points, weights) = points(&mut words, n);
                curves.insert(
                    name,
                    NurbsCurve::with_weights(p, &points, &weights, knots[1..n + p].to_vec()).unwrap(),
                );
            }
            "surf" => {
                let [p, q, n, m, rational] = [count(), count(), count(), count(), count()];
                let u = numbers(&mut words, n + p + 1);
                let v = numbers(&mut words, m + q + 1);
                let (points, weights) = points(&mut words, n * m);
                let knots = [u[1..n + p].to_vec(), v[1..m + q].to_vec()];
                let surface = if rational == 1 {
                    NurbsSurface::with_weights([p, q], [n, m], &points, &weights, knots)
                } else {
                    NurbsSurface::new([p, q], [n, m], points, knots)
                };
                surfaces.insert(name, surface.unwrap());
            }
            "pts" => {
                let n = count();
                numbers(&mut words, 3 * n);
            }
            _ => {
                let n = count() * count();
                numbers(&mut words, n);
            }
        }
    }
    (curves, surfaces)
}

fn numbers<'a>(words: &mut impl Iterator<Item = &'a str>, count: usize) -> Vec<f64> {
    words.take(count).map(|w| w.parse().unwrap()).collect()
}

fn points<'a>(words: &mut impl Iterator<Item = &'a str>, count: usize) -> (Vec<Point3>, Vec<f64>) {
    let list = numbers(words, 4 * count);
    list.chunks(4).map(|c| (Point3::new(c[0], c[1], c[2]), c[3])).unzip()
}

/// The face of a surface, less what a curve in its parameter plane encloses.
fn brep(surface: &NurbsSurface, hole: Option<&NurbsCurve>) -> Brep {
    let own: Surface = surface.clone().into();
    let mut parts =
        Parts { faces: vec![Face::new(0, false)], surfaces: vec![Some(own.clone())], ..Parts::default() };
    let corner = |x: f64, y: f64| Point3::new(x, y, 0.0);
    let sides = [
        (Side::South, corner(0.0, 0.0), corner(1.0, 0.0), false),
        (Side::East, corner(1.0, 0.0), corner(1.0, 1.0), false),
        (Side::North, corner(1.0, 1.0), corner(0.0, 1.0), true),
        (Side::West, corner(0.0, 1.0), corner(0.0, 0.0), true),
    ];
    let add = |parts: &mut Parts, edge: Curve, flat: Curve, chain: usize, reversed: bool| {
        let place = parts.trims.len();
        parts.edges.push(Edge {
            part: CurvePart::whole(parts.curves_3d.len(), edge.domain()),
            vertices: [None; 2],
            trims: vec![place],
            tolerance: 0.0,
            deleted: false,
        });
        parts.curves_3d.push(Some(edge));
        parts.trims.push(Trim {
            part: CurvePart::whole(place, flat.domain()),
            edge: Some(place),
            reversed,
            vertices: [None; 2],
            kind: TrimKind::Unknown,
            iso: Iso::None,
            in_loop: Some(chain),
            tolerance: [0.0; 2],
            older_tolerances: [0.0; 2],
            deleted: false,
        });
        parts.curves_2d.push(Some(flat));
        parts.loops[chain].trims.push(place);
    };
    for (kind, chain) in [(LoopKind::Outer, 0), (LoopKind::Inner, 1)] {
        if chain == 1 && hole.is_none() {
            continue;
        }
        parts.loops.push(Loop { trims: Vec::new(), kind, face: Some(0), deleted: false });
        parts.faces[0].loops.push(chain);
        if chain == 0 {
            for (side, from, to, reversed) in sides {
                let flat = LineCurve { line: Line::new(from, to), domain: Interval::UNIT };
                add(&mut parts, own.side_curve(side).unwrap(), flat.into(), 0, reversed);
            }
        } else if let Some(hole) = hole {
            // A cubic through points of the lifted curve, near enough: the deviation is measured.
            let flat: Curve = Curve::from(hole.clone()).reversed();
            let n = 2000;
            let domain = flat.domain();
            let lifted: Vec<Point3> = (0..=n)
                .map(|k| {
                    let p = flat.point_at(domain.at(f64::from(k) / f64::from(n)));
                    surface.point_at(p.x, p.y)
                })
                .collect();
            let edge =
                NurbsCurve::interpolate(3, &lifted, katydid_geometry::KnotSpacing::Uniform, None, None);
            add(&mut parts, edge.unwrap().into(), flat, 1, false);
        }
    }
    parts.set_iso();
    parts.set_kinds();
    parts.set_vertices();
    Brep::from_parts(parts).unwrap()
}
