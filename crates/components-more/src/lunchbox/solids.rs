//! LunchBox Math: the Platonic solids, whole and with their corners cut off.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_elementary::Elementary;
use katydid_geometry::{Brep, Curve, Plane, Point3, PolylineCurve, Vector3};

/// The golden section.
const PHI: f64 = 1.618_033_988_749_895;

/// In solids of radius 1: heights above a face that differ less are equal.
const SAME: f64 = 1e-9;

/// A regular solid about the origin. Its corners lie in the directions of the faces of its dual.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Solid {
    Tetrahedron,
    Cube,
    Octahedron,
    Dodecahedron,
    Icosahedron,
}

/// A place with all signs of its numbers that are not 0.
fn signs([x, y, z]: [f64; 3]) -> Vec<Vector3> {
    let both = |x: f64| if x == 0.0 { vec![0.0] } else { vec![x, -x] };
    let mut out = Vec::with_capacity(8);
    for x in both(x) {
        for y in both(y) {
            out.extend(both(z).into_iter().map(|z| Vector3::new(x, y, z)));
        }
    }
    out
}

/// The same with its numbers in turn at x, y and z.
fn turns([x, y, z]: [f64; 3]) -> Vec<Vector3> {
    [[x, y, z], [z, x, y], [y, z, x]].into_iter().flat_map(signs).collect()
}

impl Solid {
    /// The directions of the corners.
    fn corners(self) -> Vec<Vector3> {
        match self {
            Self::Tetrahedron => signs([1.0; 3]).into_iter().filter(|v| v.x * v.y * v.z > 0.0).collect(),
            Self::Cube => signs([1.0; 3]),
            Self::Octahedron => turns([1.0, 0.0, 0.0]),
            Self::Dodecahedron => [signs([1.0; 3]), turns([0.0, PHI, 1.0 / PHI])].concat(),
            Self::Icosahedron => turns([0.0, 1.0, PHI]),
        }
    }

    /// The directions of the faces.
    fn faces(self) -> Vec<Vector3> {
        match self {
            Self::Tetrahedron => self.corners().into_iter().map(|v| -v).collect(),
            Self::Cube => Self::Octahedron.corners(),
            Self::Octahedron => Self::Cube.corners(),
            Self::Dodecahedron => Self::Icosahedron.corners(),
            Self::Icosahedron => Self::Dodecahedron.corners(),
        }
    }

    /// The faces as rings of corners, counter-clockwise from outside, of the solid with corners at distance 1. A part of half
    /// of each edge is cut off at both ends.
    pub(crate) fn rings(self, cut: f64) -> Vec<Vec<Vector3>> {
        let unit = |v: Vector3| v.unitized().unwrap_or(Vector3::ZERO);
        let corners: Vec<Vector3> = self.corners().into_iter().map(unit).collect();
        let points = cut_corners(&corners, cut);
        let mut directions = self.faces();
        if cut > 0.0 {
            directions.extend(&corners);
        }
        directions.into_iter().map(|direction| ring(&points, unit(direction))).collect()
    }
}

/// The corners, or two points on each edge where something is cut off; one where they meet in the middle.
fn cut_corners(corners: &[Vector3], cut: f64) -> Vec<Vector3> {
    if cut == 0.0 {
        return corners.to_vec();
    }
    let distances = |v: Vector3| corners.iter().map(move |w| (*w - v).length()).filter(|d| *d > SAME);
    let edge = corners.iter().flat_map(|v| distances(*v)).fold(f64::INFINITY, f64::min);
    let mut points: Vec<Vector3> = Vec::new();
    for v in corners {
        for w in corners.iter().filter(|w| ((**w - *v).length() - edge).abs() < SAME) {
            let point = *v + (*w - *v) * (0.5 * cut);
            if points.iter().all(|known| (*known - point).length() > SAME) {
                points.push(point);
            }
        }
    }
    points
}

/// The points farthest in a direction, in order round it.
fn ring(points: &[Vector3], direction: Vector3) -> Vec<Vector3> {
    let height = points.iter().map(|p| p.dot(direction)).fold(f64::NEG_INFINITY, f64::max);
    let mut ring: Vec<Vector3> =
        points.iter().copied().filter(|p| p.dot(direction) > height - SAME).collect();
    let Some(first) = ring.first().copied() else { return ring };
    let across = direction.cross(first);
    let middle = direction * height;
    let along = first - middle;
    let angle = |p: &Vector3| {
        let (x, y) = ((*p - middle).dot(along), (*p - middle).dot(across));
        // From just below 0, so that the first point stays the first.
        let angle = y.arctangent_of(x);
        if angle < -SAME { angle + std::f64::consts::TAU } else { angle }
    };
    ring.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    ring
}

