//! Breps under a map.

use super::Morph;
use crate::brep::parameters::ParameterMaps;
use crate::brep::{CurvePart, Parts, Solidity, with_ends};
use crate::{Brep, Curve, Direction, Interval, Point3, Result, Surface, Tolerance};

/// How far round a bent trim its face's surface reaches, as a part of the trims' extent.
const MARGIN: f64 = 0.01;
/// Parameters nearer than this part of the domain are one.
const SAME: f64 = 1e-9;
/// A map is affine along a curve whose mapped control points miss by no more than this part of its size.
const EXACT: f64 = 1e-12;

impl Brep {
    /// The image of the Brep: faces on the images of the parts of their surfaces that they use
    /// ([`Surface::morphed`]), with the same trims, and edges that are the images of its edges ([`Curve::morphed`]).
    /// Both are within half the tolerance of the exact image, and so as near to each other as edges and faces were
    /// before, and the tolerance. What is closed stays closed; a map that turns a solid inside out is set right.
    ///
    /// # Errors
    /// As the map's; the map tears an edge apart or makes a point of it.
    pub fn morphed(&self, morph: &dyn Morph, tolerance: &Tolerance) -> Result<Self> {
        let half = Tolerance { absolute: 0.5 * tolerance.positive_distance()?, ..*tolerance };
        self.carried(morph, |surface| surface.morphed(morph, &half), |curve| edge_image(curve, morph, &half))
    }

    /// The Brep with the control points of its surfaces and edges mapped, as [`Surface::with_morphed_controls`] has it.
    /// Edges lie on their faces only as far as the map takes the control points of both alike.
    ///
    /// # Errors
    /// As the map's.
    pub fn with_morphed_controls(&self, morph: &dyn Morph) -> Result<Self> {
        self.carried(
            morph,
            |surface| surface.with_morphed_controls(morph),
            |curve| curve.with_morphed_controls(morph),
        )
    }

    fn carried(
        &self,
        morph: &dyn Morph,
        surface_image: impl Fn(&Surface) -> Result<Surface>,
        curve_image: impl Fn(&Curve) -> Result<Curve>,
    ) -> Result<Self> {
        let mut parts = self.parts().clone();
        (parts.curves_2d, parts.curves_3d, parts.surfaces) = Default::default();
        parts.regions = None;
        for (place, vertex) in parts.vertices.iter_mut().enumerate() {
            if !vertex.deleted && self.vertices().get(place).is_some() {
                vertex.point = morph.image(vertex.point)?;
            }
        }
        self.carry_edges(&mut parts, curve_image)?;
        for place in 0..parts.faces.len() {
            crate::cancellation::check()?;
            self.carry_face(place, &mut parts, &surface_image)?;
        }
        parts.set_iso();
        parts.measure_tolerances();
        parts.solidity = Solidity::Unknown;
        Ok(Self::from_parts(parts)?.turned_outward())
    }

    fn carry_edges(&self, parts: &mut Parts, image: impl Fn(&Curve) -> Result<Curve>) -> Result<()> {
        for (place, edge) in parts.edges.iter_mut().enumerate().filter(|(_, edge)| !edge.deleted) {
            crate::cancellation::check()?;
            let Some(curve) = self.edge_as_curve(place)? else { continue };
            let made = image(&curve)?;
            let ends =
                edge.vertices.map(|v| v.and_then(|v| parts.vertices.get(v)).map(|vertex| vertex.point));
            let made = match (ends, self.ends_meet(place, &curve)) {
                ([Some(start), Some(end)], true) => with_ends(&made, [start, end])?,
                _ => made,
            };
            edge.part = CurvePart::whole(parts.curves_3d.len(), made.domain());
            parts.curves_3d.push(Some(made));
        }
        Ok(())
    }

    /// Whether an edge ends in its vertices but for rounding.
    fn ends_meet(&self, place: usize, curve: &Curve) -> bool {
        let Some(edge) = self.edges().get(place) else { return false };
        let near = SAME * curve.bounding_box().diagonal().length();
        edge.vertices.into_iter().zip([curve.start(), curve.end()]).all(|(vertex, end)| {
            let vertex = vertex.and_then(|v| self.vertices().get(v));
            vertex.is_some_and(|vertex| vertex.point.distance_to(end) <= near)
        })
    }

    fn carry_face(
        &self,
        place: usize,
        parts: &mut Parts,
        image: impl Fn(&Surface) -> Result<Surface>,
    ) -> Result<()> {
        let Some(face) = self.faces().get(place).filter(|face| !face.deleted) else { return Ok(()) };
        let Some(surface) = self.face_surface(place) else { return Ok(()) };
        let loops = face.loops.iter().filter_map(|l| self.loops().get(*l));
        let mut trims: Vec<(usize, Curve)> = Vec::new();
        for trim in loops.flat_map(|chain| chain.trims.iter().copied()) {
            if let Some(flat) = self.trim_as_curve(trim)? {
                trims.push((trim, flat));
            }
        }
        let used = used(surface, trims.iter().map(|(_, flat)| flat))?;
        let maps = ParameterMaps::to_nurbs(&used);
        if let Some(face) = parts.faces.get_mut(place) {
            face.surface = Some(parts.surfaces.len());
        }
        parts.surfaces.push(Some(image(&used)?));
        for (trim, flat) in trims {
            let moved = maps.moved(&flat)?;
            if let Some(trim) = parts.trims.get_mut(trim) {
                trim.part = CurvePart::whole(parts.curves_2d.len(), moved.domain());
                parts.curves_2d.push(Some(moved));
            }
        }
        Ok(())
    }
}

