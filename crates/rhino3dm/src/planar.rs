//! Points of a plane, matrices and lists, as the classes beyond curves, surfaces and meshes store them
//! (section 3).

use katydid_geometry::{Plane, Point2, Xform};
use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::{Result, typecode};

/// A plane as an archive stores it: a frame, and beside it an equation that programs do not always keep in step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StoredPlane {
    /// Origin and axes; not checked to be of unit length or at right angles.
    pub frame: Plane,
    /// The stored equation's four coefficients where they are not those that follow from the frame.
    pub equation: Option<[f64; 4]>,
}

impl From<Plane> for StoredPlane {
    fn from(frame: Plane) -> Self {
        Self { frame, equation: None }
    }
}

/// The equation that openNURBS computes from a frame: n·p + d = 0 with d = −n·origin.
fn computed_equation(frame: &Plane) -> [f64; 4] {
    let (n, o) = (frame.z_axis, frame.origin);
    // Subtracted from 0 so that a plane through the origin gets 0, not −0.
    [n.x, n.y, n.z, 0.0 - (n.x * o.x + n.y * o.y + n.z * o.z)]
}

/// Read side. Every `what` names the thing for the error message.
impl Reader<'_> {
    pub(crate) fn point2(&mut self, what: &'static str) -> Result<Point2> {
        Ok(Point2::new(self.f64(what)?, self.f64(what)?))
    }

    pub(crate) fn points2(&mut self, what: &'static str) -> Result<Vec<Point2>> {
        let count = self.count(16, what)?;
        (0..count).map(|_| self.point2(what)).collect()
    }

    /// A plane with its equation.
    pub(crate) fn stored_plane(&mut self, what: &'static str) -> Result<StoredPlane> {
        let frame = Plane {
            origin: self.point(what)?,
            x_axis: self.vector(what)?,
            y_axis: self.vector(what)?,
            z_axis: self.vector(what)?,
        };
        let equation = [self.f64(what)?, self.f64(what)?, self.f64(what)?, self.f64(what)?];
        // Bit for bit: 0 and −0 are not the same in the bytes.
        let differs = equation.map(f64::to_bits) != computed_equation(&frame).map(f64::to_bits);
        Ok(StoredPlane { frame, equation: differs.then_some(equation) })
    }

    /// A matrix, row after row.
    pub(crate) fn matrix(&mut self, what: &'static str) -> Result<Xform> {
        let mut matrix = Xform::IDENTITY;
        for number in matrix.rows.iter_mut().flatten() {
            *number = self.f64(what)?;
        }
        Ok(matrix)
    }

    /// A list of identifiers, as openNURBS stores it: in a chunk of its own.
    pub(crate) fn id_list(&mut self, what: &'static str) -> Result<Vec<Uuid>> {
        let (mut list, _) = self.versioned_1(what)?;
        let count = list.count(16, what)?;
        let ids = (0..count).map(|_| list.uuid(what)).collect();
        list.finish();
        ids
    }

    /// The body of the next anonymous chunk, which has no version of its own.
    pub(crate) fn anonymous(&mut self, what: &'static str) -> Result<Self> {
        self.expect(typecode::ANONYMOUS, what)
    }
}

/// Write side.
impl Writer {
    pub(crate) fn point2(&mut self, p: Point2) {
        self.f64(p.x);
        self.f64(p.y);
    }

    pub(crate) fn points2(&mut self, points: &[Point2]) -> Result<()> {
        self.count(points.len(), "points")?;
        points.iter().for_each(|p| self.point2(*p));
        Ok(())
    }

    pub(crate) fn stored_plane(&mut self, plane: &StoredPlane) {
        let frame = &plane.frame;
        self.point(frame.origin);
        self.vector(frame.x_axis);
        self.vector(frame.y_axis);
        self.vector(frame.z_axis);
        let equation = plane.equation.unwrap_or_else(|| computed_equation(frame));
        equation.into_iter().for_each(|x| self.f64(x));
    }

    pub(crate) fn matrix(&mut self, matrix: &Xform) {
        matrix.rows.iter().flatten().for_each(|x| self.f64(*x));
    }

    pub(crate) fn id_list(&mut self, ids: &[Uuid]) -> Result<()> {
        self.versioned(1, 0, |w| {
            w.count(ids.len(), "identifiers")?;
            ids.iter().for_each(|id| w.uuid(*id));
            Ok(())
        })
    }
}
