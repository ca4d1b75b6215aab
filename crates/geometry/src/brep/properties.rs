//! Areas, volumes and moments of breps by quadrature on the exact surfaces.

mod green;
mod rule;

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
    /// # Errors
    /// The brep is not closed, or as for the area.
    pub fn volume_properties(&self, fraction: f64, go_on: impl Fn() -> bool) -> Result<MassProperties> {
        if !self.is_solid() {
            return Err(Error::degenerate("brep", "it is not closed, and has no volume"));
        }
        self.measured(Measure::Volume, fraction, &go_on)
    }

    /// The area of one face within its trims; see [`Brep::area_properties`].
    ///
    /// # Errors
    /// As for the area; or there is no such face.
    pub fn face_area(&self, face: usize, fraction: f64) -> Result<MassProperties> {
        let frame = self.frame()?;
        let sheet = Sheet::new(self, face, frame)?.ok_or_else(super::trimmed::no_face)?;
        finished(&[sheet], Measure::Area, frame, fraction, &|| true)
    }

    /// The volume between one face and a point, positive where the face looks away from the point; the shares of all
    /// faces of a solid are its volume. See [`Brep::area_properties`] for `fraction`.
    ///
    /// # Errors
    /// As for the area; or there is no such face.
    pub fn face_volume(&self, face: usize, from: Point3, fraction: f64) -> Result<f64> {
        let frame = Frame { centre: from, ..self.frame()? };
        let sheet = Sheet::new(self, face, frame)?.ok_or_else(super::trimmed::no_face)?;
        let mut work = Work::new(MOST, &|| true);
        let area = sheet.integral(Measure::Area, f64::INFINITY, &mut work)?[0].abs();
        let share = sheet.integral(Measure::Volume, fraction.clamp(1e-13, 0.1) * area, &mut work)?[0];
        let volume = share * frame.size.powi(3);
        Ok(if sheet.reversed { -volume } else { volume })
    }

    fn frame(&self) -> Result<Frame> {
        let bounds = self.bounds_of_faces().ok_or(Error::degenerate("brep", "it has no faces"))?;
        Ok(Frame::of(&bounds))
    }

    fn measured(&self, measure: Measure, fraction: f64, go_on: &dyn Fn() -> bool) -> Result<MassProperties> {
        let frame = self.frame()?;
        let mut sheets = Vec::with_capacity(self.faces().len());
        for face in 0..self.faces().len() {
            sheets.extend(Sheet::new(self, face, frame)?);
        }
        finished(&sheets, measure, frame, fraction, go_on)
    }
}

/// The most densities that are looked at for one shape.
const MOST: u64 = 200_000_000;

fn finished(
    sheets: &[Sheet<'_>],
    measure: Measure,
    frame: Frame,
    fraction: f64,
    go_on: &dyn Fn() -> bool,
) -> Result<MassProperties> {
    let fraction = fraction.clamp(1e-13, 0.1);
    let mut work = Work::new(MOST, go_on);
    // What the first look gives is what "a fraction of the area" refers to.
    let mut area = 0.0;
    for sheet in sheets {
        area += sheet.integral(Measure::Area, f64::INFINITY, &mut work)?[0].abs();
    }
    work.error = 0.0;
    let (mut sum, share) = ([0.0; 10], 1.0 / sheets.len().max(1) as f64);
    for sheet in sheets {
        let part = sheet.integral(measure, fraction * area * share, &mut work)?;
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