/// A solid in a plane's axes.
fn solid(
    context: &Context<'_>,
    kind: Solid,
    plane: &Plane,
    radius: f64,
    cut: f64,
) -> Result<Shared<Brep>, Message> {
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(Message::error(format!("The radius is {radius}: it must be greater than 0")));
    }
    if !(0.0..=1.0).contains(&cut) {
        return Err(Message::error(format!("The truncation is {cut}: it must be from 0 to 1")));
    }
    let tolerance = context.tolerance();
    let small = || Message::error("An edge of the solid is shorter than the tolerance of the document");
    let at = |v: &Vector3| -> Point3 { plane.at(radius * v.x, radius * v.y, radius * v.z) };
    let closed = |ring: Vec<Vector3>| -> Vec<Point3> { ring.iter().chain(ring.first()).map(at).collect() };
    let outlines: Vec<Vec<Point3>> =
        kind.rings(if cut < SAME { 0.0 } else { cut }).into_iter().map(closed).collect();
    // Far from the origin numbers lie farther apart than the tolerance, and corners fall together.
    let is_fine = |p: &Point3| [p.x, p.y, p.z].iter().all(|x| x.abs() * f64::EPSILON < tolerance.absolute);
    if !outlines.iter().flatten().all(is_fine) {
        return Err(Message::error(
            "The solid lies too far from the origin for the tolerance of the document",
        ));
    }
    let is_long = |(a, b): (&Point3, &Point3)| a.distance_to(*b) > tolerance.absolute;
    if !outlines.iter().all(|points| points.iter().zip(points.iter().skip(1)).all(is_long)) {
        return Err(small());
    }
    let mut faces = Vec::with_capacity(outlines.len());
    for points in outlines {
        let outline = Curve::Polyline(PolylineCurve::new(points).map_err(|_| small())?);
        faces.extend(Brep::planar_faces(&[outline], &tolerance)?.breps);
    }
    let joined = Brep::join(&faces, &tolerance)?.breps;
    match <[Brep; 1]>::try_from(joined) {
        Ok([made]) if made.is_solid() => Ok(Shared::new(made)),
        _ => Err(small()),
    }
}

/// A component for a solid whose corners can be cut off.
macro_rules! platonic {
    ($(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal, $kind:expr) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "LunchBox/Math")]
        #[output("Platonic Solid", "Plato", "The solid.", kind = Brep)]
        fn $function(
            context: &Context<'_>,
            /// The plane: its origin is the middle of the solid, its axes turn it.
            #[port("Plane", "Pln", default = Plane::XY)]
            plane: Plane,
            /// The distance of the corners from the middle before anything is cut off, greater than 0.
            #[port("Radius", "Rad", default = 1.0)]
            radius: f64,
            /// How much is cut off at the corners, from 0, nothing, to 1, where cuts meet in the middles of the edges.
            #[port("Truncation", "Trunc", default = 0.0)]
            truncation: f64,
        ) -> Result<Shared<Brep>, Message> {
            solid(context, $kind, &plane, radius, truncation)
        }
    };
}

platonic!(
    /// A cube, whose corners can be cut off. Stands for LunchBox's Platonic Cube; that the truncation is the part of half of an
    /// edge is our reading.
    cube, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c41", "Platonic Cube", "PlatoCube", Solid::Cube
);
platonic!(
    /// A regular icosahedron, of 20 triangles, whose corners can be cut off: with a third of each edge at both ends, that is a
    /// truncation of 2/3, it is the football. Stands for LunchBox's Platonic Icosahedron; that the truncation is the part of half
    /// of an edge is our reading.
    icosahedron, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c42", "Platonic Icosahedron", "PlatoIcosa", Solid::Icosahedron
);
platonic!(
    /// A regular octahedron, of 8 triangles, whose corners can be cut off. Stands for LunchBox's Platonic Octahedron; that the
    /// truncation is the part of half of an edge is our reading.
    octahedron, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c43", "Platonic Octahedron", "PlatoOcta", Solid::Octahedron
);
platonic!(
    /// A regular tetrahedron, of 4 triangles, whose corners can be cut off. Stands for LunchBox's Platonic Tetrahedron; that the
    /// truncation is the part of half of an edge is our reading.
    tetrahedron, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c44", "Platonic Tetrahedron", "PlatoTetra", Solid::Tetrahedron
);

