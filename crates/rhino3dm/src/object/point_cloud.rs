//! Class PointCloud (section 8).

use katydid_geometry::{Point3, Vector3};

use super::major_1;
use crate::chunk::{Reader, Writer};
use crate::{Result, colour};

/// Many points as one object, as archives have it: coordinates need not be finite, and a list of another length than
/// that of the points means nothing to openNURBS. Which points are hidden is not stored.
#[derive(Debug, Clone, PartialEq)]
pub struct PointCloud {
    /// The points.
    pub points: Vec<Point3>,
    /// One normal a point, or none at all.
    pub normals: Vec<Vector3>,
    /// One colour a point as red, green, blue, alpha, or none at all.
    pub colours: Vec<[u8; 4]>,
    /// One number a point, or none at all.
    pub values: Vec<f64>,
    /// A plane that somebody gave the cloud: origin, three axes, and the four numbers of its equation.
    pub plane: [f64; 16],
    /// Least and greatest corner of the box of the points; not set until somebody computed it.
    pub bounds: [[f64; 3]; 2],
    /// What openNURBS notes about the cloud: 1 when the points are ordered, 2 when the plane is meant.
    pub flags: i32,
}

impl Default for PointCloud {
    /// No points, the plane of x and y, no box.
    fn default() -> Self {
        let mut plane = [0.0; 16];
        // The axes, and the third of them once more as the normal of the equation.
        for i in [3, 7, 11, 14] {
            plane[i] = 1.0;
        }
        Self {
            points: Vec::new(),
            normals: Vec::new(),
            colours: Vec::new(),
            values: Vec::new(),
            plane,
            bounds: [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]],
            flags: 0,
        }
    }
}

impl From<Vec<Point3>> for PointCloud {
    fn from(points: Vec<Point3>) -> Self {
        Self { points, ..Self::default() }
    }
}

const WHAT: &str = "point cloud";

pub(super) fn read(body: &mut Reader<'_>) -> Result<PointCloud> {
    let minor = major_1(body, WHAT)?;
    let points: Vec<[f64; 3]> = body.items(WHAT)?;
    let mut cloud = PointCloud::from(points.into_iter().map(Point3::from).collect::<Vec<_>>());
    let numbers = cloud.plane.iter_mut().chain(cloud.bounds.as_flattened_mut());
    for x in numbers {
        *x = body.f64(WHAT)?;
    }
    cloud.flags = body.i32(WHAT)?;
    if minor >= 1 {
        let normals: Vec<[f64; 3]> = body.items(WHAT)?;
        cloud.normals = normals.into_iter().map(Vector3::from).collect();
        cloud.colours = body.items(WHAT)?;
        cloud.colours.iter_mut().for_each(|c| *c = colour::from_archive(*c));
    }
    if minor >= 2 {
        cloud.values = body.doubles(WHAT)?;
    }
    Ok(cloud)
}

pub(super) fn write(cloud: &PointCloud, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 2);
    w.points(&cloud.points)?;
    cloud.plane.iter().chain(cloud.bounds.as_flattened()).for_each(|x| w.f64(*x));
    w.i32(cloud.flags);
    w.count(cloud.normals.len(), "normals")?;
    cloud.normals.iter().for_each(|n| w.vector(*n));
    w.count(cloud.colours.len(), "colours")?;
    cloud.colours.iter().for_each(|c| w.colour(colour::to_archive(*c)));
    w.doubles(&cloud.values)
}
