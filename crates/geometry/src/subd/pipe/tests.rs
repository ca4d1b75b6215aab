use super::{MultiPipe, MultiPipeCap, MultiPipeNetwork};
use crate::subd::{SubD, SubDNet};
use crate::{Curve, Line, Mesh, Plane, Point3, Vector3};

fn network(lines: &[[Point3; 2]]) -> MultiPipeNetwork {
    MultiPipeNetwork::of_lines(lines, 1e-3).unwrap()
}

fn point(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn closed(radius: f64) -> MultiPipe {
    MultiPipe { radii: vec![radius], caps: MultiPipeCap::Round, ..MultiPipe::default() }
}

/// Vertices less edges plus faces: 2 for each body less twice its handles.
fn characteristic(net: &SubDNet) -> i64 {
    net.vertices().len() as i64 - net.edges().len() as i64 + net.faces().len() as i64
}

/// A closed orientable surface that looks outward, with as many handles as the network has loops.
fn check_closed(lines: &MultiPipeNetwork, net: &SubDNet, bodies: i64) {
    let mesh = net.to_mesh().unwrap();
    assert!(mesh.is_closed() && mesh.is_manifold() && mesh.is_oriented());
    assert!(mesh.volume_and_centroid().0 > 0.0);
    let loops = lines.struts().len() as i64 - lines.nodes().len() as i64 + bodies;
    assert_eq!(characteristic(net), 2 * bodies - 2 * loops);
}

fn limit(net: &SubDNet) -> Mesh {
    SubD::new(net.clone()).limit_mesh(2).unwrap()
}

/// Around a line the surface's rings are closed cubic splines with four control points: at the radius where these are,
/// and at 11 √2 / 16 · 1.5 / √2 … of it between: (√2 · 22/48 · 1.5) = 0.9723 of it.
#[test]
fn a_pipe_has_its_radius() {
    let line = network(&[[point(0.0, 0.0, 0.0), point(0.0, 0.0, 10.0)]]);
    for segment in [0.0, 1.0] {
        let pipe = MultiPipe { radii: vec![2.0], segment, ..MultiPipe::default() };
        let net = pipe.around(&line).unwrap();
        assert_eq!(net.faces().len(), if segment > 0.0 { 40 } else { 4 });
        for p in limit(&net).vertices() {
            let reach = p.x.hypot(p.y);
            assert!(reach < 2.0 + 1e-9 && reach > 0.972 * 2.0, "{reach}");
            assert!(p.z > -1e-9 && p.z < 10.0 + 1e-9);
        }
    }
    let flat = MultiPipe { caps: MultiPipeCap::Flat, ..closed(1.0) }.around(&line).unwrap();
    check_closed(&line, &flat, 1);
    let bounds = limit(&flat).bounding_box().unwrap();
    assert!(bounds.min.z.abs() < 1e-9 && (bounds.max.z - 10.0).abs() < 1e-9);
    let round = closed(1.0).around(&line).unwrap();
    check_closed(&line, &round, 1);
    let bounds = limit(&round).bounding_box().unwrap();
    assert!(bounds.min.z < -0.5 && bounds.min.z > -1.0);
}

#[test]
fn frames_of_polyhedra() {
    let corner = |k: usize| point((k & 1) as f64, (k >> 1 & 1) as f64, (k >> 2 & 1) as f64);
    let far = |a: usize, b: usize| corner(a).distance_to(corner(b));
    let pairs = |wanted: f64, of: &[usize]| -> Vec<[Point3; 2]> {
        let all = of.iter().flat_map(|a| of.iter().map(move |b| [*a, *b]));
        all.filter(|[a, b]| a < b && (far(*a, *b) - wanted).abs() < 1e-9).map(|p| p.map(corner)).collect()
    };
    let cube = network(&pairs(1.0, &[0, 1, 2, 3, 4, 5, 6, 7]));
    let tetrahedron = network(&pairs(2.0_f64.sqrt(), &[0, 3, 5, 6]));
    assert_eq!((cube.struts().len(), tetrahedron.struts().len()), (12, 6));
    for frame in [&cube, &tetrahedron] {
        for radius in [0.01, 0.1, 3.0] {
            for cube_fit in [0.0, 0.5, 1.0] {
                let pipe = MultiPipe { cube_fit, strut_size: 0.8, segment: 0.2, ..closed(radius) };
                check_closed(frame, &pipe.around(frame).unwrap(), 1);
            }
        }
    }
    // Of a cube of struts every node is a cube: nothing but quads.
    let quads = MultiPipe { cube_fit: 0.1, ..closed(0.1) }.around(&cube).unwrap();
    assert!((0..quads.faces().len()).all(|face| quads.corners(face).count() == 4));
    assert_eq!(quads.vertices().len(), 64);
}

#[test]
fn stars_of_struts() {
    for count in 2..14_usize {
        // Directions spread over the ball by the golden angle, and squeezed to one side of it.
        for squeeze in [1.0, 0.4] {
            let lines: Vec<[Point3; 2]> = (0..count)
                .map(|k| {
                    let z = 1.0 - squeeze * (2.0 * k as f64 + 1.0) / count as f64;
                    let angle = 2.399_963 * k as f64;
                    let r = (1.0 - z * z).max(0.0).sqrt();
                    [Point3::ORIGIN, (Vector3::new(r * angle.cos(), r * angle.sin(), z) * 5.0).to_point()]
                })
                .collect();
            let star = network(&lines);
            check_closed(&star, &closed(0.3).around(&star).unwrap(), 1);
        }
    }
}

#[test]
fn rings_close_without_tearing() {
    let circle: Curve = crate::Circle::new(Plane::XY, 5.0).unwrap().into();
    let lines = MultiPipeNetwork::lines_of(&circle, 0.6).unwrap();
    assert!(lines.len() >= 10);
    let ring = network(&lines);
    let net = closed(1.0).around(&ring).unwrap();
    check_closed(&ring, &net, 1);
    assert_eq!(net.faces().len(), 4 * lines.len());
    // A crooked closed polyline in space.
    let corners = [(0.0, 0.0, 0.0), (4.0, 0.0, 1.0), (5.0, 4.0, 0.0), (3.0, 6.0, 3.0), (-1.0, 4.0, -2.0)]
        .map(|(x, y, z)| point(x, y, z));
    let lines: Vec<_> = (0..5).map(|k| [corners[k], corners[(k + 1) % 5]]).collect();
    let crooked = network(&lines);
    check_closed(&crooked, &closed(0.3).around(&crooked).unwrap(), 1);
}

#[test]
fn radii_go_over_evenly() {
    let line: Vec<[Point3; 2]> =
        (0..4).map(|k| [point(f64::from(k), 0.0, 0.0), point(f64::from(k + 1), 0.0, 0.0)]).collect();
    let line = network(&line);
    let pipe = MultiPipe {
        radii: vec![0.1, 0.3],
        size_points: vec![point(-1.0, 0.0, 0.0), point(9.0, 0.0, 0.0)],
        ..MultiPipe::default()
    };
    let radii = line.radii(&pipe);
    for (p, radius) in line.nodes().iter().zip(radii) {
        assert!((radius - (0.1 + 0.05 * p.x)).abs() < 1e-6);
    }
}

#[test]
fn what_cannot_be_piped() {
    let line = [[Point3::ORIGIN, point(1.0, 0.0, 0.0)]];
    let made = |pipe: MultiPipe| pipe.around(&network(&line));
    assert!(made(MultiPipe::default()).is_ok());
    assert!(MultiPipe::default().around(&MultiPipeNetwork::default()).is_err());
    for radii in [vec![], vec![0.0], vec![f64::NAN], vec![1.0, 2.0]] {
        assert!(made(MultiPipe { radii, ..MultiPipe::default() }).is_err());
    }
    assert!(made(MultiPipe { segment: 1e-9, ..MultiPipe::default() }).is_err());
    assert!(made(MultiPipe { end_offset: f64::INFINITY, ..MultiPipe::default() }).is_err());
    let along = [[Point3::ORIGIN, point(1.0, 0.0, 0.0)], [Point3::ORIGIN, point(2.0, 0.0, 0.0)]];
    assert!(MultiPipe::default().around(&network(&along)).is_err());
    assert!(MultiPipeNetwork::of_lines(&[[Point3::ORIGIN, point(f64::NAN, 0.0, 0.0)]], 0.1).is_err());
    assert!(network(&[[Point3::ORIGIN, point(1e-5, 0.0, 0.0)]]).struts().is_empty());
    let smooth: Curve = Line::new(Point3::ORIGIN, point(1.0, 0.0, 0.0)).into();
    assert_eq!(MultiPipeNetwork::lines_of(&smooth, 0.6).unwrap().len(), 1);
}

/// Random networks, many of them with struts in nearly one direction, all closed and sound.
#[test]
fn random_networks() {
    let mut state = 7_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / (1_u64 << 31) as f64
    };
    let mut made = 0;
    for round in 0..60 {
        let nodes: Vec<Point3> =
            (0..4 + round % 9).map(|_| point(5.0 * next(), 5.0 * next(), 5.0 * next())).collect();
        // A path, so that it hangs together, and chords.
        let mut lines: Vec<[Point3; 2]> = nodes.windows(2).map(|w| [w[0], w[1]]).collect();
        for _ in 0..round % 12 {
            let pick = |x: f64| nodes[((x * nodes.len() as f64) as usize).min(nodes.len() - 1)];
            lines.push([pick(next()), pick(next())]);
        }
        let net = network(&lines);
        let pipe = MultiPipe { cube_fit: 0.3 * f64::from(round as u32 % 4), ..closed(0.02 + 0.5 * next()) };
        if let Ok(surface) = pipe.around(&net) {
            check_closed(&net, &surface, 1);
            made += 1;
        }
    }
    assert!(made > 55, "{made}");
}
