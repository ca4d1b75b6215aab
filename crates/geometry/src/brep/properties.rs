//! Areas, volumes and moments of breps by quadrature on the exact surfaces.

mod bound;
mod green;
mod rule;
mod strip;

use crate::brep::thresholds::{FINEST_SHARE, NO_VOLUME};
use bound::Nearness;
use green::Sheet;
use rule::Work;

use super::Brep;
use crate::{BoundingBox, Direction, Error, MassProperties, Point3, Result, Vector3};

/// What is integrated over a face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Measure {
    /// The area of the face.
    Area,
    /// The face's share in the volume, by the divergence theorem.
    Volume,
}

/// Coordinates in which the numbers stay near 1.
#[derive(Debug, Clone, Copy)]
struct Frame {
    centre: Point3,
    size: f64,
}

impl Frame {
    fn of(bounds: &BoundingBox) -> Self {
        Self { centre: bounds.center(), size: (0.5 * bounds.diagonal().length()).max(f64::MIN_POSITIVE) }
    }
}

impl Measure {
    /// The integrands 1, x, y, z, xx, yy, zz, xy, yz and zx at a point with the derivatives by u and v.
    fn density(self, p: Vector3, by_u: Vector3, by_v: Vector3) -> [f64; 10] {
        let n = by_u.cross(by_v);
        match self {
            Self::Area => {
                let patch = n.length();
                [1.0, p.x, p.y, p.z, p.x * p.x, p.y * p.y, p.z * p.z, p.x * p.y, p.y * p.z, p.z * p.x]
                    .map(|value| value * patch)
            }
            Self::Volume => {
                let (x, y, z) = (p.x * n.x, p.y * n.y, p.z * n.z);
                [
                    p.dot(n) / 3.0,
                    0.5 * p.x * x,
                    0.5 * p.y * y,
                    0.5 * p.z * z,
                    p.x * p.x * x / 3.0,
                    p.y * p.y * y / 3.0,
                    p.z * p.z * z / 3.0,
                    0.5 * p.x * p.y * x,
                    0.5 * p.y * p.z * y,
                    0.5 * p.z * p.x * z,
                ]
            }
        }
    }
}

impl Brep {
    /// The area of all faces within their trims, its centroid and moments, to a fraction of the area (10⁻¹³ to 0.1,
    /// others count as the nearest of them).
    ///
    /// Integrals over a face become integrals along its trims by Green's theorem, of an inner integral across the
    /// parameter plane; both by Gauss–Legendre rules of 6 and 10 points between knots, halved where they differ by
    /// too much (P. Davis and P. Rabinowitz, *Methods of Numerical Integration*, 5.6 and 6.5; the reduction is
    /// derived). The face is what its trims enclose: where they only follow an edge within the edge's tolerance, so
    /// does the area. `go_on` is asked again and again; where it says no the work stops.
    ///
    /// # Errors
    /// There are no faces or none with an area, a trim has no curve, the work was stopped, or a number overflows.
    pub fn area_properties(&self, fraction: f64, go_on: impl Fn() -> bool) -> Result<MassProperties> {
        self.measured(Measure::Area, fraction, &go_on)
    }

    /// The volume that a solid encloses, its centroid and moments, to a fraction of the solid's size (area times half
    /// of the diagonal); see [`Brep::area_properties`]. Which way the normals point does not matter.
    ///
    /// The solid is what its edges bound. Where trims follow them to rounding that is what the trims enclose. Files hold
    /// solids whose trims or surfaces lie beside the edges: there a face reaches to the feet of its edges on the surface
    /// (a trim that is off by less than 10⁻⁷ of the size stays), and strips of straight lines close what is left between
    /// faces and edges, and between edges and vertices. The shell is closed then, and the results move with the solid:
    /// they are the same seen from anywhere. (The area is that within the trims as they are.)
    ///
    /// # Errors
    /// The brep is not closed, or as for the area.
    pub fn volume_properties(&self, fraction: f64, go_on: impl Fn() -> bool) -> Result<MassProperties> {
        if !self.is_solid() {
            return Err(Error::degenerate("brep", "it is not closed, and has no volume"));
        }
        self.measured(Measure::Volume, fraction, &go_on)
    }

    /// The volume between the faces of an open brep and the centre of the box around them, its centroid and moments:
    /// what Rhino gives where no shell is closed. It means little, since it depends on that point. Of a solid it is the
    /// volume. See [`Brep::area_properties`] for `fraction` and `go_on`.
    ///
    /// # Errors
    /// The faces enclose no volume with the point, as those of a plane do not; or as for the area.
    pub fn open_volume_properties(&self, fraction: f64, go_on: impl Fn() -> bool) -> Result<MassProperties> {
        let found = self.measured(Measure::Volume, fraction, &go_on)?;
        let size = self.frame()?.size;
        // Rounding leaves of a flat shell a volume of that order.
        if !(found.amount > NO_VOLUME * size.powi(3)) {
            return Err(Error::degenerate("brep", "it is flat, and has no volume"));
        }
        Ok(found)
    }