/// The part of a surface that trims enclose: up to straight ones along parameter lines, a little round bent ones.
fn used<'a>(surface: &Surface, trims: impl Iterator<Item = &'a Curve> + Clone) -> Result<Surface> {
    let mut out = surface.clone();
    for direction in Direction::BOTH {
        let domain = surface.domain(direction);
        let coordinate = |p: Point3| if direction == Direction::U { p.x } else { p.y };
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut straight: Vec<f64> = Vec::new();
        for trim in trims.clone() {
            let bounds = trim.bounding_box();
            low = low.min(coordinate(bounds.min));
            high = high.max(coordinate(bounds.max));
            if let Curve::Line(line) = trim
                && coordinate(line.line.from) == coordinate(line.line.to)
            {
                straight.push(coordinate(line.line.from));
            }
        }
        let near = SAME * domain.length();
        let margin = MARGIN * (high - low);
        let side = |x: f64, end: f64, outward: f64| {
            if (x - end).abs() <= near || (end - x) * outward <= 0.0 {
                end
            } else if straight.contains(&x) {
                x
            } else {
                domain.clamp(x + margin * outward)
            }
        };
        let range = Interval::new(side(low, domain.start, -1.0), side(high, domain.end, 1.0));
        if range.is_increasing() && range != domain {
            out = out.trimmed(direction, range)?;
        }
    }
    Ok(out)
}

/// The image of an edge: exact where the map is affine along it.
fn edge_image(curve: &Curve, morph: &dyn Morph, tolerance: &Tolerance) -> Result<Curve> {
    let source = Curve::from(curve.to_nurbs()?);
    let plain = source.with_morphed_controls(morph)?;
    let size = curve.bounding_box().diagonal().length();
    let pieces = source.pieces().len();
    let count = (8 * pieces).max(32);
    let mut exact = true;
    for k in 0..=count {
        let t = source.domain().at(k as f64 / count as f64);
        if !(morph.image(source.point_at(t))?.distance_to(plain.point_at(t)) <= EXACT * size) {
            exact = false;
            break;
        }
    }
    if !exact {
        return curve.morphed(morph, tolerance);
    }
    Ok(match curve {
        Curve::Line(_) | Curve::Polyline(_) => curve.with_morphed_controls(morph)?,
        _ => plain,
    })
}

#[cfg(test)]
mod tests {
    use super::super::curve::By;
    use super::super::{Bend, BoxMorph, Taper, Twist};
    use super::*;
    use crate::construct::{box_brep, cone, cylinder, sphere, torus};
    use crate::{Arc, Box3, Circle, Cone, Cylinder, Line, Plane, Sphere, Torus, TwistedBox, Vector3};

    fn cuboid(size: [f64; 3]) -> Box3 {
        let [x, y, z] = size.map(|size| Interval::new(0.0, size));
        Box3 { plane: Plane::XY, x, y, z }
    }

    fn solids() -> Vec<(&'static str, Brep)> {
        let tube = Cylinder::new(Plane::XY, 1.0, Interval::new(0.5, 3.0)).unwrap();
        vec![
            ("box", box_brep(&cuboid([2.0, 1.5, 4.0])).unwrap()),
            ("ball", sphere(&Sphere::around(Point3::new(0.3, 0.2, 1.5), 1.0).unwrap()).unwrap()),
            ("cylinder", cylinder(&tube, [true; 2]).unwrap()),
            ("cone", cone(&Cone::new(Plane::XY, 1.0, 2.0).unwrap(), true).unwrap()),
            ("torus", torus(&Torus::new(Plane::XY, 2.0, 0.5).unwrap()).unwrap()),
        ]
    }

    fn volume(solid: &Brep) -> f64 {
        solid.volume_properties(1e-9, || true).unwrap().amount
    }

    fn sound(name: &str, image: &Brep, tolerance: &Tolerance) {
        assert!(image.is_valid(), "{name}: {:?}", image.faults());
        assert!(image.is_solid(), "{name} is open");
        for edge in 0..image.edges().len() {
            let apart = image.edge_deviation(edge).unwrap();
            assert!(apart <= 2.0 * tolerance.absolute, "edge {edge} of the {name} is {apart} off");
        }
    }

    /// Upright, through the middle of nothing.
    fn axis() -> Line {
        Line::new(Point3::new(0.2, 0.1, 0.0), Point3::new(0.2, 0.1, 4.0))
    }

