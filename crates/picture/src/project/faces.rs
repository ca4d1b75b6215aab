//! Lit faces: meshes, surfaces, tiles.

use katydid_data::Colour;
use katydid_elementary::Elementary;
use katydid_geometry::{Mesh, Point3, Vector3};

use super::{BEFORE, Canvas};
use crate::clip;
use crate::drawing::{Corner, Face, blend, channel, opaque};
use katydid_scene::{Facets, Look};

/// The light that reaches what the lamp does not.
const AMBIENT: f64 = 0.42;
/// The same for faces whose colours mean something: they must be found again in the legend.
const AMBIENT_FALSE_COLOUR: f64 = 0.8;
/// Edges of a mesh are drawn while they are longer than this on average, in pixels.
const SHORTEST_EDGES: f64 = 5.0;
/// The same for faces that let light through: several behind one another must not grow black.
const AMBIENT_CLEAR: f64 = 0.62;
/// Facets of a surface stray from it by this part of a pixel at most.
const SMOOTH: f64 = 0.3;
/// Corners of clear faces nearer to each other than this, in pixels, are in one place.
const SAME: f64 = 0.02;
/// A quad whose corners are no farther from a plane than this, in pixels of depth, is drawn as one face.
const FLAT: f64 = 0.5;

impl Canvas {
    pub(super) fn mesh(&mut self, mesh: &Mesh, look: &Look) {
        self.shaded(mesh, mesh.normals(), look);
        let edges = mesh.edges();
        let on_picture = |line: &katydid_geometry::Line| {
            let (a, b) = (self.camera.project(line.from)?, self.camera.project(line.to)?);
            Some((a[0] - b[0]).hypotenuse(a[1] - b[1]))
        };
        let lines = || edges.iter().filter_map(|edge| Some((edge, mesh.edge_line(edge)?)));
        let total: f64 = lines().filter_map(|(_, line)| on_picture(&line)).sum();
        let all = total >= SHORTEST_EDGES * edges.len() as f64;
        let colour = blend(opaque(look.fill), Colour::rgb(0, 0, 0), 0.45);
        let colour = if mesh.colours().is_empty() { colour } else { Colour::rgb(70, 70, 74) };
        let drawn: Vec<_> = lines()
            .filter(|(edge, _)| all || edge.faces != 2)
            .map(|(edge, line)| (line, if edge.faces == 2 { 0.5 } else { 1.0 }))
            .collect();
        for (line, width) in drawn {
            self.line(&[line.from, line.to], colour, width, BEFORE);
        }
    }

    pub(super) fn surface(&mut self, facets: &Facets, look: &Look) {
        let units = facets.mesh.vertices().iter().map(|p| self.camera.unit(*p));
        let unit = units.fold(f64::INFINITY, f64::min);
        let finer = facets.within(SMOOTH * unit);
        let facets = finer.as_ref().unwrap_or(facets);
        self.shaded(&facets.mesh, facets.mesh.normals(), look);
        let dark = blend(opaque(look.fill), Colour::rgb(0, 0, 0), 0.4);
        for line in &facets.isocurves {
            self.line(line, blend(dark, opaque(look.fill), 0.35), 0.6, BEFORE);
        }
        for line in &facets.borders {
            self.line(line, dark, 1.1, BEFORE);
        }
    }

    fn shaded(&mut self, mesh: &Mesh, normals: &[Vector3], look: &Look) {
        let flat = if normals.is_empty() { mesh.face_normals() } else { Vec::new() };
        let colours = mesh.colours();
        let ambient = match (colours.is_empty(), look.fill.a) {
            (false, _) => AMBIENT_FALSE_COLOUR,
            (true, 255) => AMBIENT,
            (true, _) => AMBIENT_CLEAR,
        };
        for (k, face) in mesh.faces().iter().enumerate() {
            let corner = |&i: &u32| {
                let i = i as usize;
                let p = *mesh.vertices().get(i)?;
                let normal = normals.get(i).or_else(|| flat.get(k)).copied().unwrap_or(Vector3::Z);
                // Colours that mean something let nothing through, as they would be others.
                let own = colours.get(i).map_or(look.fill, |&[r, g, b, _]| Colour::rgb(r, g, b));
                Some((p, lit(own, normal, self.camera.towards_lamp(p), ambient)))
            };
            let corners: Option<Vec<(Point3, Colour)>> = face.indices().iter().map(corner).collect();
            if let Some(corners) = corners {
                self.face(corners, false);
            }
        }
    }

