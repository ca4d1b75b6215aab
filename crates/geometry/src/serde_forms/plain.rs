//! Points, vectors, planes, ranges, boxes, matrices.

use super::{Form, structure, through_forms};
use crate::serde_forms::thresholds::ROTATION;
use crate::{
    AffineParts, BoundingBox, Box3, Error, Frustum, Interval, Line, Matrix, Plane, PlaneEquation, Point2,
    Point3, Quaternion, Rectangle, Result, Tolerance, Vector2, Vector3, Xform,
};

/// An error unless all numbers are finite.
pub(super) fn finite(what: &'static str, numbers: &[f64]) -> Result<()> {
    if numbers.iter().all(|x| x.is_finite()) { Ok(()) } else { Err(Error::NotFinite(what)) }
}

/// Types that are a list of numbers.
macro_rules! lists {
    ($($type:ident [$count:literal] $what:literal),* $(,)?) => { $(
        impl Form for $type {
            type Written = [f64; $count];
            fn written(&self) -> [f64; $count] {
                (*self).into()
            }
            fn read(written: [f64; $count]) -> Result<Self> {
                finite($what, &written).map(|()| written.into())
            }
        }
        through_forms!($type);
    )* };
}

lists! {
    Point2[2] "point",
    Vector2[2] "vector",
    Point3[3] "point",
    Vector3[3] "vector",
}

impl Form for Quaternion {
    type Written = [f64; 4];
    fn written(&self) -> [f64; 4] {
        [self.w, self.x, self.y, self.z]
    }
    fn read([w, x, y, z]: [f64; 4]) -> Result<Self> {
        finite("quaternion", &[w, x, y, z]).map(|()| Self::new(w, x, y, z))
    }
}

impl Form for Interval {
    type Written = [f64; 2];
    fn written(&self) -> [f64; 2] {
        [self.start, self.end]
    }
    fn read([start, end]: [f64; 2]) -> Result<Self> {
        finite("interval", &[start, end]).map(|()| Self::new(start, end))
    }
}

impl Form for Xform {
    type Written = [[f64; 4]; 4];
    fn written(&self) -> [[f64; 4]; 4] {
        self.rows
    }
    fn read(rows: [[f64; 4]; 4]) -> Result<Self> {
        finite("transform", rows.as_flattened()).map(|()| Self { rows })
    }
}

impl Form for PlaneEquation {
    type Written = [f64; 4];
    fn written(&self) -> [f64; 4] {
        self.coefficients()
    }
    fn read(written: [f64; 4]) -> Result<Self> {
        Self::from_unit(written)
    }
}

/// A matrix row by row.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(unreachable_pub, reason = "an associated type needs it")]
pub struct WrittenMatrix {
    rows: usize,
    columns: usize,
    values: Vec<f64>,
}

impl Form for Matrix {
    type Written = WrittenMatrix;
    fn written(&self) -> WrittenMatrix {
        WrittenMatrix { rows: self.rows(), columns: self.columns(), values: self.values().to_vec() }
    }
    fn read(w: WrittenMatrix) -> Result<Self> {
        Self::new(w.rows, w.columns, w.values)
    }
}

through_forms!(Quaternion, Interval, Xform, PlaneEquation, Matrix);

/// An error unless the three axes are a right-handed frame of unit vectors, up to rounding.
fn frame(p: &Plane) -> Result<()> {
    let (x, y, z) = (p.x_axis, p.y_axis, p.z_axis);
    let off = [x.dot(y), y.dot(z), z.dot(x), x.length() - 1.0, y.length() - 1.0, z.length() - 1.0];
    if off.iter().all(|e| e.abs() <= ROTATION) && x.cross(y).dot(z) > 0.0 {
        return Ok(());
    }
    Err(Error::Invalid { what: "plane", why: "its axes are no right-handed frame of unit vectors".into() })
}

/// An error unless a range runs forward.
pub(super) fn increasing(what: &'static str, range: Interval) -> Result<()> {
    if range.is_increasing() {
        return Ok(());
    }
    Err(Error::Invalid { what, why: format!("{} to {} does not increase", range.start, range.end) })
}

structure!(Line { from: Point3, to: Point3 } | _ | Ok(()));
structure!(Plane { origin: Point3, x_axis: Vector3, y_axis: Vector3, z_axis: Vector3 } frame);
structure!(Rectangle { plane: Plane, x: Interval, y: Interval } | _ | Ok(()));
structure!(Box3 { plane: Plane, x: Interval, y: Interval, z: Interval } | _ | Ok(()));
structure!(
    Frustum { x: Interval, y: Interval, depth: Interval } | f | Xform::camera_to_clip(f, false).map(drop)
);
structure!(
    AffineParts { translation: Vector3, rotation: Xform, axes: Xform, scale: Vector3 } | a | {
        if a.rotation.is_rotation(ROTATION) && a.axes.is_rotation(ROTATION) {
            return Ok(());
        }
        Err(Error::Invalid { what: "affine parts", why: "rotation or axes are no rotation".into() })
    }
);
structure!(
    BoundingBox { min: Point3, max: Point3 } | b | {
        if b.min.x <= b.max.x && b.min.y <= b.max.y && b.min.z <= b.max.z {
            return Ok(());
        }
        Err(Error::Invalid { what: "box", why: "its smallest corner is larger than its largest".into() })
    }
);
structure!(
    Tolerance { absolute: f64, angle: f64 } | t | {
        finite("tolerance", &[t.absolute, t.angle])?;
        if t.absolute >= 0.0 && t.angle >= 0.0 {
            return Ok(());
        }
        Err(Error::OutOfRange { what: "tolerance", value: t.absolute.min(t.angle), must: "at least 0" })
    }
);
