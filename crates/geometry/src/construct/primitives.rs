//! Boxes, spheres, cylinders, cones and tori.

use crate::construct::thresholds::ROUND_TOLERANCE;
use crate::thresholds;
use std::f64::consts::{FRAC_PI_2, TAU};

use katydid_elementary::Elementary;

use crate::brep::{Along, Builder, LoopKind, Path};
use crate::{
    Box3, Brep, Circle, Cone, Curve, Cylinder, Error, Interval, Line, LineCurve, NurbsSurface, Plane,
    PlaneSurface, Point3, Result, Sphere, Surface, Tolerance, Torus, Vector3,
};

/// The corners of the faces of a box, seen from outside: y-min, x-max, y-max, x-min, bottom, top.
const FACES: [[usize; 4]; 6] =
    [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [0, 3, 2, 1], [4, 5, 6, 7]];
/// The corners at the ends of the edges of a box: bottom, top, uprights.
const EDGES: [[usize; 2]; 12] =
    [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];

/// The solid of a box, its vertices, edges and faces in the order of openNURBS: corners around the bottom, then
/// around the top; edges of the bottom, of the top, uprights; faces y-min, x-max, y-max, x-min, bottom, top. Each
/// face is a plane over 0…its lengths.
///
/// # Errors
/// The box is not finite, or flat.
pub fn box_brep(shape: &Box3) -> Result<Brep> {
    let corners = shape.corners();
    if !corners.iter().all(|p| p.is_finite()) {
        return Err(Error::NotFinite("box"));
    }
    if let Some(flat) = shape.flat_side() {
        let sheet = PlaneSurface::new(flat.plane, flat.x.ordered(), flat.y.ordered())?;
        return Brep::from_surface(sheet.into());
    }
    let sizes =
        [corners[1] - corners[0], corners[3] - corners[0], corners[4] - corners[0]].map(Vector3::length);
    let largest = sizes.iter().fold(0.0_f64, |m, s| m.max(*s));
    if !sizes.iter().all(|s| *s > thresholds::ROUNDING * largest) {
        return Err(Error::degenerate("box", "it has no area"));
    }
    let mut builder = Builder::new();
    let vertices = corners.map(|p| builder.vertex(p));
    let edges = EDGES.map(|[a, b]| {
        let line = LineCurve::new(Line::new(corners[a], corners[b]));
        builder.edge(line.into(), [vertices[a], vertices[b]])
    });
    for face in FACES {
        let [a, b, _, d] = face.map(|k| corners[k]);
        let plane = Plane::from_axes(a, b - a, d - a)?;
        let (x, y) = (a.distance_to(b), a.distance_to(d));
        let surface = PlaneSurface::new(plane, Interval::new(0.0, x), Interval::new(0.0, y))?;
        let flat = [(0.0, 0.0), (x, 0.0), (x, y), (0.0, y)].map(|(u, v)| Point3::new(u, v, 0.0));
        let mut paths = Vec::with_capacity(4);
        for k in 0..4 {
            let ends = [face[k], face[(k + 1) % 4]];
            let place = EDGES.iter().position(|e| *e == ends || *e == [ends[1], ends[0]]);
            let Some((place, edge)) = place.and_then(|p| Some((p, *edges.get(p)?))) else { continue };
            let curve: Curve = LineCurve::new(Line::new(flat[k], flat[(k + 1) % 4])).into();
            paths.push(Path { curve, along: Along::Edge(edge, EDGES[place] != ends) });
        }
        let face = builder.face(surface.into(), false);
        builder.bound(face, LoopKind::Outer, paths)?;
    }
    builder.finish(
        thresholds::SAME_POINT * largest.max(1.0) + f64::EPSILON * corners[0].to_vector().length() * 64.0,
    )
}

/// The solid of a sphere: one face with a seam and two singular sides. Its parameters are lengths: u 0…2πr, v
/// −πr/2…πr/2, as in Rhino.
///
/// # Errors
/// The radius is out of range.
pub fn sphere(shape: &Sphere) -> Result<Brep> {
    let (r, whole) = (shape.radius, Surface::from(*shape));
    let whole = whole.with_domain(crate::Direction::U, Interval::new(0.0, TAU * r))?;
    let half = FRAC_PI_2 * r;
    Brep::from_surface(whole.with_domain(crate::Direction::V, Interval::new(-half, half))?)
}

/// The sphere as six four-sided surfaces, rational of degree 4, that meet like the sides of a cube, in the order of
/// the faces of a box.
///
/// After J. Cobb, *Tiling the sphere with rational Bézier patches* (1988); control points derived.
///
/// # Errors
/// The radius is out of range.
pub fn quad_sphere(shape: &Sphere) -> Result<Brep> {
    let patch = side_of_sphere()?;
    let unit = Plane::XY;
    let p = &shape.plane;
    let mut faces = Vec::with_capacity(6);
    for [x, y] in [
        [Vector3::X, Vector3::Z],
        [Vector3::Y, Vector3::Z],
        [-Vector3::X, Vector3::Z],
        [-Vector3::Y, Vector3::Z],
        [Vector3::Y, Vector3::X],
        [Vector3::X, Vector3::Y],
    ] {
        let world = |v: Vector3| p.x_axis * v.x + p.y_axis * v.y + p.z_axis * v.z;
        let side = Plane::from_axes(p.origin, world(x), world(y))?;
        let turned = patch.transformed(&crate::Xform::scale(Point3::ORIGIN, shape.radius))?;
        let placed = turned.transformed(&crate::Xform::plane_to_plane(&unit, &side))?;
        faces.push(Brep::from_surface(placed.into())?);
    }
    Brep::joined_into_one(
        &faces,
        &Tolerance { absolute: ROUND_TOLERANCE * shape.radius, ..Tolerance::default() },
    )
}

