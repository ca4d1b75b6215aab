//! Class PointCloud (section 8).

use katydid_geometry::{Plane, Point3, Vector3};

use super::major_1;
use crate::chunk::{Reader, Writer};
use crate::{Error, Result, colour};

/// Many points as one object.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PointCloud {
    /// The points.
    pub points: Vec<Point3>,
    /// One normal a point, or none at all.
    pub normals: Vec<Vector3>,
    /// One colour a point as red, green, blue, alpha, or none at all.
    pub colours: Vec<[u8; 4]>,
    /// One number a point, or none at all.
    pub values: Vec<f64>,
}

impl From<Vec<Point3>> for PointCloud {
    fn from(points: Vec<Point3>) -> Self {
        Self { points, ..Self::default() }
    }
}

const WHAT: &str = "point cloud";

pub(super) fn read(body: &mut Reader<'_>) -> Result<PointCloud> {
    let offset = body.offset();
    let minor = major_1(body, WHAT)?;
    let mut cloud = PointCloud::from(body.points(WHAT)?);
    // A plane, a box and flags, which follow from the points or mean nothing without them.
    body.take(128 + 48 + 4, WHAT)?;
    if minor >= 1 {
        let count = body.count(24, WHAT)?;
        cloud.normals = (0..count).map(|_| body.vector(WHAT)).collect::<Result<_>>()?;
        let count = body.count(4, WHAT)?;
        cloud.colours =
            (0..count).map(|_| body.colour(WHAT).map(colour::from_archive)).collect::<Result<_>>()?;
    }
    if minor >= 2 {
        cloud.values = body.doubles(WHAT)?;
    }
    let count = cloud.points.len();
    if !cloud.points.iter().all(|p| p.is_finite()) {
        return Err(Error::geometry(offset, WHAT, katydid_geometry::Error::NotFinite("point")));
    }
    if cloud.normals.len() != count || !cloud.normals.iter().all(|n| n.is_finite()) {
        cloud.normals.clear();
    }
    if cloud.colours.len() != count {
        cloud.colours.clear();
    }
    if cloud.values.len() != count {
        cloud.values.clear();
    }
    Ok(cloud)
}

pub(super) fn write(cloud: &PointCloud, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 2);
    w.points(&cloud.points)?;
    w.plane(&Plane::XY);
    w.empty_box();
    w.i32(0);
    w.count(cloud.normals.len(), "normals")?;
    cloud.normals.iter().for_each(|n| w.vector(*n));
    w.count(cloud.colours.len(), "colours")?;
    cloud.colours.iter().for_each(|c| w.colour(colour::to_archive(*c)));
    w.doubles(&cloud.values)
}