    /// The area of one face within its trims; see [`Brep::area_properties`].
    ///
    /// # Errors
    /// As for the area; or there is no such face.
    pub fn face_area(&self, face: usize, fraction: f64) -> Result<MassProperties> {
        let (frame, fraction) = (self.frame()?, within(fraction));
        let mut work = Work::new(MOST, &|| true);
        let sheet = Sheet::new(self, face, frame, Nearness::TRIMS, &work)?;
        let sheet = sheet.ok_or_else(super::trimmed::no_face)?;
        finished(&[sheet], Measure::Area, frame, fraction, &mut work)
    }

    /// The volume between one face and a point, positive where the face looks away from the point. The face reaches to
    /// its edges as in [`Brep::volume_properties`]; the shares of all faces of a solid are its volume where the edges lie
    /// on the faces. Where they do not, the gaps have shares of their own, and the sum depends on the point. See
    /// [`Brep::area_properties`] for `fraction`.
    ///
    /// # Errors
    /// As for the area; or there is no such face.
    pub fn face_volume(&self, face: usize, from: Point3, fraction: f64) -> Result<f64> {
        let (frame, fraction) = (Frame { centre: from, ..self.frame()? }, within(fraction));
        let mut work = Work::new(MOST, &|| true);
        let near = Nearness::of(fraction, frame.size);
        let sheet = Sheet::new(self, face, frame, near, &work)?.ok_or_else(super::trimmed::no_face)?;
        let area = sheet.integral(Measure::Area, f64::INFINITY, &mut work)?[0].abs();
        let share = sheet.integral(Measure::Volume, fraction * area, &mut work)?[0];
        let volume = share * frame.size.powi(3);
        Ok(if sheet.reversed { -volume } else { volume })
    }

    fn frame(&self) -> Result<Frame> {
        let bounds = self.bounds_of_faces().ok_or(Error::degenerate("brep", "it has no faces"))?;
        Ok(Frame::of(&bounds))
    }

    fn measured(&self, measure: Measure, fraction: f64, go_on: &dyn Fn() -> bool) -> Result<MassProperties> {
        let (frame, fraction) = (self.frame()?, within(fraction));
        let mut work = Work::new(MOST, go_on);
        let near = match measure {
            Measure::Area => Nearness::TRIMS,
            Measure::Volume => Nearness::of(fraction, frame.size),
        };
        let mut sheets = Vec::with_capacity(self.faces().len());
        for face in 0..self.faces().len() {
            sheets.extend(Sheet::new(self, face, frame, near, &work)?);
        }
        finished(&sheets, measure, frame, fraction, &mut work)
    }
}

/// A fraction that can be reached.
fn within(fraction: f64) -> f64 {
    if fraction.is_nan() { FINEST_SHARE } else { fraction.clamp(FINEST_SHARE, 0.1) }
}

/// The most densities that are looked at for one shape.
const MOST: u64 = 200_000_000;

fn finished(
    sheets: &[Sheet<'_>],
    measure: Measure,
    frame: Frame,
    fraction: f64,
    work: &mut Work<'_>,
) -> Result<MassProperties> {
    // What the first look gives is what "a fraction of the area" refers to.
    let mut area = 0.0;
    for sheet in sheets {
        area += sheet.integral(Measure::Area, f64::INFINITY, work)?[0].abs();
    }
    work.error = 0.0;
    let (mut sum, share) = ([0.0; 10], 1.0 / sheets.len().max(1) as f64);
    for sheet in sheets {
        let mut part = sheet.integral(measure, fraction * area * share, work)?;
        if measure == Measure::Volume {
            let closing = sheet.closing(0.1 * fraction * area * share, work)?;
            part.iter_mut().zip(closing).for_each(|(sum, v)| *sum += v);
        }
        let turned = measure == Measure::Volume && sheet.reversed;
        for (sum, value) in sum.iter_mut().zip(part) {
            *sum += if turned { -value } else { value };
        }
    }
    let dimension = if measure == Measure::Area { 2 } else { 3 };
    MassProperties::of_integrals(sum, work.error, frame.centre, frame.size, dimension)
}

/// The other direction first where that leaves less to do: the inner integral runs across the fewer spans.
fn inner_direction(spans: [usize; 2]) -> Direction {
    if spans[0] <= spans[1] { Direction::U } else { Direction::V }
}