/// The side around +z of the unit sphere tiled by six equal patches.
///
/// Under stereographic projection from the south pole its great circles become circles about (0, −1) and the like
/// of radius √2, 15° to both sides of the middle. A rational biquadratic patch of the plane with these arcs as its
/// sides, lifted back, is biquartic and exact.
fn side_of_sphere() -> Result<NurbsSurface> {
    let (corner, weight) = (0.5 * (3.0_f64.sqrt() - 1.0), (std::f64::consts::PI / 12.0).cosine());
    let middle = 2.0_f64.sqrt() / weight - 1.0;
    let flat = |i: usize, j: usize| -> [f64; 3] {
        let sign = |k: usize| k as f64 - 1.0;
        match (i == 1, j == 1) {
            (true, true) => [0.0, 0.0, 1.0],
            (true, false) => [0.0, sign(j) * middle * weight, weight],
            (false, true) => [sign(i) * middle * weight, 0.0, weight],
            (false, false) => [sign(i) * corner, sign(j) * corner, 1.0],
        }
    };
    // Products in Bernstein form: coefficients by the binomials of 2 over those of 4.
    let (two, four) = ([1.0, 2.0, 1.0], [1.0, 4.0, 6.0, 4.0, 1.0]);
    let mut net = vec![[0.0; 4]; 25];
    for (a, b, c, d) in (0..81).map(|k| (k / 27, k / 9 % 3, k / 3 % 3, k % 3)) {
        let ([x, y, w], [p, q, r]) = (flat(a, b), flat(c, d));
        let share = two[a] * two[c] / four[a + c] * (two[b] * two[d] / four[b + d]);
        let squares = x * p + y * q;
        let lifted = [x * r + w * p, y * r + w * q, w * r - squares, w * r + squares];
        if let Some(point) = net.get_mut((a + c) * 5 + b + d) {
            for (sum, value) in point.iter_mut().zip(lifted) {
                *sum += share * value;
            }
        }
    }
    let knots: Vec<f64> = [0.0, 1.0].iter().flat_map(|t| [*t; 4]).collect();
    NurbsSurface::rational([4, 4], [5, 5], net, [knots.clone(), knots])
}

/// The tube of a cylinder, with the caps asked for at its bottom and top. u runs round over 0…2πr, v along the axis.
///
/// # Errors
/// Numbers out of range.
pub fn cylinder(shape: &Cylinder, caps: [bool; 2]) -> Result<Brep> {
    let whole =
        Surface::from(*shape).with_domain(crate::Direction::U, Interval::new(0.0, TAU * shape.radius))?;
    with_discs(Brep::from_surface(whole)?, caps.iter().any(|c| *c), |p| {
        let height = shape.plane.signed_distance(p);
        caps[usize::from((height - shape.height.start).abs() > (height - shape.height.end).abs())]
    })
}

/// The side of a cone, with its base when asked for.
///
/// # Errors
/// Numbers out of range.
pub fn cone(shape: &Cone, cap: bool) -> Result<Brep> {
    with_discs(Brep::from_surface(Surface::from(*shape))?, cap, |_| true)
}

/// The solid of a torus.
///
/// # Errors
/// Numbers out of range.
pub fn torus(shape: &Torus) -> Result<Brep> {
    Brep::from_surface(Surface::from(*shape))
}

/// A brep with those of its circular holes filled that `wanted` says of their starts; the discs are planes over
/// −r…r.
fn with_discs(brep: Brep, any: bool, wanted: impl Fn(Point3) -> bool) -> Result<Brep> {
    if !any {
        return Ok(brep);
    }
    let naked = brep.naked_edges();
    let mut rims = Vec::new();
    for edge in naked {
        let Some(curve) = brep.edge_as_curve(edge)? else { continue };
        if wanted(curve.start()) {
            rims.push((edge, curve));
        }
    }
    let size = brep.bounds_of_faces().map_or(1.0, |b| b.diagonal().length());
    let mut builder = Builder::from_brep(brep);
    for (place, curve) in rims {
        let Some(edge) = builder.known_edge(place) else { continue };
        // Edges run with the loop of the side, so discs run against them.
        let Curve::Arc(arc) = &curve else {
            return Err(Error::degenerate("cap", "its rim is not a circle"));
        };
        let Circle { plane, radius } = arc.arc.circle;
        let plane = plane.flipped();
        let flat = crate::brep::flatten::flattened(&curve, &plane)?.reversed();
        let range = Interval::new(-radius, radius);
        let face = builder.face(PlaneSurface::new(plane, range, range)?.into(), false);
        builder.bound(face, LoopKind::Outer, vec![Path { curve: flat, along: Along::Edge(edge, true) }])?;
    }
    builder.finish(thresholds::SAME_POINT * size)
}

/// The rectangle of a plane between two ranges of its coordinates, which are its parameters, as a brep. Ranges that
/// decrease are turned round.
///
/// # Errors
/// The plane is not finite, or a range has no length.
pub fn plane_surface(plane: &Plane, x: Interval, y: Interval) -> Result<Brep> {
    Brep::from_surface(PlaneSurface::new(*plane, x.ordered(), y.ordered())?.into())
}