    #[test]
    fn a_twist_keeps_volumes() {
        let tolerance = Tolerance { absolute: 1e-4, ..Tolerance::default() };
        let twist = Twist::new(axis(), 1.5, true).unwrap();
        for (name, solid) in solids() {
            let image = solid.morphed(&twist, &tolerance).unwrap();
            sound(name, &image, &tolerance);
            let (before, after) = (volume(&solid), volume(&image));
            assert!((after - before).abs() < 20.0 * tolerance.absolute, "{name}: {before} becomes {after}");
        }
    }

    #[test]
    fn a_box_morph_is_exact_where_it_is_affine() {
        let from = cuboid([1.0, 2.0, 4.0]);
        let corners = from.corners();
        let lean = |p: Point3| Point3::new(2.0 * p.x + 0.5 * p.z, p.y - p.x, 0.5 * p.z + 3.0);
        let same = BoxMorph::new(from, TwistedBox::new(corners).unwrap()).unwrap();
        let leaning = BoxMorph::new(from, TwistedBox::new(corners.map(lean)).unwrap()).unwrap();
        for (name, solid) in solids() {
            for (morph, factor) in [(&same, 1.0), (&leaning, 1.0)] {
                let image = solid.morphed(morph, &Tolerance::default()).unwrap();
                sound(name, &image, &Tolerance { absolute: 1e-8, ..Tolerance::default() });
                let (before, after) = (volume(&solid), volume(&image));
                assert!((after - factor * before).abs() < 1e-7 * before, "{name}: {before} becomes {after}");
            }
        }
    }

    /// ∫ det J over the box, by Gauss's rule of two places: the determinant is of degree 2 in each coordinate.
    fn trilinear_volume(from: &Box3, morph: &BoxMorph) -> f64 {
        let h = 1e-4;
        let sides = [from.x, from.y, from.z];
        let mut sum = 0.0;
        for k in 0..8 {
            let place: [f64; 3] = std::array::from_fn(|i| {
                let sign = if k & (1 << i) == 0 { -1.0 } else { 1.0 };
                sides[i].at(0.5 + 0.5 * sign / 3.0_f64.sqrt())
            });
            let p = Point3::from(place);
            let along =
                |v: Vector3| (morph.image(p + v * h).unwrap() - morph.image(p - v * h).unwrap()) / (2.0 * h);
            let (a, b, c) = (along(Vector3::X), along(Vector3::Y), along(Vector3::Z));
            sum += a.cross(b).dot(c) / 8.0;
        }
        sum * sides.iter().map(|side| side.length()).product::<f64>()
    }

    #[test]
    fn a_trilinear_map_has_the_volume_of_its_integral() {
        let from = cuboid([2.0, 1.5, 4.0]);
        let mut corners = from.corners();
        corners[6] += Vector3::new(0.7, 0.4, 1.0);
        corners[4] += Vector3::new(-0.3, 0.2, 0.6);
        corners[1] += Vector3::new(0.1, -0.5, 0.2);
        let morph = BoxMorph::new(from, TwistedBox::new(corners).unwrap()).unwrap();
        let tolerance = Tolerance { absolute: 1e-5, ..Tolerance::default() };
        let image = box_brep(&from).unwrap().morphed(&morph, &tolerance).unwrap();
        sound("box", &image, &tolerance);
        let (wanted, found) = (trilinear_volume(&from, &morph), volume(&image));
        assert!((found - wanted).abs() < 1e-4 * wanted, "{found} instead of {wanted}");
        for (name, solid) in solids() {
            sound(name, &solid.morphed(&morph, &tolerance).unwrap(), &tolerance);
        }
    }

    #[test]
    fn bends_tapers_and_mirrors_stay_closed() {
        let tolerance = Tolerance { absolute: 1e-4, ..Tolerance::default() };
        // About an axis that lies beyond all of them: what lies on both sides of it would be folded over.
        let about = Plane::YZ.with_origin(Point3::new(0.0, -6.0, 0.0));
        let arc = Arc::new(Circle::new(about, 6.0).unwrap(), Interval::new(0.0, 1.2)).unwrap();
        let bend = Bend::new(&arc).unwrap();
        let taper = Taper::new(axis(), 1.0, 0.4, false, true).unwrap();
        let inside_out = By(|p: Point3| Point3::new(-p.x - 0.02 * p.y * p.y, p.y, p.z + 0.05 * p.x * p.z));
        let partial = Twist::new(axis(), 0.8, false).unwrap();
        let maps: [(&str, &dyn Morph); 4] =
            [("bend", &bend), ("taper", &taper), ("mirror", &inside_out), ("twist of a part", &partial)];
        for (map, morph) in maps {
            for (name, solid) in solids() {
                let image = solid.morphed(morph, &tolerance).unwrap();
                sound(&format!("{name} in a {map}"), &image, &tolerance);
                assert!(volume(&image) > 0.0, "{name} in a {map}");
            }
        }
    }
}