/// A regular dodecahedron, of 12 pentagons. Stands for LunchBox's Platonic Dodecahedron.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c45",
    name = "Platonic Dodecahedron",
    nick = "PlatoDodec",
    at = "LunchBox/Math"
)]
#[output("Platonic Solid", "Plato", "The solid.", kind = Brep)]
fn dodecahedron(
    context: &Context<'_>,
    /// The plane: its origin is the middle of the solid, its axes turn it.
    #[port("Plane", "Pln", default = Plane::XY)]
    plane: Plane,
    /// The distance of the corners from the middle, greater than 0.
    #[port("Radius", "Rad", default = 1.0)]
    radius: f64,
) -> Result<Shared<Brep>, Message> {
    solid(context, Solid::Dodecahedron, &plane, radius, 0.0)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Plane, Point3};

    use super::{PHI, Solid, Vector3};

    /// The solids with the numbers of corners, edges and faces, and the edge and the volume for radius 1 (closed forms: H.
    /// Coxeter, *Regular Polytopes*, table I).
    fn solids() -> [(&'static str, Solid, [usize; 3], f64, f64); 5] {
        let root = f64::sqrt;
        let tetra = root(8.0 / 3.0);
        let cube = 2.0 / root(3.0);
        let octa = root(2.0);
        let icosa = 4.0 / root(10.0 + 2.0 * root(5.0));
        let dodeca = 2.0 / (root(3.0) * PHI);
        let volume = |edge: f64, factor: f64| factor * edge * edge * edge;
        [
            ("Tetrahedron", Solid::Tetrahedron, [4, 6, 4], tetra, volume(tetra, root(2.0) / 12.0)),
            ("Cube", Solid::Cube, [8, 12, 6], cube, volume(cube, 1.0)),
            ("Octahedron", Solid::Octahedron, [6, 12, 8], octa, volume(octa, root(2.0) / 3.0)),
            (
                "Icosahedron",
                Solid::Icosahedron,
                [12, 30, 20],
                icosa,
                volume(icosa, 5.0 * (3.0 + root(5.0)) / 12.0),
            ),
            (
                "Dodecahedron",
                Solid::Dodecahedron,
                [20, 30, 12],
                dodeca,
                volume(dodeca, (15.0 + 7.0 * root(5.0)) / 4.0),
            ),
        ]
    }

    fn made(trial: Trial) -> std::sync::Arc<katydid_geometry::Brep> {
        match trial.run().outputs[0].column().get(0) {
            Some(Value::Brep(brep)) => brep,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn five_regular_solids() {
        let plane = Plane::XY.with_origin(Point3::new(3.0, -1.0, 2.0)).rotated(0.4);
        for (name, _, counts, edge, volume) in solids() {
            let brep = made(Trial::of(&format!("Platonic {name}")).item(plane).item(2.0));
            assert!(brep.is_valid() && brep.is_solid(), "{name}");
            let found = [brep.vertices().len(), brep.edges().len(), brep.faces().len()];
            assert_eq!(found, counts, "{name}");
            for vertex in brep.vertices() {
                assert!((vertex.point.distance_to(plane.origin) - 2.0).abs() < 1e-9, "{name}");
            }
            for k in 0..brep.edges().len() {
                let curve = brep.edge_as_curve(k).unwrap().unwrap();
                let length = curve.start().distance_to(curve.end());
                assert!((length - 2.0 * edge).abs() < 1e-9, "{name}: {length}");
            }
            let found = brep.volume_properties(1e-9, || true).unwrap().amount;
            assert!((found - 8.0 * volume).abs() < 1e-6, "{name}: {found} {volume}");
        }
    }

    #[test]
    fn cut_solids_have_the_faces_of_both() {
        for (name, kind, [corners, edges, faces], ..) in solids() {
            for (cut, count) in [(0.5, 2 * edges), (1.0, edges)] {
                let rings = kind.rings(cut);
                assert_eq!(rings.len(), faces + corners, "{name}");
                // Each point lies in three faces, at the middles of edges in four.
                let total: usize = rings.iter().map(Vec::len).sum();
                assert_eq!(total, count * if cut < 1.0 { 3 } else { 4 }, "{name}");
                // Euler: a solid without holes.
                assert_eq!(count + rings.len(), total / 2 + 2, "{name}");
                for ring in &rings {
                    let middle = ring.iter().fold(Vector3::ZERO, |sum, p| sum + *p);
                    let normal = (ring[1] - ring[0]).cross(ring[2] - ring[1]);
                    assert!(normal.dot(middle) > 0.0, "{name} is inside out");
                }
            }
        }
        // The football: 12 pentagons and 20 hexagons with equal edges.
        let football = made(Trial::of("Platonic Icosahedron").default().default().item(2.0 / 3.0));
        assert!(football.is_solid());
        assert_eq!([football.vertices().len(), football.edges().len(), football.faces().len()], [60, 90, 32]);
    }

    #[test]
    fn refused() {
        let of =
            |radius: f64, cut: f64| Trial::of("Platonic Cube").default().item(radius).item(cut).message();
        assert!(of(0.0, 0.0).contains("greater than 0"));
        assert!(of(f64::NAN, 0.0).contains("greater than 0"));
        assert!(of(1.0, 1.5).contains("from 0 to 1"));
        assert!(of(1.0, f64::NAN).contains("from 0 to 1"));
        assert!(of(1e-7, 0.0).contains("shorter than the tolerance"));
        let far = Plane::XY.with_origin(Point3::new(f64::MAX, 0.0, 0.0));
        assert!(Trial::of("Platonic Octahedron").item(far).message().contains("too far from the origin"));
    }
}