    /// A face of three corners, or of four in order; one that is not flat becomes two.
    fn face(&mut self, corners: Vec<(Point3, Colour)>, sign: bool) {
        let corners = if corners.iter().all(|(p, _)| self.camera.sees(*p)) {
            corners
        } else {
            clip::polygon(&corners, |p| self.camera.before(p), blend)
        };
        let place =
            |(p, colour): &(Point3, Colour)| Some(Corner { at: self.camera.project(*p)?, colour: *colour });
        let Some(corners) = corners.iter().map(place).collect::<Option<Vec<Corner>>>() else { return };
        if !sign && self.is_twice(&corners) {
            return;
        }
        if let [a, b, c, d] = corners[..]
            && !is_flat_and_convex([a.at, b.at, c.at, d.at])
        {
            self.solids.faces.push(Face { corners: vec![a, b, c], sign });
            self.solids.faces.push(Face { corners: vec![a, c, d], sign });
        } else if corners.len() > 2 {
            self.solids.faces.push(Face { corners, sign });
        }
    }

    /// Whether a clear face lies where one is already, as where two boxes share a side: both would look like one of
    /// half the clearness.
    fn is_twice(&mut self, corners: &[Corner]) -> bool {
        if corners.iter().all(|corner| corner.colour.a == 255) {
            return false;
        }
        let mut key: Vec<[i64; 3]> =
            corners.iter().map(|corner| corner.at.map(|x| (x / SAME).round() as i64)).collect();
        key.sort_unstable();
        !self.clear.insert(key)
    }

    pub(super) fn tile(&mut self, corners: &[Point3; 4], colours: &[Colour; 4]) {
        self.face(corners.iter().copied().zip(colours.iter().copied()).collect(), false);
    }
}

/// The colour in the light of a lamp; both sides are lit alike.
fn lit(colour: Colour, normal: Vector3, lamp: Vector3, ambient: f64) -> Colour {
    let light = ambient + (1.0 - ambient) * normal.dot(lamp).abs().min(1.0);
    let [r, g, b] = [colour.r, colour.g, colour.b].map(|x| channel(f64::from(x) * light));
    Colour { a: colour.a, r, g, b }
}

/// Whether four corners lie on a plane and turn one way.
fn is_flat_and_convex(q: [[f64; 3]; 4]) -> bool {
    let turn =
        |a: [f64; 3], b: [f64; 3], c: [f64; 3]| (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
    let turns = [0, 1, 2, 3].map(|k| turn(q[k], q[(k + 1) % 4], q[(k + 2) % 4]));
    if !(turns.iter().all(|t| *t > 0.0) || turns.iter().all(|t| *t < 0.0)) {
        return false;
    }
    // The fourth corner's depth on the plane of the others, by its place between them.
    let [a, b, c, d] = q;
    let area = turn(a, b, c);
    let (u, v) = (turn(a, d, c) / area, turn(a, b, d) / area);
    let depth = a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]);
    (depth - d[2]).abs() <= FLAT
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bent_and_dented_quads_are_told() {
        let q = |z: f64| [[0.0, 0.0, 0.0], [10.0, 0.0, 2.0], [10.0, 10.0, 5.0], [0.0, 10.0, z]];
        assert!(is_flat_and_convex(q(3.0)));
        assert!(!is_flat_and_convex(q(7.0)));
        let dented = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 10.0, 0.0]];
        assert!(!is_flat_and_convex(dented));
    }

    #[test]
    fn light_falls_from_the_front_on_both_sides() {
        let grey = Colour::argb(100, 200, 200, 200);
        assert_eq!(lit(grey, Vector3::Z, Vector3::Z, 0.5), grey);
        assert_eq!(lit(grey, -Vector3::Z, Vector3::Z, 0.5), grey);
        assert_eq!(lit(grey, Vector3::X, Vector3::Z, 0.5), Colour::argb(100, 100, 100, 100));
    }
}
